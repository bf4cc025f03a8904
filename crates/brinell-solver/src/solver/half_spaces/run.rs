//! From a problem to its steps: each load on a grid of half the cells and on the one that was asked for.

use super::engine::{Answer, GridDesign, HalfSpaceEngine};
use super::errors;
use super::history::{History, Recorder};
use super::measure::measure;
use super::problem::HalfSpaceProblem;
use super::raw_step::RawStep;
use super::step::{HalfSpaceReceiver, HalfSpaceStep};
use crate::contact::{ConjugateGradientSolver, ContactLoad, ContactSolver};
use crate::job::{Coupling, Theory};
use crate::solver::half_spaces::check::Check;
use crate::solver::loads::{Loads, largest_loads, loads};
use crate::solver::method::couplings::iteration::{Controls, Scales};
use crate::solver::method::increments::Division;
use crate::solver::method::observer::{Interrupt, Observer, SolveStatus};
use crate::solver::method::phases::PhaseTimes;
use crate::solver::method::run::Run;
use crate::solver::method::solve::solve;
use crate::solver::{IncrementNumber, SolveError, strategy};

/// Cells over a semi-axis of the grid that finds out how large the contact is, and its tolerance.
const SIZING_CELLS: f64 = 4.0;
const SIZING_TOLERANCE: f64 = 1e-3;
/// How grids are iterated that nothing is reported of, whatever the job asks for.
const AUXILIARY: Coupling = Coupling::Accelerated;

/// Largest violation of a contact condition that the contact solver leaves: half of what the check lets pass.
const CONTACT_TOLERANCE: f64 = 5e-9;

/// The solver that applies flexibilities. One that needs their entries has nothing to work on.
pub(super) fn contact_solver() -> ConjugateGradientSolver {
    ConjugateGradientSolver::new(CONTACT_TOLERANCE)
}

/// What a run leaves beside its steps.
#[derive(Debug, Clone, Default)]
pub struct HalfSpaceRun {
    /// Time by phase.
    pub phases: PhaseTimes,
    /// Grids made.
    pub grids: usize,
    /// Why loads at the end are missing.
    pub interrupted: Option<Interrupt>,
}

/// Solves the loads of a problem, each on what the one before has left under flow theory.
///
/// # Errors
/// [`SolveError`]. An iteration that does not converge is no error: see [`SolveStatus`].
pub fn run_each(
    problem: &HalfSpaceProblem,
    observer: &mut dyn Observer,
    receiver: &mut dyn HalfSpaceReceiver,
) -> Result<HalfSpaceRun, SolveError> {
    let mut done = HalfSpaceRun::default();
    let mut run = Run { phases: &mut done.phases, passes: &mut done.grids, observer };
    let solver = LoadSolver { problem };
    let interrupted = match loads(&problem.load) {
        Loads::Given(loads) if problem.solver.theory == Theory::Flow => {
            solver.history(&loads, &mut run, receiver)?
        }
        Loads::Given(loads) => solver.loads(&loads, &mut run, receiver)?,
        Loads::Sought(_) => return Err(SolveError::NotInThreeDimensions),
    };
    done.interrupted = interrupted;
    Ok(done)
}

/// Solves loads of one problem.
struct LoadSolver<'a> {
    problem: &'a HalfSpaceProblem,
}

/// How a load is iterated.
#[derive(Clone, Copy)]
pub(super) struct Iterating {
    pub load: ContactLoad,
    pub tolerance: f64,
    pub scales: Scales,
    pub increment: Option<IncrementNumber>,
}

impl HalfSpaceProblem {
    pub(super) fn controls<'a>(&self, contact: &'a dyn ContactSolver, iterating: Iterating) -> Controls<'a> {
        Controls {
            contact,
            load: iterating.load,
            tolerance: iterating.tolerance,
            max_iterations: self.solver.max_iterations as usize,
            renewable: false,
            scales: iterating.scales,
            increment: iterating.increment,
        }
    }

    /// Whether a body has a hardening curve.
    pub(super) fn can_yield(&self) -> bool {
        self.materials.iter().flatten().any(|material| material.plasticity().is_some())
    }
}

