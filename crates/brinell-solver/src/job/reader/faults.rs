//! The faults of a document and their places.

use std::cell::{Cell, RefCell};
use std::fmt;

use super::tree::Node;
use crate::job::{Domain, FaultCode, FieldError};

/// Most listed faults; further ones are only counted.
pub const MAX_FAULTS: usize = 100;
/// Longest key in a pointer, in bytes.
const LONGEST_KEY: usize = 256;

/// The place of a value in the document, as a chain of links to the root. It becomes text only
/// when a pointer is needed.
#[derive(Debug, Clone, Copy)]
pub enum Place<'a> {
    /// The document.
    Root,
    /// A member of the object at a place.
    Key(&'a Place<'a>, &'a str),
    /// An item of the array at a place.
    Index(&'a Place<'a>, usize),
}

impl Place<'_> {
    /// Returns the JSON pointer (RFC 6901); for a member with a longer key than `LONGEST_KEY`, the
    /// pointer of its parent.
    pub fn pointer(&self) -> String {
        match self {
            Self::Root => String::new(),
            Self::Key(parent, key) if key.len() > LONGEST_KEY => parent.pointer(),
            Self::Key(parent, key) => {
                format!("{}/{}", parent.pointer(), key.replace('~', "~0").replace('/', "~1"))
            }
            Self::Index(parent, index) => format!("{}/{index}", parent.pointer()),
        }
    }
}

/// All faults so far.
#[derive(Debug, Default)]
pub struct Faults {
    list: RefCell<Vec<FieldError>>,
    unlisted: Cell<usize>,
    /// A place whose domain a reader asks for, and that domain once it is read.
    watched: Option<(String, Cell<Option<Domain>>)>,
}

impl Faults {
    /// Returns no faults, with an eye on the domain of the number at a pointer.
    pub fn watching(pointer: &str) -> Self {
        Self { watched: Some((pointer.to_owned(), Cell::default())), ..Self::default() }
    }

    /// Notes in which domain a number is read.
    pub fn reads(&self, place: &Place<'_>, domain: Domain) {
        if let Some((pointer, found)) = &self.watched
            && place.pointer() == *pointer
        {
            found.set(Some(domain));
        }
    }

    /// Returns the domain of the watched number, if it has one.
    pub fn watched(self) -> Option<Domain> {
        self.watched.and_then(|(_, found)| found.get())
    }

    /// Records a fault. Its text is formatted only if the list has room.
    pub fn add(&self, place: &Place<'_>, code: FaultCode, detail: fmt::Arguments<'_>) {
        if self.list.borrow().len() < MAX_FAULTS {
            self.push(FieldError { pointer: place.pointer(), code, detail: detail.to_string() });
        } else {
            self.unlisted.set(self.unlisted.get() + 1);
        }
    }

    /// Records a fault, unless the list has the same one.
    pub fn push(&self, fault: FieldError) {
        let mut list = self.list.borrow_mut();
        if list.contains(&fault) {
        } else if list.len() < MAX_FAULTS {
            list.push(fault);
        } else {
            self.unlisted.set(self.unlisted.get() + 1);
        }
    }

    /// Records several faults.
    pub fn extend(&self, found: impl IntoIterator<Item = FieldError>) {
        for fault in found {
            self.push(fault);
        }
    }

    /// Returns the faults in document order, with a note at the end if there are more than the
    /// list holds.
    pub fn into_sorted(self, document: &Node) -> Vec<FieldError> {
        let mut list = self.list.into_inner();
        list.sort_by_cached_key(|fault| document.position(&fault.pointer));
        let unlisted = self.unlisted.get();
        if unlisted > 0 {
            let detail =
                format!("{unlisted} more faults are not listed; these are the first {MAX_FAULTS}");
            list.push(FieldError { pointer: String::new(), code: FaultCode::MoreFaults, detail });
        }
        list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pointers_are_escaped() {
        let tags = Place::Key(&Place::Root, "tags");
        assert_eq!(Place::Key(&tags, "a/b~c").pointer(), "/tags/a~1b~0c");
        assert_eq!(Place::Index(&tags, 7).pointer(), "/tags/7");
        assert_eq!(Place::Key(&tags, &"k".repeat(1000)).pointer(), "/tags");
        assert_eq!(Place::Root.pointer(), "");
    }

    #[test]
    fn the_list_is_bounded() {
        let faults = Faults::default();
        for index in 0..250 {
            faults.add(
                &Place::Index(&Place::Root, index),
                FaultCode::WrongType,
                format_args!("wrong"),
            );
        }
        let list = faults.into_sorted(&Node::Array(vec![Node::Null; 250]));
        assert_eq!(list.len(), MAX_FAULTS + 1);
        let last = list.last().unwrap();
        assert_eq!(
            last.to_string(),
            "(job): 150 more faults are not listed; these are the first 100"
        );
    }
}
