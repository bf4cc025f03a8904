//! Structure of a sparse Cholesky factor: supernodes and their elimination tree.
//!
//! The columns of `L` are grouped into supernodes: runs of columns `[start, end)` with one common
//! set of rows below, stored as a dense column-major panel whose first `end - start` rows are the
//! diagonal block.

#![expect(
    clippy::cast_possible_truncation,
    reason = "equations are numbered by u32, so that there are fewer than 2^32 of them"
)]

use std::ops::Range;
use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::SymbolicSupernodalParams;
use faer::sparse::linalg::cholesky::{simplicial, supernodal};

use super::{FactorizationError, SymmetricPattern};

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
                structure
                    .supernode(s)
                    .pattern()
                    .first()
                    .map_or(s, |&r| supernode_of[r as usize] as usize)
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
        self.pattern.bytes()
            + lists
            + size_of_val(structure.row_idx())
            + size_of_val(self.parent.as_slice())
    }

    /// Entries stored for the factor, including the zeros above the diagonal of each panel's
    /// diagonal block.
    pub fn factor_entries(&self) -> usize {
        self.structure.len_val()
    }

    /// Returns the supernodes that a solve visits if its right-hand side and its wanted entries
    /// lie in `equations`: the supernodes of these equations and all their ancestors.
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
        let offsets = self.value_offsets();
        Supernode {
            columns: columns_of(&self.structure, s),
            rows: self.structure.supernode(s).pattern(),
            values: offsets[s] as usize..offsets[s + 1] as usize,
        }
    }

    /// Where the panel of each supernode begins among the values of the factor, and where the last
    /// one ends.
    pub(super) fn value_offsets(&self) -> &[u32] {
        self.structure.col_ptr_for_val()
    }

    /// Parent of a supernode in the elimination tree; the root is its own.
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

impl Reach {
    pub(super) fn supernodes(&self) -> &[u32] {
        &self.supernodes
    }
}

/// A run of columns of the factor with one common set of rows below its diagonal block. Its panel
/// holds both, column-major.
pub(super) struct Supernode<'a> {
    pub columns: Range<usize>,
    /// Rows below the diagonal block.
    pub rows: &'a [u32],
    /// Where the panel lies among the values of the factor.
    pub values: Range<usize>,
}

impl Supernode<'_> {
    /// Rows of the panel.
    pub fn height(&self) -> usize {
        self.columns.len() + self.rows.len()
    }

    /// Multiplications of its own elimination.
    pub fn work(&self) -> usize {
        self.columns.len() * self.height() * self.height()
    }
}

fn columns_of(structure: &supernodal::SymbolicSupernodalCholesky<u32>, s: usize) -> Range<usize> {
    structure.supernode_begin()[s] as usize..structure.supernode_end()[s] as usize
}
