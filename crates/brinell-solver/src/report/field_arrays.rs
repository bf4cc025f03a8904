//! The mesh fields of a load step as binary arrays for storage: they need no parsing and are read
//! piece by piece.
//!
//! The bytes are the eight letters `BRNFLD01`, the length of a header (u32), four zeros, the
//! header in JSON, padded with spaces to a multiple of 8, and the arrays, each from a multiple of
//! 8 on. Numbers are little-endian. The header lists the arrays: body, name, type (`f64`, for
//! `elements` `u32`), how many there are (`count`), numbers of each (`components`), and `offset`
//! from the end of the header \[bytes\]. A rigid body has no arrays. Names, meanings and units are
//! the same as in [`FieldsReport`] or, in three dimensions, in [`LayersReport`].
//!
//! Only the store reads and writes these bytes: [`FieldLayout`] converts them to JSON and to the
//! files of an `.npz` archive.

use std::ops::Range;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{FieldsReport, LAYER_NAMES, LayersReport, PerBody, Side};

const MAGIC: &[u8; 8] = b"BRNFLD01";
/// Offset of the header \[bytes\].
const HEADER: usize = 16;
/// Alignment of the end of the header and of every array \[bytes\].
const ALIGNMENT: usize = 8;
/// Number of numbers in one piece.
pub(super) const CHUNK: usize = 4096;

/// Errors of writing and reading fields.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FieldArraysError {
    /// A number is NaN or infinite.
    #[error("/fields/{body}/{name}/{index} is not a finite number")]
    NotFinite {
        /// The body.
        body: Side,
        /// Name of the array.
        name: String,
        /// Index of the node.
        index: usize,
    },
    /// The bytes were not written by [`encode_fields`].
    #[error("not an array of fields: {0}")]
    Malformed(String),
}

/// Type of the numbers of an array.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Number {
    F64,
    U32,
}

impl Number {
    const fn bytes(self) -> usize {
        match self {
            Self::U32 => 4,
            Self::F64 => 8,
        }
    }

    /// Decodes numbers from bytes.
    fn read(self, bytes: &[u8]) -> impl Iterator<Item = f64> {
        bytes.chunks_exact(self.bytes()).map(move |bytes| match self {
            Self::F64 => bytes.try_into().map_or(0.0, f64::from_le_bytes),
            Self::U32 => {
                bytes.try_into().map_or(0.0, |bytes| f64::from(u32::from_le_bytes(bytes)))
            }
        })
    }
}

/// Entry of an array in the header.
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

/// Positions of the arrays in the bytes of a load step. Converts the arrays to other forms piece
/// by piece, so that no caller has to hold all of them in memory.
#[derive(Debug, Clone)]
pub struct FieldLayout {
    arrays: Vec<Array>,
    /// Offset of the data \[bytes\].
    data: usize,
}

/// A piece of the fields in another form.
#[derive(Debug, Clone)]
pub enum FieldPiece {
    /// Literal bytes.
    Text(Vec<u8>),
    /// Numbers that are converted from the bytes of the load step.
    Numbers(NumbersPiece),
}

/// Some numbers of an array and the form to which they are converted.
#[derive(Debug, Clone)]
pub struct NumbersPiece {
    /// Position of the numbers in the bytes of the load step.
    source: Range<usize>,
    number: Number,
    components: usize,
    /// Whether they are the first numbers of their array.
    is_first: bool,
    form: NumbersForm,
}

/// Forms of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum NumbersForm {
    /// Items of a JSON list, with a comma before each item except the first.
    Json,
    /// Floating-point numbers in single precision; integers unchanged.
    SinglePrecision,
}

/// Names of the arrays of a body, in the order of the bytes.
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

/// Writes arrays in sequence.
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

