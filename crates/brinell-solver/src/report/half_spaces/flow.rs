//! What flow theory knows of half-spaces: increments, surfaces, energies.

use std::sync::Arc;

use super::elastic::EllipticReference;
use super::step::{of_bodies, section_along_x};
use crate::job::{Job, Material, Theory};
use crate::report::units::UnitConverter;
use crate::report::{EnergyReport, FlowReport, IncrementsReport, PerBody, SurfaceReport};
use crate::solver::half_spaces::{HalfSpaceBody, HalfSpaceStep, SurfaceMap};

/// Equivalent plastic strain that the tolerance of an iteration may leave where nothing yields.
const NOTICEABLE: f64 = 1e-6;
/// Power of the approach with which the force of elastic bodies grows.
const HERTZ_POWER: f64 = 1.5;

/// What a history has done so far.
#[derive(Debug, Default)]
pub(super) struct FlowState {
    /// Force and approach at the end of the last increment.
    last: [f64; 2],
    /// Work of the force since rest \[N mm\].
    work: f64,
    /// Elastic energy at the end of the last load \[N mm\].
    elastic: f64,
    /// Plastic strains where the load last began to fall.
    before_unloading: Option<[Option<Arc<HalfSpaceBody>>; 2]>,
    bodies: [Option<Arc<HalfSpaceBody>>; 2],
}

impl FlowState {
    /// The report of the next load; `None` under deformation theory.
    pub fn report(
        &mut self,
        job: &Job,
        step: &HalfSpaceStep,
        reference: &EllipticReference,
        write: UnitConverter,
    ) -> Option<FlowReport> {
        if job.solver.theory != Theory::Flow {
            return None;
        }
        let falls = step.figures.force < self.last[0];
        if falls && self.before_unloading.is_none() {
            self.before_unloading = Some(self.bodies.clone());
        } else if !falls {
            self.before_unloading = None;
        }
        let energy = self.energy(job, step);
        self.bodies.clone_from(&step.bodies);
        let in_units = |energy: f64| write.force(write.length(energy));
        let increments = &step.increments;
        Some(FlowReport {
            unloading_stiffness: write.stiffness(reference.stiffness(step.figures.semi_axes)),
            energy: EnergyReport {
                work: in_units(energy.work),
                elastic: in_units(energy.elastic),
                plastic: in_units(energy.work - energy.elastic),
                stored: 0.0,
                dissipated: in_units(energy.work - energy.elastic),
            },
            increments: IncrementsReport {
                force: increments.iter().map(|end| write.force(end.force)).collect(),
                approach: increments.iter().map(|end| write.length(end.approach)).collect(),
                peak_pressure: increments.iter().map(|end| write.stress(end.peak_pressure)).collect(),
                half_width: increments.iter().map(|end| write.length(end.half_width)).collect(),
                iterations: increments.iter().map(|end| end.iterations).collect(),
            },
            surfaces: if step.status.is_stopped() {
                PerBody { upper: None, lower: None }
            } else {
                let deflection = elastic_deflection(job, step);
                of_bodies(step, |body, side| self.surface(job, step, (body, side), &deflection, write))
            },
        })
    }

    /// Work since rest and elastic energy \[N mm\].
    ///
    /// The force follows a power of the approach within an increment of loading, as Hertz's does from rest. While the load falls and
    /// nothing yields, its work is what the elastic energy loses.
    fn energy(&mut self, job: &Job, step: &HalfSpaceStep) -> Energies {
        let elastic = elastic_energy(job, step);
        let first = self.last;
        let mut rising = 0.0;
        for end in &step.increments {
            rising += work_between(self.last, [end.force, end.approach]);
            self.last = [end.force, end.approach];
        }
        self.work += if step.figures.force < first[0] { elastic - self.elastic } else { rising };
        self.elastic = elastic;
        Energies { work: self.work, elastic }
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
        let map = &step.surface;
        let extreme = |sign: f64| heights.iter().map(|height| sign * height).fold(0.0, f64::max);
        let highest = (0..heights.len()).max_by(|a, b| heights[*a].total_cmp(&heights[*b])).unwrap_or(0);
        let (x, y) = (map.grid.x(highest / map.grid.ny()), map.grid.y(highest % map.grid.ny()));
        let before = self.before_unloading.as_ref().and_then(|bodies| bodies[side].as_deref());
        let gains = before.map_or_else(Vec::new, |before| gains(before, body));
        let most = gains.iter().copied().fold(0.0, f64::max);
        let has_reversed = most > NOTICEABLE;
        SurfaceReport {
            x: (0..map.grid.nx()).map(|i| write.length(map.grid.x(i))).collect(),
            height: section_along_x(map, &heights).iter().map(|height| write.length(*height)).collect(),
            depth: write.length(extreme(-1.0)),
            pile_up: write.length(extreme(1.0)),
            pile_up_position: if extreme(1.0) > 0.0 { write.length(x.hypot(y)) } else { 0.0 },
            yielded_in_reverse: has_reversed,
            reverse_area: write.area(reverse_area(body, &gains)),
            max_reverse_strain: if has_reversed { most } else { 0.0 },
        }
    }
}

struct Energies {
    work: f64,
    elastic: f64,
}

