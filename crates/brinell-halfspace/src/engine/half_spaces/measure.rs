//! Figures and fields of an answer.

use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;

use crate::{Stop, Stopped, SurfaceGrid, TensorField, YieldingBody};
use brinell_contact::Flexibility as _;

use super::step::{HalfSpaceBody, LargestStrain, PlasticSection, SurfaceMap};
use super::system::{ElasticBody, HalfSpaces, above};
use brinell_method::couplings::iteration::Outcome;
use brinell_method::figures::{BodyFigures, Figures};
use brinell_method::steps::Energy;

/// The figures and fields of an answer that follow from its state.
pub(super) struct Measured {
    pub figures: Figures,
    pub peak_position: [f64; 2],
    pub largest_cell_pressure: f64,
    pub surface: SurfaceMap,
    pub energy: Energy,
    pub bodies: [Option<Arc<HalfSpaceBody>>; 2],
}

/// Stresses of the upper and lower body \[MPa\], without the initial stress; `None` for a rigid
/// body, and for an upper body that equals the lower one.
pub(super) type Stresses = [Option<TensorField>; 2];

/// Evaluates the stresses in the state of an answer.
///
/// # Errors
/// [`Stopped`].
pub(super) fn stresses(
    system: &HalfSpaces,
    outcome: &Outcome,
    stop: &mut Stop<'_>,
) -> Result<Stresses, Stopped> {
    let state = &outcome.state;
    let pressure: Vec<f64> = system.pressure(&state.response.contact.force).collect();
    let mut yielding = system.yielding.borrow_mut();
    let mut of = |body: &ElasticBody| match body.yielding {
        Some(n) => yielding.bodies[n].stresses(&pressure, &state.loads[n], stop),
        None => elastic_stress(body, &pressure, stop),
    };
    let [upper, lower] = &system.elastic;
    let upper = upper.as_ref().filter(|_| !system.is_shared());
    Ok([upper.map(&mut of).transpose()?, lower.as_ref().map(of).transpose()?])
}

/// Derives the figures and fields of an answer. Without `stresses` there is no figure of stress,
/// and the fields of stress are zero. `last_peak` is the earlier position of the largest pressure, for bodies that
/// do not touch.
pub(super) fn measure(
    system: &HalfSpaces,
    outcome: &Outcome,
    last_peak: [f64; 2],
    stresses: Option<Stresses>,
) -> Measured {
    let contact = &outcome.state.response.contact;
    let grid = *system.grid();
    let pressure: Vec<f64> = system.pressure(&contact.force).collect();
    let touches = contact.total_force > 0.0;
    let (peak_pressure, peak_cell) = system.peak(&contact.force);
    let peak_position = if touches { place(&grid, peak_cell) } else { last_peak };
    let axes = semi_axes(system, &pressure);
    let has_stresses = stresses.is_some();
    let bodies = fields(system, stresses.unwrap_or_default());
    let gap = contact.gap.iter().zip(&pressure);
    let gap = gap.map(|(gap, pressure)| if *pressure > 0.0 { 0.0 } else { *gap }).collect();
    let of_body = |body: &Option<Arc<HalfSpaceBody>>| {
        let below = has_stresses.then_some(peak_position);
        body.as_deref().map(|body| of_body(body, below))
    };
    let contact_area = area(system, &pressure, axes);
    let all = grid.cell_area() * grid.n_cells() as f64;
    let middle_pressure = middle_pressure(system, &pressure);
    let figures = Figures {
        force: contact.total_force,
        approach: system.approach(contact),
        // The mean around the largest pressure is below that between the cells of a round top.
        peak_pressure: peak_pressure.max(middle_pressure.unwrap_or_default()),
        middle_pressure,
        half_width: axes[0],
        semi_axis_y: Some(axes[1]),
        contact_area: Some(contact_area),
        contact_ratio: system.design.is_patch().then(|| contact_area / all),
        bodies: [of_body(&bodies[0]), of_body(&bodies[1])],
    };
    Measured {
        figures,
        peak_position,
        largest_cell_pressure: pressure.iter().copied().fold(0.0, f64::max),
        energy: energy(system, outcome, &pressure),
        surface: SurfaceMap { grid, pressure, gap },
        bodies,
    }
}

