//! `GET /docs/`: the OpenAPI document for a person to read, written as one page of plain HTML in
//! the style of the page at `/`.

mod operation;
mod schema;
mod text;

use std::fmt::Write as _;
use std::sync::LazyLock;

use axum::http::HeaderName;
use axum::http::header::{CACHE_CONTROL, CONTENT_SECURITY_POLICY};
use axum::response::{Html, IntoResponse, Redirect};
use serde_json::Value;

use super::openapi;
use super::page::POLICY;
use operation::{operation, operations};
use schema::schemas;
use text::{escaped, paragraphs};

/// `GET /docs`: addresses in the page are relative to `/docs/`, so that it stands below the path
/// of a proxy too.
pub(super) async fn to_page() -> Redirect {
    Redirect::permanent("docs/")
}

/// `GET /docs/`.
pub(super) async fn page() -> impl IntoResponse {
    static PAGE: LazyLock<String> = LazyLock::new(|| write(&openapi::document()));
    let headers: [(HeaderName, &str); 2] =
        [(CACHE_CONTROL, "no-cache"), (CONTENT_SECURITY_POLICY, POLICY)];
    (headers, Html(PAGE.as_str()))
}

/// The whole page.
fn write(document: &Value) -> String {
    let info = &document["info"];
    let mut html = HEAD.to_owned();
    let tags = document["tags"].as_array().map_or(&[][..], Vec::as_slice);
    html.push_str("<nav id=\"contents\" aria-label=\"Operations\">\n");
    for tag in tags {
        let name = tag["name"].as_str().unwrap_or_default();
        let _ = write!(html, "<h2><a href=\"#tag-{0}\">{0}</a></h2>\n<ul>\n", escaped(name));
        for (method, path, body) in operations(document, name) {
            let id = escaped(body["operationId"].as_str().unwrap_or_default());
            let _ = writeln!(
                html,
                "<li><a href=\"#{id}\"><span class=\"method\">{method}</span> \
                 <code>{}</code></a></li>",
                escaped(path)
            );
        }
        html.push_str("</ul>\n");
    }
    html.push_str(
        "<h2><a href=\"#schemas\">schemas</a></h2>\n</nav>\n<main id=\"interface\" \
         tabindex=\"-1\">\n",
    );
    let _ = write!(
        html,
        "<section aria-label=\"About\">\n<h1>{} {}</h1>\n{}<p>For programs: <a \
         href=\"../openapi.json\">openapi.json</a>.</p>\n</section>\n",
        escaped(info["title"].as_str().unwrap_or_default()),
        escaped(info["version"].as_str().unwrap_or_default()),
        paragraphs(info["description"].as_str().unwrap_or_default())
    );
    for tag in tags {
        let name = tag["name"].as_str().unwrap_or_default();
        let _ = write!(
            html,
            "<section aria-labelledby=\"tag-{0}\">\n<h2 id=\"tag-{0}\">{0}</h2>\n{1}",
            escaped(name),
            paragraphs(tag["description"].as_str().unwrap_or_default())
        );
        for (method, path, body) in operations(document, name) {
            operation(&mut html, document, method, path, body);
        }
        html.push_str("</section>\n");
    }
    schemas(&mut html, document);
    html.push_str("</main>\n</body>\n</html>\n");
    html
}

const HEAD: &str = "<!doctype html>
<html lang=\"en\" data-colours=\"light\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">
<meta name=\"color-scheme\" content=\"light dark\">
<title>Brinell: the interface</title>
<link rel=\"icon\" href=\"../web/favicon.svg\" type=\"image/svg+xml\">
<link rel=\"stylesheet\" href=\"../web/style/base.css\">
<link rel=\"stylesheet\" href=\"../web/docs/docs.css\">
<script type=\"module\" src=\"../web/docs/docs.js\"></script>
</head>
<body class=\"docs\">
<a class=\"skip\" href=\"#interface\">Skip to the interface</a>
<header>
<p class=\"name\"><a href=\"../\">Brinell</a></p>
<p>the interface</p>
<div class=\"tools\"><button type=\"button\" id=\"theme\" aria-label=\"Auto: colours as the system\">Auto</button></div>
</header>
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_is_documented_is_on_the_page() {
        let document = openapi::document();
        let html = write(&document);
        for (path, item) in document["paths"].as_object().unwrap() {
            for operation in item.as_object().unwrap().values() {
                let id = operation["operationId"].as_str().unwrap();
                assert!(html.contains(&format!("<article id=\"{id}\"")), "{path}");
            }
        }
        for name in document["components"]["schemas"].as_object().unwrap().keys() {
            assert!(html.contains(&format!("<article id=\"schema-{name}\"")), "{name}");
        }
        // Every link within the page leads somewhere, and no id is there twice.
        for target in html.split("href=\"#").skip(1).map(|rest| rest.split('"').next().unwrap()) {
            assert_eq!(html.matches(&format!(" id=\"{target}\"")).count(), 1, "{target}");
        }
    }
}
