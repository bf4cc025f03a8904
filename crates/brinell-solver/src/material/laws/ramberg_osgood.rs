//! Ramberg and Osgood's power law.

use crate::material::HardeningLaw;

/// `ε_p = a (σ_0/E) (q/σ_0)^m`.
///
/// # Reference
/// W. Ramberg, W. R. Osgood, *Description of stress-strain curves by three parameters*, NACA TN 902 (1943).
#[derive(Debug, Clone, PartialEq)]
pub struct RambergOsgood {
    /// σ_0 \[MPa\].
    pub(in crate::material) reference_stress: f64,
    /// `a σ_0 / E`.
    pub(in crate::material) reference_strain: f64,
    /// m.
    pub(in crate::material) exponent: f64,
    /// 3G \[MPa\].
    pub(in crate::material) triple_shear: f64,
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
