//! Elliptic contacts that roll and slide.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

mod driver;
mod march;
mod operators;
mod passes;
