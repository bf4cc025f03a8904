//! A store that does not answer is told by `/livez` after a minute, and no sooner.

use std::sync::Arc;
use std::time::Duration;

use tokio::time::{advance, pause, resume, timeout};

use crate::dropped::service;
use crate::subject::{MEMORY_STORE, Subject};

#[tokio::test]
async fn a_store_is_alive_for_a_minute_after_its_last_answer() {
    let subject = Subject::memory(MEMORY_STORE).await;
    let jobs = service(&subject);
    pause();
    advance(Duration::from_secs(59)).await;
    assert!(jobs.is_store_alive());
    advance(Duration::from_secs(2)).await;
    assert!(!jobs.is_store_alive());
    resume();
    let watched = Arc::clone(&jobs);
    // The watch never ends; its first question is answered at once.
    timeout(Duration::from_secs(5), async move {
        let watch = tokio::spawn(async move { watched.watch_store().await });
        while !jobs.is_store_alive() {
            tokio::task::yield_now().await;
        }
        watch.abort();
    })
    .await
    .unwrap();
}
