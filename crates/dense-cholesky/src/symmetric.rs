//! Dense symmetric matrices and their Cholesky factorization, which is faer's.

use std::ops::Index;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{
    LltError, LltRegularization, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::cholesky::llt::inverse::{inverse, inverse_scratch};
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::{MatMut, MatRef, Par, Spec};
use thiserror::Error;

/// Two sizes differ that must be equal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("expected {expected} entries, found {found}")]
pub struct SizeMismatch {
    /// The required size.
    pub expected: usize,
    /// The given size.
    pub found: usize,
}

/// A pivot was not clearly positive: the matrix is indefinite, singular, or holds a NaN.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("matrix is not positive definite (row {index})")]
pub struct NotPositiveDefinite {
    /// First row whose leading block is not positive definite.
    pub index: usize,
}

/// A symmetric n × n matrix, all n² entries stored.
///
/// Invariant: `self[(i, j)] == self[(j, i)]` bit for bit, so a row serves as a column.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetricMatrix {
    n: usize,
    data: Vec<f64>,
}

impl SymmetricMatrix {
    /// The n × n zero matrix (the flexibility of a rigid body).
    pub fn zeros(n: usize) -> Self {
        Self { n, data: vec![0.0; n * n] }
    }

    /// Calls `entry(i, j)` for the lower triangle, `j <= i`, and mirrors it.
    pub fn from_fn(n: usize, mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        let mut matrix = Self::zeros(n);
        for i in 0..n {
            for j in 0..=i {
                let value = entry(i, j);
                matrix.data[i * n + j] = value;
                matrix.data[j * n + i] = value;
            }
        }
        matrix
    }

    /// Number of rows.
    pub const fn len(&self) -> usize {
        self.n
    }

    /// Whether there are no rows.
    pub const fn is_empty(&self) -> bool {
        self.n == 0
    }

    /// Row i, which is also column i.
    ///
    /// # Panics
    /// If `i >= len()`.
    pub fn row(&self, i: usize) -> &[f64] {
        &self.data[i * self.n..(i + 1) * self.n]
    }

    /// All entries, row by row.
    pub fn as_slice(&self) -> &[f64] {
        &self.data
    }

    /// Adds another matrix of the same size to this one.
    ///
    /// # Errors
    /// [`SizeMismatch`] if the sizes differ; nothing is changed then.
    pub fn add(&mut self, other: &Self) -> Result<(), SizeMismatch> {
        if self.n != other.n {
            return Err(SizeMismatch { expected: self.n, found: other.n });
        }
        for (left, right) in self.data.iter_mut().zip(&other.data) {
            *left += right;
        }
        Ok(())
    }

    /// The block of the given rows and columns.
    ///
    /// # Panics
    /// If an index is not below `len()`.
    #[must_use]
    pub fn principal_block(&self, indices: &[usize]) -> Self {
        let entry = |&i| indices.iter().map(move |&j| self[(i, j)]);
        Self { n: indices.len(), data: indices.iter().flat_map(entry).collect() }
    }
}

impl Index<(usize, usize)> for SymmetricMatrix {
    type Output = f64;
    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        &self.row(i)[j]
    }
}

/// The factor L of a symmetric positive definite matrix `A = L Lᵀ`.
#[derive(Debug, Clone)]
pub struct DenseCholesky {
    n: usize,
    /// L column by column; entries above the diagonal have no meaning.
    lower: Vec<f64>,
}

impl DenseCholesky {
    /// Factorizes a matrix; n³/6 multiply-adds.
    ///
    /// A pivot counts as positive above `8 n ε A_ii`, so a matrix that is singular to working
    /// precision is refused instead of answered with noise.
    ///
    /// # Errors
    /// [`NotPositiveDefinite`] with the first row whose pivot is not positive; a NaN is not.
    pub fn factor(matrix: SymmetricMatrix) -> Result<Self, NotPositiveDefinite> {
        let SymmetricMatrix { n, data: mut lower } = matrix;
        let smallest_pivot: Vec<f64> =
            (0..n).map(|i| 8.0 * n as f64 * f64::EPSILON * lower[i * n + i].abs()).collect();
        let a = MatMut::from_column_major_slice_mut(&mut lower, n, n);
        factorize_in_place(a, &mut factorization_memory(n))?;
        let is_positive = |&i: &usize| lower[i * n + i].powi(2) > smallest_pivot[i];
        match (0..n).find(|i| !is_positive(i)) {
            Some(index) => Err(NotPositiveDefinite { index }),
            None => Ok(Self { n, lower }),
        }
    }

    /// Number of rows.
    pub const fn len(&self) -> usize {
        self.n
    }

    /// Whether there are no rows.
    pub const fn is_empty(&self) -> bool {
        self.n == 0
    }

