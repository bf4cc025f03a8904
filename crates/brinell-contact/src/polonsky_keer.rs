//! Projected conjugate gradients after Polonsky and Keer: one pass over all cells, no
//! preconditioner.
//!
//! A step along the conjugate direction of the cells with R > 0 is cut off at R = 0; cells that
//! penetrate are loaded by the same step length, and the conjugate directions restart. The forces
//! are scaled to the load after *every* step; forces that are scaled only at the end satisfy the
//! contact conditions of another load.
//!
//! # Reference
//! I. A. Polonsky, L. M. Keer, *A numerical method for solving rough contact problems based on the
//! multi-level multi-summation and conjugate gradient techniques*, Wear 231 (1999) 206–219.

use super::vectors::{add_scaled, dot, largest, total};
use super::{
    ContactError, ContactLoad, ContactProblem, ContactSolution, ContactSolver, ContactStatus,
    StopHook, operator,
};

/// Iterations after which the solver gives up: a guard. Hertz to 1e-10 takes 73 and 109
/// applications at Ry/Rx 1 and 20.
const ITERATION_LIMIT: usize = 2000;

/// The fallback of [`ConjugateGradientSolver`](super::ConjugateGradientSolver).
#[derive(Debug, Clone, Copy)]
pub struct PolonskyKeerSolver {
    /// Largest violation of a contact condition, as [`KktReport`](super::KktReport) measures it.
    pub tolerance: f64,
}

impl PolonskyKeerSolver {
    /// Makes a solver that iterates until the independent check passes `tolerance`.
    pub const fn new(tolerance: f64) -> Self {
        Self { tolerance }
    }
}

impl ContactSolver for PolonskyKeerSolver {
    fn solve(
        &self,
        problem: &ContactProblem<'_>,
        start: Option<&ContactSolution>,
        stop: &mut StopHook<'_>,
    ) -> Result<ContactSolution, ContactError> {
        operator::solve(problem, start, self.tolerance, |problem, solution, tolerance| {
            run(problem, solution, tolerance, stop)
        })
    }
}

/// Mean of a quantity over the pairs in contact.
fn mean_in_contact(values: &[f64], force: &[f64]) -> f64 {
    let touching = values.iter().zip(force).filter(|(_, r)| **r > 0.0);
    let (sum, pairs) = touching.fold((0.0, 0.0), |(sum, pairs), (w, _)| (sum + w, pairs + 1.0));
    sum / pairs
}

/// Scales forces to the prescribed sum.
fn scale_to_load(problem: &ContactProblem<'_>, force: &mut [f64]) {
    if let ContactLoad::Force(prescribed) = problem.load {
        let factor = prescribed / total(force);
        for r in force.iter_mut() {
            *r *= factor;
        }
    }
}

/// Continues from the forces of `solution`, with normals along the approach.
pub(crate) fn run(
    problem: &ContactProblem<'_>,
    mut solution: ContactSolution,
    tolerance: f64,
    stop: &mut StopHook<'_>,
) -> Result<ContactSolution, ContactError> {
    let zeros = || vec![0.0; problem.n_pairs()];
    let (mut opening, mut direction, mut image) = (zeros(), zeros(), zeros());
    for r in &mut solution.force {
        *r = r.max(0.0);
    }
    scale_to_load(problem, &mut solution.force);
    let (mut previous, mut conjugate) = (1.0, 0.0);
    let mut iteration = 0;
    loop {
        problem.flexibility.apply(&solution.force, &mut opening);
        solution.applications += 1;
        let scale = largest(&opening);
        add_scaled(&mut opening, 1.0, problem.initial_gap);
        let approach = match problem.load {
            ContactLoad::Approach(approach) => approach,
            ContactLoad::Force(_) => mean_in_contact(&opening, &solution.force),
        };
        let (mut worst, mut product) = (0.0_f64, 0.0);
        for (w, r) in opening.iter_mut().zip(&solution.force) {
            *w -= approach;
            if *r > 0.0 {
                worst = worst.max(w.abs());
                product += *w * *w;
            } else {
                worst = worst.max(-*w);
            }
        }
        let ended = worst <= 0.5 * tolerance * scale;
        let stopped = !ended && stop().is_break();
        if ended || stopped || iteration == ITERATION_LIMIT {
            let report = operator::finish(problem, &mut solution, approach);
            solution.status = match stopped {
                true => ContactStatus::Stopped,
                false if report.passes(tolerance) => ContactStatus::Converged,
                false => ContactStatus::IterationLimit,
            };
            return Ok(solution);
        }
        conjugate = if previous > 0.0 { conjugate * product / previous } else { 0.0 };
        previous = product;
        for ((t, w), r) in direction.iter_mut().zip(&opening).zip(&solution.force) {
            *t = match () {
                () if *r > 0.0 => w + conjugate * *t,
                // If the cells in contact are in equilibrium, only the penetrating cells remain.
                () if product == 0.0 => w.min(0.0),
                () => 0.0,
            };
        }
        problem.flexibility.apply(&direction, &mut image);
        solution.applications += 1;
        let energy = dot(&direction, &image);
        if energy.is_nan() || energy <= 0.0 {
            return Err(ContactError::NoEnergy { energy });
        }
        let mut slope = 0.0;
        if matches!(problem.load, ContactLoad::Force(_)) {
            slope = mean_in_contact(&image, &solution.force);
        }
        // Step to the least energy among forces with this sum, to first order in what scaling
        // changes.
        let (mut numerator, mut denominator) = (0.0, 0.0);
        for ((t, u), w) in direction.iter().zip(&image).zip(&opening) {
            numerator += w * t;
            denominator += (u - slope) * t;
        }
        let step = numerator / denominator;
        conjugate = 1.0;
        for ((r, t), w) in solution.force.iter_mut().zip(&direction).zip(&opening) {
            let touched = *r > 0.0;
            *r = (*r - step * t).max(0.0);
            if !touched && *w < 0.0 {
                *r = -step * w;
                conjugate = 0.0;
            }
        }
        scale_to_load(problem, &mut solution.force);
        iteration += 1;
    }
}
