//! Brings a database up to date. Steps are applied in order, each once, and are never changed
//! afterwards.

use sqlx::migrate::{Migrate, MigrateError, Migration, MigrationType, Migrator};
use sqlx::{Acquire, SqlSafeStr};

/// One change of the tables.
pub(super) struct Step {
    pub(super) version: i64,
    pub(super) name: &'static str,
    pub(super) sql: &'static str,
}

/// The steps to the tables of one kind of database.
macro_rules! steps {
    ($kind:literal) => {
        $crate::store::migration::steps!($kind:
            1 "jobs" "0001_jobs", 2 "requests" "0002_requests", 3 "results" "0003_results",
            4 "fair \
               share" "0004_fair_share", 5 "quotas" "0005_quotas", 6 "callbacks" "0006_callbacks",
            7 "field parts" "0007_field_parts", 8 "solver time" "0008_solver_time")
    };
    ($kind:literal: $($version:literal $name:literal $file:literal),*) => {
        &[$($crate::store::migration::Step {
            version: $version,
            name: $name,
            sql: include_str!(concat!("../../migrations/", $kind, "/", $file, ".sql")),
        }),*]
    };
}
pub(super) use steps;

/// Applies the steps that are missing. Several processes may start at once: on PostgreSQL they
/// take turns by an advisory lock.
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
    let migrator = Migrator::with_migrations(steps.iter().map(step).collect());
    migrator.run(database).await.map_err(|error| match error {
        MigrateError::VersionMissing(step) => sqlx::Error::Configuration(
            format!(
                "it was made by a newer version of brinell (version {} does not know its step \
                 {step}); run that version, or restore a backup of before",
                env!("CARGO_PKG_VERSION")
            )
            .into(),
        ),
        error => error.into(),
    })
}
