//! The numbers of a sparse Cholesky factor, supernode by supernode.
//!
//! Left-looking: a supernode takes its columns of A, subtracts what every earlier supernode that has rows among them
//! contributes, `L_d[rows of s and below] · L_d[rows of s]ᵀ`, and is then factorized as a dense block. Each finished
//! supernode waits in the list of the one that owns its next row; so the contributors are at hand without search.
//!
//! Where cores are idle and the factorization is large, disjoint subtrees of the elimination tree are factorized side by
//! side, and the large panels above them in blocks of rows. The order in which contributions are subtracted stays that
//! of one thread, and with it every bit of the factor.
//!
//! # Reference
//! E. G. Ng, B. W. Peyton, *Block sparse Cholesky algorithms on advanced uniprocessor computers*, SIAM J. Sci. Comput. 14
//! (1993) 1034–1056.

#![expect(clippy::cast_possible_truncation, reason = "there are fewer than 2^32 equations")]

use std::mem;
use std::ops::{ControlFlow, Range};

use super::cholesky::{FactorizationError, SymbolicCholesky};
use super::cores::Cores;
use super::panel::{Contribution, Supernode, Workspace};

/// Multiplications between two questions whether to go on; some milliseconds.
const WORK_BETWEEN_CHECKPOINTS: usize = 1 << 28;
/// End of a list.
const NONE: u32 = u32::MAX;

/// Asked now and then whether to go on.
pub(super) type Checkpoint<'a> = dyn FnMut() -> ControlFlow<()> + 'a;

/// Factorizes the matrix with the given lower-triangle values into `factor`: the supernodes that are `outdated`, and
/// those that it does not hold yet. What lies above the diagonal in the panels is of no meaning. Asks `checkpoint` now
/// and then whether to go on.
pub(super) fn factorize(
    symbolic: &SymbolicCholesky,
    matrix: &[f64],
    factor: &mut Vec<f64>,
    outdated: &[bool],
    cores: Option<&Cores>,
    checkpoint: &mut Checkpoint<'_>,
) -> Result<(), FactorizationError> {
    let elimination = Elimination { symbolic, matrix, outdated, held: factor.len() };
    let missing = symbolic.factor_entries() - factor.len();
    factor.try_reserve_exact(missing).map_err(|_| FactorizationError::TooLarge)?;
    let mut workspace = Workspace::new(symbolic);
    let subtrees = match cores {
        Some(cores) if cores.has_idle() => elimination.subtrees(),
        _ => Vec::new(),
    };
    let all = 0..symbolic.supernode_count();
    if subtrees.is_empty() {
        elimination.run(all, Values::Growing(factor), &[], &mut workspace, cores, checkpoint)?;
    } else {
        complete(factor, symbolic.factor_entries());
        let finished = elimination.run_subtrees(&subtrees, factor, &mut workspace, cores, checkpoint)?;
        elimination.run(all, Values::Growing(factor), &finished, &mut workspace, cores, checkpoint)?;
    }
    Ok(())
}

/// Gives a factor all its entries, those that are new being zero: as memory that nobody has touched, if it is empty.
fn complete(factor: &mut Vec<f64>, entries: usize) {
    if factor.is_empty() {
        *factor = Vec::new();
        *factor = vec![0.0; entries];
    }
    factor.resize(entries, 0.0);
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

/// A matrix on its way to becoming a factor.
pub(super) struct Elimination<'a> {
    pub symbolic: &'a SymbolicCholesky,
    matrix: &'a [f64],
    outdated: &'a [bool],
    /// Values that the factor held before.
    held: usize,
}

