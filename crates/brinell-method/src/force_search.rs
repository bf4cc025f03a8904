//! The force under which a figure of the contact has a value.
//!
//! ```text
//! coarse:   whole solves at a lower density, until a force meets the value nearly
//! fine:     whole solves as they were asked for, from there on with the slope that the coarse ones have shown
//! ```
//!
//! Figures of contacts follow powers of the force over long ranges, so that both are looked at in
//! logarithms.

use super::bracket::{Bracket, Next};
use super::observer::SolveStatus;
use super::run::Run;
use super::steps::Step;
use crate::Error;

/// Deviation of the figure that is near enough at the lower density, which is itself off by as
/// much.
const NEAR: f64 = 0.01;
/// Most solves at the lower density.
const MAX_COARSE: usize = 40;
/// Slope of the logarithms below which the figure does not tell the force.
const INSENSITIVE: f64 = 0.02;
/// Deviation up to which such a figure is looked upon as having the value under any force.
const FLAT: f64 = 0.03;
/// Least change of a force, as a logarithm, over which a slope is read off two fine solves.
const SLOPE_SPAN: f64 = 0.02;
/// Change of a force that shows the slope where the first trial is near already.
const NEIGHBOUR: f64 = 1.1;
/// Largest change of the logarithm of the force between fine solves.
const LARGEST_CORRECTION: f64 = 0.3;

/// How finely a trial is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Density {
    /// As coarsely as looking for a force allows.
    Coarse,
    /// As it was asked for.
    Asked,
}

/// What is asked of a force.
#[derive(Debug, Clone, Copy)]
pub struct Terms {
    /// The force to start from \[N/mm or N\].
    pub first_force: f64,
    /// What is expected of `d ln figure / d ln force`.
    pub expected_slope: f64,
    /// Deviation that ends the search, and the most fine solves.
    pub tolerance: f64,
    /// The most solves at the density that was asked for.
    pub most_fine: usize,
    /// Deviation from which on the value counts as missed.
    pub missed: f64,
}

/// Bodies whose contact has a figure that is sought.
pub trait Sought {
    /// A load as a step.
    type Step: Step;
    /// Its errors, and those of the search.
    type Error: From<Error>;

    /// Solves under one force.
    ///
    /// # Errors
    /// Those of a solve that say nothing of the force.
    fn trial(
        &self,
        density: Density,
        force: f64,
        run: &mut Run<'_>,
    ) -> Result<Tried<Self::Step>, Self::Error>;
}

/// What a force has given.
pub struct Trial<S> {
    /// The figure over its wanted value.
    pub ratio: f64,
    /// Of the force itself and of the loads that follow it.
    pub steps: Vec<S>,
}

/// A trial, or why its force is too large to be solved.
pub type Tried<S> = Result<Trial<S>, String>;

/// What a search has found.
pub struct ForceFound<S> {
    /// The trial that meets the value.
    pub trial: Trial<S>,
    /// Relative change of the figure over that of the force.
    pub sensitivity: f64,
    /// The same between the last fine solves.
    pub slope: f64,
}

/// A force that was sought by what it does and does not exist.
#[derive(Debug, Clone, PartialEq)]
pub struct Unreachable {
    /// The nearest figure that was found, over its wanted value; of the onset of yield, the
    /// highest von Mises stress over the yield stress. Not a number where none was found.
    pub nearest: f64,
    /// The force under which it was \[N/mm or N\].
    pub force: f64,
    /// The largest force that was solved \[N/mm or N\].
    pub largest_force: f64,
    /// Why no other force does.
    pub reason: UnreachableReason,
}

/// Why no force gives a contact what it was to have.
#[derive(Debug, Clone, PartialEq)]
pub enum UnreachableReason {
    /// Larger forces cannot be solved, for this reason.
    Limit(String),
    /// The figure is too small under the largest force.
    LargestForce,
    /// The figure is too large under the smallest force.
    SmallestForce,
    /// The figure is the same under all forces nearby.
    Insensitive,
}

/// Looks for the force.
///
/// # Errors
/// [`Error::Unreachable`], and those of a solve.
pub fn find<B: Sought>(
    bodies: &B,
    terms: Terms,
    run: &mut Run<'_>,
) -> Result<ForceFound<B::Step>, B::Error> {
    let (force, sensitivity) = run.silently(|run| coarse(bodies, terms, run))?;
    let mut found = fine(bodies, terms, force, sensitivity, run)?;
    // Of a figure that rises more steeply than others an equally small change of the force is a
    // larger one.
    let steepness = (sensitivity / terms.expected_slope).max(1.0);
    let trial = &mut found.trial;
    if trial.is_converged() && trial.deviation() > (steepness * terms.missed).max(terms.tolerance)
    {
        trial.steps.iter_mut().for_each(|step| step.miss(trial.ratio));
    }
    Ok(found)
}

