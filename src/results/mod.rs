//! What a solution means to its reader.
mod report;
pub use report::*;
