//! Follows one job for one client, at the client's pace: nothing is read before it is wanted, so that a client that
//! does not read costs nothing and holds nobody up.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Duration;

use axum::response::sse::Event;
use serde::Serialize;
use tokio::time::sleep;
use tokio_util::sync::CancellationToken;

use super::wire::JobDocument;
use crate::jobs::{Desk, JobId, JobRecord, JobState, StoreError, Watch};

/// Longest time between two looks at the store, should an announcement be lost.
const LOOK_AGAIN: Duration = Duration::from_secs(1);

/// Iterations seen, of which attempt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Place {
    attempt: u32,
    seen: usize,
}

impl Place {
    /// Reads an event's id; `None` if no event has it.
    pub(super) fn parse(id: &str) -> Option<Self> {
        let mut parts = id.split('-');
        let place = Self { attempt: parts.next()?.parse().ok()?, seen: parts.next()?.parse().ok()? };
        matches!(parts.next(), None | Some("end")).then_some(place)
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
pub(super) struct Follower {
    desk: Arc<Desk>,
    job: JobId,
    watch: Watch,
    closing: CancellationToken,
    place: Place,
    told: Option<(JobState, u32, bool)>,
    events: VecDeque<Event>,
    ended: bool,
}

impl Follower {
    /// From `place` on, or from the beginning.
    pub(super) fn new(desk: Arc<Desk>, job: JobId, place: Option<Place>, closing: CancellationToken) -> Self {
        let (watch, place) = (desk.watch(job), place.unwrap_or_default());
        Self { desk, job, watch, closing, place, told: None, events: VecDeque::new(), ended: false }
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
            if let Err(error) = self.look().await {
                // The stream breaks off; the client comes back to where it was.
                tracing::debug!(job = %self.job, %error, "stopped following");
                return None;
            }
            if self.events.is_empty() {
                tokio::select! {
                    _ = self.watch.changed() => {}
                    () = sleep(LOOK_AGAIN) => {}
                    () = self.closing.cancelled() => return None,
                }
            }
        }
    }

    /// Asks the store what is new.
    async fn look(&mut self) -> Result<(), StoreError> {
        let mut record = self.desk.get(self.job).await?;
        if record.attempts != self.place.attempt || record.iterations < self.place.seen {
            self.place = Place { attempt: record.attempts, seen: 0 };
        }
        let mut iterations = Vec::new();
        if record.iterations > self.place.seen {
            iterations = self.desk.history(self.job, self.place.seen).await?;
            record = self.desk.get(self.job).await?;
            if record.attempts != self.place.attempt {
                return Ok(());
            }
            iterations.truncate(record.iterations.saturating_sub(self.place.seen));
        }
        let finished = record.state.is_finished();
        if !finished {
            self.tell_state(&record, None);
        }
        for iteration in &iterations {
            self.place.seen += 1;
            self.events.extend(event("iteration", iteration).map(|event| event.id(self.place.id())));
        }
        // Written in one step with the last iterations; whatever came between is fetched by the next look.
        if finished && (iterations.is_empty() || self.place.seen >= record.iterations) {
            self.tell_state(&record, Some(Place::end_of(&record)));
            self.ended = true;
        }
        Ok(())
    }

    fn tell_state(&mut self, record: &JobRecord, id: Option<String>) {
        let now = (record.state, record.attempts, record.cancel_requested);
        if self.told.replace(now) != Some(now) {
            let state = event("state", &JobDocument::from(record.clone()));
            self.events.extend(state.map(|event| match id {
                Some(id) => event.id(id),
                None => event,
            }));
        }
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
    fn places_are_read_as_they_are_written() {
        let place = Place { attempt: 2, seen: 17 };
        assert_eq!(Place::parse(&place.id()), Some(place));
        assert_eq!(Place::parse("2-17-end"), Some(place));
        for noise in ["", "2", "2-x", "-1-2", "2-17-begin"] {
            assert_eq!(Place::parse(noise), None, "{noise:?}");
        }
    }
}