/// Encodes the fields of both bodies in double precision for [`FieldLayout`].
///
/// # Errors
/// [`FieldArraysError::NotFinite`].
pub fn encode_fields(fields: &PerBody<Option<FieldsReport>>) -> Result<Vec<u8>, FieldArraysError> {
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

/// Encodes the layers of both bodies in double precision for [`FieldLayout`].
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

impl FieldLayout {
    /// Reads the header from bytes that include at least the whole header.
    ///
    /// # Errors
    /// [`FieldArraysError::Malformed`].
    pub fn read(beginning: &[u8]) -> Result<Self, FieldArraysError> {
        let length = beginning
            .get(..HEADER)
            .filter(|head| head.starts_with(MAGIC))
            .and_then(|head| head.get(8..12));
        let length = length.and_then(|length| length.try_into().ok()).map(u32::from_le_bytes);
        let length = length.and_then(|length| usize::try_from(length).ok());
        let data = length.and_then(|length| HEADER.checked_add(length));
        let data = data.ok_or_else(|| malformed("no such beginning"))?;
        let header =
            beginning.get(HEADER..data).ok_or_else(|| malformed("the header is cut off"))?;
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

    /// Returns the end of the last array: the smallest valid number of bytes.
    pub fn end(&self) -> usize {
        self.arrays.iter().map(|array| self.source(array).end).max().unwrap_or(self.data)
    }

    /// Returns the member of the report of a load step that has the arrays: `fields` of a mesh, or
    /// `layers` of half-spaces.
    pub fn member(&self) -> &'static str {
        if self.arrays.iter().any(|array| array.name == "z_faces") { "layers" } else { "fields" }
    }

    /// Returns whether a body has arrays.
    pub(in crate::report) fn has(&self, body: Side) -> bool {
        self.arrays.iter().any(|array| array.body == body)
    }

    /// Returns the position of an array in the bytes.
    pub(in crate::report) fn find(
        &self,
        body: Side,
        name: &str,
    ) -> Result<Range<usize>, FieldArraysError> {
        let found = self.arrays.iter().find(|array| array.body == body && array.name == name);
        Ok(self.source(found.ok_or_else(|| malformed(format!("no {name}")))?))
    }

    fn source(&self, array: &Array) -> Range<usize> {
        let begin = self.data + array.offset;
        begin..begin + array.bytes()
    }

    /// Returns the numbers of an array in pieces of some tens of kilobytes.
    fn numbers(&self, array: &Array, form: NumbersForm) -> impl Iterator<Item = FieldPiece> {
        let (number, components, source) = (array.number, array.components, self.source(array));
        let step = CHUNK.next_multiple_of(components.max(1)) * number.bytes();
        let end = source.end;
        source.clone().step_by(step).map(move |from| {
            let (source, is_first) = (from..(from + step).min(end), from == source.start);
            FieldPiece::Numbers(NumbersPiece { source, number, components, is_first, form })
        })
    }

    /// Returns the arrays as JSON, in the form of their member of the report.
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

    /// Returns the arrays of these names, or all arrays, as the files of an `.npz` archive in
    /// single precision.
    pub fn npy(&self, names: Option<&[&str]>) -> Vec<NpyFile> {
        let is_wanted =
            |array: &&Array| names.is_none_or(|names| names.contains(&array.name.as_str()));
        let file = |array: &Array| NpyFile {
            name: format!("{}/{}.npy", array.body, array.name),
            header: npy_header(array.number, &self.shape(array)),
            numbers: self.numbers(array, NumbersForm::SinglePrecision).collect(),
        };
        self.arrays.iter().filter(is_wanted).map(file).collect()
    }

    /// Returns the shape of an array: nodes or elements with their components, or cells of
    /// half-spaces by layer, x and y.
    fn shape(&self, array: &Array) -> Vec<usize> {
        let along = |name| {
            self.arrays
                .iter()
                .find(|other| other.body == array.body && other.name == name)
                .map(|axis| axis.count)
        };
        match [along("z"), along("x"), along("y")] {
            [Some(z), Some(x), Some(y)] if z * x * y == array.count => vec![z, x, y],
            _ if array.components == 1 => vec![array.count],
            _ => vec![array.count, array.components],
        }
    }
}

/// A file of an `.npz` archive: one array.
#[derive(Debug, Clone)]
pub struct NpyFile {
    /// Name in the archive, for example `lower/von_mises.npy`.
    pub name: String,
    /// Bytes before the numbers.
    pub header: Vec<u8>,
    /// The numbers.
    pub numbers: Vec<FieldPiece>,
}

/// Returns the header of an `.npy` file: type and shape of the array in a Python dictionary,
/// padded to 64 bytes (version 1.0 of the format,
/// <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>).
fn npy_header(number: Number, shape: &[usize]) -> Vec<u8> {
    const BEGINNING: usize = 10;
    let number = if number == Number::U32 { "<u4" } else { "<f4" };
    let shape = shape.iter().map(|length| format!("{length},")).collect::<Vec<_>>().join(" ");
    let text = format!("{{'descr': '{number}', 'fortran_order': False, 'shape': ({shape}), }}");
    let length = (BEGINNING + text.len() + 1).next_multiple_of(64) - BEGINNING;
    let size = u16::try_from(length).unwrap_or(u16::MAX).to_le_bytes();
    let text = format!("{text:<width$}\n", width = length - 1);
    [b"\x93NUMPY\x01\x00", &size[..], text.as_bytes()].concat()
}

impl FieldPiece {
    /// Returns the position of the source numbers in the bytes of the load step; empty for text.
    pub fn source(&self) -> Range<usize> {
        match self {
            Self::Text(_) => 0..0,
            Self::Numbers(piece) => piece.source.clone(),
        }
    }

    /// Converts the bytes at the source of the piece.
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
            // A write to memory does not fail.
            let _ = match self.number {
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "it was an integer"
                )]
                Number::U32 => serde_json::to_writer(&mut text, &(number as u32)),
                Number::F64 => serde_json::to_writer(&mut text, &number),
            };
            if is_tuple && (k + 1) % self.components == 0 {
                text.push(b']');
            }
        }
        text
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

    /// Returns the bytes of pieces in sequence.
    fn written(bytes: &[u8], pieces: Vec<FieldPiece>) -> Vec<u8> {
        pieces.into_iter().flat_map(|piece| piece.clone().write(&bytes[piece.source()])).collect()
    }

    #[test]
    fn the_json_is_that_of_the_report() {
        let mut many = fields();
        let upper = many.upper.as_mut().unwrap();
        upper.nodes = (0..5000).map(|k| [f64::from(k) / 7.0, 1e-9 * f64::from(k)]).collect();
        upper.von_mises = (0..9000).map(f64::from).collect();
        for fields in [fields(), many, PerBody { upper: None, lower: None }] {
            let bytes = encode_fields(&fields).unwrap();
            let layout = FieldLayout::read(&bytes).unwrap();
            assert!(layout.end() <= bytes.len());
            let json = written(&bytes, layout.json());
            assert_eq!(String::from_utf8(json).unwrap(), serde_json::to_string(&fields).unwrap());
        }
    }

    #[test]
    fn layers_are_written_like_the_report_and_have_the_shape_of_their_grid() {
        let values = |name| if name == "z" { vec![0.5, -2.0] } else { vec![1e-7] };
        let mut body: serde_json::Map<_, _> =
            LAYER_NAMES.into_iter().map(|name| (name.to_owned(), values(name).into())).collect();
        body.insert("x".to_owned(), vec![1.0, 2.0, 3.0].into());
        body.insert("sigma_xx".to_owned(), vec![0.0; 6].into());
        let lower: LayersReport = serde_json::from_value(body.into()).unwrap();
        let layers = PerBody { upper: None, lower: Some(lower) };
        let bytes = encode_layers(&layers).unwrap();
        let layout = FieldLayout::read(&bytes).unwrap();
        assert_eq!(layout.member(), "layers");
        let json = written(&bytes, layout.json());
        assert_eq!(String::from_utf8(json).unwrap(), serde_json::to_string(&layers).unwrap());
        let stress = layout.npy(Some(&["sigma_xx"])).remove(0);
        assert!(String::from_utf8_lossy(&stress.header).contains("'shape': (2, 3, 1,)"));
    }

    #[test]
    fn a_file_of_an_archive_has_type_shape_and_numbers() {
        let bytes = encode_fields(&fields()).unwrap();
        let files = FieldLayout::read(&bytes).unwrap().npy(Some(&["displacement", "elements"]));
        let shown = files.into_iter().map(|NpyFile { name, header, numbers }| {
            assert_eq!(header.len() % 64, 0);
            let text = String::from_utf8_lossy(&header[10..]).trim().to_owned();
            (name, text, written(&bytes, numbers))
        });
        let elements: Vec<u8> = [0_u32, 1, 2, 2].into_iter().flat_map(u32::to_le_bytes).collect();
        let numbers = [0.0, 0.5, 1.0, 2.0, 1.0 / 3.0, 4.0_f32];
        let displacement = numbers.into_iter().flat_map(f32::to_le_bytes).collect();
        let about = |kind, shape| {
            format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}")
        };
        let expected = [
            ("upper/elements.npy".to_owned(), about("<u4", "(1, 4,)"), elements),
            ("upper/displacement.npy".to_owned(), about("<f4", "(3, 2,)"), displacement),
        ];
        assert_eq!(shown.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn arrays_have_the_names_that_can_be_asked_for() {
        let layout = FieldLayout::read(&encode_fields(&fields()).unwrap()).unwrap();
        assert_eq!(
            layout.arrays.iter().map(|array| &*array.name).collect::<Vec<_>>(),
            FIELD_NAMES
        );
        let names: Vec<_> = layout.npy(None).into_iter().map(|file| file.name).collect();
        assert_eq!(names, FIELD_NAMES.map(|name| format!("upper/{name}.npy")));
    }

    #[test]
    fn numbers_that_are_not_finite_are_refused() {
        let mut spoilt = fields();
        spoilt.upper.as_mut().unwrap().sigma_y[1] = f64::NAN;
        let error = encode_fields(&spoilt).unwrap_err();
        assert_eq!(error.to_string(), "/fields/upper/sigma_y/1 is not a finite number");
    }

    #[test]
    fn a_damaged_header_is_an_error() {
        let bytes = encode_fields(&fields()).unwrap();
        for length in [0, 4, 15, 40] {
            assert!(FieldLayout::read(&bytes[..length]).is_err(), "{length}");
        }
    }
}
