//! `brinell key`: API keys are made, listed and revoked here, also beside a running service.

use std::fmt::Write as _;
use std::process::ExitCode;
use std::time::Duration;

use clap::{Args, Subcommand};
use jiff::tz::TimeZone;
use jiff::{Span, Timestamp};

use super::common::block_on;
use super::fault::Fault;
use super::input::write_answer;
use crate::app::{open_existing, open_keys};
use crate::config::StorageConfig;
use crate::jobs::{ApiKey, Clock, KeyId, KeyLimits, Scope, SystemClock, new_secret};
use crate::telemetry::AUDIT;
use brinell_solver::job::Named as _;

/// Arguments of `brinell key`.
#[derive(Debug, Args)]
pub(super) struct KeyArgs {
    #[command(subcommand)]
    command: KeyCommand,
}

#[derive(Debug, Subcommand)]
enum KeyCommand {
    /// Make a key and print its token, which is not shown again
    ///
    /// A request that sends a key is checked. Requests without one are refused where the service
    /// listens beyond loopback, unless it runs with --allow-anonymous, and everywhere with
    /// --require-api-key.
    Create {
        /// Whose it is, for people
        name: String,
        /// What it may do
        #[arg(long, value_name = "SCOPE", default_value = "write")]
        scope: Scope,
        #[command(flatten)]
        limits: Limits,
        #[command(flatten)]
        storage: StorageConfig,
    },
    /// List all keys
    List {
        #[command(flatten)]
        storage: StorageConfig,
    },
    /// Set what a key may take and when it expires; what is not given is left to the settings of
    /// the service
    Limit {
        /// Which
        id: KeyId,
        #[command(flatten)]
        limits: Limits,
        #[command(flatten)]
        storage: StorageConfig,
    },
    /// Give a key another secret and print its token; its jobs and limits stay
    Rotate {
        /// Which
        id: KeyId,
        /// How long the token so far stays good
        #[arg(long, value_name = "HOURS", default_value = "24", value_parser = hours_or_none)]
        overlap: Duration,
        #[command(flatten)]
        storage: StorageConfig,
    },
    /// Make a key no longer good, at once and for ever
    Revoke {
        /// Which
        id: KeyId,
        #[command(flatten)]
        storage: StorageConfig,
    },
}

/// What a key may take.
#[derive(Debug, Clone, Copy, Args)]
struct Limits {
    /// Most jobs that may wait [default: that of the service]
    #[arg(long, value_name = "N")]
    max_queued: Option<u32>,
    /// Most jobs that may be solved at the same time [default: that of the service]
    #[arg(long, value_name = "N")]
    max_running: Option<u32>,
    /// Room that results may take [default: that of the service]
    #[arg(long, value_name = "MIB")]
    max_stored: Option<u32>,
    /// Highest priority of a job [default: that of the service]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    max_priority: Option<i16>,
    /// When the key ceases to be good: a moment, `2027-01-31T12:00:00Z`, or a time from now, `90
    /// days` [default: never]
    #[arg(long, value_name = "TIME", value_parser = moment)]
    expires: Option<Timestamp>,
}

impl Limits {
    fn limits(self) -> KeyLimits {
        KeyLimits {
            queued: self.max_queued,
            running: self.max_running,
            stored_bytes: self.max_stored.map(|mebibytes| u64::from(mebibytes) << 20),
            priority: self.max_priority,
        }
    }
}

