//! Fields and figures of an answer.

use std::f64::consts::PI;
use std::sync::Arc;

use brinell_contact::Flexibility as _;
use brinell_halfspace::{SurfaceGrid, TensorField, YieldingBody};

use super::step::{HalfSpaceBody, HalfSpaceFigures, LargestStrain, SurfaceMap};
use super::system::{ElasticBody, HalfSpaces};
use crate::solver::Energy;
use crate::solver::method::contact_system::BlockVector;
use crate::solver::method::couplings::iteration::Outcome;

/// An answer as far as it can be read off one state.
pub(super) struct Measured {
    pub figures: HalfSpaceFigures,
    pub peak_position: [f64; 2],
    pub largest_cell_pressure: f64,
    pub surface: SurfaceMap,
    pub energy: Energy,
    pub bodies: [Option<Arc<HalfSpaceBody>>; 2],
}

/// Reads off an answer after its check; `last_peak` is where the pressure was largest before, for bodies that do not touch.
pub(super) fn measure(system: &HalfSpaces, outcome: &Outcome, last_peak: [f64; 2]) -> Measured {
    let contact = &outcome.state.response.contact;
    let grid = *system.grid();
    let pressure: Vec<f64> = contact.force.iter().map(|force| force / grid.cell_area()).collect();
    let touches = contact.total_force > 0.0;
    let (peak_pressure, peak_cell) = system.peak(&contact.force);
    let peak_position = if touches { place(&grid, peak_cell) } else { last_peak };
    let axes = semi_axes(&grid, &pressure);
    let bodies = fields(system, &outcome.state.loads, &pressure);
    let figures = HalfSpaceFigures {
        force: contact.total_force,
        approach: contact.approach,
        peak_pressure,
        semi_axes: axes,
        area: PI * axes[0] * axes[1],
        max_plastic_strain: of_bodies(&bodies, |body| body.largest_strain.map_or(0.0, |most| most.value)),
        dent: of_bodies(&bodies, |body| body.plastic_displacement.iter().copied().fold(0.0, f64::max)),
        pile_up: of_bodies(&bodies, |body| -body.plastic_displacement.iter().copied().fold(0.0, f64::min)),
        least_stress: of_bodies(&bodies, |body| {
            let column = body.column(peak_position);
            column.iter().skip(1).map(|point| point.stress[0].min(point.stress[1])).fold(0.0, f64::min)
        }),
    };
    Measured {
        figures,
        peak_position,
        largest_cell_pressure: pressure.iter().copied().fold(0.0, f64::max),
        surface: SurfaceMap { grid, pressure, gap: contact.gap.clone() },
        energy: energy(system, outcome),
        bodies,
    }
}

/// Elastic energy of the pressure, `½ RᵀF R`, and of plastic strain, whose cross terms cancel; and the work of plastic flow.
fn energy(system: &HalfSpaces, outcome: &Outcome) -> Energy {
    let force = &outcome.state.response.contact.force;
    let mut displacement = vec![0.0; force.len()];
    system.surface.apply(force, &mut displacement);
    let of_pressure = 0.5 * force.iter().zip(&displacement).map(|(r, u)| r * u).sum::<f64>();
    let mut energy = Energy { elastic: of_pressure, ..Energy::default() };
    let mut yielding = system.yielding.borrow_mut();
    for (body, increment) in yielding.bodies.iter_mut().zip(&outcome.state.loads) {
        energy.elastic += body.count() * body.residual_energy(increment);
        let (n_cells, layers) = (force.len(), body.space().layers());
        for cell in 0..layers.len() * n_cells {
            let layer = cell / n_cells;
            let volume = body.count() * layers.thickness(layer) * system.grid().cell_area();
            let [work, stored] = body.law().plastic_work(layer, cell).map(|density| volume * density);
            energy.plastic_work += work;
            energy.backstress += stored;
        }
    }
    energy
}

fn of_bodies(bodies: &[Option<Arc<HalfSpaceBody>>; 2], figure: impl Fn(&HalfSpaceBody) -> f64) -> [f64; 2] {
    bodies.each_ref().map(|body| body.as_deref().map_or(0.0, &figure))
}

/// Middle of a cell.
pub(super) fn place(grid: &SurfaceGrid, cell: usize) -> [f64; 2] {
    [grid.x(cell / grid.ny()), grid.y(cell % grid.ny())]
}

/// Fields of both bodies; equal ones share them.
fn fields(system: &HalfSpaces, loads: &BlockVector, pressure: &[f64]) -> [Option<Arc<HalfSpaceBody>>; 2] {
    let [upper, lower] = &system.elastic;
    let is_shared = matches!((upper, lower), (Some(a), Some(b)) if Arc::ptr_eq(&a.space, &b.space));
    let of = |body: &ElasticBody| Arc::new(field(system, body, loads, pressure));
    let upper = upper.as_ref().map(of);
    let lower = if is_shared { upper.clone() } else { lower.as_ref().map(of) };
    [upper, lower]
}

