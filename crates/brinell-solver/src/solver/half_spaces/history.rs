//! Loads one after the other on one grid, each divided into increments, by flow theory.

use super::check::Check;
use super::engine::{Answer, GridDesign, HalfSpaceEngine};
use super::measure::{measure, semi_axes};
use super::problem::HalfSpaceProblem;
use super::raw_step::RawStep;
use super::run::{Iterating, contact_solver};
use super::system::HalfSpaces;
use crate::contact::ContactLoad;
use crate::job::Theory;
use crate::solver::method::contact_system::ContactSystem as _;
use crate::solver::method::couplings::iteration::{Outcome, Scales, norm};
use crate::solver::method::increments::{Division, Growth, IncrementEnds, Leg};
use crate::solver::method::observer::{IterationRecord, SolveStatus};
use crate::solver::method::run::Run;
use crate::solver::method::solve::{Leave, OnSystem, solve};
use crate::solver::method::steps::IncrementRecord;
use crate::solver::strategy::coupling;
use crate::solver::{IncrementNumber, SolveError};

/// Largest pressure over the yield stress at which a ball begins to yield (Poisson's ratio 0.3); others begin later.
const ONSET: f64 = 1.6;

/// Takes the steps of a history.
pub(super) trait Steps {
    /// The history begins, perhaps anew.
    fn begin(&mut self);
    /// A load has ended.
    fn step(&mut self, step: RawStep, run: &mut Run<'_>);
}

/// Keeps steps.
#[derive(Default)]
pub(super) struct Recorder {
    pub steps: Vec<RawStep>,
}

impl Recorder {
    /// How the last load ended.
    pub fn status(&self) -> SolveStatus {
        self.steps.last().map_or(SolveStatus::Converged, |step| step.status)
    }

    /// The largest semi-axes, or these.
    pub fn semi_axes_or(&self, other: [f64; 2]) -> [f64; 2] {
        let axes = self.steps.iter().map(|step| step.semi_axes_or([0.0; 2]));
        let most = axes.fold([0.0_f64; 2], |most, axes| [most[0].max(axes[0]), most[1].max(axes[1])]);
        if most[0] > 0.0 && most[1] > 0.0 { most } else { other }
    }
}

impl Steps for Recorder {
    fn begin(&mut self) {
        self.steps.clear();
    }

    fn step(&mut self, step: RawStep, _: &mut Run<'_>) {
        self.steps.push(step);
    }
}

/// Loads in order, and how each is divided.
pub(super) struct History<'a> {
    pub problem: &'a HalfSpaceProblem,
    pub loads: &'a [ContactLoad],
    pub division: Division,
}

/// Where a history is.
#[derive(Default)]
struct Progress {
    force: f64,
    approach: f64,
    /// Largest force and approach so far.
    reached: [f64; 2],
    scales: Scales,
    /// Where the pressure was largest under the last load above zero.
    peak: [f64; 2],
}

impl Progress {
    fn after(&mut self, system: &HalfSpaces, outcome: &Outcome) {
        let response = &outcome.state.response;
        self.force = response.contact.total_force;
        self.approach = response.contact.approach;
        self.reached = [self.reached[0].max(self.force), self.reached[1].max(self.approach)];
        self.scales.force = self.scales.force.max(norm(&response.contact.force));
        self.scales.displacement = self.scales.displacement.max(system.norm(&response.displacement));
    }

    fn measure(&self, load: ContactLoad) -> f64 {
        match load {
            ContactLoad::Force(_) => self.force,
            ContactLoad::Approach(_) => self.approach,
        }
    }
}

/// One load in the making.
#[derive(Default)]
struct Records {
    iterations: Vec<IterationRecord>,
    increments: Vec<IncrementRecord>,
    has_failed: bool,
}

