//! Schemas: their members, and the type of a value in words.

use std::fmt::Write as _;

use serde_json::Value;

use super::text::{escaped, inline, paragraphs};

const BASE: &str = "#/components/schemas/";

/// Every schema of the document.
pub(super) fn schemas(html: &mut String, document: &Value) {
    html.push_str("<section aria-labelledby=\"schemas\">\n<h2 id=\"schemas\">schemas</h2>\n");
    for (name, schema) in document["components"]["schemas"].as_object().into_iter().flatten() {
        let name = escaped(name);
        let _ = write!(
            html,
            "<article id=\"schema-{name}\" aria-labelledby=\"name-{name}\">\n<h3 \
             id=\"name-{name}\"><code>{name}</code></h3>\n{}",
            paragraphs(schema["description"].as_str().unwrap_or_default())
        );
        if schema["properties"].is_object() {
            members(html, schema);
        } else {
            let _ = writeln!(html, "<p>{}</p>", kind(schema));
        }
        html.push_str("</article>\n");
    }
    html.push_str("</section>\n");
}

/// The members of an object; those that belong to another kind of object are left out.
fn members(html: &mut String, schema: &Value) {
    let required = schema["required"].as_array().cloned().unwrap_or_default();
    html.push_str("<dl>\n");
    for (name, property) in schema["properties"].as_object().into_iter().flatten() {
        if property["type"] == "null" {
            continue;
        }
        let is_required = required.iter().any(|one| one == name);
        entry(html, name, is_required, property, property["description"].as_str());
    }
    html.push_str("</dl>\n");
}

/// One member: its name and its description.
pub(super) fn entry(
    html: &mut String,
    name: &str,
    is_required: bool,
    schema: &Value,
    description: Option<&str>,
) {
    let required = if is_required { " <span class=\"tag\">required</span>" } else { "" };
    let _ = writeln!(
        html,
        "<dt><code>{}</code> <span class=\"quiet\">{}</span>{required}</dt>\n<dd>{}</dd>",
        escaped(name),
        kind(schema),
        inline(description.unwrap_or_default())
    );
}

/// Returns the type of a value in words.
pub(super) fn kind(schema: &Value) -> String {
    if let Some(name) = schema["$ref"].as_str().and_then(|target| target.strip_prefix(BASE)) {
        let name = escaped(name);
        return format!("<a href=\"#schema-{name}\">{name}</a>");
    }
    for (part, between) in [("oneOf", " or "), ("anyOf", " or "), ("allOf", " and ")] {
        if let Some(parts) = schema[part].as_array() {
            return parts.iter().map(kind).collect::<Vec<_>>().join(between);
        }
    }
    if let Some(words) =
        schema["enum"].as_array().or_else(|| schema["x-extensible-enum"].as_array())
    {
        let words: Vec<_> =
            words.iter().map(|word| format!("<code>{}</code>", plain(word))).collect();
        return words.join(", ");
    }
    if !schema["const"].is_null() {
        return format!("<code>{}</code>", plain(&schema["const"]));
    }
    if schema["items"].is_object() {
        return format!("list of {}", kind(&schema["items"]));
    }
    if let Some(items) = schema["prefixItems"].as_array() {
        let items: Vec<_> = items.iter().map(kind).collect();
        return format!("list of {}", items.join(", "));
    }
    let types = match &schema["type"] {
        Value::Array(types) => types.iter().map(plain).collect::<Vec<_>>().join(" or "),
        Value::Null => "any value".to_owned(),
        one => plain(one),
    };
    let mut written = types;
    for (key, word) in [
        ("format", ""),
        ("minimum", "from "),
        ("exclusiveMinimum", "above "),
        ("maximum", "to "),
        ("exclusiveMaximum", "below "),
        ("maxLength", "at most "),
    ] {
        if !schema[key].is_null() {
            let _ = write!(written, ", {word}{}", plain(&schema[key]));
        }
    }
    written
}

/// A word or a number of the document.
fn plain(value: &Value) -> String {
    escaped(&value.as_str().map_or_else(|| value.to_string(), str::to_owned))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_value_is_told_in_words() {
        for (schema, expected) in [
            (
                json!({"type": "number", "minimum": 0, "exclusiveMaximum": 0.5}),
                "number, from 0, below 0.5",
            ),
            (
                json!({"type": ["string", "null"], "format": "date-time"}),
                "string or null, date-time",
            ),
            (
                json!({"type": "array", "items": {"type": "array", "items": {"type": "integer"}}}),
                "list of list of integer",
            ),
            (
                json!({"oneOf": [{"$ref": "#/components/schemas/Job"}, {"type": "null"}]}),
                "<a href=\"#schema-Job\">Job</a> or null",
            ),
            (json!({"enum": ["a<b"]}), "<code>a&lt;b</code>"),
            (json!({}), "any value"),
        ] {
            assert_eq!(kind(&schema), expected);
        }
    }
}
