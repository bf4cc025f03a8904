//! Settings of a solve.

use std::fmt;

use strum::{IntoStaticStr, VariantArray};

use brinell_contact::{ActiveSetSolver, ContactSolver};

use crate::couplings::{Accelerated, Coupling};
use crate::increments::Increments;

/// The theory of plasticity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub enum Theory {
    /// Stress follows the history of strain (Prandtl and Reuss).
    #[default]
    Flow,
    /// Stress is a function of the total strain (Hencky): the paper's theory, for rising loads.
    Deformation,
}

/// Theory, methods and limits of a solve.
#[derive(Clone, Copy)]
pub struct Settings {
    /// Theory of plasticity.
    pub theory: Theory,
    /// Increments of the loads of a history.
    pub increments: Increments,
    /// The alternation of contact and plasticity.
    pub coupling: &'static (dyn Coupling + Sync),
    /// The solver of the contact conditions, for bodies that have a choice.
    pub contact: &'static (dyn ContactSolver + Sync),
    /// Relative tolerance on the displacement change and on the out-of-balance force.
    pub tolerance: f64,
    /// Iteration limit.
    pub max_iterations: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            theory: Theory::default(),
            increments: Increments::default(),
            coupling: &Accelerated,
            contact: &ActiveSetSolver,
            tolerance: 1e-6,
            max_iterations: 500,
        }
    }
}

impl fmt::Debug for Settings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Settings")
            .field("theory", &self.theory)
            .field("increments", &self.increments)
            .field("tolerance", &self.tolerance)
            .field("max_iterations", &self.max_iterations)
            .finish_non_exhaustive()
    }
}
