//! Half-spaces and tracks as engines of `brinell-method`.
//!
//! [`half_spaces`] presses two bodies together in three dimensions; [`rolling`] rolls or slides a
//! body over a track. Neither knows a job, a wire format or a unit of display.

pub mod half_spaces;
pub mod rolling;
mod watch;
