//! Authentication and authorization of requests.
//!
//! If API keys are not required, a request without a key has the rights of an administrator: such
//! a service belongs on loopback or behind a proxy that authenticates. If keys are required, every
//! request under `/v1` carries `Authorization: Bearer TOKEN`. A key sees the jobs submitted under
//! it; keys of some scopes see all jobs. Any other job does not exist for the caller.

use std::future::pending;

use axum::extract::{FromRequestParts, Request, State};
use axum::http::header::AUTHORIZATION;
use axum::http::request::Parts;
use axum::http::{HeaderMap, Method};
use axum::middleware::Next;
use axum::response::Response;

use super::HttpState;
use super::problem::Problem;
use super::problem_type::ProblemType;
use super::written_body::ending;
use crate::jobs::{JobRecord, KeyId, Scope};

/// Routes that change nothing although their method is POST.
pub(super) const HARMLESS: [&str; 4] =
    ["/v1/validate", "/v1/hertz", "/v1/hardening-curves", "/v1/batch/fetch"];

/// The caller of a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Caller {
    key: Option<KeyId>,
    scope: Scope,
}

impl Caller {
    const ANYBODY: Self = Self { key: None, scope: Scope::Admin };

    /// Returns the key that new jobs are submitted under.
    pub(super) const fn key(self) -> Option<KeyId> {
        self.key
    }

    /// Returns the key whose jobs are visible; `None` if all jobs are.
    pub(super) fn confined_to(self) -> Option<KeyId> {
        self.key.filter(|_| !self.scope.sees_all())
    }

    /// Returns within seconds after the caller's key becomes invalid; never without a key.
    pub(super) async fn ends(self, state: &HttpState) {
        match self.key {
            Some(key) => state.jobs.key_ends(key).await,
            None => pending().await,
        }
    }

    /// Returns whether a job is visible to this caller.
    pub(super) fn sees(self, record: &JobRecord) -> bool {
        self.confined_to().is_none_or(|key| record.submitter == Some(key))
    }
}

impl FromRequestParts<HttpState> for Caller {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let caller = parts.extensions.get().copied();
        let caller = caller.or((!state.settings.require_api_key).then_some(Self::ANYBODY));
        caller.ok_or_else(|| Problem::new(ProblemType::Unauthorized, "an API key is required"))
    }
}

/// The layer that authenticates and authorizes requests. A key that is sent counts even where none
/// is required.
pub(super) async fn authenticate(
    State(state): State<HttpState>,
    mut request: Request,
    next: Next,
) -> Result<Response, Problem> {
    let Some(token) = bearer(request.headers()) else {
        if state.settings.require_api_key {
            return Err(Problem::new(
                ProblemType::Unauthorized,
                "send the header Authorization: Bearer TOKEN",
            ));
        }
        return Ok(next.run(request).await);
    };
    let caller = identify(&state, token).await?;
    let reads = matches!(*request.method(), Method::GET | Method::HEAD);
    if !caller.scope.changes() && !reads && !HARMLESS.contains(&request.uri().path()) {
        return Err(Problem::new(ProblemType::Forbidden, "this API key may only read"));
    }
    request.extensions_mut().insert(caller);
    let mut response = tokio::select! {
        response = next.run(request) => response,
        () = caller.ends(&state) => return Err(no_longer_good()),
    };
    // For the log of the request.
    response.extensions_mut().insert(caller);
    Ok(ending(response, async move { caller.ends(&state).await }))
}

/// Returns the bearer token of a request. Other schemes concern only the client and a proxy.
fn bearer(headers: &HeaderMap) -> Option<&str> {
    let (scheme, token) = headers.get(AUTHORIZATION)?.to_str().ok()?.split_once(' ')?;
    scheme.eq_ignore_ascii_case("bearer").then(|| token.trim())
}

fn no_longer_good() -> Problem {
    Problem::new(ProblemType::Unauthorized, "the API key is not known, or no longer good")
}

/// Returns the caller that a token belongs to. If the process has a key of its own, it accepts no
/// other.
async fn identify(state: &HttpState, token: &str) -> Result<Caller, Problem> {
    if let Some(once) = &state.settings.once_key {
        return if once.accepts(token) { Ok(Caller::ANYBODY) } else { Err(no_longer_good()) };
    }
    let key = state.jobs.authenticate(token).await?.ok_or_else(no_longer_good)?;
    Ok(Caller { key: Some(key.id), scope: key.scope })
}
