//! Loads that roll and slide over a track again and again: its cells, one pass of the load, and what
//! becomes of the track. A line is a track of one row.
//!
//! - [`TrackGrid`]: columns of a ring, rows across it, and the window of the contact;
//! - [`Operators`]: pressure and plastic strain to stress and displacement, of a
//!   [line](crate::line) or of an [ellipse](crate::raceway);
//! - [`TrackBody`]: plastic strain that is carried along the track, one pass as the fixed point
//!   of `increment -> open -> (contact) -> trial -> flow`;
//! - [`Outlet`], [`PassStrain`]: figures of a pass;
//! - [`SteadyState`]: shakedown, closed cycle or ratcheting;
//! - [`TrackFault`]: why there is no answer;
//! - [`TrackLimits`]: limits of shakedown of the discrete track of a line.
//!
//! x is the direction of travel, y lies across it, z is the depth. Equations with sources:
//! `docs/theory_rolling.md`.

mod body;
mod fault;
mod figures;
mod grid;
mod law;
mod limits;
mod operators;
mod verdict;

pub use body::TrackBody;
pub use fault::{DEEPEST, TrackFault};
pub use figures::{AtDepth, Outlet, PassStrain};
pub use grid::{LENGTH_OF_ELLIPSE, LENGTH_OF_LINE, TrackGrid};
pub use limits::TrackLimits;
pub use operators::{Direction, Frame, Ground, Operators, Settled};
pub use verdict::SteadyState;
