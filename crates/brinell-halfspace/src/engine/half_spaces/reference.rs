//! The elastic reference of a contact of half-spaces, and the load at its onset of yield.

use crate::{EllipticContact, SurfaceFlexibility, SurfaceGrid};
use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolver as _, never,
};

use super::gap::RollerGap;
use super::problem::HalfSpaceProblem;
use super::step::{HalfSpaceStep, SurfaceMap};
use brinell_material::Solid;
use brinell_material::analytical::{DepthLimit, HertzEllipse, YieldOnset, factor_of_onset};

/// Hertz's theory of two half-spaces, for any force.
#[derive(Debug, Clone)]
pub struct EllipticReference {
    problem: HalfSpaceProblem,
    onset: Option<DepthLimit>,
    rolling: Option<DepthLimit>,
}

impl EllipticReference {
    /// Returns the reference for a problem.
    pub fn of(problem: HalfSpaceProblem) -> Self {
        if !problem.has_hertz() {
            return Self { onset: None, rolling: None, problem };
        }
        let unit = problem.hertz(1.0);
        let ellipse = (!problem.is_line(&unit))
            .then_some(HertzEllipse { axis_ratio: unit.semi_axis_x / unit.semi_axis_y });
        let half_width = unit.semi_axis_x / unit.peak_pressure;
        let least = |limit: fn(&Solid, Option<HertzEllipse>, f64) -> Option<DepthLimit>| {
            let bodies = problem.materials.iter().flatten();
            let limits = bodies.filter_map(|material| limit(material, ellipse, half_width));
            limits.min_by(|a, b| a.peak_pressure.total_cmp(&b.peak_pressure))
        };
        let (onset, rolling) = (
            least(|body, ellipse, half_width| onset(body, ellipse, half_width, 1.0)),
            least(rolling),
        );
        // The closed forms neglect stress before the load.
        let is_stressed =
            problem.materials.iter().flatten().any(|body| !body.initial_stress().is_empty());
        // They also neglect that a contact may reach the ends of a roller before it yields.
        let is_alike = |limit: &DepthLimit| {
            let force = problem.force_where(|hertz| hertz.peak_pressure, limit.peak_pressure, 3.0);
            problem.is_line(&problem.hertz(force)) == ellipse.is_none()
        };
        let onset = onset.filter(|limit| !is_stressed && is_alike(limit));
        Self { onset, rolling: rolling.filter(is_alike), problem }
    }

    /// Returns the problem with the force at its onset of yield, where closed forms tell it.
    pub fn with_onset(&self) -> HalfSpaceProblem {
        let problem = &self.problem;
        let onset = self
            .onset_force()
            .filter(|force| problem.heights.is_none() && !problem.is_line(&problem.hertz(*force)));
        HalfSpaceProblem { onset, ..problem.clone() }
    }

    /// Returns the contact under a force \[N\].
    pub fn under(&self, force: f64) -> EllipticContact {
        self.problem.hertz(force)
    }

    /// Returns the gap before loading at the middles of the cells \[mm\].
    pub fn initial_gap(&self, grid: &SurfaceGrid) -> Vec<f64> {
        self.problem.gap(grid)
    }

    /// Returns the force at the onset of yield \[N\]. Returns `None` if no body has a yield
    /// stress, or if Hertz's theory does not apply: to a body with a stress before the load, or to
    /// a roller with a profile or a tilt.
    pub fn onset_force(&self) -> Option<f64> {
        let force = |peak| self.problem.force_where(|hertz| hertz.peak_pressure, peak, 3.0);
        let is_plain = self.problem.rollers.iter().all(RollerGap::is_plain);
        self.onset.filter(|_| is_plain).map(|limit| force(limit.peak_pressure))
    }

