//! The `brinell` program.

use std::process::ExitCode;

fn main() -> ExitCode {
    brinell::cli::main()
}
