//! The outer loop. It builds systems until one fits the contact, solves the loads on each of them,
//! and alternates contact and plasticity under each load.

use super::contact_system::{BlockVector, ContactSystem};
use super::couplings::iteration::{Controls, InitialState, Outcome};
use super::couplings::{self, Coupling};
use super::observer::{IncrementNumber, IterationRecord};
use super::run::Run;
use crate::{Error, Interrupted};
use brinell_contact::ContactLoad;

/// Builds a [`ContactSystem`] of two bodies from a design and judges the outcomes on it.
pub trait Engine {
    /// The two bodies and their contact.
    type System: ContactSystem;
    /// The resolution of the system and its extent around the contact.
    type Design;
    /// An outcome on its system, with what the engine derives from both.
    type Answer;
    /// The errors of the engine and of the alternation.
    type Error: From<Error> + Interrupted;

    /// Builds a system. Returns it with initial displacements for the iteration, if any are known.
    ///
    /// The engine may change a design that it cannot build.
    ///
    /// # Errors
    /// A design that cannot be built, or a factorization that fails.
    fn build(
        &self,
        design: &mut Self::Design,
        run: &mut Run<'_>,
    ) -> Result<(Self::System, Option<BlockVector>), Self::Error>;

    /// Prepares the system of the loads before for the next loads; by default leaves it.
    ///
    /// # Errors
    /// Those of a factorization.
    fn resume(
        &self,
        _design: &Self::Design,
        system: Self::System,
        _run: &mut Run<'_>,
    ) -> Result<(Self::System, Option<BlockVector>), Self::Error> {
        Ok((system, None))
    }

    /// Judges an outcome: accepts it, continues it on the same system, or asks for another design.
    /// Accepts an outcome that the observer stopped.
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

/// A load and the number of its continuations on the same system.
#[derive(Debug, Clone, Copy)]
pub struct Round {
    /// The load.
    pub load: ContactLoad,
    /// Number of continuations, zero at first.
    pub number: usize,
    /// Whether it is an increment that does not end a load.
    pub is_on_way: bool,
}

/// The judgement of an engine on an outcome.
pub enum Verdict<S, D, A> {
    /// The outcome is the answer.
    Accept(A),
    /// Points outside the plastic region have yielded: the iteration continues on a larger region.
    Continue {
        /// The same system with the larger plastic region.
        system: S,
        /// Initial displacements of the continued iteration.
        start: Option<BlockVector>,
        /// Records of the iterations so far.
        history: Vec<IterationRecord>,
    },
    /// The contact does not fit on the system: all loads are solved again on this design.
    Again(D),
}

/// The verdict with the types of an engine.
pub type VerdictOf<E> =
    Verdict<<E as Engine>::System, <E as Engine>::Design, <E as Engine>::Answer>;

/// Why the loads on a system end early.
pub enum Leave<D, E> {
    /// The contact does not fit on the system: all loads are solved again on this design.
    Again(Box<D>),
    /// The solve has failed.
    Failed(E),
}

impl<D, E: From<Error>> From<Error> for Leave<D, E> {
    fn from(error: Error) -> Self {
        Self::Failed(error.into())
    }
}

/// The early end with the types of an engine.
pub type LeaveOf<E> = Leave<<E as Engine>::Design, <E as Engine>::Error>;

/// Solves loads on one system after another until all of them fit on one.
///
/// `known` is the system of the loads before, if there is one. `loads` runs once on every system
/// and receives the initial displacements.
///
/// # Errors
/// Errors of the engine, of a contact solve and of `loads`.
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
        let is_on_way = controls.increment.is_some_and(IncrementNumber::is_on_way);
        let mut under = Round { load: controls.load, number: 0, is_on_way };
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
