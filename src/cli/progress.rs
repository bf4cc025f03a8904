//! One line of progress on a terminal, for work that takes longer than a second.

use std::io::{self, IsTerminal, Write};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use super::table::significant;
use crate::jobs::IterationRecord;
use brinell_solver::solver::{Interrupt, Observer};

/// Work shorter than this shows no progress.
const DELAY: Duration = Duration::from_secs(1);
/// Time between two updates.
const INTERVAL: Duration = Duration::from_millis(100);

/// Introduces iterations that the report does not list.
pub(super) const PRELIMINARY: &str = "preliminary solve, ";

/// An observer that prints progress and times the solve.
pub(super) struct ProgressLine {
    started: Instant,
    shown: Option<Instant>,
    text: String,
    is_terminal: bool,
    delay: Duration,
}

impl ProgressLine {
    pub(super) fn start() -> Self {
        Self {
            started: Instant::now(),
            shown: None,
            text: "preparing".to_owned(),
            is_terminal: io::stderr().is_terminal(),
            delay: DELAY,
        }
    }

    /// Shows progress from the first moment on.
    pub(super) fn impatient() -> Self {
        let mut line = Self::start();
        line.delay = Duration::ZERO;
        line
    }

    /// Shows an iteration, after the words that introduce it.
    pub(super) fn show(&mut self, before: &str, record: &IterationRecord) {
        let increment = record.increment.map_or_else(String::new, |at| {
            let load = if at.loads > 1 {
                format!("load {} of {}, ", at.load, at.loads)
            } else {
                String::new()
            };
            format!("{load}increment {} of {}, ", at.number, at.count)
        });
        self.text = format!(
            "{before}{increment}iteration {}, residual {:.1e}, peak pressure {}",
            record.iteration,
            record.equilibrium_residual,
            significant(record.peak_pressure, 5)
        );
        self.refresh();
    }

    fn refresh(&mut self) {
        let due = self.shown.is_none_or(|shown| shown.elapsed() >= INTERVAL);
        if self.is_terminal && due && self.started.elapsed() >= self.delay {
            self.shown = Some(Instant::now());
            let seconds = self.started.elapsed().as_secs_f64();
            let _ = write!(io::stderr(), "\r\x1b[K{}, {seconds:.1} s", self.text);
        }
    }
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        if self.shown.is_some() {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}

impl Observer for ProgressLine {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.show("", record);
        ControlFlow::Continue(())
    }

    fn on_preliminary_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.show(PRELIMINARY, record);
        ControlFlow::Continue(())
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.refresh();
        ControlFlow::Continue(())
    }

    fn elapsed(&self) -> Duration {
        self.started.elapsed()
    }
}
