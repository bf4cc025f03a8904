//! The checker itself, on made-up sources.

use super::Rules;

const SMALL: Rules<'_> = Rules {
    layers: &[&["app"], &["http", "store"], &["solve"], &["mesh", "contact"], &["linalg", "model"]],
    barred: &[("http", &["solve"], "it is told by others")],
    exceptions: &[("mesh", "contact", "they share the numbering of pairs")],
    core: "solve",
    reserved: &[("faer", "linalg")],
};

#[track_caller]
fn faults(file: &str, source: &str, expected: &[&str]) {
    assert_eq!(SMALL.check(file, source), expected);
}

#[test]
fn downward_is_free() {
    faults("src/solve/run.rs", "use crate::mesh::Mesh;\nuse crate::{contact, linalg::{self, Graph}};", &[]);
    faults("src/mesh/mod.rs", "use crate::contact::Pairs;\nuse crate::mesh::outline;", &[]);
    faults("src/lib.rs", "pub use crate::solve::run;", &[]);
}

#[test]
fn upward_and_sideways_are_not() {
    let upward = "src/mesh/grid.rs:2 imports crate::solve: mesh may not see solve, which lies above it";
    faults("src/mesh/grid.rs", "//! Grid.\nuse crate::solve::run;", &[upward]);
    let sideways = "src/http/x.rs:1 imports crate::store: http may not see store, which lies beside it";
    faults("src/http/x.rs", "use crate::store::MemoryStore;", &[sideways]);
    let barred = "src/http/x.rs:1 imports crate::solve: http may not see solve: it is told by others";
    faults("src/http/x.rs", "use crate::solve::Observer;", &[barred]);
}

#[test]
fn an_exception_holds_one_way() {
    let other_way = "src/contact.rs:1 imports crate::mesh: contact may not see mesh, which lies beside it";
    faults("src/contact.rs", "use crate::mesh::Mesh;", &[other_way]);
}

#[test]
fn the_lowest_layer_imports_nothing() {
    let source = "use crate::model::Job;\nuse crate::mesh::Mesh;\nuse crate::linalg::Graph;";
    assert_eq!(SMALL.check("src/linalg/graph.rs", source).len(), 2);
}

#[test]
fn groups_paths_and_visibilities_are_seen() {
    for source in [
        "use crate::{linalg::Graph, solve::{run, Options}};",
        "use {std::fmt, crate::solve::run};",
        "use crate :: solve as s;",
        "fn f(x: &crate::solve::Options) {}",
        "fn f() -> Vec<crate::solve::Options> { Vec::<crate::linalg::Graph>::new() }",
        "macro_rules! m { () => { $crate::solve::run() } }",
        "pub(in crate::solve) fn f() {}",
    ] {
        assert_eq!(SMALL.check("src/mesh/grid.rs", source).len(), 1, "{source}");
    }
    assert_eq!(SMALL.check("src/mesh/grid.rs", "use crate::{solve::{A, B}, app};").len(), 2);
}

#[test]
fn super_can_lead_out_of_a_module() {
    let out = "src/mesh/grid.rs:1 imports crate::solve: mesh may not see solve, which lies above it";
    faults("src/mesh/grid.rs", "use super::super::solve::run;", &[out]);
    faults("src/mesh/grid.rs", "use super::outline::solve;", &[]);
    faults("src/mesh/grid.rs", "mod tests { use super::super::solve; }", &[]);
    assert_eq!(
        SMALL.check("src/mesh/grid.rs", "mod tests { use super::super::super::solve::run; }").len(),
        1
    );
    assert_eq!(SMALL.check("src/mesh/mod.rs", "use super::solve::run;").len(), 1);
    assert_eq!(SMALL.check("src/mesh/grid.rs", "mod a { mod b {} } use super::super::solve::run;").len(), 1);
}

#[test]
fn comments_strings_and_characters_are_not_code() {
    let source = r##"
        //! See [`crate::solve`]; println! and tokio are banned.
        /* use crate::solve::run; /* faer */ use crate::app; */
        const A: &str = "use crate::solve::run; \" faer";
        const B: &str = r#"crate::app::run " tokio"#;
        const C: [char; 3] = ['"', '\'', '\u{22}'];
        fn f<'a>(x: &'a str) -> &'a str { x }
    "##;
    faults("src/mesh/grid.rs", source, &[]);
    let then = format!("{source}\nuse crate::solve::run;");
    assert_eq!(SMALL.check("src/mesh/grid.rs", &then).len(), 1, "the code after them is");
}

#[test]
fn the_core_is_pure_and_the_service_need_not_be() {
    for source in [
        "use std::time::Instant;",
        "use std::{fmt, fs::File};",
        "fn f() { std::thread::spawn(|| ()); }",
        "use tokio::sync::Notify;",
        "fn f() { println!(\"{}\", 1); }",
    ] {
        assert_eq!(SMALL.check("src/mesh/grid.rs", source).len(), 1, "{source}");
        assert_eq!(SMALL.check("src/http/x.rs", source).len(), 0, "{source}");
    }
    faults("src/mesh/grid.rs", "use std::time::Duration; fn print(env: u8) -> u8 { env }", &[]);
}

#[test]
fn linear_algebra_alone_starts_threads() {
    let source = "use std::thread;";
    faults("src/linalg/x.rs", source, &[]);
    faults("src/solve/x.rs", source, &["src/solve/x.rs:1 names std::thread: solve belongs to the core"]);
    assert_eq!(SMALL.check("src/linalg/x.rs", "use std::fs;").len(), 1);
}

#[test]
fn a_reserved_crate_stays_where_it_is() {
    let fault = "src/solve/x.rs:1 names faer: only linalg may";
    faults("src/solve/x.rs", "use faer::sparse::SparseColMat;", &[fault]);
    faults("src/linalg/x.rs", "use faer::sparse::SparseColMat;", &[]);
}

#[test]
fn what_has_no_layer_is_refused() {
    let unplaced = "src/utils.rs: utils is in no layer; say in tests/architecture.rs where it belongs";
    faults("src/utils.rs", "", &[unplaced]);
    for source in ["use crate::utils::f;", "use crate::*;", "use crate::{self as root};"] {
        assert_eq!(SMALL.check("src/solve/run.rs", source).len(), 1, "{source}");
    }
}
