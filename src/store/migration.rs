//! Brings a database up to date. Steps are applied in order, each once, and are never changed afterwards.

use sqlx::migrate::{Migrate, Migration, MigrationType, Migrator};
use sqlx::{Acquire, SqlSafeStr};

/// One change of the tables.
pub(super) struct Step {
    pub(super) version: i64,
    pub(super) name: &'static str,
    pub(super) sql: &'static str,
}

/// Applies the steps that are missing. Several processes may start at once: on PostgreSQL they take turns by an
/// advisory lock.
///
/// # Errors
/// If a step fails (its transaction is rolled back), or the database was made by a newer version.
pub(super) async fn run<'a, A>(steps: &[Step], database: A) -> Result<(), sqlx::Error>
where
    A: Acquire<'a>,
    <A::Connection as std::ops::Deref>::Target: Migrate,
{
    let step = |step: &Step| {
        let sql = step.sql.into_sql_str();
        Migration::new(step.version, step.name.into(), MigrationType::Simple, sql, false)
    };
    Migrator::with_migrations(steps.iter().map(step).collect()).run(database).await?;
    Ok(())
}
