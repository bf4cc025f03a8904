//! Finite elements: meshes, the quadrilateral with mean dilatation, and the assembly of equations
//! and stresses.

pub mod assembly;
pub mod element;
pub mod mesh;
