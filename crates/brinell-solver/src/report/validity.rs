//! Findings on contacts of finite elements, and remarks on every answer.

use serde::{Deserialize, Serialize};

use super::findings::{
    Advice, Deformation, Finding, FinerBy, MANY_MESHES, Unconverged, Wide, Work, guesses,
};
use super::mesh_effects::{
    COARSE_MESH, is_clamped_column, is_ring_on_few_elements, peak_is_next_to_end,
    peak_is_unbounded,
};
use super::surface_stress::UncertainStress;
use super::{onset, plastic_strain, strength};
use crate::contact::{ContactLoad, KktReport};
use crate::fem::mesh::Outline;
use crate::inputs::outline_of;
use crate::job::{Analysis, Coupling, HistoryLoad, Job, Load, Shape, SolverSettings, Theory};
use crate::material::Solid;
use crate::solver::{
    ElasticReference, IterationRecord, LastIncrement, PairState, Problem, SolveStatus,
    StepSolution, TIP_ELEMENTS,
};
use crate::units::UnitConverter;

/// One remark on the validity of the answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ValidityNote {
    /// Stable identifier.
    pub code: String,
    /// For a person.
    pub message: String,
}

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
/// Number of equations above which a mesh is called fine.
const MANY_EQUATIONS: usize = 1_000_000;
/// Plastic strain above which small-strain theory is inaccurate.
const LARGE_STRAIN: f64 = 0.05;
/// Distance over the half-width within which the stress of the contact decays, and a support affects
/// the answer.
pub(super) const NEAR_SUPPORT: f64 = 5.0;

/// Returns the remarks of findings in the units of a job. Neighbours with the code `coarse_mesh`
/// make one remark.
pub(super) fn remarks(findings: &[Finding], write: UnitConverter) -> Vec<ValidityNote> {
    let mut notes: Vec<ValidityNote> = Vec::with_capacity(findings.len());
    for finding in findings {
        let (code, message) = (finding.code(), finding.text(write));
        match notes.iter_mut().find(|note| code == "coarse_mesh" && note.code == code) {
            Some(note) => note.message = format!("{} {message}", note.message),
            None => notes.push(ValidityNote { code: code.to_owned(), message }),
        }
    }
    notes
}

/// Returns the findings on a load step.
pub(super) fn findings(
    job: &Job,
    problem: &Problem,
    step: &StepSolution,
    reference: Option<&ElasticReference>,
) -> Vec<Finding> {
    let half_width = step.field.patch.map_or(0.0, |patch| patch.half_width());
    let strain =
        step.field.bodies.iter().flatten().map(|body| body.max_strain()).fold(0.0, f64::max);
    let mut findings: Vec<Finding> = Vec::new();
    findings.extend(status(step, job.solver));
    findings.extend(slow_coupling(step, job.solver.coupling));
    let of_histories = step.path.energy.is_some();
    let search = Work::Search {
        meshes: step.search.systems,
        of_cells: false,
        of_histories,
        force: step.figures.force,
    };
    findings.extend(long_search(search));
    findings.extend(fine_mesh(job, step, half_width));
    let radius = smallest_radius(job, reference);
    findings.extend(wide_contact(job, step, half_width, radius).map(Finding::Wide));
    // Strains of a slower coupling that has not converged are no property of the bodies.
    let is_iterate =
        step.status == SolveStatus::NotConverged && job.solver.coupling != Coupling::Accelerated;
    if !is_iterate {
        let last = step.path.energy.map(|_| step.path.last_increment);
        findings.extend(large_strain(strain, step.checks.has_collapsed, last));
    }
    let of_theory = findings.len();
    findings.extend(of_history(job, step.load, step.field.patch.is_some()));
    findings.extend(sharp_corner(step, strain));
    if step.checks.reaches_edge {
        findings.push(Finding::AtEdge { in_hole: step.field.conforming.is_some() });
    }
    if !step.is_preliminary {
        of_mesh(job, step, half_width, &mut findings);
    }
    findings.extend(plastic_strain::findings(job, step));
    findings.extend(onset::why_unknown(job, problem, step));
    findings.extend(strength::findings(job, step));
    let mut depths = step.field.bodies.iter().flatten().map(|body| body.depth());
    if depths.any(|depth| depth < NEAR_SUPPORT * half_width) {
        findings.push(Finding::NearSupport);
    }
    if strain > 0.0 && step.path.energy.is_none() {
        let of = deformation(job, problem, reference);
        findings.insert(of_theory, Finding::DeformationTheory(of));
    }
    findings.extend(guesses(job));
    findings
}

