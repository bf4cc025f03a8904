//! The elastic contact of a self-affine surface beside the Fourier transforms that it takes:
//! `cargo bench -p brinell-halfspace --bench rough -- 1024`.
//!
//! For two loads, some 6 and 20 % of the area in contact: applications of the flexibility and of
//! the preconditioner to 1e-8, seconds, and seconds of as many transforms, rows of padding left
//! out. Ratios within one run are what counts.
#![expect(clippy::unwrap_used, reason = "a benchmark that cannot go on says where")]

use std::cell::Cell;
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolver, ContactStatus,
    Flexibility, never,
};
use brinell_halfspace::{SurfaceFlexibility, SurfaceGrid};
use realfft::RealFftPlanner;
use rustfft::FftPlanner;
use rustfft::num_complex::Complex64;

/// Counts what is asked of a surface.
struct Counted {
    surface: SurfaceFlexibility,
    applications: Cell<usize>,
    preconditionings: Cell<usize>,
}

impl Flexibility for Counted {
    fn len(&self) -> usize {
        self.surface.len()
    }

    fn apply(&self, force: &[f64], displacement: &mut [f64]) {
        self.applications.set(self.applications.get() + 1);
        self.surface.apply(force, displacement);
    }

    fn precondition(&self, displacement: &[f64], force: &mut [f64]) {
        self.preconditionings.set(self.preconditionings.get() + 1);
        self.surface.precondition(displacement, force);
    }
}

/// Heights of a side of 1 with a root mean square slope of 0.1, a Hurst exponent of 0.8 and waves
/// between an eighth of the side and 8 cells.
fn self_affine(n: usize) -> Vec<f64> {
    let mut state = 1_u64;
    let mut noise = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
    };
    let mut field: Vec<Complex64> = (0..n * n).map(|_| Complex64::new(noise(), 0.0)).collect();
    let mut planner = FftPlanner::new();
    transform(n, &mut field, &*planner.plan_fft_forward(n));
    let number = |k: usize| (if 2 * k > n { k as f64 - n as f64 } else { k as f64 }).abs();
    let mut slope = 0.0;
    for (k, value) in field.iter_mut().enumerate() {
        let size = number(k / n).hypot(number(k % n));
        let is_kept = (8.0..=n as f64 / 8.0).contains(&size);
        *value *= if is_kept { size.powf(-1.8) } else { 0.0 };
        slope += (TAU * size).powi(2) * value.norm_sqr();
    }
    transform(n, &mut field, &*planner.plan_fft_inverse(n));
    field.iter().map(|height| 0.1 * height.re / slope.sqrt()).collect()
}

/// Along both directions; the order of rows and columns is exchanged twice.
fn transform(n: usize, field: &mut [Complex64], plan: &dyn rustfft::Fft<f64>) {
    for _ in 0..2 {
        plan.process(field);
        for i in 0..n {
            for j in 0..i {
                field.swap(i * n + j, j * n + i);
            }
        }
    }
}

/// Seconds of `count` transforms of `n × n` reals there and back in a box of `m × m`.
fn transforms(n: usize, m: usize, count: usize) -> f64 {
    let (mut real, mut complex) = (RealFftPlanner::<f64>::new(), FftPlanner::<f64>::new());
    let (there, back) = (real.plan_fft_forward(m), real.plan_fft_inverse(m));
    let (down, up) = (complex.plan_fft_forward(m), complex.plan_fft_inverse(m));
    let (mut row, mut half) = (vec![1.0; m], vec![Complex64::ZERO; m / 2 + 1]);
    let mut columns = vec![Complex64::ZERO; m * (m / 2 + 1)];
    let mut scratch = vec![Complex64::ZERO; 4 * m];
    let start = Instant::now();
    for _ in 0..count {
        for _ in 0..n {
            there.process_with_scratch(&mut row, &mut half, &mut scratch).unwrap();
        }
        down.process_with_scratch(&mut columns, &mut scratch);
        up.process_with_scratch(&mut columns, &mut scratch);
        for _ in 0..n {
            half[0].im = 0.0;
            half[m / 2].im = 0.0;
            back.process_with_scratch(&mut half, &mut row, &mut scratch).unwrap();
        }
        black_box(&row);
    }
    start.elapsed().as_secs_f64()
}

fn main() {
    let n: usize = std::env::args().skip(1).find_map(|word| word.parse().ok()).unwrap_or(256);
    let heights = self_affine(n);
    let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let gap: Vec<f64> = heights.iter().map(|height| highest - height).collect();
    let grid = SurfaceGrid::new(n, n, 1.0 / n as f64, 1.0 / n as f64).unwrap();
    let surface = SurfaceFlexibility::new(grid, 1.0);
    let counted = Counted { surface, applications: Cell::new(0), preconditionings: Cell::new(0) };
    for force in [0.0025, 0.01] {
        let problem = ContactProblem {
            flexibility: &counted,
            initial_gap: &gap,
            closing: &vec![1.0; gap.len()],
            load: ContactLoad::Force(force),
        };
        counted.applications.set(0);
        counted.preconditionings.set(0);
        let start = Instant::now();
        let solution =
            ConjugateGradientSolver::new(1e-8).solve(&problem, None, &mut never).unwrap();
        let seconds = start.elapsed().as_secs_f64();
        assert_eq!(solution.status, ContactStatus::Converged);
        let [applications, preconditionings] =
            [&counted.applications, &counted.preconditionings].map(Cell::get);
        let of_transforms =
            transforms(n, 2 * n, applications) + transforms(n, n, preconditionings);
        println!(
            "{n} × {n}, area {:.4}: {applications} applications, {preconditionings} \
             preconditionings, {} sets, {seconds:.3} s, transforms {of_transforms:.3} s, ratio \
             {:.2}",
            solution.active_set.len() as f64 / gap.len() as f64,
            solution.pivots,
            seconds / of_transforms,
        );
    }
}
