//! The HTTP interface. This module lists the routes; one file in `routes` holds each handler and
//! declares it for [`openapi`].
//!
//! Every error, including errors of the framework and panics, is answered as
//! `application/problem+json` ([`Problem`]). Every answer carries an `x-request-id`, the client's
//! own if it sent one.

mod access;
mod batch;
mod body;
mod client_address;
mod docs;
mod edge;
mod event_stream;
mod examples;
mod export_file;
mod guide;
mod job_path;
mod joined;
mod listen;
mod metrics;
mod negotiation;
pub mod openapi;
mod page;
mod parameters;
mod preference;
mod prefix;
mod problem;
mod problem_type;
mod query;
mod rates;
mod request_log;
mod result_body;
mod routes;
mod selection;
mod streams;
mod tls;
pub mod wire;
mod written_body;

use std::any::Any;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::extract::Request;
use axum::http::{Extensions, HeaderMap, HeaderValue, Method, Uri};
use axum::middleware::{from_fn, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use tokio_util::sync::CancellationToken;
use tower_http::CompressionLevel;
use tower_http::catch_panic::CatchPanicLayer;
use tower_http::compression::CompressionLayer;
use tower_http::compression::predicate::{DefaultPredicate, NotForContentType, Predicate};
use tower_http::cors::{AllowHeaders, AllowOrigin, CorsLayer, ExposeHeaders};
use tower_http::request_id::{MakeRequestUuid, PropagateRequestIdLayer, SetRequestIdLayer};
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::jobs::{JobService, OnceKey, Retention, Turn, Turns};
use crate::webhook::CallbackRules;
use access::{Caller, authenticate};
use body::{BODIES_OF_KEY, Bodies};
use edge::{check_host, drop_unusable_request_id, guard_response};
use negotiation::settle_coding;
use query::refuse_undeclared;
use rates::Rates;
use request_log::log_request;
use result_body::CodingChosen;
use routes::{
    batch_cancel, batch_fetch, batch_submit, cancel_job, delete_job, get_capacity, get_events,
    get_examples, get_export, get_fields, get_job, get_metrics, get_openapi, get_problem,
    get_request, get_result, health, list_jobs, post_hardening_curve, post_hertz, post_job,
    post_solve, post_validate,
};

use streams::EventStreamLimit;

pub use client_address::Network;
pub use edge::AllowedHosts;
pub(crate) use examples::EXAMPLES;
pub use guide::Guide;
pub use listen::{ConnectionTimeouts, Listening, serve};
pub use metrics::{Metrics, metrics_router, worker_router};
pub use problem::Problem;
pub use problem_type::ProblemType;
pub use request_log::REQUEST_DURATION;
pub(crate) use selection::summary;
pub use streams::EVENT_STREAMS;
pub use tls::{TlsError, TlsIdentity};

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
    rates: Arc<Rates>,
    streams: Arc<EventStreamLimit>,
    bodies: Bodies,
    sending: Arc<Turns>,
    metrics: Option<Metrics>,
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

    /// Waits for a turn to send a result. Each turn holds a piece of a result in memory until its
    /// client has read it.
    fn turn(&self, caller: Caller) -> impl Future<Output = Turn> + Send + use<> {
        let sending = Arc::clone(&self.sending);
        async move { sending.take(caller.key()).await }
    }
}

