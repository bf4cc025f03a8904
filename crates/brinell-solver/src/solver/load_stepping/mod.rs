//! From a job to its solution: loads one after the other, each on its meshes.

mod load_stepper;
mod onset;
pub(crate) mod run;
