//! A value with its place.

use std::fmt;
use std::ops::RangeInclusive;

use super::faults::{Faults, Place};
use super::text::{Figure, Got, Guess, List, Quoted};
use super::tree::Node;
use crate::job::{Domain, FaultCode, FieldError, Named, Units};

/// A value of the document, its place, and the list of faults.
#[derive(Debug, Clone, Copy)]
pub(in crate::job) struct Cursor<'a> {
    pub(super) node: &'a Node,
    pub(super) place: &'a Place<'a>,
    pub(super) faults: &'a Faults,
}

impl<'a> Cursor<'a> {
    /// Returns the cursor of the whole document.
    pub fn root(document: &'a Node, faults: &'a Faults) -> Self {
        Self { node: document, place: &Place::Root, faults }
    }

    /// Records a fault of this value.
    pub fn fault(&self, code: FaultCode, detail: fmt::Arguments<'_>) {
        self.faults.add(self.place, code, detail);
    }

    /// Records the faults of a checked constructor and adds the written value to each. Their
    /// pointers are relative to this value.
    pub fn report(&self, found: impl IntoIterator<Item = FieldError>) {
        for fault in found {
            let pointer = format!("{}{}", self.place.pointer(), fault.pointer);
            let detail = match self.node.at(&fault.pointer) {
                Some(got @ (Node::Number(_) | Node::Text(_))) => {
                    format!("{}, got {}", fault.detail, Got(got))
                }
                _ => fault.detail,
            };
            self.faults.push(FieldError { pointer, code: fault.code, detail });
        }
    }

    /// Returns the result of a checked constructor, and records its faults.
    pub fn checked<T>(&self, built: Result<T, Vec<FieldError>>) -> Option<T> {
        built.map_err(|faults| self.report(faults)).ok()
    }

    /// Whether the value is the number zero.
    pub fn is_zero(&self) -> bool {
        matches!(self.node, Node::Number(value) if *value == 0.0)
    }

    /// Whether the value is an array.
    pub fn is_array(&self) -> bool {
        matches!(self.node, Node::Array(_))
    }

    /// Returns the pairs of numbers that stand in a list at a pointer below this value.
    pub fn pairs_at(&self, pointer: &str) -> Option<Vec<[f64; 2]>> {
        let Some(Node::Array(rows)) = self.node.at(pointer) else { return None };
        let pair = |row: &Node| match row {
            Node::Array(cells) => match cells[..] {
                [Node::Number(x), Node::Number(y)] => Some([x, y]),
                _ => None,
            },
            _ => None,
        };
        rows.iter().map(pair).collect()
    }

    /// Whether the value is an object.
    pub fn is_object(&self) -> bool {
        matches!(self.node, Node::Object(_))
    }

    /// Returns a finite number.
    pub fn number(&self) -> Option<f64> {
        let Node::Number(value) = self.node else { return self.not("a number") };
        Some(*value)
    }

    /// Returns a number in a range.
    pub fn number_in<T: TryFrom<f64>>(&self, range: &RangeInclusive<f64>) -> Option<T> {
        let value = self.number()?;
        if range.contains(&value)
            && let Ok(value) = T::try_from(value)
        {
            return Some(value);
        }
        let (low, high) = (Figure(*range.start()), Figure(*range.end()));
        self.fault(
            FaultCode::OutOfRange,
            format_args!("must be between {low} and {high}, got {}", Figure(value)),
        );
        None
    }

