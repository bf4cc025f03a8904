//! One mesh: build, iterate, and do it again if the mesh turns out too small.

#![expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a positive number of columns")]

use super::body::{BodyModel, PlasticReach};
use super::iteration::{Controls, Iteration, Outcome};
use super::patch::ContactPatch;
use super::phases::PhaseTimes;
use super::problem::Problem;
use super::solution::CoarseFigures;
use super::system::{PerModel, System};
use super::{Observer, SolveError, SolveStatus, coupling};
use crate::assembly::StressField;
use crate::contact::{ContactLoad, ContactSolver};
use crate::mesh::{ContactZone, Refinement};
use crate::model::SolverSettings;

/// What a pass is asked to do.
#[derive(Clone, Copy)]
pub(super) struct PassRequest<'a> {
    pub contact: &'a dyn ContactSolver,
    pub zone: ContactZone,
    pub refinement: Refinement,
    pub plastic_reach: PlasticReach,
    /// Load of both sides of the axis together.
    pub load: ContactLoad,
    pub solver: SolverSettings,
}

/// A discretized problem, and the displacements that the last loads left on it.
pub(super) struct Prepared {
    pub system: System,
    /// Load and displacements, the latest last; at most two.
    pub states: Vec<(f64, PerModel)>,
}

impl Prepared {
    /// Displacements to start a load from: on the straight line through the last two states, or the last one.
    fn start(&self, load: f64) -> Option<PerModel> {
        match self.states.as_slice() {
            [.., (before, u), (last, v)] if (last - before).abs() > f64::EPSILON * last.abs() => {
                let t = (load - last) / (last - before);
                let along = |(u, v): (&Vec<f64>, &Vec<f64>)| -> Vec<f64> {
                    u.iter().zip(v).map(|(u, v)| v + t * (v - u)).collect()
                };
                Some(u.iter().zip(v).map(along).collect())
            }
            [.., (_, v)] => Some(v.clone()),
            [] => None,
        }
    }
}

/// What came of a pass.
pub(super) struct Pass {
    pub system: System,
    pub outcome: Outcome,
    /// `None` where nothing touches.
    pub patch: Option<ContactPatch>,
    /// Whether the contact reaches the edge of the zone all the same.
    pub reaches_edge: bool,
    /// Times the zone was widened.
    pub enlargements: usize,
    /// Meshes made.
    pub meshes: usize,
    /// States of former loads on the same mesh.
    former_states: Vec<(f64, PerModel)>,
}

