//! The final check: it judges the last state by full displacement fields and the material law in
//! the whole bodies.

mod contact_stiffness;
mod edge_contact;

use std::sync::Arc;

use contact_stiffness::elastic_stiffness;
use edge_contact::EdgeContact;

use std::f64::consts::PI;

use crate::assembly::StressField;
use crate::element::StressState;
use crate::engine::ContactPatch;
use crate::engine::body_solution::BodySolution;
use crate::engine::body_system::body::BodyModel;
use crate::engine::body_system::system::System;
use crate::engine::mesh_solve::MeshSolve;
use crate::engine::problem::Problem;
use crate::engine::solution::{NarrowEdge, PairState, RoundedTip, SectionField, StepSolution};
use brinell_contact::kkt::ContactScales;
use brinell_contact::{ContactLoad, KktReport};
use brinell_material::{ElasticModuli, von_mises};
use brinell_method::Interrupted as _;
use brinell_method::contact_system::Linearize as _;
use brinell_method::couplings::iteration::{Outcome, norm, relative};
use brinell_method::final_check::{Evidence, LeastScales, judge};
use brinell_method::observer::{Interrupt, Observer, SolveStatus, ask};
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use brinell_method::steps::{Checks, Energy, Path, Search, Step};

/// Elements over half of the arc of a tip with which the pressure on it is known to two per cent.
pub const TIP_ELEMENTS: f64 = 4.0;

/// x of the largest pressure that a history had, and of the middle of its contact \[mm\].
pub(crate) type LastPeak = [f64; 2];

/// Judges the final state by full displacement fields and the material law in the whole bodies,
/// without results of the iteration. Takes stresses and nodal displacements out of the mesh solve.
/// Where nothing touches, peak and middle are those of `last_peak`.
pub(crate) fn finish(
    problem: &Problem,
    pass: &mut MeshSolve,
    load: ContactLoad,
    tolerance: f64,
    (least, last_peak): (LeastScales, Option<LastPeak>),
    run: &mut Run<'_>,
) -> StepSolution {
    let contact_stiffness =
        if pass.yields() { Ok(None) } else { unyielding_stiffness(problem, pass, run) };
    let contact_stiffness = contact_stiffness.unwrap_or_else(|interrupt| {
        pass.outcome.status = interrupt.into();
        None
    });
    run.time_observed(Phase::Output, |observer| {
        let (evidence, bodies) = from_fields(pass, least.residual, last_peak, observer)
            .unwrap_or_else(|interrupt| {
                pass.outcome.status = interrupt.into();
                from_iteration(pass)
            });
        let contact_stiffness = contact_stiffness.filter(|_| !pass.outcome.status.is_stopped());
        let judged = judge(&pass.system, &pass.outcome, &evidence, load, tolerance, least.contact);
        let mut step = step(pass, evidence, &bodies, judged, last_peak, load);
        step.contact_stiffness = contact_stiffness;
        step.field.rounded_edge = unresolved_edge(problem, &step);
        step.field.rounded_tip = unresolved_tip(problem, &step);
        step
    })
}

/// Returns the rounded edge of a punch, if the elements are too large for the contact on it.
fn unresolved_edge(problem: &Problem, step: &StepSolution) -> Option<NarrowEdge> {
    let edge =
        EdgeContact::of(problem, step.field.patch?, step.field.spacing, step.figures.force)?;
    let EdgeContact { elastic, flat } = edge;
    edge.is_narrow(step.field.spacing)
        .then(|| NarrowEdge { elastic, half_width: flat + elastic.width() })
}

/// Returns the tip in the middle of the contact, if it is too narrow for the elements.
fn unresolved_tip(problem: &Problem, step: &StepSolution) -> Option<RoundedTip> {
    let (arc, half_width) = (problem.tip_arc(), step.figures.half_width);
    let patch = step.field.patch.filter(|patch| patch.left <= 0.0)?;
    if let Some(exponent) = problem.pointed_exponent() {
        return Some(RoundedTip { arc: None, elastic_pressure: pointed_pressure(step, exponent) });
    }
    if arc >= half_width || arc >= TIP_ELEMENTS * step.field.spacing || patch.right < arc {
        return None;
    }
    let elastic_pressure = problem.elastic_pressure_in_middle(half_width);
    Some(RoundedTip { arc: Some(arc), elastic_pressure })
}

/// Pressure in the middle under a power on an elastic half-space, as a sum of flat punches whose
/// forces grow with the half-width s as `sⁿ` (plane) and `sⁿ⁺¹` (axisymmetric) \[MPa\].
fn pointed_pressure(step: &StepSolution, exponent: f64) -> f64 {
    let (force, half_width) = (step.figures.force, step.figures.half_width);
    let rest = exponent - 1.0;
    match step.field.stress_state {
        StressState::Axisymmetric => {
            0.5 * (exponent + 1.0) / rest * force / (PI * half_width * half_width)
        }
        StressState::PlaneStrain | StressState::PlaneStress => {
            exponent / rest * force / (PI * half_width)
        }
    }
}

