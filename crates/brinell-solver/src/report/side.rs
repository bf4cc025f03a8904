//! The two bodies of a contact.

use serde::{Deserialize, Serialize};

/// One of the two bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// The upper body.
    Upper,
    /// The lower body.
    Lower,
}

impl Side {
    /// Returns the side of a body, 0 for the upper one.
    pub(super) const fn of(body: usize) -> Self {
        if body == 0 { Self::Upper } else { Self::Lower }
    }
}
