//! The document is served, and every answer is as it says.

use std::time::Instant;

use serde_json::{Value, json};

use crate::curl::{Answer, curl};
use crate::events::events;
use crate::in_process::{InProcess, job};
use crate::schema::Schema;
use crate::server::{DEADLINE, Server, Target, example};

/// A service and what it says of itself.
struct Documented<'a> {
    target: &'a Target,
    document: Value,
}

impl<'a> Documented<'a> {
    fn new(target: &'a Target) -> Self {
        Self { target, document: target.get("/openapi.json").json() }
    }

    /// Holds an answer to what the document says of this operation.
    #[track_caller]
    fn check(&self, method: &str, template: &str, answer: &Answer) {
        let operation = &self.document["paths"][template][method];
        let status = answer.status.to_string();
        let response = &operation["responses"][&status];
        assert!(response.is_object(), "{method} {template} must not answer {status}");
        for name in response["headers"].as_object().into_iter().flatten().map(|(name, _)| name) {
            let may_be_missing = ["Idempotency-Replayed", "Preference-Applied", "Retry-After"]
                .contains(&name.as_str());
            assert!(
                may_be_missing || answer.header(&name.to_lowercase()).is_some(),
                "{template} {status} {name}"
            );
        }
        let Some(content) = response["content"].as_object() else {
            return assert!(answer.body.is_empty(), "{method} {template} {status} has a body");
        };
        let declared = answer.header("content-type").unwrap_or_default();
        let essence = declared.split(';').next().unwrap_or_default();
        assert!(content.contains_key(essence), "{method} {template} {status} is {declared}");
        if essence.ends_with("json") {
            self.fits(&content[essence]["schema"], &answer.json());
        } else if essence == "text/event-stream" {
            for event in events(&answer.body) {
                let schema = match event.name.as_str() {
                    "state" => "Job",
                    "iteration" => "Iteration",
                    other => panic!("the document does not know the event {other}"),
                };
                self.fits(&json!({"$ref": format!("#/components/schemas/{schema}")}), &event.data);
            }
        }
    }

    #[track_caller]
    fn fits(&self, schema: &Value, value: &Value) {
        let mut document = self.document.clone();
        document["schema"] = schema.clone();
        let faults = Schema::at(&document, "/schema").faults(value);
        assert!(faults.is_none(), "{schema}: {faults:?}");
    }

    fn get(&self, template: &str, path: &str) -> Answer {
        let answer = self.target.get(path);
        self.check("get", template, &answer);
        answer
    }

    fn post(&self, template: &str, path: &str, body: &str, headers: &[&str]) -> Answer {
        let headers: Vec<_> = headers.iter().flat_map(|header| ["-H", header]).collect();
        let answer = self.target.post_with(path, body, &headers);
        self.check("post", template, &answer);
        answer
    }
}

const JSON: &str = "Content-Type: application/json";
const NOBODY: &str = "/v1/jobs/0197e1f0-0000-7000-8000-000000000000";

