//! Undeformed outlines. Each shape is one file: its dimensions with their table, and what holds between them.
//!
//! Every shape is described in its own frame: the contact starts at the origin, `x` is tangential, and
//! heights are counted along the outward normal. Both bodies use the same convention, so swapping `upper` and
//! `lower` mirrors the problem.

mod block;
mod cylinder;
mod groove;
mod hole;
mod power;
mod profile;
mod punch;
mod wedge;

pub use block::Block;
pub use cylinder::Cylinder;
pub use groove::Groove;
pub use hole::{Hole, OuterEdge};
pub use power::{Ellipse, Parabola, Power};
pub use profile::{Interpolation, Profile};
pub use punch::Punch;
pub use wedge::{Cone, Wedge};

use super::fields::tagged;

tagged! {
    /// The undeformed outline of a body.
    pub enum Shape by "type" {
        Cylinder, Block, Groove, Hole, Profile, Wedge, Cone, Punch, Parabola, Ellipse, Power
    }
}
