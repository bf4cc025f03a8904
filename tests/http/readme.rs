//! The curl examples of the README, executed.
//!
//! Every fenced block whose info string is `sh curl` is run by `sh -eu` in the package's directory. In it,
//! `http://127.0.0.1:8080`, where `brinell serve` listens by default, stands for the service under test. The
//! blocks run in order, in one shell, so that a later one may use the variables of an earlier one.

use std::fs;
use std::process::{Command, Stdio};

use crate::server::Server;

const DEFAULT_URL: &str = "http://127.0.0.1:8080";

#[test]
fn every_curl_example_works() {
    let readme = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
    let text = fs::read_to_string(readme).expect("README.md is there");
    let blocks = curl_blocks(&text);
    assert!(!blocks.is_empty(), "README.md has no block marked ```sh curl");
    assert!(blocks.iter().all(|block| block.contains(DEFAULT_URL)), "an example asks no service");

    let server = Server::start();
    let script = blocks.join("\n").replace(DEFAULT_URL, &server.target.url);
    let output = Command::new("sh")
        .args(["-euc", &script])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdin(Stdio::null())
        .output()
        .expect("sh runs");
    let (shown, complaints) =
        (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{script}\n{shown}\n{complaints}");
    assert!(!shown.contains("/problems/"), "an example is answered by a problem:\n{script}\n{shown}");
    server.target.assert_alive();
}

/// The texts of all fenced blocks marked `sh curl`.
fn curl_blocks(text: &str) -> Vec<String> {
    let (mut blocks, mut open) = (Vec::new(), None::<String>);
    for line in text.lines() {
        match &mut open {
            None if line.trim_end() == "```sh curl" => open = Some(String::new()),
            None => {}
            Some(_) if line.trim_end() == "```" => blocks.extend(open.take()),
            Some(block) => {
                block.push_str(line);
                block.push('\n');
            }
        }
    }
    blocks
}

#[test]
fn only_marked_blocks_are_taken() {
    let text = "```sh\ncargo test\n```\n\n```sh curl\ncurl a\ncurl b\n```\ntext\n```sh curl\ncurl c\n```\n";
    assert_eq!(curl_blocks(text), ["curl a\ncurl b\n", "curl c\n"]);
}
