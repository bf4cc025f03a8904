//! Processor cores that are lent to whoever can use more than one.

use std::sync::atomic::{AtomicIsize, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, Thread};
use std::time::Duration;

/// The cores that the jobs of a process share.
///
/// Each job occupies one. A factorization that is large enough borrows those that are idle, piece of work by piece of
/// work, and leaves one as soon as a job wants it. So a pool that is full is as fast as if nobody ever borrowed.
#[derive(Debug)]
pub struct Cores {
    /// Cores that nobody uses; below zero if jobs wait for borrowed ones.
    idle: AtomicIsize,
}

/// A core in use, given back when dropped.
#[derive(Debug)]
#[must_use]
pub struct OccupiedCore(Arc<Cores>);

/// A core that is given back when dropped or, if jobs want it, at the next opportunity.
struct BorrowedCore<'a>(&'a Cores);

impl Cores {
    /// So many cores, all idle.
    pub fn new(count: usize) -> Arc<Self> {
        Arc::new(Self { idle: AtomicIsize::new(isize::try_from(count).unwrap_or(isize::MAX)) })
    }

    /// Takes a core for a job, whether one is idle or not.
    pub fn occupy(self: &Arc<Self>) -> OccupiedCore {
        self.idle.fetch_sub(1, Ordering::Relaxed);
        OccupiedCore(Arc::clone(self))
    }

    /// Whether there is one to borrow at the moment.
    pub fn has_idle(&self) -> bool {
        self.idle.load(Ordering::Relaxed) > 0
    }

    fn borrow(&self) -> Option<BorrowedCore<'_>> {
        let take = |idle: isize| (idle > 0).then(|| idle - 1);
        let taken = self.idle.fetch_update(Ordering::Relaxed, Ordering::Relaxed, take);
        taken.is_ok().then(|| BorrowedCore(self))
    }
}

impl OccupiedCore {
    /// All the cores that this is one of.
    pub fn all(&self) -> Arc<Cores> {
        Arc::clone(&self.0)
    }
}

impl BorrowedCore<'_> {
    fn is_wanted(&self) -> bool {
        self.0.idle.load(Ordering::Relaxed) < 0
    }
}

impl Drop for OccupiedCore {
    fn drop(&mut self) {
        self.0.idle.fetch_add(1, Ordering::Relaxed);
    }
}

impl Drop for BorrowedCore<'_> {
    fn drop(&mut self) {
        self.0.idle.fetch_add(1, Ordering::Relaxed);
    }
}

/// Time between two looks around while others are still at work.
const LOOK_AROUND: Duration = Duration::from_millis(5);

/// Does each piece of work once: on this thread by `own`, and on idle cores each by a worker that `hire` makes. Pieces are
/// begun in their order. While this thread has nothing left to do but wait for the others, it calls `waiting` every few
/// milliseconds.
pub fn share<T: Send, W: FnMut(T)>(
    cores: Option<&Cores>,
    pieces: Vec<T>,
    mut own: impl FnMut(T),
    hire: impl Fn() -> W + Sync,
    mut waiting: impl FnMut(),
) {
    let most = pieces.len().saturating_sub(1);
    let queue = Mutex::new(pieces.into_iter());
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    let helpers = AtomicUsize::new(0);
    thread::scope(|scope| {
        for core in (0..most).map_while(|_| cores?.borrow()) {
            let (next, hire) = (&next, &hire);
            let shift = Shift::begin(&helpers);
            let help = move || {
                let _shift = shift;
                let mut work = hire();
                while !core.is_wanted()
                    && let Some(piece) = next()
                {
                    work(piece);
                }
            };
            // Without another thread it takes longer, that is all.
            let _ = thread::Builder::new().name("helper".to_owned()).spawn_scoped(scope, help);
        }
        while let Some(piece) = next() {
            own(piece);
        }
        while helpers.load(Ordering::Acquire) > 0 {
            thread::park_timeout(LOOK_AROUND);
            waiting();
        }
    });
}

/// A helper at work; at its end the thread that it helps is woken.
struct Shift<'a> {
    helpers: &'a AtomicUsize,
    owner: Thread,
}

impl<'a> Shift<'a> {
    fn begin(helpers: &'a AtomicUsize) -> Self {
        helpers.fetch_add(1, Ordering::Relaxed);
        Self { helpers, owner: thread::current() }
    }
}

impl Drop for Shift<'_> {
    fn drop(&mut self) {
        self.helpers.fetch_sub(1, Ordering::Release);
        self.owner.unpark();
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;
    use std::sync::Barrier;

    use super::*;

    #[test]
    fn every_piece_is_done_once_and_by_several() {
        let cores = Cores::new(2);
        let _job = cores.occupy();
        let (both, done) = (Barrier::new(2), Mutex::new(Vec::new()));
        let record = |piece: usize| {
            if piece < 2 {
                // Only two threads together get past this.
                both.wait();
            }
            done.lock().unwrap().push((piece, thread::current().id()));
        };
        share(Some(&cores), (0..20).collect(), record, || record, || ());
        let done = done.into_inner().unwrap();
        assert_eq!(done.iter().map(|(piece, _)| *piece).collect::<HashSet<_>>(), (0..20).collect());
        assert_eq!((done.len(), done.iter().map(|(_, id)| *id).collect::<HashSet<_>>().len()), (20, 2));
        assert!(cores.has_idle(), "what was borrowed is given back");
    }

    #[test]
    fn who_waits_looks_around() {
        let cores = Cores::new(2);
        let _job = cores.occupy();
        let (looks, both) = (AtomicUsize::new(0), Barrier::new(2));
        let until_seen = |_: usize| {
            both.wait();
            while looks.load(Ordering::Relaxed) < 3 {
                thread::yield_now();
            }
        };
        let own = |_: usize| {
            both.wait();
        };
        share(Some(&cores), vec![0, 1], own, || until_seen, || _ = looks.fetch_add(1, Ordering::Relaxed));
        assert!(looks.into_inner() >= 3);
    }

    #[test]
    fn nobody_borrows_from_a_full_pool() {
        let cores = Cores::new(2);
        let jobs = [cores.occupy(), cores.occupy()];
        let own = thread::current().id();
        let alone = |()| assert_eq!(thread::current().id(), own);
        share(Some(&cores), vec![(); 5], alone, || alone, || ());
        share(None, vec![(); 5], alone, || alone, || ());
        drop(jobs);
        assert!(cores.borrow().is_some());
    }

    #[test]
    fn a_borrowed_core_is_left_when_a_job_comes() {
        let cores = Cores::new(2);
        let _job = cores.occupy();
        let core = cores.borrow().unwrap();
        assert!(!core.is_wanted() && cores.borrow().is_none());
        let other = cores.occupy();
        assert!(core.is_wanted());
        drop(core);
        assert!(!cores.has_idle());
        drop(other);
        assert!(cores.has_idle());
    }
}
