//! This interface as an OpenAPI 3.1 document.
//!
//! Paths, parameters and answers are declared beside each handler and collected by the router that
//! serves them, so none can be forgotten. Schemas of jobs come from the solver's tables of fields,
//! schemas of results from its types. Errors follow from the inputs of a handler. Tests compare
//! the document with the running service (`tests/openapi`), and `api/openapi.json` with the
//! document.

mod derived;
mod problems;
mod reference;

use std::sync::LazyLock;

use serde_json::{Map, Value, json};

use super::examples::EXAMPLES;
use super::problem_type::ProblemType;
use super::routes;
use crate::jobs::{JobState, Quota};
use brinell_solver::job::FaultCode;
use brinell_solver::job::fields::words;
use brinell_solver::job::schema::schemas as schema_of_jobs;
use brinell_solver::report;
use brinell_solver::solver::SolveStatus;
use reference::BASE;
pub(super) use reference::{job, named, tags, units};

/// The document, as JSON.
pub(super) fn text() -> &'static str {
    static TEXT: LazyLock<String> = LazyLock::new(|| pretty(&document()));
    &TEXT
}

/// Returns the document as text.
pub fn pretty(document: &Value) -> String {
    format!("{document:#}\n")
}

/// The document.
///
/// # Panics
/// Never: a collection of plain data has a JSON form.
#[expect(clippy::expect_used, reason = "plain data has a JSON form")]
pub fn document() -> Value {
    let collected = routes::documented().into_openapi();
    let mut document = serde_json::to_value(collected).expect("plain data has a JSON form");
    document["info"] = info();
    document["servers"] = json!([{"url": "/"}]);
    document["tags"] = tags_of_operations();
    document["components"]["securitySchemes"] = json!({"api_key": {
        "type": "http",
        "scheme": "bearer",
        "description": "The token that `brinell key create` prints. Only where the service asks \
                        for API keys.",
    }});
    if let Some(schemas) = document["components"]["schemas"].as_object_mut() {
        derived::complete(schemas);
    }
    let schemas = &mut document["components"]["schemas"];
    schemas["Job"]["properties"]["result"] = json!({
        "$ref": format!("{BASE}Report"),
        "description": "The result; only in the answer to a client that waits, and only if the \
                        job is done by then.",
    });
    for (key, schema) in [("units", "Units"), ("analysis", "Analysis"), ("tags", "Tags")] {
        schemas["Report"]["properties"][key] = json!({"$ref": format!("{BASE}{schema}")});
    }
    for (name, words, description) in [
        ("JobState", words::<JobState>(), JOB_STATES),
        ("SolveStatus", words::<SolveStatus>(), SOLVE_STATUS),
        ("VerdictLevel", words::<report::VerdictLevel>(), VERDICT_LEVELS),
        ("AnswerQuantity", words::<report::Quantity>(), ANSWER_QUANTITIES),
    ] {
        schemas[name] = open_set(description, &words);
    }
    let kinds: Vec<_> = ProblemType::ALL.iter().map(|kind| kind.uri()).collect();
    let kinds: Vec<_> = kinds.iter().map(String::as_str).collect();
    schemas["Problem"]["properties"]["type"] = open_set(PROBLEM_TYPES, &kinds);
    schemas["Problem"]["properties"]["quota"] = open_set(QUOTAS, &Quota::NAMES);
    schemas["Fault"]["properties"]["code"] = open_set(FAULT_CODES, &words::<FaultCode>());
    schemas["ValidityNote"]["properties"]["code"] =
        open_set(VALIDITY_CODES, &report::validity_codes());
    for (name, schema) in schema_of_jobs(BASE) {
        schemas[name] = schema;
    }
    problems::declare(&mut document, &routes::guarded().into_openapi().paths);
    link_jobs(&mut document);
    show_examples(&mut document);
    document["components"]["headers"] = problems::headers();
    keep_used_examples(&mut document);
    document
}

