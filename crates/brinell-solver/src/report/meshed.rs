//! Jobs between meshed bodies, in a plane or of revolution.

use brinell_halfspace::Stop;

use super::answers::Measured;
use super::cost::{
    FIELD_COPIES, JobEstimate, REPORTED_INCREMENT_BYTES, SOLVER_BYTES, STEP_BYTES, increments_of,
    steps_of,
};
use super::datum::Datum;
use super::findings::Finding;
use super::hertz::{line, over_friction};
use super::known::{self, Known, Zone};
use super::measured::measured;
use super::shown::{Arrays, Parts, Shown, Solved};
use super::{
    IncrementsReport, MeshReport, PerBody, PlasticityReport, ShakedownMap, contact, error_bars,
    fatigue, fields, flow, hardness, onset, plastic_zone, subsurface, target, validity,
};
use crate::fatigue::{not_smooth, of_section};
use crate::inputs::{SolveError, of_small_mesh};
use crate::job::Job;
use crate::solver::method::figures::Figure;
use crate::solver::method::observer::ask;
use crate::solver::{
    self, BodySolution, ElasticReference, Interrupt, MeshedContact, Observer, Options,
    SectionField, SolveStatus, StepReceiver, StepSolution,
};
use crate::units::UnitConverter;

/// Bytes per node of the fields of a load step: ten numbers and the corners of an element.
const FIELD_BYTES: u64 = 96;
/// Bytes that each element over the half-width adds to the report, by its contact nodes.
const STEP_BYTES_PER_ELEMENT: u64 = 832;
/// Bytes per node of an increment of flow theory. The solver keeps displacements of the coarse
/// mesh, with a quarter of the nodes, for this number of increments and for twice the number.
const INCREMENT_BYTES: u64 = 16 * (1 + 2) / 4;

/// Meshed bodies.
pub(super) struct Meshed<'a> {
    job: &'a Job,
    contact: MeshedContact,
    write: UnitConverter,
}

impl<'a> Meshed<'a> {
    pub fn new(job: &'a Job, contact: MeshedContact) -> Self {
        Self { job, contact, write: UnitConverter::new(job.units, job.analysis) }
    }

    /// Returns the elastic contact of a step in closed form.
    fn reference(&self, step: &StepSolution) -> Option<ElasticReference> {
        ElasticReference::of(&self.contact.problem, step.figures.force)
    }
}

