//! A figure of a result is a row: no other member of it is a number.

use brinell::http::openapi;
use serde_json::Value;

/// Schemas that may have numbers: the row itself, what was asked for, the mesh, the times, and the
/// entries of lists that have one for each part of a contact or each iteration.
const WITH_NUMBERS: [&str; 11] = [
    "Answer",
    "AnswerAt",
    "AnswerPlace",
    "ErrorBar",
    "PrescribedForce",
    "PrescribedApproach",
    "Mesh",
    "Timings",
    "Patch",
    "Iteration",
    "IncrementNumber",
];

fn is_number(schema: &Value) -> bool {
    let is = |kind: &Value| matches!(kind.as_str(), Some("number" | "integer" | "boolean"));
    match &schema["type"] {
        Value::Array(kinds) => kinds.iter().any(is),
        kind => is(kind),
    }
}

/// Returns the schemas to which one leads, and its members that are numbers.
fn look(name: &str, schema: &Value, found: &mut Vec<String>, next: &mut Vec<String>) {
    if let Some(target) = schema["$ref"].as_str() {
        next.extend(target.rsplit('/').next().map(str::to_owned));
    }
    for (key, member) in schema["properties"].as_object().into_iter().flatten() {
        if is_number(member) {
            found.push(format!("{name}.{key}"));
        }
        look(&format!("{name}.{key}"), member, found, next);
    }
    for list in ["oneOf", "anyOf", "allOf", "prefixItems"] {
        for one in schema[list].as_array().into_iter().flatten() {
            look(name, one, found, next);
        }
    }
    for inner in ["items", "additionalProperties"] {
        if schema[inner].is_object() {
            look(name, &schema[inner], found, next);
        }
    }
}

#[test]
fn no_figure_stands_outside_of_rows() {
    let document = openapi::document();
    let (mut found, mut seen) = (Vec::new(), Vec::new());
    let mut next = vec!["Report".to_owned()];
    while let Some(name) = next.pop() {
        if seen.contains(&name) {
            continue;
        }
        let schema = &document["components"]["schemas"][&name];
        let (mut numbers, mut further) = (Vec::new(), Vec::new());
        look(&name, schema, &mut numbers, &mut further);
        if !WITH_NUMBERS.contains(&name.as_str()) {
            found.extend(numbers);
        }
        next.extend(further);
        seen.push(name);
    }
    assert!(found.is_empty(), "{found:?}");
    assert!(seen.iter().any(|name| name == "Answer"), "{seen:?}");
}
