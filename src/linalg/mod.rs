//! Linear algebra without mechanics.

pub mod dense;
