//! The time of a job by kind of work. The observer has the clock.

use std::time::Duration;

/// A kind of work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Mesh generation.
    Mesh,
    /// Numbering by nested dissection.
    Ordering,
    /// Sparsity pattern and symbolic factorization.
    Symbolic,
    /// Stiffness assembly.
    Assembly,
    /// Numeric factorization.
    Numeric,
    /// Contact flexibility.
    Flexibility,
    /// Contact solves.
    Contact,
    /// Plastic law and initial-stress loads.
    Plasticity,
    /// Forward and back substitutions.
    Solves,
    /// Final fields.
    Output,
}

const PHASES: usize = Phase::Output as usize + 1;

/// Time spent on each kind of work.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct PhaseTimes {
    spent: [Duration; PHASES],
}

impl PhaseTimes {
    /// Books time spent on one kind of work.
    pub fn book(&mut self, phase: Phase, time: Duration) {
        self.spent[phase as usize] += time;
    }

    /// Time of one kind of work.
    pub fn spent(&self, phase: Phase) -> Duration {
        self.spent[phase as usize]
    }

    /// Adds the times of another record.
    pub fn add(&mut self, other: &Self) {
        for (mine, theirs) in self.spent.iter_mut().zip(&other.spent) {
            *mine += *theirs;
        }
    }
}
