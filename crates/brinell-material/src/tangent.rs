//! Tangent moduli of deformation theory, for the reference stiffness of an iteration.
//!
//! ```text
//! dσ = D dε,   D = K 1⊗1 + 2 G_s dev - κ s'⊗s',   κ = 4/9 (3 G_s - H) / ε_q²
//! s' = [e_xx, e_yy, e_zz, γ_xy/2],   H = dq/dε_q
//! ```
//!
//! D is a reference only: the solution does not depend on D. Convergence is faster the closer D is
//! to the tangent at the solution. D must not be much softer than this tangent, or errors grow. At
//! the yield point the tangent jumps from 3G to a fraction of it, and the present iterate may lie
//! on the wrong side of the jump. So H and G_s are means over a range of strains, and a part of κ
//! is left out.

use nalgebra::Vector4;

use super::moduli::deviatoric_projection;
use super::{
    ElasticModuli, Moduli, ModuliReduction, OutOfPlane, ReferenceModuli, equivalent_strain,
};

/// The reduction at a trial strain deviator: the strain deviator of deformation theory or, for a
/// law with a memory, the deviator of the elastic strain if the increment were elastic, less the
/// backstress over 2G. `stress(f)` is the equivalent stress at which the law ends from f times
/// that trial, `yield_stress` its elastic limit \[MPa\]. `None` where the point is elastic, with
/// some margin.
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
    let range = reference.range();
    if trial_stress * (1.0 + range) <= yield_stress {
        return None;
    }
    let stress = |factor: f64| stress(factor).min(factor * trial_stress);
    let (below, above) = (stress(1.0 - range), stress(1.0 + range));
    let tangent = (above - below) / (2.0 * range * equivalent);
    let triple_secant = 0.5 * (below / (1.0 - range) + above / (1.0 + range)) / equivalent;
    let kappa = 4.0 / 9.0 * (1.0 - reference.left_out()) * (triple_secant - tangent)
        / (equivalent * equivalent);
    let [x, y, z, g] = trial;
    let direction = Vector4::new(x, y, z, 0.5 * g);
    let shear = (triple_secant / 3.0).max(reference.softest() * elastic.shear);
    let moduli = match out_of_plane {
        OutOfPlane::Strained => deviatoric_reduction(elastic.shear - shear, kappa, direction),
        OutOfPlane::PlaneStress => {
            let whole = condensed(elastic.matrix());
            whole
                - condensed(
                    elastic.matrix()
                        - deviatoric_reduction(elastic.shear - shear, kappa, direction),
                )
        }
    };
    Some(ModuliReduction { moduli, is_beyond_yield: trial_stress > yield_stress })
}

/// Moduli with σ_zz = 0 and ε_zz eliminated: `D_ij - D_i3 D_3j / D_33`.
fn condensed(moduli: Moduli) -> Moduli {
    moduli - moduli.column(2) * moduli.row(2) / moduli[(2, 2)]
}

/// `2 (G - G_s) dev + κ s'⊗s'`.
fn deviatoric_reduction(lost_shear: f64, kappa: f64, direction: Vector4<f64>) -> Moduli {
    2.0 * lost_shear * deviatoric_projection() + kappa * direction * direction.transpose()
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix4;

    use super::*;
    use crate::ConstitutiveModel;
    use crate::deformation::tests::law;

    /// The elastic moduli, condensed in plane stress.
    fn elastic(out_of_plane: OutOfPlane) -> Moduli {
        let law = law(out_of_plane);
        let stress = |k: usize| {
            let mut unit = [0.0; 4];
            unit[k] = 1e-6;
            law.update(unit, &()).0.stress.map(|s| s / 1e-6)
        };
        Matrix4::from_fn(|i, j| stress(j)[i])
    }

    /// Well beyond yield the curve is straight over the range of the means, so that H is exact;
    /// G_s is a mean, and a tenth of κ is left out on purpose.
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
                    let found = elastic[(i, j)] - reduction[(i, j)];
                    assert!(
                        (found - derivative).abs() < 0.05 * elastic[(i, i)],
                        "{out_of_plane:?} {i}{j}"
                    );
                }
            }
        }
    }

    #[test]
    fn it_is_symmetric_and_softer_than_elastic_but_not_unstable() {
        for out_of_plane in [OutOfPlane::Strained, OutOfPlane::PlaneStress] {
            let law = law(out_of_plane);
            let reduction = law
                .tangent([6e-3, -4e-3, 1e-3, 5e-3], &(), ReferenceModuli::Tangent)
                .unwrap()
                .moduli;
            let elastic = elastic(out_of_plane);
            let work = |moduli: &Moduli, e: Vector4<f64>| e.dot(&(moduli * e));
            for k in 0..200u32 {
                let e = Vector4::from(
                    [0, 1, 2, 3].map(|c| f64::from((k * 7919 + c * 104_729) % 101) - 50.0),
                );
                let (all, lost) = (work(&elastic, e), work(&reduction, e));
                assert!(lost >= -1e-9 * all && lost < all);
            }
            assert!((reduction - reduction.transpose()).amax() < 1e-9);
        }
    }

    #[test]
    fn an_elastic_point_keeps_its_moduli() {
        assert_eq!(
            law(OutOfPlane::Strained).tangent(
                [1e-3, -5e-4, 0.0, 0.0],
                &(),
                ReferenceModuli::Tangent
            ),
            None
        );
    }
}
