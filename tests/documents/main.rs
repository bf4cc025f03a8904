//! The documents: those that are generated are those of today, and whatever they name exists.

#![expect(clippy::expect_used, reason = "a test that cannot go on says where")]

mod names;
mod reference;

use std::fs;
use std::path::{Path, PathBuf};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

fn path(inside: impl AsRef<Path>) -> PathBuf {
    Path::new(ROOT).join(inside)
}

fn read(inside: impl AsRef<Path>) -> String {
    let path = path(inside);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
