//! The row of a figure.

use serde::{Deserialize, Serialize};

use crate::job::{BarKind, Name, Named as _, Quantity, Side};
use crate::report::{FatigueCriterion, SolvedHardening};

/// One figure, made to be shown.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Answer {
    /// Stable identifier, such as `peak_pressure`. Name, `body` and `at` identify a row.
    pub name: String,
    /// Name for a person.
    pub label: String,
    /// Whose figure it is: `upper`, `lower` or, of bodies that are alike, `both`; `null` of the
    /// contact.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub body: Option<AnswerBody>,
    /// Of which pass, rule of hardening, criterion or load it is; absent of the step as it ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<AnswerAt>,
    /// The figure in `unit`; `null` where it is not known, and `reason` says why.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub value: Option<f64>,
    /// Its physical quantity. A `strain` and a `ratio` are shown in per cent.
    pub quantity: Quantity,
    /// Symbol of its unit in the units of the job; empty of a strain, a ratio and a number.
    pub unit: String,
    /// Estimated bound of its relative error by mesh and increments, or a word.
    pub error: ErrorBar,
    /// Why the error is not bounded; absent beside any other error.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// What a figure without a bound of its error is at least. Unit: `unit`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_least: Option<f64>,
    /// What a figure without a bound of its error is at most, one below zero by its size. Unit:
    /// `unit`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_most: Option<f64>,
    /// The figure by Hertz's elastic theory, where that has one.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub elastic: Option<f64>,
    /// Where it is; `null` of a figure without a place.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub place: Option<AnswerPlace>,
    /// A note for a person: over which points a maximum was taken, or against what the figure
    /// counts.
    pub text: String,
    /// Whether it stands behind the figures that answer the job.
    pub detail: bool,
}

/// The bound of a relative error, or one word.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(untagged)]
pub enum ErrorBar {
    /// Bound of the relative error \[1 >= 0\].
    Relative(f64),
    /// What stands in place of a bound.
    Word(ErrorWord),
}

/// What stands in place of the bound of an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
pub enum ErrorWord {
    /// The job asked for the figure, which it has to rounding.
    Given,
    /// The figure is a closed form of the job's own data.
    Exact,
    /// Nothing bounds the error, for the `reason` of the row.
    NotBounded,
}

impl ErrorBar {
    /// Returns the bound, 0 of a figure that is given or exact, `None` without one.
    pub const fn bound(self) -> Option<f64> {
        match self {
            Self::Relative(error) => Some(error),
            Self::Word(ErrorWord::Given | ErrorWord::Exact) => Some(0.0),
            Self::Word(ErrorWord::NotBounded) => None,
        }
    }
}

/// Whose figure an answer is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
pub enum AnswerBody {
    /// The upper body.
    Upper,
    /// The lower body.
    Lower,
    /// Both bodies, which are alike.
    Both,
}

impl From<Side> for AnswerBody {
    fn from(side: Side) -> Self {
        match side {
            Side::Upper => Self::Upper,
            Side::Lower => Self::Lower,
        }
    }
}

/// Of which part of the step, or of which load of the job, a row is.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct AnswerAt {
    /// The pass of a load that rolls, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pass: Option<usize>,
    /// The rule of hardening, where two were solved.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hardening: Option<SolvedHardening>,
    /// The criterion of fatigue.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub criterion: Option<FatigueCriterion>,
    /// The load, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<usize>,
}

/// The place of a figure, in the coordinates of the arrays of its step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct AnswerPlace {
    /// In which body.
    pub body: AnswerBody,
    /// x, or the radius \[length\].
    pub x: f64,
    /// y; only in three dimensions \[length\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub y: Option<f64>,
    /// Depth below the surface \[length\].
    pub depth: f64,
}

/// The bar of a figure, with the reason for none.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::report) enum Bar {
    /// A bound of the relative error.
    Relative(f64),
    /// The job asked for the figure.
    Given,
    /// A closed form.
    Exact,
    /// None, and why.
    None(String),
}

