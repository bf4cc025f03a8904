//! The steps of a solution: one for each load.

use super::couplings::iteration::Outcome;
use super::increments::LastIncrement;
use super::observer::{Interrupt, Observer, SolveStatus};
use super::run::Run;
use crate::Interrupted;
use brinell_contact::ContactLoad;

/// Headline figures of a contact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CoarseFigures {
    /// Largest contact pressure \[MPa\].
    pub peak_pressure: f64,
    /// Half-width \[mm\].
    pub half_width: f64,
    /// Approach \[mm\].
    pub approach: f64,
    /// Contact force of both sides of the axis \[N/mm\].
    pub force: f64,
    /// Upper and lower body; zeros of a rigid one.
    pub bodies: [BodyFigures; 2],
}

/// Scalar figures of one body.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BodyFigures {
    /// Largest equivalent plastic strain at a point \[1\].
    pub max_plastic_strain: f64,
    /// Mean equivalent plastic strain over the plastic area \[1\].
    pub mean_plastic_strain: f64,
    /// Area of the section that has yielded \[mm²\].
    pub plastic_area: f64,
    /// Depth of the deepest point of the surface below the undeformed one \[mm\].
    pub dent: f64,
    /// Height of the highest point of the surface above the undeformed one \[mm\].
    pub pile_up: f64,
    /// Least stress along the surface on the normal below the middle of the contact \[MPa\].
    pub least_stress: f64,
    /// Largest von Mises stress over the strength there, that of the surface being 1 \[MPa\].
    pub largest_von_mises: f64,
}

impl CoarseFigures {
    /// Number of figures.
    pub const COUNT: usize = 18;

    /// Returns all figures in the order of the members: contact, upper body, lower body.
    pub fn values(&self) -> [f64; Self::COUNT] {
        let Self { peak_pressure, half_width, approach, force, bodies: [upper, lower] } = *self;
        let [a, b, c, d, e, f, g] = upper.values();
        let [h, i, j, k, l, m, n] = lower.values();
        [peak_pressure, half_width, approach, force, a, b, c, d, e, f, g, h, i, j, k, l, m, n]
    }

    /// Makes figures of their values, the inverse of [`values`](Self::values).
    pub fn of(values: [f64; Self::COUNT]) -> Self {
        let [peak_pressure, half_width, approach, force, bodies @ ..] = values;
        let [a, b, c, d, e, f, g, lower @ ..] = bodies;
        let bodies = [BodyFigures::of([a, b, c, d, e, f, g]), BodyFigures::of(lower)];
        Self { peak_pressure, half_width, approach, force, bodies }
    }
}

impl BodyFigures {
    fn values(&self) -> [f64; 7] {
        let Self { max_plastic_strain, mean_plastic_strain, plastic_area, dent, pile_up, .. } =
            *self;
        let Self { least_stress, largest_von_mises, .. } = *self;
        [
            max_plastic_strain,
            mean_plastic_strain,
            plastic_area,
            dent,
            pile_up,
            least_stress,
            largest_von_mises,
        ]
    }

    fn of(values: [f64; 7]) -> Self {
        let [
            max_plastic_strain,
            mean_plastic_strain,
            plastic_area,
            dent,
            pile_up,
            least_stress,
            largest_von_mises,
        ] = values;
        Self {
            max_plastic_strain,
            mean_plastic_strain,
            plastic_area,
            dent,
            pile_up,
            least_stress,
            largest_von_mises,
        }
    }
}

/// One increment of a load history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IncrementRecord {
    /// Contact force, both sides of the axis.
    pub force: f64,
    /// Approach \[mm\].
    pub approach: f64,
    /// Largest contact pressure \[MPa\].
    pub peak_pressure: f64,
    /// Half-width \[mm\].
    pub half_width: f64,
    /// Iterations made.
    pub iterations: usize,
    /// Points that have yielded so far.
    pub plastic_points: usize,
    /// How the iteration ended.
    pub status: SolveStatus,
}

impl IncrementRecord {
    /// The record of an increment.
    pub fn of(figures: CoarseFigures, outcome: &Outcome) -> Self {
        let CoarseFigures { force, approach, peak_pressure, half_width, .. } = figures;
        Self {
            force,
            approach,
            peak_pressure,
            half_width,
            iterations: outcome.history.len(),
            plastic_points: outcome.history.last().map_or(0, |record| record.plastic_points),
            status: outcome.status,
        }
    }
}

/// The end of a load of a history.
pub struct LoadEnd {
    /// The requested load. The applied load is smaller where a body has collapsed.
    pub load: ContactLoad,
    /// The increment that reached it.
    pub last_increment: LastIncrement,
    /// All increments of the load.
    pub increments: Vec<IncrementRecord>,
    /// Largest approach and half-width of the history so far \[mm\].
    pub reached: [f64; 2],
}

/// The result of an engine for one load.
pub trait Step {
    /// Returns the status.
    fn status(&self) -> SolveStatus;
    /// Sets the status.
    fn set_status(&mut self, status: SolveStatus);
    /// Whether the contact reaches the edge of the widest system.
    fn reaches_edge(&self) -> bool;
    /// Stores the increments of a history that led to this load.
    fn end_load(&mut self, end: LoadEnd);
    /// Stores the figures of the coarse history, from which the errors are estimated.
    fn estimate(&mut self, coarse: Option<CoarseFigures>, increments: Option<CoarseFigures>);
    /// Marks the step as a preliminary one of the coarse history.
    fn make_preliminary(&mut self);
    /// Marks the step as one that misses the wanted value of its figure under every force. `ratio`
    /// is the figure over that value.
    fn miss(&mut self, ratio: f64);
}

/// Receives each step of a solution as soon as it is finished.
pub trait StepReceiver<S> {
    /// Receives the next step.
    fn step(&mut self, step: S, observer: &mut dyn Observer);

    /// Discards the steps so far, because a history begins again: its contact has outgrown the
    /// system. Independent loads never begin again.
    fn begin_anew(&mut self);
}

/// Collects the steps.
impl<S> StepReceiver<S> for Vec<S> {
    fn step(&mut self, step: S, _: &mut dyn Observer) {
        self.push(step);
    }

    fn begin_anew(&mut self) {
        self.clear();
    }
}

/// Solves independent loads in order; `solve` takes a load and the next one.
///
/// If the observer stops the solve, finished steps are kept, and the returned interrupt is the
/// reason for the missing ones.
///
/// # Errors
/// Errors of `solve`, also the interrupt before the first step is finished.
pub fn each_load<S: Step, E: Interrupted>(
    loads: &[ContactLoad],
    receiver: &mut dyn StepReceiver<S>,
    run: &mut Run<'_>,
    mut solve: impl FnMut(ContactLoad, Option<ContactLoad>, &mut Run<'_>) -> Result<S, E>,
) -> Result<Option<Interrupt>, E> {
    for (k, &load) in loads.iter().enumerate() {
        match solve(load, loads.get(k + 1).copied(), run) {
            Ok(step) => {
                let status = step.status();
                receiver.step(step, run.observer);
                if status.is_stopped() {
                    break;
                }
            }
            // Finished steps are kept.
            Err(error) if k > 0 => return error.interrupt().ok_or(error).map(Some),
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}
