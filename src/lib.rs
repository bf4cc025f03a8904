//! Elasto-plastic contact between two bodies.
pub mod analytical;
pub mod contact;
pub mod linalg;
pub mod model;
pub mod results;
pub mod solve;
