//! Both direct solvers against the contact conditions, each other, and Hertz's pressure.

use std::f64::consts::PI;

use brinell_contact::{
    ActiveSet, ActiveSetSolver, ContactError, ContactLoad, ContactProblem, ContactSolution,
    ContactSolver, SimplexSolver, kkt, never,
};
use dense_cholesky::SymmetricMatrix;
use proptest::prelude::*;

/// Data that a [`ContactProblem`] borrows.
#[derive(Debug, Clone)]
struct Case {
    flexibility: SymmetricMatrix,
    initial_gap: Vec<f64>,
    closing: Vec<f64>,
    load: ContactLoad,
}

impl Case {
    fn problem(&self) -> ContactProblem<'_> {
        ContactProblem {
            flexibility: &self.flexibility,
            initial_gap: &self.initial_gap,
            closing: &self.closing,
            load: self.load,
        }
    }

    /// Solves by both methods, judges both, compares them; returns simplex and active set.
    fn solve(&self) -> (ContactSolution, ContactSolution) {
        let simplex = self.judged(&SimplexSolver, None);
        let active = self.judged(&ActiveSetSolver, None);
        assert_same(&simplex, &active, 1e-10);
        (simplex, active)
    }

    fn judged(&self, solver: &dyn ContactSolver, warm: Option<&ActiveSet>) -> ContactSolution {
        let start = warm
            .map(|set| ContactSolution { active_set: set.clone(), ..ContactSolution::default() });
        let solution = match solver.solve(&self.problem(), start.as_ref(), &mut never) {
            Ok(solution) => solution,
            Err(error) => panic!("{error}: {self:?}"),
        };
        let report = kkt::check(&self.problem(), &solution.force, solution.approach);
        assert!(report.passes(1e-11), "{report:?}: {self:?}");
        assert!(solution.gap.iter().all(|&gap| gap >= 0.0));
        assert!(solution.active_set.iter().all(|k| solution.gap[k] == 0.0));
        assert_eq!(
            solution.active_set,
            ActiveSet::from_fn(self.initial_gap.len(), |&k| solution.force[k] > 0.0)
        );
        solution
    }
}

/// Forces, gaps and approach agree relative to their largest values.
fn assert_same(left: &ContactSolution, right: &ContactSolution, tolerance: f64) {
    let largest = |values: &[f64]| values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let difference = |a: &[f64], b: &[f64]| {
        assert_eq!(a.len(), b.len());
        a.iter().zip(b).fold(0.0, |m: f64, (p, q)| m.max((p - q).abs()))
    };
    let force = difference(&left.force, &right.force);
    let gap = difference(&left.gap, &right.gap);
    let lengths = largest(&left.gap).max(left.approach.abs());
    assert!(force <= tolerance * largest(&left.force), "forces differ by {force:e}");
    assert!(gap <= tolerance * lengths, "gaps differ by {gap:e}");
    assert!((left.approach - right.approach).abs() <= tolerance * lengths);
}

/// The `SplitMix64` generator: enough randomness for test data, the same on every run.
struct Random(u64);

impl Random {
    /// Uniform in `0..1`.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// An element of `0..n`.
    fn below(&mut self, n: usize) -> usize {
        let place = self.unit() * n as f64;
        (0..n).rev().find(|&k| k as f64 <= place).unwrap_or(0)
    }
}

/// `B Bᵀ / n + ridge`, with entries of B in -1..1: no structure that would favour either method.
fn random_flexibility(n: usize, ridge: f64, random: &mut Random) -> SymmetricMatrix {
    let b: Vec<Vec<f64>> =
        (0..n).map(|_| (0..n).map(|_| 2.0 * random.unit() - 1.0).collect()).collect();
    SymmetricMatrix::from_fn(n, |i, j| {
        let dot: f64 = b[i].iter().zip(&b[j]).map(|(p, q)| p * q).sum();
        dot / n as f64 + if i == j { ridge } else { 0.0 }
    })
}

/// Makes pairs i and n-1-i interchangeable, the symmetry of a full model.
fn centrosymmetric(a: &SymmetricMatrix) -> SymmetricMatrix {
    let last = a.len() - 1;
    SymmetricMatrix::from_fn(a.len(), |i, j| 0.5 * (a[(i, j)] + a[(last - i, last - j)]))
}