/// The values of the factor as far as a sequence of supernodes needs them.
pub(super) enum Values<'a> {
    /// All of them, from the first on; panels are added as they come.
    Growing(&'a mut Vec<f64>),
    /// Those of a subtree, which begin at `base`.
    Part { base: usize, values: &'a mut [f64] },
}

/// A subtree that is factorized, and who in it contributes to supernodes outside, in the order in which they came to wait.
pub(super) struct Finished {
    pub supernodes: Range<usize>,
    pub waiting: Vec<Waiting>,
}

/// A supernode whose next rows, after those `given`, belong to the supernode `owner`.
pub(super) struct Waiting {
    owner: usize,
    contributor: u32,
    given: u32,
}

/// Who contributes to the supernodes of a sequence.
struct Lists {
    /// First of the sequence.
    start: usize,
    /// First contributor of each supernode, the next one in the same list, and how many of its rows each has given.
    first: Vec<u32>,
    next: Vec<u32>,
    given: Vec<u32>,
}

impl Elimination<'_> {
    /// Whether a supernode has to be factorized.
    pub fn is_outdated(&self, s: usize) -> bool {
        self.symbolic.supernode(s).values.end > self.held || self.outdated[s]
    }

    /// Factorizes supernodes in order, but for those of subtrees that are finished. Returns who waits to contribute to
    /// later ones.
    pub fn run(
        &self,
        supernodes: Range<usize>,
        mut values: Values<'_>,
        finished: &[Finished],
        workspace: &mut Workspace,
        cores: Option<&Cores>,
        checkpoint: &mut Checkpoint<'_>,
    ) -> Result<Vec<Waiting>, FactorizationError> {
        let mut lists = Lists::new(&supernodes);
        let mut outside = Vec::new();
        let mut finished = finished.iter().peekable();
        let mut work = 0;
        let mut s = supernodes.start;
        while s < supernodes.end {
            if let Some(subtree) = finished.next_if(|subtree| subtree.supernodes.start == s) {
                subtree.waiting.iter().for_each(|waiting| lists.add(waiting));
                s = subtree.supernodes.end;
                continue;
            }
            let node = self.symbolic.supernode(s);
            let Opened { base, done, panel, is_zero } = values.open(&node.values);
            let contributors = lists.contributors(s);
            let contributions: Vec<Contribution<'_>> =
                contributors.map(|(d, given)| self.contribution(d, given, &node, base, done)).collect();
            if self.is_outdated(s) {
                work += node.work() + contributions.iter().map(Contribution::work).sum::<usize>();
                if !is_zero {
                    // In one go, because memory that nobody has touched is mapped fastest in order.
                    panel.fill(0.0);
                }
                workspace.make(self.symbolic, self.matrix, &node, &contributions, panel, cores)?;
            }
            for waiting in self.waiting(s, &node, &contributions) {
                if waiting.owner < supernodes.end { lists.add(&waiting) } else { outside.push(waiting) }
            }
            if work > WORK_BETWEEN_CHECKPOINTS {
                work = 0;
                if checkpoint().is_break() {
                    return Err(FactorizationError::Stopped);
                }
            }
            s += 1;
        }
        Ok(outside)
    }

    /// What supernode `d`, some of whose rows have been given already, contributes to another.
    fn contribution<'v>(
        &'v self,
        d: u32,
        given: u32,
        node: &Supernode<'_>,
        base: usize,
        done: &'v [f64],
    ) -> Contribution<'v> {
        let source = self.symbolic.supernode(d as usize);
        let begin = given as usize;
        let end = begin + source.rows[begin..].partition_point(|&row| (row as usize) < node.columns.end);
        let values = &done[source.values.start - base..source.values.end - base];
        Contribution { supernode: d, node: source, values, begin, end }
    }

    /// Where those that have contributed to a supernode wait next, and it itself.
    fn waiting<'c>(
        &'c self,
        s: usize,
        node: &'c Supernode<'c>,
        contributions: &'c [Contribution<'c>],
    ) -> impl Iterator<Item = Waiting> + use<'c> {
        let others = contributions.iter().map(|c| (c.supernode, c.node.rows, c.end));
        let all = others.chain([(s as u32, node.rows, 0)]);
        all.filter_map(|(contributor, rows, given)| {
            let owner = self.symbolic.supernode_of(*rows.get(given)?);
            Some(Waiting { owner, contributor, given: given as u32 })
        })
    }
}

/// A panel, and what is before it.
struct Opened<'a> {
    /// Number of the first value before the panel among those of the factor.
    base: usize,
    done: &'a [f64],
    panel: &'a mut [f64],
    is_zero: bool,
}

impl Values<'_> {
    fn open(&mut self, panel: &Range<usize>) -> Opened<'_> {
        let (base, values, is_zero): (usize, &mut [f64], bool) = match self {
            Self::Growing(values) => {
                let is_new = values.len() < panel.end;
                if is_new {
                    // Zeros for this panel alone, so that they are still in the cache when it is filled.
                    values.resize(panel.end, 0.0);
                }
                (0, values, is_new)
            }
            Self::Part { base, values } => (*base, values, false),
        };
        let (done, rest) = values.split_at_mut(panel.start - base);
        Opened { base, done, panel: &mut rest[..panel.len()], is_zero }
    }
}

