//! Assembly, run and orderly shutdown of the service.

use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};
use std::time::Duration;

use axum::Router;
use metrics_exporter_prometheus::PrometheusHandle;
use thiserror::Error;
use tokio::net::TcpListener;
use tokio::task::JoinSet;
use tokio::time::{sleep, timeout};
use tokio_util::sync::CancellationToken;

use crate::config::{
    MetricsConfig, ServeConfig, StorageConfig, TlsConfig, WebhookConfig, WorkerConfig,
};
use crate::http::{
    AllowedHosts, Guide, HttpSettings, HttpState, Listening, Metrics, TlsError, TlsIdentity,
    metrics_router, router, serve, worker_router,
};
use crate::jobs::{
    JobNotifier, JobService, JobSolver, JobStore, OnceKey, Retention, SWEEP, SystemClock,
};
use crate::lifecycle::{Hangups, raise_file_limit};
use crate::outgoing::{Client, RootsError};
use crate::store::{
    DATABASE, PostgresError, SqliteError, Store, open_postgres, open_sqlite,
    open_sqlite_in_memory, open_sqlite_keys,
};
use crate::telemetry::{AUDIT, collect};
use crate::webhook::{Announcer, CallbackRules};
use crate::worker::{Pulse, STOP_TIMEOUT, Worker};

/// Time for clients to take their last answers, once all jobs are done.
const CLOSE_TIMEOUT: Duration = Duration::from_secs(3);

/// Most connections to the port of the metrics.
const METRICS_CONNECTIONS: usize = 100;

/// Open files besides the connections of clients: store, metrics and outgoing requests.
const OTHER_FILES: usize = METRICS_CONNECTIONS + 64;

/// Time between two sweeps.
const SWEEP_INTERVAL: Duration = Duration::from_secs(30);

/// Time between two aggregations of the metrics.
const UPKEEP_INTERVAL: Duration = Duration::from_secs(5);