fn random_case(random: &mut Random, kind: usize) -> Case {
    let n = 1 + random.below(30);
    let ridge = 10_f64.powf(-4.0 * random.unit());
    let mut flexibility = random_flexibility(n, ridge, random);
    let mut initial_gap: Vec<f64> = match kind {
        0 => (0..n).map(|_| random.unit()).collect(),
        1 => (0..n).map(|_| 2.0 * random.unit() - 1.2).collect(),
        2 => (0..n).map(|_| (4.0 * random.unit()).floor() - 2.0).collect(),
        _ => vec![0.25; n],
    };
    // Normals along the approach, or up to 84 degrees off.
    let inclined = random.unit() < 0.5;
    let mut closing: Vec<f64> =
        (0..n).map(|_| if inclined { 1.0 - 0.9 * random.unit() } else { 1.0 }).collect();
    if random.unit() < 0.4 {
        flexibility = centrosymmetric(&flexibility);
        for k in 0..n / 2 {
            initial_gap[n - 1 - k] = initial_gap[k];
            closing[n - 1 - k] = closing[k];
        }
    }
    Case {
        flexibility,
        initial_gap,
        closing,
        load: ContactLoad::Force(10_f64.powf(4.0 * random.unit() - 2.0)),
    }
}

#[test]
fn thousand_random_problems_by_both_solvers() {
    let mut random = Random(1);
    let mut handed_over = 0;
    for index in 0..1000 {
        let mut case = random_case(&mut random, index % 4);
        let (by_force, active) = case.solve();
        let is_flat = case.closing.iter().all(|closing| (closing - 1.0).abs() < f64::EPSILON);
        handed_over += usize::from(is_flat && active.pivots > by_force.pivots);

        case.load = ContactLoad::Approach(by_force.approach);
        let (by_approach, _) = case.solve();
        assert_same(&by_force, &by_approach, 1e-9);
        assert!((by_approach.total_force / by_force.total_force - 1.0).abs() < 1e-9);

        let warm: ActiveSet =
            (0..case.initial_gap.len() + 3).filter(|_| random.unit() < 0.5).collect();
        assert_same(&by_force, &case.judged(&ActiveSetSolver, Some(&warm)), 1e-9);
    }
    assert!((1..=20).contains(&handed_over), "the active set ran in a circle {handed_over} times");
}

proptest! {
    #[test]
    fn any_gaps_any_load(
        seed in any::<u64>(),
        initial_gap in prop::collection::vec(-1.0..1.0_f64, 1..20),
        force in 1e-3..1e3_f64,
        warm in prop::collection::vec(0_usize..25, 0..20),
    ) {
        let flexibility = random_flexibility(initial_gap.len(), 0.01, &mut Random(seed));
        let closing = vec![1.0; initial_gap.len()];
        let mut case = Case { flexibility, initial_gap, closing, load: ContactLoad::Force(force) };
        let (simplex, _) = case.solve();
        prop_assert!((simplex.total_force / force - 1.0).abs() < 1e-12);
        let from_warm = case.judged(&ActiveSetSolver, Some(&warm.into_iter().collect()));
        assert_same(&simplex, &from_warm, 1e-10);

        case.initial_gap.iter_mut().for_each(|gap| *gap += 100.0);
        let (farther, _) = case.solve();
        let expected = ContactSolution { approach: simplex.approach + 100.0, ..simplex };
        assert_same(&expected, &farther, 1e-9);
    }
}

/// Flexibility of two half-planes in plane strain: pair j's force spread over its element of width
/// h, seen from the middle of element i. `u(x) = -2 p / (π E*) ∫ ln|x - s| ds + const`; a half
/// model adds the mirrored force.
///
/// # Reference
/// K. L. Johnson, *Contact Mechanics* (1985), ch. 2.
fn half_planes(x: &[f64], h: f64, modulus: f64, mirrored: bool) -> SymmetricMatrix {
    let primitive = |t: f64| t * t.abs().ln() - t;
    let integral = |d: f64| primitive(d + 0.5 * h) - primitive(d - 0.5 * h);
    SymmetricMatrix::from_fn(x.len(), |i, j| {
        let image = if mirrored { integral(x[i] + x[j]) } else { 0.0 };
        10.0 / modulus - 2.0 / (PI * modulus * h) * (integral(x[i] - x[j]) + image)
    })
}

/// Two cylinders of effective radius 10 mm, `E* = 115384.6 MPa`, n elements over `width` Hertz
/// half-widths.
fn cylinders(n: usize, width: f64, mirrored: bool) -> (Case, Vec<f64>, f64) {
    let (radius, modulus, force) = (10.0, 210_000.0 / 1.82, 612.6106);
    let half_width = (4.0 * force * radius / (PI * modulus)).sqrt();
    let h =
        if mirrored { width * half_width / n as f64 } else { 2.0 * width * half_width / n as f64 };
    let start = if mirrored { 0.0 } else { -width * half_width };
    let x: Vec<f64> = (0..n).map(|k| start + (k as f64 + 0.5) * h).collect();
    let case = Case {
        flexibility: half_planes(&x, h, modulus, mirrored),
        initial_gap: x.iter().map(|x| x * x / (2.0 * radius)).collect(),
        closing: vec![1.0; n],
        load: ContactLoad::Force(if mirrored { 0.5 * force } else { force }),
    };
    (case, x.iter().map(|x| x / half_width).collect(), 2.0 * force / (PI * half_width) * h)
}

