//! Why a contact of half-spaces has no solution.

use std::fmt;

use crate::{ElasticityError, GridError};

use brinell_method::Interrupted;
use brinell_method::observer::Interrupt;

/// Why a contact of half-spaces has no solution.
#[derive(Debug, Clone, PartialEq)]
pub enum HalfSpaceError {
    /// The alternation has no answer.
    Method(brinell_method::Error),
    /// No grid for half-spaces.
    Grid(GridError),
    /// Elastic constants that half-spaces do not have.
    Elasticity(ElasticityError),
    /// The onset of yield is sought of bodies that do not yield, or do from the first load on.
    NoYieldPoint,
    /// The load is far beyond what half-spaces bear with small strains.
    Overloaded {
        /// Largest pressure of elastic bodies over the stress under which the material flows.
        overload: f64,
        /// Largest ratio that is solved.
        most: f64,
    },
    /// The contact would be many times as wide as a roller is long.
    ShortRoller {
        /// Its length \[mm\].
        length: f64,
        /// Least length that a grid holds \[mm\].
        least: f64,
    },
}

impl fmt::Display for HalfSpaceError {
    /// Writes lengths in millimetres.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Method(error) => error.fmt(f),
            Self::Grid(error) => error.fmt(f),
            Self::Elasticity(error) => error.fmt(f),
            Self::NoYieldPoint => f.write_str(
                "neither body has a yield stress, so there is no onset of yield to find",
            ),
            Self::Overloaded { overload, most } => write!(
                f,
                "elastic bodies would press on each other with {overload:.0} times the stress at \
                 which these flow; half-spaces with small strains are solved up to {most} times: \
                 reduce the load"
            ),
            Self::ShortRoller { length, least } => write!(
                f,
                "the roller is {length} mm long, but under this load no grid holds its contact \
                 below a length of {least} mm"
            ),
        }
    }
}

impl std::error::Error for HalfSpaceError {}

impl Interrupted for HalfSpaceError {
    fn interrupt(&self) -> Option<Interrupt> {
        match self {
            Self::Method(error) => error.interrupt(),
            _ => None,
        }
    }
}

impl From<brinell_method::Error> for HalfSpaceError {
    fn from(error: brinell_method::Error) -> Self {
        Self::Method(error)
    }
}

impl From<GridError> for HalfSpaceError {
    fn from(error: GridError) -> Self {
        Self::Grid(error)
    }
}

impl From<ElasticityError> for HalfSpaceError {
    fn from(error: ElasticityError) -> Self {
        Self::Elasticity(error)
    }
}
