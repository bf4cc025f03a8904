//! Texts that are in memory as a whole while they are sent, such as a VTK file of a fine mesh: few at a time, and a client that
//! dawdles gives its place to one that waits.

use std::io;
use std::sync::Arc;
use std::time::Duration;

use axum::body::{Body, Bytes};
use futures_util::stream;
use tokio::sync::mpsc::{self, Sender};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{Instant, sleep_until};

use crate::jobs::{KeyId, Turn, Turns};

/// How many at a time, and of one API key.
const PLACES: usize = 8;
const PLACES_OF_KEY: usize = 2;

/// While others wait, a client has to take at least so many bytes in each such time.
const WINDOW: Duration = Duration::from_secs(3);
const LEAST: usize = 3 << 20;

/// Size \[bytes\] of the pieces that are sent.
const PIECE: usize = 64 << 10;

/// Places for such texts.
#[derive(Debug, Clone)]
pub(super) struct TextPlaces {
    keys: Arc<Turns>,
    places: Arc<Semaphore>,
    window: Duration,
}

/// One place.
pub(super) struct TextPlace {
    of_key: Turn,
    permit: Option<OwnedSemaphorePermit>,
    window: Duration,
}

impl Default for TextPlaces {
    fn default() -> Self {
        let (keys, places) = (Turns::new(PLACES_OF_KEY), Semaphore::new(PLACES));
        Self { keys: Arc::new(keys), places: Arc::new(places), window: WINDOW }
    }
}

impl TextPlaces {
    /// Waits for a place.
    pub(super) async fn take(&self, key: Option<KeyId>) -> TextPlace {
        let of_key = self.keys.take(key).await;
        let place = Arc::clone(&self.places).acquire_owned().await;
        TextPlace { of_key, permit: place.ok(), window: self.window }
    }
}

impl TextPlace {
    /// Sends a text and keeps the place until it is sent, or until others may wait and the client is too slow: then the body
    /// breaks off.
    pub(super) fn send(self, text: Bytes) -> Body {
        let (sender, receiver) = mpsc::channel::<Bytes>(1);
        let left = text.len();
        tokio::spawn(self.pass_on(text, sender));
        Body::from_stream(stream::try_unfold((receiver, left), async |(mut receiver, left)| {
            match receiver.recv().await {
                Some(piece) => {
                    let left = left.saturating_sub(piece.len());
                    Ok(Some((piece, (receiver, left))))
                }
                None if left == 0 => Ok(None),
                None => Err(io::Error::from(io::ErrorKind::TimedOut)),
            }
        }))
    }

    /// Whether all places are taken, so that others may wait.
    fn is_wanted(&self) -> bool {
        let is_last = |permit: &OwnedSemaphorePermit| permit.semaphore().available_permits() == 0;
        self.of_key.is_last() || self.permit.as_ref().is_some_and(is_last)
    }

    async fn pass_on(self, mut text: Bytes, sender: Sender<Bytes>) {
        let mut until = Instant::now() + self.window;
        let mut due = text.len().saturating_sub(LEAST);
        while !text.is_empty() {
            tokio::select! {
                free = sender.reserve() => {
                    let Ok(free) = free else { return };
                    // A copy: a piece of the text that a slow connection holds would hold the whole of it.
                    let piece = text.split_to(PIECE.min(text.len()));
                    free.send(Bytes::copy_from_slice(&piece));
                }
                () = sleep_until(until) => {
                    if text.len() > due && self.is_wanted() {
                        tracing::debug!(bytes = text.len(), "a client that dawdles loses its place");
                        return;
                    }
                    until += self.window;
                    due = text.len().saturating_sub(LEAST);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use futures_util::StreamExt;
    use http_body_util::BodyExt;

    use super::*;

    const LONG: usize = 4 << 20;

    fn places() -> TextPlaces {
        TextPlaces { window: Duration::from_millis(10), ..TextPlaces::default() }
    }

    #[tokio::test]
    async fn a_text_arrives_whole() {
        let text = Bytes::from((0..=u8::MAX).cycle().take(LONG + 7).collect::<Vec<_>>());
        let body = places().take(None).await.send(text.clone());
        assert_eq!(body.collect().await.unwrap().to_bytes(), text);
        let body = places().take(None).await.send(Bytes::new());
        assert!(body.collect().await.unwrap().to_bytes().is_empty());
    }

    #[tokio::test]
    async fn who_dawdles_gives_place_to_others() {
        let places = places();
        let mut dawdlers = Vec::new();
        for _ in 0..PLACES {
            let body = places.take(None).await.send(vec![0; LONG].into());
            dawdlers.push(body.into_data_stream());
        }
        // Nobody has read anything yet.
        let waiting = places.take(None).await.send(Bytes::from_static(b"x"));
        assert_eq!(waiting.collect().await.unwrap().to_bytes(), "x");
        let mut ends = Vec::new();
        for mut dawdler in dawdlers {
            let mut last = dawdler.next().await;
            while let Some(Ok(_)) = last {
                last = dawdler.next().await;
            }
            ends.push(last.is_some_and(|last| last.is_err()));
        }
        assert!(ends.contains(&true), "nobody's text broke off");
    }
}
