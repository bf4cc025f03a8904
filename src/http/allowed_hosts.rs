//! The host names that a service answers to.

use std::net::SocketAddr;

/// Host names of a service that listens on loopback.
const LOOPBACK: [&str; 3] = ["localhost", "127.0.0.1", "[::1]"];

/// The hosts that a service answers to.
///
/// A foreign web page can make its own host name resolve to this machine (DNS rebinding) and then
/// send requests as if it came from this service. The `Host` header still holds the foreign name.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct AllowedHosts(Option<Vec<String>>);

impl AllowedHosts {
    /// Accepts the given names. Without any, accepts the names of loopback if the service listens
    /// there alone, and every name otherwise: there, requests need an API key or are open to all.
    pub fn new(names: &[String], address: SocketAddr) -> Self {
        let is_loopback = address.ip().to_canonical().is_loopback();
        if names.is_empty() && !is_loopback {
            return Self(None);
        }
        let bound = address.ip().to_string();
        let loopback = LOOPBACK.iter().map(|name| (*name).to_owned()).chain([bound]);
        let names = names.iter().map(|name| name.to_ascii_lowercase());
        Self(Some(names.chain(loopback.filter(|_| is_loopback)).collect()))
    }

    /// Returns whether a `Host` header names this service.
    pub(super) fn allow(&self, host: &str) -> bool {
        let name = host
            .rsplit_once(':')
            .filter(|(_, port)| port.bytes().all(|byte| byte.is_ascii_digit()));
        let name = name.map_or(host, |(name, _)| name).to_ascii_lowercase();
        self.0.as_ref().is_none_or(|names| names.contains(&name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_known_names_are_answered_to() {
        let hosts = |names: &[&str], address: &str| {
            let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
            AllowedHosts::new(&names, address.parse().unwrap())
        };
        let local = hosts(&[], "127.0.0.1:8080");
        for name in ["localhost", "LOCALHOST:8080", "127.0.0.1:8080", "[::1]:8080", "[::1]"] {
            assert!(local.allow(name), "{name}");
        }
        for name in ["evil.example", "localhost.evil.example:8080", "", "127.0.0.1.evil.example"] {
            assert!(!local.allow(name), "{name}");
        }
        assert!(hosts(&[], "0.0.0.0:8080").allow("any.example"));
        let named = hosts(&["Brinell.example"], "0.0.0.0:8080");
        assert!(named.allow("brinell.example:443") && !named.allow("localhost"));
        assert!(hosts(&["brinell.example"], "127.0.0.1:8080").allow("localhost"));
    }
}
