//! The elastic contact of the same bodies in closed form.

use std::f64::consts::PI;

use crate::element::StressState;
use crate::engine::problem::{Problem, ProblemBody};
use brinell_material::analytical::{
    DepthLimit, HertzLine, HertzPoint, YieldOnset, factor_of_onset,
};

/// Hertz's contact and the onset of yield.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticReference {
    /// Half-width, or contact radius \[mm\].
    pub half_width: f64,
    /// Peak pressure \[MPa\].
    pub peak_pressure: f64,
    /// Effective radius \[mm\].
    pub effective_radius: f64,
    /// Force at which the first body begins to yield \[N/mm, or N in axisymmetry\]; `None` if none
    /// has a yield stress.
    pub yield_onset_force: Option<f64>,
    /// Depth at which it does \[mm\].
    pub yield_onset_depth: Option<f64>,
    /// Elastic shakedown limit of a line contact that rolls freely, in plane strain; `None` where
    /// no body yields.
    pub rolling_limit: Option<DepthLimit>,
}

impl ElasticReference {
    /// The reference for two bodies under a force \[N/mm, or N in axisymmetry\]; `None` where
    /// Hertz's theory does not apply: a pin in its hole, surfaces that are no arcs or do not open
    /// away from the origin.
    pub fn of(problem: &Problem, force: f64) -> Option<Self> {
        if problem.conforming.is_some() {
            return None;
        }
        let (curvature, modulus) = (problem.curvature()?, problem.effective_modulus());
        if curvature <= 0.0 || !modulus.is_finite() {
            return None;
        }
        let radius = curvature.recip();
        // The closed forms know of no stress before the load.
        let is_stressed = problem.bodies.iter().any(|body| body.initial_stress.is_some());
        let yielding = || problem.bodies.iter().filter(|_| !is_stressed);
        let onset = |body: &ProblemBody| onset(problem.stress_state, body, radius, modulus, 1.0);
        let first = yielding().filter_map(onset).min_by(|a, b| a.0.total_cmp(&b.0));
        let rolling =
            |body: &ProblemBody| rolling_limit(problem.stress_state, body, radius, modulus);
        let rolling_limit = yielding().filter_map(rolling);
        let (half_width, peak_pressure) = contact(problem.stress_state, force, radius, modulus);
        Some(Self {
            half_width,
            peak_pressure,
            effective_radius: radius,
            yield_onset_force: first.map(|(force, _)| force),
            yield_onset_depth: first.map(|(_, depth)| depth),
            rolling_limit: rolling_limit
                .min_by(|a, b| a.peak_pressure.total_cmp(&b.peak_pressure)),
        })
    }
}

impl ElasticReference {
    /// The elastic shakedown limit of a line contact for several frictions, of both bodies the
    /// lower; empty where there is no [`Self::rolling_limit`].
    pub fn limits_over_friction(&self, problem: &Problem) -> Vec<(f64, DepthLimit)> {
        if self.rolling_limit.is_none() {
            return Vec::new();
        }
        let half_width = 2.0 * self.effective_radius / problem.effective_modulus();
        let bodies = problem.bodies.iter().filter_map(|body| sliding_limits(body, half_width));
        let lower = |(friction, one): (f64, DepthLimit), other: DepthLimit| {
            (friction, if other.peak_pressure < one.peak_pressure { other } else { one })
        };
        bodies
            .reduce(|one, two| {
                one.into_iter().zip(two).map(|(one, (_, two))| lower(one, two)).collect()
            })
            .unwrap_or_default()
    }
}

/// The largest von Mises stress of elastic bodies over the yield stress under a force, its place
/// `[x, depth]` \[mm\] and the body, by Hertz's theory: the factor on both yield stresses that
/// makes the force that of first yield. `None` where [`ElasticReference::of`] has no onset of
/// yield.
pub fn elastic_utilization(problem: &Problem, force: f64) -> Option<(f64, [f64; 2], usize)> {
    let (curvature, modulus) = (problem.curvature()?, problem.effective_modulus());
    if problem.bodies.iter().any(|body| body.initial_stress.is_some()) {
        return None;
    }
    let radius = curvature.recip();
    let of_body = |body: &ProblemBody| {
        let onset = |factor: f64| onset(problem.stress_state, body, radius, modulus, factor);
        onset(1.0)?;
        Some(factor_of_onset(|factor| onset(factor).unwrap_or_default(), force))
    };
    let bodies = problem.bodies.iter().enumerate();
    let used = bodies.filter_map(|(side, body)| Some((of_body(body)?, side)));
    let ((ratio, depth), side) = used.max_by(|a, b| a.0.0.total_cmp(&b.0.0))?;
    Some((ratio, [0.0, depth], side))
}

