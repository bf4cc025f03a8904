//! Remarks on the validity of an answer.

use serde::{Deserialize, Serialize};

use super::mesh_effects::{
    COARSE_MESH, is_clamped_column, is_ring_on_few_elements, peak_is_next_to_end,
    peak_is_unbounded,
};
use super::run::{CONFORMING_ADVICE, lies_in_groove};
use super::surface_stress::UncertainStress;
use super::units::rounded;
use super::{error_bars, onset, plastic_strain, strength};
use crate::contact::{ContactLoad, KktReport};
use crate::fem::mesh::Outline;
use crate::job::{
    Body, Coupling, HistoryLoad, Job, Load, MeshSettings, PositiveF64, SolverSettings, Theory,
    Units,
};
use crate::solver::outline_of;
use crate::solver::{
    IterationRecord, LastIncrement, MAX_HALF_ANGLE, PairState, RoundedTip, SolveStatus,
    StepSolution, TIP_ELEMENTS,
};

/// One remark on the validity of the answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ValidityNote {
    /// Stable identifier.
    pub code: String,
    /// For a person.
    pub message: String,
}

/// Every code that a remark can have.
pub const VALIDITY_CODES: &[&str] = &[
    "not_converged",
    "cancelled",
    "timed_out",
    "slow_coupling",
    "wide_contact",
    "large_strain",
    "collapse",
    "deformation_theory",
    "falling_loads",
    "no_contact",
    "contact_at_edge",
    "coarse_mesh",
    "coarse_case",
    "onset_unknown",
    "unbounded_strain",
    "bilinear_curve",
    "initial_yield",
    "yield_by_hardness",
    "near_support",
    "sharp_corner",
    "suspicious_units",
    "half_spaces",
    "roller_end",
    "surface_end",
];

pub(super) const AT_EDGE: &str = "The contact still reaches the edge of the meshed contact zone; \
                                  pressure beyond it is missing.";

/// Young's modulus \[MPa\] below which the job probably gives MPa in place of Pa.
const SOFT: f64 = 1.0;
pub(super) const SUSPICIOUS_UNITS: &str = "Units are SI, but the figures look like millimetres, \
                                           newtons and megapascals: metres, N/m and pascals are \
                                           expected. If they are meant in mm, leave `units` out.";

/// Half-width over the smallest radius above which the surfaces deviate too far from their
/// tangent.
pub(super) const WIDE_CONTACT: f64 = 0.1;
/// Slope of a surface above which the contact is called wide. A smooth curve through the points of
/// a flank with a slope of 10 % has slopes up to 15 %.
const STEEP: f64 = 0.15;
/// Work for a load above which the remark `slow_coupling` is due, in evaluations of the plastic
/// law. A factorization counts as `FACTORIZATION` evaluations.
///
/// Among 40 random jobs most took 10 to 20 evaluations for a load. All jobs that took more than 20
/// times the median time of jobs of their size get the remark.
const MUCH_WORK: usize = 200;
const FACTORIZATION: usize = 10;
/// Number of meshes above which a search for a force is called long.
const MANY_MESHES: usize = 40;
/// Number of equations above which a mesh is called fine.
const MANY_EQUATIONS: usize = 1_000_000;
/// Plastic strain above which small-strain theory is inaccurate.
const LARGE_STRAIN: f64 = 0.05;
/// Depth of a body over the half-width below which the support affects the answer.
const NEAR_SUPPORT: f64 = 5.0;

