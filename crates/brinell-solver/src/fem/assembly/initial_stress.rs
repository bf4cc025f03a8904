//! The initial-stress load of deformation plasticity.
//!
//! ```text
//! P_e = Σ_elements ∫ Bᵀ σ_0 dV,   σ_0 = D_e ε - σ = 2 (G - G_s) e,   K_e u = R + P_e
//! ```
//!
//! The paper prints its eq. (2.1) with a minus sign; with its own (2.3) only the plus satisfies equilibrium.
//!
//! The stiffness need not be the elastic one. With any moduli `D = D_e - C` in its place the same holds for the load
//!
//! ```text
//! P = Σ ∫ Bᵀ (D ε - σ) dV = P_e - Σ ∫ Bᵀ C ε dV,   K u = R + P
//! ```
//!
//! and the closer D is to the tangent of the law at the answer, the less P changes on the way there.
//!
//! # Reference
//! Jiang Jinqing, Shang Shiying, *A total initial-stress method for elasto-plastic contact problems*,
//! eqs. (2.1)–(2.5).

use super::softening::ModuliReduction;
use super::{Equations, out_of_plane};
use crate::fem::element::{ElementStiffness, QUADRATURE_POINTS, Quad, StressState};
use crate::fem::mesh::Mesh;
use crate::job::Deformable;
use crate::material::{OutOfPlane, PointLaw, ReferenceModuli};
use sparse_cholesky::wide;

/// The elements of a body that may yield, prepared for repeated evaluation.
#[derive(Debug, Clone)]
pub struct InitialStressRegion {
    elements: Vec<RegionElement>,
    law: PointLaw,
    /// What [`RegionElement::softening`] points to.
    softening: Vec<ModuliReduction>,
}

#[derive(Debug, Clone)]
struct RegionElement {
    quad: Quad,
    equations: [[u32; 2]; 4],
    /// Index in the mesh.
    index: usize,
    /// Where the moduli are by which its reference stiffness is softened, if it is.
    softening: Option<usize>,
}

impl InitialStressRegion {
    /// Takes the elements of the mesh that are `inside`; `None` for a material that cannot yield.
    pub fn new(
        mesh: &Mesh,
        stress_state: StressState,
        equations: &Equations,
        inside: &[bool],
        material: &Deformable,
    ) -> Option<Self> {
        let law = PointLaw::new(material, out_of_plane(stress_state));
        if !law.can_yield() {
            return None;
        }
        let elements = (0..mesh.elements.len())
            .filter(|&element| inside[element])
            .map(|element| RegionElement {
                quad: Quad::new(&mesh.corners(element), stress_state),
                equations: mesh.elements[element].map(|node| equations.of_node(node)),
                index: element,
                softening: None,
            })
            .collect();
        Some(Self { elements, law, softening: Vec::new() })
    }

    /// Refers the load to a stiffness with the tangent moduli at the strains `[ε_xx, ε_yy, ε_zz, γ_xy]` that `strain`
    /// gives for the points of each element of the region, from its index in the mesh and its quadrilateral; to the
    /// elastic stiffness where none of these strains is beyond yield.
    pub fn linearize(
        &mut self,
        reference: ReferenceModuli,
        mut strain: impl FnMut(usize, &Quad) -> [PerPoint; 4],
    ) {
        self.softening.clear();
        let mut is_beyond_yield = false;
        for element in &mut self.elements {
            let strain = strain(element.index, &element.quad);
            let softened =
                std::array::from_fn(|g| self.law.softening(strain.map(|component| component[g]), reference));
            is_beyond_yield |= softened.iter().flatten().any(|point| point.is_beyond_yield);
            element.softening =
                ModuliReduction::new(&softened.map(|point| Some(point?.moduli))).map(|softening| {
                    self.softening.push(softening);
                    self.softening.len() - 1
                });
        }
        if !is_beyond_yield {
            self.refer_to_elastic();
        }
    }

    /// Refers the load to the elastic stiffness again.
    pub fn refer_to_elastic(&mut self) {
        self.softening.clear();
        for element in &mut self.elements {
            element.softening = None;
        }
    }

    /// Whether the load refers to the elastic stiffness.
    pub fn refers_to_elastic(&self) -> bool {
        self.softening.is_empty()
    }

