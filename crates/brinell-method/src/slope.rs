//! The slope of the force over the approach, by two loads beside each load.
//!
//! The load-approach curve of a mesh has corners. So a load is solved again a little smaller and
//! a little larger, on small meshes that are sized by their contacts and end alike: their errors
//! cancel in the difference.

use std::ops::ControlFlow;
use std::time::Duration;

use super::observer::{Interrupt, Observer, SolveStatus};
use super::steps::{Step, StepReceiver};
use crate::Interrupted;
use brinell_contact::ContactLoad;

/// Smaller and larger load over that of a step.
const LESS_AND_MORE: [f64; 2] = [0.95, 1.05];

/// Relative error of the slope.
pub const SLOPE_ERROR: f64 = 0.02;
/// The same in plane stress, where plastic flow gathers in bands.
pub const SLOPE_ERROR_IN_PLANE_STRESS: f64 = 0.05;

/// Force and approach at the end of a load.
pub type Reached = [f64; 2];

/// Solves loads one after the other on a small mesh. Returns what the last one reaches; `None`
/// where there is no answer.
pub type Solve<'a> =
    dyn FnMut(&[ContactLoad], &mut dyn Observer) -> Result<Option<Reached>, Interrupt> + 'a;

/// Gives each step its slope and hands it over.
pub struct Slopes<'a, F> {
    receiver: &'a mut dyn StepReceiver<F>,
    is_sought: fn(&Step<F>) -> bool,
    solve: &'a mut Solve<'a>,
    /// Whether each load starts from the state after the load before.
    is_history: bool,
    /// The loads before, of a history.
    before: Vec<ContactLoad>,
    /// Largest force and approach of them.
    largest: Reached,
}

impl<'a, F> Slopes<'a, F> {
    /// Hands steps over to `receiver`; `is_sought` tells those that have a slope which is not known
    /// yet.
    pub fn new(
        receiver: &'a mut dyn StepReceiver<F>,
        is_sought: fn(&Step<F>) -> bool,
        is_history: bool,
        solve: &'a mut Solve<'a>,
    ) -> Self {
        let (before, largest) = (Vec::new(), [0.0; 2]);
        Self { receiver, is_sought, solve, is_history, before, largest }
    }

    fn slope(
        &mut self,
        load: ContactLoad,
        observer: &mut dyn Observer,
    ) -> Result<Option<f64>, Interrupt> {
        let mut under = |factor: f64| {
            // Below the largest load so far bodies are elastic.
            let load = match load {
                ContactLoad::Force(force) => {
                    ContactLoad::Force((factor * force).max(self.largest[0]))
                }
                ContactLoad::Approach(by) => {
                    ContactLoad::Approach((factor * by).max(self.largest[1]))
                }
            };
            let loads: Vec<_> = self.before.iter().copied().chain([load]).collect();
            (self.solve)(&loads, &mut Silent(&mut *observer))
        };
        let [less, more] = LESS_AND_MORE;
        let (less, more) = (under(less)?, under(more)?);
        let slope = |(less, more): (Reached, Reached)| (more[0] - less[0]) / (more[1] - less[1]);
        Ok(less.zip(more).map(slope).filter(|slope| slope.is_finite() && *slope > 0.0))
    }
}

impl<F> StepReceiver<F> for Slopes<'_, F> {
    fn step(&mut self, mut step: Step<F>, observer: &mut dyn Observer) {
        let load = step.load;
        let reached = [step.figures.force, step.figures.approach];
        if (self.is_sought)(&step) {
            match self.slope(load, observer) {
                Ok(slope) => step.contact_stiffness = slope.or(step.contact_stiffness),
                Err(interrupt) => step.status = interrupt.into(),
            }
        }
        if self.is_history {
            self.before.push(load);
            self.largest = [0, 1].map(|k| self.largest[k].max(reached[k]));
        }
        self.receiver.step(step, observer);
    }

    fn begin_anew(&mut self) {
        self.before.clear();
        self.largest = [0.0; 2];
        self.receiver.begin_anew();
    }
}

/// Returns what the last of the loads on a small mesh reaches; `None` where one of them has no
/// answer.
///
/// # Errors
/// Why the observer stopped the solve.
pub fn reached<F, E: Interrupted>(
    interrupt: &Result<Option<Interrupt>, E>,
    steps: &[Step<F>],
) -> Result<Option<Reached>, Interrupt> {
    let interrupt = match interrupt {
        Ok(interrupt) => *interrupt,
        Err(error) => return error.interrupt().map_or(Ok(None), Err),
    };
    let stopped = || steps.iter().find_map(|step| step.status.interrupt());
    interrupt.or_else(stopped).map_or(Ok(()), Err)?;
    let is_converged = steps.iter().all(|step| step.status == SolveStatus::Converged);
    let last = steps.last().filter(|_| is_converged);
    Ok(last.map(|step| [step.figures.force, step.figures.approach]))
}

/// Lets a solve be stopped but not seen. It holds less than the job does.
struct Silent<'a>(&'a mut dyn Observer);

impl Observer for Silent<'_> {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.0.on_checkpoint()
    }

    fn elapsed(&self) -> Duration {
        self.0.elapsed()
    }
}
