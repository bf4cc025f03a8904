//! Fatigue of contacts through both engines, beside closed forms.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

use std::f64::consts::PI;
use std::sync::Arc;

use brinell_contact::ContactLoad;
use brinell_halfspace::engine::half_spaces::{self, Conformity, HalfSpaceProblem, HalfSpaceStep};
use brinell_halfspace::engine::rolling::{
    self, Footprint, HardeningRules, RollingLoad, RollingProblem, TrackField, TrackStep,
};
use brinell_halfspace::{Fatigue, Passing, Utilization};
use brinell_material::analytical::ElasticConstants;
use brinell_material::fatigue::{Criterion, Cycle, FatigueStrength, Limits, Stress};
use brinell_material::hardening::StraightLine;
use brinell_material::{InitialStressProfile, Solid};
use brinell_method::observer::{SolveStatus, Unobserved};
use brinell_method::settings::Settings;
use brinell_method::sought::Loads;

const PEAK: f64 = 1000.0;
const ELASTIC: ElasticConstants =
    ElasticConstants { young_modulus: 210_000.0, poisson_ratio: 0.3 };
const NEVER: f64 = 1e5;

/// Limits by which Dang Van's weight is `weight`; in torsion 1 MPa, so that utilizations are
/// stresses.
fn limits(weight: f64) -> Limits {
    Limits { torsion: 1.0, bending: 3.0 / (1.5 + weight) }
}

/// Limits by which Crossland's weight is 0: its stress is √J2a.
fn of_von_mises() -> Limits {
    Limits { torsion: 1.0, bending: 3f64.sqrt() }
}

fn body(yield_stress: f64, limits: Limits) -> Solid {
    let law = StraightLine { yield_stress, plastic_modulus: 20_000.0 };
    Solid::new(ELASTIC).with_hardening(Arc::new(law)).with_fatigue(FatigueStrength::new(limits))
}

fn load(force: f64, friction: f64) -> RollingLoad {
    RollingLoad {
        force,
        passes: 1,
        ends_at_verdict: false,
        friction,
        alternating: false,
        track: None,
        hardening: HardeningRules::Isotropic,
    }
}

fn modulus() -> f64 {
    ELASTIC.young_modulus / (1.0 - ELASTIC.poisson_ratio.powi(2))
}

/// A rigid roller on a body; the half-width is 1 mm under [`PEAK`].
fn line(lower: Solid, friction: f64, columns: usize) -> RollingProblem {
    let curvature = 2.0 * PEAK / modulus();
    let load = load(0.5 * PI * PEAK, friction);
    let asked = (columns, Settings::default());
    RollingProblem::of_lines([None, Some(lower)], Some(curvature), load, asked).unwrap()
}

/// A rigid ball on a body; the radius of the contact is 1 mm under [`PEAK`].
fn ball(lower: Solid, columns: usize) -> RollingProblem {
    let curvature = 0.5 * PI * PEAK / modulus();
    RollingProblem {
        materials: [None, Some(lower)],
        footprint: Footprint::Ellipse { curvatures: [curvature; 2], rollers: Vec::new() },
        load: load(2.0 / 3.0 * PI * PEAK, 0.0),
        columns,
        solver: Settings::default(),
    }
}

fn rolled(problem: &RollingProblem) -> TrackField {
    let mut steps: Vec<TrackStep> = Vec::new();
    rolling::run(problem, &mut Unobserved, &mut steps).unwrap();
    let step = steps.remove(0);
    assert_eq!(step.status, SolveStatus::Converged);
    step.field
}

/// The fatigue of the lower body.
fn of(problem: &RollingProblem) -> Fatigue {
    let [_, lower] = rolled(problem).fatigue;
    lower.unwrap()
}

fn by(fatigue: &Fatigue, criterion: Criterion) -> &Utilization {
    fatigue.criteria[criterion as usize].as_ref().unwrap()
}

#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance, "{found} for {expected}");
}

