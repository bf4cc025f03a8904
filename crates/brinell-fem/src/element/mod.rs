//! The 4-node quadrilateral with mean dilatation (B-bar).
//!
//! Plastic flow keeps the volume constant. A plain Q4 then locks: it has four volumetric
//! constraints in each element. B-bar replaces the dilatation at each Gauss point by its mean over
//! the element, a single constraint, and keeps the deviator:
//!
//! ```text
//! ε̄ = dev(B u) + ⅓ (1/V ∫ tr(B u) dV) 1
//! ```
//!
//! # Reference
//! T. J. R. Hughes, *Generalization of selective integration procedures to anisotropic and
//! nonlinear media*, Int. J. Numer. Meth. Engng 15 (1980) 1413–1418.

mod bilinear_map;
mod quad;
mod stiffness;

pub use bilinear_map::{natural_coordinates, shape_functions};
pub use quad::{QUADRATURE_POINTS, Quad, SHAPE_AT_POINTS, StressState};
pub use stiffness::{ElementStiffness, element_stiffness};
