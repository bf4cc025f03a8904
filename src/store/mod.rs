//! Where jobs are kept: implementations of [`JobStore`].
//!
//! | store | for |
//! |---|---|
//! | [`open_sqlite`] | one process; its jobs survive whatever happens to it |
//! | [`open_sqlite_in_memory`] | demonstrations and tests: the same tables, gone with the process |
//! | [`open_postgres`] | any number of processes on any number of machines |

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
    /// What an API key may take that has no bound of its own.
    pub by_key: KeyLimits,
    /// Room \[bytes\] on the disk below which no job is accepted. Only of a file: the disk of a
    /// server is its own matter.
    pub min_free_bytes: u64,
}

pub use postgres::{PostgresError, open_postgres};
pub use sqlite::{
    DATABASE, SqliteError, open_sqlite, open_sqlite_in_memory, open_sqlite_keys, restore_sqlite,
};