/// Returns the sentences of the remark on details of the contact that the mesh does not resolve.
fn coarse_mesh(job: &Job, step: &StepSolution, half_width: f64) -> Vec<String> {
    let mut messages = Vec::new();
    if step.patch.is_some() && half_width < COARSE_MESH * step.spacing {
        messages.push(format!(
            "The half-width has only {:.1} elements; ask for at least 10 \
             (`mesh.elements_per_half_width`).",
            half_width / step.spacing
        ));
    }
    if let Some((part, elements)) =
        step.coarsest_part().filter(|(_, elements)| *elements < COARSE_MESH)
    {
        messages.push(format!(
            "The part of the contact at x = {:.4} mm has only {elements:.1} elements over half of \
             its width: pressure, yield and the end of the contact there are those of the mesh. \
             Ask for more elements (`mesh.elements_per_half_width`), or solve that part for \
             itself.",
            0.5 * (part.left + part.right)
        ));
    }
    if is_ring_on_few_elements(step) {
        messages.push(format!(
            "The contact is a ring of few elements at r = {:.4} mm: its figures are those of the \
             mesh, and their errors are not known. Ask for more elements \
             (`mesh.elements_per_half_width`).",
            step.peak_position
        ));
    } else if peak_is_next_to_end(step) {
        messages.push(format!(
            "The largest pressure is at {:.4} mm, next to an end of the contact, where it rises \
             within elements of {:.2e} mm: it is that of the mesh. Ask for more elements \
             (`mesh.elements_per_half_width`).",
            step.peak_position, step.spacing
        ));
    }
    if step.unknown_peaks_before > 0 {
        messages.push(
            "The mesh does not tell the largest pressure of an earlier load, nor what it left in \
             the bodies: plastic strain and stress are those of the mesh. Ask for more elements \
             (`mesh.elements_per_half_width`)."
                .to_owned(),
        );
    }
    if is_clamped_column(job, step) {
        messages.push(
            "A clamped body is deeper than wide: the mesh has few elements over its end, and the \
             error of the approach, and of the force under a given approach, is not known. A body \
             on rollers has no such end."
                .to_owned(),
        );
    }
    if let Some(message) = surface_stress(step).or_else(|| approach_left(job, step)) {
        messages.push(message);
    }
    if let Some(edge) = &step.rounded_edge {
        messages.push(format!(
            "The contact ends within about {:.2e} mm on the rounded edges, where elastic bodies \
             have a peak of about {:.0} MPa in closed form; elements of {:.2e} mm leave that out. \
             {}What is away from the edges does not depend on it.",
            edge.elastic.width(),
            edge.elastic.peak_pressure(),
            step.spacing,
            if job.load == Load::Onset {
                "Onset of yield is that of the closed form. "
            } else {
                ""
            }
        ));
    }
    if let Some(tip) = &step.rounded_tip {
        messages.push(rounded_tip(tip, step, half_width));
    }
    if let Some(needed) = step.unresolved {
        messages.push(format!(
            "Within the contact the surfaces have details that elements of {needed:.2e} mm \
             resolve; those of this mesh have {:.2e} mm.",
            step.spacing
        ));
    }
    messages
}

/// Returns the remark on stresses at the surface, below the middle of the contact, that change
/// within single elements.
fn surface_stress(step: &StepSolution) -> Option<String> {
    let uncertain =
        step.bodies.iter().flatten().filter_map(|body| UncertainStress::of(step, body));
    let error = uncertain.map(|stress| stress.error).reduce(f64::max)?;
    Some(format!(
        "Below the surface plastic strain changes within elements of {:.2e} mm: stresses along \
         the surface, at the depth 0, are known to about {} MPa only. Ask for more elements \
         (`mesh.elements_per_half_width`).",
        step.spacing,
        rounded(error)
    ))
}

/// Returns the remark on a permanent approach that is smaller than its error.
fn approach_left(job: &Job, step: &StepSolution) -> Option<String> {
    if step.patch.is_some() {
        return None;
    }
    let bar = error_bars::estimate(job, step)?.approach?;
    (bar > 1.0).then(|| {
        format!(
            "The approach that is left is smaller than its error of {} mm: it may as well be \
             none, or of the other sign.",
            rounded(bar * step.approach.abs())
        )
    })
}

/// Returns the remark on a tip whose arc is narrow compared with the elements.
fn rounded_tip(tip: &RoundedTip, step: &StepSolution, half_width: f64) -> String {
    let Some(arc) = tip.arc else {
        return format!(
            "The curvature of the surface is infinite at its tip; elements of {:.2e} mm leave \
             that out, and pressure, yield and strain at the tip are those of the mesh. In closed \
             form elastic bodies have a peak of about {:.0} MPa there. What is away from the tip \
             does not depend on it.",
            step.spacing, tip.elastic_pressure
        );
    };
    let needed = (TIP_ELEMENTS * half_width / arc).ceil();
    let advice = if needed > f64::from(MeshSettings::MAX_ELEMENTS_PER_HALF_WIDTH) {
        "No mesh that may be asked for resolves it.".to_owned()
    } else {
        format!("About {needed:.0} elements (`mesh.elements_per_half_width`) resolve it.")
    };
    format!(
        "The tip is rounded off within {:.2e} mm to each side of its middle; elements of {:.2e} \
         mm leave that out, and pressure, yield and strain at the tip are those of the mesh. In \
         closed form elastic bodies have a peak of about {:.0} MPa there. {advice} What is away \
         from the tip does not depend on it.",
        arc, step.spacing, tip.elastic_pressure
    )
}

