//! Finite elements: meshes, the quadrilateral with mean dilatation, the assembly of equations and
//! stresses, and meshed bodies as an engine of `brinell-method`.

pub mod assembly;
pub mod element;
pub mod engine;
pub mod mesh;
