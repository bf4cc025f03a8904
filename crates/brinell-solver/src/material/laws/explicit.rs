//! Laws that give the stress as an explicit, rising and concave function of the plastic strain.

use crate::material::HardeningLaw;

/// The root in `p = ε_p` of `q(p) + 3G p = 3G ε_q`, and the stress there; `curve(p)` is `(q, dq/dp)`.
///
/// Newton's method from the far end of the bracket `[0, ε_q - σ_y/3G]`: on a concave function the first step lands
/// at or short of the root and all further ones approach it from below. A step that leaves the bracket (an
/// infinite slope at zero) is replaced by bisection.
fn solve(
    triple_shear: f64,
    yield_stress: f64,
    equivalent_strain: f64,
    curve: impl Fn(f64) -> (f64, f64),
) -> f64 {
    let trial = triple_shear * equivalent_strain;
    if trial <= yield_stress {
        return trial;
    }
    let (mut low, mut high) = (0.0, (trial - yield_stress) / triple_shear);
    let mut strain: f64 = high;
    for _ in 0..100 {
        let (stress, slope) = curve(strain);
        let excess = stress + triple_shear * strain - trial;
        if excess > 0.0 {
            high = strain;
        } else {
            low = strain;
        }
        let newton = strain - excess / (slope + triple_shear);
        if (newton - strain).abs() <= 1e-15 * trial / triple_shear {
            break;
        }
        strain = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
    }
    // Not `trial - 3G ε_p`, which loses all digits of the stress at large strains.
    trial.min(curve(strain).0)
}

/// `q = σ_y (1 + ε_p/ε_0)^n`.
///
/// # Reference
/// H. W. Swift, *Plastic instability under plane stress*, J. Mech. Phys. Solids 1 (1952) 1–18.
#[derive(Debug, Clone, PartialEq)]
pub struct Swift {
    /// σ_y \[MPa\].
    pub(in crate::material) yield_stress: f64,
    /// ε_0.
    pub(in crate::material) strain_offset: f64,
    /// n.
    pub(in crate::material) exponent: f64,
    /// 3G \[MPa\].
    pub(in crate::material) triple_shear: f64,
}

impl HardeningLaw for Swift {
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        solve(self.triple_shear, self.yield_stress, equivalent_strain, |strain| {
            let base = 1.0 + strain / self.strain_offset;
            let stress = self.yield_stress * base.powf(self.exponent);
            (stress, self.exponent * stress / (base * self.strain_offset))
        })
    }
}

/// `q = σ_y + k ε_p^n`.
///
/// # Reference
/// P. Ludwik, *Elemente der technologischen Mechanik* (1909).
#[derive(Debug, Clone, PartialEq)]
pub struct Ludwik {
    /// σ_y \[MPa\].
    pub(in crate::material) yield_stress: f64,
    /// k \[MPa\].
    pub(in crate::material) coefficient: f64,
    /// n.
    pub(in crate::material) exponent: f64,
    /// 3G \[MPa\].
    pub(in crate::material) triple_shear: f64,
}

impl HardeningLaw for Ludwik {
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        solve(self.triple_shear, self.yield_stress, equivalent_strain, |strain| {
            let hardening = self.coefficient * strain.powf(self.exponent);
            (self.yield_stress + hardening, self.exponent * hardening / strain)
        })
    }
}

/// `q = σ_y + (σ_s - σ_y)(1 - exp(-b ε_p))`.
///
/// # Reference
/// E. Voce, *The relationship between stress and strain for homogeneous deformation*, J. Inst. Metals 74 (1948)
/// 537–562.
#[derive(Debug, Clone, PartialEq)]
pub struct Voce {
    /// σ_y \[MPa\].
    pub(in crate::material) yield_stress: f64,
    /// σ_s \[MPa\].
    pub(in crate::material) saturation_stress: f64,
    /// b.
    pub(in crate::material) rate: f64,
    /// 3G \[MPa\].
    pub(in crate::material) triple_shear: f64,
}

impl HardeningLaw for Voce {
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        let range = self.saturation_stress - self.yield_stress;
        solve(self.triple_shear, self.yield_stress, equivalent_strain, |strain| {
            let rest = range * (-self.rate * strain).exp();
            (self.saturation_stress - rest, self.rate * rest)
        })
    }
}
