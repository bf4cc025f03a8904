//! Two bodies and the contact between them.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::element::StressState;
use crate::engine::body_system::axis;
use crate::engine::body_system::body::{BodyMaterial, BodyModel};
use crate::engine::body_system::elastic_body::BodyKey;
use crate::engine::body_system::factor_cache::{FactorCache, PooledFactor};
use crate::engine::body_system::plastic_search_region::{PlasticSearchRegion, RadialEnvelope};
use crate::engine::body_system::preparation::prepare;
use crate::engine::body_system::transfer::NodalField;
use crate::engine::conforming::ConformingPair;
use crate::engine::error::MeshedError;
use crate::engine::problem::Problem;
use crate::mesh::{ContactZone, Refinement};
use brinell_method::contact_system::{BlockVector, ContactSystem as _};
use brinell_method::observer::Held;
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use dense_cholesky::SymmetricMatrix;
use sparse_cholesky::Cholesky;

/// The discretized pair of bodies. Equal bodies are one [`BodyModel`] that counts twice: under the
/// same contact forces they are mirror images of each other in every iteration.
pub(crate) struct System {
    pub bodies: Vec<BodyModel>,
    /// Number of bodies, 1 or 2, that each model represents.
    pub bodies_represented: Vec<usize>,
    /// Model of the upper and the lower body; `None` for a rigid one.
    pub model_of: [Option<usize>; 2],
    pub stress_state: StressState,
    pub zone: ContactZone,
    /// A pin and its hole, whose abscissae are arc lengths.
    pub conforming: Option<ConformingPair>,
    /// The smallest gap as the outlines are given, which gaps are counted from \[mm\].
    pub smallest_gap: f64,
    /// Initial gap δ0 of each candidate pair along its normal \[mm\].
    pub initial_gap: Vec<f64>,
    /// The cosine of the angle between each pair's normal and the approach.
    pub closing: Vec<f64>,
    /// Flexibility of both bodies together \[mm/N\].
    pub flexibility: SymmetricMatrix,
    /// The choice of the plastic regions.
    pub search_region: PlasticSearchRegion,
    /// The last accepted increment of a history.
    pub accepted: Accepted,
    /// Load and displacements of the whole models, the latest last; at most two.
    states: Vec<(f64, BlockVector)>,
}

/// The last accepted increment of a history.
pub(crate) struct Accepted {
    /// Displacements on the active equations.
    pub displacement: BlockVector,
    /// Displacements on all equations; empty at rest.
    pub whole: BlockVector,
    /// Extent of plastic flow so far.
    pub plastic: RadialEnvelope,
    /// Largest half-width of the contact so far \[mm\].
    pub half_width: f64,
}

impl Accepted {
    /// The state before the first increment, with displacements of zero.
    fn at_rest(displacement: BlockVector) -> Self {
        Self { displacement, whole: Vec::new(), plastic: RadialEnvelope::NONE, half_width: 0.0 }
    }
}

/// The requirements on a mesh.
#[derive(Clone, Copy)]
pub(crate) struct Design<'a> {
    pub zone: &'a ContactZone,
    pub refinement: Refinement,
    pub search_region: PlasticSearchRegion,
    /// Cache that may hold its bodies and factors.
    pub cache: Option<&'a Arc<FactorCache>>,
    /// Whether [`System::linearize_after`] or another linearization comes before the first
    /// iteration, so that no factor is needed before.
    pub is_linearized_later: bool,
}

