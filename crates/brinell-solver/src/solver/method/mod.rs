//! The method: contact and plasticity in alternation, over bodies of any kind.
//!
//! [`ContactSystem`](contact_system::ContactSystem) is all that it asks of two bodies. Nothing here knows a mesh, an element or a
//! job.

pub(crate) mod bracket;
pub(crate) mod contact_system;
pub(crate) mod couplings;
pub(crate) mod final_check;
pub(crate) mod force_search;
#[cfg(test)]
mod half_planes;
pub(crate) mod history;
mod history_steps;
pub(crate) mod increments;
pub(crate) mod observer;
pub(crate) mod phases;
pub(crate) mod progress;
pub(crate) mod run;
pub(crate) mod solve;
pub(crate) mod steps;
