//! API keys and their scopes.
//!
//! A token is `brinell_<id>_<secret>`. The id finds the key in the store. The secret is random and
//! long enough that its plain SHA-256 cannot be reversed by guessing; the store keeps this digest
//! only. Digests are compared in constant time.

use std::time::Duration;

use async_trait::async_trait;
use brinell_solver::job::Named;
use clap::ValueEnum;
use jiff::Timestamp;
use serde::Serialize;
use sha2::{Digest, Sha256};
use strum::{IntoStaticStr, VariantArray};
use subtle::ConstantTimeEq;
use uuid::Uuid;

use super::{KeyId, StoreError};

const PREFIX: &str = "brinell_";

/// What a key may do.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    IntoStaticStr,
    ValueEnum,
    VariantArray,
)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum Scope {
    /// Look at its own jobs.
    Read,
    /// Hand jobs in, stop and remove its own.
    Write,
    /// Look at everybody's jobs.
    Monitor,
    /// Everything, with everybody's jobs.
    Admin,
}

impl Scope {
    /// Returns whether the key may submit, cancel and remove jobs.
    pub const fn changes(self) -> bool {
        matches!(self, Self::Write | Self::Admin)
    }

    /// Returns whether the key sees the jobs of all keys.
    pub const fn sees_all(self) -> bool {
        matches!(self, Self::Monitor | Self::Admin)
    }
}

impl Named for Scope {}

/// Limits of an API key; `None` takes the limit of the service's settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct KeyLimits {
    /// Jobs waiting.
    pub queued: Option<u32>,
    /// Jobs being solved at the same time, by all workers together.
    pub running: Option<u32>,
    /// Bytes of results, those that unfinished jobs are estimated to have included.
    pub stored_bytes: Option<u64>,
    /// Highest priority of a job.
    pub priority: Option<i16>,
}

impl KeyLimits {
    /// Returns these limits, with `defaults` where a limit is `None`.
    #[must_use]
    pub fn or(self, defaults: Self) -> Self {
        Self {
            queued: self.queued.or(defaults.queued),
            running: self.running.or(defaults.running),
            stored_bytes: self.stored_bytes.or(defaults.stored_bytes),
            priority: self.priority.or(defaults.priority),
        }
    }
}

/// The previous secret of a key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PreviousSecret {
    /// SHA-256 of it.
    pub digest: [u8; 32],
    /// When the secret expires.
    pub until: Timestamp,
}

/// A key as it is stored.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ApiKey {
    /// Its name for programs.
    pub id: KeyId,
    /// Its name for people.
    pub name: String,
    /// What it may do.
    pub scope: Scope,
    /// SHA-256 of the secret.
    pub digest: [u8; 32],
    /// The secret before this one.
    pub previous: Option<PreviousSecret>,
    /// Its limits.
    pub limits: KeyLimits,
    /// When it was made.
    pub created_at: Timestamp,
    /// When it expires.
    pub expires_at: Option<Timestamp>,
    /// When it was revoked.
    pub revoked_at: Option<Timestamp>,
}

impl ApiKey {
    /// Generates a key and its token. The token cannot be recovered later.
    pub fn generate(name: String, scope: Scope, now: Timestamp) -> (Self, String) {
        let id = KeyId::generate();
        let (digest, token) = new_secret(id);
        let key = Self {
            id,
            name,
            scope,
            digest,
            previous: None,
            limits: KeyLimits::default(),
            created_at: now,
            expires_at: None,
            revoked_at: None,
        };
        (key, token)
    }

    /// Returns whether `secret` is a secret of this key and the key is valid.
    pub fn accepts(&self, secret: &str, now: Timestamp) -> bool {
        let given = digest(secret);
        let is_current = bool::from(self.digest.ct_eq(&given));
        let is_previous = self
            .previous
            .as_ref()
            .is_some_and(|old| bool::from(old.digest.ct_eq(&given)) && now < old.until);
        (is_current || is_previous) && self.is_good(now)
    }

    /// Returns whether the key is neither revoked nor expired.
    pub fn is_good(&self, now: Timestamp) -> bool {
        self.revoked_at.is_none() && self.expires_at.is_none_or(|end| now < end)
    }
}

/// Generates a new secret for a key: its digest and the token.
pub fn new_secret(id: KeyId) -> ([u8; 32], String) {
    // Two random UUIDs are 244 random bits.
    let secret = format!("{}{}", Uuid::new_v4().simple(), Uuid::new_v4().simple());
    (digest(&secret), format!("{PREFIX}{}_{secret}", id.uuid().simple()))
}