/// Stress below Hertz's line of peak pressure and half-width 1 with a traction μ p. K. L. Johnson,
/// *Contact Mechanics* (1985), equations 4.49 and 7.8.
fn below_line(x: f64, z: f64, friction: f64) -> Stress {
    let (root, sum) = ((1.0 - x * x + z * z).hypot(2.0 * x * z), 1.0 - x * x + z * z);
    let (m2, n2) = (0.5 * (root + sum), (0.5 * (root - sum)).max(0.0));
    let (m, n, part) = (m2.sqrt(), n2.sqrt().copysign(x), m2 + n2);
    let xx = 2.0 * z - m * (1.0 + (z * z + n2) / part);
    let zz = -m * (1.0 - (z * z + n2) / part);
    let xz = -n * (m2 - z * z) / part;
    let xx_of_traction = n * (2.0 - (z * z - m2) / part) - 2.0 * x;
    let (xx, zz, xz) = (xx + friction * xx_of_traction, zz + friction * xz, xz + friction * xx);
    [xx, 0.3 * (xx + zz), zz, 0.0, xz, 0.0]
}

fn closed_form(z: f64, friction: f64, weight: f64) -> f64 {
    let far = [14.0, 8.0, 5.0, 3.5, 2.6].into_iter().flat_map(|x| [-x, x]);
    let places = far.chain((-500..=500).map(|k| 0.005 * f64::from(k)));
    let path: Vec<Stress> = places.map(|x| below_line(x, z, friction)).collect();
    Cycle::of(&path).shear(Criterion::DangVan, weight)
}

/// Figures of a program of its own, to ±0.0003 of the peak pressure.
#[test]
fn a_line_that_rolls_has_the_stresses_of_hertz() {
    let fatigue = of(&line(body(NEVER, of_von_mises()), 0.0, 40));
    near(by(&fatigue, Criterion::Crossland).largest.value / PEAK, 0.25, 4e-4);
    let orthogonal = by(&fatigue, Criterion::OrthogonalShear);
    near(orthogonal.largest.value / PEAK, 0.25, 4e-4);
    near(orthogonal.largest.depth, 0.5, 0.03);
    for (weight, expected) in [(0.15, 0.2066), (0.25, 0.1818), (0.33, 0.1641), (0.40, 0.1507)] {
        let fatigue = of(&line(body(NEVER, limits(weight)), 0.0, 40));
        let found = by(&fatigue, Criterion::DangVan);
        near(found.largest.value / PEAK, expected, 4e-4);
        assert!(found.largest.depth > 0.5 && found.largest.depth < 0.75, "{:?}", found.largest);
        near(found.of_rest(), 0.0, 1e-12);
        let [short, long] = found.relative_life(0.0).unwrap();
        near(short, 1.0, 0.05);
        near(long, 1.0, 0.05);
        let error = found.error.unwrap();
        assert!(error > 0.0 && error < 0.05 * found.largest.value, "{found:?}");
    }
}

#[test]
fn a_stress_along_the_surface_shifts_dang_van_through_the_engine() {
    let with = |stress: f64| {
        let initial = InitialStressProfile::new([[0.0, stress, stress]]);
        let lower = body(NEVER, limits(0.25)).with_initial_stress(initial);
        of(&line(lower, 0.0, 20))
    };
    let (none, pressed) = (with(0.0), with(-0.1 * PEAK));
    let [before, after] = [&none, &pressed].map(|fatigue| by(fatigue, Criterion::DangVan));
    let shift = -0.25 * 2.0 / 3.0 * 0.1 * PEAK;
    near(after.largest.value - before.largest.value, shift, 1e-8);
    near(after.of_rest(), shift, 1e-8);
    near(after.without_rest, before.largest.value, 1e-8);
    let [before, after] = [&none, &pressed].map(|fatigue| by(fatigue, Criterion::OrthogonalShear));
    near(after.largest.value, before.largest.value, 1e-8);
    assert!(after.relative_life(0.0) == before.relative_life(0.0));
}

