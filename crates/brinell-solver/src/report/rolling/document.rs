//! What a load that rolls adds to the JSON of a step.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use strum::{IntoStaticStr, VariantArray};

use crate::job::Named;

/// The passes that have converged, one entry for each in every list; their figures under the names
/// of rows.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Passes))]
pub struct PassesReport {
    /// Number of the pass, from 1.
    pub number: Vec<usize>,
    /// Iterations made.
    pub iterations: Vec<usize>,
    /// Figures of the contact and of both bodies.
    pub contact: BTreeMap<String, Course>,
    /// What each pass leaves in the upper body; empty of one that cannot yield.
    pub upper: BTreeMap<String, Course>,
    /// What each pass leaves in the lower body; empty of one that cannot yield.
    pub lower: BTreeMap<String, Course>,
}

/// A figure of all passes.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Course {
    /// Its values, in the unit of the row.
    pub value: Vec<f64>,
    /// Bounds of their relative errors by columns and length of the track; `null` where the pass on
    /// half the columns has no answer, and of a figure that is 0 \[1 >= 0\].
    pub error: Vec<Option<f64>>,
}

/// The verdict on a track by one rule of hardening; its figures are the rows `strain_per_pass`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RuleVerdict {
    /// The rule.
    pub hardening: SolvedHardening,
    /// What becomes of the track, of both bodies the worse.
    pub verdict: TrackVerdict,
    /// Why the verdict is open or the passes end; `null` otherwise.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub reason: Option<String>,
}

/// A rule of hardening that was solved.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, IntoStaticStr, VariantArray,
)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum SolvedHardening {
    /// That of the job: a backstress, no hardening, or a curve without a yield point.
    Given,
    /// Isotropic.
    Isotropic,
    /// Kinematic, with the same uniaxial curve.
    Kinematic,
}

impl Named for SolvedHardening {}

/// What becomes of a track.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    IntoStaticStr,
    VariantArray,
)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum TrackVerdict {
    /// Nothing yields.
    Elastic,
    /// Plastic flow ends.
    ShakesDown,
    /// The material flows in every pass and returns to where it was: plastic shakedown.
    ClosedCycle,
    /// The passes do not tell.
    Undecided,
    /// Every pass adds a plastic strain.
    Ratchets,
}

impl Named for TrackVerdict {}

/// Hertz's peak pressures that a contact bears over the friction, of both bodies the lower.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ShakedownMap {
    /// Traction over pressure in the whole contact \[1\].
    pub friction: Vec<f64>,
    /// Up to which nothing yields; empty of a load that does not roll \[stress\].
    pub elastic: Vec<f64>,
    /// Up to which perfectly plastic bodies shake down; `null` of an ellipse that slides
    /// \[stress\].
    pub perfect: Vec<Option<f64>>,
    /// Up to which bodies with kinematic hardening without bound shake down; empty of a load that
    /// does not roll \[stress\].
    pub kinematic: Vec<f64>,
    /// Depth that decides on `perfect`; empty of a load that rolls \[length\].
    pub perfect_depth: Vec<f64>,
}
