//! Elasto-plastic materials: stress from strain and from the history of a point. Closed forms of
//! contact mechanics.
//!
//! - [`ConstitutiveModel`] is the interface to the solver: stress update, tangent and state of a
//!   point;
//! - [`HardeningLaw`] is a uniaxial curve, one file each in [`hardening`];
//! - [`ReturnMapping`] combines a curve with elasticity;
//! - [`DeformationPlasticity`] is the model of the paper, without a memory;
//! - [`FlowPlasticity`] follows a history of loads, with isotropic and kinematic hardening;
//! - [`StreamLaw`] follows the rows of a body that passes under a load;
//! - [`Inhomogeneous`] gives one of these models a strength that varies over depth, and a residual
//!   stress of the unloaded body;
//! - [`Solid`] is the material of a body, from which a model is made;
//! - [`fatigue`]: criteria on the path of the stress at a point;
//! - [`tensile`] makes a curve of a tensile test;
//! - [`analytical`]: closed forms of Hertz, McEwen, Hill, Prandtl, Persson and others, for
//!   comparison.

pub mod analytical;
mod ball;
mod deformation;
pub mod fatigue;
mod flow;
pub mod hardening;
pub mod hardness;
mod inhomogeneous;
mod initial_stress;
mod interpolant;
mod kinematic;
mod model;
mod moduli;
mod return_mapping;
mod solid;
mod stream;
mod strength;
mod tangent;
pub mod tensile;

pub use analytical::von_mises;
pub use ball::{Ball, smallest_ball};
pub use deformation::DeformationPlasticity;
pub use flow::{BackstressTerm, FlowPlasticity, FlowState, Flowing};
pub use hardening::{HardeningLaw, Inverse};
pub use inhomogeneous::{Inhomogeneous, scaled};
pub use initial_stress::InitialStressProfile;
pub use model::{ConstitutiveModel, PerPoint, PointOrigin, PointResponse};
pub use moduli::{ElasticModuli, Moduli, ModuliReduction, OutOfPlane, ReferenceModuli};
pub use return_mapping::{ReturnMapping, body_flows, flows, stress_of_yield};
pub use solid::Solid;
pub use stream::{Deviators, Rows, StreamLaw, StreamOfLayers, TrackFrame};
pub use strength::{Depth, DepthStrength, StrengthProfile, interpolate};

/// Equivalent strain `ε_q = √(2/3 e:e)` of a deviator `[e_xx, e_yy, e_zz, γ_xy]`.
#[inline]
pub fn equivalent_strain(deviator: [f64; 4]) -> f64 {
    let [x, y, z, g] = deviator;
    (2.0 / 3.0 * (x * x + y * y + z * z + 0.5 * g * g)).sqrt()
}

/// Returns the deviator of a strain or stress.
#[inline(always)]
pub(crate) fn deviator(tensor: [f64; 4]) -> [f64; 4] {
    let [x, y, z, g] = tensor;
    let mean = (x + y + z) / 3.0;
    [x - mean, y - mean, z - mean, g]
}

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
