//! A service with TLS of its own.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use crate::curl::curl;
use crate::server::{DEADLINE, Scratch, Server, example};

/// A certificate or key for tests.
pub fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/http/tls").join(name)
}

/// A service with the first certificate, in files that can be replaced.
fn start(data: &Scratch) -> Server {
    let [cert, key] = ["cert.pem", "key.pem"].map(|name| {
        let copy = data.0.join(name);
        fs::copy(file(&format!("first.{name}")), &copy).unwrap();
        copy.to_str().unwrap().to_owned()
    });
    Server::start_with(&["--tls-cert", &cert, "--tls-key", &key])
}

/// The status that a client gets that trusts one certificate; `None` if it trusts the service not.
fn status(server: &Server, trusted: &str, path: &str) -> Option<u16> {
    let answer = Command::new("curl")
        .args([
            "--silent",
            "--output",
            "/dev/null",
            "--write-out",
            "%{http_code}",
            "--max-time",
            "30",
            "--cacert",
        ])
        .arg(file(trusted))
        .arg(format!("{}{path}", server.target.url))
        .output()
        .unwrap();
    String::from_utf8(answer.stdout).unwrap().parse().ok().filter(|status| *status != 0)
}

#[test]
#[cfg_attr(no_curl, ignore = "needs curl: install it")]
fn a_client_that_trusts_the_certificate_is_answered() {
    let data = Scratch::new();
    let server = start(&data);
    assert!(server.target.url.starts_with("https://"));
    assert_eq!(status(&server, "first.cert.pem", "/livez"), Some(200));
    assert_eq!(status(&server, "second.cert.pem", "/livez"), None);
    let cacert = file("first.cert.pem");
    let body = example().to_string();
    let url = format!("{}/v1/solve", server.target.url);
    let args = [
        "--cacert",
        cacert.to_str().unwrap(),
        "-H",
        "Content-Type: application/json",
        "-d",
        &body,
        &url,
    ];
    assert_eq!(curl(&args).json()["result"]["status"], "converged");
}

#[test]
fn the_health_check_knows_the_certificate() {
    let data = Scratch::new();
    let server = start(&data);
    let address = server.target.url.strip_prefix("https://").unwrap();
    let check = |certificate: &str| {
        let mut check = Command::new(env!("CARGO_BIN_EXE_brinell"));
        check.args(["healthcheck", "--listen", address, "--tls-cert"]).arg(file(certificate));
        check.output().unwrap().status.success()
    };
    assert!(check("first.cert.pem") && !check("second.cert.pem"));
}

#[test]
#[cfg_attr(no_curl, ignore = "needs curl: install it")]
fn a_renewed_certificate_is_taken_up() {
    let data = Scratch::new();
    let server = start(&data);
    // What cannot be used changes nothing.
    fs::write(data.0.join("key.pem"), "no key").unwrap();
    server.signal("HUP");
    assert_eq!(status(&server, "first.cert.pem", "/livez"), Some(200));
    for name in ["cert.pem", "key.pem"] {
        fs::copy(file(&format!("second.{name}")), data.0.join(name)).unwrap();
    }
    server.signal("HUP");
    let started = Instant::now();
    while status(&server, "second.cert.pem", "/livez") != Some(200) {
        assert!(started.elapsed() < DEADLINE, "the second certificate is not used");
    }
}

#[test]
fn unusable_certificates_are_named() {
    for (cert, key, named) in [
        ("first.cert.pem", "second.key.pem", "second.key.pem"),
        ("first.key.pem", "first.key.pem", "first.key.pem: no certificate in it"),
        ("none.pem", "first.key.pem", "none.pem"),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_brinell"))
            .args(["serve", "--listen", "127.0.0.1:0", "--data-dir", ":memory:", "--tls-cert"])
            .arg(file(cert))
            .arg("--tls-key")
            .arg(file(key))
            .output()
            .unwrap();
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(
            !output.status.success() && told.contains(named) && told.contains("--tls-cert"),
            "{told}"
        );
    }
}
