//! Writer of VTK files in XML, for programs like ParaView: one piece of one grid with its arrays
//! inline. A file is written piece by piece, so that neither the file nor the fields have to be in
//! memory as a whole.
//!
//! ```text
//! base64:  a 64-bit count of bytes, little-endian values after it, both in one text
//! ascii:   values, a space after each
//! ```
//!
//! # Reference
//! *VTK XML file formats*, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>.

use std::collections::BTreeMap;
use std::fmt::{Display, Write as _};
use std::ops::Range;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::ExportError;
use crate::report::{FieldArraysError, FieldLayout, Report, Side};

/// Number of the quadrilateral with 4 nodes in VTK.
pub(super) const QUAD: u8 = 9;

const TENSOR: &str = "NumberOfComponents=\"6\" ComponentName0=\"XX\" ComponentName1=\"YY\" \
                      ComponentName2=\"ZZ\" ComponentName3=\"XY\" ComponentName4=\"YZ\" \
                      ComponentName5=\"XZ\"";

/// The contents of a file.
pub trait VtkContents: Sized + 'static {
    /// Some values of an array.
    type Block: Clone + Send + Sync;

    /// The type of its grid.
    const GRID: &'static str;
    /// The form of all values.
    const ENCODING: Encoding;
    /// Arrays in the order of the file. Neighbours of one group stand in one element.
    const ARRAYS: &'static [Array<Self>];

    /// Returns the attributes of the grid and of its piece, once the survey is done.
    fn size(&self) -> [String; 2];

    /// Returns the blocks that are read before the file begins, with the positions of their
    /// sources in the bytes of the load step.
    fn survey(&self) -> Vec<(Self::Block, Vec<Range<usize>>)> {
        Vec::new()
    }

    /// Reads a block of the survey.
    fn read(&mut self, _block: &Self::Block, _from: Sources) {}

    /// Returns the blocks of an array in order, with the positions of their sources.
    fn blocks(&self, array: &Array<Self>) -> Vec<(Self::Block, Vec<Range<usize>>)>;
}

/// Forms of values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// Decimal numbers.
    Ascii,
    /// Base64 of the bytes.
    Base64,
}

/// Types of values.
#[derive(Debug, Clone, Copy)]
pub enum Type {
    Float64,
    Int64,
    UInt8,
}

/// Writes a block.
type Write<C> = fn(&C, &<C as VtkContents>::Block, Sources, &mut Values);

/// An array: its group with attributes, type, name and number of components, how many values it
/// has of each, the names of its sources, and the function that writes a block.
pub struct Array<C: VtkContents>(
    pub(super) &'static str,
    pub(super) Type,
    pub(super) &'static str,
    pub(super) usize,
    pub(super) fn(&C) -> usize,
    pub(super) &'static [&'static str],
    pub(super) Write<C>,
);

impl<C: VtkContents> Array<C> {
    fn element(&self) -> &'static str {
        self.0.split(' ').next().unwrap_or_default()
    }
}

/// Bytes of the source arrays of a block.
#[derive(Debug, Clone, Copy)]
pub struct Sources<'a>(pub(super) &'a [&'a [u8]]);

impl Sources<'_> {
    pub(super) fn float(self, source: usize, at: usize) -> f64 {
        let bytes = self.0.get(source).and_then(|bytes| bytes.as_chunks().0.get(at));
        bytes.map_or(0.0, |bytes| f64::from_le_bytes(*bytes))
    }

    pub(super) fn floats(self, source: usize) -> Vec<f64> {
        let bytes = self.0.get(source).map_or(&[][..], |bytes| bytes.as_chunks().0);
        bytes.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect()
    }
}

/// Positions of the source arrays of a body in the bytes of the load step, by name.
pub(super) type Places = BTreeMap<&'static str, Range<usize>>;

