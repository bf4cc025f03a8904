//! The search of the force under which a figure of the contact has a wanted value.
//!
//! ```text
//! coarse:   whole solves at a lower density until a force nearly gives the value
//! fine:     whole solves at the requested density, corrected with the slope of the coarse ones
//! ```
//!
//! Figures of contacts are powers of the force over long ranges, so that the search works with the
//! logarithms of both.

use super::bracket::{Bracket, Next};
use super::loads::{Trial, Tried};
use super::run::Run;
use crate::{Error, Unreachable, UnreachableReason};

/// Deviation of the figure that ends the search at the lower density, whose own error is as large.
const NEAR: f64 = 0.01;
/// Solves at the lower density, at most.
const MAX_COARSE: usize = 40;
/// Slope of the logarithms below which the figure does not determine the force.
const INSENSITIVE: f64 = 0.02;
/// Deviation up to which any force gives the wanted value of a figure that does not determine the
/// force.
const FLAT: f64 = 0.03;
/// Least difference of the logarithms of two forces whose fine solves give a slope.
const SLOPE_SPAN: f64 = 0.02;
/// Ratio of a second force to the first one, for the slope, where the first force meets the value
/// already.
const NEIGHBOUR: f64 = 1.1;
/// Largest change of the logarithm of the force between fine solves.
const LARGEST_CORRECTION: f64 = 0.3;

/// The density of a trial.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Density {
    /// The low density of the search.
    Coarse,
    /// The requested density.
    Asked,
}

/// The terms of a search.
#[derive(Debug, Clone, Copy)]
pub struct Terms {
    /// First force \[N/mm or N\].
    pub first_force: f64,
    /// Expected slope `d ln figure / d ln force`.
    pub expected_slope: f64,
    /// Deviation of the figure that ends the search.
    pub tolerance: f64,
    /// Solves at the requested density, at most.
    pub most_fine: usize,
    /// Deviation above which the value counts as missed.
    pub missed: f64,
}

/// The result of a search.
pub struct ForceFound<F> {
    /// The trial that meets the value.
    pub trial: Trial<F>,
    /// Relative change of the figure over that of the force.
    pub sensitivity: f64,
    /// The same quotient between the last fine solves.
    pub slope: f64,
}

/// Looks for the force; `trial` solves under one.
///
/// # Errors
/// [`Error::Unreachable`], and those of a trial.
pub fn find<F, E: From<Error>>(
    mut trial: impl FnMut(Density, f64, &mut Run<'_>) -> Result<Tried<F>, E>,
    terms: Terms,
    run: &mut Run<'_>,
) -> Result<ForceFound<F>, E> {
    let (force, sensitivity) = run.preliminarily(|run| coarse(&mut trial, terms, run))?;
    let mut found = fine(&mut trial, terms, force, sensitivity, run)?;
    // The deviation of a steep figure is larger under an equally small change of the force.
    let steepness = (sensitivity / terms.expected_slope).max(1.0);
    let trial = &mut found.trial;
    if trial.is_converged() && trial.deviation() > (steepness * terms.missed).max(terms.tolerance)
    {
        trial.steps.iter_mut().for_each(|step| step.miss(trial.ratio));
    }
    Ok(found)
}

/// Returns a force that nearly gives the value, and the slope of the logarithms there.
fn coarse<F, E: From<Error>>(
    trial: &mut impl FnMut(Density, f64, &mut Run<'_>) -> Result<Tried<F>, E>,
    terms: Terms,
    run: &mut Run<'_>,
) -> Result<(f64, f64), E> {
    let mut bracket = Bracket::new(terms.expected_slope);
    let mut force = terms.first_force;
    let mut reason = UnreachableReason::LargestForce;
    let mut near = None;
    for _ in 0..MAX_COARSE {
        match trial(Density::Coarse, force, run)? {
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
                    reason = UnreachableReason::Limit(trial.why_not_converged().into());
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

/// Corrects a nearly right force by fine solves.
fn fine<F, E: From<Error>>(
    trial: &mut impl FnMut(Density, f64, &mut Run<'_>) -> Result<Tried<F>, E>,
    terms: Terms,
    mut force: f64,
    sensitivity: f64,
    run: &mut Run<'_>,
) -> Result<ForceFound<F>, E> {
    let mut slope = sensitivity;
    let mut best: Option<Trial<F>> = None;
    let mut last: Option<[f64; 2]> = None;
    for _ in 0..terms.most_fine {
        let trial = match trial(Density::Asked, force, run)? {
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

/// Returns the error of a value that no force gives; `nearest` is the figure under `force` over
/// that value.
fn unreachable(force: f64, nearest: f64, reason: UnreachableReason) -> Error {
    Error::Unreachable(Unreachable { nearest, force, largest_force: force, reason })
}
