//! The fields of the report in the JSON of a result.
//!
//! Lengths, forces and stresses are in the job's own units. `x` is tangential, `y` normal to the
//! contact and `z` out of the plane; stresses are tensile positive, pressures compressive
//! positive.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{
    Answer, ContactReport, ErrorEstimate, FieldsReport, FlowReport, HardnessReport, LayersReport,
    LoadApproach, RollingReport, ShakedownLimit, TargetReport, ThreeDimensionalReport,
    ValidityNote, Verdict, YieldOnsetReport,
};
use crate::solver::{IterationRecord, SolveStatus};

/// The answer to a job.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Report {
    /// `mm_N_MPa` or `SI`.
    pub units: String,
    /// `plane_strain`, `plane_stress`, `axisymmetric` or `three_dimensional`.
    pub analysis: String,
    /// Theory of plasticity, `flow` or `deformation`; `null` where no body can yield.
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub theory: Option<String>,
    /// The least good status of all steps.
    pub status: SolveStatus,
    /// One entry for each load.
    pub steps: Vec<StepReport>,
    /// The figures that follow from more than one load: of a hardness test, and the sensitivity of
    /// a target.
    #[serde(default)]
    pub answers: Vec<Answer>,
    /// The load–approach curve of a sweep.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_approach: Option<LoadApproach>,
    /// The force that was asked for by what it does; only of a job with `load.target`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub target: Option<TargetReport>,
    /// The hardness that a test finds; only of a job with `load.hardness`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hardness: Option<HardnessReport>,
    /// The mesh of the last step.
    pub mesh: MeshReport,
    /// Where the time went.
    pub timings_ms: Timings,
    /// Labels of the job.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub tags: BTreeMap<String, String>,
    /// Version of the program.
    pub version: String,
}

/// One load step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Step))]
pub struct StepReport {
    /// What was prescribed.
    pub load: LoadReport,
    /// How this step ended.
    pub status: SolveStatus,
    /// The state of the bodies in one sentence; absent of results of 0.2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub verdict: Option<Verdict>,
    /// The figures that answer the job, in the order in which it asks for them; empty of results
    /// of 0.2 and of a step that was stopped.
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub answers: Vec<Answer>,
    /// Approach α of the supports; `null` of a line contact that rolls, which has none
    /// \[length\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub approach: Option<f64>,
    /// Between which two boundaries α is counted.
    pub approach_datum: String,
    /// Contact pressure and its resultants.
    pub contact: ContactReport,
    /// Contact stiffness dP/dα: the slope of the load-approach curve at this load, with the
    /// plastic flow that it brings; 0 where nothing touches. `null` where bodies yield as the load
    /// rises and `output.contact_stiffness` does not ask for it, where the answer did not
    /// converge, and where bodies flow at a constant stress in plane stress \[stiffness\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub contact_stiffness: Option<f64>,
    /// What only flow theory knows: increments, dents, energies; absent under deformation theory.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flow: Option<FlowReport>,
    /// Stresses over depth on the axis, or below the middle of the contact where there is none; of
    /// a load that rolls what its last pass has left, the same all along the track. Absent when
    /// not asked for, and where the step was stopped.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub subsurface: Option<PerBody<Option<SubsurfaceReport>>>,
    /// The same below the largest pressure; absent where that is in the middle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub subsurface_below_peak: Option<PerBody<Option<SubsurfaceReport>>>,
    /// Plastic zone of each body; `null` for a rigid one.
    pub plasticity: PerBody<Option<PlasticityReport>>,
    /// The closed-form elastic contact of the same bodies, where there is one.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub hertz: Option<HertzReport>,
    /// The onset of yield, of a job with `"load": {"onset": true}`; `null` of other jobs, and
    /// where the remark `onset_unknown` says why.
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub yield_onset: Option<YieldOnsetReport>,
    /// What to keep in mind about this answer.
    pub validity: Vec<ValidityNote>,
    /// Estimated relative discretization errors, where two meshes allow them.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub estimated_error: Option<ErrorEstimate>,
    /// Mesh and nodal fields; absent unless asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fields: Option<PerBody<Option<FieldsReport>>>,
    /// Stresses and plastic strain in the layers of half-spaces in three dimensions, which have no
    /// mesh; absent unless `output.fields` asks for them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layers: Option<PerBody<Option<LayersReport>>>,
    /// What only a contact in three dimensions has; absent in other analyses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub three_dimensional: Option<ThreeDimensionalReport>,
    /// Passes of a load that rolls, and what becomes of the track; absent of all other loads.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rolling: Option<RollingReport>,
    /// Every outer iteration.
    pub history: Vec<IterationRecord>,
}

impl StepReport {
    /// Returns the profiles over depth, if the job asks for them: of the upper and the lower body,
    /// below the middle and below the peak pressure.
    pub fn profiles(&self) -> impl Iterator<Item = (&'static str, &SubsurfaceReport)> {
        let lines = [&self.subsurface, &self.subsurface_below_peak].into_iter().flatten();
        lines.flat_map(|bodies| {
            let bodies = [("upper", &bodies.upper), ("lower", &bodies.lower)];
            bodies.into_iter().filter_map(|(name, body)| Some((name, body.as_ref()?)))
        })
    }

