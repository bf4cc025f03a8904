//! Jobs whose load rolls.

use super::half_spaces::half_spaces;
use super::plane::problem;
use super::settings::settings;
use crate::analytical::DepthLimit;
use crate::job::{Analysis, HardeningRule, Job, Load, Until};
use crate::solver::rolling::{HardeningRules, RollingLoad, RollingProblem, TrackError};
use crate::solver::{ElasticReference, Problem};

/// A contact that rolls, and what closed forms say of it.
pub(crate) struct RollingInput {
    pub problem: RollingProblem,
    /// The bodies of a line contact.
    lines: Option<Problem>,
}

impl RollingInput {
    /// Returns Hertz's line contact; `None` of an ellipse.
    pub fn reference(&self) -> Option<ElasticReference> {
        ElasticReference::of(self.lines.as_ref()?, self.problem.load.force)
    }

    /// Returns the limits of shakedown of lines over friction.
    pub fn over_friction(&self, reference: &ElasticReference) -> Vec<(f64, DepthLimit)> {
        let lines = self.lines.as_ref();
        lines.map(|lines| reference.limits_over_friction(lines)).unwrap_or_default()
    }
}

/// Returns the contact of a job whose load rolls.
///
/// # Errors
/// [`TrackError::NoTrack`] and [`TrackError::NoRaceway`]: the load does not roll, or not over
/// these surfaces.
pub(crate) fn rolling(job: &Job) -> Result<RollingInput, TrackError> {
    let Load::Rolling(given) = job.load else { return Err(TrackError::NoTrack) };
    let load = RollingLoad {
        force: given.force.get(),
        passes: given.passes,
        ends_at_verdict: given.until == Until::Verdict,
        friction: given.friction,
        hardening: match given.hardening {
            HardeningRule::Both => HardeningRules::Both,
            HardeningRule::Isotropic => HardeningRules::Isotropic,
            HardeningRule::Kinematic => HardeningRules::Kinematic,
        },
        alternating: given.alternating,
        track: given.track,
    };
    if job.analysis == Analysis::ThreeDimensional {
        let shapes = half_spaces(job).ok_or(TrackError::NoTrack)?;
        return Ok(RollingInput {
            problem: RollingProblem::of_half_spaces(&shapes, load)?,
            lines: None,
        });
    }
    let lines = problem(job);
    let curvature = lines.curvature().filter(|_| lines.conforming.is_none());
    let asked = (job.mesh.elements_per_half_width as usize, settings(job));
    let materials = lines.bodies.each_ref().map(|body| body.material.clone());
    let problem = RollingProblem::of_lines(materials, curvature, load, asked)?;
    Ok(RollingInput { problem, lines: Some(lines) })
}
