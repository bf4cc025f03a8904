//! One mesh solve: its request, its result, and the contact zone of the next one.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a positive number of columns"
)]

use std::sync::Arc;

use crate::assembly::{Extent, StressField};
use crate::engine::body_solution::BodySolution;
use crate::engine::body_system::body::BodyModel;
use crate::engine::body_system::contact_patch::{ContactPatch, Pairs};
use crate::engine::body_system::factor_cache::FactorCache;
use crate::engine::body_system::plastic_search_region::{PlasticSearchRegion, RadialEnvelope};
use crate::engine::body_system::system::System;
use crate::engine::body_system::transfer::NodalField;
use crate::engine::problem::Problem;
use crate::engine::solution::pressure_in_middle;
use crate::mesh::{ContactZone, ROUNDING, Refinement};
use brinell_contact::{ContactLoad, ContactSolver};
use brinell_method::contact_system::ContactSystem as _;
use brinell_method::couplings::iteration::{Controls, Outcome, Scales};
use brinell_method::figures::{BodyFigures, Figures};
use brinell_method::final_check::COLLAPSE_STRAIN;
use brinell_method::observer::ask;
use brinell_method::observer::{IncrementNumber, Interrupt, Observer};
use brinell_method::settings::Settings;

/// The request for a mesh solve.
#[derive(Clone)]
pub(crate) struct MeshSolveRequest<'a> {
    pub contact: &'a dyn ContactSolver,
    pub zone: ContactZone,
    pub refinement: Refinement,
    pub search_region: PlasticSearchRegion,
    /// Load of both sides of the axis together.
    pub load: ContactLoad,
    pub solver: Settings,
    /// The answer on another mesh as initial state, one field for each model.
    pub previous: Option<&'a [NodalField<'a>]>,
    /// Bodies and factors of earlier jobs.
    pub cache: Option<&'a Arc<FactorCache>>,
    /// Least scales of residuals.
    pub scales: Scales,
    /// The increment of a history.
    pub increment: Option<IncrementNumber>,
}

impl MeshSolveRequest<'_> {
    /// Returns the settings of the iteration.
    pub fn controls(&self) -> Controls<'_> {
        Controls {
            contact: self.contact,
            load: self.load,
            tolerance: self.solver.tolerance,
            max_iterations: self.solver.max_iterations,
            renewable: false,
            scales: self.scales,
            increment: self.increment,
        }
    }
}

/// The state of one whole model.
pub(crate) struct ModelField {
    /// Displacements by equation \[mm\].
    pub displacement: Vec<f64>,
    /// Displacements `[u_x, u_y]` of every node \[mm\].
    pub nodal: Vec<[f64; 2]>,
    pub stress: StressField,
}

/// The result of a mesh solve.
pub(crate) struct MeshSolve {
    pub system: System,
    pub outcome: Outcome,
    /// The state of each whole model; empty if it was stopped.
    pub fields: Vec<ModelField>,
    /// `None` where nothing touches.
    pub patch: Option<ContactPatch>,
    /// The ends by which the next mesh is sized.
    pub sizing_patch: Option<ContactPatch>,
    /// Whether the contact still reaches the edge of the zone.
    pub reaches_edge: bool,
    /// Interval beyond the zone on which the surfaces penetrate each other \[mm\].
    pub meets: Option<(f64, f64)>,
    /// Number of enlargements of the zone.
    pub enlargements: usize,
}

impl MeshSolve {
    /// Assembles the result of an iteration.
    pub fn of(
        problem: &Problem,
        system: System,
        outcome: Outcome,
        fields: Vec<ModelField>,
    ) -> Self {
        let Found { patch, sizing_patch, reaches_edge, meets } =
            find_contact(problem, &system, &outcome, &fields);
        let enlargements = 0;
        Self { system, outcome, fields, patch, sizing_patch, reaches_edge, meets, enlargements }
    }

    /// Returns the extent of plastic flow.
    pub fn yielded_envelope(&self) -> RadialEnvelope {
        let points = self.fields.iter().flat_map(|field| field.stress.points.iter().flatten());
        let yielded = points.filter(|point| point.yielded).map(|point| point.position);
        RadialEnvelope::around(self.system.zone.centre(), yielded)
    }

    /// Whether any point has yielded.
    pub fn yields(&self) -> bool {
        self.fields
            .iter()
            .flat_map(|field| field.stress.points.iter().flatten())
            .any(|point| point.yielded)
    }

