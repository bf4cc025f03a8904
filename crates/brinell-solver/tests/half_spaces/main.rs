//! Contacts in three dimensions: Hertz, and bodies that yield against figures of axisymmetric
//! finite elements and of finer grids. An executable of its own, because nothing of it is shared
//! with plane problems.
#![expect(clippy::unwrap_used, reason = "a test ends where it fails")]

mod beside_finite_elements;
mod conforming;
mod fits;
mod limits;

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use brinell_method::Error;
use brinell_method::couplings::{Coupling, Strong, Weak};
use brinell_method::settings::{Settings, Theory};
use brinell_method::sought::{Loads, Sought, Target, TargetFigure};
use brinell_solver::contact::ContactLoad;
use brinell_solver::job::{
    Bilinear, Deformable, Elastic, Hardening, NonNegativeF64, PoissonRatio, PositiveF64,
};
use brinell_solver::material::Solid;
use brinell_solver::solver::half_spaces::{
    Conformity, HalfSpaceError, HalfSpaceProblem, HalfSpaceStep, errors, estimate, run_each,
};
use brinell_solver::solver::{
    Figure, Held, Increments, Interrupt, IterationRecord, Observer, SolveStatus, Unobserved,
};

const YIELD_STRESS: f64 = 500.0;
const RADIUS: f64 = 10.0;

fn positive(value: f64) -> PositiveF64 {
    PositiveF64::new(value).unwrap()
}

/// Steel with a tangent modulus of this part of Young's modulus beyond yield, or without yield.
fn steel(tangent: Option<f64>) -> Solid {
    let elastic = Elastic {
        young_modulus: positive(210_000.0),
        poisson_ratio: PoissonRatio::new(0.3).unwrap(),
    };
    let hardening = tangent.map(|tangent| {
        Hardening::Bilinear(Bilinear {
            yield_stress: positive(YIELD_STRESS),
            tangent_modulus: NonNegativeF64::new(tangent * 210_000.0).unwrap(),
        })
    });
    Solid::from(&Deformable::new(elastic, hardening))
}

/// Forces in their order \[N\].
fn forces(forces: impl IntoIterator<Item = f64>) -> Loads {
    Loads::History(forces.into_iter().map(ContactLoad::Force).collect())
}

/// A rigid ellipsoid of radii 10 mm and `radius_y` on a body, elastic at first.
fn on_flat(radius_y: f64, material: Solid, cells: u32) -> HalfSpaceProblem {
    HalfSpaceProblem {
        cells_of_slopes: None,
        onset: None,
        materials: [None, Some(material)],
        curvature: [RADIUS.recip(), radius_y.recip(), 0.0],
        conformity: Conformity::default(),
        rollers: Vec::new(),
        heights: None,
        loads: Loads::Sought(Sought::Onset),
        cells_per_semi_axis: cells,
        solver: Settings { theory: Theory::Deformation, ..Settings::default() },
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
            "{figures:?}\n  errors {:?}\n  {} iterations, {} enlargements, kkt {:e}, plastic \
             {:e}, grid {}×{} ",
            errors(step, None),
            step.history.len(),
            step.enlargements,
            step.checks.contact.worst(),
            step.checks.residual,
            step.field.surface.grid.nx(),
            step.field.surface.grid.ny(),
        );
    }
    steps
}

fn under(mut problem: HalfSpaceProblem, ratio: f64) -> HalfSpaceStep {
    problem.loads = forces([force_of(&problem, ratio)]);
    solved(&problem).remove(0)
}

/// Counts what it is asked, keeps the largest memory it is told of, and stops a solve after so
/// many questions.
#[derive(Default)]
struct Watch {
    asked: usize,
    held: usize,
    iterations: usize,
    stop_after: Option<usize>,
    last: Option<Instant>,
    /// Longest time between two questions.
    longest: Duration,
}