    /// Returns the largest equivalent plastic strain of both bodies, of a load that rolls that of
    /// all passes, or `None` if the strain of a body has no limit on finer meshes.
    pub fn max_plastic_strain(&self) -> Option<f64> {
        if let Some(rolling) = &self.rolling {
            let last = rolling.passes.last();
            let bodies =
                last.into_iter().flat_map(|last| [&last.bodies.upper, &last.bodies.lower]);
            let strains = bodies.flatten().map(|body| body.accumulated_strain);
            return Some(strains.fold(0.0, f64::max));
        }
        let zones = [&self.plasticity.upper, &self.plasticity.lower].into_iter().flatten();
        zones
            .map(|zone| zone.max_equivalent_plastic_strain)
            .try_fold(0.0, |most, strain| Some(f64::max(most, strain?)))
    }

    /// Returns x of a profile \[length\].
    pub fn place_of(&self, profile: &SubsurfaceReport) -> f64 {
        profile.position.unwrap_or(self.contact.peak_position)
    }
}

/// What a step prescribed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
pub enum LoadReport {
    /// Total force \[force >= 0\].
    Force(f64),
    /// Approach \[length\].
    Approach(f64),
}

/// One value for each body.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct PerBody<T> {
    /// Of the upper body.
    pub upper: T,
    /// Of the lower body.
    pub lower: T,
}

impl<T: Clone> PerBody<Option<T>> {
    /// Applies a function to each deformable body and its side. Bodies that share one solution
    /// share the result.
    pub(super) fn of<B>(bodies: &[Option<Arc<B>>; 2], say: impl Fn(&B, usize) -> T) -> Self {
        let said: Result<Self, Infallible> =
            Self::try_of(bodies, |body, side| Ok(say(body, side)));
        match said {
            Ok(said) => said,
        }
    }

    /// Applies a function to each deformable body, as [`Self::of`], until it returns an error.
    pub(super) fn try_of<B, E>(
        bodies: &[Option<Arc<B>>; 2],
        mut say: impl FnMut(&B, usize) -> Result<T, E>,
    ) -> Result<Self, E> {
        let [upper, lower] = bodies;
        let mut of = |body: &Option<Arc<B>>, side: usize| {
            body.as_ref().map(|body| say(body, side)).transpose()
        };
        let of_upper = of(upper, 0)?;
        let of_lower = match (upper, lower) {
            (Some(upper), Some(lower)) if Arc::ptr_eq(upper, lower) => of_upper.clone(),
            _ => of(lower, 1)?,
        };
        Ok(Self { upper: of_upper, lower: of_lower })
    }
}

/// Stresses along a normal of the surface.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Subsurface))]
pub struct SubsurfaceReport {
    /// x of the normal, along the arc for a pin in a hole. Results of 0.2 do not have it: their
    /// normal is at `contact.peak_position` \[length\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<f64>,
    /// Depth below the surface, from 0 \[length\].
    pub depth: Vec<f64>,
    /// Tangential stress; radial in axisymmetry \[stress\].
    pub sigma_x: Vec<f64>,
    /// Normal stress; axial in axisymmetry \[stress\].
    pub sigma_y: Vec<f64>,
    /// Out-of-plane stress; hoop stress in axisymmetry \[stress\].
    pub sigma_z: Vec<f64>,
    /// Largest shear stress, half the difference of the extreme principal stresses \[stress\].
    pub tau_max: Vec<f64>,
    /// Von Mises stress \[stress\].
    pub von_mises: Vec<f64>,
    /// Equivalent plastic strain \[1\].
    pub equivalent_plastic_strain: Vec<f64>,
    /// Yield stress; only where it varies with the depth \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_stress: Option<Vec<f64>>,
    /// Von Mises stress over that yield stress \[1\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilization: Option<Vec<f64>>,
    /// Tangential stress before the load, what is left of an initial stress after the body has
    /// relaxed; a part of `sigma_x` \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub initial_sigma_x: Option<Vec<f64>>,
    /// Normal stress before the load \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub initial_sigma_y: Option<Vec<f64>>,
    /// Out-of-plane stress before the load \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub initial_sigma_z: Option<Vec<f64>>,
    /// y of the normal; of this and the following only in three dimensions, where `sigma_x` is
    /// `sigma_xx`, the normal stress `sigma_y` is `sigma_zz`, and `sigma_z` is `sigma_yy`
    /// \[length\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position_y: Option<f64>,
    /// Stress along x, the shorter semi-axis of the contact \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma_xx: Option<Vec<f64>>,
    /// Stress along y, the longer semi-axis \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma_yy: Option<Vec<f64>>,
    /// Stress along z, the normal into the body \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma_zz: Option<Vec<f64>>,
    /// Shear stress between x and y \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma_xy: Option<Vec<f64>>,
    /// Shear stress between x and z \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma_xz: Option<Vec<f64>>,
    /// Shear stress between y and z \[stress\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma_yz: Option<Vec<f64>>,
}