/// A key that one process receives at its start and never stores. Its bearer is an administrator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OnceKey([u8; 32]);

impl OnceKey {
    /// Fewest characters of the secret: 128 bits in hexadecimal.
    pub const MIN_LENGTH: usize = 32;

    /// Wraps a secret; `None` if it is shorter than the minimum.
    pub fn new(secret: &str) -> Option<Self> {
        (secret.len() >= Self::MIN_LENGTH).then(|| Self(digest(secret)))
    }

    /// Returns whether `secret` is the secret of this key.
    pub fn accepts(&self, secret: &str) -> bool {
        bool::from(self.0.ct_eq(&digest(secret)))
    }
}

fn digest(secret: &str) -> [u8; 32] {
    Sha256::digest(secret.as_bytes()).into()
}

/// Splits a token into id and secret; `None` if the text is no token.
pub fn read_token(token: &str) -> Option<(KeyId, &str)> {
    let (id, secret) = token.strip_prefix(PREFIX)?.split_once('_')?;
    Some((id.parse().ok()?, secret))
}

/// Stores API keys.
#[async_trait]
pub trait KeyStore: Send + Sync + 'static {
    /// Stores a key.
    async fn add_key(&self, key: ApiKey) -> Result<(), StoreError>;

    /// Returns all keys, the oldest first, or the key of the given id.
    async fn keys(&self, id: Option<KeyId>) -> Result<Vec<ApiKey>, StoreError>;

    /// Gives a key a new secret; the present secret stays valid for `overlap`. Returns `false` if
    /// the key does not exist or is revoked.
    async fn rotate_key(
        &self,
        id: KeyId,
        digest: [u8; 32],
        overlap: Duration,
    ) -> Result<bool, StoreError>;

    /// Sets limits and expiry of a key. Returns `false` if the key does not exist or is revoked.
    async fn limit_key(
        &self,
        id: KeyId,
        limits: KeyLimits,
        expires_at: Option<Timestamp>,
    ) -> Result<bool, StoreError>;

    /// Revokes a key. Returns `false` if the key does not exist or was revoked before.
    async fn revoke_key(&self, id: KeyId) -> Result<bool, StoreError>;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_expires_and_so_does_a_secret_that_was_replaced() {
        let at = |second| Timestamp::from_second(second).unwrap();
        let (key, token) = ApiKey::generate("press".to_owned(), Scope::Write, at(0));
        let (_, old) = read_token(&token).unwrap();
        let (digest, token) = new_secret(key.id);
        let (id, new) = read_token(&token).unwrap();
        assert_eq!(id, key.id);
        let previous = Some(PreviousSecret { digest: key.digest, until: at(10) });
        let key = ApiKey { digest, previous, expires_at: Some(at(20)), ..key };
        let good = |second| [old, new].map(|secret| key.accepts(secret, at(second)));
        assert_eq!(
            [good(9), good(10), good(19), good(20)],
            [[true, true], [false, true], [false, true], [false, false]]
        );
        assert!(!ApiKey { revoked_at: Some(at(0)), ..key.clone() }.accepts(old, at(1)));
    }

    #[test]
    fn a_once_key_is_long_and_accepts_itself_alone() {
        let secret = "0123456789abcdef0123456789abcdef";
        assert_eq!(OnceKey::new(&secret[1..]), None);
        let key = OnceKey::new(secret).unwrap();
        assert!(key.accepts(secret) && !key.accepts(&secret[1..]) && !key.accepts(""));
        assert!(!format!("{key:?}").contains(secret));
    }

    #[test]
    fn a_token_opens_its_key_and_no_other() {
        let now = Timestamp::UNIX_EPOCH;
        let (key, token) = ApiKey::generate("press".to_owned(), Scope::Write, now);
        let (id, secret) = read_token(&token).unwrap();
        assert_eq!(id, key.id);
        assert!(key.accepts(secret, now));
        let (other, _) = ApiKey::generate("lathe".to_owned(), Scope::Write, now);
        assert!(!other.accepts(secret, now) && !key.accepts("", now));
        assert!(!ApiKey { revoked_at: Some(now), ..key.clone() }.accepts(secret, now));
        assert!(!format!("{key:?}").contains(secret));
        for noise in ["", "brinell_", "brinell_x_y", "token"] {
            assert_eq!(read_token(noise), None, "{noise:?}");
        }
    }
}
