//! The elastic part of a body, which load and hardening do not change: mesh, equations, elastic
//! stiffness.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::assembly::Support;
use crate::assembly::{Equations, PlasticPoints, Restraint, StiffnessAssembler};
use crate::element::{QUADRATURE_POINTS, Quad, SHAPE_AT_POINTS, StressState, element_stiffness};
use crate::engine::error::MeshedError;
use crate::mesh::{ContactZone, Mesh, Outline, Quality, Refinement};
use brinell_material::analytical::ElasticConstants;
use brinell_method::observer::Observer;
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use dense_cholesky::SymmetricMatrix;
use sparse_cholesky::{Cholesky, EliminationOrder, Graph, Reach, SymbolicCholesky};

/// The key of an elastic body: equal keys give equal bodies.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BodyKey {
    pub outline: Outline,
    pub zone: ContactZone,
    pub refinement: Refinement,
    pub stress_state: StressState,
    pub constants: ElasticConstants,
    pub support: Support,
}

/// An elastic body: all data that depend only on mesh, elastic constants and supports.
#[derive(Debug)]
pub(crate) struct ElasticBody {
    pub key: BodyKey,
    pub mesh: Arc<Mesh>,
    pub equations: Arc<Equations>,
    pub symbolic: Arc<SymbolicCholesky>,
    /// Supernodes of the equations that contact forces act on.
    pub contact_reach: Reach,
    restraint: Restraint,
    /// The support of a pin: forces by equation along the outward direction of the approach,
    /// spread evenly over its section, of resultant 1. `None` for a body with a support at its
    /// boundary.
    spread_support: Option<Vec<f64>>,
    bulk_modulus: f64,
    /// The elastic stiffness, entry by entry of its pattern.
    stiffness: Vec<f64>,
    quality: Quality,
}

impl ElasticBody {
    /// Meshes a body, orders and analyses its equations unless another body has the same ones, and
    /// assembles its stiffness.
    pub fn new(
        key: BodyKey,
        like: impl FnOnce(&dyn Fn(&Self) -> bool) -> Option<Arc<Self>>,
        run: &mut Run<'_>,
    ) -> Result<Self, MeshedError> {
        let BodyKey { outline, zone, refinement, constants, support, .. } = &key;
        let mesh = run.time(Phase::Mesh, || Mesh::generate(outline, zone, *refinement))?;
        run.checkpoint()?;
        // Here and not where it is reported: a job that is stopped must not wait for it.
        let quality = run.time(Phase::Mesh, || Quality::of(&mesh));
        run.checkpoint()?;
        let restraint = Restraint::new(&mesh, *support);
        let is_like = |body: &Self| body.is_structured_like(&mesh, &restraint);
        let (equations, symbolic) = match run.time(Phase::Ordering, || like(&is_like)) {
            Some(body) => (Arc::clone(&body.equations), Arc::clone(&body.symbolic)),
            None => structure(&mesh, &restraint, run)?,
        };
        let shear = constants.shear_modulus();
        let spread_support = key
            .outline
            .ring()
            .filter(|ring| ring.radius() > 0.0)
            .map(|_| spread_support(&mesh, &equations, key.stress_state));
        let mut body = Self {
            contact_reach: if spread_support.is_some() {
                symbolic.reach(&equations.of_nodes(&vec![true; mesh.nodes.len()]))
            } else {
                symbolic.trailing_reach(contact_equations(&mesh, &equations))
            },
            spread_support,
            mesh: Arc::new(mesh),
            equations,
            symbolic,
            restraint,
            bulk_modulus: constants.bulk_modulus(),
            stiffness: Vec::new(),
            quality,
            key,
        };
        run.checkpoint()?;
        body.stiffness =
            run.time(Phase::Assembly, || body.stiffness_with(|_| [shear; QUADRATURE_POINTS]));
        run.checkpoint()?;
        Ok(body)
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        self.mesh.bytes()
            + self.equations.bytes()
            + self.symbolic.bytes()
            + size_of_val(self.stiffness.as_slice())
            + self.spread_support.as_ref().map_or(0, |spread| size_of_val(spread.as_slice()))
    }

