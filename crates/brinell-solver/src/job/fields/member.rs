//! Reading and writing of the types of fields.

use serde::Serialize;
use serde::ser::Serializer;

use super::super::number::{NonNegativeF64, PoissonRatio, PositiveF64};
use super::super::reader::{Cursor, Object};
use super::{Field, FieldKind, FieldValue, NumberKind};
use crate::job::{Named, Units};

/// A type of field values.
pub(in crate::job) trait Member: Sized {
    /// Whether a job must give a field of this type without a default.
    const REQUIRED: bool = true;

    /// Reads the value of a field.
    fn read(cursor: Cursor<'_>, field: &Field, units: Option<Units>) -> Option<Self>;

    /// Returns the value in N–mm–MPa; `None` if the field is not written.
    fn value(&self) -> Option<FieldValue>;

    /// Returns the value of a missing field, for optional types.
    fn absent() -> Option<Self> {
        None
    }
}

/// Reads a field of an object. The field may be missing if it has a default or an optional type.
pub(in crate::job) fn read_member<T: Member>(
    object: &Object<'_>,
    field: &Field,
    units: Option<Units>,
    default: Option<T>,
) -> Option<T> {
    match default.or_else(T::absent) {
        Some(default) => object.or(field.key, default, |cursor| T::read(cursor, field, units)),
        None => object.required(field.key, |cursor| T::read(cursor, field, units)),
    }
}

/// Reads a number in the range of its figure.
fn read_figure<T: TryFrom<f64>>(
    cursor: Cursor<'_>,
    kind: &NumberKind,
    units: Option<Units>,
) -> Option<T> {
    match kind {
        NumberKind::Quantity(quantity) => cursor.quantity(*quantity, units),
        NumberKind::Pure(range) => cursor.number_in(range),
    }
}

macro_rules! numbers {
    ($($type:ty),+) => {$(
        impl Member for $type {
            fn read(cursor: Cursor<'_>, field: &Field, units: Option<Units>) -> Option<Self> {
                let FieldKind::Figure(kind) = &field.kind else { return None };
                read_figure(cursor, kind, units)
            }

            fn value(&self) -> Option<FieldValue> {
                Some(FieldValue::Figure(f64::from(*self)))
            }
        }
    )+};
}

numbers!(f64, PositiveF64, NonNegativeF64, PoissonRatio);

impl Member for u32 {
    fn read(cursor: Cursor<'_>, field: &Field, _: Option<Units>) -> Option<Self> {
        let FieldKind::Whole(range) = &field.kind else { return None };
        cursor.integer(range)
    }

    fn value(&self) -> Option<FieldValue> {
        Some(FieldValue::Whole(*self))
    }
}

impl Member for bool {
    fn read(cursor: Cursor<'_>, _: &Field, _: Option<Units>) -> Option<Self> {
        cursor.boolean()
    }

    fn value(&self) -> Option<FieldValue> {
        Some(FieldValue::Flag(*self))
    }
}

impl<T: Named> Member for T {
    fn read(cursor: Cursor<'_>, _: &Field, _: Option<Units>) -> Option<Self> {
        cursor.named()
    }

    fn value(&self) -> Option<FieldValue> {
        Some(FieldValue::Word(self.name()))
    }
}

/// A list of points. Types that check their points wrap this one.
impl Member for Vec<[f64; 2]> {
    fn read(cursor: Cursor<'_>, field: &Field, units: Option<Units>) -> Option<Self> {
        let FieldKind::Points { columns: [(_, first), (_, second)], count } = &field.kind else {
            return None;
        };
        cursor.array(count.clone(), |item| {
            item.pair(|c| read_figure(c, first, units), |c| read_figure(c, second, units))
        })
    }

    fn value(&self) -> Option<FieldValue> {
        Some(FieldValue::Points(self.clone()))
    }
}

impl<T: Member> Member for Option<T> {
    const REQUIRED: bool = false;

    fn read(cursor: Cursor<'_>, field: &Field, units: Option<Units>) -> Option<Self> {
        T::read(cursor, field, units).map(Some)
    }

    fn value(&self) -> Option<FieldValue> {
        self.as_ref().and_then(T::value)
    }

    fn absent() -> Option<Self> {
        Some(None)
    }
}

/// A value in the wire format, in a system of units.
pub(super) struct Written<'a>(pub &'a FieldValue, pub &'a Field, pub Units);

impl Serialize for Written<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let wire = |kind: &NumberKind, core| kind.to_wire(self.2, core);
        match (self.0, &self.1.kind) {
            (FieldValue::Figure(core), FieldKind::Figure(kind)) => {
                serializer.serialize_f64(wire(kind, *core))
            }
            (
                FieldValue::Points(points),
                FieldKind::Points { columns: [(_, first), (_, second)], .. },
            ) => serializer
                .collect_seq(points.iter().map(|[x, y]| [wire(first, *x), wire(second, *y)])),
            (FieldValue::Figure(core), _) => serializer.serialize_f64(*core),
            (FieldValue::Points(points), _) => points.serialize(serializer),
            (FieldValue::Whole(number), _) => serializer.serialize_u32(*number),
            (FieldValue::Flag(flag), _) => serializer.serialize_bool(*flag),
            (FieldValue::Word(word), _) => serializer.serialize_str(word),
        }
    }
}