pub(super) fn key(args: &KeyArgs) -> Result<ExitCode, Fault> {
    block_on(async {
        let text = match &args.command {
            KeyCommand::Create { name, scope, limits, storage } => {
                create(name, *scope, *limits, storage).await?
            }
            KeyCommand::List { storage } => {
                let now = SystemClock.now();
                open_existing(storage)
                    .await?
                    .keys(None)
                    .await?
                    .iter()
                    .map(|key| line(key, now))
                    .collect()
            }
            KeyCommand::Limit { id, limits, storage } => {
                let keys = open_existing(storage).await?;
                if !keys.limit_key(*id, limits.limits(), limits.expires).await? {
                    return Err(Fault::NoKey(*id));
                }
                let (key, expires, limits) = (id, &limits.expires, limits.limits());
                tracing::info!(target: AUDIT, %key, ?limits, ?expires, "limits of a key set");
                format!("the limits of {id} are set\n")
            }
            KeyCommand::Rotate { id, overlap, storage } => {
                let (digest, token) = new_secret(*id);
                if !open_existing(storage).await?.rotate_key(*id, digest, *overlap).await? {
                    return Err(Fault::NoKey(*id));
                }
                tracing::info!(target: AUDIT, key = %id, ?overlap, "key rotated");
                format!("{token}\n")
            }
            KeyCommand::Revoke { id, storage } => {
                if !open_existing(storage).await?.revoke_key(*id).await? {
                    return Err(Fault::NoKey(*id));
                }
                tracing::info!(target: AUDIT, key = %id, "key revoked");
                format!("{id} is revoked\n")
            }
        };
        write_answer(None, text.as_bytes())?;
        Ok(ExitCode::SUCCESS)
    })
}

async fn create(
    name: &str,
    scope: Scope,
    limits: Limits,
    storage: &StorageConfig,
) -> Result<String, Fault> {
    let (key, token) = ApiKey::generate(name.to_owned(), scope, SystemClock.now());
    let key = ApiKey { limits: limits.limits(), expires_at: limits.expires, ..key };
    let id = key.id;
    open_keys(storage).await?.add_key(key).await?;
    tracing::info!(target: AUDIT, key = %id, name, ?scope, ?limits, "key made");
    Ok(format!("{token}\n"))
}

fn line(key: &ApiKey, now: Timestamp) -> String {
    let state = match (key.revoked_at, key.is_good(now)) {
        (Some(_), _) => "revoked",
        (None, false) => "expired",
        (None, true) => "good",
    };
    let mut notes = String::new();
    let KeyLimits { queued, running, stored_bytes, priority } = key.limits;
    let bounds = [
        ("queued", queued.map(i64::from)),
        ("running", running.map(i64::from)),
        ("stored MiB", stored_bytes.and_then(|bytes| i64::try_from(bytes >> 20).ok())),
        ("priority", priority.map(i64::from)),
    ];
    for (name, bound) in bounds {
        let _ = bound.map(|bound| write!(notes, ", {name} <= {bound}"));
    }
    let _ = key.expires_at.map(|end| write!(notes, ", until {end:.0}"));
    format!(
        "{}  {:5}  {state:7}  {:.0}  {}{notes}\n",
        key.id,
        key.scope.name(),
        key.created_at,
        key.name
    )
}

/// Reads a moment, or a time from now.
fn moment(text: &str) -> Result<Timestamp, String> {
    if let Ok(moment) = text.parse() {
        return Ok(moment);
    }
    let span: Span = text.parse().map_err(
        |_| "must be a moment such as 2027-01-31T12:00:00Z, or a time such as `90 days`",
    )?;
    let end = SystemClock.now().to_zoned_datetime(TimeZone::UTC).checked_add(span);
    end.map(|end| end.timestamp()).map_err(|error| error.to_string())
}

/// Reads a number of hours, which may be 0.
fn hours_or_none(text: &str) -> Result<Duration, String> {
    let hours: f64 = text.parse().map_err(|_| "must be a number of hours")?;
    let most = 24.0 * 366.0;
    let is_possible = (0.0..=most).contains(&hours);
    if is_possible {
        Ok(Duration::from_secs_f64(hours * 3600.0))
    } else {
        Err(format!("must be from 0 to {most} hours"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_expires_at_a_moment_or_after_a_time() {
        assert_eq!(moment("2027-01-31T12:00:00Z").unwrap().to_string(), "2027-01-31T12:00:00Z");
        let day = moment("1 day").unwrap().duration_since(SystemClock.now());
        assert!((86_390..=86_400).contains(&day.as_secs()), "{day}");
        for text in ["", "soon", "2027-01-31", "90000000 years"] {
            assert!(moment(text).is_err(), "{text}");
        }
        assert_eq!(hours_or_none("0"), Ok(Duration::ZERO));
        assert!(hours_or_none("-1").is_err() && hours_or_none("NaN").is_err());
    }
}
