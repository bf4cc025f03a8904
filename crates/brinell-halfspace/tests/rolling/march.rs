//! The same pass by marching the load column by column over a long track: another way to the same
//! figures, and what a pass in one piece saves.

#![allow(dead_code, reason = "tests and benches use parts of it")]

use std::f64::consts::PI;

use brinell_contact::{ActiveSetSolver, ContactLoad, ContactProblem, ContactSolver, never};
use brinell_halfspace::line::{LineFlexibility, LineSpace, LineWork};
use brinell_halfspace::track::{Direction, Operators as _, TrackGrid};
use brinell_material::{
    ElasticModuli, FlowPlasticity, Flowing, OutOfPlane, ReturnMapping, scaled,
};
use brinell_method::couplings::anderson::Anderson;

use super::driver::{A, POISSON, Setup, YOUNG, modulus, space};

/// A perfectly plastic track, cell by cell, in the frame of the load.
pub struct March {
    space: LineSpace,
    grid: TrackGrid,
    work: LineWork,
    model: FlowPlasticity<0>,
    flexibility: LineFlexibility,
    gap: Vec<f64>,
    force: f64,
    friction: f64,
    tolerance: f64,
    /// `2μ ε_p`, and the deviators at the end of the last step.
    strain: Vec<f64>,
    stress: Vec<f64>,
    accumulated: Vec<f64>,
    /// The last increment, where the next one begins.
    last: Vec<f64>,
    pub evaluations: usize,
}

impl March {
    pub fn new(setup: &Setup) -> Self {
        let (grid, layers) = setup.grid();
        let space = space(grid, layers);
        let elastic = ElasticModuli {
            bulk: YOUNG / (3.0 * (1.0 - 2.0 * POISSON)),
            shear: 0.5 * YOUNG / (1.0 + POISSON),
        };
        let mapping = ReturnMapping::new(scaled(&setup.material.law, 1.0), elastic.shear);
        let radius = modulus() * A / (2.0 * setup.peak);
        let n = space.ground().field_len::<3>();
        Self {
            work: space.work(),
            model: FlowPlasticity::new(elastic, mapping, [], OutOfPlane::Strained),
            flexibility: LineFlexibility::new(&grid, modulus()),
            gap: grid.sample(|x, _| x * x / (2.0 * radius)),
            force: 0.5 * PI * A * setup.peak,
            friction: setup.friction,
            tolerance: setup.tolerance,
            strain: vec![0.0; n],
            stress: vec![0.0; n],
            accumulated: vec![0.0; n / 3],
            last: vec![0.0; n],
            evaluations: 0,
            space,
            grid,
        }
    }

    /// Solves one step at a part of the load.
    pub fn step(&mut self, part: f64) {
        let n = self.grid.n_columns();
        let strained = vec![1; self.space.ground().layers.len()];
        let mut increment = std::mem::take(&mut self.last);
        let mut trial = vec![0.0; increment.len()];
        let mut image = vec![0.0; increment.len()];
        let mut strains = vec![0.0; self.accumulated.len()];
        let mut flowed: Vec<usize> = Vec::new();
        let mut has_flowed = vec![false; self.accumulated.len()];
        for (cell, has_flowed) in has_flowed.iter_mut().enumerate() {
            if (0..3).any(|k| increment[place(cell, n) + k * n] != 0.0) {
                *has_flowed = true;
                flowed.push(cell);
            }
        }
        let mut anderson = Anderson::default();
        for _ in 0..80 {
            self.evaluations += 1;
            let total: Vec<f64> = self.strain.iter().zip(&increment).map(|(e, d)| e + d).collect();
            let mut opening = vec![0.0; self.gap.len()];
            self.space
                .opening(
                    Direction::Normal,
                    &total,
                    &strained,
                    &mut self.work,
                    &mut opening,
                    &mut || false,
                )
                .unwrap();
            let gap: Vec<f64> = self.gap.iter().zip(&opening).map(|(g, u)| g + u).collect();
            let problem = ContactProblem {
                flexibility: &self.flexibility,
                initial_gap: &gap,
                closing: &vec![1.0; gap.len()],
                load: ContactLoad::Force(part * self.force),
            };
            let contact = ActiveSetSolver.solve(&problem, None, &mut never).unwrap();
            let pressure: Vec<f64> =
                contact.force.iter().map(|f| f / self.grid.column()).collect();
            self.space
                .stress(&pressure, self.friction, &mut self.work, &mut trial, &mut || false)
                .unwrap();
            image.fill(0.0);
            strains.copy_from_slice(&self.accumulated);
            for cell in 0..strains.len() {
                let at = place(cell, n);
                let whole = |field: &[f64]| {
                    let [xx, zz, xz] = [field[at], field[at + n], field[at + 2 * n]];
                    [xx, -xx - zz, zz, xz]
                };
                let (stress, old, added) = (whole(&trial), whole(&self.stress), whole(&increment));
                let start = Flowing {
                    stress: old,
                    accumulated: self.accumulated[cell],
                    backstress: [],
                    plastic_work: 0.0,
                };
                let step = std::array::from_fn(|k| stress[k] + added[k] - old[k]);
                let Some(end) = self.model.flow_along(start, step, 2) else { continue };
                strains[cell] = end.accumulated;
                for (k, row) in [0, 2, 3].into_iter().enumerate() {
                    image[at + k * n] = stress[row] + added[row] - end.stress[row];
                }
                if !std::mem::replace(&mut has_flowed[cell], true) {
                    flowed.push(cell);
                }
            }
            let pack = |field: &[f64]| {
                let mut packed = Vec::with_capacity(3 * flowed.len());
                for cell in &flowed {
                    let weight = self.space.ground().layers.thickness(cell / n).sqrt();
                    packed.extend((0..3).map(|k| weight * field[place(*cell, n) + k * n]));
                }
                packed
            };
            let (x, y) = (pack(&increment), pack(&image));
            let size = y.iter().map(|y| y * y).sum::<f64>().sqrt();
            let change = x.iter().zip(&y).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
            if change <= self.tolerance * size {
                break;
            }
            let next = anderson.next(&x, y);
            for (cell, values) in flowed.iter().zip(next.chunks_exact(3)) {
                let weight = self.space.ground().layers.thickness(cell / n).sqrt().recip();
                for (k, value) in values.iter().enumerate() {
                    increment[place(*cell, n) + k * n] = weight * value;
                }
            }
        }
        for (strain, added) in self.strain.iter_mut().zip(&image) {
            *strain += added;
        }
        self.accumulated = strains;
        self.stress = trial;
        self.last = image;
    }

