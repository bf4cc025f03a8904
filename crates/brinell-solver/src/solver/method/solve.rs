//! The one loop: meshes until one serves, on each of them loads, under each load contact and plasticity in alternation.

use super::contact_system::{BlockVector, ContactSystem};
use super::couplings::iteration::{Controls, InitialState, Outcome};
use super::couplings::{self, Coupling};
use super::observer::IterationRecord;
use super::run::Run;
use super::steps::CoarseFigures;
use crate::contact::ContactLoad;
use crate::solver::SolveError;

/// Bodies that become a [`ContactSystem`] once it is said how finely and how far around the contact.
pub(crate) trait Engine {
    type System: ContactSystem;
    /// How finely, and how far.
    type Design;
    type Answer: Answer<System = Self::System>;

    /// Makes a system. Returns it with displacements to start from, if any are known.
    ///
    /// A design that cannot be built may be changed to one that can.
    ///
    /// # Errors
    /// Those of a mesh or a factorization.
    fn build(
        &self,
        design: &mut Self::Design,
        run: &mut Run<'_>,
    ) -> Result<(Self::System, Option<BlockVector>), SolveError>;

    /// Prepares a system that another load has left for the loads to come.
    ///
    /// # Errors
    /// Those of a factorization.
    fn resume(
        &self,
        design: &Self::Design,
        system: Self::System,
        run: &mut Run<'_>,
    ) -> Result<(Self::System, Option<BlockVector>), SolveError>;

    /// What becomes of an outcome under a load, after so many rounds of this load on this system. An outcome that was stopped
    /// is accepted.
    ///
    /// # Errors
    /// Those of a factorization.
    fn verdict(
        &self,
        design: &Self::Design,
        system: Self::System,
        outcome: Outcome,
        under: Round,
        run: &mut Run<'_>,
    ) -> Result<VerdictOf<Self>, SolveError>;
}

/// A load, and how often it has been continued on the same system.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Round {
    pub load: ContactLoad,
    pub number: usize,
}

/// An outcome on a system with all that the engine says of it.
pub(crate) trait Answer {
    type System: ContactSystem;

    fn system(&self) -> &Self::System;

    fn outcome(&self) -> &Outcome;

    fn outcome_mut(&mut self) -> &mut Outcome;

    fn into_parts(self) -> (Self::System, Outcome);

    /// Headline figures, those of no contact where nothing touches.
    fn figures(&self) -> CoarseFigures;

    /// Whether strains have outgrown the theory of small strains.
    fn has_collapsed(&self) -> bool;
}

/// What becomes of an outcome.
pub(crate) enum Verdict<S, D, A> {
    Accept(A),
    /// Plastic flow has been found where it was not looked for: from here on it is.
    Continue {
        system: S,
        start: Option<BlockVector>,
        history: Vec<IterationRecord>,
    },
    /// The contact does not fit: all loads again, by another design.
    Again(D),
}

pub(crate) type VerdictOf<E> = Verdict<<E as Engine>::System, <E as Engine>::Design, <E as Engine>::Answer>;

/// Why loads are left before their end.
pub(crate) enum Leave<D> {
    Again(Box<D>),
    Failed(SolveError),
}

impl<D> From<SolveError> for Leave<D> {
    fn from(error: SolveError) -> Self {
        Self::Failed(error)
    }
}

/// Solves loads, on one system after another until one serves for all of them.
///
/// `known` is a system that loads before these have left. `loads` is called anew for every system, with displacements to start
/// from.
///
/// # Errors
/// Those of the engine, of a contact solve and of `loads`.
pub(crate) fn solve<E: Engine, T>(
    engine: &E,
    mut design: E::Design,
    mut known: Option<E::System>,
    run: &mut Run<'_>,
    mut loads: impl FnMut(
        &OnSystem<'_, E>,
        E::System,
        Option<BlockVector>,
        &mut Run<'_>,
    ) -> Result<T, Leave<E::Design>>,
) -> Result<T, SolveError> {
    loop {
        let (system, start) = if let Some(system) = known.take() {
            engine.resume(&design, system, run)?
        } else {
            let built = engine.build(&mut design, run)?;
            *run.passes += 1;
            built
        };
        match loads(&OnSystem { engine, design: &design }, system, start, run) {
            Ok(answer) => return Ok(answer),
            Err(Leave::Again(next)) => design = *next,
            Err(Leave::Failed(error)) => return Err(error),
        }
    }
}

/// Solves single loads on a system.
pub(crate) struct OnSystem<'a, E: Engine> {
    engine: &'a E,
    design: &'a E::Design,
}

impl<E: Engine> OnSystem<'_, E> {
    /// Alternates contact and plasticity under one load until the engine accepts the outcome.
    ///
    /// # Errors
    /// [`Leave::Again`] where the contact does not fit on the system.
    pub fn solve(
        &self,
        mut system: E::System,
        start: Option<BlockVector>,
        coupling: &dyn Coupling,
        controls: Controls<'_>,
        run: &mut Run<'_>,
    ) -> Result<E::Answer, Leave<E::Design>> {
        let mut initial = InitialState { displacement: start, ..InitialState::default() };
        let mut under = Round { load: controls.load, number: 0 };
        loop {
            let outcome = couplings::iterate(&mut system, coupling, controls, initial, run)?;
            match self.engine.verdict(self.design, system, outcome, under, run)? {
                Verdict::Accept(answer) => return Ok(answer),
                Verdict::Continue { system: same, start, history } => {
                    system = same;
                    initial = InitialState { displacement: start, history, ..InitialState::default() };
                    under.number += 1;
                }
                Verdict::Again(design) => return Err(Leave::Again(Box::new(design))),
            }
        }
    }
}