/// Half-width and peak pressure.
fn contact(stress_state: StressState, force: f64, radius: f64, modulus: f64) -> (f64, f64) {
    match stress_state {
        StressState::PlaneStrain | StressState::PlaneStress => {
            let hertz = HertzLine::new(force, radius, modulus);
            (hertz.half_width(), hertz.peak_pressure())
        }
        StressState::Axisymmetric => {
            let hertz = HertzPoint::new(force, radius, modulus);
            (hertz.contact_radius(), hertz.peak_pressure())
        }
    }
}

/// The pressure up to which a line contact shakes down under a body that rolls.
fn rolling_limit(
    stress_state: StressState,
    body: &ProblemBody,
    radius: f64,
    modulus: f64,
) -> Option<DepthLimit> {
    let yield_stress = body.yield_stress().filter(|_| stress_state == StressState::PlaneStrain)?;
    let half_width = 2.0 * radius / modulus;
    Some(match body.material.as_ref()?.strength() {
        Some(strength) => {
            DepthLimit::rolling(half_width, |depth| yield_stress * strength.factor(depth))
        }
        None => DepthLimit::uniform_rolling(half_width, yield_stress),
    })
}

/// The pressures up to which a line contact shakes down over friction; `half_width` is that of a
/// unit peak pressure \[mm/MPa\].
fn sliding_limits(body: &ProblemBody, half_width: f64) -> Option<Vec<(f64, DepthLimit)>> {
    let yield_stress = body.yield_stress()?;
    Some(match body.material.as_ref()?.strength() {
        Some(strength) => {
            let at = |depth: f64| yield_stress * strength.factor(depth);
            DepthLimit::over_friction(half_width, at).collect()
        }
        None => DepthLimit::uniform_over_friction(half_width, yield_stress).collect(),
    })
}

/// Force and depth at which a body begins to yield, with a factor on its yield stress.
fn onset(
    stress_state: StressState,
    body: &ProblemBody,
    radius: f64,
    modulus: f64,
    factor: f64,
) -> Option<(f64, f64)> {
    let material = body.material.as_ref()?;
    let yield_stress = factor * body.hardening()?.yield_stress();
    if yield_stress <= 0.0 {
        return None;
    }
    let poisson_ratio = material.elastic().poisson_ratio;
    if let Some(strength) = material.strength() {
        let yield_stress = |depth: f64| yield_stress * strength.factor(depth);
        let limit = match stress_state {
            StressState::PlaneStrain => {
                DepthLimit::line_onset(poisson_ratio, 2.0 * radius / modulus, yield_stress)
            }
            StressState::PlaneStress => {
                DepthLimit::line_onset(0.0, 2.0 * radius / modulus, yield_stress)
            }
            StressState::Axisymmetric => {
                DepthLimit::point_onset(poisson_ratio, 0.5 * PI * radius / modulus, yield_stress)
            }
        };
        let force = match stress_state {
            StressState::PlaneStrain | StressState::PlaneStress => {
                HertzLine::from_peak_pressure(limit.peak_pressure, radius, modulus).force()
            }
            StressState::Axisymmetric => {
                HertzPoint::from_peak_pressure(limit.peak_pressure, radius, modulus).force()
            }
        };
        return Some((force, limit.depth));
    }
    let (onset, force) = match stress_state {
        StressState::PlaneStrain => {
            let onset = YieldOnset::line_von_mises(poisson_ratio);
            (onset, onset.line_force(yield_stress, radius, modulus))
        }
        // Without out-of-plane stress the field is that of plane strain with ν = 0.
        StressState::PlaneStress => {
            let onset = YieldOnset::line_von_mises(0.0);
            (onset, onset.line_force(yield_stress, radius, modulus))
        }
        StressState::Axisymmetric => {
            let onset = YieldOnset::point(poisson_ratio);
            (onset, onset.point_force(yield_stress, radius, modulus))
        }
    };
    Some((force, onset.depth_ratio * contact(stress_state, force, radius, modulus).0))
}
