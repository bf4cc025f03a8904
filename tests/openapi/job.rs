//! The schema of a job beside the reader: what the reader refuses by its form is not in the schema.

use brinell::http::openapi::document;
use brinell_solver::job::Job;
use serde_json::{Value, json};

use crate::schema::Schema;

#[test]
fn what_is_refused_by_its_form_is_refused_by_the_schema() {
    let text = include_str!("../../api/examples/two_cylinders.json");
    let schema = Schema::named(&document(), "ContactJob");
    for (pointer, value) in [
        ("/analysis", json!("plane")),
        ("/upper/shape/radius", json!(-20.0)),
        ("/upper/shape/raduis", json!(20.0)),
        ("/upper/shape/type", json!("cone")),
        ("/upper/support", json!("glued")),
        ("/upper/material/poisson_ratio", json!(0.5)),
        ("/upper/material/plasticity/law", json!("linear")),
        ("/upper/material/plasticity/rate", json!(1.0)),
        ("/lower/material", json!({"rigid": false})),
        ("/load", json!({"force": 1.0, "approach": 1.0})),
        ("/load/force", json!(0.0)),
        ("/load", json!({"forces": []})),
        ("/load", json!({"forces": 612})),
        ("/mesh/elements_per_half_width", json!(3)),
        ("/solver/tolerance", json!(1.0)),
        ("/output/fields", json!("yes")),
        ("/tags", json!({"": "empty key"})),
        ("/tags", json!({"key": 1})),
        ("/colour", json!("red")),
    ] {
        let mut job: Value = serde_json::from_str(text).unwrap();
        assert_eq!(schema.faults(&job), None);
        let (parent, key) = pointer.rsplit_once('/').unwrap();
        job.pointer_mut(parent).unwrap()[key] = value;
        assert!(schema.faults(&job).is_some(), "{pointer}");
        assert!(Job::from_value(&job).is_err(), "{pointer}");
    }
}
