//! A primal-dual active set outside, preconditioned conjugate gradients inside.
//!
//! On an active set I the conditions are linear: `g + F R = α` on I, `R = 0` elsewhere, `Σ R = P`. Conjugate gradients
//! solve them with a preconditioner `M ≈ F⁻¹`, restricted to I. Under a prescribed force every direction keeps the sum of the
//! forces. With `m = M 1_I`,
//! ```text
//! α = mᵀw / Σm,   w = g + F R,   r = w - α,   z = M r - (Σ M r / Σ m) m
//! ```
//! so that α is the best approach in the norm of M and `Σ z = 0`. The inner iteration ends at a fiftieth of its first
//! residual: the set matters more than the forces until it has settled. The next set keeps cells with R > 0 and takes in
//! cells that penetrate, by more than the tolerance, since the inner iteration knows no better.
//!
//! The set is not proven to settle. Sets that go on changing hand over to [`PolonskyKeerSolver`].
//!
//! # Reference
//! M. Hintermüller, K. Ito, K. Kunisch, *The primal-dual active set strategy as a semismooth Newton method*, SIAM J. Optim.
//! 13 (2002) 865–888, for the outer iteration.

use super::vectors::{add_scaled, dot, largest, sum, total};
use super::{
    ContactError, ContactLoad, ContactProblem, ContactSolution, ContactSolver, ContactStatus,
    PolonskyKeerSolver, StopHook, start,
};

/// Reduction of the residual by which an inner iteration ends. From the prototype in Python; not tuned here.
const INNER_REDUCTION: f64 = 0.02;
/// Sets after which the fallback takes over. Hertz on 32 × 32 cells takes 7 and 8 at Ry/Rx 1 and 2; rough surfaces are untried.
const SET_LIMIT: usize = 60;
/// Applications within one set: a guard, not a measured bound.
const INNER_LIMIT: usize = 400;

/// Solves contact problems by applications of the flexibility alone. Holds its work space.
#[derive(Debug, Clone)]
pub struct ConjugateGradientSolver {
    /// Largest violation of a contact condition, as [`KktReport`](super::KktReport) measures it.
    pub tolerance: f64,
    active: Vec<bool>,
    /// 1 on the active set, 0 elsewhere.
    indicator: Vec<f64>,
    opening: Vec<f64>,
    residual: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    preconditioned: Vec<f64>,
    uniform: Vec<f64>,
    fallback: PolonskyKeerSolver,
}

/// How the inner iteration on one set ended.
struct Inner {
    approach: f64,
    /// `max |r| / max |u|` over the set.
    residual: f64,
    /// `max |u|`.
    scale: f64,
    stopped: bool,
}

