//! What the loads of a hardness test tell.

use super::seen::{Increment, Seen, is_pyramid};
use crate::job::{Block, HardnessTest, Job, Shape, TestScale};
use crate::solver::method::parabola::Parabola;

/// Part of the force from which on a parabola is fitted.
const FITTED_FROM: f64 = 0.15;
/// Elements over the radius under the total force from which on the approach under the preliminary
/// one, with a quarter of them, is known.
const LEAST_ELEMENTS: u32 = 16;
/// Part of the change that is left as an error, and standard errors in a bar.
const LEFT: f64 = 0.25;
const STANDARD_ERRORS: f64 = 1.5;
/// Conversion of N/mm² to kgf/mm² in the standards.
const KGF: f64 = 0.102;
/// Area of the faces of Vickers' pyramid over their projection.
const VICKERS_FACES: f64 = 1.0785;
/// Vickers' number by the diagonals over that of the cone, less 1, at most
/// (docs/notes/hardness.md).
const EDGES: f64 = 0.09;
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

/// A figure under a force by the parabola over the root of the force through the increments of the
/// load. Radius and depth of a cone are in proportion to that root.
#[derive(Debug, Clone, Copy)]
struct Smooth {
    value: f64,
    /// Exponent m of `F = k x^m` under the force.
    exponent: f64,
    /// Relative standard error of the value.
    error: f64,
}

impl Smooth {
    /// `figure` is the place of the figure in an increment.
    fn of(increments: &[Increment], force: f64, figure: usize) -> Option<Self> {
        let points: Vec<[f64; 2]> = increments
            .iter()
            .filter(|increment| increment[0] >= FITTED_FROM * force)
            .map(|increment| [(increment[0] / force).sqrt() - 1.0, increment[figure]])
            .collect();
        if points.len() < 6 {
            return None;
        }
        let Parabola { value, slope, error, .. } = Parabola::through(&points);
        let is_rising = value > 0.0 && slope > 0.0;
        is_rising.then(|| Self { value, exponent: 2.0 * value / slope, error: error / value })
    }

    /// Returns the figure that an error of this order leaves on elements without size, and the
    /// bound of its relative error.
    fn extrapolated(self, coarse: &Self, order: i32) -> [f64; 2] {
        let part = (2.0_f64.powi(order) - 1.0).recip();
        let change = self.value - coarse.value;
        let value = self.value + part * change;
        let scatter = ((1.0 + part) * self.error).hypot(part * coarse.error);
        [value, LEFT * (change / value).abs() + STANDARD_ERRORS * scatter]
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
    /// Exponent of Meyer's law.
    pub exponent: Option<f64>,
    /// Radius of the contact under the largest force \[mm\].
    pub radius: f64,
    /// Bound of its relative error.
    radius_error: Option<f64>,
    /// Radius on the mesh, whose surface has its edge there \[mm\].
    edge: f64,
    /// Whether the mesh tells the approach under a preliminary force.
    tells_depth: bool,
}

impl<'a> Found<'a> {
    pub fn of(
        test: &'a HardnessTest,
        job: &Job,
        loads: &'a [Seen],
        loaded: usize,
    ) -> Option<Self> {
        let load = &loads[loaded];
        let by_mesh = load.increments.each_ref().map(|all| Smooth::of(all, load.force, 1));
        let edge = by_mesh[0].map_or(load.half_width, |fine| fine.value);
        let (radius, radius_error) = match by_mesh {
            [Some(fine), Some(coarse)] => {
                let [radius, error] = fine.extrapolated(&coarse, 1);
                (radius, Some(error))
            }
            _ => (edge, None),
        };
        let exponent = by_mesh[0].map(|fine| fine.exponent);
        let Shape::Block(specimen) = job.lower.shape else { return None };
        let tells_depth = job.mesh.elements_per_half_width >= LEAST_ELEMENTS;
        Some(Self {
            test,
            specimen,
            loads,
            loaded,
            exponent,
            radius,
            radius_error,
            edge,
            tells_depth,
        })
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
        let before = self.approach_under(self.loaded.checked_sub(1)?).0;
        Some(self.approach_after(self.loads.get(self.loaded + 1)?) - before)
    }

