//! The curl examples of the README, executed, and what it shows of their answers.
//!
//! Every fenced block whose info string is `sh curl` is run by `sh -eu` in the package's directory. In it,
//! `http://127.0.0.1:8080`, where `brinell serve` listens by default, stands for the service under test. The
//! blocks run in order, in one shell, so that a later one may use the variables of an earlier one.

use std::fs;
use std::process::{Command, Stdio};

use crate::server::Server;

const DEFAULT_URL: &str = "http://127.0.0.1:8080";

fn readme() -> String {
    fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md")).expect("README.md is there")
}

/// What a script prints that asks this service.
fn printed(script: &str, server: &Server) -> String {
    let script = script.replace(DEFAULT_URL, &server.target.url);
    let output = Command::new("sh")
        .args(["-euc", &script])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdin(Stdio::null())
        .output()
        .expect("sh runs");
    let (shown, complaints) =
        (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{script}\n{shown}\n{complaints}");
    shown.into_owned()
}

#[test]
fn every_curl_example_works() {
    let blocks = curl_blocks(&readme());
    assert!(!blocks.is_empty(), "README.md has no block marked ```sh curl");
    assert!(blocks.iter().all(|block| block.contains(DEFAULT_URL)), "an example asks no service");

    let server = Server::start();
    let script = blocks.join("\n");
    let shown = printed(&script, &server);
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

/// What the first curl example prints is what the README shows below it, to six digits: the last ones differ between processors.
#[test]
fn the_figures_shown_are_those_of_today() {
    let text = readme();
    let (_, after) = text.split_once("```sh curl\n").expect("README.md has an example");
    let (example, after) = after.split_once("```\n\n```\n").expect("its answer follows");
    let (shown, _) = after.split_once("```").expect("the answer ends");

    let (shown, now) = (figures(shown), figures(&printed(example, &Server::start())));
    assert_eq!((shown.len(), now.len()), (4, 4), "{shown:?} {now:?}");
    for ((name, old), (name_now, new)) in shown.iter().zip(&now) {
        assert_eq!(name, name_now);
        assert!(
            (old - new).abs() <= 1e-6 * new.abs(),
            "README.md shows {name} {old}, the service says {new}"
        );
    }
}

/// Lines `"name":figure`.
fn figures(lines: &str) -> Vec<(String, f64)> {
    lines
        .lines()
        .map(|line| line.split_once(':').expect("a name and a figure"))
        .map(|(name, figure)| (name.to_owned(), figure.parse().expect("a figure")))
        .collect()
}

/// The table and the chart that the README shows are those that a terminal shows.
#[test]
fn the_table_shown_is_that_of_today() {
    let text = readme();
    let begin = text.find("force 612.6106 N/mm").expect("README.md shows the table");
    let shown = text[begin..].split("```").next().expect("the table ends");
    let output = Command::new(env!("CARGO_BIN_EXE_brinell"))
        .args(["solve", "api/examples/two_cylinders.json", "--format", "table"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("the program runs");
    let printed = String::from_utf8_lossy(&output.stdout);
    assert!(printed.contains(shown.trim_end()), "README.md shows\n{shown}\nthe program prints\n{printed}");
}

#[test]
fn only_marked_blocks_are_taken() {
    let text = "```sh\ncargo test\n```\n\n```sh curl\ncurl a\ncurl b\n```\ntext\n```sh curl\ncurl c\n```\n";
    assert_eq!(curl_blocks(text), ["curl a\ncurl b\n", "curl c\n"]);
}