/// The surface decides from a friction below 0.2 on: there a place sees ±2 μ p0 along the travel.
#[test]
fn friction_moves_the_place_to_the_surface() {
    for (friction, at_a_depth) in [(0.1, 0.1854), (0.2, 0.1906), (0.3, 0.2524)] {
        let from_there = (4..130).map(|k| closed_form(0.01 * f64::from(k), friction, 0.25));
        near(from_there.fold(0.0, f64::max), at_a_depth, 4e-4);
        let fatigue = of(&line(body(NEVER, limits(0.25)), friction, 40));
        let found = by(&fatigue, Criterion::DangVan);
        let curve = fatigue.depths.iter().zip(&found.over_depth).skip(1);
        for (depth, value) in curve.filter(|(depth, _)| **depth < 1.5) {
            // The columns round off the ends of the contact.
            let tolerance = if *depth < 0.1 { 0.03 } else { 1.5e-3 };
            near(value / PEAK, closed_form(*depth, friction, 0.25), tolerance);
        }
        let is_at_surface = found.largest.depth < 0.05;
        assert_eq!(is_at_surface, friction > 0.15, "{friction}: {:?}", found.largest);
    }
}

/// Cells round the stress off by their width squared, and the first row lies half a cell beside y = 0.
#[test]
fn a_ball_that_rolls_has_the_stresses_of_hertz() {
    assert_ball(&of(&ball(body(NEVER, limits(0.25)), 12)), 2e-3);
}

#[test]
#[ignore = "full"]
fn a_ball_that_rolls_on_fine_cells_has_the_stresses_of_hertz() {
    assert_ball(&of(&ball(body(NEVER, limits(0.25)), 24)), 6e-4);
}

#[track_caller]
fn assert_ball(found: &Fatigue, tolerance: f64) {
    near(by(found, Criterion::DangVan).largest.value / PEAK, 0.1660, tolerance);
    near(by(found, Criterion::OrthogonalShear).largest.value / PEAK, 0.2139, tolerance);
}

#[test]
fn a_ball_that_is_pressed_has_the_stresses_of_hertz() {
    let pressed = pressed(body(NEVER, of_von_mises()));
    near(by(&pressed, Criterion::Crossland).largest.value / PEAK, 0.2139, 1e-3);
    near(by(&pressed, Criterion::OrthogonalShear).largest.value / PEAK, 0.2139, 1e-3);
    assert!(by(&pressed, Criterion::OrthogonalShear).largest.across.abs() < 0.1);
}

/// The fatigue under a ball that is pressed.
fn pressed(lower: Solid) -> Fatigue {
    let curvature = 0.5 * PI * PEAK / modulus();
    let problem = HalfSpaceProblem {
        materials: [None, Some(lower)],
        curvature: [curvature, curvature, 0.0],
        conformity: Conformity::default(),
        rollers: Vec::new(),
        heights: None,
        loads: Loads::Each(vec![ContactLoad::Force(2.0 / 3.0 * PI * PEAK)]),
        cells_per_semi_axis: 16,
        cells_of_slopes: None,
        onset: None,
        solver: Settings::default(),
    };
    let mut steps: Vec<HalfSpaceStep> = Vec::new();
    half_spaces::run_each(&problem, &mut Unobserved, &mut steps).unwrap();
    steps.remove(0).field.fatigue(&problem, 1, &mut || false).unwrap().unwrap()
}

