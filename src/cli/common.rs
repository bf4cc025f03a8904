//! What several commands share.

use clap::ValueEnum;

use super::fault::Fault;

/// Exit code for a job that did not converge.
pub(super) const NOT_CONVERGED: u8 = 3;

/// How to print an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// JSON, for programs
    Json,
    /// A table, for people
    Table,
}

/// Runs async work on a runtime of its own.
pub(super) fn block_on<T>(work: impl Future<Output = Result<T, Fault>>) -> Result<T, Fault> {
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build()?;
    let done = runtime.block_on(work);
    runtime.shutdown_background();
    done
}