/// Finds the source arrays of a body.
pub(super) fn places<C: VtkContents>(
    layout: &FieldLayout,
    side: Side,
) -> Result<Places, ExportError> {
    let names = C::ARRAYS.iter().flat_map(|array| array.5);
    names.map(|name| Ok((*name, layout.find(side, name).map_err(unusable)?))).collect()
}

/// Values on their way into a file.
#[derive(Debug)]
pub struct Values {
    encoding: Encoding,
    /// Bytes that are not yet encoded, because base64 encodes groups of three bytes.
    pub(super) pending: Vec<u8>,
    text: String,
}

impl Values {
    pub(super) const fn new(encoding: Encoding) -> Self {
        Self { encoding, pending: Vec::new(), text: String::new() }
    }

    fn add(&mut self, value: impl Display, bytes: &[u8]) {
        match self.encoding {
            Encoding::Ascii => drop(write!(self.text, "{value} ")),
            Encoding::Base64 => self.pending.extend(bytes),
        }
    }

    pub(super) fn floats(&mut self, values: impl IntoIterator<Item = f64>) {
        values.into_iter().for_each(|value| self.add(value, &value.to_le_bytes()));
    }

    pub(super) fn integers(&mut self, values: impl IntoIterator<Item = usize>) {
        values.into_iter().for_each(|value| self.add(value, &(value as u64).to_le_bytes()));
    }

    /// Appends one small integer `count` times.
    pub(super) fn repeated(&mut self, value: u8, count: usize) {
        (0..count).for_each(|_| self.add(value, &[value]));
    }

    /// Encodes whole groups of bytes, or all.
    fn encode(&mut self, all: bool) {
        let end = if all { self.pending.len() } else { self.pending.len() / 3 * 3 };
        STANDARD.encode_string(&self.pending[..end], &mut self.text);
        self.pending.drain(..end);
    }
}

/// A piece of a file. Pieces are written in order.
#[derive(Debug, Clone)]
pub struct VtkPiece<B> {
    part: PieceKind<B>,
    sources: Vec<Range<usize>>,
}

#[derive(Debug, Clone)]
enum PieceKind<B> {
    Survey(B),
    Head,
    /// The beginning of one of the arrays.
    Begin(usize),
    Block(usize, B),
    End,
    Foot,
}

impl<B> VtkPiece<B> {
    /// Returns the positions of its source numbers in the bytes of the load step.
    pub fn sources(&self) -> &[Range<usize>] {
        &self.sources
    }
}

/// State of a file between its pieces.
pub struct VtkFile<C> {
    title: String,
    contents: C,
    values: Values,
}

impl<C: VtkContents> VtkFile<C> {
    /// Returns the file of the load step `step`, counted from 0 and out of `steps`.
    pub(super) fn of(report: &Report, [step, steps]: [usize; 2], contents: C) -> Self {
        let Report { version, analysis, units, .. } = report;
        let step = step + 1;
        let title =
            format!("brinell {version}, {analysis}, units {units}, step {step} of {steps}");
        Self { title, contents, values: Values::new(C::ENCODING) }
    }

    /// Returns all pieces of the file in order.
    pub fn pieces(&self) -> Vec<VtkPiece<C::Block>> {
        let text = |part| VtkPiece { part, sources: Vec::new() };
        let survey = self.contents.survey().into_iter();
        let read = |(block, sources)| VtkPiece { part: PieceKind::Survey(block), sources };
        let mut pieces: Vec<_> = survey.map(read).chain([text(PieceKind::Head)]).collect();
        for (k, array) in C::ARRAYS.iter().enumerate() {
            let write = |(block, sources)| VtkPiece { part: PieceKind::Block(k, block), sources };
            pieces.push(text(PieceKind::Begin(k)));
            pieces.extend(self.contents.blocks(array).into_iter().map(write));
            pieces.push(text(PieceKind::End));
        }
        pieces.push(text(PieceKind::Foot));
        pieces
    }

