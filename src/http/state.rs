//! Bounds of the interface, and the state that the handlers share.

use std::sync::Arc;
use std::time::Duration;

use axum::extract::FromRef;
use axum::http::HeaderValue;
use tokio_util::sync::CancellationToken;

use super::allowed_hosts::AllowedHosts;
use super::bodies::{BODIES_OF_KEY, Bodies};
use super::client_address::Network;
use super::guide::Guide;
use super::listen::ConnectionTimeouts;
use super::metrics::Metrics;
use super::rates::Rates;
use super::streams::EventStreamLimit;
use crate::jobs::{JobService, KeyId, OnceKey, Retention, Turn, Turns};
use crate::webhook::CallbackRules;

/// Bounds on a single request.
#[derive(Debug, Clone, PartialEq)]
pub struct HttpSettings {
    /// Largest body.
    pub max_body_bytes: usize,
    /// Longest time a body may take to arrive.
    pub body_timeout: Duration,
    /// Timeouts of slow connections.
    pub timeouts: ConnectionTimeouts,
    /// Most connections at a time.
    pub connections: usize,
    /// Most event streams open at a time.
    pub event_streams: usize,
    /// Longest time `POST /v1/solve` waits for its result.
    pub solve_limit: Duration,
    /// Longest time `?wait=` waits.
    pub wait_limit: Duration,
    /// Whether requests under `/v1` need an API key.
    pub require_api_key: bool,
    /// The key of this process, if it has one; the keys of the store are then ignored.
    pub once_key: Option<OnceKey>,
    /// Jobs that an API key may submit per second.
    pub jobs_per_second: Option<f64>,
    /// Origins whose pages may send requests (CORS); `*` allows all.
    pub cors_origins: Vec<HeaderValue>,
    /// Where people reach the page, as far as it is told.
    pub public_origin: Option<HeaderValue>,
    /// Proxies whose `X-Forwarded-For` is believed.
    pub trusted_proxies: Vec<Network>,
    /// How long finished jobs are kept.
    pub retention: Retention,
    /// Capacity of this node.
    pub capacity: Capacity,
}

/// Capacity of a node.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Capacity {
    /// Jobs solved here at the same time.
    pub solvers: usize,
    /// Memory \[bytes\] they may need together.
    pub memory_bytes: u64,
    /// Most jobs that may wait.
    pub queued_jobs: usize,
    /// Longest time \[s\] a job may be solved for.
    pub job_seconds: f64,
}

impl Default for HttpSettings {
    fn default() -> Self {
        Self {
            max_body_bytes: 1 << 20,
            body_timeout: Duration::from_secs(30),
            timeouts: ConnectionTimeouts {
                head: Duration::from_secs(30),
                write: Duration::from_secs(30),
            },
            connections: 4000,
            event_streams: 1000,
            solve_limit: Duration::from_secs(30),
            wait_limit: Duration::from_mins(1),
            require_api_key: false,
            once_key: None,
            jobs_per_second: None,
            cors_origins: Vec::new(),
            public_origin: None,
            trusted_proxies: Vec::new(),
            retention: Retention::default(),
            capacity: Capacity::default(),
        }
    }
}

/// State that the handlers share.
#[derive(Clone)]
pub struct HttpState {
    /// Operations on jobs.
    pub jobs: Arc<JobService>,
    /// Bounds.
    pub settings: HttpSettings,
    /// Rules for `callback_url`.
    pub callbacks: Arc<CallbackRules>,
    /// Accepted host names.
    pub hosts: Arc<AllowedHosts>,
    /// Served at `/guide/`.
    pub guide: Arc<Guide>,
    /// Cancelled before connections close, to end event streams.
    pub closing: CancellationToken,
    pub(super) rates: Arc<Rates>,
    pub(super) streams: Arc<EventStreamLimit>,
    pub(super) bodies: Bodies,
    pub(super) sending: Arc<Turns>,
    pub(super) metrics: Option<Metrics>,
}

impl HttpState {
    /// Makes the shared state of the handlers. `metrics` are served at `/metrics`.
    pub fn new(jobs: Arc<JobService>, settings: HttpSettings, metrics: Option<Metrics>) -> Self {
        let rates = Arc::new(Rates::new(settings.jobs_per_second));
        let streams = Arc::new(EventStreamLimit::new(settings.event_streams));
        let bodies = Bodies::new(settings.max_body_bytes);
        Self {
            jobs,
            settings,
            bodies,
            sending: Arc::new(Turns::new(BODIES_OF_KEY)),
            callbacks: Arc::default(),
            hosts: Arc::default(),
            guide: Arc::default(),
            closing: CancellationToken::new(),
            rates,
            streams,
            metrics,
        }
    }

    /// Waits for a turn of a key to send a result. Each turn holds a piece of a result in memory
    /// until its client has read it.
    pub(super) fn turn(&self, key: Option<KeyId>) -> impl Future<Output = Turn> + Send + use<> {
        let sending = Arc::clone(&self.sending);
        async move { sending.take(key).await }
    }
}

impl FromRef<HttpState> for Arc<Guide> {
    fn from_ref(state: &HttpState) -> Self {
        Self::clone(&state.guide)
    }
}
