//! Where a history is, from one increment to the next.

use super::increments::Leg;
use crate::contact::ContactLoad;
use crate::contact::kkt::ContactScales;
use crate::fem::assembly::GaussPoint;
use crate::solver::IncrementNumber;
use crate::solver::final_check;
use crate::solver::mesh_solve::MeshSolve;
use crate::solver::method::contact_system::{BlockVector, ContactSystem as _};
use crate::solver::method::couplings::iteration::{Scales, norm};

/// Where a history is.
pub(super) struct Progress {
    /// Displacements one increment before, and the load measure then.
    pub before: Option<(BlockVector, f64)>,
    pub time: f64,
    pub number: IncrementNumber,
    pub force: f64,
    pub approach: f64,
    /// Largest force and approach so far.
    pub reached: [f64; 2],
    pub scales: Scales,
    /// Largest scales of the contact conditions so far.
    pub contact_scales: ContactScales,
    /// Whether the load falls.
    pub is_falling: bool,
    /// Largest peak pressure so far, its x, and that of the middle of its contact.
    pub peak: [f64; 3],
    /// What the points of each model have been through.
    pub points: Vec<Vec<PointHistory>>,
}

/// What a point has been through, beyond the state of its law.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct PointHistory {
    /// Equivalent plastic strain.
    accumulated: f64,
    /// What of it came since the load last began to fall.
    reverse: f64,
    /// Largest von Mises stress \[MPa\].
    von_mises: f64,
}

impl Progress {
    /// Before the first load.
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
            is_falling: false,
            peak: [0.0; 3],
            points: Vec::new(),
        }
    }

    /// Turns to a load. What points gain while loads fall counts from where the first of them begins to fall.
    pub fn begin(&mut self, leg: &Leg) {
        if leg.falls() && !self.is_falling {
            self.points.iter_mut().flatten().for_each(|point| point.reverse = 0.0);
        }
        self.is_falling = leg.falls();
    }

    /// Displacements at a load on the straight line through the last two increments of a leg, the later of which has left
    /// these.
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

    pub fn reached_measure(&self, leg: &Leg) -> f64 {
        if leg.is_force { self.force } else { self.approach }
    }

    /// Whether loads before this one were larger.
    pub fn is_below_largest_load(&self) -> bool {
        let [force, approach] = self.reached;
        self.force < force && self.approach < approach
    }

    /// Takes over what an increment has found.
    pub fn accept(&mut self, solve: &mut MeshSolve, target: ContactLoad, time: f64, leg: &Leg) {
        let contact = &solve.outcome.state.response.contact;
        self.before = (!leg.falls()).then(|| {
            let accepted = solve.system.accepted.displacement.clone();
            (accepted, self.reached_measure(leg))
        });
        self.time = time;
        self.force = match target {
            ContactLoad::Force(force) => force,
            ContactLoad::Approach(_) => solve.system.figures(contact).force,
        };
        self.approach = contact.approach;
        self.reached = [self.reached[0].max(self.force), self.reached[1].max(self.approach)];
        self.scales.force = self.scales.force.max(norm(&contact.force));
        self.scales.displacement =
            self.scales.displacement.max(solve.system.norm(&solve.outcome.state.response.displacement));
        self.contact_scales = self.contact_scales.larger(final_check::contact_scales(solve, target));
        let plastic = solve.system.accepted.plastic.joined(&solve.yielded_envelope());
        let whole = solve.fields.iter().map(|field| field.displacement.clone()).collect();
        (solve.system.accepted.plastic, solve.system.accepted.whole) = (plastic, whole);
        self.points.resize_with(solve.fields.len(), Vec::new);
        for (field, histories) in solve.fields.iter_mut().zip(&mut self.points) {
            let points = field.stress.points.as_flattened_mut();
            histories.resize(points.len(), PointHistory::default());
            for (point, history) in points.iter_mut().zip(histories) {
                history.take(point, self.is_falling);
            }
        }
    }
}

impl PointHistory {
    /// Goes on to the end of an increment, and tells the point what it has been through.
    fn take(&mut self, point: &mut GaussPoint, is_falling: bool) {
        if is_falling {
            self.reverse += point.equivalent_plastic_strain - self.accumulated;
        }
        self.accumulated = point.equivalent_plastic_strain;
        self.von_mises = self.von_mises.max(point.largest_von_mises);
        point.reverse_plastic_strain = self.reverse;
        point.largest_von_mises = self.von_mises;
    }
}
