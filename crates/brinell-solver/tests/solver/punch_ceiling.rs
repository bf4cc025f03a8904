//! A deeply plastic contact: the mean pressure approaches Prandtl's `(2 + π) σ_y/√3 = 2.968 σ_y`
//! from below.
//!
//! L. Prandtl (1920); R. Hill, *The Mathematical Theory of Plasticity* (1950), chapter IX. It is
//! reached only as the elastic part of the strain vanishes beside the plastic one; a contact that
//! stays small beside its bodies is still some 10 % below.

use brinell_solver::analytical::{prandtl_mean_pressure, shear_yield_von_mises};
use brinell_solver::report::Name;
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::problems::{cylinder, report};

const YIELD: f64 = 200.0;

#[test]
fn the_mean_pressure_stays_below_prandtls() {
    let law = json!({"law": "bilinear", "yield_stress": YIELD, "tangent_modulus": 0.0});
    let mut block = cylinder("clamped", law);
    block["shape"] = json!({"type": "block", "width": 120.0, "depth": 60.0});
    let mut punch = cylinder("clamped", Value::Null);
    punch["material"] = json!({"rigid": true});
    let job = json!({"analysis": "plane_strain", "upper": punch, "lower": block,
        "load": {"forces": [300.0, 600.0, 1200.0, 2000.0]},
        "mesh": {"elements_per_half_width": 16},
        "solver": {"max_iterations": 2000}});
    let report = report(&job);
    let ceiling = prandtl_mean_pressure(shear_yield_von_mises(YIELD));
    let mean: Vec<f64> =
        report.steps.iter().map(|step| step[Name::MeanPressure] / ceiling).collect();
    for (step, mean) in report.steps.iter().zip(&mean) {
        assert_eq!(step.status, SolveStatus::Converged);
        assert!(*mean < 1.0, "{mean} of the ceiling");
    }
    assert!(mean.windows(2).all(|pair| pair[1] > pair[0]), "{mean:?}");
    assert!(mean[3] > 0.87, "{mean:?}");
}
