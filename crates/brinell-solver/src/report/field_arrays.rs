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
//! A rigid body has no arrays. Names, meanings and units are those of [`FieldsReport`] or, in three dimensions, of [`LayersReport`].

use std::ops::Range;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{FieldsReport, LAYER_NAMES, LayersReport, PerBody};

const MAGIC: &[u8; 8] = b"BRNFLD01";
/// Where the header begins.
const HEADER: usize = 16;
/// Boundary of the header's end and of every array \[bytes\].
const ALIGNMENT: usize = 8;
/// Numbers in one piece of another form.
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

    /// The numbers that bytes stand for.
    fn read(self, bytes: &[u8]) -> impl Iterator<Item = f64> {
        bytes.chunks_exact(self.bytes()).map(move |bytes| match self {
            Self::F32 => bytes.try_into().map_or(0.0, |bytes| f64::from(f32::from_le_bytes(bytes))),
            Self::F64 => bytes.try_into().map_or(0.0, f64::from_le_bytes),
            Self::U32 => bytes.try_into().map_or(0.0, |bytes| f64::from(u32::from_le_bytes(bytes))),
        })
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

/// Where the arrays of a step stand in its bytes, and how they become other forms piece by piece: nobody has to hold all of them.
#[derive(Debug, Clone)]
pub struct FieldLayout {
    arrays: Vec<Array>,
    /// Where the data begin.
    data: usize,
}

/// A piece of another form of the fields.
#[derive(Debug, Clone)]
pub enum FieldPiece {
    /// These bytes.
    Text(Vec<u8>),
    /// What becomes of some of the numbers.
    Numbers(NumbersPiece),
}

/// Numbers of an array, and what they become.
#[derive(Debug, Clone)]
pub struct NumbersPiece {
    /// Where they stand in the bytes of the step.
    source: Range<usize>,
    number: Number,
    components: usize,
    /// They are the first of their array.
    is_first: bool,
    form: NumbersForm,
}

/// What numbers become.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum NumbersForm {
    /// Items of a list, with commas before all but the first.
    Json,
    /// Floating-point numbers in single precision, others as they are.
    SinglePrecision,
}

/// The fields of a step in their binary form, over bytes of any owner.
#[derive(Debug, Clone)]
pub struct FieldArrays<B> {
    bytes: B,
    layout: FieldLayout,
}

/// The names of the arrays of a body, in their order.
pub const FIELD_NAMES: [&str; 9] = [
    "nodes",
    "elements",
    "displacement",
    "sigma_x",
    "sigma_y",
    "sigma_z",
    "tau_xy",
    "von_mises",
    "equivalent_plastic_strain",
];

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
        Ok([beginning(self.arrays)?, self.data].concat())
    }
}

/// Everything before the data.
fn beginning(arrays: Vec<Array>) -> Result<Vec<u8>, FieldArraysError> {
    let mut header = serde_json::to_vec(&Header { arrays }).map_err(malformed)?;
    header.resize(header.len().next_multiple_of(ALIGNMENT), b' ');
    let length = u32::try_from(header.len()).map_err(malformed)?;
    Ok([&MAGIC[..], &length.to_le_bytes(), &[0; 4], &header].concat())
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

    /// The layers of both bodies in double precision.
    ///
    /// # Errors
    /// [`FieldArraysError::NotFinite`].
    pub fn encode_layers(layers: &PerBody<Option<LayersReport>>) -> Result<Vec<u8>, FieldArraysError> {
        let mut encoder = Encoder::default();
        for (body, layers) in [(Side::Upper, &layers.upper), (Side::Lower, &layers.lower)] {
            let Some(layers) = layers else { continue };
            for (name, values) in LAYER_NAMES.into_iter().zip(layers.arrays()) {
                encoder.floats(body, name, scalars(values))?;
            }
        }
        encoder.finish()
    }
}

