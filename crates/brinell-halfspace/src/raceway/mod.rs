//! Elliptic contacts that roll and slide along a straight track of finite width: balls, crowned
//! rollers and raceways.
//!
//! - [`RacewayGrid`]: a ring along the travel, padding across it; half by symmetry about the axis;
//! - [`RacewaySpace`]: S, S_t, their transposes and G;
//! - [`UniformTrack`]: groove and forward displacement of what a pass leaves;
//! - [`RacewayBody`]: plastic strain that is carried along the rows of a track; it
//!   [`Rolls`](crate::track::Rolls) as a body under a line does.
//!
//! x is the direction of travel, y lies across it, z is the depth. Equations with sources:
//! `docs/theory_rolling.md`.

mod body;
mod grid;
mod space;
mod uniform;
mod waves;

pub use body::{RacewayBody, RowLaw};
pub use grid::{RACEWAY_LENGTH, RacewayGrid};
pub use space::{RacewaySpace, RacewayWork};
pub use uniform::UniformTrack;
