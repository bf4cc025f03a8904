//! The fields of the report in the JSON of a result.
//!
//! Lengths, forces and stresses are in the job's own units. `x` is tangential, `y` normal to the
//! contact and `z` out of the plane; stresses are tensile positive, pressures compressive
//! positive.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::ops::Index;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::answers::Name;
use super::known::is_shared;
use super::{
    Answer, ContactReport, FatigueReport, FieldsReport, FoundReport, IncrementsReport,
    LayersReport, LoadApproach, PassesReport, RuleVerdict, ShakedownMap, Side, SurfaceReport,
    TolerancesReport, ValidityNote, Verdict,
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
    /// What to keep in mind about figures that follow from more than one load.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub validity: Vec<ValidityNote>,
    /// The input that the job asks for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub found: Option<FoundReport>,
    /// What tolerances of inputs do to the figures.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerances: Option<TolerancesReport>,
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
    /// The state of the bodies in one sentence.
    pub verdict: Verdict,
    /// The figures of the step: those that answer the job, in the order in which it asks for them,
    /// and behind them details. Empty of a step that was stopped.
    pub answers: Vec<Answer>,
    /// The contact over the surface.
    pub contact: ContactReport,
    /// The increments of this load, under flow theory.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub increments: Option<IncrementsReport>,
    /// The surface of each body near the contact, under flow theory.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surfaces: Option<PerBody<Option<SurfaceReport>>>,
    /// Stresses over depth on the axis, or below the middle of the contact where there is none; of
    /// a load that rolls what its last pass has left, the same all along the track. Absent when
    /// not asked for, and where the step was stopped.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub subsurface: Option<PerBody<Option<SubsurfaceReport>>>,
    /// The same below the largest pressure; absent where that is in the middle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub subsurface_below_peak: Option<PerBody<Option<SubsurfaceReport>>>,
    /// Utilization over depth by criteria of high-cycle fatigue, of a load that rolls after its last
    /// pass by the rule of hardening of its verdict; absent without limits of fatigue, `null` of a
    /// body without, and where it is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fatigue: Option<PerBody<Option<FatigueReport>>>,
    /// Plastic zone of each body; `null` for a rigid one.
    pub plasticity: PerBody<Option<PlasticityReport>>,
    /// Hertz's peak pressures that the contact bears over the friction as it rolls, where strength
    /// and shapes have closed forms.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shakedown: Option<ShakedownMap>,
    /// The passes of a load that rolls.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub passes: Option<PassesReport>,
    /// The verdicts on a track by each rule of hardening that was solved.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rules: Vec<RuleVerdict>,
    /// What to keep in mind about this answer.
    pub validity: Vec<ValidityNote>,
    /// Mesh and nodal fields; absent unless asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fields: Option<PerBody<Option<FieldsReport>>>,
    /// Stresses and plastic strain in the layers of half-spaces in three dimensions, which have no
    /// mesh; absent unless `output.fields` asks for them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layers: Option<PerBody<Option<LayersReport>>>,
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

    /// Returns the first row of a name: that which answers the job, of bodies the one that decides.
    pub fn row(&self, name: Name) -> Option<&Answer> {
        self.answers.iter().find(|row| row.is(name))
    }

    /// Returns the value of the first row of a name, in its unit.
    pub fn value(&self, name: Name) -> Option<f64> {
        self.row(name)?.value
    }

    /// Returns the bound of the relative error of the first row of a name.
    pub fn bar(&self, name: Name) -> Option<f64> {
        self.row(name)?.error.bound()
    }

    /// Returns Hertz's figure beside the first row of a name.
    pub fn elastic(&self, name: Name) -> Option<f64> {
        self.row(name)?.elastic
    }

    /// Returns the approach, without force the permanent one.
    pub fn approach(&self) -> Option<f64> {
        self.value(Name::Approach).or_else(|| self.value(Name::PermanentApproach))
    }

    /// Returns x of the largest pressure.
    pub fn peak_position(&self) -> f64 {
        let place = self.row(Name::PeakPressure).and_then(|row| row.place);
        place.map_or(0.0, |place| place.x)
    }

    /// Returns the value of a figure of a body.
    pub fn body(&self, name: Name, side: Side) -> Option<f64> {
        self.of_body(name, side)?.value
    }

    /// Returns the row of a body.
    pub fn of_body(&self, name: Name, side: Side) -> Option<&Answer> {
        self.answers.iter().find(|row| row.is(name) && row.is_of(side))
    }
}

impl Index<Name> for StepReport {
    type Output = f64;

    /// Returns the value of the first row of a name.
    ///
    /// # Panics
    /// If the step has no such row, or its value is not known.
    fn index(&self, name: Name) -> &f64 {
        let value = self.row(name).and_then(|row| row.value.as_ref());
        value.unwrap_or_else(|| panic!("the step has no {}", name.label()))
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
        let of_lower = if is_shared(bodies) { of_upper.clone() } else { of(lower, 1)? };
        Ok(Self { upper: of_upper, lower: of_lower })
    }
}

/// Stresses along a normal of the surface.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Subsurface))]
pub struct SubsurfaceReport {
    /// x of the normal, along the arc for a pin in a hole; in three dimensions `[x, y]`
    /// \[length\].
    pub position: Vec<f64>,
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
    /// Stress along x, the shorter semi-axis of the contact. This and the following only in three
    /// dimensions, where `sigma_x` is `sigma_xx`, the normal stress `sigma_y` is `sigma_zz`, and
    /// `sigma_z` is `sigma_yy` \[stress\].
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

/// The plastic zone of one body.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = PlasticZone))]
pub struct PlasticityReport {
    /// Outline of the plastic zone in the section x–y: closed polygons of points `[x, depth]`, the
    /// first one not repeated, both sides of the axis; none in three dimensions. Depth is counted
    /// downward from the plane in which the bodies first touch, into the material of either body.
    /// Counter-clockwise in the axes `(x, depth)`; holes clockwise \[length\].
    pub outline: Vec<Vec<[f64; 2]>>,
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
    /// Columns, rows and layers of the cells of half-spaces or of a track, 0 layers of elastic
    /// bodies; absent of meshes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cells: Option<[usize; 3]>,
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
            cells: None,
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
