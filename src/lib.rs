//! The service and the command line around [`brinell_solver`]: jobs, their store, workers, HTTP,
//! the program.
//!
//! | module | what it is for |
//! |---|---|
//! | [`cli`] | `serve`, `worker`, `solve`, `validate`, `demo`, `key`, `openapi`, `healthcheck` |
//! | [`app`] | assembly, run and shutdown of the service |
//! | [`config`], [`telemetry`], `lifecycle` | flags and variables; log and metrics; signals |
//! | [`http`] | router, one endpoint a file, problems, the OpenAPI document |
//! | [`webhook`], [`outgoing`] | announcements of the ends of jobs; the HTTP client |
//! | [`worker`] | solver threads, their supervisors, leases and heartbeats |
//! | [`store`] | stores of jobs: SQLite, PostgreSQL |
//! | [`jobs`] | identity and states of a job, trait of the store |
//!
//! Imports run downward only.
pub mod app;
pub mod cli;
pub mod config;
pub mod http;
pub mod jobs;
pub mod lifecycle;
pub mod outgoing;
pub mod store;
pub mod telemetry;
pub mod webhook;
pub mod worker;
