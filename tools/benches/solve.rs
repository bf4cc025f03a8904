//! Whole jobs, by criterion: `cargo bench -p brinell-tools --bench solve`. How near they come to the floor under
//! them is measured by `cargo bench --bench performance`.
#![expect(clippy::unwrap_used, reason = "a benchmark that cannot go on says where")]

use std::hint::black_box;
use std::time::Duration;

use brinell_solver::inputs;
use brinell_solver::job::{Job, Load, MeshSettings, PositiveF64};
use brinell_solver::solver::{SolveStatus, Unobserved};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// The default job: accelerated, active set, 1e-6.
const JOB: &str = include_str!("../../api/examples/two_cylinders.json");
/// Elastic peak pressure over yield stress, and the force per length that gives it \[N/mm\].
const LOADS: [(u32, f64); 2] = [(3, 612.6106), (4, 1089.0855)];
/// Elements over the half-width.
const ELEMENTS: [u32; 6] = [10, 20, 40, 80, 160, 320];

criterion_group!(benches, whole_jobs);
criterion_main!(benches);

fn job(elements: u32, force: f64) -> Job {
    let mut job = Job::from_json(JOB.as_bytes()).unwrap();
    job.mesh = MeshSettings::default().with_elements(elements);
    job.load = Load::Forces(PositiveF64::new(force).unwrap().into());
    job
}

fn whole_jobs(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("solve");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(5))
        .warm_up_time(Duration::from_millis(500));
    for elements in ELEMENTS {
        for (yields, force) in LOADS {
            let job = job(elements, force);
            let name =
                BenchmarkId::new(format!("{elements} elements"), format!("p0 = {yields} σ_y"));
            group.bench_with_input(name, &job, |b, job| {
                b.iter(|| {
                    let solution = inputs::run(black_box(job), &mut Unobserved).unwrap();
                    assert_eq!(solution.steps[0].status, SolveStatus::Converged);
                    solution
                });
            });
        }
    }
    group.finish();
}
