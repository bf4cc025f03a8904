#!/usr/bin/env bash
# The verdict on one part within a minute of a change: its unit tests and a dozen named problems.
#
# usage: scripts/quick.sh PART; PART is a crate without `brinell-` (solver, contact, ...), sparse-cholesky,
# service or page. Slow tests stay with .ci/run and .ci/full.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
part=${1:?"which part? a crate, service or page"}

# One problem for each coupling, analysis, law family, theory and kind of load.
solver_problems=(
)
# One question for each route family, the queue, the lock of the document and the command line.
service_problems=(
)

case $part in
solver)
    cargo test -p brinell-solver --lib --test solver -- --exact "${solver_problems[@]}"
    ;;
service)
    cargo test -p brinell --lib --test http --test openapi --test cli -- --exact "${service_problems[@]}"
    ;;
page)
    npm --prefix tests/page run check
    [ -x target/debug/brinell ] || cargo build
    npm --prefix tests/page run smoke
    ;;
*)
    [ -d "crates/$part" ] || part=brinell-$part
    cargo test -p "$part"
    ;;
esac
