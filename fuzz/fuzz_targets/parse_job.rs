//! Any bytes: they are a job or they are refused with reasons; a job survives being written and
//! read, and its cost can be estimated. Nothing panics.
#![no_main]

use brinell_solver::job::{Job, JobError};
use brinell_solver::report::preflight;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &[u8]| {
    match Job::from_json(text) {
        Ok(job) => {
            let written = serde_json::to_vec(&job).expect("a job can be written");
            // A conversion of units may move a figure at the very edge of its range by one digit,
            // out of it.
            if let Ok(back) = Job::from_json(&written) {
                assert_eq!(back.units, job.units);
                assert_eq!(back.tags, job.tags);
            }
            let _ = preflight(&job);
        }
        Err(JobError::Fields(faults)) => {
            assert!(!faults.is_empty());
            assert!(faults.iter().all(|fault| !fault.detail.is_empty()));
        }
        Err(JobError::Syntax { line, column, .. }) => assert!(line > 0 || column == 0),
    }
});
