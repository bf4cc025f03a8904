//! Elliptic contacts that roll and slide along a straight track of finite width: balls, crowned
//! rollers and raceways.
//!
//! - [`RacewaySpace`]: S, S_t, their transposes and G on a ring along the travel, with padding
//!   across it; half by symmetry about the axis;
//! - [`UniformTrack`]: groove and forward displacement of what a pass leaves;
//! - [`RacewayBody`]: plastic strain that is carried along the rows of a [track](crate::track).

mod space;
mod uniform;
mod waves;

pub use space::{RacewaySpace, RacewayWork};
pub use uniform::UniformTrack;

use crate::tensors::{COMPONENTS, DEVIATOR_COMPONENTS};
use crate::track::TrackBody;
use brinell_material::StreamLaw;

/// The plastic law of the rows of a body.
pub type RowLaw = dyn StreamLaw<COMPONENTS, DEVIATOR_COMPONENTS>;

/// A body under an ellipse, of which deviators `xx yy xy xz yz` are given.
pub type RacewayBody = TrackBody<RacewaySpace, COMPONENTS, DEVIATOR_COMPONENTS>;
