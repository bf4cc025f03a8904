//! Why a contact that rolls has no solution.

use std::fmt;

use crate::track::TrackFault;
use crate::{ElasticityError, GridError};

use brinell_method::Interrupted;
use brinell_method::observer::Interrupt;

/// Why a contact that rolls has no solution.
#[derive(Debug, Clone, PartialEq)]
pub enum TrackError {
    /// The alternation has no answer.
    Method(brinell_method::Error),
    /// No grid for half-spaces.
    Grid(GridError),
    /// Elastic constants that half-spaces do not have.
    Elasticity(ElasticityError),
    /// A load rolls over surfaces that do not open as one arc.
    NoTrack,
    /// A load rolls in three dimensions over surfaces on which it cannot, and why.
    NoRaceway(&'static str),
    /// A track has no equilibrium.
    Track(TrackFault),
}

impl fmt::Display for TrackError {
    /// Writes lengths in millimetres.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Method(error) => error.fmt(f),
            Self::Grid(error) => error.fmt(f),
            Self::Elasticity(error) => error.fmt(f),
            Self::NoTrack => f.write_str(
                "a load rolls over surfaces that open as one arc from where they touch: \
                 cylinders, blocks, grooves, parabolas and ellipses, of which at least one is \
                 round",
            ),
            Self::NoRaceway(reason) => f.write_str(reason),
            Self::Track(fault) => fault.fmt(f),
        }
    }
}

impl std::error::Error for TrackError {}

impl Interrupted for TrackError {
    fn interrupt(&self) -> Option<Interrupt> {
        match self {
            Self::Method(error) => error.interrupt(),
            _ => None,
        }
    }
}

impl From<brinell_method::Error> for TrackError {
    fn from(error: brinell_method::Error) -> Self {
        Self::Method(error)
    }
}

impl From<GridError> for TrackError {
    fn from(error: GridError) -> Self {
        Self::Grid(error)
    }
}

impl From<ElasticityError> for TrackError {
    fn from(error: ElasticityError) -> Self {
        Self::Elasticity(error)
    }
}
