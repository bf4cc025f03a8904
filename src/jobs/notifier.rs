//! Notifies subscribers in this process that a job has changed.
//!
//! The store announces every change here after its commit; a store shared by several machines
//! forwards their announcements too. Subscribers then query the store. A signal carries no data,
//! so a slow subscriber needs no buffer and misses nothing: its next query returns the latest
//! state.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::{Notify, watch};

use super::JobId;

/// The changes of a job since the first subscription to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Signal {
    /// Number of changes announced.
    pub changes: u64,
    /// Whether a client asked the job to stop.
    pub cancel_requested: bool,
    /// Whether the job has reached its final state.
    pub finished: bool,
}

/// Announces changes of jobs to subscribers in this process.
#[derive(Debug, Default)]
pub struct JobNotifier {
    jobs: Mutex<HashMap<JobId, watch::Sender<Signal>>>,
    work: Notify,
    ended: Notify,
    of_worker: bool,
}

impl JobNotifier {
    /// Creates a notifier without subscribers.
    pub fn new() -> Arc<Self> {
        Arc::new(Self::default())
    }

    /// Creates the notifier of a process that only solves: of the changes that other processes
    /// make, it needs work and requests to stop.
    pub fn of_worker() -> Arc<Self> {
        Arc::new(Self { of_worker: true, ..Self::default() })
    }

    /// Whether the process only solves.
    pub fn is_of_worker(&self) -> bool {
        self.of_worker
    }

    /// Subscribes to one job. Subscribe first, then query the store: a change between the two is
    /// not missed.
    pub fn subscribe(self: &Arc<Self>, id: JobId) -> Subscription {
        let receiver = self
            .lock()
            .entry(id)
            .or_insert_with(|| watch::Sender::new(Signal::default()))
            .subscribe();
        Subscription { id, receiver, notifier: Arc::clone(self) }
    }

    /// Announces progress of a job.
    pub fn announce_progress(&self, id: JobId) {
        self.announce(id, |_| ());
    }

    /// Announces that a job was asked to stop.
    pub fn announce_cancel(&self, id: JobId) {
        self.announce(id, |signal| signal.cancel_requested = true);
    }

    /// Announces that a job reached its final state.
    pub fn announce_finished(&self, id: JobId) {
        self.ended.notify_one();
        self.announce(id, |signal| signal.finished = true);
    }

    /// Wakes all subscribers to query again, because announcements may have been lost.
    pub fn announce_gap(&self) {
        for sender in self.lock().values() {
            sender.send_modify(|signal| signal.changes += 1);
        }
        self.announce_work();
    }

    /// Announces that a job can be claimed.
    pub fn announce_work(&self) {
        self.work.notify_one();
    }

    /// Waits for [`JobNotifier::announce_work`], and returns at once if it was called since the
    /// last wait. Each process has one waiter.
    pub async fn work(&self) {
        self.work.notified().await;
    }

    /// Waits until a job is announced finished, and returns at once if one was since the last wait.
    /// Each process has one waiter.
    pub async fn ended(&self) {
        self.ended.notified().await;
    }

    fn announce(&self, id: JobId, change: impl FnOnce(&mut Signal)) {
        if let Some(sender) = self.lock().get(&id) {
            sender.send_modify(|signal| {
                signal.changes += 1;
                change(signal);
            });
        }
    }

    fn lock(&self) -> MutexGuard<'_, HashMap<JobId, watch::Sender<Signal>>> {
        self.jobs.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A subscription to the changes of one job.
#[derive(Debug)]
pub struct Subscription {
    id: JobId,
    receiver: watch::Receiver<Signal>,
    notifier: Arc<JobNotifier>,
}

impl Subscription {
    /// Waits for the next change and returns all that has happened so far.
    pub async fn changed(&mut self) -> Signal {
        // The sender lives as long as this receiver does, so waiting cannot fail.
        let _ = self.receiver.changed().await;
        *self.receiver.borrow_and_update()
    }

    /// Waits until the job is announced finished.
    pub async fn finished(&mut self) {
        let _ = self.receiver.wait_for(|signal| signal.finished).await;
    }
}

impl Drop for Subscription {
    fn drop(&mut self) {
        let mut jobs = self.notifier.lock();
        if jobs.get(&self.id).is_some_and(|sender| sender.receiver_count() <= 1) {
            jobs.remove(&self.id);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn changes_between_watching_and_waiting_are_not_missed() {
        let notifier = JobNotifier::new();
        let id = JobId::generate();
        let mut subscription = notifier.subscribe(id);
        notifier.announce_progress(id);
        notifier.announce_cancel(id);
        assert_eq!(
            subscription.changed().await,
            Signal { changes: 2, cancel_requested: true, finished: false }
        );
        notifier.announce_finished(id);
        subscription.finished().await;
    }

    #[tokio::test]
    async fn jobs_without_subscribers_take_no_memory() {
        let notifier = JobNotifier::new();
        let id = JobId::generate();
        let (first, second) = (notifier.subscribe(id), notifier.subscribe(id));
        drop(first);
        assert_eq!(notifier.lock().len(), 1);
        drop(second);
        notifier.announce_finished(id);
        assert!(notifier.lock().is_empty());
    }

    #[tokio::test]
    async fn work_announced_before_anyone_waits_counts() {
        let notifier = JobNotifier::new();
        notifier.announce_work();
        notifier.work().await;
    }
}
