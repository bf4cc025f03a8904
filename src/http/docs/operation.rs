//! Operations with their parameters, bodies and answers.

use std::fmt::Write as _;

use serde_json::Value;

use super::schema::{entry, kind};
use super::text::{escaped, inline, paragraphs};

/// The order of the operations of an address.
const METHODS: [&str; 3] = ["get", "post", "delete"];

/// The operations of a tag: method, path and the rest.
pub(super) fn operations<'a>(
    document: &'a Value,
    tag: &'a str,
) -> impl Iterator<Item = (&'static str, &'a str, &'a Value)> {
    let paths = document["paths"].as_object().into_iter().flatten();
    let all = paths.flat_map(|(path, item)| {
        METHODS.iter().filter_map(move |method| Some((*method, path.as_str(), item.get(method)?)))
    });
    let tagged = all.filter(move |(_, _, body)| {
        body["tags"].as_array().is_some_and(|tags| tags.iter().any(|one| one == tag))
    });
    // The tags that most readers want come first.
    let (first, rest): (Vec<_>, Vec<_>) = tagged.partition(|(_, path, _)| *path == "/v1/solve");
    first.into_iter().chain(rest)
}

/// One operation.
pub(super) fn operation(
    html: &mut String,
    document: &Value,
    method: &str,
    path: &str,
    body: &Value,
) {
    let id = escaped(body["operationId"].as_str().unwrap_or_default());
    let _ = write!(
        html,
        "<article id=\"{id}\" aria-labelledby=\"name-{id}\">\n<h3 id=\"name-{id}\"><span \
         class=\"method\">{method}</span> <code>{}</code></h3>\n\
         <p class=\"summary\">{}</p>\n{}",
        escaped(path),
        inline(body["summary"].as_str().unwrap_or_default()),
        paragraphs(body["description"].as_str().unwrap_or_default())
    );
    parameters(html, body);
    if let Some(content) = body["requestBody"]["content"].as_object() {
        html.push_str("<h4>Body</h4>\n");
        for (media, form) in content {
            let text = inline(body["requestBody"]["description"].as_str().unwrap_or_default());
            let _ = writeln!(
                html,
                "<p><code>{}</code>: {}. {text}</p>",
                escaped(media),
                kind(&form["schema"])
            );
            examples(html, document, form);
        }
    }
    calls(html, method, path, body);
    html.push_str("<h4>Answers</h4>\n<dl>\n");
    for (status, response) in body["responses"].as_object().into_iter().flatten() {
        let forms: Vec<String> =
            response["content"].as_object().map_or_else(Vec::new, |content| {
                let form = |(media, form): (&String, &Value)| {
                    format!("{} {}", escaped(media), kind(&form["schema"]))
                };
                content.iter().map(form).collect()
            });
        let _ = writeln!(
            html,
            "<dt><code>{}</code> <span class=\"quiet\">{}</span></dt>\n<dd>{}</dd>",
            escaped(status),
            forms.join(", "),
            inline(response["description"].as_str().unwrap_or_default())
        );
    }
    html.push_str("</dl>\n</article>\n");
}

/// Examples of the request in a shell and in Python's standard library.
fn calls(html: &mut String, method: &str, path: &str, body: &Value) {
    const BASE: &str = "http://127.0.0.1:8080";
    let address = format!("{BASE}{path}");
    let has_body = body["requestBody"].is_object();
    let is_json = body["responses"]
        .as_object()
        .into_iter()
        .flatten()
        .filter(|(status, _)| status.starts_with('2'))
        .any(|(_, response)| response["content"]["application/json"].is_object());
    let mut curl = format!("curl -s '{address}'");
    let mut python = "import json\nimport urllib.request\n\n".to_owned();
    let mut arguments = format!("\"{address}\"");
    if has_body {
        curl.push_str(" -H 'Content-Type: application/json' -d @job.json");
        arguments.push_str(
            ", data=open(\"job.json\", \"rb\").read(), headers={\"Content-Type\": \
             \"application/json\"}",
        );
    }
    if method != "get" && !(method == "post" && has_body) {
        let _ = write!(curl, " -X {}", method.to_uppercase());
        let _ = write!(arguments, ", method=\"{}\"", method.to_uppercase());
    }
    let read = if is_json { "json.load(response)" } else { "response.read()" };
    let _ = write!(
        python,
        "request = urllib.request.Request({arguments})\nwith urllib.request.urlopen(request) as \
         response:\n    answer = {read}"
    );
    if !is_json {
        python = python.replace("import json\n", "");
    }
    for (name, text) in [("curl", curl), ("Python", python)] {
        let _ = writeln!(
            html,
            "<details><summary>{name}</summary>\n<pre class=\"scroll\" tabindex=\"0\" \
             aria-label=\"{name}: {method} {path}\" role=\"region\">{}</pre>\n</details>",
            escaped(&text),
            path = escaped(path)
        );
    }
}

fn parameters(html: &mut String, body: &Value) {
    let parameters = body["parameters"].as_array().map_or(&[][..], Vec::as_slice);
    if parameters.is_empty() {
        return;
    }
    html.push_str("<h4>Parameters</h4>\n<dl>\n");
    for parameter in parameters {
        let place = parameter["in"].as_str().unwrap_or_default();
        let name = parameter["name"].as_str().unwrap_or_default();
        let name = match place {
            "query" => format!("?{name}="),
            "path" => format!("{{{name}}}"),
            _ => format!("{name}:"),
        };
        let is_required = parameter["required"] == true;
        entry(html, &name, is_required, &parameter["schema"], parameter["description"].as_str());
    }
    html.push_str("</dl>\n");
}

/// The examples of a body, folded.
fn examples(html: &mut String, document: &Value, form: &Value) {
    for example in form["examples"].as_object().into_iter().flat_map(|examples| examples.values())
    {
        let target = example["$ref"].as_str().and_then(|target| target.strip_prefix('#'));
        let example = target.and_then(|target| document.pointer(target)).unwrap_or(example);
        let name = escaped(example["summary"].as_str().unwrap_or("example"));
        let _ = writeln!(
            html,
            "<details><summary>Example: {name}</summary>\n<pre class=\"scroll\" tabindex=\"0\" \
             aria-label=\"{name}\" role=\"region\">{}</pre>\n</details>",
            escaped(&format!("{:#}", example["value"]))
        );
    }
}
