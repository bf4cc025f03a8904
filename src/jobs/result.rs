//! Stored results, in parts: no process has to hold a long sweep in memory.

use bytes::Bytes;

use super::{Deflated, EncodeError, encode};
use brinell_solver::report::{StepReport, encode_fields, encode_layers};

/// Where the steps of a report stand in its JSON, and its rows behind them.
const STEPS: &str = "\"steps\":[]";
const ROWS: &str = ",\"answers\":";

/// The result of one step.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StepResult {
    /// Its number, counted from 0. It replaces a stored step of the same number, and the steps
    /// behind that one are removed.
    pub number: usize,
    /// The step's report without its fields (JSON).
    pub report: Deflated,
    /// Its fields, as [`encode_fields`] writes them, in double precision.
    pub fields: Option<Bytes>,
}

impl StepResult {
    /// Splits a step's report from its fields.
    ///
    /// # Errors
    /// [`EncodeError`] if a number in it is NaN or infinite.
    pub fn encode(number: usize, mut report: StepReport) -> Result<Self, EncodeError> {
        let fields = take_fields(&mut report)?;
        let report = Deflated::compress(&encode(&report)?)?;
        Ok(Self { number, report, fields: fields.map(Bytes::from) })
    }

    /// Returns the stored parts of its fields, each with the offset of its first byte.
    pub fn parts(&self) -> impl Iterator<Item = (usize, &[u8])> {
        let fields = self.fields.as_deref().unwrap_or_default();
        (0..).step_by(FIELDS_PART).zip(fields.chunks(FIELDS_PART))
    }

    /// Returns the bytes that it takes in the store.
    pub fn bytes(&self) -> usize {
        self.report.packed().len() + self.fields.as_ref().map_or(0, Bytes::len)
    }
}

/// Takes the fields or layers out of the report of a step, as [`encode_fields`] writes them.
///
/// # Errors
/// [`EncodeError`] if a number in them is NaN or infinite.
pub fn take_fields(report: &mut StepReport) -> Result<Option<Vec<u8>>, EncodeError> {
    let fields = report.fields.take().map(|fields| encode_fields(&fields));
    let layers = || report.layers.take().map(|layers| encode_layers(&layers));
    fields.or_else(layers).transpose().map_err(|error| EncodeError::Altered(error.to_string()))
}

/// Size \[bytes\] of the stored parts of fields; the last part is shorter.
pub const FIELDS_PART: usize = 256 << 10;

/// A part of the fields of a step.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FieldsPart {
    /// Offset of its first byte within the fields of the step.
    pub first: usize,
    /// Its bytes.
    pub bytes: Bytes,
}

/// A result without its steps.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ResultHead {
    /// The report with an empty list of steps (JSON).
    pub report: Bytes,
    /// Number of steps that are stored apart.
    pub steps: usize,
    /// Whether the steps have fields.
    pub has_fields: bool,
    /// Number of the attempt that produced it.
    pub attempt: u32,
}

impl ResultHead {
    /// Returns whether the figures of the report are rows. Those of programs before 0.3.0 are not.
    pub fn has_rows(&self) -> bool {
        let around = self.around_steps();
        around.is_some_and(|(_, behind)| behind[1..].starts_with(ROWS.as_bytes()))
    }

    /// Returns the JSON before and behind the steps; `None` of the first version, whose reports
    /// contain their steps.
    pub fn around_steps(&self) -> Option<(Bytes, Bytes)> {
        // The JSON before the steps contains no text of a client that could be mistaken for the
        // marker.
        let text = std::str::from_utf8(&self.report).ok()?;
        let begin = text.find(STEPS)? + STEPS.len() - 1;
        Some((self.report.slice(..begin), self.report.slice(begin..)))
    }
}
