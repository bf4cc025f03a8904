//! API keys.

use brinell::jobs::{ApiKey, KeyStore, Scope};
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
