//! The hardening laws, one by one.

mod bilinear;
mod explicit;
mod ramberg_osgood;
mod table;

pub use bilinear::Bilinear;
pub use explicit::{Ludwik, Swift, Voce};
pub use ramberg_osgood::RambergOsgood;
pub use table::Table;