impl Observer for Watch {
    fn on_iteration(&mut self, _: &IterationRecord) -> ControlFlow<Interrupt> {
        self.iterations += 1;
        self.on_checkpoint()
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.asked += 1;
        let now = Instant::now();
        let since = self.last.replace(now).map_or(Duration::ZERO, |last| now - last);
        self.longest = self.longest.max(since);
        let is_over = self.stop_after.is_some_and(|most| self.asked > most);
        if is_over { ControlFlow::Break(Interrupt::Cancelled) } else { ControlFlow::Continue(()) }
    }

    fn on_held(&mut self, part: Held, bytes: usize) -> ControlFlow<Interrupt> {
        if part == Held::Bodies {
            self.held = self.held.max(bytes);
        }
        ControlFlow::Continue(())
    }
}

/// Grids of soft bodies are as large as `estimate` says before anything is solved, however far
/// plastic strain reaches.
#[test]
fn soft_bodies_keep_to_the_estimate() {
    for (radius_y, tangent, ratio) in
        [(10.0, 0.0, 6.0), (10.0, 0.0, 14.0), (10.0, 0.05, 10.0), (100.0, 0.0, 6.0)]
    {
        let mut problem = on_flat(radius_y, steel(Some(tangent)), 4);
        problem.loads = forces([force_of(&problem, ratio)]);
        let expected = estimate(&problem).unwrap();
        let (mut watch, mut steps): (_, Vec<HalfSpaceStep>) = (Watch::default(), Vec::new());
        run_each(&problem, &mut watch, &mut steps).unwrap();
        let step = &steps[0];
        let grid = &step.field.surface.grid;
        let axis = step.figures.semi_axes()[0];
        println!(
            "{radius_y} {ratio}: {} enlargements, {:.1} cells",
            step.enlargements,
            axis / grid.hx()
        );
        assert_eq!(step.status, SolveStatus::Converged);
        assert!(grid.nx() <= expected.cells[0] && grid.ny() <= expected.cells[1]);
        assert!(step.field.bodies[1].as_ref().unwrap().layers.len() <= expected.layers);
        assert!(watch.held as u64 <= expected.bytes && watch.held > 0);
        assert!(axis > 2.9 * grid.hx(), "the grid is coarser than asked for");
    }
}

/// 128 × 128 cells of more layers than 48.
#[test]
fn a_large_grid_keeps_within_4_gb() {
    let mut problem = on_flat(10.0, steel(Some(0.05)), 40);
    problem.loads = forces([force_of(&problem, 4.0)]);
    let expected = estimate(&problem).unwrap();
    println!("{expected:?}");
    assert!(expected.cells[0] >= 128 && expected.cells[1] >= 128 && expected.layers >= 48);
    assert!(expected.bytes < 4 << 30, "{expected:?}");
}

#[test]
fn loads_that_no_small_strain_bears_are_refused() {
    let mut problem = on_flat(10.0, steel(Some(0.0)), 10);
    problem.loads = forces([force_of(&problem, 41.0)]);
    let refused = |error| matches!(error, HalfSpaceError::Overloaded { most, .. } if most < 41.0);
    assert!(refused(estimate(&problem).unwrap_err()));
    let mut steps: Vec<HalfSpaceStep> = Vec::new();
    assert!(refused(run_each(&problem, &mut Unobserved, &mut steps).unwrap_err()));
}

/// A stop waits for a part of an evaluation, wherever it comes.
#[test]
fn a_solve_stops_within_an_evaluation() {
    let mut problem = on_flat(10.0, steel(Some(0.0)), 6);
    problem.loads = forces([force_of(&problem, 4.0)]);
    let (mut watch, mut steps): (_, Vec<HalfSpaceStep>) = (Watch::default(), Vec::new());
    run_each(&problem, &mut watch, &mut steps).unwrap();
    // A question for each layer and each wave number, there and back.
    assert!(watch.asked > 40 * watch.iterations, "{} in {}", watch.asked, watch.iterations);
    for part in 1..8 {
        let most = part * watch.asked / 8;
        let mut stopped = Watch { stop_after: Some(most), ..Watch::default() };
        steps.clear();
        let ended = run_each(&problem, &mut stopped, &mut steps);
        assert!(
            ended == Err(HalfSpaceError::Method(Error::Interrupted(Interrupt::Cancelled)))
                || steps[0].status == SolveStatus::Cancelled
        );
        assert!(stopped.asked <= most + 3, "{} after {most}", stopped.asked);
    }
}

