//! Settings of the solvers.

use std::num::NonZeroUsize;
use std::thread::available_parallelism;
use std::time::Duration;

use clap::Args;

use super::machine::machine_memory;
use super::parse::seconds;
use crate::worker::WorkerSettings;

/// Part of the machine's memory that jobs may take, in percent.
const MEMORY_PERCENT: u64 = 70;

/// Memory \[bytes\] assumed where the system does not report it.
const UNKNOWN_MEMORY: u64 = 4 << 30;

/// Default size of the cache of bodies and factors: a part of the jobs' memory, and at most so
/// many bytes.
const CACHE_PART: u64 = 8;
const MAX_CACHE: u64 = 512 << 20;

/// Memory of the places: a part of the jobs' memory, and at most so many bytes for each solver.
const PLACES_PART: u64 = 4;
const MAX_OF_PLACES: u64 = 320 << 20;

/// Settings of the solvers.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct WorkConfig {
    /// Jobs solved at the same time [default: one per core]
    #[arg(long, env = "BRINELL_WORKERS", value_name = "N")]
    pub workers: Option<NonZeroUsize>,

    /// Memory that the jobs being solved may need together, of which a quarter (320 a worker at
    /// most) is for small ones [default: 70 % of the machine's or the container's]
    #[arg(long, env = "BRINELL_MEMORY_LIMIT", value_name = "MIB")]
    pub memory_limit: Option<u32>,

    /// Memory for meshes and factors kept for later jobs on the same bodies; 0 keeps none
    /// [default: an eighth of --memory-limit, 512 at most]
    #[arg(long, env = "BRINELL_FACTOR_CACHE", value_name = "MIB")]
    pub factor_cache: Option<u32>,

    /// Longest time a job may be solved for
    #[arg(
        long, env = "BRINELL_JOB_TIMEOUT", value_name = "SECONDS", default_value = "600",
        value_parser = seconds,
    )]
    pub job_timeout: Duration,

    /// How often the worker of a job may be lost before the job is given up
    #[arg(
        long, env = "BRINELL_MAX_ATTEMPTS", value_name = "N", default_value = "3",
        value_parser = clap::value_parser!(u32).range(1..=100),
    )]
    pub max_attempts: u32,

    /// Time after which a worker without a sign of life is taken for lost
    #[arg(
        long, env = "BRINELL_LEASE", value_name = "SECONDS", default_value = "30",
        value_parser = seconds,
    )]
    pub lease: Duration,

    /// Time to finish running jobs in after SIGTERM; the others go back to the queue
    #[arg(
        long, env = "BRINELL_GRACE", value_name = "SECONDS", default_value = "30",
        value_parser = seconds,
    )]
    pub grace: Duration,
}

impl Default for WorkConfig {
    fn default() -> Self {
        Self {
            workers: None,
            memory_limit: None,
            factor_cache: None,
            job_timeout: Duration::from_mins(10),
            max_attempts: 3,
            lease: Duration::from_secs(30),
            grace: Duration::from_secs(30),
        }
    }
}

impl WorkConfig {
    /// Returns the number of jobs solved at the same time.
    pub fn slots(&self) -> usize {
        self.workers.or_else(|| available_parallelism().ok()).map_or(1, NonZeroUsize::get)
    }

    /// Memory \[bytes\] that the jobs being solved may need together.
    pub fn memory(&self) -> u64 {
        let default = || machine_memory().unwrap_or(UNKNOWN_MEMORY) / 100 * MEMORY_PERCENT;
        self.memory_limit.map_or_else(default, |mebibytes| u64::from(mebibytes) << 20)
    }

    /// Returns the part of [`Self::memory`] \[bytes\] that belongs to the places.
    fn memory_of_places(&self) -> u64 {
        (self.memory() / PLACES_PART).min(MAX_OF_PLACES * self.slots() as u64)
    }

    /// Largest memory \[bytes\] that a job may need.
    pub fn job_memory(&self) -> u64 {
        self.memory() - self.memory_of_places()
    }

    /// Returns the size \[bytes\] of the cache of bodies and factors, in addition to
    /// [`Self::memory`].
    pub fn factor_cache(&self) -> usize {
        let default = || (self.memory() / CACHE_PART).min(MAX_CACHE);
        let bytes = self.factor_cache.map_or_else(default, |mebibytes| u64::from(mebibytes) << 20);
        usize::try_from(bytes).unwrap_or(usize::MAX)
    }

    /// Returns the settings of a worker, for a durable store or one in memory.
    pub fn worker(&self, durable: bool) -> WorkerSettings {
        WorkerSettings {
            slots: self.slots(),
            memory: self.job_memory(),
            memory_of_place: self.memory_of_places() / (self.slots() as u64 + 1),
            job_timeout: self.job_timeout,
            lease: self.lease,
            poll: Duration::from_secs(1),
            max_attempts: self.max_attempts,
            empties_queue: !durable,
        }
    }
}
