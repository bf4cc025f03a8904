//! A second engine, which tests the method without finite elements: two half-planes in line
//! contact, with a layer of yielding springs between them.
//!
//! Each contact pair has a spring of stiffness s in series with the half-planes. Under a
//! compression w with the plastic part p, the spring carries `R = s (w - p)`. The plastic part
//! grows so that `R = R_y + H p` beyond yield, and never decreases. The initial stress is `s p`.

mod tests;

use std::f64::consts::PI;

use super::contact_system::{BlockVector, ContactFigures, ContactSystem};
use super::couplings::Coupling;
use super::couplings::iteration::{Controls, InitialState, Outcome, Scales, norm};
use super::figures::Figures;
use super::final_check::{Evidence, LeastScales, judge};
use super::force_search::Density;
use super::history::{Memory, NextIncrement};
use super::increments::Growth;
use super::progress::Progress;
use super::run::Run;
use super::solve::{Engine, Round, Verdict, VerdictOf, solve};
use super::steps::{Checks, Path, Search, Step};
use crate::Error;
use brinell_contact::kkt::ContactScales;
use brinell_contact::{ActiveSetSolver, ContactLoad, ContactProblem, ContactSolution};
use dense_cholesky::SymmetricMatrix;

/// Radius of the upper surface \[mm\], modulus E\* of both bodies \[MPa\], and depth of zero
/// displacement \[mm\].
const RADIUS: f64 = 10.0;
const MODULUS: f64 = 1e5;
const DATUM: f64 = 100.0;
/// Stiffness and hardening modulus of the springs \[N/mm² per mm\], and their yield pressure
/// \[MPa\].
const STIFFNESS: f64 = 1e7;
const HARDENING: f64 = 1e6;
const YIELD: f64 = 400.0;
const TOLERANCE: f64 = 1e-9;

/// The springs, and the flexibility of springs and half-planes.
struct HalfPlanes {
    /// Spacing of the contact pairs \[mm\].
    spacing: f64,
    initial_gap: Vec<f64>,
    closing: Vec<f64>,
    flexibility: SymmetricMatrix,
    /// Whether each spring belongs to the plastic region.
    watched: Vec<bool>,
    /// Compressions of the accepted state, and their plastic parts.
    accepted: BlockVector,
    plastic: Vec<f64>,
}

impl HalfPlanes {
    fn new(Design { pairs, watched }: Design, spacing: f64) -> Self {
        let x = |k: usize| (k as f64 - 0.5 * (pairs - 1) as f64) * spacing;
        let integral = |t: f64| if t == 0.0 { 0.0 } else { t * (t.abs() / DATUM).ln() - t };
        let flexibility = SymmetricMatrix::from_fn(pairs, |i, j| {
            let (near, far) = (x(i) - x(j) - 0.5 * spacing, x(i) - x(j) + 0.5 * spacing);
            let half_planes = -2.0 / (PI * MODULUS * spacing) * (integral(far) - integral(near));
            half_planes + if i == j { 1.0 / (STIFFNESS * spacing) } else { 0.0 }
        });
        let beside = (pairs - watched) / 2;
        Self {
            spacing,
            initial_gap: (0..pairs).map(|k| x(k).powi(2) / (2.0 * RADIUS)).collect(),
            closing: vec![1.0; pairs],
            flexibility,
            watched: (0..pairs).map(|k| (beside..pairs - beside).contains(&k)).collect(),
            accepted: vec![vec![0.0; pairs]],
            plastic: vec![0.0; pairs],
        }
    }

    /// Returns the plastic part of a compression.
    fn plastic_compression(&self, pair: usize, w: f64) -> f64 {
        let before = self.plastic[pair];
        let beyond_yield = (STIFFNESS * w - YIELD) / (STIFFNESS + HARDENING);
        if self.watched[pair] { beyond_yield.max(before) } else { before }
    }
}

impl ContactSystem for HalfPlanes {
    fn zeros(&self) -> BlockVector {
        vec![vec![0.0; self.initial_gap.len()]]
    }

    fn initial_gap(&self) -> &[f64] {
        &self.initial_gap
    }

