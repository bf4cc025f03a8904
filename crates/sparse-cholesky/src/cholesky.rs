//! Sparse Cholesky factorization and solves over parts of the factor.
//!
//! The matrix is numbered in elimination order ([`super::EliminationOrder`]): positions in a
//! vector are positions in the factor, without a permutation.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::FactorizationError;
use super::factorization::{factorize, outdated_supernodes};
use super::symbolic::{Reach, Supernode, SymbolicCholesky};
use dense_cholesky::{SymmetricMatrix, dot, inverse_of_factor, simd_dispatch};

/// The factor `L` of `A = L Lᵀ`.
#[derive(Debug, Clone)]
pub struct Cholesky {
    symbolic: Arc<SymbolicCholesky>,
    values: Vec<f64>,
    /// Lower-triangle values of the factorized matrix; empty without a matrix.
    matrix: Vec<f64>,
}

impl Cholesky {
    /// Factorizes the matrix with the given lower-triangle values, in the order of its pattern.
    ///
    /// # Errors
    /// [`FactorizationError`] if an entry is not finite or a pivot not positive.
    pub fn factor(
        symbolic: &Arc<SymbolicCholesky>,
        values: &[f64],
    ) -> Result<Self, FactorizationError> {
        let mut factor = Self::empty(symbolic);
        factor.refactor(values.to_vec(), &mut || ControlFlow::Continue(()))?;
        Ok(factor)
    }

    /// Makes an empty factor, without a matrix.
    pub fn empty(symbolic: &Arc<SymbolicCholesky>) -> Self {
        Self { symbolic: Arc::clone(symbolic), values: Vec::new(), matrix: Vec::new() }
    }

