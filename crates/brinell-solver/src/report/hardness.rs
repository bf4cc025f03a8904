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

use serde::{Deserialize, Serialize};

use super::ValidityNote;
use super::error_bars::under_its_force;
use super::findings::Finding;
use crate::job::{Block, HardnessTest, Job, Material, Named, Shape, TestScale};
use crate::solver::{SolveStatus, StepSolution};
use crate::units::UnitConverter;

/// Part of the force from which on Meyer's law is fitted.
const FITTED_FROM: f64 = 0.25;
/// Error of the radius in elements.
const ELEMENTS_OFF: f64 = 0.3;
/// Standard errors in a bar.
const STANDARD_ERRORS: f64 = 2.0;
/// Conversion of N/mm² to kgf/mm² in the standards.
const KGF: f64 = 0.102;
/// Area of the faces of Vickers' pyramid over their projection.
const VICKERS_FACES: f64 = 1.0785;
/// Depth of a Rockwell unit \[mm\].
const ROCKWELL_UNIT: f64 = 0.002;
/// `E* a / (σ R)` from which on a ball is fully plastic: D. Tabor; K. L. Johnson, *Contact
/// Mechanics* (1985), section 6.3.
const FULLY_PLASTIC: f64 = 40.0;
/// Tabor's pressure over flow stress, his strains of a ball over a/R and of a pyramid.
const TABOR: f64 = 2.8;
const BALL_STRAIN: f64 = 0.2;
const PYRAMID_STRAIN: f64 = 0.08;
/// Dao's strain, and the `h_r/h_m` that tell a pressure: nearer to 1, an error of 1 % in a depth is one
/// of more than a tenth in the pressure.
const DAO_STRAIN: f64 = 0.033;
const DAO_DEPTHS: [f64; 2] = [0.5, 0.9];
/// Oliver and Pharr's ε.
const EPSILON: f64 = 0.75;

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
    /// Estimated bound of the relative error of the number, or of the mean pressure, by the mesh
    /// \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub relative_error: Option<f64>,
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
    /// E* of the two materials \[stress\].
    pub true_reduced_modulus: f64,
    /// Force over the area, H \[stress\].
    pub indentation_hardness: f64,
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
        let found = Found::of(test, &self.0, loaded);
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
        let mut remarks = Vec::new();
        let mut remark = |code: &str, message: String| {
            remarks.push(ValidityNote { code: code.to_owned(), message });
        };
        if published.is_none() {
            remark("bias_unknown", found.why_unknown().to_owned());
        }
        let number = found.number(found.radius).filter(|_| found.is_converged());
        if let (Some(number), Some([least, most])) = (number, range(test.scale))
            && !(least..=most).contains(&number)
        {
            let name = test.scale.name();
            remark(
                "outside_scale",
                format!("The scale {name} is for {least} to {most} by its standard."),
            );
        }
        let least_thickness = found.least_thickness();
        if let (Some(least), Shape::Block(Block { depth, .. })) =
            (least_thickness, &job.lower.shape)
            && depth.get() < least
        {
            let message = format!(
                "The specimen is {} thick; the standard wants {} for this indentation, so that \
                 the support does not bear it.",
                write.length_text(depth.get()),
                write.length_text(least)
            );
            remark("thin_specimen", message);
        }
        if test.slope().is_some() && is_pyramid(test) {
            let message = "A pyramid is solved as the cone of equal area, of 70.3° half-angle: \
                           its edges are left out.";
            remark("equal_cone", message.to_owned());
        }
        let diagonal = if is_pyramid(test) { std::f64::consts::FRAC_PI_2.sqrt() } else { 1.0 };
        Some(HardnessReport {
            test: test.name(),
            number,
            relative_error: found.relative_error(),
            bias: published.map(|(pressure, _)| found.pressure() / pressure - 1.0),
            bias_source: published.map(|(_, source)| source.to_owned()),
            force: write.force(found.load().force),
            diameter: write.length(2.0 * diagonal * found.radius),
            depth: write.length(found.load().dent),
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
            least_thickness: least_thickness.map(|least| write.length(least)),
            remarks,
        })
    }
}

const fn is_pyramid(test: &HardnessTest) -> bool {
    matches!(test.scale, TestScale::Hv | TestScale::Berkovich)
}

/// Numbers for which a scale is meant: ISO 6506-1 and ISO 6508-1.
const fn range(scale: TestScale) -> Option<[f64; 2]> {
    match scale {
        TestScale::Hbw => Some([0.0, 650.0]),
        TestScale::Hrc => Some([20.0, 70.0]),
        TestScale::Hrb => Some([10.0, 100.0]),
        TestScale::Hv | TestScale::Berkovich | TestScale::Sphere => None,
    }
}

