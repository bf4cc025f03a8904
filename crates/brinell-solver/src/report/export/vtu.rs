//! VTK file of the fields of both bodies on unstructured cells, for programs like ParaView. It is
//! written piece by piece and need not be in memory as a whole.
//!
//! ```text
//! image of a half model:  x → -x,  u_x → -u_x,  τ_xy → -τ_xy
//!                         corners in reverse order (still counter-clockwise)
//! upper body:             u_y → u_y - α, so that the support of the lower body is at rest
//! ```
//!
//! Both halves share the nodes on the axis. For a body of revolution x is the radius, and there is
//! no image. Arrays are inline: base64 of a 64-bit count of bytes and the little-endian values
//! after it.
//!
//! # Reference
//! *VTK XML file formats*, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>.

use std::fmt::Write as _;
use std::ops::Range;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::surface_vtu::surface_vtu;
use super::vtk::{END, QUAD, TENSOR, unusable};
use super::{ExportError, FieldsFile};
use crate::job::{Analysis, Named};
use crate::report::field_arrays::CHUNK;
use crate::report::{FieldArraysError, FieldLayout, FieldSide, Report, encode_fields};

/// Writes the mesh before loading with `displacement` \[length\], `stress` (XX, YY, ZZ, XY, YZ,
/// XZ), `von_mises` and `equivalent_plastic_strain` at its nodes and `body` (0 lower, 1 upper) in
/// its cells, in the units of the job.
///
/// Displacements are relative to the support of the lower body: the upper body moves down by the
/// approach, so that the displaced bodies touch. Load steps are counted from 0.
///
/// # Errors
/// [`ExportError::NoStep`]; [`ExportError::NoFields`] if the job did not ask for fields.
pub fn field_vtu(report: &Report, step: usize) -> Result<String, ExportError> {
    let shown = report.steps.get(step).ok_or(ExportError::NoStep(step))?;
    if let Some(whole) = &shown.three_dimensional {
        let maps = whole.maps.as_ref().ok_or(ExportError::NoFields)?;
        return Ok(surface_vtu(report, [step, report.steps.len()], maps.clone()).collect());
    }
    let bytes =
        encode_fields(shown.fields.as_ref().ok_or(ExportError::NoFields)?).map_err(unusable)?;
    let layout = FieldLayout::read(&bytes).map_err(unusable)?;
    Ok(VtuFile::new(
        report,
        [step, report.steps.len()],
        shown.approach.unwrap_or_default(),
        &layout,
    )?
    .whole(&bytes))
}

/// State of a file between its pieces.
#[derive(Debug)]
pub struct VtuFile {
    title: String,
    /// Deformable bodies, the lower one first.
    bodies: Vec<Body>,
    /// Bytes of an array that are not yet encoded, because base64 encodes groups of three bytes.
    pending: Vec<u8>,
}

/// A deformable body.
#[derive(Debug)]
struct Body {
    name: u8,
    is_half: bool,
    /// Distance by which the body moves down \[length\].
    descent: f64,
    nodes: usize,
    elements: usize,
    /// Positions of its arrays in the bytes of the load step, in the order of [`SOURCES`].
    sources: [Range<usize>; 9],
    /// Nodes on the axis of a half model, in ascending order.
    axis: Vec<usize>,
}

/// Names of the source arrays with their number of bytes for each node or element.
const SOURCES: [(&str, usize); 9] = [
    ("nodes", 16),
    ("elements", 16),
    ("displacement", 16),
    ("sigma_x", 8),
    ("sigma_y", 8),
    ("sigma_z", 8),
    ("tau_xy", 8),
    ("von_mises", 8),
    ("equivalent_plastic_strain", 8),
];

/// An array of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Array {
    Displacement,
    Stress,
    VonMises,
    Strain,
    Body,
    Points,
    Connectivity,
    Offsets,
    Types,
}

/// Arrays of the file in order, each with the text before it.
const ARRAYS: [(&str, Array); 9] = [
    ("<PointData Scalars=\"von_mises\" Vectors=\"displacement\">\n", Array::Displacement),
    ("", Array::Stress),
    ("", Array::VonMises),
    ("", Array::Strain),
    ("</PointData>\n<CellData>\n", Array::Body),
    ("</CellData>\n<Points>\n", Array::Points),
    ("</Points>\n<Cells>\n", Array::Connectivity),
    ("", Array::Offsets),
    ("", Array::Types),
];

/// A piece of the file. Pieces are written in order.
#[derive(Debug, Clone)]
pub struct VtuPiece {
    what: What,
    /// Positions of the source numbers in the bytes of the load step.
    sources: Vec<Range<usize>>,
}