    /// Third direction.
    pub fn stress_state(&self) -> StressState {
        self.key.stress_state
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

    /// Factorizes the elastic stiffness, reduced at plastic points. Returns the contact
    /// flexibility of this stiffness.
    pub fn factorize(
        &self,
        factor: &mut Cholesky,
        points: Option<&dyn PlasticPoints>,
        run: &mut Run<'_>,
    ) -> Result<SymmetricMatrix, brinell_method::Error> {
        let values = run.time(Phase::Assembly, || self.softened_by(points));
        run.checkpoint()?;
        run.time_observed(Phase::Numeric, |observer| refactor(factor, values, observer))?;
        run.checkpoint()?;
        Ok(run.time(Phase::Flexibility, || self.flexibility(factor)))
    }

    /// Inward normal displacements of the contact nodes under unit forces that press on them, with
    /// a factor of this body \[mm/N\].
    pub fn flexibility(&self, factor: &Cholesky) -> SymmetricMatrix {
        let Self { mesh, equations, .. } = self;
        let count = contact_equations(mesh, equations);
        let inverse = factor.trailing_inverse(count);
        if mesh.contact_normals.is_empty() {
            return inverse;
        }
        let start = equations.len() - count;
        // Held components have no entry.
        let entries = |k: usize| -> Vec<(usize, f64)> {
            let components = self.normal_components(k).into_iter().filter(|(_, n)| *n != 0.0);
            components.map(|(equation, n)| (equation - start, n)).collect()
        };
        let entries: Vec<_> = (0..mesh.contact_nodes.len()).map(entries).collect();
        let fixed = SymmetricMatrix::from_fn(entries.len(), |i, j| {
            let products = entries[i].iter().flat_map(|&(row, n)| {
                let inverse = &inverse;
                entries[j].iter().map(move |&(column, m)| n * m * inverse[(row, column)])
            });
            products.sum()
        });
        let Some(spread) = &self.spread_support else { return fixed };
        // Displacements under the forces of the support.
        let mut held = spread.clone();
        factor.solve(&mut held);
        let own = dot(spread, &held);
        let closing = |k: usize| mesh.contact_normals[k][1];
        let outward: Vec<f64> = (0..entries.len())
            .map(|k| {
                self.normal_components(k).map(|(equation, n)| n * held[equation]).iter().sum()
            })
            .collect();
        SymmetricMatrix::from_fn(entries.len(), |i, j| {
            fixed[(i, j)] - closing(i) * outward[j] - closing(j) * outward[i]
                + closing(i) * closing(j) * own
        })
    }

    /// The equations of contact node `k` and the components of its normal; 0 for one that is held.
    fn normal_components(&self, k: usize) -> [(usize, f64); 2] {
        let [x, y] =
            self.equations.of_node(self.mesh.contact_nodes[k]).map(|equation| equation as usize);
        let [n_x, n_y] = self.mesh.contact_normals.get(k).copied().unwrap_or([0.0, 1.0]);
        [(x, if x < self.equations.len() { n_x } else { 0.0 }), (y, n_y)]
    }

    fn softened_by(&self, points: Option<&dyn PlasticPoints>) -> Vec<f64> {
        let mut values = self.stiffness.clone();
        if let Some(points) = points {
            let assembler = self.assembler();
            points.reduced_elements(&mut |element, addition| {
                assembler.add(&mut values, element, addition);
            });
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
        self.quality
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

    /// Whether forces spread over the whole body support it.
    pub fn has_spread_support(&self) -> bool {
        self.spread_support.is_some()
    }

    /// Adds contact forces that press on the body to a load vector, and the supporting forces of a
    /// pin.
    pub fn add_contact_forces(&self, force: &[f64], load: &mut [f64]) {
        if let Some(spread) = &self.spread_support {
            let total: f64 =
                force.iter().zip(&self.mesh.contact_normals).map(|(r, [_, e])| r * e).sum();
            for (entry, share) in load.iter_mut().zip(spread) {
                *entry += share * total;
            }
        }
        for (k, r) in force.iter().enumerate() {
            for (equation, component) in self.normal_components(k) {
                load[equation] -= component * r;
            }
        }
    }

    /// Inward normal displacements of the contact nodes \[mm\]; of a pin relative to the mean
    /// displacement of its section along the approach.
    pub fn contact_displacement(&self, x: &[f64]) -> impl Iterator<Item = f64> {
        let mean = self.spread_support.as_ref().map_or(0.0, |spread| dot(spread, x));
        (0..self.mesh.contact_nodes.len()).map(move |k| {
            let components = self.normal_components(k);
            let [along, across] = components.map(|(equation, component)| component * x[equation]);
            components[1].1 * mean - (along + across)
        })
    }

    /// `[x, inward normal displacement]` of the nodes on the whole free surface, in order of x
    /// \[mm\].
    pub fn free_surface(&self, x: &[f64]) -> Vec<[f64; 2]> {
        let mut surface: Vec<[f64; 2]> = self
            .mesh
            .free_surface_nodes
            .iter()
            .map(|&node| {
                let [_, normal] = self.equations.of_node(node);
                [self.mesh.nodes[node as usize][0], -x[normal as usize]]
            })
            .collect();
        surface.sort_by(|a, b| a[0].total_cmp(&b[0]));
        surface
    }
}

/// Forces along y by equation, spread evenly over the free nodes of a body, of resultant 1.
fn spread_support(mesh: &Mesh, equations: &Equations, stress_state: StressState) -> Vec<f64> {
    let mut spread = vec![0.0; equations.len() + 1];
    for (element, nodes) in mesh.elements.iter().enumerate() {
        let quad = Quad::new(&mesh.corners(element), stress_state);
        for (&node, shape) in nodes.iter().zip(SHAPE_AT_POINTS) {
            let share: f64 = shape.iter().zip(quad.weight).map(|(n, weight)| n * weight).sum();
            spread[equations.of_node(node)[1] as usize] += share;
        }
    }
    spread[equations.len()] = 0.0;
    let total: f64 = spread.iter().sum();
    for share in &mut spread {
        *share /= total;
    }
    spread
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Number of equations at the end that contact forces act on: the normal components of the contact
/// nodes, and before these the tangential ones where normals are inclined.
fn contact_equations(mesh: &Mesh, equations: &Equations) -> usize {
    let nodes = mesh.contact_nodes.len();
    if mesh.contact_normals.is_empty() {
        return nodes;
    }
    let is_free = |node: &&u32| (equations.of_node(**node)[0] as usize) < equations.len();
    nodes + mesh.contact_nodes.iter().filter(is_free).count()
}

/// Numbers the equations of a mesh, and analyses their factor.
fn structure(
    mesh: &Mesh,
    restraint: &Restraint,
    run: &mut Run<'_>,
) -> Result<(Arc<Equations>, Arc<SymbolicCholesky>), brinell_method::Error> {
    let (equations, graph) = run.time(Phase::Ordering, || {
        let graph = Graph::from_cells(mesh.nodes.len(), &mesh.elements);
        let order = EliminationOrder::new(&graph, &mesh.lattice, &mesh.contact_nodes);
        (Equations::new(&order, restraint, mesh.contact_nodes.len()), graph)
    });
    run.checkpoint()?;
    let pattern = run.time(Phase::Symbolic, || equations.pattern(&graph));
    run.checkpoint()?;
    let symbolic = run.time(Phase::Symbolic, || SymbolicCholesky::new(pattern))?;
    run.checkpoint()?;
    Ok((Arc::new(equations), symbolic))
}

/// Factorizes a stiffness in place of the last one; the observer can stop it.
pub(crate) fn refactor(
    factor: &mut Cholesky,
    values: Vec<f64>,
    observer: &mut dyn Observer,
) -> Result<(), brinell_method::Error> {
    let mut interrupt = None;
    let outcome = factor.refactor(values, &mut || match observer.on_checkpoint() {
        ControlFlow::Continue(()) => ControlFlow::Continue(()),
        ControlFlow::Break(wish) => {
            interrupt = Some(wish);
            ControlFlow::Break(())
        }
    });
    interrupt.map_or_else(
        || Ok(outcome?),
        |interrupt| Err(brinell_method::Error::Interrupted(interrupt)),
    )
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A cylinder with a contact of a hundredth of its radius.
    pub(crate) fn key(radius: f64, young: f64, support: Support) -> BodyKey {
        BodyKey {
            outline: Outline::arc(radius.recip(), radius, radius),
            zone: ContactZone::uniform(0.0, 0.01 * radius, 8, true),
            refinement: Refinement { growth: 1.3 },
            stress_state: StressState::PlaneStrain,
            constants: ElasticConstants { young_modulus: young, poisson_ratio: 0.3 },
            support,
        }
    }
}