    fn contact_problem<'a>(
        &'a self,
        initial_gap: &'a [f64],
        load: ContactLoad,
    ) -> ContactProblem<'a> {
        ContactProblem {
            flexibility: &self.flexibility,
            initial_gap,
            closing: &self.closing,
            load,
        }
    }

    fn gap_opening(&self, initial_stress: &BlockVector) -> Vec<f64> {
        initial_stress[0].iter().map(|stress| stress / (STIFFNESS * self.spacing)).collect()
    }

    fn displacement(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector {
        let loads = initial_stress[0].iter().zip(force);
        vec![loads.map(|(stress, force)| (stress + force) / (STIFFNESS * self.spacing)).collect()]
    }

    fn initial_stress(&self, displacement: &BlockVector, into: &mut BlockVector) -> usize {
        let mut flowing = 0;
        for (k, stress) in into[0].iter_mut().enumerate() {
            let plastic = self.plastic_compression(k, displacement[0][k]);
            *stress = STIFFNESS * self.spacing * plastic;
            flowing += usize::from(plastic > 0.0);
        }
        flowing
    }

    fn norm(&self, v: &BlockVector) -> f64 {
        norm(&v[0])
    }

    fn distance(&self, v: &BlockVector, w: &BlockVector) -> f64 {
        norm(&v[0].iter().zip(&w[0]).map(|(v, w)| v - w).collect::<Vec<_>>())
    }

    fn pack(&self, vectors: &BlockVector) -> Vec<f64> {
        vectors[0].clone()
    }

    fn unpack(&self, packed: &[f64], vectors: &mut BlockVector) {
        vectors[0].copy_from_slice(packed);
    }

    fn accepted(&self) -> &BlockVector {
        &self.accepted
    }

    fn commit(&mut self, displacement: BlockVector) {
        self.plastic = displacement[0]
            .iter()
            .enumerate()
            .map(|(k, &w)| self.plastic_compression(k, w))
            .collect();
        self.accepted = displacement;
    }

    fn figures(&self, contact: &ContactSolution) -> ContactFigures {
        ContactFigures {
            force: contact.total_force,
            approach: contact.approach,
            peak_pressure: contact.force.iter().copied().fold(0.0, f64::max) / self.spacing,
            pairs: contact.active_set.len(),
        }
    }
}

/// Number of contact pairs, and number of springs in the plastic region.
#[derive(Clone, Copy)]
struct Design {
    pairs: usize,
    watched: usize,
}

/// The engine: a coupling, and a spacing of the contact pairs.
struct Springs {
    coupling: &'static dyn Coupling,
    spacing: f64,
}

struct SpringAnswer {
    system: HalfPlanes,
    outcome: Outcome,
    /// Number of continuations with a larger plastic region.
    continued: usize,
}

impl SpringAnswer {
    fn figures(&self) -> Figures {
        let contact = &self.outcome.state.response.contact;
        let contact = self.system.figures(contact);
        contact.headline(0.5 * contact.pairs as f64 * self.system.spacing)
    }

    /// Returns the step. The check evaluates the answer anew from its forces.
    fn step(&self, load: ContactLoad, least: LeastScales) -> Step<()> {
        let Self { system, outcome, .. } = self;
        let state = &outcome.state;
        let evidence = if outcome.status.is_stopped() {
            Evidence::of_iteration(system, outcome, false)
        } else {
            let mut loads = system.zeros();
            system.initial_stress(
                &system.displacement(&state.loads, &state.response.contact.force),
                &mut loads,
            );
            let mut unloaded_gap = vec![0.0; loads[0].len()];
            system
                .contact_problem(&[], load)
                .flexibility
                .apply(&state.response.contact.force, &mut unloaded_gap);
            let opening = system.gap_opening(&loads);
            for ((gap, initial), opening) in
                unloaded_gap.iter_mut().zip(&system.initial_gap).zip(opening)
            {
                *gap += initial + opening;
            }
            let residual = system.distance(&loads, &state.loads);
            let equilibrium_residual =
                residual / norm(&state.response.contact.force).max(least.residual);
            Evidence {
                unloaded_gap,
                equilibrium_residual,
                has_collapsed: false,
                reaches_edge: false,
            }
        };
        self.judged(&evidence, load, least.contact)
    }

    fn judged(&self, evidence: &Evidence, load: ContactLoad, least: ContactScales) -> Step<()> {
        let Self { system, outcome, .. } = self;
        let (status, contact) = judge(system, outcome, evidence, load, TOLERANCE, least);
        Step {
            status,
            load,
            figures: self.figures(),
            coarse: None,
            increment_error: None,
            checks: Checks {
                contact,
                residual: evidence.equilibrium_residual,
                reaches_edge: evidence.reaches_edge,
                has_collapsed: evidence.has_collapsed,
            },
            history: outcome.history.clone(),
            path: Path::default(),
            search: Search::default(),
            contact_stiffness: None,
            enlargements: 0,
            is_preliminary: false,
            field: (),
        }
    }
}

impl Engine for Springs {
    type System = HalfPlanes;
    type Design = Design;
    type Answer = SpringAnswer;
    type Error = Error;

    fn build(
        &self,
        design: &mut Design,
        _: &mut Run<'_>,
    ) -> Result<(HalfPlanes, Option<BlockVector>), Error> {
        Ok((HalfPlanes::new(*design, self.spacing), None))
    }