impl FieldLayout {
    /// Reads the header, of bytes that have at least that.
    ///
    /// # Errors
    /// [`FieldArraysError::Malformed`].
    pub fn read(beginning: &[u8]) -> Result<Self, FieldArraysError> {
        let length =
            beginning.get(..HEADER).filter(|head| head.starts_with(MAGIC)).and_then(|head| head.get(8..12));
        let length = length.and_then(|length| length.try_into().ok()).map(u32::from_le_bytes);
        let length = length.and_then(|length| usize::try_from(length).ok());
        let data = length.and_then(|length| HEADER.checked_add(length));
        let data = data.ok_or_else(|| malformed("no such beginning"))?;
        let header = beginning.get(HEADER..data).ok_or_else(|| malformed("the header is cut off"))?;
        let Header { arrays } = serde_json::from_slice(header).map_err(malformed)?;
        let has_end = |array: &Array| {
            let numbers = array.count.checked_mul(array.components);
            let bytes = numbers.and_then(|numbers| numbers.checked_mul(array.number.bytes()));
            let end = bytes.and_then(|bytes| bytes.checked_add(array.offset));
            end.and_then(|end| end.checked_add(data)).is_some()
        };
        if arrays.iter().all(has_end) {
            Ok(Self { arrays, data })
        } else {
            Err(malformed("an array without end"))
        }
    }

    /// Bytes that the step has at least: up to the end of its last array.
    pub fn end(&self) -> usize {
        self.arrays.iter().map(|array| self.source(array).end).max().unwrap_or(self.data)
    }

    /// The member of a step that the arrays are: `fields` of a mesh, or `layers` of half-spaces.
    pub fn member(&self) -> &'static str {
        if self.arrays.iter().any(|array| array.name == "z_faces") { "layers" } else { "fields" }
    }

    /// Whether a body has arrays.
    pub(in crate::report) fn has(&self, body: Side) -> bool {
        self.arrays.iter().any(|array| array.body == body)
    }

    /// Where an array stands.
    pub(in crate::report) fn find(&self, body: Side, name: &str) -> Result<Range<usize>, FieldArraysError> {
        let found = self.arrays.iter().find(|array| array.body == body && array.name == name);
        Ok(self.source(found.ok_or_else(|| malformed(format!("no {name}")))?))
    }

    fn source(&self, array: &Array) -> Range<usize> {
        let begin = self.data + array.offset;
        begin..begin + array.bytes()
    }

    /// The numbers of an array in pieces of some tens of kilobytes.
    fn numbers(&self, array: &Array, form: NumbersForm) -> impl Iterator<Item = FieldPiece> {
        let (number, components, source) = (array.number, array.components, self.source(array));
        let step = CHUNK.next_multiple_of(components.max(1)) * number.bytes();
        let end = source.end;
        source.clone().step_by(step).map(move |from| {
            let (source, is_first) = (from..(from + step).min(end), from == source.start);
            FieldPiece::Numbers(NumbersPiece { source, number, components, is_first, form })
        })
    }

    /// The JSON of the member of the report that they are.
    pub fn json(&self) -> Vec<FieldPiece> {
        let mut pieces = Vec::new();
        let text = |text: String| FieldPiece::Text(text.into_bytes());
        for body in [Side::Upper, Side::Lower] {
            let mut arrays = self.arrays.iter().filter(|array| array.body == body).peekable();
            let is_rigid = arrays.peek().is_none();
            let before = if body == Side::Upper { "{" } else { "," };
            let begin = if is_rigid { "null" } else { "{" };
            pieces.push(text(format!("{before}\"{body}\":{begin}")));
            for (k, array) in arrays.enumerate() {
                let comma = if k == 0 { "" } else { "," };
                pieces.push(text(format!("{comma}\"{}\":[", array.name)));
                pieces.extend(self.numbers(array, NumbersForm::Json));
                pieces.push(text("]".to_owned()));
            }
            if !is_rigid {
                pieces.push(text("}".to_owned()));
            }
        }
        pieces.push(text("}".to_owned()));
        pieces
    }

    /// The same fields in single precision: the arrays of these names, or all of them.
    ///
    /// # Errors
    /// [`FieldArraysError::Malformed`].
    pub fn single_precision(&self, names: Option<&[&str]>) -> Result<Vec<FieldPiece>, FieldArraysError> {
        let (mut singles, mut pieces, mut end): (Vec<Array>, _, usize) = (Vec::new(), Vec::new(), 0);
        let pad = |end: usize| FieldPiece::Text(vec![0; end.next_multiple_of(ALIGNMENT) - end]);
        let is_wanted = |array: &&Array| names.is_none_or(|names| names.contains(&array.name.as_str()));
        for array in self.arrays.iter().filter(is_wanted) {
            pieces.push(pad(end));
            let number = if array.number == Number::F64 { Number::F32 } else { array.number };
            let single = Array { number, offset: end.next_multiple_of(ALIGNMENT), ..array.clone() };
            end = single.offset + single.bytes();
            pieces.extend(self.numbers(array, NumbersForm::SinglePrecision));
            singles.push(single);
        }
        pieces.push(pad(end));
        pieces.insert(0, FieldPiece::Text(beginning(singles)?));
        Ok(pieces)
    }
}

