//! The slope of the force over the approach, by two loads beside each load.
//!
//! The load-approach curve of a mesh has corners. So a load is solved again a little smaller and
//! a little larger, on small meshes that are sized by their contacts and end alike: their errors
//! cancel in the difference.

use std::ops::ControlFlow;
use std::time::Duration;

use super::observer::{Interrupt, Observer};
use super::steps::{Step, StepReceiver};
use brinell_contact::ContactLoad;

/// Smaller and larger load over that of a step.
const LESS_AND_MORE: [f64; 2] = [0.95, 1.05];

/// Force and approach at the end of a load.
pub type Reached = [f64; 2];

/// What has to be known of a step.
#[derive(Debug, Clone, Copy)]
pub struct Loaded {
    /// The load.
    pub load: ContactLoad,
    /// Force and approach under it.
    pub reached: Reached,
    /// Whether it has a slope that is not known yet.
    pub is_sought: bool,
}

/// Solves loads one after the other on a small mesh. Returns what the last one reaches; `None`
/// where there is no answer.
pub type Solve<'a> =
    dyn FnMut(&[ContactLoad], &mut dyn Observer) -> Result<Option<Reached>, Interrupt> + 'a;

/// Reads a step, and stores its slope.
pub type OfStep<S> = (fn(&S) -> Loaded, fn(&mut S, f64));

/// Gives each step its slope and hands it over.
pub struct Slopes<'a, S> {
    receiver: &'a mut dyn StepReceiver<S>,
    loaded: fn(&S) -> Loaded,
    give: fn(&mut S, f64),
    solve: &'a mut Solve<'a>,
    /// Whether each load starts from the state after the load before.
    is_history: bool,
    /// The loads before, of a history.
    before: Vec<ContactLoad>,
    /// Largest force and approach of them.
    largest: Reached,
}

impl<'a, S: Step> Slopes<'a, S> {
    /// Hands steps over to `receiver`: `loaded` reads a step, and `give` stores its slope.
    pub fn new(
        receiver: &'a mut dyn StepReceiver<S>,
        (loaded, give): OfStep<S>,
        is_history: bool,
        solve: &'a mut Solve<'a>,
    ) -> Self {
        let (before, largest) = (Vec::new(), [0.0; 2]);
        Self { receiver, loaded, give, solve, is_history, before, largest }
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

impl<S: Step> StepReceiver<S> for Slopes<'_, S> {
    fn step(&mut self, mut step: S, observer: &mut dyn Observer) {
        let Loaded { load, reached, is_sought } = (self.loaded)(&step);
        if is_sought {
            match self.slope(load, observer) {
                Ok(slope) => slope.into_iter().for_each(|slope| (self.give)(&mut step, slope)),
                Err(interrupt) => step.set_status(interrupt.into()),
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
