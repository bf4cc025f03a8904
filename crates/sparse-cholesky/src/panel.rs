//! One supernode of a Cholesky factor as a dense panel.

use faer::dyn_stack::MemBuffer;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Accum, MatMut, MatRef, Par};

use super::FactorizationError;
use super::symbolic::{Supernode, SymbolicCholesky};
use dense_cholesky::{factorization_memory, factorize_in_place};

/// What a finished supernode subtracts from the one that owns its rows `[first, first + count)`.
pub(super) struct Update<'a> {
    pub source: &'a Supernode<'a>,
    /// Panel of the source.
    pub values: &'a [f64],
    pub first: usize,
    pub count: usize,
}

impl Update<'_> {
    /// Multiplications.
    pub fn work(&self) -> usize {
        (self.source.rows.len() - self.first) * self.count * self.source.columns.len()
    }
}

/// Memory that is used for one panel after the other.
pub(super) struct PanelWorkspace {
    /// Row of the present panel that holds each row of the matrix.
    panel_row: Vec<u32>,
    product: Vec<f64>,
    runs: Vec<Run>,
    memory: MemBuffer,
}

/// Rows of an update that are neighbours in the panel too.
#[derive(Clone, Copy)]
struct Run {
    from: usize,
    to: usize,
    len: usize,
}

impl PanelWorkspace {
    pub fn new(symbolic: &SymbolicCholesky) -> Self {
        let widest =
            (0..symbolic.supernode_count()).map(|s| symbolic.supernode(s).columns.len()).max();
        Self {
            panel_row: vec![0; symbolic.order()],
            product: Vec::new(),
            runs: Vec::new(),
            memory: factorization_memory(widest.unwrap_or(0)),
        }
    }

    /// Writes the columns of the matrix into a panel of zeros, which becomes the present one.
    pub fn scatter(
        &mut self,
        symbolic: &SymbolicCholesky,
        matrix: &[f64],
        node: &Supernode<'_>,
        panel: &mut [f64],
    ) {
        let below = node.rows.iter().map(|&row| row as usize);
        for (panel_row, row) in (0u32..).zip(node.columns.clone().chain(below)) {
            self.panel_row[row] = panel_row;
        }
        let pattern = symbolic.pattern();
        for (column, target) in node.columns.clone().zip(panel.chunks_exact_mut(node.height())) {
            let values = &matrix[pattern.column_start(column)..];
            for (&row, value) in pattern.column(column).iter().zip(values) {
                target[self.panel_row[row as usize] as usize] = *value;
            }
        }
    }

    /// Subtracts an update from the present panel.
    pub fn subtract(&mut self, update: &Update<'_>, node: &Supernode<'_>, panel: &mut [f64]) {
        let &Update { source, values, first, count } = update;
        let (width, height) = (source.columns.len(), source.height());
        let rows = &source.rows[first..];
        let below = MatRef::from_column_major_slice(values, height, width)
            .subrows(width + first, rows.len());
        let size = rows.len() * count;
        if self.product.len() < size {
            self.product.resize(size, 0.0);
        }
        let product = &mut self.product[..size];
        let target = MatMut::from_column_major_slice_mut(product, rows.len(), count);
        matmul(target, Accum::Replace, below, below.subrows(0, count).transpose(), 1.0, Par::Seq);
        self.runs.clear();
        for (from, &row) in rows.iter().enumerate() {
            let to = self.panel_row[row as usize] as usize;
            match self.runs.last_mut() {
                Some(run) if run.to + run.len == to => run.len += 1,
                _ => self.runs.push(Run { from, to, len: 1 }),
            }
        }
        for (column, &row) in product.chunks_exact(rows.len()).zip(rows) {
            let start = (row as usize - node.columns.start) * node.height();
            let target = &mut panel[start..start + node.height()];
            for &Run { from, to, len } in &self.runs {
                for (entry, value) in
                    target[to..to + len].iter_mut().zip(&column[from..from + len])
                {
                    *entry -= value;
                }
            }
        }
    }

    /// Turns a panel of the Schur complement into one of the factor.
    pub fn factorize(
        &mut self,
        node: &Supernode<'_>,
        panel: &mut [f64],
    ) -> Result<(), FactorizationError> {
        let width = node.columns.len();
        let panel = MatMut::from_column_major_slice_mut(panel, node.height(), width);
        let (mut diagonal, below) = panel.split_at_row_mut(width);
        factorize_in_place(diagonal.as_mut(), &mut self.memory).map_err(|error| {
            FactorizationError::NotPositiveDefinite { equation: node.columns.start + error.index }
        })?;
        solve_lower_triangular_in_place(diagonal.as_ref(), below.transpose_mut(), Par::Seq);
        Ok(())
    }
}
