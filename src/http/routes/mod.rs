//! One endpoint a file.

mod answer;
mod batch_cancel;
mod batch_fetch;
mod batch_submit;
mod cancel_job;
mod delete_job;
mod get_capacity;
mod get_events;
mod get_examples;
mod get_export;
mod get_fields;
mod get_job;
mod get_metrics;
mod get_openapi;
mod get_problem;
mod get_request;
mod get_result;
mod health;
mod list_jobs;
mod post_hardening_curve;
mod post_hertz;
mod post_job;
mod post_solve;
mod post_validate;

use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use super::state::HttpState;
pub(super) use get_openapi::Document;

/// Routes in the OpenAPI document.
pub(super) fn documented() -> OpenApiRouter<HttpState> {
    guarded().merge(open())
}

/// Routes that need an API key if keys are required.
pub(super) fn guarded() -> OpenApiRouter<HttpState> {
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
pub(super) fn open() -> OpenApiRouter<HttpState> {
    OpenApiRouter::default()
        .routes(routes!(get_problem::get_problem))
        .routes(routes!(get_openapi::get_openapi))
        .routes(routes!(health::livez))
        .routes(routes!(health::readyz))
}
