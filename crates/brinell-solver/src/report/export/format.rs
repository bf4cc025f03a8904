//! Every form of a report under its file name.

use thiserror::Error;

use super::{depth_svg, field_vtu, pressure_csv, pressure_svg, subsurface_csv, summary_csv};
use crate::job::Job;
use crate::report::Report;

/// Why a report has no such form.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ExportError {
    /// The report has no such step, counted from 0.
    #[error("there is no step {}", .0 + 1)]
    NoStep(usize),
    /// Stresses over depth were not asked for, or both bodies are rigid.
    #[error("the result has no stresses over depth; solve the job with \"output\": {{\"subsurface\": true}}")]
    NoSubsurface,
    /// Fields were not asked for.
    #[error("the result has no mesh fields; solve the job with \"output\": {{\"fields\": true}}")]
    NoFields,
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
    /// Fields of both bodies.
    FieldVtu,
    /// Contact pressure with Hertz beside it.
    PressureSvg,
    /// Stresses over depth with McEwen beside them.
    DepthSvg,
}

impl Export {
    /// Every form.
    pub const ALL: [Self; 6] = [
        Self::SummaryCsv,
        Self::PressureCsv,
        Self::SubsurfaceCsv,
        Self::FieldVtu,
        Self::PressureSvg,
        Self::DepthSvg,
    ];

    /// What a file of it is called.
    pub const fn file_name(self) -> &'static str {
        match self {
            Self::SummaryCsv => "summary.csv",
            Self::PressureCsv => "pressure.csv",
            Self::SubsurfaceCsv => "subsurface.csv",
            Self::FieldVtu => "field.vtu",
            Self::PressureSvg => "pressure.svg",
            Self::DepthSvg => "depth.svg",
        }
    }

    /// Its media type.
    pub const fn media_type(self) -> &'static str {
        match self {
            Self::SummaryCsv | Self::PressureCsv | Self::SubsurfaceCsv => {
                "text/csv; charset=utf-8; header=present"
            }
            Self::FieldVtu => "application/xml",
            Self::PressureSvg | Self::DepthSvg => "image/svg+xml",
        }
    }

    /// Whether it shows one step; the others have a column for it.
    pub const fn shows_one_step(self) -> bool {
        !matches!(self, Self::SummaryCsv | Self::PressureCsv | Self::SubsurfaceCsv)
    }

    /// Has a job's output contain what this form shows.
    pub fn require(self, job: &mut Job) {
        match self {
            Self::FieldVtu => job.output.fields = true,
            Self::SubsurfaceCsv | Self::DepthSvg => job.output.subsurface = true,
            Self::SummaryCsv | Self::PressureCsv | Self::PressureSvg => {}
        }
    }

    /// Writes a report in this form; `step`, counted from 0, is the last one unless it is given.
    ///
    /// # Errors
    /// [`ExportError`].
    pub fn write(self, job: &Job, report: &Report, step: Option<usize>) -> Result<String, ExportError> {
        let step = step.unwrap_or(report.steps.len().saturating_sub(1));
        match self {
            Self::SummaryCsv => Ok(summary_csv(report)),
            Self::PressureCsv => Ok(pressure_csv(report)),
            Self::SubsurfaceCsv => subsurface_csv(report),
            Self::FieldVtu => field_vtu(report, step),
            Self::PressureSvg => pressure_svg(job, report, step),
            Self::DepthSvg => depth_svg(job, report, step),
        }
    }
}
