//! Report of flow theory: increments, surfaces with their dents, and energies.

use serde::{Deserialize, Serialize};

use super::PerBody;
use crate::solver::{BodySolution, Energy, IncrementRecord, StepSolution};
use crate::units::UnitConverter;

/// What only flow theory knows of a step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Flow))]
pub struct FlowReport {
    /// dP/dα where the load begins to fall: that of the elastic bodies with the pairs in contact.
    /// 0 where nothing touches \[stiffness >= 0\].
    pub unloading_stiffness: f64,
    /// Where the work of the force has gone since the bodies were at rest.
    pub energy: EnergyReport,
    /// The increments of this load.
    pub increments: IncrementsReport,
    /// The surface of each body: the dent where the force is zero.
    pub surfaces: PerBody<Option<SurfaceReport>>,
}

/// Energies of both bodies: force times length.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Energy))]
pub struct EnergyReport {
    /// Work of the contact force, the sum of the next two \[energy >= 0\].
    pub work: f64,
    /// Elastic energy \[energy >= 0\].
    pub elastic: f64,
    /// Work of the stresses on plastic strain \[energy >= 0\].
    pub plastic: f64,
    /// The part of that which the backstress stores \[energy >= 0\].
    pub stored: f64,
    /// The rest of it \[energy >= 0\].
    pub dissipated: f64,
}

impl EnergyReport {
    /// Returns the energies in the units of a job.
    pub(super) fn of(energy: Energy, write: UnitConverter) -> Self {
        let in_units = |energy: f64| write.force(write.length(energy));
        Self {
            work: in_units(energy.work()),
            elastic: in_units(energy.elastic),
            plastic: in_units(energy.plastic_work),
            stored: in_units(energy.backstress),
            dissipated: in_units(energy.dissipated()),
        }
    }
}

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
    /// Depth of the deepest point below the undeformed surface \[length >= 0\].
    pub depth: f64,
    /// Height of the highest point above the undeformed surface \[length >= 0\].
    pub pile_up: f64,
    /// |x| of that point \[length >= 0\].
    pub pile_up_position: f64,
    /// Whether any point yielded since the load last began to fall.
    pub yielded_in_reverse: bool,
    /// Area of these points in the section x–y, both sides of the axis \[area >= 0\].
    pub reverse_area: f64,
    /// Largest equivalent plastic strain gained since then \[1 >= 0\].
    pub max_reverse_strain: f64,
}

/// Equivalent plastic strain below which a point counts as elastic. The tolerance of the iteration
/// may leave smaller strains.
pub(super) const NOTICEABLE: f64 = 1e-6;

pub(super) fn flow(step: &StepSolution, write: UnitConverter) -> Option<FlowReport> {
    let energy = step.path.energy?;
    Some(FlowReport {
        unloading_stiffness: write.stiffness(step.field.unloading_stiffness),
        energy: EnergyReport::of(energy, write),
        increments: IncrementsReport::of(&step.path.increments, write),
        surfaces: if step.status.is_stopped() {
            PerBody::default()
        } else {
            PerBody::of(&step.field.bodies, |body, _| surface(body, step.field.symmetric, write))
        },
    })
}

fn surface(body: &BodySolution, symmetric: bool, write: UnitConverter) -> SurfaceReport {
    let mut surface = body.surface();
    if symmetric {
        let mirrored = surface.iter().rev().filter(|[x, _]| *x > 0.0).map(|[x, y]| [-x, *y]);
        surface = mirrored.collect::<Vec<_>>().into_iter().chain(surface).collect();
    }
    let [place, highest] =
        surface.iter().copied().fold([0.0; 2], |best, at| if at[1] > best[1] { at } else { best });
    let points = body.stress.points.iter().flatten();
    let reverse = points.filter(|point| point.reverse_plastic_strain > NOTICEABLE);
    let copies = if symmetric { 2.0 } else { 1.0 };
    let area: f64 = reverse.clone().map(|point| point.area).sum();
    let strain = reverse.map(|point| point.reverse_plastic_strain).fold(0.0, f64::max);
    SurfaceReport {
        x: surface.iter().map(|[x, _]| write.length(*x)).collect(),
        height: surface.iter().map(|[_, y]| write.length(*y)).collect(),
        depth: write.length(body.dent_depth()),
        pile_up: write.length(highest),
        pile_up_position: write.length(place.abs()),
        yielded_in_reverse: strain > 0.0,
        reverse_area: write.area(copies * area),
        max_reverse_strain: strain,
    }
}
