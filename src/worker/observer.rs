//! The observer of a solve: it measures the job's time, forwards progress and tells the solver
//! when to stop.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use tokio::sync::mpsc::UnboundedSender;

use super::memory::JobMemory;
use super::message::Message;
use super::thread::{LONG, give_way};
use crate::jobs::{IterationRecord, encode};
use brinell_solver::solver::{Held, Interrupt, Observer};

/// Shortest time between two messages about progress. Each message wakes the supervisor, which
/// costs as much as some iterations of a short job. A job that ends sooner sends its iterations
/// with its outcome.
const SEND_INTERVAL: Duration = Duration::from_millis(50);

/// A flag that stops a solve, shared between its supervisor and its thread.
#[derive(Debug, Clone, Default)]
pub(super) struct StopFlag(Arc<AtomicBool>);

impl StopFlag {
    pub(super) fn raise(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    pub(super) fn is_raised(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Observes one solve on behalf of its supervisor.
pub(super) struct JobObserver {
    started: Instant,
    timeout: Duration,
    stop: StopFlag,
    messages: UnboundedSender<Message>,
    interrupt: Option<Interrupt>,
    pending: Vec<IterationRecord>,
    has_iterated: bool,
    n_preliminary: usize,
    preliminary: Option<IterationRecord>,
    sent_at: Duration,
    gives_way: bool,
    memory: JobMemory,
    out_of_memory: Option<String>,
}

impl JobObserver {
    /// Starts the job's clock.
    pub(super) fn start(
        timeout: Duration,
        memory: JobMemory,
        stop: StopFlag,
        messages: UnboundedSender<Message>,
    ) -> Self {
        Self {
            started: Instant::now(),
            timeout,
            stop,
            messages,
            interrupt: None,
            pending: Vec::new(),
            has_iterated: false,
            n_preliminary: 0,
            preliminary: None,
            sent_at: Duration::ZERO,
            gives_way: false,
            memory,
            out_of_memory: None,
        }
    }

    /// Takes the iterations that have not been sent.
    pub(super) fn take_pending(&mut self) -> Vec<IterationRecord> {
        std::mem::take(&mut self.pending)
    }

    fn send_progress(&mut self) {
        let now = self.started.elapsed();
        if now.saturating_sub(self.sent_at) < SEND_INTERVAL {
            return;
        }
        let message = if self.pending.is_empty() {
            self.preliminary.take().filter(|it| encode(it).is_ok()).map(Message::Preliminary)
        } else {
            Some(Message::Iterations(self.take_pending()))
        };
        if let Some(message) = message {
            self.sent_at = now;
            let _ = self.messages.send(message);
        }
    }

    /// Returns the excess of memory that stopped the solve, if one did.
    pub(super) fn out_of_memory(&mut self) -> Option<String> {
        self.out_of_memory.take()
    }

    /// Returns why the solve was stopped, if it was.
    pub(super) fn interrupt(&self) -> Option<Interrupt> {
        self.interrupt
    }
}

impl Observer for JobObserver {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        // Progress is informative: a record that JSON cannot represent is left out, and the report
        // will give the reason.
        if encode(record).is_ok() {
            self.pending.push(record.clone());
        }
        self.has_iterated = true;
        self.preliminary = None;
        self.on_checkpoint()
    }

    fn on_preliminary_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        // Each increment counts anew; who watches the job sees that it goes on.
        self.n_preliminary += 1;
        let iteration = self.n_preliminary;
        self.preliminary =
            (!self.has_iterated).then(|| IterationRecord { iteration, ..record.clone() });
        self.on_checkpoint()
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.send_progress();
        if !self.gives_way && self.started.elapsed() >= LONG {
            self.gives_way = true;
            give_way();
        }
        let interrupt = if self.stop.is_raised() || self.out_of_memory.is_some() {
            Interrupt::Cancelled
        } else if self.started.elapsed() >= self.timeout {
            Interrupt::TimedOut
        } else {
            return ControlFlow::Continue(());
        };
        self.interrupt = Some(interrupt);
        ControlFlow::Break(interrupt)
    }

    fn on_held(&mut self, part: Held, bytes: usize) -> ControlFlow<Interrupt> {
        if let Err(reason) = self.memory.hold(part, bytes as u64) {
            self.out_of_memory = Some(reason);
        }
        self.on_checkpoint()
    }

    fn elapsed(&self) -> Duration {
        self.started.elapsed()
    }
}
