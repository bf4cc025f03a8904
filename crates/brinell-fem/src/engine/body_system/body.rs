//! A deformable body: its factor, its contact flexibility and its plastic region.

use std::sync::Arc;

use crate::assembly::{
    Extent, MaterialModel, PlasticPoints, PointStresses, StressField, Unloaded, given_stress,
    initial_force, relaxed_stress,
};
use crate::element::Quad;
use crate::engine::body_system::elastic_body::ElasticBody;
use crate::engine::body_system::factor_cache::PooledFactor;
use crate::engine::body_system::plastic_search_region::{PlasticSearchRegion, nodes_of};
use crate::engine::body_system::transfer::{NodalField, Places, TransferredField};
use crate::engine::problem::GivenStress;
use crate::mesh::Mesh;
use brinell_material::{ElasticModuli, ReferenceModuli};
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use dense_cholesky::SymmetricMatrix;
use sparse_cholesky::{Cholesky, Reach};

/// The data of one body that persist between iterations.
pub(crate) struct BodyModel {
    pub elastic: Arc<ElasticBody>,
    pub model: Arc<dyn MaterialModel>,
    pub plastic_region: PlasticRegion,
    /// Factor of the present stiffness: elastic, or with the tangent moduli that
    /// [`PlasticRegion::points`] refers to.
    pub factor: PooledFactor,
    /// Inward normal displacement of the contact nodes under unit forces that press on them
    /// \[mm/N\].
    pub flexibility: SymmetricMatrix,
    /// Whether the present stiffness is softer than the elastic one; `None` before there is one.
    is_softened: Option<bool>,
    /// Stress of the unloaded body.
    pub initial_stress: Option<Arc<InitialState>>,
}

/// The residual stress of a body before any load, after relaxation to equilibrium.
#[derive(Debug)]
pub(crate) struct InitialState {
    /// At the points of each element \[MPa\].
    pub stress: Arc<PointStresses>,
    /// `∫ Bᵀ σ dV` by equation: not zero where the mesh does not integrate a stress exactly that
    /// is in equilibrium.
    force: Vec<f64>,
}

/// The material of a body and its state.
#[derive(Clone, Copy)]
pub(crate) struct BodyMaterial<'a> {
    pub model: &'a Arc<dyn MaterialModel>,
    pub initial_stress: Option<&'a GivenStress>,
}

/// The plastic region of a body.
pub(crate) struct PlasticRegion {
    /// Whether each element belongs to it.
    elements: Vec<bool>,
    /// Whether each node is active: a node of the region's elements or a contact node.
    nodes: Vec<bool>,
    /// The equations of the active nodes.
    pub active_equations: Vec<u32>,
    /// Supernodes of the active equations.
    pub reach: Reach,
    /// The Gauss points of the region; `None` for a body that cannot yield.
    pub points: Option<Box<dyn PlasticPoints>>,
}

impl BodyModel {
    /// Factorizes the elastic stiffness or, given a previous field, the stiffness with the tangent
    /// moduli there, unless it `is_linearized_later`. Also returns the previous displacements,
    /// transferred to the active equations.
    pub fn new(
        elastic: Arc<ElasticBody>,
        mut factor: PooledFactor,
        material: BodyMaterial<'_>,
        search_region: PlasticSearchRegion,
        previous: Option<NodalField<'_>>,
        is_linearized_later: bool,
        run: &mut Run<'_>,
    ) -> Result<(Self, Option<Vec<f64>>), brinell_method::Error> {
        let BodyMaterial { model, initial_stress } = material;
        let initial_stress = match initial_stress {
            Some(given) => {
                elastic.factorize(&mut factor, None, run)?;
                Some(Arc::new(InitialState::relaxed(&elastic, &factor, model.elastic(), given)))
            }
            None => None,
        };
        let (plastic_region, transferred) = run.time(Phase::Plasticity, || {
            let mut plastic_region =
                PlasticRegion::new(&elastic, model, initial_stress.as_deref(), search_region);
            let transferred = previous.map(|field| plastic_region.linearize_by(field, &elastic));
            (plastic_region, transferred)
        });
        run.checkpoint()?;
        let mut body = Self {
            elastic,
            model: Arc::clone(model),
            plastic_region,
            factor,
            flexibility: SymmetricMatrix::from_fn(0, |_, _| 0.0),
            is_softened: None,
            initial_stress,
        };
        if !is_linearized_later {
            body.factorize(run)?;
        }
        Ok((body, transferred))
    }

