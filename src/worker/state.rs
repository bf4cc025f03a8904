//! What the tasks of a worker share.

use std::sync::Arc;
use std::time::Duration;

use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

use super::memory::WorkerMemory;
use super::running::{Outage, Pulse, Running};
use super::slots::Slots;
use crate::jobs::{JobNotifier, JobSolver, JobStore, WorkerId};

/// Settings of a worker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WorkerSettings {
    /// Jobs solved at the same time.
    pub slots: usize,
    /// Memory \[bytes\] that large jobs may need together, by their estimates.
    pub memory: u64,
    /// Memory \[bytes\] that each place has in addition.
    pub memory_of_place: u64,
    /// Longest time a job may be solved for.
    pub job_timeout: Duration,
    /// Duration of a lease without a heartbeat. A worker sends three heartbeats in this time.
    pub lease: Duration,
    /// Longest time between two claims; new jobs of this process are announced and claimed at
    /// once.
    pub poll: Duration,
    /// Number of lost workers after which a job fails.
    pub max_attempts: u32,
    /// Whether to solve all queued jobs before stopping, as a store in memory needs.
    pub empties_queue: bool,
}

/// State that the worker's tasks share.
pub(super) struct WorkerState {
    pub(super) id: WorkerId,
    pub(super) settings: WorkerSettings,
    pub(super) store: Arc<dyn JobStore>,
    pub(super) notifier: Arc<JobNotifier>,
    pub(super) solver: Arc<dyn JobSolver>,
    pub(super) slots: Arc<Slots>,
    pub(super) running: Running,
    pub(super) outage: Outage,
    pub(super) pulse: Pulse,
    pub(super) memory: Arc<WorkerMemory>,
    pub(super) tasks: TaskTracker,
    pub(super) drain: CancellationToken,
    pub(super) halt: CancellationToken,
}
