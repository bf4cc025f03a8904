//! Projected conjugate gradients after Polonsky and Keer: one pass over all cells, no preconditioner.
//!
//! A step along the conjugate direction of the cells with R > 0 is cut off at R = 0; cells that penetrate are loaded by the
//! same step length, and conjugacy starts anew. The forces are scaled to the load after *every* step: scaled at the end
//! alone, the answer satisfies the contact conditions of another load.
//!
//! # Reference
//! I. A. Polonsky, L. M. Keer, *A numerical method for solving rough contact problems based on the multi-level
//! multi-summation and conjugate gradient techniques*, Wear 231 (1999) 206–219.

use super::vectors::{add_scaled, dot, largest, total};
use super::{
    ContactError, ContactLoad, ContactProblem, ContactSolution, ContactSolver, ContactStatus, StopHook, start,
};

/// Iterations after which the solver gives up: a guard. Hertz to 1e-10 takes 73 and 109 applications at Ry/Rx 1 and 20.
const ITERATION_LIMIT: usize = 2000;

/// The fallback of [`ConjugateGradientSolver`](super::ConjugateGradientSolver). Holds its work space.
#[derive(Debug, Clone)]
pub struct PolonskyKeerSolver {
    /// Largest violation of a contact condition, as [`KktReport`](super::KktReport) measures it.
    pub tolerance: f64,
    opening: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
}

impl PolonskyKeerSolver {
    /// A solver that goes on until the independent check passes `tolerance`.
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, opening: Vec::new(), direction: Vec::new(), image: Vec::new() }
    }

    /// The approach that the cells in contact have on average, or the prescribed one.
    fn approach(&self, problem: &ContactProblem<'_>, force: &[f64]) -> f64 {
        match problem.load {
            ContactLoad::Approach(approach) => approach,
            ContactLoad::Force(_) => {
                let touching = self.opening.iter().zip(force).filter(|(_, r)| **r > 0.0);
                let (sum, cells) = touching.fold((0.0, 0.0), |(sum, cells), (w, _)| (sum + w, cells + 1.0));
                sum / cells
            }
        }
    }
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

impl ContactSolver for PolonskyKeerSolver {
    fn solve(
        &mut self,
        problem: &ContactProblem<'_>,
        solution: &mut ContactSolution,
        stop: &mut StopHook<'_>,
    ) -> Result<(), ContactError> {
        problem.validate()?;
        (solution.applications, solution.active_sets) = (0, 0);
        if let Some(approach) = problem.approach_without_force() {
            solution.without_force(problem, approach);
            return Ok(());
        }
        let n = problem.n_cells();
        for vector in [&mut self.opening, &mut self.direction, &mut self.image] {
            vector.resize(n, 0.0);
        }
        if solution.force.len() != n || !solution.force.iter().any(|r| *r > 0.0) {
            solution.force.resize(n, 0.0);
            start::guess(problem, &mut solution.force, &mut self.image);
            solution.applications += 1;
        }
        for r in &mut solution.force {
            *r = r.max(0.0);
        }
        scale_to_load(problem, &mut solution.force);
        self.direction.fill(0.0);
        let (mut previous, mut conjugate) = (1.0, 0.0);
        let mut iteration = 0;
        loop {
            problem.flexibility.apply(&solution.force, &mut self.opening);
            solution.applications += 1;
            let scale = largest(&self.opening);
            add_scaled(&mut self.opening, 1.0, problem.initial_gap);
            let approach = self.approach(problem, &solution.force);
            let (mut worst, mut product) = (0.0_f64, 0.0);
            for (w, r) in self.opening.iter_mut().zip(&solution.force) {
                *w -= approach;
                if *r > 0.0 {
                    worst = worst.max(w.abs());
                    product += *w * *w;
                } else {
                    worst = worst.max(-*w);
                }
            }
            let ended = worst <= 0.5 * self.tolerance * scale;
            let stopped = !ended && stop().is_break();
            if ended || stopped || iteration == ITERATION_LIMIT {
                solution.finish(problem, approach);
                solution.status = match stopped {
                    true => ContactStatus::Stopped,
                    false if solution.kkt.passes(self.tolerance) => ContactStatus::Converged,
                    false => ContactStatus::IterationLimit,
                };
                return Ok(());
            }
            conjugate = if previous > 0.0 { conjugate * product / previous } else { 0.0 };
            previous = product;
            for ((t, w), r) in self.direction.iter_mut().zip(&self.opening).zip(&solution.force) {
                *t = match () {
                    () if *r > 0.0 => w + conjugate * *t,
                    // Where the cells in contact are at rest, those that penetrate are all that is left to move.
                    () if product == 0.0 => w.min(0.0),
                    () => 0.0,
                };
            }
            problem.flexibility.apply(&self.direction, &mut self.image);
            solution.applications += 1;
            let energy = dot(&self.direction, &self.image);
            if energy.is_nan() || energy <= 0.0 {
                return Err(ContactError::NotPositiveDefinite { energy });
            }
            let mut slope = 0.0;
            if matches!(problem.load, ContactLoad::Force(_)) {
                let touching = self.image.iter().zip(&solution.force).filter(|(_, r)| **r > 0.0);
                let (sum, cells) = touching.fold((0.0, 0.0), |(sum, cells), (u, _)| (sum + u, cells + 1.0));
                slope = sum / cells;
            }
            // Step to the least energy among forces with this sum, to first order in what scaling changes.
            let (mut numerator, mut denominator) = (0.0, 0.0);
            for ((t, u), w) in self.direction.iter().zip(&self.image).zip(&self.opening) {
                numerator += w * t;
                denominator += (u - slope) * t;
            }
            let step = numerator / denominator;
            conjugate = 1.0;
            for ((r, t), w) in solution.force.iter_mut().zip(&self.direction).zip(&self.opening) {
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
}