/// Returns the elastic energy and the work of plastic flow. The elastic energy has a part from the
/// pressure, `½ RᵀF R`, and a part from the plastic strain; their cross terms cancel.
fn energy(system: &HalfSpaces, outcome: &Outcome, pressure: &[f64]) -> Energy {
    let (state, force) = (&outcome.state, &outcome.state.response.contact.force);
    let mut displacement = vec![0.0; force.len()];
    system.surface.apply(force, &mut displacement);
    let of_pressure = 0.5 * force.iter().zip(&displacement).map(|(r, u)| r * u).sum::<f64>();
    let mut energy = Energy { elastic: of_pressure, ..Energy::default() };
    let yielding = system.yielding.borrow();
    for ((body, increment), trial) in
        yielding.bodies.iter().zip(&state.loads).zip(&state.response.displacement)
    {
        energy.elastic += body.count() * body.residual_energy(pressure, trial, increment);
        let (n_cells, layers) = (force.len(), body.space().layers());
        for cell in 0..layers.len() * n_cells {
            let layer = cell / n_cells;
            let volume = body.count() * layers.thickness(layer) * system.grid().cell_area();
            let [work, stored] =
                body.law().plastic_work(layer, cell).map(|density| volume * density);
            energy.plastic_work += work;
            energy.backstress += stored;
        }
    }
    energy
}

/// Measures the figures of a body. The least stress is that below a place, that of the largest
/// pressure.
fn of_body(body: &HalfSpaceBody, below: Option<[f64; 2]>) -> BodyFigures {
    let displacement = || body.plastic_displacement.iter().copied();
    let n_cells = body.grid.n_cells();
    let strains = body.equivalent_plastic_strain.chunks(n_cells.max(1)).enumerate();
    let yielded =
        strains.filter(|(_, strains)| strains.iter().any(|e| *e > 0.0)).map(|(layer, _)| layer);
    let least_stress = |place: [f64; 2]| {
        let below = body.column(place).into_iter().skip(1);
        below.map(|point| point.stress[0].min(point.stress[1])).fold(0.0, f64::min)
    };
    BodyFigures {
        max_plastic_strain: body.largest_strain.map_or(0.0, |most| most.value),
        mean_plastic_strain: None,
        plastic_area: None,
        plastic_depth: yielded.map(|layer| body.layers.middle(layer)).reduce(f64::max),
        dent: displacement().fold(0.0, f64::max),
        pile_up: -displacement().fold(0.0, f64::min),
        least_stress: below.map(least_stress),
        largest_von_mises: None,
    }
}

/// Returns the middle of a cell.
pub(super) fn place(grid: &SurfaceGrid, cell: usize) -> [f64; 2] {
    [grid.x(cell / grid.ny()), grid.y(cell % grid.ny())]
}

/// Returns the fields of both bodies; equal bodies share them.
fn fields(system: &HalfSpaces, [upper, lower]: Stresses) -> [Option<Arc<HalfSpaceBody>>; 2] {
    let of = |side: usize, stress: Option<TensorField>| {
        system.elastic[side].as_ref().map(|body| Arc::new(field(system, body, stress)))
    };
    let lower = of(1, lower);
    [if system.is_shared() { lower.clone() } else { of(0, upper) }, lower]
}

fn field(system: &HalfSpaces, body: &ElasticBody, stress: Option<TensorField>) -> HalfSpaceBody {
    let (grid, layers) = (*body.space.grid(), body.space.layers().clone());
    let (n_layers, n_cells) = (layers.len(), grid.n_cells());
    let has_stress = stress.is_some();
    let stress = stress.unwrap_or_else(|| TensorField::tensors(n_layers, n_cells));
    let elastic = HalfSpaceBody {
        stress,
        grid,
        layers,
        plastic_strain: None,
        equivalent_plastic_strain: Vec::new(),
        plastic_displacement: vec![0.0; n_cells],
        largest_strain: None,
        plastic_volume: 0.0,
        plastic_section: PlasticSection::default(),
    };
    let yielding = system.yielding.borrow();
    let mut result = match body.yielding {
        Some(n) => field_of_yielding(&yielding.bodies[n], elastic),
        None => elastic,
    };
    for (layer, [xx, yy, xy]) in body.initial.iter().enumerate().filter(|_| has_stress) {
        for (k, initial) in [(0, xx), (1, yy), (3, xy)] {
            for stress in result.stress.component_mut(layer, k) {
                *stress += initial;
            }
        }
    }
    result
}

fn elastic_stress(
    body: &ElasticBody,
    pressure: &[f64],
    stop: &mut Stop<'_>,
) -> Result<TensorField, Stopped> {
    let (n_layers, n_cells) = (body.space.layers().len(), body.space.grid().n_cells());
    let mut work = body.space.work();
    let mut opening = vec![0.0; n_cells];
    body.space.opening(
        &TensorField::deviators(n_layers, n_cells),
        &mut work,
        &mut opening,
        stop,
    )?;
    let mut stress = TensorField::tensors(n_layers, n_cells);
    body.space.stress(pressure, &mut work, &mut stress, stop)?;
    Ok(stress)
}

