//! The load of a job.

use std::ops::Deref;

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::fields::InUnits;
use super::reader::Cursor;
use super::{
    Domain, FaultCode, FieldError, HardnessTest, NonNegativeF64, PositiveF64, Rolling, Target,
    Units,
};

/// The load of a job. Several values are a sweep with one load step each.
#[derive(Debug, Clone, PartialEq)]
pub enum Load {
    /// Forces for the whole contact, both sides of the axis: N per mm of thickness in plane
    /// analyses, N in axisymmetry.
    Forces(Sweep),
    /// Approaches α of the supports \[mm\].
    Approaches(Sweep),
    /// Forces and approaches in sequence. Each load starts from the state after the load before:
    /// `{"history": [...]}`.
    History(History),
    /// The onset of yield; its force is the answer: `{"onset": true}`.
    Onset,
    /// A figure of the contact and its target value; the force is the answer: `{"target": {...}}`.
    Target(Target),
    /// A force that rolls over a track, pass after pass: `{"rolling": {"force": 2000}}`.
    Rolling(Rolling),
}

/// One to [`MAX_VALUES`](Self::MAX_VALUES) values of the load, in the order of their load steps.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep(Vec<PositiveF64>);

impl Sweep {
    /// Most values of a sweep.
    pub const MAX_VALUES: usize = 1000;

    /// Builds a sweep of one to [`MAX_VALUES`](Self::MAX_VALUES) values.
    ///
    /// # Errors
    /// The fault, with an empty pointer.
    pub fn new(values: Vec<PositiveF64>) -> Result<Self, Vec<FieldError>> {
        if (1..=Self::MAX_VALUES).contains(&values.len()) {
            return Ok(Self(values));
        }
        Err(vec![FieldError::new(
            "",
            format!("must have between 1 and {} items", Self::MAX_VALUES),
        )])
    }
}

impl From<PositiveF64> for Sweep {
    fn from(value: PositiveF64) -> Self {
        Self(vec![value])
    }
}

impl TryFrom<Vec<PositiveF64>> for Sweep {
    type Error = Vec<FieldError>;

    fn try_from(values: Vec<PositiveF64>) -> Result<Self, Self::Error> {
        Self::new(values)
    }
}

impl Deref for Sweep {
    type Target = [PositiveF64];

    fn deref(&self) -> &[PositiveF64] {
        &self.0
    }
}

/// One load of a history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HistoryLoad {
    /// A force as in [`Load::Forces`]; zero unloads the bodies.
    Force(NonNegativeF64),
    /// An approach as in [`Load::Approaches`]; zero returns the bodies to their first touch.
    Approach(NonNegativeF64),
}

impl HistoryLoad {
    const KINDS: &'static [&'static str] = &["force", "approach"];

    /// Returns the force or approach.
    pub fn magnitude(self) -> f64 {
        match self {
            Self::Force(value) | Self::Approach(value) => value.get(),
        }
    }

    fn read(cursor: Cursor<'_>, force: Domain, units: Option<Units>) -> Option<Self> {
        let object = cursor.object()?;
        object.only(Self::KINDS);
        let figure = |key, quantity: Domain| {
            object.required(key, |c| {
                if c.is_zero() {
                    NonNegativeF64::new(0.0).ok()
                } else {
                    c.quantity(quantity, units)
                }
            })
        };
        match (object.has("force"), object.has("approach")) {
            (true, false) => figure("force", force).map(Self::Force),
            (false, true) => figure("approach", Domain::Approach).map(Self::Approach),
            (both, _) => {
                let code = if both { FaultCode::Inconsistent } else { FaultCode::Required };
                object.fault_here(
                    code,
                    format_args!("must have one of: {}", Self::KINDS.join(", ")),
                );
                None
            }
        }
    }
}

/// One to [`Sweep::MAX_VALUES`] loads in sequence, at least one of them above zero.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    loads: Vec<HistoryLoad>,
    /// The hardness test that the reader wrote as these loads: `{"hardness": {...}}`.
    test: Option<HardnessTest>,
}