/// Returns the shape of a contact by deformation theory, and how far beyond yield it is.
fn deformation(job: &Job, problem: &Problem, reference: Option<&ElasticReference>) -> Deformation {
    if job.bodies().iter().any(|body| matches!(body.shape, Shape::Cone(_) | Shape::Wedge(_))) {
        return Deformation::Tip;
    }
    let solids = problem.bodies.each_ref().map(|body| body.material.as_ref());
    match reference.and_then(|hertz| Solid::over_yield_stress(solids, hertz.peak_pressure)) {
        Some(ratio) if job.analysis == Analysis::Axisymmetric => Deformation::Ball(ratio),
        Some(ratio) => Deformation::Line(ratio),
        None => Deformation::Other,
    }
}

/// Returns the smallest of the effective radius and the radii of the surfaces, infinite if none
/// has a radius \[mm\].
pub(super) fn smallest_radius(job: &Job, reference: Option<&ElasticReference>) -> f64 {
    let effective = reference.map_or(f64::INFINITY, |reference| reference.effective_radius);
    let curvatures =
        job.bodies().into_iter().filter_map(|body| outline_of(&body.shape).curvature());
    curvatures.fold(
        if effective > 0.0 { effective } else { f64::INFINITY },
        // The effective radius of nearly conforming bodies is large, but their gaps deviate from
        // the vertical by the curvature of each body.
        |least, curvature| least.min(curvature.abs().recip()),
    )
}

/// Adds the findings on details of the contact that the mesh does not resolve.
fn of_mesh(job: &Job, step: &StepSolution, half_width: f64, findings: &mut Vec<Finding>) {
    let spacing = step.field.spacing;
    if step.field.patch.is_some() && half_width < COARSE_MESH * spacing {
        let number = half_width / spacing;
        findings.push(Finding::FewElements { number, advice: FinerBy::Elements });
    }
    if let Some((part, number)) =
        step.field.coarsest_part().filter(|(_, elements)| *elements < COARSE_MESH)
    {
        let x = 0.5 * (part.left + part.right);
        findings.push(Finding::FewElementsOverPart { x, number });
    }
    if is_ring_on_few_elements(step) {
        findings.push(Finding::RingOnFewElements { radius: step.field.peak_position });
    } else if peak_is_next_to_end(step) {
        findings.push(Finding::PeakNextToEnd { x: step.field.peak_position, spacing });
    }
    if !step.path.unknown_before.is_empty() {
        findings.push(Finding::EarlierLoads { unknown: step.path.unknown_before });
    }
    if is_clamped_column(job, step) {
        findings.push(Finding::ClampedColumn);
    }
    let bodies = [0, 1].map(|side| {
        step.field.bodies[side].as_deref().and_then(|body| UncertainStress::of(step, body))
    });
    if bodies.iter().any(Option::is_some) {
        findings.push(Finding::SurfaceStress { spacing, bodies });
    }
    if let Some(edge) = &step.field.rounded_edge {
        findings.push(Finding::RoundedEdge {
            width: edge.elastic.width(),
            pressure: edge.elastic.peak_pressure(),
            spacing,
            is_onset: job.load == Load::Onset,
        });
    }
    if let Some(tip) = &step.field.rounded_tip {
        findings.push(Finding::RoundedTip {
            arc: tip.arc,
            needed: tip.arc.map_or(0.0, |arc| (TIP_ELEMENTS * half_width / arc).ceil()),
            pressure: tip.elastic_pressure,
            spacing,
        });
    }
    if let Some(needed) = step.field.unresolved {
        findings.push(Finding::Details { needed, spacing });
    }
}

/// Returns the finding on a permanent approach that is smaller than its error bar.
pub(super) fn small_approach(step: &StepSolution, bar: Option<f64>) -> Option<Finding> {
    let bar = bar.filter(|bar| *bar > 1.0 && step.field.patch.is_none())?;
    Some(Finding::SmallApproach { error: bar * step.figures.approach.abs() })
}

