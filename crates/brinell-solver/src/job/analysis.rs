//! The kinematic assumption of a job.

use serde::Serialize;
use strum::{IntoStaticStr, VariantArray};

use super::{Domain, Named};

/// Kinematic assumption.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, IntoStaticStr, VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
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

impl Named for Analysis {}

impl Analysis {
    /// Returns the quantity of a force: per thickness in plane analyses, the total force in
    /// axisymmetry and three dimensions.
    pub const fn force(self) -> Domain {
        match self {
            Self::PlaneStrain | Self::PlaneStress => Domain::LineForce,
            Self::Axisymmetric | Self::ThreeDimensional => Domain::Force,
        }
    }
}