/// How long a cancelled solve may go on: a bearing ball by default, and a large ball by flow
/// theory.
#[test]
#[ignore = "full"]
fn a_solve_asks_twice_a_second_at_least() {
    for (cells, theory) in
        [(10, Theory::Deformation), (10, Theory::Flow), (30, Theory::Deformation)]
    {
        let mut problem = on_flat(RADIUS, steel(Some(0.05)), cells);
        problem.solver.theory = theory;
        let force = force_of(&problem, 4.0);
        problem.loads = match theory {
            Theory::Flow => forces([force, 0.0]),
            Theory::Deformation => forces([force]),
        };
        let (mut watch, mut steps): (_, Vec<HalfSpaceStep>) = (Watch::default(), Vec::new());
        let begin = Instant::now();
        run_each(&problem, &mut watch, &mut steps).unwrap();
        let end = watch.last.unwrap().elapsed();
        println!(
            "{cells} cells, {theory:?}: {:?}, {} questions, {:?} at most, {end:?} at the end",
            begin.elapsed(),
            watch.asked,
            watch.longest
        );
        assert!(watch.longest.max(end) < Duration::from_millis(500));
    }
}

/// Loaded and unloaded by flow theory.
fn loaded_and_unloaded(mut problem: HalfSpaceProblem, ratio: f64) -> [HalfSpaceStep; 2] {
    let force = force_of(&problem, ratio);
    problem.solver.theory = Theory::Flow;
    problem.loads = forces([force, 0.0]);
    solved(&problem).try_into().unwrap()
}

/// Mean pressure of the cells around the middle \[MPa\].
fn pressure_in_the_middle(step: &HalfSpaceStep) -> f64 {
    let map = &step.field.surface;
    let (nx, ny) = (map.grid.nx(), map.grid.ny());
    let around = |n: usize| [(n - 1) / 2, n / 2];
    around(nx).iter().flat_map(|i| around(ny).map(|j| map.pressure[i * ny + j])).sum::<f64>() / 4.0
}

fn near(found: f64, expected: f64, tolerance: f64, name: &str) {
    let error = found / expected - 1.0;
    println!("{name}: {found:.6e} for {expected:.6e}, {error:.2e}");
    assert!(error.abs() < tolerance, "{name}: {found} for {expected}");
}

fn agrees_with_hertz(radius_ratio: f64, cells: u32, [pressure, approach, axes]: [f64; 3]) {
    let step = under(on_flat(radius_ratio * RADIUS, steel(None), cells), 3.0);
    let hertz = step.field.hertz.unwrap();
    near(step.figures.peak_pressure, hertz.peak_pressure, pressure, "peak");
    near(step.figures.approach, hertz.approach, approach, "approach");
    near(step.figures.semi_axes()[0], hertz.semi_axis_x, axes, "a");
    near(step.figures.semi_axes()[1], hertz.semi_axis_y, axes, "b");
    let error = |figure| errors(&step, None).unwrap().get(figure, 0).unwrap();
    let [peak, approach] = [Figure::PeakPressure, Figure::Approach].map(error);
    assert!((step.figures.approach - hertz.approach).abs() <= approach);
    assert!((step.figures.peak_pressure - hertz.peak_pressure).abs() <= peak);
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
    problem.loads = Loads::Each(vec![ContactLoad::Approach(step.figures.approach)]);
    let other = solved(&problem).remove(0);
    near(other.figures.force, step.figures.force, 1e-4, "force");
}

