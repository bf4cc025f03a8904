//! What has to converge to 1e-6: laws, shapes, couplings and analyses.
//!
//! `cargo run --release --example outcomes` prints all combinations, those that do not converge among them.

use brinell::solve::{SolveStatus, StepSolution};
use serde_json::Value;

use crate::contacts::{ANALYSES, job, laws, pairs, surfaces};
use crate::problems::solve;

#[track_caller]
fn converged(job: &Value) -> StepSolution {
    let step = solve(job).steps.remove(0);
    assert_eq!(step.status, SolveStatus::Converged, "{:e}: {job}", step.equilibrium_residual);
    step
}

/// Equal cylinders.
#[track_caller]
fn cylinders(analysis: &str, coupling: &str, law: &Value, ratio: f64) -> StepSolution {
    let [cylinder, ..] = surfaces();
    converged(&job(analysis, coupling, law, [&cylinder, &cylinder], ratio))
}

/// The paper's couplings. In plane stress they are slow: strong coupling takes 165 iterations with straight hardening and
/// does not get there in 500 with a table or Ludwik's curve.
#[test]
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

/// Not in plane stress with perfect plasticity: there the equations lose ellipticity, the strain wants to gather in a
/// line, and whether it comes to rest depends on the mesh.
#[test]
fn the_default_coupling_converges_within_25_iterations_up_to_five_yield_stresses() {
    for (name, law) in &laws() {
        for ratio in [3.0, 4.0, 5.0] {
            for analysis in ANALYSES {
                if (analysis, *name) != ("plane_stress", "perfectly plastic") {
                    let taken = cylinders(analysis, "accelerated", law, ratio).history.len();
                    assert!(taken <= 25, "{analysis} {name} {ratio}: {taken} iterations");
                }
            }
        }
    }
}

#[test]
fn every_pair_of_shapes_converges_up_to_five_yield_stresses() {
    let (law, surfaces) = (&laws()[0].1, surfaces());
    assert_eq!(pairs(&surfaces).count(), 12);
    for pair in pairs(&surfaces) {
        for analysis in ANALYSES {
            for ratio in [3.0, 5.0] {
                let step = converged(&job(analysis, "accelerated", law, pair, ratio));
                let context = format!("{analysis} {ratio}: {} on {}", pair[0].name, pair[1].name);
                assert!(step.history.len() <= 25 && !step.reaches_edge, "{context}");
            }
        }
    }
}