    /// Writes a piece from the bytes at its sources.
    pub fn write(&mut self, piece: &VtkPiece<C::Block>, sources: &[impl AsRef<[u8]>]) -> String {
        let sources: Vec<&[u8]> = sources.iter().map(AsRef::as_ref).collect();
        match &piece.part {
            PieceKind::Survey(block) => self.contents.read(block, Sources(&sources)),
            PieceKind::Head => self.head(),
            PieceKind::Begin(array) => self.begin(*array),
            PieceKind::Block(array, block) => {
                C::ARRAYS[*array].6(&self.contents, block, Sources(&sources), &mut self.values);
                self.values.encode(false);
            }
            PieceKind::End => {
                self.values.encode(true);
                self.values.text.push_str("</DataArray>\n");
            }
            PieceKind::Foot => {
                let (last, grid) = (C::ARRAYS.last().map_or("", Array::element), C::GRID);
                let text = &mut self.values.text;
                let _ = write!(text, "</{last}>\n</Piece>\n</{grid}>\n</VTKFile>\n");
            }
        }
        std::mem::take(&mut self.values.text)
    }

    /// Writes the whole file from the bytes of the load step.
    pub fn whole(mut self, bytes: &[u8]) -> String {
        let written = self.pieces().into_iter().map(|piece| {
            let sources: Vec<&[u8]> =
                piece.sources.iter().map(|source| &bytes[source.clone()]).collect();
            self.write(&piece, &sources)
        });
        written.collect()
    }

    fn head(&mut self) {
        let (title, grid, [of_grid, of_piece]) = (&self.title, C::GRID, self.contents.size());
        let header = match C::ENCODING {
            Encoding::Ascii => "",
            Encoding::Base64 => " header_type=\"UInt64\"",
        };
        let _ = write!(
            self.values.text,
            "<?xml version=\"1.0\"?>\n<!-- {title} -->\n\
             <VTKFile type=\"{grid}\" version=\"1.0\" byte_order=\"LittleEndian\"{header}>\n\
             <{grid}{of_grid}>\n<Piece {of_piece}>\n"
        );
    }

    fn begin(&mut self, number: usize) {
        let array = &C::ARRAYS[number];
        let Array(group, kind, name, components, count, ..) = array;
        let before = number.checked_sub(1).map(|before| &C::ARRAYS[before]);
        let text = &mut self.values.text;
        if before.is_none_or(|before| before.0 != *group) {
            let closed = before.map(|before| format!("</{}>\n", before.element()));
            let _ = writeln!(text, "{}<{group}>", closed.unwrap_or_default());
        }
        let (attributes, format) = match (C::ENCODING, components) {
            (Encoding::Base64, 1) => (String::new(), "binary"),
            (Encoding::Base64, 6) => (TENSOR.to_owned(), "binary"),
            (Encoding::Base64, n) => (format!("NumberOfComponents=\"{n}\""), "binary"),
            (Encoding::Ascii, n) => (format!("NumberOfComponents=\"{n}\""), "ascii"),
        };
        let _ = write!(
            text,
            "<DataArray type=\"{kind:?}\" Name=\"{name}\" {attributes} format=\"{format}\">"
        );
        if C::ENCODING == Encoding::Base64 {
            let size = if matches!(kind, Type::UInt8) { 1 } else { 8 };
            self.values.integers([size * components * count(&self.contents)]);
        }
    }
}

#[expect(clippy::needless_pass_by_value, reason = "for map_err")]
pub(super) fn unusable(error: FieldArraysError) -> ExportError {
    ExportError::Fields(error.to_string())
}

/// Returns the faces of cells of equal width with these middles.
pub(super) fn faces(middles: &[f64], across: &[f64]) -> Vec<f64> {
    let width = |places: &[f64]| Some(places.get(1)? - places.first()?);
    let width = width(middles).or_else(|| width(across)).unwrap_or(1.0);
    let first = middles.first().map(|first| first - 0.5 * width);
    first.into_iter().chain(middles.iter().map(|middle| middle + 0.5 * width)).collect()
}
