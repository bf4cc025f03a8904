//! Moduli by which the reference stiffness of an element falls short of the elastic one.

use crate::element::{ElementStiffness, QUADRATURE_POINTS, Quad};
use crate::plasticity::Moduli;

/// One value for each Gauss point.
type PerPoint = [f64; QUADRATURE_POINTS];

/// Pairs of components `[ε_xx, ε_yy, ε_zz, γ_xy]` in the upper triangle, row by row.
const PAIRS: [(usize, usize); 10] =
    [(0, 0), (0, 1), (0, 2), (0, 3), (1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (3, 3)];

/// `C = D_e - D` at the points of one element: upper triangle, point by point innermost \[MPa\].
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Softening {
    moduli: [PerPoint; 10],
}

impl Softening {
    /// Collects the moduli of all points; `None` where every point is elastic.
    pub fn new(points: &[Option<Moduli>; QUADRATURE_POINTS]) -> Option<Self> {
        if points.iter().all(Option::is_none) {
            return None;
        }
        let moduli = PAIRS.map(|(i, j)| points.map(|moduli| moduli.map_or(0.0, |moduli| moduli[i][j])));
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

    /// Takes `∫ Bᵀ C B dV` off a stiffness.
    pub fn apply(&self, quad: &Quad, stiffness: &mut ElementStiffness) {
        for node in 0..4 {
            for component in 0..2 {
                let mut unit = [[0.0; 2]; 4];
                unit[node][component] = 1.0;
                let forces = quad.nodal_forces(&self.stress(&quad.strain(&unit)));
                for (row, force) in stiffness.iter_mut().zip(forces) {
                    for (entry, f) in row[node].iter_mut().zip(force) {
                        entry[component] -= f;
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::{Kinematics, element_stiffness};

    /// Taking `2 (G - G') dev` off the stiffness with G leaves the stiffness with G'.
    #[test]
    fn softening_by_a_smaller_shear_modulus_is_the_stiffness_with_that_modulus() {
        let corners = [[1.0, 0.0], [3.0, 0.3], [3.4, 1.9], [0.8, 1.5]];
        let (bulk, whole, left) = (175.0, 80.0, 30.0);
        let isotropic = |i: usize, j: usize| match (i, j) {
            (3, 3) => whole - left,
            (3, _) | (_, 3) => 0.0,
            _ => 2.0 * (whole - left) * (f64::from(u8::from(i == j)) - 1.0 / 3.0),
        };
        let moduli: Moduli = std::array::from_fn(|i| std::array::from_fn(|j| isotropic(i, j)));
        for kinematics in [Kinematics::PlaneStrain, Kinematics::Axisymmetric] {
            let quad = Quad::new(&corners, kinematics);
            let mut stiffness = element_stiffness(&quad, bulk, &[whole; 4]);
            Softening::new(&[Some(moduli); 4]).unwrap().apply(&quad, &mut stiffness);
            let expected = element_stiffness(&quad, bulk, &[left; 4]);
            let difference = stiffness.iter().flatten().flatten().flatten();
            for (found, expected) in difference.zip(expected.iter().flatten().flatten().flatten()) {
                assert!((found - expected).abs() < 1e-9);
            }
        }
    }
}
