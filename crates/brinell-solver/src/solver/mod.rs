//! The alternation of contact and plasticity.
//!
//! ```text
//! size:      a small mesh finds out how wide the contact is and how far plastic flow reaches
//! coarse:    a mesh of half the density, sized by that answer
//! fine:      the mesh that was asked for, sized by the coarse one
//!   factorize  K = L Lᵀ of each body, once; contact flexibility F from the last block of L
//!   repeat     contact (R, α) → displacements → plastic law → initial-stress load
//! judge:     full displacement fields; contact conditions and equilibrium from scratch
//! ```

mod body_system;
mod couplings;
mod final_check;
mod load_stepping;
mod mesh_sizing;
mod observer;
mod phases;
mod problem;
mod reference;

pub use body_system::contact_patch::ContactPatch;
pub use body_system::factor_cache::{FactorCache, FactorCacheStats};
pub use final_check::solution::{BodySolution, CoarseFigures, PairState, Solution, StepSolution};
pub use load_stepping::run::{Options, run, run_with};
pub use mesh_sizing::estimate::{Estimate, estimate};
pub use observer::{Interrupt, IterationRecord, Observer, SolveStatus, Unobserved};
pub use phases::{Phase, PhaseTimes};
pub use reference::ElasticReference;

use std::ops::ControlFlow;

use thiserror::Error;

use crate::contact::ContactError;
use crate::fem::mesh::MeshError;
use sparse_cholesky::FactorizationError;

/// Why a job has no solution to report.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SolveError {
    /// No mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// No factor.
    #[error(transparent)]
    Factorization(#[from] FactorizationError),
    /// No contact solution.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The load would spread the contact over too much of the bodies.
    #[error(
        "the contact would reach about {half_width:.4} mm to each side on a surface that spans {available:.4} mm; \
         small-displacement contact theory does not carry that far: reduce the load"
    )]
    TooWide {
        /// Expected half-width \[mm\].
        half_width: f64,
        /// Half-span of the narrower surface \[mm\].
        available: f64,
    },
    /// The surfaces do not open away from the contact.
    #[error("the surfaces do not open away from where they first touch; conforming contacts are not solved")]
    Conforming,
    /// The onset of yield is sought of bodies that do not yield, or do from the first load on.
    #[error("neither body has a yield stress, so there is no onset of yield to find")]
    NoYieldPoint,
    /// Stopped before there was anything to report.
    #[error("stopped before the first iteration")]
    Interrupted(Interrupt),
}

/// Passes on an observer's wish to stop.
fn checkpoint(observer: &mut dyn Observer) -> Result<(), SolveError> {
    match observer.on_checkpoint() {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(interrupt) => Err(SolveError::Interrupted(interrupt)),
    }
}
