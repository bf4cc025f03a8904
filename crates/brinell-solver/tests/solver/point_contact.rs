//! Hertz's point contact by the axisymmetric analysis, and where it first yields.
//!
//! ```text
//! a³ = 3FR/(4E*),  p0 = 3F/(2πa²),  α = a²/R,  first yield at p0 = 1.613 σ_y, 0.481 a deep (ν = 0.3)
//! ```
//!
//! α = a²/R belongs to bodies without end. A sphere held on its diametral plane is stiffer by a
//! part of the order of a/R, and pressure and area of a real sphere differ from Hertz's by (a/R)²;
//! the loads here keep a/R small.
//!
//! H. Hertz (1882); K. L. Johnson, *Contact Mechanics* (1985), section 4.2.

use brinell_solver::analytical::{HertzPoint, YieldOnset};
use brinell_solver::report::{Name, Report};
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::problems::{assert_approach, assert_peak, assert_within, cylinder, report};

const RADIUS: f64 = 20.0;
const MODULUS: f64 = 210_000.0 / 1.82;

/// Two equal spheres whose contact radius is `ratio` times their effective radius.
fn spheres(ratio: f64) -> (HertzPoint, Report) {
    let effective = 0.5 * RADIUS;
    let peak = 2.0 * MODULUS * ratio / std::f64::consts::PI;
    let hertz = HertzPoint::from_peak_pressure(peak, effective, MODULUS);
    let body = cylinder("clamped", Value::Null);
    let job = json!({"analysis": "axisymmetric", "upper": body, "lower": body,
        "load": {"force": hertz.force()}});
    (hertz, report(&job))
}

#[test]
fn equal_spheres_have_hertz_pressure_and_approach() {
    for ratio in [0.0005, 0.001, 0.002, 0.004] {
        let (hertz, report) = spheres(ratio);
        let step = &report.steps[0];
        assert_eq!(step.status, SolveStatus::Converged);
        assert_eq!(step.history.len(), 1, "an elastic contact needs one iteration");
        assert_peak(step, hertz.peak_pressure());
        assert_approach(step, hertz.approach());
        assert!((step[Name::HalfWidth] - hertz.contact_radius()).abs() < report.mesh.spacing);
        let total: f64 = step.contact.nodes.force.iter().sum();
        assert_within(total, hertz.force(), 1e-9);
    }
}

#[test]
fn a_sphere_on_a_block_has_hertz_pressure() {
    let effective = RADIUS;
    let hertz = HertzPoint::from_peak_pressure(300.0, effective, MODULUS);
    let mut block = cylinder("clamped", Value::Null);
    block["shape"] = json!({"type": "block", "width": 80.0, "depth": 40.0});
    let job = json!({"analysis": "axisymmetric", "upper": cylinder("clamped", Value::Null),
        "lower": block,
        "load": {"force": hertz.force()}});
    let report = report(&job);
    let step = &report.steps[0];
    assert_eq!(step.status, SolveStatus::Converged);
    assert_peak(step, hertz.peak_pressure());
    // The block is no half-space.
    assert_within(step.approach().unwrap(), hertz.approach(), 2e-3);
}

/// Stresses on the axis, down to three contact radii, within 1 % of the peak pressure.
#[test]
fn stresses_on_the_axis_are_those_of_hertz() {
    let (hertz, report) = spheres(0.001);
    let (a, p0) = (hertz.contact_radius(), hertz.peak_pressure());
    let profile = report.steps[0].subsurface.as_ref().unwrap().upper.as_ref().unwrap();
    let mut compared = 0;
    for (k, &depth) in profile.depth.iter().enumerate().filter(|(_, depth)| **depth <= 3.0 * a) {
        let exact = hertz.stress_on_axis(depth, 0.3);
        for (name, got, expected) in [
            ("radial", profile.sigma_x[k], exact.sigma_x),
            ("axial", profile.sigma_y[k], exact.sigma_y),
            ("hoop", profile.sigma_z[k], exact.sigma_z),
            ("tau_max", profile.tau_max[k], exact.tau_max()),
            ("von_mises", profile.von_mises[k], exact.von_mises()),
        ] {
            let error = (got - expected).abs() / p0;
            assert!(error < 0.01, "{name} at {:.3} a: {got} instead of {expected}", depth / a);
        }
        compared += 1;
    }
    assert!(compared > 30);
    let (k, most) =
        profile.von_mises.iter().enumerate().max_by(|x, y| x.1.total_cmp(y.1)).unwrap();
    assert_within(p0 / most, 1.613, 5e-3);
    assert!((profile.depth[k] / a - 0.481).abs() < 0.05);
}

/// `{"onset": true}` for two equal spheres of this yield stress: Hertz's contact under the force
/// found, and the report of it.
fn onset(yield_stress: f64, elements: u32) -> (HertzPoint, Report) {
    let law = json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 0.0});
    let mut body = cylinder("clamped", law);
    body["shape"]["radius"] = json!(10.0);
    let job = json!({"analysis": "axisymmetric", "upper": body, "lower": body,
        "load": {"onset": true},
        "mesh": {"elements_per_half_width": elements}});
    let report = report(&job);
    assert_eq!(report.status, SolveStatus::Converged);
    (HertzPoint::new(report.steps[0][Name::Force], 5.0, MODULUS), report)
}

/// σ_y 100 MPa, so that a/R is 0.001; p0/σ_y within 0.5 %.
#[test]
fn first_yield_is_found_where_the_closed_form_has_it() {
    let exact = YieldOnset::point(0.3);
    assert_within(exact.pressure_ratio, 1.613, 5e-4);
    for (elements, tolerance) in [(20, 5e-3), (40, 5e-3)] {
        let (hertz, report) = onset(100.0, elements);
        assert_within(hertz.peak_pressure() / 100.0, 1.613, tolerance);
        let profile = report.steps[0].subsurface.as_ref().unwrap().upper.as_ref().unwrap();
        let (k, _) =
            profile.von_mises.iter().enumerate().max_by(|x, y| x.1.total_cmp(y.1)).unwrap();
        assert!((profile.depth[k] / hertz.contact_radius() - 0.481).abs() < 0.05);

        // The force goes with the third power of the pressure; Jackson and Green's fit of it is
        // good to 0.5 %.
        let fitted = YieldOnset::jackson_green_force(0.3, 100.0, 5.0, MODULUS);
        assert_within(hertz.force(), fitted, 3.0 * tolerance + 5e-3);
    }
}
