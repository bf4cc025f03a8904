//! Entry points of the service and the command line: they estimate, solve and report a job.

use std::ops::ControlFlow;
use std::time::Duration;

use serde::Serialize;
use thiserror::Error;

use super::build::{ReportBuilder, in_units};
use super::findings::CONFORMING_ADVICE;
use super::validity::lies_in_groove;
use super::{Report, StepReport, half_spaces, rolling, solve_error, target};
use brinell_halfspace::track::TrackFault;

use crate::contact::ContactError;
use crate::fem::mesh::MeshError;
use crate::inputs::SolveError::{self, HalfSpaces, Meshed, Track};
use crate::inputs::{self, meshed_contact, of_small_mesh, small_solves};
use crate::job::{Analysis, FieldError, Job, Load, Material, Named as _, Shape};
use crate::solver::half_spaces::HalfSpaceError;
use crate::solver::method;
use crate::solver::rolling::TrackError;
use crate::solver::{
    self, Estimate, Held, Interrupt, IterationRecord, MeshedError, Observer, Options,
    SectionField, StepReceiver, StepSolution,
};
use crate::units::UnitConverter;

/// Reasons for a job without a report.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RunError {
    /// The job is well formed but describes a contact that the theory does not cover.
    #[error("{}", summary(.0))]
    Input(Vec<FieldError>),
    /// The observer stopped the job before the first report.
    #[error("stopped before the first iteration")]
    Interrupted(Interrupt),
    /// The solver failed.
    #[error("{0}")]
    Failed(String),
}