    /// Moves the load by one column.
    pub fn shift(&mut self) {
        let n = self.grid.n_columns();
        for field in [&mut self.strain, &mut self.stress, &mut self.accumulated] {
            for row in field.chunks_exact_mut(n) {
                row.rotate_left(1);
            }
        }
    }

    /// Largest accumulated strain of the column that is so far behind the load, and how far its
    /// surface has moved forward.
    pub fn behind(&self, distance: f64) -> (f64, f64) {
        let n = self.grid.n_columns();
        let column = (0..n / 2).rev().find(|i| self.grid.x(*i) <= -distance).unwrap_or(0);
        let layers = &self.space.ground().layers;
        let strain =
            (0..layers.len()).map(|l| self.accumulated[l * n + column]).fold(0.0, f64::max);
        let shear: f64 = (0..layers.len())
            .map(|l| layers.thickness(l) * self.strain[(l * 3 + 2) * n + column])
            .sum();
        (strain, -shear / self.space.ground().elastic.shear())
    }
}

/// The first of the three numbers of a cell.
const fn place(cell: usize, n: usize) -> usize {
    cell / n * 3 * n + cell % n
}

/// Points that the load has passed after travelling 9 a have what a pass in one piece gives them;
/// at a small part of the evaluations.
#[test]
fn a_pass_is_what_marching_gives() {
    let setup = Setup { length: 24.0, ..Setup::new(10, 0.0, 1.05) };
    let pass = super::driver::Roller::new(&setup).pass(150);
    let mut march = March::new(&setup);
    for part in 1..=5 {
        march.step(0.2 * f64::from(part));
    }
    let travel = 90;
    for _ in 0..travel {
        march.shift();
        march.step(1.0);
    }
    // What was rolled over early on had less track behind it.
    let (strain, forward) = march.behind(1.5);
    let whole = march.evaluations * march.grid.n_columns() / travel;
    println!(
        "marching {strain:.3e} {forward:.3e}, {} evaluations, {whole} for the ring; one piece {}",
        march.evaluations,
        pass.line()
    );
    assert!((strain / pass.strain.largest.value - 1.0).abs() < 0.04, "{strain}");
    assert!((forward / pass.outlet.forward - 1.0).abs() < 0.05, "{forward}");
    assert!(march.evaluations > 12 * pass.evaluations, "{}", march.evaluations);
}

/// Near the limit of its traction a perfectly plastic track flows wherever its stress jumps. A load
/// that is marched over a long straight track, whose ends it never sees, leaves what the pass in one
/// piece leaves.
#[test]
#[ignore = "full"]
fn a_pass_near_its_traction_is_what_marching_a_straight_track_gives() {
    let setup = Setup { length: 48.0, ..Setup::new(10, 0.2, 1.45) };
    let pass = super::driver::Roller::new(&Setup { length: 32.0, ..setup.clone() }).pass(150);
    let mut march = March::new(&setup);
    for part in 1..=5 {
        march.step(0.2 * f64::from(part));
    }
    for _ in 0..140 {
        march.shift();
        march.step(1.0);
    }
    let (strain, forward) = march.behind(2.0);
    println!("marching {strain:.3e} {forward:.3e}; one piece {}", pass.line());
    assert!((strain / pass.strain.largest.value - 1.0).abs() < 0.05, "{strain}");
    assert!((forward / pass.outlet.forward - 1.0).abs() < 0.05, "{forward}");
}
