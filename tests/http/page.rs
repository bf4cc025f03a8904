//! The page as a browser's network stack sees it. What people see is in `tests/page/`.

use std::fs;
use std::path::{Path, PathBuf};

use crate::curl::{Answer, curl};
use crate::server::{Server, example};

/// All that a browser asks for, compressed: its modules come as one file.
const PAGE_BYTES: usize = 220_000;

fn ask(server: &Server, path: &str, headers: &[&str]) -> Answer {
    let url = format!("{}{path}", server.target.url);
    let mut args: Vec<&str> = headers.iter().flat_map(|header| ["-H", *header]).collect();
    args.push(&url);
    curl(&args)
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { files(&path, found) } else { found.push(path) }
    }
}

/// Every file under `web/` as an address.
fn addresses() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("web");
    let mut found = Vec::new();
    files(&root, &mut found);
    let address = |path: &PathBuf| format!("/web/{}", path.strip_prefix(&root).unwrap().display());
    found.iter().map(address).collect()
}

#[test]
fn the_page_is_served_whole_and_light() {
    let server = Server::start();
    let addresses = addresses();
    assert!(addresses.len() > 10, "{addresses:?}");
    let mut weight = 0;
    for path in addresses.iter().map(String::as_str).chain(["/", "/web/page.js"]) {
        let answer = ask(&server, path, &["Accept-Encoding: gzip"]);
        assert_eq!(answer.status, 200, "{path}");
        assert_eq!(answer.header("content-encoding"), Some("gzip"), "{path}");
        let is_module = Path::new(path).extension().is_some_and(|extension| extension == "js");
        let is_joined = is_module && path != "/web/page.js";
        weight += if is_joined { 0 } else { answer.body.len() };
    }
    assert!(weight > 100_000 && weight < PAGE_BYTES, "{weight} bytes");
}

#[test]
fn a_reload_asks_for_the_document_alone() {
    let server = Server::start();
    let page = String::from_utf8(ask(&server, "/", &[]).body).unwrap();
    let (_, after) = page.split_once("src=\"").unwrap();
    let script = format!("/{}", after.split('"').next().unwrap());
    let kept = |path: &str| {
        let answer = ask(&server, path, &[]);
        assert_eq!(answer.status, 200, "{path}");
        answer.header("cache-control").unwrap().to_owned()
    };
    assert_eq!(kept("/"), "no-cache");
    assert!(kept(&script).contains("immutable"), "{script}");
    // Under a plain name, and under the digest of another version, it may have another content.
    assert_eq!(kept("/web/main.js"), "no-cache");
    assert_eq!(kept("/web/0123456789abcdef/main.js"), "no-cache");
}

#[test]
fn it_is_held_to_its_own_origin() {
    let server = Server::start();
    let answer = ask(&server, "/", &[]);
    assert_eq!(answer.header("content-type"), Some("text/html; charset=utf-8"));
    assert_eq!(answer.header("x-content-type-options"), Some("nosniff"));
    assert_eq!(answer.header("referrer-policy"), Some("no-referrer"));
    let policy = answer.header("content-security-policy").unwrap();
    assert!(policy.starts_with("default-src 'self';") && !policy.contains("unsafe"), "{policy}");
    assert_eq!(answer.header("content-encoding"), None);
    assert!(String::from_utf8(answer.body).unwrap().starts_with("<!doctype html>"));
}

#[test]
fn unchanged_files_are_not_sent_again() {
    let server = Server::start();
    let plain = ask(&server, "/", &[]);
    let gzip = ask(&server, "/", &["Accept-Encoding: br, gzip;q=0.5"]);
    let (plain_tag, gzip_tag) = (plain.header("etag").unwrap(), gzip.header("etag").unwrap());
    assert_ne!(plain_tag, gzip_tag, "a strong tag names bytes");
    assert_eq!(gzip.header("vary"), Some("accept-encoding"));
    for known in [plain_tag.to_owned(), format!("\"other\", W/{plain_tag}"), "*".to_owned()] {
        let again = ask(&server, "/", &[&format!("If-None-Match: {known}")]);
        assert_eq!((again.status, again.body.len()), (304, 0), "{known}");
        assert_eq!(again.header("etag"), Some(plain_tag));
    }
    assert_eq!(ask(&server, "/", &[&format!("If-None-Match: {gzip_tag}")]).status, 200);
    let refused = ask(&server, "/", &["Accept-Encoding: gzip;q=0"]);
    assert_eq!(refused.header("content-encoding"), None);
}

#[test]
fn other_files_are_not_served() {
    let server = Server::start();
    for path in [
        "/web/",
        "/web/none.js",
        "/web/0123456789abcdef/none.js",
        "/web/0123456789abcdef/",
        "/web/..%2fCargo.toml",
        "/web/%2e%2e/Cargo.toml",
        "/web/%FF",
    ] {
        ask(&server, path, &[]).problem(404, "not-found");
    }
}

#[test]
fn a_job_can_be_read_back() {
    let server = Server::start();
    let job = server.target.submit(&example());
    let answer = server.target.get(&format!("{job}/request"));
    assert_eq!((answer.status, answer.header("content-type")), (200, Some("application/json")));
    assert_eq!(answer.json(), example());
    server.target.get("/v1/jobs/none/request").problem(404, "job-not-found");
}
