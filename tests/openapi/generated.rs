//! Files of the repository that are written from the program: they have to be what the program
//! would write now.
//!
//! `BRINELL_WRITE=1 cargo test --test openapi` writes them anew.

use std::fs;
use std::path::{Path, PathBuf};

use brinell::http::openapi;

use crate::{form, types};

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[track_caller]
fn assert_written(path: &str, text: &str) {
    let file: PathBuf = root().join(path);
    if std::env::var_os("BRINELL_WRITE").is_some() {
        fs::write(&file, text).unwrap();
    }
    let is_same = fs::read_to_string(&file).is_ok_and(|written| written == text);
    assert!(
        is_same,
        "{path} is not what the program says; write it anew: BRINELL_WRITE=1 cargo test --test \
         openapi"
    );
}

#[test]
fn the_document_is_in_the_repository() {
    assert_written("api/openapi.json", &openapi::pretty(&openapi::document()));
}

#[test]
fn the_tables_of_the_form_are_those_of_the_core() {
    let figures = types::figures(&openapi::document());
    assert_written("web/setup/tables.js", &format!("{}\n{figures}", form::tables()));
}

#[test]
fn the_types_of_the_page_are_those_of_the_document() {
    let page = fs::read_to_string(root().join("web/types.js")).unwrap();
    assert_written("web/wire.js", &types::types(&openapi::document(), &page));
}
