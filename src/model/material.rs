//! Elastic constants and uniaxial hardening curves.

use serde::Serialize;

use super::{NonNegativeF64, PoissonRatio, PositiveF64};

/// What a body is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum Material {
    /// Does not deform.
    Rigid,
    /// Isotropic elastic, with an optional plastic curve.
    Deformable(Deformable),
}

/// Elastic constants and, beside them, a hardening curve that is physical for these constants.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Deformable {
    elastic: Elastic,
    plasticity: Option<Hardening>,
}

impl Deformable {
    /// Elastic constants.
    pub fn elastic(&self) -> &Elastic {
        &self.elastic
    }

    /// Uniaxial hardening curve; `None` is purely elastic.
    pub fn plasticity(&self) -> Option<&Hardening> {
        self.plasticity.as_ref()
    }
}

/// Isotropic linear elasticity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Elastic {
    /// Young's modulus E \[MPa\].
    pub young_modulus: PositiveF64,
    /// Poisson's ratio ν.
    pub poisson_ratio: PoissonRatio,
}

impl Elastic {
    /// Shear modulus `G = E / (2 (1 + ν))` \[MPa\].
    pub fn shear_modulus(&self) -> f64 {
        self.young_modulus.get() / (2.0 * (1.0 + self.poisson_ratio.get()))
    }

    /// Bulk modulus `K = E / (3 (1 - 2ν))` \[MPa\].
    pub fn bulk_modulus(&self) -> f64 {
        self.young_modulus.get() / (3.0 * (1.0 - 2.0 * self.poisson_ratio.get()))
    }

    /// Plane-strain modulus `E / (1 - ν²)` \[MPa\].
    pub fn plane_strain_modulus(&self) -> f64 {
        self.young_modulus.get() / (1.0 - self.poisson_ratio.get().powi(2))
    }
}

/// Uniaxial curve of stress against plastic strain. Its numerics live in `plasticity`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "law", rename_all = "snake_case")]
pub enum Hardening {
    /// Straight line of slope `E_t` (total strain) beyond the yield stress; `E_t = 0` is perfectly plastic.
    Bilinear {
        /// σ_y \[MPa\].
        yield_stress: PositiveF64,
        /// E_t \[MPa\], below Young's modulus.
        tangent_modulus: NonNegativeF64,
    },
    /// `ε_p = a (σ_0 / E) (q / σ_0)^m`.
    RambergOsgood {
        /// σ_0 \[MPa\].
        reference_stress: PositiveF64,
        /// Offset a.
        offset: PositiveF64,
        /// Exponent m, at least 1.
        exponent: PositiveF64,
    },
    /// Piecewise linear through `[plastic_strain, stress]`, the first at zero plastic strain; constant beyond
    /// the last.
    Table {
        /// Points, plastic strain strictly increasing, stress \[MPa\] not falling.
        points: Vec<[f64; 2]>,
    },
    /// `q = σ_y (1 + ε_p / ε_0)^n`.
    Swift {
        /// σ_y \[MPa\].
        yield_stress: PositiveF64,
        /// ε_0.
        strain_offset: PositiveF64,
        /// n, between 0 and 1.
        exponent: PositiveF64,
    },
    /// `q = σ_y + k ε_p^n`.
    Ludwik {
        /// σ_y \[MPa\].
        yield_stress: PositiveF64,
        /// k \[MPa\].
        coefficient: PositiveF64,
        /// n, between 0 and 1.
        exponent: PositiveF64,
    },
    /// `q = σ_y + (σ_s - σ_y) (1 - exp(-b ε_p))`.
    Voce {
        /// σ_y \[MPa\].
        yield_stress: PositiveF64,
        /// Saturation stress σ_s \[MPa\], at least σ_y.
        saturation_stress: PositiveF64,
        /// b.
        rate: PositiveF64,
    },
}
