//! The engines and the method, under one name.
//!
//! Meshed bodies are an engine of `brinell-fem`, half-spaces and tracks are engines of
//! `brinell-halfspace`, and `brinell-method` drives all of them.

pub use brinell_fem::engine::*;
pub use brinell_halfspace::engine::{half_spaces, rolling};
pub(crate) use brinell_method as method;
pub use brinell_method::figures::{BodyFigures, Figure, FigureSet, Figures, Values};
pub use brinell_method::increments::{Increments, LastIncrement};
pub use brinell_method::observer::{
    Held, IncrementNumber, Interrupt, IterationRecord, Observer, SolveStatus, Unobserved,
};
pub use brinell_method::phases::{Phase, PhaseTimes};
pub(crate) use brinell_method::slope::{SLOPE_ERROR, SLOPE_ERROR_IN_PLANE_STRESS};
pub use brinell_method::steps::{
    Checks, Energy, IncrementRecord, Path, Search, Step, StepReceiver,
};
pub use brinell_method::{Limit, Unreachable, UnreachableReason};
