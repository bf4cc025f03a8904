//! From elements to equations: numbering, stiffness, initial-stress loads and stresses.

mod equations;
mod initial_stress;
mod stiffness;
mod stress;

pub use equations::{Equations, Restraint};
pub use initial_stress::{InitialStressRegion, PlasticUpdate};
pub use stiffness::StiffnessAssembler;
pub use stress::{GaussPoint, StressField};