/// Returns the remarks on a load step. `radius` is the smallest of the effective radius and the
/// radii of the surfaces, infinite if none has a radius \[mm\]. `depths` are the depths of the
/// deformable bodies \[mm\].
pub(super) fn notes(
    job: &Job,
    step: &StepSolution,
    radius: f64,
    depths: &[f64],
) -> Vec<ValidityNote> {
    let mut notes = Vec::new();
    let mut say = |code: &str, message: String| {
        debug_assert!(VALIDITY_CODES.contains(&code));
        notes.push(ValidityNote { code: code.to_owned(), message });
    };
    if let Some((code, message)) = status_remark(step, job.solver) {
        say(code, message);
    }
    let half_width = step.patch.map_or(0.0, |patch| patch.half_width());
    let work = [
        slow_coupling(step, job.solver.coupling),
        many_meshes(step),
        fine_mesh(job, step, half_width),
    ];
    for message in work.into_iter().flatten() {
        say("slow_coupling", message);
    }
    if let Some(message) = wide_contact(job, step, half_width, radius) {
        say("wide_contact", message);
    }
    let strain = step.bodies.iter().flatten().map(|body| body.max_strain()).fold(0.0, f64::max);
    // Strains of a slower coupling that has not converged are no property of the bodies.
    let is_iterate =
        step.status == SolveStatus::NotConverged && job.solver.coupling != Coupling::Accelerated;
    let last = step.energy.map(|_| step.last_increment);
    if let (false, Some((code, message))) =
        (is_iterate, strain_remark(strain, step.has_collapsed, last))
    {
        say(code, message);
    }
    if strain > 0.0 && step.energy.is_none() {
        say(
            "deformation_theory",
            "Plasticity by deformation theory: exact where stresses grow in proportion, which \
             below a growing contact they do not. Where the elastic peak is 3, 4 and 5 times the \
             yield stress, its peak pressure is above that of flow theory (`solver.theory`) by 3, \
             7 and 10 to 12 % for steel cylinders and by 5, 10 and 11 to 13 % for spheres. Says \
             nothing about unloading or residual stresses."
                .into(),
        );
    }
    if let Some((code, message)) = history_remark(job, step.load, step.patch.is_some()) {
        say(code, message.into());
    }
    if let Some(message) = sharp_corner(step, strain) {
        say("sharp_corner", message);
    }
    if step.reaches_edge {
        say(
            "contact_at_edge",
            if step.conforming.is_some() {
                format!(
                    "The contact reaches beyond what is meshed of the hole. It is solved up to \
                     {MAX_HALF_ANGLE}° to each side: reduce the load, or widen the clearance."
                )
            } else {
                AT_EDGE.to_owned()
            },
        );
    }
    let coarse = coarse_mesh(job, step, half_width);
    if !coarse.is_empty() && !step.is_preliminary() {
        say("coarse_mesh", coarse.join(" "));
    }
    for (code, message) in plastic_strain::remarks(job, step) {
        say(code, message);
    }
    if let Some(message) = onset::why_unknown(job, step) {
        say("onset_unknown", message);
    }
    for (code, message) in strength::remarks(job, step) {
        say(code, message);
    }
    if depths.iter().any(|depth| *depth < NEAR_SUPPORT * half_width) {
        say(
            "near_support",
            "A support is closer than five half-widths below the contact; it shapes the stresses, \
             and Hertz's figures of half-spaces do not apply."
                .into(),
        );
    }
    if looks_like_millimetres(job) {
        say("suspicious_units", SUSPICIOUS_UNITS.into());
    }
    notes
}