/// The largest utilization is that of its place without residual stress, and a times the hydrostatic
/// part of it.
#[test]
fn residual_stress_of_a_pass_has_its_part() {
    let mut problem = line(body(450.0, limits(0.25)), 0.0, 16);
    (problem.load.passes, problem.load.ends_at_verdict) = (20, true);
    let field = rolled(&problem);
    let fatigue = field.fatigue[1].as_ref().unwrap();
    let outlet = &field.passes.last().unwrap().bodies[1].as_ref().unwrap().outlet;
    assert_eq!(2 * outlet.accumulated.len() + 1, fatigue.depths.len());
    assert!(outlet.residual.iter().any(|[xx, yy, ..]| *xx < -10.0 && *yy < 0.0));
    let found = by(fatigue, Criterion::DangVan);
    assert!(found.of_rest() < 0.0, "{found:?}");
    let layer = outlet.faces.partition_point(|face| *face <= found.largest.depth) - 1;
    let [xx, yy, zz, ..] = outlet.residual[layer];
    let without = found.largest.value - 0.25 * (xx + yy + zz) / 3.0;
    assert!(without <= found.without_rest + 1e-9, "{without} {found:?}");
    assert!(found.relative_life(0.0).unwrap()[0] > 1.0, "{found:?}");
}

/// A body that flows in each pass has no high-cycle fatigue, nor has one that is not known to.
#[test]
fn bodies_that_flow_have_none() {
    let flat = Arc::new(StraightLine { yield_stress: 400.0, plastic_modulus: 0.0 });
    let lower = body(NEVER, limits(0.25)).with_hardening(Arc::clone(&flat) as _);
    let mut problem = line(lower, 0.0, 10);
    problem.load.passes = 2;
    let field = rolled(&problem);
    assert!(field.verdicts[1].is_some() && field.fatigue == [None, None]);
    let without = line(Solid::new(ELASTIC).with_hardening(flat), 0.0, 10);
    assert!(rolled(&without).fatigue == [None, None]);
}

/// Lundberg and Palmgren's life `L ~ (z^h / (τ^c V))^(1/e)` with c = 31/3, h = 7/3, and V the depth
/// times the width of the contact: Q^-3 of balls with e = 10/9, Q^-4 of lines with 9/8.
#[test]
fn lives_fall_with_the_force_as_lundberg_and_palmgren_have_it() {
    let life = |mut problem: RollingProblem, times: f64, e: f64| {
        problem.load.force *= times;
        let field = rolled(&problem);
        let fatigue = field.fatigue[1].as_ref().unwrap();
        let largest = by(fatigue, Criterion::OrthogonalShear).largest;
        let width = field.last.half_width_across.unwrap_or(1.0);
        let power = largest.value.powf(-31.0 / 3.0) * largest.depth.powf(7.0 / 3.0 - 1.0) / width;
        power.powf(1.0 / e)
    };
    let lower = || body(NEVER, limits(0.25));
    let of_line = |times: f64| life(line(lower(), 0.0, 16), times, 9.0 / 8.0);
    near(of_line(2.0) / of_line(1.0) * 2f64.powi(4), 1.0, 0.01);
    let of_ball = |times: f64| life(ball(lower(), 8), times, 10.0 / 9.0);
    near(of_ball(2.0) / of_ball(1.0) * 2f64.powi(3), 1.0, 0.01);
}

/// The error of a path over cells, beside one over many.
#[test]
fn the_error_of_cells_is_bounded() {
    let strength = FatigueStrength::new(limits(0.25));
    let of = |passing: Passing, depth: f64| {
        let depths = (1..30).map(|k| depth * f64::from(k)).collect();
        Fatigue::of(&passing, 0.0, &strength, depths, |_, _| 0.0, &mut || false).unwrap()
    };
    let line = |n: usize| of(Passing::hertz_line(1.0, n, 0.3).unwrap(), 0.04);
    let circle = |n: usize| of(Passing::hertz_ellipse([1.0; 2], [n; 2], 0.3).unwrap(), 0.04);
    let (of_line, of_circle) = (line(320), circle(40));
    for n in [6, 8, 12, 16, 20] {
        for (found, exact) in [(line(n), &of_line), (circle(n), &of_circle)] {
            for criterion in Criterion::ALL {
                let [found, exact] = [&found, exact].map(|of| by(of, criterion).largest.value);
                let error = n as f64 * (found / exact - 1.0);
                assert!(error.abs() < Fatigue::OF_CELLS, "{n} {criterion:?}: {error}");
            }
        }
    }
}