impl FieldPiece {
    /// Where the numbers stand that it is made of.
    pub fn source(&self) -> Range<usize> {
        match self {
            Self::Text(_) => 0..0,
            Self::Numbers(piece) => piece.source.clone(),
        }
    }

    /// Its length \[bytes\], if that does not depend on the numbers.
    pub fn length(&self) -> Option<usize> {
        match self {
            Self::Text(text) => Some(text.len()),
            Self::Numbers(NumbersPiece { form: NumbersForm::Json, .. }) => None,
            Self::Numbers(piece) if piece.number == Number::F64 => Some(piece.source.len() / 2),
            Self::Numbers(piece) => Some(piece.source.len()),
        }
    }

    /// Makes it of the bytes at its source.
    pub fn write(self, source: &[u8]) -> Vec<u8> {
        match self {
            Self::Text(text) => text,
            Self::Numbers(piece) if piece.form == NumbersForm::Json => piece.json(source),
            Self::Numbers(piece) if piece.number == Number::F64 => {
                #[expect(
                    clippy::cast_possible_truncation,
                    reason = "to the nearest number of single precision"
                )]
                let singles = piece.number.read(source).map(|number| number as f32);
                singles.flat_map(f32::to_le_bytes).collect()
            }
            Self::Numbers(_) => source.to_vec(),
        }
    }
}

impl NumbersPiece {
    fn json(&self, source: &[u8]) -> Vec<u8> {
        let mut text = Vec::with_capacity(20 * source.len() / self.number.bytes());
        for (k, number) in self.number.read(source).enumerate() {
            if k > 0 || !self.is_first {
                text.push(b',');
            }
            let is_tuple = self.components > 1;
            if is_tuple && k % self.components == 0 {
                text.push(b'[');
            }
            // Writing to memory does not fail.
            let _ = match self.number {
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "it was an integer"
                )]
                Number::U32 => serde_json::to_writer(&mut text, &(number as u32)),
                Number::F32 | Number::F64 => serde_json::to_writer(&mut text, &number),
            };
            if is_tuple && (k + 1) % self.components == 0 {
                text.push(b']');
            }
        }
        text
    }
}

impl<B: AsRef<[u8]>> FieldArrays<B> {
    /// Reads what [`FieldArrays::encode`] or [`FieldLayout::single_precision`] has written.
    ///
    /// # Errors
    /// [`FieldArraysError::Malformed`].
    pub fn read(bytes: B) -> Result<Self, FieldArraysError> {
        let layout = FieldLayout::read(bytes.as_ref())?;
        if layout.end() <= bytes.as_ref().len() {
            Ok(Self { bytes, layout })
        } else {
            Err(malformed("the data are cut off"))
        }
    }

    fn data(&self, array: &Array) -> &[u8] {
        &self.bytes.as_ref()[self.layout.source(array)]
    }

    /// The fields as the report has them.
    ///
    /// # Errors
    /// [`FieldArraysError::Malformed`].
    pub fn decode(&self) -> Result<PerBody<Option<FieldsReport>>, FieldArraysError> {
        Ok(PerBody { upper: self.body(Side::Upper)?, lower: self.body(Side::Lower)? })
    }

