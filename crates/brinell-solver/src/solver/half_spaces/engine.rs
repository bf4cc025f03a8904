//! Half-spaces as an engine of the method: which grid, and what becomes of an outcome on it.

use std::sync::Arc;

use brinell_halfspace::{
    DEVIATOR_COMPONENTS, Elasticity, HalfSpace, Layers, SurfaceFlexibility, SurfaceGrid,
    YieldingBody,
};

use super::estimate::bytes;
use super::law::law_of_cells;
use super::measure::{place, reach, semi_axes};
use super::problem::{Expected, HalfSpaceProblem};
use super::system::{ElasticBody, HalfSpaces, Yielding};
use crate::contact::{ConjugateGradientSolver, ContactLoad};
use crate::job::{self, Deformable, InitialStressProfile, Theory};
use crate::solver::method::contact_system::{BlockVector, ContactFigures, ContactSystem as _};
use crate::solver::method::couplings::Coupling;
use crate::solver::method::couplings::iteration::{Controls, Outcome, Scales};
use crate::solver::method::figures::Figures;
use crate::solver::method::final_check::COLLAPSE_STRAIN;
use crate::solver::method::observer::Held;
use crate::solver::method::phases::Phase;
use crate::solver::method::run::Run;
use crate::solver::method::solve::{self, Engine, Round, Verdict, VerdictOf};
use crate::solver::watch::watched;
use crate::solver::{SolveError, strategy};

/// Half a side of the grid over the semi-axis. From the prototype in Python.
const REACH: f64 = 1.6;
/// Thickness of the first layer over the shorter side of a cell, and growth of the layers times
/// cells along a side. From the prototype in Python.
const FIRST_LAYER: f64 = 0.75;
const GROWTH: f64 = 1.92;
/// Depth of the layers over the shorter semi-axis. From the prototype in Python.
const DEPTH: f64 = 2.6;
/// Overload of a ball, and what is left of it for a line, beyond which plastic zones are wider and
/// deeper than that; they grow with its square root. Perfectly plastic balls and ellipsoids of
/// radii 10 and 100 mm, overloads 3 to 30, reach within 0.9 of these grids.
const WIDE_ZONE: f64 = 8.0;
const WIDE_ZONE_OF_LINES: f64 = 4.0;
/// How far a grid reaches beyond the ends of a roller, over the half-width of the contact.
const BEYOND_ENDS: f64 = 1.0;
/// Sides of cells along a roller over those across it, as long as they are not more than so many
/// times as many.
const ROLLER_ASPECT: f64 = 4.0;
pub(super) const MOST_CELLS_ALONG: f64 = 8.0;
/// Depth of the layers below heights over half the shorter side, and their growth.
const PATCH_DEPTH: f64 = 0.5;
const PATCH_GROWTH: f64 = 1.2;
/// Factor by which cells grow at least where contact or plastic strain has reached the end of a
/// grid, and how often they do.
const ENLARGEMENT: f64 = 1.3;
const MAX_ENLARGEMENTS: usize = 8;
/// Half a side and depth of a grid over what yields on it.
const MARGIN: f64 = 1.1;

/// How a grid is laid out. Its cells are as many as its extent asks for: where contact or plastic
/// strain reaches further than that, the cells grow and not their number, which bounds the memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GridDesign {
    /// Semi-axes along x and y, or more where plastic strain reaches far beyond them \[mm\].
    pub semi_axes: [f64; 2],
    /// Cells over each of them.
    pub cells: f64,
    /// Half sides over the semi-axes.
    reach: [f64; 2],
    /// Depth of the layers over the shorter semi-axis.
    depth: f64,
    /// Factor on all depths.
    stretch: f64,
    /// Half the length of a roller along y, which cells do not go across \[mm\], and whether it
    /// touches from end to end.
    pub half_length: Option<f64>,
    is_line: bool,
    /// Cells along y over those along x.
    finer: f64,
    /// Cells of heights, and cells over a semi-axis for which the grid has as many.
    patch: Option<([usize; 2], f64)>,
    pub enlargements: usize,
}

