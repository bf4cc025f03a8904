//! Why a job has no solution to report.

use brinell_halfspace::{ElasticityError, GridError};
use thiserror::Error;

use crate::contact::ContactError;
use crate::fem::mesh::MeshError;
use crate::solver::conforming::MAX_HALF_ANGLE;
use crate::solver::method::force_search::Unreachable;
use crate::solver::method::observer::Interrupt;
use crate::solver::method::{self, Interrupted};
use sparse_cholesky::FactorizationError;

/// Why a job has no solution to report.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SolveError {
    /// No mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// No factor.
    #[error(transparent)]
    Factorization(#[from] FactorizationError),
    /// No contact solution.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// No grid for half-spaces.
    #[error(transparent)]
    Grid(#[from] GridError),
    /// Elastic constants that half-spaces do not have.
    #[error(transparent)]
    Elasticity(#[from] ElasticityError),
    /// The load would spread the contact over too much of the bodies.
    #[error(
        "the contact would reach about {half_width:.4} mm to each side on a surface that spans \
         {available:.4} mm; small-displacement contact theory does not carry that far: reduce the \
         load"
    )]
    TooWide {
        /// Expected half-width \[mm\].
        half_width: f64,
        /// Half-span of the narrower surface \[mm\].
        available: f64,
    },
    /// The load would press a pin round more of its hole than is solved.
    #[error(
        "the contact would reach about {half_angle:.0}° to each side; a contact in a hole is \
         solved up to {MAX_HALF_ANGLE}°: reduce the load, or widen the clearance"
    )]
    TooFarRound {
        /// Expected angle to each side \[degrees\].
        half_angle: f64,
    },
    /// The surfaces do not open away from the contact.
    #[error(
        "the surfaces do not open within {limit:.4} mm of where they first touch, half of the way \
         to their ends, so that no load makes a contact that ends there: make the surfaces wider \
         if they open beyond"
    )]
    Conforming {
        /// How far from there contacts are solved \[mm\].
        limit: f64,
    },
    /// The surfaces first touch where one of them is about to end.
    #[error(
        "the surfaces first touch at x = {x:.4} mm, but contacts are solved from {left:.4} to \
         {right:.4} mm, a fifth short of the ends of the surfaces: make them wider, or move what \
         touches towards the middle"
    )]
    TouchesAtEnd {
        /// Where they first touch \[mm\].
        x: f64,
        /// Where a contact may begin \[mm\].
        left: f64,
        /// Where it may end \[mm\].
        right: f64,
    },
    /// A surface that is given by points has details much smaller than the contact.
    #[error(
        "within the contact, of half-width {half_width:.4} mm, the surfaces have details that \
         only elements of {spacing:.2e} mm resolve, but {finest:.2e} mm is the finest that is \
         solved: give the surface with fewer points, smooth its trace, or leave out a radius that \
         is so much smaller than the contact"
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
        "the face turns by {opening:.3} at the point x = {x:.6} mm of a profile, within the \
         contact: set its `interpolation` to \"linear\" if this is a corner, to \"smooth\" if it \
         is to be rounded off"
    )]
    AmbiguousCorner {
        /// The body, 0 for the upper one.
        side: usize,
        /// Where \[mm\].
        x: f64,
        /// Change of slope.
        opening: f64,
    },
    /// The onset of yield is sought of bodies that do not yield, or do from the first load on.
    #[error("neither body has a yield stress, so there is no onset of yield to find")]
    NoYieldPoint,
    /// A history without a load.
    #[error("none of the loads is above zero")]
    NoLoad,
    /// No force gives the contact what it was to have.
    #[error("no force gives the contact what the job asks for")]
    Unreachable(Unreachable),
    /// The bodies have no stiffness that could take secant moduli.
    #[error("the coupling by secant stiffness needs bodies whose stiffness is assembled")]
    NoSecantStiffness,
    /// The load is far beyond what half-spaces bear with small strains.
    #[error(
        "elastic bodies would press on each other with {overload:.0} times the stress at which \
         these flow; half-spaces with small strains are solved up to {most} times: reduce the load"
    )]
    Overloaded {
        /// Largest pressure of elastic bodies over the stress under which the material flows.
        overload: f64,
        /// What is solved.
        most: f64,
    },
    /// The contact would be many times as wide as a roller is long.
    #[error(
        "the roller is {length:.2e} mm long, but under this load no grid holds its contact below a \
         length of {least:.2e} mm: reduce the load or its moment, or give the length that touches"
    )]
    ShortRoller {
        /// Its length \[mm\].
        length: f64,
        /// What a grid holds \[mm\].
        least: f64,
    },
    /// Stopped before there was anything to report.
    #[error("stopped before the first iteration")]
    Interrupted(Interrupt),
}

impl From<method::Error> for SolveError {
    fn from(error: method::Error) -> Self {
        match error {
            method::Error::Factorization(error) => Self::Factorization(error),
            method::Error::Contact(error) => Self::Contact(error),
            method::Error::NoLoad => Self::NoLoad,
            method::Error::Unreachable(nearest) => Self::Unreachable(nearest),
            method::Error::NoSecantStiffness => Self::NoSecantStiffness,
            method::Error::Interrupted(interrupt) => Self::Interrupted(interrupt),
        }
    }
}

impl Interrupted for SolveError {
    fn interrupt(&self) -> Option<Interrupt> {
        match self {
            Self::Interrupted(interrupt) => Some(*interrupt),
            _ => None,
        }
    }
}
