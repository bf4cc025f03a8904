//! The metrics in Prometheus's text format.

use std::sync::Arc;
use std::time::Duration;

use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::http::{HeaderName, StatusCode};
use axum::routing::get;
use axum::{Json, Router};
use metrics_exporter_prometheus::PrometheusHandle;
use serde_json::json;

use crate::jobs::{self, JobStore};

/// The text of `GET /metrics`, and its media type.
pub(super) type Exposition = ([(HeaderName, &'static str); 1], String);

/// The sources of the metrics.
#[derive(Clone)]
pub struct Metrics {
    collected: PrometheusHandle,
    store: Arc<dyn JobStore>,
}

impl Metrics {
    /// Metrics of this process and of the queue of a store.
    pub fn new(collected: PrometheusHandle, store: Arc<dyn JobStore>) -> Self {
        Self { collected, store }
    }

    /// Renders the present values.
    pub(super) async fn show(&self) -> Exposition {
        let counts = self.store.counts().await;
        if let Err(error) = &counts {
            tracing::warn!(
                error = error as &dyn std::error::Error,
                "the queue cannot be measured"
            );
        }
        jobs::metrics::queue(counts.ok().as_ref());
        ([(CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8")], self.collected.render())
    }
}

/// `GET /livez` of a worker, from whether it lives and the time since the store last answered one
/// of its heartbeats.
pub fn worker_router<F>(life: F) -> Router
where
    F: Fn() -> (bool, Duration) + Clone + Send + Sync + 'static,
{
    let livez = move || async move {
        let (is_alive, age) = life();
        let (code, status) = if is_alive {
            (StatusCode::OK, "alive")
        } else {
            (StatusCode::SERVICE_UNAVAILABLE, "still")
        };
        (code, Json(json!({"status": status, "heartbeat_age_seconds": age.as_secs()})))
    };
    Router::new().route("/livez", get(livez))
}

/// `GET /metrics` alone, for a port of its own.
pub fn metrics_router(metrics: Metrics) -> Router {
    Router::new()
        .route("/metrics", get(async |State(metrics): State<Metrics>| metrics.show().await))
        .with_state(metrics)
}
