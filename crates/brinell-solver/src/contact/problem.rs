//! What goes into a contact solve and what comes out.

use super::{ActiveSet, ContactError};
use sparse_cholesky::dense::SymmetricMatrix;

/// What is prescribed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactLoad {
    /// Sum of the contact forces P >= 0 \[N\]; the approach is an output.
    Force(f64),
    /// Approach α of the supports \[mm\]; the force is an output, and may be zero.
    Approach(f64),
}

impl ContactLoad {
    /// The figure that is prescribed.
    pub const fn magnitude(self) -> f64 {
        match self {
            Self::Force(value) | Self::Approach(value) => value,
        }
    }
}

/// The contact of n candidate pairs under one load.
#[derive(Debug, Clone, Copy)]
pub struct ContactProblem<'a> {
    /// F \[mm/N\], symmetric positive definite: both bodies' normal displacements under unit pair forces.
    pub flexibility: &'a SymmetricMatrix,
    /// Equivalent initial gap `g = δ0 + u_p` \[mm\]; plastic flow may make entries negative.
    pub initial_gap: &'a [f64],
    /// What is prescribed.
    pub load: ContactLoad,
}

/// The answer to a [`ContactProblem`].
#[derive(Debug, Clone, PartialEq)]
pub struct ContactSolution {
    /// Contact force R of each pair \[N\], compressive, >= 0.
    pub force: Vec<f64>,
    /// Gap δ of each pair after loading \[mm\], >= 0; exactly 0 on the active set.
    pub gap: Vec<f64>,
    /// Approach α of the supports \[mm\].
    pub approach: f64,
    /// The pairs in contact, exactly those with R > 0.
    pub active_set: ActiveSet,
    /// Simplex pivots, or linear systems solved by the active set (plus the pivots of its fallback).
    pub pivots: usize,
}

impl ContactSolution {
    /// Sum of the contact forces P \[N\].
    pub fn total_force(&self) -> f64 {
        self.force.iter().sum()
    }
}

impl ContactProblem<'_> {
    /// Number of candidate pairs.
    pub const fn n_pairs(&self) -> usize {
        self.initial_gap.len()
    }

    /// The smallest equivalent initial gap.
    pub(super) fn smallest_gap(&self) -> f64 {
        self.initial_gap.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Refuses data that are no contact problem.
    pub(super) fn validate(&self) -> Result<(), ContactError> {
        let (expected, found) = (self.flexibility.len(), self.initial_gap.len());
        if expected != found {
            return Err(ContactError::DimensionMismatch { expected, found });
        }
        if found == 0 {
            return Err(ContactError::NoPairs);
        }
        let (value, name) = match self.load {
            ContactLoad::Force(force) => (force, "force"),
            ContactLoad::Approach(approach) => (approach, "approach"),
        };
        if !value.is_finite() {
            return Err(ContactError::NotFinite(name));
        }
        if !self.initial_gap.iter().all(|gap| gap.is_finite()) {
            return Err(ContactError::NotFinite("initial gap"));
        }
        if !self.flexibility.as_slice().iter().all(|entry| entry.is_finite()) {
            return Err(ContactError::NotFinite("flexibility"));
        }
        match self.load {
            ContactLoad::Force(force) if force < 0.0 => Err(ContactError::NegativeForce(force)),
            _ => Ok(()),
        }
    }

    /// The answer without contact forces, if the load asks for none: the bodies at the prescribed approach, or
    /// just touching under `P = 0`.
    pub(super) fn without_force(&self) -> Option<ContactSolution> {
        let smallest = self.smallest_gap();
        let approach = match self.load {
            ContactLoad::Force(force) => (force <= 0.0).then_some(smallest)?,
            ContactLoad::Approach(approach) => (approach <= smallest).then_some(approach)?,
        };
        Some(ContactSolution {
            force: vec![0.0; self.n_pairs()],
            gap: self.initial_gap.iter().map(|gap| gap - approach).collect(),
            approach,
            active_set: ActiveSet::default(),
            pivots: 0,
        })
    }
}