impl GridDesign {
    /// For the contact that is expected, and a job that asks for `asked` cells.
    pub fn new(expected: Expected, cells: f64, asked: f64) -> Self {
        let Expected { semi_axes: [a, b], half_length, is_line, patch, overload, .. } = expected;
        let wide = WIDE_ZONE_OF_LINES + (WIDE_ZONE - WIDE_ZONE_OF_LINES) * (a / b);
        let beyond = (overload / wide).sqrt().max(1.0) - 1.0;
        // Beyond the ends of a long contact plastic strain reaches as far as beside it.
        let reach = [1.0 + beyond, 1.0 + beyond * a / b].map(|factor| REACH * factor);
        let reach = [
            reach[0],
            if is_line { 1.0 + BEYOND_ENDS * (1.0 + beyond) * a / b } else { reach[1] },
        ];
        let finer =
            if is_line { (b / (ROLLER_ASPECT * a)).clamp(1.0, MOST_CELLS_ALONG) } else { 1.0 };
        let depth = DEPTH * (1.0 + beyond);
        let semi_axes = [a, b];
        let (stretch, enlargements) = (1.0, 0);
        let patch = patch.map(|patch| (patch, asked));
        let (reach, depth) =
            if patch.is_some() { ([1.0; 2], PATCH_DEPTH) } else { (reach, depth) };
        Self {
            semi_axes,
            cells,
            reach,
            depth,
            stretch,
            half_length,
            is_line,
            finer,
            patch,
            enlargements,
        }
    }

    /// Whether the grid is that of heights.
    pub const fn is_patch(&self) -> bool {
        self.patch.is_some()
    }

    /// The same extent in other cells.
    pub fn with_cells(self, cells: f64) -> Self {
        Self { cells, ..self }
    }

    /// A grid for both.
    pub fn union(self, other: Self) -> Self {
        let larger = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].max(b[1])];
        Self {
            semi_axes: larger(self.semi_axes, other.semi_axes),
            reach: larger(self.reach, other.reach),
            depth: self.depth.max(other.depth),
            stretch: self.stretch.max(other.stretch),
            is_line: self.is_line || other.is_line,
            finer: self.finer.max(other.finer),
            ..self
        }
    }

    /// The same number of cells around this contact and what yields below it; this design where
    /// nothing touches.
    pub fn fitted(self, system: &HalfSpaces, force: &[f64]) -> Self {
        let mut axes = reach(system, force);
        if self.patch.is_some() || axes[0].min(axes[1]) <= 0.0 {
            return self;
        }
        if let Some(half_length) = self.half_length.filter(|_| self.is_line) {
            axes[1] = half_length;
        }
        let zone = plastic_zone(system).map(|reach| MARGIN * reach);
        let semi_axes = [0, 1].map(|k| axes[k].max(zone[k] / self.reach[k]));
        let stretch = (zone[2] / (self.depth * semi_axes[0].min(semi_axes[1]))).max(1.0);
        Self { semi_axes, stretch, ..self }
    }

    /// A larger grid, for one whose ends along x, along y or in depth are reached.
    fn enlarged(self, system: &HalfSpaces, force: &[f64], reached: [bool; 3]) -> Self {
        let factor = reached.map(|reached| if reached { ENLARGEMENT } else { 1.0 });
        let [x, y] = self.semi_axes;
        let least = Self {
            semi_axes: [factor[0] * x, factor[1] * y],
            enlargements: self.enlargements + 1,
            ..self
        };
        let next = least.union(self.fitted(system, force));
        let stretch = factor[2] * self.stretch * self.shorter() / next.shorter();
        Self { stretch: stretch.max(1.0), ..next }
    }

    fn shorter(&self) -> f64 {
        self.semi_axes[0].min(self.semi_axes[1])
    }

    /// Cells of the surface and layers below them.
    pub fn grid(&self) -> Result<(SurfaceGrid, Layers), SolveError> {
        if let Some((cells, asked)) = self.patch {
            return self.grid_of_patch(cells, self.cells / asked);
        }
        let [a, b] = self.semi_axes;
        let cells = [self.cells, self.cells * self.finer];
        let (hx, mut hy) = (a / cells[0], b / cells[1]);
        let mut over_semi_axes = cells;
        if let Some(half_length) = self.half_length {
            hy = half_length / (half_length / hy).ceil();
            over_semi_axes[1] = b / hy;
        }
        let sides = [hx, hy];
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a small positive number"
        )]
        let counts = [0, 1].map(|k| 2 * (self.reach[k] * over_semi_axes[k]).ceil() as usize);
        let grid = SurfaceGrid::new(counts[0], counts[1], sides[0], sides[1])?;
        let growth = 1.0 + GROWTH / (2.0 * REACH * self.cells);
        let first = FIRST_LAYER * sides[0].min(sides[1]);
        let layers = Layers::graded(
            self.stretch * first,
            growth,
            self.stretch * self.depth * self.shorter(),
        )?;
        Ok((grid, layers))
    }
}

