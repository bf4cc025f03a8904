//! Finite elements: meshes, the quadrilateral with mean dilatation, and what is assembled from it.

pub mod assembly;
pub mod element;
pub mod mesh;