    /// Replaces b by the solution x of `A x = b`.
    ///
    /// # Panics
    /// If `b` has not n entries.
    pub fn solve_in_place(&self, b: &mut [f64]) {
        assert_eq!(b.len(), self.n, "right-hand side");
        let lower = MatRef::from_column_major_slice(&self.lower, self.n, self.n);
        let mut b = MatMut::from_column_major_slice_mut(b, self.n, 1);
        solve_lower_triangular_in_place(lower, b.as_mut(), Par::Seq);
        solve_upper_triangular_in_place(lower.transpose(), b, Par::Seq);
    }
}

/// Memory for [`factorize_in_place`] of up to n rows.
pub fn factorization_memory(n: usize) -> MemBuffer {
    MemBuffer::new(cholesky_in_place_scratch::<f64>(n, Par::Seq, Spec::default()))
}

/// Overwrites the lower triangle of a matrix by its factor.
///
/// # Errors
/// [`NotPositiveDefinite`] with the first row whose pivot is not positive.
pub fn factorize_in_place(
    a: MatMut<'_, f64>,
    memory: &mut MemBuffer,
) -> Result<(), NotPositiveDefinite> {
    let (regularization, stack) = (LltRegularization::default(), MemStack::new(memory));
    cholesky_in_place(a, regularization, Par::Seq, stack, Spec::default())
        .map(|_| ())
        .map_err(|LltError::NonPositivePivot { index }| NotPositiveDefinite { index })
}

/// `A⁻¹ = YᵀY`, `L Y = I`, of the lower triangle L that is stored column by column.
pub fn inverse_of_factor(lower: &[f64], n: usize) -> SymmetricMatrix {
    let mut data = vec![0.0; n * n];
    let out = MatMut::from_column_major_slice_mut(&mut data, n, n);
    let lower = MatRef::from_column_major_slice(lower, n, n);
    let mut memory = MemBuffer::new(inverse_scratch::<f64>(n, Par::Seq));
    inverse(out, lower, Par::Seq, MemStack::new(&mut memory));
    SymmetricMatrix::from_fn(n, |i, j| data[j * n + i])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Exponential kernel: positive definite, every entry different from zero.
    fn kernel(n: usize) -> SymmetricMatrix {
        SymmetricMatrix::from_fn(n, |i, j| (-0.3 * (i as f64 - j as f64).abs()).exp())
    }

    #[test]
    fn solves_small_and_blocked_sizes() {
        for n in [0, 1, 2, 3, 4, 31, 64, 65, 150, 400] {
            let a = kernel(n);
            let expected: Vec<f64> = (0..n).map(|i| (i as f64).sin() + 0.5).collect();
            let mut x: Vec<f64> =
                (0..n).map(|i| a.row(i).iter().zip(&expected).map(|(p, q)| p * q).sum()).collect();
            let factor = DenseCholesky::factor(a).unwrap();
            factor.solve_in_place(&mut x);
            assert_eq!((factor.len(), factor.is_empty()), (n, n == 0));
            for (left, right) in x.iter().zip(&expected) {
                assert!((left - right).abs() < 1e-12, "n = {n}: {left} {right}");
            }
        }
    }

    #[test]
    fn refuses_what_is_not_positive_definite() {
        let index = |n: usize, data: Vec<f64>| {
            let matrix = SymmetricMatrix::from_fn(n, |i, j| data[i * n + j]);
            DenseCholesky::factor(matrix).unwrap_err().index
        };
        assert_eq!(index(2, vec![1.0, 2.0, 2.0, 1.0]), 1);
        assert_eq!(index(2, vec![1.0, 1.0, 1.0, 1.0]), 1);
        // Positive in exact arithmetic, singular to working precision.
        assert_eq!(index(2, vec![1.0, 1.0, 1.0, 1.0 + 4.0 * f64::EPSILON]), 1);
        assert_eq!(index(1, vec![0.0]), 0);
        assert_eq!(index(1, vec![f64::NAN]), 0);
        assert_eq!(index(1, vec![f64::INFINITY]), 0);
        let mut late = kernel(100).as_slice().to_vec();
        late[77 * 100 + 77] = -1.0;
        assert_eq!(index(100, late), 77);
    }

    #[test]
    fn symmetric_matrix_stays_symmetric() {
        let mut a = SymmetricMatrix::from_fn(2, |i, j| [1.0, 3.0, 5.0][i + j]);
        assert_eq!((a[(0, 1)], a[(1, 0)]), (3.0, 3.0));
        a.add(&SymmetricMatrix::from_fn(2, |i, j| (i + j) as f64)).unwrap();
        assert_eq!(a.as_slice(), [1.0, 4.0, 4.0, 7.0]);
        assert_eq!(a.principal_block(&[1]).as_slice(), [7.0]);
        assert_eq!(a.add(&SymmetricMatrix::zeros(3)), Err(SizeMismatch { expected: 2, found: 3 }));
        assert!(SymmetricMatrix::zeros(0).is_empty());
    }
}
