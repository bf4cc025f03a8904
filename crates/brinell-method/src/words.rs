//! Words that every engine and every report share: the two bodies, and the physical quantities.

use strum::{IntoStaticStr, VariantArray};

/// One of the two bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::Display, IntoStaticStr, VariantArray)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[strum(serialize_all = "snake_case")]
pub enum Side {
    /// The upper body.
    Upper,
    /// The lower body.
    Lower,
}

impl Side {
    /// Both bodies, in the order of pairs.
    pub const BOTH: [Self; 2] = [Self::Upper, Self::Lower];

    /// Returns the side of a member of a pair, 0 for the upper body.
    pub const fn of(member: usize) -> Self {
        if member == 0 { Self::Upper } else { Self::Lower }
    }

    /// Returns the place in a pair, 0 for the upper body.
    pub const fn member(self) -> usize {
        self as usize
    }
}

/// A physical quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = AnswerQuantity))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[strum(serialize_all = "snake_case")]
pub enum Quantity {
    /// A length.
    Length,
    /// An area.
    Area,
    /// A volume.
    Volume,
    /// A stress.
    Stress,
    /// A force.
    Force,
    /// A force on unit thickness.
    LineForce,
    /// A force over a length.
    Stiffness,
    /// A force on unit thickness over a length.
    LineStiffness,
    /// A force times a length; also a moment.
    Energy,
    /// The same on unit thickness.
    LineEnergy,
    /// A strain, shown in per cent.
    Strain,
    /// A part of a whole, shown in per cent.
    Ratio,
    /// A factor.
    Number,
    /// An angle \[mrad\].
    Angle,
    /// An angle \[degrees\].
    Degrees,
}