    /// Whether the material yields outside the plastic region.
    pub fn yields_outside_region(&self) -> bool {
        let mut bodies = self.system.bodies.iter().zip(&self.fields);
        bodies.any(|(body, field)| body.yields_outside_region(&field.stress))
    }

    /// Returns the answer as the initial state on another mesh.
    pub fn nodal_fields(&self) -> Vec<NodalField<'_>> {
        let fields = self.system.bodies.iter().zip(&self.fields);
        fields
            .map(|(body, field)| NodalField {
                mesh: &body.elastic.mesh,
                displacement: &field.nodal,
            })
            .collect()
    }

    /// x of the middle of the contact, 0 of half models and where nothing touches \[mm\].
    pub fn middle(&self) -> f64 {
        match self.patch {
            Some(patch) if !self.system.zone.is_symmetric() => 0.5 * (patch.left + patch.right),
            _ => 0.0,
        }
    }

    /// x of the middle of the contact and its largest half-width so far \[mm\].
    pub fn middle_and_widest(&self) -> [f64; 2] {
        [self.middle(), self.widest()]
    }

    /// Pressure in the middle of the contact \[MPa\].
    fn middle_pressure(&self) -> f64 {
        let (x, pressure) =
            self.system.pressure_over_x(&self.outcome.state.response.contact.force);
        pressure_in_middle(self.system.stress_state, self.middle(), &x, &pressure)
    }

    /// All figures.
    pub fn measure(&self) -> Figures {
        Figures { bodies: self.body_figures(), ..self.figures() }
    }

    /// Connected parts of the contact.
    pub fn parts(&self) -> Vec<ContactPatch> {
        let (x, pressures) =
            self.system.pressure_over_x(&self.outcome.state.response.contact.force);
        ContactPatch::parts(&x, &pressures)
    }

    /// Takes the system, with the displacements of this load.
    pub fn into_system(self, load: ContactLoad) -> System {
        let displacement = self.fields.into_iter().map(|field| field.displacement).collect();
        let mut system = self.system;
        system.remember(load.magnitude(), displacement);
        system
    }
}

impl MeshSolve {
    /// Headline figures of the contact; zeros without contact.
    pub fn figures(&self) -> Figures {
        let contact = self.system.figures(&self.outcome.state.response.contact);
        let half_width = self.patch.map_or(0.0, |patch| patch.half_width());
        Figures { middle_pressure: Some(self.middle_pressure()), ..contact.headline(half_width) }
    }

    /// Figures of both bodies.
    fn body_figures(&self) -> [Option<BodyFigures>; 2] {
        let (system, symmetric) = (&self.system, self.system.zone.is_symmetric());
        let pressure = system.pressures(&self.outcome.state.response.contact.force);
        let of_model: Vec<Option<BodyFigures>> = system
            .bodies
            .iter()
            .zip(&self.fields)
            .map(|(body, field)| {
                let solution = BodySolution::of(
                    body,
                    field.nodal.clone(),
                    field.stress.clone(),
                    self.middle_and_widest(),
                );
                solution.figures(system.stress_state, symmetric, self.middle(), &pressure)
            })
            .collect();
        system.model_of.map(|model| model.and_then(|k| *of_model.get(k)?))
    }

    /// Largest half-width of the contact so far, this load included \[mm\].
    pub fn widest(&self) -> f64 {
        let half_width = self.patch.map_or(0.0, |patch| patch.half_width());
        half_width.max(self.system.accepted.half_width)
    }

    /// Whether strains have outgrown the theory of small strains.
    pub fn has_collapsed(&self) -> bool {
        if !self.outcome.is_conclusive {
            return false;
        }
        // Strain stays where the load falls and the contact becomes narrow.
        let half_width = self.widest();
        let least_area = COLLAPSE_AREA * half_width * half_width;
        self.system.bodies.iter().zip(&self.fields).any(|(body, field)| {
            let accumulates = body.model.has_memory();
            let points = field.stress.points.iter().flatten();
            let strained = points.filter(|point| point.strain(accumulates) > COLLAPSE_STRAIN);
            strained.map(|point| point.area).sum::<f64>() > least_area
        })
    }
}

/// Area of the section that strains so much, over the square of the half-width. Beside a sharp edge
/// or tip strains grow without bound under any load: below a cone of 20° that does not harden they
/// exceed 1 over 1/130.
const COLLAPSE_AREA: f64 = 1.0 / 50.0;