/// An error that keeps the service from running.
#[derive(Debug, Error)]
pub enum AppError {
    /// The service cannot listen on the address.
    #[error("cannot listen on {address}: {source} (set by {setting})")]
    Listen {
        /// The flag and the variable that set it.
        setting: &'static str,
        /// The address as configured.
        address: String,
        /// Why.
        source: io::Error,
    },
    /// The embedded database does not open.
    #[error(transparent)]
    Sqlite(#[from] SqliteError),
    /// The shared database does not open.
    #[error(transparent)]
    Postgres(#[from] PostgresError),
    /// Separate workers are configured without a shared database.
    #[error(
        "workers in processes of their own need a shared database: --database-url postgres://... \
         (BRINELL_DATABASE_URL)"
    )]
    NotShared,
    /// The data directory has no database.
    #[error("there is no database in {}", .0.display())]
    NoStore(PathBuf),
    /// The certificate or its key cannot be used.
    #[error("{0} (set by --tls-cert, BRINELL_TLS_CERT and --tls-key, BRINELL_TLS_KEY)")]
    Tls(#[from] TlsError),
    /// The guide cannot be read.
    #[error("the guide in {}: {source} (set by --guide, BRINELL_GUIDE)", .folder.display())]
    Guide {
        /// The folder as configured.
        folder: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The certificates of receivers cannot be used.
    #[error("{0} (set by --webhook-ca, BRINELL_WEBHOOK_CA)")]
    Webhooks(#[from] RootsError),
    /// Pages of all origins may ask, and no key is required.
    #[error(
        "--cors-origin '*' (BRINELL_CORS_ORIGIN) lets every page that a user of this machine opens \
         ask the service; require keys by --require-api-key, or name the origins"
    )]
    OpenToAllPages,
    /// The key of this process cannot be used.
    #[error("{0} holds no key of {min} characters or more (named by --once-key-env, \
             BRINELL_ONCE_KEY_ENV)", min = OnceKey::MIN_LENGTH)]
    OnceKey(String),
    /// The operating system refuses threads, signals or connections.
    #[error(transparent)]
    System(#[from] io::Error),
}

/// The service, bound to its address and ready to run.
pub struct Service {
    listening: Listening,
    address: SocketAddr,
    state: HttpState,
    worker: Option<Worker>,
    background: JoinSet<()>,
    grace: Duration,
}

impl Service {
    /// Binds the address, opens the store and starts the solvers. Needs a Tokio runtime.
    ///
    /// # Errors
    /// [`AppError`].
    pub async fn bind(config: &ServeConfig, solver: Arc<dyn JobSolver>) -> Result<Self, AppError> {
        if config.no_workers && !config.storage.is_shared() {
            return Err(AppError::NotShared);
        }
        let once_key = config.once_key_env.as_deref().map(once_key).transpose()?;
        let guide = guide(config.guide.clone())?;
        let listener = listen("--listen, BRINELL_LISTEN", &config.listen).await?;
        let address = listener.local_addr()?;
        if config.cors_origin.iter().any(|origin| origin == "*") && !config.keys_required(address)
        {
            return Err(AppError::OpenToAllPages);
        }
        let identity = tls_identity(&config.tls)?;
        let tls = identity.as_ref().map(TlsIdentity::acceptor).transpose()?;
        tracing::info!(version = env!("CARGO_PKG_VERSION"), %address, ?config, "starting");
        let notifier = JobNotifier::new();
        let store = open_store(&config.storage, &notifier).await?;
        let mut background = JoinSet::new();
        background.spawn(sweep(Arc::clone(&store) as _, config.storage.retention()));
        let metrics = start_metrics(
            &config.metrics,
            Arc::clone(&store) as _,
            Router::new(),
            &mut background,
        )
        .await?;
        if let Some(identity) = identity {
            background.spawn(reload_on_hangup(identity)?);
        }
        let callbacks = announce(&config.webhooks, &store, &notifier, &mut background)?;
        let worker = if config.no_workers {
            None
        } else {
            let settings = config.work.worker(config.storage.is_durable());
            Some(Worker::start(
                Arc::clone(&store) as _,
                Arc::clone(&notifier),
                Arc::clone(&solver),
                settings,
            ))
        };
        let jobs = Arc::new(JobService::new(
            Arc::clone(&store) as _,
            notifier,
            solver,
            Arc::clone(&store) as _,
            store,
            config.submission_limits(),
        ));
        let checked = Arc::clone(&jobs);
        background.spawn(async move { checked.check_store().await });
        let watched = Arc::clone(&jobs);
        background.spawn(async move { watched.watch_store().await });
        let connections = connections(config.max_connections);
        let settings = HttpSettings {
            require_api_key: config.keys_required(address),
            once_key,
            connections,
            ..config.http()
        };
        let metrics = config.metrics.metrics_listen.is_none().then_some(metrics);
        let hosts = Arc::new(AllowedHosts::new(&config.allowed_hosts, address));
        let mut state = HttpState::new(jobs, settings, metrics);
        state.hosts = hosts;
        state.guide = Arc::new(guide);
        state.callbacks = callbacks;
        let listening = Listening { listener, tls };
        Ok(Self { listening, address, state, worker, background, grace: config.work.grace })
    }

    /// Returns the address that the service listens on.
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Returns its URL.
    pub fn url(&self) -> String {
        let scheme = if self.listening.tls.is_some() { "https" } else { "http" };
        format!("{scheme}://{}", self.address)
    }