/// Dao's loading curvature of an E* and the stress at his strain, within the moduli over stress of
/// his materials \[MPa\].
fn dao_curvature(modulus: f64, stress: f64) -> Option<f64> {
    let x = (modulus / stress).ln();
    let ratio = ((-1.131 * x + 13.635) * x - 30.594) * x + 29.267;
    (3.0..6.3).contains(&x).then_some(ratio * stress)
}

/// Meyer's law near the largest force.
#[derive(Debug, Clone, Copy)]
struct MeyerFit {
    /// Radius under the largest force \[mm\].
    radius: f64,
    exponent: f64,
    /// Relative standard error of the radius.
    error: f64,
}

impl MeyerFit {
    fn of(increments: &[[f64; 2]], force: f64) -> Option<Self> {
        let points: Vec<[f64; 2]> = increments
            .iter()
            .filter(|[at, half_width]| *at >= FITTED_FROM * force && *half_width > 0.0)
            .map(|[at, half_width]| [(at / force).ln(), half_width.ln()])
            .collect();
        if points.len() < 6 {
            return None;
        }
        let count = points.len() as f64;
        let mean = [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / count);
        let moment = |a: usize, b: usize| -> f64 {
            points.iter().map(|point| (point[a] - mean[a]) * (point[b] - mean[b])).sum()
        };
        let spread = moment(0, 0);
        let slope = moment(0, 1) / spread;
        let at_force = mean[1] - slope * mean[0];
        let off = points.iter().map(|[x, y]| (y - slope * x - at_force).powi(2)).sum::<f64>();
        let scatter = (off / (count - 2.0)).sqrt();
        let error = scatter * (1.0 / count + mean[0] * mean[0] / spread).sqrt();
        (slope > 0.0).then(|| Self { radius: at_force.exp(), exponent: 1.0 / slope, error })
    }
}

/// What the loads of a test tell.
struct Found<'a> {
    test: &'a HardnessTest,
    loads: &'a [Seen],
    loaded: usize,
    fit: Option<MeyerFit>,
    /// Radius of the contact under the largest force \[mm\].
    radius: f64,
}

impl<'a> Found<'a> {
    fn of(test: &'a HardnessTest, loads: &'a [Seen], loaded: usize) -> Self {
        let load = &loads[loaded];
        let fit = MeyerFit::of(&load.increments, load.force);
        let radius = fit.map_or(load.half_width, |fit| fit.radius);
        Self { test, loads, loaded, fit, radius }
    }

    fn load(&self) -> &Seen {
        &self.loads[self.loaded]
    }

    fn unloaded(&self) -> Option<&Seen> {
        self.loads.get(self.loaded + 1..)?.iter().find(|seen| seen.force == 0.0)
    }

    /// Whether all that the number needs has converged.
    fn is_converged(&self) -> bool {
        let last = self.loaded + usize::from(self.test.scale.is_rockwell());
        self.loads.len() > last && self.loads[..=last].iter().all(|seen| seen.is_converged)
    }

    fn area(&self) -> f64 {
        std::f64::consts::PI * self.radius * self.radius
    }

    fn pressure(&self) -> f64 {
        self.load().force / self.area()
    }

    /// Returns the hardness number for a radius of the contact.
    fn number(&self, radius: f64) -> Option<f64> {
        let force = self.load().force;
        let area = std::f64::consts::PI * radius * radius;
        match self.test.scale {
            TestScale::Hbw => {
                let ball = self.test.radius();
                let cap = 2.0
                    * std::f64::consts::PI
                    * ball
                    * (ball - (ball * ball - radius * radius).max(0.0).sqrt());
                Some(KGF * force / cap)
            }
            TestScale::Hv => Some(KGF * force / (VICKERS_FACES * area)),
            TestScale::Hrc => Some(100.0 - self.rockwell_depth()? / ROCKWELL_UNIT),
            TestScale::Hrb => Some(130.0 - self.rockwell_depth()? / ROCKWELL_UNIT),
            TestScale::Berkovich | TestScale::Sphere => None,
        }
    }

    /// Returns the depth that the total force adds, under the preliminary force \[mm\].
    fn rockwell_depth(&self) -> Option<f64> {
        let before = self.loads.get(self.loaded.checked_sub(1)?)?;
        Some(self.loads.get(self.loaded + 1)?.approach - before.approach)
    }

    fn radius_error(&self) -> f64 {
        let standard = self.fit.map_or(0.0, |fit| STANDARD_ERRORS * fit.error);
        standard + ELEMENTS_OFF * self.load().spacing / self.radius
    }

