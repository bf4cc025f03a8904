//! The answer to one load step.

use std::sync::Arc;

use crate::{EllipticContact, Layers, SurfaceGrid, TensorField};

use brinell_method::steps::Step;

/// The answer to one load of a contact in three dimensions.
///
/// The semi-axes among its figures are extrapolated from the squared pressure of the outermost
/// cells on the axes, the contact area is that of their ellipse, the peak pressure is that after a
/// 3 × 3 binomial mean: unsmoothed, the pressure is jagged near the edge of a contact that yields.
/// Dent and pile-up are those by plastic strain alone, extrapolated. The least stress is that of σxx and σyy in
/// the column below the peak pressure, without the surface layer. The elastic energy leaves out
/// the initial stress. The residual is that of the plastic law, `‖2μ(Δε(σ) - Δε)‖` over the
/// contact force, with the plastic strain increment Δε of the answer and the increment Δε(σ) of
/// the law at its stresses.
pub type HalfSpaceStep = Step<HalfSpaceField>;

/// The fields of two half-spaces under one load. Lengths in mm, forces in N, stresses in MPa.
#[derive(Debug, Clone)]
pub struct HalfSpaceField {
    /// `[x, y]` of the largest smoothed pressure. Without contact, the position under the last
    /// load with contact.
    pub peak_position: [f64; 2],
    /// Largest pressure of a single cell.
    pub largest_cell_pressure: f64,
    /// Slope by which the gap falls along y because the rollers tilt; given, or found from the
    /// moment.
    pub tilt: f64,
    /// Contact of elastic bodies under the same force; `None` without force.
    pub hertz: Option<EllipticContact>,
    /// Pressure and gap at the surface.
    pub surface: Arc<SurfaceMap>,
    /// Upper and lower body; `None` for a rigid body. Two equal bodies share one.
    pub bodies: [Option<Arc<HalfSpaceBody>>; 2],
    /// Part of a roller's moment that is missing, over force times half the length.
    pub missing_moment: f64,
}

/// Pressure and gap in the cells of the surface: `[i ny + j]` for the cell `(i, j)` at
/// `(grid.x(i), grid.y(j))`.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceMap {
    /// The grid of cells.
    pub grid: SurfaceGrid,
    /// Pressure \[MPa\].
    pub pressure: Vec<f64>,
    /// Gap under load \[mm\].
    pub gap: Vec<f64>,
}

/// Fields of one body, in the cells of its layers.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfSpaceBody {
    /// The grid of cells in each layer.
    pub grid: SurfaceGrid,
    /// The layers, from the surface down.
    pub layers: Layers,
    /// Stress `xx yy zz xy xz yz` \[MPa\], tension positive, initial stress included; zero in a
    /// step that was stopped or is preliminary.
    pub stress: TensorField,
    /// Plastic strain `xx yy xy xz yz`, tensor shear; `zz = -xx - yy`. `None` for a body without a
    /// hardening curve.
    pub plastic_strain: Option<TensorField>,
    /// Equivalent plastic strain, `[layer * n_cells + cell]`; empty if the body cannot yield.
    pub equivalent_plastic_strain: Vec<f64>,
    /// Displacement of the surface by plastic strain, extrapolated, positive into the body \[mm\].
    pub plastic_displacement: Vec<f64>,
    /// The largest equivalent plastic strain; `None` if no cell has yielded.
    pub largest_strain: Option<LargestStrain>,
    /// Volume of the plastic region \[mm³\].
    pub plastic_volume: f64,
    /// The plastic region in the section of the cells beside y = 0.
    pub plastic_section: PlasticSection,
}

/// The cells of a section that have yielded.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PlasticSection {
    /// Their area \[mm²\].
    pub area: f64,
    /// Their mean equivalent plastic strain.
    pub mean_strain: f64,
    /// Whether the region includes a cell of the surface, in any section.
    pub reaches_surface: bool,
}

/// The largest equivalent plastic strain of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LargestStrain {
    /// The strain.
    pub value: f64,
    /// `[x, y, z]` of the middle of the cell \[mm\].
    pub position: [f64; 3],
}

/// Stress and strain at one depth below a point of the surface.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ColumnPoint {
    /// Depth of the middle of the layer \[mm\].
    pub depth: f64,
    /// Stress `xx yy zz xy xz yz` \[MPa\].
    pub stress: [f64; 6],
    /// Equivalent plastic strain.
    pub equivalent_plastic_strain: f64,
}

/// Returns the von Mises stress of the stress `[xx, yy, zz, xy, xz, yz]`.
pub fn von_mises([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> f64 {
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * normal + 3.0 * (xy * xy + xz * xz + yz * yz)).sqrt()
}

impl HalfSpaceBody {
    /// Returns the von Mises stress of a cell \[MPa\].
    pub fn von_mises(&self, layer: usize, cell: usize) -> f64 {
        von_mises(std::array::from_fn(|k| self.stress.component(layer, k)[cell]))
    }

    /// Returns the column of the body below a point `[x, y]`, layer by layer, interpolated
    /// linearly between the middles of cells.
    pub fn column(&self, position: [f64; 2]) -> Vec<ColumnPoint> {
        let corners = corners(&self.grid, position);
        let n_cells = self.grid.n_cells();
        let at = |field: &[f64]| {
            corners.iter().map(|(cell, weight)| weight * field[*cell]).sum::<f64>()
        };
        let strain = &self.equivalent_plastic_strain;
        let point = |layer: usize| ColumnPoint {
            depth: self.layers.middle(layer),
            stress: std::array::from_fn(|k| at(self.stress.component(layer, k))),
            equivalent_plastic_strain: strain
                .get(layer * n_cells..(layer + 1) * n_cells)
                .map_or(0.0, at),
        };
        (0..self.layers.len()).map(point).collect()
    }
}

/// Returns the four cells around a point, with their weights.
fn corners(grid: &SurfaceGrid, [x, y]: [f64; 2]) -> [(usize, f64); 4] {
    let [(i, u), (j, v)] =
        [(x / grid.hx(), grid.nx()), (y / grid.hy(), grid.ny())].map(|(x, n)| {
            let place = (x + 0.5 * (n - 1) as f64).clamp(0.0, (n - 1) as f64);
            let lower = (0..n - 1).rev().find(|cell| *cell as f64 <= place).unwrap_or(0);
            (lower, place - lower as f64)
        });
    let cell = |i: usize, j: usize| i * grid.ny() + j;
    [
        (cell(i, j), (1.0 - u) * (1.0 - v)),
        (cell(i, j + 1), (1.0 - u) * v),
        (cell(i + 1, j), u * (1.0 - v)),
        (cell(i + 1, j + 1), u * v),
    ]
}
