//! Limits of first yield and of shakedown over friction.

use crate::SlidingContact;

use super::problem::RollingProblem;
use brinell_material::Solid;

/// Frictions of the limits.
const FRICTIONS: [f64; 10] = [0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5];

/// Peak pressures by Hertz up to which both bodies bear a friction \[MPa\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionLimit {
    /// Traction over pressure.
    pub friction: f64,
    /// Up to which nothing yields.
    pub elastic: f64,
    /// Up to which bodies with kinematic hardening without bound shake down.
    pub kinematic: f64,
}

impl RollingProblem {
    /// The limits over friction, of both bodies the lower, with strength and initial stress at the
    /// depths of this contact; empty where no body has a yield point.
    pub fn limits_over_friction(&self) -> Vec<FrictionLimit> {
        let [along, across] = self.semi_axes();
        let of_body = |material: &Solid, yield_stress: f64| {
            let contact = SlidingContact {
                along,
                across: (!self.is_line()).then_some(across),
                poisson: material.elastic().poisson_ratio,
            };
            let strength = material.strength();
            let initial = material.initial_stress();
            let over_depth = |depth: f64| {
                yield_stress * strength.map_or(1.0, |strength| strength.factor(depth))
            };
            contact.limits(&FRICTIONS, over_depth, |depth| initial.at(depth))
        };
        let bodies = self.with_yield_point().map(|(material, stress)| of_body(material, stress));
        let mut limits: Vec<FrictionLimit> = Vec::new();
        for of_body in bodies {
            let found = FRICTIONS.iter().zip(of_body).map(|(friction, limit)| FrictionLimit {
                friction: *friction,
                elastic: limit.elastic,
                kinematic: limit.kinematic,
            });
            if limits.is_empty() {
                limits.extend(found);
                continue;
            }
            for (least, found) in limits.iter_mut().zip(found) {
                least.elastic = least.elastic.min(found.elastic);
                least.kinematic = least.kinematic.min(found.kinematic);
            }
        }
        limits
    }

    /// The least yield stress in shear of both bodies, where strength does not vary \[MPa\].
    pub fn shear_yield_stress(&self) -> Option<f64> {
        let stresses = self.with_yield_point().map(|(_, stress)| stress / 3f64.sqrt());
        stresses.min_by(f64::total_cmp)
    }

    /// Bodies whose law has a yield point, with their yield stress \[MPa\].
    fn with_yield_point(&self) -> impl Iterator<Item = (&Solid, f64)> {
        self.yielding().filter_map(|(_, material)| {
            let stress = material.hardening_law()?.yield_stress();
            (stress > 0.0).then_some((material, stress))
        })
    }
}
