//! Elasto-plastic contact between two bodies.
pub mod analytical;
pub mod assembly;
pub mod contact;
pub mod element;
pub mod linalg;
pub mod mesh;
pub mod model;
pub mod plasticity;
pub mod results;
pub mod solve;
