//! Two bodies and the contact between them.

use std::f64::consts::PI;
use std::sync::{Arc, Mutex, PoisonError};

use super::axis;
use super::body::BodyModel;
use super::elastic_body::{BodyPlan, ElasticBody};
use super::factor_cache::{FactorCache, LentFactor};
use super::former::FormerField;
use super::phases::{Phase, PhaseTimes};
use super::plastic_reach::PlasticReach;
use super::problem::Problem;
use super::side_by_side::{LARGE, side_by_side};
use super::{Observer, SolveError};
use crate::contact::{ActiveSet, ContactLoad, ContactProblem, ContactSolution, ContactSolver};
use crate::fem::assembly::InitialStressRegion;
use crate::fem::element::Kinematics;
use crate::fem::mesh::{ContactZone, Refinement};
use crate::job::Deformable;
use crate::material::ReferenceModuli;
use sparse_cholesky::Cholesky;
use sparse_cholesky::dense::SymmetricMatrix;

/// The discretized pair of bodies. Equal bodies are one [`BodyModel`] that counts twice: under the same
/// contact forces they are mirror images of each other in every iteration.
pub(super) struct System {
    pub bodies: Vec<BodyModel>,
    /// How many of the two bodies each model stands for.
    pub multiplicity: Vec<usize>,
    /// Model of the upper and the lower body; `None` for a rigid one.
    pub model_of: [Option<usize>; 2],
    pub kinematics: Kinematics,
    pub zone: ContactZone,
    /// The smallest gap as the outlines are given, which gaps are counted from \[mm\].
    pub smallest_gap: f64,
    /// Initial gap δ0 of each candidate pair \[mm\].
    pub initial_gap: Vec<f64>,
    /// Flexibility of both bodies together \[mm/N\].
    pub flexibility: SymmetricMatrix,
}

/// What a mesh is to be like.
#[derive(Clone, Copy)]
pub(super) struct Design<'a> {
    pub zone: ContactZone,
    pub refinement: Refinement,
    pub plastic_reach: PlasticReach,
    /// Where it may be already.
    pub cache: Option<&'a Arc<FactorCache>>,
}

/// One vector for each model.
pub(super) type PerModel = Vec<Vec<f64>>;

/// Displacements and contact for given initial-stress loads.
#[derive(Debug, Clone)]
pub(super) struct Response {
    /// Displacements on the window of each model \[mm\].
    pub displacement: PerModel,
    pub contact: ContactSolution,
}

