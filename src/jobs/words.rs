//! Words that jobs are found by: those of title and labels, and the kinds of their shapes and
//! materials.

use std::collections::BTreeSet;

use serde::Deserialize;
use serde_json::Value;

/// What the text of a job says of what it is about.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Described {
    title: Value,
    tags: Value,
    upper: Value,
    lower: Value,
}

/// Most words of a job, and most characters of a word.
const MOST: usize = 32;
const LENGTH: usize = 40;

/// Splits a text into words, in lower case.
pub fn words(text: &str) -> impl Iterator<Item = String> {
    let words = text.split(|character: char| !character.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty());
    words.map(|word| word.to_lowercase().chars().take(LENGTH).collect())
}

/// Returns the label under which the store keeps a word. No client's label has a name like this
/// one, because names are printable.
pub fn label_of(word: &str) -> (String, String) {
    (format!("\u{1}{word}"), String::new())
}

/// Returns the words of the text of a job.
pub(super) fn words_of(request: &[u8]) -> BTreeSet<String> {
    let described: Described = serde_json::from_slice(request).unwrap_or_default();
    let mut texts = Vec::new();
    kinds(&described.title, &mut texts);
    for body in [&described.upper, &described.lower] {
        kinds(&body["shape"], &mut texts);
        kinds(&body["material"], &mut texts);
    }
    kinds(&described.tags, &mut texts);
    texts.extend(described.tags.as_object().into_iter().flat_map(|tags| tags.keys().cloned()));
    texts.iter().flat_map(|text| words(text)).take(MOST).collect()
}

/// Gathers the texts of a document, and the names of members that are switched on.
fn kinds(value: &Value, texts: &mut Vec<String>) {
    match value {
        Value::String(text) => texts.push(text.clone()),
        Value::Object(members) => {
            for (name, member) in members {
                if *member == Value::Bool(true) {
                    texts.push(name.clone());
                }
                kinds(member, texts);
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_has_the_words_of_its_title_its_shapes_and_its_materials() {
        let mut job: Value =
            serde_json::from_str(include_str!("../../api/examples/two_cylinders.json")).unwrap();
        job["title"] = "Roller 7, of the PRESS".into();
        job["tags"] = serde_json::json!({"bearing": "NU-210"});
        job["lower"]["material"] = serde_json::json!({"rigid": true});
        let words = words_of(job.to_string().as_bytes());
        for word in ["roller", "7", "press", "cylinder", "rigid", "bearing", "210"] {
            assert!(words.contains(word), "{word} of {words:?}");
        }
    }
}
