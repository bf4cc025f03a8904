//! The mesh fields of a step as arrays of numbers: a tenth of the size of their JSON, and read without parsing.
//!
//! ```text
//! offset          bytes   content
//! 0               8       "BRNFLD01"
//! 8               4       H, length of the header (u32); a multiple of 8
//! 12              4       zero
//! 16              H       header: JSON, padded with spaces
//! 16 + H                  data
//! ```
//!
//! Numbers are little-endian. The header lists the arrays of both bodies:
//!
//! ```json
//! {"arrays": [{"body": "upper", "name": "nodes", "type": "f32", "components": 2, "count": 812, "offset": 0}, …]}
//! ```
//!
//! `count` is the number of nodes or elements, `components` the numbers for each; they stand together. `offset` is counted
//! in bytes from the beginning of the data and is a multiple of 8. `type` is `f32` or `f64`, and `u32` for `elements`.
//! A rigid body has no arrays. Names, meanings and units are those of [`FieldsReport`].

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{FieldsReport, PerBody};

const MAGIC: &[u8; 8] = b"BRNFLD01";
/// Where the header begins.
const HEADER: usize = 16;
/// Boundary of the header's end and of every array \[bytes\].
const ALIGNMENT: usize = 8;
/// Numbers in one chunk of JSON.
const CHUNK: usize = 4096;

/// Why fields are not written or read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FieldArraysError {
    /// A number is NaN or infinite.
    #[error("/fields/{body}/{name}/{index} is not a finite number")]
    NotFinite {
        /// Which body.
        body: Side,
        /// Which array.
        name: String,
        /// Node at fault.
        index: usize,
    },
    /// The bytes are not what [`FieldArrays::encode`] writes.
    #[error("not an array of fields: {0}")]
    Malformed(String),
}

/// Which body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// The upper one.
    Upper,
    /// The lower one.
    Lower,
}

impl std::fmt::Display for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Upper => "upper",
            Self::Lower => "lower",
        })
    }
}

/// Type of the numbers of an array.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Number {
    F32,
    F64,
    U32,
}

impl Number {
    const fn bytes(self) -> usize {
        match self {
            Self::F32 | Self::U32 => 4,
            Self::F64 => 8,
        }
    }
}

/// One array, as the header lists it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
struct Array {
    body: Side,
    name: String,
    #[serde(rename = "type")]
    number: Number,
    components: usize,
    count: usize,
    offset: usize,
}

impl Array {
    const fn numbers(&self) -> usize {
        self.count * self.components
    }

    const fn bytes(&self) -> usize {
        self.numbers() * self.number.bytes()
    }
}

#[derive(Serialize, Deserialize)]
struct Header {
    arrays: Vec<Array>,
}

/// The fields of a step in their binary form, over bytes of any owner.
#[derive(Debug, Clone)]
pub struct FieldArrays<B> {
    bytes: B,
    arrays: Vec<Array>,
    /// Where the data begin.
    data: usize,
}

/// Writes arrays one after the other.
#[derive(Default)]
struct Encoder {
    arrays: Vec<Array>,
    data: Vec<u8>,
}

impl Encoder {
    fn array(&mut self, body: Side, name: &str, number: Number, components: usize, count: usize) {
        self.data.resize(self.data.len().next_multiple_of(ALIGNMENT), 0);
        let offset = self.data.len();
        self.arrays.push(Array { body, name: name.to_owned(), number, components, count, offset });
    }

