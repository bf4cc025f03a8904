//! Where jobs are kept, and for how long.

use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;
use std::time::Duration;

use clap::Args;

use super::parse::hours;
use crate::jobs::Retention;
use crate::store::MemoryLimits;

/// Address of a database. Shown without what may be a password.
#[derive(Clone, PartialEq, Eq)]
pub enum DatabaseUrl {
    /// `memory:`: this process's memory, gone with it.
    Memory,
    /// `postgres://...`.
    Postgres(String),
}

impl FromStr for DatabaseUrl {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "memory:" {
            Ok(Self::Memory)
        } else if text.starts_with("postgres://") || text.starts_with("postgresql://") {
            Ok(Self::Postgres(text.to_owned()))
        } else {
            Err("must begin with postgres:// (or be memory:); without it, jobs are kept in --data-dir"
                .to_owned())
        }
    }
}

impl fmt::Debug for DatabaseUrl {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Memory => "memory:",
            Self::Postgres(_) => "postgres://...",
        })
    }
}

/// Settings of the store.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct StorageConfig {
    /// Directory of the embedded database; one process owns it
    #[arg(long, env = "BRINELL_DATA_DIR", value_name = "DIR", default_value = "brinell-data")]
    pub data_dir: PathBuf,

    /// Shared database instead of the embedded one, a `postgres://` address; `memory:` keeps nothing
    #[arg(long, env = "BRINELL_DATABASE_URL", value_name = "URL", hide_env_values = true)]
    pub database_url: Option<DatabaseUrl>,

    /// Most jobs that may wait in the queue
    #[arg(long, env = "BRINELL_QUEUE_CAPACITY", value_name = "N", default_value = "10000")]
    pub queue_capacity: usize,

    /// Time jobs with a result are kept for
    #[arg(long, env = "BRINELL_KEEP_RESULTS", value_name = "HOURS", default_value = "168", value_parser = hours)]
    pub keep_results: Duration,

    /// Time failed, cancelled and timed out jobs are kept for
    #[arg(long, env = "BRINELL_KEEP_FAILURES", value_name = "HOURS", default_value = "72", value_parser = hours)]
    pub keep_failures: Duration,

    /// Most finished jobs that are kept in memory (memory: only)
    #[arg(long, env = "BRINELL_KEEP_JOBS", value_name = "N", default_value = "1000")]
    pub keep_jobs: usize,

    /// Most memory that finished jobs may take (memory: only)
    #[arg(long, env = "BRINELL_KEEP_MEMORY", value_name = "MIB", default_value = "256")]
    pub keep_memory: u32,
}

impl Default for StorageConfig {
    fn default() -> Self {
        Self {
            data_dir: PathBuf::from("brinell-data"),
            database_url: None,
            queue_capacity: 10_000,
            keep_results: Duration::from_hours(168),
            keep_failures: Duration::from_hours(72),
            keep_jobs: 1000,
            keep_memory: 256,
        }
    }
}

impl StorageConfig {
    /// Whether other processes see the same jobs.
    pub const fn is_shared(&self) -> bool {
        matches!(self.database_url, Some(DatabaseUrl::Postgres(_)))
    }

    /// Whether jobs outlive the process.
    pub const fn is_durable(&self) -> bool {
        !matches!(self.database_url, Some(DatabaseUrl::Memory))
    }

    /// How long finished jobs are kept.
    pub const fn retention(&self) -> Retention {
        Retention { succeeded: self.keep_results, failed: self.keep_failures }
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