/// A dent that is deeper than the approach: the bodies are apart, at the approach that was given.
/// Without force, the approach is where they touch first.
#[test]
fn bodies_apart_are_at_the_approach_that_was_given() {
    let mut problem = on_flat(10.0, steel(Some(0.05)), 6);
    problem.solver.theory = Theory::Flow;
    let last = |end: ContactLoad| {
        let mut problem = problem.clone();
        problem.loads = Loads::History(vec![ContactLoad::Approach(0.01), end]);
        solved(&problem).pop().expect("two loads")
    };
    let touching = last(ContactLoad::Force(0.0)).figures.approach;
    let given = 0.2 * touching;
    let apart = last(ContactLoad::Approach(given));
    assert!(apart.figures.force <= 0.0 && touching > 0.0);
    near(apart.figures.approach, given, 1e-12, "approach");
    near(apart.history.last().unwrap().approach, given, 1e-12, "approach of the iteration");
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
    near(turned.figures.semi_axes()[1], along.figures.semi_axes()[1], 1e-9, "b");
}

#[test]
fn a_ball_under_deformation_theory() {
    let step = under(on_flat(RADIUS, steel(Some(0.05)), 6), 4.0);
    near(step.figures.peak_pressure, 1259.5, 1e-2, "peak");
    near(step.figures.approach, 2.0555e-3, 1e-2, "approach");
    near(step.figures.bodies[1].unwrap().max_plastic_strain, 5.12e-3, 6e-2, "plastic strain");
    assert!((15..=26).contains(&step.history.len()), "{}", step.history.len());
}

#[test]
#[ignore = "full"]
fn a_ball_under_deformation_theory_on_a_finer_grid() {
    let step = under(on_flat(RADIUS, steel(Some(0.05)), 12), 4.0);
    near(step.figures.peak_pressure, 1259.5, 3e-3, "peak");
    near(step.figures.approach, 2.0555e-3, 2e-3, "approach");
    near(step.figures.bodies[1].unwrap().max_plastic_strain, 5.12e-3, 2e-2, "plastic strain");
    let by = |coupling: &'static (dyn Coupling + Sync)| {
        let mut problem = on_flat(RADIUS, steel(Some(0.05)), 12);
        problem.solver.coupling = coupling;
        under(problem, 4.0)
    };
    for other in [by(&Strong), by(&Weak)] {
        near(other.figures.approach, step.figures.approach, 1e-6, "approach");
        near(
            other.figures.bodies[1].unwrap().max_plastic_strain,
            step.figures.bodies[1].unwrap().max_plastic_strain,
            1e-4,
            "strain",
        );
    }
}

#[test]
#[ignore = "full"]
fn a_ball_under_flow_theory_and_unloaded() {
    let [loaded, unloaded] = loaded_and_unloaded(on_flat(RADIUS, steel(Some(0.05)), 15), 4.0);
    near(loaded.figures.peak_pressure, 1140.5, 5e-3, "peak");
    near(loaded.figures.approach, 2.0355e-3, 2e-3, "approach");
    near(loaded.figures.bodies[1].unwrap().max_plastic_strain, 4.79e-3, 1e-2, "plastic strain");
    near(unloaded.figures.bodies[1].unwrap().dent, 5.92e-4, 1.5e-2, "dent");
    near(unloaded.figures.bodies[1].unwrap().pile_up, 3.37e-5, 3e-2, "pile-up");
    // Below the ring of the largest pressure.
    let column = unloaded.field.bodies[1].as_ref().unwrap().column([0.0755, 0.0]);
    let least = column.iter().min_by(|a, b| a.stress[0].total_cmp(&b.stress[0])).unwrap();
    near(least.stress[0], -215.0, 2e-2, "residual stress");
    near(least.depth, 0.097, 0.1, "its depth");
    near(pressure_in_the_middle(&loaded), 1117.0, 1e-2, "pressure in the middle");
    assert!((1..=2).contains(&unloaded.history.len()));
}

