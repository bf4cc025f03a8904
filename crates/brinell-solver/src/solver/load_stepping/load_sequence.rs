//! Loads one after the other, by the theory of the job.

use std::sync::Arc;

use super::history::{self, HistoryRequest};
use super::load_stepper::LoadStepper;
use super::steps::StepReceiver;
use crate::contact::{ContactLoad, ContactSolver};
use crate::job::Job;
use crate::solver::body_system::factor_cache::FactorCache;
use crate::solver::problem::Problem;
use crate::solver::solution::Solution;
use crate::solver::{Observer, SolveError};

/// The bodies, and how loads on them are solved.
#[derive(Clone, Copy)]
pub(super) struct LoadSequence<'a> {
    /// The bodies under deformation theory, by which meshes are sized.
    pub problem: &'a Problem,
    /// The same bodies with models that have a memory, if the loads are to be a history.
    pub with_memory: Option<&'a Problem>,
    pub job: &'a Job,
    pub contact: &'a dyn ContactSolver,
    pub cache: Option<&'a Arc<FactorCache>>,
}

impl LoadSequence<'_> {
    /// Solves loads in order and hands over each step as soon as it is finished.
    ///
    /// Where the observer stops it, the steps that are done are kept and the solution says so; before the first of them is done it
    /// is an error.
    pub fn solve(
        &self,
        loads: &[ContactLoad],
        solution: &mut Solution,
        observer: &mut dyn Observer,
        receiver: &mut dyn StepReceiver,
    ) -> Result<(), SolveError> {
        let mut stepper = LoadStepper::new(self.problem, self.job, self.contact, self.cache);
        if let Some(problem) = self.with_memory {
            let (job, contact, increments) = (self.job, self.contact, self.job.solver.increments);
            let request = HistoryRequest { problem, sizing: &stepper, job, contact, loads, increments };
            return history::run(request, solution, observer, receiver);
        }
        for (k, &load) in loads.iter().enumerate() {
            match stepper.step(load, loads.get(k + 1).copied(), solution, observer) {
                Ok(step) => {
                    let status = step.status;
                    receiver.step(step, observer);
                    if status.is_stopped() {
                        break;
                    }
                }
                // The steps that are done are worth keeping.
                Err(SolveError::Interrupted(interrupt)) if k > 0 => {
                    solution.interrupted = Some(interrupt);
                    break;
                }
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}
