//! The curl examples of the README: the test runs them and compares their output.
//!
//! Every fenced block whose info string is `sh curl` is run by `sh -eu` in the package's
//! directory. In it, `http://127.0.0.1:8080`, where `brinell serve` listens by default, stands for
//! the service under test. The blocks run in order, in one shell, so that a later one may use the
//! variables of an earlier one.

use std::fs;
use std::process::{Command, Stdio};

use crate::server::Server;

const README: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
const DEFAULT_URL: &str = "http://127.0.0.1:8080";

fn readme() -> String {
    fs::read_to_string(README).expect("README.md is there")
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
#[cfg_attr(no_curl, ignore = "needs curl: install it")]
fn every_curl_example_works() {
    let blocks = curl_blocks(&readme());
    assert!(!blocks.is_empty(), "README.md has no block marked ```sh curl");
    assert!(blocks.iter().all(|block| block.contains(DEFAULT_URL)), "an example asks no service");

    let server = Server::start();
    let script = blocks.join("\n");
    let shown = printed(&script, &server);
    assert!(
        !shown.contains("/problems/"),
        "an example is answered by a problem:\n{script}\n{shown}"
    );
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

/// What the first curl example prints is what the README shows below it.
#[test]
#[ignore = "full"]
fn the_figures_shown_are_those_of_today() {
    let text = readme();
    let (_, after) = text.split_once("```sh curl\n").expect("README.md has an example");
    let (example, after) = after.split_once("```\n\n```\n").expect("its answer follows");
    let (shown, _) = after.split_once("```").expect("the answer ends");
    hold(shown, &printed(example, &Server::start()));
}

/// The table and the chart that the README shows are those that a terminal shows.
#[test]
#[ignore = "full"]
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
    let begin = printed.find("force 612.6106 N/mm").expect("the program prints the table");
    let lines = shown.lines().count();
    let now: String = printed[begin..].split_inclusive('\n').take(lines).collect();
    hold(shown, &now);
}

/// Compares what README.md shows with what is printed now: words exactly, figures to three digits.
/// With `BRINELL_WRITE=1` writes it anew instead.
fn hold(shown: &str, now: &str) {
    if std::env::var_os("BRINELL_WRITE").is_some() {
        let text = readme().replacen(shown, now, 1);
        return fs::write(README, text).expect("README.md can be written");
    }
    let different = differences(shown, now);
    assert!(
        different.is_empty(),
        "README.md differs; BRINELL_WRITE=1 writes it anew: {different:?}"
    );
}

/// The words that differ, figures beyond three digits.
fn differences(shown: &str, now: &str) -> Vec<(String, String)> {
    let words = |text: &str| -> Vec<String> {
        let separators = |c: char| c.is_whitespace() || c == ':' || c == ',';
        text.split(separators).filter(|word| !word.is_empty()).map(str::to_owned).collect()
    };
    let alike = |old: &str, new: &str| match (old.parse::<f64>(), new.parse::<f64>()) {
        (Ok(old), Ok(new)) => (old - new).abs() <= 5e-4 * old.abs().max(new.abs()),
        _ => old == new,
    };
    let (old, new) = (words(shown), words(now));
    let mut different: Vec<_> =
        old.iter().cloned().zip(new.iter().cloned()).filter(|(a, b)| !alike(a, b)).collect();
    if old.len() != new.len() {
        different.push((format!("{} words", old.len()), format!("{} words", new.len())));
    }
    different
}

#[test]
fn figures_are_compared_to_three_digits() {
    assert!(differences("peak 1500.1 MPa", "peak  1500.4 MPa").is_empty());
    assert_eq!(differences("\"peak\":1500.1,", "\"peak\":1510.1,").len(), 1);
    assert_eq!(differences("peak 1 MPa", "peak 1 GPa").len(), 1);
    assert_eq!(differences("peak 1", "peak 1 MPa").len(), 1);
}

#[test]
fn only_marked_blocks_are_taken() {
    let text = "```sh\ncargo test\n```\n\n```sh curl\ncurl a\ncurl b\n```\ntext\n```sh curl\ncurl \
                c\n```\n";
    assert_eq!(curl_blocks(text), ["curl a\ncurl b\n", "curl c\n"]);
}
