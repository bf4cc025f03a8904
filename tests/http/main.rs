//! The service as its clients see it: the real binary, asked by the real `curl` where there is one.
#![expect(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on says where"
)]

mod audit;
mod bad_input;
mod batch;
mod curl;
mod edge;
mod events;
mod exports;
mod guide;
mod hostile;
mod in_process;
mod jobs;
mod keys;
mod listing;
mod memory;
mod metrics;
mod openapi;
mod page;
mod paper;
mod protocol;
mod readme;
mod results;
#[path = "../support/schema.rs"]
mod schema;
mod server;
mod shutdown;
mod solvers;
mod stand_in;
mod storage;
mod stored;
mod submission;
mod three_dimensions;
mod tls;
mod traces;
mod troubled;
mod webhooks;
