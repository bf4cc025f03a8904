//! Loads one after the other, by the theory that is asked for.

use std::sync::Arc;

use super::history::MeshedHistory;
use super::load_stepper::{LoadStepper, auxiliary};
use crate::engine::body_system::factor_cache::FactorCache;
use crate::engine::error::MeshedError;
use crate::engine::meshed_contact::Asked;
use crate::engine::problem::Problem;
use crate::engine::solution::SectionField;
use brinell_contact::{ActiveSetSolver, ContactLoad, ContactSolver};
use brinell_method::history;
use brinell_method::loads::{Stretch, each_from_rest, each_load};
use brinell_method::observer::Interrupt;
use brinell_method::run::Run;
use brinell_method::settings::Settings;
use brinell_method::steps::StepReceiver;

/// Elements over the half-width under the first load of a history, at least: from so many on a mesh
/// is not called coarse. Where fewer are asked for, the contact may still grow by `LEAST_GROWTH`.
const FEWEST_OF_FIRST: f64 = 10.0;
const LEAST_GROWTH: f64 = 1.25;

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

impl<'a> LoadSequence<'a> {
    /// Solves loads one after the other and hands over each step as soon as it is finished.
    ///
    /// Where the observer stops it, the steps that are done are kept, and the interrupt says why
    /// the others are missing; before the first of them is done it is an error.
    pub fn solve(
        &self,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        receiver: &mut dyn StepReceiver<SectionField>,
    ) -> Result<Option<Interrupt>, MeshedError> {
        match self.with_memory {
            Some(problem) => self.history(problem, Stretch::whole(loads), run, receiver),
            None => self.independent(loads, run, receiver),
        }
    }

    /// Solves loads that are each applied to bodies at rest, as [`Self::solve`].
    pub fn solve_each(
        &self,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        receiver: &mut dyn StepReceiver<SectionField>,
    ) -> Result<Option<Interrupt>, MeshedError> {
        let Some(problem) = self.with_memory else {
            return self.independent(loads, run, receiver);
        };
        let stepper = self.stepper();
        let most = (f64::from(self.asked.elements) / FEWEST_OF_FIRST).max(LEAST_GROWTH);
        let serves = |first, load| stepper.growth(first, load) <= most;
        each_from_rest(loads, receiver, run, serves, |stretch, run, receiver| {
            self.history(problem, stretch, run, receiver)
        })
    }

    /// The same on auxiliary meshes of other elements.
    pub fn auxiliary(&self, elements: u32) -> Self {
        let Settings { theory, increments, .. } = self.asked.solver;
        let asked = Asked { elements, solver: Settings { theory, increments, ..auxiliary() } };
        Self { asked, contact: &ActiveSetSolver, ..*self }
    }

    fn stepper(&self) -> LoadStepper<'a> {
        LoadStepper::new(self.problem, self.asked, self.contact, self.cache)
    }

    fn independent(
        &self,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        receiver: &mut dyn StepReceiver<SectionField>,
    ) -> Result<Option<Interrupt>, MeshedError> {
        let mut stepper = self.stepper();
        each_load(loads, receiver, run, |load, next, run| stepper.step(load, next, run))
    }

    fn history(
        &self,
        problem: &Problem,
        stretch: Stretch<'_>,
        run: &mut Run<'_>,
        receiver: &mut dyn StepReceiver<SectionField>,
    ) -> Result<Option<Interrupt>, MeshedError> {
        let (asked, contact, loads) = (self.asked, self.contact, stretch.loads);
        let stepper = self.stepper();
        let bodies = MeshedHistory { problem, sizing: &stepper, asked, contact, loads };
        let coarse = bodies.coarse(run)?;
        history::run(coarse, stretch, asked.solver.increments, run, receiver)
    }
}
