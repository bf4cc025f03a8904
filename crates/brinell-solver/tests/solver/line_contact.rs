//! Hertz's line contact and the approach of two elastic bodies.
//!
//! ```text
//! a = √(4PR/πE*),  p0 = 2P/(πa),  p = p0 √(1 - x²/a²)
//! ```
//!
//! K. L. Johnson, *Contact Mechanics* (1985), sections 4.2 and 5.6.

use brinell_solver::analytical::ElasticConstants;
use brinell_solver::analytical::{HertzLine, disc_approach};
use brinell_solver::report::Name;
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::problems::{FORCE_3, assert_peak, assert_width, assert_within, report, two_cylinders};

#[test]
fn equal_cylinders_have_hertz_pressure() {
    let report = report(&two_cylinders("clamped", Value::Null, FORCE_3));
    let step = &report.steps[0];
    assert_eq!(step.status, SolveStatus::Converged);
    assert_eq!(step.history.len(), 1, "an elastic contact needs one iteration");
    let hertz = HertzLine::new(FORCE_3, 10.0, 210_000.0 / 1.82);
    assert_peak(step, hertz.peak_pressure());
    assert!((step[Name::HalfWidth] - hertz.half_width()).abs() < report.mesh.spacing);
    assert!((step[Name::Force] - FORCE_3).abs() <= 1e-9 * FORCE_3);
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
fn peak_pressure_is_that_of_hertz_over_loads() {
    for force in [50.0, 100.0, 250.0, 400.0, 900.0] {
        let report = report(&two_cylinders("clamped", Value::Null, force));
        let hertz = HertzLine::new(force, 10.0, 210_000.0 / 1.82);
        assert_peak(&report.steps[0], hertz.peak_pressure());
    }
}

fn cylinder_on_block(force: f64) -> Value {
    let elastic = |young: f64| json!({"young_modulus": young, "poisson_ratio": 0.3});
    json!({
        "analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": 50.0}, "material": elastic(210_000.0)},
        "lower": {"shape": {"type": "block", "width": 200.0, "depth": 200.0},
            "material": elastic(70_000.0)},
        "load": {"force": force}
    })
}

/// The NAFEMS contact benchmark: a steel cylinder on an aluminium block, a = 6.2146 mm, p0 =
/// 3585.4 MPa.
///
/// At a/R = 0.12 a circle is no longer the parabola of Hertz's theory: the arc rises faster, which
/// makes the peak higher by about (a/R)²/8 = 0.19 %, and the contact narrower by 3/16 (a/R)² = 0.29 %: the
/// pressure under a gap of x²/2R + x⁴/8R³ carries πE*a²/4R [1 + 3/8 (a/R)²]. Under a sixteenth of the
/// force that part is sixteen times smaller, and so must the difference be.
#[test]
fn nafems_cylinder_on_block() {
    let benchmark = report(&cylinder_on_block(35_000.0));
    let step = &benchmark.steps[0];
    let of_arc = (6.2146_f64 / 50.0).powi(2);
    assert_peak(step, 3585.4 * (1.0 + of_arc / 8.0));
    assert_width(step, 6.2146 * (1.0 - of_arc * 3.0 / 16.0));
    assert_within(step.elastic(Name::PeakPressure).unwrap(), 3585.4, 2e-5);
    assert_within(step.elastic(Name::HalfWidth).unwrap(), 6.2146, 2e-5);

    let light = report(&cylinder_on_block(35_000.0 / 16.0));
    let step = &light.steps[0];
    assert_peak(step, step.elastic(Name::PeakPressure).unwrap());
}

/// Approach of the centre of a disc towards its contact point, `P(1-ν²)/(πE) [2 ln(4R/a) - 1]`,
/// for a disc that is free to spread: roller support.
///
/// Johnson's disc is loaded by a force at the opposite point; here the diametral plane moves as a
/// whole, which is stiffer by a part that does not depend on the load. The *difference* between
/// two loads is free of it.
#[test]
fn approach_grows_as_for_a_disc() {
    let elastic = ElasticConstants { young_modulus: 210_000.0, poisson_ratio: 0.3 };
    let compliance = |force: f64| {
        let step = &report(&two_cylinders("roller", Value::Null, force)).steps[0].clone();
        let a = step.elastic(Name::HalfWidth).unwrap();
        (step.approach().unwrap() / force, 2.0 * disc_approach(force, elastic, 20.0, a) / force)
    };
    let (light, heavy) = (compliance(60.0), compliance(600.0));
    assert_within(light.0 - heavy.0, light.1 - heavy.1, 5e-3);
    // And the stiffer part is small.
    assert_within(heavy.0, heavy.1, 0.05);
}

/// A rigid cylinder of radius R on a layer that is much thinner than the contact is wide, held at
/// its base: strained across alone, it has the pressure `M (a² - x²) / 2Rd` with `M = E (1-ν) /
/// ((1+ν) (1-2ν))` and carries `2 M a³ / 3Rd`.
///
/// K. L. Johnson, *Contact Mechanics* (1985), section 5.8.
#[test]
fn a_thin_layer_is_compressed_as_by_itself() {
    let depth = 0.01;
    let elastic = json!({"young_modulus": 2000.0, "poisson_ratio": 0.2});
    let job = json!({"analysis": "plane_strain", "load": {"approach": 2e-4},
        "upper": {"shape": {"type": "cylinder", "radius": 100.0}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 20.0, "depth": depth},
            "material": elastic}});
    let step = &report(&job).steps[0];
    assert_eq!(step.status, SolveStatus::Converged);
    let half_width = (2.0_f64 * 100.0 * 2e-4).sqrt();
    let modulus = 2000.0 * 0.8 / (1.2 * 0.6);
    assert_within(step[Name::HalfWidth], half_width, 0.05);
    assert_within(step[Name::PeakPressure], modulus * 2e-4 / depth, 0.01);
    assert_within(step[Name::Force], 2.0 * modulus * half_width.powi(3) / (300.0 * depth), 0.05);
}

/// Layers of any thickness under a contact of the same force: the thinner, the smaller the
/// contact, without a jump where columns take the place of rings.
#[test]
fn layers_of_any_thickness_are_meshed() {
    for elements in [4, 7, 14] {
        let mut last = f64::INFINITY;
        for k in 0..12 {
            let depth = 20.0 * 0.5_f64.powi(k);
            let material = json!({"young_modulus": 70_000.0, "poisson_ratio": 0.3});
            let job = json!({"analysis": "plane_strain", "load": {"force": 3500.0},
                "upper": {"shape": {"type": "cylinder", "radius": 50.0},
                    "material": {"rigid": true}},
                "lower": {"shape": {"type": "block", "width": 60.0, "depth": depth},
                    "material": material},
                "mesh": {"elements_per_half_width": elements}, "output": {"subsurface": false}});
            let step = &report(&job).steps[0];
            assert_eq!(step.status, SolveStatus::Converged, "{depth}");
            assert!(
                step[Name::HalfWidth] < 1.01 * last,
                "{depth}: {} after {last}",
                step[Name::HalfWidth]
            );
            last = step[Name::HalfWidth];
        }
    }
}
