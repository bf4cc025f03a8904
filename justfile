# Developer commands. `just` lists them; each also works typed out.

_default:
    @just --list

# Everything a change has to pass
ci:
    .ci/run

# All tests
test:
    cargo test

# Closed forms, invariants, other programs
verify:
    cargo test --test verification

# Formatting and lints
lint:
    cargo fmt --check
    cargo clippy --all-targets -- -D warnings

# Documentation of the library, warnings being errors
doc:
    RUSTDOCFLAGS='-D warnings' cargo doc --no-deps

# The core without the service around it
core:
    cargo check --lib --no-default-features

# The reference problem over HTTP, shown
demo:
    cargo run --release -- demo

# The service on 127.0.0.1:8080
serve:
    cargo run --release -- serve
