//! The kinematic assumption of a job.

use serde::Serialize;

use super::{Named, Quantity};

/// Kinematic assumption.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Analysis {
    /// `ε_zz` = 0: long bodies.
    PlaneStrain,
    /// `σ_zz` = 0: thin discs.
    PlaneStress,
    /// Bodies of revolution about the line of approach.
    Axisymmetric,
    /// Half-spaces whose surfaces are curved in two directions.
    ThreeDimensional,
}

impl Named for Analysis {
    const ALL: &'static [Self] =
        &[Self::PlaneStrain, Self::PlaneStress, Self::Axisymmetric, Self::ThreeDimensional];

    fn name(self) -> &'static str {
        match self {
            Self::PlaneStrain => "plane_strain",
            Self::PlaneStress => "plane_stress",
            Self::Axisymmetric => "axisymmetric",
            Self::ThreeDimensional => "three_dimensional",
        }
    }
}

impl Analysis {
    /// Returns the quantity of a force: per thickness in plane analyses, the total force in
    /// axisymmetry and three dimensions.
    pub const fn force(self) -> Quantity {
        match self {
            Self::PlaneStrain | Self::PlaneStress => Quantity::LineForce,
            Self::Axisymmetric | Self::ThreeDimensional => Quantity::Force,
        }
    }
}
