//! Contacts in three dimensions: Hertz, and bodies that yield against figures of axisymmetric finite elements and of
//! finer grids. An executable of its own, because nothing of it is shared with plane problems.
#![expect(clippy::unwrap_used, reason = "a test ends where it fails")]

use brinell_solver::job::{
    Bilinear, Coupling, Deformable, Elastic, Hardening, History, HistoryLoad, Load, NonNegativeF64,
    PoissonRatio, PositiveF64, SolverSettings, Theory,
};
use brinell_solver::solver::half_spaces::{HalfSpaceProblem, HalfSpaceStep, run_each};
use brinell_solver::solver::{SolveStatus, Unobserved};

const YIELD_STRESS: f64 = 500.0;
const RADIUS: f64 = 10.0;

fn positive(value: f64) -> PositiveF64 {
    PositiveF64::new(value).unwrap()
}

/// Steel with a tangent modulus of this part of Young's modulus beyond yield, or without yield.
fn steel(tangent: Option<f64>) -> Deformable {
    let elastic =
        Elastic { young_modulus: positive(210_000.0), poisson_ratio: PoissonRatio::new(0.3).unwrap() };
    let hardening = tangent.map(|tangent| {
        Hardening::Bilinear(Bilinear {
            yield_stress: positive(YIELD_STRESS),
            tangent_modulus: NonNegativeF64::new(tangent * 210_000.0).unwrap(),
        })
    });
    Deformable::new(elastic, hardening).unwrap()
}

/// A rigid ellipsoid of radii 10 mm and `radius_y` on a body, elastic at first.
fn on_flat(radius_y: f64, material: Deformable, cells: u32) -> HalfSpaceProblem {
    HalfSpaceProblem {
        materials: [None, Some(material)],
        curvature: [RADIUS.recip(), radius_y.recip(), 0.0],
        load: Load::Onset,
        cells_per_semi_axis: cells,
        solver: SolverSettings::default(),
    }
}

/// The force under which the largest elastic pressure is this many yield stresses.
fn force_of(problem: &HalfSpaceProblem, ratio: f64) -> f64 {
    (ratio * YIELD_STRESS / problem.hertz(1.0).peak_pressure).powi(3)
}

fn solved(problem: &HalfSpaceProblem) -> Vec<HalfSpaceStep> {
    let mut steps: Vec<HalfSpaceStep> = Vec::new();
    run_each(problem, &mut Unobserved, &mut steps).unwrap();
    for step in &steps {
        assert_eq!(step.status, SolveStatus::Converged);
        let figures = step.figures;
        println!(
            "{figures:?}\n  errors {:?}\n  {} iterations, {} enlargements, kkt {:e}, plastic {:e}, grid {}×{} ",
            step.errors,
            step.history.len(),
            step.enlargements,
            step.contact_check.worst(),
            step.plastic_residual,
            step.surface.grid.nx(),
            step.surface.grid.ny(),
        );
    }
    steps
}

fn under(mut problem: HalfSpaceProblem, ratio: f64) -> HalfSpaceStep {
    problem.load = Load::Forces(positive(force_of(&problem, ratio)).into());
    solved(&problem).remove(0)
}

/// Loaded and unloaded by flow theory.
fn loaded_and_unloaded(mut problem: HalfSpaceProblem, ratio: f64) -> [HalfSpaceStep; 2] {
    let force = force_of(&problem, ratio);
    problem.solver.theory = Theory::Flow;
    let loads = [force, 0.0].map(|force| HistoryLoad::Force(NonNegativeF64::new(force).unwrap()));
    problem.load = Load::History(History::new(loads.to_vec()).unwrap());
    solved(&problem).try_into().unwrap()
}

fn near(found: f64, expected: f64, tolerance: f64, name: &str) {
    let error = found / expected - 1.0;
    println!("{name}: {found:.6e} for {expected:.6e}, {error:.2e}");
    assert!(error.abs() < tolerance, "{name}: {found} for {expected}");
}

fn agrees_with_hertz(radius_ratio: f64, cells: u32, [pressure, approach, axes]: [f64; 3]) {
    let step = under(on_flat(radius_ratio * RADIUS, steel(None), cells), 3.0);
    let hertz = step.hertz.unwrap();
    near(step.figures.peak_pressure, hertz.peak_pressure, pressure, "peak");
    near(step.figures.approach, hertz.approach, approach, "approach");
    near(step.figures.semi_axes[0], hertz.semi_axis_x, axes, "a");
    near(step.figures.semi_axes[1], hertz.semi_axis_y, axes, "b");
    let errors = step.errors.unwrap();
    assert!((step.figures.approach - hertz.approach).abs() <= errors.approach);
    assert!((step.figures.peak_pressure - hertz.peak_pressure).abs() <= errors.peak_pressure);
}

