//! The page's types of what goes over the wire, from the schemas of the document.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use serde_json::{Value, json};

const HEAD: &str = "\
/**
 * What goes over the wire: the schemas of the OpenAPI document that the page names, and those that
 * they refer to. Generated from it: `BRINELL_WRITE=1 cargo test --test openapi`.
 *
";

/// The types that a module of the page imports from this one.
pub fn types(document: &Value, page: &str) -> String {
    let is_letter = |sign: &char| sign.is_ascii_alphanumeric();
    let named =
        page.split("wire.js').").skip(1).map(|rest| rest.chars().take_while(is_letter).collect());
    let mut text = HEAD.to_owned();
    for name in reached(document, named.collect()) {
        let schema = &document["components"]["schemas"][&name];
        if let Some(properties) = schema["properties"].as_object() {
            writeln!(text, " * @typedef {{object}} {name}").unwrap();
            for (key, property) in properties {
                let is_required = schema["required"]
                    .as_array()
                    .is_some_and(|all| all.iter().any(|one| one == key));
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

/// These schemas, and all that they refer to.
fn reached(document: &Value, mut wanted: Vec<String>) -> BTreeSet<String> {
    fn refer(node: &Value, wanted: &mut Vec<String>) {
        match node {
            Value::Object(members) => {
                for (key, one) in members {
                    match one.as_str() {
                        Some(target) if key == "$ref" => {
                            wanted.push(target.rsplit('/').next().unwrap().to_owned());
                        }
                        _ => refer(one, wanted),
                    }
                }
            }
            Value::Array(items) => items.iter().for_each(|one| refer(one, wanted)),
            _ => {}
        }
    }
    let mut seen = BTreeSet::new();
    while let Some(name) = wanted.pop() {
        if seen.insert(name.clone()) {
            refer(&document["components"]["schemas"][&name], &mut wanted);
        }
    }
    seen
}

/// What a figure is whose description ends like this.
const SAID: [(&str, &str); 4] = [
    ("length", "Unit: mm (SI: m)."),
    ("stress", "Unit: MPa (SI: Pa)."),
    ("load", "Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions."),
    ("slope", "Unit: N/mm² (SI: N/m²); in axisymmetry and three dimensions N/mm (SI: N/m)."),
];

/// The keys of every quantity in a report, and of the figures for which a force can be looked for.
pub fn figures(document: &Value) -> String {
    let mut found: BTreeMap<&str, &str> = BTreeMap::new();
    for name in reached(document, vec!["Report".to_owned(), "TargetLoad".to_owned()]) {
        let schema = &document["components"]["schemas"][&name];
        for (key, property) in schema["properties"].as_object().into_iter().flatten() {
            let said = property["description"].as_str().unwrap_or_default();
            let Some((quantity, _)) = SAID.iter().find(|(_, unit)| said.ends_with(unit)) else {
                continue;
            };
            let before = found.insert(key, quantity);
            assert!(
                before.is_none_or(|before| before == *quantity),
                "{key} is a {quantity} in {name}"
            );
        }
    }
    let mut text = "\
/** The figures of a result by what they are; those without unit are left out. @type {Record<string, string[]>} */
/* prettier-ignore */
export const FIGURES = {
"
    .to_owned();
    for (quantity, _) in SAID {
        let keys: Vec<&str> =
            found.iter().filter(|(_, one)| **one == quantity).map(|(key, _)| *key).collect();
        writeln!(text, "  {quantity}: {},", json!(keys)).unwrap();
    }
    text + "};\n"
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
        return words
            .iter()
            .map(Value::to_string)
            .collect::<Vec<_>>()
            .join(" | ")
            .replace('"', "'");
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
            Some(items) => {
                format!("[{}]", items.iter().map(type_of).collect::<Vec<_>>().join(", "))
            }
            None if schema["minItems"].is_u64() && schema["minItems"] == schema["maxItems"] => {
                let count =
                    schema["minItems"].as_u64().map_or(0, |count| usize::try_from(count).unwrap());
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
