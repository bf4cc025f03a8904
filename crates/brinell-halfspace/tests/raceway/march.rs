//! The same pass by marching the ball column by column over a long straight track, which knows
//! neither a join nor an inlet.

use std::sync::Arc;

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolver, never,
};
use brinell_halfspace::SurfaceFlexibility;
use brinell_halfspace::raceway::{RacewaySpace, RacewayWork};
use brinell_halfspace::track::{Direction, Operators as _, TrackGrid};
use brinell_material::hardening::StraightLine;
use brinell_material::{ElasticModuli, FlowPlasticity, Flowing, OutOfPlane, ReturnMapping};
use brinell_method::couplings::anderson::Anderson;

use super::driver::{POISSON, Roller, Setup, TWENTIETH, YIELD, YOUNG, modulus, space};

const COMPONENTS: usize = 5;

/// A track without backstress, cell by cell, in the frame of the ball.
struct March {
    space: RacewaySpace,
    grid: TrackGrid,
    work: RacewayWork,
    model: FlowPlasticity<0>,
    flexibility: SurfaceFlexibility,
    gap: Vec<f64>,
    setup: Setup,
    /// `2μ ε_p`, and the deviators at the end of the last step.
    strain: Vec<f64>,
    stress: Vec<f64>,
    accumulated: Vec<f64>,
    /// The last increment, where the next one begins.
    last: Vec<f64>,
    evaluations: usize,
}

impl March {
    fn new(setup: &Setup) -> Self {
        let (grid, layers) = setup.grid();
        let space = space(grid, layers, setup.friction != 0.0);
        let elastic = ElasticModuli {
            bulk: YOUNG / (3.0 * (1.0 - 2.0 * POISSON)),
            shear: 0.5 * YOUNG / (1.0 + POISSON),
        };
        let law = StraightLine { yield_stress: YIELD, plastic_modulus: setup.plastic_modulus };
        let mapping = ReturnMapping::new(Arc::new(law), elastic.shear);
        let surface = grid.surface().unwrap();
        let [rx, ry] = setup.radii;
        let n = space.ground().field_len::<5>();
        Self {
            work: space.work(),
            model: FlowPlasticity::new(elastic, mapping, [], OutOfPlane::Strained),
            gap: surface.sample(|x, y| x * x / (2.0 * rx) + y * y / (2.0 * ry)),
            flexibility: SurfaceFlexibility::new(surface, modulus()),
            setup: setup.clone(),
            strain: vec![0.0; n],
            stress: vec![0.0; n],
            accumulated: vec![0.0; n / COMPONENTS],
            last: vec![0.0; n],
            evaluations: 0,
            space,
            grid,
        }
    }

    /// The trial under a part of the load with these strains in all.
    fn trial(&mut self, total: &[f64], part: f64, into: &mut [f64]) {
        let (rows, window) = (self.grid.n_rows(), self.grid.window().len());
        let mut opening = vec![0.0; rows * window];
        let reach = vec![rows; self.space.ground().layers.len()];
        self.space
            .opening(Direction::Normal, total, &reach, &mut self.work, &mut opening, &mut || false)
            .unwrap();
        let mut gap = self.gap.clone();
        for (i, cells) in gap.chunks_exact_mut(2 * rows).enumerate() {
            for j in 0..rows {
                cells[rows + j] += opening[j * window + i];
                cells[rows - 1 - j] += opening[j * window + i];
            }
        }
        let problem = ContactProblem {
            flexibility: &self.flexibility,
            initial_gap: &gap,
            closing: &vec![1.0; gap.len()],
            load: ContactLoad::Force(part * self.setup.force()),
        };
        let contact =
            ConjugateGradientSolver::new(1e-8).solve(&problem, None, &mut never).unwrap();
        let mut pressure = vec![0.0; rows * window];
        for (i, cells) in contact.force.chunks_exact(2 * rows).enumerate() {
            for j in 0..rows {
                pressure[j * window + i] =
                    0.5 * (cells[rows + j] + cells[rows - 1 - j]) / self.grid.cell_area();
            }
        }
        let friction = self.setup.friction;
        self.space.stress(&pressure, friction, &mut self.work, into, &mut || false).unwrap();
    }

