//! The input of a contact that rolls.

use crate::track::{DEEPEST, Frame as _, LENGTH_OF_ELLIPSE, LENGTH_OF_LINE, TrackFault};
use crate::{EllipticContact, Layers};
use brinell_material::{StreamLaw, TrackFrame};

use super::error::TrackError;
use crate::engine::half_spaces::{HalfSpaceProblem, Relief, RollerGap};
use brinell_material::Solid;
use brinell_material::analytical::{DepthLimit, HertzEllipse, HertzLine};
use brinell_method::settings::Settings;

/// Curvature that couples both axes over the sum of the curvatures, and sine of a rotation, below
/// which a contact lies along the travel.
const ALIGNED: f64 = 1e-9;
/// Curvature across the travel over that along it below which a contact is as good as a line, and
/// the reverse.
const LONGEST: f64 = 1e-3;

/// The gap between the undeformed bodies.
#[derive(Debug, Clone, PartialEq)]
pub enum Footprint {
    /// A line across the travel: the reciprocal of the sum of both curvatures \[mm\].
    Line {
        /// Radius of the gap.
        radius: f64,
    },
    /// An ellipse whose axes lie along and across the travel.
    Ellipse {
        /// Sums of both curvatures along and across the travel \[1/mm\].
        curvatures: [f64; 2],
        /// Ends and relief of rollers whose axes lie across the travel.
        rollers: Vec<RollerGap>,
    },
}

/// A contact that passes over its track again and again, in the direction of x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingLoad {
    /// Force \[N/mm of a line, N\].
    pub force: f64,
    /// Passes at most.
    pub passes: u32,
    /// Whether the passes end as soon as three of them running agree on a verdict.
    pub ends_at_verdict: bool,
    /// Traction over pressure, positive where the traction on the lower body acts along the
    /// travel.
    pub friction: f64,
    /// Whether every second pass goes back.
    pub alternating: bool,
    /// Length of the track over the elastic semi-axis along the travel; `None` for the default.
    pub track: Option<f64>,
    /// How bodies harden that have no backstress.
    pub hardening: HardeningRules,
}

/// How bodies harden whose curve says nothing of a load that turns round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum HardeningRules {
    /// Isotropically as given, and once more kinematically with the same uniaxial curve.
    #[default]
    Both,
    /// Isotropically.
    Isotropic,
    /// Kinematically with the same uniaxial curve.
    Kinematic,
}

/// Two bodies, the gap between them, and the load that rolls.
#[derive(Debug, Clone)]
pub struct RollingProblem {
    /// Upper and lower body; `None` for a rigid body. At least one body deforms.
    pub materials: [Option<Solid>; 2],
    /// The gap between the undeformed bodies.
    pub footprint: Footprint,
    /// Force, friction and passes.
    pub load: RollingLoad,
    /// Columns over the elastic half-width, cells over each semi-axis.
    pub columns: usize,
    /// Coupling, tolerance and iteration limit.
    pub solver: Settings,
}

/// An elastic peak pressure up to which a track shakes down, and what decides on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// Peak pressure by Hertz \[MPa\].
    pub peak_pressure: f64,
    /// Depth that decides \[mm\].
    pub depth: f64,
    /// The body, 0 for the upper one.
    pub side: usize,
}

impl RollingProblem {
    /// The problem of lines in plane strain whose surfaces open with a curvature \[1/mm\].
    ///
    /// # Errors
    /// [`TrackError::NoTrack`]: the surfaces do not open as one arc from where they touch.
    pub fn of_lines(
        materials: [Option<Solid>; 2],
        curvature: Option<f64>,
        load: RollingLoad,
        (columns, solver): (usize, Settings),
    ) -> Result<Self, TrackError> {
        let radius = curvature.map(f64::recip).filter(|radius| *radius > 0.0);
        Ok(Self {
            materials,
            footprint: Footprint::Line {
                radius: radius.filter(|radius| radius.is_finite()).ok_or(TrackError::NoTrack)?,
            },
            load,
            columns,
            solver,
        })
    }

    /// The contact modulus E\* \[MPa\], `1/E* = Σ (1 - ν²)/E` over the bodies that deform.
    pub fn effective_modulus(&self) -> f64 {
        let compliance = |material: &Solid| {
            let elastic = material.elastic();
            (1.0 - elastic.poisson_ratio.powi(2)) / elastic.young_modulus
        };
        self.materials.iter().flatten().map(compliance).sum::<f64>().recip()
    }

