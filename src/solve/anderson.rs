//! Anderson acceleration of a fixed-point iteration `x = g(x)`.
//!
//! The next point is the combination `Σ θ_j g(x_j)`, `Σ θ_j = 1`, of the last steps whose combined residual
//! `Σ θ_j (g(x_j) - x_j)` is smallest.
//!
//! # Reference
//! D. G. Anderson, *Iterative procedures for nonlinear integral equations*, J. ACM 12 (1965) 547–560;
//! H. F. Walker, P. Ni, *Anderson acceleration for fixed-point iterations*, SIAM J. Numer. Anal. 49 (2011)
//! 1715–1735.

use std::collections::VecDeque;

use crate::linalg::dense::DenseCholesky;

/// Steps that are combined at most.
pub(super) const DEPTH: usize = 7;
/// A residual that grows by more than this factor empties the memory.
const RESTART_GROWTH: f64 = 2.0;
/// Relative shift that keeps nearly dependent differences from blowing up the combination.
const REGULARIZATION: f64 = 1e-14;

/// Memory of past steps.
#[derive(Debug, Default)]
pub(super) struct Anderson {
    steps: VecDeque<Step>,
}

#[derive(Debug)]
struct Step {
    image: Vec<f64>,
    residual: Vec<f64>,
}

impl Anderson {
    /// Takes `x` and `g(x)` and returns the next point.
    pub fn next(&mut self, x: &[f64], image: Vec<f64>) -> Vec<f64> {
        let residual: Vec<f64> = image.iter().zip(x).map(|(g, x)| g - x).collect();
        let grown = |last: &Step| {
            dot(&residual, &residual) > RESTART_GROWTH.powi(2) * dot(&last.residual, &last.residual)
        };
        if self.steps.back().is_some_and(grown) {
            self.steps.clear();
        }
        if self.steps.len() > DEPTH {
            self.steps.pop_front();
        }
        self.steps.push_back(Step { image, residual });
        self.combine()
    }

    /// `g_n - Σ γ_j (g_n - g_j)` with the γ that minimise `‖f_n - Σ γ_j (f_n - f_j)‖`.
    fn combine(&self) -> Vec<f64> {
        let Some((last, earlier)) =
            self.steps.iter().collect::<Vec<_>>().split_last().map(|(l, e)| (*l, e.to_vec()))
        else {
            return Vec::new();
        };
        let mut next = last.image.clone();
        let differences: Vec<Vec<f64>> = earlier
            .iter()
            .map(|step| last.residual.iter().zip(&step.residual).map(|(a, b)| a - b).collect())
            .collect();
        let n = differences.len();
        let mut gram = vec![0.0; n * n];
        for i in 0..n {
            for j in 0..=i {
                let product = dot(&differences[i], &differences[j]);
                gram[i * n + j] = product;
                gram[j * n + i] = product;
            }
            gram[i * n + i] *= 1.0 + REGULARIZATION;
        }
        let mut gamma: Vec<f64> = differences.iter().map(|d| dot(d, &last.residual)).collect();
        let Ok(factor) = DenseCholesky::factor(n, gram) else { return next };
        factor.solve_in_place(&mut gamma);
        for (step, &weight) in earlier.iter().zip(&gamma) {
            for ((value, newest), image) in next.iter_mut().zip(&last.image).zip(&step.image) {
                *value -= weight * (newest - image);
            }
        }
        next
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `x = A x + b` with spectral radius 0.95; Anderson is GMRES there and ends after n steps.
    #[test]
    fn solves_a_linear_map_in_as_many_steps_as_dimensions() {
        let map =
            |x: &[f64]| vec![0.95 * x[0] + 0.1 * x[1] + 1.0, 0.3 * x[1] + 2.0, -0.8 * x[2] + 0.2 * x[0]];
        let mut x = vec![0.0; 3];
        let mut anderson = Anderson::default();
        for _ in 0..5 {
            let image = map(&x);
            x = anderson.next(&x, image);
        }
        for (g, x) in map(&x).iter().zip(&x) {
            assert!((g - x).abs() < 1e-9);
        }
    }
}
