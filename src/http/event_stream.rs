//! Follows one job for one client, at the client's pace: nothing is read before it is wanted, so that a client that
//! does not read costs nothing and holds nobody up.

use std::collections::VecDeque;
use std::time::Duration;

use axum::response::sse::Event;
use serde::Serialize;
use tokio::time::sleep;

use super::HttpState;
use super::wire::{JobDocument, Prefix};
use crate::jobs::{JobId, JobRecord, JobState, StoreError, Subscription};

/// Longest time between two looks at the store, should an announcement be lost.
const POLL_INTERVAL: Duration = Duration::from_secs(1);

/// Iterations seen, of which attempt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct EventPosition {
    attempt: u32,
    seen: usize,
}

impl EventPosition {
    /// Reads an event's id; `None` if no event has it.
    pub(super) fn parse(id: &str) -> Option<Self> {
        let mut parts = id.split('-');
        let position = Self { attempt: parts.next()?.parse().ok()?, seen: parts.next()?.parse().ok()? };
        matches!(parts.next(), None | Some("end")).then_some(position)
    }

    /// The id of the last event of a finished job.
    pub(super) fn end_of(record: &JobRecord) -> String {
        format!("{}-{}-end", record.attempts, record.iterations)
    }

    fn id(self) -> String {
        format!("{}-{}", self.attempt, self.seen)
    }
}

/// One client's view of a job.
pub(super) struct EventStream {
    state: HttpState,
    job: JobId,
    subscription: Subscription,
    prefix: Prefix,
    position: EventPosition,
    sent_state: Option<(JobState, u32, bool)>,
    events: VecDeque<Event>,
    ended: bool,
}

impl EventStream {
    /// From `place` on, or from the beginning.
    pub(super) fn new(state: HttpState, job: JobId, position: Option<EventPosition>, prefix: Prefix) -> Self {
        let (subscription, position) = (state.jobs.subscribe(job), position.unwrap_or_default());
        Self {
            state,
            job,
            subscription,
            prefix,
            position,
            sent_state: None,
            events: VecDeque::new(),
            ended: false,
        }
    }

    /// The next event; `None` after the last.
    pub(super) async fn next(&mut self) -> Option<Event> {
        loop {
            if let Some(event) = self.events.pop_front() {
                return Some(event);
            }
            if self.ended {
                return None;
            }
            if let Err(error) = self.poll().await {
                // The stream breaks off; the client comes back to where it was.
                tracing::debug!(job = %self.job, %error, "stopped following");
                return None;
            }
            if self.events.is_empty() {
                tokio::select! {
                    _ = self.subscription.changed() => {}
                    () = sleep(POLL_INTERVAL) => {}
                    () = self.state.closing.cancelled() => return None,
                }
            }
        }
    }

    /// Asks the store what is new.
    async fn poll(&mut self) -> Result<(), StoreError> {
        let mut record = self.state.jobs.get(self.job).await?;
        if record.attempts != self.position.attempt || record.iterations < self.position.seen {
            self.position = EventPosition { attempt: record.attempts, seen: 0 };
        }
        let mut iterations = Vec::new();
        if record.iterations > self.position.seen {
            iterations = self.state.jobs.history(self.job, self.position.seen).await?;
            record = self.state.jobs.get(self.job).await?;
            if record.attempts != self.position.attempt {
                return Ok(());
            }
            iterations.truncate(record.iterations.saturating_sub(self.position.seen));
        }
        let finished = record.state.is_finished();
        if !finished {
            self.send_state(&record, None).await?;
        }
        for iteration in &iterations {
            self.position.seen += 1;
            self.events.extend(event("iteration", iteration).map(|event| event.id(self.position.id())));
        }
        // Written in one step with the last iterations; whatever came between is fetched by the next look.
        if finished && (iterations.is_empty() || self.position.seen >= record.iterations) {
            self.send_state(&record, Some(EventPosition::end_of(&record))).await?;
            self.ended = true;
        }
        Ok(())
    }

    async fn send_state(&mut self, record: &JobRecord, id: Option<String>) -> Result<(), StoreError> {
        let now = (record.state, record.attempts, record.cancel_requested);
        if self.sent_state.replace(now) != Some(now) {
            let job = JobDocument::of(&self.state, record.clone(), &self.prefix).await?;
            self.events.extend(event("state", &job).map(|event| match id {
                Some(id) => event.id(id),
                None => event,
            }));
        }
        Ok(())
    }
}

fn event<T: Serialize>(name: &str, data: &T) -> Option<Event> {
    let event = Event::default().event(name).json_data(data);
    event.inspect_err(|error| tracing::error!(%error, "an event has no JSON form")).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_are_read_as_they_are_written() {
        let position = EventPosition { attempt: 2, seen: 17 };
        assert_eq!(EventPosition::parse(&position.id()), Some(position));
        assert_eq!(EventPosition::parse("2-17-end"), Some(position));
        for noise in ["", "2", "2-x", "-1-2", "2-17-begin"] {
            assert_eq!(EventPosition::parse(noise), None, "{noise:?}");
        }
    }
}
