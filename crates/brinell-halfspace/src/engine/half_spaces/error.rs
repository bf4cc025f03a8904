//! Why a contact of half-spaces has no solution.

use crate::{ElasticityError, GridError};

use brinell_method::Interrupted;
use brinell_method::observer::Interrupt;

/// Why a contact of half-spaces has no solution. Its texts have lengths in millimetres.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum HalfSpaceError {
    /// The alternation has no answer.
    #[error(transparent)]
    Method(#[from] brinell_method::Error),
    /// No grid for half-spaces.
    #[error(transparent)]
    Grid(#[from] GridError),
    /// Elastic constants that half-spaces do not have.
    #[error(transparent)]
    Elasticity(#[from] ElasticityError),
    /// The onset of yield is sought of bodies that do not yield, or do from the first load on.
    #[error("neither body has a yield stress, so there is no onset of yield to find")]
    NoYieldPoint,
    /// The load is far beyond what half-spaces bear with small strains.
    #[error(
        "elastic bodies would press on each other with {overload:.0} times the stress at which \
         these flow; half-spaces with small strains are solved up to {most} times: reduce the load"
    )]
    Overloaded {
        /// Largest pressure of elastic bodies over the stress under which the material flows.
        overload: f64,
        /// Largest ratio that is solved.
        most: f64,
    },
    /// The contact would be many times as wide as a roller is long.
    #[error(
        "the roller is {length} mm long, but under this load no grid holds its contact below a \
         length of {least} mm"
    )]
    ShortRoller {
        /// Its length \[mm\].
        length: f64,
        /// Least length that a grid holds \[mm\].
        least: f64,
    },
}

impl Interrupted for HalfSpaceError {
    fn interrupt(&self) -> Option<Interrupt> {
        match self {
            Self::Method(error) => error.interrupt(),
            _ => None,
        }
    }
}
