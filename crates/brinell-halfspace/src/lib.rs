//! Elasto-plastic contact of three-dimensional half-spaces, by fast Fourier transforms.
//!
//! Frame: z points into the body, z = 0 is its surface. Lengths in mm, stresses in MPa, tension
//! positive, pressures `p >= 0` compressive, u_z positive into the body. Tensors have the order xx
//! yy zz xy xz yz, with tensor shear.
//!
//! - [`SurfaceFlexibility`] is A: contact forces to displacements, for `brinell-contact`;
//! - [`HalfSpace`] is S (pressures to stresses), Sᵀ (plastic strains to displacements) and G
//!   (plastic strains to stresses);
//! - [`YieldingBody`] is a body with plastic strain: gap and trial stress for an increment, and
//!   what its [`PlasticLaw`] answers;
//! - [`EllipticContact`] is Hertz;
//! - [`Passing`] is a pressure that passes over a body, [`Fatigue`] whether the body endures it;
//! - [`track`]: contacts that roll and slide, along a [`mod@line`] or over a [`raceway`];
//! - [`engine`]: half-spaces and tracks as engines of `brinell-method`.
//!
//! All formulas with their sources: `docs/theory_three_dimensions.md`.

mod body;
mod eigenstrain_stress;
mod elasticity;
pub mod engine;
mod fatigue;
mod grid;
mod half_space;
mod hertz;
mod images;
pub mod line;
mod offsets;
mod passing;
mod pressure_stress;
pub mod raceway;
mod sliding;
mod stop;
mod surface;
mod tensors;
pub mod track;
mod traction_stress;
mod transform;
mod waves;

pub use body::{PlasticLaw, YieldingBody};
pub use elasticity::{Elasticity, ElasticityError};
pub use fatigue::{Fatigue, Largest, Utilization};
pub use grid::{GridError, Layers, SurfaceGrid};
pub use half_space::{HalfSpace, HalfSpaceWork};
pub use hertz::EllipticContact;
pub use passing::{Level, Passing};
pub use sliding::{SlidingContact, SlidingLimit};
pub use stop::{Stop, Stopped};
pub use surface::SurfaceFlexibility;
pub use tensors::{COMPONENTS, DEVIATOR_COMPONENTS, TensorField, from_isometric, isometric};
