//! A body meshed and numbered, with its elastic stiffness: all that load and hardening do not change.

use std::ops::ControlFlow;
use std::sync::{Arc, OnceLock};

use crate::fem::assembly::{Equations, PlasticPoints, Restraint, StiffnessAssembler, Unloaded};
use crate::fem::element::{QUADRATURE_POINTS, StressState, element_stiffness};
use crate::fem::mesh::{ContactZone, Mesh, Outline, Quality, Refinement};
use crate::job::{Elastic, Support};
use crate::solver::error::checkpoint;
use crate::solver::phases::{Phase, PhaseTimes};
use crate::solver::{Observer, SolveError};
use sparse_cholesky::dense::SymmetricMatrix;
use sparse_cholesky::{Cholesky, EliminationOrder, Graph, Reach, SymbolicCholesky};

/// What an elastic body is made of: of equal keys come equal bodies.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BodyKey {
    pub outline: Outline,
    pub zone: ContactZone,
    pub refinement: Refinement,
    pub stress_state: StressState,
    pub constants: Elastic,
    pub support: Support,
}

/// What depends on mesh, elastic constants and supports alone.
#[derive(Debug)]
pub(crate) struct ElasticBody {
    pub key: BodyKey,
    pub mesh: Arc<Mesh>,
    pub equations: Arc<Equations>,
    pub symbolic: Arc<SymbolicCholesky>,
    /// Supernodes of the contact normals.
    pub contact_reach: Reach,
    restraint: Restraint,
    bulk_modulus: f64,
    /// The elastic stiffness, entry by entry of its pattern.
    stiffness: Vec<f64>,
    quality: OnceLock<Quality>,
}

impl ElasticBody {
    /// Meshes a body; orders and analyses its equations, unless there is another that has the same; assembles its
    /// stiffness.
    pub fn new(
        key: BodyKey,
        like: impl FnOnce(&dyn Fn(&Self) -> bool) -> Option<Arc<Self>>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<Self, SolveError> {
        let BodyKey { outline, zone, refinement, constants, support, .. } = &key;
        let mesh = phases.time(Phase::Mesh, observer, || Mesh::generate(outline, zone, *refinement))?;
        checkpoint(observer)?;
        let contacts = mesh.contact_nodes.len();
        let restraint = Restraint::new(&mesh, *support);
        let is_like = |body: &Self| body.is_structured_like(&mesh, &restraint);
        let (equations, symbolic) = match phases.time(Phase::Ordering, observer, || like(&is_like)) {
            Some(body) => (Arc::clone(&body.equations), Arc::clone(&body.symbolic)),
            None => structure(&mesh, &restraint, phases, observer)?,
        };
        let shear = constants.shear_modulus();
        let mut body = Self {
            mesh: Arc::new(mesh),
            contact_reach: symbolic.trailing_reach(contacts),
            equations,
            symbolic,
            restraint,
            bulk_modulus: constants.bulk_modulus(),
            stiffness: Vec::new(),
            quality: OnceLock::new(),
            key,
        };
        checkpoint(observer)?;
        body.stiffness =
            phases.time(Phase::Assembly, observer, || body.stiffness_with(|_| [shear; QUADRATURE_POINTS]));
        checkpoint(observer)?;
        Ok(body)
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        self.mesh.bytes()
            + self.equations.bytes()
            + self.symbolic.bytes()
            + size_of_val(self.stiffness.as_slice())
    }

    /// Third direction.
    pub fn stress_state(&self) -> StressState {
        self.key.stress_state
    }

    /// The body before any load.
    pub fn unloaded(&self) -> Unloaded<'_> {
        Unloaded { mesh: &self.mesh, stress_state: self.key.stress_state, initial_stress: None }
    }

    /// Whether a mesh has the same equations, wherever its nodes may lie.
    fn is_structured_like(&self, mesh: &Mesh, restraint: &Restraint) -> bool {
        let own = &*self.mesh;
        own.elements == mesh.elements
            && own.lattice == mesh.lattice
            && own.contact_nodes == mesh.contact_nodes
            && self.restraint == *restraint
    }

    /// The stiffness with other shear moduli at the points of each element.
    pub fn stiffness_with(&self, shear: impl Fn(usize) -> [f64; QUADRATURE_POINTS]) -> Vec<f64> {
        let bulk = self.bulk_modulus;
        self.assembler().assemble(|element, quad| element_stiffness(quad, bulk, &shear(element)))
    }

