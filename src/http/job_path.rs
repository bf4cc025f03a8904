//! The job an address names, and how long its asker will wait.

use std::collections::HashMap;
use std::time::Duration;

use axum::extract::{FromRequestParts, Path};
use axum::http::request::Parts;
use serde::Deserialize;
use utoipa::IntoParams;

use super::HttpState;
use super::access::Caller;
use super::problem::Problem;
use super::query::{read, wrong};
use crate::jobs::{JobId, StoreError};

/// The `{id}` of an address. What is no id, or another's, names no job.
#[derive(Debug, Clone, Copy)]
pub(super) struct JobPath(pub(super) JobId);

impl FromRequestParts<HttpState> for JobPath {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let named = Path::<HashMap<String, String>>::from_request_parts(parts, state).await.ok();
        let id = named.and_then(|Path(named)| named.get("id")?.parse().ok()).ok_or(StoreError::NotFound)?;
        let caller = Caller::from_request_parts(parts, state).await?;
        if caller.confined_to().is_some() && !caller.sees(&state.jobs.get(id).await?) {
            return Err(StoreError::NotFound.into());
        }
        Ok(Self(id))
    }
}

#[derive(Debug, Deserialize, IntoParams)]
#[into_params(parameter_in = Query)]
#[serde(deny_unknown_fields)]
pub(super) struct WaitQuery {
    /// Wait so many seconds for the job to finish, fractions allowed, cut at the service's limit.
    #[param(minimum = 0, default = 0, example = 30)]
    wait: Option<f64>,
}

/// The `?wait=` of an address: seconds, fractions allowed, cut at the service's limit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wait(pub(super) Duration);

impl FromRequestParts<HttpState> for Wait {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let query: WaitQuery = read(parts, state).await?;
        let seconds = query.wait.unwrap_or(0.0);
        if !(seconds.is_finite() && seconds >= 0.0) {
            return Err(wrong(format!("wait must be a number of seconds, 0 or greater, got {seconds}")));
        }
        Ok(Self(Duration::from_secs_f64(seconds.min(state.settings.wait_limit.as_secs_f64()))))
    }
}
