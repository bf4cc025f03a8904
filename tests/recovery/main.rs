//! Nothing acknowledged is lost: processes are killed, databases restarted, workers crash.
#![expect(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on says where"
)]

mod client;
#[path = "../support/cluster.rs"]
mod cluster;
mod crash_loop;
#[path = "../http/curl.rs"]
#[expect(dead_code, reason = "shared with the HTTP tests")]
mod curl;
mod kill;
#[path = "../support/line.rs"]
mod line;
mod lines;
mod nodes;
#[path = "../http/server.rs"]
#[expect(dead_code, reason = "shared with the HTTP tests")]
mod server;
#[path = "../http/solvers.rs"]
#[expect(dead_code, reason = "shared with the HTTP tests")]
mod solvers;
#[path = "../http/stand_in.rs"]
mod stand_in;
