//! `GET /problems/{name}`: what a kind of error means, for a person.

use axum::extract::Path;
use axum::extract::rejection::PathRejection;

use crate::http::{Problem, ProblemType};

/// What a kind of error means, for a person
///
/// The address is the `type` member of a problem.
#[utoipa::path(
    get, path = "/problems/{name}", tag = "service",
    params(("name" = String, Path, description = "Name of the kind.", example = "invalid-job")),
    responses((
        status = OK, description = "An explanation.", body = String, content_type = "text/plain",
    )),
    extensions(("x-problems" = json!(["not-found"]))),
)]
pub(in crate::http) async fn get_problem(
    name: Result<Path<String>, PathRejection>,
) -> Result<String, Problem> {
    let kind = name
        .ok()
        .and_then(|Path(name)| ProblemType::by_name(&name))
        .ok_or_else(|| Problem::new(ProblemType::NotFound, "there is no such kind of problem"))?;
    Ok(format!("{}\n\n{}\n\nHTTP status {}\n", kind.title(), kind.explanation(), kind.status()))
}
