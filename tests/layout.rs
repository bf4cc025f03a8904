//! Imports run one way inside each crate: no file imports, over others, from a file that imports
//! from it, not from its parent either. No two enums of the workspace have one name.
//!
//! An import is a path that begins with `crate`, `super`, `self` or a module below. It leads to
//! the file that has the item; a `pub use` passes the name on and is none. Items under `cfg(test)`
//! do not count.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

type Module = Vec<String>;

/// Lines of code, without comments and items under `cfg(test)`; modules among those.
fn code(text: &str) -> (String, Vec<&str>) {
    let (mut kept, mut modules, mut lines) = (String::new(), Vec::new(), text.lines());
    while let Some(line) = lines.next() {
        if line.trim() == "#[cfg(test)]" {
            let depth = line.len() - line.trim_start().len();
            let is_of_item = |line: &&str| line.len() > depth && !line[depth..].starts_with(' ');
            for line in lines.by_ref().filter(is_of_item) {
                let module = line.trim().strip_prefix("mod ");
                modules.extend(module.map(|name| name.trim_end_matches([';', '{', ' '])));
                if line.ends_with([';', '}']) {
                    break;
                }
            }
        } else if !line.trim_start().starts_with("//") {
            kept.extend([line, "\n"]);
        }
    }
    (kept, modules)
}

/// Reads a path or a tree such as `a::{b, c::d}` at the front of the words.
fn tree(words: &mut &[&str], before: &str, paths: &mut Vec<String>) {
    let path = [before, words[0]].concat();
    *words = &words[1..];
    if path.ends_with("::") && words[0] == "{" {
        *words = &words[1..];
        while words[0] != "}" {
            tree(words, &path, paths);
            let beside = if words[0] == "as" { 2 } else { 0 };
            *words = &words[beside + usize::from(words[beside] == ",")..];
        }
        *words = &words[1..];
    } else {
        paths.push(path);
    }
}

/// The texts of a crate by module.
fn sources(folder: &Path, module: &[String], files: &mut BTreeMap<Module, (String, String)>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        let inner = [module, &[name.to_owned()]].concat();
        if path.is_dir() {
            sources(&path, &inner, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let module = if matches!(name, "mod" | "lib") { module.to_vec() } else { inner };
            files.insert(module, (path.display().to_string(), fs::read_to_string(path).unwrap()));
        }
    }
}

/// The files of a crate and the files that each imports from.
fn imports(folder: &Path) -> BTreeMap<String, BTreeSet<String>> {
    let mut files = BTreeMap::new();
    sources(folder, &[], &mut files);
    let (mut paths, mut passed_on, mut tests) = (Vec::new(), BTreeMap::new(), Vec::new());
    for (module, (_, text)) in &files {
        let below = |name: &str| [&module[..], &[name.to_owned()]].concat();
        let (code, of_tests) = code(text);
        tests.extend(of_tests.into_iter().map(below));
        let is_word = |sign: char| sign.is_alphanumeric() || "_:".contains(sign);
        let apart = |sign| if is_word(sign) { sign.to_string() } else { format!(" {sign} ") };
        let code: String = code.chars().map(apart).collect();
        let words: Vec<&str> = code.split_whitespace().collect();
        // `pub(in crate::a)` is no import.
        let is_path =
            |at: &usize| words[*at].contains("::") && !words[..*at].ends_with(&["(", "in"]);
        for at in (1..words.len()).filter(is_path) {
            let (is_use, mut found) = (words[at - 1] == "use", Vec::new());
            tree(&mut &words[at..], "", &mut found);
            for path in found {
                let mut target = module.clone();
                let names: Vec<&str> = path.split("::").filter(|name| !name.is_empty()).collect();
                let is_below = files.contains_key(&below(names[0]));
                if !is_below && !["super", "self", "crate"].contains(&names[0]) {
                    continue;
                }
                for name in names {
                    match name {
                        "crate" => target.clear(),
                        "super" => drop(target.pop()),
                        "self" => {}
                        name => target.push(name.to_owned()),
                    }
                }
                if is_use && matches!(words[at.saturating_sub(2)], "pub" | ")") {
                    passed_on.insert(below(target.last().map_or("", String::as_str)), target);
                } else {
                    paths.push((module, target));
                }
            }
        }
    }
    let mut graph = BTreeMap::<String, BTreeSet<String>>::new();
    for (module, mut target) in paths {
        for _ in 0..6 {
            let passed = |end: usize| Some((passed_on.get(&target[..end])?, end));
            let known = (1..=target.len()).rev().find_map(passed);
            let Some((to, end)) = known.filter(|_| !files.contains_key(&target)) else { break };
            target = [&to[..], &target[end..]].concat();
        }
        while !files.contains_key(&target) {
            target.pop();
        }
        let is_of_tests = || tests.iter().any(|test| module.starts_with(test));
        if *module != target && !is_of_tests() {
            let imported = graph.entry(files[module].0.clone()).or_default();
            imported.insert(files[&target].0.clone());
        }
    }
    graph
}

