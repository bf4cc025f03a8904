//! A second engine, by which the method is tested without finite elements: two half-planes that touch along a line, with a layer
//! of springs between them that yield.
//!
//! Each pair k has a spring of stiffness s in series with the half-planes. It carries `R = s (w - p)` under a compression w, of
//! which p is plastic: it grows so that `R = R_y + H p` beyond yield, and is never taken back. The initial stress is `s p`.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use super::bracket::{Bracket, Next};
use super::contact_system::{BlockVector, ContactFigures, ContactSystem};
use super::couplings::iteration::{Controls, InitialState, Outcome, Scales, norm};
use super::couplings::{self, Accelerated, Coupling, SecantStiffness, Strong, Weak};
use super::observer::{Interrupt, IterationRecord, Observer, SolveStatus};
use super::run::Run;
use super::solve::{Engine, Leave, Round, Verdict, solve};
use crate::contact::{
    ActiveSetSolver, ContactLoad, ContactProblem, ContactSolution, ContactSolver, SimplexSolver, kkt, never,
};
use crate::solver::{Solution, SolveError, Unobserved};
use sparse_cholesky::dense::SymmetricMatrix;

/// Radius of the upper surface \[mm\], modulus E\* of both bodies \[MPa\], and the depth where displacements are zero \[mm\].
const RADIUS: f64 = 10.0;
const MODULUS: f64 = 1e5;
const DATUM: f64 = 100.0;
/// Stiffness and hardening of the springs \[N/mm² per mm\], and the pressure at which they yield \[MPa\].
const STIFFNESS: f64 = 1e7;
const HARDENING: f64 = 1e6;
const YIELD: f64 = 400.0;
/// Distance of the pairs \[mm\].
const SPACING: f64 = 0.01;

/// The springs, and the half-planes by their flexibility.
struct HalfPlanes {
    initial_gap: Vec<f64>,
    closing: Vec<f64>,
    flexibility: SymmetricMatrix,
    /// Whether each spring is looked at for plastic flow.
    watched: Vec<bool>,
    /// Compressions of the accepted state, and what is plastic of them.
    accepted: BlockVector,
    plastic: Vec<f64>,
}

impl HalfPlanes {
    fn new(Design { pairs, watched }: Design) -> Self {
        let x = |k: usize| (k as f64 - 0.5 * (pairs - 1) as f64) * SPACING;
        let integral = |t: f64| if t == 0.0 { 0.0 } else { t * (t.abs() / DATUM).ln() - t };
        let flexibility = SymmetricMatrix::from_fn(pairs, |i, j| {
            let (near, far) = (x(i) - x(j) - 0.5 * SPACING, x(i) - x(j) + 0.5 * SPACING);
            let half_planes = -2.0 / (PI * MODULUS * SPACING) * (integral(far) - integral(near));
            half_planes + if i == j { 1.0 / (STIFFNESS * SPACING) } else { 0.0 }
        });
        let beside = (pairs - watched) / 2;
        Self {
            initial_gap: (0..pairs).map(|k| x(k).powi(2) / (2.0 * RADIUS)).collect(),
            closing: vec![1.0; pairs],
            flexibility,
            watched: (0..pairs).map(|k| (beside..pairs - beside).contains(&k)).collect(),
            accepted: vec![vec![0.0; pairs]],
            plastic: vec![0.0; pairs],
        }
    }

    /// What is plastic of a compression.
    fn plastic_compression(&self, pair: usize, w: f64) -> f64 {
        let before = self.plastic[pair];
        let beyond_yield = (STIFFNESS * w - YIELD) / (STIFFNESS + HARDENING);
        if self.watched[pair] { beyond_yield.max(before) } else { before }
    }

    fn widened(&self, gap_opening: &[f64]) -> Vec<f64> {
        self.initial_gap.iter().zip(gap_opening).map(|(gap, opening)| gap + opening).collect()
    }
}

impl ContactSystem for HalfPlanes {
    fn zeros(&self) -> BlockVector {
        vec![vec![0.0; self.initial_gap.len()]]
    }

    fn initial_gap(&self) -> &[f64] {
        &self.initial_gap
    }

    fn contact_problem<'a>(&'a self, initial_gap: &'a [f64], load: ContactLoad) -> ContactProblem<'a> {
        ContactProblem { flexibility: &self.flexibility, initial_gap, closing: &self.closing, load }
    }

    fn gap_opening(&self, initial_stress: &BlockVector) -> Vec<f64> {
        initial_stress[0].iter().map(|stress| stress / (STIFFNESS * SPACING)).collect()
    }

