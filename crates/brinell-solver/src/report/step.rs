//! Writes the report of each load step when the step ends, and the rest of the report at the end.

use std::time::Duration;

use super::answers::{Facts, Measured, is_dented};
use super::findings::left_unknown;
use super::hardness::HardnessSeen;
use super::load_approach::CurvePoint;
use super::shown::{Arrays, Parts, Shown, Solved};
use super::target::TargetSeen;
use super::{LoadReport, MeshReport, Report, StepReport, Timings, load_approach, validity};
use crate::contact::ContactLoad;
use crate::inputs::SolveError;
use crate::job::{Named as _, Quantity};
use crate::solver::method::figures::{FigureSet, Figures};
use crate::solver::{
    IterationRecord, Observer, Options, Phase, PhaseTimes, SolveStatus, Step, StepReceiver,
};
use crate::units::UnitConverter;

/// Solves the job of an engine and passes the report of each load step to `on_step` when the step
/// ends, so that failures of later steps do not lose it. The returned report has no steps.
///
/// # Errors
/// Those of the engine.
pub(super) fn run_each<E: Shown>(
    engine: &E,
    options: Options<'_>,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
) -> Result<Report, SolveError> {
    let mut writer = StepWriter::new(engine, on_step);
    let solved = engine.solve(options, observer, &mut writer)?;
    Ok(writer.finish(&solved, observer.elapsed()))
}

/// Writes the steps of one job.
struct StepWriter<'a, E: Shown> {
    engine: &'a E,
    write: UnitConverter,
    on_step: &'a mut dyn FnMut(usize, StepReport),
    seen: Seen<E::Memory>,
    /// Time spent on reports.
    time: Duration,
}

/// What the load steps so far have told.
#[derive(Default)]
struct Seen<M> {
    /// Number of steps.
    number: usize,
    status: Option<SolveStatus>,
    /// Points of the converged load steps.
    curve: Vec<CurvePoint>,
    /// The mesh of the last load step on the grid that was asked for.
    mesh: MeshReport,
    /// Largest force that has left plastic strain in a history.
    dented_under: f64,
    /// Figures of the bodies that the loads of a history have left unknown.
    unknown: FigureSet,
    target: TargetSeen,
    hardness: HardnessSeen,
    memory: M,
}

impl<E: Shown> StepReceiver<E::Field> for StepWriter<'_, E> {
    fn step(&mut self, step: Step<E::Field>, observer: &mut dyn Observer) {
        let start = observer.elapsed();
        let report = self.report(step, observer);
        self.time += observer.elapsed().saturating_sub(start);
        (self.on_step)(self.seen.number, report);
        self.seen.number += 1;
    }

    fn begin_anew(&mut self) {
        self.seen = Seen::default();
    }
}

impl<'a, E: Shown> StepWriter<'a, E> {
    fn new(engine: &'a E, on_step: &'a mut dyn FnMut(usize, StepReport)) -> Self {
        let job = engine.job();
        let write = UnitConverter::new(job.units, job.analysis);
        Self { engine, write, on_step, seen: Seen::default(), time: Duration::ZERO }
    }

    /// Returns the report of the next load step. If the observer interrupts the report, the load
    /// step gets the status of the interrupt.
    fn report(&mut self, mut step: Step<E::Field>, observer: &mut dyn Observer) -> StepReport {
        let (engine, job, write) = (self.engine, self.engine.job(), self.write);
        step.path.unknown_before = self.seen.unknown;
        let is_stopped = step.status.is_stopped();
        let arrays =
            if is_stopped { Ok(Arrays::default()) } else { engine.arrays(&step, observer) };
        let arrays = arrays.unwrap_or_else(|interrupt| {
            step.status = interrupt.into();
            step.contact_stiffness = None;
            Arrays::default()
        });
        let mut findings = engine.findings(&step);
        let parts = engine.parts(&mut self.seen.memory, &step, &findings);
        if job.load.is_history() && parts.leaves_unknown {
            self.seen.unknown = left_unknown(self.seen.unknown, &findings);
        }
        self.seen.see(&step, &parts);
        // A stopped job may end with preliminary steps of a coarser mesh, after steps of the
        // requested mesh. The report describes the requested mesh if it has any step.
        if !step.is_preliminary || self.seen.mesh.nodes == 0 {
            let enlargements = self.seen.mesh.enlargements + step.enlargements;
            self.seen.mesh = MeshReport { enlargements, ..engine.mesh(&step) };
        }
        let Parts { mut known, measured, indentation, .. } = parts;
        self.seen.hardness.see(indentation);
        for (zone, cover) in known.zones.iter_mut().zip(arrays.covers) {
            if let Some(zone) = zone {
                zone.cover = zone.cover.or(cover);
            }
        }
        known.fatigue.extend(arrays.fatigue);
        let force = step.figures.force;
        let is_dented = is_dented(self.seen.dented_under, force);
        let measured = Measured { is_dented, ..measured };
        let has_yielded = known.zones.iter().flatten().any(|zone| zone.yielded);
        if known.flow.is_some()
            && job.load.is_history()
            && has_yielded
            && !step.status.is_stopped()
        {
            self.seen.dented_under = self.seen.dented_under.max(force);
        }
        let facts = Facts { job, known: &known, measured: &measured, findings: &findings, write };
        let answers = facts.rows();
        let verdict = facts.verdict(&answers);
        let verdict = self.seen.hardness.before(verdict, job, write);
        let fatigue = facts.curves_of_fatigue(&answers);
        let of_fatigue = facts.remarks_on_fatigue(&answers);
        findings.extend(of_fatigue);
        StepReport {
            load: match step.load {
                ContactLoad::Force(force) => LoadReport::Force(write.force(force)),
                ContactLoad::Approach(approach) => LoadReport::Approach(write.length(approach)),
            },
            status: step.status,
            verdict,
            answers,
            contact: parts.contact,
            increments: parts.increments,
            surfaces: parts.surfaces,
            subsurface: arrays.subsurface,
            subsurface_below_peak: arrays.below_peak,
            plasticity: arrays.plasticity,
            shakedown: parts.shakedown,
            passes: parts.passes,
            rules: parts.rules,
            validity: validity::remarks(&findings, write),
            fatigue,
            fields: arrays.fields,
            layers: arrays.layers,
            history: step.history.iter().map(|record| in_units(record, write)).collect(),
        }
    }