    fn floats<const N: usize>(
        &mut self,
        body: Side,
        name: &str,
        values: &[[f64; N]],
    ) -> Result<(), FieldArraysError> {
        self.array(body, name, Number::F64, N, values.len());
        for (index, value) in values.iter().enumerate() {
            if !value.iter().all(|number| number.is_finite()) {
                return Err(FieldArraysError::NotFinite { body, name: name.to_owned(), index });
            }
            self.data.extend(value.iter().flat_map(|number| number.to_le_bytes()));
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Vec<u8>, FieldArraysError> {
        self.data.resize(self.data.len().next_multiple_of(ALIGNMENT), 0);
        let mut header = serde_json::to_vec(&Header { arrays: self.arrays }).map_err(malformed)?;
        header.resize(header.len().next_multiple_of(ALIGNMENT), b' ');
        let length = u32::try_from(header.len()).map_err(malformed)?;
        Ok([&MAGIC[..], &length.to_le_bytes(), &[0; 4], &header, &self.data].concat())
    }
}

#[expect(clippy::needless_pass_by_value, reason = "errors are mapped to it")]
fn malformed(what: impl ToString) -> FieldArraysError {
    FieldArraysError::Malformed(what.to_string())
}

fn scalars(values: &[f64]) -> &[[f64; 1]] {
    values.as_chunks().0
}

impl FieldArrays<Vec<u8>> {
    /// The fields of both bodies in double precision.
    ///
    /// # Errors
    /// [`FieldArraysError::NotFinite`].
    pub fn encode(fields: &PerBody<Option<FieldsReport>>) -> Result<Vec<u8>, FieldArraysError> {
        let mut encoder = Encoder::default();
        for (body, fields) in [(Side::Upper, &fields.upper), (Side::Lower, &fields.lower)] {
            let Some(fields) = fields else { continue };
            let FieldsReport {
                nodes,
                elements,
                displacement,
                sigma_x,
                sigma_y,
                sigma_z,
                tau_xy,
                von_mises,
                equivalent_plastic_strain,
            } = fields;
            encoder.floats(body, "nodes", nodes)?;
            encoder.array(body, "elements", Number::U32, 4, elements.len());
            encoder.data.extend(elements.iter().flatten().flat_map(|corner| corner.to_le_bytes()));
            encoder.floats(body, "displacement", displacement)?;
            for (name, values) in [
                ("sigma_x", sigma_x),
                ("sigma_y", sigma_y),
                ("sigma_z", sigma_z),
                ("tau_xy", tau_xy),
                ("von_mises", von_mises),
                ("equivalent_plastic_strain", equivalent_plastic_strain),
            ] {
                encoder.floats(body, name, scalars(values))?;
            }
        }
        encoder.finish()
    }
}

impl<B: AsRef<[u8]>> FieldArrays<B> {
    /// Reads the header of fields.
    ///
    /// # Errors
    /// [`FieldArraysError::Malformed`].
    pub fn read(bytes: B) -> Result<Self, FieldArraysError> {
        let all = bytes.as_ref();
        let length =
            all.get(..HEADER).filter(|head| head.starts_with(MAGIC)).and_then(|head| head.get(8..12));
        let length = length.and_then(|length| length.try_into().ok()).map(u32::from_le_bytes);
        let length = length.and_then(|length| usize::try_from(length).ok());
        let data = length.and_then(|length| HEADER.checked_add(length));
        let data = data.ok_or_else(|| malformed("no such beginning"))?;
        let header = all.get(HEADER..data).ok_or_else(|| malformed("the header is cut off"))?;
        let Header { arrays } = serde_json::from_slice(header).map_err(malformed)?;
        let available = all.len() - data;
        let fits = |array: &Array| {
            let numbers = array.count.checked_mul(array.components);
            let bytes = numbers.and_then(|numbers| numbers.checked_mul(array.number.bytes()));
            bytes.and_then(|bytes| bytes.checked_add(array.offset)).is_some_and(|end| end <= available)
        };
        if arrays.iter().all(fits) {
            Ok(Self { bytes, arrays, data })
        } else {
            Err(malformed("the data are cut off"))
        }
    }

    fn data(&self, array: &Array) -> &[u8] {
        let begin = self.data + array.offset;
        &self.bytes.as_ref()[begin..begin + array.bytes()]
    }

    /// The numbers `from..to` of an array.
    fn numbers(&self, array: &Array, range: std::ops::Range<usize>) -> impl Iterator<Item = f64> {
        let size = array.number.bytes();
        let number = array.number;
        self.data(array)[range.start * size..range.end * size].chunks_exact(size).map(move |bytes| {
            match number {
                Number::F32 => bytes.try_into().map_or(0.0, |bytes| f64::from(f32::from_le_bytes(bytes))),
                Number::F64 => bytes.try_into().map_or(0.0, f64::from_le_bytes),
                Number::U32 => bytes.try_into().map_or(0.0, |bytes| f64::from(u32::from_le_bytes(bytes))),
            }
        })
    }

    /// The same fields in single precision.
    ///
    /// # Errors
    /// [`FieldArraysError::Malformed`].
    pub fn single_precision(&self) -> Result<Vec<u8>, FieldArraysError> {
        let mut encoder = Encoder::default();
        for array in &self.arrays {
            let number = if array.number == Number::F64 { Number::F32 } else { array.number };
            encoder.array(array.body, &array.name, number, array.components, array.count);
            if array.number == Number::F64 {
                #[expect(
                    clippy::cast_possible_truncation,
                    reason = "to the nearest number of single precision"
                )]
                let singles = self.numbers(array, 0..array.numbers()).map(|number| number as f32);
                encoder.data.extend(singles.flat_map(f32::to_le_bytes));
            } else {
                encoder.data.extend_from_slice(self.data(array));
            }
        }
        encoder.finish()
    }

