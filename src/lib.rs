//! Elasto-plastic contact between two bodies.
pub mod model;
pub mod results;
pub mod solve;

#[cfg(feature = "service")]
pub mod http;
#[cfg(feature = "service")]
pub mod jobs;
#[cfg(feature = "service")]
pub mod store;
#[cfg(feature = "service")]
pub mod worker;
