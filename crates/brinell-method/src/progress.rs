//! The progress of a history from one increment to the next.

use super::contact_system::{BlockVector, ContactSystem};
use super::couplings::iteration::{Outcome, Scales, norm};
use super::increments::Leg;
use super::observer::IncrementNumber;
use brinell_contact::ContactLoad;
use brinell_contact::kkt::{self, ContactScales};

/// The progress of a history.
pub struct Progress {
    /// Displacements and load measure of the increment before.
    pub before: Option<(BlockVector, f64)>,
    /// Number of finished loads plus the applied part of the present load.
    pub time: f64,
    /// The increment.
    pub number: IncrementNumber,
    /// Contact force \[N or N/mm\].
    pub force: f64,
    /// Approach \[mm\].
    pub approach: f64,
    /// Largest force and approach so far.
    pub reached: [f64; 2],
    /// Scales of changes and residuals.
    pub scales: Scales,
    /// Largest scales of the contact conditions so far.
    pub contact_scales: ContactScales,
}

impl Progress {
    /// The progress before the first load.
    pub fn at_rest() -> Self {
        Self {
            before: None,
            time: 0.0,
            number: IncrementNumber { number: 0, count: 0, load: 0, loads: 0 },
            force: 0.0,
            approach: 0.0,
            reached: [0.0; 2],
            scales: Scales::default(),
            contact_scales: ContactScales::default(),
        }
    }

    /// Extrapolates displacements to a load along the straight line through the last two
    /// increments of a leg. `accepted` are the displacements of the later one.
    pub fn extrapolated(&self, accepted: BlockVector, load: f64, leg: &Leg) -> BlockVector {
        let Some((before, at)) = &self.before else { return accepted };
        let last = self.reached_measure(leg);
        if last - at <= f64::EPSILON * last.abs() || before.len() != accepted.len() {
            return accepted;
        }
        let part = ((load - last) / (last - at)).clamp(0.0, 1.5);
        let lines = before.iter().zip(&accepted);
        lines.map(|(u, v)| u.iter().zip(v).map(|(u, v)| v + part * (v - u)).collect()).collect()
    }

    /// The measure of a leg, force or approach, in the present state.
    pub fn reached_measure(&self, leg: &Leg) -> f64 {
        if leg.is_force { self.force } else { self.approach }
    }

    /// Whether loads before this one were larger.
    pub fn is_below_largest_load(&self) -> bool {
        let [force, approach] = self.reached;
        self.force < force && self.approach < approach
    }

    /// Records the outcome of an increment, before the system accepts it.
    pub fn accept(
        &mut self,
        system: &impl ContactSystem,
        outcome: &Outcome,
        target: ContactLoad,
        time: f64,
        leg: &Leg,
    ) {
        let response = &outcome.state.response;
        let contact = &response.contact;
        self.before =
            (!leg.falls()).then(|| (system.accepted().clone(), self.reached_measure(leg)));
        self.time = time;
        self.force = match target {
            ContactLoad::Force(force) => force,
            ContactLoad::Approach(_) => system.figures(contact).force,
        };
        self.approach = contact.approach;
        self.reached = [self.reached[0].max(self.force), self.reached[1].max(self.approach)];
        self.scales.force = self.scales.force.max(norm(&contact.force));
        self.scales.displacement =
            self.scales.displacement.max(system.norm(&response.displacement));
        let problem = system.contact_problem(system.initial_gap(), target);
        self.contact_scales = self.contact_scales.larger(kkt::scales(&problem, &contact.force));
    }
}