impl Shown for Meshed<'_> {
    type Field = SectionField;
    /// Limits of shakedown over friction, which every load step repeats.
    type Memory = Option<ShakedownMap>;

    fn job(&self) -> &Job {
        self.job
    }

    /// Adds the memory of the result to the estimate of the solver.
    fn cost(&self) -> Result<JobEstimate, SolveError> {
        let job = self.job;
        let estimate = solver::estimate(&self.contact)?;
        let steps = steps_of(job);
        let increments = if job.has_memory() { increments_of(job, steps)[1] } else { 0 };
        let nodes = estimate.equations as u64 / 2;
        let fields = if job.output.fields { FIELD_BYTES * nodes } else { 0 };
        let elements = u64::from(job.mesh.elements_per_half_width);
        let step = fields + STEP_BYTES + STEP_BYTES_PER_ELEMENT * elements;
        Ok(JobEstimate {
            equations: estimate.equations,
            bytes: SOLVER_BYTES
                + estimate.bytes
                + of_small_mesh(job, estimate.bytes)
                + FIELD_COPIES * fields
                + increments * (nodes * INCREMENT_BYTES + REPORTED_INCREMENT_BYTES),
            result_bytes: step * steps + increments * REPORTED_INCREMENT_BYTES,
        })
    }

    fn solve(
        &self,
        options: Options<'_>,
        observer: &mut dyn Observer,
        receiver: &mut dyn StepReceiver<SectionField>,
    ) -> Result<Solved, SolveError> {
        let solver::Solution { phases, passes, interrupted, sensitivity, .. } =
            solver::run_each(&self.contact, options, observer, receiver)?;
        Ok(Solved { phases, passes, interrupted, sensitivity })
    }

    fn arrays(
        &self,
        step: &StepSolution,
        observer: &mut dyn Observer,
    ) -> Result<Arrays, Interrupt> {
        let (write, bodies) = (self.write, &step.field.bodies);
        let mut arrays = Arrays::default();
        if self.job.output.subsurface {
            let mut at = |x: f64| {
                PerBody::try_of(bodies, |body, _| {
                    ask(observer)?;
                    Ok(subsurface::profile(step, body, x, write))
                })
            };
            let below_peak =
                subsurface::is_beside_middle(step).then(|| at(step.field.peak_position));
            arrays.subsurface = Some(at(step.field.middle)?);
            arrays.below_peak = below_peak.transpose()?;
        }
        let mut covers = [None; 2];
        arrays.plasticity = PerBody::try_of(bodies, |body, side| {
            ask(observer)?;
            let zone = plastic_zone::outline(body, step.field.symmetric);
            covers[side] = zone.cover();
            let written = |polygon: &Vec<[f64; 2]>| {
                polygon.iter().map(|point| point.map(|x| write.length(x))).collect()
            };
            Ok(PlasticityReport { outline: zone.outline.iter().map(written).collect() })
        })?;
        // Bodies that share one solution share its zone.
        if known::is_shared(bodies) {
            covers[1] = covers[0];
        }
        arrays.covers = covers;
        if step.figures.force > 0.0 {
            let of = |side: usize, stop: &mut Stop<'_>| {
                of_section(step, &self.contact.problem, side, stop)
            };
            let is_alike = self.job.upper.is_alike(&self.job.lower);
            let refused = without_fatigue(step);
            arrays.fatigue = fatigue::of_pressed(self.job, is_alike, refused, observer, of)?;
        }
        if self.job.output.fields {
            arrays.fields = Some(fields::fields(step, write, observer)?);
        }
        Ok(arrays)
    }

    fn findings(&self, step: &StepSolution) -> Vec<Finding> {
        let reference = self.reference(step);
        let problem = &self.contact.problem;
        let mut findings = validity::findings(self.job, problem, step, reference.as_ref());
        let bars = error_bars::estimate(self.job, step, &findings);
        findings.extend(validity::small_approach(
            step,
            bars.and_then(|bars| bars.of_figure(Figure::Approach, 0)),
        ));
        findings
    }

    fn parts(
        &self,
        memory: &mut Self::Memory,
        step: &StepSolution,
        findings: &[Finding],
    ) -> Parts {
        let (job, problem, write) = (self.job, &self.contact.problem, self.write);
        let reference = self.reference(step);
        let shakedown = reference.as_ref().map(|reference| {
            let limits = || over_friction(&reference.limits_over_friction(problem), write);
            memory.get_or_insert_with(limits).clone()
        });
        let conforming = step.field.conforming;
        let flow = flow::flow(step);
        Parts {
            known: Known {
                load: step.load,
                status: step.status,
                figures: step.figures,
                peak_place: [step.field.peak_position, 0.0],
                mean_pressure: step.field.mean_pressure(&step.figures),
                half_angle: conforming
                    .map(|pair| pair.angle(step.figures.half_width).to_degrees()),
                parts: contact::patches(step).count(),
                stiffness: step.contact_stiffness,
                flow,
                zones: step
                    .field
                    .bodies
                    .each_ref()
                    .map(|body| body.as_ref().map(|body| zone(body, step.field.symmetric))),
                hertz: reference.as_ref().map(line),
                onset: onset::onset((job, problem), step, findings),
                bars: error_bars::estimate(job, step, findings),
                whole: None,
                rolled: None,
                fatigue: Vec::new(),
                is_alike: job.upper.is_alike(&job.lower),
                is_graded: step
                    .field
                    .bodies
                    .iter()
                    .flatten()
                    .any(|body| body.model.varies_in_strength()),
            },
            contact: contact::report(step, write),
            increments: (step.path.energy)
                .map(|_| IncrementsReport::of(&step.path.increments, write)),
            surfaces: flow::surfaces(step, write),
            passes: None,
            rules: Vec::new(),
            shakedown: shakedown.filter(|map| !map.friction.is_empty()),
            spacing: Some(step.field.spacing),
            measured: Measured {
                datum: Datum::of(job, write),
                ..measured(job, problem, step, reference.as_ref(), findings)
            },
            target: target::of_section(job, step, findings),
            indentation: hardness::indentation(job, step),
            leaves_unknown: step.status == SolveStatus::Converged,
        }
    }

    fn mesh(&self, step: &StepSolution) -> MeshReport {
        let bodies = || step.field.bodies.iter().flatten();
        let quality = bodies().map(|body| body.quality);
        MeshReport {
            symmetric: step.field.symmetric,
            spacing: self.write.length(step.field.spacing),
            contact_pairs: step.field.pairs.len(),
            nodes: bodies().map(|body| body.mesh.nodes.len()).sum(),
            elements: bodies().map(|body| body.mesh.elements.len()).sum(),
            equations: bodies().map(|body| body.equations).sum(),
            min_jacobian_ratio: quality.clone().map(|q| q.min_jacobian_ratio).fold(1.0, f64::min),
            max_aspect_ratio: quality.map(|q| q.max_aspect_ratio).fold(1.0, f64::max),
            ..MeshReport::default()
        }
    }
}

/// Returns why the bodies of a contact have no fatigue.
fn without_fatigue(step: &StepSolution) -> Option<&'static str> {
    let field = &step.field;
    if field.conforming.is_some() {
        return Some("a pin in its hole does not lie in a plane");
    }
    if !field.loaded_corners.is_empty() {
        return Some("a sharp corner carries pressure");
    }
    let patch = field.patch?;
    // A ring lies on both sides of its axis.
    let is_ring = field.symmetric && contact::patches(step).all(|part| part.left > 0.0);
    let parts = contact::patches(step).count() + usize::from(is_ring);
    not_smooth(parts, field.peak_position, [patch.left, patch.right])
}

/// Returns the plastic zone of a body, but for the depth at which it begins.
fn zone(solution: &BodySolution, symmetric: bool) -> Zone {
    let most = solution.most_strained().filter(|point| point.equivalent_plastic_strain > 0.0);
    let [place, depth] = solution.mesh.frame.place(most.map_or([0.0; 2], |point| point.position));
    Zone {
        yielded: solution.has_yielded(),
        largest: solution.bounded_plastic_strain(),
        mean: solution.mean_plastic_strain(),
        place: [place, 0.0, depth],
        area: solution.plastic_area(symmetric),
        volume: None,
        cover: None,
    }
}
