//! The answer to one load.

use std::sync::Arc;

use brinell_contact::KktReport;
use brinell_halfspace::{EllipticContact, Layers, SurfaceGrid, TensorField};

use crate::contact::ContactLoad;
use crate::solver::method::increments::LastIncrement;
use crate::solver::method::observer::{IterationRecord, SolveStatus};
use crate::solver::method::steps::{CoarseFigures, IncrementRecord, LoadEnd, Step};
use crate::solver::solution::Energy;

/// The answer to one load of a contact in three dimensions. Lengths in mm, forces in N, stresses
/// in MPa.
#[derive(Debug, Clone)]
pub struct HalfSpaceStep {
    /// How the iteration ended, the final check included.
    pub status: SolveStatus,
    /// What was prescribed.
    pub load: ContactLoad,
    /// Scalar figures.
    pub figures: HalfSpaceFigures,
    /// Estimated errors of these figures, absolute; `None` where the coarser solve has no answer.
    pub errors: Option<HalfSpaceFigures>,
    /// `[x, y]` of the largest smoothed pressure; of the last contact where nothing touches.
    pub peak_position: [f64; 2],
    /// Largest pressure of a single cell.
    pub largest_cell_pressure: f64,
    /// Slope by which the gap falls along y by the tilt of rollers, given or found.
    pub tilt: f64,
    /// Elastic bodies under the same force; `None` without force.
    pub hertz: Option<EllipticContact>,
    /// Pressures and gaps.
    pub surface: Arc<SurfaceMap>,
    /// Where the work of the force has gone, by flow theory. Stress before any load is left out of
    /// the elastic part.
    pub energy: Energy,
    /// Upper and lower body; `None` for a rigid one. Two equal bodies share one.
    pub bodies: [Option<Arc<HalfSpaceBody>>; 2],
    /// Every iteration on the grid that was asked for.
    pub history: Vec<IterationRecord>,
    /// The contact conditions, checked on the answer.
    pub contact_check: KktReport,
    /// What is missing of the moment of a roller, over force and half its length.
    pub missing_moment: f64,
    /// What the plastic law leaves of the plastic strains, `‖2μ(Δε(σ) - Δε)‖` over the contact
    /// force, evaluated anew.
    pub plastic_residual: f64,
    /// The increments of this load, under flow theory.
    pub increments: Vec<IncrementRecord>,
    /// The last of them.
    pub last_increment: LastIncrement,
    /// Largest approach of the history so far \[mm\]; zero without one.
    pub largest_approach: f64,
    /// How often the grid was enlarged.
    pub enlargements: usize,
    /// Whether contact or plastic strain still reaches the end of the grid.
    pub reaches_edge: bool,
    /// Whether plastic strain is so large that the load is at or beyond what the bodies bear.
    pub has_collapsed: bool,
    /// Whether it is what the grid of half the cells has found, of a history that was stopped.
    pub is_preliminary: bool,
    /// The figure that is sought over its wanted value, where no force gave it.
    pub missed: Option<f64>,
}

/// Scalar figures of a step, or their errors.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct HalfSpaceFigures {
    /// Contact force \[N\].
    pub force: f64,
    /// Approach α of distant points \[mm\].
    pub approach: f64,
    /// Largest pressure after a 3 × 3 binomial mean, without which it is jagged near the edge of a
    /// contact that yields \[MPa\].
    pub peak_pressure: f64,
    /// Semi-axes along x and y, from the square of the pressure of the outermost cells on the axes
    /// \[mm\].
    pub semi_axes: [f64; 2],
    /// Area of the ellipse of these semi-axes \[mm²\].
    pub area: f64,
    /// Largest equivalent plastic strain of the upper and lower body.
    pub max_plastic_strain: [f64; 2],
    /// Largest sinking of the surface by plastic strain \[mm\]; without load the depth of the
    /// dent.
    pub dent: [f64; 2],
    /// Largest rise of the surface by plastic strain \[mm\].
    pub pile_up: [f64; 2],
    /// Least of the stresses σxx and σyy in the column of the peak pressure, from below the
    /// surface layer on \[MPa\]; without load the residual stress.
    pub least_stress: [f64; 2],
}

/// Cells of the surface: `[i ny + j]` for the cell `(i, j)` at `(grid.x(i), grid.y(j))`.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceMap {
    /// Cells.
    pub grid: SurfaceGrid,
    /// Pressure \[MPa\].
    pub pressure: Vec<f64>,
    /// Gap under load \[mm\].
    pub gap: Vec<f64>,
}

