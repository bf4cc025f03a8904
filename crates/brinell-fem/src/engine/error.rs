//! Why a contact of meshed bodies has no solution.

use crate::mesh::MeshError;
use brinell_method::observer::Interrupt;
use brinell_method::{Interrupted, Limit};
use sparse_cholesky::FactorizationError;

/// Why a contact of meshed bodies has no solution. Its texts have lengths in millimetres.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshedError {
    /// The alternation has no answer.
    #[error(transparent)]
    Method(#[from] brinell_method::Error),
    /// No mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The load would spread the contact over too much of the bodies.
    #[error(
        "the contact would reach {half_width} mm to each side on a surface that spans {available} mm"
    )]
    TooWide {
        /// Expected half-width \[mm\].
        half_width: f64,
        /// Half-span of the narrower surface \[mm\].
        available: f64,
    },
    /// The load would press a pin round more of its hole than is solved.
    #[error("the contact would reach {half_angle:.0}° to each side of a hole")]
    TooFarRound {
        /// Expected angle to each side \[degrees\].
        half_angle: f64,
    },
    /// The surfaces do not open away from the contact.
    #[error("the surfaces do not open within {limit} mm of where they first touch")]
    Conforming {
        /// Distance from the first contact within which contacts are solved \[mm\].
        limit: f64,
    },
    /// The surfaces first touch where one of them is about to end.
    #[error(
        "the surfaces first touch at x = {x} mm, but contacts are solved from {left} mm to {right} mm"
    )]
    TouchesAtEnd {
        /// Abscissa of the first contact \[mm\].
        x: f64,
        /// Left limit of contacts \[mm\].
        left: f64,
        /// Right limit of contacts \[mm\].
        right: f64,
    },
    /// A surface that is given by points has details much smaller than the contact.
    #[error(
        "within a contact of half-width {half_width} mm, the surfaces have details that only \
         elements of {spacing} mm resolve, but {finest} mm is the finest that is solved"
    )]
    TraceTooFine {
        /// Expected half-width \[mm\].
        half_width: f64,
        /// Element size that resolves the trace \[mm\].
        spacing: f64,
        /// Smallest element size that is solved \[mm\].
        finest: f64,
    },
    /// A profile has a corner in the contact, and nothing says whether it is one.
    #[error(
        "the face turns by {opening} at the point x = {x} mm within the contact, and nothing says \
         whether this is a corner"
    )]
    AmbiguousCorner {
        /// The body, 0 for the upper one.
        side: usize,
        /// Abscissa of the corner \[mm\].
        x: f64,
        /// Change of slope.
        opening: f64,
    },
    /// The onset of yield is sought of bodies that do not yield, or do from the first load on.
    #[error("neither body has a yield stress, so there is no onset of yield to find")]
    NoYieldPoint,
}

impl MeshedError {
    /// Returns why a force is too large to be solved.
    ///
    /// # Errors
    /// The same error, where no smaller force avoids it.
    pub(super) fn too_large(self) -> Result<Limit, Self> {
        match self {
            Self::TooWide { .. } | Self::TooFarRound { .. } => {
                Ok("the contact would spread over more of the surfaces than is solved".into())
            }
            Self::Mesh(MeshError::ZoneBeyondBody { half_width, available }) => {
                Ok(Limit::NoRoom { half_width, available })
            }
            Self::Mesh(MeshError::TooSteep { x, slope }) => Ok(Limit::TooSteep { x, slope }),
            Self::Mesh(error) => Ok(Limit::Other(error.to_string())),
            error => Err(error),
        }
    }
}

impl Interrupted for MeshedError {
    fn interrupt(&self) -> Option<Interrupt> {
        match self {
            Self::Method(error) => error.interrupt(),
            _ => None,
        }
    }
}

impl From<FactorizationError> for MeshedError {
    fn from(error: FactorizationError) -> Self {
        Self::Method(error.into())
    }
}
