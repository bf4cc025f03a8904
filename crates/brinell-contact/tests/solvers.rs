//! What holds for conjugate gradients: conditions met by an independent check, the answer of the
//! direct solver, warm or cold, stopped when asked.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]
#![expect(clippy::float_cmp, reason = "what is handed through has to be the same to the last bit")]

use std::ops::ControlFlow;

use brinell_contact::{
    ActiveSetSolver, ConjugateGradientSolver, ContactError, ContactLoad, ContactProblem,
    ContactSolution, ContactSolver, ContactStatus, Flexibility, KktReport, kkt, never,
};
use dense_cholesky::SymmetricMatrix;
use proptest::prelude::*;

const TOLERANCE: f64 = 1e-9;
const SOLVER: ConjugateGradientSolver = ConjugateGradientSolver::new(TOLERANCE);

/// `f(i, j) = 1/(1 + |i - j|)` on a line, positive definite as a convex falling function of the
/// distance, and some more on its diagonal.
fn line(n: usize, extra: f64) -> SymmetricMatrix {
    let entry =
        |i: usize, j: usize| 1.0 / (1.0 + i.abs_diff(j) as f64) + if i == j { extra } else { 0.0 };
    SymmetricMatrix::from_fn(n, entry)
}

fn solve(solver: &dyn ContactSolver, problem: &ContactProblem<'_>) -> ContactSolution {
    solver.solve(problem, None, &mut never).unwrap()
}

fn judged(problem: &ContactProblem<'_>, solution: &ContactSolution) -> KktReport {
    kkt::check(problem, &solution.force, solution.approach)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_condition_holds_whatever_the_gaps(
        gaps in prop::collection::vec(-1.0..1.0_f64, 2..40),
        force in 1e-3..1e2_f64,
        extra in 0.0..2.0_f64,
        inclined in prop::option::of(prop::collection::vec(0.1..1.0_f64, 40)),
    ) {
        let flexibility = line(gaps.len(), extra);
        let problem = ContactProblem {
        flexibility: &flexibility,
        initial_gap: &gaps,
        closing: &inclined.unwrap_or_else(|| vec![1.0; 40])[..gaps.len()],
        load: ContactLoad::Force(force),
    };
        let direct = solve(&ActiveSetSolver, &problem);
        let solution = solve(&SOLVER, &problem);
        prop_assert_eq!(solution.status, ContactStatus::Converged);
        prop_assert!(judged(&problem, &solution).passes(TOLERANCE));
        prop_assert!((solution.total_force / force - 1.0).abs() < 1e-12);

        // The same contact, with its approach given.
        let load = ContactLoad::Approach(solution.approach);
        let approached = ContactProblem { load, ..problem };
        let other = solve(&SOLVER, &approached);
        prop_assert_eq!(other.status, ContactStatus::Converged);
        prop_assert!((other.total_force / force - 1.0).abs() < 1e-6);
        let scale = direct.force.iter().copied().fold(0.0, f64::max);
        for (a, b) in direct.force.iter().zip(&solution.force) {
            prop_assert!((a - b).abs() < 1e-6 * scale);
        }
    }
}

#[test]
fn a_warm_start_takes_fewer_applications_to_the_same_answer() {
    let flexibility = line(60, 0.1);
    let gaps: Vec<f64> = (0..60).map(|k| 0.01 * (f64::from(k) - 29.3).powi(2)).collect();
    let problem = ContactProblem {
        flexibility: &flexibility,
        initial_gap: &gaps,
        closing: &vec![1.0; gaps.len()],
        load: ContactLoad::Force(3.0),
    };
    let cold = solve(&SOLVER, &problem);
    let warm = SOLVER.solve(&problem, Some(&cold), &mut never).unwrap();
    assert_eq!(warm.status, ContactStatus::Converged);
    assert!(
        2 * warm.applications < cold.applications,
        "{} of {}",
        warm.applications,
        cold.applications
    );
    assert!((warm.approach / cold.approach - 1.0).abs() < 1e-8);
}

#[test]
fn bodies_apart_carry_no_force() {
    let flexibility = line(3, 0.0);
    for (load, approach) in [
        (ContactLoad::Force(0.0), 0.5),
        (ContactLoad::Approach(0.4), 0.4),
        (ContactLoad::Approach(0.5), 0.5),
    ] {
        let problem = ContactProblem {
            flexibility: &flexibility,
            initial_gap: &[0.7, 0.5, 0.9],
            closing: &[1.0; 3],
            load,
        };
        let solution = solve(&SOLVER, &problem);
        assert_eq!(solution.status, ContactStatus::Converged);
        assert_eq!((solution.total_force, solution.approach), (0.0, approach));
        assert_eq!(solution.force, [0.0; 3]);
        assert_eq!(solution.gap[1], 0.5 - approach);
    }
}

/// Springs of 2 mm/N, whose preconditioner rounds.
struct Springs;

impl Flexibility for Springs {
    fn len(&self) -> usize {
        2
    }

    fn apply(&self, force: &[f64], displacement: &mut [f64]) {
        displacement.iter_mut().zip(force).for_each(|(u, r)| *u = 2.0 * r);
    }

