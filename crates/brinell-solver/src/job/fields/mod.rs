//! One table of fields per object of the job: its reader, its writer, its schema and its form come
//! from it.
//!
//! `record!` declares a struct and its table together, `tagged!` an enumeration of such structs
//! that a word tells apart. Each law of hardening and each shape is one file that holds one such
//! declaration.
//!
//! ```text
//! record! {
//!     /// A straight line beyond the yield stress.
//!     pub struct Bilinear("bilinear", "Bilinear") {
//!         /// Yield stress σ_y.
//!         pub yield_stress: PositiveF64 = Field::quantity(Quantity::Stress).label("Yield stress", "σ_y").example(500.0),
//!     }
//! }
//! ```

mod member;
mod record;

use std::ops::RangeInclusive;

use super::{FieldError, Named, Quantity, Units};

pub(super) use member::{Member, read_member};
pub(super) use record::{
    Record, faults_of, read_record, read_record_of, read_settings, read_settings_from,
    write_record,
};
pub(super) use record::{record, tagged};

/// Names, description and fields of one object of the job.
#[derive(Debug, Clone)]
pub struct FieldTable {
    /// Name of the type, e.g. `RambergOsgood`.
    pub name: &'static str,
    /// The word that tells this object from its siblings, e.g. `ramberg_osgood`; empty if it has
    /// none.
    pub word: &'static str,
    /// What a form calls it.
    pub label: &'static str,
    /// One sentence, with the equation of a law.
    pub description: &'static str,
    /// Its fields, in the order in which messages list them.
    pub fields: &'static [Field],
}

/// One field of an object of the job.
#[derive(Debug, Clone)]
pub struct Field {
    /// Its key.
    pub key: &'static str,
    /// What it means.
    pub description: &'static str,
    /// What a form calls it.
    pub label: &'static str,
    /// Its symbol in the equations; `_` and `^` write what follows below and above.
    pub symbol: &'static str,
    /// What it holds.
    pub kind: FieldKind,
    /// A typical figure, in N–mm–MPa.
    pub example: Example,
    /// Whether it must be given.
    pub required: bool,
}

/// A typical value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Example {
    /// None: one of the words, or the default, is example enough.
    None,
    /// Of a figure.
    Figure(f64),
    /// Of a list of points.
    Points(&'static [[f64; 2]]),
}

