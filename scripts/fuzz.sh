#!/usr/bin/env bash
# Feeds random jobs to the parser: scripts/fuzz.sh [SECONDS], 60 unless said otherwise.
#
# libFuzzer with the compiler's own coverage instrumentation, which a stable toolchain has too. Address sanitizing, the
# part that needs a nightly one (`cargo +nightly fuzz run parse_job`), finds little in code that forbids `unsafe`.
# What is found lies in target/fuzz/findings, and the run fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seconds=${1:-60}
host=$(rustc -vV | sed -n 's/^host: //p')
# With a target, build scripts and macros are left out of the instrumentation.
coverage=(
    --cfg fuzzing
    -Cpasses=sancov-module
    -Ccodegen-units=1
    -Cllvm-args=-sanitizer-coverage-level=4
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters
    -Cllvm-args=-sanitizer-coverage-pc-table
    -Cllvm-args=-sanitizer-coverage-trace-compares
)
RUSTFLAGS="${coverage[*]}" cargo build --manifest-path fuzz/Cargo.toml --target "$host" --target-dir target/fuzz

mkdir -p target/fuzz/corpus target/fuzz/findings
"target/fuzz/$host/debug/parse_job" target/fuzz/corpus api/examples \
    -artifact_prefix=target/fuzz/findings/ -dict=fuzz/job.dict -max_total_time="$seconds" -timeout=10 -print_final_stats=1