/// Adds the plastic strain and displacement to the fields of a body that can yield.
fn field_of_yielding(body: &YieldingBody, elastic: HalfSpaceBody) -> HalfSpaceBody {
    let HalfSpaceBody { grid, ref layers, .. } = elastic;
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
    let beside_axis = |cell: &usize| cell % grid.ny() == (grid.ny() - 1) / 2;
    let section = cells.filter(beside_axis).filter(has_yielded);
    let [area, integral] = section.fold([0.0; 2], |[area, integral], cell| {
        let part = layers.thickness(cell / n_cells) * grid.hx();
        [area + part, integral + part * strain[cell]]
    });
    let plastic_section = PlasticSection {
        area,
        mean_strain: if area > 0.0 { integral / area } else { 0.0 },
        reaches_surface: (0..n_cells).any(|cell| has_yielded(&cell)),
    };
    let (plastic_strain, displacement) = body.opened();
    HalfSpaceBody {
        plastic_strain: Some(plastic_strain.clone()),
        plastic_displacement: displacement.to_vec(),
        equivalent_plastic_strain: strain,
        largest_strain,
        plastic_volume,
        plastic_section,
        ..elastic
    }
}

/// Returns half the width and half the length of the contact; with a roller, the largest
/// half-width of its [rows clear of its ends](Row::clear_of_ends), of all rows where none is.
pub(super) fn semi_axes(system: &HalfSpaces, pressure: &[f64]) -> [f64; 2] {
    let grid = system.grid();
    if system.design.is_patch() {
        return half_extents(grid, pressure);
    }
    let Some(half_length) = system.design.half_length else { return ellipse(grid, pressure) };
    let rows = Row::all(grid, pressure);
    let largest: Vec<f64> = rows.iter().map(|row| row.largest_pressure).collect();
    let widest = |rows: &[Row]| rows.iter().map(|row| row.half_width).fold(0.0, f64::max);
    let clear = widest(&rows[Row::clear_of_ends(grid, &rows, half_length)]);
    let width = if clear > 0.0 { clear } else { widest(&rows) };
    // The line through two rows knows nothing of the end of a roller.
    let ends = ends(&largest, grid.hy()).map(|[low, high]| {
        let y = |from_first: f64| (grid.y(0) + from_first).clamp(-half_length, half_length);
        0.5 * (y(high) - y(low))
    });
    [width, ends.unwrap_or(0.0)]
}

/// Returns the largest distances from the origin to cells in contact, along x and along y.
pub(super) fn reach(system: &HalfSpaces, pressure: &[f64]) -> [f64; 2] {
    let (grid, axes) = (system.grid(), semi_axes(system, pressure));
    if system.design.half_length.is_none() {
        return axes;
    }
    let touched = (0..pressure.len()).filter(|cell| pressure[*cell] > 0.0);
    let farthest =
        touched.map(|cell| place(grid, cell)[1].abs() + 0.5 * grid.hy()).fold(0.0, f64::max);
    [axes[0], farthest]
}

/// Returns half the extents of the cells in contact along x and y, the outermost cells included.
fn half_extents(grid: &SurfaceGrid, pressure: &[f64]) -> [f64; 2] {
    let touched = || (0..pressure.len()).filter(|cell| pressure[*cell] > 0.0);
    let half = |number: &dyn Fn(usize) -> usize, side: f64| {
        let (first, last) = (touched().map(number).min(), touched().map(number).max());
        first.zip(last).map_or(0.0, |(first, last)| 0.5 * side * (last - first + 1) as f64)
    };
    [half(&|cell| cell / grid.ny(), grid.hx()), half(&|cell| cell % grid.ny(), grid.hy())]
}

/// Weights of four cells for the value between the inner two, by a cubic, and for their mean.
const CUBIC: [f64; 4] = [-0.0625, 0.5625, 0.5625, -0.0625];
const MEAN: [f64; 4] = [0.0, 0.5, 0.5, 0.0];

/// Returns the pressure in the middle of the contact, which lies between cells, by the squares of
/// elastic bodies and as the mean of bodies that yield; of a roller the largest across its middle;
/// `None` of heights.
fn middle_pressure(system: &HalfSpaces, pressure: &[f64]) -> Option<f64> {
    let (grid, design) = (system.grid(), &system.design);
    if design.is_patch() {
        return None;
    }
    let (weights, power) = if system.is_elastic() { (CUBIC, 2) } else { (MEAN, 1) };
    let [first, low] = [grid.nx(), grid.ny()].map(|count| count / 2 - 2);
    let beside = |i: usize| {
        let cells = pressure[i * grid.ny() + low..].iter().zip(weights);
        cells.map(|(pressure, weight)| weight * pressure.powi(power)).sum::<f64>()
    };
    let middle = if design.half_length.is_some() {
        let across: Vec<f64> = (0..grid.nx()).map(beside).collect();
        let top = |three: &[f64]| match power {
            2 => three[1] + above(three[0], three[1], three[2]),
            _ => three[1],
        };
        across.windows(3).map(top).fold(0.0, f64::max)
    } else {
        weights.iter().enumerate().map(|(k, weight)| weight * beside(first + k)).sum()
    };
    Some(middle.max(0.0).powf(f64::from(power).recip()))
}

