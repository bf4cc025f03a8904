//! Balls that conform to their seats, beside axisymmetric finite elements of both bodies.

use brinell_solver::job::Job;
use brinell_solver::report::{self, Name, StepReport};
use serde_json::{Value, json};

use super::*;

fn step(job: &Value) -> StepReport {
    let report = report::run(&Job::from_value(job).unwrap(), &mut Unobserved).unwrap();
    assert_eq!(report.status, SolveStatus::Converged);
    report.steps.into_iter().next().unwrap()
}

/// A ball of 20 mm in a socket of 22 mm, under Hertz's force of an angle.
#[test]
fn a_ball_in_its_socket_is_that_of_finite_elements() {
    let steel = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3});
    let (ball, socket) = (20.0_f64, 22.0_f64);
    for degrees in [5.0_f64, 10.0, 20.0] {
        let size = (ball * socket).sqrt() * degrees.to_radians();
        let curvature = 1.0 / ball - 1.0 / socket;
        let force = 4.0 / 3.0 * 105_000.0 / 0.91 * size.powi(3) * curvature;
        let round = step(&json!({"analysis": "axisymmetric",
            "upper": {"shape": {"type": "cylinder", "radius": ball}, "material": steel},
            "lower": {"shape": {"type": "hole", "radius": socket, "outer_radius": 800},
                "material": steel},
            "load": {"force": force}, "mesh": {"elements_per_half_width": 16}}));
        let space = step(&json!({"analysis": "three_dimensional",
            "upper": {"shape": {"type": "sphere", "radius": ball}, "material": steel},
            "lower": {"shape": {"type": "curved", "radius_x": -socket, "radius_y": -socket},
                "material": steel},
            "load": {"force": force}, "mesh": {"elements_per_half_width": 12}}));
        let off = space[Name::PeakPressure] / round[Name::PeakPressure] - 1.0;
        println!("{degrees}°: {off}, {}", space[Name::SemiAxisA] / round[Name::HalfWidth] - 1.0);
        near(space[Name::PeakPressure], round[Name::PeakPressure], 2e-2, "peak");
        near(space[Name::SemiAxisA], round[Name::HalfWidth], 2e-2, "half-width");
        near(space[Name::Force], force, 1e-9, "force");
        // Along the normals the pressures sum to 1 + θ²/5 of the force: 1.024 at 20°.
        let is_told = space.validity.iter().any(|note| note.code == "inclined_pressure");
        assert_eq!(is_told, degrees > 15.0, "{degrees}°");
    }
}