impl History<'_> {
    /// Solves all loads on one grid, or on a larger one from the first load on. The grid in the end.
    pub fn solve(
        &self,
        design: GridDesign,
        run: &mut Run<'_>,
        steps: &mut dyn Steps,
    ) -> Result<GridDesign, SolveError> {
        let engine = HalfSpaceEngine { problem: self.problem, theory: Theory::Flow };
        solve(&engine, design, None, run, |grid, mut system, _, run| {
            steps.begin();
            let (mut progress, mut last) = (Progress::default(), design);
            for number in 0..self.loads.len() {
                let (step, after, on) = self.load(number, grid, system, &mut progress, run)?;
                (system, last) = (after, on);
                let is_stopped = step.status.is_stopped();
                steps.step(step, run);
                if is_stopped {
                    break;
                }
            }
            Ok(last)
        })
    }

    fn load(
        &self,
        number: usize,
        grid: &OnSystem<'_, HalfSpaceEngine<'_>>,
        mut system: HalfSpaces,
        progress: &mut Progress,
        run: &mut Run<'_>,
    ) -> Result<(RawStep, HalfSpaces, GridDesign), Leave<GridDesign>> {
        let load = self.loads[number];
        let leg = self.leg(load, progress);
        let mut ends = IncrementEnds::of(&leg, self.division);
        let mut records = Records::default();
        let mut k = 0;
        loop {
            let increment = IncrementNumber {
                number: k + 1,
                count: ends.count(),
                load: number + 1,
                loads: self.loads.len(),
            };
            let iterating = Iterating {
                load: leg.load(ends.measure(k)),
                tolerance: self.problem.solver.tolerance.get(),
                scales: progress.scales,
                increment: Some(increment),
            };
            let contact = contact_solver();
            let controls = self.problem.controls(&contact, iterating);
            let coupling = coupling(self.problem.solver.coupling);
            let answer = grid.solve(system, None, coupling, controls, run)?;
            let Answer { system: same, mut outcome, design } = answer;
            system = same;
            let iterations = std::mem::take(&mut outcome.history);
            let count = iterations.len();
            records.iterations.extend(iterations);
            let has_failed = outcome.status == SolveStatus::NotConverged;
            if has_failed && ends.halve(k, progress.measure(load)) {
                continue;
            }
            records.has_failed |= has_failed;
            progress.after(&system, &outcome);
            records.increments.push(increment_record(&system, &outcome, count));
            let is_last = k + 1 == ends.count() || outcome.status.is_stopped();
            let step =
                is_last.then(|| raw_step(iterating, &system, &outcome, progress, &mut records, design));
            system.commit(outcome.state.response.displacement);
            if let Some(step) = step {
                return Ok((step, system, design));
            }
            k += 1;
        }
    }

    fn leg(&self, load: ContactLoad, progress: &Progress) -> Leg {
        let is_force = matches!(load, ContactLoad::Force(_));
        let onset = self.onset_force();
        let onset = if is_force { onset } else { onset.map(|force| self.problem.hertz(force).approach) };
        Leg {
            is_force,
            from: progress.measure(load),
            to: load.magnitude(),
            reached: progress.reached[usize::from(!is_force)],
            // Between the elastic and the fully plastic contact of a ball.
            growth: Growth { onset, exponent: if is_force { 2.4 } else { 2.0 } },
        }
    }

    /// A force below which no body yields, but where strength varies over so little depth that it hides it \[N\].
    fn onset_force(&self) -> Option<f64> {
        let weakest = |material: &crate::job::Deformable| {
            let factor = material.strength().map_or(1.0, |strength| strength.range().0);
            material.hardening_law().map(|law| factor * law.nominal_yield_stress())
        };
        let least = self.problem.materials.iter().flatten().filter_map(weakest).reduce(f64::min)?;
        Some((ONSET * least / self.problem.hertz(1.0).peak_pressure).powi(3))
    }
}

/// The step at the end of a load.
fn raw_step(
    iterating: Iterating,
    system: &HalfSpaces,
    outcome: &Outcome,
    progress: &mut Progress,
    records: &mut Records,
    design: GridDesign,
) -> RawStep {
    let Iterating { load, tolerance, .. } = iterating;
    let check = Check::of(system, outcome, load, progress.scales.force);
    let status = check.verdict(outcome.status, tolerance);
    let has_failed = records.has_failed && status == SolveStatus::Converged;
    let measured = measure(system, outcome, progress.peak);
    progress.peak = measured.peak_position;
    RawStep {
        load,
        status: if has_failed { SolveStatus::NotConverged } else { status },
        measured,
        check,
        history: std::mem::take(&mut records.iterations),
        increments: std::mem::take(&mut records.increments),
        enlargements: design.enlargements,
    }
}

fn increment_record(system: &HalfSpaces, outcome: &Outcome, iterations: usize) -> IncrementRecord {
    let contact = &outcome.state.response.contact;
    let figures = system.figures(contact);
    let [x, y] = semi_axes(system.grid(), &contact.force);
    IncrementRecord {
        force: figures.force,
        approach: figures.approach,
        peak_pressure: figures.peak_pressure,
        half_width: x.min(y),
        iterations,
        plastic_points: system.yielded_cells(),
        status: outcome.status,
    }
}
