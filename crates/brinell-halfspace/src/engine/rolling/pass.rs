//! One pass: its figures, and the evidence on which it is judged.

use crate::track::{Operators, Outlet, PassStrain, TrackBody, TrackFault};

use super::engine::{Answer, TrackEngine};
use super::system::Track;
use crate::engine::watch::never;
use brinell_method::contact_system::{ContactFigures, ContactSystem};
use brinell_method::couplings::iteration::{norm, relative};
use brinell_method::final_check::{Evidence, LeastScales, judge};
use brinell_method::observer::IterationRecord;
use brinell_method::observer::SolveStatus;

/// Excess of a residual stress over its yield surface that the iteration may leave. Sound passes
/// have none.
const BEYOND_YIELD: f64 = 1e-3;
/// Part of the largest plastic work of a pass that may be missing in the balance of energy.
const ENERGY: f64 = 0.1;
/// Plastic work over the force and the slope of the gap at the end of the contact, the size of an
/// elastic rolling force on one side, below which the balance is not resolved.
const LEAST_WORK: f64 = 1e-6;

/// One pass of the load. Lengths in mm, stresses in MPa, forces and works per length of travel in
/// N; of a line contact forces and works on unit thickness in N/mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Pass {
    /// Status of the iteration, including the final check.
    pub status: SolveStatus,
    /// Iterations made.
    pub iterations: usize,
    /// Residual of the plastic law over the contact force, computed again at the end.
    pub residual: f64,
    /// Largest contact pressure.
    pub peak_pressure: f64,
    /// Its x, in the direction of travel.
    pub peak_position: f64,
    /// Ends of the contact along the travel, on the axis.
    pub ends: [f64; 2],
    /// Half the width of the contact across the travel; `None` of a line.
    pub half_width_across: Option<f64>,
    /// Approach of the bodies; `None` of a line, which has none.
    pub approach: Option<f64>,
    /// Force against which the load is pushed, without friction.
    pub rolling_force: f64,
    /// Work of the traction on the plastic displacement of the surfaces.
    pub work_of_traction: f64,
    /// Why the pass is no answer although its iteration may have converged.
    pub fault: Option<TrackFault>,
    /// Residual state of each body after the pass; of two equal bodies that roll freely in both.
    pub bodies: [Option<BodyPass>; 2],
}

/// Residual state of a body after a pass.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyPass {
    /// Changes of this pass and what all passes have left.
    pub outlet: Outlet,
    /// Plastic strain of the pass, by which a verdict is found.
    pub strain: PassStrain,
}

impl Pass {
    /// Half the width of the contact along the travel \[mm\].
    pub fn half_width(&self) -> f64 {
        0.5 * (self.ends[1] - self.ends[0])
    }

    /// Plastic work of both bodies \[N\].
    pub fn plastic_work(&self) -> f64 {
        self.bodies.iter().flatten().map(|body| body.outlet.plastic_work).sum()
    }

    /// Change of the energy of residual stress of both bodies \[N\].
    pub fn stored_energy(&self) -> f64 {
        self.bodies.iter().flatten().map(|body| body.outlet.stored_energy).sum()
    }

    /// Returns the error of the balance of energy over the plastic work; 0 without plastic work.
    pub fn energy_gap(&self) -> f64 {
        let done = self.plastic_work();
        if done > 0.0 { relative(self.missing_work(), done) } else { 0.0 }
    }

    /// What is missing in the balance of energy \[N\].
    ///
    /// Elastic displacements do no work over a steady pass: the work of pressure and traction is
    /// the plastic work and the change of the energy of residual stress.
    fn missing_work(&self) -> f64 {
        let spent = self.rolling_force + self.work_of_traction;
        (spent - self.plastic_work() - self.stored_energy()).abs()
    }

    /// Checks the law and the balance of energy of a pass behind those of `earlier`: the residual
    /// stress is within its yield surface, and no work is missing over the largest plastic work,
    /// which counts as `least` at least.
    ///
    /// # Errors
    /// [`TrackFault::BeyondYield`], [`TrackFault::Energy`].
    fn check(&self, earlier: &[Self], least: f64) -> Result<(), TrackFault> {
        let bodies = self.bodies.iter().flatten();
        let excess = bodies.map(|body| body.outlet.excess).fold(f64::NEG_INFINITY, f64::max);
        if excess > BEYOND_YIELD {
            return Err(TrackFault::BeyondYield { excess });
        }
        let works = earlier.iter().chain([self]).map(Self::plastic_work);
        let gap = self.missing_work() / works.fold(least, f64::max);
        if gap > ENERGY { Err(TrackFault::Energy { gap }) } else { Ok(()) }
    }
}

