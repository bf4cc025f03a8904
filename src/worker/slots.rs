//! Slots of a worker: a number of solvers, and memory that their jobs share.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::{Notify, OwnedSemaphorePermit, Semaphore};

/// All slots of a worker.
#[derive(Debug)]
pub(super) struct Slots {
    solvers: Arc<Semaphore>,
    n_solvers: usize,
    memory: u64,
    used: Mutex<u64>,
    freed: Notify,
}

/// Solvers reserved for jobs that have not been claimed yet.
#[derive(Debug)]
pub(super) struct Reservation {
    permits: Vec<OwnedSemaphorePermit>,
    /// These are all there are.
    pub(super) all: bool,
}

/// The solvers and the memory of one job, released when dropped.
#[derive(Debug)]
pub(super) struct Slot {
    slots: Arc<Slots>,
    memory: u64,
    _permits: Vec<OwnedSemaphorePermit>,
}

impl Slots {
    pub(super) fn new(n_solvers: usize, memory: u64) -> Self {
        let solvers = Arc::new(Semaphore::new(n_solvers));
        Self { solvers, n_solvers, memory, used: Mutex::new(0), freed: Notify::new() }
    }

    /// Waits for a free solver, or for all of them, and takes all that are free.
    pub(super) async fn take(&self, all: bool) -> Reservation {
        let least = if all { u32::try_from(self.n_solvers).unwrap_or(u32::MAX) } else { 1 };
        let first = Arc::clone(&self.solvers).acquire_many_owned(least).await;
        let mut n_taken = if all { self.n_solvers } else { 1 };
        let mut permits: Vec<OwnedSemaphorePermit> = first.into_iter().collect();
        while let Ok(permit) = Arc::clone(&self.solvers).try_acquire_owned() {
            permits.push(permit);
            n_taken += 1;
        }
        Reservation { all: n_taken == self.n_solvers, permits }
    }

    /// Memory \[bytes\] of the whole worker.
    pub(super) fn memory(&self) -> u64 {
        self.memory
    }

    /// Memory \[bytes\] no job has taken.
    pub(super) fn free_memory(&self) -> u64 {
        self.memory.saturating_sub(*self.used())
    }

    /// Waits until a job has given its room back.
    pub(super) async fn freed(&self) {
        self.freed.notified().await;
    }

    fn used(&self) -> MutexGuard<'_, u64> {
        self.used.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Reservation {
    /// How many solvers these are.
    pub(super) fn len(&self) -> usize {
        self.permits.iter().map(OwnedSemaphorePermit::num_permits).sum()
    }

    /// Assigns one solver to a job, or on all of them if it must be alone. `None` if there is none.
    pub(super) fn assign(&mut self, slots: &Arc<Slots>, exclusive: bool, memory: u64) -> Option<Slot> {
        let permits = if exclusive {
            std::mem::take(&mut self.permits)
        } else {
            let mut last = self.permits.pop()?;
            match last.split(1) {
                Some(one) if last.num_permits() > 0 => {
                    self.permits.push(last);
                    vec![one]
                }
                Some(one) => vec![one],
                None => vec![last],
            }
        };
        *slots.used() += memory;
        Some(Slot { slots: Arc::clone(slots), memory, _permits: permits })
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        let mut used = self.slots.used();
        *used = used.saturating_sub(self.memory);
        self.slots.freed.notify_one();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn seats_are_taken_and_given_back() {
        let slots = Arc::new(Slots::new(3, 100));
        let mut reservation = slots.take(false).await;
        assert_eq!((reservation.len(), reservation.all), (3, true));
        let slot = reservation.assign(&slots, false, 60).unwrap();
        drop(reservation);
        assert_eq!(slots.free_memory(), 40);
        let reservation = slots.take(false).await;
        assert_eq!((reservation.len(), reservation.all), (2, false));
        drop((reservation, slot));
        slots.freed().await;
        let mut reservation = slots.take(true).await;
        assert_eq!((reservation.len(), reservation.all, slots.free_memory()), (3, true, 100));
        let first = reservation.assign(&slots, false, 0).unwrap();
        assert_eq!(reservation.len(), 2);
        let exclusive = reservation.assign(&slots, true, 0).unwrap();
        assert_eq!(reservation.len(), 0);
        assert!(reservation.assign(&slots, false, 0).is_none());
        drop((first, exclusive));
    }
}
