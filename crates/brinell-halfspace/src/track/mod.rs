//! Line contacts that roll and slide: the operators of a track, one pass of the load, and what
//! becomes of the track.
//!
//! - [`TrackGrid`], [`LineFlexibility`]: columns of a ring, and contact in a window;
//! - [`TrackSpace`]: S, S_t and G with `q_y = 0`, in plane strain;
//! - [`RollingBody`]: plastic strain that is carried along the track, one pass as the fixed point
//!   of `increment -> open -> (contact) -> trial -> flow`;
//! - [`Rolls`]: what it has in common with a body under an elliptic contact;
//! - [`Outlet`], [`PassStrain`], [`rolling_force`]: figures of a pass;
//! - [`Verdict`]: shakedown, closed cycle or ratcheting;
//! - [`TrackFault`]: why there is no answer;
//! - [`TrackLimits`]: limits of shakedown of the discrete track.
//!
//! x is the direction of travel, z the depth. Equations with sources: `docs/theory_rolling.md`.

mod body;
mod fault;
mod figures;
mod grid;
mod limits;
mod rolls;
mod space;
pub(crate) mod strip;
mod sweep;
mod verdict;

pub use body::RollingBody;
pub use fault::{DEEPEST, TrackFault};
pub(crate) use fault::{FlowOfPass, NOTHING, excess};
pub(crate) use figures::work_along;
pub use figures::{AtDepth, Outlet, PassStrain, rolling_force};
pub(crate) use grid::live_columns;
pub use grid::{LineFlexibility, TRACK_LENGTH, TrackGrid};
pub use limits::TrackLimits;
pub use rolls::Rolls;
pub use space::{TrackSpace, TrackWork};
pub use verdict::Verdict;