    /// The problem of half-spaces in three dimensions over which a load rolls along x.
    ///
    /// # Errors
    /// [`TrackError::NoRaceway`]: the surfaces do not open as an ellipse whose axes lie along and
    /// across the travel.
    pub fn of_half_spaces(
        shapes: &HalfSpaceProblem,
        load: RollingLoad,
    ) -> Result<Self, TrackError> {
        let [along, across, mixed] = shapes.curvature;
        let rollers = &shapes.rollers;
        let refuse = |reason: &'static str| Err(TrackError::NoRaceway(reason));
        if shapes.heights.is_some() {
            return refuse("surfaces with heights of their own do not roll");
        }
        if mixed.abs() > ALIGNED * (along + across) {
            return refuse(
                "the axes of the contact have to lie along x, the direction of travel, and along y",
            );
        }
        if rollers.iter().any(|roller| roller.rotation.sin().abs() > ALIGNED) {
            return refuse("a roller rolls across its axis, which has to lie along y");
        }
        if !rollers.iter().all(RollerGap::is_even) {
            return refuse("both sides of a track have to be alike: no roller tilts");
        }
        if rollers.iter().any(|roller| !matches!(roller.relief, Relief::Straight)) {
            return refuse(
                "a roller rolls with a crown radius, or straight with the analysis \
                 \"plane_strain\"; no other profile rolls",
            );
        }
        if across <= LONGEST * along || along <= LONGEST * across {
            return refuse(
                "both curvatures of the gap, along the travel and across it, have to be more than \
                 a thousandth of each other; lines roll with the analysis \"plane_strain\"",
            );
        }
        let problem = Self {
            materials: shapes.materials.clone(),
            footprint: Footprint::Ellipse {
                curvatures: [along, across],
                rollers: rollers.clone(),
            },
            load,
            columns: shapes.cells_per_semi_axis as usize,
            solver: shapes.solver,
        };
        let [_, b] = problem.semi_axes();
        if rollers.iter().any(|roller| 2.0 * b >= roller.length) {
            return refuse("the ellipse has to end on the roller: it is longer than the roller");
        }
        Ok(problem)
    }

    /// The problem with kinematic hardening of the same uniaxial curves; `None` where no body
    /// hardens isotropically.
    pub fn hardening_kinematically(&self) -> Option<Self> {
        let other = |material: &Option<Solid>| material.as_ref()?.hardening_kinematically();
        let others = self.materials.each_ref().map(other);
        let is_changed = others.iter().any(Option::is_some);
        let materials = others.into_iter().zip(&self.materials);
        let mut materials = materials.map(|(other, given)| other.or_else(|| given.clone()));
        let materials = [materials.next().flatten(), materials.next().flatten()];
        is_changed.then(|| Self { materials, ..self.clone() })
    }

    /// Whether the contact is a line.
    pub const fn is_line(&self) -> bool {
        matches!(self.footprint, Footprint::Line { .. })
    }

    /// The gap at a place \[mm\].
    pub fn gap(&self, x: f64, y: f64) -> f64 {
        match &self.footprint {
            Footprint::Line { radius } => x * x / (2.0 * radius),
            Footprint::Ellipse { curvatures: [kx, ky], rollers } => {
                let falls: f64 = rollers.iter().map(|roller| roller.fall([x, y])).sum();
                0.5 * (kx * x * x + ky * y * y) + falls
            }
        }
    }

    /// Length of the track over the elastic semi-axis along the travel.
    pub fn length(&self) -> f64 {
        let default = if self.is_line() { LENGTH_OF_LINE } else { LENGTH_OF_ELLIPSE };
        self.load.track.unwrap_or(default)
    }

    /// Semi-axes of the contact of elastic bodies along and across the travel \[mm\]; of a line
    /// its half-width twice.
    pub fn semi_axes(&self) -> [f64; 2] {
        match self.elastic() {
            Elastic::Line(hertz) => [hertz.half_width(); 2],
            Elastic::Ellipse(hertz) => [hertz.semi_axis_x, hertz.semi_axis_y],
        }
    }

    /// Peak pressure of elastic bodies \[MPa\].
    pub fn elastic_peak(&self) -> f64 {
        match self.elastic() {
            Elastic::Line(hertz) => hertz.peak_pressure(),
            Elastic::Ellipse(hertz) => hertz.peak_pressure,
        }
    }

    /// The contact of elastic bodies.
    fn elastic(&self) -> Elastic {
        let (force, modulus) = (self.load.force, self.effective_modulus());
        match self.footprint {
            Footprint::Line { radius } => Elastic::Line(HertzLine::new(force, radius, modulus)),
            Footprint::Ellipse { curvatures: [kx, ky], .. } => {
                let [rx, ry] = [kx.recip(), ky.recip()];
                Elastic::Ellipse(EllipticContact::new(rx, ry, modulus, force))
            }
        }
    }

    /// Traction in the direction of travel over pressure, on the upper and on the lower body.
    pub fn frictions(&self) -> [f64; 2] {
        [-self.load.friction, self.load.friction]
    }