fn summary(errors: &[FieldError]) -> String {
    errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

impl RunError {
    /// Returns the error of a job and names the fields that cause it.
    pub(super) fn of(job: &Job, error: impl Into<SolveError>) -> Self {
        let error = &error.into();
        let sides = [("upper", &job.upper), ("lower", &job.lower)];
        // Surfaces given by points: of deformable bodies or of all bodies.
        let faces = |deformable: bool| -> Vec<String> {
            let faces = sides.iter().filter(|(_, body)| {
                let is_rigid = matches!(body.material, Material::Rigid);
                matches!(body.shape, Shape::Profile(_)) && !(deformable && is_rigid)
            });
            faces.map(|(side, _)| format!("/{side}/shape/points")).collect()
        };
        let sought = || match &job.load {
            Load::Target(target) => format!("/load/target/{}", target.figure.name()),
            _ => "/load/onset".to_owned(),
        };
        let pointers = match error {
            error if error.method().is_some() => match error.method() {
                Some(method::Error::Interrupted(interrupt)) => {
                    return Self::Interrupted(*interrupt);
                }
                Some(method::Error::NoLoad) => vec![format!("/load/{}", job.load.kind())],
                Some(method::Error::Unreachable(_)) => vec![sought()],
                _ => Vec::new(),
            },
            Meshed(
                MeshedError::TooWide { .. }
                | MeshedError::TooFarRound { .. }
                | MeshedError::Mesh(MeshError::ZoneBeyondBody { .. }),
            ) => vec!["/load".to_owned()],
            HalfSpaces(HalfSpaceError::Overloaded { .. }) => {
                vec![format!("/load/{}", job.load.kind())]
            }
            HalfSpaces(HalfSpaceError::ShortRoller { .. }) => {
                let rollers =
                    sides.iter().filter(|(_, body)| matches!(body.shape, Shape::Roller(_)));
                rollers.map(|(side, _)| format!("/{side}/shape/length")).collect()
            }
            Meshed(MeshedError::NoYieldPoint) | HalfSpaces(HalfSpaceError::NoYieldPoint) => {
                vec![sought()]
            }
            Track(TrackError::Track(TrackFault::Traction { .. })) => {
                vec!["/load/rolling/friction".to_owned()]
            }
            Track(TrackError::NoTrack | TrackError::NoRaceway(_))
            | Meshed(MeshedError::Conforming { .. } | MeshedError::TouchesAtEnd { .. }) => {
                sides.map(|(side, _)| format!("/{side}/shape")).to_vec()
            }
            Meshed(MeshedError::AmbiguousCorner { side, .. }) => {
                let side = if *side == 0 { "upper" } else { "lower" };
                vec![format!("/{side}/shape/interpolation")]
            }
            Meshed(MeshedError::TraceTooFine { .. }) => {
                let radii = sides.iter().filter_map(|(side, body)| match body.shape {
                    Shape::Punch(_) => Some(format!("/{side}/shape/edge_radius")),
                    Shape::Wedge(_) | Shape::Cone(_) => Some(format!("/{side}/shape/tip_radius")),
                    _ => None,
                });
                faces(false).into_iter().chain(radii).collect()
            }
            Meshed(MeshedError::Mesh(MeshError::TooSteep { .. })) => faces(true),
            _ => Vec::new(),
        };
        let write = UnitConverter::new(job.units, job.analysis);
        let detail = match error {
            Meshed(MeshedError::TooWide { .. } | MeshedError::Conforming { .. })
                if lies_in_groove(job) =>
            {
                format!("{}; {CONFORMING_ADVICE}", solve_error::text(error, write))
            }
            error => match error.method() {
                Some(method::Error::Unreachable(found)) => {
                    target::unreachable(found, &job.load, write)
                }
                // The author of the job cannot act on errors from inside the contact solver.
                Some(method::Error::Contact(
                    ContactError::NotPositiveDefinite { .. }
                    | ContactError::NoEnergy { .. }
                    | ContactError::Ray { .. }
                    | ContactError::IllConditioned { .. },
                )) => {
                    "rounding leaves the contact without an answer: lengths, stiffness and load \
                       of the job differ by too many orders of magnitude for numbers of double \
                       precision"
                        .to_owned()
                }
                _ => solve_error::text(error, write),
            },
        };
        if pointers.is_empty() {
            return Self::Failed(detail);
        }
        Self::Input(
            pointers
                .into_iter()
                .map(|pointer| FieldError::not_solvable(pointer, detail.clone()))
                .collect(),
        )
    }
}

/// What a job will cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Estimate))]
pub struct JobEstimate {
    /// Equations of both bodies.
    pub equations: usize,
    /// Peak memory \[bytes\], the fields of a step while they are handed over included.
    pub bytes: u64,
    /// The result of all steps as it is kept \[bytes\].
    pub result_bytes: u64,
    /// How much work it is, in units of its own: to weigh jobs against each other.
    #[serde(skip)]
    pub work: u64,
}

/// Estimates the cost of a job without meshing it.
///
/// # Errors
/// The fields of the job that describe a contact outside the theory.
pub fn preflight(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    if let Load::Rolling(_) = job.load {
        return rolling::preflight(job);
    }
    if job.analysis == Analysis::ThreeDimensional {
        return half_spaces::preflight(job);
    }
    match inputs::estimate(job).map_err(|error| RunError::of(job, error)) {
        Ok(estimate) => Ok(with_result(job, estimate)),
        Err(RunError::Input(errors)) => Err(errors),
        Err(other) => Err(vec![FieldError::not_solvable("", other.to_string())]),
    }
}

/// Bytes that every job takes: the heap of a thread, in pages of 2 MiB, and buffers of the load
/// steps that are being written to the result.
pub(super) const SOLVER_BYTES: u64 = 56 << 20;
/// Bytes per node of the fields of a load step: ten numbers and the corners of an element.
const FIELD_BYTES: u64 = 96;
/// Copies of the fields while a load step is written, encoded and stored.
pub(super) const FIELD_COPIES: u64 = 6;
/// Bytes of the compressed report of a load step without fields and contact nodes.
pub(super) const STEP_BYTES: u64 = 8 << 10;
/// Bytes that each element over the half-width adds to the report, by its contact nodes.
const STEP_BYTES_PER_ELEMENT: u64 = 832;

/// Bytes per node of an increment of flow theory. The solver keeps displacements of the coarse
/// mesh, with a quarter of the nodes, for this number of increments and for twice the number.
const INCREMENT_BYTES: u64 = 16 * (1 + 2) / 4;
/// Bytes of an increment and its iterations in the report.
pub(super) const REPORTED_INCREMENT_BYTES: u64 = 1024;
/// Increments that the solver chooses itself: in total up to the largest load, and for each load.
const CHOSEN_INCREMENTS: [u64; 2] = [32, 2];

/// Memory of a job \[bytes\] whose load step counts as one unit of work.
const WORK_UNIT: u64 = 1 << 16;

/// Mesh solves of a search for a load. Coarser meshes count by their share of the work.
const SEARCH_SOLVES: u64 = 4;

/// Returns the number of load steps of a job and of their mesh solves.
pub(super) fn steps_and_solves(job: &Job) -> [u64; 2] {
    match &job.load {
        Load::Forces(sweep) | Load::Approaches(sweep) => [sweep.iter().count() as u64; 2],
        Load::History(history) => [history.iter().count() as u64; 2],
        // One load step under the force and one after its removal.
        Load::Target(target) if target.figure.is_permanent() => [2, 2 * SEARCH_SOLVES],
        Load::Rolling(rolling) => [1, rolling.passes.into()],
        Load::Onset | Load::Target(_) => [1, SEARCH_SOLVES],
    }
}

/// Returns the most increments of one load of a history, and those of all `steps`.
pub(super) fn increments_of(job: &Job, steps: u64) -> [u64; 2] {
    let [to_largest, of_load] =
        job.solver.increments.map_or(CHOSEN_INCREMENTS, |of_load| [0, of_load.into()]);
    [to_largest + of_load, to_largest + of_load * steps]
}

/// Adds the memory and work of the result to the estimate of the solver.
fn with_result(job: &Job, estimate: Estimate) -> JobEstimate {
    let [steps, solves] = steps_and_solves(job);
    let increments = if job.has_memory() { increments_of(job, steps)[1] } else { 0 };
    let nodes = estimate.equations as u64 / 2;
    let fields = if job.output.fields { FIELD_BYTES * nodes } else { 0 };
    let step =
        fields + STEP_BYTES + STEP_BYTES_PER_ELEMENT * u64::from(job.mesh.elements_per_half_width);
    let work = (estimate.bytes / WORK_UNIT).max(1);
    JobEstimate {
        equations: estimate.equations,
        bytes: SOLVER_BYTES
            + estimate.bytes
            + of_small_mesh(job, estimate.bytes)
            + FIELD_COPIES * fields
            + increments * (nodes * INCREMENT_BYTES + REPORTED_INCREMENT_BYTES),
        result_bytes: step * steps + increments * REPORTED_INCREMENT_BYTES,
        work: work * solves + of_small_mesh(job, work) * small_solves(job, steps),
    }
}

/// Converts each iteration to the units of the job and passes it to another observer.
struct InUnits<'a> {
    observer: &'a mut dyn Observer,
    write: UnitConverter,
}

