//! Wherever a job is stopped, it keeps what it has iterated.

use std::ops::ControlFlow;

use brinell_method::Error;
use brinell_solver::inputs::{SolveError, run};
use brinell_solver::job::Job;
use brinell_solver::report::{self, StepReport};
use brinell_solver::solver::{
    IncrementNumber, Interrupt, IterationRecord, Observer, SolveStatus, Unobserved,
};

fn is_cancelled(error: &SolveError) -> bool {
    error.method() == Some(&Error::Interrupted(Interrupt::Cancelled))
}
use serde_json::{Value, json};

/// Says stop at the n-th question, and counts the iterations that it has seen.
struct StopAt {
    questions: usize,
    iterations: usize,
}

impl Observer for StopAt {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.iterations += 1;
        assert_eq!(record.iteration, self.iterations, "iterations are counted through");
        self.on_checkpoint()
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        match self.questions.checked_sub(1) {
            Some(left) => {
                self.questions = left;
                ControlFlow::Continue(())
            }
            None => ControlFlow::Break(Interrupt::Cancelled),
        }
    }
}

/// A punch on a block that does not harden, which takes several linearizations.
fn job(coupling: &str) -> Job {
    let cylinder = json!({"type": "cylinder", "radius": 20.0});
    let law = json!({"law": "bilinear", "yield_stress": 200.0, "tangent_modulus": 0.0});
    let job: Value = json!({
        "analysis": "plane_strain",
        "upper": {"shape": cylinder, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 120.0, "depth": 60.0}, "support": "clamped",
                  "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3,
                      "plasticity": law}},
        "load": {"force": 1200.0}, "mesh": {"elements_per_half_width": 8},
        "solver": {"theory": "deformation", "coupling": coupling},
    });
    Job::from_json(job.to_string().as_bytes()).unwrap()
}

/// Meshes that serve several loads, and coarser ones beside them, may be stopped in the midst of
/// anything.
#[test]
#[ignore = "full"]
fn a_sweep_that_is_stopped_keeps_the_steps_before() {
    let cylinder = json!({"shape": {"type": "cylinder", "radius": 20.0},
        "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3,
                     "plasticity": {"law": "bilinear", "yield_stress": 500.0,
                         "tangent_modulus": 10_500.0}}});
    let job: Value = json!({
        "analysis": "plane_strain", "upper": cylinder, "lower": cylinder,
        "load": {"forces": [300.0, 330.0, 360.0, 390.0]}, "mesh": {"elements_per_half_width": 5},
        "solver": {"theory": "deformation"},
    });
    let job = Job::from_json(job.to_string().as_bytes()).unwrap();
    let (mut most, mut stopped) = (0, 0);
    for questions in 0.. {
        match run(&job, &mut StopSweepAt(questions)) {
            Err(error) if is_cancelled(&error) => {
                assert_eq!(most, 0, "question {questions}");
            }
            Err(error) => panic!("stopped at question {questions}: {error}"),
            Ok(solution) => {
                let converged = solution
                    .steps
                    .iter()
                    .filter(|step| step.status == SolveStatus::Converged)
                    .count();
                assert!(
                    converged >= most && converged + 1 >= solution.steps.len(),
                    "question {questions}"
                );
                most = converged;
                if most == 4 {
                    break;
                }
                stopped += 1;
            }
        }
    }
    assert!(stopped > 50, "stopped at {stopped} places");
}

/// Up, nearly to nothing, farther up than before, and back.
fn history() -> Job {
    let cylinder = json!({"shape": {"type": "cylinder", "radius": 20.0},
        "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3,
                     "plasticity": {"law": "bilinear", "yield_stress": 500.0,
                         "tangent_modulus": 10_500.0}}});
    let job: Value = json!({
        "analysis": "plane_strain", "upper": cylinder, "lower": cylinder,
        "load": {"history": [{"force": 500}, {"force": 100}, {"force": 600}, {"force": 0}]},
        "mesh": {"elements_per_half_width": 6}, "solver": {"theory": "flow", "increments": 3},
    });
    Job::from_json(job.to_string().as_bytes()).unwrap()
}

/// How many questions are asked while a job is solved.
fn questions(solve: impl FnOnce(&mut StopSweepAt)) -> usize {
    let mut whole = StopSweepAt(usize::MAX);
    solve(&mut whole);
    usize::MAX - whole.0
}

