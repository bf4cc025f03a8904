//! Where jobs are kept: implementations of [`JobStore`](crate::jobs::JobStore).
//!
//! | store | for |
//! |---|---|
//! | [`MemoryStore`] | demonstrations and tests |
//! | [`open_sqlite`] | one process; its jobs survive whatever happens to it |
//! | [`open_postgres`] | any number of processes on any number of machines |

pub mod memory;
mod migration;
mod postgres;
mod shelf;
mod sql;
mod sqlite;

pub use memory::{MemoryLimits, MemoryStore};
pub use postgres::{PostgresError, open_postgres};
pub use sqlite::{SqliteError, open_sqlite};
