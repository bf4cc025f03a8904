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
use super::observer::{Interrupt, SolveStatus};
use super::run::Run;
use super::sought::{Sought, TargetFigure};
use super::steps::Step;
use crate::{Error, Limit, Unreachable, UnreachableReason};
use brinell_contact::ContactLoad;

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
/// Ratio of the first force to a second one, for the slope, where the first force meets the value
/// already. A larger second force may not be solvable.
const NEIGHBOUR: f64 = 1.1;
/// Largest change of the logarithm of the force between fine solves.
const LARGEST_CORRECTION: f64 = 0.3;

/// Relative deviation that ends the search, largest number of solves at the requested density, and
/// relative deviation from which on the value counts as missed: for a target, and for the onset of
/// yield, which scatters less. At 20 elements figures scatter by 0.02 % (peak pressure) to 0.4 %
/// (half-width) with the mesh; a utilization at the edge of a contact circle scatters with its
/// radius.
const TARGET: (f64, usize, f64) = (1e-3, 4, 1e-2);
const ONSET: (f64, usize, f64) = (2e-4, 8, 3e-3);

/// The density of a trial.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Density {
    /// The low density of the search.
    Coarse,
    /// Half the requested density, by which errors are told.
    Half,
    /// The requested density.
    Asked,
}

/// The force that is sought.
#[derive(Debug, Clone, Copy)]
pub struct Search {
    /// The effect that defines it.
    pub sought: Sought,
    /// The force to start from \[N/mm or N\].
    pub first_force: f64,
    /// Relative scatter, from system to system, of figures that follow the width of the contact.
    pub scatter_of_width: f64,
}

/// The solves of an engine that try forces.
pub trait Trials {
    /// The fields of a step.
    type Field;
    /// The errors of a solve.
    type Error: From<Error>;

    /// Solves loads in order, beginning at rest.
    ///
    /// # Errors
    /// Those of a solve.
    fn solve(
        &self,
        density: Density,
        loads: &[ContactLoad],
        run: &mut Run<'_>,
        steps: &mut Vec<Step<Self::Field>>,
    ) -> Result<Option<Interrupt>, Self::Error>;

    /// Returns why the force of an error is too large to be solved; other errors come back.
    ///
    /// # Errors
    /// Errors that no smaller force avoids.
    fn too_large(error: Self::Error) -> Result<Limit, Self::Error>;

    /// Returns the highest von Mises stress over the yield stress; 0 where nothing can yield.
    fn utilization(&self, step: &Step<Self::Field>) -> f64;

    /// Returns a target at the end of the loads by which it is found \[mm, MPa or 1\].
    fn figure(&self, step: &Step<Self::Field>, target: TargetFigure) -> f64;

    /// Returns the relative error of a target at the end of the loads, where it has one.
    fn error(&self, step: &Step<Self::Field>, target: TargetFigure) -> Option<f64>;
}

/// The terms on which a search ends.
#[derive(Debug, Clone, Copy)]
struct Terms {
    search: Search,
    /// Expected slope `d ln figure / d ln force`.
    expected_slope: f64,
    /// Deviation of the figure that ends the search.
    tolerance: f64,
    /// Solves at the requested density, at most.
    most_fine: usize,
    /// Deviation above which the value counts as missed.
    missed: f64,
}

impl Terms {
    fn of(search: Search) -> Self {
        let Search { sought, scatter_of_width, .. } = search;
        let (tolerance, most_fine, missed) = match sought {
            Sought::Onset => ONSET,
            Sought::Target(_) => TARGET,
        };
        let scatter = if sought.follows_width() { scatter_of_width } else { 0.0 };
        let expected_slope = sought.expected_slope();
        Self { search, expected_slope, tolerance, most_fine, missed: missed.max(scatter) }
    }
}

/// The result under one force.
pub struct Trial<F> {
    /// The figure over its wanted value.
    pub ratio: f64,
    /// Steps of the force and of the load after it.
    pub steps: Vec<Step<F>>,
}

/// A trial, or the reason why its force is too large to be solved.
pub type Tried<F> = Result<Trial<F>, Limit>;