#[test]
#[ignore = "full"]
fn perfectly_plastic_balls() {
    let [loaded, unloaded] = loaded_and_unloaded(on_flat(RADIUS, steel(Some(0.0)), 15), 4.0);
    near(loaded.figures.peak_pressure, 1089.5, 5e-3, "peak");
    near(loaded.figures.approach, 2.0549e-3, 2e-3, "approach");
    near(loaded.figures.bodies[1].unwrap().max_plastic_strain, 5.18e-3, 1e-2, "plastic strain");
    near(unloaded.figures.bodies[1].unwrap().dent, 6.47e-4, 1.5e-2, "dent");
    let [loaded, unloaded] = loaded_and_unloaded(on_flat(RADIUS, steel(Some(0.0)), 15), 6.0);
    near(loaded.figures.peak_pressure, 1212.0, 5e-2, "peak");
    near(pressure_in_the_middle(&loaded), 1082.0, 1e-2, "pressure in the middle");
    near(loaded.figures.approach, 5.191e-3, 3e-3, "approach");
    near(loaded.figures.bodies[1].unwrap().max_plastic_strain, 1.014e-2, 3e-2, "plastic strain");
    near(unloaded.figures.bodies[1].unwrap().dent, 2.522e-3, 1.5e-2, "dent");
}

#[test]
#[ignore = "full"]
fn a_ball_far_beyond_first_yield() {
    let [loaded, unloaded] = loaded_and_unloaded(on_flat(RADIUS, steel(Some(0.05)), 15), 6.0);
    near(loaded.figures.peak_pressure, 1318.0, 3e-2, "peak");
    near(loaded.figures.approach, 5.055e-3, 3e-3, "approach");
    near(unloaded.figures.bodies[1].unwrap().dent, 2.266e-3, 1.5e-2, "dent");
}

#[test]
#[ignore = "full"]
fn ellipses_that_yield() {
    let step = under(on_flat(50.0, steel(Some(0.05)), 12), 4.0);
    near(step.figures.peak_pressure, 1279.5, 3e-3, "peak");
    near(step.figures.approach, 3.8355e-3, 1e-3, "approach");
    near(step.figures.bodies[1].unwrap().max_plastic_strain, 5.05e-3, 1e-2, "plastic strain");
    near(step.figures.semi_axes()[0], 0.200, 2e-2, "a");
    near(step.figures.semi_axes()[1], 0.515, 2e-2, "b");

    let [loaded, unloaded] = loaded_and_unloaded(on_flat(50.0, steel(Some(0.05)), 15), 4.0);
    near(loaded.figures.peak_pressure, 1174.5, 5e-3, "peak");
    near(loaded.figures.approach, 3.805e-3, 2e-3, "approach");
    near(loaded.figures.bodies[1].unwrap().max_plastic_strain, 4.80e-3, 1.5e-2, "plastic strain");
    near(unloaded.figures.bodies[1].unwrap().dent, 1.008e-3, 1.5e-2, "dent");
    near(unloaded.figures.bodies[1].unwrap().pile_up, 7.44e-5, 3e-2, "pile-up");
    near(loaded.figures.semi_axes()[0], 0.200, 2e-2, "a");
    near(loaded.figures.semi_axes()[1], 0.508, 2e-2, "b");
    let column = unloaded.field.bodies[1].as_ref().unwrap().column([0.0; 2]);
    let least = column.iter().min_by(|a, b| a.stress[0].total_cmp(&b.stress[0])).unwrap();
    near(least.stress[0], -230.5, 3e-2, "residual stress");
    near(least.depth, 0.172, 0.1, "its depth");
    let five = loaded.figures.peak_pressure;

    let mut longer = on_flat(200.0, steel(Some(0.05)), 15);
    longer.solver.increments = Increments::Given(8);
    let [loaded, unloaded] = loaded_and_unloaded(longer, 4.0);
    near(loaded.figures.peak_pressure, 1218.4, 1e-2, "peak");
    near(loaded.figures.approach, 5.264e-3, 1e-2, "approach");
    // The reference has 8 increments.
    near(loaded.figures.bodies[1].unwrap().max_plastic_strain, 5.02e-3, 1.5e-2, "plastic strain");
    near(unloaded.figures.bodies[1].unwrap().dent, 1.177e-3, 1e-2, "dent");
    // Towards plane strain.
    assert!(
        1141.0 < five
            && five < loaded.figures.peak_pressure
            && loaded.figures.peak_pressure < 1256.9
    );
}

