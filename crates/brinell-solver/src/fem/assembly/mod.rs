//! From elements to equations: numbering, stiffness, initial-stress loads and stresses.

mod equations;
mod initial_stress;
mod softening;
mod stiffness;
mod stress;

use crate::fem::element::StressState;
use crate::material::OutOfPlane;

pub use equations::{Equations, Restraint};
pub use initial_stress::InitialStressRegion;
pub use stiffness::StiffnessAssembler;
pub use stress::{GaussPoint, StressField};

/// What the stress_state know of the out-of-plane direction.
fn out_of_plane(stress_state: StressState) -> OutOfPlane {
    match stress_state {
        StressState::PlaneStrain | StressState::Axisymmetric => OutOfPlane::Strained,
        StressState::PlaneStress => OutOfPlane::Free,
    }
}
