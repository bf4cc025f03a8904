//! The elastic bodies as a contact solver sees them.

use sparse_cholesky::dense::SymmetricMatrix;

/// The flexibility F of both bodies: symmetric positive definite, from contact forces to displacements along the normals.
///
/// Direct solvers need its [entries](Self::dense), conjugate gradients apply it.
pub trait Flexibility {
    /// Number of candidate pairs.
    fn len(&self) -> usize;

    /// Whether there are no candidate pairs.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// `u = F R`; both slices have [`len`](Self::len) entries.
    fn apply(&self, force: &[f64], displacement: &mut [f64]);

    /// A symmetric positive definite approximation of `F⁻¹ u`, up to a positive factor. The identity by default.
    fn precondition(&self, displacement: &[f64], force: &mut [f64]) {
        force.copy_from_slice(displacement);
    }

    /// The entries of F row by row, where they are at hand.
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

    fn dense(&self) -> Option<&[f64]> {
        Some(self.as_slice())
    }
}

/// The entries of a flexibility.
#[derive(Clone, Copy)]
pub(super) struct Entries<'a> {
    n: usize,
    entries: &'a [f64],
}

impl<'a> Entries<'a> {
    /// `None` of a flexibility whose entries are not at hand.
    pub fn of(flexibility: &'a dyn Flexibility) -> Option<Self> {
        Some(Self { n: flexibility.len(), entries: flexibility.dense()? })
    }

    pub fn at(self, i: usize, j: usize) -> f64 {
        self.entries[i * self.n + j]
    }

    pub fn row(self, i: usize) -> &'a [f64] {
        &self.entries[i * self.n..(i + 1) * self.n]
    }

    pub fn all(self) -> &'a [f64] {
        self.entries
    }

    /// The rows and columns of these pairs.
    pub fn principal_block(self, pairs: &[usize]) -> SymmetricMatrix {
        SymmetricMatrix::from_fn(pairs.len(), |i, j| self.at(pairs[i], pairs[j]))
    }
}
