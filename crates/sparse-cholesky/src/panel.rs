//! One supernode of a Cholesky factor: a dense panel, and what earlier ones take off it.
//!
//! A large panel is made in blocks of rows, which idle cores may share. How it is divided depends on the panel alone, so
//! that its bits do not depend on who was idle.

use std::ops::Range;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{
    LltError, LltRegularization, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Accum, MatMut, MatRef, Par, Spec};

use super::cholesky::{FactorizationError, SymbolicCholesky};
use super::cores::{Cores, share};

/// Multiplications from which a panel is made in blocks; about a millisecond.
const BLOCKWISE: usize = 1 << 24;
/// Blocks of a panel.
const BLOCKS: usize = 4;

/// Columns of the factor that share one set of rows below.
pub(super) struct Supernode<'a> {
    pub columns: Range<usize>,
    /// Rows below its diagonal block.
    pub rows: &'a [u32],
    /// Where its panel lies among the values of the factor.
    pub values: Range<usize>,
}

impl Supernode<'_> {
    pub fn height(&self) -> usize {
        self.columns.len() + self.rows.len()
    }

    /// Multiplications of its own elimination.
    pub fn work(&self) -> usize {
        self.columns.len() * self.height() * self.height()
    }
}

/// What the rows `[begin, end)` of one supernode make it contribute to the supernode that owns them.
pub(super) struct Contribution<'a> {
    /// Its number.
    pub supernode: u32,
    pub node: Supernode<'a>,
    pub values: &'a [f64],
    pub begin: usize,
    pub end: usize,
}

impl Contribution<'_> {
    pub fn work(&self) -> usize {
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

/// Some rows of a panel, from `first` on.
struct Block<'a> {
    first: usize,
    rows: MatMut<'a, f64>,
}

/// What is needed on the way.
pub(super) struct Workspace {
    /// Place of a row in the present panel.
    place: Vec<u32>,
    product: Product,
    memory: MemBuffer,
}

#[derive(Default)]
struct Product {
    values: Vec<f64>,
    runs: Vec<Run>,
}

impl Workspace {
    pub fn new(symbolic: &SymbolicCholesky) -> Self {
        let widest = (0..symbolic.supernode_count()).map(|s| symbolic.supernode(s).columns.len()).max();
        let request = cholesky_in_place_scratch::<f64>(widest.unwrap_or(0), Par::Seq, Spec::default());
        Self {
            place: vec![0; symbolic.order()],
            product: Product::default(),
            memory: MemBuffer::new(request),
        }
    }

    /// Makes a panel, which is zero, one of the factor: the columns of the matrix, less what others contribute, are
    /// factorized.
    pub fn make(
        &mut self,
        symbolic: &SymbolicCholesky,
        matrix: &[f64],
        node: &Supernode<'_>,
        contributions: &[Contribution<'_>],
        panel: &mut [f64],
        cores: Option<&Cores>,
    ) -> Result<(), FactorizationError> {
        self.locate(node);
        self.scatter(symbolic, matrix, node, panel);
        let work = contributions.iter().map(Contribution::work).sum();
        let (place, start) = (&self.place, node.columns.start);
        let subtract = |product: &mut Product, mut block: Block<'_>| {
            for contribution in contributions {
                product.subtract(contribution, place, start, &mut block);
            }
        };
        let all = MatMut::from_column_major_slice_mut(panel, node.height(), node.columns.len());
        in_blocks(work, all, cores, &mut self.product, subtract);
        self.factorize(node, panel, cores)
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

    /// Turns a panel of the Schur complement into one of the factor.
    fn factorize(
        &mut self,
        node: &Supernode<'_>,
        panel: &mut [f64],
        cores: Option<&Cores>,
    ) -> Result<(), FactorizationError> {
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
        let diagonal = diagonal.as_ref();
        let solve = |_: &mut Product, block: Block<'_>| {
            solve_lower_triangular_in_place(diagonal, block.rows.transpose_mut(), Par::Seq);
        };
        in_blocks(width * width * node.rows.len(), below, cores, &mut self.product, solve);
        Ok(())
    }
}

impl Product {
    /// Takes a contribution off a block of the panel that begins with the column `start` of the factor.
    fn subtract(
        &mut self,
        contribution: &Contribution<'_>,
        place: &[u32],
        start: usize,
        block: &mut Block<'_>,
    ) {
        let Contribution { node: source, values, begin, end, .. } = contribution;
        let (width, height) = (source.columns.len(), source.height());
        let all = MatRef::from_column_major_slice(values, height, width).subrows(width, source.rows.len());
        let (above, beyond) = (block.first, block.first + block.rows.nrows());
        let rows = &source.rows[*begin..];
        let ahead = |limit: usize| rows.partition_point(|&row| (place[row as usize] as usize) < limit);
        let mine = begin + ahead(above)..begin + ahead(beyond);
        if mine.is_empty() {
            return;
        }
        let (m, k) = (mine.len(), end - begin);
        if self.values.len() < m * k {
            self.values.resize(m * k, 0.0);
        }
        let product = &mut self.values[..m * k];
        let target = MatMut::from_column_major_slice_mut(product, m, k);
        let (left, right) = (all.subrows(mine.start, m), all.subrows(*begin, k));
        matmul(target, Accum::Replace, left, right.transpose(), 1.0, Par::Seq);
        self.runs.clear();
        for (k, &row) in source.rows[mine].iter().enumerate() {
            let to = place[row as usize] as usize - above;
            match self.runs.last_mut() {
                Some(run) if run.to + run.len == to => run.len += 1,
                _ => self.runs.push(Run { from: k, to, len: 1 }),
            }
        }
        for (column, &row) in product.chunks_exact(m).zip(rows) {
            let target = block.rows.as_mut().col_mut(row as usize - start);
            let Some(target) = target.try_as_col_major_mut() else {
                unreachable!("panels are stored by columns")
            };
            let target = target.as_slice_mut();
            for &Run { from, to, len } in &self.runs {
                for (entry, value) in target[to..to + len].iter_mut().zip(&column[from..from + len]) {
                    *entry -= value;
                }
            }
        }
    }
}

/// Does work on all rows, in one piece if it is little.
fn in_blocks(
    work: usize,
    rows: MatMut<'_, f64>,
    cores: Option<&Cores>,
    own: &mut Product,
    action: impl Fn(&mut Product, Block<'_>) + Sync,
) {
    let count = if work < BLOCKWISE { 1 } else { BLOCKS };
    let size = rows.nrows().div_ceil(count).max(1);
    let mut blocks = Vec::with_capacity(count);
    let (mut first, mut rest) = (0, rows);
    while rest.nrows() > size {
        let (rows, others) = rest.split_at_row_mut(size);
        blocks.push(Block { first, rows });
        (first, rest) = (first + size, others);
    }
    blocks.push(Block { first, rows: rest });
    let action = &action;
    let hire = || {
        let mut product = Product::default();
        move |block| action(&mut product, block)
    };
    share(cores, blocks, |block| action(own, block), hire, || ());
}
