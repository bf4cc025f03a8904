//! Slots of a worker: a number of solvers, and memory that their jobs share.
//!
//! Where a long job holds a solver, short jobs have as many places again and one more, with memory of their own: they share the cores
//! with the long ones instead of waiting for them.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::jobs::{Claim, SHORT_WORK};
use tokio::sync::{Notify, OwnedSemaphorePermit, Semaphore};

/// All slots of a worker.
#[derive(Debug)]
pub(super) struct Slots {
    solvers: Arc<Semaphore>,
    /// Places for short jobs beside the solvers.
    beside: Arc<Semaphore>,
    n_solvers: usize,
    n_beside: usize,
    memory: Memory,
    used: Mutex<Used>,
    freed: Notify,
}

/// Memory \[bytes\] of a worker.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Memory {
    /// Of the jobs that hold a solver.
    pub(super) solvers: u64,
    /// Of the short jobs beside them.
    pub(super) beside: u64,
}

/// What running jobs take.
#[derive(Debug, Default)]
struct Used {
    memory: Memory,
    /// Solvers that long jobs hold.
    long: usize,
}

/// Solvers reserved for jobs that have not been claimed yet.
#[derive(Debug)]
pub(super) struct Reservation {
    permits: Vec<OwnedSemaphorePermit>,
    beside: Vec<OwnedSemaphorePermit>,
    /// These are all there are, and nothing runs.
    pub(super) all: bool,
}

/// The solvers and the memory of one job, released when dropped.
#[derive(Debug)]
pub(super) struct Slot {
    slots: Arc<Slots>,
    memory: u64,
    beside: bool,
    long: bool,
    _permits: Vec<OwnedSemaphorePermit>,
}

/// Places for short jobs beside so many solvers: one more, so that each core has a job that does not wait for a place.
pub(super) const fn places_beside(n_solvers: usize) -> usize {
    n_solvers + 1
}

impl Slots {
    pub(super) fn new(n_solvers: usize, memory: Memory) -> Self {
        let n_beside = places_beside(n_solvers);
        Self {
            solvers: Arc::new(Semaphore::new(n_solvers)),
            beside: Arc::new(Semaphore::new(n_beside)),
            n_solvers,
            n_beside,
            memory,
            used: Mutex::default(),
            freed: Notify::new(),
        }
    }

    /// Waits for a free solver, or for a free place beside a long job, and takes all that are free.
    pub(super) async fn take(&self) -> Reservation {
        // Only who takes slots gives solvers to long jobs: this does not become true while it waits.
        let has_long = self.used().long > 0;
        let (mut permits, mut beside) = (Vec::new(), Vec::new());
        tokio::select! {
            biased;
            solver = Arc::clone(&self.solvers).acquire_owned() => permits.extend(solver),
            place = Arc::clone(&self.beside).acquire_owned(), if has_long => beside.extend(place),
        }
        while let Ok(permit) = Arc::clone(&self.solvers).try_acquire_owned() {
            permits.push(permit);
        }
        while has_long && let Ok(permit) = Arc::clone(&self.beside).try_acquire_owned() {
            beside.push(permit);
        }
        let n_idle = permits.len() + beside.len() + self.beside.available_permits();
        Reservation { all: n_idle == self.n_solvers + self.n_beside, permits, beside }
    }

    /// Waits until nothing runs, and takes all solvers.
    pub(super) async fn take_all(&self) -> Reservation {
        let all = |places| u32::try_from(places).unwrap_or(u32::MAX);
        let solvers = Arc::clone(&self.solvers).acquire_many_owned(all(self.n_solvers));
        let permits = solvers.await.into_iter().collect();
        let beside = Arc::clone(&self.beside).acquire_many_owned(all(self.n_beside));
        let beside = beside.await.into_iter().collect();
        Reservation { all: true, permits, beside }
    }

    /// Memory \[bytes\] of the whole worker.
    pub(super) fn memory(&self) -> Memory {
        self.memory
    }

    /// Memory \[bytes\] no job has taken.
    pub(super) fn free_memory(&self) -> Memory {
        let used = self.used().memory;
        Memory {
            solvers: self.memory.solvers.saturating_sub(used.solvers),
            beside: self.memory.beside.saturating_sub(used.beside),
        }
    }

    /// Waits until a job has given its room back.
    pub(super) async fn freed(&self) {
        self.freed.notified().await;
    }