    fn relative_error(&self) -> Option<f64> {
        if !self.is_converged() {
            return None;
        }
        if self.test.scale.is_rockwell() {
            let [before, after] = [self.loaded.checked_sub(1)?, self.loaded + 1].map(|k| {
                self.loads.get(k).and_then(|seen| Some(seen.approach_bar? * seen.approach))
            });
            let number = self.number(self.radius)?;
            return Some((before?.abs() + after?.abs()) / ROCKWELL_UNIT / number.abs());
        }
        self.fit?;
        let error = self.radius_error();
        match (self.number(self.radius * (1.0 - error)), self.number(self.radius)) {
            (Some(more), Some(number)) => Some(more / number - 1.0),
            _ => Some((1.0 - error).powi(-2) - 1.0),
        }
    }

    /// Height of the specimen's surface at the edge of the contact \[mm\].
    fn edge_height(&self) -> f64 {
        let surface = &self.load().surface;
        let beyond = surface.iter().position(|[x, _]| *x >= self.radius);
        match beyond.and_then(|k| Some((surface.get(k.checked_sub(1)?)?, surface.get(k)?))) {
            Some(([left, low], [right, high])) => {
                low + (high - low) * (self.radius - left) / (right - left)
            }
            None => 0.0,
        }
    }

    /// Mean pressure of a published result and its source.
    fn published(&self, modulus: f64, flow_stress: Option<f64>) -> Option<(f64, &'static str)> {
        match self.test.scale {
            TestScale::Hbw | TestScale::Hrb | TestScale::Sphere => {
                let stress = flow_stress?;
                let plasticity = modulus * self.radius / (stress * self.test.radius());
                let source = "D. Tabor, The Hardness of Metals (1951): 2.8 σ(0.2 a/R)";
                (plasticity >= FULLY_PLASTIC).then_some((TABOR * stress, source))
            }
            TestScale::Hv | TestScale::Berkovich => {
                flow_stress?;
                let ratio = self.unloaded()?.approach / self.load().approach;
                let source = "M. Dao et al., Acta Materialia 49 (2001) 3899: mean pressure of a \
                              cone of 70.3° by h_r/h_m";
                (DAO_DEPTHS[0]..=DAO_DEPTHS[1]).contains(&ratio).then(|| {
                    (modulus * 0.268_536 * (0.995_249_5 - ratio).powf(1.114_273_5), source)
                })
            }
            TestScale::Hrc => None,
        }
    }

    const fn why_unknown(&self) -> &'static str {
        match self.test.scale {
            TestScale::Hrc => {
                "No published result with large strains is known of the sphero-conical indenter: \
                 what small strains leave out is not known."
            }
            TestScale::Hv | TestScale::Berkovich => {
                "The depth that is left tells the published pressure with large strains where it \
                 is half to 90 % of that under load: what small strains leave out of \
                 it is not known."
            }
            TestScale::Hbw | TestScale::Hrb | TestScale::Sphere => {
                "The ball is not fully plastic, where Tabor's rule begins: what small strains \
                 leave out is not known."
            }
        }
    }

    /// ISO 6506-1: eight depths; ISO 6507-1: one and a half diagonals; ISO 6508-1: ten depths of a
    /// cone, fifteen of a ball.
    fn least_thickness(&self) -> Option<f64> {
        let depth = self.load().dent;
        match self.test.scale {
            TestScale::Hbw => Some(8.0 * depth),
            TestScale::Hv => Some(1.5 * (2.0 * std::f64::consts::PI).sqrt() * self.radius),
            TestScale::Hrc => Some(10.0 * self.rockwell_depth()?),
            TestScale::Hrb => Some(15.0 * self.rockwell_depth()?),
            TestScale::Berkovich | TestScale::Sphere => None,
        }
    }

    fn oliver_pharr(&self, modulus: f64, write: UnitConverter) -> Option<OliverPharrReport> {
        if self.test.scale.is_rockwell() || self.load().stiffness <= 0.0 {
            return None;
        }
        let Seen { force, approach, stiffness, .. } = *self.load();
        let depth = approach - EPSILON * force / stiffness;
        let area = std::f64::consts::PI
            * match self.test.slope() {
                None => (2.0 * self.test.radius() - depth) * depth,
                Some(slope) => (depth / slope).powi(2),
            };
        (depth > 0.0 && area > 0.0).then(|| OliverPharrReport {
            stiffness: write.stiffness(stiffness),
            contact_depth: write.length(depth),
            area: write.area(area),
            true_area: write.area(self.area()),
            reduced_modulus: write.stress(0.5 * stiffness * (std::f64::consts::PI / area).sqrt()),
            true_reduced_modulus: write.stress(modulus),
            indentation_hardness: write.stress(force / area),
        })
    }
}