    /// Chooses another plastic region. The stiffness becomes elastic again at the next
    /// linearization.
    pub fn set_plastic_region(&mut self, search_region: PlasticSearchRegion) {
        self.plastic_region = PlasticRegion::new(
            &self.elastic,
            &self.model,
            self.initial_stress.as_deref(),
            search_region,
        );
    }

    /// Factorizes again, with the moduli of plastic flow at given displacements; without
    /// displacements, with the elastic moduli.
    pub fn linearize(
        &mut self,
        at: Option<(&[f64], ReferenceModuli)>,
        run: &mut Run<'_>,
    ) -> Result<(), brinell_method::Error> {
        let ElasticBody { mesh, equations, .. } = &*self.elastic;
        if let Some(points) = &mut self.plastic_region.points {
            run.time(Phase::Plasticity, || match at {
                Some((u, reference)) => points.linearize(reference, &mut |element, quad| {
                    let nodes = mesh.elements[element];
                    quad.strain(&nodes.map(|node| equations.of_node(node).map(|k| u[k as usize])))
                }),
                None => points.refer_to_elastic(),
            });
        }
        self.factorize(run)
    }

    /// Factorizes again, with the tangent moduli of an answer on another mesh. Returns the
    /// displacements of this answer, transferred to the active equations.
    pub fn linearize_by(
        &mut self,
        previous: NodalField<'_>,
        run: &mut Run<'_>,
    ) -> Result<Vec<f64>, brinell_method::Error> {
        let Self { elastic, plastic_region, .. } = self;
        let transferred =
            run.time(Phase::Plasticity, || plastic_region.linearize_by(previous, elastic));
        self.factorize(run)?;
        Ok(transferred)
    }

    /// Factorizes again, with the tangent moduli after the last of the changes of displacement that
    /// are known on another mesh. States follow the other changes one after the other. Returns the
    /// displacements after the last one.
    pub fn linearize_after(
        &mut self,
        from: &[f64],
        changes: &[NodalField<'_>],
        run: &mut Run<'_>,
    ) -> Result<Vec<f64>, brinell_method::Error> {
        let Self { elastic, plastic_region, .. } = self;
        let after =
            run.time(Phase::Plasticity, || plastic_region.linearize_after(from, changes, elastic));
        self.factorize(run)?;
        Ok(after)
    }

    /// Enlarges the plastic region.
    pub fn extend_plastic_region(&mut self, search_region: PlasticSearchRegion, accepted: &[f64]) {
        let Self { elastic, model, plastic_region, initial_stress, .. } = self;
        plastic_region.extend(
            elastic,
            &**model,
            initial_stress.as_deref(),
            search_region,
            accepted,
        );
    }

    fn factorize(&mut self, run: &mut Run<'_>) -> Result<(), brinell_method::Error> {
        let is_softened = self.plastic_region.is_softened();
        if is_softened || self.is_softened != Some(false) {
            let points = self.plastic_region.points.as_deref();
            self.flexibility = self.elastic.factorize(&mut self.factor, points, run)?;
            self.is_softened = Some(is_softened);
        }
        Ok(())
    }

    /// Stresses at displacements of all nodes. A body that cannot yield has no region.
    pub fn stress_field(&self, nodal: &[[f64; 2]], extent: Extent) -> StressField {
        let unloaded = self.unloaded();
        match &self.plastic_region.points {
            Some(points) => points.stress_field(&unloaded, nodal, extent),
            None if extent == Extent::Region => StressField::zeros(&self.elastic.mesh),
            None => self.model.stress_field(&unloaded, nodal),
        }
    }

    /// The body before any load.
    fn unloaded(&self) -> Unloaded<'_> {
        unloaded(&self.elastic, self.initial_stress.as_deref())
    }