    /// The fields as the report has them.
    ///
    /// # Errors
    /// [`FieldArraysError::Malformed`].
    pub fn decode(&self) -> Result<PerBody<Option<FieldsReport>>, FieldArraysError> {
        Ok(PerBody { upper: self.body(Side::Upper)?, lower: self.body(Side::Lower)? })
    }

    fn body(&self, body: Side) -> Result<Option<FieldsReport>, FieldArraysError> {
        if self.arrays.iter().all(|array| array.body != body) {
            return Ok(None);
        }
        let elements = self.find(body, "elements", 4)?;
        let corners = self.data(elements).as_chunks::<4>().0.iter().map(|bytes| u32::from_le_bytes(*bytes));
        Ok(Some(FieldsReport {
            nodes: self.pairs(body, "nodes")?,
            elements: corners.collect::<Vec<_>>().as_chunks().0.to_vec(),
            displacement: self.pairs(body, "displacement")?,
            sigma_x: self.values(body, "sigma_x", 1)?,
            sigma_y: self.values(body, "sigma_y", 1)?,
            sigma_z: self.values(body, "sigma_z", 1)?,
            tau_xy: self.values(body, "tau_xy", 1)?,
            von_mises: self.values(body, "von_mises", 1)?,
            equivalent_plastic_strain: self.values(body, "equivalent_plastic_strain", 1)?,
        }))
    }

    fn find(&self, body: Side, name: &str, components: usize) -> Result<&Array, FieldArraysError> {
        let found = self.arrays.iter().find(|array| array.body == body && array.name == name);
        found.filter(|array| array.components == components).ok_or_else(|| malformed(format!("no {name}")))
    }

    fn values(&self, body: Side, name: &str, components: usize) -> Result<Vec<f64>, FieldArraysError> {
        let array = self.find(body, name, components)?;
        Ok(self.numbers(array, 0..array.numbers()).collect())
    }

    fn pairs(&self, body: Side, name: &str) -> Result<Vec<[f64; 2]>, FieldArraysError> {
        Ok(self.values(body, name, 2)?.as_chunks().0.to_vec())
    }

    /// The JSON of the fields in the report, in pieces of some tens of kilobytes.
    pub fn json(&self) -> impl Iterator<Item = Vec<u8>> {
        let mut pieces = Vec::new();
        for body in [Side::Upper, Side::Lower] {
            let mut arrays = self.arrays.iter().filter(|array| array.body == body).peekable();
            let before = if body == Side::Upper { "{" } else { "," };
            let none = if arrays.peek().is_none() { "null" } else { "{" };
            pieces.push(Piece::Text(format!("{before}\"{body}\":{none}")));
            let is_rigid = arrays.peek().is_none();
            for (k, array) in arrays.enumerate() {
                let comma = if k == 0 { "" } else { "," };
                pieces.push(Piece::Text(format!("{comma}\"{}\":[", array.name)));
                let step = CHUNK.next_multiple_of(array.components.max(1));
                let starts = (0..array.numbers()).step_by(step);
                pieces.extend(
                    starts.map(|from| Piece::Numbers(array, from, (from + step).min(array.numbers()))),
                );
                pieces.push(Piece::Text("]".to_owned()));
            }
            if !is_rigid {
                pieces.push(Piece::Text("}".to_owned()));
            }
        }
        pieces.push(Piece::Text("}".to_owned()));
        pieces.into_iter().map(|piece| self.piece(piece))
    }