    fn precondition(&self, displacement: &[f64], force: &mut [f64]) {
        force.iter_mut().zip(displacement).for_each(|(r, u)| *r = 0.1 * u);
    }
}

/// A gap so much larger than the displacement that its rounding is above the tolerance.
#[test]
fn one_pair_far_below_the_datum_is_no_fault_of_the_flexibility() {
    for k in 0..100 {
        let problem = ContactProblem {
            flexibility: &Springs,
            initial_gap: &[0.3 + 0.01 * f64::from(k), 5.0],
            closing: &[1.0; 2],
            load: ContactLoad::Force(1e-8),
        };
        assert_eq!(solve(&SOLVER, &problem).force, [1e-8, 0.0]);
    }
}

#[test]
fn a_flat_contact_has_its_closed_form() {
    // Two equal cells share the load: u = (1 + ½) P/2.
    let flexibility = line(2, 0.0);
    let problem = ContactProblem {
        flexibility: &flexibility,
        initial_gap: &[0.0; 2],
        closing: &[1.0; 2],
        load: ContactLoad::Force(4.0),
    };
    let solution = solve(&SOLVER, &problem);
    assert!((solution.force[0] - 2.0).abs() < 1e-9 && (solution.force[1] - 2.0).abs() < 1e-9);
    assert!((solution.approach - 3.0).abs() < 1e-9);
}

#[test]
fn a_hook_stops_a_solve_and_the_answer_says_so() {
    let flexibility = line(60, 0.1);
    let gaps: Vec<f64> = (0..60).map(|k| 0.01 * (f64::from(k) - 29.3).powi(2)).collect();
    let problem = ContactProblem {
        flexibility: &flexibility,
        initial_gap: &gaps,
        closing: &vec![1.0; gaps.len()],
        load: ContactLoad::Force(3.0),
    };
    let mut asked = 0;
    let mut hook = || {
        asked += 1;
        if asked == 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let solution = SOLVER.solve(&problem, None, &mut hook).unwrap();
    assert_eq!(asked, 2);
    assert_eq!(solution.status, ContactStatus::Stopped);
    assert!((solution.total_force - 3.0).abs() < 1e-12);
    assert!(!judged(&problem, &solution).passes(TOLERANCE));
}

#[test]
fn data_that_are_no_contact_are_refused() {
    let flexibility = line(2, 0.0);
    let refused = |initial_gap: &[f64], load| {
        let problem =
            ContactProblem { flexibility: &flexibility, initial_gap, closing: &[1.0; 2], load };
        ConjugateGradientSolver::new(1e-8).solve(&problem, None, &mut never).unwrap_err()
    };
    assert_eq!(
        refused(&[0.0], ContactLoad::Force(1.0)),
        ContactError::DimensionMismatch { expected: 2, found: 1 }
    );
    assert_eq!(refused(&[0.0; 2], ContactLoad::Force(-1.0)), ContactError::NegativeForce(-1.0));
    assert_eq!(refused(&[0.0; 2], ContactLoad::Force(f64::NAN)), ContactError::NotFinite("force"));
    assert_eq!(
        refused(&[0.0, f64::NAN], ContactLoad::Force(1.0)),
        ContactError::NotFinite("initial gap")
    );

    let indefinite = SymmetricMatrix::from_fn(2, |i, j| if i == j { 1.0 } else { 2.0 });
    let problem = ContactProblem {
        flexibility: &indefinite,
        initial_gap: &[0.0; 2],
        closing: &[1.0; 2],
        load: ContactLoad::Force(1.0),
    };
    let uneven = ContactSolution { force: vec![0.9, 0.1], ..ContactSolution::default() };
    let result = SOLVER.solve(&problem, Some(&uneven), &mut never);
    assert!(matches!(result, Err(ContactError::NoEnergy { .. })), "{result:?}");
}

#[test]
fn the_check_finds_each_fault() {
    let flexibility = line(3, 0.0);
    assert_eq!(flexibility.dense().map(<[f64]>::len), Some(9));
    let problem = ContactProblem {
        flexibility: &flexibility,
        initial_gap: &[0.0, 0.0, 5.0],
        closing: &[1.0; 3],
        load: ContactLoad::Force(2.0),
    };
    let sound = kkt::check(&problem, &[1.0, 1.0, 0.0], 1.5);
    assert!(sound.worst() < 1e-15, "{sound:?}");
    assert!(kkt::check(&problem, &[1.0, 1.0, 0.0], 1.6).penetration > 0.05);
    assert!(kkt::check(&problem, &[1.0, 1.0, 0.0], 1.4).complementarity > 0.05);
    assert!(kkt::check(&problem, &[2.1, -0.1, 0.0], 1.5).tension > 0.04);
    assert!(kkt::check(&problem, &[1.1, 1.1, 0.0], 1.65).equilibrium > 0.05);
    assert!(!kkt::check(&problem, &[f64::NAN, 1.0, 0.0], 1.5).passes(1.0));
    assert!(!kkt::check(&problem, &[1.0], 1.5).passes(1.0));
}
