//! Writes a report in any of its forms.

use super::csv::table;
use super::layers_vtr::layers_vtr;
use super::{
    Export, ExportError, depth_svg, field_vtu, load_approach_svg, pressure_svg, surface_svg,
};
use crate::job::Job;
use crate::report::Report;

impl Export {
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
            Self::FieldVtu => field_vtu(report, step),
            Self::FieldVtr => layers_vtr(report, step),
            Self::PressureSvg => pressure_svg(job, report, step),
            Self::DepthSvg => depth_svg(job, report, step),
            Self::LoadApproachSvg => load_approach_svg(job, report),
            Self::SurfaceSvg => surface_svg(job, report, step),
            form => table(form, job, report),
        }
    }
}
