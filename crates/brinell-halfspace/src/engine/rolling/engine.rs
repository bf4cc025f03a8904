//! A track as an engine of the method: which columns, and what becomes of a pass on them.

use std::cell::RefCell;
use std::marker::PhantomData;
use std::sync::Arc;

use crate::engine::CONTACT_TOLERANCE;
use crate::engine::watch::watched;
use crate::line::LineFlexibility;
use crate::track::{Frame as _, Ground, Operators, TrackBody, TrackFault, TrackGrid};
use crate::{Elasticity, GridError, Layers, SurfaceFlexibility};

use super::design::TrackDesign;
use super::error::TrackError;
use super::memory::bytes;
use super::problem::{RollingProblem, initial_stress};
use super::system::Track;
use brinell_contact::{ConjugateGradientSolver, ContactLoad, Flexibility};
use brinell_material::Solid;
use brinell_method::contact_system::BlockVector;
use brinell_method::couplings::iteration::{Controls, Outcome, Scales};
use brinell_method::couplings::{Accelerated, Coupling};
use brinell_method::final_check::COLLAPSE_STRAIN;
use brinell_method::observer::Held;
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use brinell_method::solve::{Engine, Round, Verdict, VerdictOf};

/// Enlargements of a track at most.
const MAX_ENLARGEMENTS: usize = 4;
/// Length that a track is given at most where flow reaches its ends, over the length asked for.
const LONGEST: f64 = 4.0;

/// Tolerance of tracks that nothing but errors is found from: strains of late passes agree to three
/// digits.
const OF_ERRORS: f64 = 1e-5;

/// Two bodies on a track.
pub(super) struct TrackEngine<'a, O, const D: usize, const R: usize> {
    pub problem: &'a RollingProblem,
    pub coupling: &'static dyn Coupling,
    /// Residual over the contact force at which an iteration ends.
    pub tolerance: f64,
    contact: ConjugateGradientSolver,
    operators: PhantomData<O>,
}

impl<'a, O: Operators<D, R>, const D: usize, const R: usize> TrackEngine<'a, O, D, R> {
    /// Iterated as the problem asks for.
    pub fn new(problem: &'a RollingProblem) -> Self {
        Self::with(problem, problem.solver.coupling, problem.solver.tolerance)
    }

    /// Iterated as is best for tracks that nothing but errors is found from.
    pub fn auxiliary(problem: &'a RollingProblem) -> Self {
        Self::with(problem, &Accelerated, problem.solver.tolerance.max(OF_ERRORS))
    }

    fn with(problem: &'a RollingProblem, coupling: &'static dyn Coupling, tolerance: f64) -> Self {
        Self {
            problem,
            coupling,
            tolerance,
            contact: ConjugateGradientSolver::new(CONTACT_TOLERANCE),
            operators: PhantomData,
        }
    }

    /// The increment is filled in.
    pub fn controls(&self) -> Controls<'_> {
        Controls {
            contact: if self.problem.is_line() {
                self.problem.solver.contact
            } else {
                &self.contact
            },
            load: ContactLoad::Force(self.problem.load.force),
            tolerance: self.tolerance,
            max_iterations: self.problem.solver.max_iterations,
            renewable: false,
            scales: Scales::default(),
            increment: None,
        }
    }

    fn track(
        &self,
        design: &TrackDesign,
        run: &mut Run<'_>,
    ) -> Result<Track<O, D, R>, TrackError> {
        let (grid, layers) = design.lay()?;
        let problem = self.problem;
        run.hold(Held::Bodies, bytes(problem, &grid, layers.len()))?;
        let frictions = problem.frictions();
        let bodies = problem.yielding().map(|(side, material)| {
            let count = if problem.is_shared() { 2 } else { 1 };
            body((grid, &layers), material, (count, frictions[side]), run)
        });
        let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
        let initial_gap = grid.sample(|x, y| problem.gap(x, y));
        Ok(Track {
            design: *design,
            flexibility: flexibility(&grid, problem.effective_modulus())?,
            closing: vec![1.0; initial_gap.len()],
            initial_gap,
            accepted: bodies.iter().map(|body| vec![0.0; body.n_numbers()]).collect(),
            bodies: bodies.into(),
            outlets: Vec::new(),
            begun: RefCell::default(),
            grid,
        })
    }
}