#[derive(Debug, Clone)]
enum What {
    /// Search for the nodes on the axis; it writes nothing.
    Axis(Items),
    /// Text before the arrays.
    Head,
    Begin(&'static str, Array),
    Values(Array, Items),
    End,
    Foot,
}

/// Some of the nodes or elements of a body, or of its image.
#[derive(Debug, Clone)]
struct Items {
    body: usize,
    is_image: bool,
    range: Range<usize>,
}

impl Array {
    /// Returns type, name and attributes of the array.
    const fn declaration(self) -> [&'static str; 3] {
        match self {
            Self::Displacement => ["Float64", "displacement", "NumberOfComponents=\"3\""],
            Self::Stress => ["Float64", "stress", TENSOR],
            Self::VonMises => ["Float64", "von_mises", ""],
            Self::Strain => ["Float64", "equivalent_plastic_strain", ""],
            Self::Body => ["UInt8", "body", ""],
            Self::Points => ["Float64", "Points", "NumberOfComponents=\"3\""],
            Self::Connectivity => ["Int64", "connectivity", ""],
            Self::Offsets => ["Int64", "offsets", ""],
            Self::Types => ["UInt8", "types", ""],
        }
    }

    /// Returns the number of bytes for each node or element.
    const fn bytes(self) -> usize {
        match self {
            Self::Displacement | Self::Points => 24,
            Self::Stress => 48,
            Self::VonMises | Self::Strain | Self::Offsets => 8,
            Self::Connectivity => 32,
            Self::Body | Self::Types => 1,
        }
    }

    const fn is_of_elements(self) -> bool {
        matches!(self, Self::Body | Self::Connectivity | Self::Offsets | Self::Types)
    }

    /// Returns the indices of the source arrays in [`SOURCES`].
    const fn sources(self) -> &'static [usize] {
        match self {
            Self::Points => &[0],
            Self::Connectivity => &[1],
            Self::Displacement => &[2],
            Self::Stress => &[3, 4, 5, 6],
            Self::VonMises => &[7],
            Self::Strain => &[8],
            Self::Body | Self::Offsets | Self::Types => &[],
        }
    }
}

impl Body {
    fn new(
        name: u8,
        layout: &FieldLayout,
        is_half: bool,
        descent: f64,
    ) -> Result<Option<Self>, FieldArraysError> {
        let side = if name == 0 { FieldSide::Lower } else { FieldSide::Upper };
        if !layout.has(side) {
            return Ok(None);
        }
        let mut sources: [Range<usize>; 9] = Default::default();
        for (source, (name, _)) in sources.iter_mut().zip(SOURCES) {
            *source = layout.find(side, name)?;
        }
        let [nodes, elements] = [0, 1].map(|k: usize| sources[k].len() / SOURCES[k].1);
        Ok(Some(Self { name, is_half, descent, nodes, elements, sources, axis: Vec::new() }))
    }

    /// Returns the number of nodes, including the image.
    fn all_nodes(&self) -> usize {
        if self.is_half { 2 * self.nodes - self.axis.len() } else { self.nodes }
    }

    /// Returns the index of a node, or of its image, among the nodes of the body and its image.
    fn index(&self, node: usize, is_image: bool) -> usize {
        match self.axis.binary_search(&node) {
            Err(before) if is_image => (self.nodes + node).saturating_sub(before),
            _ => node,
        }
    }

    /// Returns the position of a range of nodes or elements of a source array.
    fn source(&self, source: usize, range: &Range<usize>) -> Range<usize> {
        let (begin, bytes) = (self.sources[source].start, SOURCES[source].1);
        begin + bytes * range.start..begin + bytes * range.end
    }
}

impl VtuFile {
    /// Returns the file of the load step `step`, counted from 0 and out of `steps`, with its
    /// approach and with the fields in `layout`.
    ///
    /// # Errors
    /// [`ExportError::Fields`].
    pub fn new(
        report: &Report,
        [step, steps]: [usize; 2],
        approach: f64,
        layout: &FieldLayout,
    ) -> Result<Self, ExportError> {
        let is_half = report.mesh.symmetric && report.analysis != Analysis::Axisymmetric.name();
        let bodies = [(0, 0.0), (1, approach)]
            .map(|(name, descent)| Body::new(name, layout, is_half, descent));
        let bodies: Result<Vec<_>, _> = bodies.into_iter().filter_map(Result::transpose).collect();
        let title = format!(
            "brinell {}, {}, units {}, step {} of {steps}",
            report.version,
            report.analysis,
            report.units,
            step + 1
        );
        Ok(Self { title, bodies: bodies.map_err(unusable)?, pending: Vec::new() })
    }

    fn head(&self, text: &mut String) {
        let [nodes, elements] = self.before(self.bodies.len());
        let _ = write!(
            text,
            "<?xml version=\"1.0\"?>\n\
             <!-- {} -->\n\
             <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">\n\
             <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
            self.title, nodes, elements,
        );
    }

