//! A small vocabulary for JSON Schema, so that a field is one line: name, unit, meaning, example.

use serde_json::{Map, Value, json};

/// A member of an object.
pub(super) struct Field {
    name: &'static str,
    schema: Value,
    required: bool,
}

/// A member that is always there.
pub(super) fn field(name: &'static str, schema: Value) -> Field {
    Field { name, schema, required: true }
}

/// A member that may be missing.
pub(super) fn optional(name: &'static str, schema: Value) -> Field {
    Field { name, schema, required: false }
}

/// An object with these members.
pub(super) fn object(description: &str, fields: impl IntoIterator<Item = Field>) -> Value {
    let (mut properties, mut required) = (Map::new(), Vec::new());
    for Field { name, schema, required: is_required } in fields {
        properties.insert(name.to_owned(), schema);
        if is_required {
            required.push(name);
        }
    }
    let mut object = json!({"type": "object", "description": description, "properties": properties});
    if !required.is_empty() {
        object["required"] = json!(required);
    }
    object
}

/// A schema of the document by its name.
pub(super) fn named(name: &str) -> Value {
    json!({"$ref": format!("#/components/schemas/{name}")})
}

/// The same in a role of its own.
pub(super) fn named_as(name: &str, description: &str) -> Value {
    json!({"$ref": format!("#/components/schemas/{name}"), "description": description})
}

/// Exactly one of these.
pub(super) fn one_of(description: &str, variants: &[&str]) -> Value {
    let references: Vec<_> = variants.iter().map(|name| named(name)).collect();
    json!({"description": description, "oneOf": references})
}

/// This, or `null`.
pub(super) fn nullable(name: &str, description: &str) -> Value {
    json!({"description": description, "oneOf": [named(name), {"type": "null"}]})
}

/// One of these words.
pub(super) fn words(description: &str, words: &[&str]) -> Value {
    json!({"type": "string", "description": description, "enum": words})
}

/// Some text.
pub(super) fn text(description: &str, example: &str) -> Value {
    json!({"type": "string", "description": description, "examples": [example]})
}

/// True or false.
pub(super) fn truth(description: &str) -> Value {
    json!({"type": "boolean", "description": description})
}

/// A count.
pub(super) fn count(description: &str, example: u64) -> Value {
    json!({"type": "integer", "minimum": 0, "description": description, "examples": [example]})
}

/// What a figure of a result is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    Length,
    Area,
    Stress,
    Force,
    Stiffness,
    Energy,
    Milliseconds,
    Pure,
}

impl Unit {
    const fn words(self) -> &'static str {
        match self {
            Self::Length => "Unit: mm (SI: m).",
            Self::Area => "Unit: mm² (SI: m²).",
            Self::Stress => "Unit: MPa (SI: Pa).",
            Self::Force => "Unit: N/mm (SI: N/m) of thickness; N in axisymmetry.",
            Self::Stiffness => "Unit: N/mm² (SI: N/m²); in axisymmetry N/mm (SI: N/m).",
            Self::Energy => "Unit: N (SI: N) of thickness, force times length; N mm (SI: J) in axisymmetry.",
            Self::Milliseconds => "Unit: ms.",
            Self::Pure => "Without unit.",
        }
    }
}

/// A figure of a result that may have either sign.
pub(super) fn signed(unit: Unit, description: &str, example: f64) -> Value {
    json!({"type": "number", "description": format!("{description} {}", unit.words()), "examples": [example]})
}

/// A figure of a result that is never negative.
pub(super) fn figure(unit: Unit, description: &str, example: f64) -> Value {
    let mut figure = signed(unit, description, example);
    figure["minimum"] = json!(0);
    figure
}

/// A figure of a result, or `null` where there is none.
pub(super) fn figure_or_null(unit: Unit, description: &str, example: f64) -> Value {
    let mut figure = figure(unit, description, example);
    figure["type"] = json!(["number", "null"]);
    figure
}

/// A list of figures of a result.
pub(super) fn list(unit: Unit, description: &str, example: &[f64]) -> Value {
    json!({"type": "array", "items": {"type": "number"},
        "description": format!("{description} {}", unit.words()), "examples": [example]})
}

/// A list of these.
pub(super) fn list_of(description: &str, items: Value) -> Value {
    let mut list = json!({"type": "array", "description": description});
    list["items"] = items;
    list
}

/// A pair of numbers.
pub(super) fn pair(description: &str, first: &Value, second: &Value) -> Value {
    json!({"type": "array", "description": description, "prefixItems": [first, second],
        "minItems": 2, "maxItems": 2})
}
