//! Takes connections: HTTP/1.1, with bounds on heads and on the patience with slow clients.

use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::GracefulShutdown;
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::sleep;
use tokio_io_timeout::TimeoutStream;
use tokio_util::sync::CancellationToken;

/// Most bytes of a head: a longer one is answered by 431, here where it does not fit into the buffer, which may take
/// somewhat more, or else with a problem.
pub(super) const HEAD_BYTES: usize = 64 << 10;

/// Most headers in it.
const HEADERS: usize = 100;

/// Pause after a connection could not be taken, as when there are too many.
const PAUSE: Duration = Duration::from_millis(100);

/// How long slow clients are waited for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConnectionTimeouts {
    /// Longest time a request's head may take to arrive, and a connection may idle between two requests.
    pub head: Duration,
    /// Longest time a client may take nothing of what is being sent.
    pub write: Duration,
}

/// Serves at most `most` connections at a time until `close`, then lets every connection finish the request it is in.
pub async fn serve(
    listener: TcpListener,
    router: Router,
    timeouts: ConnectionTimeouts,
    most: usize,
    close: CancellationToken,
) {
    let connections = GracefulShutdown::new();
    let places = Arc::new(Semaphore::new(most.min(Semaphore::MAX_PERMITS)));
    loop {
        // Without a place, further clients wait in the system's own queue.
        let next = async {
            let place = Arc::clone(&places).acquire_owned().await;
            (listener.accept().await, place)
        };
        let (accepted, place) = tokio::select! {
            next = next => next,
            () = close.cancelled() => break,
        };
        match accepted {
            Ok((stream, _)) => attend(stream, router.clone(), timeouts, &connections, place.ok()),
            Err(error) => {
                tracing::warn!(%error, "a connection could not be taken");
                sleep(PAUSE).await;
            }
        }
    }
    drop(listener);
    connections.shutdown().await;
}

fn attend(
    stream: TcpStream,
    router: Router,
    timeouts: ConnectionTimeouts,
    connections: &GracefulShutdown,
    place: Option<OwnedSemaphorePermit>,
) {
    // Answers are single writes; waiting to fill a packet would only delay them.
    let _ = stream.set_nodelay(true);
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(timeouts.write));
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(timeouts.head)
        .max_buf_size(HEAD_BYTES)
        .max_headers(HEADERS)
        .serve_connection(TokioIo::new(Box::pin(stream)), TowerToHyperService::new(router));
    let connection = connections.watch(connection);
    tokio::spawn(async move {
        if let Err(error) = connection.await {
            tracing::debug!(%error, "a connection ended early");
        }
        drop(place);
    });
}
