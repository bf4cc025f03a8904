//! The context of a running solve: its observer and the record of its time.

use std::ops::ControlFlow;

use crate::Error;
use crate::observer::{Held, Interrupt, IterationRecord, Observer, Retold, ask};
use crate::phases::{Phase, PhaseTimes};
use brinell_contact::{ContactError, ContactProblem, ContactSolution, ContactSolver};

/// A running solve.
pub struct Run<'a> {
    /// Time by phase.
    pub phases: &'a mut PhaseTimes,
    /// Systems built so far.
    pub passes: &'a mut usize,
    /// Follows the solve and may stop it.
    pub observer: &'a mut dyn Observer,
}

impl<'a> Run<'a> {
    /// Makes a run that books time and systems in these records.
    pub fn new(
        phases: &'a mut PhaseTimes,
        passes: &'a mut usize,
        observer: &'a mut dyn Observer,
    ) -> Self {
        Self { phases, passes, observer }
    }

    /// Lends the same run to a function that takes it by value.
    pub fn reborrow(&mut self) -> Run<'_> {
        Run { phases: &mut *self.phases, passes: &mut *self.passes, observer: &mut *self.observer }
    }

    /// Runs `work`, whose iterations are preliminary to the observer.
    pub fn preliminarily<T>(&mut self, work: impl FnOnce(&mut Run<'_>) -> T) -> T {
        let observer = &mut Retold::preliminary(self.observer, IterationRecord::clone);
        work(&mut Run { phases: self.phases, passes: self.passes, observer })
    }

    /// Runs `work` and books its time.
    pub fn time<T>(&mut self, phase: Phase, work: impl FnOnce() -> T) -> T {
        self.time_observed(phase, |_| work())
    }

    /// Solves the contact conditions. The observer can stop it.
    ///
    /// # Errors
    /// Those of the contact solver.
    pub fn solve_contact(
        &mut self,
        solver: &dyn ContactSolver,
        problem: &ContactProblem<'_>,
        start: Option<&ContactSolution>,
    ) -> Result<ContactSolution, ContactError> {
        self.time_observed(Phase::Contact, |observer| {
            let mut stop = || observer.on_checkpoint().map_break(|_| ());
            solver.solve(problem, start, &mut stop)
        })
    }

    /// Runs `work`, which asks the observer itself, and books its time.
    pub fn time_observed<T>(
        &mut self,
        phase: Phase,
        work: impl FnOnce(&mut dyn Observer) -> T,
    ) -> T {
        let start = self.observer.elapsed();
        let outcome = work(self.observer);
        self.phases.book(phase, self.observer.elapsed().saturating_sub(start));
        outcome
    }

    /// Asks the observer whether to stop, before there is an iteration to report.
    ///
    /// # Errors
    /// [`Error::Interrupted`].
    pub fn checkpoint(&mut self) -> Result<(), Error> {
        ask(self.observer).map_err(Error::Interrupted)
    }

    /// Tells the observer what a part of the solve is about to hold \[bytes\].
    ///
    /// # Errors
    /// [`Error::Interrupted`].
    pub fn hold(&mut self, part: Held, bytes: usize) -> Result<(), Error> {
        let told = self.observer.on_held(part, bytes);
        told.break_value().map_or(Ok(()), |interrupt| Err(Error::Interrupted(interrupt)))
    }

    /// Shows an iteration to the observer.
    pub fn show(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.observer.on_iteration(record)
    }
}
