//! Elasto-plastic contact between two bodies.
pub mod model;
pub mod results;
pub mod solve;
