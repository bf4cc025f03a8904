//! Tables of fields. The reader, the writer, the schema and the form of an object of the job all
//! derive from its table.
//!
//! `record!` declares a struct together with its table, and `tagged!` an enumeration of records
//! with a word for each. Every hardening law and every shape is one `record!`.
//!
//! ```text
//! record! {
//!     /// A straight line beyond the yield stress.
//!     pub struct Bilinear("bilinear", "Bilinear") {
//!         /// Yield stress σ_y.
//!         pub yield_stress: PositiveF64 = Field::quantity(Domain::Stress).label("Yield stress", "σ_y").example(500.0),
//!     }
//! }
//! ```

mod member;
mod record;

use std::ops::RangeInclusive;

use super::{Domain, FieldError, Named, Units};

pub(super) use member::{Member, read_member};
pub(super) use record::{
    InUnits, Record, faults_of, read_record, read_record_of, read_settings, read_settings_from,
    write_record,
};
pub(super) use record::{record, tagged};

/// Names, description and fields of one object of the job.
#[derive(Debug, Clone)]
pub struct FieldTable {
    /// Name of the type, e.g. `RambergOsgood`.
    pub name: &'static str,
    /// The word that names this kind of object, e.g. `ramberg_osgood`; empty if there is only one
    /// kind.
    pub word: &'static str,
    /// Its label in a form.
    pub label: &'static str,
    /// One sentence, with the equation of a law.
    pub description: &'static str,
    /// Its fields, in the order in which messages list them.
    pub fields: &'static [Field],
}

/// One field of an object of the job.
#[derive(Debug, Clone)]
pub struct Field {
    /// Its key in the wire format.
    pub key: &'static str,
    /// Its meaning.
    pub description: &'static str,
    /// Its label in a form.
    pub label: &'static str,
    /// Its symbol in equations; `_` and `^` mark subscripts and superscripts.
    pub symbol: &'static str,
    /// The type and range of its value.
    pub kind: FieldKind,
    /// A typical value, in N–mm–MPa.
    pub example: Example,
    /// Whether a job must give it.
    pub required: bool,
}

/// A typical value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Example {
    /// No example: the words or the default serve as one.
    None,
    /// A figure.
    Figure(f64),
    /// A list of points.
    Points(&'static [[f64; 2]]),
}

/// The type and range of a field's value.
#[derive(Debug, Clone)]
pub enum FieldKind {
    /// A number.
    Figure(NumberKind),
    /// A whole number in a range.
    Whole(RangeInclusive<u32>),
    /// `true` or `false`.
    Flag,
    /// One word of a named enumeration, with the name of its type and its words.
    Choice(&'static str, fn() -> Vec<&'static str>),
    /// Points, each a pair of figures.
    Points {
        /// The two figures of a point, with their descriptions.
        columns: [(&'static str, NumberKind); 2],
        /// Range of the number of points.
        count: RangeInclusive<usize>,
    },
}

/// A number and its range.
#[derive(Debug, Clone)]
pub enum NumberKind {
    /// A figure with a unit; the quantity determines the range.
    Quantity(Domain),
    /// A figure without a unit.
    Pure(RangeInclusive<f64>),
}

impl NumberKind {
    /// Returns the smallest and largest valid figure, in N–mm–MPa.
    pub const fn range(&self) -> (f64, f64) {
        match self {
            Self::Quantity(quantity) => quantity.range(),
            Self::Pure(range) => (*range.start(), *range.end()),
        }
    }

    /// Converts a figure in N–mm–MPa to the wire format.
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

    /// Returns a field for a figure with a unit.
    pub(super) const fn quantity(quantity: Domain) -> Self {
        Self::new(FieldKind::Figure(NumberKind::Quantity(quantity)))
    }

    /// Returns a field for a figure without a unit.
    pub(super) const fn pure(range: RangeInclusive<f64>) -> Self {
        Self::new(FieldKind::Figure(NumberKind::Pure(range)))
    }

    /// Returns a field for a whole number.
    pub(super) const fn whole(range: RangeInclusive<u32>) -> Self {
        Self::new(FieldKind::Whole(range))
    }

    /// Returns a field for `true` or `false`.
    pub(super) const fn flag() -> Self {
        Self::new(FieldKind::Flag)
    }

    /// Returns a field for one of the words of `T`, with `name` as the name of this type.
    pub(super) const fn choice<T: Named>(name: &'static str) -> Self {
        Self::new(FieldKind::Choice(name, words::<T>))
    }

    /// Returns a field for a list of points.
    pub(super) const fn points(
        columns: [(&'static str, NumberKind); 2],
        count: RangeInclusive<usize>,
    ) -> Self {
        Self::new(FieldKind::Points { columns, count })
    }

    /// Returns the field with a label and a symbol.
    pub(super) const fn label(mut self, label: &'static str, symbol: &'static str) -> Self {
        self.label = label;
        self.symbol = symbol;
        self
    }

    /// Returns the field with a typical figure.
    pub(super) const fn example(mut self, example: f64) -> Self {
        self.example = Example::Figure(example);
        self
    }

    /// Returns the field with typical points.
    pub(super) const fn example_points(mut self, points: &'static [[f64; 2]]) -> Self {
        self.example = Example::Points(points);
        self
    }

    /// Returns the field with its key, its description and whether a job must give it.
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

/// Returns the words of an enumeration.
pub fn words<T: Named>() -> Vec<&'static str> {
    T::ALL.iter().map(|value| value.name()).collect()
}

/// The valid figures, words and points of an object, for conditions between fields.
#[derive(Debug, Default)]
pub(super) struct Known {
    pub values: Vec<(&'static str, FieldValue)>,
    /// Keys of all given fields, valid or not.
    pub given: Vec<&'static str>,
}

impl Known {
    /// Returns a figure in N–mm–MPa; `None` if it is missing or invalid.
    pub fn figure(&self, key: &str) -> Option<f64> {
        let found = self.values.iter().find(|(name, _)| *name == key);
        found.and_then(
            |(_, value)| if let FieldValue::Figure(figure) = value { Some(*figure) } else { None },
        )
    }

    /// Returns a word; `None` if it is missing or invalid.
    pub fn word(&self, key: &str) -> Option<&'static str> {
        let found = self.values.iter().find(|(name, _)| *name == key);
        found.and_then(
            |(_, value)| if let FieldValue::Word(word) = value { Some(*word) } else { None },
        )
    }

    /// Whether a field is given, valid or not.
    pub fn has(&self, key: &str) -> bool {
        self.given.contains(&key)
    }

    /// Returns points in N–mm–MPa; `None` if they are missing or invalid.
    pub fn points(&self, key: &str) -> Option<&[[f64; 2]]> {
        let found = self.values.iter().find(|(name, _)| *name == key);
        found.and_then(
            |(_, value)| {
                if let FieldValue::Points(points) = value { Some(&**points) } else { None }
            },
        )
    }
}

/// The value of a field, in N–mm–MPa.
#[derive(Debug, Clone, PartialEq)]
pub enum FieldValue {
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

/// Returns a fault of a field unless a condition holds.
pub(super) fn unless(holds: bool, pointer: &str, detail: &str) -> Option<FieldError> {
    (!holds).then(|| FieldError::new(pointer, detail))
}
