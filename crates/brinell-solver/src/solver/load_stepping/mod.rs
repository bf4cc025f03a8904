//! From a job to its solution: loads one after the other, each on its meshes.

mod history;
mod increments;
mod load_stepper;
pub(super) mod onset;
pub(crate) mod run;
