//! The page's types of what goes over the wire, from the schemas of the document.

use std::fmt::Write;

use serde_json::Value;

const HEAD: &str = "\
/**
 * What goes over the wire, one type for each schema of the OpenAPI document. Generated from it:
 * `BRINELL_WRITE=1 cargo test --test openapi`.
 *
";

pub fn types(document: &Value) -> String {
    let mut text = HEAD.to_owned();
    for (name, schema) in document["components"]["schemas"].as_object().into_iter().flatten() {
        if let Some(properties) = schema["properties"].as_object() {
            writeln!(text, " * @typedef {{object}} {name}").unwrap();
            for (key, property) in properties {
                let is_required =
                    schema["required"].as_array().is_some_and(|all| all.iter().any(|one| one == key));
                let key = if is_required { key.clone() } else { format!("[{key}]") };
                writeln!(text, " * @property {{{}}} {key}", type_of(property)).unwrap();
            }
        } else {
            writeln!(text, " * @typedef {{{}}} {name}", type_of(schema)).unwrap();
        }
        text += " *\n";
    }
    text += " */\n\nexport {};\n";
    text
}

/// A schema as TypeScript writes its type.
fn type_of(schema: &Value) -> String {
    if let Some(target) = schema["$ref"].as_str() {
        return target.rsplit('/').next().unwrap_or_default().to_owned();
    }
    for union in ["oneOf", "anyOf"] {
        if let Some(variants) = schema[union].as_array() {
            return variants.iter().map(type_of).collect::<Vec<_>>().join(" | ");
        }
    }
    if let Some(words) = schema["enum"].as_array() {
        return words.iter().map(Value::to_string).collect::<Vec<_>>().join(" | ").replace('"', "'");
    }
    if schema["const"].is_string() || schema["const"].is_boolean() {
        return schema["const"].to_string().replace('"', "'");
    }
    if let Some(kinds) = schema["type"].as_array() {
        let plain = |kind: &Value| {
            let mut one = schema.clone();
            one["type"] = kind.clone();
            type_of(&one)
        };
        return kinds.iter().map(plain).collect::<Vec<_>>().join(" | ");
    }
    match schema["type"].as_str() {
        Some("string") => "string".to_owned(),
        Some("number" | "integer") => "number".to_owned(),
        Some("boolean") => "boolean".to_owned(),
        Some("null") => "null".to_owned(),
        Some("array") => match schema["prefixItems"].as_array() {
            Some(items) => format!("[{}]", items.iter().map(type_of).collect::<Vec<_>>().join(", ")),
            None if schema["minItems"].is_u64() && schema["minItems"] == schema["maxItems"] => {
                let count = schema["minItems"].as_u64().map_or(0, |count| usize::try_from(count).unwrap());
                format!("[{}]", vec![type_of(&schema["items"]); count].join(", "))
            }
            None => format!("({})[]", type_of(&schema["items"])),
        },
        Some("object") if schema["properties"].is_object() => {
            let properties = schema["properties"].as_object().into_iter().flatten();
            let members = properties.map(|(key, one)| format!("{key}: {}", type_of(one)));
            format!("{{{}}}", members.collect::<Vec<_>>().join(", "))
        }
        Some("object") if schema["additionalProperties"].is_object() => {
            format!("Record<string, {}>", type_of(&schema["additionalProperties"]))
        }
        _ => "any".to_owned(),
    }
}
