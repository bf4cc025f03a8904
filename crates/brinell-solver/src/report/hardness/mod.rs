//! The answer of a hardness test.
//!
//! The edge of a contact lies between two nodes, so that the half-width under a force scatters by
//! an element. Meyer's law `F = k d^m`, fitted by least squares to the increments from a quarter of
//! the force on, has the radius a under the force; its standard error and 0.3 h/a bound the error.
//!
//! Beside the mean pressure p stands that of published results with large strains. Balls: D.
//! Tabor, *The Hardness of Metals* (1951), `p = 2.8 σ(0.2 a/R)` with full plasticity. Cones of
//! 70.3°: M. Dao et al., Acta Mater. 49 (2001) 3899, `p/E* = 0.268536 (0.9952495 − h_r/h_m)^1.1142735`
//! from the depths under load and after it, and their loading curvature F/h² from the stress at a
//! plastic strain of 3.3 %.

mod answer;
mod found;
mod remarks;

use serde::{Deserialize, Serialize};

use self::found::Found;
use super::ValidityNote;
use super::error_bars::under_its_force;
use super::findings::Finding;
use crate::job::{HardnessTest, Job, Material, TestScale};
use crate::solver::{SolveStatus, StepSolution};
use crate::units::UnitConverter;

/// Tabor's strains of a ball over a/R and of a pyramid.
const BALL_STRAIN: f64 = 0.2;
const PYRAMID_STRAIN: f64 = 0.08;
/// Strain of Dao's curvature.
const DAO_STRAIN: f64 = 0.033;

/// The hardness that a test finds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = HardnessResult))]
pub struct HardnessReport {
    /// Name of the test, e.g. `HBW 10/3000`.
    pub test: String,
    /// Hardness number; `null` of `berkovich` and `sphere`, whose hardness is `mean_pressure`, and
    /// where a load did not converge \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub number: Option<f64>,
    /// Estimated bound of the relative error of the number, or of the mean pressure, by the mesh;
    /// `null` of Rockwell numbers, whose zero is a convention \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub relative_error: Option<f64>,
    /// The same in points of the scale \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub number_error: Option<f64>,
    /// Mean pressure over that of a published result with large strains, less 1; `null` where none
    /// is known, as a remark says \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub bias: Option<f64>,
    /// The published result.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub bias_source: Option<String>,
    /// Largest force \[force\].
    pub force: f64,
    /// Diameter of the contact under it; of pyramids the diagonal of a square of equal area
    /// \[length\].
    pub diameter: f64,
    /// Depth of the indentation under it \[length\].
    pub depth: f64,
    /// Estimated bound of the relative error of the depth by the mesh \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub depth_error: Option<f64>,
    /// Depth that is left \[length\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub permanent_depth: Option<f64>,
    /// Diameter of the highest points around the indentation that is left; `null` where nothing is
    /// piled up \[length\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub rim_diameter: Option<f64>,
    /// Height of the edge of the contact under load over the plane surface: above 0 piled up,
    /// below 0 sunk in \[length\].
    pub pile_up: f64,
    /// Force over the area of the contact, Meyer's hardness \[stress\].
    pub mean_pressure: f64,
    /// Exponent of Meyer's law, force over diameter \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub meyer_exponent: Option<f64>,
    /// Tabor's representative plastic strain: 0.2 a/R of a ball, 0.08 of a pyramid \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub representative_strain: Option<f64>,
    /// Stress of the curve at this strain \[stress\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub flow_stress: Option<f64>,
    /// Mean pressure over this stress; Tabor's is 2.8 \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub constraint: Option<f64>,
    /// What an instrument would find by Oliver and Pharr's method.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub oliver_pharr: Option<OliverPharrReport>,
    /// Loading curvature F/h² of a pyramid over that of Dao et al., less 1 \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub curvature_bias: Option<f64>,
    /// Least thickness of the specimen by the standard \[length\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub least_thickness: Option<f64>,
    /// What to keep in mind.
    pub remarks: Vec<ValidityNote>,
}

/// Oliver and Pharr's figures (J. Mater. Res. 7 (1992) 1564) of the unloading curve, beside the
/// true contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = OliverPharr))]
pub struct OliverPharrReport {
    /// Slope S of the unloading curve at its beginning \[stiffness\].
    pub stiffness: f64,
    /// Contact depth `h_c = h − 0.75 F/S` \[length\].
    pub contact_depth: f64,
    /// Area of the indenter at this depth \[area\].
    pub area: f64,
    /// Area of the true contact \[area\].
    pub true_area: f64,
    /// `√π S / (2 √A)` \[stress\].
    pub reduced_modulus: f64,
    /// Estimated bound of its relative error by the mesh \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub modulus_error: Option<f64>,
    /// E* of the two materials \[stress\].
    pub true_reduced_modulus: f64,
    /// Force over the area, H \[stress\].
    pub indentation_hardness: f64,
    /// Estimated bound of its relative error by the mesh \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub hardness_error: Option<f64>,
}

