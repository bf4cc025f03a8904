//! How the job is to be solved and what is to be reported.

use serde::Serialize;

use super::PositiveF64;

/// Mesh request.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MeshSettings {
    /// Elements over one contact half-width, `4..=MAX_ELEMENTS_PER_HALF_WIDTH`. Default 20.
    pub elements_per_half_width: u32,
}

impl MeshSettings {
    /// Fewest elements over a half-width that a job may ask for.
    pub const MIN_ELEMENTS_PER_HALF_WIDTH: u32 = 4;
    /// Most elements over a half-width that a job may ask for (about 2.5 million equations a body).
    pub const MAX_ELEMENTS_PER_HALF_WIDTH: u32 = 320;
}

impl Default for MeshSettings {
    fn default() -> Self {
        Self { elements_per_half_width: 20 }
    }
}

/// How the contact iteration and the plastic iteration alternate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Coupling {
    /// Strong coupling with Anderson acceleration.
    #[default]
    Accelerated,
    /// One initial-stress update for each contact solve (the paper's choice).
    Strong,
    /// Plasticity converged at fixed contact forces between contact solves, with Aitken relaxation.
    Weak,
    /// Stiffness reassembled with secant moduli and factorized again every iteration (the paper's rival).
    SecantStiffness,
}

/// Which method solves the contact problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ContactMethod {
    /// Warm-started primal-dual active set.
    #[default]
    ActiveSet,
    /// Restricted-basis-entry simplex (the paper's).
    Simplex,
}

/// Iteration controls.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SolverSettings {
    /// Coupling of contact and plasticity.
    pub coupling: Coupling,
    /// Contact method.
    pub contact: ContactMethod,
    /// Relative tolerance on the displacement change and on the equilibrium residual. Default 1e-6.
    pub tolerance: PositiveF64,
    /// Iteration limit, at least 1. Default 500.
    pub max_iterations: u32,
}

/// What the result contains beside the contact itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct OutputSettings {
    /// Stresses over depth under the peak pressure. Default true.
    pub subsurface: bool,
    /// Mesh and nodal fields. Default false.
    pub fields: bool,
}

impl Default for OutputSettings {
    fn default() -> Self {
        Self { subsurface: true, fields: false }
    }
}
