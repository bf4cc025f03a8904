//! The forms of a report and their file names.

use thiserror::Error;

use super::csv::table;
use super::layers_vtr::layers_vtr;
use super::{depth_svg, field_vtu, load_approach_svg, pressure_svg, surface_svg};
use crate::job::{Analysis, Job};
use crate::report::{Report, StepReport};

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
        if step.rolling.is_some() { Self::Rolling } else { Self::NoFlow }
    }
}

/// Forms of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Export {
    /// Table with one row of figures for each load step.
    SummaryCsv,
    /// Contact pressure of all load steps.
    PressureCsv,
    /// Stresses over depth of all load steps.
    SubsurfaceCsv,
    /// All increments of a history: force, approach, pressure.
    IncrementsCsv,
    /// Load-displacement curve of a hardness test.
    HardnessCsv,
    /// Passes of a load that rolls.
    PassesCsv,
    /// Surfaces of all load steps with dent and pile-up.
    SurfaceCsv,
    /// Fields of both bodies.
    FieldVtu,
    /// Stress and plastic strain in the layers of half-spaces in three dimensions, or in the section
    /// of a track.
    FieldVtr,
    /// Chart of the contact pressure and Hertz's pressure.
    PressureSvg,
    /// Chart of the stresses over depth and McEwen's stresses.
    DepthSvg,
    /// Chart of force over approach, a loop for a history with unloading.
    LoadApproachSvg,
    /// Chart of the surfaces with dent and pile-up.
    SurfaceSvg,
}

impl Export {
    /// All forms.
    pub const ALL: [Self; 13] = [
        Self::SummaryCsv,
        Self::PressureCsv,
        Self::SubsurfaceCsv,
        Self::IncrementsCsv,
        Self::HardnessCsv,
        Self::PassesCsv,
        Self::SurfaceCsv,
        Self::FieldVtu,
        Self::FieldVtr,
        Self::PressureSvg,
        Self::DepthSvg,
        Self::LoadApproachSvg,
        Self::SurfaceSvg,
    ];

    /// Returns the file name of this form.
    pub const fn file_name(self) -> &'static str {
        match self {
            Self::SummaryCsv => "summary.csv",
            Self::PressureCsv => "pressure.csv",
            Self::SubsurfaceCsv => "subsurface.csv",
            Self::IncrementsCsv => "increments.csv",
            Self::HardnessCsv => "hardness.csv",
            Self::PassesCsv => "passes.csv",
            Self::SurfaceCsv => "surface.csv",
            Self::FieldVtu => "field.vtu",
            Self::FieldVtr => "field.vtr",
            Self::PressureSvg => "pressure.svg",
            Self::DepthSvg => "depth.svg",
            Self::LoadApproachSvg => "load_approach.svg",
            Self::SurfaceSvg => "surface.svg",
        }
    }

    /// Returns the media type of this form.
    pub const fn media_type(self) -> &'static str {
        match self {
            Self::SummaryCsv
            | Self::PressureCsv
            | Self::SubsurfaceCsv
            | Self::IncrementsCsv
            | Self::HardnessCsv
            | Self::PassesCsv
            | Self::SurfaceCsv => "text/csv; charset=utf-8; header=present",
            Self::FieldVtu | Self::FieldVtr => "application/xml",
            Self::PressureSvg | Self::DepthSvg | Self::LoadApproachSvg | Self::SurfaceSvg => {
                "image/svg+xml"
            }
        }
    }

    /// Returns whether this form is a [`Table`](super::Table).
    pub const fn is_table(self) -> bool {
        matches!(
            self,
            Self::SummaryCsv
                | Self::PressureCsv
                | Self::SubsurfaceCsv
                | Self::IncrementsCsv
                | Self::HardnessCsv
                | Self::PassesCsv
                | Self::SurfaceCsv
        )
    }

    /// Returns whether this form shows a single load step. The other forms show all load steps.
    pub const fn shows_one_step(self) -> bool {
        matches!(
            self,
            Self::FieldVtu
                | Self::FieldVtr
                | Self::PressureSvg
                | Self::DepthSvg
                | Self::SurfaceSvg
        )
    }

    /// Changes the output of a job to include the data of this form.
    pub fn require(self, job: &mut Job) {
        match self {
            Self::FieldVtu | Self::FieldVtr => job.output.fields = true,
            Self::SubsurfaceCsv | Self::DepthSvg => job.output.subsurface = true,
            // The map of the pressure belongs to the fields.
            Self::PressureSvg => job.output.fields |= job.analysis == Analysis::ThreeDimensional,
            Self::SummaryCsv
            | Self::PressureCsv
            | Self::IncrementsCsv
            | Self::HardnessCsv
            | Self::PassesCsv
            | Self::SurfaceCsv
            | Self::LoadApproachSvg
            | Self::SurfaceSvg => {}
        }
    }

    /// Writes a report in this form. `step` is counted from 0; its default is the last load step.
    ///
    /// # Errors
    /// [`ExportError`].
    pub fn write(
        self,
        job: &Job,
        report: &Report,
        step: Option<usize>,
    ) -> Result<String, ExportError> {
        let step = step.unwrap_or(report.steps.len().saturating_sub(1));
        match self {
            Self::SummaryCsv
            | Self::PressureCsv
            | Self::SubsurfaceCsv
            | Self::IncrementsCsv
            | Self::HardnessCsv
            | Self::PassesCsv
            | Self::SurfaceCsv => table(self, job, report),
            Self::FieldVtu => field_vtu(report, step),
            Self::FieldVtr => layers_vtr(report, step),
            Self::PressureSvg => pressure_svg(job, report, step),
            Self::DepthSvg => depth_svg(job, report, step),
            Self::LoadApproachSvg => load_approach_svg(job, report),
            Self::SurfaceSvg => surface_svg(job, report, step),
        }
    }
}
