//! Half-spaces and tracks as engines of `brinell-method`.
//!
//! [`half_spaces`] presses two bodies together in three dimensions; [`rolling`] rolls or slides a
//! body over a track. Neither knows a job, a wire format or a unit of display.

pub mod half_spaces;
pub mod rolling;
mod watch;

/// Part of the cells that flows, for the memory of a solve: one of so many.
const FLOWING: usize = 4;

/// Largest violation of a contact condition that the contact solver leaves: half of what the check
/// lets pass.
const CONTACT_TOLERANCE: f64 = 5e-9;
