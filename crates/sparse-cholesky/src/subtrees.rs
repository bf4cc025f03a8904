//! Disjoint subtrees of the elimination tree, factorized side by side.
//!
//! In a postorder the supernodes of a subtree follow each other, and so do their values: each subtree is a piece of work
//! that needs nothing of the others.

use std::cell::RefCell;
use std::cmp::Reverse;
use std::mem;
use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use super::cholesky::FactorizationError;
use super::cores::{Cores, share};
use super::factorization::{Checkpoint, Elimination, Finished, Values};
use super::panel::Workspace;

/// Multiplications from which a factorization is shared with idle cores; some ten milliseconds.
const SHARED: usize = 1 << 28;
/// Subtrees that are factorized side by side have at most this part of the whole work: a core that is lent is back soon.
pub(super) const SUBTREE_PART: usize = 16;

/// A subtree to factorize.
struct Piece<'a> {
    supernodes: Range<usize>,
    /// Where its values begin among those of the factor.
    base: usize,
    values: &'a mut [f64],
}

impl Elimination<'_> {
    /// Subtrees to factorize side by side, in order; none if there is too little to do.
    pub fn subtrees(&self) -> Vec<Range<usize>> {
        let count = self.symbolic.supernode_count();
        let mut work = vec![0; count];
        let mut first: Vec<usize> = (0..count).collect();
        let mut total = 0;
        for s in 0..count {
            if self.is_outdated(s) {
                let own = self.symbolic.supernode(s).work();
                work[s] += own;
                total += own;
            }
            let parent = self.symbolic.parent(s);
            if parent != s {
                work[parent] += work[s];
                first[parent] = first[parent].min(first[s]);
            }
        }
        if total < SHARED {
            return Vec::new();
        }
        let limit = total / SUBTREE_PART;
        // Larger than this with its parent, but not alone; what is tiny is not worth a piece of its own.
        let is_piece = |&s: &usize| {
            let parent = self.symbolic.parent(s);
            work[s] <= limit && work[s] > limit / SUBTREE_PART && (parent == s || work[parent] > limit)
        };
        let pieces: Vec<Range<usize>> = (0..count).filter(is_piece).map(|s| first[s]..s + 1).collect();
        debug_assert!(pieces.windows(2).all(|pair| pair[0].end <= pair[1].start), "the order is a postorder");
        pieces
    }

    /// Factorizes subtrees, on idle cores too.
    pub fn run_subtrees(
        &self,
        subtrees: &[Range<usize>],
        factor: &mut [f64],
        workspace: &mut Workspace,
        cores: Option<&Cores>,
        checkpoint: &mut Checkpoint<'_>,
    ) -> Result<Vec<Finished>, FactorizationError> {
        let mut pieces = Vec::with_capacity(subtrees.len());
        let (mut base, mut rest) = (0, factor);
        for supernodes in subtrees {
            let begin = self.symbolic.supernode(supernodes.start).values.start;
            let end = self.symbolic.supernode(supernodes.end - 1).values.end;
            let (values, others) = mem::take(&mut rest)[begin - base..].split_at_mut(end - begin);
            pieces.push(Piece { supernodes: supernodes.clone(), base: begin, values });
            (base, rest) = (end, others);
        }
        // The largest first, so that all are done at about the same time.
        pieces.sort_by_key(|piece| Reverse(piece.values.len()));
        let outcomes = Mutex::new(Vec::new());
        let factorize = |piece: Piece<'_>, workspace: &mut Workspace, checkpoint: &mut Checkpoint<'_>| {
            let Piece { supernodes, base, values } = piece;
            let start = supernodes.start;
            let outcome =
                self.run(supernodes.clone(), Values::Part { base, values }, &[], workspace, None, checkpoint);
            let outcome = outcome.map(|waiting| Finished { supernodes, waiting });
            outcomes.lock().unwrap_or_else(PoisonError::into_inner).push((start, outcome));
        };
        let stopped = AtomicBool::new(false);
        let checkpoint = RefCell::new(checkpoint);
        let ask = || {
            let wish = checkpoint.borrow_mut()();
            stopped.fetch_or(wish.is_break(), Ordering::Relaxed);
            wish
        };
        let own = |piece: Piece<'_>| factorize(piece, workspace, &mut || ask());
        let hire = || {
            let mut workspace = Workspace::new(self.symbolic);
            let (stopped, factorize) = (&stopped, &factorize);
            move |piece: Piece<'_>| {
                factorize(piece, &mut workspace, &mut || {
                    if stopped.load(Ordering::Relaxed) {
                        ControlFlow::Break(())
                    } else {
                        ControlFlow::Continue(())
                    }
                });
            }
        };
        share(cores, pieces, own, hire, || _ = ask());
        let mut outcomes = outcomes.into_inner().unwrap_or_else(PoisonError::into_inner);
        outcomes.sort_by_key(|(start, _)| *start);
        outcomes.into_iter().map(|(_, outcome)| outcome).collect()
    }
}
