//! The questions that turn a job round: which input gives a figure a value, and what tolerances
//! of inputs do to the answers. Numbers stand in the units of the job, as they are written.

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::figure::{BarKind, Name};
use super::reader::Cursor;
use super::{FaultCode, Named, Side};

/// An input that is sought between two ends for what it does to a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Find {
    /// JSON pointers of the numbers that take the value.
    pub vary: Vec<String>,
    /// The ends, the smaller one first.
    pub between: [f64; 2],
    /// The figure of the last load step.
    pub figure: Name,
    /// Of which body it is, where both have it; `None` for the largest figure of its name.
    pub body: Option<Side>,
    /// What it shall be.
    pub wanted: Wanted,
}

/// What a figure shall be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Wanted {
    /// This value, in the unit of its row.
    Value(f64),
    /// As small as it becomes between the ends.
    Least,
    /// As large as it becomes between the ends.
    Most,
}

/// The relative tolerance of a number of the job, to either side.
#[derive(Debug, Clone, PartialEq)]
pub struct Tolerance {
    /// The JSON pointer of the number.
    pub pointer: String,
    /// The tolerance.
    pub relative: f64,
}

impl Find {
    /// Most numbers that take one value.
    pub const MOST_VARIED: usize = 8;
    pub(super) const KEYS: [&'static str; 3] = ["vary", "between", "until"];
    /// Keys of `until` beside the names of figures.
    pub(super) const ENDS: [&'static str; 2] = ["least", "most"];
    pub(super) const BODY: &'static str = "body";

    /// Returns the names of all figures that can be wanted: those whose error is bounded.
    pub(super) fn figures() -> impl Iterator<Item = Name> {
        let found = [Name::InputFound, Name::ForceFound, Name::ForceSensitivity];
        let all = Name::ALL.iter().copied();
        all.filter(move |name| name.bar() != BarKind::None && !found.contains(name))
    }

    pub(super) fn read(cursor: Cursor<'_>) -> Option<Self> {
        let object = cursor.object()?;
        object.only(&Self::KEYS);
        let vary = object.required("vary", |c| {
            if c.is_array() {
                c.array(1..=Self::MOST_VARIED, |item| item.text().map(str::to_owned))
            } else {
                Some(vec![c.text_or("a JSON pointer or a list of those")?.to_owned()])
            }
        });
        let between = object.required("between", |c| {
            let [low, high] = c.pair(|c| c.number(), |c| c.number())?;
            if low < high {
                return Some([low, high]);
            }
            c.fault(FaultCode::Inconsistent, format_args!("must have the smaller end first"));
            None
        });
        let until = object.required("until", Self::read_until);
        let (vary, between, (figure, body, wanted)) = (vary?, between?, until?);
        Some(Self { vary, between, figure, body, wanted })
    }

    fn read_until(cursor: Cursor<'_>) -> Option<(Name, Option<Side>, Wanted)> {
        let object = cursor.object()?;
        let figures: Vec<&str> = Self::figures().map(Named::name).collect();
        let names = Name::ALL.iter().map(|name| name.name());
        let known: Vec<&str> = Self::ENDS.into_iter().chain(names).collect();
        let bodies = Side::BOTH.map(Side::name);
        object.only(&[&known[..], &[Self::BODY]].concat());
        let body = object.or(Self::BODY, None, |c| {
            let word = c.word(&bodies)?;
            Some(Side::BOTH.into_iter().find(|side| side.name() == word))
        })?;
        let named = |word: &str| Self::figures().find(|name| name.name() == word);
        let read = |key: &&str| match *key {
            "least" => object.required(key, |c| Some((named(c.word(&figures)?)?, Wanted::Least))),
            "most" => object.required(key, |c| Some((named(c.word(&figures)?)?, Wanted::Most))),
            figure => object.required(figure, |c| {
                let value = c.number()?;
                let name = named(figure);
                if value == 0.0 || name.is_none() {
                    let why = if name.is_none() {
                        "cannot be wanted: nothing bounds the error of this figure"
                    } else {
                        "must not be 0"
                    };
                    c.fault(FaultCode::OutOfRange, format_args!("{why}"));
                    return None;
                }
                Some((name?, Wanted::Value(value)))
            }),
        };
        let given: Vec<_> = known.iter().filter(|key| object.has(key)).map(read).collect();
        if let [wanted] = given[..] {
            return wanted.map(|(figure, wanted)| (figure, body, wanted));
        }
        let (code, only) = match given.len() {
            // Unknown keys are told already.
            0 if object.len() > usize::from(object.has(Self::BODY)) => return None,
            0 => (FaultCode::Required, ""),
            _ => (FaultCode::Inconsistent, "only "),
        };
        let detail = format_args!("must have {only}one figure, as `least`, `most` or a value");
        object.fault_here(code, detail);
        None
    }
}

impl Tolerance {
    /// Most tolerances of a job.
    pub const MOST: usize = 32;
    /// Largest tolerance.
    pub const LARGEST: f64 = 0.5;

    pub(super) fn read_all(cursor: Cursor<'_>) -> Option<Vec<Self>> {
        let object = cursor.object()?;
        if !(1..=Self::MOST).contains(&object.len()) {
            let detail = format_args!("must have between 1 and {} members", Self::MOST);
            object.fault_here(FaultCode::WrongLength, detail);
            return None;
        }
        let mut all = Vec::new();
        object.each(|key, c| {
            all.push(
                c.number_in::<f64>(&(1e-6..=Self::LARGEST))
                    .map(|relative| (key.to_owned(), relative)),
            );
        });
        let tolerance = |(pointer, relative)| Self { pointer, relative };
        all.into_iter().map(|one| one.map(tolerance)).collect()
    }

    /// Writes tolerances as they are read.
    pub(super) fn write_all(all: &[Self]) -> impl Serialize + '_ {
        struct Written<'a>(&'a [Tolerance]);
        impl Serialize for Written<'_> {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_map(self.0.iter().map(|one| (&one.pointer, one.relative)))
            }
        }
        Written(all)
    }
}

impl Serialize for Find {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut until = serde_json::Map::new();
        match self.wanted {
            Wanted::Value(value) => until.insert(self.figure.name().to_owned(), value.into()),
            Wanted::Least => until.insert("least".to_owned(), self.figure.name().into()),
            Wanted::Most => until.insert("most".to_owned(), self.figure.name().into()),
        };
        if let Some(body) = self.body {
            until.insert(Self::BODY.to_owned(), body.name().into());
        }
        let mut map = serializer.serialize_map(Some(3))?;
        match &self.vary[..] {
            [one] => map.serialize_entry("vary", one)?,
            many => map.serialize_entry("vary", many)?,
        }
        map.serialize_entry("between", &self.between)?;
        map.serialize_entry("until", &until)?;
        map.end()
    }
}
