//! One mesh: build, iterate, and do it again if the mesh turns out too small.

use super::body::PlasticReach;
use super::iteration::{Controls, Iteration, Outcome};
use super::patch::ContactPatch;
use super::phases::PhaseTimes;
use super::problem::Problem;
use super::solution::CoarseFigures;
use super::system::System;
use super::{Observer, SolveError, SolveStatus, coupling};
use crate::assembly::StressField;
use crate::contact::{ContactLoad, ContactSolver};
use crate::mesh::{ContactZone, Refinement};
use crate::model::SolverSettings;

/// What a pass is asked to do.
#[derive(Clone, Copy)]
pub(super) struct PassRequest<'a> {
    pub contact: &'a dyn ContactSolver,
    /// Half-width of the candidate zone \[mm\].
    pub zone_half_width: f64,
    /// Elements over that half-width.
    pub columns: usize,
    pub refinement: Refinement,
    pub plastic_reach: PlasticReach,
    /// Load of both sides of the axis together.
    pub load: ContactLoad,
    pub solver: SolverSettings,
}

/// What came of it.
pub(super) struct Pass {
    pub system: System,
    pub outcome: Outcome,
    /// `None` where nothing touches.
    pub patch: Option<ContactPatch>,
    /// Whether the contact reaches the edge of the zone all the same.
    pub reaches_edge: bool,
    /// Times the zone was widened.
    pub enlargements: usize,
}

impl Pass {
    /// Distance from the middle of the contact up to which material yields \[mm\]; 0 if none does.
    pub fn plastic_radius(&self) -> f64 {
        let radii = self.system.bodies.iter().enumerate().map(|(k, body)| {
            let nodal = body.nodal(&self.outcome.state.response.displacement[k]);
            let field = StressField::evaluate(&body.mesh, body.kinematics, &body.material, &nodal);
            let yielded = field.points.iter().flatten().filter(|point| point.yielded);
            yielded.map(|point| point.position[0].hypot(point.position[1])).fold(0.0, f64::max)
        });
        radii.fold(0.0, f64::max)
    }

    /// Headline figures.
    pub fn figures(&self) -> Option<CoarseFigures> {
        let contact = &self.outcome.state.response.contact;
        Some(CoarseFigures {
            peak_pressure: self.system.peak_pressure(&contact.force),
            half_width: self.patch?.half_width(),
            approach: contact.approach,
        })
    }
}

/// How much wider the zone becomes when the contact reaches its edge.
const ENLARGEMENT: f64 = 1.5;
/// Enlargements after which the contact is taken to be wider than the body.
const MAX_ENLARGEMENTS: usize = 12;

/// Solves on one mesh; on a wider one where the contact reaches the edge of the zone, and with the whole body as
/// plastic region where plastic flow leaves the one that was prepared.
pub(super) fn run(
    problem: &Problem,
    request: &PassRequest<'_>,
    phases: &mut PhaseTimes,
    observer: &mut dyn Observer,
) -> Result<Pass, SolveError> {
    let mut request = *request;
    let mut enlargements = 0;
    loop {
        let zone = zone(problem, &request);
        let system =
            System::build(problem, zone, request.refinement, request.plastic_reach, phases, observer)?;
        let outcome = iterate(&system, &request, phases, observer)?;
        let interrupted = matches!(outcome.status, SolveStatus::Cancelled | SolveStatus::TimedOut);
        if !interrupted && outcome.left_region && request.plastic_reach != PlasticReach::WholeBody {
            request.plastic_reach = PlasticReach::WholeBody;
            continue;
        }
        let reaches_edge = reaches_edge(&system, &outcome);
        if !interrupted && reaches_edge && enlargements < MAX_ENLARGEMENTS {
            enlargements += 1;
            request.zone_half_width *= ENLARGEMENT;
            request.columns = (request.columns as f64 * ENLARGEMENT).round() as usize;
            continue;
        }
        let x: Vec<f64> = (0..=zone.columns).map(|k| zone.abscissa(k)).collect();
        let pressures = system.pressures(&outcome.state.response.contact.force);
        let patch = ContactPatch::find(&x, &pressures, zone.symmetric);
        return Ok(Pass { system, outcome, patch, reaches_edge, enlargements });
    }
}

fn zone(problem: &Problem, request: &PassRequest<'_>) -> ContactZone {
    let half = request.zone_half_width;
    if problem.is_symmetric() {
        ContactZone { x_min: 0.0, x_max: half, columns: request.columns, symmetric: true }
    } else {
        ContactZone { x_min: -half, x_max: half, columns: 2 * request.columns, symmetric: false }
    }
}

fn iterate(
    system: &System,
    request: &PassRequest<'_>,
    phases: &mut PhaseTimes,
    observer: &mut dyn Observer,
) -> Result<Outcome, SolveError> {
    let load = match request.load {
        ContactLoad::Force(force) => ContactLoad::Force(force / system.copies() as f64),
        approach @ ContactLoad::Approach(_) => approach,
    };
    let controls = Controls {
        contact: request.contact,
        load,
        tolerance: request.solver.tolerance.get(),
        max_iterations: request.solver.max_iterations as usize,
    };
    coupling::run(Iteration::new(system, controls, observer, phases), request.solver.coupling)
}

/// Whether one of the outermost two pairs of an open end of the zone carries force.
fn reaches_edge(system: &System, outcome: &Outcome) -> bool {
    let active = &outcome.state.response.contact.active_set;
    let last = system.zone.columns;
    let right = active.contains(last) || active.contains(last - 1);
    let left = !system.zone.symmetric && (active.contains(0) || active.contains(1));
    right || left
}
