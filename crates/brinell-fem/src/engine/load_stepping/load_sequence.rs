//! Loads one after the other, by the theory that is asked for.

use std::sync::Arc;

use super::history::MeshedHistory;
use super::load_stepper::LoadStepper;
use crate::engine::body_system::factor_cache::FactorCache;
use crate::engine::error::MeshedError;
use crate::engine::meshed_contact::Asked;
use crate::engine::problem::Problem;
use crate::engine::solution::SectionField;
use brinell_contact::{ContactLoad, ContactSolver};
use brinell_method::history;
use brinell_method::loads::each_load;
use brinell_method::observer::Interrupt;
use brinell_method::run::Run;
use brinell_method::steps::StepReceiver;

/// The bodies, and how loads on them are solved.
#[derive(Clone, Copy)]
pub(super) struct LoadSequence<'a> {
    /// The bodies under deformation theory, by which meshes are sized.
    pub problem: &'a Problem,
    /// The bodies with models that have a memory, if the loads are to be a history.
    pub with_memory: Option<&'a Problem>,
    pub asked: Asked,
    pub contact: &'a dyn ContactSolver,
    pub cache: Option<&'a Arc<FactorCache>>,
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
    ) -> Result<Option<Interrupt>, MeshedError> {
        let mut stepper = LoadStepper::new(self.problem, self.asked, self.contact, self.cache);
        if let Some(problem) = self.with_memory {
            let (asked, contact) = (self.asked, self.contact);
            let bodies = MeshedHistory { problem, sizing: &stepper, asked, contact, loads };
            let coarse = bodies.coarse(run)?;
            return history::run(coarse, loads, asked.solver.increments, run, receiver);
        }
        each_load(loads, receiver, run, |load, next, run| stepper.step(load, next, run))
    }
}