    /// Solves one step at a part of the load.
    fn step(&mut self, part: f64) {
        let n_cells = self.grid.n_cells();
        let mut increment = std::mem::take(&mut self.last);
        let (mut trial, mut image) = (increment.clone(), increment.clone());
        let mut strains = vec![0.0; self.accumulated.len()];
        let mut anderson = Anderson::default();
        for _ in 0..80 {
            self.evaluations += 1;
            let total: Vec<f64> = self.strain.iter().zip(&increment).map(|(e, d)| e + d).collect();
            self.trial(&total, part, &mut trial);
            image.fill(0.0);
            strains.copy_from_slice(&self.accumulated);
            for (cell, strain) in strains.iter_mut().enumerate() {
                let at = |k: usize| (cell / n_cells * COMPONENTS + k) * n_cells + cell % n_cells;
                let whole = |field: &[f64]| {
                    let [xx, yy, xy, xz, yz] = std::array::from_fn(|k| field[at(k)]);
                    [xx, yy, -xx - yy, xy, xz, yz]
                };
                let (stress, old, added) = (whole(&trial), whole(&self.stress), whole(&increment));
                let start = Flowing {
                    stress: old,
                    accumulated: *strain,
                    backstress: [],
                    plastic_work: 0.0,
                };
                let step = std::array::from_fn(|k| stress[k] + added[k] - old[k]);
                let Some(end) = self.model.flow_along(start, step, 2) else { continue };
                *strain = end.accumulated;
                for (k, row) in [0, 1, 3, 4, 5].into_iter().enumerate() {
                    image[at(k)] = stress[row] + added[row] - end.stress[row];
                }
            }
            let size = image.iter().map(|y| y * y).sum::<f64>().sqrt();
            let change = increment.iter().zip(&image).map(|(x, y)| (x - y).powi(2)).sum::<f64>();
            if change.sqrt() <= self.setup.tolerance * size {
                break;
            }
            increment = anderson.next(&increment, image.clone());
        }
        for (strain, added) in self.strain.iter_mut().zip(&image) {
            *strain += added;
        }
        self.accumulated = strains;
        self.stress = trial;
        self.last = image;
    }

    /// Moves the ball by one column.
    fn shift(&mut self) {
        let nx = self.grid.n_columns();
        for field in [&mut self.strain, &mut self.stress, &mut self.accumulated] {
            field.chunks_exact_mut(nx).for_each(|row| row.rotate_left(1));
        }
    }

    /// Largest accumulated strain of the section so far behind the ball; of a track with this
    /// section the groove, how far its axis has moved forward, and the least residual stress σxx,
    /// σyy on it.
    fn behind(&mut self, distance: f64) -> (f64, [f64; 2], [f64; 2]) {
        let (nx, rows) = (self.grid.n_columns(), self.grid.n_rows());
        let column = (0..nx / 2).rev().find(|i| self.grid.x(*i) <= -distance).unwrap();
        let of = |field: &[f64], row: usize| field[row * nx + column];
        let n_rows = self.accumulated.len() / nx;
        let strain = (0..n_rows).map(|row| of(&self.accumulated, row)).fold(0.0, f64::max);
        let section: Vec<[f64; COMPONENTS]> = (0..n_rows)
            .map(|row| {
                let (layer, j) = (row / rows, row % rows);
                std::array::from_fn(|k| of(&self.strain, (layer * COMPONENTS + k) * rows + j))
            })
            .collect();
        let initial = vec![[0.0; 2]; n_rows / rows];
        let left = self.space.settle(&section, &initial, &mut self.work);
        let least =
            |k: usize| left.residual.iter().step_by(rows).map(|s| s[k]).fold(0.0, f64::min);
        let compliance = 0.5 / self.space.ground().elastic.shear();
        let strains: Vec<_> = section.iter().map(|tau| tau.map(|t| compliance * t)).collect();
        let outlet = [left.groove[0], self.space.forward(&strains)];
        (strain, outlet, [least(0), least(1)])
    }
}

/// Points that the ball has passed after travelling 10 a have what a pass in one piece gives them,
/// with hardening, with friction, and without hardening, where a join would flow most.
#[test]
#[ignore = "full"]
fn a_pass_of_a_ball_is_what_marching_a_straight_track_gives() {
    for (friction, ratio, modulus) in
        [(0.0, 3.5, TWENTIETH), (0.2, 3.0, TWENTIETH), (0.0, 3.5, 0.0)]
    {
        let setup = Setup { friction, ..Setup::ball(5, ratio, modulus) };
        let pass = Roller::new(&setup).pass();
        let mut march = March::new(&Setup { length: 24.0, tolerance: 1e-4, ..setup });
        for part in 1..=5 {
            march.step(0.2 * f64::from(part));
        }
        for _ in 0..50 {
            march.shift();
            march.step(1.0);
        }
        let (strain, outlet, residual) = march.behind(2.0 * march.setup.hertz().semi_axis_x);
        println!(
            "marching {strain:.3e} {outlet:?} {residual:.1?}, {} evaluations; one piece {}",
            march.evaluations,
            pass.line()
        );
        let close = |found: f64, expected: f64| {
            assert!((found / expected - 1.0).abs() < 0.015, "{found:e} for {expected:e}");
        };
        close(pass.strain.largest.value, strain);
        close(pass.outlet.groove_depth, outlet[0]);
        close(pass.outlet.forward, outlet[1]);
        close(pass.least_residual()[0], residual[0]);
        close(pass.least_residual()[1], residual[1]);
    }
}
