//! Builds the report of a solution load step by load step.

use std::time::Duration;

use super::answers::{Measured, is_dented};
use super::datum::Datum;
use super::findings::{Finding, left_unknown};
use super::hardness::HardnessSeen;
use super::load_approach::CurvePoint;
use super::measured::measured;
use super::target::TargetSeen;
use super::{
    ErrorEstimate, FieldsReport, HertzReport, LoadReport, MeshReport, PerBody, PlasticityReport,
    Report, ShakedownLimit, StepReport, SubsurfaceReport, Timings, contact, error_bars, fields,
    flow, load_approach, onset, plastic_zone, subsurface, validity,
};
use crate::analytical::DepthLimit;
use crate::contact::ContactLoad;
use crate::job::{Job, Named, Quantity};
use crate::solver::method::figures::FigureSet;
use crate::solver::method::observer::ask;
use crate::solver::{
    BodySolution, ElasticReference, Interrupt, IterationRecord, Observer, Phase, PhaseTimes,
    Problem, Solution, SolveStatus, StepSolution, has_yielded,
};
use crate::units::UnitConverter;

/// Writes the report of each load step when the step ends, and the rest of the report at the end.
pub(super) struct ReportBuilder<'a> {
    job: &'a Job,
    problem: &'a Problem,
    write: UnitConverter,
    status: Option<SolveStatus>,
    /// Points of the converged load steps.
    curve: Vec<CurvePoint>,
    /// Largest force so far that has left plastic strain in a history.
    dented_under: f64,
    /// Figures of the bodies that the loads of the history so far have left unknown.
    unknown: FigureSet,
    target: TargetSeen,
    hardness: HardnessSeen,
    /// The mesh of the last load step.
    mesh: MeshReport,
    /// Limits of shakedown over friction, which every load step repeats.
    over_friction: Option<Vec<ShakedownLimit>>,
    /// Time spent on reports.
    time: Duration,
}

impl<'a> ReportBuilder<'a> {
    pub(super) fn new(job: &'a Job, problem: &'a Problem) -> Self {
        let write = UnitConverter::new(job.units, job.analysis);
        Self {
            job,
            problem,
            write,
            status: None,
            curve: Vec::new(),
            dented_under: 0.0,
            unknown: FigureSet::default(),
            target: TargetSeen::default(),
            hardness: HardnessSeen::default(),
            mesh: MeshReport::NONE,
            over_friction: None,
            time: Duration::ZERO,
        }
    }

    /// Discards all load steps so far and keeps the time that their reports took.
    pub(super) fn begin_anew(&mut self) {
        *self = Self { time: self.time, ..Self::new(self.job, self.problem) };
    }

    /// Returns the report of the next load step. If the observer interrupts the report, the load
    /// step gets the status of the interrupt.
    pub(super) fn step(
        &mut self,
        mut step: StepSolution,
        observer: &mut dyn Observer,
    ) -> StepReport {
        let start = observer.elapsed();
        step.path.unknown_before = self.unknown;
        let fields = FieldReports::of(self.job, &step, self.write, observer);
        let fields = fields.unwrap_or_else(|interrupt| {
            step.status = interrupt.into();
            step.contact_stiffness = None;
            FieldReports::NONE
        });
        let step = &step;
        let reference = ElasticReference::of(self.problem, step.figures.force);
        let mut findings = validity::findings(self.job, self.problem, step, reference.as_ref());
        let bars = error_bars::estimate(self.job, step, &findings);
        let approach_bar = bars.and_then(|bars| bars.approach);
        findings.extend(validity::small_approach(step, approach_bar));
        self.status = worse(self.status, step.status);
        if step.status == SolveStatus::Converged {
            if self.job.load.is_history() {
                self.unknown = left_unknown(self.unknown, &findings);
            }
            let (half_width, stiffness) = (step.figures.half_width, step.contact_stiffness);
            let end = [step.figures.approach, step.figures.force, half_width];
            self.curve.extend(load_approach::points(
                &step.path.increments,
                end,
                step.field.spacing,
                stiffness,
            ));
        }
        // A stopped job may end with preliminary steps of a coarser mesh, after steps of the
        // requested mesh. The report describes the requested mesh if it has any step.
        if !step.is_preliminary || self.mesh.nodes == 0 {
            let enlargements = self.mesh.enlargements + step.enlargements;
            self.mesh = MeshReport { enlargements, ..mesh_report(step, self.write) };
        }
        self.target.see(self.job, step, &findings);
        self.hardness.see(self.job, step, &findings);
        let measured = Measured {
            is_dented: is_dented(self.dented_under, step.figures.force),
            datum: Datum::of(self.job, self.write),
            ..measured(self.job, self.problem, step, reference.as_ref(), &findings)
        };
        if step.path.energy.is_some()
            && self.job.load.is_history()
            && step.field.bodies.iter().flatten().any(|body| body.has_yielded())
        {
            self.dented_under = self.dented_under.max(step.figures.force);
        }
        let over_friction = reference.as_ref().map(|reference| {
            let limits =
                || over_friction(&reference.limits_over_friction(self.problem), self.write);
            &**self.over_friction.get_or_insert_with(limits)
        });
        let over_friction = over_friction.unwrap_or_default();
        let judged = Judged { reference, over_friction, bars, findings: &findings };
        let report = step_report((self.job, self.problem), step, judged, fields, self.write);
        let report = report.answered(self.job, &measured, &findings, self.write).with_hardness(
            self.job,
            &self.hardness,
            self.write,
        );
        self.time += observer.elapsed().saturating_sub(start);
        report
    }

