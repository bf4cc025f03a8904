//! Line contacts that roll and slide: columns of a half-space in plane strain.
//!
//! - [`LineFlexibility`]: contact in the window of a track;
//! - [`LineSpace`]: S, S_t, their transposes and G with `q_y = 0`;
//! - [`LineBody`]: plastic strain that is carried along the layers of a [track](crate::track).

mod flexibility;
mod space;
pub(crate) mod strip;
mod sweep;

pub use flexibility::LineFlexibility;
pub use space::{LineSpace, LineWork};

use crate::track::TrackBody;

/// A body under a line, of which deviators `xx zz xz` are given.
pub type LineBody = TrackBody<LineSpace, 4, 3>;