impl System {
    /// Meshes and factorizes, unless it is linearized later: with elastic moduli or, given a previous
    /// field for each model, with the tangent moduli there. Also returns the previous displacements, transferred to the
    /// active equations of the new meshes.
    pub fn build(
        problem: &Problem,
        design: Design<'_>,
        previous: Option<&[NodalField<'_>]>,
        run: &mut Run<'_>,
    ) -> Result<(Self, Option<BlockVector>), MeshedError> {
        let Design { zone, refinement, search_region, cache, is_linearized_later } = design;
        let mut models: Vec<(BodyKey, BodyMaterial<'_>)> = Vec::new();
        let mut bodies_represented: Vec<usize> = Vec::new();
        let mut model_of = [None; 2];
        for (side, body) in problem.bodies.iter().enumerate() {
            let (Some(material), Some(model)) = (&body.material, &body.model) else { continue };
            if side == 1 && problem.bodies_are_equal() {
                bodies_represented[0] = 2;
                model_of[1] = model_of[0];
                continue;
            }
            let key = BodyKey {
                outline: body.outline.clone(),
                zone: zone.clone(),
                refinement,
                stress_state: problem.stress_state,
                constants: material.elastic(),
                support: body.support,
            };
            model_of[side] = Some(models.len());
            models.push((
                key,
                BodyMaterial { model, initial_stress: body.initial_stress.as_deref() },
            ));
            bodies_represented.push(1);
        }
        let mut bodies: Vec<BodyModel> = Vec::with_capacity(models.len());
        let mut transferred = Vec::with_capacity(models.len());
        let mut held = 0;
        for (k, (key, material)) in models.into_iter().enumerate() {
            // The second body may share the order and the analysis of the first.
            let first = bodies.first().map(|body| &body.elastic);
            let elastic = prepare(key, first, cache.map(|cache| &**cache), run)?;
            held += elastic.bytes() + size_of::<f64>() * elastic.symbolic.factor_entries();
            run.hold(Held::Bodies, held)?;
            let own = || PooledFactor::own(Cholesky::empty(&elastic.symbolic));
            let factor = run
                .time(Phase::Numeric, || cache.map_or_else(own, |cache| cache.acquire(&elastic)));
            let previous = previous.and_then(|fields| fields.get(k).copied());
            let (body, displacement) = BodyModel::new(
                elastic,
                factor,
                material,
                search_region,
                previous,
                is_linearized_later,
                run,
            )?;
            bodies.push(body);
            transferred.push(displacement);
        }
        // The pair of an edge closes where the edge is.
        let initial_gap: Vec<f64> = (0..=zone.columns())
            .map(|k| problem.initial_gap(zone.edge(k).unwrap_or_else(|| zone.abscissa(k))))
            .collect();
        let zeros = bodies.iter().map(|body| body.elastic.zeros()).collect();
        let mut system = Self {
            bodies,
            bodies_represented,
            model_of,
            stress_state: problem.stress_state,
            zone: zone.clone(),
            conforming: problem.conforming,
            smallest_gap: problem.smallest_gap,
            closing: zone.abscissae().iter().map(|&x| problem.closing(x)).collect(),
            initial_gap,
            flexibility: SymmetricMatrix::from_fn(0, |_, _| 0.0),
            search_region,
            accepted: Accepted::at_rest(zeros),
            states: Vec::new(),
        };
        if !is_linearized_later {
            system.sum_flexibility();
        }
        Ok((system, transferred.into_iter().collect()))
    }

    /// Factorizes anew, with the tangent moduli of an answer on another mesh, one field for each
    /// model. Returns that answer's displacements, transferred to the active equations.
    pub fn linearize_by(
        &mut self,
        previous: &[NodalField<'_>],
        run: &mut Run<'_>,
    ) -> Result<BlockVector, brinell_method::Error> {
        let transferred = self
            .bodies
            .iter_mut()
            .zip(previous)
            .map(|(body, &field)| body.linearize_by(field, run))
            .collect::<Result<_, _>>()?;
        self.sum_flexibility();
        Ok(transferred)
    }

    /// Factorizes anew, with the tangent moduli after the last of the changes of displacement from
    /// `from` that are known on other meshes, for each model one field a change. States follow the
    /// other changes. Returns the displacements after the last one.
    pub fn linearize_after(
        &mut self,
        from: &BlockVector,
        changes: &[Vec<NodalField<'_>>],
        run: &mut Run<'_>,
    ) -> Result<BlockVector, brinell_method::Error> {
        let mut after = Vec::with_capacity(self.bodies.len());
        for ((body, from), changes) in self.bodies.iter_mut().zip(from).zip(changes) {
            after.push(body.linearize_after(from, changes, run)?);
        }
        self.sum_flexibility();
        Ok(after)
    }

    /// Remembers the displacements that a load has left on all equations.
    pub fn remember(&mut self, load: f64, displacement: BlockVector) {
        self.states.push((load, displacement));
        let surplus = self.states.len().saturating_sub(2);
        self.states.drain(..surplus);
    }

    /// The displacements that the last load has left.
    pub fn last_state(&self) -> Option<&BlockVector> {
        self.states.last().map(|(_, displacement)| displacement)
    }

    /// Displacements to start a load from: on the straight line through the last two states, or
    /// the last one.
    pub fn extrapolated(&self, load: f64) -> Option<BlockVector> {
        match self.states.as_slice() {
            [.., (before, u), (last, v)] if (last - before).abs() > f64::EPSILON * last.abs() => {
                let t = (load - last) / (last - before);
                let along = |(u, v): (&Vec<f64>, &Vec<f64>)| -> Vec<f64> {
                    u.iter().zip(v).map(|(u, v)| v + t * (v - u)).collect()
                };
                Some(u.iter().zip(v).map(along).collect())
            }
            states => states.last().map(|(_, v)| v.clone()),
        }
    }

    /// Enlarges the plastic region of each body. States in the region are kept; added elements
    /// have been elastic up to the last accepted increment.
    pub fn extend_plastic_region(&mut self, search_region: PlasticSearchRegion) {
        let Self { bodies, accepted, .. } = self;
        for (k, body) in bodies.iter_mut().enumerate() {
            body.extend_plastic_region(
                search_region,
                accepted.whole.get(k).map_or(&[], Vec::as_slice),
            );
        }
        self.search_region = search_region;
        // On the active equations, which are more now.
        if !self.accepted.whole.is_empty() {
            self.accepted.displacement.clone_from(&self.accepted.whole);
        }
    }

    /// Returns to the bodies before any load, with another plastic region. The factors have to be
    /// renewed before the next iteration.
    pub fn rest(&mut self, search_region: PlasticSearchRegion) {
        self.set_plastic_region(search_region);
        self.accepted = Accepted::at_rest(self.zeros());
        self.states.clear();
    }

    /// Chooses another plastic region of each body. The factors have to be renewed before the next
    /// iteration with tangent moduli.
    pub fn set_plastic_region(&mut self, search_region: PlasticSearchRegion) {
        for body in &mut self.bodies {
            body.set_plastic_region(search_region);
        }
        self.search_region = search_region;
    }

    pub(super) fn sum_flexibility(&mut self) {
        let parts: Vec<&SymmetricMatrix> =
            self.bodies.iter().map(|body| &body.flexibility).collect();
        self.flexibility =
            total_flexibility(self.zone.columns() + 1, &parts, &self.bodies_represented);
    }

    /// Returns the tributary length of pair `k`, `∫ N_k dx` \[mm\], or its area, `∫ N_k 2πx dx`
    /// \[mm²\] in axisymmetry, with the shape function `N_k` of the surface. A uniform pressure is
    /// thereby exact.
    pub fn tributary(&self, k: usize) -> f64 {
        self.tributary_within(k, self.zone.abscissae())
    }

    /// Returns the places \[mm\] of the pairs that carry force at a sharp corner of one of the
    /// surfaces.
    pub fn loaded_corners(&self, force: &[f64]) -> Vec<f64> {
        let loaded = (0..force.len()).filter(|&k| force[k] > 0.0 && self.zone.is_sharp_corner(k));
        loaded.map(|k| self.zone.edge(k).unwrap_or_else(|| self.zone.abscissa(k))).collect()
    }

    /// [`Self::tributary`], but of an edge at which the contact ends only what lies inside of the
    /// edge.
    fn loaded_width(&self, k: usize, force: &[f64]) -> f64 {
        let Some(edge) = self.zone.edge(k) else { return self.tributary(k) };
        let x = self.zone.abscissae();
        let is_loaded = |k: usize| force.get(k).is_some_and(|r| *r > 0.0);
        let inset = (edge - x[k]).abs();
        let beyond = match self.stress_state {
            StressState::PlaneStrain | StressState::PlaneStress => inset,
            StressState::Axisymmetric => PI * inset * (edge + x[k]),
        };
        match (k.checked_sub(1).is_some_and(is_loaded), is_loaded(k + 1)) {
            (true, false) => self.tributary_within(k, &x[..=k]) + beyond,
            (false, true) if k > 0 => self.tributary_within(0, &x[k..]) + beyond,
            _ => self.tributary(k),
        }
    }

    /// [`Self::tributary`] on the columns between these abscissae, `x[k]` being that of the pair.
    fn tributary_within(&self, k: usize, x: &[f64]) -> f64 {
        let here = x[k];
        let (inner, outer) =
            (k.checked_sub(1).map(|j| here - x[j]), x.get(k + 1).map(|x| x - here));
        let (inner, outer) = (inner.unwrap_or(0.0), outer.unwrap_or(0.0));
        match self.stress_state {
            StressState::PlaneStrain | StressState::PlaneStress => 0.5 * (inner + outer),
            StressState::Axisymmetric => {
                let Some(pair) = &self.conforming else {
                    return PI * (inner * (here - inner / 3.0) + outer * (here + outer / 3.0));
                };
                // Simpson's rule with the distance from the axis at the node and half an element
                // beside it.
                let side = |width: f64, middle: f64| {
                    width * (2.0 * pair.half_chord(middle) + pair.half_chord(here))
                };
                PI / 3.0 * (side(inner, here - 0.5 * inner) + side(outer, here + 0.5 * outer))
            }
        }
    }

    /// The first half of a solve: `L⁻¹ P_e` on the active equations, and by how much these loads
    /// widen the gap at each pair, `u_p`. Of `K⁻¹ P_e` only the contact entries are needed before
    /// R is known, and R enters at the end of the elimination, so that nothing is done twice.
    pub fn eliminate(&self, loads: &BlockVector) -> (BlockVector, Vec<f64>) {
        let mut forward = loads.clone();
        let mut gap_opening = vec![0.0; self.initial_gap.len()];
        for ((body, x), count) in
            self.bodies.iter().zip(&mut forward).zip(&self.bodies_represented)
        {
            body.factor.forward(&body.plastic_region.reach, x);
            let mut plastic = x.clone();
            body.factor.backward(&body.elastic.contact_reach, &mut plastic);
            for (g, w) in gap_opening.iter_mut().zip(body.elastic.contact_displacement(&plastic)) {
                *g += *count as f64 * w;
            }
        }
        (forward, gap_opening)
    }

    /// The second half: `K⁻¹ (P_e + R)` on the active equations.
    pub fn substitute(&self, mut forward: BlockVector, force: &[f64]) -> BlockVector {
        for (body, x) in self.bodies.iter().zip(&mut forward) {
            let mut contact = vec![0.0; x.len()];
            body.elastic.add_contact_forces(force, &mut contact);
            body.factor.forward(&body.elastic.contact_reach, &mut contact);
            for (value, addition) in x.iter_mut().zip(&contact) {
                *value += addition;
            }
            body.factor.backward(&body.plastic_region.reach, x);
        }
        forward
    }

    /// 2 if the meshed half stands for both sides, else 1; a body of revolution is whole.
    pub(super) fn sides(&self) -> usize {
        let is_plane = self.stress_state != StressState::Axisymmetric;
        if self.zone.is_symmetric() && is_plane { 2 } else { 1 }
    }

    /// Returns how often a model counts in sums over both whole bodies.
    pub fn copies(&self, model: usize) -> usize {
        self.bodies_represented[model] * self.sides()
    }

    /// The force along the approach of the whole contact, by the forces of the meshed pairs.
    pub fn whole_load(&self, force: &[f64]) -> f64 {
        self.sides() as f64 * force.iter().zip(&self.closing).map(|(r, e)| r * e).sum::<f64>()
    }

    /// The force of a pair, by that of its meshed part: of a pair on the axis half of it is
    /// meshed.
    pub fn pair_force(&self, pair: usize, force: f64) -> f64 {
        if pair == 0 && self.sides() == 2 { 2.0 * force } else { force }
    }

    /// Contact pressure of each pair \[MPa\]: its force over the length or area it stands for;
    /// next to the axis of a body of revolution, the smooth continuation of what lies around it.
    pub fn pressures(&self, force: &[f64]) -> Vec<f64> {
        let mut pressures: Vec<f64> =
            (0..force.len()).map(|k| force[k] / self.loaded_width(k, force)).collect();
        if self.stress_state == StressState::Axisymmetric && self.zone.is_uniform() {
            axis::recover(&mut pressures);
        }
        pressures
    }

    /// Abscissae of the pairs and their pressures.
    pub fn pressure_over_x(&self, force: &[f64]) -> (Vec<f64>, Vec<f64>) {
        (self.zone.abscissae().to_vec(), self.pressures(force))
    }

    /// Largest contact pressure \[MPa\].
    pub fn peak_pressure(&self, force: &[f64]) -> f64 {
        self.pressures(force).into_iter().fold(0.0, f64::max)
    }

    pub(super) fn distance_or_norm(&self, v: &BlockVector, w: Option<&BlockVector>) -> f64 {
        let sum = self.bodies.iter().enumerate().map(|(k, body)| {
            let squares = body.plastic_region.active_equations.iter().map(|&e| {
                let e = e as usize;
                (v[k][e] - w.map_or(0.0, |w| w[k][e])).powi(2)
            });
            self.bodies_represented[k] as f64 * squares.sum::<f64>()
        });
        sum.sum::<f64>().sqrt()
    }
}

/// `Σ count · F`.
pub(crate) fn total_flexibility(
    n: usize,
    parts: &[&SymmetricMatrix],
    counts: &[usize],
) -> SymmetricMatrix {
    SymmetricMatrix::from_fn(n, |i, j| {
        parts.iter().zip(counts).map(|(part, count)| *count as f64 * part[(i, j)]).sum()
    })
}
