//! From elements to equations: numbering, stiffness, initial-stress loads and stresses.

mod equations;
mod moduli_reduction;
mod plastic_points;
mod relaxation;
mod stiffness;
mod stress;
mod unloaded;

use crate::element::StressState;
use brinell_material::OutOfPlane;

pub use equations::{Equations, Restraint, Support};
pub use plastic_points::{Extent, MaterialModel, PlasticPoints};
pub use relaxation::{given_stress, initial_force, relaxed_stress};
pub use stiffness::StiffnessAssembler;
pub use stress::{GaussPoint, StressField};
pub use unloaded::{PointStresses, Unloaded};

/// Returns the out-of-plane condition of a stress state.
pub fn out_of_plane(stress_state: StressState) -> OutOfPlane {
    match stress_state {
        StressState::PlaneStrain | StressState::Axisymmetric => OutOfPlane::Strained,
        StressState::PlaneStress => OutOfPlane::PlaneStress,
    }
}
