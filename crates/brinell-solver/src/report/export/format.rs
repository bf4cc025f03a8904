//! The forms of a report and their file names.

use crate::job::{Analysis, Job};

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
    /// Utilization over depth by criteria of fatigue.
    FatigueCsv,
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
    pub const ALL: [Self; 14] = [
        Self::SummaryCsv,
        Self::PressureCsv,
        Self::SubsurfaceCsv,
        Self::IncrementsCsv,
        Self::HardnessCsv,
        Self::PassesCsv,
        Self::FatigueCsv,
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
            Self::FatigueCsv => "fatigue.csv",
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
            Self::FieldVtu | Self::FieldVtr => "application/xml",
            Self::PressureSvg | Self::DepthSvg | Self::LoadApproachSvg | Self::SurfaceSvg => {
                "image/svg+xml"
            }
            _ => "text/csv; charset=utf-8; header=present",
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
                | Self::FatigueCsv
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
            | Self::FatigueCsv
            | Self::SurfaceCsv
            | Self::LoadApproachSvg
            | Self::SurfaceSvg => {}
        }
    }
}
