//! Jobs whose load rolls: estimate, report, findings, answers.

mod answers;
mod cost;
mod document;
mod findings;
mod known;
mod section;
mod step;
mod verdicts;

pub use document::{
    Course, PassesReport, RuleVerdict, ShakedownMap, SolvedHardening, TrackVerdict,
};
pub(super) use known::Rolled;
pub(super) use step::Track;
