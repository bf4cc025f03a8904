//! The alternation of contact and plasticity.
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
pub mod floors;
pub mod half_spaces;
mod load_stepping;
mod loads;
mod mesh_sizing;
mod mesh_solve;
mod outline;
mod problem;
pub(crate) mod recovery;
mod reference;
pub mod rolling;
mod slopes;
mod solution;
mod strategy;
mod surface_recovery;
mod theory_bias;
pub(crate) mod watch;

pub(crate) use brinell_method as method;

pub use body_solution::BodySolution;
pub(crate) use body_solution::{bounded_strain, has_yielded};
pub use body_system::contact_patch::ContactPatch;
pub use body_system::factor_cache::{FactorCache, FactorCacheStats};
pub use conforming::ConformingPair;
pub(crate) use conforming::MAX_HALF_ANGLE;
pub use error::SolveError;
pub(crate) use error::track_text;
pub(crate) use final_check::TIP_ELEMENTS;
pub(crate) use load_stepping::force_search::target_figure;
pub use load_stepping::run::{Options, run, run_each, run_with};
pub(crate) use load_stepping::utilization::{
    EDGE_UTILIZATION, at_narrow_edge, highest_utilization,
};
pub use mesh_sizing::estimate::{Estimate, estimate};
pub use method::figures::{BodyFigures, Figure, FigureSet, Figures};
pub use method::increments::LastIncrement;
pub use method::observer::{
    Held, IncrementNumber, Interrupt, IterationRecord, Observer, SolveStatus, Unobserved,
};
pub use method::phases::{Phase, PhaseTimes};
pub use method::steps::{Checks, Energy, IncrementRecord, Path, Search, Step, StepReceiver};
pub use method::{Unreachable, UnreachableReason};
pub use outline::outline_of;
pub use problem::ModelOf;
pub(crate) use problem::Problem;
pub use reference::ElasticReference;
pub(crate) use reference::{elastic_utilization, factor_of_onset, over_yield_stress};
pub(crate) use slopes::{
    SLOPE_ERROR, SLOPE_ERROR_IN_PLANE_STRESS, of_small_mesh, small, small_solves,
};
pub use solution::{NarrowEdge, PairState, RoundedTip, SectionField, Solution, StepSolution};
pub use surface_recovery::{SurfaceStress, surface_stresses};
pub(crate) use surface_recovery::{
    recovered, recovered_at_rest, surface_stress_error, surface_stress_in_middle,
};
pub(crate) use theory_bias::LEAST_RATIO;
pub use theory_bias::TheoryBias;