    /// Factorizes the elastic stiffness, softened where plastic points say so, in place of what the factor was of. Returns the
    /// contact flexibility that belongs to it.
    pub fn factorize(
        &self,
        factor: &mut Cholesky,
        points: Option<&dyn PlasticPoints>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<SymmetricMatrix, SolveError> {
        let values = phases.time(Phase::Assembly, observer, || self.softened_by(points));
        checkpoint(observer)?;
        phases.time_observed(Phase::Numeric, observer, |observer| refactor(factor, values, observer))?;
        checkpoint(observer)?;
        let contacts = self.mesh.contact_nodes.len();
        Ok(phases.time(Phase::Flexibility, observer, || factor.trailing_inverse(contacts)))
    }

    fn softened_by(&self, points: Option<&dyn PlasticPoints>) -> Vec<f64> {
        let mut values = self.stiffness.clone();
        if let Some(points) = points {
            let assembler = self.assembler();
            points.reduced_elements(&mut |element, addition| assembler.add(&mut values, element, addition));
        }
        values
    }

    fn assembler(&self) -> StiffnessAssembler<'_> {
        StiffnessAssembler {
            mesh: &self.mesh,
            stress_state: self.key.stress_state,
            equations: &self.equations,
            pattern: self.symbolic.pattern(),
        }
    }

    /// Quality of the mesh.
    pub fn quality(&self) -> Quality {
        *self.quality.get_or_init(|| Quality::of(&self.mesh))
    }

    /// A vector over the equations, zero, with the extra entry that stands for held components.
    pub fn zeros(&self) -> Vec<f64> {
        vec![0.0; self.equations.len() + 1]
    }

    /// Displacements `[u_x, u_y]` of every node \[mm\].
    pub fn nodal(&self, x: &[f64]) -> Vec<[f64; 2]> {
        (0u32..)
            .take(self.mesh.nodes.len())
            .map(|node| self.equations.of_node(node).map(|k| x[k as usize]))
            .collect()
    }

    /// Adds contact forces that press on the body to a load vector.
    pub fn add_contact_forces(&self, force: &[f64], load: &mut [f64]) {
        let start = self.equations.contact_start();
        for (entry, r) in load[start..].iter_mut().zip(force) {
            *entry -= r;
        }
    }

    /// Inward normal displacements of the contact nodes \[mm\].
    pub fn contact_displacement<'a>(&self, x: &'a [f64]) -> impl Iterator<Item = f64> + use<'a> {
        let start = self.equations.contact_start();
        x[start..start + self.mesh.contact_nodes.len()].iter().map(|u| -u)
    }

    /// `[x, inward normal displacement]` of the nodes on the whole free surface, in order of x \[mm\].
    pub fn free_surface(&self, x: &[f64]) -> Vec<[f64; 2]> {
        let mut surface: Vec<[f64; 2]> = self
            .mesh
            .free_surface_nodes()
            .map(|node| {
                let [_, normal] = self.equations.of_node(node);
                [self.mesh.nodes[node as usize][0], -x[normal as usize]]
            })
            .collect();
        surface.sort_by(|a, b| a[0].total_cmp(&b[0]));
        surface
    }
}

/// Numbers the equations of a mesh, and analyses their factor.
fn structure(
    mesh: &Mesh,
    restraint: &Restraint,
    phases: &mut PhaseTimes,
    observer: &mut dyn Observer,
) -> Result<(Arc<Equations>, Arc<SymbolicCholesky>), SolveError> {
    let (equations, graph) = phases.time(Phase::Ordering, observer, || {
        let graph = Graph::from_cells(mesh.nodes.len(), &mesh.elements);
        let order = EliminationOrder::new(&graph, &mesh.lattice, &mesh.contact_nodes);
        (Equations::new(&order, restraint, mesh.contact_nodes.len()), graph)
    });
    checkpoint(observer)?;
    let pattern = phases.time(Phase::Symbolic, observer, || equations.pattern(&graph));
    checkpoint(observer)?;
    let symbolic = phases.time(Phase::Symbolic, observer, || SymbolicCholesky::new(pattern))?;
    checkpoint(observer)?;
    Ok((Arc::new(equations), symbolic))
}

/// Factorizes a stiffness in place of the last one; the observer can stop it.
pub(crate) fn refactor(
    factor: &mut Cholesky,
    values: Vec<f64>,
    observer: &mut dyn Observer,
) -> Result<(), SolveError> {
    let mut interrupt = None;
    let outcome = factor.refactor(values, &mut || match observer.on_checkpoint() {
        ControlFlow::Continue(()) => ControlFlow::Continue(()),
        ControlFlow::Break(wish) => {
            interrupt = Some(wish);
            ControlFlow::Break(())
        }
    });
    interrupt.map_or_else(|| Ok(outcome?), |interrupt| Err(SolveError::Interrupted(interrupt)))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::job::{Cylinder, PoissonRatio, PositiveF64, Shape};

    /// A cylinder with a contact of a hundredth of its radius.
    pub(crate) fn key(radius: f64, young: f64, support: Support) -> BodyKey {
        let positive = |value: f64| PositiveF64::new(value).unwrap();
        BodyKey {
            outline: Outline::of(&Shape::Cylinder(Cylinder { radius: positive(radius) })),
            zone: ContactZone::uniform(0.0, 0.01 * radius, 8, true),
            refinement: Refinement { growth: 1.3 },
            stress_state: StressState::PlaneStrain,
            constants: Elastic {
                young_modulus: positive(young),
                poisson_ratio: PoissonRatio::new(0.3).unwrap(),
            },
            support,
        }
    }
}