impl ConjugateGradientSolver {
    /// A solver that goes on until the independent check passes `tolerance`.
    pub fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            active: Vec::new(),
            indicator: Vec::new(),
            opening: Vec::new(),
            residual: Vec::new(),
            direction: Vec::new(),
            image: Vec::new(),
            preconditioned: Vec::new(),
            uniform: Vec::new(),
            fallback: PolonskyKeerSolver::new(tolerance),
        }
    }

    fn resize(&mut self, n: usize) {
        self.active.resize(n, false);
        for vector in [
            &mut self.indicator,
            &mut self.opening,
            &mut self.residual,
            &mut self.direction,
            &mut self.image,
            &mut self.preconditioned,
            &mut self.uniform,
        ] {
            vector.resize(n, 0.0);
        }
    }

    /// `z = M r` on the active set, zero elsewhere.
    fn precondition(&mut self, problem: &ContactProblem<'_>) {
        problem.flexibility.precondition(&self.residual, &mut self.preconditioned);
        for (z, inside) in self.preconditioned.iter_mut().zip(&self.indicator) {
            *z *= inside;
        }
    }

    /// Conjugate gradients on the set, from the forces in `solution`; leaves `w = g + F R` in `opening`.
    fn equations_of_set(
        &mut self,
        problem: &ContactProblem<'_>,
        solution: &mut ContactSolution,
        stop: &mut StopHook<'_>,
    ) -> Result<Inner, ContactError> {
        let constrained = matches!(problem.load, ContactLoad::Force(_));
        let mut uniform_sum = 1.0;
        if constrained {
            self.residual.copy_from_slice(&self.indicator);
            self.precondition(problem);
            self.uniform.copy_from_slice(&self.preconditioned);
            uniform_sum = total(&self.uniform);
        }
        problem.flexibility.apply(&solution.force, &mut self.opening);
        solution.applications += 1;
        let scale = largest(&self.opening);
        add_scaled(&mut self.opening, 1.0, problem.initial_gap);

        let (mut first, mut previous, mut count) = (f64::INFINITY, 0.0, 0);
        loop {
            let approach = match problem.load {
                ContactLoad::Approach(approach) => approach,
                ContactLoad::Force(_) => dot(&self.opening, &self.uniform) / uniform_sum,
            };
            let mut worst = 0.0_f64;
            for ((r, w), inside) in self.residual.iter_mut().zip(&self.opening).zip(&self.indicator) {
                *r = (w - approach) * inside;
                worst = worst.max(r.abs());
            }
            let residual = worst / scale;
            if count == 0 {
                first = residual;
            }
            let ended = residual <= 0.5 * self.tolerance || residual <= INNER_REDUCTION * first;
            let stopped = !ended && stop().is_break();
            if ended || stopped || count == INNER_LIMIT {
                return Ok(Inner { approach, residual, scale, stopped });
            }
            self.precondition(problem);
            if constrained {
                let share = total(&self.preconditioned) / uniform_sum;
                add_scaled(&mut self.preconditioned, -share, &self.uniform);
            }
            let product = dot(&self.residual, &self.preconditioned);
            let conjugate = if count == 0 { 0.0 } else { product / previous };
            previous = product;
            for (t, z) in self.direction.iter_mut().zip(&self.preconditioned) {
                *t = if count == 0 { *z } else { z + conjugate * *t };
            }
            problem.flexibility.apply(&self.direction, &mut self.image);
            solution.applications += 1;
            let energy = dot(&self.direction, &self.image);
            if energy.is_nan() || energy <= 0.0 {
                return Err(ContactError::NotPositiveDefinite { energy });
            }
            let step = product / energy;
            add_scaled(&mut solution.force, -step, &self.direction);
            add_scaled(&mut self.opening, -step, &self.image);
            count += 1;
        }
    }

    /// Takes the forces' own set, without the tension, at the prescribed force.
    fn adopt(&mut self, problem: &ContactProblem<'_>, force: &mut [f64]) {
        for (k, inside) in self.active.iter().enumerate() {
            self.indicator[k] = f64::from(u8::from(*inside));
            force[k] = if *inside { force[k].max(0.0) } else { 0.0 };
        }
        if let ContactLoad::Force(prescribed) = problem.load {
            let carried = total(force);
            if carried > 0.0 {
                for r in force.iter_mut() {
                    *r *= prescribed / carried;
                }
            } else {
                let cells = total(&self.indicator);
                for (r, inside) in force.iter_mut().zip(&self.indicator) {
                    *r = inside * prescribed / cells;
                }
            }
        }
    }

    /// The next set: without tension, with what penetrates. Whether it is another one.
    fn next_set(&mut self, force: &[f64], inner: &Inner) -> bool {
        let mut changed = false;
        for (k, inside) in self.active.iter_mut().enumerate() {
            let next = if *inside {
                force[k] > 0.0
            } else {
                self.opening[k] - inner.approach < -self.tolerance * inner.scale
            };
            changed |= next != *inside;
            *inside = next;
        }
        changed
    }
}

impl ContactSolver for ConjugateGradientSolver {
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
        self.resize(n);
        if solution.force.len() != n || !solution.force.iter().any(|r| *r > 0.0) {
            solution.force.resize(n, 0.0);
            start::guess(problem, &mut solution.force, &mut self.image);
            solution.applications += 1;
        }
        for (inside, r) in self.active.iter_mut().zip(&solution.force) {
            *inside = *r > 0.0;
        }
        let lowest = problem.initial_gap.iter().copied().fold(f64::INFINITY, f64::min);
        while solution.active_sets < SET_LIMIT {
            solution.active_sets += 1;
            self.adopt(problem, &mut solution.force);
            let inner = self.equations_of_set(problem, solution, stop)?;
            if inner.stopped {
                self.adopt(problem, &mut solution.force);
                solution.finish(problem, inner.approach);
                solution.status = ContactStatus::Stopped;
                return Ok(());
            }
            let changed = self.next_set(&solution.force, &inner);
            if !changed && inner.residual <= 0.5 * self.tolerance {
                solution.finish(problem, inner.approach);
                if solution.kkt.passes(self.tolerance) {
                    solution.status = ContactStatus::Converged;
                    return Ok(());
                }
            }
            if sum(n, |k| f64::from(u8::from(self.active[k]))) == 0.0 {
                for (inside, g) in self.active.iter_mut().zip(problem.initial_gap) {
                    *inside = *g <= lowest;
                }
            }
        }
        let spent = (solution.applications, solution.active_sets);
        self.adopt(problem, &mut solution.force);
        self.fallback.tolerance = self.tolerance;
        self.fallback.solve(problem, solution, stop)?;
        solution.applications += spent.0;
        solution.active_sets += spent.1;
        Ok(())
    }
}
