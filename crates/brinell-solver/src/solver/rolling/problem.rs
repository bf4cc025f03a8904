//! The input of a line contact that rolls.

use std::sync::Arc;

use brinell_halfspace::Layers;
use brinell_halfspace::track::TrackFault;
use brinell_material::{StreamLaw, StreamOfLayers};

use crate::analytical::{DepthLimit, HertzLine};
use crate::job::{Deformable, InitialStressProfile, Job, Load, Rolling, SolverSettings};
use crate::material::{
    BackstressTerm, ElasticModuli, FlowPlasticity, OutOfPlane, ReturnMapping, scaled,
};
use crate::solver::SolveError;
use crate::solver::problem::Problem;

/// Two bodies, the radius of the gap between them, and the load that rolls.
#[derive(Debug, Clone)]
pub struct RollingProblem {
    /// Upper and lower body; `None` for a rigid body. At least one body deforms.
    pub materials: [Option<Deformable>; 2],
    /// Radius of the gap, the reciprocal of the sum of both curvatures \[mm\].
    pub radius: f64,
    /// Force, friction and passes.
    pub load: Rolling,
    /// Columns over the elastic half-width.
    pub columns: usize,
    /// Coupling, tolerance and iteration limit.
    pub solver: SolverSettings,
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
    /// The problem of a job.
    ///
    /// # Errors
    /// [`SolveError::NoTrack`]: the load does not roll, or the surfaces do not open as one arc
    /// from where they touch.
    pub fn of(job: &Job) -> Result<Self, SolveError> {
        let Load::Rolling(load) = job.load else { return Err(SolveError::NoTrack) };
        let problem = Problem::of(job);
        let curvature = problem.curvature().filter(|_| problem.conforming.is_none());
        let radius = curvature.map(f64::recip).filter(|radius| *radius > 0.0);
        Ok(Self {
            materials: problem.bodies.map(|body| body.material),
            radius: radius.filter(|radius| radius.is_finite()).ok_or(SolveError::NoTrack)?,
            load,
            columns: job.mesh.elements_per_half_width as usize,
            solver: job.solver,
        })
    }

    /// The contact modulus E\* \[MPa\], `1/E* = Σ (1 - ν²)/E` over the bodies that deform.
    pub fn effective_modulus(&self) -> f64 {
        let compliance = |material: &Deformable| {
            let elastic = material.elastic();
            (1.0 - elastic.poisson_ratio.get().powi(2)) / elastic.young_modulus.get()
        };
        self.materials.iter().flatten().map(compliance).sum::<f64>().recip()
    }

    /// The contact of elastic bodies.
    pub fn hertz(&self) -> HertzLine {
        HertzLine::new(self.load.force.get(), self.radius, self.effective_modulus())
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
    pub fn yielding(&self) -> impl Iterator<Item = (usize, &Deformable)> {
        let sides = self.materials.iter().enumerate().take(if self.is_shared() { 1 } else { 2 });
        sides.filter_map(|(side, material)| {
            let material = material.as_ref()?;
            material.hardening_law().map(|_| (side, material))
        })
    }

    /// Checks that the surfaces bear the traction under the pressure of Hertz.
    ///
    /// # Errors
    /// [`SolveError::Track`].
    pub fn bears(&self) -> Result<(), SolveError> {
        let traction = self.load.friction.abs() * self.hertz().peak_pressure();
        for (_, material) in self.yielding() {
            let Some(law) = law_of_layers(material, &[0.0]) else { continue };
            let strength = law.largest_stress(0) / 3f64.sqrt();
            if traction > strength {
                return Err(SolveError::Track(TrackFault::Traction { traction, strength }));
            }
        }
        Ok(())
    }

    /// The limit of shakedown of perfectly plastic bodies in closed form; `None` where no body
    /// yields.
    pub fn perfect_limit(&self) -> Option<Limit> {
        let half_width = 2.0 * self.radius / self.effective_modulus();
        let of_body = |(side, material): (usize, &Deformable)| {
            let yield_stress =
                Some(material.hardening_law()?.yield_stress()).filter(|limit| *limit > 0.0)?;
            let strength = material.strength();
            let limit = DepthLimit::sliding(self.load.friction.abs(), half_width, |depth| {
                yield_stress * strength.as_ref().map_or(1.0, |strength| strength.factor(depth))
            });
            Some(Limit { peak_pressure: limit.peak_pressure, depth: limit.depth, side })
        };
        let limits = self.yielding().filter_map(of_body);
        limits.min_by(|a, b| a.peak_pressure.total_cmp(&b.peak_pressure))
    }

    /// `σ_y/E` of a body; of a curve without a yield point by its nominal yield stress.
    pub(super) fn yield_strain(material: &Deformable) -> f64 {
        let stress = material.hardening_law().map_or(0.0, |law| law.nominal_yield_stress());
        stress / material.elastic().young_modulus.get()
    }
}

/// The plastic law of layers at these depths, if the material can yield. Each has the strength at
/// its depth.
pub(super) fn law_of_layers(material: &Deformable, depths: &[f64]) -> Option<Box<dyn StreamLaw>> {
    let curve = material.hardening_law()?;
    // The number of terms is a type parameter, as in the cells of three dimensions.
    Some(match *material.backstress() {
        [] => of_terms(material, &curve, depths, []),
        [a] => of_terms(material, &curve, depths, [a].each_ref().map(BackstressTerm::from)),
        [a, b] => of_terms(material, &curve, depths, [a, b].each_ref().map(BackstressTerm::from)),
        [a, b, c] => {
            of_terms(material, &curve, depths, [a, b, c].each_ref().map(BackstressTerm::from))
        }
        [a, b, c, d, ..] => {
            of_terms(material, &curve, depths, [a, b, c, d].each_ref().map(BackstressTerm::from))
        }
    })
}

fn of_terms<const N: usize>(
    material: &Deformable,
    curve: &Arc<dyn crate::material::HardeningLaw>,
    depths: &[f64],
    backstress: [BackstressTerm; N],
) -> Box<dyn StreamLaw> {
    let elastic = ElasticModuli::from(material.elastic());
    let strength = material.strength();
    let of_layer = |depth: &f64| {
        let factor = strength.as_ref().map_or(1.0, |strength| strength.factor(*depth));
        let mapping = ReturnMapping::new(scaled(curve, factor), elastic.shear);
        Arc::new(FlowPlasticity::new(elastic, mapping, backstress, OutOfPlane::Strained))
    };
    Box::new(StreamOfLayers::new(depths.iter().map(of_layer).collect()))
}

/// σxx along the travel and σyy across it in each layer before any load \[MPa\].
pub(super) fn initial_stress(material: &Deformable, layers: &Layers) -> Vec<[f64; 2]> {
    let profile = InitialStressProfile::new(material.initial_stress());
    (0..layers.len()).map(|layer| profile.at(layers.middle(layer))).collect()
}
