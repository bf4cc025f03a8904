//! Uniaxial hardening curves, as the deviatoric law needs them.

use crate::model::{Deformable, Hardening};

/// A uniaxial curve of stress against plastic strain.
pub trait HardeningLaw {
    /// Stress up to which the response is elastic \[MPa\]; 0 where plastic strain begins at once.
    fn yield_stress(&self) -> f64;

    /// Whether a point in this state counts as yielded: where plastic strain has begun or, for a curve without an
    /// elastic limit, by convention above its reference stress.
    fn has_yielded(&self, _equivalent_stress: f64, plastic_strain: f64) -> bool {
        plastic_strain > 0.0
    }

    /// The equivalent stress q \[MPa\] that solves `ε_q = q / (3G) + ε_p(q)` for an equivalent strain `ε_q >= 0`.
    ///
    /// The left side minus the right falls monotonically in q, so the root is unique; it is never above
    /// `3G ε_q`. Implementations end after a bounded number of steps.
    fn equivalent_stress(&self, equivalent_strain: f64) -> f64;
}

/// The curve of one material, prepared for evaluation.
#[derive(Debug, Clone, PartialEq)]
pub enum UniaxialCurve {
    /// Straight hardening.
    Bilinear(Bilinear),
    /// Power law without a yield point.
    RambergOsgood(RambergOsgood),
}

impl UniaxialCurve {
    /// Prepares the hardening curve of a material; `None` if it is purely elastic.
    pub fn of(material: &Deformable) -> Option<Self> {
        let elastic = material.elastic();
        let (young, triple_shear) = (elastic.young_modulus.get(), 3.0 * elastic.shear_modulus());
        Some(match material.plasticity()? {
            Hardening::Bilinear { yield_stress, tangent_modulus } => {
                let ratio = tangent_modulus.get() / young;
                Self::Bilinear(Bilinear {
                    yield_stress: yield_stress.get(),
                    plastic_modulus: tangent_modulus.get() / (1.0 - ratio),
                    triple_shear,
                })
            }
            Hardening::RambergOsgood { reference_stress, offset, exponent } => {
                Self::RambergOsgood(RambergOsgood {
                    reference_stress: reference_stress.get(),
                    reference_strain: offset.get() * reference_stress.get() / young,
                    exponent: exponent.get(),
                    triple_shear,
                })
            }
            _ => unreachable!("laws that are not built yet are refused by the model"),
        })
    }
}

impl UniaxialCurve {
    fn law(&self) -> &dyn HardeningLaw {
        match self {
            Self::Bilinear(law) => law,
            Self::RambergOsgood(law) => law,
        }
    }
}

impl HardeningLaw for UniaxialCurve {
    fn yield_stress(&self) -> f64 {
        self.law().yield_stress()
    }

    fn has_yielded(&self, equivalent_stress: f64, plastic_strain: f64) -> bool {
        self.law().has_yielded(equivalent_stress, plastic_strain)
    }

    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        // Not through `law()`: this is the innermost loop, and the closed form is worth inlining.
        match self {
            Self::Bilinear(law) => law.equivalent_stress(equivalent_strain),
            Self::RambergOsgood(law) => law.equivalent_stress(equivalent_strain),
        }
    }
}

/// `q = σ_y + H ε_p` with the plastic modulus `H = E_t / (1 - E_t/E)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Bilinear {
    yield_stress: f64,
    plastic_modulus: f64,
    triple_shear: f64,
}

impl HardeningLaw for Bilinear {
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    /// Closed form: `ε_p = max(0, (3G ε_q - σ_y) / (3G + H))`.
    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        let trial = self.triple_shear * equivalent_strain;
        let excess = (trial - self.yield_stress).max(0.0);
        trial - self.triple_shear * excess / (self.triple_shear + self.plastic_modulus)
    }
}

/// `ε_p = a (σ_0/E) (q/σ_0)^m`.
///
/// # Reference
/// W. Ramberg, W. R. Osgood, *Description of stress-strain curves by three parameters*, NACA TN 902 (1943).
#[derive(Debug, Clone, PartialEq)]
pub struct RambergOsgood {
    reference_stress: f64,
    /// `a σ_0 / E`.
    reference_strain: f64,
    exponent: f64,
    triple_shear: f64,
}

impl HardeningLaw for RambergOsgood {
    fn yield_stress(&self) -> f64 {
        0.0
    }

    fn has_yielded(&self, equivalent_stress: f64, _plastic_strain: f64) -> bool {
        equivalent_stress > self.reference_stress
    }

    /// Newton's method on `f(q) = q/(3G) + ε_p(q) - ε_q`, which is convex and rising: started above the root it
    /// falls to it without overshoot. The purely elastic answer lies above the root; where it is far above, the
    /// purely plastic one is nearer and above it too.
    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        if equivalent_strain <= 0.0 {
            return 0.0;
        }
        let mut q = self.triple_shear * equivalent_strain;
        if q > self.reference_stress {
            let strain_ratio = equivalent_strain / self.reference_strain;
            q = q.min(self.reference_stress * strain_ratio.powf(self.exponent.recip()));
        }
        for _ in 0..60 {
            let plastic_strain = self.reference_strain * (q / self.reference_stress).powf(self.exponent);
            let excess = q / self.triple_shear + plastic_strain - equivalent_strain;
            let slope = self.triple_shear.recip() + self.exponent * plastic_strain / q;
            let step = excess / slope;
            q -= step;
            // Convergence is quadratic: a step this small has left the error at rounding.
            if step.abs() <= 1e-9 * q {
                break;
            }
        }
        q
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bilinear_follows_its_uniaxial_curve() {
        let law = Bilinear { yield_stress: 500.0, plastic_modulus: 11_052.63, triple_shear: 242_307.7 };
        for plastic_strain in [0.0, 1e-4, 3e-3, 0.1] {
            let q = 500.0 + 11_052.63 * plastic_strain;
            let strain = q / 242_307.7 + plastic_strain;
            assert!((law.equivalent_stress(strain) - q).abs() < 1e-9 * q);
        }
        assert!((law.equivalent_stress(1e-3) - 242.3077).abs() < 1e-9);
    }

    #[test]
    fn ramberg_osgood_follows_its_uniaxial_curve_over_many_decades() {
        let law = RambergOsgood {
            reference_stress: 500.0,
            reference_strain: 0.3 * 500.0 / 210_000.0,
            exponent: 5.0,
            triple_shear: 242_307.7,
        };
        for q in [1e-6, 1.0, 100.0, 500.0, 900.0, 5000.0, 1e6] {
            let strain = q / 242_307.7 + law.reference_strain * (q / 500.0f64).powi(5);
            assert!((law.equivalent_stress(strain) - q).abs() < 1e-12 * q, "q = {q}");
        }
    }
}
