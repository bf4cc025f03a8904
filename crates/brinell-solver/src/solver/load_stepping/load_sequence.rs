//! Loads one after the other, by the theory of the job.

use std::sync::Arc;

use super::history::MeshedHistory;
use super::load_stepper::LoadStepper;
use crate::contact::{ContactLoad, ContactSolver};
use crate::job::Job;
use crate::solver::body_system::factor_cache::FactorCache;
use crate::solver::method::history;
use crate::solver::method::loads::each_load;
use crate::solver::method::run::Run;
use crate::solver::method::steps::StepReceiver;
use crate::solver::problem::Problem;
use crate::solver::solution::SectionField;
use crate::solver::{Interrupt, SolveError};

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
    /// Whether deformation theory is compared with flow theory.
    pub tells_bias: bool,
}

impl LoadSequence<'_> {
    /// Solves loads in order and hands over each step as soon as it is finished.
    ///
    /// Where the observer stops it, the steps that are done are kept, and the interrupt says why
    /// the others are missing; before the first of them is done it is an error.
    pub fn solve(
        &self,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        receiver: &mut dyn StepReceiver<SectionField>,
    ) -> Result<Option<Interrupt>, SolveError> {
        let mut stepper = LoadStepper::new(self.problem, self.job, self.contact, self.cache)
            .telling_bias(self.tells_bias);
        if let Some(problem) = self.with_memory {
            let (job, contact) = (self.job, self.contact);
            let bodies = MeshedHistory { problem, sizing: &stepper, job, contact, loads };
            let coarse = bodies.coarse(run)?;
            return history::run(coarse, loads, job.solver.increments, run, receiver);
        }
        each_load(loads, receiver, run, |load, next, run| stepper.step(load, next, run))
    }
}
