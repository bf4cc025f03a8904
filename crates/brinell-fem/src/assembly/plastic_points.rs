//! The plastic region, the part of a body that may yield, and the initial-stress load of its
//! plastic flow.
//!
//! ```text
//! P_e = Σ_elements ∫ Bᵀ σ_0 dV,   σ_0 = D_e ε - σ = 2 (G - G_s) e,   K_e u = R + P_e
//! ```
//!
//! The paper prints eq. (2.1) with a minus sign; with its eq. (2.3), only the plus sign satisfies
//! equilibrium.
//!
//! The reference stiffness need not be elastic. With moduli `D = D_e - C` the load is
//!
//! ```text
//! P = Σ ∫ Bᵀ (D ε - σ) dV = P_e - Σ ∫ Bᵀ C ε dV,   K u = R + P
//! ```
//!
//! and P changes the less between iterations, the closer D is to the tangent at the solution.
//!
//! # Reference
//! Jiang Jinqing, Shang Shiying, *A total initial-stress method for elasto-plastic contact
//! problems*, eqs. (2.1)–(2.5).

use std::fmt::Debug;
use std::sync::Arc;

use super::moduli_reduction::ElementReduction;
use super::{Equations, StressField, Unloaded, stress};
use crate::element::{ElementStiffness, QUADRATURE_POINTS, Quad};
use brinell_material::{
    ConstitutiveModel, ElasticModuli, HardeningLaw, PerPoint, ReferenceModuli,
};
use dense_cholesky::simd_dispatch;

/// A constitutive model with its state type erased. A body holds one and makes a plastic region
/// for each of its meshes.
pub trait MaterialModel: Debug + Send + Sync {
    /// Returns the elastic moduli.
    fn elastic(&self) -> ElasticModuli;

    /// The isotropic hardening law; `None` for a material that cannot yield.
    fn hardening(&self) -> Option<&dyn HardeningLaw>;

    /// Whether the stress depends on the strain path, so that loads are a history.
    fn has_memory(&self) -> bool;

    /// Factor of the stresses of [`Self::hardening`] at a place `[x, y]` of the undeformed body
    /// \[mm\].
    fn strength(&self, position: [f64; 2]) -> f64;

    /// Whether [`Self::strength`] varies over the body.
    fn varies_in_strength(&self) -> bool;

    /// Makes the plastic region of the elements of a mesh that are `inside`, at rest.
    fn points(
        self: Arc<Self>,
        unloaded: &Unloaded<'_>,
        equations: &Equations,
        inside: &[bool],
    ) -> Box<dyn PlasticPoints>;

    /// Returns the stresses at nodal displacements `[u_x, u_y]` \[mm\] after a straight path from
    /// rest.
    fn stress_field(&self, unloaded: &Unloaded<'_>, displacement: &[[f64; 2]]) -> StressField;
}

impl<M: ConstitutiveModel> MaterialModel for M {
    fn elastic(&self) -> ElasticModuli {
        ConstitutiveModel::elastic(self)
    }

    fn hardening(&self) -> Option<&dyn HardeningLaw> {
        ConstitutiveModel::hardening(self)
    }

    fn has_memory(&self) -> bool {
        ConstitutiveModel::has_memory(self)
    }

    fn strength(&self, position: [f64; 2]) -> f64 {
        ConstitutiveModel::strength(self, position)
    }

    fn varies_in_strength(&self) -> bool {
        ConstitutiveModel::varies_in_strength(self)
    }

    fn points(
        self: Arc<Self>,
        unloaded: &Unloaded<'_>,
        equations: &Equations,
        inside: &[bool],
    ) -> Box<dyn PlasticPoints> {
        let mut region = Region {
            model: self,
            elements: Vec::new(),
            states: Vec::new(),
            reductions: Vec::new(),
        };
        region.extend(unloaded, equations, inside, &[]);
        Box::new(region)
    }

    fn stress_field(&self, unloaded: &Unloaded<'_>, displacement: &[[f64; 2]]) -> StressField {
        stress::evaluate(self, unloaded, displacement, |element| {
            Some(unloaded.states(self, element))
        })
    }
}

/// A plastic region: Gauss points with their geometry, law, and states of the last accepted
/// increment.
pub trait PlasticPoints: Debug + Send + Sync {
    /// Refers the load to a stiffness with the moduli at the strains `[ε_xx, ε_yy, ε_zz, γ_xy]`.
    /// `strain` gives these for the points of an element, from its index in the mesh and its
    /// quadrilateral. The stiffness is elastic where no point is beyond yield.
    fn linearize(
        &mut self,
        reference: ReferenceModuli,
        strain: &mut dyn FnMut(usize, &Quad) -> [PerPoint; 4],
    );