    /// Appends the values of an array at nodes or elements.
    fn values<B: AsRef<[u8]>>(&mut self, array: Array, items: &Items, sources: &[B]) {
        let Items { body: number, is_image, ref range } = *items;
        let body = &self.bodies[number];
        let [first_node, first_element] = self.before(number);
        let first_element = first_element + if is_image { body.elements } else { 0 };
        let is_written = |node: &usize| !is_image || body.axis.binary_search(node).is_err();
        let nodes = range.clone().enumerate().filter(|(_, node)| is_written(node)).map(|(k, _)| k);
        let at = |source: usize, at: usize| float(sources, source, at);
        let sign = if is_image { -1.0 } else { 1.0 };
        let pending = &mut self.pending;
        match array {
            Array::Displacement => {
                floats(
                    pending,
                    nodes.map(|k| [sign * at(0, 2 * k), at(0, 2 * k + 1) - body.descent, 0.0]),
                );
            }
            Array::Points => {
                floats(pending, nodes.map(|k| [sign * at(0, 2 * k), at(0, 2 * k + 1), 0.0]));
            }
            Array::Stress => {
                floats(
                    pending,
                    nodes.map(|k| [at(0, k), at(1, k), at(2, k), sign * at(3, k), 0.0, 0.0]),
                );
            }
            Array::VonMises | Array::Strain => floats(pending, nodes.map(|k| [at(0, k)])),
            Array::Body => pending.extend(range.clone().map(|_| body.name)),
            Array::Types => pending.extend(range.clone().map(|_| QUAD)),
            Array::Offsets => {
                integers(pending, range.clone().map(|k| 4 * (first_element + k + 1)));
            }
            Array::Connectivity => {
                let corners =
                    sources.first().map_or(&[][..], |bytes| bytes.as_ref().as_chunks::<16>().0);
                let corners = corners.iter().map(|corners| corners.as_chunks::<4>().0);
                let index =
                    |corner: &[u8; 4]| body.index(u32::from_le_bytes(*corner) as usize, is_image);
                let nodes = |corners: &[[u8; 4]]| corners.iter().map(index).collect::<Vec<_>>();
                let turned = corners.map(nodes).flat_map(|mut nodes| {
                    if is_image {
                        nodes.reverse();
                    }
                    nodes
                });
                integers(pending, turned.map(|node| first_node + node));
            }
        }
    }

    /// Returns the numbers of nodes and elements in the bodies before `body`, including their
    /// images.
    fn before(&self, body: usize) -> [usize; 2] {
        let bodies = self.bodies.iter().take(body);
        let count =
            |body: &Body| [body.all_nodes(), body.elements * (1 + usize::from(body.is_half))];
        bodies.map(count).fold([0; 2], |[n, e], [nodes, elements]| [n + nodes, e + elements])
    }
}

impl FieldsFile for VtuFile {
    type Piece = VtuPiece;

    fn pieces(&self) -> Vec<VtuPiece> {
        let text = |what| VtuPiece { what, sources: Vec::new() };
        let mut pieces = Vec::new();
        for (k, body) in self.bodies.iter().enumerate().filter(|(_, body)| body.is_half) {
            pieces.extend(items(k, false, body.nodes).map(|items| {
                let sources = vec![body.source(0, &items.range)];
                VtuPiece { what: What::Axis(items), sources }
            }));
        }
        pieces.push(text(What::Head));
        for (before, array) in ARRAYS {
            pieces.push(text(What::Begin(before, array)));
            for (k, body) in self.bodies.iter().enumerate() {
                let count = if array.is_of_elements() { body.elements } else { body.nodes };
                let halves = [false, true].into_iter().take(1 + usize::from(body.is_half));
                pieces.extend(halves.flat_map(|is_image| items(k, is_image, count)).map(
                    |items| {
                        let of = |source: &usize| body.source(*source, &items.range);
                        let sources = array.sources().iter().map(of).collect();
                        VtuPiece { what: What::Values(array, items), sources }
                    },
                ));
            }
            pieces.push(text(What::End));
        }
        pieces.push(text(What::Foot));
        pieces
    }

    fn sources(piece: &VtuPiece) -> &[Range<usize>] {
        &piece.sources
    }

