//! The members of an object, by key.

use std::collections::HashSet;
use std::fmt;

use super::cursor::Cursor;
use super::faults::{Faults, Place};
use super::text::{Guess, List, Quoted};
use super::tree::Node;
use crate::job::{FaultCode, FieldError};

/// An object of the document.
#[derive(Debug, Clone, Copy)]
pub struct Object<'a> {
    at: Cursor<'a>,
    members: &'a [(String, Node)],
}

impl<'a> Object<'a> {
    /// Builds the object and reports repeated keys.
    pub fn new(at: Cursor<'a>, members: &'a [(String, Node)]) -> Self {
        let object = Self { at, members };
        let mut seen = HashSet::with_capacity(members.len());
        let mut told = HashSet::new();
        for (key, _) in members {
            if !seen.insert(key) && told.insert(key) {
                object.fault(
                    key,
                    FaultCode::DuplicateKey,
                    format_args!("the key {} is given more than once", Quoted(key)),
                );
            }
        }
        object
    }

    /// Reports every unknown key.
    pub fn only(&self, known: &[&str]) {
        for (key, _) in self.members {
            let written = key.as_str();
            if !known.contains(&written) {
                let guess = Guess { written, known };
                let (key, known) = (Quoted(written), List(known));
                self.fault(
                    written,
                    FaultCode::UnknownKey,
                    format_args!("unknown key {key}; expected one of: {known}{guess}"),
                );
            }
        }
    }

    /// Whether a key is present with a value other than `null`.
    pub fn has(&self, key: &str) -> bool {
        self.find(key).is_some_and(|node| *node != Node::Null)
    }

    /// Visits all members with their cursors, for objects with free keys.
    pub fn each(&self, mut visit: impl FnMut(&str, Cursor<'_>)) {
        for (key, node) in self.members {
            visit(
                key,
                Cursor { node, place: &Place::Key(self.at.place, key), faults: self.faults() },
            );
        }
    }

    /// Returns the number of members.
    pub fn len(&self) -> usize {
        self.members.len()
    }

    /// Reads a required member.
    pub fn required<T>(&self, key: &str, read: impl FnOnce(Cursor<'_>) -> Option<T>) -> Option<T> {
        let Some(node) = self.find(key) else {
            self.fault(key, FaultCode::Required, format_args!("is required"));
            return None;
        };
        read(Cursor { node, place: &Place::Key(self.at.place, key), faults: self.faults() })
    }

    /// Reads an optional member; `null` counts as missing.
    pub fn or<T>(
        &self,
        key: &str,
        default: T,
        read: impl FnOnce(Cursor<'_>) -> Option<T>,
    ) -> Option<T> {
        if self.has(key) { self.required(key, read) } else { Some(default) }
    }

    /// Records a fault of a member.
    pub fn fault(&self, key: &str, code: FaultCode, detail: fmt::Arguments<'_>) {
        self.faults().add(&Place::Key(self.at.place, key), code, detail);
    }

    /// Records a fault of the object.
    pub fn fault_here(&self, code: FaultCode, detail: fmt::Arguments<'_>) {
        self.at.fault(code, detail);
    }

    /// Records faults like [`Cursor::report`].
    pub fn report(&self, found: impl IntoIterator<Item = FieldError>) {
        self.at.report(found);
    }

    /// Returns a value like [`Cursor::checked`].
    pub fn checked<T>(&self, built: Result<T, Vec<FieldError>>) -> Option<T> {
        self.at.checked(built)
    }

    fn find(&self, key: &str) -> Option<&'a Node> {
        self.members.iter().find(|(name, _)| name == key).map(|(_, node)| node)
    }

    fn faults(&self) -> &'a Faults {
        self.at.faults
    }
}

impl<'a> Cursor<'a> {
    /// Returns an object. A repeated key is a fault; its first value is read.
    pub fn object(self) -> Option<Object<'a>> {
        let Node::Object(members) = self.node else { return self.not("an object") };
        Some(Object::new(self, members))
    }
}
