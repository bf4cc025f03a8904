//! What every hardening law says of itself.

use std::fmt::Debug;
use std::sync::Arc;

/// A uniaxial curve `q(ε_p)` of stress \[MPa\] against plastic strain, rising and concave.
pub trait HardeningLaw: Debug + Send + Sync {
    /// Stress up to which the response is elastic \[MPa\]; 0 where plastic strain begins at once.
    fn yield_stress(&self) -> f64;

    /// q at a plastic strain `>= 0` \[MPa\].
    fn stress(&self, plastic_strain: f64) -> f64;

    /// `dq/dε_p` \[MPa\]; may be infinite at zero.
    fn slope(&self, plastic_strain: f64) -> f64;

    /// Both at once, for laws that share work between them.
    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        (self.stress(plastic_strain), self.slope(plastic_strain))
    }

    /// `ε_p(q)` for a law that is given that way round; `None` for all others.
    fn inverse(&self, _stress: f64) -> Option<Inverse> {
        None
    }

    /// The corners `[ε_p, q]` of a piecewise linear law, the first at zero plastic strain; beyond the last it has the slope
    /// there. `None` for a curved law.
    fn polyline(&self) -> Option<Vec<[f64; 2]>> {
        None
    }

    /// Stress above which a point counts as yielded \[MPa\]: the yield stress or, for a curve without an elastic limit,
    /// what convention says.
    fn nominal_yield_stress(&self) -> f64 {
        self.yield_stress()
    }

    /// A stress at which the material flows noticeably \[MPa\]; contacts are sized by it before anything is solved.
    fn flow_stress(&self) -> f64 {
        1.2 * self.yield_stress()
    }

    /// Whether a point in this state counts as yielded: where plastic strain has begun or, for a curve without an elastic
    /// limit, above the nominal yield stress.
    fn has_yielded(&self, stress: f64, plastic_strain: f64) -> bool {
        plastic_strain > 0.0 && (self.yield_stress() > 0.0 || stress > self.nominal_yield_stress())
    }
}

/// Plastic strain at a stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inverse {
    /// ε_p.
    pub plastic_strain: f64,
    /// `dε_p/dq` \[1/MPa\].
    pub slope: f64,
}

/// A law with its parameters as a job gives them.
pub(super) trait Curve {
    /// The curve beside a Young's modulus \[MPa\].
    fn law(&self, young_modulus: f64) -> Arc<dyn HardeningLaw>;
}
