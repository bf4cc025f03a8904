//! How the job is to be solved and what is to be reported.

use std::ops::RangeInclusive;

use serde::Serialize;

use super::reader::Cursor;
use super::{Named, PositiveF64};

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

    pub(super) fn read(cursor: Cursor<'_>) -> Option<Self> {
        let object = cursor.object()?;
        object.only(&["elements_per_half_width"]);
        let range = Self::MIN_ELEMENTS_PER_HALF_WIDTH..=Self::MAX_ELEMENTS_PER_HALF_WIDTH;
        let default = Self::default().elements_per_half_width;
        let elements = object.or("elements_per_half_width", default, |c| c.integer(&range));
        Some(Self { elements_per_half_width: elements? })
    }
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
    /// Strong coupling on the tangent stiffness of a coarser mesh's answer, with Anderson acceleration.
    #[default]
    Accelerated,
    /// One initial-stress update for each contact solve (the paper's choice).
    Strong,
    /// Plasticity converged at fixed contact forces between contact solves, with Aitken relaxation.
    Weak,
    /// Stiffness reassembled with secant moduli and factorized again every iteration (the paper's rival).
    SecantStiffness,
}

impl Named for Coupling {
    const ALL: &'static [Self] = &[Self::Accelerated, Self::Strong, Self::Weak, Self::SecantStiffness];

    fn name(self) -> &'static str {
        match self {
            Self::Accelerated => "accelerated",
            Self::Strong => "strong",
            Self::Weak => "weak",
            Self::SecantStiffness => "secant_stiffness",
        }
    }
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

impl Named for ContactMethod {
    const ALL: &'static [Self] = &[Self::ActiveSet, Self::Simplex];

    fn name(self) -> &'static str {
        match self {
            Self::ActiveSet => "active_set",
            Self::Simplex => "simplex",
        }
    }
}

/// Iteration controls.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SolverSettings {
    /// Coupling of contact and plasticity.
    pub coupling: Coupling,
    /// Contact method.
    pub contact: ContactMethod,
    /// Relative tolerance on the displacement change and on the equilibrium residual, in
    /// [`TOLERANCES`](Self::TOLERANCES). Default 1e-6.
    pub tolerance: PositiveF64,
    /// Iteration limit, in [`ITERATION_LIMITS`](Self::ITERATION_LIMITS). Default 500.
    pub max_iterations: u32,
}

impl SolverSettings {
    /// Tolerances that a job may ask for.
    pub const TOLERANCES: RangeInclusive<f64> = 1e-12..=1e-1;
    /// Iteration limits that a job may ask for.
    pub const ITERATION_LIMITS: RangeInclusive<u32> = 1..=100_000;

    pub(super) fn read(cursor: Cursor<'_>) -> Option<Self> {
        let object = cursor.object()?;
        object.only(&["coupling", "contact", "tolerance", "max_iterations"]);
        let default = Self::default();
        let coupling = object.or("coupling", default.coupling, |c| c.named());
        let contact = object.or("contact", default.contact, |c| c.named());
        let tolerance = object.or("tolerance", default.tolerance, |c| c.number_in(&Self::TOLERANCES));
        let max_iterations =
            object.or("max_iterations", default.max_iterations, |c| c.integer(&Self::ITERATION_LIMITS));
        Some(Self {
            coupling: coupling?,
            contact: contact?,
            tolerance: tolerance?,
            max_iterations: max_iterations?,
        })
    }
}

impl Default for SolverSettings {
    fn default() -> Self {
        Self {
            coupling: Coupling::default(),
            contact: ContactMethod::default(),
            tolerance: PositiveF64::MICRO,
            max_iterations: 500,
        }
    }
}

/// What the result contains beside the contact itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct OutputSettings {
    /// Stresses over depth under the peak pressure. Default true.
    pub subsurface: bool,
    /// Mesh and nodal fields. Default false.
    pub fields: bool,
}

impl OutputSettings {
    pub(super) fn read(cursor: Cursor<'_>) -> Option<Self> {
        let object = cursor.object()?;
        object.only(&["subsurface", "fields"]);
        let default = Self::default();
        let subsurface = object.or("subsurface", default.subsurface, |c| c.boolean());
        let fields = object.or("fields", default.fields, |c| c.boolean());
        Some(Self { subsurface: subsurface?, fields: fields? })
    }
}

impl Default for OutputSettings {
    fn default() -> Self {
        Self { subsurface: true, fields: false }
    }
}
