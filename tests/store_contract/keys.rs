//! API keys.

use std::time::Duration;

use brinell::jobs::{ApiKey, KeyId, KeyLimits, KeyStore, Scope, new_secret, read_token};
use jiff::Timestamp;

use crate::subject::Subject;

pub async fn api_keys_are_kept_and_revoked(subject: &Subject) {
    let store: &dyn KeyStore = subject.store.as_ref();
    let now = Timestamp::UNIX_EPOCH;
    let (first, _) = ApiKey::generate("press".to_owned(), Scope::Write, now);
    let (second, _) = ApiKey::generate("lathe".to_owned(), Scope::Admin, now);
    for key in [&first, &second] {
        store.add_key(key.clone()).await.unwrap();
    }
    assert_eq!(store.keys(None).await.unwrap(), [first.clone(), second.clone()]);
    assert_eq!(store.keys(Some(second.id)).await.unwrap(), std::slice::from_ref(&second));
    assert!(store.revoke_key(first.id).await.unwrap());
    assert!(!store.revoke_key(first.id).await.unwrap());
    assert!(store.keys(Some(first.id)).await.unwrap()[0].revoked_at.is_some());
    assert!(store.keys(Some(second.id)).await.unwrap()[0].revoked_at.is_none());
}

pub async fn a_secret_is_replaced_and_limits_are_changed(subject: &Subject) {
    let store: &dyn KeyStore = subject.store.as_ref();
    let limits =
        KeyLimits { queued: Some(1), running: Some(2), stored_bytes: Some(3), priority: Some(-4) };
    let (key, old) = ApiKey::generate("press".to_owned(), Scope::Write, Timestamp::UNIX_EPOCH);
    let key = ApiKey { limits, expires_at: Some("2030-01-01T00:00:00Z".parse().unwrap()), ..key };
    store.add_key(key.clone()).await.unwrap();
    assert_eq!(store.keys(Some(key.id)).await.unwrap(), std::slice::from_ref(&key));

    let (digest, new) = new_secret(key.id);
    assert!(store.rotate_key(key.id, digest, Duration::from_mins(1)).await.unwrap());
    let rotated = store.keys(Some(key.id)).await.unwrap().remove(0);
    let start = brinell::jobs::Clock::now(subject.clock.as_ref());
    for (after, good) in [(59, [true, true]), (61, [false, true])] {
        let now = start + Duration::from_secs(after);
        assert_eq!(
            [&old, &new].map(|token| rotated.accepts(read_token(token).unwrap().1, now)),
            good
        );
    }
    let less = KeyLimits { running: Some(1), ..KeyLimits::default() };
    assert!(store.limit_key(key.id, less, None).await.unwrap());
    let limited = store.keys(Some(key.id)).await.unwrap().remove(0);
    assert_eq!((limited.limits, limited.expires_at, limited.digest), (less, None, digest));

    store.revoke_key(key.id).await.unwrap();
    for id in [key.id, KeyId::generate()] {
        assert!(!store.rotate_key(id, digest, Duration::ZERO).await.unwrap());
        assert!(!store.limit_key(id, limits, None).await.unwrap());
    }
}
