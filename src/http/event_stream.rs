//! Events of one job for one client. The stream reads a page of the history only when the client
//! has taken the last one: a client that does not read occupies little memory and no connection to
//! the database.

use axum::response::sse::Event;
use serde::Serialize;
use tokio::sync::mpsc::Sender;
use tokio::time::sleep;

use super::HttpState;
use super::prefix::Prefix;
use super::wire::JobDocument;
use crate::jobs::{
    IterationRecord, JobId, JobRecord, JobState, NumberedIteration, POLL_INTERVAL, StoreError,
    Subscription,
};

/// Number of iterations sent, and their attempt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct EventPosition {
    attempt: u32,
    seen: usize,
}

impl EventPosition {
    /// Parses an event's id; `None` if it is none.
    pub(super) fn parse(id: &str) -> Option<Self> {
        let mut parts = id.split('-');
        let position =
            Self { attempt: parts.next()?.parse().ok()?, seen: parts.next()?.parse().ok()? };
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

/// Sends the events of a job to one client. It holds one page of iterations, and no connection to
/// the database, while it waits for the client.
pub(super) struct Follower {
    state: HttpState,
    job: JobId,
    subscription: Subscription,
    prefix: Prefix,
    position: EventPosition,
    sent_state: Option<(JobState, u32, bool, Option<IterationRecord>)>,
    events: Sender<Event>,
}

impl Follower {
    /// From `position` on, or from the beginning.
    pub(super) fn new(
        state: HttpState,
        job: JobId,
        position: Option<EventPosition>,
        prefix: Prefix,
        events: Sender<Event>,
    ) -> Self {
        let (subscription, position) = (state.jobs.subscribe(job), position.unwrap_or_default());
        Self { state, job, subscription, prefix, position, sent_state: None, events }
    }

    /// Follows the job to its end. If the store does not answer, the client waits; if a row is
    /// damaged, the stream breaks off.
    pub(super) async fn run(mut self) -> Result<(), StoreError> {
        let closing = self.state.closing.clone();
        loop {
            match self.look().await {
                Ok(true) => break,
                Ok(false) | Err(StoreError::Unavailable(_)) => {}
                Err(error) => return Err(error),
            }
            tokio::select! {
                _ = self.subscription.changed() => {}
                () = sleep(POLL_INTERVAL) => {}
                () = closing.cancelled() => break,
            }
        }
        Ok(())
    }

    /// Sends new events; returns whether the job has ended.
    async fn look(&mut self) -> Result<bool, StoreError> {
        loop {
            let record = self.record().await?;
            if record.attempts != self.position.attempt || record.iterations < self.position.seen {
                self.position = EventPosition { attempt: record.attempts, seen: 0 };
            }
            let finished = record.state.is_finished();
            if !finished {
                self.send_state(&record, None).await?;
            }
            let is_behind = record.iterations > self.position.seen;
            if is_behind && self.send_page().await? {
                continue;
            }
            if finished {
                self.send_state(&record, Some(EventPosition::end_of(&record))).await?;
            }
            return Ok(finished);
        }
    }

    /// Sends a page of iterations; `false` if there is none.
    async fn send_page(&mut self) -> Result<bool, StoreError> {
        let turn = self.state.streams.turn().await;
        let page = self.state.jobs.store().history(self.job, self.position.seen).await?;
        drop(turn);
        if self.record().await?.attempts != self.position.attempt {
            return Ok(true);
        }
        for NumberedIteration { number, record } in &page {
            self.position.seen = number + 1;
            self.send(event("iteration", record).map(|event| event.id(self.position.id()))).await;
        }
        Ok(!page.is_empty())
    }

    async fn record(&self) -> Result<JobRecord, StoreError> {
        let _turn = self.state.streams.turn().await;
        self.state.jobs.get(self.job).await
    }

    async fn send_state(
        &mut self,
        record: &JobRecord,
        id: Option<String>,
    ) -> Result<(), StoreError> {
        let preliminary = record.latest.clone().filter(|_| record.iterations == 0);
        let now = (record.state, record.attempts, record.cancel_requested, preliminary);
        if self.sent_state.as_ref() != Some(&now) {
            let turn = self.state.streams.turn().await;
            let job = JobDocument::of(&self.state, record.clone(), &self.prefix).await?;
            drop(turn);
            let event = event("state", &job).map(|event| match id {
                Some(id) => event.id(id),
                None => event,
            });
            self.send(event).await;
            self.sent_state = Some(now);
        }
        Ok(())
    }

    /// Waits until the client takes an event. The task ends when the client has gone.
    async fn send(&self, event: Option<Event>) {
        if let Some(event) = event {
            let _ = self.events.send(event).await;
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
    fn positions_are_read_as_they_are_written() {
        let position = EventPosition { attempt: 2, seen: 17 };
        assert_eq!(EventPosition::parse(&position.id()), Some(position));
        assert_eq!(EventPosition::parse("2-17-end"), Some(position));
        for noise in ["", "2", "2-x", "-1-2", "2-17-begin"] {
            assert_eq!(EventPosition::parse(noise), None, "{noise:?}");
        }
    }
}
