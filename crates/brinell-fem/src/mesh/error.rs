//! Bodies that are not meshed.

use thiserror::Error;

/// Slope of a surface given by points up to which meshes are made without fail.
pub const MESHED_SLOPE: f64 = 0.5;

/// Why mesh generation has failed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MeshError {
    /// The contact zone does not fit on the body.
    #[error(
        "a contact zone of half-width {half_width:.4} mm does not fit on a surface that spans \
         {available:.4} mm"
    )]
    ZoneBeyondBody {
        /// Half-width of the zone asked for \[mm\].
        half_width: f64,
        /// Largest half-width that the surface offers \[mm\].
        available: f64,
    },
    /// A surface given by points is too steep for the mesh.
    #[error(
        "the face has a slope of {slope:.2} at x = {x:.6} mm; a body that deforms is meshed up to \
         slopes of about {MESHED_SLOPE}, and contact theory with small displacements is not meant \
         for steeper ones"
    )]
    TooSteep {
        /// Abscissa \[mm\].
        x: f64,
        /// Slope there.
        slope: f64,
    },
    /// The interpolation folded over itself.
    #[error(
        "element {element} of the mesh is turned inside out; this is a defect of the mesh \
         generator"
    )]
    Inverted {
        /// Index of the element.
        element: usize,
    },
}