    /// Factorizes another matrix of the same pattern. Asks `checkpoint` every few milliseconds
    /// whether to continue. After an error the factor is empty.
    ///
    /// A supernode is recomputed only if an entry of the matrix has changed in its columns or in
    /// the columns of a descendant in the elimination tree. The values are bit for bit those of
    /// [`Self::factor`].
    ///
    /// # Errors
    /// As [`Self::factor`], and [`FactorizationError::Stopped`].
    pub fn refactor(
        &mut self,
        values: Vec<f64>,
        checkpoint: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<(), FactorizationError> {
        let previous = std::mem::take(&mut self.matrix);
        if values.iter().any(|v| !v.is_finite()) {
            return Err(FactorizationError::NotFinite);
        }
        let outdated = if previous.is_empty() {
            self.values.clear();
            None
        } else {
            Some(outdated_supernodes(&self.symbolic, &previous, &values))
        };
        factorize(&self.symbolic, &values, &mut self.values, outdated.as_deref(), checkpoint)?;
        self.matrix = values;
        Ok(())
    }

    /// Empties the factor, so that the next matrix is factorized completely.
    pub fn invalidate(&mut self) {
        self.matrix.clear();
    }

    /// Structure of the factor.
    pub fn symbolic(&self) -> &Arc<SymbolicCholesky> {
        &self.symbolic
    }

    /// Bytes held by the factor and its matrix.
    pub fn bytes(&self) -> usize {
        size_of_val(self.values.as_slice()) + size_of_val(self.matrix.as_slice())
    }

    /// Solves `A x = b` in place. Cost: every entry of `L` twice.
    pub fn solve(&self, x: &mut [f64]) {
        self.solve_restricted(&self.symbolic.full_reach(), x);
    }

    /// Solves `A x = b` in place for right-hand sides and wanted entries that both lie in the
    /// reach.
    ///
    /// Entries outside the reach stay unchanged. The entries on the reach are bit for bit those of
    /// a full solve.
    pub fn solve_restricted(&self, reach: &Reach, x: &mut [f64]) {
        self.forward(reach, x);
        self.backward(reach, x);
    }

    /// Overwrites `x` by `L⁻¹ x` on the reach.
    pub fn forward(&self, reach: &Reach, x: &mut [f64]) {
        let mut below = Vec::new();
        simd_dispatch(|| {
            for &s in reach.supernodes() {
                forward_panel(self.panel(s), x, &mut below);
            }
        });
    }

    /// Overwrites `x` by `L⁻ᵀ x` on the reach.
    ///
    /// Back substitution visits the panels from last to first, a slow order for memory. So each
    /// group of panels that fits the cache is read once forward before its use.
    pub fn backward(&self, reach: &Reach, x: &mut [f64]) {
        let mut below = Vec::new();
        let mut rest = reach.supernodes();
        let offsets = self.symbolic.value_offsets();
        simd_dispatch(|| {
            while let Some(&last) = rest.last() {
                let end = offsets[last as usize + 1] as usize;
                let first = rest
                    .partition_point(|&s| offsets[s as usize] as usize + GROUP < end)
                    .min(rest.len() - 1);
                let (before, group) = rest.split_at(first);
                if self.values.len() > CACHED {
                    for &s in group {
                        touch(self.panel(s).1);
                    }
                }
                for &s in group.iter().rev() {
                    backward_panel(self.panel(s), x, &mut below);
                }
                rest = before;
            }
        });
    }

    /// The last `count` rows and columns of `A⁻¹`.
    ///
    /// With `L_cc` the last diagonal block of `L`, it is `YᵀY` where `L_cc Y = I`. Cost
    /// `O(count³)`.
    pub fn trailing_inverse(&self, count: usize) -> SymmetricMatrix {
        let first = self.symbolic.order() - count;
        // Column-major lower triangle of L_cc.
        let mut block = vec![0.0; count * count];
        for &s in self.symbolic.trailing_reach(count).supernodes() {
            let (node, panel) = self.panel(s);
            for (c, column) in panel.chunks_exact(node.height()).enumerate() {
                let Some(target) = (node.columns.start + c).checked_sub(first) else { continue };
                let own_rows = node.columns.start + c..node.columns.end;
                let below = node.rows.iter().map(|&r| r as usize);
                for (row, l) in own_rows.chain(below).zip(&column[c..]) {
                    block[target * count + row - first] = *l;
                }
            }
        }
        inverse_of_factor(&block, count)
    }

    /// A supernode and its panel, column-major.
    fn panel(&self, s: u32) -> (Supernode<'_>, &[f64]) {
        let node = self.symbolic.supernode(s as usize);
        let values = &self.values[node.values.clone()];
        (node, values)
    }
}

/// Forward substitution with one panel. The contributions of its columns to the rows below are
/// summed in `below` and scattered once.
#[inline(always)]
fn forward_panel((node, panel): (Supernode<'_>, &[f64]), x: &mut [f64], below: &mut Vec<f64>) {
    below.clear();
    below.resize(node.rows.len(), 0.0);
    for (c, column) in panel.chunks_exact(node.height()).enumerate() {
        let (diagonal, lower) = column[c..].split_at(node.columns.len() - c);
        let own = &mut x[node.columns.start + c..node.columns.end];
        let pivot = own[0] / diagonal[0];
        own[0] = pivot;
        for (y, l) in own[1..].iter_mut().zip(&diagonal[1..]) {
            *y -= pivot * l;
        }
        for (y, l) in below.iter_mut().zip(lower) {
            *y += pivot * l;
        }
    }
    for (&row, y) in node.rows.iter().zip(below.iter()) {
        x[row as usize] -= y;
    }
}

/// Entries of a factor that stays in the cache between two solves.
const CACHED: usize = 1 << 20;
/// Entries of the panels in a group.
const GROUP: usize = 1 << 15;

/// Brings values into the cache.
#[inline(always)]
fn touch(values: &[f64]) {
    let sum: f64 = values.iter().step_by(8).sum();
    std::hint::black_box(sum);
}

/// Back substitution with one panel.
#[inline(always)]
fn backward_panel((node, panel): (Supernode<'_>, &[f64]), x: &mut [f64], below: &mut Vec<f64>) {
    below.clear();
    below.extend(node.rows.iter().map(|&row| x[row as usize]));
    for (c, column) in panel.chunks_exact(node.height()).enumerate().rev() {
        let (diagonal, lower) = column[c..].split_at(node.columns.len() - c);
        let own = &mut x[node.columns.start + c..node.columns.end];
        let sum = own[0] - dot(&own[1..], &diagonal[1..]) - dot(below, lower);
        own[0] = sum / diagonal[0];
    }
}