impl GridDesign {
    /// The grid of heights, with this part of its cells along each side. Layers grow faster than
    /// elsewhere, because there are many cells to a side.
    fn grid_of_patch(
        &self,
        cells: [usize; 2],
        part: f64,
    ) -> Result<(SurfaceGrid, Layers), SolveError> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 512")]
        let counts = cells.map(|count| ((count as f64 * part).round() as usize).clamp(2, count));
        let sides = [0, 1].map(|k| 2.0 * self.semi_axes[k] / counts[k] as f64);
        let grid = SurfaceGrid::new(counts[0], counts[1], sides[0], sides[1])?;
        let first = FIRST_LAYER * sides[0].min(sides[1]);
        let depth = self.stretch * self.depth * self.shorter();
        Ok((grid, Layers::graded(first, PATCH_GROWTH, depth)?))
    }
}

/// Two half-spaces with the laws of one theory.
pub(super) struct HalfSpaceEngine<'a> {
    pub problem: &'a HalfSpaceProblem,
    pub theory: Theory,
    pub coupling: &'static dyn Coupling,
    pub tolerance: f64,
    contact: ConjugateGradientSolver,
    /// Figures of a grid of half the cells at the end of each load of a history.
    pub coarse: Vec<Figures>,
}

/// Largest violation of a contact condition that the contact solver leaves: half of what the check
/// lets pass.
pub(super) const CONTACT_TOLERANCE: f64 = 5e-9;

impl<'a> HalfSpaceEngine<'a> {
    /// Iterated as the job asks for.
    pub fn new(problem: &'a HalfSpaceProblem, theory: Theory) -> Self {
        let coupling = strategy::coupling(problem.solver.coupling);
        Self { coupling, ..Self::auxiliary(problem, theory, problem.solver.tolerance.get()) }
    }

    /// Iterated as is best for grids that nothing is reported of.
    pub fn auxiliary(problem: &'a HalfSpaceProblem, theory: Theory, tolerance: f64) -> Self {
        let coupling = strategy::coupling(job::Coupling::Accelerated);
        let contact = ConjugateGradientSolver::new(CONTACT_TOLERANCE);
        Self { problem, theory, coupling, tolerance, contact, coarse: Vec::new() }
    }

    /// The load is filled in.
    pub fn controls(&self) -> Controls<'_> {
        Controls {
            contact: &self.contact,
            load: ContactLoad::Force(0.0),
            tolerance: self.tolerance,
            max_iterations: self.problem.solver.max_iterations as usize,
            renewable: false,
            scales: Scales::default(),
            increment: None,
        }
    }
}

/// An outcome on its grid.
pub(super) struct Answer {
    pub system: HalfSpaces,
    pub outcome: Outcome,
}

impl solve::Answer for Answer {
    type System = HalfSpaces;

    fn system(&self) -> &HalfSpaces {
        &self.system
    }

    fn outcome(&self) -> &Outcome {
        &self.outcome
    }

    fn outcome_mut(&mut self) -> &mut Outcome {
        &mut self.outcome
    }

    fn into_parts(self) -> (HalfSpaces, Outcome) {
        (self.system, self.outcome)
    }

    /// The shorter semi-axis is the half-width.
    fn figures(&self) -> Figures {
        let contact = &self.outcome.state.response.contact;
        let ContactFigures { force, approach, peak_pressure, .. } = self.system.figures(contact);
        let [x, y] = semi_axes(&self.system, &contact.force);
        Figures { peak_pressure, half_width: x.min(y), approach, force, ..Figures::default() }
    }

    fn has_collapsed(&self) -> bool {
        self.system.yielding.borrow().bodies.iter().any(|body| {
            let cells = body.space().layers().len() * body.space().grid().n_cells();
            (0..cells).any(|cell| body.law().equivalent_plastic_strain(cell) > COLLAPSE_STRAIN)
        })
    }
}

