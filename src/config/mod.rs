//! Settings of the service: each is a flag and a `BRINELL_*` variable; the flag wins.

mod edge;
mod machine;
mod parse;
mod storage;
mod work;

use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::Duration;

use axum::http::HeaderValue;

use clap::Args;

use crate::http::{Capacity, ConnectionTimeouts, HttpSettings, Network};
use crate::jobs::SubmissionLimits;
pub use edge::{TlsConfig, WebhookConfig};
use parse::{connections, origin, own_origin, rate, seconds};
pub use storage::{DatabaseUrl, StorageConfig};
pub use work::WorkConfig;

/// Settings of `brinell serve`.
#[derive(Debug, Clone, PartialEq, Args)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of its own")]
pub struct ServeConfig {
    /// Address and port to listen on; port 0 is any free one
    #[arg(long, env = "BRINELL_LISTEN", value_name = "ADDR", default_value = "127.0.0.1:8080")]
    pub listen: String,

    /// Name under which the service is addressed, several times if need be [default: those of
    /// loopback, if it listens there]
    #[arg(
        long = "allowed-host",
        env = "BRINELL_ALLOWED_HOSTS",
        value_name = "NAME",
        value_delimiter = ','
    )]
    pub allowed_hosts: Vec<String>,

    /// Folder with the guide, which is served at /guide [default: the folder `guide` beside the
    /// program, if it is there]
    #[arg(long, env = "BRINELL_GUIDE", value_name = "FOLDER")]
    pub guide: Option<PathBuf>,

    /// Address of the service for people, `https://press.example`, in the links that the page
    /// copies and prints [default: the one that the browser has]
    #[arg(
        long, env = "BRINELL_PUBLIC_ORIGIN", value_name = "ORIGIN", value_parser = own_origin,
    )]
    pub public_origin: Option<HeaderValue>,

    /// Do not solve here: leave the jobs to `brinell worker` (needs --database-url)
    #[arg(
        long, env = "BRINELL_NO_WORKERS",
        conflicts_with_all = ["workers", "memory_limit", "factor_cache"],
    )]
    pub no_workers: bool,

    /// Longest time POST /v1/solve waits for its result before it answers 202
    #[arg(
        long, env = "BRINELL_SOLVE_LIMIT", value_name = "SECONDS", default_value = "30",
        value_parser = seconds,
    )]
    pub solve_limit: Duration,

    /// Largest request body
    #[arg(long, env = "BRINELL_MAX_BODY", value_name = "BYTES", default_value = "1048576")]
    pub max_body: usize,

    /// Longest time a request's head may take to arrive, and a connection may idle
    #[arg(
        long, env = "BRINELL_HEADER_TIMEOUT", value_name = "SECONDS", default_value = "30",
        value_parser = seconds,
    )]
    pub header_timeout: Duration,

    /// Longest time a request's body may take to arrive
    #[arg(
        long, env = "BRINELL_BODY_TIMEOUT", value_name = "SECONDS", default_value = "30",
        value_parser = seconds,
    )]
    pub body_timeout: Duration,

    /// Longest time a client may take nothing of its answer
    #[arg(
        long, env = "BRINELL_WRITE_TIMEOUT", value_name = "SECONDS", default_value = "30",
        value_parser = seconds,
    )]
    pub write_timeout: Duration,

    /// Most connections at a time; further clients wait
    #[arg(
        long, env = "BRINELL_MAX_CONNECTIONS", value_name = "N", default_value = "4000",
        value_parser = connections,
    )]
    pub max_connections: usize,

    /// Most event streams open at a time
    #[arg(long, env = "BRINELL_MAX_EVENT_STREAMS", value_name = "N", default_value = "1000")]
    pub max_event_streams: usize,

    /// Largest estimated memory of a job
    #[arg(long, env = "BRINELL_MAX_JOB_MEMORY", value_name = "MIB", default_value = "4096")]
    pub max_job_memory: u32,

    /// Largest estimated result of a job
    #[arg(long, env = "BRINELL_MAX_RESULT", value_name = "MIB", default_value = "4096")]
    pub max_result: u32,

    /// Jobs that one API key may hand in a second, ten seconds' worth at once [default: no limit]
    #[arg(long, env = "BRINELL_RATE_LIMIT", value_name = "N", value_parser = rate)]
    pub rate_limit: Option<f64>,

    /// Answer only to API keys (`brinell key create`), on loopback too
    #[arg(long, env = "BRINELL_REQUIRE_API_KEY")]
    pub require_api_key: bool,

    /// Answer to everybody, also on addresses other than loopback
    #[arg(long, env = "BRINELL_ALLOW_ANONYMOUS", conflicts_with = "require_api_key")]
    pub allow_anonymous: bool,

    /// Answer only to the key that this environment variable holds, 32 characters or more, which
    /// is kept nowhere
    #[arg(
        long,
        env = "BRINELL_ONCE_KEY_ENV",
        value_name = "NAME",
        conflicts_with = "allow_anonymous"
    )]
    pub once_key_env: Option<String>,

    /// Stop, as at SIGTERM, when standard input is closed: with the process that holds its other
    /// end
    #[arg(long, env = "BRINELL_EXIT_WITH_STDIN")]
    pub exit_with_stdin: bool,

    /// Origin whose pages may ask this service, e.g. `https://design.example`; `*` is every
    /// origin. May be repeated
    #[arg(
        long, env = "BRINELL_CORS_ORIGIN", value_name = "ORIGIN", value_delimiter = ',',
        value_parser = origin,
    )]
    pub cors_origin: Vec<HeaderValue>,

    /// Proxy whose `X-Forwarded-For` tells the address of the client, for the log: an address, or a
    /// network like `10.0.0.0/8`. May be repeated
    #[arg(
        long = "trusted-proxy",
        env = "BRINELL_TRUSTED_PROXIES",
        value_name = "ADDR",
        value_delimiter = ','
    )]
    pub trusted_proxies: Vec<Network>,

    #[command(flatten)]
    /// Certificate and key.
    pub tls: TlsConfig,

    #[command(flatten)]
    /// Settings of announcements.
    pub webhooks: WebhookConfig,

    #[command(flatten)]
    /// Where metrics are shown.
    pub metrics: MetricsConfig,

    #[command(flatten)]
    /// Where jobs are kept.
    pub storage: StorageConfig,

    #[command(flatten)]
    /// How they are solved.
    pub work: WorkConfig,
}

