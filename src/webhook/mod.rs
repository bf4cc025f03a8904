//! Tells receivers that jobs have ended (webhooks).
//!
//! The store keeps each announcement beside its job from the submission on; the transaction that
//! ends the job makes the announcement due. A process leases an announcement for one attempt. If
//! the process dies, the lease expires and the attempt is repeated: every announcement is
//! delivered at least once, always with the same id. Failed attempts are repeated with growing
//! pauses for about a day.

mod notice;
mod receivers;
mod rules;
mod signature;

use std::sync::Arc;
use std::time::Duration;

use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode};
use metrics::counter;
use tokio::task::JoinSet;
use tokio::time::{Instant, sleep_until, timeout};
use tracing::Instrument;
use tracing::field::Empty;
use uuid::Uuid;

use crate::jobs::{
    Clock, Delivery, DeliveryEnd, DeliveryStore, JobNotifier, JobStore, StoreError, SystemClock,
    TraceParent,
};
use crate::outgoing::Client;
use crate::telemetry;
use notice::Notice;
use receivers::{ATTEMPT, LEASE, Postponed, Receiver, Receivers};
pub use rules::CallbackRules;
pub use signature::WebhookSecret;
use signature::signatures;

/// Attempts by outcome.
pub const DELIVERIES: &str = "brinell_webhook_deliveries_total";

/// Time between two queries for due announcements: when the last query found none, and when it
/// found more than there was room for.
const POLL: Duration = Duration::from_secs(1);
const POLL_SOON: Duration = Duration::from_millis(100);

/// Pause behind the end of a job, in which further ones may end.
const SOON: Duration = Duration::from_millis(20);

/// Pauses after failed attempts, in units of the first pause; there is one more attempt than
/// pauses.
const PAUSES: [u32; 8] = [1, 6, 24, 120, 720, 2160, 5760, 8640];

/// Longest description of a failed attempt.
const ERROR: usize = 200;

/// Everything that announcing needs.
pub struct Announcer {
    /// Jobs.
    pub jobs: Arc<dyn JobStore>,
    /// Tells of the ends of jobs.
    pub notifier: Arc<JobNotifier>,
    /// The announcements.
    pub deliveries: Arc<dyn DeliveryStore>,
    /// The hosts that may be called.
    pub rules: Arc<CallbackRules>,
    /// The HTTP client.
    pub client: Client,
    /// The secrets that sign announcements.
    pub secrets: Vec<WebhookSecret>,
    /// Pause after the first failed attempt.
    pub pause: Duration,
}

impl Announcer {
    /// Delivers due announcements, for ever.
    pub async fn run(self: Arc<Self>) {
        let mut attempts: JoinSet<(Receiver, Duration)> = JoinSet::new();
        let mut receivers = Receivers::default();
        let mut look_at = Instant::now();
        loop {
            let mut postponed = Vec::new();
            while let Some(Ok((receiver, took))) = attempts.try_join_next() {
                postponed.extend(receivers.ended(&receiver, took));
            }
            if look_at <= Instant::now() {
                let room = receivers.room();
                let due = if room == 0 { Vec::new() } else { self.due(room).await };
                let mut pause = match (room, due.len()) {
                    (0, _) => POLL_SOON,
                    (_, 0) => POLL,
                    _ => Duration::ZERO,
                };
                for delivery in due {
                    let host =
                        self.rules.check(&delivery.url).map(|to| to.host).unwrap_or_default();
                    if let Some(one) = receivers.offer((host, delivery.submitter), delivery) {
                        postponed.push(one);
                        pause = POLL_SOON;
                    }
                }
                look_at = Instant::now() + pause;
            }
            self.postpone(postponed).await;
            while let Some((receiver, delivery)) = receivers.next() {
                let (announcer, begin) = (Arc::clone(&self), Instant::now());
                attempts.spawn(async move {
                    announcer.deliver(&delivery).await;
                    (receiver, begin.elapsed())
                });
            }
            tokio::select! {
                () = sleep_until(look_at) => {}
                () = self.notifier.ended(), if look_at > Instant::now() + POLL_SOON => {
                    look_at = Instant::now() + SOON;
                }
                Some(Ok((receiver, took))) = attempts.join_next() => {
                    self.postpone(receivers.ended(&receiver, took)).await;
                }
            }
        }
    }

    /// Claims due announcements, at most `limit` of them.
    async fn due(&self, limit: usize) -> Vec<Delivery> {
        self.deliveries.claim_deliveries(limit, LEASE).await.unwrap_or_else(|error| {
            tracing::warn!(
                error = &error as &dyn std::error::Error,
                "cannot look for announcements"
            );
            Vec::new()
        })
    }

    async fn postpone(&self, postponed: Vec<Postponed>) {
        if postponed.is_empty() {
            return;
        }
        let ends = postponed
            .into_iter()
            .map(|(delivery, retry)| (delivery, DeliveryEnd::Postponed { retry }));
        self.end(ends.collect()).await;
    }