/// Returns the finding on a pressure at a sharp corner that has no limit, or whose limit the mesh
/// does not resolve.
fn sharp_corner(step: &StepSolution, strain: f64) -> Option<Finding> {
    let x = *step.field.loaded_corners.first()?;
    if strain == 0.0 {
        return Some(Finding::ElasticCorner { x });
    }
    peak_is_unbounded(step).then_some(Finding::YieldingCorner { x })
}

/// Returns the finding on a contact that is wide compared with the radii or, for a pin in a hole,
/// at whose ends the normals of pin and hole differ too much.
fn wide_contact(job: &Job, step: &StepSolution, half_width: f64, radius: f64) -> Option<Wide> {
    if let Some(pair) = &step.field.conforming {
        let angle = half_width / pair.effective_radius();
        return (angle > WIDE_CONTACT).then_some(Wide::InHole { angle });
    }
    if half_width > WIDE_CONTACT * radius {
        return Some(Wide::OverRadius {
            ratio: half_width / radius,
            in_groove: lies_in_groove(job),
        });
    }
    let slope = steepest(job, step);
    (slope > STEEP).then_some(Wide::Slope { slope })
}

/// Returns the largest slope between two neighbouring pairs in contact on surfaces without a
/// radius: wedges, cones and profiles.
fn steepest(job: &Job, step: &StepSolution) -> f64 {
    let outlines = job.bodies().map(|body| outline_of(&body.shape));
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
    step.field.pairs.windows(2).map(between).fold(0.0, f64::max)
}

/// Returns the finding on a load that took far more work than usual. The work is measured in
/// counts that are the same on every machine.
fn slow_coupling(step: &StepSolution, coupling: Coupling) -> Option<Finding> {
    let updates: usize = step.history.iter().map(|record| record.initial_stress_updates).sum();
    let iterations = step.history.len();
    if coupling != Coupling::Accelerated {
        let work = Work::Coupling { updates, iterations };
        return (updates > MUCH_WORK).then_some(Finding::Work(work));
    }
    let factorizations: usize = step.history.iter().map(|record| record.factorizations).sum();
    let increments = step.path.increments.len().max(1);
    (updates + FACTORIZATION * factorizations > MUCH_WORK).then(|| {
        Finding::Work(Work::Load {
            updates,
            iterations,
            increments: (increments * increments > updates).then_some(increments),
            factorizations: (factorizations > increments).then_some(factorizations),
        })
    })
}

/// Returns the finding on a search for a force that took many meshes.
pub(super) fn long_search(search: Work) -> Option<Finding> {
    let is_long = matches!(search, Work::Search { meshes, .. } if meshes > MANY_MESHES);
    is_long.then_some(Finding::Work(search))
}

/// Returns the finding on a mesh that details of the surfaces make much finer than the job
/// requests.
fn fine_mesh(job: &Job, step: &StepSolution, half_width: f64) -> Option<Finding> {
    let asked = f64::from(job.mesh.elements_per_half_width);
    let elements = half_width / step.field.spacing;
    let equations: usize = step.field.bodies.iter().flatten().map(|body| body.equations).sum();
    (elements > 2.0 * asked && equations > MANY_EQUATIONS)
        .then_some(Finding::Work(Work::FineMesh { elements, asked, equations }))
}

/// Returns the finding on a load step that did not converge.
fn status(step: &StepSolution, settings: SolverSettings) -> Option<Finding> {
    match step.status {
        SolveStatus::Converged => None,
        SolveStatus::NotConverged => {
            Some(Finding::NotConverged(Unfinished::of(step).cause(settings)))
        }
        status => Some(Finding::stopped(status, step.is_preliminary)),
    }
}

/// Returns the finding on strains that are not small. `last` is the last increment of a history.
pub(super) fn large_strain(
    strain: f64,
    has_collapsed: bool,
    last: Option<LastIncrement>,
) -> Option<Finding> {
    if has_collapsed {
        let last = last.map(|LastIncrement { from, size, .. }| [from, size]);
        return Some(Finding::Collapse { strain, last });
    }
    (strain > LARGE_STRAIN).then_some(Finding::LargeStrain { strain })
}

