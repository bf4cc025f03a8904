//! The numbers of a sparse Cholesky factor, supernode by supernode.
//!
//! Left-looking: a supernode takes its columns of A, subtracts what every earlier supernode that has rows among them
//! contributes, `L_d[rows of s and below] · L_d[rows of s]ᵀ`, and is then factorized as a dense block. Each finished
//! supernode waits in the list of the one that owns its next row; so the contributors are at hand without search.
//!
//! # Reference
//! E. G. Ng, B. W. Peyton, *Block sparse Cholesky algorithms on advanced uniprocessor computers*, SIAM J. Sci. Comput. 14
//! (1993) 1034–1056.

#![expect(clippy::cast_possible_truncation, reason = "there are fewer than 2^32 equations")]

use std::ops::ControlFlow;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{
    LltError, LltRegularization, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Accum, MatMut, MatRef, Par, Spec};

use super::cholesky::{FactorizationError, SymbolicCholesky};

/// Multiplications between two questions whether to go on; some milliseconds.
const WORK_BETWEEN_CHECKPOINTS: usize = 1 << 28;
/// End of a list.
const NONE: u32 = u32::MAX;

/// Factorizes the matrix with the given lower-triangle values into `factor`, whatever that holds. What lies above the
/// diagonal in the panels is of no meaning. Asks `checkpoint` now and then whether to go on.
pub(super) fn factorize(
    symbolic: &SymbolicCholesky,
    matrix: &[f64],
    factor: &mut Vec<f64>,
    checkpoint: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<(), FactorizationError> {
    let count = symbolic.supernode_count();
    factor.clear();
    factor.try_reserve_exact(symbolic.factor_entries()).map_err(|_| FactorizationError::TooLarge)?;
    let mut workspace = Workspace::new(symbolic)?;
    // First contributor of each supernode, next one in the same list, and how many of its rows a contributor has given.
    let (mut first, mut next) = (vec![NONE; count], vec![NONE; count]);
    let mut given = vec![0u32; count];
    let mut work = 0;
    for s in 0..count {
        let node = symbolic.supernode(s);
        // Zeros for this panel alone, so that they are still in the cache when it is filled.
        factor.resize(node.values.end, 0.0);
        let (finished, panel) = factor.split_at_mut(node.values.start);
        workspace.locate(&node);
        workspace.scatter(symbolic, matrix, &node, panel);
        let mut contributor = first[s];
        while contributor != NONE {
            let d = contributor as usize;
            contributor = next[d];
            let source = symbolic.supernode(d);
            let begin = given[d] as usize;
            let end = begin + source.rows[begin..].partition_point(|&row| (row as usize) < node.columns.end);
            let contribution =
                Contribution { values: &finished[source.values.clone()], node: source, begin, end };
            work += contribution.work();
            workspace.subtract(&contribution, &node, panel);
            given[d] = end as u32;
            if let Some(&row) = contribution.node.rows.get(end) {
                let owner = symbolic.supernode_of(row);
                (next[d], first[owner]) = (first[owner], d as u32);
            }
        }
        work += node.columns.len() * node.height() * node.height();
        workspace.factorize(&node, panel)?;
        if let Some(&row) = node.rows.first() {
            let owner = symbolic.supernode_of(row);
            (next[s], first[owner]) = (first[owner], s as u32);
        }
        if work > WORK_BETWEEN_CHECKPOINTS {
            work = 0;
            if checkpoint().is_break() {
                return Err(FactorizationError::Stopped);
            }
        }
    }
    Ok(())
}

/// Columns of the factor that share one set of rows below.
pub(super) struct Supernode<'a> {
    pub columns: std::ops::Range<usize>,
    /// Rows below its diagonal block.
    pub rows: &'a [u32],
    /// Where its panel lies among the values of the factor.
    pub values: std::ops::Range<usize>,
}

impl Supernode<'_> {
    fn height(&self) -> usize {
        self.columns.len() + self.rows.len()
    }
}

/// What the rows `[begin, end)` of one supernode make it contribute to the supernode that owns them.
struct Contribution<'a> {
    node: Supernode<'a>,
    values: &'a [f64],
    begin: usize,
    end: usize,
}

