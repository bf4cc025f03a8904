//! Why a job has no solution to report.

use std::fmt;

use brinell_halfspace::track::TrackFault;
use brinell_halfspace::{ElasticityError, GridError};

use crate::contact::ContactError;
use crate::fem::mesh::{MESHED_SLOPE, MeshError};
use crate::job::{Analysis, Units};
use crate::solver::conforming::MAX_HALF_ANGLE;
use crate::solver::method::Unreachable;
use crate::solver::method::observer::Interrupt;
use crate::solver::method::{self, Interrupted};
use crate::units::{UnitConverter, about};
use sparse_cholesky::FactorizationError;

/// Why a job has no solution to report.
#[derive(Debug, Clone, PartialEq)]
pub enum SolveError {
    /// No mesh.
    Mesh(MeshError),
    /// No factor.
    Factorization(FactorizationError),
    /// No contact solution.
    Contact(ContactError),
    /// No grid for half-spaces.
    Grid(GridError),
    /// Elastic constants that half-spaces do not have.
    Elasticity(ElasticityError),
    /// The load would spread the contact over too much of the bodies.
    TooWide {
        /// Expected half-width \[mm\].
        half_width: f64,
        /// Half-span of the narrower surface \[mm\].
        available: f64,
    },
    /// The load would press a pin round more of its hole than is solved.
    TooFarRound {
        /// Expected angle to each side \[degrees\].
        half_angle: f64,
    },
    /// The surfaces do not open away from the contact.
    Conforming {
        /// How far from there contacts are solved \[mm\].
        limit: f64,
    },
    /// The surfaces first touch where one of them is about to end.
    TouchesAtEnd {
        /// Where they first touch \[mm\].
        x: f64,
        /// Where a contact may begin \[mm\].
        left: f64,
        /// Where it may end \[mm\].
        right: f64,
    },
    /// A surface that is given by points has details much smaller than the contact.
    TraceTooFine {
        /// Expected half-width \[mm\].
        half_width: f64,
        /// Element size that resolves the trace \[mm\].
        spacing: f64,
        /// Smallest element size that is solved \[mm\].
        finest: f64,
    },
    /// A profile has a corner in the contact, and nothing says whether it is one.
    AmbiguousCorner {
        /// The body, 0 for the upper one.
        side: usize,
        /// Where \[mm\].
        x: f64,
        /// Change of slope.
        opening: f64,
    },
    /// The onset of yield is sought of bodies that do not yield, or do from the first load on.
    NoYieldPoint,
    /// A history without a load.
    NoLoad,
    /// No force gives the contact what it was to have.
    Unreachable(Unreachable),
    /// The bodies have no stiffness that could take secant moduli.
    NoSecantStiffness,
    /// The load is far beyond what half-spaces bear with small strains.
    Overloaded {
        /// Largest pressure of elastic bodies over the stress under which the material flows.
        overload: f64,
        /// What is solved.
        most: f64,
    },
    /// The contact would be many times as wide as a roller is long.
    ShortRoller {
        /// Its length \[mm\].
        length: f64,
        /// What a grid holds \[mm\].
        least: f64,
    },
    /// A load rolls over surfaces that do not open as one arc.
    NoTrack,
    /// A load rolls in three dimensions over surfaces on which it cannot, and why.
    NoRaceway(&'static str),
    /// A track has no equilibrium.
    Track(TrackFault),
    /// Stopped before there was anything to report.
    Interrupted(Interrupt),
}

impl fmt::Display for SolveError {
    /// Writes lengths in millimetres.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(UnitConverter::new(Units::MmNMpa, Analysis::PlaneStrain)))
    }
}

impl std::error::Error for SolveError {}