    /// Whether one body stands for both: equal bodies that roll freely.
    pub fn is_shared(&self) -> bool {
        self.load.friction == 0.0
            && self.materials[0].is_some()
            && self.materials[0] == self.materials[1]
    }

    /// The bodies that can yield, with their side; only the first of two that share one.
    pub fn yielding(&self) -> impl Iterator<Item = (usize, &Solid)> {
        let sides = self.materials.iter().enumerate().take(if self.is_shared() { 1 } else { 2 });
        sides.filter_map(|(side, material)| {
            let material = material.as_ref()?;
            material.hardening_law().map(|_| (side, material))
        })
    }

    /// Checks that the surfaces bear the traction under the pressure of Hertz, and that it is not too
    /// far beyond yield.
    ///
    /// # Errors
    /// [`TrackError::Track`].
    pub fn bears(&self) -> Result<(), TrackError> {
        let traction = self.load.friction.abs() * self.elastic_peak();
        for (_, material) in self.yielding() {
            let law: Option<Box<dyn StreamLaw>> = TrackFrame::law(material, &[0.0], 1);
            let Some(law) = law else { continue };
            TrackFault::require_strength(&*law, traction).map_err(TrackError::Track)?;
        }
        let solids = [0, 1].map(|side| self.materials[side].as_ref());
        let peak = self.elastic_peak();
        match Solid::over_yield_stress(solids, peak) {
            Some(ratio) if ratio > DEEPEST => {
                // Hertz's peak grows with the root of the force of a line, the cubic root of an
                // ellipse.
                let power = if self.is_line() { 2 } else { 3 };
                Err(TrackError::Track(TrackFault::Deep {
                    peak,
                    yield_stress: peak / ratio,
                    force: self.load.force * (DEEPEST / ratio).powi(power),
                }))
            }
            _ => Ok(()),
        }
    }

    /// The limit of shakedown of perfectly plastic bodies in closed form; `None` where no body
    /// yields, and of an ellipse that slides or is longer along the travel than across it.
    pub fn perfect_limit(&self) -> Option<Limit> {
        let friction = self.load.friction.abs();
        let of_body = |(side, material): (usize, &Solid)| {
            let yield_stress = material.yield_stress()?;
            let strength = material.strength();
            let over_depth = |depth: f64| {
                yield_stress * strength.map_or(1.0, |strength| strength.factor(depth))
            };
            let limit = match self.elastic() {
                Elastic::Line(_) => {
                    let half_width = 2.0 * self.radius() / self.effective_modulus();
                    DepthLimit::sliding(friction, half_width, over_depth)
                }
                Elastic::Ellipse(hertz) => {
                    let axis_ratio = hertz.semi_axis_x / hertz.semi_axis_y;
                    if friction > 0.0 || axis_ratio > 1.0 + ALIGNED {
                        return None;
                    }
                    let half_width = hertz.semi_axis_x / hertz.peak_pressure;
                    let ellipse = HertzEllipse { axis_ratio: axis_ratio.min(1.0) };
                    DepthLimit::ellipse_rolling(ellipse, half_width, over_depth)
                }
            };
            Some(Limit { peak_pressure: limit.peak_pressure, depth: limit.depth, side })
        };
        let limits = self.yielding().filter_map(of_body);
        limits.min_by(|a, b| a.peak_pressure.total_cmp(&b.peak_pressure))
    }

    /// The smaller radius of the gap \[mm\].
    pub fn smallest_radius(&self) -> f64 {
        match self.footprint {
            Footprint::Line { radius } => radius,
            Footprint::Ellipse { curvatures: [along, across], .. } => along.max(across).recip(),
        }
    }

    /// Slope of the gap along the travel at the end of the elastic contact.
    pub(super) fn slope(&self) -> f64 {
        self.semi_axes()[0] / self.radius()
    }

    /// Radius of the gap along the travel \[mm\].
    fn radius(&self) -> f64 {
        match self.footprint {
            Footprint::Line { radius } => radius,
            Footprint::Ellipse { curvatures: [along, _], .. } => along.recip(),
        }
    }

    /// `σ_y/E` of a body; of a curve without a yield point by its nominal yield stress.
    pub(super) fn yield_strain(material: &Solid) -> f64 {
        let stress = material.hardening_law().map_or(0.0, |law| law.nominal_yield_stress());
        stress / material.elastic().young_modulus
    }
}

/// The contact of elastic bodies.
enum Elastic {
    Line(HertzLine),
    Ellipse(EllipticContact),
}

/// σxx along the travel and σyy across it in each layer before any load \[MPa\].
pub(super) fn initial_stress(material: &Solid, layers: &Layers) -> Vec<[f64; 2]> {
    let profile = material.initial_stress();
    (0..layers.len()).map(|layer| profile.at(layers.middle(layer))).collect()
}
