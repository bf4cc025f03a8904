//! Time of a job against the floor under it: one sparse factorization of each body (`cargo bench --bench solve`).
//!
//! Criterion measures whole jobs. Then, pair by pair in the same run, a job and the factorization of its two
//! final meshes (ordering, symbolic and numeric, nothing shared between the bodies) are timed side by side, and
//! the medians of their ratios are printed.
#![expect(clippy::unwrap_used, reason = "a benchmark that cannot go on says where")]

use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use brinell::assembly::{Equations, Restraint, StiffnessAssembler};
use brinell::element::{Kinematics, QUADRATURE_POINTS, element_stiffness};
use brinell::linalg::{Cholesky, EliminationOrder, Graph, SymbolicCholesky};
use brinell::mesh::Mesh;
use brinell::model::{Job, Load, Material, MeshSettings, PositiveF64};
use brinell::solve::{self, Solution, SolveStatus, Unobserved};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// The default job: accelerated, active set, 1e-6.
const JOB: &str = include_str!("../api/examples/two_cylinders.json");
/// Elastic peak pressure over yield stress, and the force per length that gives it \[N/mm\].
const LOADS: [(u32, f64); 2] = [(3, 612.6106), (4, 1089.0855)];
/// Elements over the half-width, and pairs of job and factorization timed.
const MESHES: [(u32, usize); 3] = [(20, 31), (40, 15), (80, 7)];
/// The default job may take this many two-body factorizations.
const TARGET: f64 = 10.0;

criterion_group!(benches, whole_jobs, against_the_floor);
criterion_main!(benches);

fn job(elements: u32, force: f64) -> Job {
    let mut job = Job::from_json(JOB.as_bytes()).unwrap();
    job.mesh = MeshSettings { elements_per_half_width: elements };
    job.load = Load::Forces(PositiveF64::new(force).unwrap().into());
    job
}

fn run(job: &Job) -> Solution {
    let solution = solve::run(job, &mut Unobserved).unwrap();
    assert_eq!(solution.steps[0].status, SolveStatus::Converged);
    solution
}

fn whole_jobs(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("solve");
    group.sample_size(20).measurement_time(Duration::from_secs(5));
    for (yields, force) in LOADS {
        let job = job(20, force);
        group.bench_with_input(
            BenchmarkId::new("20 elements", format!("p0 = {yields} σ_y")),
            &job,
            |b, job| {
                b.iter(|| run(black_box(job)));
            },
        );
    }
    group.finish();
}

fn against_the_floor(_: &mut Criterion) {
    println!("job against the factorization of both its bodies; medians of pairs timed back to back");
    for (elements, pairs) in MESHES {
        for (yields, force) in LOADS {
            let row = compare(&job(elements, force), pairs);
            let verdict = match elements {
                20 if row.to_two_bodies < TARGET => format!("  below {TARGET}, as it must be"),
                20 => format!("  NOT below {TARGET}"),
                _ => String::new(),
            };
            println!(
                "{elements:3} elements, p0 = {yields} σ_y: {:6} equations a body, job {:7.1} ms, factorization {:6.2} ms, \
                 ratio {:4.1} (to one body's {:4.1}){verdict}",
                row.equations,
                row.job,
                row.two_bodies,
                row.to_two_bodies,
                2.0 * row.to_two_bodies,
            );
        }
    }
}

struct Comparison {
    equations: usize,
    job: f64,
    two_bodies: f64,
    to_two_bodies: f64,
}

fn compare(job: &Job, pairs: usize) -> Comparison {
    let solution = run(job);
    let floor = Floor::of(job, &solution);
    floor.factorize();
    let timed: Vec<(f64, f64)> = (0..pairs).map(|_| (milliseconds(|| run(job)), floor.factorize())).collect();
    let median = |of: fn(&(f64, f64)) -> f64| {
        let mut values: Vec<f64> = timed.iter().map(of).collect();
        values.sort_by(f64::total_cmp);
        values[pairs / 2]
    };
    Comparison {
        equations: floor.bodies[0].equations,
        job: median(|pair| pair.0),
        two_bodies: median(|pair| pair.1),
        to_two_bodies: median(|pair| pair.0 / pair.1),
    }
}

fn milliseconds<T>(work: impl FnOnce() -> T) -> f64 {
    let clock = Instant::now();
    black_box(work());
    1e3 * clock.elapsed().as_secs_f64()
}

/// The final meshes of a job, ready to be factorized.
struct Floor {
    bodies: [FloorBody; 2],
}

struct FloorBody {
    mesh: Arc<Mesh>,
    graph: Graph,
    restraint: Restraint,
    bulk: f64,
    shear: f64,
    equations: usize,
}

impl Floor {
    fn of(job: &Job, solution: &Solution) -> Self {
        let step = &solution.steps[0];
        let sides = [(&job.upper, &step.bodies[0]), (&job.lower, &step.bodies[1])];
        Self {
            bodies: sides.map(|(body, solved)| {
                let Material::Deformable(material) = &body.material else { unreachable!("both deform") };
                let solved = solved.as_ref().unwrap();
                let mesh = Arc::clone(&solved.mesh);
                FloorBody {
                    graph: Graph::from_cells(mesh.nodes.len(), &mesh.elements),
                    restraint: Restraint::new(&mesh, body.support),
                    bulk: material.elastic().bulk_modulus(),
                    shear: material.elastic().shear_modulus(),
                    equations: solved.equations,
                    mesh,
                }
            }),
        }
    }

    /// Orders and factorizes both bodies, each for itself; the time that took \[ms\].
    fn factorize(&self) -> f64 {
        self.bodies.iter().map(FloorBody::factorize).sum()
    }
}

impl FloorBody {
    /// Ordering, symbolic and numeric factorization by nested dissection of the whole body. Graph, pattern and
    /// assembly are not counted: they are the matrix.
    fn factorize(&self) -> f64 {
        let Self { mesh, graph, restraint, .. } = self;
        let nowhere = vec![false; mesh.nodes.len()];
        let clock = Instant::now();
        let order = EliminationOrder::new(graph, &mesh.lattice, &nowhere, &[]);
        let ordering = clock.elapsed();

        let equations = Equations::new(&order, restraint, 0);
        let pattern = equations.pattern(graph);
        let clock = Instant::now();
        let symbolic = SymbolicCholesky::new(pattern).unwrap();
        let analysis = clock.elapsed();

        let kinematics = Kinematics::PlaneStrain;
        let pattern = symbolic.pattern();
        let assembler = StiffnessAssembler { mesh, kinematics, equations: &equations, pattern };
        let values = assembler
            .assemble(|_, quad| element_stiffness(quad, self.bulk, &[self.shear; QUADRATURE_POINTS]));
        let clock = Instant::now();
        black_box(Cholesky::factor(&symbolic, &values).unwrap());
        1e3 * (ordering + analysis + clock.elapsed()).as_secs_f64()
    }
}
