//! Settings of the service: each is a flag and a `BRINELL_*` variable; the flag wins.

use std::num::NonZeroUsize;
use std::thread::available_parallelism;
use std::time::Duration;

use clap::Args;

use crate::http::HttpSettings;
use crate::jobs::DeskLimits;
use crate::store::MemoryLimits;
use crate::worker::WorkerSettings;

/// Settings of `brinell serve`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct ServeConfig {
    /// Address and port to listen on; port 0 is any free one
    #[arg(long, env = "BRINELL_LISTEN", value_name = "ADDR", default_value = "127.0.0.1:8080")]
    pub listen: String,

    /// Jobs solved at the same time [default: one per core]
    #[arg(long, env = "BRINELL_WORKERS", value_name = "N")]
    pub workers: Option<NonZeroUsize>,

    /// Most jobs that may wait in the queue
    #[arg(long, env = "BRINELL_QUEUE_CAPACITY", value_name = "N", default_value = "1000")]
    pub queue_capacity: usize,

    /// Longest time POST /v1/solve waits for its result before it answers 202
    #[arg(long, env = "BRINELL_SOLVE_LIMIT", value_name = "SECONDS", default_value = "30", value_parser = seconds)]
    pub solve_limit: Duration,

    /// Longest time a job may be solved for
    #[arg(long, env = "BRINELL_JOB_TIMEOUT", value_name = "SECONDS", default_value = "600", value_parser = seconds)]
    pub job_timeout: Duration,

    /// Time to finish queued and running jobs in after SIGTERM
    #[arg(long, env = "BRINELL_GRACE", value_name = "SECONDS", default_value = "30", value_parser = seconds)]
    pub grace: Duration,

    /// Largest request body
    #[arg(long, env = "BRINELL_MAX_BODY", value_name = "BYTES", default_value = "1048576")]
    pub max_body: usize,

    /// Largest estimated memory of a job
    #[arg(long, env = "BRINELL_MAX_JOB_MEMORY", value_name = "MIB", default_value = "4096")]
    pub max_job_memory: u32,

    /// Most finished jobs that are kept
    #[arg(long, env = "BRINELL_KEEP_JOBS", value_name = "N", default_value = "1000")]
    pub keep_jobs: usize,

    /// Most memory that finished jobs may take
    #[arg(long, env = "BRINELL_KEEP_MEMORY", value_name = "MIB", default_value = "256")]
    pub keep_memory: u32,
}

impl Default for ServeConfig {
    fn default() -> Self {
        Self {
            listen: "127.0.0.1:8080".to_owned(),
            workers: None,
            queue_capacity: 1000,
            solve_limit: Duration::from_secs(30),
            job_timeout: Duration::from_mins(10),
            grace: Duration::from_secs(30),
            max_body: 1 << 20,
            max_job_memory: 4096,
            keep_jobs: 1000,
            keep_memory: 256,
        }
    }
}

impl ServeConfig {
    /// Bounds on what is taken in.
    pub fn desk(&self) -> DeskLimits {
        DeskLimits { job_bytes: u64::from(self.max_job_memory) << 20 }
    }

    /// Bounds on single requests.
    pub fn http(&self) -> HttpSettings {
        HttpSettings {
            max_body_bytes: self.max_body,
            solve_limit: self.solve_limit,
            ..HttpSettings::default()
        }
    }

    /// Bounds of the store in memory.
    pub fn memory(&self) -> MemoryLimits {
        MemoryLimits {
            queued_jobs: self.queue_capacity,
            finished_jobs: self.keep_jobs,
            finished_bytes: usize::try_from(u64::from(self.keep_memory) << 20).unwrap_or(usize::MAX),
            ..MemoryLimits::default()
        }
    }

    /// How the worker works.
    pub fn worker(&self) -> WorkerSettings {
        WorkerSettings {
            slots: self.workers.or_else(|| available_parallelism().ok()).map_or(1, NonZeroUsize::get),
            job_timeout: self.job_timeout,
            lease: Duration::from_secs(30),
            poll: Duration::from_secs(1),
            max_attempts: 3,
        }
    }
}

/// Reads a positive number of seconds, fractions allowed, up to about three years.
fn seconds(text: &str) -> Result<Duration, String> {
    let value: f64 = text.parse().map_err(|_| "must be a number of seconds".to_owned())?;
    if value > 0.0 && value <= 1e8 {
        Ok(Duration::from_secs_f64(value))
    } else {
        Err("must be greater than 0 and at most 100000000 seconds".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        config: ServeConfig,
    }

    #[test]
    fn the_defaults_of_the_flags_are_the_defaults_of_the_type() {
        assert_eq!(Line::parse_from(["brinell"]).config, ServeConfig::default());
    }

    #[test]
    fn times_must_be_positive() {
        assert_eq!(seconds("0.5"), Ok(Duration::from_millis(500)));
        for text in ["0", "-1", "NaN", "inf", "soon"] {
            assert!(seconds(text).is_err(), "{text}");
        }
    }
}