    /// Refers the load to the elastic stiffness again.
    fn refer_to_elastic(&mut self);

    /// Whether the load refers to the elastic stiffness.
    fn refers_to_elastic(&self) -> bool;

    /// Calls a function for each element with a reduced stiffness, with its index in the mesh and
    /// the change of its stiffness.
    fn reduced_elements(&self, visit: &mut dyn FnMut(usize, &ElementStiffness));

    /// Overwrites `load` by the initial-stress load \[N/mm\] of the displacements `u` \[mm\]. Both
    /// are addressed by equation number and have one entry more than there are equations, for the
    /// held components; that entry of `load` is left zero. Returns the Gauss points beyond yield.
    fn evaluate(&self, u: &[f64], load: &mut [f64]) -> usize;

    /// Accepts an increment that ends at the displacements `u` \[mm\], by equation. Its states
    /// become the initial states of the next increment.
    fn commit(&mut self, u: &[f64]);

    /// Accepts an increment that ends at the strains of [`Self::linearize`].
    fn follow(&mut self, strain: &mut dyn FnMut(usize, &Quad) -> [PerPoint; 4]);

    /// Adds the elements that are `inside` to the region. Their states follow a straight path to
    /// the displacements `u` of the last accepted increment; `u` is empty before the first one.
    fn extend(
        &mut self,
        unloaded: &Unloaded<'_>,
        equations: &Equations,
        inside: &[bool],
        u: &[f64],
    );

    /// Returns the stresses of the region or of the whole body at nodal displacements
    /// `[u_x, u_y]` \[mm\], from the states of the last accepted increment; elements outside the
    /// region start from rest.
    fn stress_field(
        &self,
        unloaded: &Unloaded<'_>,
        displacement: &[[f64; 2]],
        extent: Extent,
    ) -> StressField;
}

/// Where stresses are evaluated; elsewhere they are zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// In the plastic region.
    Region,
    /// In the whole body.
    Body,
}

/// The region of one model.
#[derive(Debug)]
struct Region<M: ConstitutiveModel> {
    model: Arc<M>,
    elements: Vec<RegionElement>,
    /// One for each element.
    states: Vec<[M::State; QUADRATURE_POINTS]>,
    /// What [`RegionElement::reduction`] points to.
    reductions: Vec<ElementReduction>,
}

#[derive(Debug, Clone)]
struct RegionElement {
    quad: Quad,
    equations: [[u32; 2]; 4],
    /// Index in the mesh.
    index: usize,
    /// Index of its moduli reduction, if its reference stiffness is reduced.
    reduction: Option<usize>,
}

impl RegionElement {
    #[inline(always)]
    fn strain(&self, u: &[f64]) -> [PerPoint; 4] {
        self.quad.strain(&self.equations.map(|e| e.map(|k| u[k as usize])))
    }

    #[inline(always)]
    fn add_forces(&self, stress: &[PerPoint; 4], load: &mut [f64]) {
        let forces = self.quad.nodal_forces(stress);
        for (equations, force) in self.equations.iter().zip(forces) {
            for (&k, f) in equations.iter().zip(force) {
                load[k as usize] += f;
            }
        }
    }
}

impl<M: ConstitutiveModel> PlasticPoints for Region<M> {
    fn linearize(
        &mut self,
        reference: ReferenceModuli,
        strain: &mut dyn FnMut(usize, &Quad) -> [PerPoint; 4],
    ) {
        self.reductions.clear();
        let mut is_beyond_yield = false;
        for (element, states) in self.elements.iter_mut().zip(&self.states) {
            let strain = strain(element.index, &element.quad);
            let reduced: [_; QUADRATURE_POINTS] = std::array::from_fn(|g| {
                self.model.tangent(strain.map(|component| component[g]), &states[g], reference)
            });
            is_beyond_yield |= reduced.iter().flatten().any(|point| point.is_beyond_yield);
            element.reduction = ElementReduction::new(&reduced.map(|point| Some(point?.moduli)))
                .map(|reduction| {
                    self.reductions.push(reduction);
                    self.reductions.len() - 1
                });
        }
        if !is_beyond_yield {
            self.refer_to_elastic();
        }
    }