impl Pass {
    /// Distance from the middle of the contact up to which material yields \[mm\]; 0 if none does.
    pub fn plastic_radius(&self) -> f64 {
        let centre = self.system.zone.centre();
        let radii = self.system.bodies.iter().enumerate().map(|(k, body)| {
            if body.region.is_none() {
                return 0.0;
            }
            let nodal = body.nodal(&self.outcome.state.response.displacement[k]);
            let field = StressField::evaluate(&body.mesh, body.kinematics, &body.material, &nodal);
            let yielded = field.points.iter().flatten().filter(|point| point.yielded);
            yielded.map(|point| (point.position[0] - centre).hypot(point.position[1])).fold(0.0, f64::max)
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

    /// Connected parts of the contact.
    pub fn parts(&self) -> Vec<ContactPatch> {
        let (x, pressures) = self.system.pressure_over_x(&self.outcome.state.response.contact.force);
        ContactPatch::parts(&x, &pressures)
    }

    /// What the next load may start from.
    pub fn into_prepared(self, load: ContactLoad) -> Prepared {
        let mut states = self.former_states;
        states.push((load.magnitude(), self.outcome.state.response.displacement));
        let surplus = states.len().saturating_sub(2);
        states.drain(..surplus);
        Prepared { system: self.system, states }
    }
}

/// How much wider the zone becomes when the contact reaches its edge.
const ENLARGEMENT: f64 = 1.5;
/// Enlargements after which the contact is taken to be wider than the body.
const MAX_ENLARGEMENTS: usize = 12;

/// Solves on one mesh; on a wider one where the contact reaches the edge of the zone or the surfaces meet beyond
/// it, and with the whole body as plastic region where plastic flow leaves the one that was prepared.
pub(super) fn run(
    problem: &Problem,
    request: &PassRequest<'_>,
    prepared: Option<Prepared>,
    phases: &mut PhaseTimes,
    observer: &mut dyn Observer,
) -> Result<Pass, SolveError> {
    let mut request = *request;
    let mut available = prepared;
    let (mut enlargements, mut meshes) = (0, 0);
    loop {
        let prepared = if let Some(prepared) = available.take() {
            prepared
        } else {
            meshes += 1;
            let PassRequest { zone, refinement, plastic_reach, .. } = request;
            let system = System::build(problem, zone, refinement, plastic_reach, phases, observer)?;
            Prepared { system, states: Vec::new() }
        };
        let start = prepared.start(request.load.magnitude());
        let Prepared { system, states } = prepared;
        let zone = system.zone;
        let outcome = iterate(&system, &request, start, phases, observer)?;
        let interrupted = matches!(outcome.status, SolveStatus::Cancelled | SolveStatus::TimedOut);
        let whole = system.bodies.iter().all(BodyModel::covers_whole_body);
        if !interrupted && outcome.left_region && !whole {
            request.plastic_reach = PlasticReach::WholeBody;
            request.zone = zone;
            continue;
        }
        let reaches_edge = reaches_edge(&system, &outcome)
            || (problem.may_touch_elsewhere() && meets_beyond_zone(problem, &system, &outcome));
        if !interrupted && reaches_edge && enlargements < MAX_ENLARGEMENTS {
            let wider = enlarge(zone);
            if fits(problem, &wider) {
                enlargements += 1;
                request.zone = wider;
                continue;
            }
        }
        let (x, pressures) = system.pressure_over_x(&outcome.state.response.contact.force);
        let patch = ContactPatch::find(&x, &pressures, zone.symmetric);
        return Ok(Pass {
            system,
            outcome,
            patch,
            reaches_edge,
            enlargements,
            meshes,
            former_states: states,
        });
    }
}

fn enlarge(zone: ContactZone) -> ContactZone {
    let (centre, half) = (zone.centre(), ENLARGEMENT * zone.half_width());
    let columns = (zone.columns as f64 * ENLARGEMENT).round() as usize;
    let x_min = if zone.symmetric { 0.0 } else { centre - half };
    ContactZone { x_min, x_max: centre + half, columns, symmetric: zone.symmetric }
}

/// Whether a zone lies on both bodies.
fn fits(problem: &Problem, zone: &ContactZone) -> bool {
    problem.bodies.iter().all(|body| zone.fits(&body.outline))
}

fn iterate(
    system: &System,
    request: &PassRequest<'_>,
    start: Option<PerModel>,
    phases: &mut PhaseTimes,
    observer: &mut dyn Observer,
) -> Result<Outcome, SolveError> {
    let controls = Controls {
        contact: request.contact,
        load: system.part_of(request.load),
        tolerance: request.solver.tolerance.get(),
        max_iterations: request.solver.max_iterations as usize,
    };
    let iteration = Iteration::new(system, controls, start, observer, phases);
    coupling::run(iteration, request.solver.coupling)
}

/// Whether one of the outermost two pairs of an open end of the zone carries force.
fn reaches_edge(system: &System, outcome: &Outcome) -> bool {
    let active = &outcome.state.response.contact.active_set;
    let last = system.zone.columns;
    let right = active.contains(last) || active.contains(last.saturating_sub(1));
    let left = !system.zone.symmetric && (active.contains(0) || active.contains(1));
    right || left
}

/// Whether the free surfaces beside the zone have moved into each other.
///
/// The gap there is `δ0 + w_u + w_l - α` with the inward displacements w of both surfaces, each interpolated
/// between its own nodes.
fn meets_beyond_zone(problem: &Problem, system: &System, outcome: &Outcome) -> bool {
    let contact = &outcome.state.response.contact;
    let surfaces: Vec<Vec<[f64; 2]>> = system
        .bodies
        .iter()
        .enumerate()
        .map(|(k, body)| {
            let mut x = outcome.state.loads[k].clone();
            body.press(&contact.force, &mut x);
            let factor = outcome.state.factors.as_ref().map_or(&body.factor, |factors| &factors[k]);
            factor.solve(&mut x);
            body.free_surface(&x)
        })
        .collect();
    let (left, right) = problem.span();
    let inward = |x: f64| -> f64 {
        surfaces
            .iter()
            .zip(&system.multiplicity)
            .map(|(surface, n)| *n as f64 * interpolate(surface, x))
            .sum()
    };
    let abscissae = surfaces.iter().flatten().map(|point| point[0]).filter(|x| (left..=right).contains(x));
    let mut beyond =
        abscissae.filter(|x| *x > system.zone.x_max || (*x < system.zone.x_min && !system.zone.symmetric));
    beyond.any(|x| problem.initial_gap(x) + inward(x) - contact.approach < 0.0)
}

/// Piecewise linear through `[x, value]` in order of x; constant beyond the ends, zero where there is nothing.
fn interpolate(points: &[[f64; 2]], x: f64) -> f64 {
    let right = points.partition_point(|p| p[0] < x);
    match (right.checked_sub(1).map(|k| points[k]), points.get(right)) {
        (Some(a), Some(b)) => a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]),
        (Some(end), None) => end[1],
        (None, Some(end)) => end[1],
        (None, None) => 0.0,
    }
}