/// Returns the state of the last iteration, without stresses and stiffness.
pub(crate) fn as_iterated(pass: &MeshSolve, load: ContactLoad, tolerance: f64) -> StepSolution {
    let (evidence, bodies) = from_iteration(pass);
    let judged =
        judge(&pass.system, &pass.outcome, &evidence, load, tolerance, ContactScales::default());
    step(pass, evidence, &bodies, judged, None, load)
}

/// Slope of the load-approach curve of bodies that have not yielded, which no narrow edge of a
/// punch holds \[N/mm per mm\].
fn unyielding_stiffness(
    problem: &Problem,
    pass: &mut MeshSolve,
    run: &mut Run<'_>,
) -> Result<Option<f64>, Interrupt> {
    let (spacing, force) = (pass.system.zone.spacing(), pass.figures().force);
    let is_held = |patch| {
        EdgeContact::of(problem, patch, spacing, force).is_some_and(|edge| edge.is_narrow(spacing))
    };
    let patch = pass.patch.filter(|patch| !is_held(*patch));
    stiffness_of_elastic_bodies(pass, patch, run)
}

/// Slope of the load-approach curve where the load begins to fall: plastic strain stays as it is,
/// so that it is that of the elastic bodies with these pairs in contact \[N/mm per mm\].
pub(crate) fn unloading_stiffness(pass: &mut MeshSolve, run: &mut Run<'_>) -> Option<f64> {
    // A job that is stopped here still returns its last increment.
    stiffness_of_elastic_bodies(pass, pass.patch, run).unwrap_or(None)
}

/// `None` where the solve was stopped, or the elastic bodies have no factor.
fn stiffness_of_elastic_bodies(
    pass: &mut MeshSolve,
    patch: Option<ContactPatch>,
    run: &mut Run<'_>,
) -> Result<Option<f64>, Interrupt> {
    let MeshSolve { system, outcome, .. } = pass;
    if outcome.status.is_stopped() {
        return Ok(None);
    }
    if let Err(error) = system.linearize(None, run) {
        return error.interrupt().map_or(Ok(None), Err);
    }
    Ok(Some(run.time(Phase::Solves, || elastic_stiffness(system, &outcome.state, patch))))
}

/// Energies of the bodies of a history.
fn energy(system: &System, outcome: &Outcome, bodies: &[Arc<BodySolution>]) -> Option<Energy> {
    outcome.history.last()?.increment?;
    let mut energy = Energy::default();
    for (k, (body, model)) in bodies.iter().zip(&system.bodies).enumerate() {
        let ElasticModuli { bulk, shear } = body.model.elastic();
        let copies = system.copies(k) as f64;
        let density = |stress: [f64; 4]| {
            let pressure = (stress[0] + stress[1] + stress[2]) / 3.0;
            von_mises(stress).powi(2) / (6.0 * shear) + pressure * pressure / (2.0 * bulk)
        };
        // The energy stored before the load is not work of the load.
        if let Some(initial) = &body.initial_stress {
            for (point, stress) in
                body.stress.points.iter().flatten().zip(initial.iter().flatten())
            {
                energy.elastic -= copies * point.weight * density(*stress);
            }
            energy.elastic -= copies * model.work_of_initial_stress(&body.displacement);
        }
        for point in body.stress.points.iter().flatten() {
            let weight = copies * point.weight;
            energy.elastic += weight * density(point.stress);
            energy.plastic_work += weight * point.plastic_work;
            energy.backstress += weight * point.backstress_energy;
        }
    }
    Some(energy)
}

/// The fields of each model.
type Bodies = Vec<Arc<BodySolution>>;

/// By the fields, unless the iteration was stopped and has none. The observer can stop it here as
/// well.
fn from_fields(
    pass: &mut MeshSolve,
    force_scale: f64,
    last_peak: Option<LastPeak>,
    observer: &mut dyn Observer,
) -> Result<(Evidence, Bodies), Interrupt> {
    if pass.outcome.status.is_stopped() {
        return Ok(from_iteration(pass));
    }
    // This precedes the move of the stresses.
    let has_collapsed = pass.has_collapsed();
    let (system, outcome) = (&pass.system, &pass.outcome);
    let contact = &outcome.state.response.contact;
    let mut squares = 0.0;
    let mut unloaded_gap = system.initial_gap.clone();
    let mut bodies = Vec::with_capacity(system.bodies.len());
    let [middle, widest] = pass.middle_and_widest();
    let middle = last_peak.filter(|_| pass.patch.is_none()).map_or(middle, |[_, middle]| middle);
    for ((body, field), &copies) in
        system.bodies.iter().zip(&mut pass.fields).zip(&system.bodies_represented)
    {
        ask(observer)?;
        let (nodal, stress) =
            (std::mem::take(&mut field.nodal), std::mem::take(&mut field.stress));
        let copies = copies as f64;
        squares += copies * body.residual_norm(&stress, &contact.force).powi(2);
        for (g, w) in
            unloaded_gap.iter_mut().zip(body.elastic.contact_displacement(&field.displacement))
        {
            *g += copies * w;
        }
        bodies.push(Arc::new(BodySolution::of(body, nodal, stress, [middle, widest])));
    }
    let equilibrium_residual = relative(squares.sqrt(), norm(&contact.force).max(force_scale));
    ask(observer)?;
    let reaches_edge = pass.reaches_edge;
    Ok((Evidence { unloaded_gap, equilibrium_residual, has_collapsed, reaches_edge }, bodies))
}

