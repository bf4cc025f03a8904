//! Stiffness matrix of one element.

use super::{QUADRATURE_POINTS, Quad, StressState};

/// `stiffness[i][j]` couples node i to node j: rows `[x, y]` of i, columns `[x, y]` of j \[N/mm
/// per mm\].
pub type ElementStiffness = [[[[f64; 2]; 2]; 4]; 4];

/// Stiffness of an element for a bulk modulus K and shear moduli `G[g]` that may differ from point
/// to point (the secant stiffness of deformation theory) \[MPa\].
///
/// ```text
/// plane strain, axisymmetry   ∫ 2G dev(ε):dev(ε) dV + V K (b̄ u)²   B-bar, b̄: mean divergence
/// plane stress                ∫ 2G ε:ε + λ' (ε_xx + ε_yy)² dV   λ' = 2Gλ/(λ + 2G), λ = K - 2G/3
/// ```
///
/// In plane stress the thickness is free to change, so that the element cannot lock and B is the
/// plain strain matrix. The matrix is symmetric; all sixteen node blocks are filled.
pub fn element_stiffness(
    quad: &Quad,
    bulk_modulus: f64,
    shear_moduli: &[f64; QUADRATURE_POINTS],
) -> ElementStiffness {
    let mut stiffness = [[[[0.0; 2]; 2]; 4]; 4];
    let mean = quad.mean_divergence();
    let bulk = match quad.stress_state {
        StressState::PlaneStrain | StressState::Axisymmetric => bulk_modulus * quad.volume(),
        StressState::PlaneStress => 0.0,
    };
    let moduli: [Moduli; QUADRATURE_POINTS] = std::array::from_fn(|g| {
        let shear = shear_moduli[g];
        Moduli {
            shear: quad.weight[g] * shear,
            dilatational: quad.weight[g]
                * dilatational_modulus(quad.stress_state, bulk_modulus, shear),
        }
    });
    for i in 0..4 {
        for j in 0..=i {
            let mut block = pair_stiffness(quad, &moduli, i, j);
            for (a, row) in block.iter_mut().enumerate() {
                for (b, entry) in row.iter_mut().enumerate() {
                    *entry += bulk * mean[i][a] * mean[j][b];
                }
            }
            stiffness[i][j] = block;
            stiffness[j][i] = [[block[0][0], block[1][0]], [block[0][1], block[1][1]]];
        }
    }
    stiffness
}

/// Weighted moduli of one point, in `2 G ε:ε + M (tr ε)²`.
#[derive(Clone, Copy)]
struct Moduli {
    shear: f64,
    dilatational: f64,
}

/// M: `-2G/3` turns ε:ε into its deviator's; λ' is what a free thickness leaves of λ.
fn dilatational_modulus(stress_state: StressState, bulk_modulus: f64, shear: f64) -> f64 {
    match stress_state {
        StressState::PlaneStrain | StressState::Axisymmetric => -2.0 / 3.0 * shear,
        StressState::PlaneStress => {
            let lame = bulk_modulus - 2.0 / 3.0 * shear;
            2.0 * shear * lame / (lame + 2.0 * shear)
        }
    }
}

