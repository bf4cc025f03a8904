//! VTK file of the layers of half-spaces on a rectilinear grid.
//!
//! ```text
//! z from the surface into the lower body; upper body: z → -z, σ_xz → -σ_xz, σ_yz → -σ_yz
//! ```

use std::ops::Range;

use super::ExportError;
use super::vtk::Type::{Float64, UInt8};
use super::vtk::{
    Array, Encoding, Places, Sources, Values, VtkContents, VtkFile, faces, places, unusable,
};
use crate::report::{FieldLayout, Report, Side, encode_layers};

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

/// A file of layers.
pub type VtrFile = VtkFile<Layers>;

/// Cells of both bodies.
#[derive(Debug)]
pub struct Layers {
    /// Numbers of cells along x and along y, and of layers of a body.
    cells: [usize; 3],
    /// Deformable bodies, the upper one first: whether it is the upper one, and its sources.
    bodies: Vec<(bool, Places)>,
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
        let sides = [Side::Upper, Side::Lower];
        let sides: Vec<_> = sides.into_iter().filter(|side| layout.has(*side)).collect();
        let first =
            *sides.first().filter(|_| layout.member() == "layers").ok_or(ExportError::NoLayers)?;
        let count =
            |name: &str| Ok(layout.find(first, name).map_err(unusable)?.len() / size_of::<f64>());
        let cells = [count("x")?, count("y")?, count("z")?];
        let body = |side| Ok((side == Side::Upper, places::<Layers>(layout, side)?));
        let bodies = sides.into_iter().map(body).collect::<Result<_, ExportError>>()?;
        Ok(Self::of(report, [step, steps], Layers { cells, bodies }))
    }
}

impl Layers {
    fn n_layers(&self) -> usize {
        self.cells[2] * self.bodies.len()
    }

    fn n_cells(&self) -> usize {
        self.cells[0] * self.cells[1] * self.n_layers()
    }

    /// Writes the cells of a layer, along x first. Shear stresses on the surface change their sign
    /// with z.
    fn layer(&self, &[body, components]: &[usize; 2], from: Sources, values: &mut Values) {
        let [nx, ny, _] = self.cells;
        let turns = |k| components == 6 && self.bodies[body].0 && matches!(k, 4 | 5);
        for cell in (0..ny).flat_map(|j| (0..nx).map(move |i| i * ny + j)) {
            let value = |k| if turns(k) { -from.float(k, cell) } else { from.float(k, cell) };
            values.floats((0..components).map(value));
        }
    }

    fn layer_faces(&self, _: &[usize; 2], from: Sources, values: &mut Values) {
        let depths = from.floats(0);
        let has = |is_upper: bool| self.bodies.iter().any(|body| body.0 == is_upper);
        let above = depths.iter().skip(1).rev().filter(|_| has(true)).map(|depth| -depth);
        let below = depths.iter().skip(1).copied().filter(|_| has(false));
        values.floats(above.chain([0.0]).chain(below));
    }
}

/// Writes the faces of cells along x or y, from the middles of the cells; the section of a track is
/// as thick as its cells are wide.
fn along(_: &Layers, _: &[usize; 2], from: Sources, values: &mut Values) {
    values.floats(faces(&from.floats(0), &from.floats(1)));
}

const CELLS: &str = "CellData Scalars=\"von_mises\" Tensors=\"stress\"";
const FACES: &str = "Coordinates";
const STRESS: &[&str] = &["sigma_xx", "sigma_yy", "sigma_zz", "sigma_xy", "sigma_yz", "sigma_xz"];
const STRAIN: &[&str] = &[
    "plastic_strain_xx",
    "plastic_strain_yy",
    "plastic_strain_zz",
    "plastic_strain_xy",
    "plastic_strain_yz",
    "plastic_strain_xz",
];
const HARDENED: &str = "equivalent_plastic_strain";

impl VtkContents for Layers {
    /// A body, and the number of components.
    type Block = [usize; 2];

    const GRID: &'static str = "RectilinearGrid";
    const ENCODING: Encoding = Encoding::Base64;
    const ARRAYS: &'static [Array<Self>] = &[
        Array(CELLS, Float64, "stress", 6, Self::n_cells, STRESS, Self::layer),
        Array(CELLS, Float64, "von_mises", 1, Self::n_cells, &["von_mises"], Self::layer),
        Array(CELLS, Float64, "plastic_strain", 6, Self::n_cells, STRAIN, Self::layer),
        Array(CELLS, Float64, HARDENED, 1, Self::n_cells, &[HARDENED], Self::layer),
        Array(CELLS, UInt8, "body", 1, Self::n_cells, &[], |all, [body, _], _, values| {
            values.repeated(u8::from(all.bodies[*body].0), all.cells[0] * all.cells[1]);
        }),
        Array(FACES, Float64, "x", 1, |all| all.cells[0] + 1, &["x", "y"], along),
        Array(FACES, Float64, "y", 1, |all| all.cells[1] + 1, &["y", "y"], along),
        Array(FACES, Float64, "z", 1, |all| all.n_layers() + 1, &["z_faces"], Self::layer_faces),
    ];

    fn size(&self) -> [String; 2] {
        let [nx, ny, _] = self.cells;
        let extent = format!("Extent=\"0 {nx} 0 {ny} 0 {}\"", self.n_layers());
        [format!(" Whole{extent}"), extent]
    }

    fn blocks(&self, array: &Array<Self>) -> Vec<([usize; 2], Vec<Range<usize>>)> {
        let Array(group, _, _, components, _, sources, _) = *array;
        if group == FACES {
            let places = sources.iter().map(|name| self.bodies[0].1[name].clone());
            return vec![([0, components], places.collect())];
        }
        let [nx, ny, n_layers] = self.cells;
        let bytes = size_of::<f64>() * nx * ny;
        let bodies = self.bodies.iter().enumerate();
        let blocks = bodies.flat_map(|(k, (is_upper, places))| {
            // Downwards.
            let layer = move |at| if *is_upper { n_layers - 1 - at } else { at };
            (0..n_layers).map(layer).map(move |layer| {
                let begin = |name| places[name].start + bytes * layer;
                let sources = sources.iter().map(|name| begin(name)..begin(name) + bytes);
                ([k, components], sources.collect())
            })
        });
        blocks.collect()
    }
}
