//! Objects of the job, declared together with their tables of fields.

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::super::reader::{Cursor, Object};
use super::member::Written;
use super::{FieldKind, FieldTable, FieldValue, Known, NumberKind};
use crate::job::{FaultCode, FieldError, Units};

/// An object of the job with a table of fields.
pub(in crate::job) trait Record: Sized {
    /// The table of its fields.
    const TABLE: FieldTable;

    /// Reads all fields, so that every fault is found, and adds the valid ones to `known`. A
    /// missing field takes its value from `default`.
    fn read_fields(
        object: &Object<'_>,
        units: Option<Units>,
        default: Option<Self>,
        known: &mut Known,
    ) -> Option<Self>;

    /// Returns the values in the order of the table.
    fn values(&self) -> Vec<Option<FieldValue>>;

    /// Checks conditions between the known fields. Pointers are relative to the object.
    fn rules(_known: &Known) -> Vec<FieldError> {
        Vec::new()
    }
}

/// Reads an object with the keys of the table and, if the table has a word, the key `tag`.
pub(in crate::job) fn read_record<T: Record>(
    object: &Object<'_>,
    tag: Option<&'static str>,
    units: Option<Units>,
    default: Option<T>,
    beside: &[(&'static str, f64)],
) -> Option<T> {
    read_record_of(object, tag, &[], units, default, beside)
}

/// Reads an object like [`read_record`], with the additional keys `shared`, which the caller
/// reads.
pub(in crate::job) fn read_record_of<T: Record>(
    object: &Object<'_>,
    tag: Option<&'static str>,
    shared: &[&'static str],
    units: Option<Units>,
    default: Option<T>,
    beside: &[(&'static str, f64)],
) -> Option<T> {
    let own = T::TABLE.fields.iter().map(|field| field.key);
    let keys: Vec<_> = tag.into_iter().chain(own).chain(shared.iter().copied()).collect();
    object.only(&keys);
    let given =
        T::TABLE.fields.iter().map(|field| field.key).filter(|key| object.has(key)).collect();
    let mut known = Known { values: beside_values(beside), given };
    let read = T::read_fields(object, units, default, &mut known);
    let faults = T::rules(&known);
    let holds = faults.is_empty();
    object.report(faults);
    read.filter(|_| holds)
}

/// Returns the faults of an object that was built in code: its rules and the ranges of its
/// figures.
pub(in crate::job) fn faults_of<T: Record>(
    record: &T,
    beside: &[(&'static str, f64)],
) -> Vec<FieldError> {
    let mut known = Known { values: beside_values(beside), given: Vec::new() };
    let mut faults = Vec::new();
    for (field, value) in T::TABLE.fields.iter().zip(record.values()) {
        let Some(value) = value else { continue };
        if let (FieldKind::Figure(NumberKind::Pure(range)), FieldValue::Figure(figure)) =
            (&field.kind, &value)
            && !range.contains(figure)
        {
            let detail = format!("must be between {} and {}", range.start(), range.end());
            let pointer = format!("/{}", field.key);
            faults.push(FieldError { pointer, code: FaultCode::OutOfRange, detail });
        }
        known.values.push((field.key, value));
        known.given.push(field.key);
    }
    faults.extend(T::rules(&known));
    faults
}

fn beside_values(beside: &[(&'static str, f64)]) -> Vec<(&'static str, FieldValue)> {
    beside.iter().map(|(key, figure)| (*key, FieldValue::Figure(*figure))).collect()
}

/// Reads an object whose fields all have defaults.
pub(in crate::job) fn read_settings<T: Record + Default>(cursor: Cursor<'_>) -> Option<T> {
    read_settings_from(cursor, T::default())
}

/// Reads an object whose missing fields take their values from `default`.
pub(in crate::job) fn read_settings_from<T: Record>(cursor: Cursor<'_>, default: T) -> Option<T> {
    read_record(&cursor.object()?, None, None, Some(default), &[])
}

/// Writes the fields of an object.
pub(in crate::job) fn write_record<T: Record, M: SerializeMap>(
    record: &T,
    map: &mut M,
    units: Units,
) -> Result<(), M::Error> {
    for (field, value) in T::TABLE.fields.iter().zip(record.values()) {
        if let Some(value) = value {
            map.serialize_entry(field.key, &Written(&value, field, units))?;
        }
    }
    Ok(())
}

/// A part of a job, to be written in these units.
pub(in crate::job) struct InUnits<'a, T>(pub &'a T, pub Units);

impl<T: Record> Serialize for InUnits<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        write_record(self.0, &mut map, self.1)?;
        map.end()
    }
}

/// Declares a struct and its [`FieldTable`] in one listing. The doc comments become the
/// descriptions. `rules` names the function that checks conditions between fields.
macro_rules! record {
    (
        $(#[doc = $doc:literal])+
        $(#[derive($($derive:ident),+)])?
        pub struct $name:ident($word:literal, $label:literal) $(where $rules:path)? {
            $(
                $(#[doc = $field_doc:literal])+
                $visible:vis $field:ident: $type:ty = $kind:expr
            ),+ $(,)?
        }
    ) => {
        $(#[doc = $doc])+
        #[derive(Debug, Clone, PartialEq)]
        $(#[derive($($derive),+)])?
        pub struct $name {
            $(
                $(#[doc = $field_doc])+
                $visible $field: $type
            ),+
        }

        impl $crate::job::fields::Record for $name {
            const TABLE: $crate::job::fields::FieldTable = $crate::job::fields::FieldTable {
                name: stringify!($name),
                word: $word,
                label: $label,
                description: concat!($($doc),+).trim_ascii(),
                fields: &[$(
                    $kind.declared(
                        stringify!($field),
                        concat!($($field_doc),+).trim_ascii(),
                        <$type as $crate::job::fields::Member>::REQUIRED,
                    )
                ),+],
            };

            fn read_fields(
                object: &$crate::job::reader::Object<'_>,
                units: Option<$crate::job::Units>,
                default: Option<Self>,
                known: &mut $crate::job::fields::Known,
            ) -> Option<Self> {
                let mut table = Self::TABLE.fields.iter();
                $(
                    let field = table.next()?;
                    let default_value = default.as_ref().map(|default| default.$field.clone());
                    let $field: Option<$type> =
                        $crate::job::fields::read_member(object, field, units, default_value);
                    let value = $field.as_ref().and_then($crate::job::fields::Member::value);
                    known.values.extend(value.map(|value| (field.key, value)));
                )+
                Some(Self { $($field: $field?),+ })
            }

            fn values(&self) -> Vec<Option<$crate::job::fields::FieldValue>> {
                vec![$($crate::job::fields::Member::value(&self.$field)),+]
            }

            $(
                fn rules(known: &$crate::job::fields::Known) -> Vec<$crate::job::FieldError> {
                    $rules(known)
                }
            )?
        }
    };
}

/// Declares an enumeration of records. A word under one key names the variant.
macro_rules! tagged {
    (
        $(#[doc = $doc:literal])+
        pub enum $name:ident by $tag:literal $(beside $($shared:literal),+)? { $($variant:ident),+ $(,)? }
    ) => {
        $(#[doc = $doc])+
        #[derive(Debug, Clone, PartialEq)]
        pub enum $name {
            $(
                #[doc = concat!("[`", stringify!($variant), "`].")]
                $variant($variant)
            ),+
        }

        impl $name {
            /// The key of the word that names the variant.
            pub const TAG: &'static str = $tag;

            /// The tables of all variants, in the order in which messages list them.
            pub const TABLES: &'static [$crate::job::FieldTable] =
                &[$(<$variant as $crate::job::fields::Record>::TABLE),+];

            /// Returns the table of this variant.
            pub const fn table(&self) -> &'static $crate::job::FieldTable {
                match self {
                    $(Self::$variant(_) => const { &<$variant as $crate::job::fields::Record>::TABLE }),+
                }
            }

            /// Returns every given field with its value in N–mm–MPa.
            pub fn values(&self) -> Vec<(&'static $crate::job::Field, $crate::job::fields::FieldValue)> {
                let values = match self {
                    $(Self::$variant(record) => $crate::job::fields::Record::values(record)),+
                };
                let given = self.table().fields.iter().zip(values);
                given.filter_map(|(field, value)| Some((field, value?))).collect()
            }

            /// Reads the variant that the tag names. `beside` holds figures of the enclosing
            /// object for the rules.
            pub(in crate::job) fn read(
                cursor: $crate::job::reader::Cursor<'_>,
                units: Option<$crate::job::Units>,
                beside: &[(&'static str, f64)],
            ) -> Option<Self> {
                use $crate::job::fields::{Record, read_record_of};
                let shared: &[&'static str] = &[$($($shared),+)?];
                let object = cursor.object()?;
                let words: Vec<_> = Self::TABLES.iter().map(|table| table.word).collect();
                let word = object.required(Self::TAG, |cursor| cursor.word(&words))?;
                $(
                    if word == <$variant as Record>::TABLE.word {
                        return read_record_of(&object, Some(Self::TAG), shared, units, None, beside)
                            .map(Self::$variant);
                    }
                )+
                None
            }

            /// Returns the faults of an object that was built in code, with pointers relative to
            /// the object. `beside` holds figures of the enclosing object for the rules.
            pub fn faults(&self, beside: &[(&'static str, f64)]) -> Vec<$crate::job::FieldError> {
                match self {
                    $(Self::$variant(record) => $crate::job::fields::faults_of(record, beside)),+
                }
            }
        }

        $(
            impl From<$variant> for $name {
                fn from(record: $variant) -> Self {
                    Self::$variant(record)
                }
            }
        )+

        impl serde::Serialize for $crate::job::fields::InUnits<'_, $name> {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                use serde::ser::SerializeMap;
                let mut map = serializer.serialize_map(None)?;
                map.serialize_entry($name::TAG, self.0.table().word)?;
                match self.0 {
                    $($name::$variant(record) => {
                        $crate::job::fields::write_record(record, &mut map, self.1)?;
                    }),+
                }
                map.end()
            }
        }
    };
}

pub(in crate::job) use {record, tagged};
