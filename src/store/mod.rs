//! Implementations of [`JobStore`].
//!
//! | store | for |
//! |---|---|
//! | [`open_sqlite`] | one process; its jobs survive a crash of it |
//! | [`open_sqlite_in_memory`] | demonstrations and tests: the same tables, in memory |
//! | [`open_postgres`] | any number of processes on any number of machines |

mod deadline;
mod migration;
mod postgres;
mod sql;
mod sqlite;

use crate::jobs::{DeliveryStore, JobStore, KeyLimits, KeyStore};

/// Jobs, the API keys they come under, and the announcements of their ends.
pub trait Store: JobStore + KeyStore + DeliveryStore {}

impl<T: JobStore + KeyStore + DeliveryStore> Store for T {}

/// Bounds of a store.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StoreLimits {
    /// Most jobs that may wait.
    pub queue_capacity: usize,
    /// Limits of an API key that sets none of its own.
    pub by_key: KeyLimits,
    /// Free disk space \[bytes\] below which the store accepts no job. It applies to SQLite files
    /// only; a database server watches its own disk.
    pub min_free_bytes: u64,
}

pub use postgres::{PostgresError, open_postgres};
pub use sqlite::{
    DATABASE, SqliteError, open_sqlite, open_sqlite_in_memory, open_sqlite_keys, restore_sqlite,
};