impl History {
    /// Builds a history of at most [`Sweep::MAX_VALUES`] loads, at least one of them above zero.
    ///
    /// # Errors
    /// The fault, with an empty pointer.
    pub fn new(loads: Vec<HistoryLoad>) -> Result<Self, Vec<FieldError>> {
        if !(1..=Sweep::MAX_VALUES).contains(&loads.len()) {
            let detail = format!("must have between 1 and {} items", Sweep::MAX_VALUES);
            return Err(vec![FieldError::new("", detail)]);
        }
        if loads.iter().all(|load| load.magnitude() == 0.0) {
            return Err(vec![FieldError::new("", "must have a load above zero")]);
        }
        Ok(Self { loads, test: None })
    }

    /// Builds the history of a hardness test.
    fn of_test(test: HardnessTest) -> Option<Self> {
        let load = |force| NonNegativeF64::new(force).ok().map(HistoryLoad::Force);
        let loads: Option<Vec<_>> = test.forces().into_iter().map(load).collect();
        Some(Self { test: Some(test), ..Self::new(loads?).ok()? })
    }
}

impl Deref for History {
    type Target = [HistoryLoad];

    fn deref(&self) -> &[HistoryLoad] {
        &self.loads
    }
}

impl Load {
    /// The keys of the wire format. A load has one of them.
    pub const KINDS: &'static [&'static str] = &[
        "force",
        "forces",
        "approach",
        "approaches",
        "history",
        "onset",
        "target",
        "rolling",
        "hardness",
    ];

    /// Returns the key of this load in the wire format: singular for one value.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Forces(values) if values.len() == 1 => "force",
            Self::Forces(_) => "forces",
            Self::Approaches(values) if values.len() == 1 => "approach",
            Self::Approaches(_) => "approaches",
            Self::History(History { test: Some(_), .. }) => HardnessTest::KEY,
            Self::History(_) => "history",
            Self::Onset => "onset",
            Self::Target(_) => "target",
            Self::Rolling(_) => Rolling::KEY,
        }
    }

    /// Whether its loads come one after the other; a force that is taken away counts.
    pub fn is_history(&self) -> bool {
        match self {
            Self::History(_) => true,
            Self::Target(target) => target.figure.is_permanent(),
            _ => false,
        }
    }

    /// Returns the hardness test whose history this is.
    pub fn hardness(&self) -> Option<&HardnessTest> {
        let Self::History(history) = self else { return None };
        history.test.as_ref()
    }

    /// Returns the smallest force above zero, if the job gives all loads as forces.
    pub fn least_force(&self) -> Option<f64> {
        let forces: Vec<f64> = match self {
            Self::Forces(forces) => forces.iter().map(|force| force.get()).collect(),
            Self::History(loads) => loads
                .iter()
                .map(|load| match load {
                    HistoryLoad::Force(force) => Some(force.get()),
                    HistoryLoad::Approach(_) => None,
                })
                .collect::<Option<_>>()?,
            _ => return None,
        };
        forces.into_iter().filter(|force| *force > 0.0).reduce(f64::min)
    }

    /// Reads a load. `force` is the quantity of a force in this analysis.
    pub(super) fn read(cursor: Cursor<'_>, force: Domain, units: Option<Units>) -> Option<Self> {
        let object = cursor.object()?;
        object.only(Self::KINDS);
        let one = |key, quantity| {
            object
                .required(key, |c| c.quantity(quantity, units))
                .map(|value: PositiveF64| value.into())
        };
        let many = |key, quantity| {
            object.required(key, |c| {
                c.array(1..=Sweep::MAX_VALUES, |item| item.quantity(quantity, units)).map(Sweep)
            })
        };
        let read = |kind: &&'static str| match *kind {
            "force" => one("force", force).map(Self::Forces),
            "forces" => many("forces", force).map(Self::Forces),
            "approach" => one("approach", Domain::Approach).map(Self::Approaches),
            "history" => object
                .required("history", |c| {
                    let loads = c.array(1..=Sweep::MAX_VALUES, |item| {
                        HistoryLoad::read(item, force, units)
                    })?;
                    c.checked(History::new(loads))
                })
                .map(Self::History),
            "onset" => {
                if object.required("onset", |c| c.boolean())? {
                    return Some(Self::Onset);
                }
                object.fault("onset", FaultCode::OutOfRange, format_args!("must be true"));
                None
            }
            "target" => object.required("target", |c| Target::read(c, units)).map(Self::Target),
            Rolling::KEY => object
                .required(Rolling::KEY, |c| Rolling::read(c, units, force))
                .map(Self::Rolling),
            HardnessTest::KEY => object
                .required(HardnessTest::KEY, |c| History::of_test(HardnessTest::read(c, units)?))
                .map(Self::History),
            _ => many("approaches", Domain::Approach).map(Self::Approaches),
        };
        let given: Vec<_> = Self::KINDS.iter().filter(|kind| object.has(kind)).collect();
        let loads: Vec<_> = given.iter().map(|kind| read(kind)).collect();
        match loads.len() {
            0 => object.fault_here(
                FaultCode::Required,
                format_args!("must have one of: {}", Self::KINDS.join(", ")),
            ),
            1 => return loads.into_iter().next().flatten(),
            _ => object.fault_here(
                FaultCode::Inconsistent,
                format_args!("must have only one of: {}", Self::KINDS.join(", ")),
            ),
        }
        None
    }
}