impl SolveError {
    /// Returns the error as a sentence in the units of a job.
    pub(crate) fn text(&self, write: UnitConverter) -> String {
        let length = |core: f64| write.length_text(core);
        match self {
            Self::Mesh(error) => mesh_text(error, write),
            Self::Factorization(error) => error.to_string(),
            Self::Contact(error) => error.to_string(),
            Self::Grid(error) => error.to_string(),
            Self::Elasticity(error) => error.to_string(),
            Self::TooWide { half_width, available } => format!(
                "the contact would reach about {} to each side on a surface that spans {}; \
                 small-displacement contact theory does not carry that far: reduce the load",
                length(*half_width),
                length(*available)
            ),
            Self::TooFarRound { half_angle } => format!(
                "the contact would reach about {half_angle:.0}° to each side; a contact in a hole \
                 is solved up to {MAX_HALF_ANGLE}°: reduce the load, or widen the clearance"
            ),
            Self::Conforming { limit } => format!(
                "the surfaces do not open within {} of where they first touch, half of the way to \
                 their ends, so that no load makes a contact that ends there: make the surfaces \
                 wider if they open beyond",
                length(*limit)
            ),
            Self::TouchesAtEnd { x, left, right } => format!(
                "the surfaces first touch at x = {}, but contacts are solved from {} to {}, a \
                 fifth short of the ends of the surfaces: make them wider, or move what touches \
                 towards the middle",
                length(*x),
                length(*left),
                length(*right)
            ),
            Self::TraceTooFine { half_width, spacing, finest } => format!(
                "within the contact, of half-width {}, the surfaces have details that only \
                 elements of {} resolve, but {} is the finest that is solved: give the surface \
                 with fewer points, smooth its trace, or leave out a radius that is so much \
                 smaller than the contact",
                length(*half_width),
                write.length_about(*spacing),
                write.length_about(*finest)
            ),
            Self::AmbiguousCorner { x, opening, .. } => format!(
                "the face turns by {} at the point x = {} of a profile, within the contact: set \
                 its `interpolation` to \"linear\" if this is a corner, to \"smooth\" if it is to \
                 be rounded off",
                about(*opening),
                length(*x)
            ),
            Self::NoYieldPoint => {
                "neither body has a yield stress, so there is no onset of yield to find".to_owned()
            }
            Self::NoLoad => "none of the loads is above zero".to_owned(),
            Self::Unreachable(_) => "no force gives the contact what the job asks for".to_owned(),
            Self::NoSecantStiffness => {
                "the coupling by secant stiffness needs bodies whose stiffness is assembled"
                    .to_owned()
            }
            Self::Overloaded { overload, most } => format!(
                "elastic bodies would press on each other with {overload:.0} times the stress at \
                 which these flow; half-spaces with small strains are solved up to {most} times: \
                 reduce the load"
            ),
            Self::ShortRoller { length: whole, least } => format!(
                "the roller is {} long, but under this load no grid holds its contact below a \
                 length of {}: reduce the load or its moment, or give the length that touches",
                write.length_about(*whole),
                write.length_about(*least)
            ),
            Self::NoTrack => "a load rolls over surfaces that open as one arc from where they \
                              touch: cylinders, blocks, grooves, parabolas and ellipses, of which \
                              at least one is round"
                .to_owned(),
            Self::NoRaceway(reason) => (*reason).to_owned(),
            Self::Track(fault) => track_text(fault, write),
            Self::Interrupted(_) => "stopped before the first iteration".to_owned(),
        }
    }
}

/// Returns why a track has no answer as a sentence in the units of a job.
pub(crate) fn track_text(fault: &TrackFault, write: UnitConverter) -> String {
    match *fault {
        TrackFault::Traction { traction, strength } => format!(
            "friction asks for a shear stress of {} at the surface, where the material bears {} \
             at most, after all hardening: there is no equilibrium",
            write.stress_about(traction),
            write.stress_about(strength)
        ),
        TrackFault::Window { width } => format!(
            "the contact reaches the end of the {} in which the bodies may touch",
            write.length_about(width)
        ),
        TrackFault::Edge { half_width } => format!(
            "contact or yield reaches the edge of the track, {} from its axis",
            write.length_about(half_width)
        ),
        TrackFault::Depth { depth } => format!(
            "the material yields down to a depth of {}, where the layers end",
            write.length_about(depth)
        ),
    }
}

/// Returns an error of the mesh as a sentence in the units of a job.
fn mesh_text(error: &MeshError, write: UnitConverter) -> String {
    match error {
        MeshError::ZoneBeyondBody { half_width, available } => format!(
            "a contact zone of half-width {} does not fit on a surface that spans {}",
            write.length_text(*half_width),
            write.length_text(*available)
        ),
        MeshError::TooSteep { x, slope } => format!(
            "the face has a slope of {slope:.2} at x = {}; a body that deforms is meshed up to \
             slopes of about {MESHED_SLOPE}, and contact theory with small displacements is not \
             meant for steeper ones",
            write.length_text(*x)
        ),
        error @ MeshError::Inverted { .. } => error.to_string(),
    }
}

macro_rules! from {
    ($($Variant:ident: $Error:ty,)*) => {
        $(impl From<$Error> for SolveError {
            fn from(error: $Error) -> Self {
                Self::$Variant(error)
            }
        })*
    };
}

from! {
    Mesh: MeshError,
    Factorization: FactorizationError,
    Contact: ContactError,
    Grid: GridError,
    Elasticity: ElasticityError,
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
