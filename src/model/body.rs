//! One of the two bodies.

use serde::Serialize;

use super::{Material, Shape};

/// One body of the contact: its shape, what it is made of and how its far boundary is held.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Undeformed outline.
    pub shape: Shape,
    /// Stress–strain law, or rigid.
    pub material: Material,
    /// How the far boundary is held. Without meaning for a rigid body.
    pub support: Support,
}

/// How the far boundary of a body is held (diametral plane of a cylinder, base of a block).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Support {
    /// Both displacement components are held.
    #[default]
    Clamped,
    /// The normal component is held, the tangential one is free.
    Roller,
}
