//! This interface as an OpenAPI 3.1 document.
//!
//! Paths, parameters and answers are declared beside each handler and collected by the router that serves them, so
//! none can be forgotten. Jobs and results are described here, field by field: the core knows nothing of OpenAPI.
//! Errors follow from what a handler takes in. Tests hold all of it to the real thing (`tests/openapi.rs`), and
//! `api/openapi.json` to this.

mod problems;
mod report;
mod schema;

use std::sync::LazyLock;

use serde_json::{Map, Value, json};
use utoipa::openapi::schema::{ObjectBuilder, OneOfBuilder, Schema, Type};
use utoipa::openapi::{Ref, RefOr};

use super::routes;

/// Where the schemas of the document are.
const BASE: &str = "#/components/schemas/";

/// The document, as it is served.
pub(super) fn text() -> &'static str {
    static TEXT: LazyLock<String> = LazyLock::new(|| pretty(&document()));
    &TEXT
}

/// The document as text, the same at every call.
pub fn pretty(document: &Value) -> String {
    format!("{document:#}\n")
}

/// The document.
///
/// # Panics
/// Never: a collection of plain data has a JSON form.
#[expect(clippy::expect_used, reason = "plain data has a JSON form")]
pub fn document() -> Value {
    let collected = super::documented_routes().into_openapi();
    let mut document = serde_json::to_value(collected).expect("plain data has a JSON form");
    document["info"] = info();
    document["servers"] = json!([{"url": "/"}]);
    document["tags"] = tags_of_operations();
    document["components"]["securitySchemes"] = json!({"api_key": {
        "type": "http",
        "scheme": "bearer",
        "description": "The token that `brinell key create` prints. Only where the service asks for API keys.",
    }});
    document["components"]["schemas"]["JobEvent"] = event();
    for (name, schema) in brinell_solver::job::schema::schemas(BASE)
        .into_iter()
        .chain(report::schemas())
        .chain(problems::schemas())
    {
        document["components"]["schemas"][name] = schema;
    }
    problems::declare(&mut document, &super::guarded_routes().into_openapi().paths);
    link_jobs(&mut document);
    show_examples(&mut document);
    document["components"]["headers"] = problems::headers();
    document
}

fn info() -> Value {
    json!({
        "title": "Brinell",
        "version": env!("CARGO_PKG_VERSION"),
        "summary": env!("CARGO_PKG_DESCRIPTION"),
        "description": "Two bodies are pressed together so hard that they yield: POST a job, get the contact \
            pressure, the approach, the stresses below the surface and the plastic zone.\n\nFigures are in the \
            units the job names. Errors are `application/problem+json` (RFC 9457) and name every field at fault.",
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

/// One server-sent event.
fn event() -> Value {
    let mut data = schema::text("A job for `state`, an iteration for `iteration`.", "{\"iteration\":1}");
    data["contentMediaType"] = json!("application/json");
    let mut id = schema::text("For `Last-Event-ID`; `state` events have none, save the last.", "1-12");
    id["pattern"] = json!("^[0-9]+-[0-9]+(-end)?$");
    schema::object(
        "One event of a job.",
        [
            schema::field("event", schema::words("Its kind.", &["state", "iteration"])),
            schema::optional("id", id),
            schema::field("data", data),
        ],
    )
}

/// Puts the files of `api/examples` beside the bodies that jobs come in, and an example of every error.
fn show_examples(document: &mut Value) {
    let jobs = routes::get_examples::EXAMPLES.iter().filter_map(|(name, text)| {
        let job: Value = serde_json::from_str(text).ok()?;
        Some(((*name).to_owned(), json!({"summary": name.replace('_', " "), "value": job})))
    });
    let all: Map<String, Value> = jobs.chain(problems::examples()).collect();
    document["components"]["examples"] = Value::Object(all);
    let reference = |name: &str| json!({"$ref": format!("#/components/examples/{name}")});
    let jobs = routes::get_examples::EXAMPLES.iter().map(|(name, _)| ((*name).to_owned(), reference(name)));
    let jobs = Value::Object(jobs.collect());
    for path in ["/v1/jobs", "/v1/solve", "/v1/validate", "/v1/hertz"] {
        document["paths"][path]["post"]["requestBody"]["content"]["application/json"]["examples"] =
            jobs.clone();
    }
}

/// Says, beside the receipts of jobs, where to go from there.
fn link_jobs(document: &mut Value) {
    let Some(paths) = document["paths"].as_object() else { return };
    let of_job = paths.iter().filter(|(path, _)| path.contains("{id}"));
    let operations = of_job.flat_map(|(_, item)| item.as_object().into_iter().flat_map(Map::values));
    let names: Vec<String> =
        operations.filter_map(|operation| Some(operation["operationId"].as_str()?.to_owned())).collect();
    let link = |name: &String| {
        (name.clone(), json!({"operationId": name, "parameters": {"id": "$response.body#/id"}}))
    };
    let links = Value::Object(names.iter().map(link).collect());
    for path in ["/v1/jobs", "/v1/solve"] {
        document["paths"][path]["post"]["responses"]["202"]["links"] = links.clone();
    }
}

/// A schema of this document, for types that are declared elsewhere.
fn named(name: &str) -> RefOr<Schema> {
    RefOr::Ref(Ref::from_schema_name(name))
}

/// A job.
pub(super) fn job() -> RefOr<Schema> {
    named("ContactJob")
}

/// Labels.
pub(super) fn tags() -> RefOr<Schema> {
    named("Tags")
}

/// An error.
pub(super) fn problem() -> RefOr<Schema> {
    named("Problem")
}

/// The cost of a job.
pub(super) fn estimate() -> RefOr<Schema> {
    named("Estimate")
}

/// An iteration, or `null` before the first.
pub(super) fn latest_iteration() -> RefOr<Schema> {
    let nothing = ObjectBuilder::new().schema_type(Type::Null);
    Schema::from(OneOfBuilder::new().item(nothing).item(named("Iteration"))).into()
}
