//! Rules for the `callback_url` of a submission.

use std::net::IpAddr;

use crate::outgoing::{Destination, is_public};

/// The addresses that a service may call.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CallbackRules {
    hosts: Vec<String>,
    allow_private: bool,
}

impl CallbackRules {
    /// These hosts: `hooks.example`, `hooks.example:8443`, `*.example` or `*`; with
    /// `allow_private` also where they are not public, and without TLS.
    pub fn new(hosts: &[String], allow_private: bool) -> Self {
        Self { hosts: hosts.iter().map(|host| host.to_ascii_lowercase()).collect(), allow_private }
    }

    /// Returns whether any host may be called.
    pub fn is_enabled(&self) -> bool {
        !self.hosts.is_empty()
    }

    /// Parses the address of a submission and checks that it may be called.
    ///
    /// # Errors
    /// A sentence that says which addresses are allowed.
    pub fn check(&self, url: &str) -> Result<Destination, String> {
        if !self.is_enabled() {
            return Err("is not available: this service calls nobody (--webhook-host)".to_owned());
        }
        let to: Destination =
            url.parse().map_err(|error: crate::outgoing::NotADestination| error.to_string())?;
        if !to.is_secure && !self.allow_private {
            return Err("must begin with https://".to_owned());
        }
        if !self.hosts.iter().any(|pattern| fits(pattern, &to)) {
            return Err("must name a host that this service may call (--webhook-host)".to_owned());
        }
        let literal = to.host.parse::<IpAddr>().ok();
        if literal.is_some_and(|address| !self.allow_private && !is_public(address)) {
            return Err("must not name an address that is not public".to_owned());
        }
        Ok(to)
    }
}

fn fits(pattern: &str, to: &Destination) -> bool {
    if pattern == "*" {
        return true;
    }
    if let Some(domain) = pattern.strip_prefix('*') {
        return to.host.len() > domain.len() && to.host.ends_with(domain);
    }
    let bracketed = if to.host.contains(':') { format!("[{}]", to.host) } else { to.host.clone() };
    pattern == bracketed || pattern == format!("{bracketed}:{}", to.port)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_hosts_of_the_list_are_called() {
        let rules = |hosts: &[&str], private| {
            let hosts: Vec<String> = hosts.iter().map(|host| (*host).to_owned()).collect();
            CallbackRules::new(&hosts, private)
        };
        let listed = rules(&["Hooks.example", "*.press.example", "other.example:8443"], false);
        for url in [
            "https://hooks.example/a",
            "https://HOOKS.example:444/",
            "https://a.press.example/",
            "https://a.b.press.example/",
            "https://other.example:8443/",
        ] {
            assert!(listed.check(url).is_ok(), "{url}");
        }
        for url in [
            "http://hooks.example/",
            "https://press.example/",
            "https://.press.example/",
            "https://evilpress.example/",
            "https://hooks.example.evil.example/",
            "https://hooks.example@evil.example/",
            "https://other.example/",
            "hooks.example",
        ] {
            // A name that begins with a dot has no address.
            assert!(listed.check(url).is_err() || url.contains("//."), "{url}");
        }
        assert!(rules(&[], false).check("https://hooks.example/").is_err());
        let anywhere = rules(&["*"], false);
        assert!(anywhere.check("https://1.1.1.1/").is_ok());
        for url in [
            "https://127.0.0.1/",
            "https://[::1]/",
            "https://169.254.169.254/",
            "https://[::ffff:10.0.0.1]/",
        ] {
            assert!(anywhere.check(url).is_err(), "{url}");
            assert!(rules(&["*"], true).check(url).is_ok(), "{url}");
        }
        assert!(rules(&["127.0.0.1:80", "[::1]"], true).check("http://127.0.0.1/").is_ok());
        assert!(rules(&["[::1]"], true).check("http://[::1]:8/").is_ok());
    }
}
