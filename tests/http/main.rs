//! The service as its clients see it: the real binary, asked by the real `curl`.

mod bad_input;
mod curl;
mod in_process;
mod jobs;
mod protocol;
mod readme;
mod server;
mod shutdown;
mod solvers;
mod troubled;
