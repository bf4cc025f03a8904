//! Numeric factorization, supernode by supernode.
//!
//! Left-looking: a supernode takes its columns of A, subtracts the update `L_d[rows of s and
//! below] · L_d[rows of s]ᵀ` of every earlier supernode d that has rows among its columns, and is
//! then factorized as a dense panel. Each finished supernode is in the list of the supernode that
//! owns its next rows, so no search is needed for the updates.
//!
//! # Reference
//! E. G. Ng, B. W. Peyton, *Block sparse Cholesky algorithms on advanced uniprocessor computers*,
//! SIAM J. Sci. Comput. 14 (1993) 1034–1056.

#![expect(clippy::cast_possible_truncation, reason = "there are fewer than 2^32 equations")]

use std::mem;
use std::ops::ControlFlow;

use super::FactorizationError;
use super::elimination::NONE;
use super::panel::{PanelWorkspace, Update};
use super::symbolic::SymbolicCholesky;

/// Multiplications between two checkpoints; some milliseconds.
const WORK_BETWEEN_CHECKPOINTS: usize = 1 << 28;

/// Factorizes the matrix with the given lower-triangle values into `factor`.
///
/// In a complete `factor` only the `outdated` supernodes are computed; an empty one grows panel by
/// panel. Entries above the diagonal of a panel's diagonal block have no meaning. After every
/// [`WORK_BETWEEN_CHECKPOINTS`] multiplications `checkpoint` decides whether to continue.
pub(super) fn factorize(
    symbolic: &SymbolicCholesky,
    matrix: &[f64],
    factor: &mut Vec<f64>,
    outdated: Option<&[bool]>,
    checkpoint: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<(), FactorizationError> {
    let missing = symbolic.factor_entries() - factor.len();
    factor.try_reserve_exact(missing).map_err(|_| FactorizationError::TooLarge)?;
    let mut workspace = PanelWorkspace::new(symbolic);
    let mut pending = PendingUpdates::new(symbolic);
    let mut work = 0;
    let mut ask = |work: &mut usize| {
        if *work > WORK_BETWEEN_CHECKPOINTS {
            *work = 0;
            if checkpoint().is_break() {
                return Err(FactorizationError::Stopped);
            }
        }
        Ok(())
    };
    for s in 0..symbolic.supernode_count() {
        let node = symbolic.supernode(s);
        let is_outdated = outdated.is_none_or(|outdated| outdated[s]);
        if factor.len() < node.values.end {
            // Only this panel is zeroed, so that it is still in the cache when it is filled.
            factor.resize(node.values.end, 0.0);
        } else if is_outdated {
            // The whole vector at once: untouched memory is mapped fastest in order.
            factor[node.values.clone()].fill(0.0);
        }
        let (done, rest) = factor.split_at_mut(node.values.start);
        let panel = &mut rest[..node.values.len()];
        if is_outdated {
            workspace.scatter(symbolic, matrix, &node, panel);
            work += node.work();
        }
        while let Some(update) = pending.pop(s) {
            let source = symbolic.supernode(update.source as usize);
            let first = update.rows_applied as usize;
            let count =
                source.rows[first..].partition_point(|&row| (row as usize) < node.columns.end);
            if is_outdated {
                let update =
                    Update { values: &done[source.values.clone()], source: &source, first, count };
                workspace.subtract(&update, &node, panel);
                work += update.work();
                ask(&mut work)?;
            }
            pending.push(PendingUpdate { rows_applied: (first + count) as u32, ..update });
        }
        if is_outdated {
            workspace.factorize(&node, panel)?;
        }
        pending.push(PendingUpdate { source: s as u32, rows_applied: 0 });
        ask(&mut work)?;
    }
    Ok(())
}

/// Returns for each supernode whether its values change from one matrix to another: if an entry
/// changes in its columns or in the columns of a descendant.
pub(super) fn outdated_supernodes(
    symbolic: &SymbolicCholesky,
    old: &[f64],
    new: &[f64],
) -> Vec<bool> {
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

/// The pending update of a finished supernode to later ones: the rows after the first
/// `rows_applied`.
#[derive(Clone, Copy)]
struct PendingUpdate {
    source: u32,
    rows_applied: u32,
}

/// The pending updates of each supernode, as linked lists.
struct PendingUpdates<'a> {
    symbolic: &'a SymbolicCholesky,
    /// First source in the list of each supernode.
    first: Vec<u32>,
    /// The next source in the list that a source is in, and how many of its rows have been
    /// applied.
    next: Vec<u32>,
    rows_applied: Vec<u32>,
}

impl<'a> PendingUpdates<'a> {
    fn new(symbolic: &'a SymbolicCholesky) -> Self {
        let none = vec![NONE; symbolic.supernode_count()];
        Self { symbolic, first: none.clone(), rows_applied: vec![0; none.len()], next: none }
    }

    /// Adds an update to the list of the supernode that owns its next row; drops it if no row is
    /// left.
    fn push(&mut self, update: PendingUpdate) {
        let PendingUpdate { source, rows_applied } = update;
        let rows = self.symbolic.supernode(source as usize).rows;
        if let Some(&row) = rows.get(rows_applied as usize) {
            let owner = self.symbolic.supernode_of(row);
            self.next[source as usize] = mem::replace(&mut self.first[owner], source);
            self.rows_applied[source as usize] = rows_applied;
        }
    }

    /// Takes an update from the list of a supernode.
    fn pop(&mut self, owner: usize) -> Option<PendingUpdate> {
        let source = self.first[owner];
        if source == NONE {
            return None;
        }
        self.first[owner] = self.next[source as usize];
        Some(PendingUpdate { source, rows_applied: self.rows_applied[source as usize] })
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use super::{WORK_BETWEEN_CHECKPOINTS, outdated_supernodes};
    use crate::{
        Cholesky, EliminationOrder, FactorizationError, Graph, LatticePoint, SymbolicCholesky,
        SymmetricPattern,
    };

    /// One equation for each point of a grid, in nested dissection.
    fn grid() -> (Arc<SymbolicCholesky>, Vec<u32>) {
        grid_of(40, 30)
    }

    fn grid_of(columns: i32, rows: i32) -> (Arc<SymbolicCholesky>, Vec<u32>) {
        let points = || (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j)));
        let at = |i: i32, j: i32| u32::try_from(i * rows + j).unwrap();
        let cells: Vec<[u32; 4]> = points()
            .filter(|&(i, j)| i + 1 < columns && j + 1 < rows)
            .map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
            .collect();
        let lattice: Vec<LatticePoint> =
            points().map(|(i, j)| LatticePoint { patch: 0, i, j }).collect();
        let graph = Graph::from_cells(lattice.len(), &cells);
        let order = EliminationOrder::new(&graph, &lattice, &[]);
        let symbolic = SymbolicCholesky::new(SymmetricPattern::of_graph(&graph, &order)).unwrap();
        (symbolic, order.positions())
    }

    /// Diagonally dominant; stiffer at some equations.
    fn matrix(symbolic: &SymbolicCholesky, is_stiff: impl Fn(usize) -> bool) -> Vec<f64> {
        let pattern = symbolic.pattern();
        let column = |j: usize| {
            let diagonal = if is_stiff(j) { 30.0 } else { 9.0 };
            std::iter::once(diagonal)
                .chain((1..pattern.column(j).len()).map(|k| -1.0 - 0.01 * k as f64))
        };
        (0..pattern.order()).flat_map(column).collect()
    }

    fn entries(factor: &Cholesky) -> Vec<u64> {
        let n = factor.symbolic().order();
        let columns = (0..n).step_by(7.max(n / 30)).flat_map(|k| {
            let mut x = vec![0.0; n];
            x[k] = 1.0;
            factor.solve(&mut x);
            x
        });
        columns.map(f64::to_bits).collect()
    }

    #[test]
    fn refactored_values_equal_a_fresh_factorization_bit_for_bit() {
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
    fn a_changed_entry_outdates_its_supernode_and_the_ancestors() {
        let (symbolic, position) = grid();
        let old = matrix(&symbolic, |_| false);
        let changed = position[0];
        let outdated =
            outdated_supernodes(&symbolic, &old, &matrix(&symbolic, |j| j == changed as usize));
        let count = outdated.iter().filter(|outdated| **outdated).count();
        assert!(count < outdated.len() / 4, "{count} of {} supernodes", outdated.len());
        // The supernode of that equation and its ancestors.
        let mut path = vec![symbolic.supernode_of(changed)];
        while symbolic.parent(path[path.len() - 1]) != path[path.len() - 1] {
            path.push(symbolic.parent(path[path.len() - 1]));
        }
        assert_eq!(count, path.len());
        assert!(path.iter().all(|&s| outdated[s]));
        assert!(outdated_supernodes(&symbolic, &old, &old).iter().all(|outdated| !outdated));
    }

    #[test]
    fn after_an_error_the_next_factorization_is_complete() {
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

    #[test]
    #[ignore = "full"]
    fn a_factorization_stops_where_the_checkpoint_says_so() {
        let (symbolic, _) = grid_of(420, 400);
        let matrix = matrix(&symbolic, |_| false);
        let whole = Cholesky::factor(&symbolic, &matrix).unwrap();
        let mut factor = Cholesky::empty(&symbolic);
        let mut asked = 0;
        factor
            .refactor(matrix.clone(), &mut || {
                asked += 1;
                ControlFlow::Continue(())
            })
            .unwrap();
        let work: usize =
            (0..symbolic.supernode_count()).map(|s| symbolic.supernode(s).work()).sum();
        assert!(
            work > 4 * WORK_BETWEEN_CHECKPOINTS && asked >= 4,
            "{work} multiplications, {asked} checkpoints"
        );
        for last in 0..asked {
            let mut left = last;
            factor.invalidate();
            let stopped = factor.refactor(matrix.clone(), &mut || {
                if left == 0 {
                    return ControlFlow::Break(());
                }
                left -= 1;
                ControlFlow::Continue(())
            });
            assert_eq!((stopped, left), (Err(FactorizationError::Stopped), 0));
        }
        factor.refactor(matrix, &mut || ControlFlow::Continue(())).unwrap();
        assert_eq!(entries(&factor), entries(&whole));
    }
}
