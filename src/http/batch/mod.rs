//! Several jobs in one request, each answered as by a request of its own.

mod fetch;
mod item;
mod members;
mod request;

pub(super) use fetch::fetched;
pub(super) use item::{BatchAnswer, BatchItem, MAX_JOBS};
pub(super) use request::{BatchOfIds, BatchOfJobs, read_ids, read_jobs};