    async fn deliver(&self, delivery: &Delivery) {
        let Delivery { job, id, .. } = delivery;
        let span = tracing::info_span!("webhook", %job, delivery = %id, trace_id = Empty);
        let trace = telemetry::adopt(&span, delivery.trace);
        let end = self.attempt(delivery, trace).instrument(span.clone()).await;
        let outcome = match &end {
            DeliveryEnd::Delivered { .. } => "delivered",
            DeliveryEnd::Failed { retry: Some(_), .. } => "retried",
            DeliveryEnd::Failed { retry: None, .. } => "given_up",
            DeliveryEnd::Postponed { .. } => "postponed",
        };
        counter!(DELIVERIES, "outcome" => outcome).increment(1);
        tracing::info!(parent: &span, attempt = delivery.attempt, outcome, ?end, "announced");
        self.end(vec![(delivery.clone(), end)]).instrument(span).await;
    }

    async fn end(&self, ends: Vec<(Delivery, DeliveryEnd)>) {
        if let Err(error) = self.deliveries.end_deliveries(&ends).await {
            let (error, attempts) = (&error as &dyn std::error::Error, ends.len());
            tracing::warn!(
                attempts,
                error,
                "the ends of attempts were not written; they will be made again"
            );
        }
    }

    async fn attempt(&self, delivery: &Delivery, trace: Option<TraceParent>) -> DeliveryEnd {
        let failed = |status: Option<u16>, error: String| {
            let error = error.chars().take(ERROR).collect();
            DeliveryEnd::Failed {
                status,
                error,
                retry: pause_behind(delivery.attempt, self.pause),
            }
        };
        let to = match self.rules.check(&delivery.url) {
            Ok(to) => to,
            Err(detail) => return failed(None, format!("the address {detail}")),
        };
        let record = match self.jobs.get(delivery.job).await {
            Ok(record) => record,
            // The announcement was removed together with its job.
            Err(StoreError::NotFound) => return failed(None, "the job was removed".to_owned()),
            Err(_) => return DeliveryEnd::Postponed { retry: POLL },
        };
        let Ok(body) = serde_json::to_vec(&Notice::of(record)) else {
            return failed(None, "the announcement cannot be written".to_owned());
        };
        let headers = self.headers(delivery, trace, &body);
        match timeout(ATTEMPT, self.client.post(&to, headers, body.into())).await {
            Ok(Ok(status)) if status.is_success() => {
                DeliveryEnd::Delivered { status: status.as_u16() }
            }
            Ok(Ok(StatusCode::GONE)) => {
                let error = "the receiver wants no more".to_owned();
                DeliveryEnd::Failed { status: Some(StatusCode::GONE.as_u16()), error, retry: None }
            }
            Ok(Ok(status)) => {
                failed(Some(status.as_u16()), format!("the receiver answered {status}"))
            }
            Ok(Err(error)) => failed(None, error.to_string()),
            Err(_) => failed(None, format!("no answer within {} s", ATTEMPT.as_secs())),
        }
    }

    fn headers(&self, delivery: &Delivery, trace: Option<TraceParent>, body: &[u8]) -> HeaderMap {
        let id = delivery.id.to_string();
        let timestamp = SystemClock.now().as_second();
        let signature = signatures(&self.secrets, &id, timestamp, body);
        let lines = [
            ("content-type", "application/json".to_owned()),
            ("user-agent", concat!("brinell/", env!("CARGO_PKG_VERSION")).to_owned()),
            ("webhook-id", id),
            ("webhook-timestamp", timestamp.to_string()),
            ("webhook-signature", signature),
        ];
        // The span has an id even if no subscriber records it.
        let is_own = trace.map(|trace| trace.span_id) != delivery.trace.map(|trace| trace.span_id);
        let trace = trace.map(|trace| if is_own { trace } else { trace.child() });
        let trace = trace.map(|trace| ("traceparent", trace.to_string()));
        let line = |(name, value): (&'static str, String)| {
            Some((HeaderName::from_static(name), HeaderValue::try_from(value).ok()?))
        };
        lines.into_iter().chain(trace).filter_map(line).collect()
    }
}

/// Returns the pause after an attempt (counted from 1), lengthened at random by up to a fifth so
/// that attempts spread out; `None` after the last.
fn pause_behind(attempt: u32, first: Duration) -> Option<Duration> {
    let index = usize::try_from(attempt.max(1) - 1).ok()?;
    let pause = first * *PAUSES.get(index)?;
    let random = u32::from(Uuid::new_v4().as_bytes()[0]);
    Some(pause + pause * random / (5 * 256))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pauses_grow_and_end() {
        let first = Duration::from_secs(5);
        let pauses: Vec<Duration> =
            (1..).map_while(|attempt| pause_behind(attempt, first)).collect();
        assert_eq!(pauses.len(), PAUSES.len());
        for (pause, units) in pauses.iter().zip(PAUSES) {
            assert!((first * units..=first * units * 6 / 5).contains(pause), "{pause:?}");
        }
        let day: Duration = pauses.iter().sum();
        assert!((Duration::from_hours(24)..Duration::from_hours(30)).contains(&day), "{day:?}");
    }
}