impl<F> Trial<F> {
    /// Whether all steps have converged.
    pub fn is_converged(&self) -> bool {
        self.steps.iter().all(|step| step.status == SolveStatus::Converged)
    }

    fn why_not_converged(&self) -> &'static str {
        if self.steps.iter().any(|step| step.checks.reaches_edge) {
            "the contact is wider than what can be meshed"
        } else {
            "the iteration does not converge"
        }
    }

    fn deviation(&self) -> f64 {
        (self.ratio - 1.0).abs()
    }
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

/// Looks for the force. The steps of a target have its relative error, the first step the number of
/// systems that were built.
///
/// # Errors
/// [`Error::Unreachable`], and those of a trial.
pub fn find<T: Trials>(
    search: Search,
    trials: &T,
    run: &mut Run<'_>,
) -> Result<ForceFound<T::Field>, T::Error> {
    let (before, terms) = (*run.passes, Terms::of(search));
    let (force, sensitivity) = run.preliminarily(|run| coarse(trials, terms, run))?;
    let mut found = fine(trials, terms, force, sensitivity, run)?;
    // The deviation of a steep figure is larger under an equally small change of the force.
    let steepness = (sensitivity / terms.expected_slope).max(1.0);
    let trial = &mut found.trial;
    if trial.is_converged() && trial.deviation() > (steepness * terms.missed).max(terms.tolerance)
    {
        trial.steps.iter_mut().for_each(|step| step.miss(trial.ratio));
    }
    if let Sought::Target(target) = search.sought {
        let error = trial.steps.last().and_then(|step| trials.error(step, target.figure));
        for step in &mut trial.steps {
            step.search.force_error = error.map(|error| error / sensitivity);
        }
    }
    if let Some(step) = trial.steps.first_mut() {
        step.search.systems = *run.passes - before;
    }
    Ok(found)
}

/// Solves under one force, and of a permanent effect without it afterwards.
///
/// # Errors
/// Errors of a solve that do not come from too large a force.
pub fn try_force<T: Trials>(
    sought: Sought,
    trials: &T,
    density: Density,
    force: f64,
    run: &mut Run<'_>,
) -> Result<Tried<T::Field>, T::Error> {
    let loads = [ContactLoad::Force(force), ContactLoad::Force(0.0)];
    let loads = &loads[..=usize::from(sought.is_permanent())];
    let mut steps = Vec::new();
    let interrupt = match trials.solve(density, loads, run, &mut steps) {
        Ok(interrupt) => interrupt,
        Err(error) => return T::too_large(error).map(Err),
    };
    let interrupt = interrupt.or_else(|| steps.iter().find_map(|step| step.status.interrupt()));
    if let Some(interrupt) = interrupt {
        return Err(Error::Interrupted(interrupt).into());
    }
    if steps.iter().any(|step| step.checks.has_collapsed) {
        return Ok(Err("a body collapses: its plastic strain is above 100 %".into()));
    }
    let ratio = |step| match sought {
        Sought::Onset => trials.utilization(step),
        Sought::Target(target) => trials.figure(step, target.figure) / target.value,
    };
    let ratio = steps.last().map_or(0.0, ratio);
    Ok(Ok(Trial { ratio, steps }))
}

/// Returns a force that nearly gives the value, and the slope of the logarithms there.
fn coarse<T: Trials>(trials: &T, terms: Terms, run: &mut Run<'_>) -> Result<(f64, f64), T::Error> {
    let mut bracket = Bracket::new(terms.expected_slope);
    let mut force = terms.search.first_force;
    let mut reason = UnreachableReason::LargestForce;
    let mut near = None;
    for _ in 0..MAX_COARSE {
        match try_force(terms.search.sought, trials, Density::Coarse, force, run)? {
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
                None => force = near / NEIGHBOUR,
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
fn fine<T: Trials>(
    trials: &T,
    terms: Terms,
    mut force: f64,
    sensitivity: f64,
    run: &mut Run<'_>,
) -> Result<ForceFound<T::Field>, T::Error> {
    let mut slope = sensitivity;
    let mut best: Option<Trial<T::Field>> = None;
    let mut last: Option<[f64; 2]> = None;
    for _ in 0..terms.most_fine {
        let trial = match try_force(terms.search.sought, trials, Density::Asked, force, run)? {
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
