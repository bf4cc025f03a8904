//! The flexibility of two elastic bodies in contact.

use dense_cholesky::SymmetricMatrix;

/// The displacements along the normals that contact forces cause, `u = F R`.
///
/// `F = flexibility [mm/N]`, the sum over both bodies, is symmetric and positive definite. u is
/// positive where it opens the gap. Direct solvers need its [entries](Self::dense), conjugate
/// gradients apply it.
pub trait Flexibility {
    /// Number of candidate cells or pairs.
    fn len(&self) -> usize;

    /// Whether there are none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// `u = F R`; both slices have [`len`](Self::len) entries.
    fn apply(&self, force: &[f64], displacement: &mut [f64]);

    /// A symmetric positive definite approximation of `F⁻¹ u`, up to a positive factor. The
    /// identity by default.
    fn precondition(&self, displacement: &[f64], force: &mut [f64]) {
        force.copy_from_slice(displacement);
    }

    /// Returns the entries of F row by row, if they are stored.
    fn dense(&self) -> Option<&[f64]> {
        None
    }
}

impl Flexibility for SymmetricMatrix {
    fn len(&self) -> usize {
        Self::len(self)
    }

    fn apply(&self, force: &[f64], displacement: &mut [f64]) {
        for (i, u) in displacement.iter_mut().enumerate() {
            *u = self.row(i).iter().zip(force).map(|(entry, r)| entry * r).sum();
        }
    }

    fn precondition(&self, displacement: &[f64], force: &mut [f64]) {
        for (k, (r, u)) in force.iter_mut().zip(displacement).enumerate() {
            *r = u / self[(k, k)];
        }
    }

    fn dense(&self) -> Option<&[f64]> {
        Some(self.as_slice())
    }
}