    fn write<B: AsRef<[u8]>>(&mut self, piece: &VtuPiece, sources: &[B]) -> String {
        let mut text = String::new();
        match &piece.what {
            What::Axis(items) => {
                let on_axis = items
                    .range
                    .clone()
                    .enumerate()
                    .filter(|(k, _)| float(sources, 0, 2 * k) == 0.0);
                let on_axis = on_axis.map(|(_, node)| node).collect::<Vec<_>>();
                self.bodies[items.body].axis.extend(on_axis);
            }
            What::Head => self.head(&mut text),
            What::Begin(before, array) => {
                let [kind, name, attributes] = array.declaration();
                let _ = write!(
                    text,
                    "{before}<DataArray type=\"{kind}\" Name=\"{name}\" {attributes} \
                     format=\"binary\">"
                );
                let count = self.before(self.bodies.len())[usize::from(array.is_of_elements())];
                self.pending.extend(((array.bytes() * count) as u64).to_le_bytes());
            }
            What::Values(array, items) => {
                self.values(*array, items, sources);
                let whole = self.pending.len() / 3 * 3;
                STANDARD.encode_string(&self.pending[..whole], &mut text);
                self.pending.drain(..whole);
            }
            What::End => {
                STANDARD.encode_string(std::mem::take(&mut self.pending), &mut text);
                text.push_str("</DataArray>\n");
            }
            What::Foot => text.push_str(END),
        }
        text
    }
}

/// Returns `count` nodes or elements in pieces.
fn items(body: usize, is_image: bool, count: usize) -> impl Iterator<Item = Items> {
    let ranges = (0..count).step_by(CHUNK).map(move |from| from..(from + CHUNK).min(count));
    ranges.map(move |range| Items { body, is_image, range })
}

fn floats<const N: usize>(bytes: &mut Vec<u8>, values: impl Iterator<Item = [f64; N]>) {
    bytes.extend(values.flatten().flat_map(f64::to_le_bytes));
}

fn integers(bytes: &mut Vec<u8>, values: impl Iterator<Item = usize>) {
    bytes.extend(values.flat_map(|value| (value as u64).to_le_bytes()));
}

/// Returns a number from the bytes of a source array.
fn float<B: AsRef<[u8]>>(sources: &[B], source: usize, at: usize) -> f64 {
    let numbers =
        sources.get(source).map(|bytes| bytes.as_ref().as_chunks::<8>().0).unwrap_or_default();
    numbers.get(at).map_or(0.0, |bytes| f64::from_le_bytes(*bytes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::{FieldsReport, PerBody};

    #[test]
    fn a_half_is_completed_by_its_image() {
        let square = FieldsReport {
            nodes: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            elements: vec![[0, 1, 2, 3]],
            displacement: vec![[0.5, -1.0]; 4],
            sigma_x: vec![1.0; 4],
            sigma_y: vec![2.0; 4],
            sigma_z: vec![3.0; 4],
            tau_xy: vec![4.0; 4],
            von_mises: vec![5.0; 4],
            equivalent_plastic_strain: vec![6.0; 4],
        };
        let bytes =
            encode_fields(&PerBody { upper: Some(square.clone()), lower: Some(square) }).unwrap();
        let layout = FieldLayout::read(&bytes).unwrap();
        let mut bodies =
            [0, 1].map(|name| Body::new(name, &layout, name == 0, 0.25).unwrap().unwrap());
        bodies[0].axis = vec![0, 3];
        let mut file =
            VtuFile { title: String::new(), bodies: bodies.into(), pending: Vec::new() };
        assert_eq!(file.before(2), [6 + 4, 3]);
        let mut written = |array: Array, body: usize, is_image, range| {
            let items = Items { body, is_image, range };
            let source = |source: &usize| &bytes[file.bodies[body].source(*source, &items.range)];
            let sources: Vec<_> = array.sources().iter().map(source).collect();
            file.values(array, &items, &sources);
            std::mem::take(&mut file.pending)
        };
        let integers = |bytes: Vec<u8>| {
            bytes.as_chunks::<8>().0.iter().map(|b| u64::from_le_bytes(*b)).collect::<Vec<_>>()
        };
        let floats = |bytes: Vec<u8>| {
            bytes.as_chunks::<8>().0.iter().map(|b| f64::from_le_bytes(*b)).collect::<Vec<_>>()
        };
        assert_eq!(integers(written(Array::Connectivity, 0, false, 0..1)), [0, 1, 2, 3]);
        assert_eq!(integers(written(Array::Connectivity, 0, true, 0..1)), [3, 5, 4, 0]);
        assert_eq!(integers(written(Array::Connectivity, 1, false, 0..1)), [6, 7, 8, 9]);
        assert_eq!(integers(written(Array::Offsets, 1, false, 0..1)), [12]);
        assert_eq!(floats(written(Array::Points, 0, true, 0..2)), [-1.0, 0.0, 0.0]);
        assert_eq!(floats(written(Array::Displacement, 0, true, 1..2)), [-0.5, -1.25, 0.0]);
        assert_eq!(floats(written(Array::Stress, 0, true, 2..4)), [1.0, 2.0, 3.0, -4.0, 0.0, 0.0]);
        assert_eq!(written(Array::Body, 1, false, 0..1), [1]);
    }
}
