//! Findings on an answer in three dimensions.

use super::spots::{self, FEW_CELLS};
use crate::inputs::along_axes;
use crate::job::{Deformable, Job, MeshSettings, Roller};
use crate::material::Solid;
use crate::report::findings::{
    CasePlace, Deformation, Finding, FinerBy, Known, OnsetUnknown, Unconverged, Wide, Work,
    guesses, left_unknown,
};
use crate::report::plastic_strain::bilinear_curve;
use crate::report::strength::{COARSE_RATIO, IDLE, by_hardness, wanted};
use crate::report::validity::{Unfinished, WIDE_CONTACT, large_strain, long_search, of_history};
use crate::solver::half_spaces::{
    HalfSpaceBody, HalfSpaceProblem, HalfSpaceStep, Relief, Row, SurfaceMap,
};
use crate::solver::method::figures::{Figure, FigureSet};
use crate::solver::method::sought::{Loads, Sought};
use crate::solver::{SolveStatus, bounded_strain};

/// Distance over the longer semi-axis within which the stress of the contact decays. The bodies
/// must resemble half-spaces up to this distance beyond the contact.
const REACH: f64 = 3.0;
/// Inclination of the common normal at the end of a contact from which the remark says so \[rad\].
const WIDE_ARC: f64 = 0.5;
/// Sum of the pressures over the force from which the remark says so.
const INCLINED: f64 = 1.01;
/// Number of depths within a layer at which strengths are compared.
const SAMPLES: u32 = 16;

/// Returns the findings on a load step.
pub(super) fn findings(
    job: &Job,
    problem: &HalfSpaceProblem,
    step: &HalfSpaceStep,
) -> Vec<Finding> {
    let mut findings: Vec<Finding> = Vec::new();
    findings.extend(status(job, step));
    findings.extend(
        widest(job, problem, problem.orientation(), step.figures.semi_axes()).map(Finding::Wide),
    );
    findings.extend(problem.half_length().and_then(|_| wide_tilt(step)).map(Finding::Wide));
    findings.extend(inclined_pressure(problem, step));
    if step.checks.reaches_edge {
        findings.push(Finding::AtEdge { in_hole: false });
    }
    let search = Work::Search {
        meshes: step.search.systems,
        of_cells: true,
        of_histories: job.has_memory(),
        force: step.figures.force,
    };
    findings.extend(long_search(search));
    findings.extend(coarse_grid(problem, step));
    findings.extend(spots::findings(problem, step));
    if !step.path.unknown_before.is_empty() {
        findings.push(Finding::EarlierLoads { unknown: step.path.unknown_before });
    }
    let strain = step.figures.values().largest(Figure::MaxPlasticStrain).unwrap_or_default();
    let is_history = job.has_memory();
    let last = is_history.then_some(step.path.last_increment);
    findings.extend(large_strain(strain, step.checks.has_collapsed, last));
    if strain > 0.0 && !is_history {
        findings.push(Finding::DeformationTheory(deformation(problem, step)));
    }
    findings.extend(of_history(job, step.load, step.figures.force > 0.0));
    let bodies = || {
        step.field
            .bodies
            .iter()
            .enumerate()
            .filter_map(|(side, body)| Some((side, body.as_deref()?)))
    };
    let unbounded = [0, 1].map(|side| {
        step.field.bodies[side]
            .as_deref()
            .is_some_and(|body| largest_strain(job, body, side).is_none())
    });
    if unbounded.contains(&true) {
        findings.push(Finding::UnboundedStrain { bodies: unbounded });
    }
    findings.extend(bilinear_curve(job, strain));
    findings.extend(by_hardness(job));
    let coarsest =
        bodies().filter_map(|(side, body)| coarsest(job.bodies()[side].deformable()?, body));
    if let Some((ratio, depth)) = coarsest.max_by(|a, b| a.0.total_cmp(&b.0)) {
        let cells = f64::from(job.mesh.elements_per_half_width);
        findings.push(Finding::CoarseCase {
            change: ratio - 1.0,
            place: CasePlace::Layer(depth),
            wanted: wanted(cells, ratio, MeshSettings::MAX_CELLS_PER_SEMI_AXIS),
            bodies: [true; 2],
        });
    }
    findings.extend(guesses(job));
    of_shapes(problem, step, &mut findings);
    findings
}

