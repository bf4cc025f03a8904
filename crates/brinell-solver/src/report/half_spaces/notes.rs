//! Remarks on the validity of an answer in three dimensions. Remarks that plane contacts share
//! have the same text.

use super::step::largest_strain;
use crate::job::{Body, Deformable, Job, Material, MeshSettings, Roller, Theory};
use crate::report::ValidityNote;
use crate::report::plastic_strain::{UNBOUNDED, bilinear_curve};
use crate::report::strength::{COARSE_RATIO, IDLE, by_hardness};
use crate::report::units::{UnitConverter, rounded};
use crate::report::validity::{
    AT_EDGE, SUSPICIOUS_UNITS, Unfinished, WIDE_CONTACT, history_remark, looks_like_millimetres,
    not_converged, share, stopped, strain_remark,
};
use crate::solver::SolveStatus;
use crate::solver::half_spaces::{
    HalfSpaceBody, HalfSpaceProblem, HalfSpaceStep, Relief, SurfaceMap,
};

/// Number of cells over the shorter semi-axis below which the grid is called coarse.
const COARSE_GRID: f64 = 5.0;
/// Distance over the longer semi-axis within which the stress of the contact decays. The bodies
/// must resemble half-spaces up to this distance beyond the contact.
const REACH: f64 = 3.0;
/// Number of depths within a layer at which strengths are compared.
const SAMPLES: u32 = 16;

/// Returns the remarks on a load step.
pub(super) fn notes(
    job: &Job,
    problem: &HalfSpaceProblem,
    step: &HalfSpaceStep,
    write: UnitConverter,
) -> Vec<ValidityNote> {
    let mut notes = Vec::new();
    let mut note =
        |code: &str, message: String| notes.push(ValidityNote { code: code.to_owned(), message });
    if let Some((code, message)) = status_remark(job, step) {
        note(code, message);
    }
    if let Some((size, radius)) = widest(job, problem.orientation(), step.figures.semi_axes) {
        note(
            "wide_contact",
            format!(
                "The contact reaches {} of a radius of curvature ({}): half-spaces take surfaces \
                 for parabolas and bodies for large beside the contact.",
                rounded(size / radius),
                write.length_text(radius)
            ),
        );
    }
    if let Some((code, message)) = problem.half_length().and_then(|_| wide_tilt(step)) {
        note(code, message);
    }
    if step.reaches_edge {
        note("contact_at_edge", AT_EDGE.to_owned());
    }
    if let Some(message) = coarse_grid(problem, step) {
        note("coarse_mesh", message);
    }
    let strain = step.figures.max_plastic_strain.into_iter().fold(0.0, f64::max);
    let is_history = job.solver.theory == Theory::Flow;
    let last = is_history.then_some(step.last_increment);
    if let Some((code, message)) = strain_remark(strain, step.has_collapsed, last) {
        note(code, message);
    }
    if strain > 0.0 && !is_history {
        note(
            "deformation_theory",
            "Deformation theory takes each point for loaded in proportion. Under a growing \
             contact it gives peaks that are some per cent to a tenth too high; the theory `flow` \
             does not."
                .to_owned(),
        );
    }
    if let Some((code, message)) = history_remark(job, step.load, step.figures.force > 0.0) {
        note(code, message.to_owned());
    }
    let is_unbounded =
        |(side, body): (usize, &HalfSpaceBody)| largest_strain(job, body, side).is_none();
    let bodies = || {
        step.bodies.iter().enumerate().filter_map(|(side, body)| Some((side, body.as_deref()?)))
    };
    if bodies().any(is_unbounded) {
        note("unbounded_strain", UNBOUNDED.to_owned());
    }
    let materials = || {
        bodies()
            .filter_map(|(side, body)| Some((deformable([&job.upper, &job.lower][side])?, body)))
    };
    let coarsest = materials().filter_map(|(material, body)| coarsest(material, body));
    let coarsest =
        coarsest.max_by(|a, b| a.0.total_cmp(&b.0)).map(|found| coarse_case(job, found, write));
    for (code, message) in
        [bilinear_curve(job, strain), by_hardness(job), coarsest].into_iter().flatten()
    {
        note(code, message);
    }
    if looks_like_millimetres(job) {
        note("suspicious_units", SUSPICIOUS_UNITS.to_owned());
    }
    of_shapes(problem, step, write, note);
    notes
}