/// Returns the contact area: of the ellipse with these semi-axes, of the rows of a roller, or of
/// the cells in contact under heights.
fn area(system: &HalfSpaces, pressure: &[f64], axes: [f64; 2]) -> f64 {
    if system.design.is_patch() {
        return pressure.iter().filter(|p| **p > 0.0).count() as f64 * system.grid().cell_area();
    }
    if system.design.half_length.is_none() {
        return PI * axes[0] * axes[1];
    }
    let rows = Row::all(system.grid(), pressure);
    rows.iter().map(|row| 2.0 * row.half_width * system.grid().hy()).sum()
}

/// Contact figures of a row of cells along x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Force per unit length along y \[N/mm\].
    pub line_load: f64,
    /// Half-width of the contact \[mm\].
    pub half_width: f64,
    /// Largest pressure of a cell \[MPa\].
    pub largest_pressure: f64,
}

impl Row {
    /// Returns all rows, in the order of y.
    pub fn all(grid: &SurfaceGrid, pressure: &[f64]) -> Vec<Self> {
        let of_row = |j: usize| {
            let cells: Vec<f64> = (0..grid.nx()).map(|i| pressure[i * grid.ny() + j]).collect();
            Self {
                line_load: cells.iter().sum::<f64>() * grid.hx(),
                half_width: half_width(&cells, grid.hx()),
                largest_pressure: cells.iter().copied().fold(0.0, f64::max),
            }
        };
        (0..grid.ny()).map(of_row).collect()
    }

    /// Returns the rows that are further from the ends of a roller than the widest row is wide: the
    /// pressure that an end concentrates widens the rows beside it, the more the smaller the cells.
    pub fn clear_of_ends(grid: &SurfaceGrid, rows: &[Self], half_length: f64) -> Range<usize> {
        let widest = rows.iter().map(|row| row.half_width).fold(0.0, f64::max);
        let is_clear = |j: &usize| grid.y(*j).abs() < half_length - widest;
        let first = (0..rows.len()).find(is_clear).unwrap_or_default();
        let count = (first..rows.len()).take_while(is_clear).count();
        first..first + count
    }
}

/// Returns the semi-axes of the ellipse that has the area of the contact, over all rows and over all
/// columns of cells, and the ratio of the second moments of the pressure, `a²/b² = ∫p x²/∫p y²`. On
/// the rows of flat pressures, which end within a cell, one row alone is off by half a cell.
fn ellipse(grid: &SurfaceGrid, pressure: &[f64]) -> [f64; 2] {
    let (ny, hx, hy) = (grid.ny(), grid.hx(), grid.hy());
    let along_y: f64 = pressure.chunks_exact(ny).map(|row| half_width(row, hy)).sum();
    let row = |j: usize| pressure.iter().skip(j).step_by(ny).copied().collect::<Vec<_>>();
    let along_x: f64 = (0..ny).map(|j| half_width(&row(j), hx)).sum();
    let product = (along_y * hx + along_x * hy) / PI;
    let [of_x, of_y] = pressure.iter().enumerate().fold([0.0; 2], |[of_x, of_y], (cell, p)| {
        let [x, y] = place(grid, cell);
        [of_x + p * (x * x + hx * hx / 12.0), of_y + p * (y * y + hy * hy / 12.0)]
    });
    if product == 0.0 {
        return [0.0; 2];
    }
    let ratio = (of_x / of_y).sqrt();
    [(product * ratio).sqrt(), (product / ratio).sqrt()]
}

/// Returns half the width of a row in contact.
fn half_width(row: &[f64], side: f64) -> f64 {
    ends(row, side).map_or(0.0, |[low, high]| 0.5 * (high - low))
}

/// Returns the ends of a row in contact, from the middle of its first cell on: there the squared
/// pressure falls to zero on the straight line through the outermost two cells.
fn ends(row: &[f64], side: f64) -> Option<[f64; 2]> {
    let in_contact = |k: &usize| row[*k] > 0.0;
    let first = (0..row.len()).find(in_contact)?;
    let last = (0..row.len()).rev().find(in_contact)?;
    // Distance from the middle of the outermost cell, in cells; half a cell if the line does not
    // fall.
    let beyond = |inner: Option<&f64>, outer: f64| match inner {
        Some(inner) if *inner > outer => {
            (outer * outer / (inner * inner - outer * outer)).min(1.0)
        }
        _ => 0.5,
    };
    let before = beyond(row.get(first + 1), row[first]);
    let after = beyond(last.checked_sub(1).map(|k| &row[k]), row[last]);
    Some([first as f64 - before, last as f64 + after].map(|cells| side * cells))
}
