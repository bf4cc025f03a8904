//! A track as an engine of the method: which columns, and what becomes of a pass on them.

use std::cell::RefCell;
use std::sync::Arc;

use brinell_halfspace::track::{LineFlexibility, RollingBody, TrackFault, TrackGrid, TrackSpace};
use brinell_halfspace::{Elasticity, Layers};

use super::estimate::bytes;
use super::problem::{RollingProblem, initial_stress, law_of_layers};
use super::system::Track;
use crate::contact::{ActiveSetSolver, ContactLoad, ContactSolver, SimplexSolver};
use crate::job::{self, ContactMethod, Deformable};
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

/// Factor of the window, the depth and the length of a track that cuts off contact or yield.
const ENLARGEMENT: f64 = 1.5;
const MAX_ENLARGEMENTS: usize = 4;

/// Columns and extent of a track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TrackDesign {
    /// Elastic half-width a \[mm\].
    pub contact: f64,
    /// Columns over a.
    pub columns: usize,
    /// Length of the track over a.
    pub length: f64,
    /// Friction that decides on the first layer.
    pub friction: f64,
    pub enlargements: usize,
}

impl TrackDesign {
    /// The track of a problem with so many columns over the half-width.
    pub fn new(problem: &RollingProblem, columns: usize) -> Self {
        Self {
            contact: problem.hertz().half_width(),
            columns,
            length: problem.load.track,
            friction: problem.load.friction,
            enlargements: 0,
        }
    }

    /// Columns and layers. All extents follow the half-width that the grid is made for.
    pub fn grid(&self) -> Result<(TrackGrid, Layers), SolveError> {
        let factor = ENLARGEMENT.powi(i32::try_from(self.enlargements).unwrap_or(i32::MAX));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "some thousands at most"
        )]
        let columns = (factor * self.columns as f64).round() as usize;
        let half_width = self.contact * columns as f64 / self.columns as f64;
        let grid = TrackGrid::of_contact(half_width, columns, self.length)?;
        Ok((grid, grid.layers(half_width, self.friction)?))
    }
}

/// Two bodies on a track.
pub(super) struct TrackEngine<'a> {
    pub problem: &'a RollingProblem,
    pub coupling: &'static dyn Coupling,
}

impl<'a> TrackEngine<'a> {
    /// Iterated as the job asks for.
    pub fn new(problem: &'a RollingProblem) -> Self {
        Self { problem, coupling: strategy::coupling(problem.solver.coupling) }
    }

    /// Iterated as is best for tracks that nothing is reported of.
    pub fn auxiliary(problem: &'a RollingProblem) -> Self {
        Self { problem, coupling: strategy::coupling(job::Coupling::Accelerated) }
    }

    pub fn tolerance(&self) -> f64 {
        self.problem.solver.tolerance.get()
    }

    /// The increment is filled in.
    pub fn controls(&self) -> Controls<'_> {
        let contact: &dyn ContactSolver = match self.problem.solver.contact {
            ContactMethod::ActiveSet => &ActiveSetSolver,
            ContactMethod::Simplex => &SimplexSolver,
        };
        Controls {
            contact,
            load: ContactLoad::Force(self.problem.load.force.get()),
            tolerance: self.tolerance(),
            max_iterations: self.problem.solver.max_iterations as usize,
            renewable: false,
            scales: Scales::default(),
            increment: None,
        }
    }

    fn track(&self, design: &TrackDesign, run: &mut Run<'_>) -> Result<Track, SolveError> {
        let (grid, layers) = design.grid()?;
        let problem = self.problem;
        run.hold(Held::Bodies, bytes(problem, &grid, layers.len()))?;
        let count = if problem.is_shared() { 2 } else { 1 };
        let frictions = problem.frictions();
        let bodies = problem.yielding().map(|(side, material)| {
            body(material, (&grid, &layers), (count, frictions[side]), run)
        });
        let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
        let initial_gap = grid.sample(|x| x * x / (2.0 * problem.radius));
        Ok(Track {
            design: *design,
            flexibility: LineFlexibility::new(&grid, problem.effective_modulus()),
            closing: vec![1.0; initial_gap.len()],
            initial_gap,
            accepted: bodies.iter().map(|body| vec![0.0; body.len()]).collect(),
            bodies: bodies.into(),
            outlets: Vec::new(),
            begun: RefCell::default(),
            grid,
        })
    }
}

