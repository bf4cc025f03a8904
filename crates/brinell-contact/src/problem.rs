//! What goes into a contact solve and what comes out.

use super::{ContactError, Flexibility, KktReport};

/// What is prescribed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactLoad {
    /// Resultant of the contact forces P >= 0 \[N\]; the approach is an output.
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

/// The contact of n candidate cells under one load.
#[derive(Clone, Copy)]
pub struct ContactProblem<'a> {
    /// F \[mm/N\].
    pub flexibility: &'a dyn Flexibility,
    /// Initial gap `g = δ0 + u_p` \[mm\]; plastic flow may make entries negative.
    pub initial_gap: &'a [f64],
    /// What is prescribed.
    pub load: ContactLoad,
}

/// How a solve ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactStatus {
    /// The independent check finds every condition within the tolerance.
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
    /// Contact force R of each cell \[N\], compressive, >= 0.
    pub force: Vec<f64>,
    /// Gap `δ = g + F R - α` of each cell after loading \[mm\], as the forces above make it.
    pub gap: Vec<f64>,
    /// Approach α \[mm\]; under no force the gap at which the bodies just touch.
    pub approach: f64,
    /// `P = Σ R` \[N\].
    pub total_force: f64,
    /// How the solve ended.
    pub status: ContactStatus,
    /// The independent check of forces and approach.
    pub kkt: KktReport,
    /// Applications of the flexibility, those of the check included.
    pub applications: usize,
    /// Active sets that were tried.
    pub active_sets: usize,
}

impl ContactProblem<'_> {
    /// Number of candidate cells.
    pub const fn n_cells(&self) -> usize {
        self.initial_gap.len()
    }

    /// Refuses data that are no contact problem.
    pub(crate) fn validate(&self) -> Result<(), ContactError> {
        let (expected, found) = (self.flexibility.len(), self.initial_gap.len());
        if expected != found {
            return Err(ContactError::DimensionMismatch { expected, found });
        }
        if found == 0 {
            return Err(ContactError::NoCells);
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
        match self.load {
            ContactLoad::Force(force) if force < 0.0 => Err(ContactError::NegativeForce(force)),
            _ => Ok(()),
        }
    }

    /// The approach under which no force acts, if the load asks for none: the prescribed one, or the one at which
    /// the first cell touches.
    pub(crate) fn approach_without_force(&self) -> Option<f64> {
        let first = self.initial_gap.iter().copied().fold(f64::INFINITY, f64::min);
        match self.load {
            ContactLoad::Force(force) => (force <= 0.0).then_some(first),
            ContactLoad::Approach(approach) => (approach <= first).then_some(approach),
        }
    }
}

impl ContactSolution {
    /// Takes over forces and approach, and has them checked.
    pub(crate) fn finish(&mut self, problem: &ContactProblem<'_>, approach: f64) {
        self.approach = approach;
        self.total_force = self.force.iter().sum();
        self.gap.resize(problem.n_cells(), 0.0);
        self.kkt = super::kkt::check(problem, &self.force, approach, &mut self.gap);
        self.applications += 1;
    }

    /// The answer where no force acts.
    pub(crate) fn without_force(&mut self, problem: &ContactProblem<'_>, approach: f64) {
        self.force.clear();
        self.force.resize(problem.n_cells(), 0.0);
        self.finish(problem, approach);
        self.status = ContactStatus::Converged;
    }
}