    fn verdict(
        &self,
        design: &Design,
        mut system: HalfPlanes,
        outcome: Outcome,
        under: Round,
        _: &mut Run<'_>,
    ) -> Result<VerdictOf<Self>, Error> {
        let contact = &outcome.state.response.contact;
        let continued = under.number;
        if outcome.status.is_stopped() {
            return Ok(Verdict::Accept(SpringAnswer { system, outcome, continued }));
        }
        let mut springs = contact.force.iter().zip(&system.watched);
        if springs.any(|(force, is_watched)| !is_watched && *force > YIELD * system.spacing) {
            system.watched.fill(true);
            let start = Some(outcome.state.response.displacement);
            return Ok(Verdict::Continue { system, start, history: outcome.history });
        }
        if contact.active_set.contains(0) {
            let pairs = design.pairs + 2 * (design.pairs / 4);
            return Ok(Verdict::Again(Design { pairs, ..*design }));
        }
        Ok(Verdict::Accept(SpringAnswer { system, outcome, continued }))
    }
}

impl Springs {
    /// Solves one load from the undeformed state.
    fn answer(&self, load: ContactLoad, run: &mut Run<'_>) -> Result<SpringAnswer, Error> {
        let design = Design { pairs: 41, watched: 21 };
        solve(self, design, None, run, |on, system, start, run| {
            on.solve(system, start, self.coupling, Controls { load, ..self.controls() }, run)
        })
    }
}

impl Memory for Springs {
    type Field = ();
    /// Number of contact pairs that was sufficient, and displacements at the end of each
    /// increment.
    type Record = (usize, Vec<BlockVector>);

    fn coupling(&self) -> &dyn Coupling {
        self.coupling
    }

    fn controls(&self) -> Controls<'_> {
        Controls {
            contact: &ActiveSetSolver,
            load: ContactLoad::Force(0.0),
            tolerance: TOLERANCE,
            max_iterations: 2000,
            renewable: false,
            scales: Scales::default(),
            increment: None,
        }
    }

    fn parts(answer: &SpringAnswer) -> (&HalfPlanes, &Outcome) {
        (&answer.system, &answer.outcome)
    }

    fn outcome_mut(answer: &mut SpringAnswer) -> &mut Outcome {
        &mut answer.outcome
    }

    fn into_parts(answer: SpringAnswer) -> (HalfPlanes, Outcome) {
        (answer.system, answer.outcome)
    }

    fn figures(answer: &SpringAnswer) -> Figures {
        answer.figures()
    }

    fn has_collapsed(_: &SpringAnswer) -> bool {
        false
    }

    fn measure(&self, answer: &SpringAnswer, _: &Self::Record) -> Figures {
        answer.figures()
    }

    fn begin(&self, system: &HalfPlanes) -> Self::Record {
        (system.initial_gap.len(), Vec::new())
    }

    fn bytes((_, displacements): &Self::Record) -> usize {
        size_of_val(displacements.as_slice())
    }

    fn design_after(&self, (pairs, _): &Self::Record) -> Design {
        Design { pairs: *pairs, watched: 21 }
    }

    fn finer(&self, (pairs, _): &Self::Record) -> (Self, Design) {
        (Self { spacing: SPACING, ..*self }, Design { pairs: 2 * pairs - 1, watched: 21 })
    }

    fn growth(&self, _: ContactLoad) -> Growth {
        Growth { onset: Some(50.0), exponent: 1.6 }
    }

    fn prepare(
        &self,
        system: &mut HalfPlanes,
        increment: &NextIncrement<'_, Self::Record>,
        _: &mut Run<'_>,
    ) -> Result<BlockVector, Error> {
        let NextIncrement { target, leg, progress, .. } = increment;
        Ok(progress.extrapolated(system.accepted().clone(), target.magnitude(), leg))
    }

    fn remember(&self, answer: &mut SpringAnswer, memory: &mut Self::Record, _: f64, _: bool) {
        memory.1.push(answer.outcome.state.response.displacement.clone());
    }

    fn step(
        &self,
        answer: &mut SpringAnswer,
        load: ContactLoad,
        _: &mut Self::Record,
        progress: &Progress,
        _: &mut Run<'_>,
    ) -> Step<()> {
        let least =
            LeastScales { residual: progress.scales.force, contact: progress.contact_scales };
        answer.step(load, least)
    }

    fn step_as_iterated(&self, answer: &SpringAnswer, load: ContactLoad) -> Step<()> {
        let Self::Answer { system, outcome, .. } = answer;
        let evidence = Evidence::of_iteration(system, outcome, false);
        answer.judged(&evidence, load, ContactScales::default())
    }
}

/// Spacing of the contact pairs at the requested density \[mm\].
const SPACING: f64 = 0.01;

impl Springs {
    /// The bodies with the contact pairs at a spacing.
    fn at(density: Density, coupling: &'static dyn Coupling) -> Self {
        let spacing = if density == Density::Asked { SPACING } else { 2.0 * SPACING };
        Self { coupling, spacing }
    }
}