#[test]
fn half_planes_give_the_pressure_of_hertz() {
    let mut errors = Vec::new();
    for n in [32, 64, 128] {
        let (case, position, peak) = cylinders(n, 1.6, true);
        let (solution, _) = case.solve();
        let error = solution
            .force
            .iter()
            .zip(&position)
            .filter(|(_, x)| **x < 0.9)
            .map(|(force, x)| (force / peak - (1.0 - x * x).sqrt()).abs())
            .fold(0.0, f64::max);
        errors.push(error);
    }
    assert!(errors[0] < 2e-4 && errors[1] < 4e-5 && errors[2] < 1e-5, "{errors:?}");
}

#[test]
fn pivots_are_the_pairs_in_contact_plus_one() {
    // (pairs in all, half model, pairs in contact, active-set steps from nothing)
    for (n, mirrored, in_contact, steps) in [
        (33, true, 21, 6),
        (33, false, 21, 6),
        (34, false, 22, 5),
        (60, true, 38, 7),
        (120, true, 75, 9),
        (120, false, 76, 7),
    ] {
        let (simplex, active) = cylinders(n, 1.6, mirrored).0.solve();
        assert_eq!(simplex.active_set.len(), in_contact, "n = {n}, mirrored = {mirrored}");
        assert_eq!(simplex.pivots, in_contact + 1, "n = {n}, mirrored = {mirrored}");
        assert_eq!(active.pivots, steps, "n = {n}, mirrored = {mirrored}");
    }
}

#[test]
fn a_warm_start_saves_steps_and_changes_nothing() {
    let (mut case, position, _) = cylinders(120, 1.6, true);
    let (_, cold) = case.solve();
    let again = case.judged(&ActiveSetSolver, Some(&cold.active_set));
    assert_eq!((again.pivots, &again.force), (1, &cold.force));
    // Plastic flow flattens the middle by 2 % of the approach: the contact widens a little.
    for (gap, x) in case.initial_gap.iter_mut().zip(&position) {
        *gap += 0.02 * cold.approach * (-4.0 * x * x).exp();
    }
    let (simplex, from_nothing) = case.solve();
    let warm = case.judged(&ActiveSetSolver, Some(&cold.active_set));
    assert_ne!(warm.active_set, cold.active_set);
    assert!(warm.pivots <= 4 && warm.pivots < from_nothing.pivots, "{} steps", warm.pivots);
    assert_same(&simplex, &warm, 1e-10);
}

#[test]
fn bodies_that_do_not_reach_each_other_carry_nothing() {
    let (mut case, ..) = cylinders(30, 1.6, false);
    case.initial_gap.iter_mut().for_each(|gap| *gap -= 1.0);
    let nearest = case.initial_gap.iter().copied().fold(f64::INFINITY, f64::min);
    for approach in [nearest - 3.0, nearest] {
        case.load = ContactLoad::Approach(approach);
        let (simplex, _) = case.solve();
        assert_eq!((simplex.total_force, simplex.approach), (0.0, approach));
        assert!(simplex.active_set.is_empty());
    }
    case.load = ContactLoad::Force(0.0);
    assert_eq!((case.solve().0.approach, case.solve().0.total_force), (nearest, 0.0));
}

/// Rough surfaces: the contact is scattered over islands, but pairs still close one by one.
#[test]
fn three_hundred_pairs_in_scattered_contact() {
    let mut random = Random(7);
    let n = 300;
    let (mut case, ..) = cylinders(n, 1.6, false);
    let smooth = case.solve().0.approach;
    case.initial_gap.iter_mut().for_each(|gap| *gap += 0.02 * smooth * random.unit());
    let (simplex, active) = case.solve();
    assert_eq!((simplex.active_set.len(), simplex.pivots, active.pivots), (49, 50, 8));
}

/// A smooth flexibility with condition numbers up to 1e13, as of a very fine mesh: the path opens
/// pairs again, the active set mostly hands over, and both end on the same set.
#[test]
fn ill_conditioned_flexibility() {
    let n = 60;
    for ridge in [1e-4, 1e-8, 1e-12] {
        for load in [ContactLoad::Force(0.5), ContactLoad::Approach(0.1)] {
            let case = Case {
                flexibility: SymmetricMatrix::from_fn(n, |i, j| {
                    let distance = (i as f64 - j as f64) / n as f64;
                    (-50.0 * distance * distance).exp() + if i == j { ridge } else { 0.0 }
                }),
                initial_gap: (0..n).map(|k| (k as f64 / n as f64 - 0.41).powi(2)).collect(),
                closing: vec![1.0; n],
                load,
            };
            let (simplex, active) = case.solve();
            assert!(simplex.pivots > simplex.active_set.len() + 1);
            assert_eq!(simplex.active_set, active.active_set);
        }
    }
}

