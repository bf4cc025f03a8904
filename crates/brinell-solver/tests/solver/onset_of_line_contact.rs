//! First yield of a line contact as `{"load": {"onset": true}}` finds it: p0/σ_y = 1.794 for ν =
//! 0.3.
//!
//! In a disc the force that arrives at the other end of the diameter adds a uniform tension σ_x =
//! P/(πR), a/2R of the peak pressure of two equal cylinders seen with R the disc's own radius
//! (Michell 1900), which brings yield forward. With σ_y 35 MPa a/R is 0.0005 and the tension 0.03
//! % of p0; at 350 MPa it is 0.27 %, and belongs into the reference.

use brinell_solver::analytical::{HertzLine, Stress};
use brinell_solver::report::Name;
use brinell_solver::solver::SolveStatus;
use serde_json::json;

use crate::problems::{assert_within, cylinder, report};

const RADIUS: f64 = 10.0;
const MODULUS: f64 = 210_000.0 / 1.82;

/// Hertz's contact under the force at which two steel cylinders of this yield stress are found to
/// yield.
fn onset(yield_stress: f64) -> HertzLine {
    let law = json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 0.0});
    let mut body = cylinder("roller", law);
    body["shape"]["radius"] = json!(RADIUS);
    let job =
        json!({"analysis": "plane_strain", "upper": body, "lower": body, "load": {"onset": true}});
    let report = report(&job);
    assert_eq!(report.status, SolveStatus::Converged);
    HertzLine::new(report.steps[0][Name::Force], 0.5 * RADIUS, MODULUS)
}

/// Highest von Mises stress on the axis of a disc, half-plane and tension together.
fn highest_in_a_disc(hertz: &HertzLine) -> f64 {
    let tension = hertz.force() / (std::f64::consts::PI * RADIUS);
    let depths = (0..2000).map(|k| 1e-3 * f64::from(k) * hertz.half_width());
    let stress = |depth: f64| {
        let plane = hertz.stress_on_axis(depth, 0.3);
        Stress {
            sigma_x: plane.sigma_x + tension,
            sigma_z: plane.sigma_z + 0.3 * tension,
            ..plane
        }
    };
    depths.map(|depth| stress(depth).von_mises()).fold(0.0, f64::max)
}

#[test]
fn small_contacts_yield_as_half_planes_do() {
    assert_within(onset(35.0).peak_pressure() / 35.0, 1.794, 5e-3);
}

/// Case 4 of the closed forms: σ_y 350 MPa.
#[test]
fn larger_contacts_yield_as_discs_do() {
    let hertz = onset(350.0);
    assert_within(highest_in_a_disc(&hertz), 350.0, 5e-3);
    // Against the half-plane, that tension included.
    assert_within(hertz.peak_pressure() / 350.0, 1.794, 8e-3);
    assert_within(hertz.force(), 53.65, 1.6e-2);
}