    fn refer_to_elastic(&mut self) {
        self.reductions.clear();
        for element in &mut self.elements {
            element.reduction = None;
        }
    }

    fn refers_to_elastic(&self) -> bool {
        self.reductions.is_empty()
    }

    fn reduced_elements(&self, visit: &mut dyn FnMut(usize, &ElementStiffness)) {
        for element in &self.elements {
            if let Some(k) = element.reduction {
                visit(
                    element.index,
                    &simd_dispatch(|| self.reductions[k].stiffness(&element.quad)),
                );
            }
        }
    }

    fn evaluate(&self, u: &[f64], load: &mut [f64]) -> usize {
        load.fill(0.0);
        let mut plastic_points = 0;
        simd_dispatch(|| {
            for (element, states) in self.elements.iter().zip(&self.states) {
                plastic_points += self.add_element(element, states, u, load);
            }
        });
        if let Some(held) = load.last_mut() {
            *held = 0.0;
        }
        plastic_points
    }

    fn commit(&mut self, u: &[f64]) {
        self.accept(|element| element.strain(u));
    }

    fn follow(&mut self, strain: &mut dyn FnMut(usize, &Quad) -> [PerPoint; 4]) {
        self.accept(|element| strain(element.index, &element.quad));
    }

    fn extend(
        &mut self,
        unloaded: &Unloaded<'_>,
        equations: &Equations,
        inside: &[bool],
        u: &[f64],
    ) {
        let mesh = unloaded.mesh;
        let mut is_new = inside.to_vec();
        for element in &self.elements {
            is_new[element.index] = false;
        }
        for index in (0..mesh.elements.len()).filter(|&element| is_new[element]) {
            let element = RegionElement {
                quad: Quad::new(&mesh.corners(index), unloaded.stress_state),
                equations: mesh.elements[index].map(|node| equations.of_node(node)),
                index,
                reduction: None,
            };
            let mut states = unloaded.states(&*self.model, index);
            if !u.is_empty() {
                let strain = element.strain(u);
                for (g, state) in states.iter_mut().enumerate() {
                    *state = self.model.update(strain.map(|component| component[g]), state).1;
                }
            }
            self.elements.push(element);
            self.states.push(states);
        }
    }

    fn stress_field(
        &self,
        unloaded: &Unloaded<'_>,
        displacement: &[[f64; 2]],
        extent: Extent,
    ) -> StressField {
        let mut place = vec![None; unloaded.mesh.elements.len()];
        for (k, element) in self.elements.iter().enumerate() {
            place[element.index] = Some(k);
        }
        stress::evaluate(&*self.model, unloaded, displacement, |element| match place[element] {
            Some(k) => Some(self.states[k]),
            None if extent == Extent::Body => Some(unloaded.states(&*self.model, element)),
            None => None,
        })
    }
}

impl<M: ConstitutiveModel> Region<M> {
    /// Moves the states of all points to these strains.
    fn accept(&mut self, mut strain: impl FnMut(&RegionElement) -> [PerPoint; 4]) {
        for (element, states) in self.elements.iter().zip(&mut self.states) {
            let strain = strain(element);
            for (g, state) in states.iter_mut().enumerate() {
                *state = self.model.update(strain.map(|component| component[g]), state).1;
            }
        }
    }

    #[inline(always)]
    fn add_element(
        &self,
        element: &RegionElement,
        states: &[M::State; QUADRATURE_POINTS],
        u: &[f64],
        load: &mut [f64],
    ) -> usize {
        let mut stress = element.strain(u);
        let reduced = element.reduction.map(|k| self.reductions[k].stress(&stress));
        let yielded = self.model.initial_stress(&mut stress, states);
        match (yielded, reduced) {
            (None, None) => return 0,
            (Some(_), None) => {}
            (None, Some(reduced)) => stress = reduced.map(|component| component.map(|s| -s)),
            (Some(_), Some(reduced)) => subtract(&mut stress, &reduced),
        }
        element.add_forces(&stress, load);
        yielded.unwrap_or(0)
    }
}

#[inline(always)]
fn subtract(a: &mut [PerPoint; 4], b: &[PerPoint; 4]) {
    for (a, b) in a.iter_mut().zip(b) {
        for g in 0..QUADRATURE_POINTS {
            a[g] -= b[g];
        }
    }
}