/// Returns the remark on a contact of few cells.
fn coarse_grid(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> Option<String> {
    let (grid, [a, b]) = (&step.surface.grid, step.figures.semi_axes);
    let cells = (a / grid.hx()).min(b / grid.hy());
    if step.is_preliminary || cells <= 0.0 || cells >= COARSE_GRID {
        return None;
    }
    let advice = if problem.heights.is_some() {
        "finer heights tell more"
    } else {
        "ask for more (`mesh.elements_per_half_width`)"
    };
    Some(format!("A semi-axis of the contact has only {cells:.1} cells; {advice}."))
}

/// Adds the remarks on the type of the surfaces: heights, rollers, half-spaces.
fn of_shapes(
    problem: &HalfSpaceProblem,
    step: &HalfSpaceStep,
    write: UnitConverter,
    mut note: impl FnMut(&str, String),
) {
    if ends_at_rim(problem, step) {
        note(
            "surface_end",
            "The contact comes to the end of the heights, beyond which nothing touches: at the \
             rim the pressure is too high and the surface too soft, as if the patch were a block \
             that stands out of the body."
                .to_owned(),
        );
    }
    if let Some(message) = roller_end(problem, step, write) {
        note("roller_end", message);
    }
    if has_kinks(problem) {
        note(
            "sharp_corner",
            "The profile of a roller is given by points: elastic pressure has no bound at its \
             kinks, and grows there with finer cells. The peak pressure is that of the cells, \
             without a bar."
                .to_owned(),
        );
    }
    let [a, b] = step.figures.semi_axes;
    if a > 0.0 {
        note(
            "half_spaces",
            format!(
                "The bodies are half-spaces. They stand for bodies that reach at least {} beyond \
                 the contact {}and in depth.",
                write.length_text(digits(REACH * b)),
                if problem.rollers.is_empty() { "to all sides " } else { "across the roller " },
            ),
        );
    }
}

/// Returns code and text of the remark on a load step that did not converge.
fn status_remark(job: &Job, step: &HalfSpaceStep) -> Option<(&'static str, String)> {
    let unfinished = Unfinished {
        contact_check: step.contact_check,
        history: &step.history,
        residual: step.plastic_residual,
        missed: step.missed,
        has_collapsed: step.has_collapsed,
        reaches_edge: step.reaches_edge,
        inherits_error: step.last_increment.inherits_error,
        is_history: job.solver.theory == Theory::Flow,
        is_elastic: step.bodies.iter().flatten().all(|body| body.largest_strain.is_none()),
    };
    match step.status {
        SolveStatus::Converged => None,
        SolveStatus::NotConverged if misses_moment(step) => {
            Some(("not_converged", missed_moment(step)))
        }
        SolveStatus::NotConverged => {
            Some(("not_converged", not_converged(&unfinished, job.solver)))
        }
        SolveStatus::Cancelled => {
            Some(("cancelled", stopped("Stopped on request", step.is_preliminary)))
        }
        SolveStatus::TimedOut => {
            Some(("timed_out", stopped("The deadline passed", step.is_preliminary)))
        }
    }
}

/// Whether the moment of a roller is what a contact violates most.
fn misses_moment(step: &HalfSpaceStep) -> bool {
    !step.contact_check.is_sound() && step.missing_moment >= step.contact_check.worst()
}

fn missed_moment(step: &HalfSpaceStep) -> String {
    format!(
        "The moment is missed by {} of the force times half the length of the roller: no tilt \
         that was tried has it. The cells next to the end bear at most the force times the \
         distance of their middles. Give a smaller moment, or more elements \
         (`mesh.elements_per_half_width`).",
        share(step.missing_moment)
    )
}

/// What is said of a tilt that is found and could not be given.
fn wide_tilt(step: &HalfSpaceStep) -> Option<(&'static str, String)> {
    let (tilt, most) = (1e3 * step.tilt, *Roller::tilts().end());
    let message = format!(
        "The moment tilts the roller by {} mrad. Beyond {most} mrad, up to which a tilt may be \
         given, rollers and half-spaces are no model of the contact: give a smaller moment.",
        rounded(tilt)
    );
    (tilt.abs() > most).then_some(("wide_contact", message))
}

const fn deformable(body: &Body) -> Option<&Deformable> {
    match &body.material {
        Material::Deformable(material) => Some(material),
        Material::Rigid => None,
    }
}

/// Returns the semi-axis and the radius of a body along it with the largest ratio, if the ratio is
/// too large for surfaces that are approximated by parabolas. `angle` turns the x of the job to
/// the x of the contact.
fn widest(job: &Job, angle: f64, semi_axes: [f64; 2]) -> Option<(f64, f64)> {
    let (sine, cosine) = angle.sin_cos();
    let curvatures =
        [&job.upper, &job.lower].into_iter().filter_map(|body| body.shape.curvatures());
    let ratios = curvatures.flat_map(|[xx, yy, xy]| {
        let along_x = cosine * cosine * xx + sine * sine * yy + 2.0 * sine * cosine * xy;
        [(semi_axes[0], along_x), (semi_axes[1], xx + yy - along_x)]
    });
    let widest = ratios.map(|(size, curvature)| (size, curvature.abs().recip()));
    let widest = widest.max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)));
    widest.filter(|(size, radius)| size / radius > WIDE_CONTACT)
}

