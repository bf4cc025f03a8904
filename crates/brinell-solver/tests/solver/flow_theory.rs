//! Flow theory in contacts: increments, unloading, dents, energies.

use brinell_solver::analytical::ElasticConstants;
use brinell_solver::analytical::effective_modulus;
use brinell_solver::inputs::{run, run_with};
use brinell_solver::job::{Coupling, Job, JobError};
use brinell_solver::report::{self, Name, Report, Side, StepReport};
use serde_json::json;

use brinell_solver::solver::{Figure, Options, Solution, SolveStatus, Unobserved};

use crate::contacts::{ANALYSES, job, laws, surfaces};
use crate::problems::{assert_within, parse};

/// Force on two equal cylinders at which Hertz's peak pressure is so many times the yield stress
/// \[N/mm\].
fn force(peak_over_yield: f64) -> f64 {
    612.6106 * (peak_over_yield / 3.0).powi(2)
}

const BILINEAR: &str = r#"{"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10500}"#;

/// Two equal cylinders, with whatever else the solver is told.
fn cylinders(plasticity: &str, load: &str, solver: &str, elements: u32) -> Job {
    let body = format!(
        r#"{{"shape": {{"type": "cylinder", "radius": 20}}, "material": {{"young_modulus": 210000,
        "poisson_ratio": 0.3, "plasticity": {plasticity}}}}}"#
    );
    let job = format!(
        r#"{{"analysis": "plane_strain", "upper": {body}, "lower": {body}, "load": {load},
        "mesh": {{"elements_per_half_width": {elements}}}, "solver": {solver}}}"#
    );
    Job::from_json(job.as_bytes()).unwrap()
}

fn solve(job: &Job) -> Solution {
    let solution = run(job, &mut Unobserved).unwrap();
    for step in &solution.steps {
        assert_eq!(
            step.status,
            SolveStatus::Converged,
            "{:?}: {:?}",
            step.load,
            step.checks.contact
        );
    }
    solution
}

fn report(job: &Job) -> Report {
    report::run(job, &mut Unobserved).unwrap()
}

