//! The service and the command line around [`brinell_solver`]: jobs, their store, workers, HTTP,
//! the program.
//!
//! | module | what it is for |
//! |---|---|
//! | [`cli`] | `serve`, `worker`, `solve`, `validate`, `demo`, `key`, `openapi`, `healthcheck` |
//! | [`app`] | puts the service together, runs it, takes it down in order |
//! | [`config`], [`telemetry`], `lifecycle` | flags and variables; log and metrics; signals |
//! | [`http`] | router, one endpoint a file, problems, the OpenAPI document |
//! | [`webhook`], [`outgoing`] | announcements of the ends of jobs; requests that the service makes itself |
//! | [`worker`] | solver threads, their supervisors, leases and heartbeats |
//! | [`store`] | where jobs are kept |
//! | [`jobs`] | what a job is once handed in: identity, states, store trait |
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
