//! From elements to equations: numbering, stiffness, initial-stress loads and stresses.

mod equations;
mod initial_stress;
mod softening;
mod stiffness;
mod stress;

use crate::fem::element::Kinematics;
use crate::material::OutOfPlane;

pub use equations::{Equations, Restraint};
pub use initial_stress::InitialStressRegion;
pub use stiffness::StiffnessAssembler;
pub use stress::{GaussPoint, StressField};

/// What the kinematics know of the out-of-plane direction.
fn out_of_plane(kinematics: Kinematics) -> OutOfPlane {
    match kinematics {
        Kinematics::PlaneStrain | Kinematics::Axisymmetric => OutOfPlane::Strained,
        Kinematics::PlaneStress => OutOfPlane::Free,
    }
}
