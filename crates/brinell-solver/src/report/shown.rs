//! What an engine shows of its steps. All else of a report is written once, by
//! [`step`](super::step).

use super::answers::Measured;
use super::cost::JobEstimate;
use super::fatigue::BodyFatigue;
use super::findings::Finding;
use super::hardness::Seen;
use super::known::Known;
use super::{
    ContactReport, FieldsReport, IncrementsReport, LayersReport, MeshReport, PassesReport,
    PerBody, PlasticityReport, RuleVerdict, ShakedownMap, SubsurfaceReport, SurfaceReport,
};
use crate::inputs::SolveError;
use crate::job::Job;
use crate::solver::{Interrupt, Observer, Options, PhaseTimes, Step, StepReceiver};

/// Times, counts and the end of a solve, beside its steps.
pub(super) struct Solved {
    /// Wall time by phase.
    pub phases: PhaseTimes,
    /// Number of meshes, grids or tracks that were made.
    pub passes: usize,
    /// Why loads at the end are missing.
    pub interrupted: Option<Interrupt>,
    /// Relative change of a sought figure over the relative change of the force.
    pub sensitivity: Option<f64>,
}

/// Arrays that need the stresses in the bodies; the default is that of a step that was stopped.
#[derive(Default)]
pub(super) struct Arrays {
    /// Below the middle of the contact.
    pub subsurface: Option<PerBody<Option<SubsurfaceReport>>>,
    /// Below a peak pressure off the middle.
    pub below_peak: Option<PerBody<Option<SubsurfaceReport>>>,
    pub plasticity: PerBody<Option<PlasticityReport>>,
    /// Depth at which the plastic zone of each body begins, where an outline tells it \[mm\].
    pub covers: [Option<f64>; 2],
    /// The fatigue of bodies with limits under a static load.
    pub fatigue: Vec<BodyFatigue>,
    pub fields: Option<PerBody<Option<FieldsReport>>>,
    pub layers: Option<PerBody<Option<LayersReport>>>,
}

/// What else only the engine knows of a step: members of the report in the units of the job, and
/// figures in N–mm–MPa.
pub(super) struct Parts {
    pub known: Known,
    pub contact: ContactReport,
    pub increments: Option<IncrementsReport>,
    pub surfaces: Option<PerBody<Option<SurfaceReport>>>,
    pub passes: Option<PassesReport>,
    pub rules: Vec<RuleVerdict>,
    pub shakedown: Option<ShakedownMap>,
    /// Size of the elements or cells under the contact; `None` of steps that are no points of a
    /// load–approach curve \[mm\].
    pub spacing: Option<f64>,
    /// Figures of which answers and verdict are made, but for what earlier loads have left.
    pub measured: Measured,
    /// The figure that a target asks for, and its relative error.
    pub target: Option<(f64, Option<f64>)>,
    /// The load of a hardness test.
    pub indentation: Option<Seen>,
    /// Whether the figures that its findings take are unknown to later loads of a history too.
    pub leaves_unknown: bool,
}

/// An engine, with the job that it solves.
pub(super) trait Shown {
    /// The fields of its steps.
    type Field;
    /// What it carries from load to load; the default is that before the first one.
    type Memory: Default;

    /// The job.
    fn job(&self) -> &Job;

    /// Memory, without solving.
    ///
    /// # Errors
    /// [`SolveError`] of a contact outside the theory.
    fn cost(&self) -> Result<JobEstimate, SolveError>;

    /// Solves the job and hands over its steps.
    ///
    /// # Errors
    /// [`SolveError`]. A load that does not converge is no error.
    fn solve(
        &self,
        options: Options<'_>,
        observer: &mut dyn Observer,
        receiver: &mut dyn StepReceiver<Self::Field>,
    ) -> Result<Solved, SolveError>;

    /// The arrays of a step that was not stopped.
    ///
    /// # Errors
    /// The observer's [`Interrupt`].
    fn arrays(
        &self,
        step: &Step<Self::Field>,
        observer: &mut dyn Observer,
    ) -> Result<Arrays, Interrupt>;

    /// The limits of a step.
    fn findings(&self, step: &Step<Self::Field>) -> Vec<Finding>;

    /// The other members of a step.
    fn parts(
        &self,
        memory: &mut Self::Memory,
        step: &Step<Self::Field>,
        findings: &[Finding],
    ) -> Parts;

    /// The mesh, grid or track of a step, without the number of passes and enlargements.
    fn mesh(&self, step: &Step<Self::Field>) -> MeshReport;
}
