//! Jobs in three dimensions: from the job to the engine of half-spaces, and from its steps to the
//! report.

mod document;
mod elastic;
mod estimate;
mod flow;
mod layers;
mod notes;
mod run;
mod step;

pub use document::{
    EllipseErrors, EllipticHertzReport, MapsReport, RollerReport, RoughContactReport,
    SectionReport, ThreeDimensionalReport,
};
pub use elastic::EllipticReference;
pub(super) use run::{preflight, run_each};
