//! What counts as rounding.

/// Relative difference of two lengths that counts as rounding, so that the numbers of rows and
/// columns do not depend on units.
pub const ROUNDING: f64 = 1e-9;
