//! The one loop: systems until one serves, on each of them loads, under each load contact and
//! plasticity in alternation.

use super::contact_system::{BlockVector, ContactSystem};
use super::couplings::iteration::{Controls, InitialState, Outcome};
use super::couplings::{self, Coupling};
use super::observer::IterationRecord;
use super::run::Run;
use super::steps::{BodyFigures, CoarseFigures};
use crate::{Error, Interrupted};
use brinell_contact::ContactLoad;

/// Bodies that become a [`ContactSystem`] once it is said how finely and how far around the
/// contact.
pub trait Engine {
    /// The bodies in contact.
    type System: ContactSystem;
    /// How finely, and how far.
    type Design;
    /// What the engine says of an outcome.
    type Answer: Answer<System = Self::System>;
    /// Its errors, and those of the alternation.
    type Error: From<Error> + Interrupted;

    /// Makes a system. Returns it with displacements to start from, if any are known.
    ///
    /// A design that cannot be built may be changed to one that can.
    ///
    /// # Errors
    /// Those of a design that cannot be built, or of a factorization.
    fn build(
        &self,
        design: &mut Self::Design,
        run: &mut Run<'_>,
    ) -> Result<(Self::System, Option<BlockVector>), Self::Error>;

    /// Prepares a system that another load has left for the loads to come.
    ///
    /// # Errors
    /// Those of a factorization.
    fn resume(
        &self,
        design: &Self::Design,
        system: Self::System,
        run: &mut Run<'_>,
    ) -> Result<(Self::System, Option<BlockVector>), Self::Error>;

    /// What becomes of an outcome under a load, after so many rounds of this load on this system.
    /// An outcome that was stopped is accepted.
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
    ) -> Result<VerdictOf<Self>, Self::Error>;
}

/// A load, and how often it has been continued on the same system.
#[derive(Debug, Clone, Copy)]
pub struct Round {
    /// The load.
    pub load: ContactLoad,
    /// How often it has been continued.
    pub number: usize,
}

/// An outcome on a system with all that the engine says of it.
pub trait Answer {
    /// The bodies in contact.
    type System: ContactSystem;

    /// The bodies.
    fn system(&self) -> &Self::System;

    /// How the iteration ended.
    fn outcome(&self) -> &Outcome;

    /// The same, to be changed.
    fn outcome_mut(&mut self) -> &mut Outcome;

    /// Both by themselves.
    fn into_parts(self) -> (Self::System, Outcome);

    /// Headline figures, those of no contact where nothing touches.
    fn figures(&self) -> CoarseFigures;

    /// Figures of both bodies; by default none.
    fn body_figures(&self) -> [BodyFigures; 2] {
        Default::default()
    }

    /// Whether strains have outgrown the theory of small strains.
    fn has_collapsed(&self) -> bool;
}

/// What becomes of an outcome.
pub enum Verdict<S, D, A> {
    /// It is the answer.
    Accept(A),
    /// Plastic flow has been found where it was not looked for: from here on it is.
    Continue {
        /// The same bodies.
        system: S,
        /// Displacements to start from.
        start: Option<BlockVector>,
        /// Records so far.
        history: Vec<IterationRecord>,
    },
    /// The contact does not fit: all loads again, by another design.
    Again(D),
}

/// As an engine gives it.
pub type VerdictOf<E> =
    Verdict<<E as Engine>::System, <E as Engine>::Design, <E as Engine>::Answer>;

/// Why loads are left before their end.
pub enum Leave<D, E> {
    /// The contact does not fit: all loads again, by another design.
    Again(Box<D>),
    /// There is no answer.
    Failed(E),
}

impl<D, E: From<Error>> From<Error> for Leave<D, E> {
    fn from(error: Error) -> Self {
        Self::Failed(error.into())
    }
}

/// As an engine leaves them.
pub type LeaveOf<E> = Leave<<E as Engine>::Design, <E as Engine>::Error>;

/// Solves loads, on one system after another until one serves for all of them.
///
/// `known` is a system that loads before these have left. `loads` is called anew for every system,
/// with displacements to start from.
///
/// # Errors
/// Those of the engine, of a contact solve and of `loads`.
pub fn solve<E: Engine, T>(
    engine: &E,
    mut design: E::Design,
    mut known: Option<E::System>,
    run: &mut Run<'_>,
    mut loads: impl FnMut(
        &OnSystem<'_, E>,
        E::System,
        Option<BlockVector>,
        &mut Run<'_>,
    ) -> Result<T, LeaveOf<E>>,
) -> Result<T, E::Error> {
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
pub struct OnSystem<'a, E: Engine> {
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
    ) -> Result<E::Answer, LeaveOf<E>> {
        let mut initial = InitialState { displacement: start, ..InitialState::default() };
        let mut under = Round { load: controls.load, number: 0 };
        loop {
            let outcome = couplings::iterate(&mut system, coupling, controls, initial, run)?;
            let verdict = self
                .engine
                .verdict(self.design, system, outcome, under, run)
                .map_err(Leave::Failed)?;
            match verdict {
                Verdict::Accept(answer) => return Ok(answer),
                Verdict::Continue { system: same, start, history } => {
                    system = same;
                    initial =
                        InitialState { displacement: start, history, ..InitialState::default() };
                    under.number += 1;
                }
                Verdict::Again(design) => return Err(Leave::Again(Box::new(design))),
            }
        }
    }
}
