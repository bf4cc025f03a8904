//! Places of a worker, one more than it has solvers: a key may hold as many places as there are
//! solvers, and leaves one place to other keys. Each place has memory of its own; larger jobs
//! share the rest. A long job gives its place back and takes shared memory instead.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::{Notify, OwnedSemaphorePermit, Semaphore};

use crate::jobs::Claim;

/// All places of a worker.
#[derive(Debug)]
pub(super) struct Slots {
    places: Arc<Semaphore>,
    memory: Memory,
    shared: Mutex<Shared>,
    freed: Notify,
}

/// What jobs share beside their places.
#[derive(Debug, Default)]
struct Shared {
    /// Memory \[bytes\] that large and long jobs have taken.
    used: u64,
    /// Whether a large job waits for memory, which long jobs leave to it.
    large_pending: bool,
}

/// Memory \[bytes\] of a worker.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Memory {
    /// Memory \[bytes\] that large jobs share.
    pub(super) shared: u64,
    /// Memory \[bytes\] of each place.
    pub(super) of_place: u64,
}

/// Places reserved for jobs that have not been claimed yet.
#[derive(Debug)]
pub(super) struct Reservation(Vec<OwnedSemaphorePermit>);

/// The place and the memory of one job, released when dropped. A long job has no place.
#[derive(Debug)]
pub(super) struct Slot {
    slots: Arc<Slots>,
    memory: u64,
    place: Option<OwnedSemaphorePermit>,
}

impl Slots {
    pub(super) fn new(n_solvers: usize, memory: Memory) -> Self {
        Self {
            places: Arc::new(Semaphore::new(n_solvers + 1)),
            memory,
            shared: Mutex::default(),
            freed: Notify::new(),
        }
    }

    /// Waits for a free place and takes all free places.
    pub(super) async fn take(&self) -> Reservation {
        let mut permits: Vec<_> =
            Arc::clone(&self.places).acquire_owned().await.into_iter().collect();
        while let Ok(permit) = Arc::clone(&self.places).try_acquire_owned() {
            permits.push(permit);
        }
        Reservation(permits)
    }

    /// Returns the memory \[bytes\] of the whole worker.
    pub(super) fn memory(&self) -> Memory {
        self.memory
    }

    /// Returns the memory \[bytes\] still free for large jobs.
    pub(super) fn free_memory(&self) -> u64 {
        self.memory.shared.saturating_sub(self.shared().used)
    }

    /// Waits until a job releases its place and memory.
    pub(super) async fn freed(&self) {
        self.freed.notified().await;
    }

    /// Tells whether a large job waits for memory.
    pub(super) fn set_large_pending(&self, is_pending: bool) {
        self.shared().large_pending = is_pending;
    }

    fn shared(&self) -> MutexGuard<'_, Shared> {
        self.shared.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Reservation {
    /// Returns the number of reserved places.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Assigns a place to a job; `None` if no place is left.
    pub(super) fn assign(&mut self, slots: &Arc<Slots>, claim: &Claim) -> Option<Slot> {
        let place = Some(self.0.pop()?);
        let memory = if claim.memory > slots.memory.of_place { claim.memory } else { 0 };
        slots.shared().used += memory;
        Some(Slot { slots: Arc::clone(slots), memory, place })
    }
}

impl Slot {
    /// Gives the place of a long job to another job, if there is memory for it beside the places.
    /// Returns whether the job still holds one.
    pub(super) fn give_place_back(&mut self) -> bool {
        let mut shared = self.slots.shared();
        let needed = if self.memory == 0 { self.slots.memory.of_place } else { 0 };
        let used = shared.used + needed;
        if self.place.is_some() && !shared.large_pending && used <= self.slots.memory.shared {
            shared.used = used;
            drop(shared);
            self.memory += needed;
            self.place = None;
            self.slots.freed.notify_one();
        }
        self.place.is_some()
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        let mut shared = self.slots.shared();
        shared.used = shared.used.saturating_sub(self.memory);
        drop(shared);
        self.place = None;
        self.slots.freed.notify_one();
    }
}

#[cfg(test)]
mod tests {
    use bytes::Bytes;

    use super::*;
    use crate::jobs::{JobId, Lease, WorkerId};

    const MEMORY: Memory = Memory { shared: 100, of_place: 10 };

    fn claim(memory: u64) -> Claim {
        let lease = Lease { job: JobId::generate(), owner: WorkerId::generate(), attempt: 1 };
        Claim { lease, memory, request: Bytes::new(), trace: None }
    }

    #[tokio::test]
    async fn places_are_taken_and_given_back() {
        let slots = Arc::new(Slots::new(3, MEMORY));
        let mut reservation = slots.take().await;
        assert_eq!(reservation.len(), 4, "one more than solvers");
        let slot = reservation.assign(&slots, &claim(60)).unwrap();
        let small = reservation.assign(&slots, &claim(10)).unwrap();
        drop(reservation);
        assert_eq!(slots.free_memory(), 40, "a small job has memory of its own");
        let reservation = slots.take().await;
        assert_eq!(reservation.len(), 2);
        drop((reservation, slot, small));
        slots.freed().await;
        let mut reservation = slots.take().await;
        assert_eq!((reservation.len(), slots.free_memory()), (4, 100));
        let taken: Vec<_> = (0..4).filter_map(|_| reservation.assign(&slots, &claim(0))).collect();
        assert_eq!((taken.len(), reservation.len()), (4, 0));
        assert!(reservation.assign(&slots, &claim(0)).is_none());
    }

    #[tokio::test]
    async fn long_jobs_give_their_places_back_while_there_is_memory() {
        let slots = Arc::new(Slots::new(1, MEMORY));
        let mut long = Vec::new();
        for free in (0..10).rev() {
            let mut slot = slots.take().await.assign(&slots, &claim(5)).unwrap();
            assert!(!slot.give_place_back());
            assert_eq!(slots.free_memory(), free * 10);
            long.push(slot);
        }
        let mut reservation = slots.take().await;
        assert_eq!(reservation.len(), 2, "ten jobs run");
        let mut last = reservation.assign(&slots, &claim(5)).unwrap();
        assert!(last.give_place_back(), "no memory is left");
        drop(long.pop());
        slots.set_large_pending(true);
        assert!(last.give_place_back(), "the memory is for the large job");
        slots.set_large_pending(false);
        assert!(!last.give_place_back());
    }
}
