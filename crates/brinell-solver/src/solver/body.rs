//! A deformable body: factorized, condensed to its contact, and watched where it may yield.

use std::sync::Arc;

use super::elastic_body::ElasticBody;
use super::factor_cache::LentFactor;
use super::former::{Carried, FormerField};
use super::phases::{Phase, PhaseTimes};
use super::plastic_reach::{PlasticReach, nodes_of};
use super::{Observer, SolveError};
use crate::fem::assembly::{InitialStressRegion, StressField};
use crate::job::Deformable;
use crate::material::{HardeningLaw, ReferenceModuli, UniaxialCurve};
use sparse_cholesky::Reach;
use sparse_cholesky::dense::SymmetricMatrix;

/// Everything about one body that outlives an iteration.
pub(super) struct BodyModel {
    pub elastic: Arc<ElasticBody>,
    pub material: Deformable,
    pub watch: Watch,
    /// Factor of the stiffness in force: elastic, or with the tangent moduli that [`Watch::region`] refers to.
    pub factor: LentFactor,
    /// Inward normal displacement of the contact nodes under unit forces that press on them \[mm/N\].
    pub flexibility: SymmetricMatrix,
    /// Whether that stiffness is softer than the elastic one.
    is_softened: bool,
}

/// The part of a body where plastic flow is taken into account.
pub(super) struct Watch {
    /// Whether each element belongs to it.
    elements: Vec<bool>,
    /// Whether an iteration loads or reads each node: those of these elements and the contact nodes.
    nodes: Vec<bool>,
    /// The window: the equations of these nodes.
    pub window: Vec<u32>,
    /// Supernodes of the window.
    pub reach: Reach,
    /// What the elements make of plastic flow; `None` for a body that cannot yield.
    pub region: Option<InitialStressRegion>,
}

impl BodyModel {
    /// Factorizes, in place of what the factor was of, the elastic stiffness or, given a former field, the one with the
    /// tangent moduli there; also returns the former displacements, carried to the window.
    pub fn new(
        elastic: Arc<ElasticBody>,
        mut factor: LentFactor,
        material: &Deformable,
        plastic_reach: PlasticReach,
        former: Option<FormerField<'_>>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<(Self, Option<Vec<f64>>), SolveError> {
        let (watch, carried) = phases.time(Phase::Plasticity, observer, || {
            let mut watch = Watch::new(&elastic, material, plastic_reach);
            let carried = former.map(|field| watch.linearize_by(field, &elastic));
            (watch, carried)
        });
        let flexibility = elastic.factorize(&mut factor, watch.region.as_ref(), phases, observer)?;
        let is_softened = watch.is_softened();
        Ok((Self { elastic, material: material.clone(), watch, factor, flexibility, is_softened }, carried))
    }

    /// Watches another part of the body. The stiffness in force is elastic again from the next linearization on.
    pub fn watch(&mut self, plastic_reach: PlasticReach) {
        self.watch = Watch::new(&self.elastic, &self.material, plastic_reach);
    }

    /// Factorizes anew, with moduli of plastic flow at displacements or, without any, the elastic ones.
    pub fn linearize(
        &mut self,
        at: Option<(&[f64], ReferenceModuli)>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError> {
        let ElasticBody { mesh, equations, .. } = &*self.elastic;
        let Some(region) = &mut self.watch.region else { return Ok(()) };
        phases.time(Phase::Plasticity, observer, || match at {
            Some((u, reference)) => region.linearize(reference, |element, quad| {
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
        let Self { elastic, watch, .. } = self;
        let carried = phases.time(Phase::Plasticity, observer, || watch.linearize_by(former, elastic));
        self.factorize(phases, observer)?;
        Ok(carried)
    }

    fn factorize(&mut self, phases: &mut PhaseTimes, observer: &mut dyn Observer) -> Result<(), SolveError> {
        let is_softened = self.watch.is_softened();
        if is_softened || self.is_softened {
            let region = self.watch.region.as_ref();
            self.flexibility = self.elastic.factorize(&mut self.factor, region, phases, observer)?;
            self.is_softened = is_softened;
        }
        Ok(())
    }

    /// `‖∫B̄ᵀσ dV - R‖` over the free components \[N/mm\].
    pub fn imbalance(&self, field: &StressField, force: &[f64]) -> f64 {
        let equations = &self.elastic.equations;
        let mut rest = self.elastic.zeros();
        self.elastic.press(force, &mut rest);
        for (node, internal) in (0u32..).zip(&field.internal_force) {
            for (&k, f) in equations.of_node(node).iter().zip(internal) {
                rest[k as usize] -= f;
            }
        }
        rest[..equations.len()].iter().map(|r| r * r).sum::<f64>().sqrt()
    }

    /// Whether the material yields where nobody has looked.
    pub fn yields_unwatched(&self, field: &StressField) -> bool {
        self.watch.region.is_some()
            && field
                .points
                .iter()
                .zip(&self.watch.elements)
                .any(|(points, watched)| !watched && points.iter().any(|point| point.yielded))
    }
}

impl Watch {
    fn new(elastic: &ElasticBody, material: &Deformable, plastic_reach: PlasticReach) -> Self {
        let ElasticBody { mesh, equations, symbolic, .. } = elastic;
        let elements = match UniaxialCurve::of(material) {
            None => vec![false; mesh.elements.len()],
            Some(curve) if curve.yield_stress() > 0.0 => plastic_reach.elements(mesh),
            // Some plastic strain is everywhere.
            Some(_) => PlasticReach::WholeBody.elements(mesh),
        };
        let mut nodes = nodes_of(mesh, &elements);
        for &node in &mesh.contact_nodes {
            nodes[node as usize] = true;
        }
        let window = equations.of_nodes(&nodes);
        let reach = symbolic.reach(&window);
        let region = InitialStressRegion::new(mesh, elastic.kinematics(), equations, &elements, material);
        Self { elements, nodes, window, reach, region }
    }

    /// Takes the tangent moduli of an answer on another mesh; returns its displacements on the window, zero where
    /// nothing yields.
    fn linearize_by(&mut self, former: FormerField<'_>, elastic: &ElasticBody) -> Vec<f64> {
        let ElasticBody { mesh, equations, .. } = elastic;
        let Some(region) = &mut self.region else { return elastic.zeros() };
        let carried = Carried::new(former, elastic.kinematics(), mesh, &self.nodes);
        region.linearize(ReferenceModuli::Tangent, |element, _| carried.strain(&mesh.elements[element]));
        let start: &[u32] = if region.refers_to_elastic() { &[] } else { &self.window };
        carried.displacement_on(start, equations)
    }

    fn is_softened(&self) -> bool {
        self.region.as_ref().is_some_and(|region| !region.refers_to_elastic())
    }
}
