//! What the loads of a hardness test tell.

use super::seen::{Seen, is_pyramid};
use crate::job::{Block, HardnessTest, Job, Shape, TestScale};

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
/// Tabor's pressure over flow stress.
const TABOR: f64 = 2.8;
/// The `h_r/h_m` that tell Dao's pressure: nearer to 1, an error of 1 % in a depth is one of more than a
/// tenth in the pressure.
const DAO_DEPTHS: [f64; 2] = [0.5, 0.9];
/// Oliver and Pharr's ε.
const EPSILON: f64 = 0.75;
/// Diameters from the middle of an indentation to an edge of the specimen.
const EDGE: f64 = 2.5;
/// Part of the contact's radius from which on the tip of a pyramid makes it a ball.
const BLUNT: f64 = 0.3;

/// Meyer's law near the largest force.
#[derive(Debug, Clone, Copy)]
pub(super) struct MeyerFit {
    /// Radius under the largest force \[mm\].
    radius: f64,
    pub exponent: f64,
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

/// Oliver and Pharr's figures (J. Mater. Res. 7 (1992) 1564) of the unloading curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct OliverPharr {
    /// `√π S / (2 √A)`, and the force over A.
    pub modulus: f64,
    pub hardness: f64,
    /// Slope S of the unloading curve at its beginning.
    pub stiffness: f64,
    /// Contact depth `h_c = h − 0.75 F/S`, and the area A of the indenter there.
    pub depth: f64,
    pub area: f64,
    /// Relative errors of modulus and hardness by the mesh.
    pub errors: [Option<f64>; 2],
}

/// What the loads of a test tell.
pub(super) struct Found<'a> {
    pub test: &'a HardnessTest,
    /// The specimen.
    pub specimen: Block,
    loads: &'a [Seen],
    loaded: usize,
    pub fit: Option<MeyerFit>,
    /// Radius of the contact under the largest force \[mm\].
    pub radius: f64,
}

impl<'a> Found<'a> {
    pub fn of(
        test: &'a HardnessTest,
        job: &Job,
        loads: &'a [Seen],
        loaded: usize,
    ) -> Option<Self> {
        let load = &loads[loaded];
        let fit = MeyerFit::of(&load.increments, load.force);
        let radius = fit.map_or(load.half_width, |fit| fit.radius);
        let Shape::Block(specimen) = job.lower.shape else { return None };
        Some(Self { test, specimen, loads, loaded, fit, radius })
    }

    pub fn load(&self) -> &Seen {
        &self.loads[self.loaded]
    }

    pub fn unloaded(&self) -> Option<&Seen> {
        self.loads.get(self.loaded + 1..)?.iter().find(|seen| seen.force == 0.0)
    }

    /// Whether all that the number needs has converged.
    fn is_converged(&self) -> bool {
        let last = self.loaded + usize::from(self.test.scale.is_rockwell());
        self.loads.len() > last && self.loads[..=last].iter().all(|seen| seen.is_converged)
    }

