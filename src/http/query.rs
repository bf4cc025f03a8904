//! Query strings, checked: an unknown parameter is a typing mistake, not an extension.

use std::num::NonZeroUsize;

use axum::extract::{FromRequestParts, Query};
use axum::http::request::Parts;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use utoipa::IntoParams;

use super::HttpState;
use super::problem::Problem;
use super::problem_type::ProblemType;
use super::result_body::ResultParts;
use crate::jobs::{JobFilter, JobId, JobState};

/// Jobs on a page, unless asked otherwise, and at most.
const PAGE: usize = 20;
const MAX_PAGE: usize = 100;

/// Bounds of `?priority=`.
const MAX_PRIORITY: i16 = 100;

pub(super) fn wrong(detail: impl Into<String>) -> Problem {
    Problem::new(ProblemType::InvalidQuery, detail)
}

/// Reads the whole query string.
pub(super) async fn read<T: DeserializeOwned + Send + 'static>(
    parts: &mut Parts,
    state: &HttpState,
) -> Result<T, Problem> {
    let query = Query::<T>::from_request_parts(parts, state).await;
    query.map(|Query(query)| query).map_err(|rejection| wrong(rejection.body_text()))
}

#[derive(Debug, Deserialize, IntoParams)]
#[into_params(parameter_in = Query)]
#[serde(deny_unknown_fields)]
pub(super) struct PriorityQuery {
    /// Larger goes first.
    #[param(minimum = -100, maximum = 100, default = 0)]
    priority: Option<i16>,
}

/// The `?priority=` of a submission: larger goes first, 0 is ordinary.
#[derive(Debug, Clone, Copy)]
pub(super) struct Priority(pub(super) i16);

impl FromRequestParts<HttpState> for Priority {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let priority = read::<PriorityQuery>(parts, state).await?.priority.unwrap_or(0);
        if priority.unsigned_abs() > MAX_PRIORITY.unsigned_abs() {
            return Err(wrong(format!("priority must be between -{MAX_PRIORITY} and {MAX_PRIORITY}")));
        }
        Ok(Self(priority))
    }
}

#[derive(Debug, Deserialize, IntoParams)]
#[into_params(parameter_in = Query)]
#[serde(deny_unknown_fields)]
pub(super) struct StepQuery {
    /// Which step of a sweep, counted from 1 [default: the last].
    #[param(value_type = Option<u32>, minimum = 1)]
    step: Option<NonZeroUsize>,
}

/// The `?step=` of a result's form: on the wire counted from 1, in here from 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step(pub(super) Option<usize>);

impl FromRequestParts<HttpState> for Step {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let step = read::<StepQuery>(parts, state).await?.step;
        Ok(Self(step.map(|step| step.get() - 1)))
    }
}

#[derive(Debug, Deserialize, IntoParams)]
#[into_params(parameter_in = Query)]
#[serde(deny_unknown_fields)]
pub(super) struct ResultQuery {
    /// One step of a sweep, counted from 1 [default: all].
    #[param(value_type = Option<u32>, minimum = 1)]
    step: Option<NonZeroUsize>,
    /// Whether mesh and nodal fields are sent, if the job asked for them.
    #[param(default = true)]
    fields: Option<bool>,
}

/// The `?step=` and `?fields=` of a result.
#[derive(Debug, Clone, Copy)]
pub(super) struct ResultSelection(pub(super) ResultParts);

impl FromRequestParts<HttpState> for ResultSelection {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let query = read::<ResultQuery>(parts, state).await?;
        Ok(Self(ResultParts {
            step: query.step.map(|step| step.get() - 1),
            without_fields: query.fields == Some(false),
        }))
    }
}

#[derive(Debug, Deserialize, IntoParams)]
#[into_params(parameter_in = Query)]
#[serde(deny_unknown_fields)]
pub(super) struct ListQuery {
    /// Only jobs in this state.
    status: Option<JobState>,
    /// Only jobs with this label, `name:value`.
    #[param(pattern = "^[^:]*:", example = "bearing:NU-210")]
    tag: Option<String>,
    /// Most jobs on the page.
    #[param(minimum = 1, maximum = 100, default = 20)]
    limit: Option<usize>,
    /// The `next_cursor` of the page before.
    #[param(format = Uuid)]
    cursor: Option<String>,
}

/// Which jobs to list: `?status=`, `?tag=name:value`, `?limit=`, `?cursor=`.
#[derive(Debug, Clone)]
pub(super) struct ListFilter(pub(super) JobFilter);

impl FromRequestParts<HttpState> for ListFilter {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Problem> {
        let query: ListQuery = read(parts, state).await?;
        let no_tag = || wrong("tag must be name:value");
        let tag = query.tag.as_deref().map(|tag| tag.split_once(':').ok_or_else(no_tag)).transpose()?;
        let tag = tag.map(|(name, value)| (name.to_owned(), value.to_owned()));
        let limit = query.limit.unwrap_or(PAGE);
        if !(1..=MAX_PAGE).contains(&limit) {
            return Err(wrong(format!("limit must be between 1 and {MAX_PAGE}, got {limit}")));
        }
        let no_cursor = |_| wrong("cursor must be the next_cursor of a page");
        let before = query.cursor.map(|cursor| cursor.parse::<JobId>().map_err(no_cursor)).transpose()?;
        Ok(Self(JobFilter { state: query.status, tag, submitter: None, before, limit }))
    }
}
