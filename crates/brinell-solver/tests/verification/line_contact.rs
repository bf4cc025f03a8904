//! Hertz's line contact and the approach of two elastic bodies.
//!
//! ```text
//! a = √(4PR/πE*),  p0 = 2P/(πa),  p = p0 √(1 - x²/a²)
//! ```
//!
//! K. L. Johnson, *Contact Mechanics* (1985), sections 4.2 and 5.6.

use brinell_solver::analytical::ElasticConstants;
use brinell_solver::analytical::{HertzLine, disc_approach};
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::problems::{FORCE_3, assert_within, report, two_cylinders};

#[test]
fn equal_cylinders_have_hertz_pressure() {
    let report = report(&two_cylinders("clamped", Value::Null, FORCE_3));
    let step = &report.steps[0];
    assert_eq!(step.status, SolveStatus::Converged);
    assert_eq!(step.history.len(), 1, "an elastic contact needs one iteration");
    let hertz = HertzLine::new(FORCE_3, 10.0, 210_000.0 / 1.82);
    assert_within(step.contact.peak_pressure, hertz.peak_pressure(), 2e-4);
    assert!((step.contact.half_width - hertz.half_width()).abs() < report.mesh.spacing);
    assert!((step.contact.force - FORCE_3).abs() <= 1e-9 * FORCE_3);
    let total: f64 = step.contact.nodes.force.iter().sum();
    assert!((total - FORCE_3).abs() <= 1e-9 * FORCE_3);

    // The whole distribution, away from the ends where one element sees the square root.
    for (x, p) in step.contact.nodes.x.iter().zip(&step.contact.nodes.pressure) {
        if x.abs() < 0.9 * hertz.half_width() {
            assert!((p - hertz.pressure(*x)).abs() < 2e-3 * hertz.peak_pressure(), "at {x}: {p}");
        }
        if x.abs() > hertz.half_width() + report.mesh.spacing {
            assert_eq!(*p, 0.0, "pressure outside the contact, at {x}");
        }
    }
}

#[test]
fn peak_pressure_stays_within_a_fiftieth_of_a_percent_over_loads() {
    for force in [50.0, 100.0, 250.0, 400.0, 900.0] {
        let report = report(&two_cylinders("clamped", Value::Null, force));
        let hertz = HertzLine::new(force, 10.0, 210_000.0 / 1.82);
        assert_within(report.steps[0].contact.peak_pressure, hertz.peak_pressure(), 2e-4);
    }
}

fn cylinder_on_block(force: f64) -> Value {
    let elastic = |young: f64| json!({"young_modulus": young, "poisson_ratio": 0.3});
    json!({
        "analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": 50.0}, "material": elastic(210_000.0)},
        "lower": {"shape": {"type": "block", "width": 200.0, "depth": 200.0}, "material": elastic(70_000.0)},
        "load": {"force": force}
    })
}

/// The NAFEMS contact benchmark: a steel cylinder on an aluminium block, a = 6.2146 mm, p0 = 3585.4 MPa.
///
/// At a/R = 0.12 a circle is no longer the parabola of Hertz's theory: the arc rises faster, which makes the
/// contact narrower and the peak higher by about (a/R)²/8 = 0.19 %. Under a sixteenth of the force that part is
/// sixteen times smaller, and so must the difference be.
#[test]
fn nafems_cylinder_on_block() {
    let benchmark = report(&cylinder_on_block(35_000.0));
    let step = &benchmark.steps[0];
    assert_within(step.contact.peak_pressure, 3585.4, 2.5e-3);
    assert_within(step.contact.half_width, 6.2146, 1e-2);
    let hertz = step.hertz.as_ref().unwrap();
    assert_within(hertz.peak_pressure, 3585.4, 2e-5);
    assert_within(hertz.half_width, 6.2146, 2e-5);

    let light = report(&cylinder_on_block(35_000.0 / 16.0));
    let step = &light.steps[0];
    assert_within(step.contact.peak_pressure, step.hertz.as_ref().unwrap().peak_pressure, 5e-4);
}

/// Approach of the centre of a disc towards its contact point, `P(1-ν²)/(πE) [2 ln(4R/a) - 1]`, for a disc that
/// is free to spread: roller support.
///
/// Johnson's disc is loaded by a force at the opposite point; here the diametral plane moves as a whole, which
/// is stiffer by a part that does not depend on the load. The *difference* between two loads is free of it.
#[test]
fn approach_grows_as_for_a_disc() {
    let elastic = ElasticConstants { young_modulus: 210_000.0, poisson_ratio: 0.3 };
    let compliance = |force: f64| {
        let step = &report(&two_cylinders("roller", Value::Null, force)).steps[0].clone();
        let a = step.hertz.as_ref().unwrap().half_width;
        (step.approach / force, 2.0 * disc_approach(force, elastic, 20.0, a) / force)
    };
    let (light, heavy) = (compliance(60.0), compliance(600.0));
    assert_within(light.0 - heavy.0, light.1 - heavy.1, 5e-3);
    // And the stiffer part is small.
    assert_within(heavy.0, heavy.1, 0.05);
}