/// Both bodies have their own limits; a job the other way up has the same answer.
#[test]
fn bodies_may_be_swapped() {
    let [weak, strong] = [0.7, 1.3].map(|torsion| {
        let limits =
            Limits { torsion, bending: torsion / limits(0.25).torsion * limits(0.25).bending };
        body(NEVER, limits)
    });
    let of = |upper: &Solid, lower: &Solid, friction: f64| {
        let mut problem = line(lower.clone(), friction, 10);
        problem.materials[0] = Some(upper.clone());
        rolled(&problem).fatigue
    };
    for friction in [0.0, 0.2] {
        let [upper, lower] = of(&weak, &strong, friction);
        let [down, up] = of(&strong, &weak, -friction);
        assert_eq!((&upper, &lower), (&up, &down));
        let [weak, strong] = [upper.unwrap(), lower.unwrap()];
        let [weak, strong] = [&weak, &strong].map(|of| by(of, Criterion::DangVan).largest.value);
        near(weak / strong, 1.3 / 0.7, 1e-9);
    }
}

/// A generator of random numbers between two.
struct Dice(u64);

impl Dice {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }
}

/// A line between two bodies or a ball on one, elastic or running in.
fn random_track(dice: &mut Dice, columns: usize) -> RollingProblem {
    let peak_over_yield = dice.between(0.8, 3.2);
    let limits = limits(dice.between(0.25, 0.4));
    let lower = body(PEAK / peak_over_yield, limits);
    let initial = dice.between(-0.3, 0.1) * PEAK / peak_over_yield;
    let lower = lower.with_initial_stress(InitialStressProfile::new([[0.0, initial, initial]]));
    let mut problem = if dice.between(0.0, 1.0) < 0.7 {
        let friction = if dice.between(0.0, 1.0) < 0.5 { 0.0 } else { dice.between(0.0, 0.25) };
        line(lower, friction, columns)
    } else {
        ball(lower, columns / 2)
    };
    problem.load.passes = 10;
    problem.load.ends_at_verdict = true;
    problem
}

/// The fatigue of a body, where its passes tell it.
fn fatigue_of(problem: &RollingProblem, side: usize) -> Option<Fatigue> {
    let mut steps: Vec<TrackStep> = Vec::new();
    rolling::run(problem, &mut Unobserved, &mut steps).ok()?;
    steps.remove(0).field.fatigue[side].take()
}

/// More force is no less utilization, but for the error; a job the other way up has the same one;
/// the bars hold on twice the columns.
#[test]
#[ignore = "full"]
fn random_tracks_are_monotonic_and_within_their_bars() {
    let (mut counted, mut held) = (0, 0);
    for seed in 0..80 {
        let mut problem = random_track(&mut Dice(1 + 977 * seed), 12);
        let Some(here) = fatigue_of(&problem, 1) else { continue };
        let force = problem.load.force;
        problem.load.force = 1.3 * force;
        let more = fatigue_of(&problem, 1);
        problem.load.force = force;
        problem.materials.swap(0, 1);
        problem.load.friction *= -1.0;
        let swapped = fatigue_of(&problem, 0).unwrap();
        problem.columns *= 2;
        let fine = fatigue_of(&problem, 0);
        for criterion in Criterion::ALL {
            let found = by(&here, criterion);
            let other = by(&swapped, criterion).largest.value;
            near(other / found.largest.value, 1.0, 1e-9);
            let Some(error) = found.error else { continue };
            if let Some(more) = &more {
                let more = by(more, criterion).largest.value;
                assert!(
                    more > found.largest.value - error,
                    "{seed} {criterion:?}: {found:?} {more}"
                );
            }
            if let Some(fine) = &fine {
                counted += 1;
                let difference = (by(fine, criterion).largest.value - found.largest.value).abs();
                held += usize::from(difference <= error);
                if difference > error {
                    println!("{seed} {criterion:?}: {difference} beyond {error}");
                }
            }
        }
    }
    println!("{held} of {counted}");
    assert!(counted > 120 && 20 * held >= 19 * counted);
}