/// Growth of a zone whose edge the contact reaches.
pub(crate) const ENLARGEMENT: f64 = 1.5;
/// Largest number of columns of a widened zone over its first number of columns; a wider zone has
/// larger elements. The parts of a contact are resolved finer than its whole width by this ratio
/// at most, and a contact that grows more was sized for a smaller one.
const MOST_COLUMNS: usize = 6;
/// Margin of a zone beyond the place where the surfaces meet, over its half-width.
const BEYOND_MEETING: f64 = 0.1;
/// Factor of the width of a zone when the rings around it cannot be meshed.
const NARROWING: f64 = 0.9;
/// Computes the full displacement field of each model and evaluates the material law in this extent;
/// returns nothing if the observer stops the solve.
pub(crate) fn fields(
    system: &System,
    outcome: &mut Outcome,
    extent: Extent,
    observer: &mut dyn Observer,
) -> Vec<ModelField> {
    if outcome.status.is_stopped() {
        return Vec::new();
    }
    let state = &outcome.state;
    let mut field = |k: usize, body: &BodyModel| -> Result<ModelField, Interrupt> {
        ask(observer)?;
        let displacement = if state.is_complete {
            state.response.displacement[k].clone()
        } else {
            let mut displacement = state.loads[k].clone();
            body.elastic.add_contact_forces(&state.response.contact.force, &mut displacement);
            body.factor.solve(&mut displacement);
            displacement
        };
        ask(observer)?;
        let nodal = body.elastic.nodal(&displacement);
        let stress = body.stress_field(&nodal, extent);
        ask(observer)?;
        Ok(ModelField { displacement, nodal, stress })
    };
    let bodies = system.bodies.iter().enumerate();
    let fields: Result<Vec<_>, _> = bodies.map(|(k, body)| field(k, body)).collect();
    fields.unwrap_or_else(|interrupt| {
        outcome.status = interrupt.into();
        Vec::new()
    })
}

/// Returns the largest number of columns of this zone after widening.
pub(crate) fn most_columns(zone: &ContactZone) -> usize {
    MOST_COLUMNS * zone.columns()
}

/// Returns a wider zone, as far as the surfaces `meet` beyond the present one; a zone without room
/// on one side grows on the other. The element size stays the same up to `most` columns. `None` if
/// there is no room.
pub(crate) fn enlarged(
    problem: &Problem,
    zone: &ContactZone,
    meet: Option<(f64, f64)>,
    most: usize,
) -> Option<ContactZone> {
    let wider = enlarge(problem, zone, meet, most);
    (fits(problem, &wider) && wider.half_width() > zone.half_width()).then_some(wider)
}

fn enlarge(
    problem: &Problem,
    zone: &ContactZone,
    meet: Option<(f64, f64)>,
    most: usize,
) -> ContactZone {
    let wider = resized(problem, zone, ENLARGEMENT);
    if problem.conforming.is_some() {
        return wider;
    }
    let (left, right) = problem.room();
    let (mut x_min, mut x_max) = (wider.x_min().max(left), wider.x_max().min(right));
    let is_far = |(from, to): &(f64, f64)| *to > x_max || (*from < x_min && !zone.is_symmetric());
    let meets_far = meet.filter(is_far);
    if let Some((from, to)) = meets_far {
        let margin = BEYOND_MEETING * 0.5 * (to.max(x_max) - from.min(x_min));
        x_max = x_max.max(to + margin).min(right);
        if !zone.is_symmetric() {
            x_min = x_min.min(from - margin).max(left);
        }
    }
    if meets_far.is_none() && wider.columns() <= most && fits(problem, &wider) {
        return wider;
    }
    let columns = (((x_max - x_min) / zone.spacing() - ROUNDING).ceil() as usize).min(most);
    problem.zone(x_min, x_max, columns, zone.is_symmetric())
}

pub(crate) fn narrow(problem: &Problem, zone: &ContactZone) -> ContactZone {
    resized(problem, zone, NARROWING)
}

/// Returns a zone wider by a factor, with elements of the same size.
fn resized(problem: &Problem, zone: &ContactZone, factor: f64) -> ContactZone {
    let (centre, mut half) = (zone.centre(), factor * zone.half_width());
    let mut columns =
        ((zone.x_max() - zone.x_min()) / zone.spacing() * factor + ROUNDING).round() as usize;
    if problem.conforming.is_some() && half > problem.span().1 {
        // The whole circumference of a pin in a hole.
        half = problem.span().1;
        columns = (half / zone.spacing() - ROUNDING).ceil() as usize;
    }
    let x_min = if zone.is_symmetric() { 0.0 } else { centre - half };
    problem.zone(x_min, centre + half, columns, zone.is_symmetric())
}