impl<O: Operators<D, R>, const D: usize, const R: usize> Answer<O, D, R> {
    /// The figures of the pass behind `earlier` ones, and the track as it leaves it. A pass that
    /// has not converged leaves nothing.
    pub fn pass(
        self,
        engine: &TrackEngine<'_, O, D, R>,
        earlier: &[Pass],
    ) -> (Pass, Track<O, D, R>, Vec<IterationRecord>) {
        let evidence = self.evidence();
        let load = engine.controls().load;
        let least = LeastScales::default().contact;
        let (status, _) =
            judge(&self.track, &self.outcome, &evidence, load, engine.tolerance, least);
        let Self { mut track, outcome, fault } = self;
        let contact = &outcome.state.response.contact;
        let pressure = track.pressure(&contact.force);
        let work = |body: &mut TrackBody<O, D, R>| {
            body.count() * body.work_of_traction(&pressure, &mut never).unwrap_or_default()
        };
        let work_of_traction = track.bodies.get_mut().iter_mut().map(work).sum();
        let ContactFigures { peak_pressure, .. } = track.figures(contact);
        let (x, along) = (track.grid.places(), track.grid.along(&pressure));
        let largest = along.iter().zip(&x).max_by(|a, b| a.0.total_cmp(b.0));
        let y: Vec<f64> = track.grid.places_across().collect();
        let across = track.grid.in_the_middle(&pressure);
        let of_places = |places: &[f64]| places.get(1).zip(places.first()).map(|(b, a)| b - a);
        let mut pass = Pass {
            status,
            iterations: outcome.history.len(),
            residual: evidence.equilibrium_residual,
            peak_pressure,
            peak_position: largest.map_or(0.0, |(_, x)| *x),
            ends: ends(&along, x.first().copied().unwrap_or(0.0), track.grid.column()),
            half_width_across: of_places(&y).map(|h| {
                let [left, right] = ends(across, y[0], h);
                0.5 * (right - left)
            }),
            approach: track.approach(contact),
            rolling_force: track.grid.rolling_force(&track.initial_gap, &pressure),
            work_of_traction,
            fault,
            bodies: [None, None],
        };
        if status == SolveStatus::Converged {
            track.commit(outcome.state.response.displacement);
            let mut outlets = track
                .outlets
                .iter()
                .map(|outlet| BodyPass { strain: PassStrain::of(outlet), outlet: outlet.clone() });
            let problem = engine.problem;
            for (side, _) in problem.yielding() {
                pass.bodies[side] = outlets.next();
            }
            if problem.is_shared() {
                let [upper, lower] = &mut pass.bodies;
                lower.clone_from(upper);
            }
            let least = LEAST_WORK * problem.load.force * problem.slope();
            if let Err(fault) = pass.check(earlier, least) {
                pass.status = SolveStatus::NotConverged;
                pass.fault = Some(fault);
                pass.bodies = [None, None];
            }
        }
        (pass, track, outcome.history)
    }

    /// Opening, stress and plastic law once more, from the loads of the last iterate.
    fn evidence(&self) -> Evidence {
        let (track, state) = (&self.track, &self.outcome.state);
        let force = &state.response.contact.force;
        let opening = track.gap_opening(&state.loads);
        let mut unloaded_gap = vec![0.0; force.len()];
        track.flexibility.apply(force, &mut unloaded_gap);
        for (gap, (initial, opening)) in
            unloaded_gap.iter_mut().zip(track.initial_gap.iter().zip(&opening))
        {
            *gap += initial + opening;
        }
        let trial = track.displacement(&state.loads, force);
        let mut answer = track.zeros();
        track.initial_stress(&trial, &mut answer);
        Evidence {
            unloaded_gap,
            equilibrium_residual: relative(track.distance(&answer, &state.loads), norm(force)),
            has_collapsed: self.has_collapsed(),
            reaches_edge: self.fault.is_some(),
        }
    }
}

/// Returns the ends of the pressure: p² falls linearly at an end of the contact.
fn ends(pressure: &[f64], first: f64, h: f64) -> [f64; 2] {
    let touches: Vec<usize> = (0..pressure.len()).filter(|i| pressure[*i] > 0.0).collect();
    let (Some(&left), Some(&right)) = (touches.first(), touches.last()) else { return [0.0; 2] };
    let x = |i: usize| first + i as f64 * h;
    let beyond = |end: usize, inner: Option<usize>| {
        let next = inner.and_then(|i| pressure.get(i)).copied().unwrap_or(0.0);
        let (at_end, next) = (pressure[end].powi(2), next.powi(2));
        if next > at_end { (h * at_end / (next - at_end)).min(h) } else { 0.5 * h }
    };
    [x(left) - beyond(left, Some(left + 1)), x(right) + beyond(right, right.checked_sub(1))]
}
