//! The validated job: what is asked of the solver, in types that cannot hold a wrong value.
//!
//! A [`Job`] is built in one of two ways: [`Job::from_json`] parses the wire format and reports *every* field
//! at fault with its JSON pointer, or a library user fills the public fields with the number types of
//! [`number`], each of which checks its range when it is made.
//!
//! # Units
//! The core works in one consistent system, N–mm–MPa. [`Units`] says how the wire figures are written;
//! parsing converts them, and the results convert back.

pub mod body;
pub mod error;
pub mod job;
pub mod material;
pub mod number;
pub mod settings;
pub mod shape;
pub mod units;

mod stub;

pub use body::{Body, Support};
pub use error::{FieldError, JobError};
pub use job::{Analysis, Job, Load};
pub use material::{Deformable, Elastic, Hardening, Material};
pub use number::{NonNegativeF64, PoissonRatio, PositiveF64};
pub use settings::{ContactMethod, Coupling, MeshSettings, OutputSettings, SolverSettings};
pub use shape::Shape;
pub use units::Units;
