//! Jobs whose load rolls: estimate, report, findings, answers.

mod answers;
mod cost;
mod document;
mod findings;
mod section;
mod step;
mod verdicts;

pub use document::{
    BodyPassErrorReport, BodyPassReport, FrictionLimits, PassErrorReport, PassReport,
    RollingReport, RuleVerdict, ShakedownLimit, SolvedHardening, TrackLimitReport,
    TrackLimitsReport, TrackVerdict,
};
pub(super) use step::Track;
