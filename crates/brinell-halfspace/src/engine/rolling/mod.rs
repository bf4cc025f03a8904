//! Contacts that roll or slide over a track, lines and ellipses, as an engine of the method: one
//! pass is one load.
//!
//! A [`RollingProblem`] holds the input, [`run`] solves its passes one after the other,
//! each from what the one before has left, and hands over one [`TrackStep`]. Equations:
//! `docs/theory_rolling.md`.

mod design;
mod engine;
mod error;
mod errors;
mod estimate;
mod fatigue;
mod limits;
mod memory;
mod pass;
mod problem;
mod run;
mod step;
mod system;

pub use error::TrackError;
pub use errors::{BodyPassErrors, PassErrors};
pub use estimate::{TrackEstimate, estimate};
pub use limits::FrictionLimit;
pub use pass::{BodyPass, Pass};
pub use problem::{Footprint, HardeningRules, Limit, RollingLoad, RollingProblem};
pub use run::{TrackRun, run};
pub use step::{KinematicPasses, TrackField, TrackStep};
