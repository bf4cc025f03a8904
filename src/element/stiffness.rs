//! Stiffness matrix of one element.

use super::{QUADRATURE_POINTS, Quad};

/// `stiffness[i][j]` couples node i to node j: rows `[x, y]` of i, columns `[x, y]` of j \[N/mm per mm\].
pub type ElementStiffness = [[[[f64; 2]; 2]; 4]; 4];

/// B-bar stiffness `∫ B_devᵀ 2G B_dev dV + V K b̄ b̄ᵀ` for a bulk modulus K and shear moduli `G[g]` that may
/// differ from point to point (the secant stiffness of deformation theory) \[MPa\].
///
/// `b̄` is the mean divergence. The matrix is symmetric; all sixteen node blocks are filled.
pub fn element_stiffness(
    quad: &Quad,
    bulk_modulus: f64,
    shear_moduli: &[f64; QUADRATURE_POINTS],
) -> ElementStiffness {
    let mut stiffness = [[[[0.0; 2]; 2]; 4]; 4];
    let weighted: [f64; QUADRATURE_POINTS] = std::array::from_fn(|g| shear_moduli[g] * quad.weight[g]);
    let mean = quad.mean_divergence();
    let bulk = bulk_modulus * quad.volume();
    for i in 0..4 {
        for j in 0..=i {
            let (ix, iy) = (&quad.gradient_x[i], &quad.gradient_y[i]);
            let (jx, jy) = (&quad.gradient_x[j], &quad.gradient_y[j]);
            let (mut xx, mut xy, mut yx, mut yy) = (0.0, 0.0, 0.0, 0.0);
            for g in 0..QUADRATURE_POINTS {
                let w = weighted[g];
                // 2 dev(ε_i) : dev(ε_j) for unit displacements of i and j.
                xx += w * (4.0 / 3.0 * ix[g] * jx[g] + iy[g] * jy[g]);
                xy += w * (iy[g] * jx[g] - 2.0 / 3.0 * ix[g] * jy[g]);
                yx += w * (ix[g] * jy[g] - 2.0 / 3.0 * iy[g] * jx[g]);
                yy += w * (4.0 / 3.0 * iy[g] * jy[g] + ix[g] * jx[g]);
            }
            let volumetric = |a: usize, b: usize| bulk * mean[i][a] * mean[j][b];
            let block = [
                [xx + volumetric(0, 0), xy + volumetric(0, 1)],
                [yx + volumetric(1, 0), yy + volumetric(1, 1)],
            ];
            stiffness[i][j] = block;
            stiffness[j][i] = [[block[0][0], block[1][0]], [block[0][1], block[1][1]]];
        }
    }
    stiffness
}

#[cfg(test)]
mod tests {
    use super::super::Kinematics;
    use super::*;

    const SKEWED: [[f64; 2]; 4] = [[0.0, 0.0], [2.0, 0.3], [2.4, 1.9], [-0.2, 1.5]];

    fn apply(stiffness: &ElementStiffness, u: &[[f64; 2]; 4]) -> [[f64; 2]; 4] {
        std::array::from_fn(|i| {
            std::array::from_fn(|a| {
                (0..4).map(|j| (0..2).map(|b| stiffness[i][j][a][b] * u[j][b]).sum::<f64>()).sum()
            })
        })
    }

    #[test]
    fn rigid_motions_cost_nothing() {
        let quad = Quad::new(&SKEWED, Kinematics::PlaneStrain);
        let stiffness = element_stiffness(&quad, 175.0, &[80.0; 4]);
        for motion in [[[1.0, 0.0]; 4], [[0.0, 1.0]; 4], SKEWED.map(|[x, y]| [-y, x])] {
            for force in apply(&stiffness, &motion).iter().flatten() {
                assert!(force.abs() < 1e-11);
            }
        }
    }

    #[test]
    fn homogeneous_strain_gives_hookes_energy() {
        // σ = K tr ε + 2G dev ε for ε_xx = 1e-3, ε_yy = -2e-3, γ_xy = 3e-3.
        let quad = Quad::new(&SKEWED, Kinematics::PlaneStrain);
        let (bulk, shear) = (175.0, 80.0);
        let u = SKEWED.map(|[x, y]| [1e-3 * x + 1.5e-3 * y, 1.5e-3 * x - 2e-3 * y]);
        let forces = apply(&element_stiffness(&quad, bulk, &[shear; 4]), &u);
        let work: f64 = forces.iter().zip(&u).map(|(f, v)| f[0] * v[0] + f[1] * v[1]).sum();
        let trace = -1e-3f64;
        let deviator = [1e-3 - trace / 3.0, -2e-3 - trace / 3.0, -trace / 3.0];
        let norm = deviator.iter().map(|e| e * e).sum::<f64>() + 0.5 * 3e-3f64.powi(2);
        let expected = quad.volume() * (bulk * trace * trace + 2.0 * shear * norm);
        assert!((work - expected).abs() < 1e-12 * expected);
    }
}