    /// `‖∫B̄ᵀσ dV - R‖` over the free components \[N/mm\].
    pub fn residual_norm(&self, field: &StressField, force: &[f64]) -> f64 {
        let equations = &self.elastic.equations;
        let mut rest = self.elastic.zeros();
        self.elastic.add_contact_forces(force, &mut rest);
        if let Some(initial) = &self.initial_stress {
            rest.iter_mut().zip(&initial.force).for_each(|(rest, force)| *rest += force);
        }
        for (node, internal) in (0u32..).zip(&field.internal_force) {
            for (&k, f) in equations.of_node(node).iter().zip(internal) {
                rest[k as usize] -= f;
            }
        }
        rest[..equations.len()].iter().map(|r| r * r).sum::<f64>().sqrt()
    }

    /// Returns `∫ σ_r : ε dV`, the work of the residual stress on displacements of all nodes \[N
    /// mm\] or \[N\]. It is zero for a stress in equilibrium. Below a plane it is the work of the
    /// tractions on the side walls of the cut-out part.
    pub fn work_of_initial_stress(&self, nodal: &[[f64; 2]]) -> f64 {
        let Some(initial) = &self.initial_stress else { return 0.0 };
        let free = self.elastic.equations.len();
        let of_node = |(node, u): (u32, &[f64; 2])| -> f64 {
            let equations =
                self.elastic.equations.of_node(node).into_iter().map(|k| k as usize).zip(u);
            equations.filter(|(k, _)| *k < free).map(|(k, u)| initial.force[k] * u).sum()
        };
        (0u32..).zip(nodal).map(of_node).sum()
    }

    /// Whether the material yields outside the plastic region.
    pub fn yields_outside_region(&self, field: &StressField) -> bool {
        self.plastic_region.points.is_some()
            && field
                .points
                .iter()
                .zip(&self.plastic_region.elements)
                .any(|(points, inside)| !inside && points.iter().any(|point| point.yielded))
    }
}

impl PlasticRegion {
    fn new(
        elastic: &ElasticBody,
        model: &Arc<dyn MaterialModel>,
        initial: Option<&InitialState>,
        search_region: PlasticSearchRegion,
    ) -> Self {
        let ElasticBody { mesh, equations, symbolic, .. } = elastic;
        let elements = searched_elements(mesh, &**model, search_region);
        let nodes = active_nodes(elastic, &elements);
        let active_equations = equations.of_nodes(&nodes);
        let reach = symbolic.reach(&active_equations);
        let points = model
            .hardening()
            .map(|_| Arc::clone(model).points(&unloaded(elastic, initial), equations, &elements));
        Self { elements, nodes, active_equations, reach, points }
    }

    /// Takes the tangent moduli of an answer on another mesh; returns its displacements on the
    /// active equations, zero where nothing yields.
    fn linearize_by(&mut self, previous: NodalField<'_>, elastic: &ElasticBody) -> Vec<f64> {
        let ElasticBody { mesh, equations, .. } = elastic;
        let Some(points) = &mut self.points else { return elastic.zeros() };
        let places = Places::of(mesh, &self.nodes, previous.mesh);
        let transferred = TransferredField::new(previous, elastic.stress_state(), &places);
        points.linearize(ReferenceModuli::Tangent, &mut |element, _| {
            transferred.strain(&mesh.elements[element])
        });
        let start: &[u32] = if points.refers_to_elastic() { &[] } else { &self.active_equations };
        transferred.displacement_on(start, equations)
    }

