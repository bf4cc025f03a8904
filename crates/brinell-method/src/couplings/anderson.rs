//! Anderson acceleration of a fixed-point iteration `x = g(x)`.
//!
//! The next point is the combination `Σ θ_j g(x_j)`, `Σ θ_j = 1`, of the last steps whose combined
//! residual `Σ θ_j (g(x_j) - x_j)` is smallest. Vectors may become longer from step to step;
//! entries to come have been zero.
//!
//! # Reference
//! D. G. Anderson, *Iterative procedures for nonlinear integral equations*, J. ACM 12 (1965)
//! 547–560; H. F. Walker, P. Ni, *Anderson acceleration for fixed-point iterations*, SIAM J.
//! Numer. Anal. 49 (2011) 1715–1735.

use std::collections::VecDeque;

use dense_cholesky::{dot, simd_dispatch};
use nalgebra::{DMatrix, DVector};

/// Steps that are combined at most.
pub const DEPTH: usize = 7;
/// A residual that grows by more than this factor empties the memory.
const RESTART_GROWTH: f64 = 2.0;
/// Relative shift that keeps nearly dependent differences from blowing up the combination.
const REGULARIZATION: f64 = 1e-14;

/// Memory of past steps, as differences of neighbouring ones.
#[derive(Debug, Default)]
pub struct Anderson {
    last: Option<Step>,
    differences: VecDeque<Step>,
    /// `ΔF_iᵀ ΔF_j` of the residual differences, in the order of `differences`.
    gram: VecDeque<VecDeque<f64>>,
}

/// An image `g(x)` and its residual `g(x) - x`, or a difference of two such pairs.
#[derive(Debug)]
struct Step {
    image: Vec<f64>,
    residual: Vec<f64>,
}

impl Anderson {
    /// Takes `x` and `g(x)` and returns the next point.
    pub fn next(&mut self, x: &[f64], image: Vec<f64>) -> Vec<f64> {
        let residual: Vec<f64> = image.iter().zip(x).map(|(g, x)| g - x).collect();
        if let Some(mut last) = self.last.take() {
            last.extend(residual.len());
            let (now, before) =
                simd_dispatch(|| (dot(&residual, &residual), dot(&last.residual, &last.residual)));
            if now > RESTART_GROWTH.powi(2) * before {
                self.differences.clear();
                self.gram.clear();
            } else {
                self.remember(last.until(&image, &residual));
            }
        }
        let next = self.combine(&image, &residual);
        self.last = Some(Step { image, residual });
        next
    }

    fn remember(&mut self, difference: Step) {
        if self.differences.len() == DEPTH {
            self.differences.pop_front();
            self.gram.pop_front();
            for row in &mut self.gram {
                row.pop_front();
            }
        }
        self.differences.push_back(difference);
        let Some(newest) = self.differences.back() else { return };
        let products: VecDeque<f64> = simd_dispatch(|| {
            self.differences.iter().map(|d| dot(&d.residual, &newest.residual)).collect()
        });
        for (row, &product) in self.gram.iter_mut().zip(&products) {
            row.push_back(product);
        }
        self.gram.push_back(products);
    }

    /// `g - Σ γ_j ΔG_j` with the γ that minimise `‖f - Σ γ_j ΔF_j‖`.
    fn combine(&self, image: &[f64], residual: &[f64]) -> Vec<f64> {
        let n = self.differences.len();
        let gram = DMatrix::from_fn(n, n, |i, j| {
            self.gram[i][j] * if i == j { 1.0 + REGULARIZATION } else { 1.0 }
        });
        let mut next = image.to_vec();
        let Some(factor) = gram.cholesky() else { return next };
        simd_dispatch(|| {
            let products = self.differences.iter().map(|d| dot(&d.residual, residual));
            let gamma = factor.solve(&DVector::from_iterator(n, products));
            for (difference, weight) in self.differences.iter().zip(&gamma) {
                for (value, d) in next.iter_mut().zip(&difference.image) {
                    *value -= weight * d;
                }
            }
        });
        next
    }
}

impl Step {
    /// Adds the entries that have been zero so far.
    fn extend(&mut self, n: usize) {
        self.image.resize(n, 0.0);
        self.residual.resize(n, 0.0);
    }

    /// The step from here to another pair.
    fn until(mut self, image: &[f64], residual: &[f64]) -> Self {
        for (mine, later) in [(&mut self.image, image), (&mut self.residual, residual)] {
            for (value, later) in mine.iter_mut().zip(later) {
                *value = later - *value;
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same with the third number known only from the third step on, before which it is zero.
    #[test]
    fn entries_may_come_later() {
        let map = |x: [f64; 3]| {
            [0.5 * x[0] + 1.0, 0.3 * x[1] + 2.0, -0.8 * x[2] + (x[0] - 1.2).max(0.0)]
        };
        let mut anderson = Anderson::default();
        let mut x = vec![0.0; 2];
        for step in 0..12 {
            let whole = |k: usize| x.get(k).copied().unwrap_or(0.0);
            let image = map([whole(0), whole(1), whole(2)]);
            x.resize(if step < 2 { 2 } else { 3 }, 0.0);
            x = anderson.next(&x, image[..x.len()].to_vec());
        }
        let fixed = [2.0, 2.0 / 0.7, 0.8 / 1.8];
        assert!(x.iter().zip(fixed).all(|(x, fixed)| (x - fixed).abs() < 1e-9), "{x:?}");
    }

    /// `x = A x + b` with spectral radius 0.95; Anderson is GMRES there and ends after n steps.
    #[test]
    fn solves_a_linear_map_in_as_many_steps_as_dimensions() {
        let map = |x: &[f64]| {
            vec![0.95 * x[0] + 0.1 * x[1] + 1.0, 0.3 * x[1] + 2.0, -0.8 * x[2] + 0.2 * x[0]]
        };
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
