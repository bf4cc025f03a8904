//! Settings of the mesh, the solver and the output.

use serde::Serialize;
use strum::{IntoStaticStr, VariantArray};

use super::fields::{Field, Known, record};
use super::{Analysis, FieldError, Named, PositiveF64};
pub use brinell_method::settings::Theory;

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
        /// Bound of the relative errors of the figures that answer the job, as 0.01. Mesh
        /// and increments are refined until they are met, to four times the elements at most;
        /// `validity` of the result names the figure that misses it. Without it one mesh is solved.
        pub accuracy: Option<PositiveF64> = Field::pure(1e-3..=0.2).label("Accuracy", ""),
    }
}

impl MeshSettings {
    /// Least number of elements over a half-width.
    pub const MIN_ELEMENTS_PER_HALF_WIDTH: u32 = 4;
    /// Largest number of elements over a half-width (about 2.5 million equations per body).
    pub const MAX_ELEMENTS_PER_HALF_WIDTH: u32 = 320;
    /// Largest number of cells over a semi-axis in three dimensions.
    pub const MAX_CELLS_PER_SEMI_AXIS: u32 = 60;

    /// Returns the mesh for a number of elements.
    #[must_use]
    pub const fn with_elements(self, elements_per_half_width: u32) -> Self {
        Self { elements_per_half_width, ..self }
    }

    /// Returns the default mesh settings of an analysis.
    pub fn of(analysis: Analysis) -> Self {
        match analysis {
            Analysis::ThreeDimensional => Self { elements_per_half_width: 10, ..Self::default() },
            Analysis::PlaneStrain | Analysis::PlaneStress | Analysis::Axisymmetric => {
                Self::default()
            }
        }
    }
}

impl Default for MeshSettings {
    fn default() -> Self {
        Self { elements_per_half_width: 20, accuracy: None }
    }
}

/// A method by one word, which sets theory, coupling and contact method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub enum Method {
    /// What the other settings say.
    #[default]
    Standard,
    /// The method of Jiang and Shang: deformation theory, total initial stress on an elastic
    /// stiffness that is factorized once, strong coupling, contact by the simplex with restricted
    /// basis entry.
    JiangShang,
}

impl Named for Method {
    const FORMER: &'static [(&'static str, Self)] = &[("paper", Self::JiangShang)];
}

/// The alternation between contact and plasticity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, IntoStaticStr, VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum Coupling {
    /// Strong coupling on the tangent stiffness of the coarse mesh's answer, with Anderson
    /// acceleration.
    #[default]
    Accelerated,
    /// One initial-stress update for each contact solve (the paper's choice).
    Strong,
    /// Plasticity converged at fixed contact forces between contact solves, with Aitken
    /// relaxation.
    Weak,
    /// Secant moduli in the stiffness, assembled and factorized anew in every iteration (the
    /// paper's comparison).
    SecantStiffness,
}

impl Named for Coupling {}

/// The method that solves the contact problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, IntoStaticStr, VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum ContactMethod {
    /// Warm-started primal-dual active set.
    #[default]
    ActiveSet,
    /// Simplex with restricted basis entry (the paper's choice).
    Simplex,
}

impl Named for ContactMethod {}

record! {
    /// Iteration controls.
    #[derive(Copy)]
    pub struct SolverSettings("", "Solver") where rules {
        /// `jiang_shang` is their published method: deformation theory, strong coupling, contact by
        /// the simplex; `coupling` may be `weak` or `secant_stiffness` for their comparisons.
        pub method: Method = Field::choice::<Method>("Method").label("Method", ""),
        /// Theory of plasticity: `flow` follows the loads from rest in increments; `deformation`
        /// takes each load at once, knows no unloading, and its error has no bound.
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
            method: Method::Standard,
            theory: Theory::default(),
            increments: None,
            coupling: Coupling::default(),
            contact: ContactMethod::default(),
            tolerance: PositiveF64::MICRO,
            max_iterations: 500,
        }
    }
}

impl SolverSettings {
    /// Returns the settings of the paper's method.
    pub fn paper() -> Self {
        Self {
            method: Method::JiangShang,
            theory: Theory::Deformation,
            coupling: Coupling::Strong,
            contact: ContactMethod::Simplex,
            ..Self::default()
        }
    }
}

/// The paper's method brings its theory, its couplings and its contact method.
fn rules(known: &Known) -> Vec<FieldError> {
    if known.word("method") != Some(Method::JiangShang.name()) {
        return Vec::new();
    }
    let paper = SolverSettings::paper();
    let accelerated = Coupling::Accelerated.name();
    let is_of_paper = |key: &str, word: &str| match key {
        "theory" => word == paper.theory.name(),
        "contact" => word == paper.contact.name(),
        _ => word != accelerated,
    };
    let words = ["theory", "coupling", "contact"].map(|key| (key, known.word(key)));
    let foreign = words.into_iter().filter_map(|(key, word)| {
        word.filter(|word| !is_of_paper(key, word))?;
        let detail = "must be left to the method `jiang_shang`, which is deformation theory with \
                      the coupling `strong`, `weak` or `secant_stiffness` and the contact method \
                      `simplex`";
        Some(FieldError::new(format!("/{key}"), detail))
    });
    foreign.collect()
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
