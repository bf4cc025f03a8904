//! The problem of Jiang and Shang: two equal cylinders pressed together past yield, by every
//! coupling.
//!
//! R 20 mm, E 210000, ν 0.3, σ_y 500, E_t 10500 MPa, plane strain, diametral planes clamped.
//! References are mesh-converged figures of an independent prototype; p0 is the elastic peak
//! pressure of the same force.

use brinell_solver::report::Name;
use brinell_solver::solver::{IterationRecord, SolveStatus};
use serde_json::json;

use crate::problems::{
    FORCE_3, FORCE_4, FORCE_5, assert_approach, assert_peak, assert_within, bilinear, paper,
    report, solve, two_cylinders,
};

const COUPLINGS: [&str; 4] = ["accelerated", "strong", "weak", "secant_stiffness"];

#[test]
fn peak_pressure_approach_and_plastic_strain_at_three_and_four_yield_stresses() {
    for (force, peak, approach, strain) in
        [(FORCE_3, 1182.6, 0.017_919, 2.88e-3), (FORCE_4, 1338.2, 0.032_604, 5.74e-3)]
    {
        let report = report(&paper(force, "accelerated"));
        let step = &report.steps[0];
        assert_eq!(step.status, SolveStatus::Converged);
        assert_peak(step, peak);
        assert_approach(step, approach);
        assert_within(step[Name::MaxPlasticStrain], strain, 0.01);
    }
}

#[test]
fn the_default_mesh_holds_the_approach_to_a_twentieth_of_a_percent() {
    let at = |elements: u32| {
        let mut job = paper(FORCE_3, "accelerated");
        job["mesh"] = json!({"elements_per_half_width": elements});
        solve(&job).steps[0].figures.approach
    };
    assert_within(at(20), at(60), 5e-4);
}

#[test]
fn roller_supports_agree_with_quadratic_elements_and_newton() {
    let report = report(&two_cylinders("roller", bilinear(), FORCE_3));
    assert_peak(&report.steps[0], 1183.8);
    assert_approach(&report.steps[0], 0.018_481);
}

#[test]
#[ignore = "full"]
fn all_couplings_reach_the_same_answer() {
    for force in [FORCE_3, FORCE_4] {
        let reference = &solve(&paper(force, "accelerated")).steps[0];
        for coupling in COUPLINGS {
            let step = &solve(&paper(force, coupling)).steps[0];
            assert_eq!(step.status, SolveStatus::Converged, "{coupling}");
            assert!(step.checks.residual <= 1.5e-6, "{coupling}: {}", step.checks.residual);
            assert_within(step.figures.peak_pressure, reference.figures.peak_pressure, 1e-4);
            assert_within(step.figures.approach, reference.figures.approach, 1e-4);
        }
    }
}

/// Iterations and initial-stress updates until the displacement change falls below a tolerance.
fn counts(history: &[IterationRecord], tolerance: f64) -> (usize, usize, usize) {
    let end =
        history.iter().position(|record| record.displacement_change <= tolerance).unwrap() + 1;
    let sum = |count: fn(&IterationRecord) -> usize| history[..end].iter().map(count).sum();
    (end, sum(|record| record.initial_stress_updates), sum(|record| record.factorizations))
}

/// At most 20 % more iterations than the prototype needed; the accelerated coupling, which starts
/// from a coarser answer and its tangent moduli, at most that much more than half of the
/// prototype's 5, 10, 6, 14 and 29.
#[test]
fn iteration_counts_stay_near_the_prototypes() {
    let with = |force: f64, coupling: &str, tolerance: f64| {
        let mut job = paper(force, coupling);
        job["solver"]["tolerance"] = json!(tolerance);
        counts(&solve(&job).steps[0].history, tolerance)
    };
    // p0/σ_y, tolerance, strong, accelerated, secant factorizations, weak alternations and updates
    let table = [
        (FORCE_3, 1e-2, 8, 1, 2, Some((8, 26))),
        (FORCE_3, 1e-5, 24, 5, 18, Some((11, 94))),
        (FORCE_4, 1e-2, 11, 1, 5, Some((12, 46))),
        (FORCE_4, 1e-5, 42, 7, 26, Some((19, 209))),
        (FORCE_4, 1e-8, 127, 15, 62, None),
    ];
    let most = |count: usize| count * 6 / 5;
    for (force, tolerance, strong, accelerated, secant, weak) in table {
        let found = with(force, "strong", tolerance).0;
        assert!(found <= most(strong), "strong at {tolerance:e}: {found} against {strong}");
        let found = with(force, "accelerated", tolerance).0;
        assert!(
            found <= most(accelerated),
            "accelerated at {tolerance:e}: {found} against {accelerated}"
        );
        let found = with(force, "secant_stiffness", tolerance).2;
        assert!(found <= most(secant), "secant at {tolerance:e}: {found} against {secant}");
        if let Some((alternations, updates)) = weak {
            let found = with(force, "weak", tolerance);
            assert!(
                found.0 <= most(alternations) && found.1 <= most(updates),
                "weak at {tolerance:e}: {found:?}"
            );
        }
    }
}

/// Plasticity that is not converged well enough sends the alternation round in a circle, on some
/// meshes and not on others.
#[test]
fn weak_coupling_converges_on_every_mesh() {
    for elements in [5, 8, 10, 12, 15] {
        for force in [FORCE_3, FORCE_4, FORCE_5] {
            let mut job = paper(force, "weak");
            job["mesh"]["elements_per_half_width"] = json!(elements);
            let step = &solve(&job).steps[0];
            assert_eq!(step.status, SolveStatus::Converged, "{elements} elements, force {force}");
            assert!(
                step.history.len() <= 55,
                "{elements} elements, force {force}: {}",
                step.history.len()
            );
        }
    }
}

#[test]
fn weak_coupling_converges_up_to_five_yield_stresses() {
    let reference = &solve(&paper(FORCE_5, "accelerated")).steps[0];
    for force in [FORCE_3, FORCE_4, 0.5 * (FORCE_4 + FORCE_5), FORCE_5] {
        let step = &solve(&paper(force, "weak")).steps[0];
        assert_eq!(step.status, SolveStatus::Converged, "force {force}");
        if force == FORCE_5 {
            assert_within(step.figures.peak_pressure, reference.figures.peak_pressure, 1e-4);
            assert_within(step.figures.approach, reference.figures.approach, 1e-4);
        }
    }
}
