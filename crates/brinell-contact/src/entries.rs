//! The entries of a flexibility, which direct solvers need.

use super::Flexibility;
use dense_cholesky::SymmetricMatrix;

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

    /// The rows and columns of these pairs.
    pub fn principal_block(self, pairs: &[usize]) -> SymmetricMatrix {
        SymmetricMatrix::from_fn(pairs.len(), |i, j| self.at(pairs[i], pairs[j]))
    }
}