/// Fields of one body, in cells of layers.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfSpaceBody {
    /// Cells of every layer.
    pub grid: SurfaceGrid,
    /// Layers from the surface down.
    pub layers: Layers,
    /// `xx yy zz xy xz yz` \[MPa\], tension positive, initial stress included; zero where a solve
    /// was stopped, or is preliminary.
    pub stress: TensorField,
    /// Plastic strain `xx yy xy xz yz`, tensor shear; `zz = -xx - yy`. `None` in a body without a
    /// hardening curve.
    pub plastic_strain: Option<TensorField>,
    /// Equivalent plastic strain, `[layer * n_cells + cell]`; empty where no cell can yield.
    pub equivalent_plastic_strain: Vec<f64>,
    /// Yield stress at the equivalent plastic strain of each cell \[MPa\], like it; nominal for a
    /// curve without a yield point.
    pub yield_stress: Vec<f64>,
    /// Displacement of the surface by plastic strain, positive into the body \[mm\].
    pub plastic_displacement: Vec<f64>,
    /// Where the largest plastic strain is; `None` where nothing has yielded.
    pub largest_strain: Option<LargestStrain>,
    /// Volume of the cells that have yielded \[mm³\].
    pub plastic_volume: f64,
}

/// The largest equivalent plastic strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LargestStrain {
    /// Its value.
    pub value: f64,
    /// `[x, y, z]` of the middle of its cell \[mm\].
    pub position: [f64; 3],
}

/// A body at one depth below a place of the surface.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ColumnPoint {
    /// Depth of the middle of the layer \[mm\].
    pub depth: f64,
    /// `xx yy zz xy xz yz` \[MPa\].
    pub stress: [f64; 6],
    /// Equivalent plastic strain.
    pub equivalent_plastic_strain: f64,
    /// Yield stress \[MPa\]; 0 in a body without a hardening curve.
    pub yield_stress: f64,
}

impl HalfSpaceBody {
    /// Von Mises stress of a cell \[MPa\].
    pub fn von_mises(&self, layer: usize, cell: usize) -> f64 {
        let [xx, yy, zz, xy, xz, yz]: [f64; 6] =
            std::array::from_fn(|k| self.stress.component(layer, k)[cell]);
        let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
        (0.5 * normal + 3.0 * (xy * xy + xz * xz + yz * yz)).sqrt()
    }

    /// The body below a place `[x, y]` of its grid, layer by layer, linear between the middles of
    /// cells.
    pub fn column(&self, position: [f64; 2]) -> Vec<ColumnPoint> {
        let corners = corners(&self.grid, position);
        let n_cells = self.grid.n_cells();
        let at = |field: &[f64]| {
            corners.iter().map(|(cell, weight)| weight * field[*cell]).sum::<f64>()
        };
        let of_layer = |field: &[f64], layer: usize| {
            field.get(layer * n_cells..(layer + 1) * n_cells).map_or(0.0, at)
        };
        let point = |layer: usize| ColumnPoint {
            depth: self.layers.middle(layer),
            stress: std::array::from_fn(|k| at(self.stress.component(layer, k))),
            equivalent_plastic_strain: of_layer(&self.equivalent_plastic_strain, layer),
            yield_stress: of_layer(&self.yield_stress, layer),
        };
        (0..self.layers.len()).map(point).collect()
    }
}

/// The four cells around a place, with their weights.
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

impl Step for HalfSpaceStep {
    fn status(&self) -> SolveStatus {
        self.status
    }

    fn set_status(&mut self, status: SolveStatus) {
        self.status = status;
    }

    fn reaches_edge(&self) -> bool {
        self.reaches_edge
    }

    fn end_load(&mut self, end: LoadEnd) {
        (self.load, self.last_increment) = (end.load, end.last_increment);
        self.increments = end.increments;
        self.largest_approach = end.reached[0];
    }

    /// The coarse history's own figures are in [`errors`](Self::errors) already.
    fn estimate(&mut self, _: Option<CoarseFigures>, increments: Option<CoarseFigures>) {
        if let (Some(errors), Some(changes)) = (&mut self.errors, increments) {
            errors.add_increments(&self.figures, changes);
        }
    }

    fn make_preliminary(&mut self) {
        self.is_preliminary = true;
    }

    fn miss(&mut self, ratio: f64) {
        (self.status, self.missed) = (SolveStatus::NotConverged, Some(ratio));
    }
}
