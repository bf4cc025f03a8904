//! JSON whose numbers are all finite.
//!
//! `serde_json` writes NaN and infinities as `null`. The encoder therefore reads the JSON back and
//! compares it with the value.

use bytes::Bytes;
use serde::{Serialize, de::DeserializeOwned};
use thiserror::Error;

/// An error of the encoder.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum EncodeError {
    /// The JSON reads back as another value, as where a number is NaN or infinite.
    #[error("it does not read back as it was written: {0}")]
    Altered(String),
    /// The JSON cannot be compressed.
    #[error(transparent)]
    Deflate(#[from] super::DeflateError),
    /// The value has no JSON form.
    #[error("{0}")]
    Json(String),
}

/// Writes a value as JSON.
///
/// # Errors
/// [`EncodeError::Altered`] if any number in it is NaN or infinite.
pub fn encode<T: Serialize + DeserializeOwned + PartialEq>(
    value: &T,
) -> Result<Bytes, EncodeError> {
    let json = serde_json::to_vec(value).map_err(|error| EncodeError::Json(error.to_string()))?;
    match serde_json::from_slice::<T>(&json) {
        Ok(read) if read == *value => Ok(json.into()),
        Ok(_) => Err(EncodeError::Altered("a number is not finite".to_owned())),
        Err(error) => Err(EncodeError::Altered(error.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use serde::Deserialize;

    use super::*;

    #[derive(Serialize, Deserialize, PartialEq)]
    struct Figures {
        list: Vec<[f64; 2]>,
        perhaps: Option<f64>,
    }

    #[test]
    fn finite_numbers_pass_and_no_others() {
        let figures =
            |number, perhaps| encode(&Figures { list: vec![[1.0, 2.0], [0.1, number]], perhaps });
        assert_eq!(
            figures(3.0, None).unwrap(),
            r#"{"list":[[1.0,2.0],[0.1,3.0]],"perhaps":null}"#
        );
        for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(matches!(figures(number, None), Err(EncodeError::Altered(_))));
            assert!(matches!(figures(1.0, Some(number)), Err(EncodeError::Altered(_))));
        }
    }
}