fn info() -> Value {
    json!({
        "title": "Brinell",
        "version": env!("CARGO_PKG_VERSION"),
        "summary": env!("CARGO_PKG_DESCRIPTION"),
        "description": "Two bodies are pressed together so hard that they yield: POST a job, get \
                        the contact \
                        pressure, the approach, the stresses below the surface and the plastic \
                        zone.\n\nFigures are in the \
                        units the job names. Errors are `application/problem+json` (RFC 9457) and \
                        name every field at fault.\n\n\
                        Answers may get further members, and sets marked `x-extensible-enum` \
                        further words, without a `/v2`: a \
                        client ignores what it does not know. A job is kept with its result until \
                        its `expires_at`.",
        "license": {"name": "MIT OR Apache-2.0", "identifier": "MIT OR Apache-2.0"},
    })
}

fn tags_of_operations() -> Value {
    json!([
        {"name": "jobs", "description": "Hand jobs in, follow them, stop them."},
        {"name": "results", "description": "What came out."},
        {"name": "theory", "description": "Answers without a mesh."},
        {"name": "service", "description": "The service itself."},
    ])
}

/// Adds the files of `api/examples` to request bodies, and an example of every error.
fn show_examples(document: &mut Value) {
    let jobs = EXAMPLES.iter().filter_map(|(name, text)| {
        let job: Value = serde_json::from_str(text).ok()?;
        Some(((*name).to_owned(), json!({"summary": name.replace('_', " "), "value": job})))
    });
    let all: Map<String, Value> = jobs.chain(problems::examples()).collect();
    document["components"]["examples"] = Value::Object(all);
    let reference = |name: &str| json!({"$ref": format!("#/components/examples/{name}")});
    let jobs = EXAMPLES.iter().map(|(name, _)| ((*name).to_owned(), reference(name)));
    let jobs = Value::Object(jobs.collect());
    for path in ["/v1/jobs", "/v1/solve", "/v1/validate", "/v1/hertz"] {
        document["paths"][path]["post"]["requestBody"]["content"]["application/json"]["examples"] =
            jobs.clone();
    }
}

/// Removes examples without a reference: those of errors that no operation answers with.
fn keep_used_examples(document: &mut Value) {
    let text = document["paths"].to_string();
    if let Some(examples) = document["components"]["examples"].as_object_mut() {
        examples.retain(|name, _| text.contains(&format!("\"#/components/examples/{name}\"")));
    }
}

/// Adds links to the answers that contain a job.
fn link_jobs(document: &mut Value) {
    let Some(paths) = document["paths"].as_object() else { return };
    let of_job = paths.iter().filter(|(path, _)| path.contains("{id}"));
    let operations =
        of_job.flat_map(|(_, item)| item.as_object().into_iter().flat_map(Map::values));
    let names: Vec<String> = operations
        .filter_map(|operation| Some(operation["operationId"].as_str()?.to_owned()))
        .collect();
    let link = |name: &String| {
        (name.clone(), json!({"operationId": name, "parameters": {"id": "$response.body#/id"}}))
    };
    let links = Value::Object(names.iter().map(link).collect());
    for path in ["/v1/jobs", "/v1/solve"] {
        document["paths"][path]["post"]["responses"]["202"]["links"] = links.clone();
    }
}

/// Schema of an extensible enumeration: plain text, so that generated clients accept future
/// values.
fn open_set(description: &str, words: &[&str]) -> Value {
    json!({
        "type": "string",
        "description": format!("{description} There may be more in the future."),
        "examples": words,
        "x-extensible-enum": words,
    })
}

const JOB_STATES: &str = "Where a job stands. `queued` and `running` are passed through, the \
                          others are final; `done` says so of states that are newer than the \
                          client.";
const SOLVE_STATUS: &str = "How a solve ended. Converged means that displacements and \
                            out-of-balance force are below the tolerance and the final state has \
                            passed a check of its own.";
const VERDICT_LEVELS: &str = "The state of the bodies: `not_converged` and `collapse` are no answers; \
                              `above_shakedown_limit`, `yields` and `dented` have plastic strain; \
                              `not_known` where no yield stress is given, or the mesh does not \
                              resolve the onset of yield.";
const ANSWER_QUANTITIES: &str =
    "The physical quantity of an answer. `strain` and `ratio` are shown in per cent.";
const VALIDITY_CODES: &str = "Stable identifier.";
const PROBLEM_TYPES: &str =
    "The kind of error: a relative address that this service answers with an explanation.";
const QUOTAS: &str = "Which quota of the API key is used up (`quota-exceeded`).";
const FAULT_CODES: &str = "The kind of fault, for programs.";