    fn used(&self) -> MutexGuard<'_, Used> {
        self.used.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Used {
    fn memory(&mut self, beside: bool) -> &mut u64 {
        if beside { &mut self.memory.beside } else { &mut self.memory.solvers }
    }
}

impl Reservation {
    /// How many solvers these are.
    pub(super) fn len(&self) -> usize {
        self.permits.iter().map(OwnedSemaphorePermit::num_permits).sum()
    }

    /// How many places beside them.
    pub(super) fn len_beside(&self) -> usize {
        self.beside.iter().map(OwnedSemaphorePermit::num_permits).sum()
    }

    /// Assigns the place that a job was claimed for; all solvers if it must be alone. `None` if there is none.
    pub(super) fn assign(&mut self, slots: &Arc<Slots>, claim: &Claim) -> Option<Slot> {
        let permits = if claim.exclusive {
            std::mem::take(&mut self.permits)
        } else {
            let free = if claim.beside { &mut self.beside } else { &mut self.permits };
            let mut last = free.pop()?;
            match last.split(1) {
                Some(one) if last.num_permits() > 0 => {
                    free.push(last);
                    vec![one]
                }
                Some(one) => vec![one],
                None => vec![last],
            }
        };
        let (memory, beside) = (claim.memory, claim.beside);
        let long = claim.work > SHORT_WORK && !beside;
        let mut used = slots.used();
        *used.memory(beside) += memory;
        used.long += usize::from(long);
        drop(used);
        Some(Slot { slots: Arc::clone(slots), memory, beside, long, _permits: permits })
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        let mut used = self.slots.used();
        let memory = used.memory(self.beside);
        *memory = memory.saturating_sub(self.memory);
        used.long -= usize::from(self.long);
        self.slots.freed.notify_one();
    }
}

#[cfg(test)]
mod tests {
    use bytes::Bytes;

    use super::*;
    use crate::jobs::{JobId, Lease, WorkerId};

    const MEMORY: Memory = Memory { solvers: 100, beside: 10 };

    fn claim(memory: u64) -> Claim {
        let lease = Lease { job: JobId::generate(), owner: WorkerId::generate(), attempt: 1 };
        Claim {
            lease,
            exclusive: false,
            beside: false,
            gives_way: false,
            work: 1,
            memory,
            request: Bytes::new(),
            trace: None,
        }
    }

    #[tokio::test]
    async fn slots_are_taken_and_given_back() {
        let slots = Arc::new(Slots::new(3, MEMORY));
        let mut reservation = slots.take().await;
        assert_eq!((reservation.len(), reservation.len_beside(), reservation.all), (3, 0, true));
        let slot = reservation.assign(&slots, &claim(60)).unwrap();
        drop(reservation);
        assert_eq!(slots.free_memory(), Memory { solvers: 40, beside: 10 });
        let reservation = slots.take().await;
        assert_eq!((reservation.len(), reservation.all), (2, false));
        drop((reservation, slot));
        slots.freed().await;
        let mut reservation = slots.take_all().await;
        assert_eq!((reservation.len(), reservation.all, slots.free_memory()), (3, true, MEMORY));
        let first = reservation.assign(&slots, &claim(0)).unwrap();
        assert_eq!(reservation.len(), 2);
        let exclusive = reservation.assign(&slots, &Claim { exclusive: true, ..claim(0) }).unwrap();
        assert_eq!(reservation.len(), 0);
        assert!(reservation.assign(&slots, &claim(0)).is_none());
        drop((first, exclusive));
    }

    #[tokio::test]
    async fn short_jobs_have_places_beside_long_ones_only() {
        let slots = Arc::new(Slots::new(1, MEMORY));
        let mut reservation = slots.take().await;
        let long = reservation.assign(&slots, &Claim { work: SHORT_WORK + 1, ..claim(100) }).unwrap();
        drop(reservation);
        let mut reservation = slots.take().await;
        assert_eq!((reservation.len(), reservation.len_beside(), reservation.all), (0, 2, false));
        assert!(reservation.assign(&slots, &claim(1)).is_none(), "the solver is taken");
        let short = reservation.assign(&slots, &Claim { beside: true, ..claim(4) }).unwrap();
        assert_eq!(slots.free_memory(), Memory { solvers: 0, beside: 6 });
        drop((long, reservation));
        let reservation = slots.take().await;
        assert_eq!((reservation.len(), reservation.len_beside()), (1, 0), "the solver is free again");
        assert!(!reservation.all, "a short job runs still");
        drop((reservation, short));
        assert!(slots.take().await.all);
        assert_eq!(slots.free_memory(), MEMORY);
    }
}
