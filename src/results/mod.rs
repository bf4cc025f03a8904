//! What a solution means to its reader: the report, its validity and its error bars.

mod build;
pub mod export;
mod recovery;
mod report;
mod run;
mod subsurface;
mod units;
mod validity;

pub use report::*;
pub use run::{JobEstimate, RunError, preflight, run};
