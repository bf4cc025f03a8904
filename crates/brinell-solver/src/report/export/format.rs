//! Every form of a report under its file name.

use thiserror::Error;

use super::csv::table;
use super::layers_vtr::layers_vtr;
use super::{depth_svg, field_vtu, load_approach_svg, pressure_svg, surface_svg};
use crate::job::{Analysis, Job};
use crate::report::Report;

/// Why a report has no such form.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ExportError {
    /// The report has no such step, counted from 0.
    #[error("there is no step {}", .0 + 1)]
    NoStep(usize),
    /// Stresses over depth were not asked for, or both bodies are rigid.
    #[error(
        "the result has no stresses over depth; solve the job with \"output\": {{\"subsurface\": \
         true}}"
    )]
    NoSubsurface,
    /// Fields were not asked for.
    #[error("the result has no mesh fields; solve the job with \"output\": {{\"fields\": true}}")]
    NoFields,
    /// Layers were not asked for, or the bodies are no half-spaces in three dimensions.
    #[error(
        "the result has no layers; solve a job in three dimensions with \"output\": {{\"fields\": \
         true}}"
    )]
    NoLayers,
    /// Deformation theory has no increments and follows no surface.
    #[error(
        "the result has no increments and no surfaces; solve the job with \"solver\": \
         {{\"theory\": \"flow\"}}"
    )]
    NoFlow,
    /// One converged load makes no curve.
    #[error(
        "the result has no curve of force over approach; it takes two different loads that \
         converge"
    )]
    NoCurve,
    /// The fields are not what they have to be.
    #[error("the fields cannot be written: {0}")]
    Fields(String),
    /// The drawing library failed.
    #[error("the figure could not be drawn: {0}")]
    Drawing(String),
}

/// A form that a report can be written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Export {
    /// One row of figures for each step.
    SummaryCsv,
    /// Contact pressure of all steps.
    PressureCsv,
    /// Stresses over depth of all steps.
    SubsurfaceCsv,
    /// Every increment of a history: force, approach, pressure.
    IncrementsCsv,
    /// The surfaces of all steps: the dent and the pile-up beside it.
    SurfaceCsv,
    /// Fields of both bodies.
    FieldVtu,
    /// Stress and plastic strain in the layers of half-spaces in three dimensions.
    FieldVtr,
    /// Contact pressure with Hertz beside it.
    PressureSvg,
    /// Stresses over depth with McEwen beside them.
    DepthSvg,
    /// Force over approach, a loop where the load comes back.
    LoadApproachSvg,
    /// The surfaces: the dent and the pile-up beside it.
    SurfaceSvg,
}

impl Export {
    /// Every form.
    pub const ALL: [Self; 11] = [
        Self::SummaryCsv,
        Self::PressureCsv,
        Self::SubsurfaceCsv,
        Self::IncrementsCsv,
        Self::SurfaceCsv,
        Self::FieldVtu,
        Self::FieldVtr,
        Self::PressureSvg,
        Self::DepthSvg,
        Self::LoadApproachSvg,
        Self::SurfaceSvg,
    ];

    /// What a file of it is called.
    pub const fn file_name(self) -> &'static str {
        match self {
            Self::SummaryCsv => "summary.csv",
            Self::PressureCsv => "pressure.csv",
            Self::SubsurfaceCsv => "subsurface.csv",
            Self::IncrementsCsv => "increments.csv",
            Self::SurfaceCsv => "surface.csv",
            Self::FieldVtu => "field.vtu",
            Self::FieldVtr => "field.vtr",
            Self::PressureSvg => "pressure.svg",
            Self::DepthSvg => "depth.svg",
            Self::LoadApproachSvg => "load_approach.svg",
            Self::SurfaceSvg => "surface.svg",
        }
    }

    /// Its media type.
    pub const fn media_type(self) -> &'static str {
        match self {
            Self::SummaryCsv
            | Self::PressureCsv
            | Self::SubsurfaceCsv
            | Self::IncrementsCsv
            | Self::SurfaceCsv => "text/csv; charset=utf-8; header=present",
            Self::FieldVtu | Self::FieldVtr => "application/xml",
            Self::PressureSvg | Self::DepthSvg | Self::LoadApproachSvg | Self::SurfaceSvg => {
                "image/svg+xml"
            }
        }
    }

    /// Whether it is a [`Table`](super::Table).
    pub const fn is_table(self) -> bool {
        matches!(
            self,
            Self::SummaryCsv
                | Self::PressureCsv
                | Self::SubsurfaceCsv
                | Self::IncrementsCsv
                | Self::SurfaceCsv
        )
    }

    /// Whether it shows one step; the others have a column for it.
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

    /// Has a job's output contain what this form shows.
    pub fn require(self, job: &mut Job) {
        match self {
            Self::FieldVtu | Self::FieldVtr => job.output.fields = true,
            Self::SubsurfaceCsv | Self::DepthSvg => job.output.subsurface = true,
            // The map is one of the fields.
            Self::PressureSvg => job.output.fields |= job.analysis == Analysis::ThreeDimensional,
            Self::SummaryCsv
            | Self::PressureCsv
            | Self::IncrementsCsv
            | Self::SurfaceCsv
            | Self::LoadApproachSvg
            | Self::SurfaceSvg => {}
        }
    }

    /// Writes a report in this form; `step`, counted from 0, is the last one unless it is given.
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
