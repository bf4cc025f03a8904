//! API keys that had no place left in the queue a moment ago.
//!
//! Who is refused and comes again at once is refused again without a look at the job or at the store: checking a sweep takes
//! milliseconds, and the transaction that counts waits for the only writer. Others would pay for both.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::{KeyId, Quota, StoreError};

/// How long a refusal stands. Clients are told to come again after a second.
const STANDS: Duration = Duration::from_millis(250);

/// The latest refusal of each key, and until when it stands.
#[derive(Debug, Default)]
pub struct Refusals(Mutex<HashMap<KeyId, (Quota, Instant)>>);

impl Refusals {
    /// Notes a refusal for want of a place in the queue; whatever else was refused may be in order next time.
    pub fn note(&self, key: Option<KeyId>, error: &StoreError) {
        self.note_at(key, error, Instant::now());
    }

    /// Refuses a key that was refused a moment ago.
    ///
    /// # Errors
    /// [`StoreError::QuotaExceeded`].
    pub fn check(&self, key: Option<KeyId>) -> Result<(), StoreError> {
        self.standing_at(key, Instant::now()).map_or(Ok(()), |quota| Err(StoreError::QuotaExceeded { quota }))
    }

    fn note_at(&self, key: Option<KeyId>, error: &StoreError, now: Instant) {
        if let (Some(key), StoreError::QuotaExceeded { quota: quota @ Quota::Queued { .. } }) = (key, error) {
            let mut refused = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            refused.retain(|_, (_, until)| *until > now);
            refused.insert(key, (*quota, now + STANDS));
        }
    }

    fn standing_at(&self, key: Option<KeyId>, now: Instant) -> Option<Quota> {
        let refused = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        refused.get(&key?).filter(|(_, until)| *until > now).map(|(quota, _)| *quota)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_for_want_of_places_stands_for_a_moment() {
        let refusals = Refusals::default();
        let (greedy, modest, now) = (KeyId::generate(), KeyId::generate(), Instant::now());
        let (full, exceeded) = (Quota::Queued { limit: 2 }, |quota| StoreError::QuotaExceeded { quota });
        refusals.note_at(Some(modest), &exceeded(Quota::Priority { limit: 3 }), now);
        refusals.note_at(Some(modest), &StoreError::QueueFull { queued: 7 }, now);
        refusals.note_at(Some(greedy), &exceeded(full), now);
        assert_eq!(refusals.standing_at(Some(greedy), now), Some(full));
        assert_eq!([refusals.standing_at(Some(modest), now), refusals.standing_at(None, now)], [None; 2]);
        let later = now + STANDS;
        assert_eq!(refusals.standing_at(Some(greedy), later), None);
        refusals.note_at(Some(modest), &exceeded(full), later);
        assert_eq!(refusals.0.lock().unwrap().len(), 1, "what is over is forgotten");
    }
}