    /// Returns a whole number in a range; `20.0` is valid.
    pub fn integer(&self, range: &RangeInclusive<u32>) -> Option<u32> {
        let value = self.number()?;
        let (low, high) = (*range.start(), *range.end());
        if value.fract() == 0.0 && (f64::from(low)..=f64::from(high)).contains(&value) {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "checked just above"
            )]
            return Some(value as u32);
        }
        self.fault(
            FaultCode::OutOfRange,
            format_args!("must be a whole number between {low} and {high}, got {}", Figure(value)),
        );
        None
    }

    /// Returns a figure with a unit, in the range of its quantity, converted to N–mm–MPa. Without
    /// a valid unit system, only the sign is checked.
    pub fn quantity<T: TryFrom<f64>>(&self, quantity: Domain, units: Option<Units>) -> Option<T> {
        let written = self.number()?;
        self.faults.reads(self.place, quantity);
        let (low, _) = quantity.range();
        let known = units.unwrap_or_default();
        let (wire_low, wire_high) = quantity.wire_range(known);
        if low > 0.0 && written <= 0.0 {
            self.fault(
                FaultCode::OutOfRange,
                format_args!("must be greater than 0, got {}", Figure(written)),
            );
        } else if low >= 0.0 && written < 0.0 {
            self.fault(
                FaultCode::OutOfRange,
                format_args!("must be at least 0, got {}", Figure(written)),
            );
        } else if units.is_some() && !(wire_low..=wire_high).contains(&written) {
            let (low, high, written) = (Figure(wire_low), Figure(wire_high), Figure(written));
            let (unit, system) = (quantity.symbol(known), known.name());
            self.fault(
                FaultCode::OutOfRange,
                format_args!(
                    "must be between {low} and {high} {unit} (units {system}), got {written}"
                ),
            );
        } else {
            return T::try_from(quantity.to_core(known, written)).ok();
        }
        None
    }

    /// Returns `true` or `false`.
    pub fn boolean(&self) -> Option<bool> {
        let Node::Bool(value) = self.node else { return self.not("true or false") };
        Some(*value)
    }

    /// Returns a string.
    pub fn text(&self) -> Option<&'a str> {
        self.text_or("a string")
    }

    /// Returns a string; all else is called not what is expected here.
    pub fn text_or(&self, expected: &str) -> Option<&'a str> {
        let Node::Text(value) = self.node else { return self.not(expected) };
        Some(value)
    }

    /// Returns one of the known words.
    pub fn word(&self, known: &[&'static str]) -> Option<&'static str> {
        let written = self.text()?;
        let found = known.iter().copied().find(|word| *word == written);
        if found.is_none() {
            let (list, got, guess) = (List(known), Quoted(written), Guess { written, known });
            self.fault(
                FaultCode::UnknownWord,
                format_args!("must be one of: {list}, got {got}{guess}"),
            );
        }
        found
    }

    /// Returns a value of an enumeration.
    pub fn named<T: Named>(&self) -> Option<T> {
        let found = match self.node {
            Node::Text(written) => T::of_word(written),
            _ => None,
        };
        found.or_else(|| {
            let names: Vec<_> = T::ALL.iter().map(|value| value.name()).collect();
            T::of_word(self.word(&names)?)
        })
    }

    /// Returns an array with a number of items in a range. All items are read.
    pub fn array<T>(
        &self,
        lengths: RangeInclusive<usize>,
        read: impl Fn(Cursor<'_>) -> Option<T>,
    ) -> Option<Vec<T>> {
        let Node::Array(items) = self.node else {
            let Node::Number(value) = self.node else { return self.not("an array") };
            let value = Figure(*value);
            let detail =
                format_args!("must be an array, got a number; write [{value}] for a list of one");
            self.fault(FaultCode::WrongType, detail);
            return None;
        };
        if !lengths.contains(&items.len()) {
            let (least, most) = (lengths.start(), lengths.end());
            self.fault(
                FaultCode::WrongLength,
                format_args!("must have between {least} and {most} items, got {}", items.len()),
            );
            return None;
        }
        let read = items.iter().enumerate().map(|(index, node)| {
            let place = Place::Index(self.place, index);
            read(Cursor { node, place: &place, faults: self.faults })
        });
        // All items are read first: a missing one would end the collection.
        read.collect::<Vec<_>>().into_iter().collect()
    }

    /// Returns a pair of numbers, `[x, y]`.
    pub fn pair<T>(
        &self,
        read_first: impl FnOnce(Cursor<'_>) -> Option<T>,
        read_second: impl FnOnce(Cursor<'_>) -> Option<T>,
    ) -> Option<[T; 2]> {
        let Node::Array(items) = self.node else { return self.not("an array of 2 numbers") };
        let [first, second] = items.as_slice() else {
            self.fault(
                FaultCode::WrongLength,
                format_args!("must be an array of 2 numbers, got {}", Got(self.node)),
            );
            return None;
        };
        let first =
            read_first(Cursor { node: first, place: &Place::Index(self.place, 0), ..*self });
        let second =
            read_second(Cursor { node: second, place: &Place::Index(self.place, 1), ..*self });
        Some([first?, second?])
    }

    /// Records that this value has the wrong type.
    pub(super) fn not<T>(&self, expected: &str) -> Option<T> {
        let got = self.node.kind();
        match (self.node, self.place) {
            // Who lists moduli or materials asks for layers.
            (Node::Array(_), Place::Key(_, "material" | "young_modulus" | "poisson_ratio")) => {
                let layers = Guess { written: "layers", known: &[] };
                let detail = format_args!("must be {expected}, got {got}{layers}");
                self.fault(FaultCode::WrongType, detail);
            }
            _ => self.fault(FaultCode::WrongType, format_args!("must be {expected}, got {got}")),
        }
        None
    }
}
