//! From a job to its solution: loads one after the other, each on its meshes.

mod bracket;
pub(super) mod force_search;
mod history;
mod increments;
mod load_sequence;
mod load_stepper;
pub(crate) mod run;
mod surface_stress;
pub(super) mod utilization;
