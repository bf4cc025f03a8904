//! The two unit systems of the wire format.

use serde::Serialize;
use strum::{IntoStaticStr, VariantArray};

use super::{Named, Quantity};

/// The units of lengths, forces and stresses in a job and its result.
///
/// The core works in [`Units::MmNMpa`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, IntoStaticStr, VariantArray)]
pub enum Units {
    /// Millimetre, newton, megapascal. Line forces are N/mm.
    #[default]
    #[serde(rename = "mm_N_MPa")]
    #[strum(serialize = "mm_N_MPa")]
    MmNMpa,
    /// Metre, newton, pascal. Line forces are N/m.
    #[serde(rename = "SI")]
    #[strum(serialize = "SI")]
    Si,
}

impl Named for Units {}

impl Units {
    /// Returns the symbol of a unit; empty of figures without one.
    pub const fn symbol(self, quantity: Quantity) -> &'static str {
        match (quantity, self) {
            (Quantity::Length, Self::MmNMpa) => "mm",
            (Quantity::Length, Self::Si) => "m",
            (Quantity::Area, Self::MmNMpa) => "mm²",
            (Quantity::Area, Self::Si) => "m²",
            (Quantity::Volume, Self::MmNMpa) => "mm³",
            (Quantity::Volume, Self::Si) => "m³",
            (Quantity::Stress, Self::MmNMpa) => "MPa",
            (Quantity::Stress, Self::Si) => "Pa",
            (Quantity::Force | Quantity::LineEnergy, _) => "N",
            (Quantity::LineForce | Quantity::Stiffness, Self::MmNMpa) => "N/mm",
            (Quantity::LineForce | Quantity::Stiffness, Self::Si) => "N/m",
            (Quantity::LineStiffness, Self::MmNMpa) => "N/mm²",
            (Quantity::LineStiffness, Self::Si) => "N/m²",
            (Quantity::Energy, Self::MmNMpa) => "N mm",
            (Quantity::Energy, Self::Si) => "N m",
            (Quantity::Angle, _) => "mrad",
            (Quantity::Degrees, _) => "°",
            (Quantity::Strain | Quantity::Ratio | Quantity::Number, _) => "",
        }
    }

    /// Converts a figure of the wire format to N–mm–MPa.
    pub fn to_core(self, quantity: Quantity, wire: f64) -> f64 {
        let (multiplier, divisor) = self.factors(quantity);
        wire * multiplier / divisor
    }

    /// Converts a figure in N–mm–MPa to the wire format.
    pub fn to_wire(self, quantity: Quantity, core: f64) -> f64 {
        let (multiplier, divisor) = self.factors(quantity);
        core * divisor / multiplier
    }

    /// Returns the factors of `core = wire * multiplier / divisor`. One of them is 1, the other a
    /// power of ten that is exact in binary, so that each conversion rounds once: 210e9 Pa is
    /// exactly 210000 MPa.
    const fn factors(self, quantity: Quantity) -> (f64, f64) {
        match (self, quantity) {
            (Self::MmNMpa, _)
            | (
                Self::Si,
                Quantity::Force
                | Quantity::LineEnergy
                | Quantity::Strain
                | Quantity::Ratio
                | Quantity::Number
                | Quantity::Angle
                | Quantity::Degrees,
            ) => (1.0, 1.0),
            (Self::Si, Quantity::Length | Quantity::Energy) => (1e3, 1.0),
            (Self::Si, Quantity::Area) => (1e6, 1.0),
            (Self::Si, Quantity::Volume) => (1e9, 1.0),
            (Self::Si, Quantity::LineForce | Quantity::Stiffness) => (1.0, 1e3),
            (Self::Si, Quantity::Stress | Quantity::LineStiffness) => (1.0, 1e6),
        }
    }
}
