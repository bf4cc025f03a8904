//! Isotropic elastic constants.

use thiserror::Error;

/// Constants that are not those of a stable isotropic body.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "Young's modulus has to be positive and Poisson's ratio between 0 and 0.5, got {young} MPa \
     and {poisson}"
)]
pub struct ElasticityError {
    /// E \[MPa\].
    pub young: f64,
    /// ν.
    pub poisson: f64,
}

/// Young's modulus E \[MPa\] and Poisson's ratio ν of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elasticity {
    young: f64,
    poisson: f64,
}

impl Elasticity {
    /// # Errors
    /// [`ElasticityError`]: E that is not positive, ν outside `[0, 0.5)`.
    pub fn new(young: f64, poisson: f64) -> Result<Self, ElasticityError> {
        if young > 0.0 && young.is_finite() && (0.0..0.5).contains(&poisson) {
            Ok(Self { young, poisson })
        } else {
            Err(ElasticityError { young, poisson })
        }
    }

    /// E \[MPa\].
    pub const fn young(&self) -> f64 {
        self.young
    }

    /// ν.
    pub const fn poisson(&self) -> f64 {
        self.poisson
    }

    /// Shear modulus `μ = E/(2(1+ν))` \[MPa\].
    pub fn shear(&self) -> f64 {
        0.5 * self.young / (1.0 + self.poisson)
    }

    /// Lamé's first constant `λ = Eν/((1+ν)(1-2ν))` \[MPa\].
    pub fn lame(&self) -> f64 {
        self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson))
    }

    /// Compliance `(1 - ν²)/E` \[1/MPa\], of which `1/E*` is the sum over both bodies.
    pub fn plane_compliance(&self) -> f64 {
        (1.0 - self.poisson * self.poisson) / self.young
    }
}
