//! Tangent moduli of deformation theory, for the stiffness that an iteration refers to.
//!
//! ```text
//! dσ = D dε,   D = K 1⊗1 + 2 G_s dev - κ s'⊗s',   κ = 4/9 (3 G_s - H) / ε_q²
//! s' = [e_xx, e_yy, e_zz, γ_xy/2],   H = dq/dε_q
//! ```
//!
//! The stiffness is a reference only: whatever D is, the iteration ends in the same state. It ends sooner the closer D
//! is to the tangent of that state, and it must not be much softer, or errors there grow instead of falling. At
//! the yield point the tangent jumps from 3G to a fraction of it, and which side a point is on is known no better than
//! the state that D is taken from. So H and G_s are means over a range of strains, and a part of κ is left out.

use super::{ElasticModuli, OutOfPlane, equivalent_strain};

/// A symmetric matrix over `[ε_xx, ε_yy, ε_zz, γ_xy]` \[MPa\].
pub type Moduli = [[f64; 4]; 4];

/// By how much the moduli of reference of one point fall short of the elastic ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModuliReduction {
    /// `D_e - D` \[MPa\]. Positive semidefinite. The part over the mean strain is zero, except in plane stress, where ε_zz
    /// has been eliminated and its row and column are zero instead.
    pub moduli: Moduli,
    /// Whether the point is beyond yield, and not only near it.
    pub is_beyond_yield: bool,
}

/// Half of the range of equivalent strains that the moduli are means over, relative to the strain.
const RANGE: f64 = 0.07;
/// Least secant modulus over the elastic one. A wild iterate must not make the stiffness numerically singular.
const SOFTEST: f64 = 1e-3;

/// How near to the tangent the moduli are that an iteration refers to.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum ReferenceModuli {
    /// As near as errors in the strain allow.
    #[default]
    Tangent,
    /// In the middle between tangent and secant.
    Damped,
    /// The secant moduli of deformation theory. An iteration that takes them anew each time always ends (L. M. Kachanov),
    /// if slowly.
    Secant,
}

impl ReferenceModuli {
    /// The next stiffer ones; `None` after the stiffest of plastic flow.
    pub fn stiffer(self) -> Option<Self> {
        match self {
            Self::Tangent => Some(Self::Damped),
            Self::Damped => Some(Self::Secant),
            Self::Secant => None,
        }
    }

    /// Part of κ that counts.
    fn share(self) -> f64 {
        match self {
            Self::Tangent => 0.9,
            Self::Damped => 0.5,
            Self::Secant => 0.0,
        }
    }
}

/// The reduction at a trial strain deviator: the strain deviator of deformation theory or, for a law with a memory, the
/// deviator of the elastic strain if the increment were elastic, less the backstress over 2G. `stress(f)` is the
/// equivalent stress at which the law ends from f times that trial, `yield_stress` its elastic limit \[MPa\]. `None`
/// where the point is elastic, with some margin.
pub(super) fn reduction(
    elastic: ElasticModuli,
    out_of_plane: OutOfPlane,
    trial: [f64; 4],
    yield_stress: f64,
    stress: impl Fn(f64) -> f64,
    reference: ReferenceModuli,
) -> Option<ModuliReduction> {
    let equivalent = equivalent_strain(trial);
    let trial_stress = 3.0 * elastic.shear * equivalent;
    if trial_stress * (1.0 + RANGE) <= yield_stress {
        return None;
    }
    let stress = |factor: f64| stress(factor).min(factor * trial_stress);
    let (below, above) = (stress(1.0 - RANGE), stress(1.0 + RANGE));
    let tangent = (above - below) / (2.0 * RANGE * equivalent);
    let triple_secant = 0.5 * (below / (1.0 - RANGE) + above / (1.0 + RANGE)) / equivalent;
    let kappa = 4.0 / 9.0 * reference.share() * (triple_secant - tangent) / (equivalent * equivalent);
    let [x, y, z, g] = trial;
    let direction = [x, y, z, 0.5 * g];
    let shear = (triple_secant / 3.0).max(SOFTEST * elastic.shear);
    let moduli = match out_of_plane {
        OutOfPlane::Strained => deviatoric_reduction(elastic.shear - shear, kappa, direction),
        OutOfPlane::PlaneStress => {
            let whole = condensed_moduli(elastic, elastic.shear, 0.0, direction);
            let left = condensed_moduli(elastic, shear, kappa, direction);
            std::array::from_fn(|i| std::array::from_fn(|j| whole[i][j] - left[i][j]))
        }
    };
    Some(ModuliReduction { moduli, is_beyond_yield: trial_stress > yield_stress })
}

