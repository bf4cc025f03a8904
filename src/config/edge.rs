//! Settings of TLS and of announcements.

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;

use super::parse::seconds;
use crate::webhook::{CallbackRules, WebhookSecret};

/// Settings of TLS.
#[derive(Debug, Clone, PartialEq, Default, Args)]
pub struct TlsConfig {
    /// Serve HTTPS with these certificates (PEM, the service's own first); read again on SIGHUP
    /// [default: HTTP]
    #[arg(long, env = "BRINELL_TLS_CERT", value_name = "FILE", requires = "tls_key")]
    pub tls_cert: Option<PathBuf>,

    /// Private key of the first certificate (PEM)
    #[arg(long, env = "BRINELL_TLS_KEY", value_name = "FILE", requires = "tls_cert")]
    pub tls_key: Option<PathBuf>,
}

/// Settings of announcements (webhooks).
#[derive(Debug, Clone, PartialEq, Args)]
pub struct WebhookConfig {
    /// Host that `callback_url` may name: `hooks.example`, `hooks.example:8443`, `*.example` or
    /// `*`. May be repeated [default: none, nobody is called]
    #[arg(
        long = "webhook-host",
        env = "BRINELL_WEBHOOK_HOSTS",
        value_name = "HOST",
        value_delimiter = ',',
        requires = "webhook_secrets"
    )]
    pub webhook_hosts: Vec<String>,

    /// Secret that announcements are signed with, `whsec_` and 24 to 64 bytes in base64; several
    /// while it is being replaced
    #[arg(
        long = "webhook-secret",
        env = "BRINELL_WEBHOOK_SECRETS",
        value_name = "SECRET",
        value_delimiter = ',',
        hide_env_values = true
    )]
    pub webhook_secrets: Vec<WebhookSecret>,

    /// Call hosts also at private, loopback and other addresses that are not public, and without
    /// TLS
    #[arg(long, env = "BRINELL_WEBHOOK_ALLOW_PRIVATE")]
    pub webhook_allow_private: bool,

    /// Further authorities whose certificates receivers may have (PEM)
    #[arg(long, env = "BRINELL_WEBHOOK_CA", value_name = "FILE")]
    pub webhook_ca: Option<PathBuf>,

    /// Pause behind the first attempt that fails; the others are 6, 24, 120, 720, 2160, 5760 and
    /// 8640 times as long
    #[arg(
        long, env = "BRINELL_WEBHOOK_RETRY", value_name = "SECONDS", default_value = "5",
        value_parser = seconds,
    )]
    pub webhook_retry: Duration,
}

impl Default for WebhookConfig {
    fn default() -> Self {
        Self {
            webhook_hosts: Vec::new(),
            webhook_secrets: Vec::new(),
            webhook_allow_private: false,
            webhook_ca: None,
            webhook_retry: Duration::from_secs(5),
        }
    }
}

impl WebhookConfig {
    /// Returns the rules for hosts that may be called.
    pub fn rules(&self) -> CallbackRules {
        CallbackRules::new(&self.webhook_hosts, self.webhook_allow_private)
    }
}
