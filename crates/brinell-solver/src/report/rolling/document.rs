//! What a load that rolls adds to the JSON of a step.

use serde::{Deserialize, Serialize};
use strum::{IntoStaticStr, VariantArray};

use crate::job::Named;
use crate::report::{PerBody, Side};

/// The passes of a load that rolls and what becomes of the track. x points along the travel, and z
/// across it. Works are those per length of travel, of a line on unit thickness too: forces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = RollingResult))]
pub struct RollingReport {
    /// What becomes of the track, of both bodies the worse.
    pub verdict: TrackVerdict,
    /// The body of which it is said; `null` of both, and where neither can yield.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub body: Option<Side>,
    /// Plastic strain of a steady pass, or of a pair of passes there and back: net strain of a
    /// track that ratchets, accumulated strain of one that closes a cycle, 0 of one that shakes
    /// down; `null` where it is undecided. Where the first layer decides it is that of the surface,
    /// by √z from the first two layers \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub rate: Option<f64>,
    /// Estimated error of the rate by columns, and its change over three passes; of the surface at
    /// least the difference to the first layer \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub rate_error: Option<f64>,
    /// Depth of the rate, 0 at the surface; `null` where there is none \[length >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub rate_depth: Option<f64>,
    /// The verdicts by each rule of hardening that was solved. `verdict` is the worst of them.
    #[serde(default)]
    pub rules: Vec<RuleVerdict>,
    /// Why the verdict is open or the passes end; `null` otherwise.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub reason: Option<String>,
    /// Traction over pressure in the whole contact, positive along the travel on the lower body
    /// \[1\].
    #[serde(default)]
    pub friction: f64,
    /// The passes that have converged.
    pub passes: Vec<PassReport>,
    /// Elastic peak pressures up to which the track shakes down under this friction.
    pub limits: TrackLimitsReport,
    /// Columns of the track.
    pub columns: usize,
    /// Layers of each body.
    pub layers: usize,
    /// Rows of cells in a layer on one side of the axis of the track, over which all fields are
    /// symmetric; 1 of a line.
    pub rows: usize,
}

/// The verdict on a track by one rule of hardening.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RuleVerdict {
    /// The rule.
    pub hardening: SolvedHardening,
    /// What becomes of the track, of both bodies the worse.
    pub verdict: TrackVerdict,
    /// As `rate` of the track \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub rate: Option<f64>,
    /// As `rate_error` of the track \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub rate_error: Option<f64>,
    /// Passes that have converged.
    pub passes: usize,
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

/// One pass of the load.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Pass))]
pub struct PassReport {
    /// Number of the pass, from 1.
    pub number: usize,
    /// Iterations made.
    pub iterations: usize,
    /// Peak pressure \[stress >= 0\].
    pub peak_pressure: f64,
    /// Half-width of the contact along the travel \[length >= 0\].
    pub half_width: f64,
    /// Half-width of the contact across the travel; `null` of a line \[length >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub half_width_across: Option<f64>,
    /// Approach of the bodies; `null` of a line, which has none \[length\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub approach: Option<f64>,
    /// Force against which the load is pushed, without friction \[force\].
    pub rolling_force: f64,
    /// The same over the load: the coefficient of rolling resistance \[1\].
    pub loss: f64,
    /// Work of plastic flow in both bodies \[force >= 0\].
    pub plastic_work: f64,
    /// Change of the elastic energy of the residual stress \[force\].
    pub stored_energy: f64,
    /// Work of the friction on the plastic displacement of the surfaces \[force\].
    pub traction_work: f64,
    /// What is missing in the balance of these works over the plastic work; 0 without one
    /// \[1 >= 0\].
    pub energy_gap: f64,
    /// What the pass leaves in each body; `null` of one that cannot yield.
    pub bodies: PerBody<Option<BodyPassReport>>,
    /// Estimated relative errors by columns and length of the track; `null` where the pass on half
    /// the columns has no answer.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub estimated_error: Option<PassErrorReport>,
}

