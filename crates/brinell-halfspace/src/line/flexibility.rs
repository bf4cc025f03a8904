//! Displacement of the surface under a line load.

use std::f64::consts::PI;

use brinell_contact::Flexibility;

use crate::track::TrackGrid;

/// The flexibility of the columns of the window: force per length \[N/mm\] to displacement along
/// the normal \[mm\].
///
/// ```text
/// A = -2/(πE*) [F(x+h/2) - F(x-h/2)],   F(x) = x ln(|x|/ℓ) - x
/// ```
/// A line load presses a half-plane in by any amount: the datum ℓ, the width of the window, makes
/// the flexibility positive definite. It adds the same displacement everywhere, and so the
/// approach of a line contact means nothing.
///
/// # Reference
/// K. L. Johnson, *Contact Mechanics* (1985), section 2.5.
#[derive(Debug, Clone)]
pub struct LineFlexibility {
    n: usize,
    entries: Vec<f64>,
}

impl LineFlexibility {
    /// The flexibility of two bodies with `1/E* = effective_modulus⁻¹` \[MPa\].
    pub fn new(grid: &TrackGrid, effective_modulus: f64) -> Self {
        let (n, h) = (grid.window().len(), grid.column());
        let datum = n as f64 * h;
        let f = |x: f64| x * (x.abs() / datum).ln() - x;
        let of_offset = |offset: usize| {
            let x = offset as f64 * h;
            -2.0 / (PI * effective_modulus) * (f(x + 0.5 * h) - f(x - 0.5 * h)) / h
        };
        let column: Vec<f64> = (0..n).map(of_offset).collect();
        let entries = (0..n * n).map(|k| column[(k / n).abs_diff(k % n)]).collect();
        Self { n, entries }
    }
}

impl Flexibility for LineFlexibility {
    fn len(&self) -> usize {
        self.n
    }

    fn apply(&self, force: &[f64], displacement: &mut [f64]) {
        for (u, row) in displacement.iter_mut().zip(self.entries.chunks_exact(self.n)) {
            *u = row.iter().zip(force).map(|(a, r)| a * r).sum();
        }
    }

    fn dense(&self) -> Option<&[f64]> {
        Some(&self.entries)
    }
}

#[cfg(test)]
mod tests {
    use brinell_contact::{
        ActiveSetSolver, ContactLoad, ContactProblem, ContactSolver, SimplexSolver, never,
    };

    use super::*;
    use crate::track::LENGTH_OF_LINE;

    /// Positive definite up to the whole window, as both solvers ask; the peak is that of Hertz.
    #[test]
    fn both_contact_solvers_take_the_flexibility() {
        let grid = TrackGrid::of_line(1.0, 20, LENGTH_OF_LINE).unwrap();
        let (modulus, peak) = (230_000.0, 1000.0);
        let flexibility = LineFlexibility::new(&grid, modulus);
        let solve = |solver: &dyn ContactSolver, gap: &[f64]| {
            let closing = vec![1.0; gap.len()];
            let load = ContactLoad::Force(0.5 * PI * peak);
            let problem = ContactProblem {
                flexibility: &flexibility,
                initial_gap: gap,
                closing: &closing,
                load,
            };
            solver.solve(&problem, None, &mut never).unwrap()
        };
        let gap = grid.sample(|x, _| x * x * peak / modulus);
        let (one, other) = (solve(&ActiveSetSolver, &gap), solve(&SimplexSolver, &gap));
        for (a, b) in one.force.iter().zip(&other.force) {
            assert!((a - b).abs() < 1e-9 * peak, "{a} {b}");
        }
        let found = one.force.iter().fold(0.0, |a: f64, b| a.max(*b)) / grid.column();
        assert!((found / peak - 1.0).abs() < 1.2e-4, "{found}");
        assert!(one.pivots < 12, "{}", one.pivots);
        // A flat punch touches everywhere.
        assert_eq!(solve(&ActiveSetSolver, &vec![0.0; gap.len()]).active_set.len(), gap.len());
    }
}
