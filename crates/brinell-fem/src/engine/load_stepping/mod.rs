//! From a job to its solution: loads one after the other, each on its meshes.

mod force_search;
mod growth;
mod history;
mod load_sequence;
mod load_stepper;
mod onset_error;
mod path;
pub(crate) mod run;
pub(super) mod surface_stress;
pub(super) mod utilization;