/// A body of a material, for `count` bodies, each as strong as its layers.
fn body<O: Operators<D, R>, const D: usize, const R: usize>(
    (grid, layers): (TrackGrid, &Layers),
    material: &Solid,
    (count, friction): (u8, f64),
    run: &mut Run<'_>,
) -> Result<TrackBody<O, D, R>, TrackError> {
    let elastic = material.elastic();
    let elastic = Elasticity::new(elastic.young_modulus, elastic.poisson_ratio)?;
    let depths: Vec<f64> = (0..layers.len()).map(|layer| layers.middle(layer)).collect();
    let law = O::Frame::law(material, &depths, grid.n_rows()).ok_or(TrackError::NoTrack)?;
    let ground = Ground { grid, layers: layers.clone(), elastic };
    let space = watched(run, Phase::Flexibility, |stop| O::new(ground, friction != 0.0, stop))?;
    let initial = initial_stress(material, layers);
    Ok(TrackBody::new(Arc::new(space), law, count, friction, initial))
}

/// The flexibility of both surfaces with the modulus E\* \[MPa\].
fn flexibility(grid: &TrackGrid, modulus: f64) -> Result<Box<dyn Flexibility>, GridError> {
    Ok(if grid.is_line() {
        Box::new(LineFlexibility::new(grid, modulus))
    } else {
        Box::new(SurfaceFlexibility::new(grid.surface()?, modulus))
    })
}

/// A pass on its track.
pub(super) struct Answer<O: Operators<D, R>, const D: usize, const R: usize> {
    pub track: Track<O, D, R>,
    pub outcome: Outcome,
    /// Fault of a track that cuts off contact or plastic region.
    pub fault: Option<TrackFault>,
}

impl<O: Operators<D, R>, const D: usize, const R: usize> Answer<O, D, R> {
    /// Whether strains have outgrown the theory of small strains.
    pub fn has_collapsed(&self) -> bool {
        let n = self.track.grid.n_columns();
        let bodies = self.track.bodies.borrow();
        let mut layers = bodies.iter().flat_map(|body| body.strains().chunks_exact(n));
        layers.any(|row| row.iter().sum::<f64>() > COLLAPSE_STRAIN)
    }
}

impl<O: Operators<D, R>, const D: usize, const R: usize> Engine for TrackEngine<'_, O, D, R> {
    type System = Track<O, D, R>;
    type Design = TrackDesign;
    type Answer = Answer<O, D, R>;
    type Error = TrackError;

    fn build(
        &self,
        design: &mut TrackDesign,
        run: &mut Run<'_>,
    ) -> Result<(Track<O, D, R>, Option<BlockVector>), TrackError> {
        Ok((self.track(design, run)?, None))
    }

    fn verdict(
        &self,
        design: &TrackDesign,
        system: Track<O, D, R>,
        outcome: Outcome,
        _: Round,
        _: &mut Run<'_>,
    ) -> Result<VerdictOf<Self>, TrackError> {
        let pressure = system.pressure(&outcome.state.response.contact.force);
        let bodies = system.bodies.borrow();
        let held = bodies.iter().try_for_each(TrackBody::holds);
        drop(bodies);
        let fault = system.grid.holds(&pressure).and(held).err();
        let (larger, may_enlarge) = match fault {
            Some(TrackFault::Far { .. }) => {
                let length = 2.0 * design.length;
                let longest = LONGEST * self.problem.length();
                (TrackDesign { length, ..*design }, length <= longest)
            }
            _ => (
                TrackDesign { enlargements: design.enlargements + 1, ..*design },
                design.enlargements < MAX_ENLARGEMENTS,
            ),
        };
        let may_enlarge = may_enlarge && !outcome.status.is_stopped();
        Ok(match fault {
            // The window of a larger track may outgrow its ring.
            Some(_) if may_enlarge && larger.lay().is_ok() => Verdict::Again(larger),
            fault => Verdict::Accept(Answer { track: system, outcome, fault }),
        })
    }
}