impl HalfSpaceEngine<'_> {
    fn system(&self, design: &GridDesign, run: &mut Run<'_>) -> Result<HalfSpaces, SolveError> {
        let (grid, layers) = design.grid()?;
        let problem = self.problem;
        run.hold(Held::Bodies, bytes(problem, &grid, &layers))?;
        let initial_gap = problem.gap(&grid);
        let is_symmetric = is_symmetric(problem, &grid, &layers, &initial_gap);
        let are_equal =
            problem.materials[0].is_some() && problem.materials[0] == problem.materials[1];
        let mut bodies = Vec::new();
        let mut body = |material: &Option<Deformable>, count: u8| {
            let material = material.as_ref();
            let count = (count, is_symmetric);
            let built = material
                .map(|material| self.body(material, &grid, &layers, (count, run), &mut bodies));
            built.transpose()
        };
        let [upper, lower] = &problem.materials;
        let elastic = if are_equal {
            let both = body(upper, 2)?;
            [both.clone(), both]
        } else {
            [body(upper, 1)?, body(lower, 1)?]
        };
        let of_body = |body: &YieldingBody| {
            let weight = |layer: usize| {
                grid.cell_area()
                    * (body.space().layers().thickness(layer) / design.shorter()).sqrt()
            };
            (0..layers.len()).map(weight).collect()
        };
        Ok(HalfSpaces {
            design: *design,
            surface: SurfaceFlexibility::new(grid, problem.effective_modulus()),
            closing: vec![1.0; initial_gap.len()],
            moment: problem.moment(),
            last_tilt: 0.0.into(),
            accepted: bodies.iter().map(|body: &YieldingBody| vec![0.0; body.len()]).collect(),
            initial_gap,
            elastic,
            weights: bodies.iter().map(of_body).collect(),
            is_smoothed: self.theory == Theory::Flow && !bodies.is_empty() && !design.is_patch(),
            yielding: Yielding::new(bodies).into(),
        })
    }

    /// A body that deforms, put among `bodies` if it can yield.
    fn body(
        &self,
        material: &Deformable,
        grid: &SurfaceGrid,
        layers: &Layers,
        ((count, is_symmetric), run): ((u8, bool), &mut Run<'_>),
        bodies: &mut Vec<YieldingBody>,
    ) -> Result<ElasticBody, SolveError> {
        let constants = material.elastic();
        let constants =
            Elasticity::new(constants.young_modulus.get(), constants.poisson_ratio.get())?;
        let initial = initial_stress(material, self.problem.orientation(), layers);
        let law = law_of_cells(material, self.theory, layers, grid.n_cells());
        let build = if law.is_some() { HalfSpace::new } else { HalfSpace::periodic };
        let space = watched(run, Phase::Flexibility, |stop| {
            build(*grid, layers.clone(), constants, is_symmetric, stop)
        })?;
        let space = Arc::new(space);
        let Some(law) = law else {
            return Ok(ElasticBody { space, initial, yielding: None });
        };
        let deviators = initial.iter().map(|stress| deviator(*stress)).collect();
        let begins_there = self.theory == Theory::Flow;
        bodies.push(YieldingBody::new(Arc::clone(&space), law, count, deviators, begins_there));
        Ok(ElasticBody { space, initial, yielding: Some(bodies.len() - 1) })
    }
}

/// Whether gap and initial stress are symmetric about both axes of the fields, to the last digit.
pub(super) fn is_symmetric(
    problem: &HalfSpaceProblem,
    grid: &SurfaceGrid,
    layers: &Layers,
    gap: &[f64],
) -> bool {
    let mut rows = gap.chunks_exact(grid.ny());
    let mirrored = gap.chunks_exact(grid.ny()).rev();
    let is_even = rows.clone().zip(mirrored).all(|(row, mirror)| row == mirror)
        && rows.all(|row| row.iter().eq(row.iter().rev()));
    is_even
        && problem.moment().is_none()
        && problem.materials.iter().flatten().all(|material| {
            initial_stress(material, problem.orientation(), layers)
                .iter()
                .all(|[_, _, xy]| xy.abs() <= 0.0)
        })
}

/// `xx yy xy` of each layer before any load, in axes turned by an angle.
fn initial_stress(material: &Deformable, angle: f64, layers: &Layers) -> Vec<[f64; 3]> {
    let at = initial_stress_over_depth(material, angle);
    (0..layers.len()).map(|layer| at(layers.middle(layer))).collect()
}

