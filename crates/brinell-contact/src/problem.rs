//! The input and output of a contact solve.

use super::entries::Entries;
use super::{ActiveSet, ContactError, Flexibility};

/// The prescribed load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactLoad {
    /// Resultant of the contact forces P >= 0 \[N\]; the approach is an output.
    Force(f64),
    /// Approach α of the supports \[mm\]; the force is an output, and may be zero.
    Approach(f64),
}

impl ContactLoad {
    /// Returns the prescribed force or approach.
    pub const fn magnitude(self) -> f64 {
        match self {
            Self::Force(value) | Self::Approach(value) => value,
        }
    }
}

/// The contact of n candidate pairs under one load.
#[derive(Clone, Copy)]
pub struct ContactProblem<'a> {
    /// F \[mm/N\], symmetric positive definite: both bodies' displacements along the normals under
    /// unit pair forces.
    pub flexibility: &'a dyn Flexibility,
    /// Equivalent initial gap `g = δ0 + u_p` along the pair's normal \[mm\]; plastic flow may make
    /// entries negative.
    pub initial_gap: &'a [f64],
    /// e: the closing of each gap by an approach of 1, the cosine of the angle between the pair's
    /// normal and the direction of the approach, in `(0, 1]`.
    pub closing: &'a [f64],
    /// The prescribed load.
    pub load: ContactLoad,
}

/// How a solve ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactStatus {
    /// Every condition holds within the tolerance of the solver.
    Converged,
    /// The iterations ran out. The forces are the last ones.
    #[default]
    IterationLimit,
    /// The hook asked to stop. The forces are the last ones.
    Stopped,
}

/// The answer to a [`ContactProblem`].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ContactSolution {
    /// Contact force R of each pair \[N\], compressive, >= 0.
    pub force: Vec<f64>,
    /// Gap δ of each pair after loading \[mm\]. Direct solvers give gaps >= 0, exactly 0 on the
    /// active set; conjugate gradients give the gaps of their forces.
    pub gap: Vec<f64>,
    /// Approach α of the supports \[mm\].
    pub approach: f64,
    /// Tilt of the gap for which it was solved, where a caller seeks one; solvers leave it 0.
    pub tilt: f64,
    /// `P = eᵀR` \[N\].
    pub total_force: f64,
    /// The pairs in contact, exactly those with R > 0.
    pub active_set: ActiveSet,
    /// How the solve ended.
    pub status: ContactStatus,
    /// Changes of the active set: pivots of the simplex, or active sets tried.
    pub pivots: usize,
    /// Applications of the flexibility, including the check; 0 for direct solvers.
    pub applications: usize,
}

impl ContactProblem<'_> {
    /// Number of candidate pairs.
    pub const fn n_pairs(&self) -> usize {
        self.initial_gap.len()
    }

    /// The approach at which the first pair touches.
    pub(crate) fn first_touch(&self) -> f64 {
        (0..self.n_pairs()).map(|k| self.touch(k)).fold(f64::INFINITY, f64::min)
    }

    /// The approach at which a pair touches while no force acts.
    pub(crate) fn touch(&self, k: usize) -> f64 {
        self.initial_gap[k] / self.closing[k]
    }

    /// `g_k - α e_k`: the gap of a pair at an approach while no force acts.
    pub(crate) fn gap_at(&self, k: usize, approach: f64) -> f64 {
        self.initial_gap[k] - approach * self.closing[k]
    }

    /// `eᵀR`.
    pub(crate) fn total(&self, force: &[f64]) -> f64 {
        self.closing.iter().zip(force).map(|(closing, force)| closing * force).sum()
    }

    /// The entries of the flexibility.
    pub(crate) fn entries(&self) -> Result<Entries<'_>, ContactError> {
        Entries::of(self.flexibility).ok_or(ContactError::NoEntries)
    }

    /// Checks that the data form a contact problem.
    pub(crate) fn validate(&self) -> Result<(), ContactError> {
        let (expected, found) = (self.flexibility.len(), self.initial_gap.len());
        if expected != found {
            return Err(ContactError::DimensionMismatch { expected, found });
        }
        if found == 0 {
            return Err(ContactError::NoPairs);
        }
        if self.closing.len() != found {
            return Err(ContactError::DimensionMismatch { expected, found: self.closing.len() });
        }
        if !self.closing.iter().all(|closing| *closing > 0.0 && *closing <= 1.0) {
            return Err(ContactError::NotClosing);
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
        let entries = self.flexibility.dense().unwrap_or_default();
        if !entries.iter().all(|entry| entry.is_finite()) {
            return Err(ContactError::NotFinite("flexibility"));
        }
        match self.load {
            ContactLoad::Force(force) if force < 0.0 => Err(ContactError::NegativeForce(force)),
            _ => Ok(()),
        }
    }

    /// Returns the answer without contact forces, if the load needs none: the bodies at the
    /// prescribed approach, or just touching under `P = 0`.
    pub(crate) fn without_force(&self) -> Option<ContactSolution> {
        let first = self.first_touch();
        let approach = match self.load {
            ContactLoad::Force(force) => (force <= 0.0).then_some(first)?,
            ContactLoad::Approach(approach) => (approach <= first).then_some(approach)?,
        };
        Some(ContactSolution {
            force: vec![0.0; self.n_pairs()],
            gap: (0..self.n_pairs()).map(|k| self.gap_at(k, approach)).collect(),
            approach,
            status: ContactStatus::Converged,
            ..ContactSolution::default()
        })
    }
}
