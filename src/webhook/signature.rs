//! Signatures of announcements in the format of Standard Webhooks, whose libraries verify them.
//!
//! ```text
//! webhook-signature: v1,base64(HMAC-SHA256(secret, "{id}.{timestamp}.{body}"))
//! ```
//!
//! # Reference
//! *Standard Webhooks*, specification 1.0, <https://www.standardwebhooks.com>.

use std::fmt;
use std::str::FromStr;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use hmac::{Hmac, KeyInit, Mac};
use sha2::Sha256;

const PREFIX: &str = "whsec_";
/// Lengths \[bytes\] that a secret may have.
const LENGTHS: std::ops::RangeInclusive<usize> = 24..=64;

/// A secret that service and receivers share.
#[derive(Clone, PartialEq, Eq)]
pub struct WebhookSecret(Vec<u8>);

impl FromStr for WebhookSecret {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let bytes = text.strip_prefix(PREFIX).and_then(|text| STANDARD.decode(text).ok());
        let bytes = bytes.filter(|bytes| LENGTHS.contains(&bytes.len()));
        bytes.map(Self).ok_or_else(|| {
            format!(
                "must be {PREFIX} and {} to {} bytes in base64: {PREFIX}$(openssl rand -base64 \
                 32)",
                LENGTHS.start(),
                LENGTHS.end()
            )
        })
    }
}

impl fmt::Debug for WebhookSecret {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("whsec_...")
    }
}

/// Signs a message with each secret: while a secret is being replaced, some receivers still use
/// the old one.
pub(super) fn signatures(
    secrets: &[WebhookSecret],
    id: &str,
    timestamp: i64,
    body: &[u8],
) -> String {
    let sign = |secret: &WebhookSecret| {
        let mut mac = Hmac::<Sha256>::new_from_slice(&secret.0).ok()?;
        mac.update(format!("{id}.{timestamp}.").as_bytes());
        mac.update(body);
        Some(format!("v1,{}", STANDARD.encode(mac.finalize().into_bytes())))
    };
    secrets.iter().filter_map(sign).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECRET: &str = "whsec_MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw";

    /// The example of the libraries of Standard Webhooks.
    #[test]
    fn the_example_of_the_standard_is_signed_as_it_should_be() {
        let secret: WebhookSecret = SECRET.parse().unwrap();
        let sign = |secrets: &[WebhookSecret]| {
            signatures(
                secrets,
                "msg_p5jXN8AQM9LWM0D4loKWxJek",
                1_614_265_330,
                br#"{"test": 2432232314}"#,
            )
        };
        let expected = "v1,g0hM9SsE+OTPJTGt/tmIKtSyZlE3uFJELVlNIOLJ1OE=";
        assert_eq!(sign(std::slice::from_ref(&secret)), expected);
        assert_eq!(sign(&[secret.clone(), secret.clone()]), format!("{expected} {expected}"));
        assert_eq!(format!("{secret:?}"), "whsec_...");
    }

    #[test]
    fn a_secret_is_long_enough() {
        for text in
            ["", "secret", "whsec_", "whsec_AAAA", "whsec_!", "MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw"]
        {
            assert!(text.parse::<WebhookSecret>().is_err(), "{text}");
        }
    }
}