#[test]
fn answers_are_as_documented() {
    let server = Server::start();
    let service = Documented::new(&server.target);
    for path in ["/livez", "/readyz", "/openapi.json", "/v1/examples", "/v1/capacity", "/v1/jobs"]
    {
        assert_eq!(service.get(path, path).status, 200);
    }
    assert_eq!(service.get("/problems/{name}", "/problems/invalid-job").status, 200);
    assert_eq!(service.get("/problems/{name}", "/problems/none").status, 404);
    assert_eq!(service.get("/v1/jobs", "/v1/jobs?limit=0").status, 400);
    let text = example().to_string();
    for path in ["/v1/validate", "/v1/hertz", "/v1/solve"] {
        assert_eq!(service.post(path, path, &text, &[JSON]).status, 200);
    }
    for path in ["/v1/validate", "/v1/hertz", "/v1/solve", "/v1/jobs"] {
        assert_eq!(service.post(path, path, "{", &[JSON]).status, 400);
        assert_eq!(service.post(path, path, "{}", &[JSON]).status, 422);
        assert_eq!(service.post(path, path, &text, &["Content-Type: text/plain"]).status, 415);
        assert_eq!(service.post(path, path, &"[".repeat(2 << 20), &[JSON]).status, 413);
    }
    let path = "/v1/hardening-curves";
    let test = r#"{"points": [[0, 0], [0.001, 210], [0.01, 380], [0.05, 450]],
        "young_modulus": 210000}"#;
    assert_eq!(service.post(path, path, test, &[JSON]).status, 200);
    assert_eq!(service.post(path, path, "{}", &[JSON]).status, 422);
    let id = "/v1/jobs/{id}";
    let accepted =
        service.post("/v1/jobs", "/v1/jobs", &text, &[JSON, "Idempotency-Key: press-7"]);
    let path = accepted.header("location").unwrap().to_owned();
    let replayed = service.post(
        "/v1/jobs",
        "/v1/jobs",
        &text,
        &[JSON, "Idempotency-Key: press-7", "Prefer: wait=60"],
    );
    assert_eq!((replayed.status, replayed.header("preference-applied")), (200, Some("wait=60")));
    assert_eq!(
        service.post("/v1/jobs", "/v1/jobs", &text, &[JSON, "Idempotency-Key: é"]).status,
        400
    );
    assert_eq!(service.get(id, &path).json()["status"], "succeeded");
    assert_eq!(service.get(id, &format!("{path}?wait=soon")).status, 400);
    assert_eq!(service.get(&format!("{id}/result"), &format!("{path}/result")).status, 200);
    for form in [
        "summary.csv",
        "pressure.csv",
        "subsurface.csv",
        "pressure.svg",
        "depth.svg",
        "surface.svg",
        "load_approach.svg",
    ] {
        assert_eq!(service.get(&format!("{id}/{form}"), &format!("{path}/{form}")).status, 200);
    }
    let form = "field.vtu";
    assert_eq!(service.get(&format!("{id}/{form}"), &format!("{path}/{form}")).status, 409);
    assert_eq!(
        service.get(&format!("{id}/depth.svg"), &format!("{path}/depth.svg?step=2")).status,
        404
    );
    let parts =
        service.get(&format!("{id}/result"), &format!("{path}/result?fields=contact&step=1"));
    assert_eq!((parts.status, &parts.json()["steps"][0]["history"]), (200, &json!([])));
    assert_eq!(service.get(&format!("{id}/result"), &format!("{path}/result?step=2")).status, 404);
    assert_eq!(
        service.get(&format!("{id}/result"), &format!("{path}/result?fields=all")).status,
        400
    );
    assert_eq!(service.get(&format!("{id}/events"), &format!("{path}/events")).status, 200);
    assert_eq!(
        service.post(&format!("{id}/cancel"), &format!("{path}/cancel"), "", &[]).status,
        200
    );
    assert_eq!(service.get(&format!("{id}/result"), &format!("{NOBODY}/result")).status, 404);
    for status in [204, 404] {
        let answer = curl(&["-X", "DELETE", &format!("{}{path}", server.target.url)]);
        assert_eq!(answer.status, status);
        service.check("delete", id, &answer);
    }
}

#[test]
fn answers_to_those_without_a_key_are_as_documented() {
    let server = Server::start_with(&["--require-api-key"]);
    let service = Documented::new(&server.target);
    let mut refused = 0;
    for (template, item) in service.document["paths"].as_object().unwrap() {
        let id = NOBODY.rsplit('/').next().unwrap();
        let path = template.replace("{id}", id).replace("{name}", "none");
        for (method, operation) in item.as_object().unwrap() {
            let url = format!("{}{path}", server.target.url);
            let answer = curl(&["-X", &method.to_uppercase(), &url]);
            service.check(method, template, &answer);
            let is_guarded = operation["security"].as_array().is_some_and(|ways| !ways.is_empty());
            assert_eq!(answer.status == 401, is_guarded, "{method} {template}");
            refused += usize::from(answer.status == 401);
        }
    }
    assert!(refused > 10);
}

