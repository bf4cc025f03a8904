//! Takes connections: HTTP/1.1, over TLS if so set, with bounds on heads and on the patience with
//! slow clients.

use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::{GracefulShutdown, Watcher};
use hyper_util::service::TowerToHyperService;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{sleep, timeout};
use tokio_io_timeout::TimeoutStream;
use tokio_rustls::TlsAcceptor;
use tokio_util::sync::CancellationToken;

/// Most bytes of a head: a longer one is answered by 431, here where it does not fit into the
/// buffer, which may take somewhat more, or else with a problem.
pub(super) const HEAD_BYTES: usize = 64 << 10;

/// Most headers in it.
const HEADERS: usize = 100;

/// Pause after a connection could not be taken, as when there are too many.
const PAUSE: Duration = Duration::from_millis(100);

/// How long slow clients are waited for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConnectionTimeouts {
    /// Longest time a request's head may take to arrive, and a connection may idle between two
    /// requests.
    pub head: Duration,
    /// Longest time a client may take nothing of what is being sent.
    pub write: Duration,
}

/// Where connections come from.
pub struct Listening {
    /// The port.
    pub listener: TcpListener,
    /// What makes them secure, if anything does.
    pub tls: Option<TlsAcceptor>,
}

/// Serves at most `most` connections at a time until `close`, then lets every connection finish
/// the request it is in.
pub async fn serve(
    Listening { listener, tls }: Listening,
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
            Ok((stream, _)) => {
                let attended = attend(
                    stream,
                    tls.clone(),
                    router.clone(),
                    timeouts,
                    connections.watcher(),
                    place.ok(),
                );
                tokio::spawn(attended);
            }
            Err(error) => {
                tracing::warn!(%error, "a connection could not be taken");
                sleep(PAUSE).await;
            }
        }
    }
    drop(listener);
    connections.shutdown().await;
}

async fn attend(
    stream: TcpStream,
    tls: Option<TlsAcceptor>,
    router: Router,
    timeouts: ConnectionTimeouts,
    connections: Watcher,
    place: Option<OwnedSemaphorePermit>,
) {
    // Answers are single writes; waiting to fill a packet would only delay them.
    let _ = stream.set_nodelay(true);
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(timeouts.write));
    let stream = Box::pin(stream);
    match tls {
        None => converse(stream, router, timeouts, connections).await,
        Some(tls) => match timeout(timeouts.head, tls.accept(stream)).await {
            Ok(Ok(stream)) => converse(stream, router, timeouts, connections).await,
            Ok(Err(error)) => tracing::debug!(%error, "a connection could not be made secure"),
            Err(_) => tracing::debug!("a connection took too long to be made secure"),
        },
    }
    drop(place);
}

/// Answers the requests of a connection.
async fn converse(
    stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static,
    router: Router,
    timeouts: ConnectionTimeouts,
    connections: Watcher,
) {
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(timeouts.head)
        .max_buf_size(HEAD_BYTES)
        .max_headers(HEADERS)
        .serve_connection(TokioIo::new(stream), TowerToHyperService::new(router));
    if let Err(error) = connections.watch(connection).await {
        tracing::debug!(%error, "a connection ended early");
    }
}