/// Whether a zone lies on both bodies.
pub(crate) fn fits(problem: &Problem, zone: &ContactZone) -> bool {
    problem.bodies.iter().all(|body| zone.fits(&body.outline))
}

/// The ends of the contact, and whether the contact extends beyond the zone.
struct Found {
    patch: Option<ContactPatch>,
    sizing_patch: Option<ContactPatch>,
    reaches_edge: bool,
    meets: Option<(f64, f64)>,
}

fn find_contact(
    problem: &Problem,
    system: &System,
    outcome: &Outcome,
    fields: &[ModelField],
) -> Found {
    let contact = &outcome.state.response.contact;
    let (x, pressure) = system.pressure_over_x(&contact.force);
    let symmetric = system.zone.is_symmetric();
    let pairs = Pairs { x: &x, pressure: &pressure, gap: &contact.gap, symmetric };
    let within = |patch: ContactPatch| patch.within(problem.walls());
    let patch = ContactPatch::find(pairs, |k| system.zone.edge(k)).map(within);
    let sizing_patch = ContactPatch::for_sizing(pairs, |k| system.zone.edge(k)).map(within);
    let is_known = !outcome.status.is_stopped() && problem.may_touch_elsewhere();
    let meets = is_known.then(|| meets_beyond_zone(problem, system, outcome, fields)).flatten();
    let reaches_edge = meets.is_some() || reaches_edge(problem, system, outcome);
    Found { patch, sizing_patch, reaches_edge, meets }
}

/// Whether one of the outermost two pairs of an open end of the zone carries force; only the
/// outermost pair counts where the zone is the whole circumference of a pin in a hole.
fn reaches_edge(problem: &Problem, system: &System, outcome: &Outcome) -> bool {
    let active = &outcome.state.response.contact.active_set;
    let last = system.zone.columns();
    let is_whole = problem.conforming.is_some() && system.zone.x_max() >= problem.span().1;
    let right = active.contains(last) || (!is_whole && active.contains(last.saturating_sub(1)));
    let left = !system.zone.is_symmetric() && (active.contains(0) || active.contains(1));
    right || left
}

/// Returns the interval beside the zone on which the free surfaces penetrate each other.
///
/// The gap there is `δ0 + w_u + w_l - α` with the inward displacements w of both surfaces, each
/// interpolated between its own nodes.
fn meets_beyond_zone(
    problem: &Problem,
    system: &System,
    outcome: &Outcome,
    fields: &[ModelField],
) -> Option<(f64, f64)> {
    let contact = &outcome.state.response.contact;
    let bodies = system.bodies.iter().zip(fields);
    let surfaces: Vec<Vec<[f64; 2]>> =
        bodies.map(|(body, field)| body.elastic.free_surface(&field.displacement)).collect();
    let (left, right) = problem.span();
    let inward = |x: f64| -> f64 {
        surfaces
            .iter()
            .zip(&system.bodies_represented)
            .map(|(surface, n)| *n as f64 * interpolate(surface, x))
            .sum()
    };
    let nodes =
        surfaces.iter().flatten().map(|point| point[0]).filter(|x| (left..=right).contains(x));
    let abscissae = nodes.chain(problem.knots_within(left, right).iter().copied());
    let zone = &system.zone;
    let beyond =
        abscissae.filter(|x| *x > zone.x_max() || (*x < zone.x_min() && !zone.is_symmetric()));
    let meeting = beyond.filter(|&x| problem.initial_gap(x) + inward(x) - contact.approach < 0.0);
    meeting.fold(None, |range, x| {
        let (from, to) = range.unwrap_or((x, x));
        Some((x.min(from), x.max(to)))
    })
}

/// Interpolates `[x, value]`, in order of x, linearly; constant beyond the ends, zero without
/// points.
fn interpolate(points: &[[f64; 2]], x: f64) -> f64 {
    let right = points.partition_point(|p| p[0] < x);
    match (right.checked_sub(1).map(|k| points[k]), points.get(right)) {
        (Some(a), Some(b)) => a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]),
        (Some(end), None) => end[1],
        (None, Some(end)) => end[1],
        (None, None) => 0.0,
    }
}
