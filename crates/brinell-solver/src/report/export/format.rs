//! The forms of a report and their file names.

use strum::{IntoStaticStr, VariantArray};

use crate::job::{Analysis, Job, Named};

/// Forms of a report. Their names are those of their files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
pub enum Export {
    /// Table with one row of figures for each load step.
    #[strum(serialize = "summary.csv")]
    SummaryCsv,
    /// Contact pressure of all load steps.
    #[strum(serialize = "pressure.csv")]
    PressureCsv,
    /// Stresses over depth of all load steps.
    #[strum(serialize = "subsurface.csv")]
    SubsurfaceCsv,
    /// All increments of a history: force, approach, pressure.
    #[strum(serialize = "increments.csv")]
    IncrementsCsv,
    /// Load-displacement curve of a hardness test.
    #[strum(serialize = "hardness.csv")]
    HardnessCsv,
    /// Passes of a load that rolls.
    #[strum(serialize = "passes.csv")]
    PassesCsv,
    /// Utilization over depth by criteria of fatigue.
    #[strum(serialize = "fatigue.csv")]
    FatigueCsv,
    /// Surfaces of all load steps with dent and pile-up.
    #[strum(serialize = "surface.csv")]
    SurfaceCsv,
    /// Fields of both bodies.
    #[strum(serialize = "field.vtu")]
    FieldVtu,
    /// Stress and plastic strain in the layers of half-spaces in three dimensions, or in the section
    /// of a track.
    #[strum(serialize = "field.vtr")]
    FieldVtr,
    /// Chart of the contact pressure and Hertz's pressure.
    #[strum(serialize = "pressure.svg")]
    PressureSvg,
    /// Chart of the stresses over depth and McEwen's stresses.
    #[strum(serialize = "depth.svg")]
    DepthSvg,
    /// Chart of force over approach, a loop for a history with unloading.
    #[strum(serialize = "load_approach.svg")]
    LoadApproachSvg,
    /// Chart of the surfaces with dent and pile-up.
    #[strum(serialize = "surface.svg")]
    SurfaceSvg,
}

impl Named for Export {}

impl Export {
    /// Returns the media type of this form.
    pub fn media_type(self) -> &'static str {
        match self.name().rsplit('.').next() {
            Some("svg") => "image/svg+xml",
            Some("csv") => "text/csv; charset=utf-8; header=present",
            _ => "application/xml",
        }
    }

    /// Returns whether this form is a [`Table`](super::Table).
    pub fn is_table(self) -> bool {
        self.media_type().starts_with("text/csv")
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
            _ => {}
        }
    }
}
