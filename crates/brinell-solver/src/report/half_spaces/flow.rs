//! What flow theory knows of half-spaces: surfaces, energies.

use std::sync::Arc;

use super::sections::section_along_x;
use crate::job::{Body, Job};
use crate::report::flow::NOTICEABLE;
use crate::report::known::{FlowFigures, SurfaceFigures};
use crate::report::{PerBody, SurfaceReport};
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
    /// Returns what flow theory knows of the next load, with the height of each surface in every
    /// cell, or `None` under deformation theory.
    pub fn next(
        &mut self,
        job: &Job,
        step: &HalfSpaceStep,
        reference: &EllipticReference,
    ) -> Option<(FlowFigures, [Option<Vec<f64>>; 2])> {
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
        let deflection = elastic_deflection(reference, step);
        let is_shown = !step.status.is_stopped();
        let heights = [0, 1].map(|side| {
            let body = step.field.bodies[side].as_deref().filter(|_| is_shown)?;
            Some(heights(job, (body, side), &deflection))
        });
        let surfaces = [0, 1].map(|side| {
            let body = step.field.bodies[side].as_deref()?;
            Some(self.surface(step, (body, side), heights[side].as_deref()?))
        });
        let flow = FlowFigures {
            unloading_stiffness: reference.stiffness(step),
            energy: step.path.energy.unwrap_or_default(),
            surfaces,
        };
        Some((flow, heights))
    }

    fn surface(
        &self,
        step: &HalfSpaceStep,
        (body, side): (&HalfSpaceBody, usize),
        heights: &[f64],
    ) -> SurfaceFigures {
        let map = &step.field.surface;
        let extreme = |sign: f64| heights.iter().map(|height| sign * height).fold(0.0, f64::max);
        let highest =
            (0..heights.len()).max_by(|a, b| heights[*a].total_cmp(&heights[*b])).unwrap_or(0);
        let (x, y) = (map.grid.x(highest / map.grid.ny()), map.grid.y(highest % map.grid.ny()));
        let before = self.before_unloading.as_ref().and_then(|bodies| bodies[side].as_deref());
        let gains = before.map_or_else(Vec::new, |before| gains(before, body));
        let most = gains.iter().copied().fold(0.0, f64::max);
        SurfaceFigures {
            depth: extreme(-1.0),
            pile_up: extreme(1.0),
            pile_up_at: [x, y],
            reverse: (most > NOTICEABLE).then(|| [most, reverse_area(body, &gains)]),
        }
    }
}

/// Returns the height of the surface of a body in every cell.
fn heights(job: &Job, (body, side): (&HalfSpaceBody, usize), deflection: &[f64]) -> Vec<f64> {
    let compliances = job.bodies().map(Body::compliance);
    let share = compliances[side] / compliances.iter().sum::<f64>();
    let displacements = deflection.iter().zip(&body.plastic_displacement);
    displacements.map(|(elastic, plastic)| -(share * elastic + plastic)).collect()
}

/// Returns the sections of surfaces along x, in the units of the job.
pub(super) fn surfaces(
    step: &HalfSpaceStep,
    heights: &[Option<Vec<f64>>; 2],
    write: UnitConverter,
) -> PerBody<Option<SurfaceReport>> {
    let map = &step.field.surface;
    let lengths = |values: &[f64]| values.iter().map(|value| write.length(*value)).collect();
    let x: Vec<f64> = (0..map.grid.nx()).map(|i| map.grid.x(i)).collect();
    let [upper, lower] = heights.each_ref().map(|heights| {
        let height = section_along_x(map, heights.as_ref()?);
        Some(SurfaceReport { x: lengths(&x), height: lengths(&height) })
    });
    PerBody { upper, lower }
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
