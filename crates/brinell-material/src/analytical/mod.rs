//! Exact and closed-form solutions, each a type or a function with its equation and its source.
//!
//! They serve twice: results report them beside the computed figures, and tests measure the solver
//! against them. Everything is `f64` in one consistent system of units (N, mm, `MPa`); forces of
//! plane problems are per unit thickness. Arguments are taken as they come: outside a formula's
//! range the answer is NaN or infinite, never a panic.
//!
//! Frame: `x` tangential, `y` normal to the contact, `z` out of the plane. Depth is counted from
//! the surface into the body, positive inwards. Stresses are tensile positive, pressures
//! compressive positive.

mod approach;
mod effective;
mod hertz_ellipse;
mod hertz_line;
mod hertz_point;
mod indentation;
mod mcewen;
mod over_depth;
mod persson;
mod power_law_cylinder;
mod punch;
mod rounded_edge;
mod stress;
mod thick_cylinder;
mod yield_onset;

pub use approach::{disc_approach, layer_approach};
pub use effective::{
    ElasticConstants, effective_modulus, effective_modulus_plane_stress, effective_radius,
};
pub use hertz_ellipse::HertzEllipse;
pub use hertz_line::HertzLine;
pub use hertz_point::HertzPoint;
pub use indentation::{PowerIndenter, circular_punch_pressure, flat_punch_pressure};
pub use over_depth::DepthLimit;
pub use persson::PinInHole;
pub use power_law_cylinder::{LoadedPowerLawCylinder, PowerLawCylinder};
pub use punch::{prandtl_mean_pressure, shear_yield_tresca, shear_yield_von_mises};
pub use rounded_edge::RoundedEdge;
pub use stress::{CylinderStress, Stress, von_mises};
pub use thick_cylinder::{LoadedCylinder, ThickCylinder};
pub use yield_onset::{YieldOnset, factor_of_onset};