impl LoadSolver<'_> {
    /// Loads that know nothing of each other.
    fn loads(
        &self,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        receiver: &mut dyn HalfSpaceReceiver,
    ) -> Result<Option<Interrupt>, SolveError> {
        for load in loads {
            let step = self.step(*load, run)?;
            let interrupt = step.status.interrupt();
            receiver.step(step, run.observer);
            if interrupt.is_some() {
                return Ok(interrupt);
            }
        }
        Ok(None)
    }

    fn step(&self, load: ContactLoad, run: &mut Run<'_>) -> Result<HalfSpaceStep, SolveError> {
        let tolerance = self.problem.solver.tolerance.get();
        let cells = f64::from(self.problem.cells_per_semi_axis);
        let design = self.size(load, run)?;
        let design = design.with(design.semi_axes, 0.5 * cells);
        let (coarse, design) = run.silently(|run| self.under(load, design, tolerance, AUXILIARY, run))?;
        interrupted(coarse.status)?;
        let design = design.with(coarse.semi_axes_or(design.semi_axes), cells);
        let (fine, _) = self.under(load, design, tolerance, self.problem.solver.coupling, run)?;
        let errors = errors::of_grid(&fine, &coarse);
        Ok(fine.into_step(self.problem, errors))
    }

    /// A first grid, sized by elastic bodies or, where they can yield, by a grid of few cells.
    fn size(&self, load: ContactLoad, run: &mut Run<'_>) -> Result<GridDesign, SolveError> {
        let elastic = self.problem.elastic_contact(load).ok_or(SolveError::NoLoad)?;
        let design = GridDesign::new([elastic.semi_axis_x, elastic.semi_axis_y], SIZING_CELLS);
        if !self.problem.can_yield() {
            return Ok(design);
        }
        let (found, design) =
            run.silently(|run| self.under(load, design, SIZING_TOLERANCE, AUXILIARY, run))?;
        interrupted(found.status)?;
        Ok(design.with(found.semi_axes_or(design.semi_axes), SIZING_CELLS))
    }

    /// One load by deformation theory.
    fn under(
        &self,
        load: ContactLoad,
        design: GridDesign,
        tolerance: f64,
        coupling: Coupling,
        run: &mut Run<'_>,
    ) -> Result<(RawStep, GridDesign), SolveError> {
        let engine = HalfSpaceEngine { problem: self.problem, theory: Theory::Deformation };
        let iterating = Iterating { load, tolerance, scales: Scales::default(), increment: None };
        let contact = contact_solver();
        let controls = self.problem.controls(&contact, iterating);
        let coupling = strategy::coupling(coupling);
        let Answer { system, mut outcome, design } =
            solve(&engine, design, None, run, |grid, system, start, run| {
                grid.solve(system, start, coupling, controls, run)
            })?;
        let check = Check::of(&system, &outcome, load, 0.0);
        let step = RawStep {
            load,
            status: check.verdict(outcome.status, tolerance),
            measured: measure(&system, &outcome, [0.0; 2]),
            check,
            history: std::mem::take(&mut outcome.history),
            increments: Vec::new(),
            enlargements: design.enlargements,
        };
        Ok((step, design))
    }

    /// Loads of which each begins where the one before has ended.
    fn history(
        &self,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        receiver: &mut dyn HalfSpaceReceiver,
    ) -> Result<Option<Interrupt>, SolveError> {
        let cells = f64::from(self.problem.cells_per_semi_axis);
        let mut design: Option<GridDesign> = None;
        for load in largest_loads(loads) {
            let next = self.size(load, run)?;
            let wider = design.is_none_or(|design| next.semi_axes[0] > design.semi_axes[0]);
            design = if wider { Some(next) } else { design };
        }
        let design = design.ok_or(SolveError::NoLoad)?;
        let (division, half) = match self.problem.solver.increments {
            Some(count) => (Division::Fixed(count), Division::Fixed(count.div_ceil(2))),
            None => (Division::Level(1), Division::Level(0)),
        };
        let history = |division| History { problem: self.problem, loads, division };
        let design = design.with(design.semi_axes, 0.5 * cells);
        let mut halved = Recorder::default();
        let design = run.silently(|run| history(half).solve(design, run, &mut halved))?;
        interrupted(halved.status())?;
        let mut coarse = Recorder::default();
        let design = run.silently(|run| history(division).solve(design, run, &mut coarse))?;
        interrupted(coarse.status())?;
        let design = design.with(coarse.semi_axes_or(design.semi_axes), cells);
        let mut deliver =
            Delivery { problem: self.problem, coarse, halved, receiver, delivered: 0, interrupt: None };
        history(division).solve(design, run, &mut deliver)?;
        Ok(deliver.interrupt)
    }
}

/// Fails where a solve that nothing is reported of was stopped.
fn interrupted(status: SolveStatus) -> Result<(), SolveError> {
    status.interrupt().map_or(Ok(()), |interrupt| Err(SolveError::Interrupted(interrupt)))
}

/// Hands over the steps of a history with their errors.
struct Delivery<'a> {
    problem: &'a HalfSpaceProblem,
    coarse: Recorder,
    halved: Recorder,
    receiver: &'a mut dyn HalfSpaceReceiver,
    delivered: usize,
    interrupt: Option<Interrupt>,
}

impl super::history::Steps for Delivery<'_> {
    fn begin(&mut self) {
        if std::mem::take(&mut self.delivered) > 0 {
            self.receiver.begin_anew();
        }
    }

    fn step(&mut self, step: RawStep, run: &mut Run<'_>) {
        let (coarse, halved) = (&self.coarse.steps[self.delivered], &self.halved.steps[self.delivered]);
        let errors = errors::of_history(&step, coarse, halved);
        self.interrupt = step.status.interrupt();
        self.delivered += 1;
        self.receiver.step(step.into_step(self.problem, errors), run.observer);
    }
}