    /// Returns why there is no hardness, if so.
    pub fn without_answer(&self) -> Option<&'static str> {
        if !self.is_converged() {
            Some("a load of the test has no answer so far")
        } else if !self.load().has_yielded {
            Some("the specimen has not yielded: nothing is indented")
        } else {
            None
        }
    }

    pub fn area(&self) -> f64 {
        std::f64::consts::PI * self.radius * self.radius
    }

    pub fn pressure(&self) -> f64 {
        self.load().force / self.area()
    }

    /// Diameter of the contact, of pyramids the diagonal of a square of equal area \[mm\].
    pub fn diameter(&self) -> f64 {
        let diagonal =
            if is_pyramid(self.test) { std::f64::consts::FRAC_PI_2.sqrt() } else { 1.0 };
        2.0 * diagonal * self.radius
    }

    /// Returns the hardness number, of a specimen that has a dent.
    pub fn number(&self) -> Option<f64> {
        self.number_of(self.radius).filter(|_| self.without_answer().is_none())
    }

    /// Returns the hardness number for a radius of the contact.
    fn number_of(&self, radius: f64) -> Option<f64> {
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

    pub fn relative_error(&self) -> Option<f64> {
        if self.test.scale.is_rockwell() || !self.is_converged() {
            return None;
        }
        self.fit?;
        let error = self.radius_error();
        match (self.number_of(self.radius * (1.0 - error)), self.number()) {
            (Some(more), Some(number)) => Some(more / number - 1.0),
            _ => Some((1.0 - error).powi(-2) - 1.0),
        }
    }

    /// Bound of the error of the number in points of its scale.
    pub fn number_error(&self) -> Option<f64> {
        let number = self.number()?;
        if !self.test.scale.is_rockwell() {
            return Some(number * self.relative_error()?);
        }
        let error = |k: usize| self.depth_off(self.loads.get(k)?);
        let depth = error(self.loaded.checked_sub(1)?)? + error(self.loaded + 1)?;
        Some(depth / ROCKWELL_UNIT)
    }

    /// Error of the depth under the largest force, relative to it.
    pub fn depth_error(&self) -> Option<f64> {
        Some(self.depth_off(self.load())? / self.load().dent)
    }

    /// Bound of the error of the depth of a load \[mm\]: that of its approach, and of an edge that
    /// is off along the face of the indenter.
    fn depth_off(&self, seen: &Seen) -> Option<f64> {
        let slope = self.test.slope().unwrap_or_else(|| self.radius / self.test.radius());
        Some((seen.approach_bar? * seen.approach).abs() + ELEMENTS_OFF * seen.spacing * slope)
    }

    /// Part of the contact's radius that the tip of a pyramid takes.
    fn tip(&self) -> f64 {
        let slope = self.test.slope().filter(|_| is_pyramid(self.test)).unwrap_or_default();
        self.test.radius() * slope / slope.hypot(1.0) / self.radius
    }

    /// Height of the specimen's surface at the edge of the contact \[mm\].
    pub fn edge_height(&self) -> f64 {
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
    pub fn published(
        &self,
        modulus: f64,
        flow_stress: Option<f64>,
    ) -> Option<(f64, &'static str)> {
        if self.is_thin() || self.is_narrow() || self.is_blunt() {
            return None;
        }
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

    /// ISO 6506-1: eight depths; ISO 6507-1: one and a half diagonals; ISO 6508-1: ten depths of a
    /// cone, fifteen of a ball.
    pub fn least_thickness(&self) -> Option<f64> {
        let depth = self.load().dent;
        match self.test.scale {
            TestScale::Hbw => Some(8.0 * depth),
            TestScale::Hv => Some(1.5 * (2.0 * std::f64::consts::PI).sqrt() * self.radius),
            TestScale::Hrc => Some(10.0 * self.rockwell_depth()?),
            TestScale::Hrb => Some(15.0 * self.rockwell_depth()?),
            TestScale::Berkovich | TestScale::Sphere => None,
        }
    }

    /// Whether the support bears a part of the force.
    pub fn is_thin(&self) -> bool {
        self.least_thickness().is_some_and(|least| self.specimen.depth.get() < least)
    }

    /// ISO 6506-1, 6507-1 and 6508-1: two and a half diameters from the middle to an edge \[mm\].
    pub fn least_width(&self) -> f64 {
        2.0 * EDGE * self.diameter()
    }

    pub fn is_narrow(&self) -> bool {
        self.specimen.width.get() < self.least_width()
    }

    /// Whether the contact is that of the tip of a pyramid.
    pub fn is_blunt(&self) -> bool {
        self.tip() > BLUNT
    }

    /// What is left of the depth, relative to it.
    pub fn left(&self) -> Option<f64> {
        let left = self.unloaded()?.dent / self.load().dent;
        Some(if self.load().has_yielded { left } else { 0.0 })
    }

    /// Area of the indenter at a depth: a ball, or a cone behind its tip.
    fn section(&self, depth: f64) -> f64 {
        let radius = self.test.radius();
        let slope = self.test.slope().unwrap_or(f64::INFINITY);
        // The tip goes over into the cone where it has the cone's slope.
        let hypotenuse = slope.hypot(1.0);
        let is_tip = slope.is_infinite() || depth < radius * (1.0 - 1.0 / hypotenuse);
        let at = if is_tip {
            (2.0 * radius - depth) * depth
        } else {
            ((depth + radius * (hypotenuse - 1.0)) / slope).powi(2)
        };
        std::f64::consts::PI * at
    }

    pub fn oliver_pharr(&self) -> Option<OliverPharr> {
        let Seen { force, approach, stiffness, half_width, .. } = *self.load();
        if self.test.scale.is_rockwell() || stiffness <= 0.0 || half_width <= 0.0 {
            return None;
        }
        let stiffness = stiffness * self.radius / half_width;
        // Depth, area, modulus and hardness of a stiffness and an approach.
        let by = |stiffness: f64, approach: f64| -> Option<[f64; 4]> {
            let depth = approach - EPSILON * force / stiffness;
            let area = self.section(depth);
            let modulus = 0.5 * stiffness * (std::f64::consts::PI / area).sqrt();
            (depth > 0.0 && area > 0.0).then(|| [depth, area, modulus, force / area])
        };
        let [depth, area, reduced_modulus, hardness] = by(stiffness, approach)?;
        let error = |k: usize, nominal: f64| {
            let [slope, deep] = [self.radius_error(), self.depth_off(self.load())?];
            self.fit?;
            let corners = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
            corners.into_iter().try_fold(0.0, |most: f64, (a, b)| {
                let at = by(stiffness * (1.0 + a * slope), approach + b * deep)?;
                Some(most.max((at[k] / nominal - 1.0).abs()))
            })
        };
        let errors = [error(2, reduced_modulus), error(3, hardness)];
        Some(OliverPharr { modulus: reduced_modulus, hardness, stiffness, depth, area, errors })
    }

    pub fn is_pyramid(&self) -> bool {
        is_pyramid(self.test)
    }
}
