//! The domains of the figures of a job: their quantities and ranges.
//!
//! The ranges are generous, from a nanometre to a kilometre, from jelly to far beyond diamond.
//! They keep every product of figures in a valid job from overflow, and they turn a mistaken unit
//! or exponent into a message instead of a strange answer.

use super::{Quantity, Units};

/// The quantity and the range of a dimensional figure of the wire format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Domain {
    /// A dimension of a shape, `1e-6..=1e6` mm.
    Length,
    /// A signed position, `-1e6..=1e6` mm.
    Position,
    /// A depth below the surface or the radius of a corner, `0..=1e6` mm.
    Depth,
    /// An approach, `1e-9..=1e6` mm.
    Approach,
    /// Young's modulus, `1e-3..=1e8` MPa.
    Modulus,
    /// A tangent modulus, `0..=1e8` MPa.
    TangentModulus,
    /// A yield, reference or saturation stress, `1e-6..=1e7` MPa.
    Stress,
    /// A stress of either sign, `-1e7..=1e7` MPa.
    SignedStress,
    /// A force per unit thickness, `1e-9..=1e9` N/mm.
    LineForce,
    /// A force, `1e-9..=1e9` N.
    Force,
    /// A moment of either sign, `-1e12..=1e12` N mm.
    Moment,
}

impl Domain {
    /// Returns the smallest and largest valid figure, in N–mm–MPa.
    pub const fn range(self) -> (f64, f64) {
        match self {
            Self::Length => (1e-6, 1e6),
            Self::Position => (-1e6, 1e6),
            Self::Depth => (0.0, 1e6),
            Self::Approach => (1e-9, 1e6),
            Self::Modulus => (1e-3, 1e8),
            Self::TangentModulus => (0.0, 1e8),
            Self::Stress => (1e-6, 1e7),
            Self::SignedStress => (-1e7, 1e7),
            Self::LineForce | Self::Force => (1e-9, 1e9),
            Self::Moment => (-1e12, 1e12),
        }
    }

    /// Returns the range in a system of units, without the trailing digits of the conversion.
    pub fn wire_range(self, units: Units) -> (f64, f64) {
        let (low, high) = self.range();
        let round = |value: f64| format!("{value:.5e}").parse().unwrap_or(value);
        (round(self.to_wire(units, low)), round(self.to_wire(units, high)))
    }

    /// Returns the physical quantity.
    pub const fn quantity(self) -> Quantity {
        match self {
            Self::Length | Self::Position | Self::Depth | Self::Approach => Quantity::Length,
            Self::Modulus | Self::TangentModulus | Self::Stress | Self::SignedStress => {
                Quantity::Stress
            }
            Self::LineForce => Quantity::LineForce,
            Self::Force => Quantity::Force,
            Self::Moment => Quantity::Energy,
        }
    }

    /// Returns the unit symbol of the quantity.
    pub const fn symbol(self, units: Units) -> &'static str {
        units.symbol(self.quantity())
    }

    /// Converts a figure of the wire format to N–mm–MPa.
    pub fn to_core(self, units: Units, wire: f64) -> f64 {
        units.to_core(self.quantity(), wire)
    }

    /// Converts a figure in N–mm–MPa to the wire format.
    pub fn to_wire(self, units: Units, core: f64) -> f64 {
        units.to_wire(self.quantity(), core)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Domain; 11] = [
        Domain::Length,
        Domain::Position,
        Domain::Depth,
        Domain::Approach,
        Domain::Modulus,
        Domain::TangentModulus,
        Domain::Stress,
        Domain::SignedStress,
        Domain::LineForce,
        Domain::Force,
        Domain::Moment,
    ];

    #[test]
    #[expect(clippy::float_cmp, reason = "the conversion is meant to be exact here")]
    fn round_figures_stay_round() {
        assert_eq!(Domain::Modulus.to_core(Units::Si, 210e9), 210_000.0);
        assert_eq!(Domain::LineForce.to_core(Units::Si, 612_610.6), 612.6106);
        assert_eq!(Domain::Length.to_core(Units::Si, 0.02), 20.0);
    }

    #[test]
    fn limits_are_round_in_either_system() {
        assert_eq!(Domain::Length.wire_range(Units::Si), (1e-9, 1e3));
        assert_eq!(Domain::Modulus.wire_range(Units::Si), (1e3, 1e14));
        assert_eq!(Domain::LineForce.wire_range(Units::Si), (1e-6, 1e12));
    }

    #[test]
    fn round_trips_to_one_part_in_1e15() {
        for quantity in ALL {
            for value in [1e-9, 0.1, 0.3, 7.0, 612.6106, 1e9] {
                let back = quantity.to_wire(Units::Si, quantity.to_core(Units::Si, value));
                assert!((back / value - 1.0).abs() < 1e-15, "{quantity:?} {value} {back}");
            }
        }
    }
}