/// What a pass leaves in a body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = BodyPass))]
pub struct BodyPassReport {
    /// How far the surface has sunk in all passes, on the axis of the track \[length\].
    pub groove_depth: f64,
    /// How far it has risen beside the groove; 0 of a line \[length >= 0\].
    pub pile_up: f64,
    /// How far this pass has moved the surface along the travel, against the depth \[length\].
    pub forward: f64,
    /// Largest plastic strain that the pass has accumulated \[1 >= 0\].
    pub largest_strain: f64,
    /// Its depth \[length >= 0\].
    pub largest_strain_depth: f64,
    /// Its distance from the axis of the track; 0 of a line \[length >= 0\].
    pub largest_strain_across: f64,
    /// Largest change of the plastic strain by the pass, as an equivalent strain: what a cycle
    /// that closes takes back is not in it \[1 >= 0\].
    pub net_strain: f64,
    /// Its depth \[length >= 0\].
    pub net_strain_depth: f64,
    /// Its distance from the axis of the track; 0 of a line \[length >= 0\].
    pub net_strain_across: f64,
    /// Largest plastic strain that all passes so far have accumulated \[1 >= 0\].
    pub accumulated_strain: f64,
    /// Least residual stress along the travel \[stress\].
    pub least_sigma_x: f64,
    /// Largest residual stress along the travel \[stress\].
    pub largest_sigma_x: f64,
    /// Least residual stress across the travel \[stress\].
    pub least_sigma_z: f64,
    /// Largest residual stress across the travel \[stress\].
    pub largest_sigma_z: f64,
}

impl BodyPassReport {
    /// Returns the largest of the residual stresses, to which their error is relative.
    pub(super) fn largest_residual(&self) -> f64 {
        let along = self.least_sigma_x.abs().max(self.largest_sigma_x.abs());
        along.max(self.least_sigma_z.abs()).max(self.largest_sigma_z.abs())
    }
}

/// Estimated relative errors of a pass; `null` of a figure that is 0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = PassErrors))]
pub struct PassErrorReport {
    /// Of the peak pressure \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub peak_pressure: Option<f64>,
    /// Of the half-width \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub half_width: Option<f64>,
    /// Of the approach; `null` of a line \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub approach: Option<f64>,
    /// Of the plastic work, and of rolling force and loss \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub plastic_work: Option<f64>,
    /// Of the figures of each body.
    pub bodies: PerBody<Option<BodyPassErrorReport>>,
}

/// Estimated relative errors of what a pass leaves in a body; `null` of a figure that is 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = BodyPassErrors))]
pub struct BodyPassErrorReport {
    /// Of the depth of the groove \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub groove_depth: Option<f64>,
    /// Of the pile-up beside the groove \[1 >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub pile_up: Option<f64>,
    /// Of the forward displacement \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub forward: Option<f64>,
    /// Of the largest accumulated plastic strain \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub largest_strain: Option<f64>,
    /// Of the largest net strain \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub net_strain: Option<f64>,
    /// Of the residual stresses, relative to the largest of them \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub residual: Option<f64>,
}

/// Elastic peak pressures up to which a track shakes down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = TrackLimits))]
pub struct TrackLimitsReport {
    /// Of perfectly plastic bodies, in closed form; `null` where no body yields, of a curve without a
    /// yield point, and of an ellipse that slides or is longer along the travel than across it.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub perfect: Option<TrackLimitReport>,
    /// Of bodies with kinematic hardening without bound, on these layers; `null` of an ellipse.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub kinematic: Option<TrackLimitReport>,
    /// Yield stress in shear, of both bodies the lower, where strength does not vary; `null` where
    /// none yields \[stress >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub shear_yield_stress: Option<f64>,
    /// Limits over friction, for strength and initial stress at the depths of this contact; empty
    /// where no body has a yield point.
    #[serde(default)]
    pub over_friction: Vec<FrictionLimits>,
}

/// Elastic peak pressures that a track bears under a friction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct FrictionLimits {
    /// Traction over pressure in the whole contact \[1 >= 0\].
    pub friction: f64,
    /// Hertz's peak pressure up to which nothing yields \[stress >= 0\].
    pub elastic_pressure: f64,
    /// The same up to which perfectly plastic bodies shake down; `null` of an
    /// ellipse that slides \[stress >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub perfect_pressure: Option<f64>,
    /// The same up to which bodies with kinematic hardening without bound shake down
    /// \[stress >= 0\].
    pub kinematic_pressure: f64,
}

/// A limit of shakedown.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = TrackLimit))]
pub struct TrackLimitReport {
    /// Hertz's peak pressure \[stress >= 0\].
    pub peak_pressure: f64,
    /// Depth that decides, 0 where the surface does \[length >= 0\].
    pub depth: f64,
    /// The body that decides.
    pub body: Side,
}

/// Elastic peak pressure up to which a line contact shakes down under a friction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ShakedownLimit {
    /// Traction over pressure in the whole contact \[1 >= 0\].
    pub friction: f64,
    /// Hertz's peak pressure \[stress >= 0\].
    pub pressure: f64,
    /// Depth that decides, 0 where the surface does \[length >= 0\].
    pub depth: f64,
}
