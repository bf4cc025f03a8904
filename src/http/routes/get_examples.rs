//! `GET /v1/examples`: jobs to begin with, ready to be posted.

use axum::Json;
use serde::Serialize;
use serde_json::value::RawValue;
use utoipa::ToSchema;

use crate::http::Problem;
use crate::http::examples::EXAMPLES;
use crate::http::openapi::job;
use crate::http::problem_type::ProblemType;

/// Jobs to begin with, each with its keys in the order of its file.
#[derive(Debug, Serialize, ToSchema)]
pub(in crate::http) struct ExampleList {
    /// Each under its name.
    examples: Vec<Example>,
}

/// A job with its name.
#[derive(Debug, Serialize, ToSchema)]
pub(in crate::http) struct Example {
    /// Its name, as that of its file in `api/examples`.
    #[schema(example = "two_cylinders")]
    name: &'static str,
    /// The job.
    #[schema(schema_with = job)]
    job: &'static RawValue,
}

/// Jobs to begin with, ready to be posted
#[utoipa::path(
    get, path = "/v1/examples", tag = "service",
    responses((status = OK, description = "The examples.", body = ExampleList)),
)]
pub(in crate::http) async fn get_examples() -> Result<Json<ExampleList>, Problem> {
    let example = |(name, text)| Ok(Example { name, job: serde_json::from_str(text)? });
    let examples = EXAMPLES.into_iter().map(example).collect::<Result<_, serde_json::Error>>();
    let fault = |error: serde_json::Error| Problem::new(ProblemType::Internal, error.to_string());
    Ok(Json(ExampleList { examples: examples.map_err(fault)? }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_is_served() {
        let directory = concat!(env!("CARGO_MANIFEST_DIR"), "/api/examples");
        for entry in std::fs::read_dir(directory).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap();
            assert!(EXAMPLES.iter().any(|(served, _)| *served == name), "{name} is not served");
        }
        for (name, text) in EXAMPLES {
            assert!(brinell_solver::job::Job::from_json(text.as_bytes()).is_ok(), "{name}");
        }
    }
}
