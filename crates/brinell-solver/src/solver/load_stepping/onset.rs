//! The load at which a contact of any shape first yields.

use std::sync::Arc;

use crate::contact::{ContactLoad, ContactSolver};
use crate::fem::assembly::GaussPoint;
use crate::job::Job;
use crate::material::von_mises;
use crate::solver::body_system::factor_cache::FactorCache;
use crate::solver::load_stepping::load_stepper::LoadStepper;
use crate::solver::problem::{Problem, ProblemBody};
use crate::solver::solution::{Solution, StepSolution};
use crate::solver::{Observer, SolveError, SolveStatus};

/// Loads tried at most.
const MAX_TRIALS: usize = 12;
/// Distance of the highest von Mises stress from the yield stress that ends the search.
const TOLERANCE: f64 = 2e-4;

/// Finds the force at which the highest von Mises stress of an elastic contact equals the yield stress.
///
/// Stress grows with a power of the force that depends on the shape (1/2 for a cylinder, 1/3 for a sphere); the
/// power is read off the last two trials. Every trial is a full solve of the elastic bodies, the last one is the
/// answer.
///
/// # Errors
/// [`SolveError::NoYieldPoint`] if no body has a yield stress, and those of a solve.
pub(crate) fn run(
    problem: &Problem,
    job: &Job,
    contact: &dyn ContactSolver,
    cache: Option<&Arc<FactorCache>>,
    solution: &mut Solution,
    observer: &mut dyn Observer,
) -> Result<StepSolution, SolveError> {
    let elastic = problem.without_plasticity();
    let yield_stress = problem.bodies.each_ref().map(ProblemBody::yield_stress);
    if yield_stress.iter().all(Option::is_none) {
        return Err(SolveError::NoYieldPoint);
    }
    let mut force = first_trial(&elastic, &yield_stress)?;
    let mut exponent = 0.5;
    let mut last: Option<(f64, f64)> = None;
    let mut trial = 1;
    loop {
        let mut stepper = LoadStepper::new(&elastic, job, contact, cache);
        let mut step = stepper.step(ContactLoad::Force(force), None, solution, observer)?;
        let ratio = highest_utilisation(&step, &yield_stress).map_or(0.0, |highest| highest.ratio);
        if (ratio - 1.0).abs() <= TOLERANCE || trial == MAX_TRIALS || step.status != SolveStatus::Converged {
            if (ratio - 1.0).abs() > TOLERANCE && step.status == SolveStatus::Converged {
                step.status = SolveStatus::NotConverged;
            }
            return Ok(step);
        }
        if let Some((other, before)) = last {
            let slope = (ratio / before).ln() / (force / other).ln();
            if slope.is_finite() && (0.05..=2.0).contains(&slope) {
                exponent = slope;
            }
        }
        last = Some((force, ratio));
        force *= ratio.recip().powf(exponent.recip()).clamp(1e-6, 1e6);
        trial += 1;
    }
}

/// A force whose contact is small, to start from.
fn first_trial(problem: &Problem, yield_stress: &[Option<f64>; 2]) -> Result<f64, SolveError> {
    let softest = yield_stress.iter().flatten().copied().fold(f64::INFINITY, f64::min);
    // The smallest force whose contact can be sized, brought up to a mean pressure of about the yield stress.
    let (mut low, mut high) = (1e-9, 1e9);
    let mean = |force: f64| -> Result<f64, SolveError> {
        let extent = crate::solver::mesh_sizing::contact_size::ContactSizeEstimate::expected(
            problem,
            ContactLoad::Force(force),
        )?;
        Ok(problem.mean_pressure(force, extent.half_width))
    };
    if matches!(mean(low), Err(SolveError::Conforming)) {
        return Err(SolveError::Conforming);
    }
    for _ in 0..80 {
        let middle = f64::sqrt(low * high);
        match mean(middle) {
            Ok(pressure) if pressure < softest => low = middle,
            _ => high = middle,
        }
    }
    Ok(low)
}

/// Where a step comes nearest to yield, or is farthest beyond it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Utilisation {
    /// Von Mises stress over yield stress.
    pub ratio: f64,
    /// 0 is the upper body, 1 the lower one.
    pub body: usize,
    /// Centroid `[x, y]` of the element \[mm\].
    pub position: [f64; 2],
}

/// The element with the highest von Mises stress over yield stress \[MPa\], by element means: single Gauss points lie
/// above the field by half a percent. Of two bodies alike, the lower one; `None` if no body can yield.
pub fn highest_utilisation(step: &StepSolution, yield_stress: &[Option<f64>; 2]) -> Option<Utilisation> {
    let elements =
        step.bodies.iter().zip(yield_stress).enumerate().filter_map(|(body, (solution, limit))| {
            let (solution, limit) = (solution.as_ref()?, (*limit)?);
            Some(solution.stress.points.iter().map(move |points| {
                let mean = GaussPoint::mean(points);
                Utilisation { ratio: von_mises(mean.stress) / limit, body, position: mean.position }
            }))
        });
    elements.flatten().max_by(|a, b| a.ratio.total_cmp(&b.ratio))
}
