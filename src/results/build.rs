//! The report of a solution.

use std::f64::consts::PI;
use std::time::Duration;

use super::subsurface;
use super::units::Writer;
use super::{
    ContactNodes, ContactReport, ErrorEstimate, HertzReport, LoadReport, MeshReport, PerBody,
    PlasticityReport, Report, StepReport, Timings, validity,
};
use crate::contact::ContactLoad;
use crate::element::Kinematics;
use crate::model::{Body, Job, Material, Named, Quantity, Shape};
use crate::solve::{
    BodySolution, ElasticReference, Interrupt, IterationRecord, Observer, Phase, PhaseTimes, Solution,
    SolveStatus, StepSolution,
};

/// Writes the report, last of all its own time.
pub(super) fn report(job: &Job, solution: &Solution, observer: &dyn Observer) -> Report {
    let start = observer.elapsed();
    let write = Writer::new(job.units, job.analysis);
    let steps = solution.steps.iter().map(|step| step_report(job, step, write)).collect();
    let end = observer.elapsed();
    Report {
        units: job.units.name().to_owned(),
        analysis: job.analysis.name().to_owned(),
        status: worst_status(solution),
        steps,
        mesh: mesh_report(solution, write),
        timings_ms: timings(&solution.phases, end, end.saturating_sub(start)),
        tags: job.tags.clone(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
    }
}

fn worst_status(solution: &Solution) -> SolveStatus {
    let rank = |status: &SolveStatus| match status {
        SolveStatus::Converged => 0,
        SolveStatus::NotConverged => 1,
        SolveStatus::TimedOut => 2,
        SolveStatus::Cancelled => 3,
    };
    let interrupted = solution.interrupted.map(|interrupt| match interrupt {
        Interrupt::Cancelled => SolveStatus::Cancelled,
        Interrupt::TimedOut => SolveStatus::TimedOut,
    });
    let statuses = solution.steps.iter().map(|step| step.status).chain(interrupted);
    statuses.max_by_key(rank).unwrap_or(SolveStatus::Cancelled)
}

fn step_report(job: &Job, step: &StepSolution, write: Writer) -> StepReport {
    let contact = contact_report(step, write);
    let bodies = PerBody { upper: &step.bodies[0], lower: &step.bodies[1] };
    let peak = peak_abscissa(step);
    let subsurface = job.output.subsurface.then(|| {
        bodies.each(|body| body.as_ref().map(|body| subsurface::profile(body, step.symmetric, peak, write)))
    });
    let reference = ElasticReference::of(job, contact_force(step));
    let depths: Vec<f64> = step.bodies.iter().flatten().map(|body| body.depth()).collect();
    let radius = reference.as_ref().map_or(f64::INFINITY, |reference| reference.effective_radius);
    StepReport {
        load: match step.load {
            ContactLoad::Force(force) => LoadReport::Force(write.force(force)),
            ContactLoad::Approach(approach) => LoadReport::Approach(write.length(approach)),
        },
        status: step.status,
        approach: write.length(step.approach),
        approach_datum: approach_datum(job, write),
        contact,
        subsurface,
        plasticity: bodies
            .each(|body| body.as_ref().map(|body| plasticity_report(body, step.symmetric, write))),
        hertz: reference.map(|reference| HertzReport {
            half_width: write.length(reference.half_width),
            peak_pressure: write.stress(reference.peak_pressure),
            yield_onset_force: reference.yield_onset_force.map(|force| write.force(force)),
            yield_onset_depth: reference.yield_onset_depth.map(|depth| write.length(depth)),
        }),
        validity: validity::notes(step, radius, &depths),
        estimated_error: estimated_error(step),
        history: step.history.iter().map(|record| in_units(record, write)).collect(),
    }
}

impl<T> PerBody<T> {
    fn each<U>(&self, f: impl Fn(&T) -> U) -> PerBody<U> {
        PerBody { upper: f(&self.upper), lower: f(&self.lower) }
    }
}

/// Force on both sides of the axis \[N/mm\].
fn contact_force(step: &StepSolution) -> f64 {
    let meshed: f64 = step.pairs.iter().map(|pair| pair.force).sum();
    let on_axis = step.pairs.first().map_or(0.0, |pair| pair.force);
    if step.is_mirrored() { 2.0 * meshed - on_axis } else { meshed }
}

/// Width on unit thickness \[mm\], or the area of the contact circle \[mm²\].
fn contact_area(step: &StepSolution, half_width: f64) -> f64 {
    match step.kinematics {
        Kinematics::PlaneStrain | Kinematics::PlaneStress => 2.0 * half_width,
        Kinematics::Axisymmetric => PI * half_width * half_width,
    }
}

fn peak_abscissa(step: &StepSolution) -> f64 {
    let highest = step.pairs.iter().max_by(|a, b| a.pressure.total_cmp(&b.pressure));
    highest.map_or(0.0, |pair| pair.x)
}

fn contact_report(step: &StepSolution, write: Writer) -> ContactReport {
    let force = contact_force(step);
    let half_width = step.patch.map_or(0.0, |patch| patch.half_width());
    let mean = if half_width > 0.0 { force / contact_area(step, half_width) } else { 0.0 };
    // A half model is mirrored: -x_n … -x_1, x_0 = 0, x_1 … x_n. Of a body of revolution x is the radius.
    let mirrored = if step.is_mirrored() { step.pairs.get(1..).unwrap_or(&[]) } else { &[] };
    let pairs =
        || mirrored.iter().rev().map(|pair| (pair, -1.0)).chain(step.pairs.iter().map(|pair| (pair, 1.0)));
    ContactReport {
        force: write.force(force),
        half_width: write.length(half_width),
        peak_pressure: write.stress(step.peak_pressure),
        peak_position: write.length(peak_abscissa(step)),
        mean_pressure: write.stress(mean),
        nodes: ContactNodes {
            x: pairs().map(|(pair, sign)| write.length(sign * pair.x)).collect(),
            pressure: pairs().map(|(pair, _)| write.stress(pair.pressure)).collect(),
            force: pairs().map(|(pair, _)| write.force(pair.force)).collect(),
            gap: pairs().map(|(pair, _)| write.length(pair.gap)).collect(),
        },
    }
}

fn plasticity_report(body: &BodySolution, symmetric: bool, write: Writer) -> PlasticityReport {
    let points = || body.stress.points.iter().flatten();
    let copies = if symmetric { 2.0 } else { 1.0 };
    let area: f64 = points().filter(|point| point.yielded).map(|point| point.area).sum();
    let most = points().max_by(|a, b| a.equivalent_plastic_strain.total_cmp(&b.equivalent_plastic_strain));
    let strain = most.map_or(0.0, |point| point.equivalent_plastic_strain);
    let position = most.filter(|_| strain > 0.0).map_or([0.0; 2], |point| point.position);
    PlasticityReport {
        yielded: points().any(|point| point.yielded),
        max_equivalent_plastic_strain: strain,
        position: write.length(position[0]),
        depth: write.length(-position[1]),
        area: write.area(copies * area),
    }
}

/// Differences to the mesh of half the density, which bound the error of a method that converges at all.
fn estimated_error(step: &StepSolution) -> Option<ErrorEstimate> {
    let coarse = step.coarse?;
    let relative = |fine: f64, coarse: f64| if fine == 0.0 { 0.0 } else { ((fine - coarse) / fine).abs() };
    Some(ErrorEstimate {
        peak_pressure: relative(step.peak_pressure, coarse.peak_pressure),
        half_width: relative(step.patch?.half_width(), coarse.half_width),
        approach: relative(step.approach, coarse.approach),
    })
}

fn approach_datum(job: &Job, write: Writer) -> String {
    let support = |side: &str, body: &Body| match (&body.material, &body.shape) {
        (Material::Rigid, _) => format!("the rigid {side} body"),
        (_, Shape::Cylinder { radius }) => {
            format!(
                "the diametral plane of the {side} body, {} from the contact",
                write.length_text(radius.get())
            )
        }
        (_, Shape::Block { depth, .. }) => block_base(side, depth.get(), write),
        (_, Shape::Groove(groove)) => block_base(side, groove.depth().get(), write),
        (_, Shape::Profile(profile)) => block_base(side, profile.depth().get(), write),
    };
    format!("{} towards {}", support("upper", &job.upper), support("lower", &job.lower))
}

fn block_base(side: &str, depth: f64, write: Writer) -> String {
    format!("the base of the {side} body, {} from the contact", write.length_text(depth))
}

fn in_units(record: &IterationRecord, write: Writer) -> IterationRecord {
    IterationRecord {
        approach: write.figure(Quantity::Approach, record.approach),
        peak_pressure: write.stress(record.peak_pressure),
        ..record.clone()
    }
}

fn mesh_report(solution: &Solution, write: Writer) -> MeshReport {
    let last = solution.steps.last();
    let bodies = || last.into_iter().flat_map(|step| step.bodies.iter().flatten());
    let quality = bodies().map(|body| body.quality);
    MeshReport {
        symmetric: last.is_some_and(|step| step.symmetric),
        spacing: write.length(last.map_or(0.0, |step| step.spacing)),
        contact_pairs: last.map_or(0, |step| step.pairs.len()),
        nodes: bodies().map(|body| body.mesh.nodes.len()).sum(),
        elements: bodies().map(|body| body.mesh.elements.len()).sum(),
        equations: bodies().map(|body| body.equations).sum(),
        passes: solution.passes,
        enlargements: solution.steps.iter().map(|step| step.enlargements).sum(),
        min_jacobian_ratio: quality.clone().map(|q| q.min_jacobian_ratio).fold(1.0, f64::min),
        max_aspect_ratio: quality.map(|q| q.max_aspect_ratio).fold(1.0, f64::max),
    }
}

fn timings(phases: &PhaseTimes, total: Duration, report: Duration) -> Timings {
    let ms = |duration: Duration| 1e3 * duration.as_secs_f64();
    Timings {
        total: ms(total),
        mesh: ms(phases.spent(Phase::Mesh)),
        assembly: ms(phases.spent(Phase::Assembly)),
        ordering: ms(phases.spent(Phase::Ordering)),
        symbolic: ms(phases.spent(Phase::Symbolic)),
        numeric: ms(phases.spent(Phase::Numeric)),
        flexibility: ms(phases.spent(Phase::Flexibility)),
        contact: ms(phases.spent(Phase::Contact)),
        plasticity: ms(phases.spent(Phase::Plasticity)),
        solves: ms(phases.spent(Phase::Solves)),
        output: ms(phases.spent(Phase::Output) + report),
    }
}
