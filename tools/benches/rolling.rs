//! A pass of a line contact, an evaluation of it beside the Fourier transforms it consists of, and
//! the same pass by marching.
//!
//! `cargo bench -p brinell-tools --bench rolling`. The ratio of `evaluation` to `transforms`
//! within one run is what counts. Counts of evaluations and the time of a map of frictions and
//! loads are printed first.
#![expect(clippy::unwrap_used, reason = "a benchmark that cannot go on says where")]

#[path = "../../crates/brinell-halfspace/tests/rolling/driver.rs"]
mod driver;
#[path = "../../crates/brinell-halfspace/tests/rolling/march.rs"]
mod march;

use std::hint::black_box;
use std::time::Instant;

use brinell_halfspace::track::{Operators as _, PassStrain, SteadyState};
use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use driver::{Material, Roller, Setup, YIELD, YOUNG};
use march::March;
use realfft::RealFftPlanner;

/// Mean evaluations of a pass of perfectly plastic tracks a little above their limits.
fn count_evaluations() {
    for resolution in [10, 20] {
        let (mut sum, mut most, mut n) = (0, 0, 0);
        for friction in [0.0, 0.1, 0.2, 0.3] {
            for factor in [1.01, 1.02, 1.05, 1.1] {
                let setup = Setup::of_discrete(resolution, friction, factor);
                let passes = Roller::new(&setup).passes(10);
                sum += passes.iter().map(|pass| pass.evaluations).sum::<usize>();
                most = passes.iter().map(|pass| pass.evaluations).max().unwrap_or(0).max(most);
                n += passes.len();
            }
        }
        println!(
            "{resolution} columns a half-width: {:.1} evaluations a pass, {most} at most",
            sum as f64 / f64::from(u32::try_from(n).unwrap())
        );
    }
}

/// Eight frictions, six loads, ten passes each: a map of shakedown.
fn map() {
    let start = Instant::now();
    let mut words = [0; 5];
    for friction in 0..8 {
        for load in 0..6 {
            let friction = 0.05 * f64::from(friction);
            let peak = (2.6 + 0.4 * f64::from(load)) * YIELD / 3f64.sqrt();
            let material = Material::perfect().with(&[[40_000.0, 200.0]]);
            let setup = Setup { peak, material, ..Setup::new(20, friction, 1.0) };
            let strains: Vec<PassStrain> =
                Roller::new(&setup).passes(10).iter().map(|pass| pass.strain).collect();
            words[match SteadyState::that_counts(&strains, YIELD / YOUNG) {
                SteadyState::Elastic => 0,
                SteadyState::ShakesDown { .. } => 1,
                SteadyState::ClosedCycle { .. } => 2,
                SteadyState::Ratchets { .. } => 3,
                SteadyState::Undecided { .. } => 4,
            }] += 1;
        }
    }
    println!(
        "a map of 8 frictions, 6 loads, 10 passes: {:?} on one core, {words:?}",
        start.elapsed()
    );
}

fn benchmarks(criterion: &mut Criterion) {
    count_evaluations();
    map();

    let setup = Setup::new(20, 0.0, 1.05);
    let mut roller = Roller::new(&setup);
    roller.passes(3);
    let (n, n_layers) = (roller.grid.n_columns(), roller.body.space().ground().layers.len());
    let strained = roller.n_strained();
    println!("{n} columns, {n_layers} layers, {strained} of them strained");
    let mut planner = RealFftPlanner::<f64>::new();
    let (there, back) = (planner.plan_fft_forward(n), planner.plan_fft_inverse(n));
    let (mut row, mut half) = (there.make_input_vec(), there.make_output_vec());
    let mut scratch = there.make_scratch_vec();
    scratch.resize(scratch.len().max(back.get_scratch_len()), half[0]);
    criterion.bench_function("rolling/transforms", |bencher| {
        bencher.iter(|| {
            for _ in 0..=3 * strained {
                row.fill(1.0);
                there.process_with_scratch(&mut row, &mut half, &mut scratch).unwrap();
            }
            for _ in 0..=3 * n_layers {
                half.fill(1.0.into());
                (half[0].im, half[n / 2].im) = (0.0, 0.0);
                back.process_with_scratch(&mut half, &mut row, &mut scratch).unwrap();
            }
            black_box(&row);
        });
    });
    let mut trial = vec![0.0; roller.body.n_numbers()];
    let mut into = trial.clone();
    criterion.bench_function("rolling/evaluation", |bencher| {
        bencher.iter(|| roller.evaluate_again(&mut trial, &mut into));
    });
    criterion.bench_function("rolling/first pass", |bencher| {
        bencher.iter_batched(
            || Roller::new(&setup),
            |mut roller| roller.pass(150).evaluations,
            BatchSize::LargeInput,
        );
    });
    let mut march = March::new(&setup);
    for part in 1..=5 {
        march.step(0.2 * f64::from(part));
    }
    // Over a half-width, of which the ring has 32.
    let before = march.evaluations;
    let start = Instant::now();
    for _ in 0..20 {
        march.shift();
        march.step(1.0);
    }
    println!(
        "marching: {} evaluations and {:?} for a half-width of travel",
        march.evaluations - before,
        start.elapsed()
    );
}

criterion_group! {
    name = rolling;
    config = Criterion::default().sample_size(20);
    targets = benchmarks
}
criterion_main!(rolling);