impl Lists {
    fn new(supernodes: &Range<usize>) -> Self {
        let none = vec![NONE; supernodes.len()];
        Self { start: supernodes.start, first: none.clone(), next: none, given: vec![0; supernodes.len()] }
    }

    fn add(&mut self, waiting: &Waiting) {
        let Waiting { owner, contributor, given } = *waiting;
        let d = contributor as usize - self.start;
        self.next[d] = mem::replace(&mut self.first[owner - self.start], contributor);
        self.given[d] = given;
    }

    /// Who contributes to a supernode, each with the number of rows it has given.
    fn contributors(&self, s: usize) -> impl Iterator<Item = (u32, u32)> {
        let mut contributor = self.first[s - self.start];
        std::iter::from_fn(move || {
            let d = (contributor != NONE).then_some(contributor)?;
            let k = d as usize - self.start;
            contributor = self.next[k];
            Some((d, self.given[k]))
        })
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use super::Elimination;
    use crate::subtrees::SUBTREE_PART;
    use crate::{
        Cholesky, Cores, EliminationOrder, FactorizationError, Graph, LatticePoint, SymbolicCholesky,
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
        let columns = (0..n).step_by(7.max(n / 30)).flat_map(|k| {
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
            factor.refactor(next.clone(), None, &mut || ControlFlow::Continue(())).unwrap();
            assert_eq!(entries(&factor), entries(&Cholesky::factor(&symbolic, &next).unwrap()));
        }
    }

    #[test]
    fn idle_cores_change_no_bit() {
        let (symbolic, position) = grid_of(420, 400);
        let soft = matrix(&symbolic, |_| false);
        let corner: Vec<usize> = (0..300).map(|k| position[k] as usize).collect();
        let stages = [soft, matrix(&symbolic, |j| corner.contains(&j)), matrix(&symbolic, |_| true)];
        let all = vec![true; symbolic.supernode_count()];
        let elimination = Elimination { symbolic: &symbolic, matrix: &stages[0], outdated: &all, held: 0 };
        assert!(elimination.subtrees().len() >= SUBTREE_PART, "there is something to share");
        let cores = Cores::new(3);
        let _job = cores.occupy();
        let (mut alone, mut shared) = (Cholesky::empty(&symbolic), Cholesky::empty(&symbolic));
        for matrix in &stages {
            alone.refactor(matrix.clone(), None, &mut || ControlFlow::Continue(())).unwrap();
            shared.refactor(matrix.clone(), Some(&cores), &mut || ControlFlow::Continue(())).unwrap();
            assert_eq!(entries(&shared), entries(&alone));
        }
        let again = matrix(&symbolic, |_| false);
        let stopped = shared.refactor(again.clone(), Some(&cores), &mut || ControlFlow::Break(()));
        assert_eq!(stopped, Err(FactorizationError::Stopped));
        let mut indefinite = again.clone();
        indefinite[symbolic.pattern().column_start(7)] = -100.0;
        let refused = shared.refactor(indefinite, Some(&cores), &mut || ControlFlow::Continue(()));
        assert_eq!(refused, Err(FactorizationError::NotPositiveDefinite { equation: 7 }));
        shared.refactor(again.clone(), Some(&cores), &mut || ControlFlow::Continue(())).unwrap();
        assert_eq!(entries(&shared), entries(&Cholesky::factor(&symbolic, &again).unwrap()));
        assert!(cores.has_idle(), "what was borrowed is given back");
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
        let refused = factor.refactor(indefinite, None, &mut || ControlFlow::Continue(()));
        assert_eq!(refused, Err(FactorizationError::NotPositiveDefinite { equation: last }));
        factor.refactor(whole.clone(), None, &mut || ControlFlow::Continue(())).unwrap();
        assert_eq!(entries(&factor), expected);
        let mut unknown = whole;
        unknown[3] = f64::NAN;
        let refused = factor.refactor(unknown, None, &mut || ControlFlow::Continue(()));
        assert_eq!(refused, Err(FactorizationError::NotFinite));
    }
}
