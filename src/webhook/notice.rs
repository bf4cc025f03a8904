//! The body of an announcement: the job's id and final state. The receiver fetches the result from
//! the service.

use std::collections::BTreeMap;

use jiff::Timestamp;
use serde::Serialize;

use crate::jobs::{JobId, JobRecord, JobState};

/// The body of an announcement.
#[derive(Debug, Serialize)]
pub(super) struct Notice {
    /// The event; further kinds may follow.
    r#type: &'static str,
    /// When.
    timestamp: Option<Timestamp>,
    data: NoticeJob,
}

/// A job, as far as it is told.
#[derive(Debug, Serialize)]
struct NoticeJob {
    id: JobId,
    status: JobState,
    has_result: bool,
    tags: BTreeMap<String, String>,
    created_at: Timestamp,
    finished_at: Option<Timestamp>,
    /// Address of the job, below that of the service.
    job: String,
}

impl Notice {
    pub(super) fn of(record: JobRecord) -> Self {
        Self {
            r#type: "job.finished",
            timestamp: record.finished_at,
            data: NoticeJob {
                id: record.id,
                status: record.state,
                has_result: record.has_report,
                tags: record.tags,
                created_at: record.created_at,
                finished_at: record.finished_at,
                job: format!("/v1/jobs/{}", record.id),
            },
        }
    }
}