/// What a field holds.
#[derive(Debug, Clone)]
pub enum FieldKind {
    /// A number.
    Figure(Figure),
    /// A whole number in a range.
    Whole(RangeInclusive<u32>),
    /// `true` or `false`.
    Flag,
    /// One word of a named enumeration: the name of its type, and its words.
    Choice(&'static str, fn() -> Vec<&'static str>),
    /// Points, each a pair of figures.
    Points {
        /// The two figures of a point, with their descriptions.
        columns: [(&'static str, Figure); 2],
        /// How many points there may be.
        count: RangeInclusive<usize>,
    },
}

/// A number and its range.
#[derive(Debug, Clone)]
pub enum Figure {
    /// With a unit; the quantity has the range.
    Quantity(Quantity),
    /// Without a unit.
    Pure(RangeInclusive<f64>),
}

impl Figure {
    /// Smallest and largest figure accepted, in N–mm–MPa.
    pub const fn range(&self) -> (f64, f64) {
        match self {
            Self::Quantity(quantity) => quantity.range(),
            Self::Pure(range) => (*range.start(), *range.end()),
        }
    }

    /// A figure in N–mm–MPa as it is written on the wire.
    pub fn to_wire(&self, units: Units, core: f64) -> f64 {
        match self {
            Self::Quantity(quantity) => quantity.to_wire(units, core),
            Self::Pure(_) => core,
        }
    }
}

impl Field {
    const fn new(kind: FieldKind) -> Self {
        Self {
            key: "",
            description: "",
            label: "",
            symbol: "",
            kind,
            example: Example::None,
            required: true,
        }
    }

    /// A figure with a unit.
    pub(super) const fn quantity(quantity: Quantity) -> Self {
        Self::new(FieldKind::Figure(Figure::Quantity(quantity)))
    }

    /// A figure without a unit.
    pub(super) const fn pure(range: RangeInclusive<f64>) -> Self {
        Self::new(FieldKind::Figure(Figure::Pure(range)))
    }

    /// A whole number.
    pub(super) const fn whole(range: RangeInclusive<u32>) -> Self {
        Self::new(FieldKind::Whole(range))
    }

    /// True or false.
    pub(super) const fn flag() -> Self {
        Self::new(FieldKind::Flag)
    }

    /// One of the words of `T`, whose type is called `name`.
    pub(super) const fn choice<T: Named>(name: &'static str) -> Self {
        Self::new(FieldKind::Choice(name, words::<T>))
    }

    /// Points.
    pub(super) const fn points(
        columns: [(&'static str, Figure); 2],
        count: RangeInclusive<usize>,
    ) -> Self {
        Self::new(FieldKind::Points { columns, count })
    }

    /// The same with a label and a symbol.
    pub(super) const fn label(mut self, label: &'static str, symbol: &'static str) -> Self {
        self.label = label;
        self.symbol = symbol;
        self
    }

    /// The same with a typical figure.
    pub(super) const fn example(mut self, example: f64) -> Self {
        self.example = Example::Figure(example);
        self
    }

    /// The same with typical points.
    pub(super) const fn example_points(mut self, points: &'static [[f64; 2]]) -> Self {
        self.example = Example::Points(points);
        self
    }

    /// The same with the key, the description and the necessity that its declaration gives it.
    pub(super) const fn declared(
        mut self,
        key: &'static str,
        description: &'static str,
        required: bool,
    ) -> Self {
        self.key = key;
        self.description = description;
        self.required = required;
        self
    }
}

/// The words of an enumeration.
pub fn words<T: Named>() -> Vec<&'static str> {
    T::ALL.iter().map(|value| value.name()).collect()
}

/// The figures and points of an object that could be read, for rules between several of them.
#[derive(Debug, Default)]
pub(super) struct Known {
    pub values: Vec<(&'static str, Value)>,
    /// Keys of the fields that are given, whether they could be read or not.
    pub given: Vec<&'static str>,
}

impl Known {
    /// A figure, in N–mm–MPa; `None` if it is missing or at fault.
    pub fn figure(&self, key: &str) -> Option<f64> {
        let found = self.values.iter().find(|(name, _)| *name == key);
        found.and_then(
            |(_, value)| if let Value::Figure(figure) = value { Some(*figure) } else { None },
        )
    }

    /// A word; `None` if it is missing or at fault.
    pub fn word(&self, key: &str) -> Option<&'static str> {
        let found = self.values.iter().find(|(name, _)| *name == key);
        found.and_then(|(_, value)| if let Value::Word(word) = value { Some(*word) } else { None })
    }

    /// Whether a field is given, at fault or not.
    pub fn has(&self, key: &str) -> bool {
        self.given.contains(&key)
    }

    /// Points, in N–mm–MPa; `None` if they are missing or at fault.
    pub fn points(&self, key: &str) -> Option<&[[f64; 2]]> {
        let found = self.values.iter().find(|(name, _)| *name == key);
        found.and_then(
            |(_, value)| if let Value::Points(points) = value { Some(&**points) } else { None },
        )
    }
}

/// What a field holds, in N–mm–MPa.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number.
    Figure(f64),
    /// A whole number.
    Whole(u32),
    /// True or false.
    Flag(bool),
    /// A word.
    Word(&'static str),
    /// Points.
    Points(Vec<[f64; 2]>),
}

/// A fault of a field beside its siblings.
pub(super) fn unless(holds: bool, pointer: &str, detail: &str) -> Option<FieldError> {
    (!holds).then(|| FieldError::new(pointer, detail))
}
