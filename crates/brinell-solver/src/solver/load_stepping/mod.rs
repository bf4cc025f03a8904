//! From a job to its solution: loads one after the other, each on its meshes.

pub(crate) mod mesh_solve;
pub(crate) mod onset;
pub(crate) mod run;