/// A force that meets the value nearly, and the slope of the logarithms there.
fn coarse<B: Sought>(bodies: &B, terms: Terms, run: &mut Run<'_>) -> Result<(f64, f64), B::Error> {
    let mut bracket = Bracket::new(terms.expected_slope);
    let mut force = terms.first_force;
    let mut reason = UnreachableReason::LargestForce;
    let mut near = None;
    for _ in 0..MAX_COARSE {
        match bodies.trial(Density::Coarse, force, run)? {
            Ok(trial) if trial.is_converged() => {
                bracket.record(force, trial.ratio);
                if trial.deviation() <= NEAR {
                    near = Some(force);
                }
                let is_flat = || bracket.slope_at(force).is_some_and(|slope| slope < INSENSITIVE);
                if trial.deviation() <= FLAT && is_flat() {
                    return Err(
                        unreachable(force, trial.ratio, UnreachableReason::Insensitive).into()
                    );
                }
            }
            Ok(trial) => {
                if bracket.limit(force) {
                    reason = UnreachableReason::Limit(trial.why_not_converged().to_owned());
                }
            }
            Err(why) => {
                if bracket.limit(force) {
                    reason = UnreachableReason::Limit(why);
                }
            }
        }
        if let Some(near) = near.or_else(|| bracket.jump()) {
            match bracket.slope_at(near) {
                Some(slope) if slope < INSENSITIVE => {
                    return Err(unreachable(near, 1.0, UnreachableReason::Insensitive).into());
                }
                Some(slope) => return Ok((near, slope)),
                None => force = near * NEIGHBOUR,
            }
            continue;
        }
        match bracket.next() {
            Next::Force(next) => force = next,
            Next::NoSmaller => {
                return Err(unreachable(force, f64::NAN, UnreachableReason::SmallestForce).into());
            }
            Next::AtLimit => break,
        }
    }
    let (force, nearest) = bracket.largest().unwrap_or((force, 0.0));
    let largest_force = bracket.largest_force().unwrap_or(force);
    Err(Error::Unreachable(Unreachable { nearest, force, largest_force, reason }).into())
}

/// From a force that is nearly right to the answer.
fn fine<B: Sought>(
    bodies: &B,
    terms: Terms,
    mut force: f64,
    sensitivity: f64,
    run: &mut Run<'_>,
) -> Result<ForceFound<B::Step>, B::Error> {
    let mut slope = sensitivity;
    let mut best: Option<Trial<B::Step>> = None;
    let mut last: Option<[f64; 2]> = None;
    for _ in 0..terms.most_fine {
        let trial = match bodies.trial(Density::Asked, force, run)? {
            Ok(trial) => trial,
            Err(why) => {
                let ratio = best.map_or(0.0, |best| best.ratio);
                return Err(unreachable(force, ratio, UnreachableReason::Limit(why)).into());
            }
        };
        if !trial.is_converged() {
            return Ok(ForceFound { trial, sensitivity, slope });
        }
        let at = [force.ln(), trial.ratio.max(f64::MIN_POSITIVE).ln()];
        if best.as_ref().is_none_or(|best| trial.deviation() < best.deviation()) {
            best = Some(trial);
        }
        if best.as_ref().is_some_and(|best| best.deviation() <= terms.tolerance) {
            break;
        }
        if let Some(last) = last
            && (at[0] - last[0]).abs() >= SLOPE_SPAN
        {
            let found = (at[1] - last[1]) / (at[0] - last[0]);
            slope = found.clamp(0.5 * slope, 2.0 * slope);
        }
        last = Some(at);
        force *= (-at[1] / slope).clamp(-LARGEST_CORRECTION, LARGEST_CORRECTION).exp();
    }
    best.map(|trial| ForceFound { trial, sensitivity, slope }).ok_or_else(|| Error::NoLoad.into())
}

/// The error of a value that no force gives; `nearest` is what the force that was solved gives of
/// it.
fn unreachable(force: f64, nearest: f64, reason: UnreachableReason) -> Error {
    Error::Unreachable(Unreachable { nearest, force, largest_force: force, reason })
}

impl<S: Step> Trial<S> {
    /// Whether all its steps have converged.
    pub fn is_converged(&self) -> bool {
        self.steps.iter().all(|step| step.status() == SolveStatus::Converged)
    }

    fn why_not_converged(&self) -> &'static str {
        if self.steps.iter().any(Step::reaches_edge) {
            "the contact is wider than what can be meshed"
        } else {
            "the iteration does not converge"
        }
    }

    fn deviation(&self) -> f64 {
        (self.ratio - 1.0).abs()
    }
}
