//! The reduction of the reference moduli of an element from the elastic ones.

use crate::element::{ElementStiffness, QUADRATURE_POINTS, Quad};
use brinell_material::{Moduli, PerPoint};

/// Pairs of components `[ε_xx, ε_yy, ε_zz, γ_xy]` in the upper triangle, row by row.
const PAIRS: [(usize, usize); 10] =
    [(0, 0), (0, 1), (0, 2), (0, 3), (1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (3, 3)];

/// `C = D_e - D` at the points of one element: upper triangle, point by point innermost \[MPa\].
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ElementReduction {
    moduli: [PerPoint; 10],
}

impl ElementReduction {
    /// Collects the moduli of all points; `None` where every point is elastic.
    pub fn new(points: &[Option<Moduli>; QUADRATURE_POINTS]) -> Option<Self> {
        if points.iter().all(Option::is_none) {
            return None;
        }
        let moduli =
            PAIRS.map(|(i, j)| points.map(|moduli| moduli.map_or(0.0, |moduli| moduli[(i, j)])));
        Some(Self { moduli })
    }

    /// `C ε`.
    #[inline(always)]
    pub fn stress(&self, strain: &[PerPoint; 4]) -> [PerPoint; 4] {
        let mut stress = [[0.0; QUADRATURE_POINTS]; 4];
        for (moduli, (i, j)) in self.moduli.iter().zip(PAIRS) {
            for g in 0..QUADRATURE_POINTS {
                stress[i][g] += moduli[g] * strain[j][g];
            }
            if i != j {
                for g in 0..QUADRATURE_POINTS {
                    stress[j][g] += moduli[g] * strain[i][g];
                }
            }
        }
        stress
    }

    /// Returns the change of the element stiffness, `-∫ Bᵀ C B dV`.
    #[inline(always)]
    #[expect(clippy::needless_range_loop, reason = "i and j address a block and its mirror image")]
    pub fn stiffness(&self, quad: &Quad) -> ElementStiffness {
        let mut stiffness = [[[[0.0; 2]; 2]; 4]; 4];
        let zero = [0.0; QUADRATURE_POINTS];
        for j in 0..4 {
            let (x, y, r) = (quad.gradient_x[j], quad.gradient_y[j], quad.over_radius[j]);
            let mut columns = [self.stress(&[x, zero, r, y]), self.stress(&[zero, y, zero, x])];
            for component in columns.iter_mut().flatten() {
                for (value, weight) in component.iter_mut().zip(&quad.weight) {
                    *value *= -weight;
                }
            }
            for i in j..4 {
                let (x, y, r) = (&quad.gradient_x[i], &quad.gradient_y[i], &quad.over_radius[i]);
                for (b, [xx, yy, zz, xy]) in columns.iter().enumerate() {
                    let (mut along_x, mut along_y) = (0.0, 0.0);
                    for g in 0..QUADRATURE_POINTS {
                        along_x += x[g] * xx[g] + r[g] * zz[g] + y[g] * xy[g];
                        along_y += y[g] * yy[g] + x[g] * xy[g];
                    }
                    for (a, value) in [along_x, along_y].into_iter().enumerate() {
                        stiffness[i][j][a][b] = value;
                        stiffness[j][i][b][a] = value;
                    }
                }
            }
        }
        stiffness
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::{StressState, element_stiffness};

    /// Reduced by `2 (G - G') dev`, the stiffness with G is that with G'.
    #[test]
    fn reduced_to_a_smaller_shear_modulus_the_stiffness_is_that_with_this_modulus() {
        let corners = [[1.0, 0.0], [3.0, 0.3], [3.4, 1.9], [0.8, 1.5]];
        let (bulk, whole, left) = (175.0, 80.0, 30.0);
        let isotropic = |i: usize, j: usize| match (i, j) {
            (3, 3) => whole - left,
            (3, _) | (_, 3) => 0.0,
            _ => 2.0 * (whole - left) * (f64::from(u8::from(i == j)) - 1.0 / 3.0),
        };
        let moduli = Moduli::from_fn(isotropic);
        for stress_state in [StressState::PlaneStrain, StressState::Axisymmetric] {
            let quad = Quad::new(&corners, stress_state);
            let elastic = element_stiffness(&quad, bulk, &[whole; 4]);
            let addition = ElementReduction::new(&[Some(moduli); 4]).unwrap().stiffness(&quad);
            let expected = element_stiffness(&quad, bulk, &[left; 4]);
            let entries =
                |k: &ElementStiffness| k.as_flattened().as_flattened().as_flattened().to_vec();
            let sum = entries(&elastic).into_iter().zip(entries(&addition)).map(|(a, b)| a + b);
            for (found, expected) in sum.zip(entries(&expected)) {
                assert!((found - expected).abs() < 1e-9);
            }
        }
    }
}
