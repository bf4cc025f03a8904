//! The validated job: the input of the solver, in types that cannot hold an invalid value.
//!
//! A [`Job`] is built in one of two ways. [`Job::from_json`] parses the wire format and reports
//! *every* faulty field with its JSON pointer. Or a user of the library fills the public fields
//! with the number types of [`number`] and with [`Deformable`], [`Groove`], [`Profile`],
//! [`TablePoints`] and [`Sweep`], whose constructors check their invariants; [`Job::validate`]
//! then checks this job against the limits of the wire format.
//!
//! # Units
//! The core works in one consistent system, N–mm–MPa. [`Units`] are the units of the wire format:
//! parsing converts the figures to the core's units, and the results convert back.

pub mod analysis;
pub mod body;
pub mod contact_job;
pub mod domain;
pub mod error;
pub mod fatigue;
pub mod fields;
mod figure;
mod find;
pub mod hardening;
pub mod hardness;
pub mod initial_stress;
pub mod load;
mod material;
pub mod name;
mod named;
mod no_data;
mod npy;
pub mod number;
pub mod over_depth;
mod reader;
mod revolution;
pub mod rolling;
#[cfg(test)]
mod roundtrip;
pub mod schema;
pub mod settings;
pub mod shape;
#[cfg(test)]
mod strategy;
mod surface;
pub mod tags;
pub mod target;
pub mod tensile;
mod theory;
mod three_dimensions;
pub mod units;
mod varied;

pub use analysis::Analysis;
pub use body::{Body, FarSupport};
pub use brinell_method::words::{Quantity, Side};
pub use contact_job::Job;
pub use domain::Domain;
pub use error::{FaultCode, FieldError, JobError};
pub use fatigue::{BENDING_OF_HARDNESS, FatigueLimits, GivenLimits};
pub use fields::{Field, FieldTable};
pub use figure::{BarKind, Name, table_of_names};
pub use find::{Find, Tolerance, Wanted};
pub use hardening::{
    BackstressTerm, Bilinear, Hardening, Ludwik, RambergOsgood, Swift, Table, TablePoints, Voce,
};
pub use hardness::{HardnessTest, TestScale};
pub use initial_stress::InitialStress;
pub use load::{History, HistoryLoad, Load, Sweep};
pub use material::{Deformable, Elastic, Material};
pub use named::Named;
pub use no_data::NoData;
pub use number::{NonNegativeF64, PoissonRatio, PositiveF64};
pub(crate) use over_depth::YIELD_OVER_HARDNESS;
pub use over_depth::{CaseCurve, HardenedCase, HardnessProfile, HardnessScale, OverDepth};
pub use rolling::{HardeningRule, Rolling, Until};
pub use settings::{
    ContactMethod, Coupling, MeshSettings, Method, OutputSettings, SolverSettings, Theory,
};
pub use shape::{
    Block, Cone, Curved, Cylinder, Ellipse, Flat, Groove, Hole, Interpolation, Parabola, Power,
    Profile, Punch, Roller, RollerProfile, Shape, Sphere, Wedge,
};
pub use surface::{Detrend, Surface};
pub use target::{Target, TargetFigure, label_of, measure_of};
pub use units::Units;
