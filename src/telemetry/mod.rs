//! The log, written to standard error for a person or as JSON lines, and the metrics.

mod metrics;
#[cfg(feature = "otlp")]
mod otlp;
mod trace;

use std::io::{self, IsTerminal};

use clap::{Args, ValueEnum};
pub use tracing_subscriber::filter::LevelFilter;
use tracing_subscriber::filter::Targets;
use tracing_subscriber::layer::SubscriberExt;
use tracing_subscriber::util::SubscriberInitExt;
use tracing_subscriber::{Layer, fmt, registry};

pub use metrics::collect;
#[cfg(feature = "otlp")]
pub use otlp::flush;
pub use trace::adopt;

/// Target of the audit log: who changed what.
pub const AUDIT: &str = "brinell::audit";

/// Settings of the log.
#[derive(Debug, Clone, Args)]
pub struct LogConfig {
    /// What to log, e.g. `info` or `brinell=debug,warn` [default: info for serve, warn elsewhere]
    #[arg(long, env = "BRINELL_LOG", value_name = "FILTER", global = true)]
    pub log: Option<Targets>,

    /// How to log
    #[arg(
        long,
        env = "BRINELL_LOG_FORMAT",
        value_name = "FORMAT",
        default_value = "text",
        global = true
    )]
    pub log_format: LogFormat,

    /// Collector that spans are sent to by OTLP over HTTP, e.g. `http://collector:4318` [default:
    /// none]
    #[cfg(feature = "otlp")]
    #[arg(long, env = "BRINELL_OTLP_ENDPOINT", value_name = "URL", global = true)]
    pub otlp_endpoint: Option<crate::outgoing::Destination>,
}

/// Form of the log.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LogFormat {
    /// For a person.
    Text,
    /// One JSON object a line.
    Json,
}

/// Starts logging. Unless a filter is set, it logs from `level` on, the audit log from `audit` on.
/// Panics are logged too. A second call changes nothing.
pub fn start(config: &LogConfig, level: LevelFilter, audit: LevelFilter) {
    let default = || Targets::new().with_default(level).with_target(AUDIT, audit);
    let filter = config.log.clone().unwrap_or_else(default);
    let log = fmt::layer().with_writer(io::stderr);
    let log = match config.log_format {
        LogFormat::Text => log.with_ansi(io::stderr().is_terminal()).boxed(),
        LogFormat::Json => log.json().boxed(),
    };
    let subscriber = registry().with(log.with_filter(filter));
    #[cfg(feature = "otlp")]
    let subscriber =
        subscriber.with(config.otlp_endpoint.as_ref().map(otlp::layer).and_then(|layer| {
            // The log is not there yet.
            layer.inspect_err(|error| eprintln!("spans are not sent: {error}")).ok()
        }));
    if subscriber.try_init().is_ok() {
        std::panic::set_hook(Box::new(|panic| {
            let place = panic.location().map(ToString::to_string).unwrap_or_default();
            let message = panic.payload_as_str().unwrap_or("(no message)");
            tracing::error!(panic = message, place, "panic");
        }));
    }
}
