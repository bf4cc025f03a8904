//! What a job that asks for an input or has tolerances is answered beside its steps.

use serde::{Deserialize, Serialize};

use crate::report::AnswerBody;

/// The input with which a figure is as wanted: the row `input_found` of `answers`. The steps are
/// those of the job with it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Found))]
pub struct FoundReport {
    /// JSON pointers of the numbers that were varied.
    pub vary: Vec<String>,
    /// Name of the figure.
    pub figure: String,
    /// Values between the ends with which it is as wanted, that of this result first. Unit: that of
    /// `input_found`.
    pub values: Vec<f64>,
    /// The jobs that were solved, in the order of their values.
    pub looks: Looks,
    /// The answer in one sentence.
    pub text: String,
}

/// Solved values of an input, the figure under each, and its relative error.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Looks {
    /// Values of the input.
    pub value: Vec<f64>,
    /// The figure.
    pub figure: Vec<f64>,
    /// Bound of its relative error; `null` without one \[1 >= 0\].
    pub error: Vec<Option<f64>>,
}

/// What tolerances of inputs do to the rows of the result that have a value: a list with one entry
/// for each row.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Tolerances))]
pub struct TolerancesReport {
    /// JSON pointers of the inputs.
    pub inputs: Vec<String>,
    /// Their relative tolerances, to either side \[1 >= 0\].
    pub relative: Vec<f64>,
    /// Names of the rows.
    pub name: Vec<String>,
    /// Their names for a person.
    pub label: Vec<String>,
    /// Their bodies.
    pub body: Vec<Option<AnswerBody>>,
    /// Bounds of their relative errors by mesh and increments; `null` without one \[1 >= 0\].
    pub error: Vec<Option<f64>>,
    /// Relative change of the figure over that of each input; `null` where the figure is not known
    /// beside it \[1\].
    pub elasticities: Vec<Vec<Option<f64>>>,
    /// Relative change where all tolerances add up, each in the sense that changes it more; `null`
    /// where the figure is not known beside it \[1 >= 0\].
    pub at_worst: Vec<Option<f64>>,
    /// Root of the sum of the squares of their changes \[1 >= 0\].
    pub root_of_squares: Vec<Option<f64>>,
    /// Which input matters most, in one sentence.
    pub text: String,
}
