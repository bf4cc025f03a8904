//! API keys take turns at something that there is little of: a key that floods waits for itself, where others would wait with it.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError, Weak};

use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use super::KeyId;

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
        Turn { _permit: permit }
    }

    /// A turn, if one is free.
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
    /// One that nobody waits for.
    pub fn free() -> Self {
        Self { _permit: None }
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
}
