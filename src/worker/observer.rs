//! The solver's only link to the outside: it owns the job's clock, passes progress on and says when to stop.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use tokio::sync::mpsc::UnboundedSender;

use super::supervise::Message;
use crate::jobs::{IterationRecord, check_finite};
use crate::solve::{Interrupt, Observer};

/// The wish that a solve stop, shared between its supervisor and its thread.
#[derive(Debug, Clone, Default)]
pub(super) struct StopFlag(Arc<AtomicBool>);

impl StopFlag {
    pub(super) fn raise(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    fn is_raised(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Watches one solve.
pub(super) struct JobObserver {
    started: Instant,
    timeout: Duration,
    stop: StopFlag,
    messages: UnboundedSender<Message>,
    interrupt: Option<Interrupt>,
}

impl JobObserver {
    /// Starts the job's clock.
    pub(super) fn start(timeout: Duration, stop: StopFlag, messages: UnboundedSender<Message>) -> Self {
        Self { started: Instant::now(), timeout, stop, messages, interrupt: None }
    }

    /// Why the solve was told to stop, if it was.
    pub(super) fn interrupt(&self) -> Option<Interrupt> {
        self.interrupt
    }
}

impl Observer for JobObserver {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        // Progress is for watching: a record that JSON cannot carry is left out, and the report will say why.
        if check_finite(record).is_ok() {
            let _ = self.messages.send(Message::Iteration(record.clone()));
        }
        self.on_checkpoint()
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        let interrupt = if self.stop.is_raised() {
            Interrupt::Cancelled
        } else if self.started.elapsed() >= self.timeout {
            Interrupt::TimedOut
        } else {
            return ControlFlow::Continue(());
        };
        self.interrupt = Some(interrupt);
        ControlFlow::Break(interrupt)
    }

    fn elapsed(&self) -> Duration {
        self.started.elapsed()
    }
}
