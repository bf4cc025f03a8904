//! How the job is to be solved and what is to be reported.

use serde::Serialize;

use super::fields::{Field, record};
use super::{Analysis, Named, PositiveF64};

record! {
    /// The mesh.
    #[derive(Copy)]
    pub struct MeshSettings("", "Mesh") {
        /// Elements over one contact half-width; in three dimensions cells over each semi-axis, 10
        /// of them if it is left out.
        pub elements_per_half_width: u32 = Field::whole(
            MeshSettings::MIN_ELEMENTS_PER_HALF_WIDTH..=MeshSettings::MAX_ELEMENTS_PER_HALF_WIDTH,
        )
        .label("Elements per half-width", ""),
    }
}

impl MeshSettings {
    /// Fewest elements over a half-width that a job may ask for.
    pub const MIN_ELEMENTS_PER_HALF_WIDTH: u32 = 4;
    /// Most elements over a half-width that a job may ask for (about 2.5 million equations a
    /// body).
    pub const MAX_ELEMENTS_PER_HALF_WIDTH: u32 = 320;
    /// Most cells over a semi-axis in three dimensions.
    pub const MAX_CELLS_PER_SEMI_AXIS: u32 = 60;

    /// What a job of an analysis has that says nothing of its mesh.
    pub fn of(analysis: Analysis) -> Self {
        match analysis {
            Analysis::ThreeDimensional => Self { elements_per_half_width: 10 },
            Analysis::PlaneStrain | Analysis::PlaneStress | Analysis::Axisymmetric => {
                Self::default()
            }
        }
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
    /// Strong coupling on the tangent stiffness of a coarser mesh's answer, with Anderson
    /// acceleration.
    #[default]
    Accelerated,
    /// One initial-stress update for each contact solve (the paper's choice).
    Strong,
    /// Plasticity converged at fixed contact forces between contact solves, with Aitken
    /// relaxation.
    Weak,
    /// Stiffness reassembled with secant moduli and factorized again every iteration (the paper's
    /// rival).
    SecantStiffness,
}

impl Named for Coupling {
    const ALL: &'static [Self] =
        &[Self::Accelerated, Self::Strong, Self::Weak, Self::SecantStiffness];

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

/// The theory of plasticity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Theory {
    /// Stress follows from the strain alone (Hencky): the paper's theory, for loads that only
    /// rise.
    #[default]
    Deformation,
    /// Stress follows from the history of strain (Prandtl and Reuss): the loads of a job are a
    /// history.
    Flow,
}

impl Named for Theory {
    const ALL: &'static [Self] = &[Self::Deformation, Self::Flow];

    fn name(self) -> &'static str {
        match self {
            Self::Deformation => "deformation",
            Self::Flow => "flow",
        }
    }
}

record! {
    /// Iteration controls.
    #[derive(Copy)]
    pub struct SolverSettings("", "Solver") {
        /// Theory of plasticity: `deformation` knows no unloading, `flow` follows the loads as a
        /// history.
        pub theory: Theory = Field::choice::<Theory>("Theory").label("Theory", ""),
        /// Increments of each load of a history, of equal size. Without it the program chooses
        /// them. Only with `flow`.
        pub increments: Option<u32> = Field::whole(1..=10_000).label("Increments", ""),
        /// How the contact iteration and the plastic iteration alternate.
        pub coupling: Coupling = Field::choice::<Coupling>("Coupling").label("Coupling", ""),
        /// The method that solves the contact conditions.
        pub contact: ContactMethod = Field::choice::<ContactMethod>("ContactMethod").label("Contact method", ""),
        /// Relative tolerance on the displacement change and on the out-of-balance force.
        pub tolerance: PositiveF64 = Field::pure(1e-12..=1e-1).label("Tolerance", ""),
        /// Iteration limit.
        pub max_iterations: u32 = Field::whole(1..=100_000).label("Iterations at most", ""),
    }
}

impl Default for SolverSettings {
    fn default() -> Self {
        Self {
            theory: Theory::default(),
            increments: None,
            coupling: Coupling::default(),
            contact: ContactMethod::default(),
            tolerance: PositiveF64::MICRO,
            max_iterations: 500,
        }
    }
}

record! {
    /// What the result contains beside the contact itself.
    #[derive(Copy)]
    pub struct OutputSettings("", "Output") {
        /// Stresses over depth under the peak pressure.
        pub subsurface: bool = Field::flag().label("Stresses over depth", ""),
        /// Mesh and nodal fields, some megabytes.
        pub fields: bool = Field::flag().label("Stress field on the mesh", ""),
        /// Contact stiffness of bodies that yield too, from two more solves of each step on small
        /// meshes.
        pub contact_stiffness: bool = Field::flag().label("Contact stiffness", "dP/dα"),
    }
}

impl Default for OutputSettings {
    fn default() -> Self {
        Self { subsurface: true, fields: false, contact_stiffness: false }
    }
}