/// Returns the largest plastic strain of a body, or `None` if its hardening curve no longer rises
/// there.
pub(super) fn largest_strain(job: &Job, body: &HalfSpaceBody, side: usize) -> Option<f64> {
    let law = job.bodies()[side].deformable().and_then(Deformable::hardening_law);
    bounded_strain(body.largest_strain.map_or(0.0, |most| most.value), law.as_deref())
}

/// Returns the figures of a load step whose bars findings take, and the figures of the bodies that it
/// leaves unknown to the loads that follow it in a history.
pub fn unknown_figures(
    job: &Job,
    problem: &HalfSpaceProblem,
    step: &HalfSpaceStep,
) -> [FigureSet; 2] {
    let findings = findings(job, problem, step);
    [Known::of_job(job, &findings).void(), left_unknown(step.path.unknown_before, &findings)]
}

/// Returns how far beyond yield a contact by deformation theory is.
fn deformation(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> Deformation {
    let hertz = step.field.hertz.filter(|_| problem.heights.is_none());
    let ratio = hertz.and_then(|hertz| {
        let solids = problem.materials.each_ref().map(Option::as_ref);
        Solid::over_yield_stress(solids, hertz.peak_pressure)
    });
    ratio.map_or(Deformation::Other, Deformation::Ball)
}

/// Returns the finding on pressures that sum to more than the force: between conforming bodies they
/// act along inclined normals.
fn inclined_pressure(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> Option<Finding> {
    let is_inclined = problem.conformity.is_conforming() && step.figures.force > 0.0;
    let map = &step.field.surface;
    let borne = map.grid.cell_area() * map.pressure.iter().sum::<f64>();
    let ratio = borne / step.figures.force;
    (is_inclined && ratio > INCLINED).then_some(Finding::InclinedPressure { ratio })
}

/// Returns the finding on a contact of few cells.
fn coarse_grid(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> Option<Finding> {
    let (grid, [a, b]) = (&step.field.surface.grid, step.figures.semi_axes());
    let number = (a / grid.hx()).min(b / grid.hy());
    if step.is_preliminary || number <= 0.0 || number >= FEW_CELLS {
        return None;
    }
    let advice = if problem.heights.is_some() { FinerBy::Heights } else { FinerBy::Cells };
    Some(Finding::FewElements { number, advice })
}

/// Adds the findings on the type of the surfaces: heights, rollers, half-spaces.
fn of_shapes(problem: &HalfSpaceProblem, step: &HalfSpaceStep, findings: &mut Vec<Finding>) {
    if problem.heights.is_some() && reaches_rim(&step.field.surface) {
        findings.push(Finding::SurfaceEnd);
    }
    if let Some(end) = roller_end(problem, step) {
        findings.push(end);
        if problem.loads == Loads::Sought(Sought::Onset) {
            let cause = OnsetUnknown::AtRollerEnd;
            findings.push(Finding::OnsetUnknown { cause, is_sought: true });
        }
    }
    if has_kinks(problem) {
        findings.push(Finding::Kinks);
    }
    let [a, b] = step.figures.semi_axes();
    if a > 0.0 {
        let across_roller = !problem.rollers.is_empty();
        findings.push(Finding::HalfSpaces { reach: REACH * b, across_roller });
    }
}

/// Returns the finding on a load step that did not converge.
fn status(job: &Job, step: &HalfSpaceStep) -> Option<Finding> {
    let unfinished = Unfinished {
        contact_check: step.checks.contact,
        history: &step.history,
        residual: step.checks.residual,
        missed: step.search.missed,
        has_collapsed: step.checks.has_collapsed,
        reaches_edge: step.checks.reaches_edge,
        inherits_error: step.path.last_increment.inherits_error,
        is_history: job.has_memory(),
        is_elastic: step.field.bodies.iter().flatten().all(|body| body.largest_strain.is_none()),
    };
    match step.status {
        SolveStatus::Converged => None,
        SolveStatus::NotConverged if misses_moment(step) => {
            Some(Finding::NotConverged(Unconverged::Moment { missing: step.field.missing_moment }))
        }
        SolveStatus::NotConverged => Some(Finding::NotConverged(unfinished.cause(job.solver))),
        status => Some(Finding::stopped(status, step.is_preliminary)),
    }
}

/// Whether the moment of a roller is what a contact violates most.
fn misses_moment(step: &HalfSpaceStep) -> bool {
    !step.checks.contact.is_sound() && step.field.missing_moment >= step.checks.contact.worst()
}

/// Returns the finding on a tilt that follows from a moment and could not be given.
fn wide_tilt(step: &HalfSpaceStep) -> Option<Wide> {
    let (tilt, most) = (1e3 * step.field.tilt, *Roller::tilts().end());
    (tilt.abs() > most).then_some(Wide::Tilt { tilt, most })
}

/// Returns the semi-axis and the radius of a body along it with the largest ratio, if the ratio is
/// too large for surfaces that are approximated by parabolas. `angle` turns the x of the job to
/// the x of the contact. Bodies that conform along an axis are arcs along it, and the inclination
/// of their normals counts instead.
fn widest(job: &Job, problem: &HalfSpaceProblem, angle: f64, semi_axes: [f64; 2]) -> Option<Wide> {
    let curvatures = job.bodies().into_iter().filter_map(|body| body.shape.curvatures());
    let conforms = problem.conformity.curvature().map(|curvature| curvature > 0.0);
    let ratios = curvatures.flat_map(|curvatures| {
        let along = along_axes(curvatures, angle);
        (0..2).filter(|k| !conforms[*k]).map(|k| (semi_axes[k], along[k])).collect::<Vec<_>>()
    });
    let widest = ratios.map(|(size, curvature)| (size, curvature.abs().recip()));
    let widest = widest.map(|(size, radius)| (size / radius, radius));
    let widest =
        widest.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(ratio, _)| *ratio > WIDE_CONTACT);
    let [a, b] = semi_axes;
    let conformity = problem.conformity;
    let inclination = conformity.angle([a, 0.0]).max(conformity.angle([0.0, b]));
    match widest {
        _ if inclination > WIDE_ARC => Some(Wide::Inclined { angle: inclination }),
        Some((ratio, radius)) => Some(Wide::OverCurvature { ratio, radius }),
        None => None,
    }
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

/// Returns whether a cell of the rim is in contact.
pub(super) fn reaches_rim(map: &SurfaceMap) -> bool {
    let (nx, ny) = (map.grid.nx(), map.grid.ny());
    let is_rim = |cell: usize| {
        let (i, j) = (cell / ny, cell % ny);
        i == 0 || j == 0 || i + 1 == nx || j + 1 == ny
    };
    map.pressure.iter().enumerate().any(|(cell, pressure)| *pressure > 0.0 && is_rim(cell))
}

/// Returns whether the profile of a roller has kinks.
pub(super) fn has_kinks(problem: &HalfSpaceProblem) -> bool {
    problem.rollers.iter().any(|roller| matches!(roller.relief, Relief::Points(_)))
}

/// Returns the finding on a contact that reaches an end of a roller.
pub(super) fn roller_end(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> Option<Finding> {
    let (half_length, map) = (problem.half_length()?, &step.field.surface);
    let (ny, hy) = (map.grid.ny(), map.grid.hy());
    let is_at_end = |cell: usize| half_length - map.grid.y(cell % ny).abs() < hy;
    let most =
        (0..map.pressure.len()).filter(|cell| is_at_end(*cell)).map(|cell| map.pressure[cell]);
    let pressure = most.fold(0.0, f64::max);
    let is_sharp = problem.rollers.iter().any(|roller| roller.relief == Relief::Straight);
    let rows = Row::all(&map.grid, &map.pressure);
    let clear = &rows[Row::clear_of_ends(&map.grid, &rows, half_length)];
    let is_all = clear.iter().all(|row| row.half_width == 0.0);
    (pressure > 0.0).then_some(Finding::RollerEnd { pressure, is_sharp, is_all })
}