    fn body(&self, body: Side) -> Result<Option<FieldsReport>, FieldArraysError> {
        if self.layout.arrays.iter().all(|array| array.body != body) {
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
        let found = self.layout.arrays.iter().find(|array| array.body == body && array.name == name);
        found.filter(|array| array.components == components).ok_or_else(|| malformed(format!("no {name}")))
    }

    fn values(&self, body: Side, name: &str, components: usize) -> Result<Vec<f64>, FieldArraysError> {
        let array = self.find(body, name, components)?;
        Ok(array.number.read(self.data(array)).collect())
    }

    fn pairs(&self, body: Side, name: &str) -> Result<Vec<[f64; 2]>, FieldArraysError> {
        Ok(self.values(body, name, 2)?.as_chunks().0.to_vec())
    }
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
    fn layers_are_written_like_the_report() {
        let names = LAYER_NAMES.map(|name| (name.to_owned(), serde_json::json!([0.5, -2.0, 1e-7])));
        let body = serde_json::Value::Object(names.into_iter().collect());
        let lower: LayersReport = serde_json::from_value(body).unwrap();
        let layers = PerBody { upper: None, lower: Some(lower) };
        let written = FieldArrays::encode_layers(&layers).unwrap();
        let layout = FieldLayout::read(&written).unwrap();
        assert_eq!(layout.member(), "layers");
        assert_eq!(layout.arrays.iter().map(|array| &*array.name).collect::<Vec<_>>(), LAYER_NAMES);
        let json = made(&written, layout.json());
        assert_eq!(String::from_utf8(json).unwrap(), serde_json::to_string(&layers).unwrap());
    }

    /// What pieces are together.
    fn made(bytes: &[u8], pieces: Vec<FieldPiece>) -> Vec<u8> {
        pieces.into_iter().flat_map(|piece| piece.clone().write(&bytes[piece.source()])).collect()
    }

    #[test]
    fn the_json_is_that_of_the_report() {
        let mut many = fields();
        let upper = many.upper.as_mut().unwrap();
        upper.nodes = (0..5000).map(|k| [f64::from(k) / 7.0, 1e-9 * f64::from(k)]).collect();
        upper.von_mises = (0..9000).map(f64::from).collect();
        for fields in [fields(), many, PerBody { upper: None, lower: None }] {
            let written = FieldArrays::encode(&fields).unwrap();
            let json = made(&written, FieldLayout::read(&written).unwrap().json());
            assert_eq!(String::from_utf8(json).unwrap(), serde_json::to_string(&fields).unwrap());
        }
    }

    #[test]
    fn single_precision_is_half_as_long_and_aligned() {
        let written = FieldArrays::encode(&fields()).unwrap();
        let pieces = FieldLayout::read(&written).unwrap().single_precision(None).unwrap();
        let length: Option<usize> = pieces.iter().map(FieldPiece::length).sum();
        let single = made(&written, pieces);
        assert_eq!(length, Some(single.len()));
        let arrays = FieldArrays::read(&single).unwrap();
        let FieldLayout { data, arrays: listed } = &arrays.layout;
        assert!(listed.iter().all(|array| (data + array.offset).is_multiple_of(ALIGNMENT)));
        let read = arrays.decode().unwrap().upper.unwrap();
        assert_eq!(read.elements, fields().upper.unwrap().elements);
        let third = read.displacement[2][0];
        let error = (3.0 * third - 1.0).abs();
        assert!(error > 1e-12 && error < 1e-7, "{third}");
    }

    #[test]
    fn arrays_are_chosen_by_their_names() {
        let written = FieldArrays::encode(&fields()).unwrap();
        let layout = FieldLayout::read(&written).unwrap();
        assert_eq!(layout.arrays.iter().map(|array| &*array.name).collect::<Vec<_>>(), FIELD_NAMES);
        let all = FieldArrays::read(made(&written, layout.single_precision(None).unwrap())).unwrap();
        for names in [&["von_mises", "elements"][..], &["nodes"], &[]] {
            let some = made(&written, layout.single_precision(Some(names)).unwrap());
            let some = FieldArrays::read(some).unwrap();
            assert_eq!(some.layout.arrays.len(), names.len());
            for array in &some.layout.arrays {
                assert!(names.contains(&array.name.as_str()));
                let same = all.find(array.body, &array.name, array.components).unwrap();
                assert_eq!(some.data(array), all.data(same));
            }
        }
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
