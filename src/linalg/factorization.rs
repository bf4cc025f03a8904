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

/// Factorizes the matrix with the given lower-triangle values into `factor`: the supernodes that are `outdated`, and
/// those that it does not hold yet. What lies above the diagonal in the panels is of no meaning. Asks `checkpoint` now
/// and then whether to go on.
pub(super) fn factorize(
    symbolic: &SymbolicCholesky,
    matrix: &[f64],
    factor: &mut Vec<f64>,
    outdated: &[bool],
    checkpoint: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<(), FactorizationError> {
    let count = symbolic.supernode_count();
    let missing = symbolic.factor_entries() - factor.len();
    factor.try_reserve_exact(missing).map_err(|_| FactorizationError::TooLarge)?;
    let mut workspace = Workspace::new(symbolic)?;
    // First contributor of each supernode, next one in the same list, and how many of its rows a contributor has given.
    let (mut first, mut next) = (vec![NONE; count], vec![NONE; count]);
    let mut given = vec![0u32; count];
    let mut work = 0;
    for s in 0..count {
        let node = symbolic.supernode(s);
        let is_held = node.values.end <= factor.len();
        let is_outdated = !is_held || outdated[s];
        if !is_held {
            // Zeros for this panel alone, so that they are still in the cache when it is filled.
            factor.resize(node.values.end, 0.0);
        }
        let (finished, rest) = factor.split_at_mut(node.values.start);
        let panel = &mut rest[..node.values.len()];
        if is_outdated {
            if is_held {
                panel.fill(0.0);
            }
            workspace.locate(&node);
            workspace.scatter(symbolic, matrix, &node, panel);
        }
        let mut contributor = first[s];
        while contributor != NONE {
            let d = contributor as usize;
            contributor = next[d];
            let source = symbolic.supernode(d);
            let begin = given[d] as usize;
            let end = begin + source.rows[begin..].partition_point(|&row| (row as usize) < node.columns.end);
            let contribution =
                Contribution { values: &finished[source.values.clone()], node: source, begin, end };
            if is_outdated {
                work += contribution.work();
                workspace.subtract(&contribution, &node, panel);
            }
            given[d] = end as u32;
            if let Some(&row) = contribution.node.rows.get(end) {
                let owner = symbolic.supernode_of(row);
                (next[d], first[owner]) = (first[owner], d as u32);
            }
        }
        if is_outdated {
            work += node.columns.len() * node.height() * node.height();
            workspace.factorize(&node, panel)?;
        }
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

/// The supernodes whose numbers change from one matrix to another: those with an entry that does, and their ancestors.
pub(super) fn outdated(symbolic: &SymbolicCholesky, old: &[f64], new: &[f64]) -> Vec<bool> {
    let pattern = symbolic.pattern();
    let mut outdated = vec![false; symbolic.supernode_count()];
    for s in 0..outdated.len() {
        let columns = symbolic.supernode(s).columns;
        let entries = pattern.column_start(columns.start)..pattern.column_start(columns.end);
        outdated[s] |= old[entries.clone()] != new[entries];
        // A parent comes after its children.
        outdated[symbolic.parent(s)] |= outdated[s];
    }
    outdated
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

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use crate::linalg::{
        Cholesky, EliminationOrder, FactorizationError, Graph, LatticePoint, SymbolicCholesky,
        SymmetricPattern,
    };

    const COLUMNS: i32 = 40;
    const ROWS: i32 = 30;

    /// One equation for each point of a grid, in nested dissection.
    fn grid() -> (Arc<SymbolicCholesky>, Vec<u32>) {
        let points = || (0..COLUMNS).flat_map(|i| (0..ROWS).map(move |j| (i, j)));
        let at = |i: i32, j: i32| u32::try_from(i * ROWS + j).unwrap();
        let cells: Vec<[u32; 4]> = points()
            .filter(|&(i, j)| i + 1 < COLUMNS && j + 1 < ROWS)
            .map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
            .collect();
        let lattice: Vec<LatticePoint> = points().map(|(i, j)| LatticePoint { patch: 0, i, j }).collect();
        let graph = Graph::from_cells(lattice.len(), &cells);
        let order = EliminationOrder::new(&graph, &lattice, &[]);
        let mut position = vec![0u32; lattice.len()];
        for (k, &node) in (0u32..).zip(order.nodes()) {
            position[node as usize] = k;
        }
        let (mut offsets, mut rows) = (vec![0u32], Vec::new());
        for (k, &node) in (0u32..).zip(order.nodes()) {
            let begin = rows.len();
            rows.push(k);
            rows.extend(graph.neighbours(node).iter().map(|&m| position[m as usize]).filter(|&row| row > k));
            rows[begin..].sort_unstable();
            offsets.push(u32::try_from(rows.len()).unwrap());
        }
        let symbolic = SymbolicCholesky::new(SymmetricPattern::from_columns(offsets, rows)).unwrap();
        (symbolic, position)
    }

    /// Diagonally dominant; stiffer at some equations.
    fn matrix(symbolic: &SymbolicCholesky, is_stiff: impl Fn(usize) -> bool) -> Vec<f64> {
        let pattern = symbolic.pattern();
        let column = |j: usize| {
            let diagonal = if is_stiff(j) { 30.0 } else { 9.0 };
            std::iter::once(diagonal).chain((1..pattern.column(j).len()).map(|k| -1.0 - 0.01 * k as f64))
        };
        (0..pattern.order()).flat_map(column).collect()
    }

    fn entries(factor: &Cholesky) -> Vec<u64> {
        let n = factor.symbolic().order();
        let columns = (0..n).step_by(7).flat_map(|k| {
            let mut x = vec![0.0; n];
            x[k] = 1.0;
            factor.solve(&mut x);
            x
        });
        columns.map(f64::to_bits).collect()
    }

    #[test]
    fn a_renewed_factor_is_bit_for_bit_a_fresh_one() {
        let (symbolic, position) = grid();
        let mut factor = Cholesky::factor(&symbolic, &matrix(&symbolic, |_| false)).unwrap();
        let corner: Vec<u32> = (0..5).map(|k| position[k]).collect();
        // A change in one corner, in another, everywhere, and none.
        let stages: [&dyn Fn(usize) -> bool; 4] = [
            &|j| corner.contains(&u32::try_from(j).unwrap()),
            &|j| j == position[position.len() - 1] as usize,
            &|_| true,
            &|_| true,
        ];
        for is_stiff in stages {
            let next = matrix(&symbolic, is_stiff);
            factor.refactor(next.clone(), &mut || ControlFlow::Continue(())).unwrap();
            assert_eq!(entries(&factor), entries(&Cholesky::factor(&symbolic, &next).unwrap()));
        }
    }

    #[test]
    fn only_what_a_change_reaches_is_outdated() {
        let (symbolic, position) = grid();
        let old = matrix(&symbolic, |_| false);
        let changed = position[0];
        let outdated = super::outdated(&symbolic, &old, &matrix(&symbolic, |j| j == changed as usize));
        let count = outdated.iter().filter(|outdated| **outdated).count();
        assert!(count < outdated.len() / 4, "{count} of {} supernodes", outdated.len());
        // The supernode of that equation and its ancestors.
        let mut path = vec![symbolic.supernode_of(changed)];
        while symbolic.parent(path[path.len() - 1]) != path[path.len() - 1] {
            path.push(symbolic.parent(path[path.len() - 1]));
        }
        assert_eq!(count, path.len());
        assert!(path.iter().all(|&s| outdated[s]));
        assert!(super::outdated(&symbolic, &old, &old).iter().all(|outdated| !outdated));
    }

    #[test]
    fn what_fails_leaves_nothing_to_build_on() {
        let (symbolic, _) = grid();
        let whole = matrix(&symbolic, |_| false);
        let mut factor = Cholesky::factor(&symbolic, &whole).unwrap();
        let expected = entries(&factor);
        let last = symbolic.order() - 1;
        let mut indefinite = whole.clone();
        indefinite[symbolic.pattern().column_start(last)] = -100.0;
        indefinite[0] = 12.0;
        let refused = factor.refactor(indefinite, &mut || ControlFlow::Continue(()));
        assert_eq!(refused, Err(FactorizationError::NotPositiveDefinite { equation: last }));
        factor.refactor(whole.clone(), &mut || ControlFlow::Continue(())).unwrap();
        assert_eq!(entries(&factor), expected);
        let mut unknown = whole;
        unknown[3] = f64::NAN;
        let refused = factor.refactor(unknown, &mut || ControlFlow::Continue(()));
        assert_eq!(refused, Err(FactorizationError::NotFinite));
    }
}
