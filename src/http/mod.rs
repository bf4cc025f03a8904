//! The HTTP interface. This module builds the router; `routes` lists the routes, and one file in it
//! holds each handler and declares it for [`openapi`].
//!
//! Every error, including errors of the framework and panics, is answered as
//! `application/problem+json` ([`Problem`]). Every answer carries an `x-request-id`, the client's
//! own if it sent one.

mod access;
mod allowed_hosts;
mod batch;
mod bodies;
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
mod state;
mod static_file;
mod streams;
mod tls;
pub mod wire;
mod written_body;

use std::any::Any;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::Request;
use axum::http::{Extensions, HeaderMap, HeaderValue, Method, Uri};
use axum::middleware::{from_fn, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use axum::{Extension, Router};
use tower_http::CompressionLevel;
use tower_http::catch_panic::CatchPanicLayer;
use tower_http::compression::CompressionLayer;
use tower_http::compression::predicate::{DefaultPredicate, NotForContentType, Predicate};
use tower_http::cors::{AllowHeaders, AllowOrigin, CorsLayer, ExposeHeaders};
use tower_http::request_id::{MakeRequestUuid, PropagateRequestIdLayer, SetRequestIdLayer};

use access::authenticate;
use edge::{check_host, drop_unusable_request_id, guard_response};
use negotiation::settle_coding;
use query::refuse_undeclared;
use request_log::log_request;
use result_body::CodingChosen;
use routes::Document;

pub use allowed_hosts::AllowedHosts;
pub use client_address::Network;
pub(crate) use examples::EXAMPLES;
pub use guide::Guide;
pub use listen::{ConnectionTimeouts, Listening, serve};
pub use metrics::{Metrics, metrics_router, worker_router};
pub use problem::Problem;
pub use problem_type::ProblemType;
pub use request_log::REQUEST_DURATION;
pub(crate) use selection::summary;
pub use state::{Capacity, HttpSettings, HttpState};
pub use streams::EVENT_STREAMS;
pub use tls::{TlsError, TlsIdentity};

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
    let guarded = routes::guarded();
    let declared = Arc::new(guarded.get_openapi().paths.clone());
    let queries = from_fn_with_state((state.clone(), declared), refuse_undeclared);
    let guarded = guarded.route_layer(queries).route_layer(keys);
    let (documented, _) = guarded.merge(routes::open()).split_for_parts();
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
        .layer(Extension(Document { value: openapi::document, text: openapi::text }))
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
