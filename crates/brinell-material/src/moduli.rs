//! Elastic moduli, and reference moduli for the stiffness of an iteration.

use nalgebra::{Matrix4, Vector4};

use crate::analytical::ElasticConstants;

/// A symmetric matrix over `[ε_xx, ε_yy, ε_zz, γ_xy]` \[MPa\].
pub type Moduli = Matrix4<f64>;

/// The reduction of the reference moduli of one point from the elastic ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModuliReduction {
    /// `D_e - D` \[MPa\]. Positive semidefinite. The part over the mean strain is zero, except in
    /// plane stress, where ε_zz has been eliminated and its row and column are zero instead.
    pub moduli: Moduli,
    /// Whether the point is beyond yield, not only near it.
    pub is_beyond_yield: bool,
}

/// The condition of the out-of-plane direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutOfPlane {
    /// The strain ε_zz is given (zero in plane strain, hoop strain in axisymmetry).
    Strained,
    /// The stress σ_zz is zero and the strain follows.
    PlaneStress,
}

/// Isotropic linear elasticity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticModuli {
    /// K \[MPa\].
    pub bulk: f64,
    /// G \[MPa\].
    pub shear: f64,
}

impl From<ElasticConstants> for ElasticModuli {
    fn from(elastic: ElasticConstants) -> Self {
        Self { bulk: elastic.bulk_modulus(), shear: elastic.shear_modulus() }
    }
}

impl ElasticModuli {
    /// Lamé's `λ = K - 2G/3` \[MPa\].
    pub fn lame(&self) -> f64 {
        self.bulk - 2.0 / 3.0 * self.shear
    }

    /// `K 1⊗1 + 2G dev` over `[ε_xx, ε_yy, ε_zz, γ_xy]` \[MPa\].
    pub fn matrix(&self) -> Moduli {
        let one = Vector4::new(1.0, 1.0, 1.0, 0.0);
        self.bulk * one * one.transpose() + 2.0 * self.shear * deviatoric_projection()
    }

    /// The strain `[ε_xx, ε_yy, ε_zz, γ_xy]` of an elastic stress `[σ_xx, σ_yy, σ_zz, τ_xy]`
    /// \[MPa\].
    pub fn strain(&self, stress: [f64; 4]) -> [f64; 4] {
        let [x, y, z, t] = stress;
        let third = (x + y + z) / 3.0;
        let mean = third / (3.0 * self.bulk);
        let along = |s: f64| mean + (s - third) / (2.0 * self.shear);
        [along(x), along(y), along(z), t / self.shear]
    }

    /// Elastic stress \[MPa\] of a strain `[ε_xx, ε_yy, ε_zz, γ_xy]`; ignores ε_zz in plane
    /// stress.
    pub fn stress(&self, strain: [f64; 4], out_of_plane: OutOfPlane) -> [f64; 4] {
        let [x, y, z, g] = strain;
        let (lame, double_shear) = (self.lame(), 2.0 * self.shear);
        match out_of_plane {
            OutOfPlane::Strained => {
                let mean = lame * (x + y + z);
                [
                    mean + double_shear * x,
                    mean + double_shear * y,
                    mean + double_shear * z,
                    self.shear * g,
                ]
            }
            OutOfPlane::PlaneStress => {
                let mean = double_shear * lame / (lame + double_shear) * (x + y);
                [mean + double_shear * x, mean + double_shear * y, 0.0, self.shear * g]
            }
        }
    }
}

/// The reference moduli of an iteration.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum ReferenceModuli {
    /// Moduli as near to the tangent as errors in the strain allow.
    #[default]
    Tangent,
    /// The tangent at the strain itself, less this part of κ, with a secant modulus of at least as
    /// much of G. Between 0, the tangent, and 1, the secant moduli of deformation theory: an
    /// iteration that takes those anew each time always ends (L. M. Kachanov), if slowly.
    Stiffened(f64),
}

impl ReferenceModuli {
    /// Half of the range of equivalent strains that the moduli are means over, relative to the
    /// strain.
    pub(super) fn range(self) -> f64 {
        match self {
            Self::Tangent => 0.07,
            // A difference quotient.
            Self::Stiffened(_) => 1e-5,
        }
    }

    /// Part of κ that is left out.
    pub(super) fn left_out(self) -> f64 {
        match self {
            Self::Tangent => 0.1,
            Self::Stiffened(part) => part,
        }
    }

    /// Least secant modulus over the elastic one. A wild iterate must not make the stiffness
    /// numerically singular.
    pub(super) fn softest(self) -> f64 {
        match self {
            Self::Tangent => 1e-3,
            Self::Stiffened(part) => part.min(1e-3),
        }
    }
}

/// `dev` over `[ε_xx, ε_yy, ε_zz, γ_xy]`: the deviator of the strain, with half of the engineering
/// shear strain.
pub(super) fn deviatoric_projection() -> Moduli {
    let third = 1.0 / 3.0;
    Matrix4::new(
        2.0 * third,
        -third,
        -third,
        0.0,
        -third,
        2.0 * third,
        -third,
        0.0,
        -third,
        -third,
        2.0 * third,
        0.0,
        0.0,
        0.0,
        0.0,
        0.5,
    )
}
