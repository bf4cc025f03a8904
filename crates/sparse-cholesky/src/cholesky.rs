//! Sparse Cholesky factorization and solves over parts of the factor.
//!
//! The matrix comes already numbered in elimination order ([`super::EliminationOrder`]), so positions in a
//! vector are positions in the factor and no permutation happens here. The columns of `L` are grouped into
//! supernodes: runs of columns `[start, end)` with one common set of rows below, stored as a dense
//! column-major panel whose first `end - start` rows are the diagonal block.

#![expect(
    clippy::cast_possible_truncation,
    reason = "equations are numbered by u32, so that there are fewer than 2^32 of them"
)]

use std::ops::{ControlFlow, Range};
use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::SymbolicSupernodalParams;
use faer::sparse::linalg::cholesky::{simplicial, supernodal};
use thiserror::Error;

use super::cores::Cores;
use super::dense::SymmetricMatrix;
use super::factorization::{factorize, outdated};
use super::panel::Supernode;
use super::{SymmetricPattern, dot, wide};

/// Why a matrix has no Cholesky factor.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FactorizationError {
    /// An entry is NaN or infinite.
    #[error("the matrix has an entry that is not finite")]
    NotFinite,
    /// A pivot is not positive: the matrix is singular or indefinite.
    #[error("the matrix is not positive definite at equation {equation}")]
    NotPositiveDefinite {
        /// Position in elimination order.
        equation: usize,
    },
    /// The caller wanted no more of it.
    #[error("the factorization was stopped")]
    Stopped,
    /// The factor has more entries than can be indexed, or memory is short.
    #[error("the factor is too large")]
    TooLarge,
}

/// Structure of the factor, shared by all matrices of one pattern.
#[derive(Debug)]
pub struct SymbolicCholesky {
    pattern: SymmetricPattern,
    structure: supernodal::SymbolicSupernodalCholesky<u32>,
    /// Parent of each supernode in the elimination tree; the root is its own.
    parent: Vec<usize>,
    /// Supernode of each column.
    supernode_of: Vec<u32>,
}

impl SymbolicCholesky {
    /// Analyses a pattern. Cost about `O(entries of L / width of a supernode)`.
    ///
    /// # Errors
    /// [`FactorizationError::TooLarge`].
    pub fn new(pattern: SymmetricPattern) -> Result<Arc<Self>, FactorizationError> {
        let n = pattern.order();
        let (offsets, columns) = pattern.transposed();
        let upper = SymbolicSparseColMatRef::new_checked(n, n, &offsets, None, &columns);
        let too_large = |_| FactorizationError::TooLarge;
        let request = simplicial::prefactorize_symbolic_cholesky_scratch::<u32>(n, columns.len())
            .or(supernodal::factorize_supernodal_symbolic_cholesky_scratch::<u32>(n));
        let mut memory = MemBuffer::try_new(request).map_err(|_| FactorizationError::TooLarge)?;
        let (mut tree, mut column_counts) = (vec![0i32; n], vec![0u32; n]);
        let tree = simplicial::prefactorize_symbolic_cholesky(
            &mut tree,
            &mut column_counts,
            upper,
            MemStack::new(&mut memory),
        );
        let structure = supernodal::factorize_supernodal_symbolic_cholesky(
            upper,
            tree,
            &column_counts,
            MemStack::new(&mut memory),
            SymbolicSupernodalParams::default(),
        )
        .map_err(too_large)?;
        let mut supernode_of = vec![0u32; n];
        for s in 0..structure.n_supernodes() {
            for column in columns_of(&structure, s) {
                supernode_of[column] = s as u32;
            }
        }
        let parent = (0..structure.n_supernodes())
            .map(|s| {
                structure.supernode(s).pattern().first().map_or(s, |&r| supernode_of[r as usize] as usize)
            })
            .collect();
        Ok(Arc::new(Self { pattern, structure, parent, supernode_of }))
    }

    /// Order of the matrix.
    pub fn order(&self) -> usize {
        self.pattern.order()
    }

    /// Pattern of the matrix.
    pub fn pattern(&self) -> &SymmetricPattern {
        &self.pattern
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let structure = &self.structure;
        let offsets = [structure.col_ptr_for_row_idx(), structure.col_ptr_for_val()];
        let columns = [structure.supernode_begin(), structure.supernode_end(), &self.supernode_of];
        let lists = offsets.iter().chain(&columns).map(|list| size_of_val(*list)).sum::<usize>();
        self.pattern.bytes() + lists + size_of_val(structure.row_idx()) + size_of_val(self.parent.as_slice())
    }

    /// Entries stored for the factor, those that panels store in vain included.
    pub fn factor_entries(&self) -> usize {
        self.structure.len_val()
    }

