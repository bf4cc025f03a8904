//! JSON in which every number is a number.
//!
//! `serde_json` writes NaN and infinities as `null`. A report must not leave like that, so it is walked through
//! once before it is written, and the first number that is none is named by its JSON pointer.

use bytes::Bytes;
use serde::{Serialize, ser};
use thiserror::Error;

/// Why a value was not written.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum EncodeError {
    /// A number is NaN or infinite.
    #[error("{pointer} is not a finite number")]
    NotFinite {
        /// Where it stands.
        pointer: String,
    },
    /// The value has no JSON form.
    #[error("{0}")]
    Json(String),
}

impl ser::Error for EncodeError {
    fn custom<T: std::fmt::Display>(message: T) -> Self {
        Self::Json(message.to_string())
    }
}

/// Writes a value as JSON.
///
/// # Errors
/// [`EncodeError::NotFinite`] if any number in it is NaN or infinite.
pub fn encode<T: Serialize>(value: &T) -> Result<Bytes, EncodeError> {
    check_finite(value)?;
    serde_json::to_vec(value).map(Bytes::from).map_err(|error| EncodeError::Json(error.to_string()))
}

/// Checks that every number in a value is one.
///
/// # Errors
/// [`EncodeError::NotFinite`] names the first that is not.
pub fn check_finite<T: Serialize>(value: &T) -> Result<(), EncodeError> {
    value.serialize(&mut Probe::default())
}

/// Walks through a value without writing it, and knows where it is.
#[derive(Default)]
struct Probe {
    path: String,
}

impl Probe {
    fn number(&self, value: f64) -> Result<(), EncodeError> {
        if value.is_finite() { Ok(()) } else { Err(EncodeError::NotFinite { pointer: self.path.clone() }) }
    }

    fn child<T: Serialize + ?Sized>(&mut self, name: &str, value: &T) -> Result<(), EncodeError> {
        let length = self.path.len();
        self.path.push('/');
        self.path.push_str(name);
        value.serialize(&mut *self)?;
        self.path.truncate(length);
        Ok(())
    }
}

/// Inside a list, a map or a struct.
struct Inside<'a> {
    probe: &'a mut Probe,
    index: usize,
    key: String,
}

impl Inside<'_> {
    fn element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), EncodeError> {
        let name = self.index.to_string();
        self.index += 1;
        self.probe.child(&name, value)
    }
}

macro_rules! nothing_to_check {
    ($($method:ident($kind:ty)),* $(,)?) => {
        $(fn $method(self, _: $kind) -> Result<(), EncodeError> { Ok(()) })*
    };
}

impl<'a> ser::Serializer for &'a mut Probe {
    type Ok = ();
    type Error = EncodeError;
    type SerializeSeq = Inside<'a>;
    type SerializeTuple = Inside<'a>;
    type SerializeTupleStruct = Inside<'a>;
    type SerializeTupleVariant = Inside<'a>;
    type SerializeMap = Inside<'a>;
    type SerializeStruct = Inside<'a>;
    type SerializeStructVariant = Inside<'a>;

    nothing_to_check!(
        serialize_bool(bool),
        serialize_i8(i8),
        serialize_i16(i16),
        serialize_i32(i32),
        serialize_i64(i64),
        serialize_u8(u8),
        serialize_u16(u16),
        serialize_u32(u32),
        serialize_u64(u64),
        serialize_char(char),
        serialize_str(&str),
        serialize_bytes(&[u8]),
        serialize_unit_struct(&'static str),
    );

    fn serialize_f32(self, value: f32) -> Result<(), EncodeError> {
        self.number(f64::from(value))
    }

    fn serialize_f64(self, value: f64) -> Result<(), EncodeError> {
        self.number(value)
    }

    fn serialize_none(self) -> Result<(), EncodeError> {
        Ok(())
    }

    fn serialize_unit(self) -> Result<(), EncodeError> {
        Ok(())
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<(), EncodeError> {
        value.serialize(self)
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Result<(), EncodeError> {
        Ok(())
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<(), EncodeError> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<(), EncodeError> {
        self.child(variant, value)
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Inside<'a>, EncodeError> {
        Ok(Inside { probe: self, index: 0, key: String::new() })
    }

    fn serialize_tuple(self, length: usize) -> Result<Inside<'a>, EncodeError> {
        self.serialize_seq(Some(length))
    }

    fn serialize_tuple_struct(self, _: &'static str, length: usize) -> Result<Inside<'a>, EncodeError> {
        self.serialize_seq(Some(length))
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        length: usize,
    ) -> Result<Inside<'a>, EncodeError> {
        self.serialize_seq(Some(length))
    }

    fn serialize_map(self, length: Option<usize>) -> Result<Inside<'a>, EncodeError> {
        self.serialize_seq(length)
    }

    fn serialize_struct(self, _: &'static str, length: usize) -> Result<Inside<'a>, EncodeError> {
        self.serialize_seq(Some(length))
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        length: usize,
    ) -> Result<Inside<'a>, EncodeError> {
        self.serialize_seq(Some(length))
    }
}

macro_rules! elements {
    ($($compound:ident::$method:ident),* $(,)?) => {$(
        impl ser::$compound for Inside<'_> {
            type Ok = ();
            type Error = EncodeError;

            fn $method<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), EncodeError> {
                self.element(value)
            }

            fn end(self) -> Result<(), EncodeError> {
                Ok(())
            }
        }
    )*};
}

elements!(
    SerializeSeq::serialize_element,
    SerializeTuple::serialize_element,
    SerializeTupleStruct::serialize_field,
    SerializeTupleVariant::serialize_field,
);

macro_rules! fields {
    ($($compound:ident),*) => {$(
        impl ser::$compound for Inside<'_> {
            type Ok = ();
            type Error = EncodeError;

            fn serialize_field<T: Serialize + ?Sized>(
                &mut self,
                name: &'static str,
                value: &T,
            ) -> Result<(), EncodeError> {
                self.probe.child(name, value)
            }

            fn end(self) -> Result<(), EncodeError> {
                Ok(())
            }
        }
    )*};
}

fields!(SerializeStruct, SerializeStructVariant);

impl ser::SerializeMap for Inside<'_> {
    type Ok = ();
    type Error = EncodeError;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), EncodeError> {
        let text = serde_json::to_string(key).map_err(|error| EncodeError::Json(error.to_string()))?;
        text.trim_matches('"').clone_into(&mut self.key);
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), EncodeError> {
        self.probe.child(&self.key, value)
    }

    fn end(self) -> Result<(), EncodeError> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[derive(Serialize)]
    struct Outer {
        fine: Option<f64>,
        list: Vec<Inner>,
    }

    #[derive(Serialize)]
    struct Inner {
        by_name: BTreeMap<String, [f64; 2]>,
    }

    fn outer(value: f64) -> Outer {
        let inner = |value| Inner { by_name: BTreeMap::from([("x".to_owned(), [1.0, value])]) };
        Outer { fine: None, list: vec![inner(2.0), inner(value)] }
    }

    #[test]
    fn finite_values_pass_unchanged() {
        let text = encode(&outer(3.0)).unwrap();
        assert_eq!(text, r#"{"fine":null,"list":[{"by_name":{"x":[1.0,2.0]}},{"by_name":{"x":[1.0,3.0]}}]}"#);
    }

    #[test]
    fn the_first_number_that_is_none_is_named() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let error = encode(&outer(bad)).unwrap_err();
            assert_eq!(error, EncodeError::NotFinite { pointer: "/list/1/by_name/x/1".to_owned() });
        }
        assert!(encode(&Some(f64::NAN)).is_err());
    }
}