/// Loads that are finished stay answers with stresses; of the others there is what the coarse mesh
/// has found.
#[test]
#[ignore = "full"]
fn a_history_that_is_stopped_keeps_the_loads_that_are_finished() {
    let job = history();
    let whole = run(&job, &mut Unobserved).unwrap();
    let asked = questions(|observer| drop(run(&job, observer).unwrap()));
    let (mut most, mut most_converged, mut preliminary) = (0, 0, 0);
    for questions in (0..asked).step_by(asked / 150 + 1) {
        let steps = match run(&job, &mut StopSweepAt(questions)) {
            Ok(solution) => solution.steps,
            Err(error) if is_cancelled(&error) => Vec::new(),
            Err(error) => panic!("stopped at question {questions}: {error}"),
        };
        let converged =
            steps.iter().take_while(|step| step.status == SolveStatus::Converged).count();
        assert!(steps.len() >= most && converged >= most_converged, "question {questions}");
        (most, most_converged) = (steps.len(), converged);
        for (k, (step, expected)) in steps.iter().zip(&whole.steps).enumerate() {
            let has_stresses =
                step.field.bodies.iter().flatten().all(|body| !body.stress.points.is_empty());
            assert_eq!(has_stresses, k < converged, "question {questions}");
            if k < converged {
                assert_eq!(
                    (step.figures.peak_pressure, step.figures.approach),
                    (expected.figures.peak_pressure, expected.figures.approach)
                );
            } else {
                assert_eq!(step.status, SolveStatus::Cancelled);
                assert!(step.is_preliminary || k == converged, "one load at most is iterated");
            }
            if step.is_preliminary {
                preliminary += 1;
                assert_eq!(step.load, expected.load);
                assert!(
                    (step.figures.approach - expected.figures.approach).abs()
                        < 0.1 * whole.steps[2].figures.approach
                );
                assert!(step.coarse.is_none() && step.contact_stiffness.is_none());
            }
        }
    }
    assert!(
        most == 4 && most_converged >= 3 && preliminary > 100,
        "{most} {most_converged} {preliminary}"
    );
}

/// So it is in the report, and each step says what it is.
#[test]
fn the_report_of_a_history_that_is_stopped_has_the_loads_that_are_finished() {
    let job = history();
    let asked = questions(|observer| drop(report::run(&job, observer).unwrap()));
    let says = |step: &StepReport, words: &str| {
        step.validity.iter().any(|note| note.code == "cancelled" && note.message.contains(words))
    };
    let mut seen = [false; 2];
    for questions in (asked / 3..asked).step_by(asked / 40 + 1) {
        let Ok(stopped) = report::run(&job, &mut StopSweepAt(questions)) else { continue };
        assert_eq!(stopped.status, SolveStatus::Cancelled);
        for step in &stopped.steps {
            let is_converged = step.status == SolveStatus::Converged;
            let has_stresses = step.plasticity.upper.is_some() && step.subsurface.is_some();
            assert_eq!(has_stresses, is_converged, "question {questions}");
            assert_eq!(is_converged, !says(step, "Stopped on request"));
            seen[0] |= is_converged;
            if says(step, "mesh of half the density") {
                seen[1] = true;
                assert!(step.answers.is_empty());
            }
        }
    }
    assert_eq!(seen, [true; 2]);
}

/// Says stop from the n-th question on.
struct StopSweepAt(usize);

impl Observer for StopSweepAt {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        match self.0.checked_sub(1) {
            Some(left) => {
                self.0 = left;
                ControlFlow::Continue(())
            }
            None => ControlFlow::Break(Interrupt::Cancelled),
        }
    }
}

/// Questions are asked up to the last field of the report, and a job that is stopped at any of
/// them has no field at all.
#[test]
fn the_report_of_a_job_can_be_stopped() {
    let cylinder = |yield_stress: f64| {
        json!({"shape": {"type": "cylinder", "radius": 20.0},
            "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3,
                         "plasticity": {"law": "bilinear", "yield_stress": yield_stress,
                             "tangent_modulus": 10_500.0}}})
    };
    let job: Value = json!({
        "analysis": "plane_strain", "upper": cylinder(500.0), "lower": cylinder(400.0),
        "load": {"force": 400.0},
        "mesh": {"elements_per_half_width": 5}, "output": {"fields": true, "subsurface": true},
        "solver": {"theory": "deformation"},
    });
    let job = Job::from_json(job.to_string().as_bytes()).unwrap();
    let mut whole = StopSweepAt(usize::MAX);
    assert_eq!(report::run(&job, &mut whole).unwrap().status, SolveStatus::Converged);
    let asked = usize::MAX - whole.0;
    // Solution, stress and check of each body, stiffness; stresses over depth, plastic zone and
    // fields of each body.
    for questions in asked - 18..asked {
        let stopped = report::run(&job, &mut StopSweepAt(questions)).unwrap();
        let step = &stopped.steps[0];
        assert_eq!(
            (stopped.status, step.status),
            (SolveStatus::Cancelled, SolveStatus::Cancelled)
        );
        assert!(
            step.answers.is_empty() && step.contact.nodes.pressure.iter().any(|p| *p > 0.0),
            "question {questions}"
        );
        assert!(
            step.fields.is_none() && step.subsurface.is_none() && step.plasticity.upper.is_none()
        );
    }
    assert_eq!(report::run(&job, &mut StopSweepAt(asked)).unwrap().status, SolveStatus::Converged);
}

