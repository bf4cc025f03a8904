//! The job that a URL names.

use std::collections::HashMap;

use axum::extract::{FromRequestParts, Path};
use axum::http::request::Parts;

use super::HttpState;
use super::access::Caller;
use super::problem::Problem;
use crate::jobs::{JobId, StoreError};

/// The `{id}` of a URL. A text that is no id, or the id of an invisible job, is answered by 404.
#[derive(Debug, Clone, Copy)]
pub(super) struct JobPath(pub(super) JobId);

impl FromRequestParts<HttpState> for JobPath {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let named = Path::<HashMap<String, String>>::from_request_parts(parts, state).await.ok();
        let id = named
            .and_then(|Path(named)| named.get("id")?.parse().ok())
            .ok_or(StoreError::NotFound)?;
        let caller = Caller::from_request_parts(parts, state).await?;
        check_seen(state, caller, id).await?;
        Ok(Self(id))
    }
}

/// Checks that a job is visible to the caller.
pub(super) async fn check_seen(
    state: &HttpState,
    caller: Caller,
    id: JobId,
) -> Result<(), StoreError> {
    if caller.confined_to().is_some() && !caller.sees(&state.jobs.get(id).await?) {
        return Err(StoreError::NotFound);
    }
    Ok(())
}