#[test]
fn elastic_ellipses_agree_with_hertz() {
    for ratio in [1.0, 5.0, 50.0] {
        agrees_with_hertz(ratio, 6, [1e-2, 2e-3, 2e-2]);
    }
}

#[test]
#[ignore = "full"]
fn elastic_ellipses_agree_with_hertz_on_finer_grids() {
    for ratio in [1.0, 2.0, 5.0, 10.0, 20.0, 50.0] {
        agrees_with_hertz(ratio, 15, [1.5e-3, 3e-4, 1.5e-2]);
    }
}

#[test]
fn force_and_approach_are_one_contact() {
    let mut problem = on_flat(30.0, steel(None), 6);
    let step = under(problem.clone(), 3.0);
    problem.load = Load::Approaches(positive(step.figures.approach).into());
    let other = solved(&problem).remove(0);
    near(other.figures.force, step.figures.force, 1e-4, "force");
}

#[test]
fn the_axes_turn_with_the_bodies() {
    let along = under(on_flat(30.0, steel(None), 6), 3.0);
    let mut problem = on_flat(30.0, steel(None), 6);
    let [xx, yy, _] = problem.curvature;
    let (sin, cos) = 0.7_f64.sin_cos();
    problem.curvature =
        [cos * cos * xx + sin * sin * yy, sin * sin * xx + cos * cos * yy, sin * cos * (xx - yy)];
    assert!((problem.orientation() - 0.7).abs() < 1e-12);
    let turned = under(problem, 3.0);
    near(turned.figures.approach, along.figures.approach, 1e-12, "approach");
    near(turned.figures.semi_axes[1], along.figures.semi_axes[1], 1e-9, "b");
}

#[test]
fn a_ball_under_deformation_theory() {
    let step = under(on_flat(RADIUS, steel(Some(0.05)), 6), 4.0);
    near(step.figures.peak_pressure, 1259.5, 1e-2, "peak");
    near(step.figures.approach, 2.0555e-3, 1e-2, "approach");
    near(step.figures.max_plastic_strain[1], 5.12e-3, 6e-2, "plastic strain");
    assert!((15..=26).contains(&step.history.len()), "{}", step.history.len());
}

#[test]
#[ignore = "full"]
fn a_ball_under_deformation_theory_on_a_finer_grid() {
    let step = under(on_flat(RADIUS, steel(Some(0.05)), 12), 4.0);
    near(step.figures.peak_pressure, 1259.5, 3e-3, "peak");
    near(step.figures.approach, 2.0555e-3, 2e-3, "approach");
    near(step.figures.max_plastic_strain[1], 5.12e-3, 2e-2, "plastic strain");
    let by = |coupling| {
        let mut problem = on_flat(RADIUS, steel(Some(0.05)), 12);
        problem.solver.coupling = coupling;
        under(problem, 4.0)
    };
    for coupling in [Coupling::Strong, Coupling::Weak] {
        let other = by(coupling);
        near(other.figures.approach, step.figures.approach, 1e-6, "approach");
        near(other.figures.max_plastic_strain[1], step.figures.max_plastic_strain[1], 1e-4, "strain");
    }
}

#[test]
#[ignore = "full"]
fn a_ball_under_flow_theory_and_unloaded() {
    let [loaded, unloaded] = loaded_and_unloaded(on_flat(RADIUS, steel(Some(0.05)), 15), 4.0);
    near(loaded.figures.peak_pressure, 1140.5, 5e-3, "peak");
    near(loaded.figures.approach, 2.0355e-3, 2e-3, "approach");
    near(loaded.figures.max_plastic_strain[1], 4.79e-3, 1e-2, "plastic strain");
    near(unloaded.figures.dent[1], 5.92e-4, 1.5e-2, "dent");
    near(unloaded.figures.pile_up[1], 3.37e-5, 3e-2, "pile-up");
    // Below the ring of the largest pressure.
    let column = unloaded.bodies[1].as_ref().unwrap().column([0.0755, 0.0]);
    let least = column.iter().min_by(|a, b| a.stress[0].total_cmp(&b.stress[0])).unwrap();
    near(least.stress[0], -215.0, 3e-2, "residual stress");
    near(least.depth, 0.097, 0.1, "its depth");
    assert!((1..=2).contains(&unloaded.history.len()));
}