    /// Returns the largest von Mises stress of elastic bodies over the yield stress under a force,
    /// its depth \[mm\] and the body: the factor on the yield stresses that makes the force that
    /// of first yield. Returns `None` where [`onset_force`](Self::onset_force) does.
    pub fn utilization(&self, force: f64) -> Option<(f64, f64, usize)> {
        self.onset_force()?;
        let hertz = self.problem.hertz(force);
        let ellipse = (!self.problem.is_line(&hertz))
            .then_some(HertzEllipse { axis_ratio: hertz.semi_axis_x / hertz.semi_axis_y });
        let half_width = hertz.semi_axis_x / hertz.peak_pressure;
        let bodies = self.problem.materials.iter().enumerate();
        let used = bodies.filter_map(|(side, material)| {
            let onset = |factor: f64| onset(material.as_ref()?, ellipse, half_width, factor);
            onset(1.0)?;
            // The force goes with the cube of the peak pressure, or with its square.
            let of_peak = |factor: f64| {
                onset(factor)
                    .map_or((0.0, 0.0), |limit| (limit.peak_pressure.powf(2.5), limit.depth))
            };
            let (factor, depth) = factor_of_onset(of_peak, hertz.peak_pressure.powf(2.5));
            Some((factor, depth, side))
        });
        used.max_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Returns the depth of the onset of yield \[mm\].
    pub fn onset_depth(&self) -> Option<f64> {
        self.onset.map(|limit| limit.depth)
    }

    /// Returns the shakedown limit of a contact that rolls along its shorter semi-axis, or `None`
    /// if no body has a yield stress. Beyond this limit the bodies yield in every passage.
    pub const fn rolling(&self) -> Option<DepthLimit> {
        self.rolling
    }

    /// Returns the reciprocal of the sum of the curvatures of both surfaces along the shorter
    /// semi-axis \[mm\]: of two cylinders and of two balls that of their plane section.
    pub fn effective_radius(&self) -> f64 {
        self.problem.principal_curvatures()[0].recip()
    }

    /// Returns dP/dα of elastic bodies at a constant contact area of the load step \[N/mm\], or 0
    /// without contact.
    pub fn stiffness(&self, step: &HalfSpaceStep) -> f64 {
        let has_outline = self.problem.heights.is_none() && self.problem.rollers.is_empty();
        if has_outline {
            let semi_axes = step.figures.semi_axes();
            self.of_outline(semi_axes) * self.problem.conformity.of_stiffness(semi_axes)
        } else {
            self.of_cells(&step.field.surface)
        }
    }

    /// Returns the stiffness of a flat punch with the shape of the cells in contact: the force
    /// that displaces all these cells by 1.
    fn of_cells(&self, map: &SurfaceMap) -> f64 {
        if map.pressure.iter().all(|pressure| *pressure <= 0.0) {
            return 0.0;
        }
        let flexibility = SurfaceFlexibility::new(map.grid, self.problem.effective_modulus());
        // With a gap of 2 no cell beside the punch comes into contact.
        let initial_gap: Vec<f64> =
            map.pressure.iter().map(|p| if *p > 0.0 { 0.0 } else { 2.0 }).collect();
        let problem = ContactProblem {
            flexibility: &flexibility,
            initial_gap: &initial_gap,
            closing: &vec![1.0; initial_gap.len()],
            load: ContactLoad::Approach(1.0),
        };
        let pressed = ConjugateGradientSolver::new(1e-6).solve(&problem, None, &mut never);
        pressed.map_or(0.0, |pressed| pressed.total_force)
    }

    /// Returns the stiffness of a flat punch with an elliptic outline of the semi-axes `a <= b`:
    /// `π E* b/K(√(1 - (a/b)²))`.
    ///
    /// # Reference
    /// K. L. Johnson, *Contact Mechanics* (1985), section 3.5.
    fn of_outline(&self, [a, b]: [f64; 2]) -> f64 {
        let (short, long) = (a.min(b), a.max(b));
        if short <= 0.0 {
            return 0.0;
        }
        let modulus = self.problem.effective_modulus();
        let (mut mean, mut root) = (1.0_f64, short / long);
        // The arithmetic-geometric mean gives K.
        for _ in 0..40 {
            (mean, root) = (0.5 * (mean + root), (mean * root).sqrt());
        }
        2.0 * modulus * long * mean
    }
}

/// Returns peak pressure and depth at the shakedown limit of a body. `half_width` is the shorter
/// semi-axis at a unit peak pressure. Without an ellipse the contact is a line contact.
fn rolling(
    material: &Solid,
    ellipse: Option<HertzEllipse>,
    half_width: f64,
) -> Option<DepthLimit> {
    let yield_stress = material.yield_stress()?;
    let strength = material.strength();
    let over_depth = |depth: f64| yield_stress * strength.map_or(1.0, |s| s.factor(depth));
    Some(match (ellipse, strength.is_some()) {
        (Some(ellipse), true) => DepthLimit::ellipse_rolling(ellipse, half_width, over_depth),
        (Some(ellipse), false) => {
            DepthLimit::uniform_ellipse_rolling(ellipse, half_width, yield_stress)
        }
        (None, true) => DepthLimit::rolling(half_width, over_depth),
        (None, false) => DepthLimit::uniform_rolling(half_width, yield_stress),
    })
}

/// Returns peak pressure and depth at the onset of yield of a body. `half_width` is the shorter
/// semi-axis at a unit peak pressure. Without an ellipse the contact is a line contact. `factor`
/// multiplies the yield stress.
fn onset(
    material: &Solid,
    ellipse: Option<HertzEllipse>,
    half_width: f64,
    factor: f64,
) -> Option<DepthLimit> {
    let yield_stress = factor * material.yield_stress()?;
    let poisson_ratio = material.elastic().poisson_ratio;
    if let Some(strength) = material.strength() {
        let over_depth = |depth: f64| yield_stress * strength.factor(depth);
        return Some(match ellipse {
            Some(ellipse) => {
                DepthLimit::ellipse_onset(ellipse, poisson_ratio, half_width, over_depth)
            }
            None => DepthLimit::line_onset(poisson_ratio, half_width, over_depth),
        });
    }
    let onset = ellipse.map_or_else(
        || YieldOnset::line_von_mises(poisson_ratio),
        |ellipse| YieldOnset::ellipse(ellipse, poisson_ratio),
    );
    let peak_pressure = onset.pressure_ratio * yield_stress;
    Some(DepthLimit { peak_pressure, depth: onset.depth_ratio * half_width * peak_pressure })
}

#[cfg(test)]
mod tests {
    use crate::engine::half_spaces::Conformity;
    use std::f64::consts::PI;
    use std::sync::Arc;