/// A body that can yield.
fn body(
    material: &Deformable,
    (grid, layers): (&TrackGrid, &Layers),
    (count, friction): (u8, f64),
    run: &mut Run<'_>,
) -> Result<RollingBody, SolveError> {
    let elastic = material.elastic();
    let elastic = Elasticity::new(elastic.young_modulus.get(), elastic.poisson_ratio.get())?;
    let depths: Vec<f64> = (0..layers.len()).map(|layer| layers.middle(layer)).collect();
    let law = law_of_layers(material, &depths).ok_or(SolveError::NoTrack)?;
    let space = watched(run, Phase::Flexibility, |stop| {
        TrackSpace::new(*grid, layers.clone(), elastic, stop)
    })?;
    let initial = initial_stress(material, layers);
    Ok(RollingBody::new(Arc::new(space), law, count, friction, initial))
}

/// A pass on its track.
pub(super) struct Answer {
    pub track: Track,
    pub outcome: Outcome,
    /// What the track cuts off.
    pub fault: Option<TrackFault>,
}

impl solve::Answer for Answer {
    type System = Track;

    fn system(&self) -> &Track {
        &self.track
    }

    fn outcome(&self) -> &Outcome {
        &self.outcome
    }

    fn outcome_mut(&mut self) -> &mut Outcome {
        &mut self.outcome
    }

    fn into_parts(self) -> (Track, Outcome) {
        (self.track, self.outcome)
    }

    fn figures(&self) -> Figures {
        let contact = &self.outcome.state.response.contact;
        let ContactFigures { force, peak_pressure, .. } = self.track.figures(contact);
        Figures { force, peak_pressure, ..Figures::default() }
    }

    fn has_collapsed(&self) -> bool {
        let n = self.track.grid.n_columns();
        let bodies = self.track.bodies.borrow();
        let mut layers = bodies.iter().flat_map(|body| body.strains().chunks_exact(n));
        layers.any(|row| row.iter().sum::<f64>() > COLLAPSE_STRAIN)
    }
}

impl Engine for TrackEngine<'_> {
    type System = Track;
    type Design = TrackDesign;
    type Answer = Answer;
    type Error = SolveError;

    fn build(
        &self,
        design: &mut TrackDesign,
        run: &mut Run<'_>,
    ) -> Result<(Track, Option<BlockVector>), SolveError> {
        Ok((self.track(design, run)?, None))
    }

    fn resume(
        &self,
        _: &TrackDesign,
        system: Track,
        _: &mut Run<'_>,
    ) -> Result<(Track, Option<BlockVector>), SolveError> {
        Ok((system, None))
    }

    fn verdict(
        &self,
        design: &TrackDesign,
        system: Track,
        outcome: Outcome,
        _: Round,
        _: &mut Run<'_>,
    ) -> Result<VerdictOf<Self>, SolveError> {
        let pressure = system.pressure(&outcome.state.response.contact.force);
        let bodies = system.bodies.borrow();
        let held = bodies.iter().try_for_each(RollingBody::holds);
        drop(bodies);
        let fault = system.grid.holds(&pressure).and(held).err();
        let may_enlarge = !outcome.status.is_stopped() && design.enlargements < MAX_ENLARGEMENTS;
        Ok(match fault {
            Some(_) if may_enlarge => {
                Verdict::Again(TrackDesign { enlargements: design.enlargements + 1, ..*design })
            }
            fault => Verdict::Accept(Answer { track: system, outcome, fault }),
        })
    }
}