/// `xx yy xy` at a depth before any load, in axes turned by an angle.
pub(super) fn initial_stress_over_depth(
    material: &Deformable,
    angle: f64,
) -> impl Fn(f64) -> [f64; 3] {
    let profile = InitialStressProfile::new(material.initial_stress());
    let (sin, cos) = angle.sin_cos();
    move |depth| {
        let [x, y] = profile.at(depth);
        [cos * cos * x + sin * sin * y, sin * sin * x + cos * cos * y, sin * cos * (y - x)]
    }
}

/// Deviator of a plane stress `xx yy xy`.
fn deviator([xx, yy, xy]: [f64; 3]) -> [f64; DEVIATOR_COMPONENTS] {
    let mean = (xx + yy) / 3.0;
    [xx - mean, yy - mean, xy, 0.0, 0.0]
}

/// How far plastic strain reaches along x, along y and in depth \[mm\].
fn plastic_zone(system: &HalfSpaces) -> [f64; 3] {
    let grid = system.grid();
    let mut zone = [0.0_f64; 3];
    for body in &system.yielding.borrow().bodies {
        let layers = body.space().layers();
        for cell in 0..layers.len() * grid.n_cells() {
            let (layer, of_layer) = (cell / grid.n_cells(), cell % grid.n_cells());
            if body.law().has_yielded(layer, cell) {
                let [x, y] = place(grid, of_layer);
                let reach = [
                    x.abs() + 0.5 * grid.hx(),
                    y.abs() + 0.5 * grid.hy(),
                    layers.faces()[layer + 1],
                ];
                zone = std::array::from_fn(|k| zone[k].max(reach[k]));
            }
        }
    }
    zone
}

/// Where contact or plastic strain comes to the end of a grid: along x, along y, in depth.
pub(super) fn ends_reached(system: &HalfSpaces, force: &[f64]) -> [bool; 3] {
    let grid = system.grid();
    let (nx, ny, n_cells) = (grid.nx(), grid.ny(), grid.n_cells());
    let is_at_x = |cell: &usize| cell / ny == 0 || cell / ny + 1 == nx;
    let is_at_y = |cell: &usize| cell.is_multiple_of(ny) || cell % ny + 1 == ny;
    let reaches = |is_there: &dyn Fn(usize) -> bool| {
        let rim = |is_at: &dyn Fn(&usize) -> bool| (0..n_cells).filter(is_at).any(is_there);
        [rim(&is_at_x), rim(&is_at_y)]
    };
    // Beyond heights there is nothing to touch.
    let is_patch = system.design.is_patch();
    let [mut at_x, mut at_y] = reaches(&|cell| force[cell] > 0.0 && !is_patch);
    let mut at_depth = false;
    for body in &system.yielding.borrow().bodies {
        let last = body.space().layers().len() - 1;
        for layer in 0..=last {
            let has_yielded = |cell: usize| body.law().has_yielded(layer, layer * n_cells + cell);
            let [x, y] = reaches(&|cell| has_yielded(cell) && !is_patch);
            (at_x, at_y) = (at_x || x, at_y || y);
            at_depth |= layer == last && (0..n_cells).any(has_yielded);
        }
    }
    [at_x, at_y, at_depth]
}

impl Engine for HalfSpaceEngine<'_> {
    type System = HalfSpaces;
    type Design = GridDesign;
    type Answer = Answer;
    type Error = SolveError;

    fn build(
        &self,
        design: &mut GridDesign,
        run: &mut Run<'_>,
    ) -> Result<(HalfSpaces, Option<BlockVector>), SolveError> {
        Ok((self.system(design, run)?, None))
    }

    fn resume(
        &self,
        _: &GridDesign,
        system: HalfSpaces,
        _: &mut Run<'_>,
    ) -> Result<(HalfSpaces, Option<BlockVector>), SolveError> {
        Ok((system, None))
    }

    fn verdict(
        &self,
        design: &GridDesign,
        system: HalfSpaces,
        outcome: Outcome,
        _: Round,
        _: &mut Run<'_>,
    ) -> Result<VerdictOf<Self>, SolveError> {
        let reached = ends_reached(&system, &outcome.state.response.contact.force);
        let may_enlarge = !outcome.status.is_stopped() && design.enlargements < MAX_ENLARGEMENTS;
        if !may_enlarge || reached == [false; 3] {
            return Ok(Verdict::Accept(Answer { system, outcome }));
        }
        let force = &outcome.state.response.contact.force;
        Ok(Verdict::Again(design.enlarged(&system, force, reached)))
    }
}
