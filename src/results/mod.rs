//! What a solution means to its reader.
mod report;
mod stub;
pub use report::*;
pub use stub::{JobEstimate, RunError, preflight, run};