    use super::*;
    use brinell_material::analytical::ElasticConstants;
    use brinell_material::hardening::StraightLine;
    use brinell_method::settings::Settings;
    use brinell_method::sought::Loads;

    #[test]
    fn the_stiffness_of_a_circle_is_that_of_a_round_punch() {
        let elastic = ElasticConstants { young_modulus: 210_000.0, poisson_ratio: 0.3 };
        let law = StraightLine { yield_stress: 500.0, plastic_modulus: 0.0 };
        let reference = EllipticReference::of(HalfSpaceProblem {
            materials: [None, Some(Solid::new(elastic).with_hardening(Arc::new(law)))],
            curvature: [0.1, 0.1, 0.0],
            conformity: Conformity::default(),
            rollers: Vec::new(),
            heights: None,
            loads: Loads::Each(vec![ContactLoad::Force(100.0)]),
            cells_per_semi_axis: 10,
            cells_of_slopes: None,
            onset: None,
            solver: Settings::default(),
        });
        let modulus = 210_000.0 / 0.91;
        assert!((reference.of_outline([0.2, 0.2]) / (2.0 * modulus * 0.2) - 1.0).abs() < 1e-14);
        // At the onset p0 = 1.613 σ_y and P = π³ R² p0³/(6 E*²).
        let force = PI.powi(3) * 100.0 * (1.6132 * 500.0f64).powi(3) / (6.0 * modulus * modulus);
        assert!((reference.onset_force().unwrap() / force - 1.0).abs() < 1e-3);
        // The tangent of Hertz's curve.
        let [before, here, after] = [99.0, 100.0, 101.0].map(|force| reference.under(force));
        let slope = 2.0 / (after.approach - before.approach);
        assert!(
            (reference.of_outline([here.semi_axis_x, here.semi_axis_y]) / slope - 1.0).abs()
                < 1e-4
        );
    }
}