    /// Returns the report without its load steps.
    fn finish(self, solved: &Solved, elapsed: Duration) -> Report {
        let Self { engine, write, seen, time, .. } = self;
        let job = engine.job();
        let interrupted = solved.interrupted.map(SolveStatus::from);
        let status =
            interrupted.map_or(seen.status, |interrupted| worse(seen.status, interrupted));
        let of_target = seen.target.rows(job, solved.sensitivity, write);
        let answers = seen.hardness.rows(job, write).into_iter().chain(of_target).collect();
        Report {
            units: job.units.name().to_owned(),
            analysis: job.analysis.name().to_owned(),
            theory: job.theory().map(|theory| theory.name().to_owned()),
            status: status.unwrap_or(SolveStatus::Cancelled),
            steps: Vec::new(),
            answers,
            load_approach: load_approach::of_job(job, seen.curve, write),
            validity: seen.hardness.remarks(job, write),
            found: None,
            tolerances: None,
            mesh: MeshReport { passes: solved.passes, ..seen.mesh },
            timings_ms: timings(&solved.phases, elapsed, time),
            tags: job.tags.clone(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
        }
    }
}

impl<M> Seen<M> {
    /// Records status, target and the points of the load–approach curve.
    fn see<F>(&mut self, step: &Step<F>, parts: &Parts) {
        let Figures { approach, force, half_width, .. } = step.figures;
        self.status = worse(self.status, step.status);
        if let Some((reached, error)) = parts.target {
            self.target.take(force, reached, error);
        }
        if let Some(spacing) = parts.spacing.filter(|_| step.status == SolveStatus::Converged) {
            let (end, increments) = ([approach, force, half_width], &step.path.increments);
            self.curve.extend(load_approach::points(
                increments,
                end,
                spacing,
                parts.known.stiffness,
            ));
        }
    }
}

/// Returns the worse of two statuses.
fn worse(one: Option<SolveStatus>, other: SolveStatus) -> Option<SolveStatus> {
    let rank = |status: &SolveStatus| match status {
        SolveStatus::Converged => 0,
        SolveStatus::NotConverged => 1,
        SolveStatus::TimedOut => 2,
        SolveStatus::Cancelled => 3,
    };
    one.into_iter().chain([other]).max_by_key(rank)
}

/// Returns an iteration in the units of the job.
pub(super) fn in_units(record: &IterationRecord, write: UnitConverter) -> IterationRecord {
    IterationRecord {
        approach: write.figure(Quantity::Length, record.approach),
        peak_pressure: write.stress(record.peak_pressure),
        ..record.clone()
    }
}

fn timings(phases: &PhaseTimes, total: Duration, report: Duration) -> Timings {
    let ms = |duration: Duration| 1e3 * duration.as_secs_f64();
    Timings {
        total: ms(total),
        mesh: ms(phases.spent(Phase::Mesh)),
        assembly: ms(phases.spent(Phase::Assembly)),
        ordering: ms(phases.spent(Phase::Ordering)),
        symbolic: ms(phases.spent(Phase::Symbolic)),
        numeric: ms(phases.spent(Phase::Numeric)),
        flexibility: ms(phases.spent(Phase::Flexibility)),
        contact: ms(phases.spent(Phase::Contact)),
        plasticity: ms(phases.spent(Phase::Plasticity)),
        solves: ms(phases.spent(Phase::Solves)),
        output: ms(phases.spent(Phase::Output) + report),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inputs::{self, meshed_contact};
    use crate::job::{Job, MeshSettings};
    use crate::report::meshed::Meshed;
    use crate::solver::Unobserved;

    #[test]
    fn numbers_begin_anew_with_a_history() {
        let job =
            Job::from_json(include_bytes!("../../../../api/examples/two_cylinders.json")).unwrap();
        let job = Job { mesh: MeshSettings::default().with_elements(4), ..job };
        let step = inputs::run(&job, &mut Unobserved).unwrap().steps.remove(0);
        let mut numbers = Vec::new();
        let mut on_step = |number, _| numbers.push(number);
        let engine = Meshed::new(&job, meshed_contact(&job));
        let mut writer = StepWriter::new(&engine, &mut on_step);
        for anew in [false, false, true, false] {
            if anew {
                writer.begin_anew();
            }
            writer.step(step.clone(), &mut Unobserved);
        }
        assert_eq!(numbers, [0, 1, 0, 1]);
    }
}
