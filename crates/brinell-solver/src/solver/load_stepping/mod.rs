//! From a job to its solution: loads one after the other, each on its meshes.

pub(super) mod force_search;
mod history;
mod history_steps;
pub(super) mod increments;
mod load_sequence;
mod load_stepper;
mod path;
mod progress;
pub(crate) mod run;
pub(crate) mod steps;
mod surface_stress;
pub(super) mod utilization;
