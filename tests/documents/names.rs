//! Paths, links and types that documents name.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{path, read};

/// A page that is longer is not read.
const README_BYTES: usize = 8 * 1024;
const MAP_BYTES: usize = 5 * 1024;
const CHANGELOG_BYTES: usize = 14 * 1024;

#[test]
fn short_documents_stay_short() {
    for (name, most) in [
        ("README.md", README_BYTES),
        ("docs/ARCHITECTURE.md", MAP_BYTES),
        ("CHANGELOG.md", CHANGELOG_BYTES),
    ] {
        let bytes = read(name).len();
        assert!(bytes <= most, "{name} has {bytes} bytes, {most} at most");
    }
}

#[test]
fn every_path_and_type_of_the_map_exists() {
    let map = read("docs/ARCHITECTURE.md") + &read("docs/how_to_add.md");
    let sources = rust_sources();
    let types = types(&sources);
    let mut missing = Vec::new();
    let mut seen = 0;
    for name in in_backticks(&map) {
        if name.contains('/') && !name.contains(' ') && !name.starts_with('/') {
            seen += 1;
            if !is_a_path(&name, &sources) {
                missing.push(name);
            }
        } else if name.starts_with(char::is_uppercase) && name.chars().all(char::is_alphanumeric) {
            seen += 1;
            if !types.contains(&name) {
                missing.push(name);
            }
        }
    }
    assert!(seen > 20, "the map names {seen} paths and types");
    assert!(missing.is_empty(), "the map names what is not there: {missing:?}");
}

#[test]
fn every_link_leads_to_a_file() {
    let mut broken = Vec::new();
    for document in markdown() {
        let text = fs::read_to_string(&document).expect("documents can be read");
        let folder = document.parent().expect("a file has a folder");
        for link in links(&text) {
            let target = link.split('#').next().unwrap_or_default();
            if !target.is_empty() && !target.contains("://") && !folder.join(target).exists() {
                broken.push(format!("{}: {link}", document.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

/// The texts between backticks, without those of fenced blocks.
fn in_backticks(text: &str) -> Vec<String> {
    let (mut names, mut fenced) = (Vec::new(), false);
    for line in text.lines() {
        if line.starts_with("```") {
            fenced = !fenced;
        } else if !fenced {
            names.extend(line.split('`').skip(1).step_by(2).map(str::to_owned));
        }
    }
    names
}

/// A path from the root, or the end of the path of a source file or its folder.
fn is_a_path(name: &str, sources: &[PathBuf]) -> bool {
    let ends = |source: &PathBuf| {
        source.ends_with(name) || source.parent().is_some_and(|at| at.ends_with(name))
    };
    path(name).exists() || sources.iter().any(ends)
}

fn types(sources: &[PathBuf]) -> BTreeSet<String> {
    let mut types = BTreeSet::new();
    for source in sources {
        let text = fs::read_to_string(source).expect("sources can be read");
        for line in text.lines() {
            let mut words = line.split_whitespace().skip_while(|word| word.starts_with("pub"));
            if let (Some("struct" | "enum" | "trait" | "type"), Some(name)) =
                (words.next(), words.next())
            {
                let end = name.find(|c: char| !c.is_alphanumeric()).unwrap_or(name.len());
                types.insert(name[..end].to_owned());
            }
        }
    }
    types
}

fn links(text: &str) -> Vec<&str> {
    let ends = text.split("](").skip(1);
    ends.filter_map(|rest| rest.split(')').next())
        .filter(|link| !link.contains(char::is_whitespace))
        .collect()
}

fn rust_sources() -> Vec<PathBuf> {
    ["src", "crates", "tests", "tools", "fuzz"]
        .iter()
        .flat_map(|folder| files(&path(folder), "rs"))
        .collect()
}

fn markdown() -> Vec<PathBuf> {
    let beside = fs::read_dir(path("")).expect("the root can be read");
    let beside =
        beside.flatten().map(|entry| entry.path()).filter(|path| has_extension(path, "md"));
    let below = ["docs", "crates", "clients/python/brinell", "deploy"];
    beside.chain(below.iter().flat_map(|folder| files(&path(folder), "md"))).collect()
}

fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            if !matches!(
                path.file_name().and_then(|name| name.to_str()),
                Some("target" | "node_modules")
            ) {
                found.extend(files(&path, extension));
            }
        } else if has_extension(&path, extension) {
            found.push(path);
        }
    }
    found
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|own| own == extension)
}
