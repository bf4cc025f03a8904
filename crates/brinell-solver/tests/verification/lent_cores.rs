//! Cores that are lent change no answer, and a job that is stopped gives them back.

use std::ops::ControlFlow;
use std::sync::Arc;

use brinell_solver::solver::{self, Interrupt, Observer, Solution, SolveError, SolveStatus};
use serde_json::{Value, json};
use sparse_cholesky::Cores;

use crate::problems::{bilinear, bits, parse, solve, two_cylinders};

/// A contact of unequal bodies that is large enough to be shared.
fn large() -> Value {
    let mut job = two_cylinders("clamped", bilinear(), 612.6106);
    job["lower"]["shape"]["radius"] = json!(35.0);
    job["mesh"] = json!({"elements_per_half_width": 56});
    job["solver"] = json!({"tolerance": 1e-4});
    job
}

/// Lends cores, and stops the solve at some checkpoint.
struct Lender {
    cores: Arc<Cores>,
    checkpoints: usize,
    last: usize,
}

impl Observer for Lender {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.checkpoints += 1;
        if self.checkpoints > self.last {
            ControlFlow::Break(Interrupt::TimedOut)
        } else {
            ControlFlow::Continue(())
        }
    }

    fn cores(&self) -> Option<Arc<Cores>> {
        Some(Arc::clone(&self.cores))
    }
}

fn lent(cores: &Arc<Cores>, last: usize) -> (Result<Solution, SolveError>, usize) {
    let mut lender = Lender { cores: Arc::clone(cores), checkpoints: 0, last };
    (solver::run(&parse(&large()), &mut lender), lender.checkpoints)
}

#[test]
fn lent_cores_change_no_bit() {
    let cores = Cores::new(3);
    let _job = cores.occupy();
    let (solution, checkpoints) = lent(&cores, usize::MAX);
    let solution = solution.unwrap();
    assert_eq!(bits(&solution), bits(&solve(&large())));
    // Wherever it is stopped, it says why and ends. How often it asks depends on who waits for whom how long.
    let mut stops = 0;
    for last in [0, 1, 2, 4, 8].into_iter().chain((1..8).map(|k| checkpoints * k / 8)) {
        match lent(&cores, last) {
            (Err(error), _) => assert_eq!(error, SolveError::Interrupted(Interrupt::TimedOut)),
            (Ok(solution), asked) if asked > last => {
                assert_eq!(solution.steps[0].status, SolveStatus::TimedOut);
            }
            (Ok(whole), _) => {
                assert_eq!(bits(&whole), bits(&solution));
                continue;
            }
        }
        stops += 1;
    }
    assert!(stops >= 5);
    // Where other jobs have all the cores, it goes on alone.
    let others = [cores.occupy(), cores.occupy()];
    let full = lent(&cores, usize::MAX).0.unwrap();
    assert_eq!(bits(&full), bits(&solution));
    drop(others);
}