#[test]
fn the_judge_rejects_wrong_answers() {
    let (case, ..) = cylinders(40, 1.6, true);
    let problem = case.problem();
    let (right, _) = case.solve();
    let total = right.total_force;
    let judge = |force: &[f64], approach: f64| kkt::check(&problem, force, approach);
    let inner = right.active_set.len() / 2;
    let outer = right.active_set.last().map_or(0, |k| k + 1);

    let mut dropped = right.force.clone();
    dropped[inner] = 0.0;
    assert!(judge(&dropped, right.approach).equilibrium > 1e-3);
    let rescaled: Vec<f64> =
        dropped.iter().map(|r| r * total / (total - right.force[inner])).collect();
    let report = judge(&rescaled, right.approach);
    assert!(report.equilibrium < 1e-14 && report.penetration > 1e-3, "{report:?}");

    let mut tensile = right.force.clone();
    tensile[outer] -= 0.01 * total;
    tensile[0] += 0.01 * total;
    assert!(judge(&tensile, right.approach).tension > 1e-3);

    let mut far = right.force.clone();
    far[outer + 3] += 0.01 * total;
    far[0] -= 0.01 * total;
    assert!(judge(&far, right.approach).complementarity > 1e-3);

    for factor in [1.0 + 1e-6, 1e-6, 1e6, -1.0] {
        let scaled: Vec<f64> = right.force.iter().map(|r| r * factor).collect();
        assert!(!judge(&scaled, right.approach).passes(1e-8), "{factor}");
        assert!(!judge(&right.force, right.approach * factor).passes(1e-8), "{factor}");
    }
    let mut broken = right.force.clone();
    broken[0] = f64::NAN;
    assert!(!judge(&broken, right.approach).passes(f64::INFINITY));
    assert!(judge(&right.force, right.approach).passes(1e-12));
}

#[test]
fn both_solvers_refuse_what_is_no_contact_problem() {
    let (case, ..) = cylinders(4, 1.6, true);
    let nan_gap = [0.0, f64::NAN, 0.0, 0.0];
    let infinite = SymmetricMatrix::from_fn(4, |i, j| if i == j { f64::INFINITY } else { 0.0 });
    let empty = SymmetricMatrix::zeros(0);
    let negative = SymmetricMatrix::from_fn(4, |i, j| if i == j { -1.0 } else { 0.0 });
    let good = case.problem();
    let problems = [
        (
            ContactProblem { initial_gap: &[0.0], ..good },
            ContactError::DimensionMismatch { expected: 4, found: 1 },
        ),
        (ContactProblem { initial_gap: &[], flexibility: &empty, ..good }, ContactError::NoPairs),
        (ContactProblem { closing: &[1.0, 1.0, 0.0, 1.0], ..good }, ContactError::NotClosing),
        (ContactProblem { initial_gap: &nan_gap, ..good }, ContactError::NotFinite("initial gap")),
        (
            ContactProblem { flexibility: &infinite, ..good },
            ContactError::NotFinite("flexibility"),
        ),
        (
            ContactProblem { load: ContactLoad::Force(f64::NAN), ..good },
            ContactError::NotFinite("force"),
        ),
        (
            ContactProblem { load: ContactLoad::Approach(f64::INFINITY), ..good },
            ContactError::NotFinite("approach"),
        ),
        (
            ContactProblem { load: ContactLoad::Force(-1.0), ..good },
            ContactError::NegativeForce(-1.0),
        ),
        (
            ContactProblem { flexibility: &negative, ..good },
            ContactError::NotPositiveDefinite { pair: 0 },
        ),
    ];
    for (problem, expected) in problems {
        for solver in [&SimplexSolver as &dyn ContactSolver, &ActiveSetSolver] {
            assert_eq!(solver.solve(&problem, None, &mut never), Err(expected));
        }
    }
}

#[test]
fn units_do_not_matter() {
    let (case, ..) = cylinders(40, 1.6, true);
    let (reference, _) = case.solve();
    for (length, force) in [(1e-3, 1.0), (1e3, 1e-6), (1.0, 1e9)] {
        let n = case.initial_gap.len();
        let scaled = Case {
            flexibility: SymmetricMatrix::from_fn(n, |i, j| {
                case.flexibility[(i, j)] * length / force
            }),
            initial_gap: case.initial_gap.iter().map(|gap| gap * length).collect(),
            closing: case.closing.clone(),
            load: ContactLoad::Force(reference.total_force * force),
        };
        let (simplex, active) = scaled.solve();
        assert_eq!(simplex.active_set, reference.active_set);
        assert_eq!((simplex.pivots, active.pivots > 0), (reference.pivots, true));
        assert!((simplex.approach / (reference.approach * length) - 1.0).abs() < 1e-12);
    }
}
