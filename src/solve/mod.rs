//! The alternation of contact and plasticity.
mod record;
pub use record::{Interrupt, IterationRecord, Observer, SolveStatus, Unobserved};
