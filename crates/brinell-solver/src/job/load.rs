//! What presses the bodies together.

use std::ops::Deref;

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::reader::Cursor;
use super::wire::InUnits;
use super::{FaultCode, FieldError, PositiveF64, Quantity, Units};

/// What presses the bodies together. Several values are a sweep, one step each.
#[derive(Debug, Clone, PartialEq)]
pub enum Load {
    /// Forces for the whole contact, both sides of the axis: N per mm of thickness in plane analyses, N in
    /// axisymmetry.
    Forces(Sweep),
    /// Approaches α of the supports \[mm\].
    Approaches(Sweep),
    /// The force at which the contact begins to yield, which is the answer: `{"onset": true}`.
    Onset,
}

/// One to [`MAX_VALUES`](Self::MAX_VALUES) values of the load, in the order in which they are applied.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep(Vec<PositiveF64>);

impl Sweep {
    /// Most values of a sweep.
    pub const MAX_VALUES: usize = 1000;

    /// Takes values if there is at least one and at most [`MAX_VALUES`](Self::MAX_VALUES).
    ///
    /// # Errors
    /// The fault, with an empty pointer.
    pub fn new(values: Vec<PositiveF64>) -> Result<Self, Vec<FieldError>> {
        if (1..=Self::MAX_VALUES).contains(&values.len()) {
            return Ok(Self(values));
        }
        Err(vec![FieldError::new("", format!("must have between 1 and {} items", Self::MAX_VALUES))])
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

impl Load {
    /// The keys of the wire format, one of which a load has.
    pub const KINDS: &'static [&'static str] = &["force", "forces", "approach", "approaches", "onset"];

    /// The key under which this load is written: singular for one value.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Forces(values) if values.len() == 1 => "force",
            Self::Forces(_) => "forces",
            Self::Approaches(values) if values.len() == 1 => "approach",
            Self::Approaches(_) => "approaches",
            Self::Onset => "onset",
        }
    }

    /// Reads a load; `force` says what a force is in this analysis.
    pub(super) fn read(cursor: Cursor<'_>, force: Quantity, units: Option<Units>) -> Option<Self> {
        let object = cursor.object()?;
        object.only(Self::KINDS);
        let one = |key, quantity| {
            object.required(key, |c| c.quantity(quantity, units)).map(|value: PositiveF64| value.into())
        };
        let many = |key, quantity| {
            object.required(key, |c| {
                c.array(1..=Sweep::MAX_VALUES, |item| item.quantity(quantity, units)).map(Sweep)
            })
        };
        let read = |kind: &&'static str| match *kind {
            "force" => one("force", force).map(Self::Forces),
            "forces" => many("forces", force).map(Self::Forces),
            "approach" => one("approach", Quantity::Approach).map(Self::Approaches),
            "onset" => {
                if object.required("onset", |c| c.boolean())? {
                    return Some(Self::Onset);
                }
                object.fault("onset", FaultCode::OutOfRange, format_args!("must be true"));
                None
            }
            _ => many("approaches", Quantity::Approach).map(Self::Approaches),
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
    /// The load as it is written; `force` says what a force is in this analysis.
    pub fn with_force(&self, force: Quantity) -> impl Serialize {
        let wire = |values: &Sweep, quantity: Quantity| {
            Some(values.iter().map(|value| quantity.to_wire(self.1, value.get())).collect())
        };
        let values = match self.0 {
            Load::Forces(values) => wire(values, force),
            Load::Approaches(values) => wire(values, Quantity::Approach),
            Load::Onset => None,
        };
        WireLoad { kind: self.0.kind(), values }
    }
}

struct WireLoad {
    kind: &'static str,
    /// `None` is written as `true`.
    values: Option<Vec<f64>>,
}

impl Serialize for WireLoad {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(1))?;
        match self.values.as_deref() {
            None => map.serialize_entry(self.kind, &true)?,
            Some([value]) => map.serialize_entry(self.kind, value)?,
            Some(values) => map.serialize_entry(self.kind, values)?,
        }
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