/// Builds the router with all routes and layers.
pub fn router(state: HttpState) -> Router {
    let keys = from_fn_with_state(state.clone(), authenticate);
    let hosts = from_fn_with_state(state.clone(), check_host);
    // Binary fields compress badly.
    let compressible = DefaultPredicate::new()
        .and(NotForContentType::const_new("application/octet-stream"))
        .and(|_, _, _: &HeaderMap, about: &Extensions| about.get::<CodingChosen>().is_none());
    let cors = cors(&state.settings.cors_origins);
    let log = from_fn_with_state(Arc::from(&state.settings.trusted_proxies[..]), log_request);
    let guarded = guarded_routes();
    let declared = Arc::new(guarded.get_openapi().paths.clone());
    let queries = from_fn_with_state((state.clone(), declared), refuse_undeclared);
    let guarded = guarded.route_layer(queries).route_layer(keys);
    let (documented, _) = guarded.merge(open_routes()).split_for_parts();
    let routes = documented
        .route("/docs", get(docs::to_page))
        .route("/docs/", get(docs::page))
        .route("/guide", get(guide::to_guide))
        .route("/guide/", get(guide::file))
        .route("/guide/{*path}", get(guide::file))
        .route("/", get(page::index))
        .route("/web/{*path}", get(page::file))
        .fallback(no_route)
        .method_not_allowed_fallback(no_method)
        .with_state(state)
        .layer(hosts)
        .layer(CatchPanicLayer::custom(panicked))
        .layer(from_fn(problem::name_request))
        // On ten megabytes of JSON, the default level saves 8 % more bytes than the fastest one
        // and takes six times as long.
        .layer(
            CompressionLayer::new().quality(CompressionLevel::Fastest).compress_when(compressible),
        )
        .layer(from_fn(settle_coding))
        .layer(from_fn(guard_response));
    // Without allowed origins, OPTIONS is answered as an unknown method.
    let routes = match cors {
        Some(cors) => routes.layer(cors),
        None => routes,
    };
    routes
        .layer(PropagateRequestIdLayer::x_request_id())
        .layer(log)
        .layer(SetRequestIdLayer::x_request_id(MakeRequestUuid))
        .layer(from_fn(drop_unusable_request_id))
}

/// The CORS layer: pages of these origins may send the same requests as a program, without
/// cookies.
fn cors(origins: &[HeaderValue]) -> Option<CorsLayer> {
    let allowed = if origins.iter().any(|origin| origin == "*") {
        AllowOrigin::any()
    } else {
        AllowOrigin::list(origins.iter().cloned())
    };
    let layer = CorsLayer::new()
        .allow_origin(allowed)
        .allow_methods([Method::GET, Method::POST, Method::DELETE])
        // `*` does not cover `Authorization`.
        .allow_headers(AllowHeaders::mirror_request())
        .expose_headers(ExposeHeaders::any())
        .max_age(Duration::from_hours(1));
    (!origins.is_empty()).then_some(layer)
}

/// Routes in the OpenAPI document.
fn documented_routes() -> OpenApiRouter<HttpState> {
    guarded_routes().merge(open_routes())
}

/// Routes that need an API key if keys are required.
fn guarded_routes() -> OpenApiRouter<HttpState> {
    let guarded = OpenApiRouter::default()
        .routes(routes!(list_jobs::list_jobs, post_job::post_job))
        .routes(routes!(get_job::get_job, delete_job::delete_job))
        .routes(routes!(get_events::get_events))
        .routes(routes!(get_request::get_request))
        .routes(routes!(get_result::get_result))
        .routes(routes!(get_fields::get_fields))
        .routes(routes!(cancel_job::cancel_job))
        .routes(routes!(batch_submit::batch_submit))
        .routes(routes!(batch_cancel::batch_cancel))
        .routes(routes!(batch_fetch::batch_fetch))
        .routes(routes!(post_solve::post_solve))
        .routes(routes!(post_validate::post_validate))
        .routes(routes!(post_hertz::post_hertz))
        .routes(routes!(post_hardening_curve::post_hardening_curve))
        .routes(routes!(get_examples::get_examples))
        .routes(routes!(get_capacity::get_capacity))
        .routes(routes!(get_metrics::get_metrics));
    get_export::exports().fold(guarded, OpenApiRouter::routes)
}

/// Routes that never need a key.
fn open_routes() -> OpenApiRouter<HttpState> {
    OpenApiRouter::default()
        .routes(routes!(get_problem::get_problem))
        .routes(routes!(get_openapi::get_openapi))
        .routes(routes!(health::livez))
        .routes(routes!(health::readyz))
}

async fn no_route(uri: Uri) -> Problem {
    Problem::new(ProblemType::NotFound, format!("there is nothing at {}", uri.path()))
}

async fn no_method(request: Request) -> Problem {
    let (method, path) = (request.method(), request.uri().path());
    Problem::new(ProblemType::MethodNotAllowed, format!("{path} does not know {method}"))
}

#[expect(clippy::needless_pass_by_value, reason = "the layer hands the panic over")]
fn panicked(panic: Box<dyn Any + Send>) -> Response {
    let message = panic.downcast_ref::<String>().map(String::as_str);
    let message =
        message.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("(no message)");
    tracing::error!(panic = message, "a request handler panicked");
    Problem::new(
        ProblemType::Internal,
        "the request could not be answered; the fault has been logged",
    )
    .into_response()
}