/// `∫ 2G ε_i:ε_j + M tr ε_i tr ε_j dV` for unit displacements of nodes i and j.
fn pair_stiffness(
    quad: &Quad,
    moduli: &[Moduli; QUADRATURE_POINTS],
    i: usize,
    j: usize,
) -> [[f64; 2]; 2] {
    let (ix, iy, ir) = (&quad.gradient_x[i], &quad.gradient_y[i], &quad.over_radius[i]);
    let (jx, jy, jr) = (&quad.gradient_x[j], &quad.gradient_y[j], &quad.over_radius[j]);
    let (mut xx, mut xy, mut yx, mut yy) = (0.0, 0.0, 0.0, 0.0);
    for (g, moduli) in moduli.iter().enumerate() {
        let Moduli { shear, dilatational } = *moduli;
        let (it, jt) = (ix[g] + ir[g], jx[g] + jr[g]);
        xx += shear * (2.0 * (ix[g] * jx[g] + ir[g] * jr[g]) + iy[g] * jy[g])
            + dilatational * it * jt;
        xy += shear * iy[g] * jx[g] + dilatational * it * jy[g];
        yx += shear * ix[g] * jy[g] + dilatational * iy[g] * jt;
        yy += shear * (2.0 * iy[g] * jy[g] + ix[g] * jx[g]) + dilatational * iy[g] * jy[g];
    }
    [[xx, xy], [yx, yy]]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SKEWED: [[f64; 2]; 4] = [[1.0, 0.0], [3.0, 0.3], [3.4, 1.9], [0.8, 1.5]];

    fn apply(stiffness: &ElementStiffness, u: &[[f64; 2]; 4]) -> [[f64; 2]; 4] {
        std::array::from_fn(|i| {
            std::array::from_fn(|a| {
                (0..4).map(|j| (0..2).map(|b| stiffness[i][j][a][b] * u[j][b]).sum::<f64>()).sum()
            })
        })
    }

    fn work(quad: &Quad, moduli: (f64, f64), u: &[[f64; 2]; 4]) -> f64 {
        let forces = apply(&element_stiffness(quad, moduli.0, &[moduli.1; 4]), u);
        forces.iter().zip(u).map(|(f, v)| f[0] * v[0] + f[1] * v[1]).sum()
    }

    #[test]
    fn rigid_motions_cost_nothing() {
        let rotation = SKEWED.map(|[x, y]| [-y, x]);
        for stress_state in [StressState::PlaneStrain, StressState::PlaneStress] {
            let quad = Quad::new(&SKEWED, stress_state);
            for motion in [[[1.0, 0.0]; 4], [[0.0, 1.0]; 4], rotation] {
                assert!(work(&quad, (175.0, 80.0), &motion).abs() < 1e-10);
            }
        }
        let quad = Quad::new(&SKEWED, StressState::Axisymmetric);
        assert!(work(&quad, (175.0, 80.0), &[[0.0, 1.0]; 4]).abs() < 1e-10);
    }

    #[test]
    fn homogeneous_strain_has_hookes_energy() {
        // K (tr ε)² + 2G dev ε : dev ε for ε_xx = 1e-3, ε_yy = -2e-3, γ_xy = 3e-3 and the ε_zz of
        // each case.
        let (bulk, shear) = (175.0, 80.0);
        let lame: f64 = bulk - 2.0 / 3.0 * shear;
        let u = SKEWED.map(|[x, y]| [1e-3 * x + 1.5e-3 * y, 1.5e-3 * x - 2e-3 * y]);
        let in_plane = -1e-3;
        for (stress_state, zz) in [
            (StressState::PlaneStrain, 0.0),
            (StressState::PlaneStress, -lame * in_plane / (lame + 2.0 * shear)),
        ] {
            let trace = in_plane + zz;
            let deviator = [1e-3 - trace / 3.0, -2e-3 - trace / 3.0, zz - trace / 3.0];
            let norm = deviator.iter().map(|e| e * e).sum::<f64>() + 0.5 * 3e-3f64.powi(2);
            let quad = Quad::new(&SKEWED, stress_state);
            let expected = quad.volume() * (bulk * trace * trace + 2.0 * shear * norm);
            let found = work(&quad, (bulk, shear), &u);
            assert!(
                (found - expected).abs() < 1e-12 * expected.abs().max(1e-6),
                "{stress_state:?}: {found} {expected}"
            );
        }
        // ε_xx = ε_zz = 1e-3 in a body of revolution.
        let quad = Quad::new(&SKEWED, StressState::Axisymmetric);
        let u = SKEWED.map(|[x, y]| [1e-3 * x, -2e-3 * y]);
        let expected = quad.volume() * 2.0 * shear * (6.0 * 1e-6);
        assert!((work(&quad, (bulk, shear), &u) - expected).abs() < 1e-11 * expected);
    }
}
