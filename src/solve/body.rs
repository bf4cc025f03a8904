//! A deformable body: meshed, factorized once, condensed to its contact.

use std::sync::Arc;

use super::former::{Carried, FormerField};
use super::phases::{Phase, PhaseTimes};
use super::{Observer, SolveError};
use crate::assembly::{Equations, InitialStressRegion, Restraint, StiffnessAssembler, StressField};
use crate::element::{Kinematics, QUADRATURE_POINTS, element_stiffness};
use crate::linalg::dense::SymmetricMatrix;
use crate::linalg::{Cholesky, EliminationOrder, Graph, Reach, SymbolicCholesky};
use crate::mesh::Mesh;
use crate::model::{Deformable, Support};
use crate::plasticity::{HardeningLaw, UniaxialCurve};

/// How far from the contact plastic flow is expected to reach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PlasticReach {
    /// Up to this distance from the middle of the contact \[mm\].
    Within(f64),
    /// Anywhere.
    WholeBody,
}

/// Everything about one body that outlives an iteration.
pub(super) struct BodyModel {
    pub mesh: Arc<Mesh>,
    pub kinematics: Kinematics,
    pub material: Deformable,
    pub equations: Equations,
    /// The elastic stiffness, entry by entry of its pattern.
    elastic: Vec<f64>,
    /// Factor of the stiffness in force: elastic, or with the tangent moduli that [`Self::region`] refers to.
    pub factor: Cholesky,
    /// Inward normal displacement of the contact nodes under unit forces that press on them \[mm/N\].
    pub flexibility: SymmetricMatrix,
    /// Elements that may yield; `None` for an elastic body.
    pub region: Option<InitialStressRegion>,
    /// Last shell of that region; plastic flow beyond it has not been taken into account.
    pub last_shell: u32,
    /// Nodes that an iteration loads or reads.
    in_window: Vec<bool>,
    /// Their equations.
    pub window: Vec<u32>,
    /// Supernodes of the window.
    pub reach: Reach,
    /// Supernodes of the contact normals.
    pub contact_reach: Reach,
}

/// What a body model is made of.
#[derive(Clone, Copy)]
pub(super) struct BodyParts<'a> {
    pub kinematics: Kinematics,
    pub material: &'a Deformable,
    pub support: Support,
    pub plastic_reach: PlasticReach,
    /// Where to linearize the plastic law; elastic otherwise.
    pub former: Option<FormerField<'a>>,
}

impl BodyModel {
    /// Orders, assembles and factorizes the stiffness and reads the contact flexibility off the factor. Also returns the
    /// former displacements, carried to the window of this mesh.
    pub fn build(
        mesh: Mesh,
        parts: BodyParts<'_>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<(Self, Option<Vec<f64>>), SolveError> {
        let BodyParts { kinematics, material, support, plastic_reach, former } = parts;
        let (in_window, last_shell, equations, graph) = phases.time(Phase::Ordering, observer, || {
            let curve = UniaxialCurve::of(material);
            let last_shell = last_plastic_shell(&mesh, curve.as_ref(), plastic_reach);
            let in_window = window_nodes(&mesh, curve.is_some().then_some(last_shell));
            let graph = Graph::from_cells(mesh.nodes.len(), &mesh.elements);
            let order = EliminationOrder::new(&graph, &mesh.lattice, &in_window, &mesh.contact_nodes);
            let restraint = Restraint::new(&mesh, support);
            (in_window, last_shell, Equations::new(&order, &restraint, mesh.contact_nodes.len()), graph)
        });
        super::checkpoint(observer)?;
        let symbolic =
            phases.time(Phase::Symbolic, observer, || SymbolicCholesky::new(equations.pattern(&graph)))?;
        super::checkpoint(observer)?;
        let (window, reach, contact_reach) = phases.time(Phase::Symbolic, observer, || {
            let window = equations.of_nodes(&in_window);
            let reach = symbolic.reach(&window);
            (window, reach, symbolic.trailing_reach(mesh.contact_nodes.len()))
        });
        let elastic = phases.time(Phase::Assembly, observer, || {
            let (bulk, shear) = (material.elastic().bulk_modulus(), material.elastic().shear_modulus());
            let pattern = symbolic.pattern();
            let assembler = StiffnessAssembler { mesh: &mesh, kinematics, equations: &equations, pattern };
            assembler.assemble(|_, quad| element_stiffness(quad, bulk, &[shear; QUADRATURE_POINTS]))
        });
        let (region, carried) = phases.time(Phase::Plasticity, observer, || {
            let mut region = InitialStressRegion::new(&mesh, kinematics, &equations, last_shell, material);
            let carried = region.as_mut().zip(former).map(|(region, field)| {
                let carried = Carried::new(field, kinematics, &mesh, &in_window);
                linearize_by(region, &carried, &mesh, &equations, &window)
            });
            (region, carried)
        });
        let stiffness = Stiffness {
            mesh: &mesh,
            kinematics,
            equations: &equations,
            elastic: &elastic,
            region: region.as_ref(),
        };
        let (factor, flexibility) = stiffness.factorize(&symbolic, phases, observer)?;
        let model = Self {
            mesh: Arc::new(mesh),
            kinematics,
            material: material.clone(),
            equations,
            elastic,
            factor,
            flexibility,
            region,
            last_shell,
            in_window,
            window,
            reach,
            contact_reach,
        };
        Ok((model, carried))
    }

