//! Fair access of API keys to a scarce resource: the requests of a key queue behind each other,
//! never in front of another key's.

use std::collections::HashMap;
use std::panic::resume_unwind;
use std::sync::{Arc, Mutex, PoisonError, Weak};

use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::task::spawn_blocking;
use uuid::Uuid;

use super::KeyId;

/// The turns of all keys.
#[derive(Debug)]
pub struct Turns {
    at_once: usize,
    keys: Mutex<HashMap<KeyId, Weak<Semaphore>>>,
}

impl Turns {
    /// Gives each key at most `at_once` turns at a time.
    pub fn new(at_once: usize) -> Self {
        Self { at_once, keys: Mutex::default() }
    }

    /// Waits for a turn, which ends when the returned value is dropped. A request without a key
    /// does not wait.
    pub async fn take(&self, key: Option<KeyId>) -> Turn {
        let permit = match key {
            Some(key) => self.of(key).acquire_owned().await.ok(),
            None => None,
        };
        Turn { _permit: permit }
    }

    /// Returns a turn if one is free.
    pub fn try_take(&self, key: Option<KeyId>) -> Option<Turn> {
        match key {
            Some(key) => Some(Turn { _permit: Some(self.of(key).try_acquire_owned().ok()?) }),
            None => Some(Turn::free()),
        }
    }

    fn of(&self, key: KeyId) -> Arc<Semaphore> {
        let mut keys = self.keys.lock().unwrap_or_else(PoisonError::into_inner);
        keys.retain(|_, turns| turns.strong_count() > 0);
        if let Some(turns) = keys.get(&key).and_then(Weak::upgrade) {
            return turns;
        }
        let turns = Arc::new(Semaphore::new(self.at_once));
        keys.insert(key, Arc::downgrade(&turns));
        turns
    }
}

/// The turn of a key.
#[derive(Debug)]
pub struct Turn {
    _permit: Option<OwnedSemaphorePermit>,
}

impl Turn {
    /// A turn that takes no place.
    pub fn free() -> Self {
        Self { _permit: None }
    }
}

/// Threads for long computations. Requests without a key share one turn.
#[derive(Debug)]
pub struct Threads {
    keys: Turns,
    places: Arc<Semaphore>,
}

impl Threads {
    /// Allows `at_once` computations, at most `of_key` of them for one key.
    pub fn new(at_once: usize, of_key: usize) -> Self {
        Self { keys: Turns::new(of_key), places: Arc::new(Semaphore::new(at_once)) }
    }

    /// Runs a closure on a blocking thread. The closure keeps its place until it ends, even if the
    /// caller's future is dropped.
    pub async fn run<T: Send + 'static>(
        &self,
        key: Option<KeyId>,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> T {
        let turn = self.keys.take(key.or(Some(KeyId::from(Uuid::nil())))).await;
        let place = Arc::clone(&self.places).acquire_owned().await;
        let run = move || {
            let _held = (turn, place);
            work()
        };
        // The runtime lives as long as the process, so the only error left is a panic of the
        // closure.
        spawn_blocking(run).await.unwrap_or_else(|error| resume_unwind(error.into_panic()))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc;

    use super::*;
    use futures_util::FutureExt;

    #[tokio::test]
    async fn work_keeps_its_place_although_nobody_waits_for_it() {
        let threads = Threads::new(2, 1);
        let (end, ended) = mpsc::channel::<()>();
        let mut left = Box::pin(threads.run(None, move || ended.recv().is_ok()));
        assert!((&mut left).now_or_never().is_none());
        drop(left);
        let mut next = Box::pin(threads.run(None, || ()));
        assert!((&mut next).now_or_never().is_none());
        assert_eq!(threads.places.available_permits(), 1, "a turn is waited for before a place");
        threads.run(Some(KeyId::generate()), || ()).await;
        end.send(()).unwrap();
        next.await;
    }

    #[tokio::test]
    async fn keys_wait_for_themselves_alone_and_leave_nothing_behind() {
        let turns = Turns::new(2);
        let (one, other) = (KeyId::generate(), KeyId::generate());
        let first = (turns.take(Some(one)).await, turns.take(Some(one)).await);
        let mut third = Box::pin(turns.take(Some(one)));
        assert!((&mut third).now_or_never().is_none());
        assert!(
            turns.take(Some(other)).now_or_never().is_some()
                && turns.take(None).now_or_never().is_some()
        );
        drop(first);
        drop(third.await);
        turns.take(Some(other)).await;
        assert_eq!(turns.keys.lock().unwrap().len(), 1);
    }
}