impl System {
    /// Meshes and factorizes: with elastic moduli or, given a former field for each model, with the tangent moduli
    /// there. Also returns the former displacements, carried to the windows of the new meshes.
    pub fn build(
        problem: &Problem,
        design: Design<'_>,
        former: Option<&[FormerField<'_>]>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<(Self, Option<PerModel>), SolveError> {
        let Design { zone, refinement, plastic_reach, cache } = design;
        let mut models: Vec<(BodyPlan, &Deformable)> = Vec::new();
        let mut multiplicity: Vec<usize> = Vec::new();
        let mut model_of = [None; 2];
        for (side, body) in problem.bodies.iter().enumerate() {
            let Some(material) = &body.material else { continue };
            if side == 1 && problem.bodies_are_equal() {
                multiplicity[0] = 2;
                model_of[1] = model_of[0];
                continue;
            }
            let plan = BodyPlan {
                outline: body.outline.clone(),
                zone,
                refinement,
                kinematics: problem.kinematics,
                constants: *material.elastic(),
                support: body.support,
            };
            model_of[side] = Some(models.len());
            models.push((plan, material));
            multiplicity.push(1);
        }
        let nodes: usize = models.iter().map(|(plan, _)| plan.estimated_nodes()).sum();
        // What one body has made ready the other may use.
        let ready: Mutex<Option<Arc<ElasticBody>>> = Mutex::default();
        let other = || ready.lock().unwrap_or_else(PoisonError::into_inner);
        let models = models.into_iter().enumerate().collect();
        let built = side_by_side(models, nodes >= LARGE, phases, observer, |model, phases, observer| {
            let (k, (plan, material)): (usize, (BodyPlan, &Deformable)) = model;
            let first = other().clone();
            let elastic =
                ElasticBody::prepare(plan, first.as_ref(), cache.map(|cache| &**cache), phases, observer)?;
            other().get_or_insert_with(|| Arc::clone(&elastic));
            let own = || LentFactor::own(Cholesky::empty(&elastic.symbolic));
            let factor = phases
                .time(Phase::Numeric, observer, || cache.map_or_else(own, |cache| cache.lend(&elastic)));
            let former = former.and_then(|fields| fields.get(k).copied());
            BodyModel::new(elastic, factor, material, plastic_reach, former, phases, observer)
        })?;
        let (bodies, carried): (Vec<BodyModel>, Vec<Option<Vec<f64>>>) = built.into_iter().unzip();
        let initial_gap = (0..=zone.columns).map(|k| problem.initial_gap(zone.abscissa(k))).collect();
        let mut system = Self {
            bodies,
            multiplicity,
            model_of,
            kinematics: problem.kinematics,
            zone,
            smallest_gap: problem.smallest_gap,
            initial_gap,
            flexibility: SymmetricMatrix::from_fn(0, |_, _| 0.0),
        };
        system.sum_flexibility();
        Ok((system, carried.into_iter().collect()))
    }

    /// Factorizes anew, with moduli of plastic flow at displacements on the windows or, without any, the elastic ones.
    pub fn linearize(
        &mut self,
        at: Option<(&PerModel, ReferenceModuli)>,
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError> {
        let is_large = self.is_large();
        let bodies = self.bodies.iter_mut().enumerate().collect();
        side_by_side(
            bodies,
            is_large,
            phases,
            observer,
            |(k, body): (usize, &mut BodyModel), phases, observer| {
                body.linearize(at.map(|(u, reference)| (u[k].as_slice(), reference)), phases, observer)
            },
        )?;
        self.sum_flexibility();
        Ok(())
    }

    /// Factorizes anew, with the tangent moduli of an answer on another mesh, one field for each model. Returns that
    /// answer's displacements, carried to the windows.
    pub fn linearize_by(
        &mut self,
        former: &[FormerField<'_>],
        phases: &mut PhaseTimes,
        observer: &mut dyn Observer,
    ) -> Result<PerModel, SolveError> {
        let is_large = self.is_large();
        let bodies = self.bodies.iter_mut().zip(former).collect();
        let carried = side_by_side(
            bodies,
            is_large,
            phases,
            observer,
            |(body, &field): (&mut BodyModel, &FormerField<'_>), phases, observer| {
                body.linearize_by(field, phases, observer)
            },
        )?;
        self.sum_flexibility();
        Ok(carried)
    }

    /// Watches another part of each body. The factors have to be made anew before the next iteration with tangent
    /// moduli.
    pub fn watch(&mut self, plastic_reach: PlasticReach) {
        for body in &mut self.bodies {
            body.watch(plastic_reach);
        }
    }

    /// Whether the stiffness in force is the elastic one.
    pub fn is_elastic(&self) -> bool {
        self.bodies
            .iter()
            .all(|body| body.watch.region.as_ref().is_none_or(InitialStressRegion::refers_to_elastic))
    }

    /// Whether its bodies are worth to be worked on at the same time.
    fn is_large(&self) -> bool {
        self.bodies.iter().map(|body| body.elastic.mesh.nodes.len()).sum::<usize>() >= LARGE
    }

    fn sum_flexibility(&mut self) {
        let parts: Vec<&SymmetricMatrix> = self.bodies.iter().map(|body| &body.flexibility).collect();
        self.flexibility = total_flexibility(self.zone.columns + 1, &parts, &self.multiplicity);
    }

    /// What the force of a pair is spread over: `∫ N_k dx` \[mm\], or `∫ N_k 2πx dx` \[mm²\] in axisymmetry, with
    /// the shape function `N_k` of the surface. So a uniform pressure is found exactly.
    pub fn tributary(&self, k: usize) -> f64 {
        let h = self.zone.spacing();
        let (is_first, is_last) = (k == 0, k == self.zone.columns);
        match self.kinematics {
            Kinematics::PlaneStrain | Kinematics::PlaneStress => {
                h * if is_first || is_last { 0.5 } else { 1.0 }
            }
            Kinematics::Axisymmetric => {
                let x = self.zone.abscissa(k);
                let inner = if is_first { 0.0 } else { 0.5 * h * (x - h / 3.0) };
                let outer = if is_last { 0.0 } else { 0.5 * h * (x + h / 3.0) };
                2.0 * PI * (inner + outer)
            }
        }
    }

    /// Initial-stress loads that are all zero.
    pub fn zeros(&self) -> PerModel {
        self.bodies.iter().map(|body| body.elastic.zeros()).collect()
    }

    /// Solves contact and equilibrium for given initial-stress loads:
    /// `u_p = K⁻¹ P_e`, contact forces R for the gap `δ0 + u_p`, then `u = K⁻¹ (P_e + R)`.
    pub fn respond(
        &self,
        loads: &PerModel,
        solver: &dyn ContactSolver,
        load: ContactLoad,
        warm: Option<&ActiveSet>,
        phases: &mut PhaseTimes,
        observer: &dyn Observer,
    ) -> Result<Response, SolveError> {
        let (forward, growth) = phases.time(Phase::Solves, observer, || self.eliminate(loads));
        let gap: Vec<f64> = self.initial_gap.iter().zip(growth).map(|(gap, growth)| gap + growth).collect();
        let problem = ContactProblem { flexibility: &self.flexibility, initial_gap: &gap, load };
        let contact = phases.time(Phase::Contact, observer, || solver.solve(&problem, warm))?;
        let displacement = phases.time(Phase::Solves, observer, || self.substitute(forward, &contact.force));
        Ok(Response { displacement, contact })
    }

    /// The first half of a solve: `L⁻¹ P_e` on the windows, and by how much these loads widen the gap at each pair,
    /// `u_p`. Of `K⁻¹ P_e` only the contact entries are needed before R is known, and R enters at the end of the
    /// elimination, so that nothing is done twice.
    pub fn eliminate(&self, loads: &PerModel) -> (PerModel, Vec<f64>) {
        let mut forward = loads.clone();
        let mut growth = vec![0.0; self.initial_gap.len()];
        for ((body, x), count) in self.bodies.iter().zip(&mut forward).zip(&self.multiplicity) {
            body.factor.forward(&body.watch.reach, x);
            let mut plastic = x.clone();
            body.factor.backward(&body.elastic.contact_reach, &mut plastic);
            for (g, w) in growth.iter_mut().zip(body.elastic.contact_displacement(&plastic)) {
                *g += *count as f64 * w;
            }
        }
        (forward, growth)
    }

    /// The second half: `K⁻¹ (P_e + R)` on the windows.
    pub fn substitute(&self, mut forward: PerModel, force: &[f64]) -> PerModel {
        for (body, x) in self.bodies.iter().zip(&mut forward) {
            let mut contact = vec![0.0; x.len()];
            body.elastic.press(force, &mut contact);
            body.factor.forward(&body.elastic.contact_reach, &mut contact);
            for (value, addition) in x.iter_mut().zip(&contact) {
                *value += addition;
            }
            body.factor.backward(&body.watch.reach, x);
        }
        forward
    }

    /// `u = K⁻¹ (P_e + R)` on the windows.
    pub fn displacement(&self, loads: &PerModel, force: &[f64]) -> PerModel {
        let solve = |(body, load): (&BodyModel, &Vec<f64>)| {
            let mut x = load.clone();
            body.elastic.press(force, &mut x);
            body.factor.solve_restricted(&body.watch.reach, &mut x);
            x
        };
        self.bodies.iter().zip(loads).map(solve).collect()
    }

    /// By how much plastic flow alone widens the gap at each pair, `u_p` \[mm\].
    pub fn plastic_gap(&self, loads: &PerModel) -> Vec<f64> {
        let mut growth = vec![0.0; self.initial_gap.len()];
        for ((body, load), count) in self.bodies.iter().zip(loads).zip(&self.multiplicity) {
            let mut x = load.clone();
            body.factor.solve_restricted(&body.watch.reach, &mut x);
            for (g, w) in growth.iter_mut().zip(body.elastic.contact_displacement(&x)) {
                *g += *count as f64 * w;
            }
        }
        growth
    }

    /// Initial-stress loads of given displacements, summed into `loads`.
    ///
    /// Returns the Gauss points beyond yield.
    pub fn initial_stress(&self, displacement: &PerModel, loads: &mut PerModel) -> usize {
        let evaluate = |(k, body): (usize, &BodyModel)| {
            let points = body
                .watch
                .region
                .as_ref()
                .map_or(0, |region| region.evaluate(&displacement[k], &mut loads[k]));
            points * self.multiplicity[k]
        };
        self.bodies.iter().enumerate().map(evaluate).sum()
    }

    /// The entries on the windows, one model after the other.
    pub fn pack(&self, vectors: &PerModel) -> Vec<f64> {
        let parts = self.bodies.iter().zip(vectors);
        parts.flat_map(|(body, v)| body.watch.window.iter().map(|&e| v[e as usize])).collect()
    }

    /// Writes entries on the windows back to where [`Self::pack`] took them from.
    pub fn unpack(&self, packed: &[f64], vectors: &mut PerModel) {
        let mut values = packed.iter();
        for (body, v) in self.bodies.iter().zip(vectors) {
            for (&e, value) in body.watch.window.iter().zip(&mut values) {
                v[e as usize] = *value;
            }
        }
    }

    /// 2 if the meshed half stands for both sides, else 1; a body of revolution is whole.
    pub fn copies(&self) -> usize {
        let is_plane = self.kinematics != Kinematics::Axisymmetric;
        if self.zone.symmetric && is_plane { 2 } else { 1 }
    }

    /// The load of what is meshed.
    pub fn part_of(&self, load: ContactLoad) -> ContactLoad {
        match load {
            ContactLoad::Force(force) => ContactLoad::Force(force / self.copies() as f64),
            approach @ ContactLoad::Approach(_) => approach,
        }
    }

    /// Pairs in contact on both sides of the axis.
    pub fn mirrored_count(&self, active: &ActiveSet) -> usize {
        let on_axis = self.copies() == 2 && active.contains(0);
        active.len() * self.copies() - usize::from(on_axis)
    }

    /// Contact pressure of each pair \[MPa\]: its force over the length or area it stands for; next to the axis of
    /// a body of revolution, the smooth continuation of what lies around it.
    pub fn pressures(&self, force: &[f64]) -> Vec<f64> {
        let mut pressures: Vec<f64> = force.iter().enumerate().map(|(k, r)| r / self.tributary(k)).collect();
        if self.kinematics == Kinematics::Axisymmetric {
            axis::recover(&mut pressures);
        }
        pressures
    }

    /// Abscissae of the pairs and their pressures.
    pub fn pressure_over_x(&self, force: &[f64]) -> (Vec<f64>, Vec<f64>) {
        ((0..=self.zone.columns).map(|k| self.zone.abscissa(k)).collect(), self.pressures(force))
    }

    /// Largest contact pressure \[MPa\].
    pub fn peak_pressure(&self, force: &[f64]) -> f64 {
        self.pressures(force).into_iter().fold(0.0, f64::max)
    }

    /// `√Σ ‖v‖²` over both bodies on the windows.
    pub fn norm(&self, vectors: &PerModel) -> f64 {
        self.distance_or_norm(vectors, None)
    }

    /// `√Σ ‖v - w‖²` over both bodies on the windows.
    pub fn distance(&self, v: &PerModel, w: &PerModel) -> f64 {
        self.distance_or_norm(v, Some(w))
    }

    /// `Σ v·w` over both bodies on the windows.
    pub fn inner(&self, v: &PerModel, w: &PerModel) -> f64 {
        let sum = self.bodies.iter().enumerate().map(|(k, body)| {
            let products = body.watch.window.iter().map(|&e| v[k][e as usize] * w[k][e as usize]);
            self.multiplicity[k] as f64 * products.sum::<f64>()
        });
        sum.sum()
    }

    fn distance_or_norm(&self, v: &PerModel, w: Option<&PerModel>) -> f64 {
        let sum = self.bodies.iter().enumerate().map(|(k, body)| {
            let squares = body.watch.window.iter().map(|&e| {
                let e = e as usize;
                (v[k][e] - w.map_or(0.0, |w| w[k][e])).powi(2)
            });
            self.multiplicity[k] as f64 * squares.sum::<f64>()
        });
        sum.sum::<f64>().sqrt()
    }
}

/// `Σ count · F`.
pub(super) fn total_flexibility(n: usize, parts: &[&SymmetricMatrix], counts: &[usize]) -> SymmetricMatrix {
    SymmetricMatrix::from_fn(n, |i, j| {
        parts.iter().zip(counts).map(|(part, count)| *count as f64 * part[(i, j)]).sum()
    })
}