impl Bar {
    /// Returns no bar, for a reason.
    pub fn none(reason: impl Into<String>) -> Self {
        Self::None(reason.into())
    }
}

/// Why a figure of a mesh has no bar.
pub(super) const NO_ESTIMATE: &str = "no estimate is made of it";

impl Answer {
    /// Returns a row with the bar that its name has by itself.
    pub(in crate::report) fn new(
        name: Name,
        quantity: Quantity,
        unit: &str,
        value: Option<f64>,
    ) -> Self {
        let row = Self {
            name: name.name().to_owned(),
            label: name.label().to_owned(),
            body: None,
            at: None,
            value: value.filter(|value| value.is_finite()),
            quantity,
            unit: unit.to_owned(),
            error: ErrorBar::Word(ErrorWord::NotBounded),
            reason: None,
            at_least: None,
            at_most: None,
            elastic: None,
            place: None,
            text: String::new(),
            detail: false,
        };
        match name.bar() {
            BarKind::Exact => row.bar(Bar::Exact),
            BarKind::Mesh | BarKind::MeshOrExact => {
                row.bar(Bar::none("two meshes do not bound it"))
            }
            BarKind::None => row.bar(Bar::none(NO_ESTIMATE)),
        }
    }

    pub(in crate::report) fn bar(self, bar: Bar) -> Self {
        let (error, reason) = match bar {
            Bar::Relative(error) => (ErrorBar::Relative(error), None),
            Bar::Given => (ErrorBar::Word(ErrorWord::Given), None),
            Bar::Exact => (ErrorBar::Word(ErrorWord::Exact), None),
            Bar::None(reason) => (ErrorBar::Word(ErrorWord::NotBounded), Some(reason)),
        };
        Self { error, reason, ..self }
    }

    pub(in crate::report) fn elastic(self, elastic: Option<f64>) -> Self {
        Self { elastic, ..self }
    }

    pub(in crate::report) fn place(self, place: Option<AnswerPlace>) -> Self {
        Self { place, ..self }
    }

    pub(in crate::report) fn labelled(self, label: &str) -> Self {
        Self { label: label.to_owned(), ..self }
    }

    pub(in crate::report) fn at(self, at: AnswerAt) -> Self {
        Self { at: Some(at), ..self }
    }

    pub(in crate::report) fn of(self, body: AnswerBody) -> Self {
        let label = match body {
            AnswerBody::Upper => format!("{}, upper", self.label),
            AnswerBody::Lower => format!("{}, lower", self.label),
            AnswerBody::Both => self.label,
        };
        Self { body: Some(body), label, ..self }
    }

    pub(in crate::report) fn text(self, text: impl Into<String>) -> Self {
        Self { text: text.into(), ..self }
    }

    /// Puts the row behind those that answer the job.
    pub(in crate::report) fn detail(self) -> Self {
        Self { detail: true, ..self }
    }

    /// A width of 0 of bodies that touch is not known, nor is the mean pressure over it.
    pub(super) fn of_width(self, touches: bool) -> Self {
        let is_unknown = touches && self.value == Some(0.0);
        let unknown = "narrower than an element";
        if is_unknown { self.not_known(unknown) } else { self }
    }

    /// Takes value and bar, for a reason.
    pub(in crate::report) fn not_known(self, reason: &str) -> Self {
        let row = Self { value: None, elastic: None, place: None, ..self };
        Self { at_least: None, at_most: None, ..row }.bar(Bar::none(reason)).text("")
    }

    /// Returns whether the row is that of a body, or of both.
    pub fn is_of(&self, side: Side) -> bool {
        [Some(AnswerBody::from(side)), Some(AnswerBody::Both)].contains(&self.body)
    }

    /// Returns whether both are rows of one figure.
    pub fn is_alike(&self, other: &Self) -> bool {
        (&self.name, self.body, self.at) == (&other.name, other.body, other.at)
    }

    /// Returns whether the row has this name.
    pub fn is(&self, name: Name) -> bool {
        self.name == name.name()
    }
}
