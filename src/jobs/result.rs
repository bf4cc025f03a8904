//! A result as it is kept: in parts, so that nobody has to hold a long sweep in memory.

use bytes::Bytes;

use super::{Deflated, EncodeError, encode};
use brinell_solver::report::{StepReport, encode_fields, encode_layers};

/// Where the steps of a report stand in its JSON.
const STEPS: &str = "\"steps\":[]";

/// The result of one step.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StepResult {
    /// Its number from 0 on. A step takes the place of one of its number, and those behind that
    /// one are given up.
    pub number: usize,
    /// The step's report without its fields (JSON).
    pub report: Deflated,
    /// Its fields, as [`encode_fields`] writes them, in double precision.
    pub fields: Option<Bytes>,
}

impl StepResult {
    /// Takes a step's report apart.
    ///
    /// # Errors
    /// [`EncodeError`] if a number in it is NaN or infinite.
    pub fn encode(number: usize, mut report: StepReport) -> Result<Self, EncodeError> {
        let fields = report.fields.take().map(|fields| encode_fields(&fields));
        let layers = || report.layers.take().map(|layers| encode_layers(&layers));
        let fields = fields
            .or_else(layers)
            .transpose()
            .map_err(|error| EncodeError::Altered(error.to_string()))?;
        let report = Deflated::compress(&encode(&report)?)?;
        Ok(Self { number, report, fields: fields.map(Bytes::from) })
    }

    /// Bytes it takes in the store.
    pub fn bytes(&self) -> usize {
        self.report.packed_len() + self.fields.as_ref().map_or(0, Bytes::len)
    }
}

/// Size \[bytes\] of the parts that fields are kept in; the last one is shorter.
pub const FIELDS_PART: usize = 256 << 10;

/// Part of the fields of a step.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FieldsPart {
    /// Where it begins in the bytes of the step.
    pub first: usize,
    /// What stands there.
    pub bytes: Bytes,
}

/// Everything in a result but its steps.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ResultHead {
    /// The report with an empty list of steps (JSON); of jobs of the first version, the whole
    /// report.
    pub report: Bytes,
    /// Steps that are kept apart.
    pub steps: usize,
    /// Whether the steps have fields.
    pub has_fields: bool,
    /// The attempt that it came of.
    pub attempt: u32,
}

impl ResultHead {
    /// The JSON before and behind the steps; `None` of a report of the first version, which has
    /// its steps in it.
    pub fn around_steps(&self) -> Option<(Bytes, Bytes)> {
        // Before the steps stand a few words of the service's own: no text of a client can be
        // mistaken for them.
        let text = std::str::from_utf8(&self.report).ok()?;
        let begin = text.find(STEPS)? + STEPS.len() - 1;
        Some((self.report.slice(..begin), self.report.slice(begin..)))
    }
}