impl Contribution<'_> {
    fn work(&self) -> usize {
        (self.node.rows.len() - self.begin) * (self.end - self.begin) * self.node.columns.len()
    }
}

/// Rows of a contribution that follow each other in the panel that they go to.
#[derive(Clone, Copy)]
struct Run {
    from: usize,
    to: usize,
    len: usize,
}

/// What is needed on the way.
struct Workspace {
    /// Place of a row in the present panel.
    place: Vec<u32>,
    product: Vec<f64>,
    runs: Vec<Run>,
    memory: MemBuffer,
}

impl Workspace {
    fn new(symbolic: &SymbolicCholesky) -> Result<Self, FactorizationError> {
        let widest = (0..symbolic.supernode_count()).map(|s| symbolic.supernode(s).columns.len()).max();
        let request = cholesky_in_place_scratch::<f64>(widest.unwrap_or(0), Par::Seq, Spec::default());
        let memory = MemBuffer::try_new(request).map_err(|_| FactorizationError::TooLarge)?;
        Ok(Self { place: vec![0; symbolic.order()], product: Vec::new(), runs: Vec::new(), memory })
    }

    fn locate(&mut self, node: &Supernode<'_>) {
        let below = node.rows.iter().map(|&row| row as usize);
        for (place, row) in (0u32..).zip(node.columns.clone().chain(below)) {
            self.place[row] = place;
        }
    }

    /// The columns of the matrix.
    fn scatter(&self, symbolic: &SymbolicCholesky, matrix: &[f64], node: &Supernode<'_>, panel: &mut [f64]) {
        let pattern = symbolic.pattern();
        for (column, target) in node.columns.clone().zip(panel.chunks_exact_mut(node.height())) {
            let rows = pattern.column(column);
            let values = &matrix[pattern.column_start(column)..];
            for (&row, value) in rows.iter().zip(values) {
                target[self.place[row as usize] as usize] = *value;
            }
        }
    }

    fn subtract(&mut self, contribution: &Contribution<'_>, node: &Supernode<'_>, panel: &mut [f64]) {
        let Contribution { node: source, values, begin, end } = contribution;
        let (width, height) = (source.columns.len(), source.height());
        let rows = &source.rows[*begin..];
        let (m, k) = (rows.len(), end - begin);
        let all = MatRef::from_column_major_slice(values, height, width).subrows(width + begin, m);
        if self.product.len() < m * k {
            self.product.resize(m * k, 0.0);
        }
        let product = &mut self.product[..m * k];
        let target = MatMut::from_column_major_slice_mut(product, m, k);
        matmul(target, Accum::Replace, all, all.subrows(0, k).transpose(), 1.0, Par::Seq);
        self.runs.clear();
        for (k, &row) in rows.iter().enumerate() {
            let place = self.place[row as usize] as usize;
            match self.runs.last_mut() {
                Some(run) if run.to + run.len == place => run.len += 1,
                _ => self.runs.push(Run { from: k, to: place, len: 1 }),
            }
        }
        for (column, &row) in product.chunks_exact(m).zip(rows) {
            let target = (row as usize - node.columns.start) * node.height();
            let target = &mut panel[target..target + node.height()];
            for &Run { from, to, len } in &self.runs {
                for (entry, value) in target[to..to + len].iter_mut().zip(&column[from..from + len]) {
                    *entry -= value;
                }
            }
        }
    }

    /// Turns a panel of the Schur complement into one of the factor.
    fn factorize(&mut self, node: &Supernode<'_>, panel: &mut [f64]) -> Result<(), FactorizationError> {
        let width = node.columns.len();
        let panel = MatMut::from_column_major_slice_mut(panel, node.height(), width);
        let (mut diagonal, below) = panel.split_at_row_mut(width);
        let stack = MemStack::new(&mut self.memory);
        let regularization = LltRegularization::default();
        cholesky_in_place(diagonal.as_mut(), regularization, Par::Seq, stack, Spec::default()).map_err(
            |LltError::NonPositivePivot { index }| FactorizationError::NotPositiveDefinite {
                equation: node.columns.start + index,
            },
        )?;
        solve_lower_triangular_in_place(diagonal.as_ref(), below.transpose_mut(), Par::Seq);
        Ok(())
    }
}