#[test]
fn no_operation_takes_a_parameter_that_it_does_not_declare() {
    let server = Server::start();
    let service = Documented::new(&server.target);
    let job = server.target.submit(&example());
    server.target.wait_for(&job, &["succeeded"]);
    let id = job.rsplit('/').next().unwrap();
    let mut refused = 0;
    for (template, item) in service.document["paths"].as_object().unwrap() {
        let path = template.replace("{id}", id).replace("{step}", "1");
        for method in item.as_object().unwrap().keys().filter(|_| path.starts_with("/v1/")) {
            let url = format!("{}{path}?no_such_parameter=1", server.target.url);
            let answer = curl(&["-X", &method.to_uppercase(), &url]);
            service.check(method, template, &answer);
            let problem = answer.problem(400, "invalid-query");
            assert_eq!(problem["errors"][0]["parameter"], "no_such_parameter", "{url}");
            refused += 1;
        }
    }
    assert!(refused > 20);
    for path in ["/livez", "/readyz", "/metrics", "/openapi.json", "/problems/internal", "/"] {
        assert_eq!(server.target.get(&format!("{path}?t=1")).status, 200, "{path}");
    }
    assert_eq!(server.target.get(&job).status, 200, "it is not deleted");
}

#[test]
fn answers_about_troubled_jobs_are_as_documented() {
    let instance = InProcess::start(|_| ());
    let service = Documented::new(&instance.target);
    for (behaviour, status) in [("impossible", 422), ("fail", 500), ("panic", 500), ("quick", 200)]
    {
        let text = job(behaviour).to_string();
        assert_eq!(
            service.post("/v1/solve", "/v1/solve", &text, &[JSON]).status,
            status,
            "{behaviour}"
        );
    }
    let (running, queued) =
        (instance.target.submit(&job("slow")), instance.target.submit(&job("quick")));
    instance.target.wait_for(&running, &["running"]);
    let id = "/v1/jobs/{id}";
    let started = Instant::now();
    while service.get(id, &running).json()["progress"]["latest"].is_null() {
        assert!(started.elapsed() < DEADLINE);
    }
    assert_eq!(service.get(id, &queued).json()["queue_position"], 0);
    assert_eq!(service.get(&format!("{id}/result"), &format!("{queued}/result")).status, 409);
    service.post(&format!("{id}/cancel"), &format!("{running}/cancel"), "", &[]);
    instance.target.wait_for(&running, &["cancelled"]);
    service.get("/v1/jobs", "/v1/jobs");
}

#[test]
fn the_page_about_the_interface_needs_no_other_server() {
    let server = Server::start();
    let page = server.target.get("/docs/");
    let text = String::from_utf8(page.body.clone()).unwrap();
    assert_eq!(
        (page.status, page.header("content-type")),
        (200, Some("text/html; charset=utf-8"))
    );
    let policy = page.header("content-security-policy").unwrap();
    assert!(policy.starts_with("default-src 'self';") && !policy.contains("unsafe"), "{policy}");
    let parts: Vec<&str> = text.split('"').collect();
    let is_address = |before: &str| before.ends_with("href=") || before.ends_with("src=");
    let is_file = |part: &str| [".js", ".css", ".svg"].iter().any(|end| part.ends_with(end));
    let pairs = parts.windows(2).filter(|pair| is_address(pair[0]) && is_file(pair[1]));
    let named: Vec<&str> = pairs.map(|pair| pair[1]).collect();
    assert_eq!(named.len(), 4, "{named:?}");
    for file in named {
        let path = file.strip_prefix("../").expect("an address relative to /docs/");
        assert_eq!(server.target.get(&format!("/{path}")).status, 200, "{file}");
    }
    // Behind a proxy that shows the service below a path, the redirect stays there.
    assert_eq!(server.target.get("/docs").header("location"), Some("docs/"));
}