    fn displacement(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector {
        let loads = initial_stress[0].iter().zip(force);
        vec![loads.map(|(stress, force)| (stress + force) / (STIFFNESS * SPACING)).collect()]
    }

    fn initial_stress(&self, displacement: &BlockVector, into: &mut BlockVector) -> usize {
        let mut flowing = 0;
        for (k, stress) in into[0].iter_mut().enumerate() {
            let plastic = self.plastic_compression(k, displacement[0][k]);
            *stress = STIFFNESS * SPACING * plastic;
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
        self.plastic =
            displacement[0].iter().enumerate().map(|(k, &w)| self.plastic_compression(k, w)).collect();
        self.accepted = displacement;
    }

    fn figures(&self, contact: &ContactSolution) -> ContactFigures {
        ContactFigures {
            force: contact.total_force,
            approach: contact.approach,
            peak_pressure: contact.force.iter().copied().fold(0.0, f64::max) / SPACING,
            pairs: contact.active_set.len(),
        }
    }
}

/// How many pairs there are, and how many of them are looked at for plastic flow.
#[derive(Clone, Copy)]
struct Design {
    pairs: usize,
    watched: usize,
}

struct Springs;

struct Answer {
    system: HalfPlanes,
    outcome: Outcome,
    /// How often more springs were looked at.
    continued: usize,
}

impl Engine for Springs {
    type System = HalfPlanes;
    type Design = Design;
    type Answer = Answer;

    fn build(
        &self,
        design: &mut Design,
        _: &mut Run<'_>,
    ) -> Result<(HalfPlanes, Option<BlockVector>), SolveError> {
        Ok((HalfPlanes::new(*design), None))
    }

    fn resume(
        &self,
        _: &Design,
        system: HalfPlanes,
        _: &mut Run<'_>,
    ) -> Result<(HalfPlanes, Option<BlockVector>), SolveError> {
        Ok((system, None))
    }

    fn verdict(
        &self,
        design: &Design,
        mut system: HalfPlanes,
        outcome: Outcome,
        under: Round,
        _: &mut Run<'_>,
    ) -> Result<Verdict<Self>, SolveError> {
        let contact = &outcome.state.response.contact;
        if outcome.status.is_stopped() {
            return Ok(Verdict::Accept(Answer { system, outcome, continued: under.number }));
        }
        let mut springs = contact.force.iter().zip(&system.watched);
        if springs.any(|(force, is_watched)| !is_watched && *force > YIELD * SPACING) {
            system.watched.fill(true);
            let start = Some(outcome.state.response.displacement);
            return Ok(Verdict::Continue { system, start, history: outcome.history });
        }
        if contact.active_set.contains(0) {
            let pairs = design.pairs + design.pairs / 2;
            return Ok(Verdict::Again(Design { pairs, ..*design }));
        }
        Ok(Verdict::Accept(Answer { system, outcome, continued: under.number }))
    }
}

fn controls(load: ContactLoad) -> Controls<'static> {
    Controls {
        contact: &ActiveSetSolver,
        load,
        tolerance: 1e-9,
        max_iterations: 2000,
        renewable: false,
        scales: Scales::default(),
        increment: None,
    }
}

/// Solves forces in order, and counts the systems made.
fn solved(coupling: &dyn Coupling, forces: &[f64], observer: &mut dyn Observer) -> (Vec<Answer>, usize) {
    let mut solution = Solution::default();
    let mut run = Run::new(&mut solution, observer);
    let design = Design { pairs: 41, watched: 21 };
    let answers = solve(&Springs, design, None, &mut run, |mesh, mut system, mut start, run| {
        let mut answers = Vec::new();
        for &force in forces {
            let answer = mesh.solve(system, start, coupling, controls(ContactLoad::Force(force)), run)?;
            start = Some(answer.outcome.state.response.displacement.clone());
            system =
                HalfPlanes::new(Design { pairs: answer.system.initial_gap.len(), watched: design.watched });
            answers.push(answer);
        }
        Ok::<_, Leave<Design>>(answers)
    });
    (answers.unwrap(), solution.passes)
}

fn peak(answer: &Answer) -> f64 {
    answer.system.figures(&answer.outcome.state.response.contact).peak_pressure
}

#[test]
fn springs_that_do_not_yield_leave_the_pressure_of_hertz() {
    let (answers, _) = solved(&Strong, &[40.0], &mut Unobserved);
    let hertz = (40.0 * MODULUS / (PI * RADIUS)).sqrt();
    // The springs take a little of the peak.
    let share = peak(&answers[0]) / hertz;
    assert!((0.95..0.97).contains(&share), "{share}");
    assert_eq!(answers[0].outcome.history.len(), 1);
}

#[test]
fn couplings_agree_and_the_answer_satisfies_the_laws() {
    let couplings: [(&str, &dyn Coupling); 3] =
        [("strong", &Strong), ("weak", &Weak), ("accelerated", &Accelerated)];
    let mut peaks = Vec::new();
    for (name, coupling) in couplings {
        let (answers, systems) = solved(coupling, &[400.0], &mut Unobserved);
        let Answer { system, outcome, continued } = &answers[0];
        assert_eq!(outcome.status, SolveStatus::Converged, "{name}");
        assert!(systems > 1 && *continued == 1, "{name}: {systems} systems, continued {continued} times");
        let contact = &outcome.state.response.contact;
        let plastic = system.gap_opening(&outcome.state.loads);
        let gap = system.widened(&plastic);
        let check = kkt::check(
            &system.contact_problem(&gap, ContactLoad::Force(400.0)),
            &contact.force,
            contact.approach,
        );
        assert!(check.is_sound(), "{check:?}");
        for (force, p) in contact.force.iter().zip(plastic).filter(|(_, p)| *p > 0.0) {
            let law = (YIELD + HARDENING * p) * SPACING;
            assert!((force - law).abs() < 1e-6 * law, "{name}: {force} {law}");
        }
        peaks.push(peak(&answers[0]));
    }
    assert!(peaks.iter().all(|peak| (peak / peaks[0] - 1.0).abs() < 1e-7), "{peaks:?}");
    let hertz = (400.0 * MODULUS / (PI * RADIUS)).sqrt();
    assert!(peaks[0] < 0.9 * hertz, "{peaks:?} {hertz}");
}

#[test]
fn both_contact_solvers_find_one_contact() {
    let system = HalfPlanes::new(Design { pairs: 101, watched: 0 });
    let problem = system.contact_problem(&system.initial_gap, ContactLoad::Force(100.0));
    let [a, b] = [&ActiveSetSolver as &dyn ContactSolver, &SimplexSolver]
        .map(|solver| solver.solve(&problem, None, &mut never).unwrap());
    assert_eq!(a.active_set, b.active_set);
    assert!((a.approach - b.approach).abs() < 1e-12);
}

#[test]
fn a_history_begins_anew_where_its_contact_outgrows_the_system() {
    let forces = [10.0, 400.0, 100.0];
    let (answers, systems) = solved(&Accelerated, &forces, &mut Unobserved);
    assert_eq!(answers.len(), 3);
    assert!(systems > 1);
    // All of them on the last one.
    assert!(
        answers.iter().all(|answer| answer.system.initial_gap.len() == answers[1].system.initial_gap.len())
    );
    let (single, _) = solved(&Accelerated, &[100.0], &mut Unobserved);
    assert!((peak(&answers[2]) / peak(&single[0]) - 1.0).abs() < 1e-6);
}

/// The force under which the largest pressure is as wanted, to a tenth of a per cent.
fn force_of_pressure(wanted: f64, mut force: f64) -> f64 {
    let mut bracket = Bracket::new(0.5);
    for _ in 0..20 {
        let (answers, _) = solved(&Accelerated, &[force], &mut Unobserved);
        let ratio = peak(&answers[0]) / wanted;
        if (ratio - 1.0).abs() < 1e-3 {
            return force;
        }
        bracket.record(force, ratio);
        let Next::Force(next) = bracket.next() else { panic!("no force beyond {force} N/mm") };
        force = next;
    }
    panic!("not found, last tried {force} N/mm");
}

#[test]
fn a_search_finds_the_force_of_a_pressure_from_either_side() {
    let [below, above] = [40.0, 600.0].map(|first| force_of_pressure(600.0, first));
    assert!((below / above - 1.0).abs() < 0.01, "{below} {above}");
    // Plastic flow takes more of the peak than the springs do without it.
    let elastic = 0.95 * (below * MODULUS / (PI * RADIUS)).sqrt();
    assert!(elastic > 600.0, "{elastic}");
}

/// Sees iterations and stops one of them.
struct Stopping {
    seen: usize,
    last: usize,
}

impl Observer for Stopping {
    fn on_iteration(&mut self, _: &IterationRecord) -> ControlFlow<Interrupt> {
        self.seen += 1;
        if self.seen == self.last {
            ControlFlow::Break(Interrupt::Cancelled)
        } else {
            ControlFlow::Continue(())
        }
    }
}

#[test]
fn an_observer_sees_each_iteration_and_stops_one() {
    let mut observer = Stopping { seen: 0, last: 3 };
    let (answers, _) = solved(&Strong, &[400.0], &mut observer);
    assert_eq!((observer.seen, answers[0].outcome.history.len()), (3, 3));
    assert_eq!(answers[0].outcome.status, SolveStatus::Cancelled);
}

#[test]
fn bodies_without_a_stiffness_have_no_secant_moduli() {
    let mut solution = Solution::default();
    let mut observer = Unobserved;
    let mut run = Run::new(&mut solution, &mut observer);
    let mut system = HalfPlanes::new(Design { pairs: 61, watched: 61 });
    let secant = &SecantStiffness;
    let load = controls(ContactLoad::Force(10.0));
    let outcome = couplings::iterate(&mut system, secant, load, InitialState::default(), &mut run);
    assert_eq!(outcome.err(), Some(SolveError::NoSecantStiffness));
}
