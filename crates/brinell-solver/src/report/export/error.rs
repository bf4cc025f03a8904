//! Why a report cannot be written in a form.

use thiserror::Error;

use crate::report::StepReport;

/// Reasons why a report cannot be written in a form.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ExportError {
    /// The report has no load step of this number, counted from 0.
    #[error("there is no step {}", .0 + 1)]
    NoStep(usize),
    /// The job did not ask for stresses over depth, or both bodies are rigid.
    #[error(
        "the result has no stresses over depth; solve the job with \"output\": {{\"subsurface\": \
         true}}"
    )]
    NoSubsurface,
    /// The job did not ask for fields.
    #[error("the result has no mesh fields; solve the job with \"output\": {{\"fields\": true}}")]
    NoFields,
    /// The job did not ask for layers, or is not in three dimensions.
    #[error(
        "the result has no layers; solve a job in three dimensions with \"output\": {{\"fields\": \
         true}}"
    )]
    NoLayers,
    /// Deformation theory has no increments and reports no surfaces.
    #[error(
        "the result has no increments and no surfaces; solve the job with \"solver\": \
         {{\"theory\": \"flow\"}}"
    )]
    NoFlow,
    /// A load that rolls has passes in place of increments and surfaces.
    #[error("the result of a load that rolls has passes, and no increments and no surfaces")]
    Rolling,
    /// The load does not roll.
    #[error("the result has no passes; its load is {{\"rolling\": {{\"force\": 2000}}}}")]
    NotRolling,
    /// No fatigue is known under the first load.
    #[error(
        "the first load has no fatigue: its rows `fatigue_utilization` say why, or no material has \
         \"fatigue\": {{\"torsion\": 480, \"bending\": 800}}"
    )]
    NoFatigue,
    /// The job is no hardness test.
    #[error("the result is of no hardness test; its load is {{\"hardness\": \"HBW 10/3000\"}}")]
    NoHardness,
    /// A single converged load gives no curve.
    #[error(
        "the result has no curve of force over approach; it takes two different loads that \
         converge"
    )]
    NoCurve,
    /// The fields are malformed.
    #[error("the fields cannot be written: {0}")]
    Fields(String),
    /// The drawing library failed.
    #[error("the figure could not be drawn: {0}")]
    Drawing(String),
}

impl ExportError {
    /// Returns why a step has no increments and no surfaces.
    pub(super) const fn without_flow(step: &StepReport) -> Self {
        if step.passes.is_some() { Self::Rolling } else { Self::NoFlow }
    }
}
