//! VTK file of the layers of half-spaces on a rectilinear grid, for programs like ParaView. It is
//! written piece by piece.
//!
//! ```text
//! z from the surface into the lower body; upper body: z → -z, σ_xz → -σ_xz, σ_yz → -σ_yz
//! ```
//!
//! Arrays are inline: base64 of a 64-bit count of bytes and the little-endian values after it.
//!
//! # Reference
//! *VTK XML file formats*, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>.

use std::fmt::Write as _;
use std::ops::Range;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::vtk::{TENSOR, faces, unusable};
use super::{ExportError, FieldsFile};
use crate::report::{FieldLayout, FieldSide, Report, encode_layers};

/// An array of cells: its name, the source arrays of its components, and its attributes.
type CellArray = (&'static str, &'static [&'static str], &'static str);

const CELL_ARRAYS: [CellArray; 4] = [
    ("stress", &["sigma_xx", "sigma_yy", "sigma_zz", "sigma_xy", "sigma_yz", "sigma_xz"], TENSOR),
    ("von_mises", &["von_mises"], ""),
    (
        "plastic_strain",
        &[
            "plastic_strain_xx",
            "plastic_strain_yy",
            "plastic_strain_zz",
            "plastic_strain_xy",
            "plastic_strain_yz",
            "plastic_strain_xz",
        ],
        TENSOR,
    ),
    ("equivalent_plastic_strain", &["equivalent_plastic_strain"], ""),
];

const END: &str = "</Coordinates>\n</Piece>\n</RectilinearGrid>\n</VTKFile>\n";

/// Writes `stress` (XX, YY, ZZ, XY, YZ, XZ), `von_mises`, `plastic_strain`,
/// `equivalent_plastic_strain` and `body` (0 lower, 1 upper) in the cells of both bodies, in the
/// units of the job. Load steps are counted from 0.
///
/// # Errors
/// [`ExportError::NoStep`]; [`ExportError::NoLayers`] if the job did not ask for layers, or is not
/// in three dimensions.
pub(super) fn layers_vtr(report: &Report, step: usize) -> Result<String, ExportError> {
    let shown = report.steps.get(step).ok_or(ExportError::NoStep(step))?;
    let layers = shown.layers.as_ref().ok_or(ExportError::NoLayers)?;
    let bytes = encode_layers(layers).map_err(unusable)?;
    let layout = FieldLayout::read(&bytes).map_err(unusable)?;
    Ok(VtrFile::new(report, [step, report.steps.len()], &layout)?.whole(&bytes))
}

/// State of a file between its pieces.
#[derive(Debug)]
pub struct VtrFile {
    title: String,
    /// Numbers of cells along x and along y, and of layers of a body.
    cells: [usize; 3],
    /// Deformable bodies, the upper one first.
    bodies: Vec<Body>,
    /// Positions of the coordinates x, y and `z_faces` in the bytes of the load step.
    coordinates: [Range<usize>; 3],
    /// Bytes of an array that are not yet encoded, because base64 encodes groups of three bytes.
    pending: Vec<u8>,
}

/// Positions of the arrays of a body, in the order of [`CELL_ARRAYS`].
#[derive(Debug)]
struct Body {
    is_upper: bool,
    arrays: Vec<Vec<Range<usize>>>,
}

/// A piece of the file. Pieces are written in order.
#[derive(Debug, Clone)]
pub struct VtrPiece {
    what: What,
    sources: Vec<Range<usize>>,
}

#[derive(Debug, Clone, Copy)]
enum What {
    Head,
    /// Type, name and attributes of an array, and its number of bytes.
    Begin([&'static str; 3], usize),
    /// Cells of a layer. `negative` marks the components that change their sign with z.
    Layer {
        negative: [bool; 6],
    },
    Body {
        number: u8,
    },
    /// Faces of cells along x or y, from the middles of the cells; the section of a track is as
    /// thick as its cells are wide.
    Faces,
    /// Faces of the layers. The flags say whether there are layers above and below the surface.
    LayerFaces([bool; 2]),
    End,
    BetweenCellsAndCoordinates,
    Foot,
}

impl Body {
    fn new(side: FieldSide, layout: &FieldLayout) -> Result<Self, ExportError> {
        let find = |name: &&str| layout.find(side, name).map_err(unusable);
        let of_array = |(_, names, _): &CellArray| names.iter().map(find).collect();
        let arrays = CELL_ARRAYS.iter().map(of_array).collect::<Result<_, _>>()?;
        Ok(Self { is_upper: side == FieldSide::Upper, arrays })
    }

    /// Returns the layers in the order of the file: downwards.
    fn layers(&self, count: usize) -> impl Iterator<Item = usize> + use<> {
        let is_upper = self.is_upper;
        (0..count).map(move |layer| if is_upper { count - 1 - layer } else { layer })
    }

    /// Returns which components of an array change their sign: shear stresses on the surface.
    fn negative(&self, components: usize) -> [bool; 6] {
        let is_shear = |k: usize| components > 1 && (k == 4 || k == 5);
        std::array::from_fn(|k| self.is_upper && is_shear(k))
    }
}

impl VtrFile {
    /// Returns the file of the load step `step`, counted from 0 and out of `steps`, with the
    /// layers in `layout`.
    ///
    /// # Errors
    /// [`ExportError::NoLayers`] if `layout` has the fields of a mesh; [`ExportError::Fields`].
    pub fn new(
        report: &Report,
        [step, steps]: [usize; 2],
        layout: &FieldLayout,
    ) -> Result<Self, ExportError> {
        let sides =
            [FieldSide::Upper, FieldSide::Lower].into_iter().filter(|side| layout.has(*side));
        let sides: Vec<FieldSide> = sides.collect();
        let first =
            *sides.first().filter(|_| layout.member() == "layers").ok_or(ExportError::NoLayers)?;
        let find = |name: &str| layout.find(first, name).map_err(unusable);
        let count = |name: &str| find(name).map(|range| range.len() / size_of::<f64>());
        let bodies =
            sides.iter().map(|side| Body::new(*side, layout)).collect::<Result<_, _>>()?;
        let title = format!(
            "brinell {}, {}, units {}, step {} of {steps}",
            report.version,
            report.analysis,
            report.units,
            step + 1
        );
        Ok(Self {
            title,
            cells: [count("x")?, count("y")?, count("z")?],
            bodies,
            coordinates: [find("x")?, find("y")?, find("z_faces")?],
            pending: Vec::new(),
        })
    }

    fn layers(&self) -> usize {
        self.cells[2] * self.bodies.len()
    }

    fn array(&self, array: usize) -> Vec<VtrPiece> {
        let (name, components, attributes) = CELL_ARRAYS[array];
        let n_cells = self.cells[0] * self.cells[1];
        let bytes = size_of::<f64>() * components.len() * n_cells * self.layers();
        let of_body = |body: &Body| {
            let what = What::Layer { negative: body.negative(components.len()) };
            let sources = body.arrays[array].clone();
            body.layers(self.cells[2]).map(move |layer| {
                let of_layer = |range: &Range<usize>| {
                    let begin = range.start + size_of::<f64>() * n_cells * layer;
                    begin..begin + size_of::<f64>() * n_cells
                };
                VtrPiece { what, sources: sources.iter().map(of_layer).collect() }
            })
        };
        let begin = text(What::Begin(["Float64", name, attributes], bytes));
        [begin]
            .into_iter()
            .chain(self.bodies.iter().flat_map(of_body))
            .chain([text(What::End)])
            .collect()
    }

    fn head(&self, text: &mut String) {
        let [nx, ny, _] = self.cells;
        let extent = format!("0 {nx} 0 {ny} 0 {}", self.layers());
        let _ = write!(
            text,
            "<?xml version=\"1.0\"?>\n\
             <!-- {} -->\n\
             <VTKFile type=\"RectilinearGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">\n\
             <RectilinearGrid WholeExtent=\"{extent}\">\n<Piece Extent=\"{extent}\">\n\
             <CellData Scalars=\"von_mises\" Tensors=\"stress\">\n",
            self.title,
        );
    }

    /// Appends the cells of a layer; x varies fastest.
    fn layer<B: AsRef<[u8]>>(&mut self, negative: [bool; 6], sources: &[B]) {
        let [nx, ny, _] = self.cells;
        let components: Vec<&[[u8; size_of::<f64>()]]> =
            sources.iter().map(|bytes| bytes.as_ref().as_chunks().0).collect();
        for cell in (0..ny).flat_map(|j| (0..nx).map(move |i| i * ny + j)) {
            for (component, negative) in components.iter().zip(negative) {
                let value = component.get(cell).map_or(0.0, |bytes| f64::from_le_bytes(*bytes));
                self.pending.extend((if negative { -value } else { value }).to_le_bytes());
            }
        }
    }
}

const fn text(what: What) -> VtrPiece {
    VtrPiece { what, sources: Vec::new() }
}

fn numbers(source: &[u8]) -> Vec<f64> {
    source.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect()
}

impl FieldsFile for VtrFile {
    type Piece = VtrPiece;

    fn pieces(&self) -> Vec<VtrPiece> {
        let [nx, ny, _] = self.cells;
        let mut pieces = vec![text(What::Head)];
        pieces.extend((0..CELL_ARRAYS.len()).flat_map(|array| self.array(array)));
        pieces.push(text(What::Begin(["UInt8", "body", ""], nx * ny * self.layers())));
        for body in &self.bodies {
            let number = u8::from(body.is_upper);
            pieces.extend((0..self.cells[2]).map(|_| text(What::Body { number })));
        }
        pieces.extend([text(What::End), text(What::BetweenCellsAndCoordinates)]);
        let has = |is_upper: bool| self.bodies.iter().any(|body| body.is_upper == is_upper);
        let of_layers = What::LayerFaces([has(true), has(false)]);
        let along =
            [("x", What::Faces, nx), ("y", What::Faces, ny), ("z", of_layers, self.layers())];
        for ((name, what, cells), source) in along.into_iter().zip(self.coordinates.clone()) {
            let across = self.coordinates[1].clone();
            pieces.push(text(What::Begin(["Float64", name, ""], size_of::<f64>() * (cells + 1))));
            pieces.push(VtrPiece { what, sources: vec![source, across] });
            pieces.push(text(What::End));
        }
        pieces.push(text(What::Foot));
        pieces
    }

    fn sources(piece: &VtrPiece) -> &[Range<usize>] {
        &piece.sources
    }

    fn write<B: AsRef<[u8]>>(&mut self, piece: &VtrPiece, sources: &[B]) -> String {
        let mut text = String::new();
        let coordinates =
            || sources.first().map_or_else(Vec::new, |source| numbers(source.as_ref()));
        match piece.what {
            What::Head => self.head(&mut text),
            What::Begin([kind, name, attributes], bytes) => {
                let _ = write!(
                    text,
                    "<DataArray type=\"{kind}\" Name=\"{name}\" {attributes} format=\"binary\">"
                );
                self.pending.extend((bytes as u64).to_le_bytes());
            }
            What::Layer { negative } => self.layer(negative, sources),
            What::Body { number } => {
                let n_cells = self.cells[0] * self.cells[1];
                self.pending.resize(self.pending.len() + n_cells, number);
            }
            What::Faces => {
                let across =
                    sources.get(1).map_or_else(Vec::new, |source| numbers(source.as_ref()));
                let faces = faces(&coordinates(), &across);
                self.pending.extend(faces.into_iter().flat_map(f64::to_le_bytes));
            }
            What::LayerFaces([above, below]) => {
                let depths = coordinates();
                let above = depths.iter().skip(1).rev().filter(|_| above).map(|depth| -depth);
                let below = depths.iter().skip(1).copied().filter(|_| below);
                let all = above.chain([0.0]).chain(below);
                self.pending.extend(all.flat_map(f64::to_le_bytes));
            }
            What::End => {
                STANDARD.encode_string(std::mem::take(&mut self.pending), &mut text);
                text.push_str("</DataArray>\n");
            }
            What::BetweenCellsAndCoordinates => text.push_str("</CellData>\n<Coordinates>\n"),
            What::Foot => text.push_str(END),
        }
        if !matches!(piece.what, What::End) {
            let whole = self.pending.len() / 3 * 3;
            STANDARD.encode_string(&self.pending[..whole], &mut text);
            self.pending.drain(..whole);
        }
        text
    }
}