/// The force is found under which elastic bodies come up to the yield stress: `p0 = 1.613 σ_y` for
/// ν = 0.3.
#[test]
fn the_onset_of_yield_is_that_of_johnson() {
    let mut problem = on_flat(RADIUS, steel(Some(0.05)), 10);
    let mut steps: Vec<HalfSpaceStep> = Vec::new();
    run_each(&problem, &mut Unobserved, &mut steps).unwrap();
    near(steps[0].figures.force, force_of(&problem, 1.613), 1.5e-2, "force");
    let highest = problem.highest_utilization(&steps[0]).unwrap();
    near(highest.ratio, 1.0, 2e-4, "utilization");
    // To half a layer.
    near(highest.position[2], 0.481 * steps[0].figures.semi_axes()[0], 0.12, "depth");
    problem.materials[1] = Some(steel(None));
    let refused = run_each(&problem, &mut Unobserved, &mut steps).unwrap_err();
    assert_eq!(refused, HalfSpaceError::NoYieldPoint);
}

#[test]
#[ignore = "full"]
fn a_force_is_found_by_the_dent_that_it_leaves() {
    let mut problem = on_flat(RADIUS, steel(Some(0.05)), 10);
    problem.solver.theory = Theory::Flow;
    let target = Target { figure: TargetFigure::DentDepth, value: 5.92e-4 };
    problem.loads = Loads::Sought(Sought::Target(target));
    let steps = solved(&problem);
    near(steps[0].figures.force, force_of(&problem, 4.0), 2e-2, "force");
    near(steps[1].figures.bodies[1].unwrap().dent, 5.92e-4, 1e-3, "dent");
}

#[test]
#[ignore = "full"]
fn two_equal_bodies_are_one_that_counts_twice() {
    let mut both = on_flat(RADIUS, steel(Some(0.05)), 6);
    both.materials = [Some(steel(Some(0.05))), Some(steel(Some(0.05)))];
    let two = under(both.clone(), 3.0);
    let one = under(on_flat(RADIUS, steel(Some(0.05)), 6), 3.0);
    // Beside a rigid ball all lengths are half as large, at the same pressures.
    near(two.figures.peak_pressure, one.figures.peak_pressure, 1e-6, "peak");
    near(two.figures.semi_axes()[0], 2.0 * one.figures.semi_axes()[0], 1e-6, "a");
    near(
        two.figures.bodies[0].unwrap().dent,
        two.figures.bodies[1].unwrap().dent,
        f64::EPSILON,
        "dent",
    );

    // Bodies that differ by nothing that matters are solved one beside the other.
    let elastic = Elastic {
        young_modulus: positive(210_000.0),
        poisson_ratio: PoissonRatio::new(0.3).unwrap(),
    };
    let harder = Hardening::Bilinear(Bilinear {
        yield_stress: positive(YIELD_STRESS * (1.0 + 1e-12)),
        tangent_modulus: NonNegativeF64::new(0.05 * 210_000.0).unwrap(),
    });
    both.materials[0] = Some(Solid::from(&Deformable::new(elastic, Some(harder))));
    let apart = under(both, 3.0);
    near(apart.figures.approach, two.figures.approach, 1e-6, "approach");
    near(
        apart.figures.bodies[0].unwrap().dent,
        apart.figures.bodies[1].unwrap().dent,
        1e-6,
        "dent",
    );
    near(apart.figures.bodies[0].unwrap().dent, two.figures.bodies[0].unwrap().dent, 1e-5, "dent");
}
