//! What flow theory knows: increments, surfaces with their dents, and energies.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::PerBody;
use super::known::{FlowFigures, SurfaceFigures};
use crate::solver::{BodySolution, IncrementRecord, StepSolution};
use crate::units::UnitConverter;

/// The ends of the increments, in order.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Increments))]
pub struct IncrementsReport {
    /// Contact force \[force\].
    pub force: Vec<f64>,
    /// Approach \[length\].
    pub approach: Vec<f64>,
    /// Largest pressure \[stress\].
    pub peak_pressure: Vec<f64>,
    /// Half-width \[length\].
    pub half_width: Vec<f64>,
    /// Iterations made.
    pub iterations: Vec<usize>,
}

impl IncrementsReport {
    /// Returns the increments in the units of a job.
    pub(super) fn of(increments: &[IncrementRecord], write: UnitConverter) -> Self {
        Self {
            force: increments.iter().map(|end| write.force(end.force)).collect(),
            approach: increments.iter().map(|end| write.length(end.approach)).collect(),
            peak_pressure: increments.iter().map(|end| write.stress(end.peak_pressure)).collect(),
            half_width: increments.iter().map(|end| write.length(end.half_width)).collect(),
            iterations: increments.iter().map(|end| end.iterations).collect(),
        }
    }
}

/// The surface of one body near the contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Surface))]
pub struct SurfaceReport {
    /// x of the nodes, both sides of the axis; arc lengths for a pin in a hole \[length\].
    pub x: Vec<f64>,
    /// How far each has moved outward from the undeformed surface; a dent is negative \[length\].
    pub height: Vec<f64>,
}

/// Equivalent plastic strain below which a point counts as elastic. The tolerance of the iteration
/// may leave smaller strains.
pub(super) const NOTICEABLE: f64 = 1e-6;

/// Returns what flow theory knows, or `None` under deformation theory.
pub(super) fn flow(step: &StepSolution) -> Option<FlowFigures> {
    let surface = |body: &Arc<BodySolution>| surface_figures(body, step.field.symmetric);
    let is_stopped = step.status.is_stopped();
    let bodies = step.field.bodies.each_ref();
    Some(FlowFigures {
        unloading_stiffness: step.field.unloading_stiffness,
        energy: step.path.energy?,
        surfaces: bodies.map(|body| body.as_ref().filter(|_| !is_stopped).map(surface)),
    })
}

/// Returns the surface of each body under flow theory.
pub(super) fn surfaces(
    step: &StepSolution,
    write: UnitConverter,
) -> Option<PerBody<Option<SurfaceReport>>> {
    step.path.energy.filter(|_| !step.status.is_stopped())?;
    let of = |body: &BodySolution, _| {
        let (x, height) = both_sides(body, step.field.symmetric)
            .into_iter()
            .map(|[x, y]| (write.length(x), write.length(y)))
            .unzip();
        SurfaceReport { x, height }
    };
    Some(PerBody::of(&step.field.bodies, of))
}

/// Returns the surface of a body, completed by its mirror image.
fn both_sides(body: &BodySolution, symmetric: bool) -> Vec<[f64; 2]> {
    let surface = body.surface();
    if !symmetric {
        return surface;
    }
    let mirrored = surface.iter().rev().filter(|[x, _]| *x > 0.0).map(|[x, y]| [-x, *y]);
    mirrored.chain(surface.iter().copied()).collect()
}

fn surface_figures(body: &Arc<BodySolution>, symmetric: bool) -> SurfaceFigures {
    let surface = both_sides(body, symmetric);
    let [place, highest] =
        surface.iter().copied().fold([0.0; 2], |best, at| if at[1] > best[1] { at } else { best });
    let points = body.stress.points.iter().flatten();
    let reverse = points.filter(|point| point.reverse_plastic_strain > NOTICEABLE);
    let copies = if symmetric { 2.0 } else { 1.0 };
    let area: f64 = reverse.clone().map(|point| point.area).sum();
    let strain = reverse.map(|point| point.reverse_plastic_strain).fold(0.0, f64::max);
    SurfaceFigures {
        depth: body.dent_depth(),
        pile_up: highest,
        pile_up_at: [if symmetric { place.abs() } else { place }, 0.0],
        reverse: (strain > 0.0).then_some([strain, copies * area]),
    }
}
