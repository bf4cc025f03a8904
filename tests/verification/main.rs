//! Verification against closed forms, invariants and independent programs, one file for each named problem.

#![expect(clippy::unwrap_used, reason = "a test ends where it fails")]
#![expect(clippy::float_cmp, reason = "what is set to zero is exactly zero")]

mod bodies;
mod contact_solvers;
mod error_bars;
mod independent_program;
mod invariants;
mod line_contact;
mod paper_problem;
mod problems;
mod soundness;
mod subsurface;
mod thick_cylinder;
mod yield_onset;
