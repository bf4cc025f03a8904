//! What has to converge to 1e-6: laws, shapes, couplings and analyses.
//!
//! `cargo run --release -p brinell-tools --bin outcomes` prints all combinations, those that do
//! not converge among them.

use brinell_solver::solver::{SolveStatus, StepSolution};
use serde_json::{Value, json};

use crate::contacts::{ANALYSES, job, laws, pairs, surfaces};
use crate::problems::solve;

#[track_caller]
fn converged(job: &Value) -> StepSolution {
    let step = solve(job).steps.remove(0);
    assert_eq!(step.status, SolveStatus::Converged, "{:e}: {job}", step.checks.residual);
    step
}

/// Equal cylinders.
#[track_caller]
fn cylinders(analysis: &str, coupling: &str, law: &Value, ratio: f64) -> StepSolution {
    let [cylinder, ..] = surfaces();
    converged(&job(analysis, coupling, law, [&cylinder, &cylinder], ratio))
}

/// The paper's couplings. In plane stress they are slow: strong coupling takes 165 iterations with
/// straight hardening and does not get there in 500 with a table or Ludwik's curve.
#[test]
#[ignore = "full"]
fn every_coupling_converges_at_three_yield_stresses() {
    for coupling in ["strong", "weak", "secant_stiffness"] {
        for (_, law) in &laws() {
            cylinders("plane_strain", coupling, law, 3.0);
            cylinders("axisymmetric", coupling, law, 3.0);
        }
        for (_, law) in [&laws()[0], &laws()[2]] {
            cylinders("plane_stress", coupling, law, 3.0);
        }
    }
}

/// In plane stress with perfect plasticity the equations lose ellipticity, and the strain wants to
/// gather in a line: there it takes longer.
#[test]
#[ignore = "full"]
fn the_default_coupling_converges_within_25_iterations_up_to_five_yield_stresses() {
    for (name, law) in &laws() {
        for ratio in [3.0, 4.0, 5.0] {
            for analysis in ANALYSES {
                let most = if (analysis, *name) == ("plane_stress", "perfectly plastic") {
                    250
                } else {
                    25
                };
                let taken = cylinders(analysis, "accelerated", law, ratio).history.len();
                assert!(taken <= most, "{analysis} {name} {ratio}: {taken} iterations");
            }
        }
    }
}

/// Loads up and down by large steps, little hardening: moduli taken from the state of another load
/// may be far too soft.
#[test]
#[ignore = "full"]
fn no_step_of_a_sweep_is_lost() {
    let [cylinder, ..] = surfaces();
    let law = json!({"law": "bilinear", "yield_stress": 500.0, "tangent_modulus": 500.0});
    let mut places = (1..).map(|k| (0.618_034 * f64::from(k)).fract());
    for _ in 0..90 {
        let mut sweep = job("plane_stress", "accelerated", &law, [&cylinder, &cylinder], 1.0);
        let forces: Vec<f64> =
            places.by_ref().take(4).map(|t| 40.0 * f64::powf(17.5, t)).collect();
        sweep["load"] = json!({"forces": forces});
        for (step, force) in solve(&sweep).steps.iter().zip(&forces) {
            assert_eq!(step.status, SolveStatus::Converged, "{force} of {forces:?}");
        }
    }
}

#[test]
#[ignore = "full"]
fn every_pair_of_shapes_converges_up_to_five_yield_stresses() {
    let (law, surfaces) = (&laws()[0].1, surfaces());
    assert_eq!(pairs(&surfaces).count(), 12);
    for pair in pairs(&surfaces) {
        for analysis in ANALYSES {
            for ratio in [3.0, 5.0] {
                let step = converged(&job(analysis, "accelerated", law, pair, ratio));
                let context = format!("{analysis} {ratio}: {} on {}", pair[0].name, pair[1].name);
                assert!(step.history.len() <= 25 && !step.checks.reaches_edge, "{context}");
            }
        }
    }
}