    /// Serves until `stop`. Then the service rejects new jobs, finishes its jobs within the grace
    /// time while it still answers queries, and closes its connections.
    ///
    /// # Errors
    /// Currently none; the signature leaves room for errors of the listener.
    pub async fn run(self, stop: CancellationToken) -> Result<(), AppError> {
        let close = self.state.closing.clone();
        let (router, timeouts) = (router(self.state.clone()), self.state.settings.timeouts);
        let most = self.state.settings.connections;
        let mut server =
            tokio::spawn(serve(self.listening, router, timeouts, most, close.clone()));
        stop.cancelled().await;
        self.state.jobs.close();
        if let Some(worker) = self.worker {
            drain(worker, time_to_solve(self.grace)).await;
        }
        // Waiting requests are answered with the state of their jobs before connections close.
        self.state.jobs.end_waits();
        close.cancel();
        if timeout(CLOSE_TIMEOUT, &mut server).await.is_err() {
            tracing::warn!("clients were still connected");
            server.abort();
        }
        drop(self.background);
        if timeout(CLOSE_TIMEOUT, self.state.jobs.close_store()).await.is_err() {
            tracing::warn!("the store was still in use");
        }
        Ok(())
    }
}

/// Solves the jobs of a shared store until `stop`.
///
/// # Errors
/// [`AppError`].
pub async fn run_worker(
    config: &WorkerConfig,
    solver: Arc<dyn JobSolver>,
    stop: CancellationToken,
) -> Result<(), AppError> {
    if !config.storage.is_shared() {
        return Err(AppError::NotShared);
    }
    let notifier = JobNotifier::of_worker();
    let settings = config.work.worker(true);
    tracing::info!(version = env!("CARGO_PKG_VERSION"), ?config, ?settings, "starting");
    // A worker has use for one connection for each solver, and for three beside them.
    let useful = u32::try_from(settings.slots).unwrap_or(u32::MAX).saturating_add(3);
    let connections = config.storage.database_connections.min(useful);
    let storage = StorageConfig { database_connections: connections, ..config.storage.clone() };
    let store = open_store(&storage, &notifier).await?;
    let mut background = JoinSet::new();
    background.spawn(sweep(Arc::clone(&store) as _, config.storage.retention()));
    let pulse = Arc::new(OnceLock::<Pulse>::new());
    let felt = Arc::clone(&pulse);
    let probe = worker_router(move || {
        felt.get().map_or((true, Duration::ZERO), |pulse| (pulse.is_alive(), pulse.age()))
    });
    start_metrics(&config.metrics, Arc::clone(&store) as _, probe, &mut background).await?;
    let worker = Worker::start(store, notifier, solver, settings);
    let _ = pulse.set(worker.pulse());
    stop.cancelled().await;
    drain(worker, time_to_solve(config.work.grace)).await;
    Ok(())
}

/// Limits the number of connections so that open files remain for the store and outgoing requests.
fn connections(most: usize) -> usize {
    let files = raise_file_limit().and_then(|files| usize::try_from(files).ok());
    let possible = files.map_or(most, |files| files.saturating_sub(OTHER_FILES).max(1));
    if possible < most {
        tracing::warn!(
            possible,
            "the limit on open files (`ulimit -n`) allows fewer connections than --max-connections"
        );
    }
    most.min(possible)
}

async fn listen(setting: &'static str, address: &str) -> Result<TcpListener, AppError> {
    let refused = |source| AppError::Listen { setting, address: address.to_owned(), source };
    TcpListener::bind(address).await.map_err(refused)
}

fn tls_identity(config: &TlsConfig) -> Result<Option<Arc<TlsIdentity>>, TlsError> {
    let (Some(certificate), Some(key)) = (&config.tls_cert, &config.tls_key) else {
        return Ok(None);
    };
    TlsIdentity::load(certificate, key).map(Some)
}

/// Reads the key that an environment variable holds.
fn once_key(variable: &str) -> Result<OnceKey, AppError> {
    let secret = std::env::var(variable).unwrap_or_default();
    OnceKey::new(&secret).ok_or_else(|| AppError::OnceKey(variable.to_owned()))
}

/// Reads the guide: the folder that is given, or else the one beside the program.
fn guide(given: Option<PathBuf>) -> Result<Guide, AppError> {
    let beside = || {
        let folder = std::env::current_exe().ok()?.parent()?.join("guide");
        folder.join("index.html").is_file().then_some(folder)
    };
    let Some(folder) = given.or_else(beside) else { return Ok(Guide::default()) };
    Guide::read(&folder).map_err(|source| AppError::Guide { folder, source })
}

/// Reads certificate and key again at every SIGHUP.
fn reload_on_hangup(identity: Arc<TlsIdentity>) -> io::Result<impl Future<Output = ()>> {
    let mut hangups = Hangups::new()?;
    Ok(async move {
        while hangups.next().await {
            match identity.reload() {
                Ok(()) => tracing::info!(target: AUDIT, "certificate and key were read again"),
                Err(error) => tracing::error!(%error, "certificate and key stay as they are"),
            }
        }
    })
}

/// Starts announcing the ends of jobs if any host may be called. Returns the rules for hosts.
fn announce(
    config: &WebhookConfig,
    store: &Arc<dyn Store>,
    notifier: &Arc<JobNotifier>,
    background: &mut JoinSet<()>,
) -> Result<Arc<CallbackRules>, AppError> {
    let rules = Arc::new(config.rules());
    if rules.is_enabled() {
        let announcer = Announcer {
            jobs: Arc::clone(store) as _,
            notifier: Arc::clone(notifier),
            deliveries: Arc::clone(store) as _,
            rules: Arc::clone(&rules),
            client: Client::new(config.webhook_allow_private, config.webhook_ca.as_deref())?,
            secrets: config.webhook_secrets.clone(),
            pause: config.webhook_retry,
        };
        background.spawn(Arc::new(announcer).run());
    }
    Ok(rules)
}

/// Starts the metrics, and serves them and `more` on a port of their own if one is configured.
async fn start_metrics(
    config: &MetricsConfig,
    store: Arc<dyn JobStore>,
    more: Router,
    background: &mut JoinSet<()>,
) -> Result<Metrics, AppError> {
    let collected = collect();
    background.spawn(upkeep(collected.clone()));
    let metrics = Metrics::new(collected, store);
    if let Some(address) = &config.metrics_listen {
        let listener = listen("--metrics-listen, BRINELL_METRICS_LISTEN", address).await?;
        tracing::info!(address = %listener.local_addr()?, "metrics");
        let (router, timeouts) =
            (metrics_router(metrics.clone()).merge(more), HttpSettings::default().timeouts);
        let listening = Listening { listener, tls: None };
        background.spawn(serve(
            listening,
            router,
            timeouts,
            METRICS_CONNECTIONS,
            CancellationToken::new(),
        ));
    }
    Ok(metrics)
}

/// Aggregates samples into their buckets periodically, also if no client scrapes them.
async fn upkeep(collected: PrometheusHandle) {
    loop {
        sleep(UPKEEP_INTERVAL).await;
        collected.run_upkeep();
    }
}

/// Returns the part of the grace time in which jobs may finish; the rest is for stopping jobs and
/// closing connections.
fn time_to_solve(grace: Duration) -> Duration {
    grace.saturating_sub(STOP_TIMEOUT + CLOSE_TIMEOUT).max(grace / 2)
}

async fn drain(worker: Worker, grace: Duration) {
    tracing::info!(?grace, "draining");
    let finished = worker.drain(grace).await;
    tracing::info!(finished, "drained");
}

async fn open_store(
    config: &StorageConfig,
    notifier: &Arc<JobNotifier>,
) -> Result<Arc<dyn Store>, AppError> {
    let (limits, notifier, clock) = (config.limits(), Arc::clone(notifier), Arc::new(SystemClock));
    Ok(match &config.database_url {
        Some(url) => {
            open_postgres(url.as_str(), config.database_connections, limits, notifier, None)
                .await?
        }
        None if config.is_in_memory() => {
            open_sqlite_in_memory(config.memory_bytes(), limits, notifier, clock).await?
        }
        None => open_sqlite(&config.data_dir, limits, notifier, clock).await?,
    })
}

/// Opens the store of API keys beside a service that may be running.
///
/// # Errors
/// [`AppError`].
pub async fn open_keys(config: &StorageConfig) -> Result<Arc<dyn Store>, AppError> {
    Ok(match &config.database_url {
        None => open_sqlite_keys(&config.data_dir, Arc::new(SystemClock)).await?,
        Some(_) => open_store(config, &JobNotifier::new()).await?,
    })
}

/// Opens an existing store for reading, beside the service that owns it.
///
/// # Errors
/// [`AppError`].
pub async fn open_existing(config: &StorageConfig) -> Result<Arc<dyn Store>, AppError> {
    if config.database_url.is_none() && !config.data_dir.join(DATABASE).exists() {
        return Err(AppError::NoStore(config.data_dir.clone()));
    }
    open_keys(config).await
}

/// Removes old jobs periodically.
async fn sweep(store: Arc<dyn JobStore>, retention: Retention) {
    loop {
        match store.sweep(&retention).await {
            Ok(SWEEP..) => continue,
            Ok(0) => {}
            Ok(jobs) => tracing::info!(target: AUDIT, jobs, "removed old jobs"),
            Err(error) => {
                tracing::warn!(error = &error as &dyn std::error::Error, "cannot remove old jobs");
            }
        }
        sleep(SWEEP_INTERVAL).await;
    }
}
