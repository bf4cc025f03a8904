//! Report of flow theory for half-spaces: increments, surfaces, energies.

use std::sync::Arc;

use super::sections::section_along_x;
use crate::job::{Job, Material};
use crate::report::flow::NOTICEABLE;
use crate::report::{EnergyReport, FlowReport, IncrementsReport, PerBody, SurfaceReport};
use crate::solver::half_spaces::{EllipticReference, HalfSpaceBody, HalfSpaceStep};
use crate::units::UnitConverter;

/// State of a history after its loads so far.
#[derive(Debug, Default)]
pub(in crate::report) struct FlowState {
    /// Force at the end of the last load.
    force: f64,
    /// Bodies before the load last began to fall.
    before_unloading: Option<[Option<Arc<HalfSpaceBody>>; 2]>,
    bodies: [Option<Arc<HalfSpaceBody>>; 2],
}

impl FlowState {
    /// Returns the report of the next load, or `None` under deformation theory.
    pub fn report(
        &mut self,
        job: &Job,
        step: &HalfSpaceStep,
        reference: &EllipticReference,
        write: UnitConverter,
    ) -> Option<FlowReport> {
        if !job.has_memory() {
            return None;
        }
        let falls = job.load.is_history() && step.figures.force < self.force;
        if falls && self.before_unloading.is_none() {
            self.before_unloading = Some(self.bodies.clone());
        } else if !falls {
            self.before_unloading = None;
        }
        self.force = step.figures.force;
        self.bodies.clone_from(&step.field.bodies);
        Some(FlowReport {
            unloading_stiffness: write.stiffness(reference.stiffness(step)),
            energy: EnergyReport::of(step.path.energy.unwrap_or_default(), write),
            increments: IncrementsReport::of(&step.path.increments, write),
            surfaces: if step.status.is_stopped() {
                PerBody::default()
            } else {
                let deflection = elastic_deflection(reference, step);
                PerBody::of(&step.field.bodies, |body, side| {
                    self.surface(job, step, (body, side), &deflection, write)
                })
            },
        })
    }

    fn surface(
        &self,
        job: &Job,
        step: &HalfSpaceStep,
        (body, side): (&HalfSpaceBody, usize),
        deflection: &[f64],
        write: UnitConverter,
    ) -> SurfaceReport {
        let share = compliance(job, side) / (compliance(job, 0) + compliance(job, 1));
        let heights: Vec<f64> = deflection
            .iter()
            .zip(&body.plastic_displacement)
            .map(|(elastic, plastic)| -(share * elastic + plastic))
            .collect();
        let map = &step.field.surface;
        let extreme = |sign: f64| heights.iter().map(|height| sign * height).fold(0.0, f64::max);
        let highest =
            (0..heights.len()).max_by(|a, b| heights[*a].total_cmp(&heights[*b])).unwrap_or(0);
        let (x, y) = (map.grid.x(highest / map.grid.ny()), map.grid.y(highest % map.grid.ny()));
        let before = self.before_unloading.as_ref().and_then(|bodies| bodies[side].as_deref());
        let gains = before.map_or_else(Vec::new, |before| gains(before, body));
        let most = gains.iter().copied().fold(0.0, f64::max);
        let has_reversed = most > NOTICEABLE;
        SurfaceReport {
            x: (0..map.grid.nx()).map(|i| write.length(map.grid.x(i))).collect(),
            height: section_along_x(map, &heights)
                .iter()
                .map(|height| write.length(*height))
                .collect(),
            depth: write.length(extreme(-1.0)),
            pile_up: write.length(extreme(1.0)),
            pile_up_position: if extreme(1.0) > 0.0 { write.length(x.hypot(y)) } else { 0.0 },
            yielded_in_reverse: has_reversed,
            reverse_area: write.area(reverse_area(body, &gains)),
            max_reverse_strain: if has_reversed { most } else { 0.0 },
        }
    }
}

/// Returns the elastic displacement of both surfaces together at each cell, `w - δ0 - u_p + α`, or
/// zeros without contact.
fn elastic_deflection(reference: &EllipticReference, step: &HalfSpaceStep) -> Vec<f64> {
    let map = &step.field.surface;
    if step.figures.force <= 0.0 {
        return vec![0.0; map.gap.len()];
    }
    let gap = reference.initial_gap(&map.grid);
    let at = |cell: usize| {
        let plastic: f64 =
            step.field.bodies.iter().flatten().map(|body| body.plastic_displacement[cell]).sum();
        map.gap[cell] - gap[cell] - plastic + step.figures.approach
    };
    (0..map.gap.len()).map(at).collect()
}

/// Returns `(1 - ν²)/E` of a body, 0 for a rigid body.
fn compliance(job: &Job, side: usize) -> f64 {
    match &[&job.upper, &job.lower][side].material {
        Material::Deformable(material) => material.elastic().plane_strain_modulus().recip(),
        Material::Rigid => 0.0,
    }
}

/// Returns the gain of equivalent plastic strain in each cell.
fn gains(before: &HalfSpaceBody, now: &HalfSpaceBody) -> Vec<f64> {
    let (before, now) = (&before.equivalent_plastic_strain, &now.equivalent_plastic_strain);
    if before.len() != now.len() {
        return Vec::new();
    }
    now.iter().zip(before).map(|(now, before)| now - before).collect()
}

/// Returns the area, in the section y = 0, of the cells that have gained plastic strain.
fn reverse_area(body: &HalfSpaceBody, gains: &[f64]) -> f64 {
    let (ny, n_cells) = (body.grid.ny(), body.grid.n_cells());
    let is_in_section = |cell: usize| cell % n_cells % ny == (ny - 1) / 2;
    let area = |cell: usize| body.grid.hx() * body.layers.thickness(cell / n_cells);
    let reversed = gains
        .iter()
        .enumerate()
        .filter(|(cell, gain)| **gain > NOTICEABLE && is_in_section(*cell));
    reversed.map(|(cell, _)| area(cell)).sum()
}
