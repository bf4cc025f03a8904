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
    n_places: usize,
    memory: Memory,
    shared: Mutex<Shared>,
    freed: Notify,
}

/// What jobs share beside their places.
#[derive(Debug, Default)]
struct Shared {
    /// Memory \[bytes\] that large and long jobs have taken.
    used: u64,
    /// Jobs that have given their places back.
    without_place: usize,
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
pub(super) struct Reservation {
    permits: Vec<OwnedSemaphorePermit>,
    /// Whether these are all places: no job runs.
    pub(super) all: bool,
}

/// The places and the memory of one job, released when dropped.
#[derive(Debug)]
pub(super) struct Slot {
    slots: Arc<Slots>,
    memory: u64,
    permits: Vec<OwnedSemaphorePermit>,
}

impl Slots {
    pub(super) fn new(n_solvers: usize, memory: Memory) -> Self {
        let n_places = n_solvers + 1;
        Self {
            places: Arc::new(Semaphore::new(n_places)),
            n_places,
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
        let all = permits.len() == self.n_places && self.shared().without_place == 0;
        Reservation { permits, all }
    }

    /// Waits until no job runs and takes all places.
    pub(super) async fn take_all(&self) -> Reservation {
        let mut permits = Vec::with_capacity(self.n_places);
        while permits.len() < self.n_places {
            permits.extend(Arc::clone(&self.places).acquire_owned().await);
        }
        while self.shared().without_place > 0 {
            self.freed.notified().await;
        }
        Reservation { all: true, permits }
    }

    /// Returns the memory \[bytes\] of the whole worker.
    pub(super) fn memory(&self) -> Memory {
        self.memory
    }

    /// Returns the memory \[bytes\] still free for large jobs.
    pub(super) fn free_memory(&self) -> u64 {
        self.memory.shared.saturating_sub(self.shared().used)
    }

    /// Waits until a job releases its places and memory.
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
        self.permits.len()
    }

    /// Assigns a place to a job, or all places if the job must run alone. `None` if no place is
    /// left.
    pub(super) fn assign(&mut self, slots: &Arc<Slots>, claim: &Claim) -> Option<Slot> {
        let kept = if claim.exclusive { 0 } else { self.permits.len().checked_sub(1)? };
        let permits = self.permits.split_off(kept);
        let memory = if claim.memory > slots.memory.of_place { claim.memory } else { 0 };
        slots.shared().used += memory;
        Some(Slot { slots: Arc::clone(slots), memory, permits })
    }
}

impl Slot {
    /// Gives the place of a long job to another job, if there is memory for it beside the places.
    /// Returns whether the job still holds one. A job that must run alone keeps all places.
    pub(super) fn give_place_back(&mut self) -> bool {
        let mut shared = self.slots.shared();
        let needed = if self.memory == 0 { self.slots.memory.of_place } else { 0 };
        let used = shared.used + needed;
        if self.permits.len() == 1 && !shared.large_pending && used <= self.slots.memory.shared {
            shared.used = used;
            shared.without_place += 1;
            drop(shared);
            self.memory += needed;
            self.permits.clear();
            self.slots.freed.notify_one();
        }
        !self.permits.is_empty()
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        let mut shared = self.slots.shared();
        shared.used = shared.used.saturating_sub(self.memory);
        shared.without_place -= usize::from(self.permits.is_empty());
        drop(shared);
        self.permits.clear();
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
        Claim { lease, exclusive: false, memory, request: Bytes::new(), trace: None }
    }

    #[tokio::test]
    async fn places_are_taken_and_given_back() {
        let slots = Arc::new(Slots::new(3, MEMORY));
        let mut reservation = slots.take().await;
        assert_eq!((reservation.len(), reservation.all), (4, true), "one more than solvers");
        let slot = reservation.assign(&slots, &claim(60)).unwrap();
        let small = reservation.assign(&slots, &claim(10)).unwrap();
        drop(reservation);
        assert_eq!(slots.free_memory(), 40, "a small job has memory of its own");
        let reservation = slots.take().await;
        assert_eq!((reservation.len(), reservation.all), (2, false));
        drop((reservation, slot, small));
        slots.freed().await;
        let mut reservation = slots.take_all().await;
        assert_eq!((reservation.len(), reservation.all, slots.free_memory()), (4, true, 100));
        let first = reservation.assign(&slots, &claim(0)).unwrap();
        assert_eq!(reservation.len(), 3);
        let exclusive =
            reservation.assign(&slots, &Claim { exclusive: true, ..claim(0) }).unwrap();
        assert_eq!(reservation.len(), 0);
        assert!(reservation.assign(&slots, &claim(0)).is_none());
        drop((first, exclusive));
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
        assert_eq!((reservation.len(), reservation.all), (2, false), "ten jobs run");
        let mut last = reservation.assign(&slots, &claim(5)).unwrap();
        assert!(last.give_place_back(), "no memory is left");
        drop(long.pop());
        slots.set_large_pending(true);
        assert!(last.give_place_back(), "the memory is for the large job");
        slots.set_large_pending(false);
        assert!(!last.give_place_back());
        drop((reservation, last, long));
        let mut reservation = slots.take_all().await;
        let alone = Claim { exclusive: true, ..claim(5) };
        let mut alone = reservation.assign(&slots, &alone).unwrap();
        assert!(alone.give_place_back(), "it runs alone");
    }
}