/// Extent of plastic flow in one body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = PlasticZone))]
pub struct PlasticityReport {
    /// Whether any Gauss point is beyond yield.
    pub yielded: bool,
    /// Largest equivalent plastic strain at a Gauss point; `null` of a material that does not
    /// harden, where it has no limit on smaller and smaller elements \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub max_equivalent_plastic_strain: Option<f64>,
    /// Mean equivalent plastic strain over the area of the section that has yielded \[1
    /// >= 0\].
    #[serde(default)]
    pub mean_equivalent_plastic_strain: f64,
    /// x of that point \[length\].
    pub position: f64,
    /// Depth of that point \[length\].
    pub depth: f64,
    /// Area of the plastic zone in the section x–y, both sides of the axis; summed over the Gauss
    /// points \[area >= 0\].
    pub area: f64,
    /// Whether the plastic zone includes a part of the free surface.
    pub reached_surface: bool,
    /// Outline of the plastic zone: closed polygons of points `[x, depth]`, the first one not
    /// repeated, both sides of the axis. Depth is counted downward from the plane in which the
    /// bodies first touch, into the material of either body. Counter-clockwise in the axes `(x,
    /// depth)`; holes clockwise \[length\].
    pub outline: Vec<Vec<[f64; 2]>>,
    /// y of the point with the largest plastic strain; of this and the next only in three
    /// dimensions, where there is no outline and `area` is that of the cells beside y = 0
    /// \[length\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position_y: Option<f64>,
    /// Volume of the cells that have yielded \[volume >= 0\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume: Option<f64>,
}

/// Hertz's elastic contact under the same force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Hertz))]
pub struct HertzReport {
    /// Half-width a \[length >= 0\].
    pub half_width: f64,
    /// Peak pressure \[stress >= 0\].
    pub peak_pressure: f64,
    /// Force at which the first body begins to yield; `null` if none can \[force >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub yield_onset_force: Option<f64>,
    /// Depth at which it does \[length >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub yield_onset_depth: Option<f64>,
    /// Elastic peak pressure up to which the contact shakes down when it rolls freely, by the
    /// orthogonal shear stress over depth: where strength is the same everywhere, 4 k of a line in
    /// plane strain. In three dimensions it rolls along its shorter semi-axis, and this is an
    /// upper bound: 4.68 k of a circle. `null` without yield, in plane stress and in axisymmetry
    /// \[stress >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub shakedown_pressure: Option<f64>,
    /// Depth that decides on it \[length >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub shakedown_depth: Option<f64>,
    /// The same limit of a line contact in plane strain with friction, which slides over the whole
    /// contact: of both bodies the lower, for either sense of the friction. Empty of all other
    /// contacts, and where `shakedown_pressure` is `null`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub shakedown_over_friction: Vec<ShakedownLimit>,
}

/// The mesh that was solved on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Mesh))]
pub struct MeshReport {
    /// Whether one half stands for both by symmetry.
    pub symmetric: bool,
    /// Tangential spacing in the contact \[length >= 0\].
    pub spacing: f64,
    /// Candidate node pairs of the meshed part.
    pub contact_pairs: usize,
    /// Nodes of both bodies.
    pub nodes: usize,
    /// Elements of both bodies.
    pub elements: usize,
    /// Equations of both bodies.
    pub equations: usize,
    /// Mesh passes made, the sizing ones included.
    pub passes: usize,
    /// Times the mesh was enlarged because the contact reached its edge.
    pub enlargements: usize,
    /// Smallest ratio of Jacobian determinants within one element; 1 is a parallelogram \[1\].
    pub min_jacobian_ratio: f64,
    /// Largest ratio of element side lengths \[1 >= 0\].
    pub max_aspect_ratio: f64,
}

impl Default for MeshReport {
    /// The report without a mesh.
    fn default() -> Self {
        Self {
            symmetric: false,
            spacing: 0.0,
            contact_pairs: 0,
            nodes: 0,
            elements: 0,
            equations: 0,
            passes: 0,
            enlargements: 0,
            min_jacobian_ratio: 1.0,
            max_aspect_ratio: 1.0,
        }
    }
}

/// Wall time \[ms\] by phase, all passes and steps together.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Timings {
    /// Everything \[ms >= 0\].
    pub total: f64,
    /// Mesh generation \[ms >= 0\].
    pub mesh: f64,
    /// Stiffness assembly \[ms >= 0\].
    pub assembly: f64,
    /// Fill-reducing ordering \[ms >= 0\].
    pub ordering: f64,
    /// Symbolic factorization \[ms >= 0\].
    pub symbolic: f64,
    /// Numeric factorization \[ms >= 0\].
    pub numeric: f64,
    /// Contact flexibility matrix \[ms >= 0\].
    pub flexibility: f64,
    /// Contact solves \[ms >= 0\].
    pub contact: f64,
    /// Plastic law and initial-stress loads \[ms >= 0\].
    pub plasticity: f64,
    /// Forward and back substitutions \[ms >= 0\].
    pub solves: f64,
    /// Final fields and this report \[ms >= 0\].
    pub output: f64,
}
