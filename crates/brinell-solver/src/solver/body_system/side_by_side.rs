//! The same work for both bodies: at the same time where it is large and a core idle, else one after the other.

use std::cell::RefCell;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use crate::solver::phases::{Phase, PhaseTimes};
use crate::solver::{Interrupt, Observer, SolveError};
use sparse_cholesky::{Cores, share};

/// Nodes of both bodies from which on it pays to prepare them at the same time: tens of milliseconds of work.
pub(crate) const LARGE: usize = 20_000;

/// Does `work` for each body; returns what comes of it in their order. For the time of others' work that this thread does
/// not fill with its own, `phases` has factorization, which most of it is.
pub(crate) fn side_by_side<T: Send, R: Send>(
    bodies: Vec<T>,
    is_large: bool,
    phases: &mut PhaseTimes,
    observer: &mut dyn Observer,
    work: impl Fn(T, &mut PhaseTimes, &mut dyn Observer) -> Result<R, SolveError> + Sync,
) -> Result<Vec<R>, SolveError> {
    let count = bodies.len();
    let Some(cores) = observer.cores().filter(|_| is_large && count > 1) else {
        return bodies.into_iter().map(|body| work(body, phases, observer)).collect();
    };
    let outcomes = Mutex::new(Vec::with_capacity(count));
    let stopped = AtomicBool::new(false);
    let note = |k: usize, outcome: Result<R, SolveError>| {
        stopped.fetch_or(outcome.is_err(), Ordering::Relaxed);
        outcomes.lock().unwrap_or_else(PoisonError::into_inner).push((k, outcome));
    };
    let hire = || {
        |(k, body)| {
            let mut observer = Aside { stopped: &stopped, cores: &cores };
            match work(body, &mut PhaseTimes::default(), &mut observer) {
                // There is a reason, and it is noted.
                Err(SolveError::Interrupted(_)) => {}
                outcome => note(k, outcome),
            }
        }
    };
    let mut wish = None;
    let mut left = observer.elapsed();
    let shared = RefCell::new((&mut *phases, &mut *observer));
    let own = |(k, body)| {
        let (phases, observer) = &mut *shared.borrow_mut();
        note(k, work(body, phases, *observer));
        left = observer.elapsed();
    };
    let waiting = || {
        if let ControlFlow::Break(interrupt) = shared.borrow_mut().1.on_checkpoint() {
            wish = Some(interrupt);
            stopped.store(true, Ordering::Relaxed);
        }
    };
    share(Some(&*cores), bodies.into_iter().enumerate().collect(), own, hire, waiting);
    phases.book(Phase::Numeric, observer.elapsed().saturating_sub(left));
    let mut outcomes = outcomes.into_inner().unwrap_or_else(PoisonError::into_inner);
    outcomes.sort_by_key(|(k, _)| *k);
    let done: Vec<R> = outcomes.into_iter().map(|(_, outcome)| outcome).collect::<Result<_, _>>()?;
    if done.len() < count {
        return Err(SolveError::Interrupted(wish.unwrap_or(Interrupt::Cancelled)));
    }
    Ok(done)
}

/// Watches work on another thread, where nobody has the job's observer.
struct Aside<'a> {
    stopped: &'a AtomicBool,
    cores: &'a Arc<Cores>,
}

impl Observer for Aside<'_> {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        if self.stopped.load(Ordering::Relaxed) {
            ControlFlow::Break(Interrupt::Cancelled)
        } else {
            ControlFlow::Continue(())
        }
    }

    fn cores(&self) -> Option<Arc<Cores>> {
        Some(Arc::clone(self.cores))
    }
}