/// Returns the remark on a pressure at a sharp corner that has no limit, or whose limit the mesh
/// does not resolve.
fn sharp_corner(step: &StepSolution, strain: f64) -> Option<String> {
    let x = step.loaded_corners.first()?;
    if strain == 0.0 {
        return Some(format!(
            "A sharp corner carries pressure at x = {x:.4} mm. Elastic pressure has no bound \
             there: the peak pressure is that of the mesh. It grows with the density of the mesh, \
             and the force under which yield begins falls."
        ));
    }
    peak_is_unbounded(step).then(|| {
        format!(
            "The largest pressure is at the sharp corner at x = {:.4} mm and still grows with the \
             density of the mesh, although the bodies yield. Where what yields hardens it has no \
             bound: the peak pressure is that of the mesh.",
            step.peak_position
        )
    })
}

/// Returns the remark on a contact that is wide compared with the radii or, for a pin in a hole,
/// at whose ends the normals of pin and hole differ too much.
fn wide_contact(job: &Job, step: &StepSolution, half_width: f64, radius: f64) -> Option<String> {
    if let Some(pair) = &step.conforming {
        let between_normals = half_width / pair.effective_radius();
        return (between_normals > WIDE_CONTACT).then(|| {
            format!(
                "At the ends of the contact the normals of pin and hole differ by {:.0}° before \
                 loading; the theory takes them for one, and is meant for a clearance that is \
                 small beside the radii.",
                between_normals.to_degrees()
            )
        });
    }
    let meant =
        "contact theory with small displacements and vertical gaps is meant for up to 10 %";
    if half_width > WIDE_CONTACT * radius {
        let share = 100.0 * half_width / radius;
        let advice =
            if lies_in_groove(job) { format!("; {CONFORMING_ADVICE}") } else { String::new() };
        return Some(format!(
            "The half-width is {share:.0} % of the smallest radius; {meant}{advice}."
        ));
    }
    let slope = steepest(job, step);
    (slope > STEEP).then(|| {
        format!("Within the contact a surface has a slope of {:.0} %; {meant}.", 100.0 * slope)
    })
}

/// Returns the largest slope between two neighbouring pairs in contact on surfaces without a
/// radius: wedges, cones and profiles.
fn steepest(job: &Job, step: &StepSolution) -> f64 {
    let outlines = [&job.upper, &job.lower].map(|body| outline_of(&body.shape));
    let between = |pair: &[PairState]| match pair {
        [a, b] if a.force > 0.0 && b.force > 0.0 => {
            let slope = |outline: &Outline| {
                ((outline.height(b.x) - outline.height(a.x)) / (b.x - a.x)).abs()
            };
            outlines
                .iter()
                .filter(|outline| outline.curvature().is_none())
                .map(slope)
                .fold(0.0, f64::max)
        }
        _ => 0.0,
    };
    step.pairs.windows(2).map(between).fold(0.0, f64::max)
}

/// Returns the remark on a load that took far more work than usual. The work is measured in counts
/// that are the same on every machine.
fn slow_coupling(step: &StepSolution, coupling: Coupling) -> Option<String> {
    let updates: usize = step.history.iter().map(|record| record.initial_stress_updates).sum();
    let iterations = step.history.len();
    if coupling != Coupling::Accelerated {
        return (updates > MUCH_WORK).then(|| {
            format!(
                "The coupling took {updates} evaluations of the plastic law in {iterations} \
                 iterations; the accelerated one (`solver.coupling`) rarely takes more than 40."
            )
        });
    }
    let factorizations: usize = step.history.iter().map(|record| record.factorizations).sum();
    if updates + FACTORIZATION * factorizations <= MUCH_WORK {
        return None;
    }
    let increments = step.increments.len().max(1);
    let mut causes = Vec::new();
    if increments * increments > updates {
        causes.push(format!(
            "the load is divided into {increments} increments, until half as many change little \
             (`solver.increments` sets their number)"
        ));
    }
    if factorizations > increments {
        causes.push(format!(
            "the iteration came to a standstill and went on by Newton's method, with \
             {factorizations} factorizations of the stiffness"
        ));
    }
    if causes.is_empty() {
        causes.push(
            "what yields hardly hardens, or is near the limit load, so that contact and plastic \
             flow settle slowly"
                .to_owned(),
        );
    }
    Some(format!(
        "This load took {updates} evaluations of the plastic law in {iterations} iterations, of \
         which others rarely take more than 40 for each increment of a history: {}.",
        causes.join("; ")
    ))
}

