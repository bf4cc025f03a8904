//! `GET /v1/jobs/{id}/result`: the report, complete or as far as a stopped job came, or the parts of it that are wanted.

use axum::extract::State;
use axum::http::header::{ACCEPT, VARY};
use axum::http::{HeaderMap, HeaderValue};
use axum::response::{IntoResponse, Response};

use crate::http::export_file::{export, file};
use crate::http::job_path::JobPath;
use crate::http::query::{Selection, SelectionQuery};
use crate::http::selection::no_step;
use crate::http::{HttpState, Problem, result_body};
use crate::jobs::{Export, JobId};
use brinell_solver::report::Report;

/// The result of a job
///
/// Complete, or as far as a stopped job came; its `status` says which. It is sent step by step as it is read. Where
/// only some parts are wanted, the others are left out or empty. With `Accept: text/csv` one row of figures for each
/// step, as `summary.csv`.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/result", tag = "results", params(
        ("id" = JobId, Path, description = "The job's id, as its `Location` has it."),
        SelectionQuery,
    ),
    responses(
        (status = OK, description = "The result.", content(
            (Report = "application/json"),
            (String = "text/csv"),
        ), headers(
            ("ETag" = String, description = "Name of these bytes, for `If-None-Match`; of JSON."),
            ("Vary" = String, description = "`accept`: the answer is in the form that the client accepts."),
        )),
        (status = NOT_MODIFIED, description = "The client has these bytes already."),
    ),
    extensions(("x-problems" = json!(["job-unfinished", "no-result", "step-not-found"]))),
)]
pub(in crate::http) async fn get_result(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
    selection: Selection,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    if prefers_csv(&headers) {
        return summary(&state, id, selection.step).await;
    }
    match state.jobs.result(id).await? {
        Some(head) => result_body::result(&state, id, head, selection, &headers).await,
        None => Err(result_body::no_result(&state.jobs.get(id).await?)),
    }
}

/// The rows of all steps, or of one.
async fn summary(state: &HttpState, id: JobId, step: Option<usize>) -> Result<Response, Problem> {
    let mut table = export(state, id, Export::SummaryCsv, None).await?;
    if let Some(step) = step {
        let mut rows = table.split_inclusive('\n');
        let head = rows.next().unwrap_or_default();
        let rows: Vec<_> = rows.collect();
        let row = rows.get(step).ok_or_else(|| no_step(rows.len()))?;
        table = format!("{head}{row}");
    }
    let mut response = file(id, Export::SummaryCsv, table).into_response();
    response.headers_mut().insert(VARY, HeaderValue::from_static("accept, accept-encoding"));
    Ok(response)
}

/// Whether a client would rather have CSV than JSON (RFC 9110, section 12.5.1): it gives it more weight, or names it
/// where JSON is only among others.
fn prefers_csv(headers: &HeaderMap) -> bool {
    let lines: Vec<_> = headers.get_all(ACCEPT).iter().filter_map(|line| line.to_str().ok()).collect();
    let preference = |main: &str, sub: &str| {
        let ranges = lines.iter().flat_map(|line| line.split(','));
        let fitting = ranges.filter_map(|range| {
            let mut parameters = range.split(';').map(str::trim);
            let (first, second) = parameters.next()?.split_once('/')?;
            let is_exact = first.eq_ignore_ascii_case(main) && second.eq_ignore_ascii_case(sub);
            let is_group = second == "*" && (first == "*" || first.eq_ignore_ascii_case(main));
            let weight = parameters.find_map(|parameter| {
                let (name, value) = parameter.split_once('=')?;
                name.trim().eq_ignore_ascii_case("q").then(|| value.trim().parse().unwrap_or(0.0))
            });
            let exactness = if is_exact { 2 } else { u8::from(first != "*") };
            (is_exact || is_group).then_some((exactness, weight.unwrap_or(1.0_f64)))
        });
        let most_exact = fitting.max_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        most_exact.map_or((0.0, 0), |(exactness, weight)| (weight, exactness))
    };
    let csv = preference("text", "csv");
    csv.0 > 0.0 && csv > preference("application", "json")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn csv_is_sent_to_those_who_would_rather_have_it() {
        for (accepted, is_csv) in [
            (&["text/csv"][..], true),
            (&["Text/CSV; header=present"], true),
            (&["text/csv, */*;q=0.1"], true),
            (&["text/csv, */*"], true),
            (&["text/*"], true),
            (&["application/json;q=0.5", "text/csv;q=0.6"], true),
            (&[], false),
            (&["*/*"], false),
            (&["application/json, text/csv"], false),
            (&["text/csv, application/json"], false),
            (&["text/csv;q=0.5, application/json"], false),
            (&["text/csv;q=0"], false),
            (&["text/csv;q=much, */*"], false),
            (&["image/png", "", ";;,/"], false),
        ] {
            let headers = accepted.iter().map(|value| (ACCEPT, HeaderValue::from_static(value))).collect();
            assert_eq!(prefers_csv(&headers), is_csv, "{accepted:?}");
        }
    }
}