    /// The supernodes that a solve touches when its right-hand side and its wanted entries both lie in
    /// `equations`: theirs and all ancestors of those.
    pub fn reach(&self, equations: &[u32]) -> Reach {
        let mut touched = vec![false; self.parent.len()];
        for &equation in equations {
            let mut s = self.supernode_of[equation as usize] as usize;
            while !touched[s] {
                touched[s] = true;
                s = self.parent[s];
            }
        }
        Reach { supernodes: (0u32..).zip(&touched).filter(|(_, t)| **t).map(|(s, _)| s).collect() }
    }

    /// The supernodes that hold the last `count` equations.
    pub fn trailing_reach(&self, count: usize) -> Reach {
        let first = self.supernode_of[self.order() - count.clamp(1, self.order())];
        Reach { supernodes: (first..self.parent.len() as u32).collect() }
    }

    pub(super) fn supernode_count(&self) -> usize {
        self.parent.len()
    }

    pub(super) fn supernode(&self, s: usize) -> Supernode<'_> {
        let offsets = self.structure.col_ptr_for_val();
        Supernode {
            columns: columns_of(&self.structure, s),
            rows: self.structure.supernode(s).pattern(),
            values: offsets[s] as usize..offsets[s + 1] as usize,
        }
    }

    /// The supernode above one in the elimination tree; the root is its own.
    pub(super) fn parent(&self, s: usize) -> usize {
        self.parent[s]
    }

    /// The supernode that holds an equation.
    pub(super) fn supernode_of(&self, equation: u32) -> usize {
        self.supernode_of[equation as usize] as usize
    }

    /// All supernodes: a reach for ordinary solves.
    pub fn full_reach(&self) -> Reach {
        Reach { supernodes: (0..self.parent.len() as u32).collect() }
    }
}

/// A set of supernodes closed under ascent in the elimination tree, in elimination order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reach {
    supernodes: Vec<u32>,
}

fn columns_of(structure: &supernodal::SymbolicSupernodalCholesky<u32>, s: usize) -> Range<usize> {
    structure.supernode_begin()[s] as usize..structure.supernode_end()[s] as usize
}

/// The factor `L` of `A = L Lᵀ`.
#[derive(Debug, Clone)]
pub struct Cholesky {
    symbolic: Arc<SymbolicCholesky>,
    values: Vec<f64>,
    /// Lower-triangle values of the matrix that this is the factor of; empty if of none.
    matrix: Vec<f64>,
}

impl Cholesky {
    /// Factorizes the matrix with the given lower-triangle values, in the order of its pattern.
    ///
    /// # Errors
    /// [`FactorizationError`] if an entry is not finite or a pivot not positive.
    pub fn factor(symbolic: &Arc<SymbolicCholesky>, values: &[f64]) -> Result<Self, FactorizationError> {
        let mut factor = Self::empty(symbolic);
        factor.refactor(values.to_vec(), None, &mut || ControlFlow::Continue(()))?;
        Ok(factor)
    }

    /// The factor of no matrix yet.
    pub fn empty(symbolic: &Arc<SymbolicCholesky>) -> Self {
        Self { symbolic: Arc::clone(symbolic), values: Vec::new(), matrix: Vec::new() }
    }