/// `∫P dα` between two points `[force, approach]` of a loading.
fn work_between([from, start]: [f64; 2], [to, end]: [f64; 2]) -> f64 {
    let trapezoid = 0.5 * (from + to) * (end - start);
    if from <= 0.0 && start.abs() <= 1e-9 * end.abs() {
        return to * end / (HERTZ_POWER + 1.0);
    }
    if from <= 0.0 || to <= from || start <= 0.0 || end <= start {
        return trapezoid;
    }
    let power = (to / from).ln() / (end / start).ln();
    (to * end - from * start) / (power + 1.0)
}

/// By Clapeyron and reciprocity, `½ ∫p (α - δ0) dA - ½ ∫ε_p:(σ - σ_0) dV - ∫ε_p:σ_0 dV` with the stress σ_0 before the load.
fn elastic_energy(job: &Job, step: &HalfSpaceStep) -> f64 {
    let map = &step.surface;
    let gap = initial_gap(job, map);
    let forces = map.pressure.iter().zip(&gap).filter(|(pressure, _)| **pressure > 0.0);
    let by_contact: f64 = forces.map(|(pressure, gap)| pressure * (step.figures.approach - gap)).sum();
    let materials = [&job.upper.material, &job.lower.material];
    let of_plastic: f64 = step
        .bodies
        .iter()
        .zip(materials)
        .filter_map(|(body, material)| Some(plastic_part(body.as_deref()?, material)))
        .sum();
    (0.5 * by_contact * map.grid.cell_area() + of_plastic).max(0.0)
}

/// `-½ ∫ε_p:(σ + σ_0) dV` of one body.
fn plastic_part(body: &HalfSpaceBody, material: &Material) -> f64 {
    let Some(strain) = &body.plastic_strain else { return 0.0 };
    let profile = match material {
        Material::Deformable(material) => crate::job::InitialStressProfile::new(material.initial_stress()),
        Material::Rigid => return 0.0,
    };
    let of_layer = |layer: usize| {
        // The mean of both stresses along the surface stands for them in axes that are turned.
        let [x, y] = profile.at(body.layers.middle(layer));
        let initial = 0.5 * (x + y);
        let [xx, yy, xy, xz, yz] = std::array::from_fn(|k| strain.component(layer, k));
        let stress: [&[f64]; 6] = std::array::from_fn(|k| body.stress.component(layer, k));
        let at = |cell: usize| {
            let normal = xx[cell] * (stress[0][cell] + initial) + yy[cell] * (stress[1][cell] + initial)
                - (xx[cell] + yy[cell]) * stress[2][cell];
            let shear = xy[cell] * stress[3][cell] + xz[cell] * stress[4][cell] + yz[cell] * stress[5][cell];
            normal + 2.0 * shear
        };
        body.layers.thickness(layer) * (0..body.grid.n_cells()).map(at).sum::<f64>()
    };
    -0.5 * body.grid.cell_area() * (0..body.layers.len()).map(of_layer).sum::<f64>()
}

/// Elastic displacement of both surfaces together at each cell, `w - δ0 - u_p + α`; none where nothing touches.
fn elastic_deflection(job: &Job, step: &HalfSpaceStep) -> Vec<f64> {
    let map = &step.surface;
    if step.figures.force <= 0.0 {
        return vec![0.0; map.gap.len()];
    }
    let gap = initial_gap(job, map);
    let at = |cell: usize| {
        let plastic: f64 = step.bodies.iter().flatten().map(|body| body.plastic_displacement[cell]).sum();
        map.gap[cell] - gap[cell] - plastic + step.figures.approach
    };
    (0..map.gap.len()).map(at).collect()
}

/// The gap before loading at the middles of cells.
fn initial_gap(job: &Job, map: &SurfaceMap) -> Vec<f64> {
    let [along_y, along_x] = job.gap_curvatures().unwrap_or_default();
    map.grid.sample(|x, y| 0.5 * (along_x * x * x + along_y * y * y))
}

/// `(1 - ν²)/E` of a body; 0 of a rigid one.
fn compliance(job: &Job, side: usize) -> f64 {
    match &[&job.upper, &job.lower][side].material {
        Material::Deformable(material) => material.elastic().plane_strain_modulus().recip(),
        Material::Rigid => 0.0,
    }
}

/// Equivalent plastic strain that each cell has gained.
fn gains(before: &HalfSpaceBody, now: &HalfSpaceBody) -> Vec<f64> {
    let (before, now) = (&before.equivalent_plastic_strain, &now.equivalent_plastic_strain);
    if before.len() != now.len() {
        return Vec::new();
    }
    now.iter().zip(before).map(|(now, before)| now - before).collect()
}

/// Area in the section y = 0 of the cells that have gained plastic strain.
fn reverse_area(body: &HalfSpaceBody, gains: &[f64]) -> f64 {
    let (ny, n_cells) = (body.grid.ny(), body.grid.n_cells());
    let is_in_section = |cell: usize| cell % n_cells % ny == (ny - 1) / 2;
    let area = |cell: usize| body.grid.hx() * body.layers.thickness(cell / n_cells);
    let reversed =
        gains.iter().enumerate().filter(|(cell, gain)| **gain > NOTICEABLE && is_in_section(*cell));
    reversed.map(|(cell, _)| area(cell)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_work_of_hertz_is_exact_in_any_increments() {
        let force = |approach: f64| 7.0 * approach.powf(1.5);
        let ends = [0.3, 0.35, 1.0];
        let mut last = [0.0, 0.0];
        let mut work = 0.0;
        for end in ends {
            let next = [force(end), end];
            work += work_between(last, next);
            last = next;
        }
        assert!((work / (7.0 / 2.5) - 1.0).abs() < 1e-14);
    }
}