impl Observer for InUnits<'_> {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.observer.on_iteration(&in_units(record, self.write))
    }

    fn on_preliminary_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.observer.on_preliminary_iteration(&in_units(record, self.write))
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.observer.on_checkpoint()
    }

    fn on_held(&mut self, part: Held, bytes: usize) -> ControlFlow<Interrupt> {
        self.observer.on_held(part, bytes)
    }

    fn elapsed(&self) -> Duration {
        self.observer.elapsed()
    }
}

/// Solves a job and returns its report. The observer sees iterations in the units of the job.
///
/// # Errors
/// [`RunError`]. A job that does not converge returns a report with that status, not an error.
pub fn run(job: &Job, observer: &mut dyn Observer) -> Result<Report, RunError> {
    run_with(job, Options::default(), observer)
}

/// Solves a job with options, as [`run`].
///
/// # Errors
/// As [`run`].
pub fn run_with(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
) -> Result<Report, RunError> {
    let mut steps = Vec::new();
    let mut on_step = |number, step| {
        steps.truncate(number);
        steps.push(step);
    };
    let report = run_each(job, options, observer, &mut on_step)?;
    Ok(Report { steps, ..report })
}

/// Solves a job as [`run_with`] and passes the report of each load step to `on_step` when the step
/// ends. Steps are numbered from 0. A history that restarts on a wider mesh numbers its steps from
/// 0 again: a step then replaces the earlier step of its number, and all later ones are void. The
/// returned report has no steps.
///
/// # Errors
/// As [`run`].
pub fn run_each(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
) -> Result<Report, RunError> {
    let observer = &mut InUnits { observer, write: UnitConverter::new(job.units, job.analysis) };
    if let Load::Rolling(_) = job.load {
        return rolling::run_each(job, observer, on_step);
    }
    if job.analysis == Analysis::ThreeDimensional {
        return half_spaces::run_each(job, observer, on_step);
    }
    let contact = meshed_contact(job);
    let builder = ReportBuilder::new(job, &contact.problem);
    let mut reports = Reports { builder, number: 0, on_step };
    let solution = solver::run_each(&contact, options, observer, &mut reports)
        .map_err(|error| RunError::of(job, error))?;
    Ok(reports.builder.finish(&solution, observer))
}

/// Reports each load step when it ends, so that failures of later steps do not lose it.
struct Reports<'a> {
    builder: ReportBuilder<'a>,
    /// Number of the next load step.
    number: usize,
    on_step: &'a mut dyn FnMut(usize, StepReport),
}

impl StepReceiver<SectionField> for Reports<'_> {
    fn step(&mut self, step: StepSolution, observer: &mut dyn Observer) {
        let report = self.builder.step(step, observer);
        (self.on_step)(self.number, report);
        self.number += 1;
    }

    fn begin_anew(&mut self) {
        self.number = 0;
        self.builder.begin_anew();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::Unobserved;

    #[test]
    fn numbers_begin_anew_with_a_history() {
        let job =
            Job::from_json(include_bytes!("../../../../api/examples/two_cylinders.json")).unwrap();
        let job = Job { mesh: crate::job::MeshSettings { elements_per_half_width: 4 }, ..job };
        let step = inputs::run(&job, &mut Unobserved).unwrap().steps.remove(0);
        let mut numbers = Vec::new();
        let mut on_step = |number, _| numbers.push(number);
        let problem = meshed_contact(&job).problem;
        let builder = ReportBuilder::new(&job, &problem);
        let mut reports = Reports { builder, number: 0, on_step: &mut on_step };
        for anew in [false, false, true, false] {
            if anew {
                reports.begin_anew();
            }
            reports.step(step.clone(), &mut Unobserved);
        }
        assert_eq!(numbers, [0, 1, 0, 1]);
    }
}
