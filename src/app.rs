//! Puts the service together, runs it and takes it down in order.

use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::serve::ListenerExt;
use thiserror::Error;
use tokio::net::TcpListener;
use tokio::time::timeout;
use tokio_util::sync::CancellationToken;

use crate::config::ServeConfig;
use crate::http::{HttpState, router};
use crate::jobs::{Desk, Hub, JobSolver, JobStore, SystemClock};
use crate::store::MemoryStore;
use crate::worker::Worker;

/// Time for clients to take their last answers, once all jobs are done.
const LAST_ANSWERS: Duration = Duration::from_secs(3);

/// Why the service does not run.
#[derive(Debug, Error)]
pub enum AppError {
    /// The address cannot be listened on.
    #[error("cannot listen on {address}: {source}")]
    Listen {
        /// The address as configured.
        address: String,
        /// Why.
        source: io::Error,
    },
    /// The operating system refuses threads, signals or connections.
    #[error(transparent)]
    System(#[from] io::Error),
}

/// The service, bound to its address and ready to run.
pub struct Service {
    listener: TcpListener,
    address: SocketAddr,
    state: HttpState,
    worker: Worker,
    grace: Duration,
}

impl Service {
    /// Binds the address and starts the solvers. Needs a Tokio runtime.
    ///
    /// # Errors
    /// [`AppError`].
    pub async fn bind(config: &ServeConfig, solver: Arc<dyn JobSolver>) -> Result<Self, AppError> {
        let refused = |source| AppError::Listen { address: config.listen.clone(), source };
        let listener = TcpListener::bind(&config.listen).await.map_err(refused)?;
        let address = listener.local_addr()?;
        let hub = Hub::new();
        let store: Arc<dyn JobStore> =
            Arc::new(MemoryStore::new(config.memory(), Arc::clone(&hub), Arc::new(SystemClock)));
        let settings = config.worker();
        tracing::info!(version = env!("CARGO_PKG_VERSION"), %address, ?config, ?settings, "starting");
        let worker = Worker::start(Arc::clone(&store), Arc::clone(&hub), Arc::clone(&solver), settings)?;
        let desk = Arc::new(Desk::new(store, hub, solver, config.desk()));
        let state = HttpState { desk, settings: config.http() };
        Ok(Self { listener, address, state, worker, grace: config.grace })
    }

    /// Where the service listens.
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Serves until `stop`, then takes no more jobs, finishes those it has within the grace time while still
    /// answering questions, and closes its connections.
    ///
    /// # Errors
    /// [`AppError::System`] if the listener breaks.
    pub async fn run(self, stop: CancellationToken) -> Result<(), AppError> {
        let close = CancellationToken::new();
        let closed = close.clone().cancelled_owned();
        // Answers are single writes; waiting to fill a packet would only delay them.
        let listener = self.listener.tap_io(|stream| drop(stream.set_nodelay(true)));
        let serve = axum::serve(listener, router(self.state.clone())).with_graceful_shutdown(closed);
        let mut server = tokio::spawn(async move { serve.await });
        tokio::select! {
            () = stop.cancelled() => {}
            ended = &mut server => return ended.map_err(io::Error::other)?.map_err(AppError::from),
        }
        self.state.desk.close();
        tracing::info!(grace = ?self.grace, "draining");
        let finished = self.worker.drain(self.grace).await;
        tracing::info!(finished, "drained");
        close.cancel();
        if timeout(LAST_ANSWERS, &mut server).await.is_err() {
            tracing::warn!("clients were still connected");
            server.abort();
        }
        Ok(())
    }
}
