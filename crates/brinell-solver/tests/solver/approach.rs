//! How far the supports come together.
//!
//! A disc on its diametral plane, `α = P(1-ν²)/(πE) [2 ln(4R/a) - 1]`, is Johnson's for a plane
//! that is free to widen: roller support. A layer on a rigid base takes the stresses of a
//! half-plane, `α = P(1-ν²)/(πE) [2 ln(2d/a) - ν/(1-ν)]`, which neglects what the base gives back.
//! With the base the constant is `1 + 2C` instead of `-ν/(1-ν)`, where
//!
//! ```text
//! C = ∫ [L(ξ) - 1 + e^(-ξ)]/ξ dξ from 0 to ∞
//! L = (cosh 2ξ - 1)/(sinh 2ξ + 2ξ)                                       frictionless base
//! L = (2κ sinh 2ξ - 4ξ)/(2κ cosh 2ξ + 4ξ² + κ² + 1),  κ = 3 - 4ν         bonded base
//! ```
//! L being the flexibility of a layer of unit depth under `cos ξx` over that of a half-plane; the
//! rest is the integral of `(1 - e^(-ξ)) 2J_1(ξa)/(ξa)/ξ` for Hertz's pressure and `a << d`.
//!
//! K. L. Johnson, *Contact Mechanics* (1985), sections 5.6 and 5.8; I. N. Sneddon, *Fourier
//! Transforms* (1951).

use brinell_solver::analytical::{ElasticConstants, HertzLine, disc_approach, layer_approach};
use serde_json::{Value, json};

use crate::problems::{assert_approach, assert_within, cylinder, report};

const STEEL: ElasticConstants = ElasticConstants { young_modulus: 210_000.0, poisson_ratio: 0.3 };
const MODULUS: f64 = 210_000.0 / 0.91;

fn rigid_cylinder() -> Value {
    let mut body = cylinder("clamped", Value::Null);
    body["material"] = json!({"rigid": true});
    body
}

#[test]
fn a_disc_follows_johnson() {
    for force in [20.0, 60.0, 200.0, 600.0] {
        let job = json!({"analysis": "plane_strain", "upper": cylinder("roller", Value::Null),
            "lower": rigid_cylinder(), "load": {"force": force}});
        let step = &report(&job).steps[0];
        let a = HertzLine::new(force, 10.0, MODULUS).half_width();
        assert_approach(step, disc_approach(force, STEEL, 20.0, a));
    }
}

fn constant(flexibility: impl Fn(f64) -> f64) -> f64 {
    let step = 1e-3;
    let integrand = |xi: f64| (flexibility(xi) - 1.0 + (-xi).exp()) / xi;
    let sum: f64 = (0..30_000).map(|k| integrand((f64::from(k) + 0.5) * step) * step).sum();
    1.0 + 2.0 * sum
}

fn frictionless(xi: f64) -> f64 {
    ((2.0 * xi).cosh() - 1.0) / ((2.0 * xi).sinh() + 2.0 * xi)
}

fn bonded(xi: f64) -> f64 {
    let kappa = 3.0 - 4.0 * STEEL.poisson_ratio;
    let below = 2.0 * kappa * (2.0 * xi).cosh() + 4.0 * xi * xi + kappa * kappa + 1.0;
    (2.0 * kappa * (2.0 * xi).sinh() - 4.0 * xi) / below
}

#[test]
fn a_layer_on_a_rigid_base() {
    let depth = 20.0;
    for (support, exact) in [("roller", constant(frictionless)), ("clamped", constant(bonded))] {
        for force in [5.0, 20.0] {
            let mut block = cylinder(support, Value::Null);
            block["shape"] = json!({"type": "block", "width": 200.0, "depth": depth});
            let job = json!({"analysis": "plane_strain", "upper": rigid_cylinder(), "lower": block,
                "load": {"force": force}});
            let step = &report(&job).steps[0];
            let a = HertzLine::new(force, 20.0, MODULUS).half_width();
            let unit = force * (1.0 - 0.09) / (std::f64::consts::PI * 210_000.0);
            let expected = unit * (2.0 * (2.0 * depth / a).ln() + exact);
            assert_approach(step, expected);
            // The closed form without the base's reaction.
            assert_within(step.approach().unwrap(), layer_approach(force, STEEL, depth, a), 0.08);
        }
    }
}
