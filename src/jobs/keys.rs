//! API keys: who may ask, and for what.
//!
//! A token is `brinell_<id>_<secret>`. The secret is random and long, so a plain SHA-256 of it is all that is kept:
//! nobody can guess what would have to be guessed. The id finds the key; the digests are compared in constant time.

use async_trait::async_trait;
use jiff::Timestamp;
use serde::Serialize;
use sha2::{Digest, Sha256};
use subtle::ConstantTimeEq;
use uuid::Uuid;

use super::{KeyId, StoreError};

const PREFIX: &str = "brinell_";

/// What a key may do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Scope {
    /// Look at its own jobs.
    Read,
    /// Hand jobs in too, and stop and remove its own.
    Write,
    /// Everything, with everybody's jobs.
    Admin,
}

impl Scope {
    /// Every scope.
    pub const ALL: [Self; 3] = [Self::Read, Self::Write, Self::Admin];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Read => "read",
            Self::Write => "write",
            Self::Admin => "admin",
        }
    }

    /// The scope of that name.
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|scope| scope.name() == name)
    }
}

/// A key as it is kept.
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
    /// When it was made.
    pub created_at: Timestamp,
    /// Since when it is no longer good.
    pub revoked_at: Option<Timestamp>,
}

impl ApiKey {
    /// A new key and its token, which is never seen again.
    pub fn generate(name: String, scope: Scope, now: Timestamp) -> (Self, String) {
        let id = KeyId::generate();
        // Two random UUIDs are 244 random bits.
        let secret = format!("{}{}", Uuid::new_v4().simple(), Uuid::new_v4().simple());
        let token = format!("{PREFIX}{}_{secret}", id.uuid().simple());
        (Self { id, name, scope, digest: digest(&secret), created_at: now, revoked_at: None }, token)
    }

    /// Whether this is its secret, and it is still good.
    pub fn accepts(&self, secret: &str) -> bool {
        bool::from(self.digest.ct_eq(&digest(secret))) && self.revoked_at.is_none()
    }
}

fn digest(secret: &str) -> [u8; 32] {
    Sha256::digest(secret.as_bytes()).into()
}

/// The id and the secret in a token; `None` if it is no token.
pub fn read_token(token: &str) -> Option<(KeyId, &str)> {
    let (id, secret) = token.strip_prefix(PREFIX)?.split_once('_')?;
    Some((id.parse().ok()?, secret))
}

/// Keeps API keys, beside the jobs they are for.
#[async_trait]
pub trait KeyStore: Send + Sync + 'static {
    /// Keeps a key.
    ///
    /// # Errors
    /// [`StoreError::Unavailable`].
    async fn add_key(&self, key: ApiKey) -> Result<(), StoreError>;

    /// All keys, the oldest first, or the one of that id.
    ///
    /// # Errors
    /// [`StoreError::Unavailable`].
    async fn keys(&self, id: Option<KeyId>) -> Result<Vec<ApiKey>, StoreError>;

    /// Makes a key no longer good; `false` if there is none, or it was revoked before.
    ///
    /// # Errors
    /// [`StoreError::Unavailable`].
    async fn revoke_key(&self, id: KeyId) -> Result<bool, StoreError>;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_token_opens_its_key_and_no_other() {
        let now = Timestamp::UNIX_EPOCH;
        let (key, token) = ApiKey::generate("press".to_owned(), Scope::Write, now);
        let (id, secret) = read_token(&token).unwrap();
        assert_eq!(id, key.id);
        assert!(key.accepts(secret));
        let (other, _) = ApiKey::generate("lathe".to_owned(), Scope::Write, now);
        assert!(!other.accepts(secret) && !key.accepts(""));
        assert!(!ApiKey { revoked_at: Some(now), ..key.clone() }.accepts(secret));
        assert!(!format!("{key:?}").contains(secret));
        for noise in ["", "brinell_", "brinell_x_y", "token"] {
            assert_eq!(read_token(noise), None, "{noise:?}");
        }
    }
}
