//! Looks for the programs that some tests need. A test whose program is not there is ignored with
//! that reason, unless `BRINELL_TESTS_COMPLETE` is set: then it fails.

use std::env;
use std::path::PathBuf;
use std::process::Command;

const COMPLETE: &str = "BRINELL_TESTS_COMPLETE";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(no_curl, no_postgresql)");
    let is_there = |program: &str| folders().iter().any(|folder| folder.join(program).exists());
    // Without a server of the system, `tests/support/cluster.rs` fetches one by pip.
    let postgresql = env::var_os("BRINELL_TEST_DATABASE_URL").is_some()
        || is_there("initdb")
        || PathBuf::from("/usr/lib/postgresql").exists()
        || answers("python3", &["-m", "pip", "--version"]);
    let found = [("no_curl", is_there("curl")), ("no_postgresql", postgresql)];
    let missing: Vec<_> = found.iter().filter(|(_, found)| !found).collect();
    if missing.is_empty() {
        return;
    }
    println!("cargo::rerun-if-env-changed=PATH");
    println!("cargo::rerun-if-env-changed={COMPLETE}");
    if env::var_os(COMPLETE).is_none() {
        for (name, _) in missing {
            println!("cargo::rustc-cfg={name}");
        }
    }
}

fn folders() -> Vec<PathBuf> {
    env::split_paths(&env::var_os("PATH").unwrap_or_default()).collect()
}

fn answers(program: &str, args: &[&str]) -> bool {
    Command::new(program).args(args).output().is_ok_and(|output| output.status.success())
}
