//! A bound on the memory of bodies, from their first byte until their jobs are in the store.
//!
//! A key may have as much as is free: alone half of the room, one of several an equal part, and there is always some left for the next
//! one. Where there are no keys, all bodies share the whole. That is the dynamic threshold of shared packet buffers (A. K. Choudhury, E. L. Hahne, *Dynamic queue length thresholds for
//! shared-memory packet switches*, IEEE/ACM Transactions on Networking 6 (1998) 130-140) with the factor 1.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use axum::body::Bytes;

use crate::jobs::KeyId;

/// Room for bodies.
#[derive(Debug)]
pub(super) struct BodyRoom {
    bytes: usize,
    /// Bytes of each key, and of all who have none.
    held: Mutex<HashMap<Option<KeyId>, usize>>,
}

impl BodyRoom {
    /// Room for so many bytes.
    pub(super) fn new(bytes: usize) -> Arc<Self> {
        Arc::new(Self { bytes, held: Mutex::default() })
    }

    /// Nothing yet.
    pub(super) fn open(self: &Arc<Self>, key: Option<KeyId>) -> HeldBody {
        HeldBody { room: Arc::clone(self), key, text: Vec::new() }
    }

    fn held(&self) -> MutexGuard<'_, HashMap<Option<KeyId>, usize>> {
        self.held.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn take(&self, key: Option<KeyId>, more: usize) -> bool {
        let mut held = self.held();
        let taken: usize = held.values().sum();
        let own = held.get(&key).copied().unwrap_or_default() + more;
        // Without keys there is nobody to leave room for.
        let needed = if key.is_some() { taken + more + own } else { taken + more };
        if needed > self.bytes {
            return false;
        }
        held.insert(key, own);
        true
    }

    fn give_back(&self, key: Option<KeyId>, bytes: usize) {
        let mut held = self.held();
        let left = held.get(&key).copied().unwrap_or_default().saturating_sub(bytes);
        if left == 0 {
            held.remove(&key);
        } else {
            held.insert(key, left);
        }
    }
}

/// A body, or what has come of it. Its room is free again when it is dropped.
#[derive(Debug)]
pub(super) struct HeldBody {
    room: Arc<BodyRoom>,
    key: Option<KeyId>,
    text: Vec<u8>,
}

impl HeldBody {
    /// Bytes so far.
    pub(super) fn len(&self) -> usize {
        self.text.len()
    }

    /// Takes in what has come; `false` if there is no room for it.
    #[must_use]
    pub(super) fn extend(&mut self, data: &[u8]) -> bool {
        let has_room = self.room.take(self.key, data.len());
        if has_room {
            self.text.extend_from_slice(data);
        }
        has_room
    }

    /// The whole. The room is held until the last part of it is dropped.
    pub(super) fn finish(mut self) -> Bytes {
        self.text.shrink_to_fit();
        Bytes::from_owner(self)
    }
}

impl AsRef<[u8]> for HeldBody {
    fn as_ref(&self) -> &[u8] {
        &self.text
    }
}

impl Drop for HeldBody {
    fn drop(&mut self) {
        self.room.give_back(self.key, self.text.len());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_has_as_much_as_is_free() {
        let room = BodyRoom::new(12);
        let [one, other, third] = [(); 3].map(|()| Some(KeyId::generate()));
        let mut first = room.open(one);
        assert!(first.extend(b"123456") && !first.extend(b"7"), "half");
        let mut second = room.open(other);
        assert!(second.extend(b"123") && !second.extend(b"4"), "half of the rest");
        assert!(!room.open(one).extend(b"1"));
        let mut last = room.open(third);
        assert!(last.extend(b"1") && !last.extend(b"2"));
        drop(second);
        assert!(last.extend(b"2"));
    }

    #[test]
    fn room_is_held_until_the_last_part_of_a_body_is_dropped() {
        let room = BodyRoom::new(8);
        let mut body = room.open(None);
        for byte in b"1234" {
            assert!(body.extend(&[*byte]));
        }
        let text = body.finish();
        let part = text.slice(1..2);
        drop(text);
        assert!(!room.open(None).extend(b"12345"));
        assert_eq!(part, "2");
        drop(part);
        assert!(room.open(None).extend(b"12345678"));
        assert!(room.held().is_empty());
    }
}