    /// Returns the report without its load steps.
    pub(super) fn finish(self, solution: &Solution, observer: &dyn Observer) -> Report {
        let Self { job, write, status, curve, target, hardness, mesh, time, .. } = self;
        let interrupted = solution.interrupted.map(SolveStatus::from);
        let status = interrupted.map_or(status, |interrupted| worse(status, interrupted));
        Report {
            units: job.units.name().to_owned(),
            analysis: job.analysis.name().to_owned(),
            theory: job.theory().map(|theory| theory.name().to_owned()),
            status: status.unwrap_or(SolveStatus::Cancelled),
            steps: Vec::new(),
            load_approach: load_approach::of_job(job, curve, write),
            target: target.finish(job, solution.sensitivity, write),
            hardness: hardness.finish(job, write),
            mesh: MeshReport { passes: solution.passes, ..mesh },
            timings_ms: timings(&solution.phases, observer.elapsed(), time),
            tags: job.tags.clone(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
        }
    }
}

/// Returns the worse of two statuses.
pub(super) fn worse(one: Option<SolveStatus>, other: SolveStatus) -> Option<SolveStatus> {
    let rank = |status: &SolveStatus| match status {
        SolveStatus::Converged => 0,
        SolveStatus::NotConverged => 1,
        SolveStatus::TimedOut => 2,
        SolveStatus::Cancelled => 3,
    };
    one.into_iter().chain([other]).max_by_key(rank)
}

/// Parts of a report that need the stresses in the bodies.
struct FieldReports {
    subsurface: [Option<PerBody<Option<SubsurfaceReport>>>; 2],
    plasticity: PerBody<Option<PlasticityReport>>,
    fields: Option<PerBody<Option<FieldsReport>>>,
}

impl FieldReports {
    /// No parts, for a stopped job: their computation would keep its core busy.
    const NONE: Self = Self {
        subsurface: [None, None],
        plasticity: PerBody { upper: None, lower: None },
        fields: None,
    };

    fn of(
        job: &Job,
        step: &StepSolution,
        write: UnitConverter,
        observer: &mut dyn Observer,
    ) -> Result<Self, Interrupt> {
        if step.status.is_stopped() {
            return Ok(Self::NONE);
        }
        let mut reports = Self::NONE;
        if job.output.subsurface {
            let mut at = |x: f64| {
                PerBody::try_of(step, |body| {
                    ask(observer)?;
                    Ok(subsurface::profile(step, body, x, write))
                })
            };
            let below_peak =
                subsurface::is_beside_middle(step).then(|| at(step.field.peak_position));
            reports.subsurface = [Some(at(step.field.middle)?), below_peak.transpose()?];
        }
        reports.plasticity = PerBody::try_of(step, |body| {
            ask(observer)?;
            Ok(plasticity_report(body, step.field.symmetric, write))
        })?;
        if job.output.fields {
            reports.fields = Some(fields::fields(step, write, observer)?);
        }
        Ok(reports)
    }
}

/// The elastic reference, the error bars and the findings of a load step.
struct Judged<'a> {
    reference: Option<ElasticReference>,
    over_friction: &'a [ShakedownLimit],
    bars: Option<ErrorEstimate>,
    findings: &'a [Finding],
}

