//! Work that takes seconds on large grids, and whoever may end it early.

use thiserror::Error;

/// Says whether to stop; long work asks again and again.
pub type Stop<'a> = dyn FnMut() -> bool + 'a;

/// Work was ended before its end; what it was to write is unfinished.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("stopped")]
pub struct Stopped;

/// Asks whether to stop.
pub(crate) fn ask(stop: &mut Stop<'_>) -> Result<(), Stopped> {
    if stop() { Err(Stopped) } else { Ok(()) }
}
