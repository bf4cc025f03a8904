//! Meshed bodies as an engine of `brinell-method`.
//!
//! ```text
//! size:      a small mesh gives the contact size and the extent of plastic flow
//! coarse:    a mesh of half the density, sized by the small mesh
//! fine:      the mesh of the requested density, sized by the coarse one
//!   factorize  K = L Lᵀ of each body, once; contact flexibility F from the last block of L
//!   repeat     contact (R, α) → displacements → plastic law → initial-stress load
//! check:     full displacement fields; contact conditions and equilibrium from scratch
//! ```

pub mod bars;
mod body_figures;
mod body_solution;
mod body_system;
mod conforming;
mod error;
mod final_check;
mod finite_elements;
mod load_stepping;
mod loads;
mod mesh_sizing;
mod mesh_solve;
mod meshed_contact;
mod problem;
pub mod recovery;
mod reference;
mod solution;
mod surface_recovery;

pub use body_solution::{BodySolution, bounded_strain, has_yielded};
pub use body_system::contact_patch::ContactPatch;
pub use body_system::factor_cache::{FactorCache, FactorCacheStats};
pub use conforming::{ConformingPair, MAX_HALF_ANGLE};
pub use error::MeshedError;
pub use final_check::TIP_ELEMENTS;
pub use load_stepping::run::{Options, run_each};
pub use load_stepping::utilization::{
    EDGE_UTILIZATION, Utilization, at_narrow_edge, highest_utilization,
};
pub use mesh_sizing::estimate::{Estimate, estimate};
pub use meshed_contact::{Asked, MeshedContact};
pub use problem::{GivenBody, GivenStress, ModelOf, Problem, ProblemBody};
pub use reference::{ElasticReference, elastic_utilization};
pub use solution::{
    NarrowEdge, PairState, RoundedTip, SectionField, Solution, StepSolution, target_figure,
};
pub use surface_recovery::{
    SurfaceStress, recovered, recovered_at_rest, surface_stress_error, surface_stress_in_middle,
    surface_stresses,
};
