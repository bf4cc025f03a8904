//! The solver from outside, one executable: verification against closed forms, invariants and
//! independent programs (one file for each named problem), the wire format, results, exports and
//! purity.
//!
//! A test that takes more than two seconds is `#[ignore = "full"]`: `.ci/full` runs it.

#![expect(clippy::unwrap_used, reason = "a test ends where it fails")]
#![expect(clippy::float_cmp, reason = "what is set to zero is exactly zero")]

mod answers;
mod apart;
mod approach;
mod autofrettage;
mod bodies;
mod bodies_of_revolution;
mod conforming;
mod contact_stiffness;
#[path = "../support/contacts.rs"]
mod contacts;
mod default_theory;
mod error_bars;
mod exports;
mod factor_cache;
mod fatigue;
mod flow_increments;
mod flow_references;
mod flow_theory;
mod hardness;
mod honesty;
mod indenters;
mod independent_program;
mod initial_stress;
mod invariants;
mod line_contact;
mod middle_pressure;
mod model;
mod onset_of_line_contact;
mod outcomes;
mod paper_problem;
mod plane_stress;
mod point_contact;
mod problems;
mod profiles;
mod punch_ceiling;
mod purity;
mod raceway;
mod random_jobs;
mod results;
mod rolling;
mod rolling_kinds;
#[path = "../support/rough_traces.rs"]
mod rough_traces;
mod shape_cases;
mod soundness;
mod stops;
mod strength_over_depth;
mod subsurface;
mod sweeps;
mod targets;
#[path = "../support/theory.rs"]
mod theory;
mod thick_cylinder;
mod traces;
mod trial_model;
mod units_of_messages;
mod yield_onset;