    /// Factorizes anew, with the tangent moduli at displacements on the window or, without any, the elastic ones.
    pub fn linearize(
        &mut self,
        u: Option<&[f64]>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError> {
        let Self { mesh, equations, region, .. } = self;
        let Some(region) = region else { return Ok(()) };
        phases.time(Phase::Plasticity, observer, || match u {
            Some(u) => region.linearize(|element, quad| {
                let nodes = mesh.elements[element];
                quad.strain(&nodes.map(|node| equations.of_node(node).map(|k| u[k as usize])))
            }),
            None => region.refer_to_elastic(),
        });
        self.factorize(phases, observer)
    }

    /// Factorizes anew, with the tangent moduli of an answer on another mesh; returns its displacements, carried to the
    /// window.
    pub fn linearize_by(
        &mut self,
        former: FormerField<'_>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<Vec<f64>, SolveError> {
        let Self { mesh, kinematics, equations, region, in_window, window, .. } = self;
        let Some(region) = region else { return Ok(self.zeros()) };
        let carried = phases.time(Phase::Plasticity, observer, || {
            let carried = Carried::new(former, *kinematics, mesh, in_window);
            linearize_by(region, &carried, mesh, equations, window)
        });
        self.factorize(phases, observer)?;
        Ok(carried)
    }

    fn factorize(&mut self, phases: &mut PhaseTimes, observer: &mut dyn Observer) -> Result<(), SolveError> {
        let symbolic = Arc::clone(self.factor.symbolic());
        let stiffness = Stiffness {
            mesh: &self.mesh,
            kinematics: self.kinematics,
            equations: &self.equations,
            elastic: &self.elastic,
            region: self.region.as_ref(),
        };
        (self.factor, self.flexibility) = stiffness.factorize(&symbolic, phases, observer)?;
        Ok(())
    }

    /// The stiffness of this body with other shear moduli, numbered and structured as the one in force.
    pub fn stiffness(&self, shear: impl Fn(usize) -> [f64; QUADRATURE_POINTS]) -> Vec<f64> {
        let bulk = self.material.elastic().bulk_modulus();
        let assembler = StiffnessAssembler {
            mesh: &self.mesh,
            kinematics: self.kinematics,
            equations: &self.equations,
            pattern: self.factor.symbolic().pattern(),
        };
        assembler.assemble(|element, quad| element_stiffness(quad, bulk, &shear(element)))
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
    pub fn press(&self, force: &[f64], load: &mut [f64]) {
        let start = self.equations.contact_start();
        for (entry, r) in load[start..].iter_mut().zip(force) {
            *entry -= r;
        }
    }

    /// `‖∫B̄ᵀσ dV - R‖` over the free components \[N/mm\].
    pub fn imbalance(&self, field: &StressField, force: &[f64]) -> f64 {
        let mut rest = self.zeros();
        self.press(force, &mut rest);
        for (node, internal) in (0u32..).zip(&field.internal_force) {
            for (&k, f) in self.equations.of_node(node).iter().zip(internal) {
                rest[k as usize] -= f;
            }
        }
        rest[..self.equations.len()].iter().map(|r| r * r).sum::<f64>().sqrt()
    }

    /// Whether plastic flow is looked for in every element; true as well where none can happen.
    pub fn covers_whole_body(&self) -> bool {
        self.region.is_none() || self.last_shell >= self.mesh.ring_count()
    }

    /// Whether the plastic region covers flow up to a distance from the middle of the contact \[mm\].
    pub fn prepared_for(&self, radius: f64) -> bool {
        self.covers_whole_body() || shells_within(&self.mesh, radius) <= self.last_shell
    }

    /// `[x, inward normal displacement]` of the nodes on the whole free surface, in order of x \[mm\].
    pub fn free_surface(&self, x: &[f64]) -> Vec<[f64; 2]> {
        let last_ray = self.mesh.lattice.iter().filter(|p| p.patch == 1).map(|p| p.i).max();
        let is_left_end = |ray: i32| !self.mesh.zone.symmetric && Some(ray) == last_ray;
        let mut surface: Vec<[f64; 2]> = (0u32..)
            .zip(&self.mesh.lattice)
            .filter(|(_, p)| if p.patch == 0 { p.j == 0 } else { p.i == 0 || is_left_end(p.i) })
            .map(|(node, _)| {
                let [_, normal] = self.equations.of_node(node);
                [self.mesh.nodes[node as usize][0], -x[normal as usize]]
            })
            .collect();
        surface.sort_by(|a, b| a[0].total_cmp(&b[0]));
        surface
    }

    /// Inward normal displacements of the contact nodes \[mm\].
    pub fn contact_displacement<'a>(&self, x: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        let start = self.equations.contact_start();
        x[start..start + self.mesh.contact_nodes.len()].iter().map(|u| -u)
    }
}

/// The stiffness matrix of a body.
struct Stiffness<'a> {
    mesh: &'a Mesh,
    kinematics: Kinematics,
    equations: &'a Equations,
    elastic: &'a [f64],
    region: Option<&'a InitialStressRegion>,
}