    /// Becomes the factor of another matrix of the same pattern; asks `checkpoint` every few milliseconds whether to go
    /// on. After an error it is the factor of none.
    ///
    /// Where two matrices are equal, so are their factors, up to the first column that differs on each branch of the
    /// elimination tree; what is known from the last matrix stays. So the cost is that of the part that has changed and
    /// of what lies above it, and the factor is bit for bit that of a fresh start.
    ///
    /// Runs on the calling thread and, if it is large, on `cores` that are idle. The bits do not depend on them.
    ///
    /// # Errors
    /// As [`Self::factor`], and [`FactorizationError::Stopped`].
    pub fn refactor(
        &mut self,
        values: Vec<f64>,
        cores: Option<&Cores>,
        checkpoint: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<(), FactorizationError> {
        let former = std::mem::take(&mut self.matrix);
        if values.iter().any(|v| !v.is_finite()) {
            return Err(FactorizationError::NotFinite);
        }
        let outdated = if former.is_empty() {
            self.values.clear();
            Vec::new()
        } else {
            outdated(&self.symbolic, &former, &values)
        };
        factorize(&self.symbolic, &values, &mut self.values, &outdated, cores, checkpoint)?;
        self.matrix = values;
        Ok(())
    }

    /// Becomes the factor of no matrix, so that the next one is factorized whole.
    pub fn forget(&mut self) {
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

    /// Solves `A x = b` in place for right-hand sides and wanted entries that both lie in the reach.
    ///
    /// Entries outside the reach are left as they were. What it writes is bit for bit what a full solve would.
    pub fn solve_restricted(&self, reach: &Reach, x: &mut [f64]) {
        self.forward(reach, x);
        self.backward(reach, x);
    }

    /// Overwrites `x` by `L⁻¹ x` on the reach.
    pub fn forward(&self, reach: &Reach, x: &mut [f64]) {
        let mut below = Vec::new();
        wide(|| {
            for &s in &reach.supernodes {
                forward_panel(&self.panel(s as usize), x, &mut below);
            }
        });
    }

    /// Overwrites `x` by `L⁻ᵀ x` on the reach.
    ///
    /// The panels come from last to first, which memory is slow at. So they are taken in groups that fit the cache, and
    /// each group is read once forward before it is used.
    pub fn backward(&self, reach: &Reach, x: &mut [f64]) {
        let mut below = Vec::new();
        let mut rest = reach.supernodes.as_slice();
        let offsets = self.symbolic.structure.col_ptr_for_val();
        wide(|| {
            while let Some(&last) = rest.last() {
                let end = offsets[last as usize + 1] as usize;
                let first =
                    rest.partition_point(|&s| offsets[s as usize] as usize + GROUP < end).min(rest.len() - 1);
                let (before, group) = rest.split_at(first);
                if self.values.len() > CACHED {
                    for &s in group {
                        touch(self.panel(s as usize).values);
                    }
                }
                for &s in group.iter().rev() {
                    backward_panel(&self.panel(s as usize), x, &mut below);
                }
                rest = before;
            }
        });
    }

    /// The last `count` rows and columns of `A⁻¹`.
    ///
    /// With `L_cc` the last diagonal block of `L`, it is `YᵀY` where `L_cc Y = I`. Cost `O(count³)`.
    pub fn trailing_inverse(&self, count: usize) -> SymmetricMatrix {
        let first = self.symbolic.order() - count;
        // Column-major lower triangle of L_cc.
        let mut block = vec![0.0; count * count];
        for &s in &self.symbolic.trailing_reach(count).supernodes {
            let panel = self.panel(s as usize);
            for (c, column) in panel.values.chunks_exact(panel.height()).enumerate() {
                let Some(target) = (panel.start + c).checked_sub(first) else { continue };
                let own_rows = panel.start + c..panel.start + panel.width;
                let below = panel.rows.iter().map(|&r| r as usize);
                for (row, l) in own_rows.chain(below).zip(&column[c..]) {
                    block[target * count + row - first] = *l;
                }
            }
        }
        // Y by forward substitution, column k of Y being zero above its diagonal.
        let mut y = vec![0.0; count * count];
        for (k, column) in y.chunks_exact_mut(count).enumerate() {
            column[k] = 1.0;
            for j in k..count {
                let l = &block[j * count + j..(j + 1) * count];
                let pivot = column[j] / l[0];
                column[j] = pivot;
                for (v, l) in column[j + 1..].iter_mut().zip(&l[1..]) {
                    *v -= pivot * l;
                }
            }
        }
        let y_column = |k: usize| &y[k * count..(k + 1) * count];
        SymmetricMatrix::from_fn(count, |i, j| {
            let from = i.max(j);
            dot(&y_column(i)[from..], &y_column(j)[from..])
        })
    }

    fn panel(&self, s: usize) -> Panel<'_> {
        let Supernode { columns, rows, values } = self.symbolic.supernode(s);
        Panel { start: columns.start, width: columns.len(), rows, values: &self.values[values] }
    }
}

/// Columns `[start, start + width)` of `L`: a dense column-major block over the rows of the diagonal block
/// followed by `rows`.
struct Panel<'a> {
    start: usize,
    width: usize,
    rows: &'a [u32],
    values: &'a [f64],
}

impl Panel<'_> {
    fn height(&self) -> usize {
        self.width + self.rows.len()
    }
}

/// Forward substitution with one panel. What its columns take off the rows below is summed in `below` first and
/// scattered once.
#[inline(always)]
fn forward_panel(panel: &Panel<'_>, x: &mut [f64], below: &mut Vec<f64>) {
    below.clear();
    below.resize(panel.rows.len(), 0.0);
    for (c, column) in panel.values.chunks_exact(panel.height()).enumerate() {
        let (diagonal, lower) = column[c..].split_at(panel.width - c);
        let own = &mut x[panel.start + c..panel.start + panel.width];
        let pivot = own[0] / diagonal[0];
        own[0] = pivot;
        for (y, l) in own[1..].iter_mut().zip(&diagonal[1..]) {
            *y -= pivot * l;
        }
        for (y, l) in below.iter_mut().zip(lower) {
            *y += pivot * l;
        }
    }
    for (&row, y) in panel.rows.iter().zip(below.iter()) {
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
fn backward_panel(panel: &Panel<'_>, x: &mut [f64], below: &mut Vec<f64>) {
    below.clear();
    below.extend(panel.rows.iter().map(|&row| x[row as usize]));
    for (c, column) in panel.values.chunks_exact(panel.height()).enumerate().rev() {
        let (diagonal, lower) = column[c..].split_at(panel.width - c);
        let own = &mut x[panel.start + c..panel.start + panel.width];
        let sum = own[0] - dot(&own[1..], &diagonal[1..]) - dot(below, lower);
        own[0] = sum / diagonal[0];
    }
}
