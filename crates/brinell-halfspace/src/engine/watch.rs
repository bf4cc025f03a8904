//! Work on half-spaces that the observer can stop.

use crate::{Stop, Stopped};

use brinell_method::observer::Interrupt;
use brinell_method::phases::Phase;
use brinell_method::run::Run;

/// Never stops a solve.
pub(crate) const fn never() -> bool {
    false
}

/// Does work that the observer can stop, and records its time.
///
/// # Errors
/// [`brinell_method::Error::Interrupted`].
pub(crate) fn watched<T>(
    run: &mut Run<'_>,
    phase: Phase,
    work: impl FnOnce(&mut Stop<'_>) -> Result<T, Stopped>,
) -> Result<T, brinell_method::Error> {
    let mut interrupt = None;
    let done = run.time_observed(phase, |observer| {
        work(&mut || {
            interrupt = observer.on_checkpoint().break_value();
            interrupt.is_some()
        })
    });
    done.map_err(|Stopped| {
        brinell_method::Error::Interrupted(interrupt.unwrap_or(Interrupt::Cancelled))
    })
}