fn up_and_down(ratio: f64) -> String {
    format!(r#"{{"history": [{{"force": {}}}, {{"force": 0}}]}}"#, force(ratio))
}

const FLOW: &str = r#"{"theory": "flow"}"#;

/// The first increment from rest is deformation theory, for every law and analysis.
#[test]
fn one_increment_is_deformation_theory() {
    let [cylinder, ..] = surfaces();
    for analysis in ANALYSES {
        for (name, law) in &laws() {
            let mut asked = job(analysis, "accelerated", law, [&cylinder, &cylinder], 3.0);
            asked["mesh"] = json!({"elements_per_half_width": 6});
            asked["solver"] = json!({"tolerance": 1e-11});
            let deformation = solve(&parse(&asked));
            asked["solver"] = json!({"theory": "flow", "increments": 1, "tolerance": 1e-11});
            let flow = solve(&parse(&asked));
            let (expected, found) = (&deformation.steps[0], &flow.steps[0]);
            assert!(
                (expected.field.spacing - found.field.spacing).abs()
                    < 1e-12 * expected.field.spacing,
                "the same mesh"
            );
            let [peak, approach] = [
                found.figures.peak_pressure / expected.figures.peak_pressure - 1.0,
                found.figures.approach / expected.figures.approach - 1.0,
            ];
            assert!(
                peak.abs() < 1e-9 && approach.abs() < 1e-9,
                "{analysis} {name}: {peak:e} {approach:e}"
            );
        }
    }
}

/// The program's own increments against eight times as many: the peak of the first load and the
/// approaches of both.
#[track_caller]
fn assert_fine_enough(mut job: Job) {
    let chosen = report(&job);
    let increments = chosen.steps[0].increments.as_ref().unwrap();
    let count = increments.force.len();
    let iterations: usize = increments.iterations.iter().sum();
    assert!(iterations <= 12 * count, "{iterations} iterations");
    job.solver.increments = Some(8 * u32::try_from(count).unwrap());
    let exact = report(&job);
    for (found, exact) in chosen.steps.iter().zip(&exact.steps) {
        let [approach, exact_approach] = [found, exact].map(|step| step.approach().unwrap());
        let is_loaded = exact[Name::PeakPressure] > 0.0;
        // An approach that is prescribed has no bar, or 0.
        let within = |bar: Option<f64>, most: f64| bar.map_or(most, |bar| most.min(bar.max(1e-9)));
        if is_loaded {
            let bar = found.bar(Name::PeakPressure);
            let [peak, exact_peak] = [found, exact].map(|step| step[Name::PeakPressure]);
            assert_within(peak, exact_peak, within(bar, 3e-3));
        }
        let name = if is_loaded { Name::Approach } else { Name::PermanentApproach };
        let bar = found.bar(name);
        assert_within(approach, exact_approach, within(bar, 3e-3));
    }
}

/// The path of the coarse mesh, which the fine one follows under one load, against 64 increments
/// that are all solved.
#[test]
#[ignore = "full"]
fn a_path_that_is_followed_errs_within_the_bars() {
    let perfect = r#"{"law": "bilinear", "yield_stress": 500, "tangent_modulus": 0}"#;
    for (law, ratio) in [(BILINEAR, 3.0), (BILINEAR, 4.0), (perfect, 3.5), (perfect, 4.0)] {
        let load = format!(r#"{{"force": {}}}"#, force(ratio));
        let mut job = cylinders(law, &load, FLOW, 20);
        let followed = &report(&job).steps[0];
        let count = followed.increments.as_ref().unwrap().force.len();
        assert!(count <= 4, "half of eight increments, {count}");
        job.solver.increments = Some(64);
        let exact = &report(&job).steps[0];
        for name in [Name::PeakPressure, Name::HalfWidth, Name::Approach] {
            assert_within(followed[name], exact[name], followed.bar(name).unwrap());
        }
    }
}

#[test]
#[ignore = "full"]
fn the_chosen_increments_are_fine_enough() {
    for ratio in [3.0, 4.0] {
        assert_fine_enough(cylinders(BILINEAR, &up_and_down(ratio), FLOW, 10));
    }
    // A sphere at 20 critical interferences.
    let sphere = sphere_under_flat(20.0, BILINEAR_SPHERE, r#"[{"approach": W}, {"force": 0}]"#);
    assert_fine_enough(sphere);
}

/// The prototype behind the theory, with other elements and other increments, has about 1150 MPa
/// at three yield stresses and 6.7 % less than deformation theory at four.
#[test]
fn peak_pressures_are_below_those_of_deformation_theory() {
    let three = solve(&cylinders(BILINEAR, &up_and_down(3.0), FLOW, 20));
    assert_within(three.steps[0].figures.peak_pressure, 1149.0, 2e-3);
    let four = solve(&cylinders(BILINEAR, &up_and_down(4.0), FLOW, 20));
    let load = format!(r#"{{"force": {}}}"#, force(4.0));
    let deformation = solve(&cylinders(BILINEAR, &load, r#"{"theory": "deformation"}"#, 20));
    let ratio = four.steps[0].figures.peak_pressure / deformation.steps[0].figures.peak_pressure;
    assert!((ratio - 0.932).abs() < 3e-3, "{ratio}");
}

/// Without force there is no contact, the approach is finite, and nothing is divided by zero.
#[test]
fn a_force_taken_away_leaves_a_dent() {
    let report = report(&cylinders(BILINEAR, &up_and_down(3.0), FLOW, 12));
    let step = &report.steps[1];
    assert_eq!(
        (step.status, step[Name::Force], step[Name::PeakPressure]),
        (SolveStatus::Converged, 0.0, 0.0)
    );
    assert!(
        step.approach().unwrap() > 1.4e-3 && step.approach().unwrap() < 1.8e-3,
        "{}",
        step.approach().unwrap()
    );
    let dent = step.body(Name::DentDepth, Side::Lower).unwrap();
    // Both dents together are about the approach that is left; the bodies have given way beside
    // them too.
    assert!(
        2.0 * dent > 0.5 * step.approach().unwrap() && 2.0 * dent < 1.5 * step.approach().unwrap()
    );
    let pile_up = step.of_body(Name::PileUp, Side::Lower).unwrap();
    assert!(pile_up.value > Some(0.0) && pile_up.place.unwrap().x > 0.0, "{pile_up:?}");
    for name in [Name::ReversePlasticStrain, Name::UnloadingStiffness] {
        assert!(step.row(name).is_none(), "{name:?}");
    }
    let subsurface = step.subsurface.as_ref().unwrap().lower.as_ref().unwrap();
    assert!(subsurface.sigma_x.iter().any(|stress| *stress < -20.0), "residual compression");
    let way = report.load_approach.unwrap();
    assert!(way.force.first() == Some(&0.0) && way.force.last() == Some(&0.0));
}

/// Taking the force away changes neither the plastic strain nor where it is reported, and the
/// outline stays around what has yielded.
#[test]
fn what_has_yielded_is_still_there_without_force() {
    let load = r#"{"history": [{"force": 700}, {"force": 300}, {"force": 0}, {"force": 0}]}"#;
    let report = report(&cylinders(BILINEAR, load, FLOW, 12));
    let [loaded, .., unloaded] = report.steps.as_slice() else { panic!("steps are missing") };
    let profile = |step: &StepReport| step.subsurface.as_ref().unwrap().lower.clone().unwrap();
    let (before, after) = (profile(loaded), profile(unloaded));
    assert_eq!(loaded.peak_position().to_bits(), unloaded.peak_position().to_bits());
    let most = before.equivalent_plastic_strain.iter().copied().fold(0.0, f64::max);
    for (p, q) in before.equivalent_plastic_strain.iter().zip(&after.equivalent_plastic_strain) {
        assert!((p - q).abs() < 1e-3 * most, "{p} {q}");
    }
    assert!(most > 0.8 * unloaded.body(Name::MaxPlasticStrain, Side::Lower).unwrap());
    let [one, other] =
        [loaded, unloaded].map(|step| step.body(Name::PlasticArea, Side::Lower).unwrap());
    assert_eq!(one.to_bits(), other.to_bits());
    let zones = [loaded, unloaded].map(|step| &step.plasticity.lower.as_ref().unwrap().outline);
    // Beside the zone some elastic points bear more when the force is taken away.
    for (p, q) in zones[0][0].iter().zip(&zones[1][0]) {
        assert!((p[0] - q[0]).hypot(p[1] - q[1]) < 1e-2 * loaded[Name::HalfWidth], "{p:?} {q:?}");
    }
}

/// The work of the force, integrated along many increments, is the elastic energy and the plastic
/// work in the bodies.
#[test]
fn the_work_of_the_force_is_stored_or_lost() {
    let kinematic = r#"{"law": "bilinear", "yield_stress": 500, "tangent_modulus": 0,
        "backstress": [{"modulus": 11000, "rate": 0}]}"#;
    for (law, stores) in [(BILINEAR, false), (kinematic, true)] {
        let many = r#"{"theory": "flow", "increments": 60}"#;
        let solution = solve(&cylinders(law, &up_and_down(3.0), many, 8));
        let (mut last, mut work) = ([0.0; 2], 0.0);
        for step in &solution.steps {
            for end in &step.path.increments {
                work += 0.5 * (end.force + last[0]) * (end.approach - last[1]);
                last = [end.force, end.approach];
            }
            let energy = step.path.energy.unwrap();
            assert_within(energy.work(), work, 3e-3);
            assert_eq!(energy.backstress > 0.0, stores);
            assert!(energy.dissipated() > 0.0);
        }
    }
}

/// Taken away and put on again, the load finds the same state, and nothing is lost on the way.
#[test]
fn an_elastic_loop_closes() {
    let load = format!(
        r#"{{"history": [{{"force": {0}}}, {{"force": 0}}, {{"force": {0}}}]}}"#,
        force(3.0)
    );
    let solver = r#"{"theory": "flow", "tolerance": 1e-10}"#;
    let solution = solve(&cylinders(BILINEAR, &load, solver, 10));
    let (first, again) = (&solution.steps[0], &solution.steps[2]);
    assert_within(again.figures.peak_pressure, first.figures.peak_pressure, 1e-6);
    assert_within(again.figures.approach, first.figures.approach, 1e-6);
    assert_within(again.path.energy.unwrap().work(), first.path.energy.unwrap().work(), 1e-6);
    assert_within(
        again.path.energy.unwrap().plastic_work,
        first.path.energy.unwrap().plastic_work,
        1e-6,
    );
}

#[test]
fn the_couplings_agree() {
    let accelerated = solve(&cylinders(BILINEAR, &up_and_down(2.5), FLOW, 8));
    for coupling in [Coupling::Strong, Coupling::Weak] {
        let mut job = cylinders(BILINEAR, &up_and_down(2.5), FLOW, 8);
        job.solver.coupling = coupling;
        let other = solve(&job);
        for (a, b) in accelerated.steps.iter().zip(&other.steps) {
            assert_within(b.figures.approach, a.figures.approach, 1e-4);
        }
        assert_within(
            other.steps[0].figures.peak_pressure,
            accelerated.steps[0].figures.peak_pressure,
            1e-4,
        );
    }
}

#[test]
fn an_approach_below_the_permanent_one_carries_nothing() {
    let load = r#"{"history": [{"approach": 0.018}, {"approach": 0.001}, {"approach": 0}]}"#;
    let report = report(&cylinders(BILINEAR, load, FLOW, 8));
    for step in &report.steps[1..] {
        assert_eq!((step.status, step[Name::Force]), (SolveStatus::Converged, 0.0));
    }
    assert!(report.steps[1].validity.iter().any(|note| note.code == "no_contact"));
}

#[test]
fn what_a_theory_cannot_do_is_refused_by_name() {
    let body = r#"{"shape": {"type": "cylinder", "radius": 20}, "material": {"young_modulus": 210000,
        "poisson_ratio": 0.3, "plasticity": {"law": "bilinear", "yield_stress": 500,
            "tangent_modulus": 10500,
        "backstress": [{"modulus": 1000, "rate": 0}]}}}"#;
    let faults = |load: &str, solver: &str| {
        let job = format!(
            r#"{{"analysis": "plane_strain", "upper": {body}, "lower": {body}, "load": {load}, "solver": {solver}}}"#
        );
        match Job::from_json(job.as_bytes()) {
            Err(JobError::Fields(faults)) => {
                faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
            }
            other => panic!("{other:?}"),
        }
    };
    let secant =
        faults(r#"{"force": 100}"#, r#"{"theory": "flow", "coupling": "secant_stiffness"}"#);
    assert!(secant.contains("/solver/coupling"), "{secant}");
    let memory = faults(
        r#"{"history": [{"force": 100}, {"force": 0}]}"#,
        r#"{"theory": "deformation", "increments": 4}"#,
    );
    for pointer in
        ["/upper/material/plasticity/backstress", "/load/history/1", "/solver/increments"]
    {
        assert!(memory.contains(pointer), "{memory}");
    }
}

/// `w_c = (π C Y/2E')² R`, C = 1.295 exp(0.736 ν): the interference at which a sphere first yields
/// (Jackson and Green).
fn critical_interference(modulus: f64, yield_stress: f64, radius: f64) -> f64 {
    let c = 1.295 * (0.736_f64 * 0.3).exp();
    (std::f64::consts::PI * c * yield_stress / (2.0 * modulus)).powi(2) * radius
}

/// Approaches of a rigid ball towards a large block, and back to no force.
fn ball_on_block(interferences: &[f64], tangent_modulus: f64, elements: u32) -> Report {
    let (yield_stress, radius) = (200.0, 10.0);
    let first = critical_interference(steel_modulus(), yield_stress, radius);
    let loads: Vec<String> =
        interferences.iter().map(|w| format!(r#"{{"approach": {}}}"#, w * first)).collect();
    let job = format!(
        r#"{{"analysis": "axisymmetric", "load": {{"history": [{}, {{"force": 0}}]}},
        "upper": {{"shape": {{"type": "cylinder", "radius": {radius}}},
            "material": {{"rigid": true}}}},
        "lower": {{"shape": {{"type": "block", "width": 300, "depth": 150}},
            "material": {{"young_modulus": 200000, "poisson_ratio": 0.3,
                "plasticity": {{"law": "bilinear",
            "yield_stress": {yield_stress}, "tangent_modulus": {tangent_modulus}}}}}}},
        "mesh": {{"elements_per_half_width": {elements}}}, "solver": {{"theory": "flow"}}}}"#,
        loads.join(", ")
    );
    report(&Job::from_json(job.as_bytes()).unwrap())
}

fn steel_modulus() -> f64 {
    effective_modulus([
        Some(ElasticConstants { young_modulus: 200_000.0, poisson_ratio: 0.3 }),
        None,
    ])
}

const BILINEAR_SPHERE: &str =
    r#"{"law": "bilinear", "yield_stress": 200, "tangent_modulus": 4000}"#;
/// The same curve by Prager's law.
const PRAGER_SPHERE: &str = r#"{"law": "bilinear", "yield_stress": 200, "tangent_modulus": 0,
    "backstress": [{"modulus": 4081.632653, "rate": 0}]}"#;

/// A sphere below a rigid flat; `W` in its history stands for so many critical interferences.
fn sphere_under_flat(interference: f64, plasticity: &str, history: &str) -> Job {
    let w = interference * critical_interference(steel_modulus(), 200.0, 10.0);
    let job = format!(
        r#"{{"analysis": "axisymmetric", "load": {{"history": {}}},
        "upper": {{"shape": {{"type": "block", "width": 40, "depth": 20}},
            "material": {{"rigid": true}}}},
        "lower": {{"shape": {{"type": "cylinder", "radius": 10}},
            "material": {{"young_modulus": 200000,
            "poisson_ratio": 0.3, "plasticity": {plasticity}}}}},
        "mesh": {{"elements_per_half_width": 10}}, "solver": {{"theory": "flow"}}}}"#,
        history.replace('W', &w.to_string())
    );
    Job::from_json(job.as_bytes()).unwrap()
}

/// Under a force that comes and goes plastic flow dies out, although the first cycle yields in
/// reverse: what the fourth cycle adds is below a thousandth of the plastic work, and the next
/// adds less than half of that.
#[test]
#[ignore = "full"]
fn a_pulsating_contact_shakes_down_within_three_cycles() {
    for law in [BILINEAR_SPHERE, PRAGER_SPHERE] {
        let job = sphere_under_flat(60.0, law, "[{\"approach\": W}]");
        let force = report(&job).steps[0][Name::Force];
        let history = format!(r#"{{"force": {force}}}, {{"force": 0}}"#);
        let report = report(&sphere_under_flat(
            60.0,
            law,
            &format!("[{}]", [history.as_str(); 5].join(",")),
        ));
        assert_eq!(report.status, SolveStatus::Converged);
        let work = |k: usize| {
            let step = &report.steps[k];
            step.value(Name::PlasticWork).unwrap_or_else(|| step[Name::DissipatedWork])
        };
        assert!(report.steps[1][Name::ReversePlasticStrain] > 0.0);
        let added = |k: usize| work(2 * k + 1) - work(2 * k - 1);
        assert!(added(3) < 1e-3 * work(9), "the fourth cycle adds {:e}", added(3) / work(9));
        assert!(added(4) < 0.5 * added(3), "{:e} {:e}", added(3), added(4));
    }
}

/// dP/dα = 2 E* a at the instant of unloading, whatever the dent.
#[test]
#[ignore = "full"]
fn a_dent_unloads_by_the_slope_of_a_flat_punch() {
    for interference in [0.9, 10.0, 40.0] {
        let report = ball_on_block(&[interference], 2000.0, 20);
        let step = &report.steps[0];
        assert_eq!(step.status, SolveStatus::Converged);
        assert!(step[Name::HalfWidth] < 0.5);
        let slope = 2.0 * steel_modulus() * step[Name::HalfWidth];
        // An elastic ball has one stiffness.
        let unloading = step.value(Name::UnloadingStiffness);
        assert_within(unloading.unwrap_or_else(|| step[Name::ContactStiffness]), slope, 5e-3);
    }
}

/// A punch below what the body bears, without load, and beyond it: the answers of the first two
/// loads are kept, and the history ends with the collapse.
#[test]
fn a_history_ends_where_a_body_collapses() {
    let text = include_str!("../cases/flat_punch_given_by_points.json");
    let mut job: serde_json::Value = serde_json::from_str(text).unwrap();
    let force = job["load"]["force"].as_f64().unwrap();
    let loads =
        [0.5 * force, 0.0, 1.3 * force, 0.0].map(|force| serde_json::json!({"force": force}));
    job["load"] = serde_json::json!({"history": loads});
    job["upper"]["shape"] = serde_json::json!({"type": "punch", "width": 2.0, "depth": 5.0});
    job["solver"] = serde_json::json!({"theory": "flow", "increments": 8});
    job["mesh"] = serde_json::json!({"elements_per_half_width": 8});
    let report = report(&Job::from_json(job.to_string().as_bytes()).unwrap());
    let status: Vec<_> = report.steps.iter().map(|step| step.status).collect();
    assert_eq!(
        status,
        [SolveStatus::Converged, SolveStatus::Converged, SolveStatus::NotConverged]
    );
    let says = |code: &str| report.steps[2].validity.iter().any(|note| note.code == code);
    assert!(says("collapse") && says("not_converged"));
    let iterations: usize = report.steps.iter().map(|step| step.history.len()).sum();
    // Those of five increments that are tried in vain among them.
    assert!(iterations <= 600, "{iterations} iterations");
}

/// Whatever the analysis: no force leaves no contact, and every figure is finite.
#[test]
fn every_analysis_comes_back_to_no_force() {
    let [cylinder, ..] = surfaces();
    for analysis in ANALYSES {
        let mut asked = job(analysis, "accelerated", &laws()[0].1, [&cylinder, &cylinder], 4.0);
        let force = asked["load"]["force"].take();
        asked["load"] =
            json!({"history": [{"force": 0}, {"force": force}, {"force": 0}, {"force": 0}]});
        asked["solver"] = json!({"theory": "flow"});
        asked["mesh"] = json!({"elements_per_half_width": 8});
        let report = report(&parse(&asked));
        assert_eq!(report.status, SolveStatus::Converged, "{analysis}");
        // A figure that is not finite would be written as null.
        for step in &report.steps {
            let arrays = (&step.contact, &step.increments, &step.surfaces, &step.subsurface);
            let text = serde_json::to_string(&arrays).unwrap();
            assert!(!text.replace("\"upper\":null", "").contains("null"), "{analysis} {text}");
            for row in &step.answers {
                assert!(row.value.is_some() || !row.text.is_empty(), "{analysis} {row:?}");
            }
        }
        assert!(report.steps[0].approach().unwrap().abs() < 1e-12, "nothing has happened yet");
        assert!(report.steps[2].approach().unwrap() > 0.0);
        assert_within(
            report.steps[3].approach().unwrap(),
            report.steps[2].approach().unwrap(),
            1e-6,
        );
    }
}

/// Bodies changed places, mirrored, in other units or of another size: the same answer.
#[test]
fn flow_theory_knows_no_up_no_left_and_no_units() {
    let body = |shape: &str, size: f64, stress: f64| {
        let length = |x: f64| x * size;
        let shape = match shape {
            "cylinder" => json!({"type": "cylinder", "radius": length(20.0)}),
            _ => json!({"type": "block", "width": length(60.0), "depth": length(30.0)}),
        };
        json!({"shape": shape, "material": {"young_modulus": 210_000.0 * stress,
            "poisson_ratio": 0.3,
            "plasticity": {"law": "bilinear", "yield_stress": 500.0 * stress,
                "tangent_modulus": 10_500.0 * stress}}})
    };
    let asked = |upper: &str, lower: &str, size: f64, stress: f64, units: &str| {
        let force = 900.0 * size * stress;
        parse(
            &json!({"analysis": "plane_strain", "units": units, "upper": body(upper, size, stress),
            "lower": body(lower, size, stress),
            "load": {"history": [{"force": force}, {"force": 0}]},
            "mesh": {"elements_per_half_width": 8}, "solver": {"theory": "flow"}}),
        )
    };
    let expected = report(&asked("cylinder", "block", 1.0, 1.0, "mm_N_MPa"));
    let variants = [
        ("swapped", asked("block", "cylinder", 1.0, 1.0, "mm_N_MPa"), 1.0, 1.0),
        ("scaled", asked("cylinder", "block", 3.0, 1.0, "mm_N_MPa"), 3.0, 1.0),
        ("SI", asked("cylinder", "block", 1e-3, 1e6, "SI"), 1e-3, 1e6),
    ];
    for (name, job, length, stress) in variants {
        let found = report(&job);
        assert_eq!(found.status, SolveStatus::Converged, "{name}");
        for (a, b) in found.steps.iter().zip(&expected.steps) {
            assert_within(a.approach().unwrap(), b.approach().unwrap() * length, 1e-6);
            assert!(
                (a[Name::PeakPressure] - b[Name::PeakPressure] * stress).abs()
                    <= 1e-6 * stress * 1e3
            );
            assert_within(
                a[Name::DissipatedWork],
                b[Name::DissipatedWork] * length * length * stress,
                1e-5,
            );
        }
    }
    // The whole section instead of its half.
    let half = asked("cylinder", "block", 1.0, 1.0, "mm_N_MPa");
    let whole = Options { use_symmetry: false, ..Options::default() };
    let whole = run_with(&half, whole, &mut Unobserved).unwrap();
    for (a, b) in whole.steps.iter().zip(&run(&half, &mut Unobserved).unwrap().steps) {
        assert_within(a.figures.approach, b.figures.approach, 1e-3);
        assert!(
            (a.figures.peak_pressure - b.figures.peak_pressure).abs()
                <= 2e-3 * b.figures.peak_pressure.max(1.0)
        );
    }
}

/// A sharp cone of 19.7° on a block that does not harden.
fn cone(load: &serde_json::Value, elements: u32) -> Report {
    crate::problems::report(&json!({
        "analysis": "axisymmetric", "load": load,
        "upper": {"shape": {"type": "cone", "angle": 19.7, "width": 10, "depth": 10},
            "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 20, "depth": 15}, "material":
            {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity":
                {"law": "bilinear", "yield_stress": 400, "tangent_modulus": 0}}},
        "mesh": {"elements_per_half_width": elements}, "solver": {"theory": "flow"},
    }))
}

/// Beside a sharp tip strain has no bound, which is no collapse. The cone is like itself at every
/// depth: F/h² is one number on every mesh.
#[test]
fn a_sharp_cone_has_an_answer_on_every_mesh() {
    let curvature = |elements: u32| {
        let step = cone(&json!({"approach": 0.2}), elements).steps.remove(0);
        assert_eq!(step.status, SolveStatus::Converged, "{elements}: {:?}", step.validity);
        // Cones of perfectly plastic bodies bear 2.4 to 3 times the yield stress.
        let mean = step[Name::MeanPressure];
        assert!((2.4..3.0).contains(&(mean / 400.0)), "{elements}: {mean}");
        step[Name::Force] / 0.04
    };
    assert_within(curvature(10), curvature(20), 0.02);
}

/// Unloading strains a sharp dent no further: the narrow contact that is left is no collapse.
#[test]
fn a_sharp_cone_is_unloaded() {
    let report = cone(&json!({"history": [{"approach": 0.2}, {"force": 0}]}), 10);
    let dent = &report.steps[1];
    assert_eq!(dent.status, SolveStatus::Converged, "{:?}", dent.validity);
    assert!((0.15..0.2).contains(&dent.approach().unwrap()), "{:?}", dent.approach());
}

/// A contact on few nodes hardly moves between two small steps of the load, on a coarser mesh
/// neither: the scatter on the whole way is in the bars of each step.
#[test]
fn small_steps_have_the_bars_of_the_whole_way() {
    let force = |force: f64| json!({"force": force});
    let report = crate::problems::report(&json!({
        "analysis": "axisymmetric",
        "load": {"history": [force(2000.0), force(2060.0), force(2120.0)]},
        "upper": {"shape": {"type": "cylinder", "radius": 10}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 80, "depth": 40}, "material":
            {"young_modulus": 200_000, "poisson_ratio": 0.3, "plasticity":
                {"law": "bilinear", "yield_stress": 100, "tangent_modulus": 0}}},
        "mesh": {"elements_per_half_width": 10}, "solver": {"theory": "flow"},
    }));
    let step = &report.steps[2];
    // 40 elements: 0.09276 mm under 2339.7 N, and the force of a plastic ball goes with the depth.
    let exact = 0.09276 / 2339.7 * 2120.0;
    let off = step.approach().unwrap() / exact - 1.0;
    let bar = step.bar(Name::Approach).unwrap();
    assert!(off.abs() < bar, "{off} in {bar}");
}

/// A ball pressed 20 mm into a soft block by flow theory: the approach times the unloading stiffness
/// is a hundred times the force, whose bar is that of the contact area.
#[test]
fn the_force_of_a_fully_plastic_contact_is_known_as_its_area() {
    let job = json!({
        "analysis": "axisymmetric", "load": {"approach": 20},
        "upper": {"shape": {"type": "cylinder", "radius": 500}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 4000, "depth": 2000}, "material":
            {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity":
                {"law": "bilinear", "yield_stress": 50, "tangent_modulus": 0}}},
        "mesh": {"elements_per_half_width": 8}, "solver": {"theory": "flow", "increments": 6},
    });
    let job = Job::from_value(&job).unwrap();
    let step = run(&job, &mut Unobserved).unwrap().steps.remove(0);
    let force = step.figures.force;
    assert!(step.field.unloading_stiffness * 20.0 > 60.0 * force);
    let size = step.field.spacing / step.figures.half_width;
    let (bars, _) = report::estimate_error(&job, &step);
    let bar = bars.unwrap().of_figure(Figure::Force, 0).unwrap();
    let change = (step.coarse.unwrap().force / force - 1.0).abs();
    let increments = step.increment_error.unwrap().get(Figure::Force, 0).unwrap();
    let shown = step.path.shown.get(Figure::Force, 0).unwrap_or_default();
    assert!(bar <= (change + 0.2001 * size).max(shown) + increments, "{bar} {change}");
}
