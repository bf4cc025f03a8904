//! The inputs of the engines: a job becomes two bodies, their loads and the settings of the solve,
//! once per job. Below are engines that know no job.

mod error;
mod half_spaces;
mod input;
mod outline;
mod plane;
mod rolling;
mod settings;
mod slopes;

pub use error::SolveError;
pub(crate) use half_spaces::along_axes;
pub use half_spaces::{elliptic_reference, half_spaces};
pub(crate) use input::{Input, of};
pub use outline::outline_of;
pub(crate) use plane::meshed_contact;
pub use plane::{elastic_reference, run, run_with, support};
pub(crate) use rolling::RollingInput;
pub use settings::{increments, loads, settings};
pub(crate) use slopes::of_small_mesh;
