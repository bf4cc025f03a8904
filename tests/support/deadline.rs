//! The one deadline of tests that wait for a condition.

use std::time::Duration;

/// Longest wait for a condition: long enough for two cores that eight busy programs share.
pub const DEADLINE: Duration = Duration::from_mins(3);