#[test]
#[ignore = "full"]
fn a_job_that_is_stopped_keeps_its_iterations() {
    for (coupling, every) in [("accelerated", 1), ("secant_stiffness", 7)] {
        let job = job(coupling);
        let mut renewals = 0;
        for questions in (0..).step_by(every) {
            let mut observer = StopAt { questions, iterations: 0 };
            match run(&job, &mut observer) {
                Err(error) if is_cancelled(&error) => {
                    assert_eq!(
                        observer.iterations, 0,
                        "{coupling}, stopped at question {questions}"
                    );
                }
                Err(error) => panic!("{coupling}, stopped at question {questions}: {error}"),
                Ok(solution) => {
                    let step = &solution.steps[0];
                    assert_eq!(step.history.len(), observer.iterations, "{coupling} {questions}");
                    assert!(step.field.pairs.iter().any(|pair| pair.pressure > 0.0));
                    renewals = step.history[1..]
                        .iter()
                        .filter(|record| record.factorizations > 0)
                        .count();
                    if step.status == SolveStatus::Converged {
                        break;
                    }
                    assert_eq!(step.status, SolveStatus::Cancelled);
                    assert!(step.contact_stiffness.is_none());
                }
            }
        }
        assert!(renewals > 0, "{coupling} factorizes while it iterates");
    }
}

/// Takes down which increments it is told of, and which before, of a preliminary solve.
#[derive(Default)]
struct Increments(Vec<IncrementNumber>, Vec<IncrementNumber>);

impl Observer for Increments {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.0.extend(record.increment);
        ControlFlow::Continue(())
    }

    fn on_preliminary_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        assert!(self.0.is_empty(), "the preliminary solve comes first");
        self.1.extend(record.increment);
        ControlFlow::Continue(())
    }
}

/// Every iteration of the final mesh says in which increment of which load it is; those of
/// deformation theory are in none.
#[test]
fn a_history_says_how_far_it_is() {
    let mut asked = job("accelerated");
    let mut seen = Increments::default();
    run(&asked, &mut seen).unwrap();
    assert!(seen.0.is_empty());
    let mut wire = serde_json::to_value(&asked).unwrap();
    wire["load"] = json!({"history": [{"force": 500}, {"force": 0}]});
    wire["solver"] = json!({"theory": "flow", "increments": 3});
    asked = Job::from_value(&wire).unwrap();
    let solution = run(&asked, &mut seen).unwrap();
    let mut told = seen.0.clone();
    told.dedup();
    let all = (1..=2).flat_map(|load| {
        (1..=3).map(move |number| IncrementNumber { number, count: 3, load, loads: 2 })
    });
    assert_eq!(told, all.collect::<Vec<_>>());
    let preliminary = IncrementNumber { number: 3, count: 3, load: 2, loads: 2 };
    assert!(seen.1.contains(&preliminary), "{:?}", seen.1);
    let kept: Vec<_> =
        solution.steps.iter().flat_map(|step| &step.history).filter_map(|r| r.increment).collect();
    assert_eq!(kept, seen.0);
}

/// Asks so many questions of the observer, if nothing stops it.
fn questions_of(job: &Job) -> usize {
    let mut watch = StopSweepAt(usize::MAX);
    report::run(job, &mut watch).unwrap();
    usize::MAX - watch.0
}

/// Wherever it is stopped, a test of hardness has the steps that it has, and no number.
#[test]
fn a_test_of_hardness_that_is_stopped_has_a_report() {
    let job = Job::from_value(&json!({
        "lower": {"shape": {"type": "block", "width": 10, "depth": 5}, "material":
            {"young_modulus": 208_000, "poisson_ratio": 0.3, "plasticity":
                {"law": "bilinear", "yield_stress": 800, "tangent_modulus": 2000}}},
        "load": {"hardness": {"scale": "sphere", "ball": 10, "force": 500}},
        "mesh": {"elements_per_half_width": 5}, "solver": {"increments": 8},
    }))
    .unwrap();
    let all = questions_of(&job);
    let mut reports = 0;
    for part in 1..24 {
        match report::run(&job, &mut StopSweepAt(all * part / 24)) {
            Ok(report) => {
                assert_eq!(report.status, SolveStatus::Cancelled);
                reports += 1;
            }
            Err(error) => assert!(error.to_string().starts_with("stopped"), "{error}"),
        }
    }
    assert!(reports > 4, "{reports} reports");
}

/// A stop in the midst of a transform loses its pass and no other.
#[test]
fn passes_that_are_finished_stay() {
    let law = json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 0});
    let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": law});
    let job = Job::from_value(&json!({
        "analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": 20}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 400, "depth": 200}, "material": steel},
        "load": {"rolling": {"force": 380, "passes": 12, "until": "passes"}},
        "mesh": {"elements_per_half_width": 6}, "solver": {"theory": "flow"},
    }))
    .unwrap();
    let all = questions_of(&job);
    let mut kept = 0;
    for part in 1..40 {
        let report = match report::run(&job, &mut StopSweepAt(all * part / 40 + part)) {
            Ok(report) => report,
            Err(error) => {
                assert_eq!(kept, 0, "part {part}: {error}");
                continue;
            }
        };
        let passes = report.steps[0].passes.as_ref().unwrap().number.len();
        assert!(passes >= kept, "part {part}: {passes} passes, {kept} before");
        kept = passes;
    }
    assert!(kept > 8, "{kept} passes");
}
