//! Where jobs are kept: implementations of [`JobStore`](crate::jobs::JobStore).

pub mod memory;
mod shelf;

pub use memory::{MemoryLimits, MemoryStore};