fn field(system: &HalfSpaces, body: &ElasticBody, loads: &BlockVector, pressure: &[f64]) -> HalfSpaceBody {
    let (grid, layers) = (*body.space.grid(), body.space.layers().clone());
    let mut yielding = system.yielding.borrow_mut();
    let mut result = match body.yielding {
        Some(n) => field_of_yielding(&mut yielding.bodies[n], &loads[n], pressure),
        None => HalfSpaceBody {
            stress: elastic_stress(body, pressure),
            grid,
            layers,
            plastic_strain: None,
            equivalent_plastic_strain: Vec::new(),
            yield_stress: Vec::new(),
            plastic_displacement: vec![0.0; grid.n_cells()],
            largest_strain: None,
            plastic_volume: 0.0,
        },
    };
    for (layer, [xx, yy, xy]) in body.initial.iter().enumerate() {
        for (k, initial) in [(0, xx), (1, yy), (3, xy)] {
            for stress in result.stress.component_mut(layer, k) {
                *stress += initial;
            }
        }
    }
    result
}

fn elastic_stress(body: &ElasticBody, pressure: &[f64]) -> TensorField {
    let (n_layers, n_cells) = (body.space.layers().len(), body.space.grid().n_cells());
    let mut work = body.space.work();
    let mut opening = vec![0.0; n_cells];
    body.space.opening(&TensorField::deviators(n_layers, n_cells), &mut work, &mut opening);
    let mut stress = TensorField::tensors(n_layers, n_cells);
    body.space.stress(pressure, &mut work, &mut stress);
    stress
}

fn field_of_yielding(body: &mut YieldingBody, increment: &[f64], pressure: &[f64]) -> HalfSpaceBody {
    let stress = body.stresses(pressure, increment);
    let (grid, layers) = (*body.space().grid(), body.space().layers().clone());
    let n_cells = grid.n_cells();
    let cells = 0..layers.len() * n_cells;
    let law = body.law();
    let strain: Vec<f64> = cells.clone().map(|cell| law.equivalent_plastic_strain(cell)).collect();
    let has_yielded = |cell: &usize| law.has_yielded(cell / n_cells, *cell);
    let volume = |cell: usize| layers.thickness(cell / n_cells) * grid.cell_area();
    let most = cells.clone().filter(has_yielded).max_by(|a, b| strain[*a].total_cmp(&strain[*b]));
    let largest_strain = most.map(|cell| {
        let [x, y] = place(&grid, cell % n_cells);
        LargestStrain { value: strain[cell], position: [x, y, layers.middle(cell / n_cells)] }
    });
    let plastic_volume = cells.clone().filter(has_yielded).map(volume).sum();
    let yield_stress = cells.map(|cell| law.yield_stress(cell / n_cells, cell)).collect();
    let (plastic_strain, displacement) = body.opened();
    HalfSpaceBody {
        stress,
        plastic_strain: Some(plastic_strain.clone()),
        plastic_displacement: displacement.to_vec(),
        equivalent_plastic_strain: strain,
        yield_stress,
        largest_strain,
        plastic_volume,
        grid,
        layers,
    }
}

/// Where the square of the pressure, on the straight line through the outermost two cells of the rows in the middle, comes
/// to zero.
pub(super) fn semi_axes(grid: &SurfaceGrid, pressure: &[f64]) -> [f64; 2] {
    let (nx, ny) = (grid.nx(), grid.ny());
    let middle = |n: usize| [(n - 1) / 2, n / 2];
    let along_x = |i: usize| 0.5 * middle(ny).map(|j| pressure[i * ny + j]).iter().sum::<f64>();
    let along_y = |j: usize| 0.5 * middle(nx).map(|i| pressure[i * ny + j]).iter().sum::<f64>();
    [
        half_width(&(0..nx).map(along_x).collect::<Vec<_>>(), grid.hx()),
        half_width(&(0..ny).map(along_y).collect::<Vec<_>>(), grid.hy()),
    ]
}

fn half_width(row: &[f64], side: f64) -> f64 {
    let in_contact = |k: &usize| row[*k] > 0.0;
    let (Some(first), Some(last)) = ((0..row.len()).find(in_contact), (0..row.len()).rev().find(in_contact))
    else {
        return 0.0;
    };
    // Beyond the middle of the outermost cell, half a cell where the line does not fall.
    let beyond = |inner: Option<&f64>, outer: f64| match inner {
        Some(inner) if *inner > outer => (outer * outer / (inner * inner - outer * outer)).min(1.0),
        _ => 0.5,
    };
    let ends =
        beyond(row.get(first + 1), row[first]) + beyond(last.checked_sub(1).map(|k| &row[k]), row[last]);
    0.5 * side * ((last - first) as f64 + ends)
}
