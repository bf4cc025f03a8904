//! `api/openapi.json`: locked, whole, and true to what the solver answers.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

mod form;
mod generated;
mod job;
mod rows;
#[path = "../support/schema.rs"]
mod schema;
mod types;

use std::fs;

use brinell::http::openapi;
use brinell_solver::job::Job;
use brinell_solver::report;
use brinell_solver::solver::Unobserved;
use serde_json::{Value, json};

use generated::root;
use schema::Schema;

/// Visits every value of a document with its pointer.
fn visit(value: &Value, pointer: &str, see: &mut impl FnMut(&str, &Value)) {
    see(pointer, value);
    match value {
        Value::Object(members) => {
            for (key, member) in members {
                let key = key.replace('~', "~0").replace('/', "~1");
                visit(member, &format!("{pointer}/{key}"), see);
            }
        }
        Value::Array(items) => {
            items
                .iter()
                .enumerate()
                .for_each(|(k, item)| visit(item, &format!("{pointer}/{k}"), see));
        }
        _ => {}
    }
}

#[test]
fn references_lead_somewhere_and_schemas_are_schemas() {
    let document = openapi::document();
    assert_eq!(document["openapi"], "3.1.0");
    let mut references = 0;
    visit(&document, "", &mut |pointer, value| {
        if let Some(target) = value["$ref"].as_str() {
            let target = target.strip_prefix('#').unwrap();
            assert!(document.pointer(target).is_some(), "{pointer} leads to {target}");
            references += 1;
        }
    });
    assert!(references > 100);
    for name in document["components"]["schemas"].as_object().unwrap().keys() {
        Schema::named(&document, name);
    }
}

#[test]
fn everything_says_what_it_is() {
    let document = openapi::document();
    let is_told =
        |value: &Value| value["description"].as_str().is_some_and(|text| !text.is_empty());
    for (name, schema) in document["components"]["schemas"].as_object().unwrap() {
        assert!(is_told(schema), "{name} has no description");
        for (key, property) in schema["properties"].as_object().into_iter().flatten() {
            let reference = property["$ref"].as_str().and_then(|target| target.strip_prefix('#'));
            let target = reference.and_then(|target| document.pointer(target)).unwrap_or(property);
            let is_alternative = property["oneOf"].is_array();
            assert!(
                is_told(property) || is_told(target) || is_alternative,
                "{name}.{key} has no description"
            );
            if property["type"] == "number" && !key.ends_with("_seconds") {
                let text = property["description"].as_str().unwrap();
                let has_unit =
                    ["Unit: ", "Range: ", "Without unit."].iter().any(|word| text.contains(word));
                assert!(has_unit, "{name}.{key} has no unit: {text}");
                // Objects of a job are closed.
                let is_answer = schema["additionalProperties"] != json!(false);
                assert!(
                    is_answer || property["examples"].is_array(),
                    "{name}.{key} has no example"
                );
            }
        }
    }
    for (path, item) in document["paths"].as_object().unwrap() {
        for (method, operation) in item.as_object().unwrap() {
            assert!(operation["summary"].is_string(), "{method} {path} has no summary");
            assert!(operation["tags"].is_array(), "{method} {path} has no tag");
            let declared = operation["parameters"].as_array().map_or(&[][..], Vec::as_slice);
            let in_path = declared.iter().filter(|parameter| parameter["in"] == "path").count();
            assert_eq!(
                in_path,
                path.matches('{').count(),
                "{method} {path} does not declare its parameters"
            );
            assert!(operation["responses"]["500"].is_object(), "{method} {path} cannot fail");
        }
    }
}

/// The document with objects closed, so that a member that nobody declared is a fault.
fn strict(name: &str) -> Schema {
    let mut document = openapi::document();
    for schema in document["components"]["schemas"].as_object_mut().unwrap().values_mut() {
        if schema["properties"].is_object() {
            schema["additionalProperties"] = json!(false);
        }
    }
    Schema::named(&document, name)
}

#[track_caller]
fn assert_valid(schema: &Schema, what: &str, value: &Value) {
    let faults = schema.faults(value);
    assert!(faults.is_none(), "{what}: {}", faults.unwrap_or_default());
}

/// The report of a job, as it is written.
fn solve(job: &Value) -> Value {
    let job = Job::from_value(job).unwrap();
    serde_json::to_value(report::run(&job, &mut Unobserved).unwrap()).unwrap()
}

#[test]
fn examples_and_their_results_are_as_documented() {
    let (job_schema, report_schema) = (strict("ContactJob"), strict("Report"));
    for entry in fs::read_dir(root().join("api/examples")).unwrap() {
        let path = entry.unwrap().path();
        let mut job: Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
        assert_valid(&job_schema, &path.display().to_string(), &job);
        job["mesh"]["elements_per_half_width"] = json!(6);
        let mut report = solve(&job);
        assert_valid(&report_schema, &path.display().to_string(), &report);
        report["steps"][0]["contact"]["undeclared"] = json!(1);
        assert!(report_schema.faults(&report).is_some(), "the schema takes anything");
    }
}

#[test]
fn every_kind_of_result_is_as_documented() {
    let (job_schema, report_schema) = (strict("ContactJob"), strict("Report"));
    let steel = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3,
        "plasticity": {"law": "table", "points": [[0.0, 500.0], [0.01, 600.0]]}});
    let ball = json!({"shape": {"type": "cylinder", "radius": 20.0}, "material": steel});
    let shape = json!({"type": "block", "width": 100.0, "depth": 100.0});
    let block = |material: Value| json!({"shape": shape, "material": material});
    let crown = json!({"shape": {"type": "profile", "depth": 20.0, "interpolation": "smooth",
            "points": [[-4.0, -0.4], [-0.5, 0.0], [4.0, -0.3]]},
        "material": {"young_modulus": 110_000.0, "poisson_ratio": 0.34}});
    let coarse = |analysis: &str, upper: &Value, lower: &Value, load: Value| {
        json!({"analysis": analysis, "upper": upper, "lower": lower, "load": load,
            "mesh": {"elements_per_half_width": 6}, "output": {"fields": true},
            "tags": {"kind": "test"}})
    };
    let rigid = block(json!({"rigid": true}));
    let mut stopped = coarse("plane_strain", &ball, &ball, json!({"force": 600.0}));
    stopped["solver"] = json!({"max_iterations": 1});
    let mut plain = coarse("plane_stress", &ball, &ball, json!({"approach": 0.01}));
    plain["output"] = json!({"subsurface": false});
    for (name, job) in [
        ("sweep", coarse("plane_strain", &ball, &rigid, json!({"forces": [100.0, 300.0, 600.0]}))),
        ("onset", coarse("axisymmetric", &ball, &rigid, json!({"onset": true}))),
        ("target", coarse("plane_strain", &ball, &rigid, json!({"target": {"half_width": 0.2}}))),
        ("profile", coarse("plane_strain", &crown, &block(steel.clone()), json!({"force": 50.0}))),
        ("stopped", stopped),
        ("plain", plain),
    ] {
        assert_valid(&job_schema, name, &job);
        assert_valid(&report_schema, name, &solve(&job));
    }
}