/// Returns the finding on falling loads under deformation theory, or on an approach that is
/// smaller than the permanent approach of earlier loads.
pub(super) fn of_history(job: &Job, load: ContactLoad, touches: bool) -> Option<Finding> {
    if job.solver.theory == Theory::Deformation {
        return falls(job).then_some(Finding::FallingLoads);
    }
    let is_pressed = matches!(load, ContactLoad::Approach(a) if a > 0.0);
    (is_pressed && !touches).then_some(Finding::NoContact)
}

/// Returns whether a load of a history is smaller than the load before it.
fn falls(job: &Job) -> bool {
    let Load::History(loads) = &job.load else { return false };
    loads.windows(2).any(|pair| match pair {
        [HistoryLoad::Force(a), HistoryLoad::Force(b)]
        | [HistoryLoad::Approach(a), HistoryLoad::Approach(b)] => b < a,
        _ => false,
    })
}

/// State of a load step that did not converge.
#[expect(clippy::struct_excessive_bools, reason = "each is a fact of its own")]
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
            contact_check: step.checks.contact,
            history: &step.history,
            residual: step.checks.residual,
            missed: step.search.missed,
            has_collapsed: step.checks.has_collapsed,
            reaches_edge: step.checks.reaches_edge,
            inherits_error: step.path.last_increment.inherits_error,
            is_history: step.path.energy.is_some(),
            is_elastic: step
                .field
                .bodies
                .iter()
                .flatten()
                .all(|body| body.max_plastic_strain() == 0.0),
        }
    }

    /// Returns the reason why the step did not converge, with advice.
    pub fn cause(&self, settings: SolverSettings) -> Unconverged {
        let iterations = self.history.len();
        let residual = self.residual;
        let is_slow = settings.coupling != Coupling::Accelerated;
        let is_balanced = self
            .history
            .last()
            .is_some_and(|last| last.equilibrium_residual <= settings.tolerance.get());
        if let Some(ratio) = self.missed {
            Unconverged::Missed { ratio }
        } else if !self.contact_check.is_sound() {
            Unconverged::Contact { violation: self.contact_check.worst(), is_slow }
        } else if self.has_collapsed {
            Unconverged::Collapse
        } else if self.reaches_edge && is_balanced {
            Unconverged::AtEdge
        } else if self.inherits_error && is_balanced {
            Unconverged::Inherited { is_slow }
        } else if self.is_history && is_balanced {
            Unconverged::Unbalanced { residual }
        } else {
            let advice = if self.is_elastic && is_balanced {
                Advice::LargerLoad
            } else if is_slow {
                Advice::AcceleratedCoupling
            } else if iterations >= settings.max_iterations as usize {
                Advice::MoreIterations
            } else {
                Advice::SmallerLoad
            };
            Unconverged::Iteration { iterations, residual, advice }
        }
    }
}

/// Returns whether a cylinder or ball lies in a groove.
pub(super) fn lies_in_groove(job: &Job) -> bool {
    let shapes = [&job.upper.shape, &job.lower.shape];
    shapes.iter().any(|shape| shape.round_radius().is_some())
        && shapes.iter().any(|shape| matches!(shape, Shape::Groove(_)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inputs::{meshed_contact, run};
    use crate::solver::Unobserved;

    fn notes(job: &Job, step: &StepSolution) -> Vec<ValidityNote> {
        let problem = meshed_contact(job).problem;
        let reference = ElasticReference::of(&problem, step.figures.force);
        let write = UnitConverter::new(job.units, job.analysis);
        remarks(&findings(job, &problem, step, reference.as_ref()), write)
    }

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
        assert!(notes(&job, &step).is_empty());
        (step.status, step.search.missed) = (SolveStatus::NotConverged, Some(1.0123));
        let told = notes(&job, &step);
        assert!(
            told[0].code == "not_converged" && told[0].message.contains("1.0123 times"),
            "{told:?}"
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
        assert!(notes(&job, &step).is_empty());
        step.checks.reaches_edge = true;
        let codes: Vec<_> = notes(&job, &step).into_iter().map(|note| note.code).collect();
        assert_eq!(codes, ["contact_at_edge"]);
    }
}
