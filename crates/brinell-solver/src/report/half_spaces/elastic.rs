//! The elastic contact of the same half-spaces, and the load under which it begins to yield.

use brinell_halfspace::EllipticContact;

use crate::analytical::{DepthLimit, HertzEllipse, YieldOnset};
use crate::job::{Analysis, Deformable, Job, Material};
use crate::solver::half_spaces::HalfSpaceProblem;

/// What Hertz's theory says of two half-spaces whatever the force.
#[derive(Debug, Clone)]
pub struct EllipticReference {
    problem: HalfSpaceProblem,
    onset: Option<DepthLimit>,
    rolling: Option<DepthLimit>,
}

/// The engine's problem of a job; `None` of a job that is not in three dimensions.
pub(super) fn problem_of(job: &Job) -> Option<HalfSpaceProblem> {
    let [upper, lower] = [&job.upper, &job.lower].map(|body| body.shape.curvatures());
    let (upper, lower) = (upper?, lower?);
    let material = |material: &Material| match material {
        Material::Rigid => None,
        Material::Deformable(material) => Some(material.clone()),
    };
    (job.analysis == Analysis::ThreeDimensional).then(|| HalfSpaceProblem {
        materials: [material(&job.upper.material), material(&job.lower.material)],
        curvature: std::array::from_fn(|k| upper[k] + lower[k]),
        load: job.load.clone(),
        cells_per_semi_axis: job.mesh.elements_per_half_width,
        solver: job.solver,
    })
}

impl EllipticReference {
    /// The reference for a job; `None` if it is not in three dimensions.
    pub fn of(job: &Job) -> Option<Self> {
        let problem = problem_of(job)?;
        let unit = problem.hertz(1.0);
        let ellipse = HertzEllipse { axis_ratio: unit.semi_axis_x / unit.semi_axis_y };
        let half_width = unit.semi_axis_x / unit.peak_pressure;
        let least = |limit: fn(&Deformable, HertzEllipse, f64) -> Option<DepthLimit>| {
            let bodies = problem.materials.iter().flatten();
            let limits = bodies.filter_map(|material| limit(material, ellipse, half_width));
            limits.min_by(|a, b| a.peak_pressure.total_cmp(&b.peak_pressure))
        };
        let (onset, rolling) = (least(onset), least(rolling));
        // The closed forms know of no stress before the load.
        let is_stressed = problem.materials.iter().flatten().any(|body| !body.initial_stress().is_empty());
        Some(Self { onset: onset.filter(|_| !is_stressed), rolling, problem })
    }

    /// The contact under a force \[N\].
    pub fn under(&self, force: f64) -> EllipticContact {
        self.problem.hertz(force)
    }

    /// Force under which a body begins to yield \[N\]; `None` where none has a yield stress, or one has a stress before the load.
    pub fn onset_force(&self) -> Option<f64> {
        let unit = self.problem.hertz(1.0).peak_pressure;
        self.onset.map(|limit| (limit.peak_pressure / unit).powi(3))
    }

    /// Depth at which it does \[mm\].
    pub fn onset_depth(&self) -> Option<f64> {
        self.onset.map(|limit| limit.depth)
    }

    /// The most that a contact bears which rolls along its shorter semi-axis without yielding in every passage; `None` where no
    /// body has a yield stress.
    pub const fn rolling(&self) -> Option<DepthLimit> {
        self.rolling
    }

    /// Radius of a ball with the mean curvature of the gap \[mm\].
    pub fn effective_radius(&self) -> f64 {
        2.0 / self.problem.principal_curvatures().iter().sum::<f64>()
    }

    /// dP/dα of elastic bodies that touch within an ellipse of a longer semi-axis `b` and an axis ratio `a/b` \[N/mm\]:
    /// `π E* b/K(√(1 - (a/b)²))`, the stiffness of a flat punch of this outline.
    ///
    /// # Reference
    /// K. L. Johnson, *Contact Mechanics* (1985), section 3.5.
    pub fn stiffness(&self, [a, b]: [f64; 2]) -> f64 {
        let (short, long) = (a.min(b), a.max(b));
        if short <= 0.0 {
            return 0.0;
        }
        let (mut mean, mut root) = (1.0_f64, short / long);
        // K by the arithmetic-geometric mean.
        while (mean - root).abs() > 1e-15 * mean {
            (mean, root) = (0.5 * (mean + root), (mean * root).sqrt());
        }
        2.0 * self.problem.effective_modulus() * long * mean
    }
}

/// The yield stress of a body that has one.
fn yield_stress(material: &Deformable) -> Option<f64> {
    material.hardening_law().map(|law| law.yield_stress()).filter(|stress| *stress > 0.0)
}

/// Where a body yields in every passage; `half_width` is the shorter semi-axis of a unit peak pressure.
fn rolling(material: &Deformable, ellipse: HertzEllipse, half_width: f64) -> Option<DepthLimit> {
    let yield_stress = yield_stress(material)?;
    Some(material.strength().map_or_else(
        || DepthLimit::uniform_ellipse_rolling(ellipse, half_width, yield_stress),
        |strength| {
            DepthLimit::ellipse_rolling(ellipse, half_width, |depth| yield_stress * strength.factor(depth))
        },
    ))
}

/// Where a body first yields; `half_width` is the shorter semi-axis of a unit peak pressure.
fn onset(material: &Deformable, ellipse: HertzEllipse, half_width: f64) -> Option<DepthLimit> {
    let yield_stress = yield_stress(material)?;
    let poisson_ratio = material.elastic().poisson_ratio.get();
    if let Some(strength) = material.strength() {
        let over_depth = |depth: f64| yield_stress * strength.factor(depth);
        return Some(DepthLimit::ellipse_onset(ellipse, poisson_ratio, half_width, over_depth));
    }
    let onset = YieldOnset::ellipse(ellipse, poisson_ratio);
    let peak_pressure = onset.pressure_ratio * yield_stress;
    Some(DepthLimit { peak_pressure, depth: onset.depth_ratio * half_width * peak_pressure })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn the_stiffness_of_a_circle_is_that_of_a_round_punch() {
        let job = br#"{"analysis": "three_dimensional",
            "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
            "lower": {"shape": {"type": "flat"}, "material": {"young_modulus": 210000, "poisson_ratio": 0.3,
                "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 0}}},
            "load": {"force": 100}}"#;
        let reference = EllipticReference::of(&Job::from_json(job).unwrap()).unwrap();
        let modulus = 210_000.0 / 0.91;
        assert!((reference.stiffness([0.2, 0.2]) / (2.0 * modulus * 0.2) - 1.0).abs() < 1e-14);
        // p0 = 1.613 σ_y at the onset, P = π³ R² p0³/(6 E*²).
        let force = PI.powi(3) * 100.0 * (1.6132 * 500.0f64).powi(3) / (6.0 * modulus * modulus);
        assert!((reference.onset_force().unwrap() / force - 1.0).abs() < 1e-3);
        // The tangent of Hertz's curve.
        let [before, here, after] = [99.0, 100.0, 101.0].map(|force| reference.under(force));
        let slope = 2.0 / (after.approach - before.approach);
        assert!((reference.stiffness([here.semi_axis_x, here.semi_axis_y]) / slope - 1.0).abs() < 1e-4);
    }
}
