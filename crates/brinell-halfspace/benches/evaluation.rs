//! An evaluation beside the Fourier transforms it consists of, an elastic contact, and a whole load.
//!
//! `cargo bench -p brinell-halfspace`. The ratio of `evaluation` to `transforms` within one run is what counts.
#![expect(clippy::unwrap_used, reason = "a benchmark that cannot go on says where")]

#[path = "../tests/common/mod.rs"]
mod common;

use std::hint::black_box;

use brinell_contact::{ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolver, never};
use brinell_halfspace::{EllipticContact, HalfSpaceSystem, LinearHardening, SurfaceFlexibility, SurfaceGrid};
use common::{Built, Case, force_of, solve};
use criterion::{Criterion, criterion_group, criterion_main};
use realfft::RealFftPlanner;
use rustfft::FftPlanner;
use rustfft::num_complex::Complex64;

/// Transforms of `count` fields there and back, rows that are padding left out: plans and nothing else.
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
                there.process_with_scratch(&mut self.rows, &mut self.half, &mut self.scratch).unwrap();
            }
            down.process_with_scratch(&mut self.columns, &mut self.scratch);
            up.process_with_scratch(&mut self.columns, &mut self.scratch);
            for _ in 0..self.n {
                self.half[0].im = 0.0;
                self.half[self.n].im = 0.0;
                back.process_with_scratch(&mut self.half, &mut self.rows, &mut self.scratch).unwrap();
            }
            black_box(&self.rows);
        }
    }
}

/// A loaded ball with its converged increment.
fn loaded(
    n: usize,
) -> (HalfSpaceSystem<LinearHardening>, Vec<brinell_halfspace::TensorField>, ContactLoad, usize) {
    let Built { mut system, force, .. } = Case::ball(n, 4.0, 0.05, 1.17).build();
    let load = ContactLoad::Force(force);
    let (increment, _, _) = solve(&mut system, load, 1e-4);
    let layers = increment[0].n_layers();
    (system, increment, load, layers)
}

fn evaluation(criterion: &mut Criterion) {
    for n in [32, 64] {
        let mut group = criterion.benchmark_group(format!("{n}"));
        group.sample_size(20);
        let (mut system, increment, load, layers) = loaded(n);
        let mut next = system.zeros();
        group.bench_function("evaluation", |bencher| {
            bencher.iter(|| {
                system.equilibrium(&increment, load, &mut never).unwrap();
                system.initial_stress(&increment, &mut next)
            });
        });
        // Five components of each layer: the sixth follows from them.
        let mut transforms = Transforms::new(n, 5 * layers);
        let (mut real, mut complex) = (RealFftPlanner::new(), FftPlanner::new());
        group
            .bench_function("transforms", |bencher| bencher.iter(|| transforms.run(&mut real, &mut complex)));
        group.bench_function("build", |bencher| {
            bencher.iter(|| Case::ball(n, 4.0, 0.05, 1.17).build().force);
        });
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

fn loads(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("ball");
    group.sample_size(10);
    let case = Case::ball(32, 4.0, 0.05, 1.17);
    group.bench_function("deformation", |bencher| {
        bencher.iter(|| {
            let mut built = case.build();
            let load = ContactLoad::Force(built.force);
            solve(&mut built.system, load, 1e-6).1
        });
    });
    group.bench_function("flow and unloading", |bencher| {
        bencher.iter(|| {
            let mut built = case.build();
            for k in 1..=10 {
                let load = ContactLoad::Force(force_of(&case, &built, k, 10));
                let tolerance = if k < 10 { 1e-4 } else { 1e-5 };
                let (increment, _, _) = solve(&mut built.system, load, tolerance);
                built.system.commit(&increment);
            }
            solve(&mut built.system, ContactLoad::Force(0.0), 1e-5).1
        });
    });
    group.finish();
}

criterion_group!(benches, elastic, evaluation, loads);
criterion_main!(benches);
