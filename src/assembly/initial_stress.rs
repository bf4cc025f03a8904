//! The initial-stress load of deformation plasticity.
//!
//! ```text
//! P_e = Σ_elements ∫ Bᵀ σ_0 dV,   σ_0 = D_e ε - σ = 2 (G - G_s) e,   K_e u = R + P_e
//! ```
//!
//! The paper prints its eq. (2.1) with a minus sign; with its own (2.3) only the plus satisfies equilibrium.
//!
//! # Reference
//! Jiang Jinqing, Shang Shiying, *A total initial-stress method for elasto-plastic contact problems*,
//! eqs. (2.1)–(2.5).

use super::Equations;
use crate::element::{Kinematics, QUADRATURE_POINTS, Quad};
use crate::mesh::Mesh;
use crate::plasticity::{HardeningLaw, UniaxialCurve};

/// The elements of a body that may yield, prepared for repeated evaluation.
#[derive(Debug, Clone)]
pub struct InitialStressRegion {
    elements: Vec<RegionElement>,
    curve: UniaxialCurve,
    shear_modulus: f64,
}

#[derive(Debug, Clone)]
struct RegionElement {
    quad: Quad,
    equations: [[u32; 2]; 4],
    /// Whether the element lies at the rim of the region.
    at_rim: bool,
}

/// What an evaluation found.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct PlasticUpdate {
    /// Gauss points beyond yield.
    pub plastic_points: usize,
    /// Whether one of them lies in the outermost shell of the region, so that flow may have left it.
    pub reached_rim: bool,
}

impl InitialStressRegion {
    /// Takes the elements whose shell is at most `last_shell`.
    pub fn new(
        mesh: &Mesh,
        kinematics: Kinematics,
        equations: &Equations,
        last_shell: u32,
        curve: UniaxialCurve,
        shear_modulus: f64,
    ) -> Self {
        let rim = if last_shell >= mesh.ring_count() { u32::MAX } else { last_shell };
        let inside = |element: &usize| mesh.shells[*element] <= last_shell;
        let elements = (0..mesh.elements.len())
            .filter(inside)
            .map(|element| RegionElement {
                quad: Quad::new(&mesh.corners(element), kinematics),
                equations: mesh.elements[element].map(|node| equations.of_node(node)),
                at_rim: mesh.shells[element] == rim,
            })
            .collect();
        Self { elements, curve, shear_modulus }
    }

    /// Overwrites `load` by the initial-stress load \[N/mm\] of the displacements `u` \[mm\]. Both are addressed
    /// by equation number and have one entry more than there are equations, for the held components; that entry
    /// of `load` is left zero.
    pub fn evaluate(&self, u: &[f64], load: &mut [f64]) -> PlasticUpdate {
        load.fill(0.0);
        let mut update = PlasticUpdate::default();
        // Below this equivalent strain a point is elastic; comparing squares spares the root.
        let limit = self.curve.yield_stress() / (3.0 * self.shear_modulus);
        for element in &self.elements {
            let displacement = element.equations.map(|e| e.map(|k| u[k as usize]));
            let mut stress = element.quad.strain(&displacement);
            let squares = make_deviatoric(&mut stress);
            if squares.iter().all(|&s| s <= limit * limit) {
                continue;
            }
            for (g, &square) in squares.iter().enumerate() {
                let equivalent = square.sqrt();
                let (factor, yielded) = self.initial_stress_factor(equivalent);
                update.plastic_points += usize::from(yielded);
                for component in &mut stress {
                    component[g] *= factor;
                }
                stress[3][g] *= 0.5;
            }
            update.reached_rim |= element.at_rim;
            let forces = element.quad.nodal_forces(&stress);
            for (equations, force) in element.equations.iter().zip(forces) {
                for (&k, f) in equations.iter().zip(force) {
                    load[k as usize] += f;
                }
            }
        }
        if let Some(held) = load.last_mut() {
            *held = 0.0;
        }
        update
    }

    /// `2 (G - G_s)` at an equivalent strain \[MPa\], and whether the point has yielded.
    fn initial_stress_factor(&self, equivalent_strain: f64) -> (f64, bool) {
        let elastic = 3.0 * self.shear_modulus * equivalent_strain;
        if elastic <= self.curve.yield_stress() {
            return (0.0, false);
        }
        let stress = self.curve.equivalent_stress(equivalent_strain);
        let plastic_strain = (elastic - stress) / (3.0 * self.shear_modulus);
        (2.0 / 3.0 * (elastic - stress) / equivalent_strain, self.curve.has_yielded(stress, plastic_strain))
    }
}

/// Takes the mean off the normal strains and returns `ε_q²` at each point.
fn make_deviatoric(strain: &mut [[f64; QUADRATURE_POINTS]; 4]) -> [f64; QUADRATURE_POINTS] {
    let [x, y, z, shear] = strain;
    std::array::from_fn(|g| {
        let mean = (x[g] + y[g] + z[g]) / 3.0;
        x[g] -= mean;
        y[g] -= mean;
        z[g] -= mean;
        2.0 / 3.0 * (x[g] * x[g] + y[g] * y[g] + z[g] * z[g] + 0.5 * shear[g] * shear[g])
    })
}
