//! The method: contact and plasticity in alternation, over bodies of any kind.
//!
//! [`ContactSystem`](contact_system::ContactSystem) describes the two bodies to it. [`solve`]
//! holds the outer loop, [`couplings`] the alternation under one load. Nothing here knows a mesh,
//! an element or a job.

pub mod bounds;
pub mod bracket;
pub mod contact_system;
pub mod couplings;
mod error;
pub mod figures;
pub mod final_check;
pub mod force_search;
#[cfg(test)]
mod half_planes;
pub mod history;
mod history_steps;
pub mod increments;
pub mod loads;
pub mod observer;
pub mod parabola;
pub mod phases;
pub mod progress;
pub mod run;
pub mod settings;
pub mod slope;
pub mod solve;
pub mod sought;
pub mod steps;
pub mod strays;
pub mod words;

pub use error::{Error, Interrupted, Limit, Unreachable, UnreachableReason};
