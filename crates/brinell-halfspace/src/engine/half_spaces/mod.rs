//! Contact in three dimensions: two half-spaces as an engine of the method.
//!
//! A [`HalfSpaceProblem`] holds the input. [`run_each`] solves it and hands over one
//! [`HalfSpaceStep`] per load.
//!
//! In all maps and fields, x runs along the shorter semi-axis of the contact, y along the longer
//! one, and z into the body. [`HalfSpaceProblem::orientation`] is the angle from the job's x to
//! this x, positive towards the job's y.

mod answer;
mod conformity;
mod design;
mod engine;
mod error;
mod errors;
mod estimate;
mod extrapolation;
mod fatigue;
mod gap;
mod given;
mod history;
mod law;
mod measure;
mod moment;
mod operators;
mod problem;
mod reference;
mod run;
mod search;
mod sizing;
mod step;
mod system;
mod tilting;
mod utilization;

pub use conformity::Conformity;
pub use error::HalfSpaceError;
pub use errors::figure_of;
pub use errors::{errors, target_error, target_figure};
pub use estimate::{HalfSpaceEstimate, estimate};
pub use gap::{HeightMap, Relief, RollerGap};
pub use measure::Row;
pub use problem::HalfSpaceProblem;
pub use reference::EllipticReference;
pub use run::{HalfSpaceRun, run_each};
pub use step::von_mises;
pub use step::{
    ColumnPoint, HalfSpaceBody, HalfSpaceField, HalfSpaceStep, LargestStrain, SurfaceMap,
};
pub use utilization::HighestUtilization;
