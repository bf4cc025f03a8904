//! Elasto-plastic contact between two bodies: contact pressure, approach, stresses below the surface and the
//! plastic zone, in milliseconds.
//!
//! # The problem
//! Two bodies meet at candidate node pairs `k` with initial gaps `δ0_k`, and a force P presses them together.
//! Wanted are the contact forces R, the gaps δ that remain, the approach α of the two supports and the
//! displacements u:
//!
//! ```text
//! K u = R + P_e(u)                      equilibrium of each body, K a stiffness factorized once
//! P_e(u) = ∫ Bᵀ (D_e - D_s(u)) B dV u   what plastic flow adds to the load (deformation theory)
//! u_p                                   what P_e alone does to the gap of each pair
//! -F R + α e + δ = δ0 + u_p             continuity, F the flexibility of both bodies at the pairs
//! eᵀR = P,  R >= 0,  δ >= 0,  R_k δ_k = 0
//! ```
//!
//! Everything after that one factorization of each body is forward and back substitution over the small
//! part of the factor that the contact and the plastic zone can reach. Contact and plasticity alternate until
//! the state is in equilibrium, and a judge that shares no code with the solvers has the last word.
//! `docs/theory.md` in the repository has every equation.
//!
//! # Example
//! ```
//! use brinell::{model::Job, results, solve::Unobserved};
//!
//! let body = r#"{"shape": {"type": "cylinder", "radius": 20}, "material": {"young_modulus": 210000,
//!     "poisson_ratio": 0.3,
//!     "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10500}}}"#;
//! let job = format!(
//!     r#"{{"analysis": "plane_strain", "upper": {body}, "lower": {body}, "load": {{"force": 612.6106}}}}"#
//! );
//! let report = results::run(&Job::from_json(job.as_bytes())?, &mut Unobserved)?;
//! let peak_pressure = report.steps[0].contact.peak_pressure; // MPa; Hertz's elastic answer is 1500
//! assert!((peak_pressure - 1182.6).abs() < 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Map
//! The core, from the top down. It is pure: no async, no files, no clock, no printing.
//!
//! | module | what it is for |
//! |---|---|
//! | [`results`] | the report of a solution, its error bars and validity; [`results::run`] is the way in |
//! | [`solve`] | sizes the meshes, alternates contact and plasticity, judges the final state |
//! | [`contact`] | two solvers of the contact conditions and the check that both have to pass |
//! | [`assembly`] | equation numbers, stiffness, initial-stress loads, stresses |
//! | [`mesh`] | a block of squares under the contact, wrapped in rings out to the boundary |
//! | [`element`] | the 4-node quadrilateral with mean dilatation (B-bar) |
//! | [`plasticity`] | hardening curves, deformation theory |
//! | [`model`] | the job, in types that cannot hold a wrong value; units |
//! | [`linalg`] | elimination order, sparse Cholesky, solves over parts of the factor |
//! | [`analytical`] | closed forms to compare with: Hertz, McEwen, Hill, Prandtl |
//!
//! Around it, with the feature `service` (on by default): `jobs`, `store`, `worker`, `http`, `config`,
//! `telemetry`, `lifecycle`, `app`, `cli`. Imports run downward only; `tests/architecture.rs` sees to it.
pub mod analytical;
pub mod assembly;
pub mod contact;
pub mod element;
pub mod linalg;
pub mod mesh;
pub mod model;
pub mod plasticity;
pub mod results;
pub mod solve;

#[cfg(feature = "service")]
pub mod app;
#[cfg(feature = "service")]
pub mod cli;
#[cfg(feature = "service")]
pub mod config;
#[cfg(feature = "service")]
pub mod http;
#[cfg(feature = "service")]
pub mod jobs;
#[cfg(feature = "service")]
pub mod lifecycle;
#[cfg(feature = "service")]
pub mod store;
#[cfg(feature = "service")]
pub mod telemetry;
#[cfg(feature = "service")]
pub mod worker;
