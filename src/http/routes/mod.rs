//! One endpoint a file.

mod answer;
pub(super) mod batch_cancel;
pub(super) mod batch_fetch;
pub(super) mod batch_submit;
pub(super) mod cancel_job;
pub(super) mod delete_job;
pub(super) mod get_capacity;
pub(super) mod get_events;
pub(super) mod get_examples;
pub(super) mod get_export;
pub(super) mod get_fields;
pub(super) mod get_job;
pub(super) mod get_metrics;
pub(super) mod get_openapi;
pub(super) mod get_problem;
pub(super) mod get_request;
pub(super) mod get_result;
pub(super) mod health;
pub(super) mod list_jobs;
pub(super) mod post_hardening_curve;
pub(super) mod post_hertz;
pub(super) mod post_job;
pub(super) mod post_solve;
pub(super) mod post_validate;