impl Default for ServeConfig {
    fn default() -> Self {
        Self {
            listen: "127.0.0.1:8080".to_owned(),
            public_origin: None,
            allowed_hosts: Vec::new(),
            guide: None,
            no_workers: false,
            solve_limit: Duration::from_secs(30),
            max_body: 1 << 20,
            header_timeout: Duration::from_secs(30),
            body_timeout: Duration::from_secs(30),
            write_timeout: Duration::from_secs(30),
            max_connections: 4000,
            max_event_streams: 1000,
            max_job_memory: 4096,
            max_result: 4096,
            rate_limit: None,
            require_api_key: false,
            allow_anonymous: false,
            once_key_env: None,
            exit_with_stdin: false,
            cors_origin: Vec::new(),
            trusted_proxies: Vec::new(),
            tls: TlsConfig::default(),
            webhooks: WebhookConfig::default(),
            metrics: MetricsConfig::default(),
            storage: StorageConfig::default(),
            work: WorkConfig::default(),
        }
    }
}

impl ServeConfig {
    /// Returns the bounds on accepted jobs. A job too large for the solvers of this process is
    /// refused, unless other processes solve.
    pub fn submission_limits(&self) -> SubmissionLimits {
        let job_bytes = u64::from(self.max_job_memory) << 20;
        let solvable = if self.storage.is_shared() { u64::MAX } else { self.work.job_memory() };
        SubmissionLimits {
            job_bytes: job_bytes.min(solvable),
            result_bytes: u64::from(self.max_result) << 20,
        }
    }

    /// Returns whether requests need an API key: if so configured, and on any address other than
    /// loopback.
    pub fn keys_required(&self, address: SocketAddr) -> bool {
        self.require_api_key
            || self.once_key_env.is_some()
            || !(self.allow_anonymous || address.ip().to_canonical().is_loopback())
    }

    /// Bounds on single requests.
    pub fn http(&self) -> HttpSettings {
        HttpSettings {
            max_body_bytes: self.max_body,
            body_timeout: self.body_timeout,
            timeouts: ConnectionTimeouts { head: self.header_timeout, write: self.write_timeout },
            connections: self.max_connections,
            event_streams: self.max_event_streams,
            solve_limit: self.solve_limit,
            jobs_per_second: self.rate_limit,
            cors_origins: self.cors_origin.clone(),
            public_origin: self.public_origin.clone(),
            trusted_proxies: self.trusted_proxies.clone(),
            retention: self.storage.retention(),
            capacity: Capacity {
                solvers: if self.no_workers { 0 } else { self.work.slots() },
                memory_bytes: if self.no_workers { 0 } else { self.work.memory() },
                queued_jobs: self.storage.queue_capacity,
                job_seconds: self.work.job_timeout.as_secs_f64(),
            },
            ..HttpSettings::default()
        }
    }
}

/// Settings of the metrics.
#[derive(Debug, Clone, PartialEq, Default, Args)]
pub struct MetricsConfig {
    /// Address and port to show metrics on, at /metrics, to everybody [default: `serve` shows them
    /// on its own port, `worker` nowhere]
    #[arg(long, env = "BRINELL_METRICS_LISTEN", value_name = "ADDR")]
    pub metrics_listen: Option<String>,
}

/// Settings of `brinell worker`.
#[derive(Debug, Clone, PartialEq, Default, Args)]
pub struct WorkerConfig {
    #[command(flatten)]
    /// Where metrics are shown.
    pub metrics: MetricsConfig,

    #[command(flatten)]
    /// Where jobs are kept.
    pub storage: StorageConfig,

    #[command(flatten)]
    /// How they are solved.
    pub work: WorkConfig,
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        config: ServeConfig,
    }

    #[test]
    fn keys_are_required_where_others_can_ask() {
        let config = ServeConfig::default();
        let required = |address: &str| config.keys_required(address.parse().unwrap());
        assert!(!required("127.0.0.1:80") && !required("[::1]:80"));
        assert!(required("0.0.0.0:80") && required("192.168.1.1:80") && required("[::]:80"));
        let open = ServeConfig { allow_anonymous: true, ..ServeConfig::default() };
        assert!(!open.keys_required("0.0.0.0:80".parse().unwrap()));
        let closed = ServeConfig { require_api_key: true, ..ServeConfig::default() };
        assert!(closed.keys_required("127.0.0.1:80".parse().unwrap()));
        let once = ServeConfig { once_key_env: Some("KEY".to_owned()), ..ServeConfig::default() };
        assert!(once.keys_required("127.0.0.1:80".parse().unwrap()));
    }

    #[test]
    fn the_defaults_of_the_flags_are_the_defaults_of_the_type() {
        assert_eq!(Line::parse_from(["brinell"]).config, ServeConfig::default());
    }
}
