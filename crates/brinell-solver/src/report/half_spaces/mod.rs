//! Jobs in three dimensions: converts the job to a problem for the engine of half-spaces, and the
//! load steps of the engine to the report.

mod document;
mod estimate;
mod findings;
mod flow;
mod layers;
mod measured;
mod seats;
mod sections;
mod spots;
mod step;
#[cfg(test)]
mod tests;

pub use document::{MapsReport, PressureQuantiles, RollerReport, SectionReport};
pub use findings::unknown_figures;
pub(super) use step::HalfSpaces;
