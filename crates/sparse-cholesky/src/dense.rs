//! Small dense symmetric matrices and their Cholesky factorization.
//!
//! Sizes stay below a few thousand. Everything is stored row by row, so that every inner loop runs over
//! neighbouring numbers.

use std::ops::Index;

use thiserror::Error;

/// Columns eliminated together by [`DenseCholesky::factor`]; a panel row then fills a few cache lines.
const PANEL: usize = 48;

/// Two sizes that had to be equal are not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("expected {expected} entries, found {found}")]
pub struct SizeMismatch {
    /// What was needed.
    pub expected: usize,
    /// What was there.
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

    /// Takes n² entries and replaces each pair (i, j), (j, i) by its mean, which removes rounding asymmetry.
    ///
    /// # Errors
    /// [`SizeMismatch`] unless there are n² entries.
    pub fn from_full(n: usize, mut data: Vec<f64>) -> Result<Self, SizeMismatch> {
        if data.len() != n * n {
            return Err(SizeMismatch { expected: n * n, found: data.len() });
        }
        for i in 0..n {
            for j in 0..i {
                let mean = 0.5 * (data[i * n + j] + data[j * n + i]);
                data[i * n + j] = mean;
                data[j * n + i] = mean;
            }
        }
        Ok(Self { n, data })
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

    /// The block of the given rows and columns, row by row, ready for [`DenseCholesky::factor`].
    ///
    /// # Panics
    /// If an index is not below `len()`.
    pub fn principal_block(&self, indices: &[usize]) -> Vec<f64> {
        let mut block = Vec::with_capacity(indices.len() * indices.len());
        for &i in indices {
            let row = self.row(i);
            block.extend(indices.iter().map(|&j| row[j]));
        }
        block
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
    /// L row by row; what lies above the diagonal is left over and never read.
    lower: Vec<f64>,
}

impl DenseCholesky {
    /// Factorizes the matrix whose n² entries are given row by row; only the lower triangle is read.
    ///
    /// A pivot counts as positive above `8 n ε A_ii`, so a matrix that is singular to working precision is
    /// refused instead of answered with noise. Right-looking in panels of 48 columns, n³/6 multiply-adds.
    ///
    /// # Errors
    /// [`NotPositiveDefinite`] with the row where the elimination stopped; a NaN stops it too.
    ///
    /// # Panics
    /// If `data` does not hold n² entries.
    pub fn factor(n: usize, data: Vec<f64>) -> Result<Self, NotPositiveDefinite> {
        assert_eq!(data.len(), n * n, "a square matrix of {n} rows has {} entries", n * n);
        let mut lower = data;
        let smallest_pivot: Vec<f64> =
            (0..n).map(|i| 8.0 * n as f64 * f64::EPSILON * lower[i * n + i].abs()).collect();
        let mut transposed = Vec::new();
        for start in (0..n).step_by(PANEL) {
            let end = (start + PANEL).min(n);
            factor_panel(&mut lower, n, start..end, &smallest_pivot)?;
            transpose_panel(&lower, n, start..end, &mut transposed);
            update_trailing(&mut lower, n, start..end, &transposed);
        }
        Ok(Self { n, lower })
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
        let n = self.n;
        assert_eq!(b.len(), n, "right-hand side");
        for i in 0..n {
            let row = &self.lower[i * n..=i * n + i];
            b[i] = (b[i] - dot(&row[..i], &b[..i])) / row[i];
        }
        for i in (0..n).rev() {
            let row = &self.lower[i * n..=i * n + i];
            let (head, tail) = b.split_at_mut(i);
            tail[0] /= row[i];
            subtract_multiple(head, tail[0], &row[..i]);
        }
    }
}

/// Eliminates the panel's columns from the panel's own rows and all rows below it.
fn factor_panel(
    lower: &mut [f64],
    n: usize,
    panel: std::ops::Range<usize>,
    smallest_pivot: &[f64],
) -> Result<(), NotPositiveDefinite> {
    for i in panel.start..n {
        let (above, rest) = lower.split_at_mut(i * n);
        let row = &mut rest[..n];
        for j in panel.start..panel.end.min(i) {
            let pivot_row = &above[j * n..j * n + n];
            let sum = dot(&row[panel.start..j], &pivot_row[panel.start..j]);
            row[j] = (row[j] - sum) / pivot_row[j];
        }
        if i < panel.end {
            let known = &row[panel.start..i];
            let pivot = row[i] - dot(known, known);
            if pivot > smallest_pivot[i] {
                row[i] = pivot.sqrt();
            } else {
                return Err(NotPositiveDefinite { index: i });
            }
        }
    }
    Ok(())
}

/// Copies the panel below its triangle so that each of its columns becomes a contiguous row.
fn transpose_panel(lower: &[f64], n: usize, panel: std::ops::Range<usize>, out: &mut Vec<f64>) {
    let below = n - panel.end;
    out.clear();
    out.resize(panel.len() * below, 0.0);
    for i in 0..below {
        let row = &lower[(panel.end + i) * n..][panel.clone()];
        for (p, &value) in row.iter().enumerate() {
            out[p * below + i] = value;
        }
    }
}

/// Subtracts the panel's outer product from the lower triangle that is still to be factorized.
fn update_trailing(lower: &mut [f64], n: usize, panel: std::ops::Range<usize>, transposed: &[f64]) {
    let below = n - panel.end;
    if below == 0 {
        return;
    }
    for i in 0..below {
        let row = &mut lower[(panel.end + i) * n..][..n];
        let (left, right) = row.split_at_mut(panel.end);
        let factors = &left[panel.clone()];
        let target = &mut right[..=i];
        let mut quads = factors.chunks_exact(4);
        let mut columns = transposed.chunks_exact(4 * below);
        for (quad, block) in quads.by_ref().zip(columns.by_ref()) {
            let (c0, rest) = block.split_at(below);
            let (c1, rest) = rest.split_at(below);
            let (c2, c3) = rest.split_at(below);
            for ((((t, a0), a1), a2), a3) in target.iter_mut().zip(c0).zip(c1).zip(c2).zip(c3) {
                *t -= quad[0] * a0 + quad[1] * a1 + quad[2] * a2 + quad[3] * a3;
            }
        }
        for (&factor, column) in quads.remainder().iter().zip(columns.remainder().chunks_exact(below)) {
            subtract_multiple(target, factor, &column[..=i]);
        }
    }
}

/// `y -= factor x`
fn subtract_multiple(y: &mut [f64], factor: f64, x: &[f64]) {
    for (left, right) in y.iter_mut().zip(x) {
        *left -= factor * right;
    }
}

/// Dot product in four interleaved sums, which lets the compiler use vector registers.
fn dot(x: &[f64], y: &[f64]) -> f64 {
    let (mut x4, mut y4) = (x.chunks_exact(4), y.chunks_exact(4));
    let mut sums = [0.0; 4];
    for (p, q) in x4.by_ref().zip(y4.by_ref()) {
        for lane in 0..4 {
            sums[lane] += p[lane] * q[lane];
        }
    }
    let tail: f64 = x4.remainder().iter().zip(y4.remainder()).map(|(p, q)| p * q).sum();
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + tail
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Exponential kernel: positive definite, every entry different from zero.
    fn kernel(n: usize) -> SymmetricMatrix {
        SymmetricMatrix::from_fn(n, |i, j| (-0.3 * (i as f64 - j as f64).abs()).exp())
    }

    #[test]
    fn solves_at_sizes_around_the_panel_width() {
        for n in [0, 1, 2, 3, 4, 47, 48, 49, 95, 97, 150] {
            let a = kernel(n);
            let expected: Vec<f64> = (0..n).map(|i| (i as f64).sin() + 0.5).collect();
            let mut x: Vec<f64> =
                (0..n).map(|i| a.row(i).iter().zip(&expected).map(|(p, q)| p * q).sum()).collect();
            let factor = DenseCholesky::factor(n, a.as_slice().to_vec()).unwrap();
            factor.solve_in_place(&mut x);
            assert_eq!((factor.len(), factor.is_empty()), (n, n == 0));
            for (left, right) in x.iter().zip(&expected) {
                assert!((left - right).abs() < 1e-12, "n = {n}: {left} {right}");
            }
        }
    }

    #[test]
    fn reads_the_lower_triangle_only() {
        let a = kernel(60);
        let mut spoiled = a.as_slice().to_vec();
        for i in 0..60 {
            for j in i + 1..60 {
                spoiled[i * 60 + j] = f64::NAN;
            }
        }
        let mut x = vec![1.0; 60];
        DenseCholesky::factor(60, spoiled).unwrap().solve_in_place(&mut x);
        assert!(x.iter().all(|value| value.is_finite()));
    }

    #[test]
    fn refuses_what_is_not_positive_definite() {
        let index = |n, data| DenseCholesky::factor(n, data).unwrap_err().index;
        assert_eq!(index(2, vec![1.0, 2.0, 2.0, 1.0]), 1);
        assert_eq!(index(2, vec![1.0, 1.0, 1.0, 1.0]), 1);
        assert_eq!(index(1, vec![0.0]), 0);
        assert_eq!(index(1, vec![f64::NAN]), 0);
        assert_eq!(index(1, vec![f64::INFINITY]), 0);
        let mut late = kernel(100).as_slice().to_vec();
        late[77 * 100 + 77] = -1.0;
        assert_eq!(index(100, late), 77);
    }

    #[test]
    fn symmetric_matrix_stays_symmetric() {
        let mut a = SymmetricMatrix::from_full(2, vec![1.0, 2.0, 4.0, 5.0]).unwrap();
        assert_eq!((a[(0, 1)], a[(1, 0)]), (3.0, 3.0));
        a.add(&SymmetricMatrix::from_fn(2, |i, j| (i + j) as f64)).unwrap();
        assert_eq!(a.as_slice(), [1.0, 4.0, 4.0, 7.0]);
        assert_eq!(a.principal_block(&[1]), [7.0]);
        assert_eq!(a.add(&SymmetricMatrix::zeros(3)), Err(SizeMismatch { expected: 2, found: 3 }));
        assert!(SymmetricMatrix::from_full(2, vec![0.0; 3]).is_err());
        assert!(SymmetricMatrix::zeros(0).is_empty());
    }
}
