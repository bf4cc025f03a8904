//! Solvers that misbehave on demand: `tags.test` says how.

use std::ops::ControlFlow;
use std::sync::{Condvar, Mutex};
use std::time::Duration;

use brinell::jobs::{CoreSolver, FieldError, JobSolver};
use brinell_solver::job::Job;
use brinell_solver::report::{
    JobEstimate, MeshReport, Report, RunError, StepReport, Timings, preflight, run,
};
use brinell_solver::solver::{Interrupt, IterationRecord, Observer, SolveStatus};

/// `abort`, `panic`, `nan`, `impossible`, `fail`; `understated` is estimated to need a byte, and
/// solved; `flood` has steps until it is told to stop; `slow` iterates until the gate is opened or
/// it is told to stop; `preliminary` does so in a preliminary solve, and then iterates once; anything else converges at once.
#[derive(Default)]
pub struct TestSolver {
    open: Mutex<bool>,
    changed: Condvar,
}

impl TestSolver {
    /// Lets slow jobs converge.
    pub fn open_gate(&self) {
        *self.open.lock().unwrap() = true;
        self.changed.notify_all();
    }

    fn wait_a_little(&self) -> bool {
        let open = self.open.lock().unwrap();
        *self.changed.wait_timeout_while(open, Duration::from_millis(1), |open| !*open).unwrap().0
    }

    fn iterate(&self, mut show: impl FnMut(&IterationRecord) -> ControlFlow<Interrupt>) -> Report {
        for iteration in 1.. {
            if let ControlFlow::Break(interrupt) = show(&record(iteration)) {
                return report(match interrupt {
                    Interrupt::Cancelled => SolveStatus::Cancelled,
                    Interrupt::TimedOut => SolveStatus::TimedOut,
                });
            }
            if self.wait_a_little() {
                break;
            }
        }
        report(SolveStatus::Converged)
    }
}

impl JobSolver for TestSolver {
    fn estimate(&self, job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
        let estimate = preflight(job)?;
        let is_understated = job.tags.get("test").is_some_and(|test| test == "understated");
        Ok(if is_understated { JobEstimate { bytes: 1, ..estimate } } else { estimate })
    }

    fn solve(
        &self,
        job: &Job,
        observer: &mut dyn Observer,
        on_step: &mut dyn FnMut(usize, StepReport),
    ) -> Result<Report, RunError> {
        match job.tags.get("test").map(String::as_str) {
            Some("abort") => std::process::abort(),
            Some("panic") => panic!("the secret of the solver"),
            Some("nan") => {
                let mut report = report(SolveStatus::Converged);
                report.timings_ms.total = f64::NAN;
                Ok(report)
            }
            Some("impossible") => {
                let detail = "more than the ring can carry".to_owned();
                Err(RunError::Input(vec![FieldError::not_solvable("/load/force", detail)]))
            }
            Some("understated") => CoreSolver::default().solve(job, observer, on_step),
            Some("flood") => {
                let step = run(job, observer)?.steps.remove(0);
                let flood = (0..).find_map(|number| {
                    on_step(number, step.clone());
                    observer.on_checkpoint().break_value()
                });
                flood.map_or(Ok(report(SolveStatus::Converged)), |interrupt| {
                    Err(RunError::Interrupted(interrupt))
                })
            }
            Some("fail") => {
                Err(RunError::Failed("the matrix is not positive definite".to_owned()))
            }
            Some("not_converged") => Ok(report(SolveStatus::NotConverged)),
            Some("slow") => Ok(self.iterate(|record| observer.on_iteration(record))),
            Some("preliminary") => {
                let report = self.iterate(|_| observer.on_preliminary_iteration(&record(1)));
                let _ = observer.on_iteration(&record(1));
                Ok(report)
            }
            _ => Ok(report(SolveStatus::Converged)),
        }
    }
}

fn record(iteration: usize) -> IterationRecord {
    IterationRecord {
        iteration,
        contact_pivots: 0,
        initial_stress_updates: 1,
        factorizations: 0,
        displacement_change: 1.0,
        force_change: 1.0,
        equilibrium_residual: 1.0,
        plastic_points: 0,
        contact_pairs: 1,
        approach: 0.1,
        peak_pressure: 1.0,
        elapsed_ms: 1.0,
        increment: None,
    }
}

fn report(status: SolveStatus) -> Report {
    Report {
        units: "mm_N_MPa".to_owned(),
        analysis: "plane_strain".to_owned(),
        theory: None,
        status,
        steps: Vec::new(),
        answers: Vec::new(),
        load_approach: None,
        found: None,
        tolerances: None,
        validity: Vec::new(),
        mesh: MeshReport::default(),
        timings_ms: Timings::default(),
        tags: std::collections::BTreeMap::new(),
        version: "test".to_owned(),
    }
}