/// Returns the remark on a search for a force that took many meshes.
fn many_meshes(step: &StepSolution) -> Option<String> {
    let each = if step.energy.is_some() {
        "each trial of a force is a history in increments on meshes of its own"
    } else {
        "near the value the contact changes from mesh to mesh"
    };
    (step.meshes_of_search > MANY_MESHES).then(|| {
        format!(
            "The force was sought on {} meshes, of which searches rarely take more than \
             {MANY_MESHES}: {each}. A force near {} (`load.force` or `load.history`) is solved at \
             once.",
            step.meshes_of_search,
            rounded(step.force())
        )
    })
}

/// Returns the remark on a mesh that details of the surfaces make much finer than the job
/// requests.
fn fine_mesh(job: &Job, step: &StepSolution, half_width: f64) -> Option<String> {
    let asked = f64::from(job.mesh.elements_per_half_width);
    let elements = half_width / step.spacing;
    let equations: usize = step.bodies.iter().flatten().map(|body| body.equations).sum();
    (elements > 2.0 * asked && equations > MANY_EQUATIONS).then(|| {
        format!(
            "Details of the surfaces take {elements:.0} elements over the half-width in place of \
             {asked:.0}, and {:.1} million equations: the job takes some {:.0} times as long as \
             one of smooth surfaces. A profile with points further apart, or a smoothed one, is \
             faster.",
            equations as f64 / 1e6,
            (elements / asked).powi(2)
        )
    })
}

/// Returns code and text of the remark on a load step that did not converge.
fn status_remark(step: &StepSolution, settings: SolverSettings) -> Option<(&'static str, String)> {
    match step.status {
        SolveStatus::Converged => None,
        SolveStatus::NotConverged => {
            Some(("not_converged", not_converged(&Unfinished::of(step), settings)))
        }
        SolveStatus::Cancelled => {
            Some(("cancelled", stopped("Stopped on request", step.is_preliminary())))
        }
        SolveStatus::TimedOut => {
            Some(("timed_out", stopped("The deadline passed", step.is_preliminary())))
        }
    }
}

/// Returns the remark on a load step that was stopped.
pub(super) fn stopped(why: &str, is_preliminary: bool) -> String {
    if is_preliminary {
        format!(
            "{why} before the mesh that was asked for had come to this load: the figures are \
             those of the mesh of half the density on which increments are chosen, and there are \
             no stresses and no error bars."
        )
    } else {
        format!("{why}; the figures are those of the last iteration.")
    }
}

/// Returns code and text of the remark on strains that are not small.
///
/// `last` is the last increment of a history.
pub(super) fn strain_remark(
    strain: f64,
    has_collapsed: bool,
    last: Option<LastIncrement>,
) -> Option<(&'static str, String)> {
    let percent = 100.0 * strain;
    if has_collapsed {
        let message = if let Some(LastIncrement { from, size, .. }) = last {
            format!(
                "Plastic strain reaches {percent:.0} %: after {} of the load another increment of \
                 {} of it, the smallest that is tried, does not end with small strains. Approach \
                 and strains are no answer. The history ends here, with that increment.",
                share(from),
                share(size)
            )
        } else {
            format!(
                "Plastic strain reaches {percent:.0} %: the bodies do not bear this load with \
                 small strains. It is at or beyond their limit load, and approach and strains are \
                 no answer. Reduce the load."
            )
        };
        return Some(("collapse", message));
    }
    (strain > LARGE_STRAIN).then(|| {
        let message = format!(
            "Plastic strain reaches {percent:.1} %; small-strain theory is meant for up to 5 %: \
             it leaves out the change of shape."
        );
        ("large_strain", message)
    })
}

/// Returns whether a job in SI has a Young's modulus that is plausible in megapascals only.
pub(super) fn looks_like_millimetres(job: &Job) -> bool {
    let mut moduli = [&job.upper, &job.lower].into_iter().filter_map(Body::young_modulus);
    job.units == Units::Si && moduli.any(|modulus| modulus < SOFT)
}