    /// Takes the tangent moduli after the last of the changes of displacement that are known on
    /// another mesh; states follow the changes before.
    fn linearize_after(
        &mut self,
        from: &[f64],
        changes: &[NodalField<'_>],
        elastic: &ElasticBody,
    ) -> Vec<f64> {
        let ElasticBody { mesh, equations, .. } = elastic;
        let Some(points) = &mut self.points else { return from.to_vec() };
        let Some((last, before)) = changes.split_last() else { return from.to_vec() };
        let places = Places::of(mesh, &self.nodes, last.mesh);
        let transferred = |change: &NodalField<'_>| {
            TransferredField::new(*change, elastic.stress_state(), &places)
        };
        let strain = |change: &TransferredField, element: usize, quad: &Quad| {
            let nodes = mesh.elements[element];
            let mut strain =
                quad.strain(&nodes.map(|node| equations.of_node(node).map(|k| from[k as usize])));
            for (value, change) in
                strain.iter_mut().flatten().zip(change.strain(&nodes).iter().flatten())
            {
                *value += change;
            }
            strain
        };
        for change in before {
            let change = transferred(change);
            points.follow(&mut |element, quad| strain(&change, element, quad));
        }
        let last = transferred(last);
        points.linearize(ReferenceModuli::Tangent, &mut |element, quad| {
            strain(&last, element, quad)
        });
        let mut after = last.displacement_on(&self.active_equations, equations);
        for &equation in &self.active_equations {
            after[equation as usize] += from[equation as usize];
        }
        after
    }

    /// Adds elements to the region.
    fn extend(
        &mut self,
        elastic: &ElasticBody,
        model: &dyn MaterialModel,
        initial: Option<&InitialState>,
        search_region: PlasticSearchRegion,
        accepted: &[f64],
    ) {
        let ElasticBody { mesh, equations, symbolic, .. } = elastic;
        let Some(points) = &mut self.points else { return };
        for (inside, more) in
            self.elements.iter_mut().zip(searched_elements(mesh, model, search_region))
        {
            *inside |= more;
        }
        points.extend(&unloaded(elastic, initial), equations, &self.elements, accepted);
        self.nodes = active_nodes(elastic, &self.elements);
        self.active_equations = equations.of_nodes(&self.nodes);
        self.reach = symbolic.reach(&self.active_equations);
    }

    fn is_softened(&self) -> bool {
        self.points.as_ref().is_some_and(|points| !points.refers_to_elastic())
    }
}

impl InitialState {
    /// Relaxes a given stress with the elastic factor of the body.
    fn relaxed(
        elastic: &ElasticBody,
        factor: &Cholesky,
        moduli: ElasticModuli,
        given: &GivenStress,
    ) -> Self {
        let (mesh, equations, stress_state) =
            (&elastic.mesh, &elastic.equations, elastic.stress_state());
        let mut stress = given_stress(mesh, stress_state, |position| given.at(position));
        let mut force = initial_force(mesh, stress_state, equations, &stress);
        if !given.is_in_equilibrium() {
            let mut displacement: Vec<f64> = force.iter().map(|f| -f).collect();
            factor.solve(&mut displacement);
            stress =
                relaxed_stress(mesh, stress_state, moduli, &stress, &elastic.nodal(&displacement));
            force = initial_force(mesh, stress_state, equations, &stress);
        }
        Self { stress: Arc::new(stress), force }
    }
}

/// `a -= b`.
/// A body before any load.
fn unloaded<'a>(elastic: &'a ElasticBody, initial: Option<&'a InitialState>) -> Unloaded<'a> {
    Unloaded {
        mesh: &elastic.mesh,
        stress_state: elastic.stress_state(),
        initial_stress: initial.map(|initial| &*initial.stress),
    }
}

/// Returns the elements of a plastic region; all elements for a material without an elastic
/// domain, none for an elastic one.
fn searched_elements(
    mesh: &Mesh,
    model: &dyn MaterialModel,
    search_region: PlasticSearchRegion,
) -> Vec<bool> {
    match model.hardening() {
        None => vec![false; mesh.elements.len()],
        Some(law) if law.yield_stress() > 0.0 => search_region.elements(mesh),
        Some(_) => PlasticSearchRegion::WholeBody.elements(mesh),
    }
}

/// Returns the nodes of these elements and the nodes with contact forces and supports.
fn active_nodes(elastic: &ElasticBody, elements: &[bool]) -> Vec<bool> {
    let mesh = &elastic.mesh;
    if elastic.has_spread_support() {
        return vec![true; mesh.nodes.len()];
    }
    let mut nodes = nodes_of(mesh, elements);
    for &node in &mesh.contact_nodes {
        nodes[node as usize] = true;
    }
    nodes
}
