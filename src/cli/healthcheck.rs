//! `brinell healthcheck`: for whatever keeps a service running and has no HTTP client of its own.

use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

use clap::Args;
use tokio::net::lookup_host;
use tokio::time::timeout;

use super::client::Client;
use super::common::block_on;
use super::fault::Fault;
use crate::outgoing::Destination;

/// Arguments of `brinell healthcheck`.
#[derive(Debug, Args)]
pub(super) struct HealthcheckArgs {
    /// Address of the service, http://127.0.0.1:8080 [default: that of --listen]
    url: Option<Destination>,

    /// Address and port that the service listens on, as `serve` has it
    #[arg(long, env = "BRINELL_LISTEN", value_name = "ADDR", default_value = "127.0.0.1:8080")]
    listen: String,

    /// Certificate of a service with TLS (PEM), as `serve` has it: no other is trusted, whatever
    /// its name
    #[arg(long, env = "BRINELL_TLS_CERT", value_name = "FILE")]
    tls_cert: Option<PathBuf>,

    /// Ask whether the process answers (/livez), not whether it takes jobs (/readyz)
    #[arg(long)]
    live: bool,
}

/// Longest time the service may take to answer.
const ACQUIRE_TIMEOUT: Duration = Duration::from_secs(2);

pub(super) fn healthcheck(args: &HealthcheckArgs) -> Result<ExitCode, Fault> {
    let path = if args.live { "/livez" } else { "/readyz" };
    let of_url = args.url.as_ref().map(Destination::listens);
    let listen = of_url.unwrap_or_else(|| args.listen.clone());
    let unwell = |reason: String| Fault::Unwell(format!("{path} of {listen}: {reason}"));
    block_on(async {
        let found = lookup_host(&listen).await.map_err(|error| unwell(error.to_string()))?.next();
        let address = found.map(reachable).ok_or_else(|| unwell("no such address".to_owned()))?;
        let client = match &args.tls_cert {
            Some(file) => {
                Client::pinned(address, file).map_err(|error| unwell(error.to_string()))?
            }
            None => Client::new(address),
        };
        let asked = timeout(ACQUIRE_TIMEOUT, client.get::<serde_json::Value>(path)).await;
        match asked {
            Ok(Ok(_)) => Ok(ExitCode::SUCCESS),
            Ok(Err(error)) => Err(unwell(error.to_string())),
            Err(_) => Err(unwell(format!("no answer within {} s", ACQUIRE_TIMEOUT.as_secs()))),
        }
    })
}

/// Where a service that listens on every address is found.
fn reachable(listens: SocketAddr) -> SocketAddr {
    let ip = match listens.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => Ipv4Addr::LOCALHOST.into(),
        IpAddr::V6(ip) if ip.is_unspecified() => Ipv6Addr::LOCALHOST.into(),
        ip => ip,
    };
    SocketAddr::new(ip, listens.port())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_address_is_also_this_machines() {
        let reached = |address: &str| reachable(address.parse().unwrap()).to_string();
        assert_eq!(reached("0.0.0.0:80"), "127.0.0.1:80");
        assert_eq!(reached("[::]:80"), "[::1]:80");
        assert_eq!(reached("192.168.1.1:80"), "192.168.1.1:80");
    }
}
