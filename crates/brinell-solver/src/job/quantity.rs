//! The physical quantities of a job: their units, conversions and ranges.
//!
//! The ranges are generous, from a nanometre to a kilometre, from jelly to far beyond diamond.
//! They keep every product of figures in a valid job from overflow, and they turn a mistaken unit
//! or exponent into a message instead of a strange answer.

use super::Units;

/// A dimensional figure of the wire format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
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

impl Quantity {
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

    /// Returns the unit symbol of this quantity.
    pub const fn symbol(self, units: Units) -> &'static str {
        match (self, units) {
            (Self::Length | Self::Position | Self::Depth | Self::Approach, Units::MmNMpa) => "mm",
            (Self::Length | Self::Position | Self::Depth | Self::Approach, Units::Si) => "m",
            (
                Self::Modulus | Self::TangentModulus | Self::Stress | Self::SignedStress,
                Units::MmNMpa,
            ) => "MPa",
            (
                Self::Modulus | Self::TangentModulus | Self::Stress | Self::SignedStress,
                Units::Si,
            ) => "Pa",
            (Self::LineForce, Units::MmNMpa) => "N/mm",
            (Self::LineForce, Units::Si) => "N/m",
            (Self::Force, _) => "N",
            (Self::Moment, Units::MmNMpa) => "N mm",
            (Self::Moment, Units::Si) => "N m",
        }
    }

    /// Converts a figure of the wire format to N–mm–MPa.
    pub fn to_core(self, units: Units, wire: f64) -> f64 {
        let (multiplier, divisor) = self.factors(units);
        wire * multiplier / divisor
    }

    /// Converts a figure in N–mm–MPa to the wire format.
    pub fn to_wire(self, units: Units, core: f64) -> f64 {
        let (multiplier, divisor) = self.factors(units);
        core * divisor / multiplier
    }

    /// Returns the factors of `core = wire * multiplier / divisor`. One of them is 1, the other a
    /// power of ten that is exact in binary, so that each conversion rounds once: 210e9 Pa is
    /// exactly 210000 MPa.
    const fn factors(self, units: Units) -> (f64, f64) {
        match (units, self) {
            (Units::MmNMpa, _) | (Units::Si, Self::Force) => (1.0, 1.0),
            (
                Units::Si,
                Self::Length | Self::Position | Self::Depth | Self::Approach | Self::Moment,
            ) => (1e3, 1.0),
            (
                Units::Si,
                Self::Modulus | Self::TangentModulus | Self::Stress | Self::SignedStress,
            ) => (1.0, 1e6),
            (Units::Si, Self::LineForce) => (1.0, 1e3),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Quantity; 11] = [
        Quantity::Length,
        Quantity::Position,
        Quantity::Depth,
        Quantity::Approach,
        Quantity::Modulus,
        Quantity::TangentModulus,
        Quantity::Stress,
        Quantity::SignedStress,
        Quantity::LineForce,
        Quantity::Force,
        Quantity::Moment,
    ];

    #[test]
    fn agrees_with_the_factors_of_units() {
        for units in [Units::MmNMpa, Units::Si] {
            let near = |quantity: Quantity, factor: f64| {
                assert!(
                    (quantity.to_core(units, 1.0) / factor - 1.0).abs() < 1e-15,
                    "{quantity:?}"
                );
            };
            near(Quantity::Length, units.length());
            near(Quantity::Stress, units.stress());
            near(Quantity::LineForce, units.line_force());
            near(Quantity::Force, 1.0);
            near(Quantity::Moment, units.length());
        }
    }

    #[test]
    #[expect(clippy::float_cmp, reason = "the conversion is meant to be exact here")]
    fn round_figures_stay_round() {
        assert_eq!(Quantity::Modulus.to_core(Units::Si, 210e9), 210_000.0);
        assert_eq!(Quantity::LineForce.to_core(Units::Si, 612_610.6), 612.6106);
        assert_eq!(Quantity::Length.to_core(Units::Si, 0.02), 20.0);
    }

    #[test]
    fn limits_are_round_in_either_system() {
        assert_eq!(Quantity::Length.wire_range(Units::Si), (1e-9, 1e3));
        assert_eq!(Quantity::Modulus.wire_range(Units::Si), (1e3, 1e14));
        assert_eq!(Quantity::LineForce.wire_range(Units::Si), (1e-6, 1e12));
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
