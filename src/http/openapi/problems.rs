//! The errors of every operation: some follow from its inputs, others are named by its handler
//! under `x-problems`.

use serde_json::{Map, Value, json};
use utoipa::openapi::Paths;

use crate::http::access::HARMLESS;
use crate::http::problem_type::ProblemType;

const METHODS: [&str; 3] = ["get", "post", "delete"];

/// Adds to every operation its errors, its security and the header with the request id.
pub(super) fn declare(document: &mut Value, guarded: &Paths) {
    let Some(paths) = document["paths"].as_object_mut() else { return };
    for (path, item) in paths {
        let is_guarded = guarded.paths.contains_key(path);
        for method in METHODS {
            let Some(operation) = item.get_mut(method).and_then(Value::as_object_mut) else {
                continue;
            };
            let mut kinds = implied(path, method, operation);
            if is_guarded {
                kinds.extend([
                    ProblemType::Unauthorized,
                    ProblemType::StoreUnavailable,
                    ProblemType::Damaged,
                ]);
                operation.insert("security".to_owned(), json!([{}, {"api_key": []}]));
            } else {
                operation.insert("security".to_owned(), json!([]));
            }
            kinds.extend(own(operation));
            for parameter in
                operation.get_mut("parameters").and_then(Value::as_array_mut).into_iter().flatten()
            {
                never_null(&mut parameter["schema"]);
            }
            if let Some(body) = operation.get_mut("requestBody") {
                body["required"] = json!(true);
            }
            let Some(responses) = operation.get_mut("responses").and_then(Value::as_object_mut)
            else {
                continue;
            };
            for kind in kinds {
                add(responses, kind);
            }
            for response in responses.values_mut() {
                response["headers"]["X-Request-Id"] = header("X-Request-Id");
            }
        }
    }
}

/// An optional parameter is never `null`: a URL cannot express it.
fn never_null(schema: &mut Value) {
    if let Some([first, _]) = schema["type"].as_array().map(Vec::as_slice) {
        schema["type"] = first.clone();
    }
}

/// The errors that a handler names.
fn own(operation: &mut Map<String, Value>) -> Vec<ProblemType> {
    let names = operation.remove("x-problems").unwrap_or_default();
    let names = names.as_array().into_iter().flatten().filter_map(Value::as_str);
    names.filter_map(ProblemType::by_name).collect()
}

/// Returns the errors that follow from the path and the inputs of an operation.
fn implied(path: &str, method: &str, operation: &Map<String, Value>) -> Vec<ProblemType> {
    let mut kinds = vec![ProblemType::Internal];
    if method != "get" && !HARMLESS.contains(&path) {
        kinds.push(ProblemType::Forbidden);
    }
    if path.contains("{id}") {
        kinds.push(ProblemType::JobNotFound);
    }
    if operation.contains_key("requestBody") {
        kinds.extend([
            ProblemType::InvalidJson,
            ProblemType::BodyTimeout,
            ProblemType::BodyTooLarge,
            ProblemType::TooManyBodies,
            ProblemType::TooManyJobs,
            ProblemType::UnsupportedMediaType,
        ]);
    }
    // Those without query parameters refuse each.
    if path.starts_with("/v1/") {
        kinds.push(ProblemType::InvalidQuery);
    }
    kinds
}

/// Adds one kind of error to the answers of an operation; kinds with the same status share an
/// answer.
fn add(responses: &mut Map<String, Value>, kind: ProblemType) {
    let schema = json!({"$ref": "#/components/schemas/Problem"});
    let response = responses
        .entry(kind.status().as_str())
        .or_insert_with(|| json!({"content": {"application/problem+json": {"schema": schema}}}));
    let titles = match response["description"].as_str() {
        Some(titles) => format!("{titles}; {}", kind.title()),
        None => kind.title().to_owned(),
    };
    response["description"] = json!(titles);
    response["content"]["application/problem+json"]["examples"][kind.name()] =
        json!({"$ref": format!("#/components/examples/{}", kind.name())});
    match kind.status().as_u16() {
        401 => response["headers"]["WWW-Authenticate"] = header("WWW-Authenticate"),
        429 | 503 => response["headers"]["Retry-After"] = header("Retry-After"),
        _ => {}
    }
}

fn header(name: &str) -> Value {
    json!({"$ref": format!("#/components/headers/{name}")})
}

/// The headers that answers of several operations carry.
pub(super) fn headers() -> Value {
    json!({
        "X-Request-Id": {
            "description": "The request's name: its own, if it had one.",
            "schema": {"type": "string"},
        },
        "WWW-Authenticate": {
            "description": "How to say who asks.",
            "schema": {"type": "string", "const": "Bearer"},
        },
        "Retry-After": {
            "description": "Seconds after which to try again.",
            "schema": {"type": "integer", "minimum": 1},
        },
    })
}

/// One example of each kind of error.
pub(super) fn examples() -> impl Iterator<Item = (String, Value)> {
    ProblemType::ALL.iter().map(|kind| {
        let problem = json!({
            "type": kind.uri(),
            "title": kind.title(),
            "status": kind.status().as_u16(),
            "detail": kind.explanation(),
        });
        (kind.name().to_owned(), json!({"value": problem}))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn handlers_name_problems_that_exist() {
        let document =
            serde_json::to_value(crate::http::routes::documented().into_openapi()).unwrap();
        let mut named = 0;
        for item in document["paths"].as_object().unwrap().values() {
            for operation in METHODS.iter().filter_map(|method| item.get(method)) {
                for name in operation["x-problems"].as_array().into_iter().flatten() {
                    assert!(ProblemType::by_name(name.as_str().unwrap()).is_some(), "{name}");
                    named += 1;
                }
            }
        }
        assert!(named > 10, "the handlers' own problems have not been found");
    }
}
