//! Settings of the store and of retention.

use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;
use std::time::Duration;

use clap::Args;

use super::parse::hours;
use crate::jobs::{KeyLimits, Retention};
use crate::store::StoreLimits;

/// Value of `--data-dir` that stands for this process's memory.
const MEMORY: &str = ":memory:";

/// URL of a PostgreSQL database; `Debug` hides it, because it may contain a password.
#[derive(Clone, PartialEq, Eq)]
pub struct DatabaseUrl(String);

impl DatabaseUrl {
    /// The address, password included.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl FromStr for DatabaseUrl {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.starts_with("postgres://") || text.starts_with("postgresql://") {
            Ok(Self(text.to_owned()))
        } else {
            Err("must begin with postgres://; without it, jobs are kept in --data-dir".to_owned())
        }
    }
}

impl fmt::Debug for DatabaseUrl {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("postgres://...")
    }
}

/// Settings of the store.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct StorageConfig {
    /// Directory of the embedded database, which one process owns; `:memory:` keeps jobs in memory
    /// only
    #[arg(long, env = "BRINELL_DATA_DIR", value_name = "DIR", default_value = "brinell-data")]
    pub data_dir: PathBuf,

    /// Shared database instead of the embedded one, a `postgres://` address
    #[arg(long, env = "BRINELL_DATABASE_URL", value_name = "URL", hide_env_values = true)]
    pub database_url: Option<DatabaseUrl>,

    /// Most connections to the shared database; one more listens, and a worker has two more for its
    /// heartbeats and claims
    #[arg(
        long, env = "BRINELL_DATABASE_CONNECTIONS", value_name = "N", default_value = "10",
        value_parser = clap::value_parser!(u32).range(2..=1000),
    )]
    pub database_connections: u32,

    /// Most jobs that may wait in the queue
    #[arg(long, env = "BRINELL_QUEUE_CAPACITY", value_name = "N", default_value = "10000")]
    pub queue_capacity: usize,

    /// Most jobs of one API key that may wait in the queue [default: no bound but the queue's]
    #[arg(long, env = "BRINELL_QUEUE_CAPACITY_PER_KEY", value_name = "N")]
    pub queue_capacity_per_key: Option<u32>,

    /// Most jobs of one API key that may be solved at the same time [default: no bound]
    #[arg(long, env = "BRINELL_MAX_RUNNING_PER_KEY", value_name = "N")]
    pub max_running_per_key: Option<u32>,

    /// Room that the results of one API key may take [default: no bound]
    #[arg(long, env = "BRINELL_MAX_STORED_PER_KEY", value_name = "MIB")]
    pub max_stored_per_key: Option<u32>,

    /// Highest priority of jobs of an API key [default: no bound]
    #[arg(
        long,
        env = "BRINELL_MAX_PRIORITY_PER_KEY",
        value_name = "N",
        allow_hyphen_values = true
    )]
    pub max_priority_per_key: Option<i16>,

    /// Time jobs with a result are kept for
    #[arg(
        long, env = "BRINELL_KEEP_RESULTS", value_name = "HOURS", default_value = "168",
        value_parser = hours,
    )]
    pub keep_results: Duration,

    /// Time failed, cancelled and timed out jobs are kept for
    #[arg(
        long, env = "BRINELL_KEEP_FAILURES", value_name = "HOURS", default_value = "72",
        value_parser = hours,
    )]
    pub keep_failures: Duration,

    /// Room for results above which the jobs that finished first are removed before their time
    /// [default: no bound]
    #[arg(long, env = "BRINELL_KEEP_STORED", value_name = "MIB")]
    pub keep_stored: Option<u32>,

    /// Room on the disk of --data-dir below which no job is accepted
    #[arg(long, env = "BRINELL_MIN_FREE_DISK", value_name = "MIB", default_value = "256")]
    pub min_free_disk: u32,

    /// Most memory that jobs may take with `--data-dir :memory:`
    #[arg(long, env = "BRINELL_KEEP_MEMORY", value_name = "MIB", default_value = "256")]
    pub keep_memory: u32,
}

impl Default for StorageConfig {
    fn default() -> Self {
        Self {
            data_dir: PathBuf::from("brinell-data"),
            database_url: None,
            database_connections: 10,
            queue_capacity: 10_000,
            queue_capacity_per_key: None,
            max_running_per_key: None,
            max_stored_per_key: None,
            max_priority_per_key: None,
            keep_results: Duration::from_hours(168),
            keep_failures: Duration::from_hours(72),
            keep_stored: None,
            min_free_disk: 256,
            keep_memory: 256,
        }
    }
}

impl StorageConfig {
    /// Returns whether other processes share the store.
    pub const fn is_shared(&self) -> bool {
        self.database_url.is_some()
    }

    /// Returns whether jobs outlive the process.
    pub fn is_durable(&self) -> bool {
        !self.is_in_memory()
    }

    /// Returns whether the store is in this process's memory.
    pub fn is_in_memory(&self) -> bool {
        self.database_url.is_none() && self.data_dir.as_os_str() == MEMORY
    }

    /// Returns how long finished jobs are kept.
    pub fn retention(&self) -> Retention {
        Retention {
            succeeded: self.keep_results,
            failed: self.keep_failures,
            stored_bytes: self.keep_stored.map(|mebibytes| u64::from(mebibytes) << 20),
        }
    }

    /// Returns the bounds of the store.
    pub fn limits(&self) -> StoreLimits {
        StoreLimits {
            queue_capacity: self.queue_capacity,
            by_key: KeyLimits {
                queued: self.queue_capacity_per_key,
                running: self.max_running_per_key,
                stored_bytes: self.max_stored_per_key.map(|mebibytes| u64::from(mebibytes) << 20),
                priority: self.max_priority_per_key,
            },
            min_free_bytes: u64::from(self.min_free_disk) << 20,
        }
    }

    /// Most memory \[bytes\] of a store in memory.
    pub fn memory_bytes(&self) -> u64 {
        u64::from(self.keep_memory) << 20
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passwords_are_not_shown() {
        let url: DatabaseUrl = "postgres://user:secret@host/name".parse().unwrap();
        assert!(!format!("{url:?}").contains("secret"));
        assert!("mysql://x".parse::<DatabaseUrl>().is_err());
    }
}