impl InUnits<'_, Load> {
    /// Returns the load in the wire format. `force` is the quantity of a force in this analysis.
    pub fn with_force(&self, force: Domain) -> impl Serialize {
        let wire = |values: &Sweep, quantity: Domain| {
            let value = |value: &PositiveF64| quantity.to_wire(self.1, value.get());
            match &values[..] {
                [one] => WireValue::One(value(one)),
                many => WireValue::Many(many.iter().map(value).collect()),
            }
        };
        let entry = |load: &HistoryLoad| match load {
            HistoryLoad::Force(value) => {
                WireHistoryLoad::Force(force.to_wire(self.1, value.get()))
            }
            HistoryLoad::Approach(value) => {
                WireHistoryLoad::Approach(Domain::Approach.to_wire(self.1, value.get()))
            }
        };
        let value = match self.0 {
            Load::Forces(values) => wire(values, force),
            Load::Approaches(values) => wire(values, Domain::Approach),
            Load::History(loads) => match &loads.test {
                Some(test) => WireValue::Hardness(InUnits(test, self.1)),
                None => WireValue::History(loads.iter().map(entry).collect()),
            },
            Load::Onset => WireValue::Yes(true),
            Load::Target(target) => WireValue::Target(InUnits(target, self.1)),
            Load::Rolling(rolling) => {
                let of_line = rolling.with_force(self.1, [force, Domain::LineForce]);
                WireValue::Rolling(OfLine(of_line, self.1))
            }
        };
        WireLoad { kind: self.0.kind(), value }
    }
}

/// A load that rolls whose force is written as that of a line.
struct OfLine(Rolling, Units);

impl Serialize for OfLine {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        InUnits(&self.0, self.1).serialize(serializer)
    }
}

struct WireLoad<'a> {
    kind: &'static str,
    value: WireValue<'a>,
}

#[derive(serde::Serialize)]
#[serde(untagged)]
enum WireValue<'a> {
    One(f64),
    Many(Vec<f64>),
    History(Vec<WireHistoryLoad>),
    Yes(bool),
    Target(InUnits<'a, Target>),
    Rolling(OfLine),
    Hardness(InUnits<'a, HardnessTest>),
}

#[derive(serde::Serialize)]
#[serde(rename_all = "snake_case")]
enum WireHistoryLoad {
    Force(f64),
    Approach(f64),
}

impl Serialize for WireLoad<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(1))?;
        map.serialize_entry(self.kind, &self.value)?;
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_is_neither_empty_nor_endless() {
        let one = PositiveF64::new(1.0).unwrap();
        assert!(Sweep::new(Vec::new()).is_err());
        assert!(Sweep::new(vec![one; Sweep::MAX_VALUES + 1]).is_err());
        assert_eq!(Sweep::new(vec![one; Sweep::MAX_VALUES]).unwrap().len(), Sweep::MAX_VALUES);
        assert_eq!(Sweep::from(one).first(), Some(&one));
    }
}
