//! Imports run downward.
//!
//! Every file under `src/` is read and every path in it that leads into the crate, by `crate::` or by enough
//! `super::`, is held against [`RULES`]. Comments and strings do not count: a doc link may point upward.

#[path = "architecture/checker.rs"]
mod checker;
#[path = "architecture/paths.rs"]
mod paths;

use std::cmp::Ordering;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use paths::{paths, tokenize};

/// What may see what.
struct Rules<'a> {
    /// From top to bottom. A module sees the layers below its own; modules of one layer do not see each
    /// other.
    layers: &'a [&'a [&'a str]],
    /// `(module, what it must not see although it lies below, why)`.
    barred: &'a [(&'a str, &'a [&'a str], &'a str)],
    /// `(module, neighbour or upper module it may see all the same, why)`.
    exceptions: &'a [(&'a str, &'a str, &'a str)],
    /// Highest layer of the core: from there down no async, no files, no clock, no printing.
    core: &'a str,
    /// `(foreign crate, the only module that names it)`.
    reserved: &'a [(&'a str, &'a str)],
}

const RULES: Rules<'_> = Rules {
    layers: &[
        &["cli"],
        &["app"],
        // Parts of the program around the service: its settings, its log, its signals.
        &["config", "telemetry", "lifecycle"],
        &["http", "worker", "store"],
        &["jobs"],
        &["results"],
        &["solve"],
        &["contact"],
        &["assembly"],
        &["mesh", "element", "plasticity"],
        &["model", "linalg", "analytical"],
    ],
    barred: &[
        ("http", &["solve", "contact", "assembly", "mesh", "linalg"], "it talks to the jobs' desk alone"),
        (
            "contact",
            &["assembly", "mesh", "element", "plasticity", "model"],
            "it takes a flexibility matrix and knows no mesh",
        ),
    ],
    exceptions: &[],
    core: "results",
    reserved: &[("faer", "linalg")],
};

/// Crates and clocks that a core module must not name.
const IMPURE_NAMES: &[&str] =
    &["tokio", "axum", "hyper", "sqlx", "clap", "indicatif", "Instant", "SystemTime"];
/// Modules of the standard library that a core module must not name.
const IMPURE_STD: &[&str] = &["env", "fs", "net", "process", "thread"];
/// The core module that may name threads all the same: it starts some on cores that it is lent.
const THREADED: &str = "linalg";
/// Macros that a core module must not call.
const PRINTING: &[&str] = &["print", "println", "eprint", "eprintln", "dbg"];

#[test]
fn imports_run_downward() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    collect(&root.join("src"), &mut files).unwrap();
    files.sort();
    assert!(files.len() > 50, "src/ has not been found whole");
    let mut faults = Vec::new();
    let mut seen = Vec::new();
    for file in files {
        let name = file.strip_prefix(root).unwrap().to_str().unwrap().replace('\\', "/");
        faults.extend(RULES.check(&name, &fs::read_to_string(&file).unwrap()));
        seen.push(Place::of(&name).module);
    }
    for module in RULES.layers.iter().copied().flatten() {
        if !seen.iter().any(|name| name == module) {
            faults.push(format!("the layers name {module}, but src/ has no such module"));
        }
    }
    assert!(faults.is_empty(), "\n{}\n", faults.join("\n"));
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

/// Where a file stands in the tree of modules.
struct Place {
    /// Module right below the crate root; empty for the root itself.
    module: String,
    /// How far the file's module lies below the crate root.
    depth: usize,
}

impl Place {
    /// Of a file name such as `src/mesh/quality.rs`.
    fn of(file: &str) -> Self {
        let path = file.trim_start_matches("src/").trim_end_matches(".rs").trim_end_matches("/mod");
        if path == "lib" || path == "main" {
            return Self { module: String::new(), depth: 0 };
        }
        let module = path.split('/').next().unwrap_or_default().to_owned();
        Self { module, depth: path.split('/').count() }
    }
}

impl Rules<'_> {
    /// Everything in a file that is against the rules, one line for each.
    fn check(&self, file: &str, source: &str) -> Vec<String> {
        let place = Place::of(file);
        if place.module.is_empty() {
            return Vec::new();
        }
        let module = place.module.as_str();
        let Some(own) = self.layer_of(module) else {
            return vec![format!(
                "{file}: {module} is in no layer; say in tests/architecture.rs where it belongs"
            )];
        };
        let tokens = tokenize(source);
        let mut faults = Vec::new();
        for path in paths(&tokens, place.depth) {
            let line = path.line;
            if let Some(target) = path.inside_crate() {
                if let Some(why) = self.refusal(module, own, target) {
                    let imports = format!("{file}:{line} imports crate::{target}");
                    faults.push(format!("{imports}: {module} may not see {target}{why}"));
                }
            } else if let [first, second, ..] = path.segments.as_slice()
                && first == "std"
                && IMPURE_STD.contains(&second.as_str())
                && self.is_core(own)
                && (second != "thread" || module != THREADED)
            {
                faults.push(format!("{file}:{line} names std::{second}: {module} belongs to the core"));
            }
        }
        for (k, token) in tokens.iter().enumerate() {
            let (name, line) = (token.text.as_str(), token.line);
            let is_call = tokens.get(k + 1).is_some_and(|next| next.text == "!");
            if self.is_core(own) && (IMPURE_NAMES.contains(&name) || is_call && PRINTING.contains(&name)) {
                faults.push(format!("{file}:{line} names {name}: {module} belongs to the core"));
            }
            let owner = self.reserved.iter().find(|(foreign, owner)| *foreign == name && *owner != module);
            if let Some((_, owner)) = owner {
                faults.push(format!("{file}:{line} names {name}: only {owner} may"));
            }
        }
        faults.dedup();
        faults
    }

    /// Position from the top.
    fn layer_of(&self, module: &str) -> Option<usize> {
        self.layers.iter().position(|layer| layer.contains(&module))
    }

    fn is_core(&self, layer: usize) -> bool {
        self.layer_of(self.core).is_some_and(|highest| layer >= highest)
    }

    /// Why a module of layer `own` may not see another; `None` if it may.
    fn refusal(&self, module: &str, own: usize, target: &str) -> Option<String> {
        if target == module || self.exceptions.iter().any(|(from, to, _)| (*from, *to) == (module, target)) {
            return None;
        }
        let Some(other) = self.layer_of(target) else {
            return Some(": no layer has that name, so nobody can tell what is behind it".to_owned());
        };
        if let Some((_, _, why)) =
            self.barred.iter().find(|(from, to, _)| *from == module && to.contains(&target))
        {
            return Some(format!(": {why}"));
        }
        match other.cmp(&own) {
            Ordering::Greater => None,
            Ordering::Equal => Some(", which lies beside it".to_owned()),
            Ordering::Less => Some(", which lies above it".to_owned()),
        }
    }
}
