//! The guide: the files of a folder, as they were when the service started.

use std::fs;

use crate::server::{Scratch, Server};

const PAGE: &str = "<!doctype html><script>alert(1)</script><p>From a press to a map";
/// In the header of the page.
const LINK: &str = r#"href="guide/""#;

fn front(server: &Server) -> String {
    String::from_utf8(server.target.get("/").body).unwrap()
}

#[test]
fn its_files_are_served_and_no_others() {
    let folder = Scratch::new();
    fs::create_dir(folder.0.join("docs")).unwrap();
    fs::write(folder.0.join("index.html"), PAGE).unwrap();
    fs::write(folder.0.join("docs/press.svg"), "<svg xmlns='http://www.w3.org/2000/svg'/>")
        .unwrap();
    let server = Server::start_with(&["--guide", folder.0.to_str().unwrap()]);
    assert_eq!(server.target.get("/guide").header("location"), Some("guide/"));
    let page = server.target.get("/guide/");
    assert_eq!((page.status, page.body.as_slice()), (200, PAGE.as_bytes()));
    assert_eq!(page.header("content-type"), Some("text/html; charset=utf-8"));
    // Its own script alone, by its digest.
    let policy = page.header("content-security-policy").unwrap();
    let (_, scripts) = policy.split_once("script-src ").unwrap();
    assert_eq!(scripts, "'self' 'sha256-bhHHL3z2vDgxUt0W3dWQOrprscmda2Y5pLsLg4GF+pI='");
    assert!(front(&server).contains(LINK));
    let picture = server.target.get("/guide/docs/press.svg");
    assert_eq!((picture.status, picture.header("content-type")), (200, Some("image/svg+xml")));
    // A file that comes later, and files beside the folder.
    fs::write(folder.0.join("later.html"), PAGE).unwrap();
    for path in ["/guide/later.html", "/guide/..%2fCargo.toml", "/guide/%2e%2e/Cargo.toml"] {
        server.target.get(path).problem(404, "not-found");
    }
}

#[test]
fn without_one_it_is_said_how_to_get_one() {
    let server = Server::start();
    assert!(!front(&server).contains(LINK));
    let problem = server.target.get("/guide/").problem(404, "not-found");
    assert!(problem["detail"].as_str().unwrap().contains("--guide"), "{problem}");
}
