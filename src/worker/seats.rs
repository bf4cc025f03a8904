//! Room to solve in: a number of solvers, and memory shared by the jobs they solve.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::{Notify, OwnedSemaphorePermit, Semaphore};

/// All seats of a worker.
#[derive(Debug)]
pub(super) struct Seats {
    solvers: Arc<Semaphore>,
    n_solvers: usize,
    memory: u64,
    used: Mutex<u64>,
    freed: Notify,
}

/// Solvers taken for jobs that are not chosen yet.
#[derive(Debug)]
pub(super) struct Taken {
    permits: Vec<OwnedSemaphorePermit>,
    /// These are all there are.
    pub(super) all: bool,
}

/// The room of one job, given back when dropped.
#[derive(Debug)]
pub(super) struct Seat {
    seats: Arc<Seats>,
    memory: u64,
    _permits: Vec<OwnedSemaphorePermit>,
}

impl Seats {
    pub(super) fn new(n_solvers: usize, memory: u64) -> Self {
        let solvers = Arc::new(Semaphore::new(n_solvers));
        Self { solvers, n_solvers, memory, used: Mutex::new(0), freed: Notify::new() }
    }

    /// Waits for a free solver, or for all of them, and takes all that are free.
    pub(super) async fn take(&self, all: bool) -> Taken {
        let least = if all { u32::try_from(self.n_solvers).unwrap_or(u32::MAX) } else { 1 };
        let first = Arc::clone(&self.solvers).acquire_many_owned(least).await;
        let mut n_taken = if all { self.n_solvers } else { 1 };
        let mut permits: Vec<OwnedSemaphorePermit> = first.into_iter().collect();
        while let Ok(permit) = Arc::clone(&self.solvers).try_acquire_owned() {
            permits.push(permit);
            n_taken += 1;
        }
        Taken { all: n_taken == self.n_solvers, permits }
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

impl Taken {
    /// How many solvers these are.
    pub(super) fn len(&self) -> usize {
        self.permits.iter().map(OwnedSemaphorePermit::num_permits).sum()
    }

    /// Seats a job on one solver, or on all of them if it must be alone. `None` if there is none.
    pub(super) fn seat(&mut self, seats: &Arc<Seats>, alone: bool, memory: u64) -> Option<Seat> {
        let permits = if alone {
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
        *seats.used() += memory;
        Some(Seat { seats: Arc::clone(seats), memory, _permits: permits })
    }
}

impl Drop for Seat {
    fn drop(&mut self) {
        let mut used = self.seats.used();
        *used = used.saturating_sub(self.memory);
        self.seats.freed.notify_one();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn seats_are_taken_and_given_back() {
        let seats = Arc::new(Seats::new(3, 100));
        let mut taken = seats.take(false).await;
        assert_eq!((taken.len(), taken.all), (3, true));
        let seat = taken.seat(&seats, false, 60).unwrap();
        drop(taken);
        assert_eq!(seats.free_memory(), 40);
        let taken = seats.take(false).await;
        assert_eq!((taken.len(), taken.all), (2, false));
        drop((taken, seat));
        seats.freed().await;
        let mut taken = seats.take(true).await;
        assert_eq!((taken.len(), taken.all, seats.free_memory()), (3, true, 100));
        let first = taken.seat(&seats, false, 0).unwrap();
        assert_eq!(taken.len(), 2);
        let alone = taken.seat(&seats, true, 0).unwrap();
        assert_eq!(taken.len(), 0);
        assert!(taken.seat(&seats, false, 0).is_none());
        drop((first, alone));
    }
}
