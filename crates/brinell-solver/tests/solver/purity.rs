//! The solver and the crates below it are pure: no async, no files, no network, no clock, no
//! threads, no printing.
//!
//! Cargo keeps the crates apart; these names come from the standard library, which every crate
//! sees.

use std::fs;
use std::path::{Path, PathBuf};

const FORBIDDEN: &[&str] = &[
    "async ",
    ".await",
    "std::env",
    "std::fs",
    "std::io::std",
    "std::net",
    "std::process",
    "std::thread",
    "Instant",
    "SystemTime",
    "print!",
    "println!",
    "eprint!",
    "eprintln!",
    "dbg!",
];

fn sources(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// Lines of code that name something impure, as `line: name`.
fn impurities(source: &str) -> Vec<String> {
    let code = source.lines().enumerate().filter(|(_, line)| !line.trim_start().starts_with("//"));
    code.flat_map(|(k, line)| {
        FORBIDDEN
            .iter()
            .filter(move |name| line.contains(**name))
            .map(move |name| format!("{}: {name}", k + 1))
    })
    .collect()
}

#[test]
fn the_solver_and_its_factorization_are_pure() {
    let mut files = Vec::new();
    for root in [
        "src",
        "../brinell-contact/src",
        "../brinell-fem/src",
        "../brinell-halfspace/src",
        "../brinell-material/src",
        "../brinell-method/src",
        "../dense-cholesky/src",
        "../sparse-cholesky/src",
    ] {
        sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join(root), &mut files);
    }
    assert!(files.len() > 50, "the sources have not been found");
    let faults: Vec<String> = files
        .iter()
        .flat_map(|file| {
            let found = impurities(&fs::read_to_string(file).unwrap());
            found.into_iter().map(move |fault| format!("{}:{fault}", file.display()))
        })
        .collect();
    assert!(faults.is_empty(), "\n{}\n", faults.join("\n"));
}

#[test]
fn impure_names_are_found_in_code_and_not_in_comments() {
    assert_eq!(impurities("// println!\nlet clock = Instant::now();"), ["2: Instant"]);
    assert_eq!(impurities("fn f() {\n    std::thread::spawn(|| ());\n}"), ["2: std::thread"]);
}

/// From the bottom up.
const CRATES: [&str; 8] = [
    "dense-cholesky",
    "sparse-cholesky",
    "brinell-material",
    "brinell-contact",
    "brinell-method",
    "brinell-fem",
    "brinell-halfspace",
    "brinell-solver",
];

#[test]
fn a_crate_depends_on_those_below_it_alone() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let there = fs::read_dir(crates).unwrap().count();
    assert_eq!(there, CRATES.len());
    for (k, name) in CRATES.iter().enumerate() {
        let manifest = fs::read_to_string(crates.join(name).join("Cargo.toml")).unwrap();
        let dependencies = manifest.split("[dependencies]").nth(1).unwrap();
        let upward: Vec<_> = CRATES[k..]
            .iter()
            .filter(|other| dependencies.lines().any(|line| line.starts_with(**other)))
            .collect();
        assert!(upward.is_empty(), "{name} names {upward:?}");
    }
}
