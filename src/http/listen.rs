//! Accepts connections: HTTP/1.1, over TLS if configured, with limits on heads and timeouts for
//! slow clients.

use std::sync::Arc;
use std::time::Duration;

use super::client_address::Peer;
use axum::{Extension, Router};
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

/// Largest head \[bytes\]. A longer one is answered by 431: by the HTTP library where it exceeds
/// its buffer, which is somewhat larger, and otherwise with a problem.
pub(super) const HEAD_BYTES: usize = 64 << 10;

/// Most headers in a head.
const HEADERS: usize = 100;

/// Pause after a failed accept, as when too many files are open.
const PAUSE: Duration = Duration::from_millis(100);

/// Timeouts of slow clients.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConnectionTimeouts {
    /// Longest time a request's head may take to arrive, and a connection may idle between two
    /// requests.
    pub head: Duration,
    /// Longest time for which a client may read nothing of an answer.
    pub write: Duration,
}

/// The listening socket.
pub struct Listening {
    /// The port.
    pub listener: TcpListener,
    /// The TLS configuration, if any.
    pub tls: Option<TlsAcceptor>,
}

/// Serves at most `most` connections at a time until `close`; then every connection finishes its
/// present request.
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
        // Above the limit, further clients wait in the backlog of the socket.
        let next = async {
            let place = Arc::clone(&places).acquire_owned().await;
            (listener.accept().await, place)
        };
        let (accepted, place) = tokio::select! {
            next = next => next,
            () = close.cancelled() => break,
        };
        match accepted {
            Ok((stream, peer)) => {
                let service = router.clone().layer(Extension(Peer(peer)));
                let attended = attend(
                    stream,
                    tls.clone(),
                    service,
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
    service: Router,
    timeouts: ConnectionTimeouts,
    connections: Watcher,
    place: Option<OwnedSemaphorePermit>,
) {
    // Nagle's algorithm is off: answers are single writes, which it would only delay.
    let _ = stream.set_nodelay(true);
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(timeouts.write));
    let stream = Box::pin(stream);
    match tls {
        None => converse(stream, service, timeouts, connections).await,
        Some(tls) => match timeout(timeouts.head, tls.accept(stream)).await {
            Ok(Ok(stream)) => converse(stream, service, timeouts, connections).await,
            Ok(Err(error)) => tracing::debug!(%error, "a connection could not be made secure"),
            Err(_) => tracing::debug!("a connection took too long to be made secure"),
        },
    }
    drop(place);
}

/// Answers the requests of a connection.
async fn converse(
    stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static,
    service: Router,
    timeouts: ConnectionTimeouts,
    connections: Watcher,
) {
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(timeouts.head)
        .max_buf_size(HEAD_BYTES)
        .max_headers(HEADERS)
        .serve_connection(TokioIo::new(stream), TowerToHyperService::new(service));
    if let Err(error) = connections.watch(connection).await {
        tracing::debug!(%error, "a connection ended early");
    }
}