/// One load of the test.
#[derive(Debug, Clone)]
struct Seen {
    force: f64,
    approach: f64,
    /// Relative error of the approach.
    approach_bar: Option<f64>,
    half_width: f64,
    spacing: f64,
    stiffness: f64,
    dent: f64,
    /// Whether the specimen has yielded.
    has_yielded: bool,
    /// Place and height of the highest point of the specimen.
    highest: [f64; 2],
    /// `[x, height]` of the surface.
    surface: Vec<[f64; 2]>,
    /// Force and half-width of the increments.
    increments: Vec<[f64; 2]>,
    is_converged: bool,
}

/// The loads of a test, as they are solved.
#[derive(Debug, Clone, Default)]
pub(super) struct HardnessSeen(Vec<Seen>);

impl HardnessSeen {
    /// Records a load.
    pub fn see(&mut self, job: &Job, step: &StepSolution, findings: &[Finding]) {
        let (Some(_), Some(specimen)) = (job.load.hardness(), &step.bodies[1]) else { return };
        let surface = specimen.surface();
        let highest =
            surface.iter().copied().fold([0.0; 2], |a, b| if b[1] > a[1] { b } else { a });
        self.0.push(Seen {
            force: step.force(),
            approach: step.approach,
            approach_bar: under_its_force(step, findings).and_then(|bars| bars.approach),
            half_width: step.half_width(),
            spacing: step.spacing,
            stiffness: step.unloading_stiffness,
            dent: specimen.dent_depth(),
            has_yielded: specimen.has_yielded(),
            highest,
            surface,
            increments: step.increments.iter().map(|end| [end.force, end.half_width]).collect(),
            is_converged: step.status == SolveStatus::Converged,
        });
    }

    /// Returns the report, or `None` of another job and where the largest force has no answer.
    pub fn finish(self, job: &Job, write: UnitConverter) -> Option<HardnessReport> {
        let test = job.load.hardness()?;
        let loaded = self.0.iter().position(|seen| seen.force >= 0.999 * test.force())?;
        let Material::Deformable(specimen) = &job.lower.material else { return None };
        let indenter = test.elastic()?;
        let modulus = 1.0
            / (1.0 / specimen.elastic().plane_strain_modulus()
                + 1.0 / indenter.plane_strain_modulus());
        let law = specimen.hardening_law();
        let found = Found::of(test, job, &self.0, loaded)?;
        let strain = match test.slope() {
            None => BALL_STRAIN * found.radius / test.radius(),
            Some(_) => PYRAMID_STRAIN,
        };
        let flow_stress = law.as_ref().map(|law| law.stress(strain));
        let published = found.published(modulus, flow_stress);
        let curvature = law
            .as_ref()
            .filter(|_| is_pyramid(test))
            .and_then(|law| dao_curvature(modulus, law.stress(DAO_STRAIN)));
        let curvature_bias = curvature
            .map(|curvature| found.load().force / found.load().approach.powi(2) / curvature - 1.0);
        Some(HardnessReport {
            test: test.name(),
            number: found.number(),
            relative_error: found.relative_error(),
            number_error: found.number_error(),
            bias: published.map(|(pressure, _)| found.pressure() / pressure - 1.0),
            bias_source: published.map(|(_, source)| source.to_owned()),
            force: write.force(found.load().force),
            diameter: write.length(found.diameter()),
            depth: write.length(found.load().dent),
            depth_error: found.depth_error(),
            permanent_depth: found.unloaded().map(|seen| write.length(seen.dent)),
            rim_diameter: found
                .unloaded()
                .filter(|seen| seen.highest[1] > 0.0)
                .map(|seen| write.length(2.0 * seen.highest[0].abs())),
            pile_up: write.length(found.edge_height()),
            mean_pressure: write.stress(found.pressure()),
            meyer_exponent: found.fit.map(|fit| fit.exponent),
            representative_strain: law.as_ref().map(|_| strain),
            flow_stress: flow_stress.map(|stress| write.stress(stress)),
            constraint: flow_stress.map(|stress| found.pressure() / stress),
            oliver_pharr: found.oliver_pharr(modulus, write),
            curvature_bias,
            least_thickness: found.least_thickness().map(|least| write.length(least)),
            remarks: found.remarks(published.is_some(), write),
        })
    }
}

const fn is_pyramid(test: &HardnessTest) -> bool {
    matches!(test.scale, TestScale::Hv | TestScale::Berkovich)
}

/// Dao's loading curvature of an E* and the stress at his strain, within the moduli over stress of
/// his materials \[MPa\].
fn dao_curvature(modulus: f64, stress: f64) -> Option<f64> {
    let x = (modulus / stress).ln();
    let ratio = ((-1.131 * x + 13.635) * x - 30.594) * x + 29.267;
    (3.0..6.3).contains(&x).then_some(ratio * stress)
}
