//! Elastic contacts of smooth bodies against Hertz, to the last iteration.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolution, ContactSolver,
    ContactStatus, kkt, never,
};
use brinell_halfspace::{EllipticContact, SurfaceFlexibility, SurfaceGrid};

const MODULUS: f64 = 210_000.0 / 0.91;

struct Case {
    hertz: EllipticContact,
    surface: SurfaceFlexibility,
    gap: Vec<f64>,
}

/// A contact of 2000 MPa on n × n cells over 2.6 times its ellipse.
fn case(ratio: f64, n: usize) -> Case {
    let (rx, ry) = (10.0, 10.0 * ratio);
    let unit = EllipticContact::new(rx, ry, MODULUS, 1.0);
    let hertz = EllipticContact::new(rx, ry, MODULUS, (2000.0 / unit.peak_pressure).powi(3));
    let side = 2.6 / n as f64;
    let grid = SurfaceGrid::new(n, n, side * hertz.semi_axis_x, side * hertz.semi_axis_y).unwrap();
    let gap = grid.sample(|x, y| x * x / (2.0 * rx) + y * y / (2.0 * ry));
    Case { hertz, surface: SurfaceFlexibility::new(grid, MODULUS), gap }
}

impl Case {
    fn force(&self) -> f64 {
        let hertz = &self.hertz;
        2.0 / 3.0
            * std::f64::consts::PI
            * hertz.semi_axis_x
            * hertz.semi_axis_y
            * hertz.peak_pressure
    }

    fn solve(&self, load: ContactLoad, solver: &impl ContactSolver) -> ContactSolution {
        let closing = vec![1.0; self.gap.len()];
        let (flexibility, initial_gap) = (&self.surface, &self.gap);
        let problem = ContactProblem { flexibility, initial_gap, closing: &closing, load };
        let solution = solver.solve(&problem, None, &mut never).unwrap();
        assert!(kkt::check(&problem, &solution.force, solution.approach).passes(1e-7));
        assert_eq!(solution.status, ContactStatus::Converged);
        solution
    }

    /// Errors of peak pressure and approach.
    fn errors(&self, solution: &ContactSolution) -> (f64, f64) {
        let peak =
            solution.force.iter().copied().fold(0.0, f64::max) / self.surface.grid().cell_area();
        (peak / self.hertz.peak_pressure - 1.0, solution.approach / self.hertz.approach - 1.0)
    }
}

#[test]
fn ellipses_up_to_fifty_agree_with_hertz() {
    for (ratio, most) in [(1.0, 22), (2.0, 23), (5.0, 27), (10.0, 28), (20.0, 29), (50.0, 31)] {
        let case = case(ratio, 32);
        let solution =
            case.solve(ContactLoad::Force(case.force()), &ConjugateGradientSolver::new(1e-8));
        let (peak, approach) = case.errors(&solution);
        println!(
            "{ratio}: {peak:.2e} {approach:.2e} {} {}",
            solution.applications, solution.pivots
        );
        assert!(peak.abs() < 1.5e-3, "Ry/Rx {ratio}: peak {peak:e}");
        assert!(approach.abs() < 3e-4, "Ry/Rx {ratio}: approach {approach:e}");
        assert!(
            solution.applications <= most,
            "Ry/Rx {ratio}: {} applications",
            solution.applications
        );
    }
}

#[test]
fn errors_fall_with_the_square_of_the_cells() {
    let figures: Vec<(f64, f64)> = [32, 64, 128]
        .into_iter()
        .map(|n| {
            let case = case(1.0, n);
            case.errors(
                &case.solve(ContactLoad::Force(case.force()), &ConjugateGradientSolver::new(1e-8)),
            )
        })
        .collect();
    for pair in figures.windows(2) {
        assert!(pair[1].0.abs() < 0.3 * pair[0].0.abs(), "peak pressure {figures:?}");
        assert!(pair[1].1.abs() < 0.4 * pair[0].1.abs(), "approach {figures:?}");
    }
}

#[test]
fn both_loads_give_one_answer() {
    for ratio in [1.0, 20.0] {
        let case = case(ratio, 32);
        let load = ContactLoad::Force(case.force());
        let solution = case.solve(load, &ConjugateGradientSolver::new(1e-10));
        let approached = case
            .solve(ContactLoad::Approach(solution.approach), &ConjugateGradientSolver::new(1e-10));
        assert!((approached.total_force / case.force() - 1.0).abs() < 1e-8);
        let largest = solution.force.iter().copied().fold(0.0, f64::max);
        for (a, b) in solution.force.iter().zip(&approached.force) {
            assert!((a - b).abs() < 1e-7 * largest);
        }
    }
}
