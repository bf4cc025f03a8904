//! Bodies that a task writes and the connection sends through a channel. The connection does not
//! poll the body while its client reads nothing, so the body itself must hold no resource, such as
//! a connection to the database.

use axum::body::{Body, HttpBody as _};
use axum::response::Response;
use futures_util::{Stream, StreamExt, stream};
use tokio::sync::mpsc::{self, Sender};
use tokio_util::task::AbortOnDropHandle;

use crate::jobs::StoreError;

/// Pieces that may wait for a slow client.
const WAITING_PIECES: usize = 2;

/// Makes a body of the pieces that a task writes. The turn lasts until the connection has taken
/// all pieces. The task ends when the client hangs up. If the task fails, the connection breaks
/// off, so that the client sees an incomplete body.
pub(super) fn written<P, T, W, F>(
    turn: impl Future<Output = P> + Send + 'static,
    write: F,
) -> impl Stream<Item = Result<T, StoreError>> + Send
where
    P: Send + 'static,
    T: Send + 'static,
    W: Future<Output = Result<(), StoreError>> + Send + 'static,
    F: FnOnce(Sender<T>) -> W + 'static,
{
    let (sender, receiver) = mpsc::channel(WAITING_PIECES);
    let client = sender.clone();
    let write = write(sender);
    let write = async {
        let turn = turn.await;
        (write.await, Some(turn))
    };
    let task = AbortOnDropHandle::new(tokio::spawn(async move {
        tokio::select! {
            written = write => written,
            () = client.closed() => (Ok(()), None),
        }
    }));
    stream::unfold((receiver, Some(task)), async |(mut receiver, task)| {
        if let Some(piece) = receiver.recv().await {
            return Some((Ok(piece), (receiver, task)));
        }
        let error = match task?.await {
            Ok((Ok(()), _)) => return None,
            Ok((Err(error), _)) => error,
            Err(error) => StoreError::unavailable(error),
        };
        log_broken_off(&error);
        Some((Err(error), (receiver, None)))
    })
    // The connection may look for more behind the end.
    .fuse()
}

/// Wraps an answer whose body breaks off when `end` is ready.
pub(super) fn ending(
    response: Response,
    end: impl Future<Output = ()> + Send + 'static,
) -> Response {
    if response.body().size_hint().exact().is_some() {
        return response;
    }
    let end = AbortOnDropHandle::new(tokio::spawn(end));
    response.map(|body| {
        let pieces = stream::unfold((body.into_data_stream(), Some(end)), async |(mut body, end)| {
            let mut end = end?;
            tokio::select! {
                biased;
                _ = &mut end => Some((Err(axum::Error::new(StoreError::KeyEnded)), (body, None))),
                piece = body.next() => Some((piece?, (body, Some(end)))),
            }
        });
        // The connection may look for more behind the end.
        Body::from_stream(pieces.fuse())
    })
}

/// Logs an answer that breaks off, except when the job was removed meanwhile.
fn log_broken_off(error: &StoreError) {
    if matches!(error, StoreError::NotFound) {
        tracing::info!("a job was removed while its result was read");
    } else {
        tracing::error!(error = error as &dyn std::error::Error, "an answer breaks off");
    }
}

#[cfg(test)]
mod tests {
    use std::future::ready;
    use std::sync::Arc;

    use http_body_util::BodyExt as _;
    use tokio::sync::Notify;

    use super::*;

    #[tokio::test]
    async fn bodies_are_sent_and_failed_ones_break_off() {
        let write = |end: Result<(), StoreError>| {
            written(ready(()), |sender| async move {
                for piece in ["a", "b", "c", "d"] {
                    let _ = sender.send(piece).await;
                }
                end
            })
        };
        let whole: Vec<_> = write(Ok(())).map(Result::ok).collect().await;
        assert_eq!(whole, [Some("a"), Some("b"), Some("c"), Some("d")]);
        let broken: Vec<_> = write(Err(StoreError::NotFound)).map(Result::ok).collect().await;
        assert_eq!(broken, [Some("a"), Some("b"), Some("c"), Some("d"), None]);
    }

    #[tokio::test]
    async fn a_task_ends_when_its_client_goes() {
        let held = Arc::new(());
        let task = Arc::clone(&held);
        let mut body = Box::pin(written(ready(()), |sender| async move {
            let _ = sender.send(()).await;
            std::future::pending::<()>().await;
            drop(task);
            Ok(())
        }));
        assert!(body.next().await.is_some());
        drop(body);
        while Arc::strong_count(&held) > 1 {
            tokio::task::yield_now().await;
        }
    }

    #[tokio::test]
    async fn a_turn_lasts_until_the_connection_has_taken_all() {
        let turn = Arc::new(());
        let held = Arc::downgrade(&turn);
        let mut body = Box::pin(written(ready(turn), |sender| async move {
            let _ = sender.send("all").await;
            Ok(())
        }));
        tokio::task::yield_now().await;
        assert!(body.next().await.is_some() && held.upgrade().is_some());
        assert!(body.next().await.is_none() && held.upgrade().is_none());
    }

    #[tokio::test]
    async fn an_answer_breaks_off_at_its_end() {
        let end = Arc::new(Notify::new());
        let signal = Arc::clone(&end);
        let body = Body::from_stream(stream::repeat_with(|| Ok::<_, axum::Error>("x")));
        let response = ending(Response::new(body), async move { signal.notified().await });
        let mut body = response.into_body();
        assert!(body.frame().await.unwrap().is_ok());
        end.notify_one();
        while body.frame().await.unwrap().is_ok() {
            tokio::task::yield_now().await;
        }
    }

    #[tokio::test]
    async fn a_body_under_a_key_may_be_asked_again_behind_its_end() {
        let pieces = Body::from_stream(stream::iter([Ok::<_, StoreError>("a")]));
        let response = ending(Response::new(pieces), std::future::pending());
        let mut body = response.into_body().into_data_stream();
        assert!(body.next().await.is_some());
        assert!(body.next().await.is_none());
        assert!(body.next().await.is_none());
    }
}
