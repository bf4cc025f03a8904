//! An evaluation beside the Fourier transforms it consists of, and an elastic contact.
//!
//! `cargo bench -p brinell-tools --bench evaluation`. The ratio of `evaluation` to `transforms`
//! within one run is what counts.
#![expect(clippy::unwrap_used, reason = "a benchmark that cannot go on says where")]

use std::hint::black_box;

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolver, never,
};
use brinell_halfspace::{
    Elasticity, EllipticContact, HalfSpace, Layers, SurfaceFlexibility, SurfaceGrid, TensorField,
};
use criterion::{Criterion, criterion_group, criterion_main};
use realfft::RealFftPlanner;
use rustfft::FftPlanner;
use rustfft::num_complex::Complex64;

/// Transforms of `count` fields there and back, rows that are padding left out: plans and nothing
/// else.
struct Transforms {
    n: usize,
    count: usize,
    rows: Vec<f64>,
    half: Vec<Complex64>,
    columns: Vec<Complex64>,
    scratch: Vec<Complex64>,
}

impl Transforms {
    fn new(n: usize, count: usize) -> Self {
        let m = 2 * n;
        let zero = Complex64::ZERO;
        Self {
            n,
            count,
            rows: vec![1.0; m],
            half: vec![zero; n + 1],
            columns: vec![zero; m * (n + 1)],
            scratch: vec![zero; 4 * m],
        }
    }

    fn run(&mut self, real: &mut RealFftPlanner<f64>, complex: &mut FftPlanner<f64>) {
        let m = 2 * self.n;
        let (there, back) = (real.plan_fft_forward(m), real.plan_fft_inverse(m));
        let (down, up) = (complex.plan_fft_forward(m), complex.plan_fft_inverse(m));
        for _ in 0..self.count {
            for _ in 0..self.n {
                there
                    .process_with_scratch(&mut self.rows, &mut self.half, &mut self.scratch)
                    .unwrap();
            }
            down.process_with_scratch(&mut self.columns, &mut self.scratch);
            up.process_with_scratch(&mut self.columns, &mut self.scratch);
            for _ in 0..self.n {
                self.half[0].im = 0.0;
                self.half[self.n].im = 0.0;
                back.process_with_scratch(&mut self.half, &mut self.rows, &mut self.scratch)
                    .unwrap();
            }
            black_box(&self.rows);
        }
    }
}

/// The operators of a ball's half-space, 3.2 semi-axes long, with layers to 2.6 of them.
fn space(n: usize, is_symmetric: bool) -> HalfSpace {
    let side = 3.2 / n as f64;
    let grid = SurfaceGrid::new(n, n, side, side).unwrap();
    let layers = Layers::graded(0.75 * side, 1.0 + 1.92 / n as f64, 2.6).unwrap();
    let elastic = Elasticity::new(210_000.0, 0.3).unwrap();
    HalfSpace::new(grid, layers, elastic, is_symmetric, &mut || false).unwrap()
}

/// A deviator in a half ball of radius 1, which is where a ball yields.
fn strain(space: &HalfSpace) -> TensorField {
    let (grid, layers) = (space.grid(), space.layers());
    let mut field = TensorField::deviators(layers.len(), grid.n_cells());
    for layer in 0..layers.len() {
        let depth = layers.middle(layer);
        let part = |x: f64, y: f64| [0.5, 0.5, x * y, x * depth, y * depth];
        for k in 0..5 {
            let inside = |x: f64, y: f64| f64::from(x * x + y * y + depth * depth < 1.0);
            let values = grid.sample(|x, y| 1e-3 * part(x, y)[k] * inside(x, y));
            field.component_mut(layer, k).copy_from_slice(&values);
        }
    }
    field
}

fn evaluation(criterion: &mut Criterion) {
    for n in [32, 64] {
        let mut group = criterion.benchmark_group(format!("{n}"));
        group.sample_size(20);
        let mut layers = 0;
        for (name, is_symmetric) in [("evaluation", false), ("symmetric", true)] {
            let space = space(n, is_symmetric);
            layers = space.layers().len();
            let strain = strain(&space);
            let pressure = space.grid().sample(|x, y| (1.0 - x * x - y * y).max(0.0).sqrt());
            let mut stress = TensorField::deviators(layers, pressure.len());
            let (mut work, mut opening) = (space.work(), vec![0.0; pressure.len()]);
            group.bench_function(name, |bencher| {
                bencher.iter(|| {
                    space.opening(&strain, &mut work, &mut opening, &mut || false).unwrap();
                    space.stress(&pressure, &mut work, &mut stress, &mut || false).unwrap();
                });
            });
        }
        // Five components of each layer: the sixth follows from them.
        let mut transforms = Transforms::new(n, 5 * layers);
        let (mut real, mut complex) = (RealFftPlanner::new(), FftPlanner::new());
        group.bench_function("transforms", |bencher| {
            bencher.iter(|| transforms.run(&mut real, &mut complex));
        });
        group.bench_function("build", |bencher| bencher.iter(|| space(n, false).layers().len()));
        group.finish();
    }
}

fn elastic(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("elastic");
    group.sample_size(10);
    for n in [32, 128, 256] {
        let hertz = EllipticContact::new(10.0, 10.0, 2e5, 100.0);
        let side = 2.6 * hertz.semi_axis_x / n as f64;
        let grid = SurfaceGrid::new(n, n, side, side).unwrap();
        let gap = grid.sample(|x, y| (x * x + y * y) / 20.0);
        let closing = vec![1.0; gap.len()];
        let surface = SurfaceFlexibility::new(grid, 2e5);
        let problem = ContactProblem {
            flexibility: &surface,
            initial_gap: &gap,
            closing: &closing,
            load: ContactLoad::Force(100.0),
        };
        let solver = ConjugateGradientSolver::new(1e-8);
        group.bench_function(format!("{n}"), |bencher| {
            bencher.iter(|| {
                let solution = solver.solve(&problem, None, &mut never).unwrap();
                solution.approach
            });
        });
    }
    group.finish();
}

criterion_group!(benches, elastic, evaluation);
criterion_main!(benches);