    /// Returns the approach under a load that rises, and the bound of its error \[mm\].
    fn approach_under(&self, load: usize) -> (f64, Option<f64>) {
        let load = &self.loads[load];
        let by_mesh = load.increments.each_ref().map(|all| Smooth::of(all, load.force, 2));
        let [Some(fine), Some(coarse)] = by_mesh else { return (load.approach, None) };
        let [approach, error] = fine.extrapolated(&coarse, 2);
        (approach, Some(error * approach))
    }

    /// Returns the approach under the largest force, and the bound of its error \[mm\].
    pub fn approach(&self) -> (f64, Option<f64>) {
        self.approach_under(self.loaded)
    }

    /// Returns the approach after the largest force \[mm\]: the recovery is smooth.
    fn approach_after(&self, unloaded: &Seen) -> f64 {
        self.approach().0 - (self.load().approach - unloaded.approach)
    }

    /// Bound of the relative error of the area, and of the mean pressure.
    pub fn area_error(&self) -> Option<f64> {
        let error = self.radius_error.filter(|_| self.is_converged())?;
        Some((1.0 - error).powi(-2) - 1.0)
    }

    /// Bound of the relative error of a number that is no Rockwell number.
    pub fn relative_error(&self) -> Option<f64> {
        if self.test.scale.is_rockwell() || !self.is_converged() {
            return None;
        }
        let error = self.radius_error?;
        match (self.number_of(self.radius * (1.0 - error)), self.number()) {
            (Some(more), Some(number)) => Some(more / number - 1.0),
            _ => self.area_error(),
        }
    }

    /// What the edges of a pyramid add to the relative error of its number.
    pub fn error_of_edges(&self) -> f64 {
        if self.test.scale == TestScale::Hv { EDGES } else { 0.0 }
    }

    /// Bound of the error of the number in points of its scale.
    pub fn number_error(&self) -> Option<f64> {
        let number = self.number()?;
        if !self.test.scale.is_rockwell() {
            return Some(number * self.relative_error()?);
        }
        let error = |load: usize| self.approach_under(load).1.filter(|_| self.tells_depth);
        Some(error(self.loaded.checked_sub(1)?)?.hypot(error(self.loaded)?) / ROCKWELL_UNIT)
    }

    /// Depth under the largest force \[mm\], and the bound of its relative error.
    pub fn depth(&self) -> (f64, Option<f64>) {
        let (approach, error) = self.approach();
        let depth = self.load().dent + approach - self.load().approach;
        (depth, error.map(|error| error / depth))
    }

    /// Part of the contact's radius that the tip of a pyramid takes.
    fn tip(&self) -> f64 {
        let slope = self.test.slope().filter(|_| is_pyramid(self.test)).unwrap_or_default();
        self.test.radius() * slope / slope.hypot(1.0) / self.radius
    }

    /// Height of the specimen's surface at the edge of the contact \[mm\].
    pub fn edge_height(&self) -> f64 {
        let surface = &self.load().surface;
        let beyond = surface.iter().position(|[x, _]| *x >= self.edge);
        match beyond.and_then(|k| Some((surface.get(k.checked_sub(1)?)?, surface.get(k)?))) {
            Some(([left, low], [right, high])) => {
                low + (high - low) * (self.edge - left) / (right - left)
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
                let ratio = self.approach_after(self.unloaded()?) / self.approach().0;
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
        let (depth, _) = self.depth();
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
        let Seen { force, stiffness, half_width, .. } = *self.load();
        let (approach, approach_error) = self.approach();
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
            let [slope, deep] = [self.radius_error?, approach_error?];
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
