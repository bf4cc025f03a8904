//! Half-spaces as an engine of the method: the system of a grid, and what becomes of an outcome
//! on it.

use std::sync::Arc;

use crate::{
    DEVIATOR_COMPONENTS, Elasticity, HalfSpace, Layers, SurfaceFlexibility, SurfaceGrid,
    YieldingBody,
};

use super::design::GridDesign;
use super::error::HalfSpaceError;
use super::law::{initial_stress, law_of_cells};
use super::measure::{place, reach, semi_axes};
use super::operators::{bytes, is_symmetric};
use super::problem::HalfSpaceProblem;
use super::system::{ElasticBody, HalfSpaces, Yielding};
use crate::engine::CONTACT_TOLERANCE;
use crate::engine::watch::watched;
use brinell_contact::{ConjugateGradientSolver, ContactLoad};
use brinell_material::Solid;
use brinell_method::contact_system::{BlockVector, ContactSystem as _};
use brinell_method::couplings::iteration::{Controls, Outcome, Scales};
use brinell_method::couplings::{Accelerated, Coupling};
use brinell_method::figures::Figures;
use brinell_method::final_check::COLLAPSE_STRAIN;
use brinell_method::observer::Held;
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use brinell_method::settings::Theory;
use brinell_method::solve::{Engine, Round, Verdict, VerdictOf};

/// Enlargements of a grid at most.
const MAX_ENLARGEMENTS: usize = 8;

/// Two half-spaces with the laws of one theory.
pub(super) struct HalfSpaceEngine<'a> {
    pub problem: &'a HalfSpaceProblem,
    pub theory: Theory,
    pub coupling: &'static dyn Coupling,
    pub tolerance: f64,
    contact: ConjugateGradientSolver,
}

impl<'a> HalfSpaceEngine<'a> {
    /// Iterated as the problem asks for.
    pub fn new(problem: &'a HalfSpaceProblem, theory: Theory) -> Self {
        let coupling = problem.solver.coupling;
        Self { coupling, ..Self::auxiliary(problem, theory, problem.solver.tolerance) }
    }

    /// Iterated as is best for grids that nothing is reported of.
    pub fn auxiliary(problem: &'a HalfSpaceProblem, theory: Theory, tolerance: f64) -> Self {
        let contact = ConjugateGradientSolver::new(CONTACT_TOLERANCE);
        Self { problem, theory, coupling: &Accelerated, tolerance, contact }
    }

    /// The load is filled in.
    pub fn controls(&self) -> Controls<'_> {
        Controls {
            contact: &self.contact,
            load: ContactLoad::Force(0.0),
            tolerance: self.tolerance,
            max_iterations: self.problem.solver.max_iterations,
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

impl Answer {
    /// Headline figures; the shorter semi-axis is the half-width.
    pub fn figures(&self) -> Figures {
        let contact = &self.outcome.state.response.contact;
        let [x, y] = semi_axes(&self.system, &contact.force);
        self.system.figures(contact).headline(x.min(y))
    }

    /// Whether strains have outgrown the theory of small strains.
    pub fn has_collapsed(&self) -> bool {
        self.system.yielding.borrow().bodies.iter().any(|body| {
            let cells = body.space().layers().len() * body.space().grid().n_cells();
            (0..cells).any(|cell| body.law().equivalent_plastic_strain(cell) > COLLAPSE_STRAIN)
        })
    }
}

impl HalfSpaceEngine<'_> {
    fn system(
        &self,
        design: &GridDesign,
        run: &mut Run<'_>,
    ) -> Result<HalfSpaces, HalfSpaceError> {
        let (grid, layers) = design.grid()?;
        let problem = self.problem;
        run.hold(Held::Bodies, bytes(problem, &grid, &layers))?;
        let initial_gap = problem.gap(&grid);
        let is_symmetric = is_symmetric(problem, &grid, &layers, &initial_gap);
        let are_equal =
            problem.materials[0].is_some() && problem.materials[0] == problem.materials[1];
        let mut bodies = Vec::new();
        let mut body = |material: &Option<Solid>, count: u8| {
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
            surface: SurfaceFlexibility::inclined(
                grid,
                problem.effective_modulus(),
                problem.conformity.curvature(),
            ),
            closing: problem.conformity.closing(&grid),
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
        material: &Solid,
        grid: &SurfaceGrid,
        layers: &Layers,
        ((count, is_symmetric), run): ((u8, bool), &mut Run<'_>),
        bodies: &mut Vec<YieldingBody>,
    ) -> Result<ElasticBody, HalfSpaceError> {
        let constants = material.elastic();
        let constants = Elasticity::new(constants.young_modulus, constants.poisson_ratio)?;
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

/// Deviator of a plane stress `xx yy xy`.
fn deviator([xx, yy, xy]: [f64; 3]) -> [f64; DEVIATOR_COMPONENTS] {
    let mean = (xx + yy) / 3.0;
    [xx - mean, yy - mean, xy, 0.0, 0.0]
}

impl HalfSpaces {
    /// The design of its grid, fitted to the contact under these forces.
    pub fn fitted(&self, force: &[f64]) -> GridDesign {
        self.design.fitted(reach(self, force), plastic_zone(self))
    }
}

/// Returns the reach of the plastic region along x, along y and in depth \[mm\].
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

/// Returns whether contact or plastic strain reaches the end of a grid: along x, along y, in depth.
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
    type Error = HalfSpaceError;

    fn build(
        &self,
        design: &mut GridDesign,
        run: &mut Run<'_>,
    ) -> Result<(HalfSpaces, Option<BlockVector>), HalfSpaceError> {
        Ok((self.system(design, run)?, None))
    }

    fn verdict(
        &self,
        design: &GridDesign,
        system: HalfSpaces,
        outcome: Outcome,
        _: Round,
        _: &mut Run<'_>,
    ) -> Result<VerdictOf<Self>, HalfSpaceError> {
        let reached = ends_reached(&system, &outcome.state.response.contact.force);
        let may_enlarge = !outcome.status.is_stopped() && design.enlargements < MAX_ENLARGEMENTS;
        if !may_enlarge || reached == [false; 3] {
            return Ok(Verdict::Accept(Answer { system, outcome }));
        }
        let force = &outcome.state.response.contact.force;
        Ok(Verdict::Again(design.enlarged(system.fitted(force), reached)))
    }
}