/// Returns code and text of the remark on falling loads under deformation theory, or on an
/// approach that is smaller than the permanent approach of earlier loads.
pub(super) fn history_remark(
    job: &Job,
    load: ContactLoad,
    touches: bool,
) -> Option<(&'static str, &'static str)> {
    if job.solver.theory == Theory::Deformation {
        return falls(job).then_some((
            "falling_loads",
            "Deformation theory takes each load from rest, whatever went before; for unloading \
             choose the theory `flow`.",
        ));
    }
    let is_pressed = matches!(load, ContactLoad::Approach(a) if a > 0.0);
    (is_pressed && !touches).then_some((
        "no_contact",
        "At this approach the bodies do not touch: what earlier loads have left of the dent is \
         deeper.",
    ))
}

/// Returns whether any load of a job is smaller than the load before it.
fn falls(job: &Job) -> bool {
    let falls = |loads: &[PositiveF64]| loads.windows(2).any(|pair| pair[1] < pair[0]);
    match &job.load {
        Load::Forces(loads) | Load::Approaches(loads) => falls(loads),
        Load::History(loads) => loads.windows(2).any(|pair| match pair {
            [HistoryLoad::Force(a), HistoryLoad::Force(b)]
            | [HistoryLoad::Approach(a), HistoryLoad::Approach(b)] => b < a,
            _ => false,
        }),
        Load::Onset | Load::Target(_) => false,
    }
}

/// Findings on a load step that did not converge.
#[expect(clippy::struct_excessive_bools, reason = "each is a finding of its own")]
pub(super) struct Unfinished<'a> {
    pub contact_check: KktReport,
    pub history: &'a [IterationRecord],
    /// Residual force of the equilibrium over the contact force, computed again at the end.
    pub residual: f64,
    pub missed: Option<f64>,
    pub has_collapsed: bool,
    pub reaches_edge: bool,
    pub inherits_error: bool,
    pub is_history: bool,
    pub is_elastic: bool,
}

impl<'a> Unfinished<'a> {
    fn of(step: &'a StepSolution) -> Self {
        Self {
            contact_check: step.contact_check,
            history: &step.history,
            residual: step.equilibrium_residual,
            missed: step.missed,
            has_collapsed: step.has_collapsed,
            reaches_edge: step.reaches_edge,
            inherits_error: step.last_increment.inherits_error,
            is_history: step.energy.is_some(),
            is_elastic: step.bodies.iter().flatten().all(|body| body.max_plastic_strain() == 0.0),
        }
    }
}

/// Returns the reason why a load step did not converge, with advice.
pub(super) fn not_converged(step: &Unfinished<'_>, settings: SolverSettings) -> String {
    let contact = step.contact_check.worst();
    let iterations = step.history.len();
    let residual = step.residual;
    let other = if settings.coupling == Coupling::Accelerated {
        ""
    } else {
        " Use the accelerated coupling (`solver.coupling`)."
    };
    let is_balanced = step
        .history
        .last()
        .is_some_and(|last| last.equilibrium_residual <= settings.tolerance.get());
    if let Some(ratio) = step.missed {
        format!(
            "What is sought is not found: under this force it is {ratio:.4} times what it is to \
             be (of an onset, the highest von Mises stress over the yield stress), and jumps from \
             one mesh to the next. More elements (`mesh.elements_per_half_width`) follow it more \
             closely."
        )
    } else if !step.contact_check.is_sound() {
        format!(
            "The final state violates the contact conditions by {} of their scale (penetration, \
             tension or load); do not use it.{other}",
            share(contact)
        )
    } else if step.has_collapsed {
        "There is no answer with small strains; see `collapse`.".into()
    } else if step.reaches_edge && is_balanced {
        "The contact is wider than what could be meshed; see `contact_at_edge`.".into()
    } else if step.inherits_error && is_balanced {
        format!(
            "An increment before it in this history has not converged, and this step inherits its \
             error.{other}"
        )
    } else if step.is_history && is_balanced {
        format!(
            "The iteration has converged, but over the whole bodies forces are off balance by {} \
             of the contact force: do not use the figures.",
            share(residual)
        )
    } else {
        let advice = if step.is_elastic && is_balanced {
            " Nothing yields: what is off is rounding, under a load that is tiny beside the \
             stress before it or beside the stiffness of the bodies. Choose a larger load."
        } else if !other.is_empty() {
            other
        } else if iterations >= settings.max_iterations as usize {
            " Raise `solver.max_iterations`."
        } else {
            " Newton's method, to which the accelerated coupling turns last, came to no end \
             either: do not use the figures. A smaller load or a little hardening may have an \
             answer."
        };
        format!(
            "Not converged after {iterations} iterations: forces are off balance by {} of the \
             contact force.{advice}",
            share(residual)
        )
    }
}

