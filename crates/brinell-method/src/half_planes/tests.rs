#![cfg(test)]

use std::ops::ControlFlow;

use super::super::couplings::{self, Accelerated, SecantStiffness, Strong, Weak};
use super::super::force_search::{Search, Trials, find};
use super::super::history;
use super::super::increments::Increments;
use super::super::loads::{Stretch, each_load};
use super::super::observer::{Interrupt, IterationRecord, Observer, SolveStatus};
use super::super::sought::{Sought, Target, TargetFigure};
use super::*;
use crate::Limit;
use crate::observer::Unobserved;
use crate::phases::PhaseTimes;
use brinell_contact::{ContactSolver, SimplexSolver, kkt, never};

fn with_run<T>(observer: &mut dyn Observer, work: impl FnOnce(&mut Run<'_>) -> T) -> (T, usize) {
    let (mut phases, mut passes) = (PhaseTimes::default(), 0);
    let answer = work(&mut Run::new(&mut phases, &mut passes, observer));
    (answer, passes)
}

/// Solves one force from the undeformed state. Returns the answer and the number of systems built.
fn solved(
    coupling: &'static dyn Coupling,
    force: f64,
    observer: &mut dyn Observer,
) -> (SpringAnswer, usize) {
    let springs = Springs::at(Density::Asked, coupling);
    let (answer, systems) =
        with_run(observer, |run| springs.answer(ContactLoad::Force(force), run));
    (answer.unwrap(), systems)
}

fn peak(answer: &SpringAnswer) -> f64 {
    answer.figures().peak_pressure
}

fn hertz(force: f64) -> f64 {
    (force * MODULUS / (PI * RADIUS)).sqrt()
}

#[test]
fn springs_that_do_not_yield_leave_the_pressure_of_hertz() {
    let (answer, _) = solved(&Strong, 40.0, &mut Unobserved);
    // The springs reduce the peak pressure a little.
    let share = peak(&answer) / hertz(40.0);
    assert!((0.95..0.97).contains(&share), "{share}");
    assert_eq!(answer.outcome.history.len(), 1);
}

#[test]
fn couplings_agree_and_the_answer_satisfies_the_laws() {
    let couplings: [(&str, &'static dyn Coupling); 3] =
        [("strong", &Strong), ("weak", &Weak), ("accelerated", &Accelerated)];
    let mut peaks = Vec::new();
    for (name, coupling) in couplings {
        let (answer, systems) = solved(coupling, 400.0, &mut Unobserved);
        assert!(
            systems > 1 && answer.continued == 1,
            "{name}: {systems} systems, {}",
            answer.continued
        );
        let step = answer.step(ContactLoad::Force(400.0), LeastScales::default());
        assert_eq!(step.status, SolveStatus::Converged, "{name}: {:?}", step.checks.contact);
        let plastic = answer.system.gap_opening(&answer.outcome.state.loads);
        let force = &answer.outcome.state.response.contact.force;
        for (force, p) in force.iter().zip(plastic).filter(|(_, p)| *p > 0.0) {
            let law = (YIELD + HARDENING * p) * SPACING;
            assert!((force - law).abs() < 1e-6 * law, "{name}: {force} {law}");
        }
        peaks.push(peak(&answer));
    }
    assert!(peaks.iter().all(|peak| (peak / peaks[0] - 1.0).abs() < 1e-7), "{peaks:?}");
    assert!(peaks[0] < 0.9 * hertz(400.0), "{peaks:?}");
}

/// The final check rejects a converged iteration whose contact was altered.
#[test]
fn the_check_finds_out_a_wrong_contact() {
    let (mut answer, _) = solved(&Accelerated, 400.0, &mut Unobserved);
    answer.outcome.state.response.contact.approach *= 1.001;
    let step = answer.step(ContactLoad::Force(400.0), LeastScales::default());
    assert_eq!(step.status, SolveStatus::NotConverged);
    assert!(!step.checks.contact.is_sound());
}

#[test]
fn both_direct_solvers_find_one_contact() {
    let system = HalfPlanes::new(Design { pairs: 101, watched: 0 }, SPACING);
    let problem = system.contact_problem(&system.initial_gap, ContactLoad::Force(100.0));
    let [a, b] = [&ActiveSetSolver as &dyn ContactSolver, &SimplexSolver]
        .map(|solver| solver.solve(&problem, None, &mut never).unwrap());
    assert_eq!(a.active_set, b.active_set);
    assert!((a.approach - b.approach).abs() < 1e-12);
    assert!(kkt::check(&problem, &a.force, a.approach).is_sound());
}

/// The engine of a coarse history and its design.
fn coarse(coupling: &'static dyn Coupling) -> (Springs, Design) {
    (Springs::at(Density::Coarse, coupling), Design { pairs: 21, watched: 11 })
}

/// Solves a history. Returns the steps and the reason of an early end.
fn history_of(
    coupling: &'static dyn Coupling,
    forces: &[f64],
    observer: &mut dyn Observer,
) -> (Vec<Step<()>>, Option<Interrupt>) {
    let loads: Vec<_> = forces.iter().map(|force| ContactLoad::Force(*force)).collect();
    let mut steps = Vec::new();
    let (end, _) = with_run(observer, |run| {
        history::run(
            coarse(coupling),
            Stretch::whole(&loads),
            Increments::default(),
            run,
            &mut steps,
        )
    });
    (steps, end.unwrap())
}

#[test]
fn a_history_leaves_a_dent_and_loads_again_as_elastic_bodies_do() {
    let forces = [400.0, 0.0, 300.0, 400.0];
    let (steps, interrupt) = history_of(&Accelerated, &forces, &mut Unobserved);
    assert_eq!((steps.len(), interrupt), (4, None));
    for step in &steps {
        assert_eq!(step.status, SolveStatus::Converged, "{:?}", step.checks.contact);
        assert!(step.coarse.and(step.increment_error).is_some() && !step.is_preliminary);
    }
    // Each spring hardens by its own pressure, so that the number of increments has no effect.
    let (single, _) = solved(&Strong, 400.0, &mut Unobserved);
    for loaded in [&steps[0], &steps[3]] {
        assert!((loaded.figures.peak_pressure / peak(&single) - 1.0).abs() < 1e-6);
    }
    assert!(steps[1].figures.approach > 0.01 * steps[0].figures.approach);
    let end = &steps[2].path;
    assert_eq!((end.increments.len(), end.reached[0]), (1, steps[0].figures.approach));
    assert!(steps[0].path.increments.len() > 3);
}

#[test]
fn a_history_runs_by_every_initial_stress_coupling() {
    let couplings: [&'static dyn Coupling; 3] = [&Strong, &Weak, &Accelerated];
    let approaches = couplings.map(|coupling| {
        let (steps, _) = history_of(coupling, &[400.0, 0.0], &mut Unobserved);
        assert!(steps.iter().all(|step| step.status == SolveStatus::Converged));
        steps[1].figures.approach
    });
    assert!(approaches.iter().all(|a| (a / approaches[0] - 1.0).abs() < 1e-6), "{approaches:?}");
}

#[test]
fn a_sweep_hands_over_each_load() {
    let springs = Springs::at(Density::Asked, &Accelerated);
    let loads = [100.0, 400.0, 50.0].map(ContactLoad::Force);
    let mut steps = Vec::new();
    let (end, _) = with_run(&mut Unobserved, |run| {
        each_load(&loads, &mut steps, run, |load, _, run| {
            Ok::<_, Error>(springs.answer(load, run)?.step(load, LeastScales::default()))
        })
    });
    assert_eq!(end, Ok(None));
    let peaks: Vec<f64> = steps.iter().map(|step| step.figures.peak_pressure).collect();
    assert!(peaks[2] < peaks[0] && peaks[0] < peaks[1], "{peaks:?}");
    let (single, _) = solved(&Accelerated, 50.0, &mut Unobserved);
    assert!((peaks[2] / peak(&single) - 1.0).abs() < 1e-9);
}

/// Springs whose force is sought.
struct Searched;

impl Trials for Searched {
    type Field = ();
    type Error = Error;

    fn solve(
        &self,
        density: Density,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        steps: &mut Vec<Step<()>>,
    ) -> Result<Option<Interrupt>, Error> {
        let springs = Springs::at(density, &Accelerated);
        each_load(loads, steps, run, |load, _, run| {
            Ok(springs.answer(load, run)?.step(load, LeastScales::default()))
        })
    }

    fn too_large(error: Error) -> Result<Limit, Error> {
        Err(error)
    }

    fn utilization(&self, _: &Step<()>) -> f64 {
        0.0
    }

    fn figure(&self, step: &Step<()>, target: TargetFigure) -> f64 {
        target.of(&step.figures, 0.0)
    }

    fn error(&self, _: &Step<()>, _: TargetFigure) -> Option<f64> {
        Some(0.01)
    }
}

#[test]
fn a_search_finds_the_force_of_a_pressure_from_either_side() {
    let search = |first_force: f64, value: f64| {
        let sought = Sought::Target(Target { figure: TargetFigure::PeakPressure, value });
        let search = Search { sought, first_force, scatter_of_width: 0.0 };
        with_run(&mut Unobserved, |run| find(search, &Searched, run)).0
    };
    let [below, above] = [40.0, 600.0].map(|first| search(first, 600.0).unwrap());
    for found in [&below, &above] {
        assert!((found.trial.ratio - 1.0).abs() < 1e-3 && found.trial.is_converged());
        assert!((0.3..0.6).contains(&found.sensitivity), "{}", found.sensitivity);
        let search = found.trial.steps[0].search;
        assert_eq!(search.force_error, Some(0.01 / found.sensitivity));
        assert!(search.systems > 1);
    }
    let [a, b] = [&below, &above].map(|found| found.trial.steps[0].figures.force);
    assert!((a / b - 1.0).abs() < 0.01, "{a} {b}");
    // Plastic flow reduces the peak pressure more than the elastic springs do.
    assert!(0.95 * hertz(a) > 600.0);
}

/// Records iterations and stops at one of them.
struct Stopping {
    seen: Vec<IterationRecord>,
    last: usize,
}

impl Observer for Stopping {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.seen.push(record.clone());
        self.on_checkpoint()
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        if self.seen.len() >= self.last {
            ControlFlow::Break(Interrupt::Cancelled)
        } else {
            ControlFlow::Continue(())
        }
    }
}

#[test]
fn an_observer_sees_each_iteration_and_stops_one() {
    let mut observer = Stopping { seen: Vec::new(), last: 3 };
    let (answer, _) = solved(&Strong, 400.0, &mut observer);
    assert_eq!((observer.seen.len(), answer.outcome.history.len()), (3, 3));
    assert_eq!(answer.outcome.status, SolveStatus::Cancelled);
}

#[test]
fn a_history_that_is_stopped_keeps_what_is_done_and_what_the_coarse_one_has_found() {
    let (whole, _) = history_of(&Accelerated, &[400.0, 0.0], &mut Unobserved);
    let mut observer = Stopping { seen: Vec::new(), last: usize::MAX };
    history_of(&Accelerated, &[400.0, 0.0], &mut observer);
    let numbers: Vec<_> = observer.seen.iter().filter_map(|record| record.increment).collect();
    assert!(numbers.is_sorted_by_key(|number| (number.load, number.number)));
    assert_eq!(numbers.last().map(|number| (number.load, number.loads)), Some((2, 2)));
    let first_of_second = numbers.iter().position(|number| number.load == 2).unwrap();

    let mut observer = Stopping { seen: Vec::new(), last: first_of_second };
    let (steps, interrupt) = history_of(&Accelerated, &[400.0, 0.0], &mut observer);
    assert_eq!((steps.len(), interrupt), (2, Some(Interrupt::Cancelled)));
    assert!((steps[0].figures.approach / whole[0].figures.approach - 1.0).abs() < 1e-6);
    assert!(steps[1].is_preliminary && steps[1].status == SolveStatus::Cancelled);
}

#[test]
fn bodies_without_a_stiffness_have_no_secant_moduli() {
    let mut system = HalfPlanes::new(Design { pairs: 61, watched: 61 }, SPACING);
    let springs = Springs::at(Density::Asked, &SecantStiffness);
    let controls = Controls { load: ContactLoad::Force(10.0), ..springs.controls() };
    let (outcome, _) = with_run(&mut Unobserved, |run| {
        couplings::iterate(&mut system, &SecantStiffness, controls, InitialState::default(), run)
    });
    assert_eq!(outcome.err(), Some(Error::NoSecantStiffness));
}
