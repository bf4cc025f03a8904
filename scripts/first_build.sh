#!/usr/bin/env bash
# Builds the program from an empty target folder as a newcomer's `cargo run -- demo` does, and fails if that takes more
# processor time than docs/notes/builds.md promises. Only an idle machine tells: beside other programs it takes a quarter more.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
most=450
folder=$(mktemp -d target/first-build.XXXXXX)
trap 'rm -rf "$folder"' EXIT
TIMEFORMAT='%U %S'
spent=$({ time CARGO_TARGET_DIR=$folder cargo build --quiet 2>"$folder/log"; } 2>&1) || { cat "$folder/log"; exit 1; }
awk -v most="$most" '{ printf "first build: %.0f s of processor time, at most %d\n", $1 + $2, most; exit $1 + $2 > most }' <<<"$spent"
