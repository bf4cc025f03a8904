//! Why a contact that rolls has no solution.

use crate::track::TrackFault;
use crate::{ElasticityError, GridError};

use brinell_method::Interrupted;
use brinell_method::observer::Interrupt;

/// Why a contact that rolls has no solution. Its texts have lengths in millimetres.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TrackError {
    /// The alternation has no answer.
    #[error(transparent)]
    Method(#[from] brinell_method::Error),
    /// No grid for half-spaces.
    #[error(transparent)]
    Grid(#[from] GridError),
    /// Elastic constants that half-spaces do not have.
    #[error(transparent)]
    Elasticity(#[from] ElasticityError),
    /// A load rolls over surfaces that do not open as one arc.
    #[error(
        "a load rolls over surfaces that open as one arc from where they touch: cylinders, \
         blocks, grooves, parabolas and ellipses, of which at least one is round"
    )]
    NoTrack,
    /// A load rolls in three dimensions over surfaces on which it cannot, and why.
    #[error("{0}")]
    NoRaceway(&'static str),
    /// A track has no equilibrium.
    #[error(transparent)]
    Track(TrackFault),
}

impl Interrupted for TrackError {
    fn interrupt(&self) -> Option<Interrupt> {
        match self {
            Self::Method(error) => error.interrupt(),
            _ => None,
        }
    }
}