/// `K 1⊗1 + 2 G_s dev - κ s'⊗s'`, with σ_zz eliminated.
fn condensed_moduli(elastic: ElasticModuli, shear: f64, kappa: f64, direction: [f64; 4]) -> Moduli {
    let reduction = deviatoric_reduction(elastic.shear - shear, kappa, direction);
    let lame = elastic.lame();
    let whole = |i: usize, j: usize| match (i, j) {
        (3, 3) => elastic.shear,
        (3, _) | (_, 3) => 0.0,
        _ if i == j => lame + 2.0 * elastic.shear,
        _ => lame,
    };
    let full = |i: usize, j: usize| whole(i, j) - reduction[i][j];
    let condensed = |i: usize, j: usize| match (i, j) {
        (2, _) | (_, 2) => 0.0,
        _ => full(i, j) - full(i, 2) * full(2, j) / full(2, 2),
    };
    std::array::from_fn(|i| std::array::from_fn(|j| condensed(i, j)))
}

/// `2 (G - G_s) dev + κ s'⊗s'`.
fn deviatoric_reduction(lost_shear: f64, kappa: f64, direction: [f64; 4]) -> Moduli {
    let isotropic = |i: usize, j: usize| match (i, j) {
        (3, 3) => lost_shear,
        (3, _) | (_, 3) => 0.0,
        _ if i == j => 4.0 / 3.0 * lost_shear,
        _ => -2.0 / 3.0 * lost_shear,
    };
    std::array::from_fn(|i| std::array::from_fn(|j| isotropic(i, j) + kappa * direction[i] * direction[j]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::ConstitutiveModel;
    use crate::material::deformation::tests::law;

    /// The elastic moduli, condensed in plane stress.
    fn elastic(out_of_plane: OutOfPlane) -> Moduli {
        let law = law(out_of_plane);
        let stress = |k: usize| {
            let mut unit = [0.0; 4];
            unit[k] = 1e-6;
            law.update(unit, &()).0.stress.map(|s| s / 1e-6)
        };
        let columns: Moduli = std::array::from_fn(stress);
        std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]))
    }

    /// Well beyond yield the curve is straight over the range of the means, so that H is exact; G_s is a mean, and
    /// a tenth of κ is left out on purpose.
    #[test]
    fn it_is_the_derivative_of_the_stress_but_for_the_stiffening() {
        let strain = [6e-3, -4e-3, 1e-3, 5e-3];
        for out_of_plane in [OutOfPlane::Strained, OutOfPlane::PlaneStress] {
            let law = law(out_of_plane);
            let reduction = law.tangent(strain, &(), ReferenceModuli::Tangent).unwrap().moduli;
            let stress = |strain: [f64; 4]| law.update(strain, &()).0.stress;
            let elastic = elastic(out_of_plane);
            for j in [0, 1, 3] {
                let step = 1e-8;
                let (mut more, mut less) = (strain, strain);
                more[j] += step;
                less[j] -= step;
                let (more, less) = (stress(more), stress(less));
                for i in [0, 1, 3] {
                    let derivative = (more[i] - less[i]) / (2.0 * step);
                    let found = elastic[i][j] - reduction[i][j];
                    assert!((found - derivative).abs() < 0.05 * elastic[i][i], "{out_of_plane:?} {i}{j}");
                }
            }
        }
    }

    #[test]
    fn it_is_symmetric_and_softer_than_elastic_but_not_unstable() {
        for out_of_plane in [OutOfPlane::Strained, OutOfPlane::PlaneStress] {
            let law = law(out_of_plane);
            let reduction =
                law.tangent([6e-3, -4e-3, 1e-3, 5e-3], &(), ReferenceModuli::Tangent).unwrap().moduli;
            let elastic = elastic(out_of_plane);
            let work = |moduli: &Moduli, e: [f64; 4]| -> f64 {
                (0..4).flat_map(|i| (0..4).map(move |j| e[i] * moduli[i][j] * e[j])).sum()
            };
            for k in 0..200u32 {
                let e = [0, 1, 2, 3].map(|c| f64::from((k * 7919 + c * 104_729) % 101) - 50.0);
                let (all, lost) = (work(&elastic, e), work(&reduction, e));
                assert!(lost >= -1e-9 * all && lost < all);
            }
            for (i, row) in reduction.iter().enumerate() {
                for (entry, mirrored) in row.iter().zip(&reduction) {
                    assert!((entry - mirrored[i]).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn an_elastic_point_keeps_its_moduli() {
        assert_eq!(
            law(OutOfPlane::Strained).tangent([1e-3, -5e-4, 0.0, 0.0], &(), ReferenceModuli::Tangent),
            None
        );
    }
}