/// Returns the largest ratio of strengths within a stressed layer, and the depth of its middle.
fn coarsest(material: &Deformable, body: &HalfSpaceBody) -> Option<(f64, f64)> {
    let (strength, limit) =
        (material.strength()?, material.hardening_law()?.nominal_yield_stress());
    let n_cells = body.grid.n_cells();
    let of_layer = |layer: usize| {
        let (top, thickness) = (body.layers.faces()[layer], body.layers.thickness(layer));
        let points = strength.points().iter().map(|[depth, _]| *depth);
        let points = points.filter(|depth| *depth > top && *depth < top + thickness);
        let samples = (0..=SAMPLES).map(|k| top + thickness * f64::from(k) / f64::from(SAMPLES));
        let factors = points.chain(samples).map(|depth| strength.factor(depth));
        let (least, greatest) =
            factors.fold((f64::INFINITY, 0.0_f64), |(a, b), s| (a.min(s), b.max(s)));
        let is_stressed =
            || (0..n_cells).any(|cell| body.von_mises(layer, cell) > IDLE * limit * least);
        (greatest > COARSE_RATIO * least && is_stressed())
            .then(|| (greatest / least, body.layers.middle(layer)))
    };
    (0..body.layers.len()).filter_map(of_layer).max_by(|a, b| a.0.total_cmp(&b.0))
}

/// Returns code and text of the remark on a strength that changes by `ratio` within a layer at
/// `depth` \[mm\].
fn coarse_case(
    job: &Job,
    (ratio, depth): (f64, f64),
    write: UnitConverter,
) -> (&'static str, String) {
    let cells = f64::from(job.mesh.elements_per_half_width);
    let wanted = (cells * ratio.ln() / COARSE_RATIO.ln())
        .ceil()
        .min(f64::from(MeshSettings::MAX_CELLS_PER_SEMI_AXIS));
    let message = format!(
        "The strength changes by {:.0} % within one layer of cells at a depth of {}, where the \
         stress is more than half of it: a layer has the strength of its middle, and what is \
         thinner is left out. About {wanted:.0} cells over a semi-axis \
         (`mesh.elements_per_half_width`) would do.",
        100.0 * (ratio - 1.0),
        write.length_text(digits(depth)),
    );
    ("coarse_case", message)
}

/// Returns whether a contact of heights reaches the rim of the heights.
fn ends_at_rim(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> bool {
    problem.heights.is_some() && reaches_rim(&step.surface)
}

/// Returns whether a cell of the rim is in contact.
fn reaches_rim(map: &SurfaceMap) -> bool {
    let (nx, ny) = (map.grid.nx(), map.grid.ny());
    let is_rim = |cell: usize| {
        let (i, j) = (cell / ny, cell % ny);
        i == 0 || j == 0 || i + 1 == nx || j + 1 == ny
    };
    map.pressure.iter().enumerate().any(|(cell, pressure)| *pressure > 0.0 && is_rim(cell))
}

/// Returns whether the peak pressure depends on the size of the cells: at the end of a roller, at
/// the rim of heights, or at the kinks of a profile given by points.
pub(super) fn is_peak_unknown(
    problem: &HalfSpaceProblem,
    step: &HalfSpaceStep,
    write: UnitConverter,
) -> bool {
    has_kinks(problem) || ends_at_rim(problem, step) || roller_end(problem, step, write).is_some()
}

fn has_kinks(problem: &HalfSpaceProblem) -> bool {
    problem.rollers.iter().any(|roller| matches!(roller.relief, Relief::Points(_)))
}

/// Returns the remark on a contact that reaches an end of a roller.
fn roller_end(
    problem: &HalfSpaceProblem,
    step: &HalfSpaceStep,
    write: UnitConverter,
) -> Option<String> {
    let (half_length, map) = (problem.half_length()?, &step.surface);
    let (ny, hy) = (map.grid.ny(), map.grid.hy());
    let is_at_end = |cell: usize| half_length - map.grid.y(cell % ny).abs() < hy;
    let most =
        (0..map.pressure.len()).filter(|cell| is_at_end(*cell)).map(|cell| map.pressure[cell]);
    let most = most.fold(0.0, f64::max);
    let is_sharp = problem.rollers.iter().any(|roller| roller.relief == Relief::Straight);
    let cells = if is_sharp {
        " It grows without bound with finer cells, because the roller is straight up to its ends: \
         a profile tells what it is."
    } else {
        ""
    };
    (most > 0.0).then(|| {
        format!(
            "The contact runs to an end of the roller, with a pressure of {} in the outermost \
             cells.{cells} A half-space goes on beyond the end and bears a part of the load \
             there; a roller ends, gives way more and is pressed less at the end than is said \
             here. Guilbault's factor (2011) would correct for it.",
            write.stress_text(most),
        )
    })
}

/// Returns a value to two digits.
fn digits(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}
