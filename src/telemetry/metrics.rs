//! Collection of metrics and their export to Prometheus.

use std::sync::OnceLock;

use metrics::{Unit, describe_counter, describe_gauge, describe_histogram, gauge};
use metrics_exporter_prometheus::{BuildError, Matcher, PrometheusBuilder, PrometheusHandle};

use crate::http::{EVENT_STREAMS, REQUEST_DURATION};
use crate::jobs::metrics as job_metrics;
use crate::webhook::DELIVERIES;

/// Upper bounds \[s\] of the buckets of durations: from a millisecond to ten minutes.
const SECONDS: [f64; 16] = [
    0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 15.0, 60.0, 180.0,
    600.0,
];

/// Upper bounds of the buckets of iteration counts.
const ITERATIONS: [f64; 9] = [1.0, 5.0, 10.0, 20.0, 30.0, 50.0, 100.0, 200.0, 500.0];

/// Starts the recorder once for the process. The returned handle renders the metrics.
pub fn collect() -> PrometheusHandle {
    static HANDLE: OnceLock<PrometheusHandle> = OnceLock::new();
    HANDLE.get_or_init(install).clone()
}

fn install() -> PrometheusHandle {
    let builder = with_buckets().unwrap_or_else(|error| {
        tracing::error!(%error, "histograms without buckets");
        PrometheusBuilder::new()
    });
    let recorder = builder.build_recorder();
    let handle = recorder.handle();
    if metrics::set_global_recorder(recorder).is_err() {
        tracing::error!("something else collects metrics in this process");
    }
    describe();
    gauge!("brinell_build_info", "version" => env!("CARGO_PKG_VERSION")).set(1.0);
    handle
}

fn with_buckets() -> Result<PrometheusBuilder, BuildError> {
    let durations = [job_metrics::QUEUE_WAIT, job_metrics::SOLVE_DURATION, REQUEST_DURATION];
    let builder = durations.into_iter().try_fold(PrometheusBuilder::new(), |builder, name| {
        builder.set_buckets_for_metric(Matcher::Full(name.to_owned()), &SECONDS)
    })?;
    builder.set_buckets_for_metric(
        Matcher::Full(job_metrics::SOLVER_ITERATIONS.to_owned()),
        &ITERATIONS,
    )
}

fn describe() {
    describe_gauge!("brinell_build_info", "Always 1; the label has the version.");
    describe_gauge!(job_metrics::QUEUE_DEPTH, "Jobs waiting, of all nodes that share the queue.");
    describe_gauge!(
        job_metrics::JOBS_RUNNING,
        "Jobs being solved, of all nodes that share the queue."
    );
    describe_histogram!(
        job_metrics::QUEUE_WAIT,
        Unit::Seconds,
        "Time between acceptance and the first attempt."
    );
    describe_histogram!(job_metrics::SOLVE_DURATION, Unit::Seconds, "Time of an attempt.");
    describe_counter!(
        job_metrics::JOBS_TOTAL,
        "Attempts by outcome: the job's final state, or released."
    );
    describe_histogram!(job_metrics::SOLVER_ITERATIONS, "Iterations of an attempt.");
    describe_counter!(
        job_metrics::FACTOR_CACHE_LOOKUPS,
        "Bodies that a job needed, by outcome: hit if kept from an earlier job."
    );
    describe_gauge!(
        job_metrics::FACTOR_CACHE_BYTES,
        Unit::Bytes,
        "Memory of bodies and factors kept for later jobs."
    );
    describe_histogram!(
        REQUEST_DURATION,
        Unit::Seconds,
        "Time from a request's head to its answer's, by route; waits that the client asked for \
         included."
    );
    describe_counter!(DELIVERIES, "Attempts to announce the end of a job, by outcome.");
    describe_gauge!(EVENT_STREAMS, "Event streams that are open.");
}
