//! Work on half-spaces that the observer can stop.

use brinell_halfspace::{Stop, Stopped};

use super::method;
use super::method::observer::Interrupt;
use super::method::phases::Phase;
use super::method::run::Run;

/// Never stops a solve.
pub(crate) const fn never() -> bool {
    false
}

/// Does work that the observer can stop, and records its time.
///
/// # Errors
/// [`method::Error::Interrupted`].
pub(crate) fn watched<T>(
    run: &mut Run<'_>,
    phase: Phase,
    work: impl FnOnce(&mut Stop<'_>) -> Result<T, Stopped>,
) -> Result<T, method::Error> {
    let mut interrupt = None;
    let done = run.time_observed(phase, |observer| {
        work(&mut || {
            interrupt = observer.on_checkpoint().break_value();
            interrupt.is_some()
        })
    });
    done.map_err(|Stopped| method::Error::Interrupted(interrupt.unwrap_or(Interrupt::Cancelled)))
}