fn step_report(
    (job, problem): (&Job, &Problem),
    step: &StepSolution,
    Judged { reference, over_friction, bars, findings }: Judged<'_>,
    fields: FieldReports,
    write: UnitConverter,
) -> StepReport {
    let FieldReports { subsurface: [subsurface, subsurface_below_peak], plasticity, fields } =
        fields;
    StepReport {
        verdict: None,
        answers: Vec::new(),
        load: match step.load {
            ContactLoad::Force(force) => LoadReport::Force(write.force(force)),
            ContactLoad::Approach(approach) => LoadReport::Approach(write.length(approach)),
        },
        status: step.status,
        approach: Some(write.length(step.figures.approach)),
        approach_datum: Datum::of(job, write).to_string(),
        contact: contact::report(step, write),
        contact_stiffness: step.contact_stiffness.map(|slope| write.stiffness(slope)),
        flow: flow::flow(step, write),
        subsurface,
        subsurface_below_peak,
        plasticity,
        hertz: reference.as_ref().map(|reference| hertz(reference, over_friction, write)),
        validity: validity::remarks(findings, write),
        yield_onset: onset::onset((job, problem), step, findings, write),
        estimated_error: bars,
        fields,
        layers: None,
        three_dimensional: None,
        rolling: None,
        history: step.history.iter().map(|record| in_units(record, write)).collect(),
    }
}

/// Returns the elastic contact in closed form.
pub(super) fn hertz(
    reference: &ElasticReference,
    over_friction: &[ShakedownLimit],
    write: UnitConverter,
) -> HertzReport {
    HertzReport {
        half_width: write.length(reference.half_width),
        peak_pressure: write.stress(reference.peak_pressure),
        yield_onset_force: reference.yield_onset_force.map(|force| write.force(force)),
        yield_onset_depth: reference.yield_onset_depth.map(|depth| write.length(depth)),
        shakedown_pressure: reference.rolling_limit.map(|limit| write.stress(limit.peak_pressure)),
        shakedown_depth: reference.rolling_limit.map(|limit| write.length(limit.depth)),
        shakedown_over_friction: over_friction.to_vec(),
    }
}

/// Returns the limits of shakedown over friction of a job.
pub(super) fn over_friction(
    limits: &[(f64, DepthLimit)],
    write: UnitConverter,
) -> Vec<ShakedownLimit> {
    let limit = |&(friction, limit): &(f64, DepthLimit)| ShakedownLimit {
        friction,
        pressure: write.stress(limit.peak_pressure),
        depth: write.length(limit.depth),
    };
    limits.iter().map(limit).collect()
}

fn plasticity_report(
    solution: &BodySolution,
    symmetric: bool,
    write: UnitConverter,
) -> PlasticityReport {
    let points = || solution.stress.points.iter().flatten();
    let (mut highest, mut position) = (0.0, [0.0; 2]);
    for point in points() {
        if point.equivalent_plastic_strain > highest {
            (highest, position) = (point.equivalent_plastic_strain, point.position);
        }
    }
    let [place, depth] = solution.mesh.frame.place(position);
    let zone = plastic_zone::outline(solution, symmetric);
    let written =
        |polygon: &Vec<[f64; 2]>| polygon.iter().map(|p| p.map(|x| write.length(x))).collect();
    PlasticityReport {
        yielded: points().any(has_yielded),
        max_equivalent_plastic_strain: solution.bounded_plastic_strain(),
        mean_equivalent_plastic_strain: solution.mean_plastic_strain(),
        position: write.length(place),
        depth: write.length(depth),
        area: write.area(solution.plastic_area(symmetric)),
        reached_surface: zone.reached_surface,
        outline: zone.outline.iter().map(written).collect(),
        position_y: None,
        volume: None,
    }
}

/// Returns an iteration in the units of the job.
pub(super) fn in_units(record: &IterationRecord, write: UnitConverter) -> IterationRecord {
    IterationRecord {
        approach: write.figure(Quantity::Length, record.approach),
        peak_pressure: write.stress(record.peak_pressure),
        ..record.clone()
    }
}

/// Returns the mesh of one load step.
fn mesh_report(step: &StepSolution, write: UnitConverter) -> MeshReport {
    let bodies = || step.field.bodies.iter().flatten();
    let quality = bodies().map(|body| body.quality);
    MeshReport {
        symmetric: step.field.symmetric,
        spacing: write.length(step.field.spacing),
        contact_pairs: step.field.pairs.len(),
        nodes: bodies().map(|body| body.mesh.nodes.len()).sum(),
        elements: bodies().map(|body| body.mesh.elements.len()).sum(),
        equations: bodies().map(|body| body.equations).sum(),
        min_jacobian_ratio: quality.clone().map(|q| q.min_jacobian_ratio).fold(1.0, f64::min),
        max_aspect_ratio: quality.map(|q| q.max_aspect_ratio).fold(1.0, f64::max),
        ..MeshReport::NONE
    }
}

pub(super) fn timings(phases: &PhaseTimes, total: Duration, report: Duration) -> Timings {
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
