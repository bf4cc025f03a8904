//! Where jobs are kept: implementations of [`JobStore`](crate::jobs::JobStore).
//!
//! | store | for |
//! |---|---|
//! | [`MemoryStore`] | demonstrations and tests |
//! | [`open_sqlite`] | one process; its jobs survive whatever happens to it, save those somebody waits for |
//! | [`open_postgres`] | any number of processes on any number of machines |

mod express;
pub mod memory;
mod migration;
mod postgres;
mod shelf;
mod sql;
mod sqlite;

/// Jobs and the API keys they come under.
pub trait Store: crate::jobs::JobStore + crate::jobs::KeyStore {}

impl<T: crate::jobs::JobStore + crate::jobs::KeyStore> Store for T {}

pub use memory::{MemoryLimits, MemoryStore};
pub use postgres::{PostgresError, open_postgres};
pub use sqlite::{SqliteError, open_sqlite, open_sqlite_keys};