/// Returns a fraction in percent, to two digits.
pub(super) fn share(part: f64) -> String {
    let digits = format!("{:.1e}", 100.0 * part);
    match digits.parse::<f64>() {
        Ok(percent) if percent == 0.0 || (1e-3..1e4).contains(&percent) => format!("{percent} %"),
        _ => format!("{digits} %"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::{Unobserved, run};

    #[test]
    fn millimetres_in_a_job_in_si_are_told() {
        for (units, radius, force, modulus, is_told) in [
            // Steel that is softer than jelly.
            ("SI", "20", "612", "210000", true),
            ("SI", "0.02", "0.06", "210000", true),
            ("SI", "0.02", "612e3", "210e9", false),
            // Rollers of a bridge are large.
            ("SI", "20", "60e6", "210e9", false),
            ("mm_N_MPa", "20", "612", "210000", false),
        ] {
            let body = format!(
                r#"{{"shape": {{"type": "cylinder", "radius": {radius}}},
                    "material": {{"young_modulus": {modulus}, "poisson_ratio": 0.3}}}}"#
            );
            let job = format!(
                r#"{{"analysis": "plane_strain", "units": "{units}",
                    "upper": {body}, "lower": {body},
                    "load": {{"force": {force}}}, "mesh": {{"elements_per_half_width": 5}}}}"#
            );
            let report =
                crate::report::run(&Job::from_json(job.as_bytes()).unwrap(), &mut Unobserved)
                    .unwrap();
            let told = report.steps[0].validity.iter().any(|note| note.code == "suspicious_units");
            assert_eq!(told, is_told, "{units} {radius} {force} {modulus}");
        }
    }

    /// The remark on a search without a result blames neither the iteration nor the load.
    #[test]
    fn what_is_not_found_is_told() {
        let job = br#"{"analysis": "plane_strain",
            "load": {"onset": true}, "mesh": {"elements_per_half_width": 10},
            "upper": {"shape": {"type": "cylinder", "radius": 10}, "material": {"rigid": true}},
            "lower": {"shape": {"type": "block", "width": 60, "depth": 40},
                "material": {"young_modulus": 70000, "poisson_ratio": 0.3, "plasticity":
                    {"law": "bilinear", "yield_stress": 100, "tangent_modulus": 0}}}}"#;
        let job = Job::from_json(job).unwrap();
        let mut step = run(&job, &mut Unobserved).unwrap().steps.remove(0);
        assert!(notes(&job, &step, 10.0, &[40.0]).is_empty());
        (step.status, step.missed) = (SolveStatus::NotConverged, Some(1.0123));
        let notes = notes(&job, &step, 10.0, &[40.0]);
        assert!(
            notes[0].code == "not_converged" && notes[0].message.contains("1.0123 times"),
            "{notes:?}"
        );
    }

    /// Meshes grow with the contact, so that no known job ends at the edge; the test sets the
    /// flag.
    #[test]
    fn a_contact_at_the_edge_is_told() {
        let job = br#"{"analysis": "plane_strain",
            "load": {"force": 50}, "mesh": {"elements_per_half_width": 10},
            "upper": {"shape": {"type": "cylinder", "radius": 10}, "material": {"rigid": true}},
            "lower": {"shape": {"type": "block", "width": 20, "depth": 20},
                      "material": {"young_modulus": 70000, "poisson_ratio": 0.3}}}"#;
        let job = Job::from_json(job).unwrap();
        let mut step = run(&job, &mut Unobserved).unwrap().steps.remove(0);
        assert!(notes(&job, &step, 10.0, &[20.0]).is_empty());
        step.reaches_edge = true;
        let codes: Vec<_> =
            notes(&job, &step, 10.0, &[20.0]).into_iter().map(|note| note.code).collect();
        assert_eq!(codes, ["contact_at_edge"]);
    }
}