fn reached(graph: &BTreeMap<String, BTreeSet<String>>, from: &String) -> BTreeSet<String> {
    let (mut seen, mut next) = (BTreeSet::new(), vec![from]);
    while let Some(file) = next.pop() {
        let imported = graph.get(file).into_iter().flatten();
        next.extend(imported.filter(|file| seen.insert((*file).clone())));
    }
    seen
}

/// The folders of all crates.
fn crates() -> impl Iterator<Item = PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let crates = fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path());
    crates.chain([root.to_owned(), root.join("tools")])
}

#[test]
fn no_files_import_each_other() {
    let (mut circles, mut count) = (Vec::new(), 0);
    for folder in crates() {
        let graph = imports(&folder.join("src"));
        count += graph.len();
        for (file, imported) in &graph {
            let back = imported.iter().filter(|next| reached(&graph, next).contains(file));
            circles.extend(back.map(|next| format!("{file} imports {next}")));
        }
    }
    assert!(count > 300, "the imports of {count} files only have been found");
    assert!(circles.is_empty(), "imports that lead back: {circles:#?}");
}

/// One name for one thing: who reads `Verdict` knows which.
#[test]
fn no_two_enums_have_one_name() {
    let mut places = BTreeMap::<String, Vec<String>>::new();
    for folder in crates() {
        let mut files = BTreeMap::new();
        sources(&folder.join("src"), &[], &mut files);
        for (path, text) in files.values() {
            let (code, _) = code(text);
            let is_beside = |sign: char| !sign.is_alphanumeric() && sign != '_';
            let words: Vec<&str> = code.split(is_beside).filter(|word| !word.is_empty()).collect();
            let is_enum =
                |pair: &&[&str]| pair[0] == "enum" && pair[1].starts_with(char::is_uppercase);
            for pair in words.windows(2).filter(is_enum) {
                places.entry(pair[1].to_owned()).or_default().push(path.clone());
            }
        }
    }
    assert!(places.len() > 100, "{} enums only have been found", places.len());
    places.retain(|_, places| places.len() > 1);
    assert!(places.is_empty(), "enums of one name: {places:#?}");
}

/// The packages of the two commands of README.md, each with its features.
fn packages(edges: &str) -> BTreeSet<String> {
    let tree = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "--locked", "--prefix", "none", "--format", "{p} {f}"])
        .args(["--edges", edges])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let text = String::from_utf8(tree.stdout).unwrap();
    text.lines().map(|line| line.trim_end_matches(" (*)").to_owned()).collect()
}

/// `cargo test` after `cargo run -- demo` builds nothing of it again.
#[test]
fn tests_take_every_package_of_the_program_as_it_is() {
    let (program, tests) = (packages("normal,build"), packages("normal,build,dev"));
    let built_again: Vec<_> = program.difference(&tests).collect();
    assert!(program.len() > 200 && tests.len() > program.len(), "cargo tree prints packages");
    assert!(built_again.is_empty(), "other features for the tests: {built_again:#?}");
}
