//! Completion of derived schemas: units and signs from the doc comments, and optional members.
//!
//! A doc comment names the quantity of a figure in brackets, `Half-width a [length >= 0].`, which
//! becomes the unit in either system and the smallest value. An optional member is never `null`; a
//! nullable member is never missing.

use serde_json::{Map, Value, json};

use super::reference::BASE;

/// Quantities of results, and their units in words.
const UNITS: [(&str, &str); 13] = [
    ("length", "Unit: mm (SI: m)."),
    ("area", "Unit: mm² (SI: m²)."),
    ("volume", "Unit: mm³ (SI: m³)."),
    ("stress", "Unit: MPa (SI: Pa)."),
    ("force", "Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions."),
    ("stiffness", "Unit: N/mm² (SI: N/m²); in axisymmetry and three dimensions N/mm (SI: N/m)."),
    (
        "energy",
        "Unit: N (SI: N) of thickness, force times length; N mm (SI: J) in axisymmetry and three \
         dimensions.",
    ),
    ("degrees", "Unit: degree."),
    ("mrad", "Unit: mrad."),
    (
        "length, stress or 1",
        "Unit: that of the figure, mm or MPa (SI: m or Pa); plastic strain without one.",
    ),
    ("ms", "Unit: ms."),
    ("bytes", "Unit: byte."),
    ("1", "Without unit."),
];

/// Lists of fixed length, which the derivation cannot know: schema, member, length.
const TUPLES: [(&str, &str, usize); 4] = [
    ("Fields", "nodes", 2),
    ("Fields", "displacement", 2),
    ("Fields", "elements", 4),
    ("PlasticZone", "outline", 2),
];

/// Schemas of requests, in which `null` equals a missing member.
const REQUESTS: [&str; 1] = ["BatchedJob"];

/// Completes every schema.
pub(super) fn complete(schemas: &mut Map<String, Value>) {
    name_parts(schemas);
    for (name, schema) in schemas {
        complete_object(schema, !REQUESTS.contains(&name.as_str()));
    }
}

/// Names the schemas that the derivation writes inline: values for each body, and the kinds of
/// load.
fn name_parts(schemas: &mut Map<String, Value>) {
    let generic: Vec<_> =
        schemas.keys().filter_map(|name| name.strip_prefix(PER_BODY)).map(str::to_owned).collect();
    for part in generic {
        let Some(mut bodies) = schemas.remove(&format!("{PER_BODY}{part}")) else { continue };
        for side in ["upper", "lower"] {
            let body = bodies["properties"][side]["oneOf"]
                .as_array_mut()
                .and_then(Vec::pop)
                .unwrap_or_default();
            schemas.insert(part.clone(), body);
            bodies["properties"][side] = json!({
                "description": format!("Of the {side} body; null if it is rigid or the step was \
                                        stopped."),
                "oneOf": [{"$ref": format!("{BASE}{part}")}, {"type": "null"}],
            });
        }
        schemas.insert(format!("{part}OfBodies"), bodies);
    }
    for variant in schemas["LoadReport"]["oneOf"].as_array().cloned().unwrap_or_default() {
        let kind = variant["required"][0].as_str().unwrap_or_default().to_owned();
        schemas.insert(prescribed(&kind), variant);
    }
    let kinds =
        ["force", "approach"].map(|kind| json!({"$ref": format!("{BASE}{}", prescribed(kind))}));
    schemas["LoadReport"]["oneOf"] = json!(kinds);
    for (name, member, length) in TUPLES {
        let mut items = &mut schemas[name]["properties"][member]["items"];
        while items["items"]["items"].is_object() {
            items = &mut items["items"];
        }
        items["minItems"] = json!(length);
        items["maxItems"] = json!(length);
    }
}

/// Name that the derivation gives to a value for each body.
const PER_BODY: &str = "PerBody_Option_";

fn prescribed(kind: &str) -> String {
    let (first, rest) = kind.split_at(1);
    format!("Prescribed{}{rest}", first.to_uppercase())
}

fn complete_object(schema: &mut Value, is_answer: bool) {
    describe(schema);
    if let Some(target) = schema["$ref"]
        .as_str()
        .and_then(|target| target.strip_prefix(BASE)?.strip_prefix(PER_BODY))
    {
        schema["$ref"] = json!(format!("{BASE}{target}OfBodies"));
    }
    if let Some(example) = schema.as_object_mut().and_then(|members| members.remove("example")) {
        schema["examples"] = json!([example]);
    }
    let required = schema["required"].as_array().cloned().unwrap_or_default();
    for (key, property) in schema["properties"].as_object_mut().into_iter().flatten() {
        if is_answer && !required.contains(&json!(key)) {
            never_null(property);
        }
        complete_object(property, is_answer);
    }
    for part in ["oneOf", "allOf", "prefixItems"] {
        schema[part]
            .as_array_mut()
            .into_iter()
            .flatten()
            .for_each(|part| complete_object(part, is_answer));
    }
    if schema["items"].is_object() {
        complete_object(&mut schema["items"], is_answer);
    }
    // Indexing creates a missing member; it is removed again.
    if let Some(members) = schema.as_object_mut() {
        members.retain(|_, member| !member.is_null());
    }
}

/// Takes `null` out of a schema.
fn never_null(schema: &mut Value) {
    if let Some([first, _]) = schema["type"].as_array().map(Vec::as_slice) {
        schema["type"] = first.clone();
    }
    let Some(variants) = schema["oneOf"].as_array() else { return };
    let others: Vec<_> =
        variants.iter().filter(|variant| variant["type"] != "null").cloned().collect();
    if let ([only], Some(members)) = (others.as_slice(), schema.as_object_mut()) {
        members.remove("oneOf");
        members.extend(only.as_object().cloned().unwrap_or_default());
    }
}

/// Writes the unit that a description names, and its sign.
fn describe(schema: &mut Value) {
    let Some(text) = schema["description"].as_str() else { return };
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let found = UNITS.iter().find_map(|(name, unit)| {
        let (plain, positive) = (format!(" \\[{name}\\]"), format!(" \\[{name} >= 0\\]"));
        let is_positive = text.contains(&positive);
        let tag = if is_positive { positive } else { plain };
        text.contains(&tag).then(|| (format!("{} {unit}", text.replace(&tag, "")), is_positive))
    });
    if let Some((described, is_positive)) = found {
        schema["description"] = json!(described);
        if is_positive {
            schema["minimum"] = json!(0);
        }
    } else {
        schema["description"] = json!(text);
    }
}
