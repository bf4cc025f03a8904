//! Numbers that carry their range in their type. None of them can hold a NaN or an infinity.

use std::ops::RangeInclusive;

use serde::Serialize;
use thiserror::Error;

/// The reason why a number was refused. The message completes the sentence "the value …".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct OutOfRange(pub &'static str);

macro_rules! ranged {
    ($(#[$doc:meta])* $name:ident, $test:expr, $message:literal) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize)]
        #[serde(transparent)]
        pub struct $name(f64);

        impl $name {
            /// Returns the number if it lies in the range of this type.
            ///
            /// # Errors
            /// [`OutOfRange`] with the range in words.
            pub fn new(value: f64) -> Result<Self, OutOfRange> {
                let in_range: fn(f64) -> bool = $test;
                if value.is_finite() && in_range(value) { Ok(Self(value)) } else { Err(OutOfRange($message)) }
            }

            /// Returns the number.
            pub const fn get(self) -> f64 {
                self.0
            }
        }

        impl TryFrom<f64> for $name {
            type Error = OutOfRange;
            fn try_from(value: f64) -> Result<Self, OutOfRange> {
                Self::new(value)
            }
        }

        impl From<$name> for f64 {
            fn from(value: $name) -> Self {
                value.0
            }
        }
    };
}

ranged!(
    /// A finite number above zero.
    PositiveF64,
    |value| value > 0.0,
    "must be a finite number greater than 0"
);
impl PositiveF64 {
    /// One millionth.
    pub(super) const MICRO: Self = Self(1e-6);
}

ranged!(
    /// A finite number, zero or above.
    NonNegativeF64,
    |value| value >= 0.0,
    "must be a finite number, 0 or greater"
);
ranged!(
    /// Poisson's ratio ν, `0 <= ν <= 0.499999`.
    ///
    /// The bulk modulus grows without bound towards 0.5; from 0.4999999 on, rounding errors keep
    /// iterations from their tolerance. B-bar elements do not lock. Auxetic materials (`ν < 0`)
    /// are not offered, because no table of yield onset covers them.
    PoissonRatio,
    |value| PoissonRatio::RANGE.contains(&value),
    "must be between 0 and 0.499999"
);

impl PoissonRatio {
    /// The range of valid values.
    pub const RANGE: RangeInclusive<f64> = 0.0..=0.499_999;
}
