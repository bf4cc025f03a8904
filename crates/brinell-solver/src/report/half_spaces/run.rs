//! Solving a job in three dimensions, and what that will cost.

use std::time::Duration;

use super::elastic::{EllipticReference, problem_of};
use super::estimate::estimate;
use super::flow::FlowState;
use super::notes::notes;
use super::step::StepWriter;
use crate::job::{FieldError, Job, Load, Named as _, Theory};
use crate::report::build::{timings, worse};
use crate::report::run::RunError;
use crate::report::units::UnitConverter;
use crate::report::{JobEstimate, MeshReport, Report, StepReport, load_approach};
use crate::solver::half_spaces::{self, HalfSpaceStep};
use crate::solver::{Observer, SolveError, SolveStatus, StepReceiver};

/// What a job will cost.
///
/// # Errors
/// The fields that describe what is not solved.
pub fn preflight(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    refuse(job).map_err(|fault| vec![fault])?;
    let problem = problem_of(job).ok_or_else(Vec::new)?;
    estimate(job, &problem).map_err(|error| vec![FieldError::not_solvable("/mesh", error.to_string())])
}

/// Solves a job and hands over the report of each step; the report that is returned has no steps.
pub fn run_each(
    job: &Job,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
) -> Result<Report, RunError> {
    let (Some(problem), Some(reference)) = (problem_of(job), EllipticReference::of(job)) else {
        return Err(RunError::Failed("the shapes are no half-spaces".to_owned()));
    };
    refuse(job).map_err(|fault| RunError::Input(vec![fault]))?;
    let write = UnitConverter::new(job.units, job.analysis);
    let writer = StepWriter { job, write, reference: &reference, orientation: problem.orientation() };
    let mut steps = Steps { writer, on_step, number: 0, seen: Seen::default(), time: Duration::ZERO };
    let done =
        half_spaces::run_each(&problem, observer, &mut steps).map_err(|error| error_of(job, &error))?;
    let Steps { seen, time, .. } = steps;
    let interrupted = done.interrupted.map(SolveStatus::from);
    let status = interrupted.map_or(seen.status, |interrupted| worse(seen.status, interrupted));
    Ok(Report {
        units: job.units.name().to_owned(),
        analysis: job.analysis.name().to_owned(),
        status: status.unwrap_or(SolveStatus::Cancelled),
        steps: Vec::new(),
        load_approach: if job.solver.theory == Theory::Flow {
            load_approach::history(&seen.curve, write)
        } else {
            load_approach::curve(seen.curve, write)
        },
        target: None,
        mesh: MeshReport { passes: done.grids, ..seen.mesh },
        timings_ms: timings(&done.phases, observer.elapsed(), time),
        tags: job.tags.clone(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
    })
}

/// Loads that are sought are not solved.
fn refuse(job: &Job) -> Result<(), FieldError> {
    let pointer = match job.load {
        Load::Onset => "/load/onset".to_owned(),
        Load::Target(target) => format!("/load/target/{}", target.figure.name()),
        _ => return Ok(()),
    };
    let detail = "a force is not sought in three dimensions yet; give `force`, `forces`, `approach`, `approaches` or `history`";
    Err(FieldError::not_solvable(pointer, detail))
}

fn error_of(job: &Job, error: &SolveError) -> RunError {
    match error {
        SolveError::Interrupted(interrupt) => RunError::Interrupted(*interrupt),
        SolveError::NoLoad => RunError::Input(vec![FieldError::not_solvable(
            format!("/load/{}", job.load.kind()),
            error.to_string(),
        )]),
        error => RunError::Failed(error.to_string()),
    }
}

/// What the steps so far have in common.
struct Seen {
    status: Option<SolveStatus>,
    /// Approach, force and contact stiffness of converged steps.
    curve: Vec<[f64; 3]>,
    mesh: MeshReport,
    flow: FlowState,
}

impl Default for Seen {
    fn default() -> Self {
        Self { status: None, curve: Vec::new(), mesh: MeshReport::NONE, flow: FlowState::default() }
    }
}

/// Writes each step as it is finished.
struct Steps<'a> {
    writer: StepWriter<'a>,
    on_step: &'a mut dyn FnMut(usize, StepReport),
    /// Of the next step.
    number: usize,
    seen: Seen,
    /// Time spent on reports.
    time: Duration,
}

impl StepReceiver<HalfSpaceStep> for Steps<'_> {
    fn step(&mut self, step: HalfSpaceStep, observer: &mut dyn Observer) {
        let start = observer.elapsed();
        let StepWriter { job, write, reference, .. } = self.writer;
        let seen = &mut self.seen;
        seen.status = worse(seen.status, step.status);
        seen.mesh = mesh_report(&step, write, seen.mesh.enlargements);
        let flow = seen.flow.report(job, &step, reference, write);
        let report = self.writer.report(&step, flow, notes(job, &step, write));
        if step.status == SolveStatus::Converged {
            let stiffness = report.contact_stiffness / write.stiffness(1.0);
            seen.curve.extend(step.increments.iter().map(|end| [end.approach, end.force, 0.0]));
            if step.increments.is_empty() {
                seen.curve.push([step.figures.approach, step.figures.force, stiffness]);
            }
        }
        self.time += observer.elapsed().saturating_sub(start);
        (self.on_step)(self.number, report);
        self.number += 1;
    }

    fn begin_anew(&mut self) {
        self.number = 0;
        self.seen = Seen::default();
    }
}

fn mesh_report(step: &HalfSpaceStep, write: UnitConverter, enlargements: usize) -> MeshReport {
    let grid = &step.surface.grid;
    let cells = grid.n_cells();
    let bodies = || step.bodies.iter().flatten();
    let of_bodies: usize = bodies().map(|body| cells * body.layers.len()).sum();
    MeshReport {
        spacing: write.length(grid.hx()),
        contact_pairs: cells,
        nodes: cells,
        elements: of_bodies,
        equations: cells + bodies().map(|body| 5 * body.equivalent_plastic_strain.len()).sum::<usize>(),
        enlargements: enlargements + step.enlargements,
        max_aspect_ratio: (grid.hy() / grid.hx()).max(grid.hx() / grid.hy()),
        ..MeshReport::NONE
    }
}
