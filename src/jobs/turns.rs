//! API keys take turns at something that there is little of: a key that floods waits for itself, where others would wait with it.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::time::Duration;

use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{Instant, sleep};

use super::KeyId;

/// Pause after a turn that others of the same key wait for, in times of how long it took.
const REST: u32 = 2;

/// Longest pause. A turn that takes longer was held up by something else, a disk perhaps.
const LONGEST_REST: Duration = Duration::from_millis(50);

/// The turns of all keys.
#[derive(Debug)]
pub struct Turns {
    at_once: usize,
    keys: Mutex<HashMap<KeyId, Weak<Semaphore>>>,
}

impl Turns {
    /// Each key has so many turns at a time.
    pub fn new(at_once: usize) -> Self {
        Self { at_once, keys: Mutex::default() }
    }

    /// Waits for a turn, which ends when what is returned is dropped. Without a key there is none to wait for.
    pub async fn take(&self, key: Option<KeyId>) -> Turn {
        let permit = match key {
            Some(key) => self.of(key).acquire_owned().await.ok(),
            None => None,
        };
        Turn { permit, begin: Instant::now() }
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
    permit: Option<OwnedSemaphorePermit>,
    begin: Instant,
}

impl Turn {
    /// One that nobody waits for.
    pub fn free() -> Self {
        Self { permit: None, begin: Instant::now() }
    }

    /// Whether the key has no other turn left.
    pub fn is_last(&self) -> bool {
        self.permit.as_ref().is_some_and(|permit| permit.semaphore().available_permits() == 0)
    }

    /// Ends it. Where others of the key wait for theirs, the next one begins after twice the time that this one took, 50 ms at most: a
    /// key that floods leaves two thirds of the time to other keys.
    pub fn end(self) {
        let Some(permit) = self.permit else { return };
        // Whoever waits holds the turns too.
        if Arc::strong_count(permit.semaphore()) > 1 {
            let rest = (REST * self.begin.elapsed()).min(LONGEST_REST);
            tokio::spawn(async move {
                sleep(rest).await;
                drop(permit);
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::FutureExt;

    #[tokio::test]
    async fn keys_wait_for_themselves_alone_and_leave_nothing_behind() {
        let turns = Turns::new(2);
        let (one, other) = (KeyId::generate(), KeyId::generate());
        let first = (turns.take(Some(one)).await, turns.take(Some(one)).await);
        let mut third = Box::pin(turns.take(Some(one)));
        assert!((&mut third).now_or_never().is_none());
        assert!(
            turns.take(Some(other)).now_or_never().is_some() && turns.take(None).now_or_never().is_some()
        );
        drop(first);
        drop(third.await);
        turns.take(Some(other)).await;
        assert_eq!(turns.keys.lock().unwrap().len(), 1);
    }

    #[tokio::test]
    async fn a_key_that_is_waited_for_rests_after_a_turn() {
        let turns = Turns::new(1);
        let (one, other) = (KeyId::generate(), KeyId::generate());
        let took = Duration::from_millis(20);
        turns.take(Some(one)).await.end();
        let turn = turns.take(Some(one)).now_or_never().expect("nobody waited");
        let mut next = Box::pin(turns.take(Some(one)));
        assert!((&mut next).now_or_never().is_none());
        sleep(took).await;
        let begin = Instant::now();
        turn.end();
        assert!(turns.take(Some(other)).now_or_never().is_some());
        drop(next.await);
        assert!(begin.elapsed() >= REST * took);
    }
}
