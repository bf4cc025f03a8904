//! Bounds on the bodies that are in memory.

use std::sync::Arc;

use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use super::problem::Problem;
use super::problem_type::ProblemType;
use crate::jobs::{KeyId, Turn, Turns};

/// Bodies of one key that may be in memory at a time, from their first byte until their jobs are
/// stored; it is also the most results that are sent to one key at a time. All keys together have
/// memory for four times as many bodies of the largest size.
pub(super) const BODIES_OF_KEY: usize = 32;
const BODIES: usize = 4 * BODIES_OF_KEY;

/// Bounds on bodies in memory.
#[derive(Debug, Clone)]
pub(super) struct Bodies {
    bytes: Arc<Semaphore>,
    keys: Arc<Turns>,
}

impl Bodies {
    /// Allows bodies of at most `largest` bytes.
    pub(super) fn new(largest: usize) -> Self {
        let bytes = largest.saturating_mul(BODIES).min(Semaphore::MAX_PERMITS);
        Self { bytes: Arc::new(Semaphore::new(bytes)), keys: Arc::new(Turns::new(BODIES_OF_KEY)) }
    }

    /// Starts a body before its first byte.
    pub(super) fn open(&self, key: Option<KeyId>) -> Result<HeldBody, Problem> {
        Ok(HeldBody {
            text: Vec::new(),
            room: None,
            turn: self.keys.try_take(key).ok_or_else(too_many_of_key)?,
        })
    }

    /// Adds received bytes to a body.
    pub(super) fn extend(&self, body: &mut HeldBody, data: &[u8]) -> Result<(), Problem> {
        let bytes = u32::try_from(data.len()).unwrap_or(u32::MAX);
        let more =
            Arc::clone(&self.bytes).try_acquire_many_owned(bytes).map_err(|_| too_many())?;
        match &mut body.room {
            Some(room) => room.merge(more),
            room => *room = Some(more),
        }
        body.text.extend_from_slice(data);
        Ok(())
    }
}

fn too_many_of_key() -> Problem {
    let detail = format!("{BODIES_OF_KEY} bodies of this API key are under way");
    Problem::new(ProblemType::TooManyJobs, detail)
}

fn too_many() -> Problem {
    Problem::new(ProblemType::TooManyBodies, "too many other bodies are held at this moment")
}

/// A body, complete or partly received. Its memory counts until its last part is dropped.
#[derive(Debug)]
pub(super) struct HeldBody {
    pub(super) text: Vec<u8>,
    pub(super) room: Option<OwnedSemaphorePermit>,
    pub(super) turn: Turn,
}

impl AsRef<[u8]> for HeldBody {
    fn as_ref(&self) -> &[u8] {
        &self.text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::body::Bytes;

    #[test]
    fn bodies_are_bounded_in_bytes_and_those_of_a_key_in_number() {
        let bodies = Bodies::new(2);
        let [one, other] = [(); 2].map(|()| Some(KeyId::generate()));
        let mut held = Vec::new();
        for _ in 0..BODIES_OF_KEY {
            let mut body = bodies.open(one).unwrap();
            bodies.extend(&mut body, b"ab").unwrap();
            held.push(Bytes::from_owner(body));
        }
        let refused = bodies.open(one).unwrap_err();
        assert_eq!(refused.kind(), ProblemType::TooManyJobs, "the key's own doing");
        assert!(bodies.open(other).is_ok());
        let mut rest = bodies.open(None).unwrap();
        for _ in BODIES_OF_KEY..BODIES {
            bodies.extend(&mut rest, b"ab").unwrap();
        }
        assert!(bodies.extend(&mut bodies.open(other).unwrap(), b"a").is_err());
        let part = held[0].slice(1..);
        held.clear();
        let mut body = bodies.open(one).unwrap();
        for _ in 1..BODIES_OF_KEY {
            bodies.extend(&mut body, b"ab").unwrap();
        }
        assert!(bodies.extend(&mut body, b"a").is_err(), "a part of a body holds the whole");
        drop(part);
        bodies.extend(&mut body, b"ab").unwrap();
    }
}