    fn piece(&self, piece: Piece<'_>) -> Vec<u8> {
        let (array, from, to) = match piece {
            Piece::Text(text) => return text.into_bytes(),
            Piece::Numbers(array, from, to) => (array, from, to),
        };
        let mut text = Vec::with_capacity(20 * (to - from));
        for (k, number) in (from..to).zip(self.numbers(array, from..to)) {
            if k > 0 {
                text.push(b',');
            }
            let is_tuple = array.components > 1;
            if is_tuple && k % array.components == 0 {
                text.push(b'[');
            }
            // Writing to memory does not fail.
            let _ = match array.number {
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "it was an integer"
                )]
                Number::U32 => serde_json::to_writer(&mut text, &(number as u32)),
                Number::F32 | Number::F64 => serde_json::to_writer(&mut text, &number),
            };
            if is_tuple && (k + 1) % array.components == 0 {
                text.push(b']');
            }
        }
        text
    }
}

/// A piece of JSON that is still to be written.
enum Piece<'a> {
    Text(String),
    Numbers(&'a Array, usize, usize),
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fields() -> PerBody<Option<FieldsReport>> {
        let values = || (0..3).map(|k| 0.1 * f64::from(k)).collect::<Vec<_>>();
        PerBody {
            upper: Some(FieldsReport {
                nodes: vec![[0.0, 1.0], [0.1, -2.5e-7], [3.0, 4.0]],
                elements: vec![[0, 1, 2, 2]],
                displacement: vec![[0.0, 0.5], [1.0, 2.0], [1.0 / 3.0, 4.0]],
                sigma_x: values(),
                sigma_y: values(),
                sigma_z: values(),
                tau_xy: values(),
                von_mises: values(),
                equivalent_plastic_strain: values(),
            }),
            lower: None,
        }
    }

    #[test]
    fn fields_are_read_as_they_were_written() {
        let written = FieldArrays::encode(&fields()).unwrap();
        assert_eq!(FieldArrays::read(&written).unwrap().decode().unwrap(), fields());
    }

    #[test]
    fn the_json_is_that_of_the_report() {
        let mut many = fields();
        let upper = many.upper.as_mut().unwrap();
        upper.nodes = (0..5000).map(|k| [f64::from(k) / 7.0, 1e-9 * f64::from(k)]).collect();
        upper.von_mises = (0..9000).map(f64::from).collect();
        for fields in [fields(), many, PerBody { upper: None, lower: None }] {
            let written = FieldArrays::encode(&fields).unwrap();
            let json: Vec<u8> = FieldArrays::read(&written).unwrap().json().flatten().collect();
            assert_eq!(String::from_utf8(json).unwrap(), serde_json::to_string(&fields).unwrap());
        }
    }

    #[test]
    fn single_precision_is_half_as_long_and_aligned() {
        let written = FieldArrays::encode(&fields()).unwrap();
        let single = FieldArrays::read(&written).unwrap().single_precision().unwrap();
        let arrays = FieldArrays::read(&single).unwrap();
        assert!(arrays.arrays.iter().all(|array| (arrays.data + array.offset).is_multiple_of(ALIGNMENT)));
        let read = arrays.decode().unwrap().upper.unwrap();
        assert_eq!(read.elements, fields().upper.unwrap().elements);
        let third = read.displacement[2][0];
        let error = (3.0 * third - 1.0).abs();
        assert!(error > 1e-12 && error < 1e-7, "{third}");
    }

    #[test]
    fn numbers_that_are_none_are_not_written() {
        let mut spoilt = fields();
        spoilt.upper.as_mut().unwrap().sigma_y[1] = f64::NAN;
        let error = FieldArrays::encode(&spoilt).unwrap_err();
        assert_eq!(error.to_string(), "/fields/upper/sigma_y/1 is not a finite number");
    }

    #[test]
    fn damage_is_an_error() {
        let written = FieldArrays::encode(&fields()).unwrap();
        for length in [0, 4, 15, 40, written.len() - 8] {
            assert!(FieldArrays::read(&written[..length]).is_err(), "{length}");
        }
    }
}