/// Takes the step from the last iterate, because a stopped iteration has no fields.
fn from_iteration(pass: &MeshSolve) -> (Evidence, Bodies) {
    let (system, outcome) = (&pass.system, &pass.outcome);
    let without_fields = |body: &BodyModel| {
        Arc::new(BodySolution::of(body, Vec::new(), StressField::default(), [0.0; 2]))
    };
    let bodies = system.bodies.iter().map(without_fields).collect();
    (Evidence::of_iteration(system, outcome, pass.reaches_edge), bodies)
}

fn step(
    pass: &MeshSolve,
    evidence: Evidence,
    bodies: &[Arc<BodySolution>],
    (status, contact_check): (SolveStatus, KktReport),
    last_peak: Option<LastPeak>,
    load: ContactLoad,
) -> StepSolution {
    let Evidence { unloaded_gap, equilibrium_residual, has_collapsed, reaches_edge } = evidence;
    let (system, outcome) = (&pass.system, &pass.outcome);
    let contact = &outcome.state.response.contact;
    let limit = bearable_pressure(system.stress_state, bodies);
    let pairs = pair_states(system, &contact.force, &unloaded_gap, contact.approach, limit);
    let found = [peak_position(&pairs), pass.middle()];
    let [peak_position, middle] = last_peak.filter(|_| pass.patch.is_none()).unwrap_or(found);
    let field = SectionField {
        symmetric: system.zone.is_symmetric(),
        stress_state: system.stress_state,
        conforming: system.conforming,
        smallest_gap: system.smallest_gap,
        spacing: system.zone.spacing(),
        peak_position,
        middle,
        pairs,
        patch: pass.patch,
        parts: pass.parts(),
        bodies: system.model_of.map(|model| model.map(|k| Arc::clone(&bodies[k]))),
        loaded_corners: system.loaded_corners(&contact.force),
        unresolved: None,
        rounded_edge: None,
        rounded_tip: None,
        unloading_stiffness: 0.0,
    };
    let peak_pressure = system.peak_pressure(&contact.force).min(limit);
    Step {
        status,
        load,
        figures: field.figures(contact.approach, peak_pressure),
        coarse: None,
        increment_error: None,
        checks: Checks {
            contact: contact_check,
            residual: equilibrium_residual,
            reaches_edge,
            has_collapsed,
        },
        history: outcome.history.clone(),
        path: Path { energy: energy(system, outcome, bodies), ..Path::default() },
        search: Search::default(),
        contact_stiffness: None,
        enlargements: pass.enlargements,
        is_preliminary: false,
        field,
    }
}

/// x of the largest pressure \[mm\].
fn peak_position(pairs: &[PairState]) -> f64 {
    let highest = pairs.iter().max_by(|a, b| a.pressure.total_cmp(&b.pressure));
    highest.map_or(0.0, |pair| pair.x)
}

/// Largest pressure that bodies bear which yield in plane stress \[MPa\]: `σ_n² - σ_n σ_t + σ_t² =
/// q²` has no `σ_n` beyond `2 q/√3`. Where a plateau ends between two pairs, the last one of it
/// has the force of a part of the next, and more pressure than that.
fn bearable_pressure(state: StressState, bodies: &[Arc<BodySolution>]) -> f64 {
    let of = |body: &Arc<BodySolution>| {
        let stresses = body.stress.points.iter().flatten().map(|point| von_mises(point.stress));
        (body.max_plastic_strain() > 0.0).then(|| 2.0 / 3f64.sqrt() * stresses.fold(0.0, f64::max))
    };
    let limits = bodies.iter().filter(|_| state == StressState::PlaneStress).filter_map(of);
    limits.fold(f64::INFINITY, f64::min)
}

fn pair_states(
    system: &System,
    force: &[f64],
    unloaded_gap: &[f64],
    approach: f64,
    limit: f64,
) -> Vec<PairState> {
    let pressures = system.pressures(force);
    (0..force.len())
        .map(|k| PairState {
            x: system.zone.abscissa(k),
            pressure: pressures[k].min(limit),
            force: system.pair_force(k, force[k]),
            closing: system.closing[k],
            // In contact the gap is zero by definition; the rounding error there is checked, not
            // reported.
            gap: if force[k] > 0.0 { 0.0 } else { unloaded_gap[k] - approach * system.closing[k] },
        })
        .collect()
}
