//! Elasto-plastic contact between two bodies: contact pressure, approach, stresses below the
//! surface and the plastic zone, in milliseconds.
//!
//! # The problem
//! Two bodies meet at candidate node pairs `k` with initial gaps `δ0_k`, and a force P presses
//! them together. Wanted are the contact forces R, the gaps δ that remain, the approach α of the
//! two supports and the displacements u:
//!
//! ```text
//! K u = R + P_e(u)                      equilibrium of each body, K a stiffness factorized once
//! P_e(u) = ∫ Bᵀ (D_e - D_s(u)) B dV u   what plastic flow adds to the load (deformation theory)
//! u_p                                   what P_e alone does to the gap of each pair
//! -F R + α e + δ = δ0 + u_p             continuity, F the flexibility of both bodies at the pairs
//! eᵀR = P,  R >= 0,  δ >= 0,  R_k δ_k = 0
//! ```
//!
//! Everything after that one factorization of each body is forward and back substitution over the
//! small part of the factor that the contact and the plastic zone can reach. Contact and
//! plasticity alternate until the state is in equilibrium, and a check that shares no code with
//! the solvers decides whether it has converged. `docs/theory.md` in the repository has every
//! equation.
//!
//! # Example
//! ```
//! use brinell_solver::{job::Job, report::{self, Name}, solver::Unobserved};
//!
//! let body = r#"{"shape": {"type": "cylinder", "radius": 20}, "material": {"young_modulus": 210000,
//!     "poisson_ratio": 0.3,
//!     "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10500}}}"#;
//! let job = format!(
//!     r#"{{"analysis": "plane_strain", "upper": {body}, "lower": {body}, "load": {{"force": 612.6106}}}}"#
//! );
//! let report = report::run(&Job::from_json(job.as_bytes())?, &mut Unobserved)?;
//! let peak_pressure = report.steps[0][Name::PeakPressure]; // MPa; Hertz finds 1500, elastic
//! assert!((peak_pressure - 1150.4).abs() < 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Map
//! From the top down. The crate is pure: no async, no files, no clock, no printing.
//!
//! | module | what it is for |
//! |---|---|
//! | [`description`] | a job in a line |
//! | [`report`] | what a caller reads: figures, error bars, warnings; [`report::run`] is the way in |
//! | [`inputs`] | from a job to two bodies, their loads and settings |
//! | [`solver`] | finite elements and half-spaces as engines of `brinell-method`: sizes, factors, final fields |
//! | [`contact`] | solvers of the contact conditions and the check that all have to pass |
//! | [`fem`] | mesh, B-bar element, equations, stiffness, initial-stress loads, stresses |
//! | [`material`] | hardening curves, deformation and flow theory |
//! | [`job`] | the job, in types that cannot hold a wrong value; units |
//! | [`analytical`] | closed forms to compare with: Hertz, McEwen, Hill, Prandtl |
//!
//! `contact`, `fem`, `material` and `analytical` are crates of their own. Imports run downward
//! only.

pub use brinell_fem as fem;
pub mod description;
pub mod inputs;
pub mod job;
pub mod report;
pub mod solver;
mod units;

/// The contact conditions, their solvers and the check that all of them have to pass.
pub use brinell_contact as contact;

/// Hardening laws, deformation and flow theory.
pub use brinell_material as material;

/// Closed forms to compare with.
pub use brinell_material::analytical;

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
