//! A pin in a hole of nearly its own radius, or a ball in a socket: the contact reaches far round
//! both.
//!
//! ```text
//! θ = s/R            angle of the common normal at the arc length s, the same on both bodies
//! δ0 = ΔR (1 - cos θ)   gap along that normal
//! e = cos θ          closing of the gap per unit of approach
//! ```
//! `R = √(R_1 R_2)` is the geometric mean of the radii of pin and hole, `ΔR = R_2 - R_1` the
//! clearance. Up to second order in `ΔR/R` the gap is the distance of the two circles. In a narrow
//! contact, `δ0 = s²/2 (1/R_1 - 1/R_2)` is that of Hertz's theory whatever the clearance, because
//! pairs have equal arc lengths on both bodies.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::element::StressState;
use crate::mesh::Outline;
use brinell_material::analytical::PinInHole;

/// Largest angle of a contact to each side of its middle \[degrees\].
pub const MAX_HALF_ANGLE: f64 = 80.0;

/// A pin and its hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConformingPair {
    /// Geometric mean of the two radii \[mm\].
    pub common_radius: f64,
    /// Difference of the two radii \[mm\].
    pub clearance: f64,
}

impl ConformingPair {
    /// The pair of two outlines, if they are a pin and its hole.
    pub fn of(outlines: [&Outline; 2]) -> Option<Self> {
        let [upper, lower] = outlines.map(Outline::ring);
        let (upper, lower) = (upper?, lower?);
        Some(Self {
            common_radius: upper.common_radius(),
            clearance: -(upper.radius() + lower.radius()),
        })
    }

    /// Angle of the common normal at an arc length \[rad\].
    pub fn angle(&self, arc: f64) -> f64 {
        arc / self.common_radius
    }

    /// Initial gap along the common normal at an arc length \[mm\].
    pub fn initial_gap(&self, arc: f64) -> f64 {
        // Without cancellation at small angles.
        2.0 * self.clearance * (0.5 * self.angle(arc)).sin().powi(2)
    }

    /// Returns the closing of the gap per unit of approach at an arc length.
    pub fn closing(&self, arc: f64) -> f64 {
        self.angle(arc).cos()
    }

    /// Half of the width of a contact across the approach, or its radius \[mm\].
    pub fn half_chord(&self, arc: f64) -> f64 {
        self.common_radius * self.angle(arc).sin()
    }

    /// Arc length of the largest contact that is solved \[mm\].
    pub fn largest_arc(&self) -> f64 {
        MAX_HALF_ANGLE.to_radians() * self.common_radius
    }

    /// Arc length of a contact with half such a width; that of a quarter of the circle for all
    /// wider ones \[mm\].
    pub fn arc_of_chord(&self, half_chord: f64) -> f64 {
        let sine = half_chord / self.common_radius;
        self.common_radius * if sine < 1.0 { sine.asin() } else { FRAC_PI_2 }
    }

    /// Radius that a narrow contact of the two has \[mm\].
    pub fn effective_radius(&self) -> f64 {
        self.common_radius * self.common_radius / self.clearance
    }

    /// Force under which elastic bodies touch to an arc length \[N/mm, or N\]: Hertz's, times what
    /// Persson's theory of equal materials makes of it in the plane.
    pub fn elastic_force(
        &self,
        stress_state: StressState,
        effective_modulus: f64,
        arc: f64,
    ) -> f64 {
        let angle = self.angle(arc);
        let narrow = match stress_state {
            StressState::PlaneStrain | StressState::PlaneStress => {
                0.25 * PI * self.clearance * angle * angle
            }
            StressState::Axisymmetric => {
                4.0 / 3.0 * self.clearance * self.common_radius * angle.powi(3)
            }
        };
        let ratio = 8.0 / (PI * angle * angle) / PinInHole::of_half_angle(angle).clearance_ratio();
        effective_modulus * narrow * if ratio > 0.0 { ratio } else { f64::INFINITY }
    }
}