    /// The elements whose stiffness is softened, by their index in the mesh, and what that adds to it.
    pub fn softened_elements(&self) -> impl Iterator<Item = (usize, ElementStiffness)> {
        self.elements.iter().filter_map(|element| {
            let softening = &self.softening[element.softening?];
            Some((element.index, wide(|| softening.stiffness(&element.quad))))
        })
    }

    /// Overwrites `load` by the initial-stress load \[N/mm\] of the displacements `u` \[mm\]. Both are addressed
    /// by equation number and have one entry more than there are equations, for the held components; that entry
    /// of `load` is left zero. Returns the Gauss points beyond yield.
    pub fn evaluate(&self, u: &[f64], load: &mut [f64]) -> usize {
        load.fill(0.0);
        let mut plastic_points = 0;
        wide(|| {
            for element in &self.elements {
                plastic_points += self.add_element(element, u, load);
            }
        });
        if let Some(held) = load.last_mut() {
            *held = 0.0;
        }
        plastic_points
    }

    #[inline(always)]
    fn add_element(&self, element: &RegionElement, u: &[f64], load: &mut [f64]) -> usize {
        let displacement = element.equations.map(|e| e.map(|k| u[k as usize]));
        let mut stress = element.quad.strain(&displacement);
        let softened = element.softening.map(|k| self.softening[k].stress(&stress));
        let yielded = match self.law.out_of_plane() {
            OutOfPlane::Strained => self.initial_stress(&mut stress),
            OutOfPlane::Free => self.initial_stress_of_a_sheet(&mut stress),
        };
        match (yielded, softened) {
            (None, None) => return 0,
            (Some(_), None) => {}
            (None, Some(softened)) => stress = softened.map(|component| component.map(|s| -s)),
            (Some(_), Some(softened)) => subtract(&mut stress, &softened),
        }
        let forces = element.quad.nodal_forces(&stress);
        for (equations, force) in element.equations.iter().zip(forces) {
            for (&k, f) in equations.iter().zip(force) {
                load[k as usize] += f;
            }
        }
        yielded.unwrap_or(0)
    }

    /// Turns strains into initial stresses; returns the points that have yielded, or `None` where all are elastic.
    #[inline(always)]
    fn initial_stress(&self, strain: &mut [PerPoint; 4]) -> Option<usize> {
        let limit = self.law.elastic_limit();
        let squares = make_deviatoric(strain);
        // Comparing squares spares the root where nothing happens.
        if squares.iter().all(|&square| square <= limit * limit) {
            return None;
        }
        let mut yielded = 0;
        for (g, &square) in squares.iter().enumerate() {
            let (factor, beyond) = self.law.initial_stress_factor(square.sqrt());
            yielded += usize::from(beyond);
            for component in strain.iter_mut() {
                component[g] *= factor;
            }
            strain[3][g] *= 0.5;
        }
        Some(yielded)
    }

    /// The same where the thickness is free and ε_zz has to be found.
    fn initial_stress_of_a_sheet(&self, strain: &mut [PerPoint; 4]) -> Option<usize> {
        let mut yielded = 0;
        for g in 0..QUADRATURE_POINTS {
            let (stress, beyond) = self.law.initial_stress([strain[0][g], strain[1][g], 0.0, strain[3][g]]);
            yielded += usize::from(beyond);
            for (component, value) in strain.iter_mut().zip(stress) {
                component[g] = value;
            }
        }
        let loaded = strain.iter().flatten().any(|s| *s != 0.0);
        loaded.then_some(yielded)
    }
}

/// One value for each Gauss point.
type PerPoint = [f64; QUADRATURE_POINTS];

#[inline(always)]
fn subtract(a: &mut [PerPoint; 4], b: &[PerPoint; 4]) {
    for (a, b) in a.iter_mut().zip(b) {
        for g in 0..QUADRATURE_POINTS {
            a[g] -= b[g];
        }
    }
}

/// Takes the mean off the normal strains and returns `ε_q²` at each point.
#[inline(always)]
fn make_deviatoric(strain: &mut [PerPoint; 4]) -> PerPoint {
    let [x, y, z, shear] = strain;
    std::array::from_fn(|g| {
        let mean = (x[g] + y[g] + z[g]) / 3.0;
        x[g] -= mean;
        y[g] -= mean;
        z[g] -= mean;
        2.0 / 3.0 * (x[g] * x[g] + y[g] * y[g] + z[g] * z[g] + 0.5 * shear[g] * shear[g])
    })
}
