//! The contact stiffness of bodies that yield: by how much the force grows with the approach.
//!
//! The load-approach curve of a mesh has corners. So the same job is solved under a smaller and
//! under a larger load, on small meshes that are sized by their contacts and end alike: their
//! errors cancel in the difference.

use std::ops::ControlFlow;
use std::time::Duration;

use super::plastic_strain;
use super::run::{RunError, run_with};
use crate::contact::ContactLoad;
use crate::fem::element::StressState;
use crate::job::{
    Analysis, History, HistoryLoad, Job, Load, MeshSettings, NonNegativeF64, OutputSettings,
    Theory, Units,
};
use crate::solver::{Interrupt, Observer, Options, SolveStatus, StepSolution};

/// Smaller and larger load over that of a step.
const LESS_AND_MORE: [f64; 2] = [0.95, 1.05];
/// Elements over the half-width of the small meshes, and cells over the semi-axes of small grids.
const ELEMENTS: u32 = 12;
const CELLS: u32 = 8;
/// Relative error of the slope; in plane stress, where plastic flow gathers in bands.
pub(super) const ERROR: f64 = 0.02;
pub(super) const PLANE_STRESS_ERROR: f64 = 0.05;

/// Elements over the half-width of the small meshes of a job.
fn small(job: &Job) -> u32 {
    let most = if job.analysis == Analysis::ThreeDimensional { CELLS } else { ELEMENTS };
    job.mesh.elements_per_half_width.min(most)
}

/// What small meshes take of what a mesh of the job's own takes, of memory or of the work of one
/// solve; nothing where they are not made.
pub(super) fn of_small_mesh(job: &Job, own: u64) -> u64 {
    let dimensions = if job.analysis == Analysis::ThreeDimensional { 3 } else { 2 };
    let of = |elements: u32| u64::from(elements).pow(dimensions);
    if job.output.contact_stiffness {
        own * of(small(job)) / of(job.mesh.elements_per_half_width)
    } else {
        0
    }
}

/// Small meshes that are solved for so many steps: under flow theory each with the loads before.
pub(super) fn small_solves(job: &Job, steps: u64) -> u64 {
    let is_history = job.solver.theory == Theory::Flow;
    if is_history { steps * (steps + 1) } else { 2 * steps }
}

/// What has to be known of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    pub load: ContactLoad,
    /// Force and approach \[N/mm or N, mm\].
    pub reached: [f64; 2],
    /// Whether it has a contact stiffness that is not known yet.
    pub is_unknown: bool,
}

impl Seen {
    pub fn of(step: &StepSolution) -> Self {
        let flows_freely = step.stress_state == StressState::PlaneStress
            && step.bodies.iter().flatten().any(|body| plastic_strain::largest(body).is_none());
        let is_converged = step.status == SolveStatus::Converged;
        Self {
            load: step.load,
            reached: [step.force(), step.approach],
            is_unknown: is_converged && step.contact_stiffness.is_none() && !flows_freely,
        }
    }
}

/// The contact stiffness of step after step of one job.
pub(super) struct LoadDifferences<'a> {
    job: &'a Job,
    pub options: Options<'a>,
    /// The loads before, under flow theory.
    loads: Vec<ContactLoad>,
    /// Largest force and approach of them.
    largest: [f64; 2],
}

impl<'a> LoadDifferences<'a> {
    pub fn new(job: &'a Job, options: Options<'a>) -> Self {
        Self { job, options, loads: Vec::new(), largest: [0.0; 2] }
    }

    /// Takes note of the next step, and gives dP/dα if that is not known and the job asks for it
    /// \[N/mm per mm, or N per mm\]. `None` where a small mesh has no answer.
    ///
    /// # Errors
    /// Why the observer stopped it.
    pub fn next(
        &mut self,
        step: Seen,
        observer: &mut dyn Observer,
    ) -> Result<Option<f64>, Interrupt> {
        let is_wanted = self.job.output.contact_stiffness && step.is_unknown;
        let slope = if is_wanted { self.slope(step.load, observer) } else { Ok(None) };
        if self.job.solver.theory == Theory::Flow {
            self.loads.push(step.load);
            self.largest = [0, 1].map(|k| self.largest[k].max(step.reached[k]));
        }
        slope
    }

    fn slope(
        &self,
        load: ContactLoad,
        observer: &mut dyn Observer,
    ) -> Result<Option<f64>, Interrupt> {
        // Below the largest load so far bodies are elastic.
        let [less, more] = LESS_AND_MORE.map(|factor| match load {
            ContactLoad::Force(force) => ContactLoad::Force((factor * force).max(self.largest[0])),
            ContactLoad::Approach(by) => ContactLoad::Approach((factor * by).max(self.largest[1])),
        });
        let ends = (self.under(less, observer)?, self.under(more, observer)?);
        let slope = |(less, more): ([f64; 2], [f64; 2])| (more[0] - less[0]) / (more[1] - less[1]);
        Ok(ends.0.zip(ends.1).map(slope).filter(|slope| slope.is_finite() && *slope > 0.0))
    }

    /// Force and approach in place of the next step under another load.
    fn under(
        &self,
        load: ContactLoad,
        observer: &mut dyn Observer,
    ) -> Result<Option<[f64; 2]>, Interrupt> {
        let Some(job) = self.auxiliary(load) else { return Ok(None) };
        match run_with(&job, self.options, &mut Silent(observer)) {
            Err(RunError::Interrupted(interrupt)) => Err(interrupt),
            Err(_) => Ok(None),
            Ok(report) => {
                report.status.interrupt().map_or(Ok(()), Err)?;
                let last = report.steps.last().filter(|_| report.status == SolveStatus::Converged);
                Ok(last.and_then(|step| Some([step.contact.force, step.approach?])))
            }
        }
    }

    /// The same job up to another load in place of the next step, on a small mesh.
    fn auxiliary(&self, load: ContactLoad) -> Option<Job> {
        let written = |load| match load {
            ContactLoad::Force(force) => NonNegativeF64::new(force).map(HistoryLoad::Force),
            ContactLoad::Approach(approach) => {
                NonNegativeF64::new(approach).map(HistoryLoad::Approach)
            }
        };
        let loads: Result<_, _> = self.loads.iter().copied().chain([load]).map(written).collect();
        Some(Job {
            load: Load::History(History::new(loads.ok()?).ok()?),
            units: Units::MmNMpa,
            mesh: MeshSettings { elements_per_half_width: small(self.job) },
            output: OutputSettings { subsurface: false, fields: false, contact_stiffness: false },
            ..self.job.clone()
        })
    }
}

/// Lets a solve be stopped but not seen. It holds less than the job does.
struct Silent<'a>(&'a mut dyn Observer);

impl Observer for Silent<'_> {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.0.on_checkpoint()
    }

    fn elapsed(&self) -> Duration {
        self.0.elapsed()
    }
}