impl Stiffness<'_> {
    /// The factor, and the contact flexibility.
    fn factorize(
        &self,
        symbolic: &Arc<SymbolicCholesky>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<(Cholesky, SymmetricMatrix), SolveError> {
        let Self { mesh, kinematics, equations, elastic, region } = *self;
        let softened = phases.time(Phase::Assembly, observer, || {
            let region = region.filter(|region| !region.refers_to_elastic())?;
            let assembler = StiffnessAssembler { mesh, kinematics, equations, pattern: symbolic.pattern() };
            let mut values = elastic.to_vec();
            for (element, addition) in region.softened_elements() {
                assembler.add(&mut values, element, &addition);
            }
            Some(values)
        });
        let values = softened.as_deref().unwrap_or(elastic);
        super::checkpoint(observer)?;
        let factor = phases.time(Phase::Numeric, observer, || Cholesky::factor(symbolic, values))?;
        super::checkpoint(observer)?;
        let contacts = mesh.contact_nodes.len();
        let flexibility = phases.time(Phase::Flexibility, observer, || factor.trailing_inverse(contacts));
        Ok((factor, flexibility))
    }
}

/// Takes tangent moduli from a carried field; returns its displacements by equation, zero where nothing yields.
fn linearize_by(
    region: &mut InitialStressRegion,
    carried: &Carried,
    mesh: &Mesh,
    equations: &Equations,
    window: &[u32],
) -> Vec<f64> {
    region.linearize(|element, _| carried.strain(&mesh.elements[element]));
    let start: &[u32] = if region.refers_to_elastic() { &[] } else { window };
    carried.displacement_on(start, equations)
}

/// Shells around the expected plastic zone that are kept ready for it to grow into.
const SPARE_SHELLS: u32 = 3;

fn last_plastic_shell(mesh: &Mesh, curve: Option<&UniaxialCurve>, plastic_reach: PlasticReach) -> u32 {
    let has_yield_point = curve.is_some_and(|curve| curve.yield_stress() > 0.0);
    match plastic_reach {
        PlasticReach::Within(radius) if has_yield_point => {
            let outermost = shells_within(mesh, radius);
            (outermost + SPARE_SHELLS).min(mesh.ring_count())
        }
        _ => mesh.ring_count(),
    }
}

/// Outermost shell that reaches within a distance from the middle of the contact \[mm\].
fn shells_within(mesh: &Mesh, radius: f64) -> u32 {
    let centre = mesh.zone.centre();
    let is_near = |node: &u32| {
        let [x, y] = mesh.nodes[*node as usize];
        (x - centre).hypot(y) < radius
    };
    let touched = mesh.elements.iter().zip(&mesh.shells).filter(|(nodes, _)| nodes.iter().any(is_near));
    touched.map(|(_, &shell)| shell).max().unwrap_or(0)
}

/// The nodes of all elements that may yield, and in any case the contact nodes.
fn window_nodes(mesh: &Mesh, last_shell: Option<u32>) -> Vec<bool> {
    let mut inside = vec![false; mesh.nodes.len()];
    for &node in &mesh.contact_nodes {
        inside[node as usize] = true;
    }
    if let Some(last) = last_shell {
        for (nodes, _) in mesh.elements.iter().zip(&mesh.shells).filter(|(_, shell)| **shell <= last) {
            for &node in nodes {
                inside[node as usize] = true;
            }
        }
    }
    inside
}
