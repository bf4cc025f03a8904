//! Answers and verdicts: their order, their figures beside closed forms, and where they are not
//! known.

use std::f64::consts::PI;

use brinell_solver::job::Job;
use brinell_solver::report::{
    self, Answer, AnswerPlace, ErrorBar, ErrorWord, LoadReport, Name, Report, StepReport,
    VerdictLevel,
};
use brinell_solver::solver::{SolveStatus, Unobserved};
use serde_json::{Value, json};

fn steel(yield_stress: f64) -> Value {
    json!({"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity":
        {"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 10_500}})
}

fn cylinder(material: &Value) -> Value {
    json!({"shape": {"type": "cylinder", "radius": 20}, "material": material})
}

fn solve(job: &Value) -> Report {
    let job = Job::from_value(job).unwrap_or_else(|error| panic!("{error:?} of {job}"));
    report::run(&job, &mut Unobserved).unwrap()
}

/// Two cylinders of 20 mm radius that yield at 218.99 N/mm.
fn cylinders(material: &Value, load: &Value, theory: &str) -> Value {
    json!({"analysis": "plane_strain", "upper": cylinder(material), "lower": cylinder(material),
        "load": load, "mesh": {"elements_per_half_width": 5}, "solver": {"theory": theory}})
}

fn answer<'a>(step: &'a StepReport, name: &str) -> &'a Answer {
    let found = step.answers.iter().find(|answer| answer.name == name);
    found.unwrap_or_else(|| panic!("no {name} in {:?}", step.answers))
}

fn why(answer: &Answer) -> &str {
    answer.reason.as_deref().unwrap_or_default()
}

fn value(step: &StepReport, name: &str) -> f64 {
    answer(step, name).value.unwrap()
}

fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found / expected - 1.0).abs() < tolerance, "{what} {found} {expected}");
}

#[test]
fn a_contact_beyond_yield_tells_its_state_and_its_margin() {
    let report = solve(&cylinders(&steel(500.0), &json!({"force": 612.6106}), "deformation"));
    let step = &report.steps[0];
    let verdict = &step.verdict;
    assert_eq!(verdict.level, VerdictLevel::AboveShakedownLimit);
    assert!(
        verdict.text.starts_with("Yields: 2.8 times first yield at 218.99 N/mm; largest plastic")
            && verdict.text.ends_with("(Hertz's peak 1500 > 1154.7 MPa)."),
        "{verdict:?}"
    );
    assert_eq!(step.answers[0].name, "peak_pressure");
    near(step.answers[0].elastic.unwrap(), 1500.0, 1e-6, "Hertz");
    near(value(step, "margin"), 218.99 / 612.6106, 1e-4, "margin");
    // Stress in a line contact goes with the root of the force.
    near(value(step, "utilization"), (612.6106_f64 / 218.99).sqrt(), 1e-4, "utilization");
    near(value(step, "effective_radius"), 10.0, 1e-12, "effective radius");
    let most = answer(step, "max_plastic_strain").place.unwrap();
    let depth = value(step, "plastic_depth");
    assert!(depth > most.depth && value(step, "plastic_cover") < most.depth, "{most:?}");
    assert_eq!(verdict.figure.as_deref(), Some("max_plastic_strain"));
    assert!(depth < 3.0 * step[Name::HalfWidth], "{depth}");
}

/// Half of the force of first yield; the same in layers, at the force that closed forms give.
#[test]
fn elastic_bodies_tell_how_far_they_are_from_yield() {
    let step =
        &solve(&cylinders(&steel(500.0), &json!({"force": 109.495}), "deformation")).steps[0];
    assert_eq!(step.verdict.level, VerdictLevel::Elastic);
    near(value(step, "margin"), 2.0, 1e-4, "margin");
    near(value(step, "utilization"), 0.5_f64.sqrt(), 1e-4, "utilization");
    let mut layered = steel(500.0);
    layered["plasticity"]["over_depth"] = json!([[0, 2.0], [0.1, 2.0], [0.3, 1.0]]);
    let step = &solve(&cylinders(&layered, &json!({"force": 100}), "deformation")).steps[0];
    let onset = step.value(Name::FirstYieldForce).unwrap();
    let step = &solve(&cylinders(&layered, &json!({"force": onset}), "deformation")).steps[0];
    near(value(step, "utilization"), 1.0, 1e-6, "utilization at first yield");
    near(value(step, "margin"), 1.0, 1e-9, "margin at first yield");
    // Before the contact, the answers that ask for strength.
    assert_eq!(step.answers[0].name, "utilization");
}

#[test]
fn without_a_yield_stress_nothing_is_known_of_yield() {
    let elastic = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    let step = &solve(&cylinders(&elastic, &json!({"force": 100}), "deformation")).steps[0];
    assert_eq!(step.verdict.level, VerdictLevel::NotKnown);
    for name in ["utilization", "margin"] {
        let answer = answer(step, name);
        assert!(answer.value.is_none() && why(answer).contains("no yield stress"), "{answer:?}");
    }
}

/// Hertz's onset does not hold for a punch; its corner has no elastic limit at all.
#[test]
fn a_sharp_corner_has_no_margin() {
    let job = json!({"analysis": "plane_strain",
        "upper": {"shape": {"type": "punch", "width": 4, "depth": 10}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 60, "depth": 60}, "material": steel(1e5)},
        "load": {"force": 100}, "mesh": {"elements_per_half_width": 5}});
    let step = &solve(&job).steps[0];
    assert_eq!(step.verdict.level, VerdictLevel::NotKnown);
    assert!(answer(step, "utilization").value.is_none());
    assert!(answer(step, "margin").value.is_none());
}

#[test]
fn an_unloaded_contact_tells_the_dent_and_the_tension_of_the_field() {
    let load = json!({"history": [{"force": 612.6106}, {"force": 0}]});
    let report = solve(&cylinders(&steel(500.0), &load, "flow"));
    let step = &report.steps[1];
    let verdict = &step.verdict;
    assert_eq!(verdict.level, VerdictLevel::Dented);
    assert!(verdict.text.contains("dent of") && verdict.text.contains("tension"), "{verdict:?}");
    let names: Vec<&str> = step.answers.iter().map(|answer| answer.name.as_str()).collect();
    let expected = ["dent_depth", "pile_up", "permanent_approach", "residual_tension"];
    assert_eq!(names[..4], expected);
    let surface = step.surfaces.as_ref().unwrap().lower.as_ref().unwrap();
    let deepest = surface.height.iter().copied().fold(0.0, f64::min);
    near(value(step, "dent_depth"), -deepest, 1e-12, "dent");
    let profile = step.subsurface.as_ref().unwrap().lower.as_ref().unwrap();
    let on_axis = profile.sigma_x.iter().chain(&profile.sigma_z).copied().fold(0.0, f64::max);
    assert!(value(step, "residual_tension") >= 0.98 * on_axis, "{on_axis}");
    // Under the load that dented the bodies, Hertz's theory is that of bodies without a dent.
    let load = json!({"history": [{"force": 612.6106}, {"force": 0}, {"force": 300}]});
    let report = solve(&cylinders(&steel(500.0), &load, "flow"));
    assert!(answer(&report.steps[2], "peak_pressure").text.contains("without a dent"));
    assert_eq!(answer(&report.steps[0], "peak_pressure").text, "");
}

/// Two approaches under which dented bodies are apart leave the same; neither tells how much.
#[test]
fn an_approach_without_contact_is_no_permanent_one() {
    let load = json!({"history": [{"approach": 0.02}, {"approach": 0.002}, {"approach": 0.001}]});
    let report = solve(&cylinders(&steel(300.0), &load, "flow"));
    for step in &report.steps[1..] {
        assert_eq!(step[Name::HalfWidth], 0.0, "{:?}", step.contact);
        let dent = value(&report.steps[1], "dent_depth");
        assert!((value(step, "dent_depth") / dent - 1.0).abs() < 1e-9);
        assert!(step.answers.iter().all(|answer| answer.name != "permanent_approach"));
        assert_eq!(answer(step, "approach").error, ErrorBar::Word(ErrorWord::Given));
        assert_eq!(LoadReport::Approach(value(step, "approach")), step.load);
    }
}

/// A pin under little force in a hole touches by one node of a mesh for its largest force.
#[test]
fn a_width_below_an_element_is_not_known() {
    let pin = json!({"analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": 10}, "material": steel(300.0)},
        "lower": {"shape": {"type": "hole", "radius": 10.02, "outer_radius": 14},
            "material": steel(300.0)},
        "load": {"history": [{"force": 5}, {"force": 2500}]}, "solver": {"theory": "flow"},
        "mesh": {"elements_per_half_width": 8}});
    let [little, more] = <[StepReport; 2]>::try_from(solve(&pin).steps).unwrap();
    assert_eq!(value(&little, "force"), 5.0);
    for name in ["half_width", "mean_pressure"] {
        let unknown = answer(&little, name);
        assert_eq!([unknown.value, unknown.error.bound()], [None; 2], "{unknown:?}");
        assert!(why(unknown) == "narrower than an element", "{unknown:?}");
        assert!(value(&more, name) > 0.0);
    }
}

/// A load within a dent: Hertz's contact of bodies without a dent is narrower, and judges nothing.
#[test]
fn a_load_within_a_dent_is_not_judged_by_hertz() {
    let history = json!({"history": [{"force": 8000}, {"force": 0}, {"force": 600}]});
    let report = solve(&cylinders(&steel(500.0), &history, "flow"));
    let [first, _, last] = <[StepReport; 3]>::try_from(report.steps).unwrap();
    let judged = &first.verdict;
    assert_eq!(judged.level, VerdictLevel::AboveShakedownLimit);
    assert!(value(&first, "margin") < 1.0 && value(&first, "shakedown_pressure") > 0.0);
    assert!(last.elastic(Name::PeakPressure) < first.elastic(Name::PeakPressure));
    let judged = &last.verdict;
    assert_eq!(judged.level, VerdictLevel::Yields);
    assert!(judged.text.starts_with("Has yielded under an earlier load"));
    for name in ["utilization", "margin"] {
        assert_eq!(answer(&last, name).value, None, "{name}");
    }
    assert!(last.answers.iter().all(|answer| answer.name != "shakedown_pressure"));
}

/// Two strips with a gap between them: the mean pressure is over the gap too, and says so.
#[test]
fn a_mean_pressure_over_a_gap_says_so() {
    let body = |shape: Value| json!({"shape": shape, "material": steel(500.0)});
    let points = [[-10.0, -1.0], [-3.0, -0.05], [-2.0, 0.0], [0.0, -0.01]];
    let mirrored = points.iter().rev().skip(1).map(|[x, y]| [-x, *y]);
    let points: Vec<[f64; 2]> = points.into_iter().chain(mirrored).collect();
    let job = json!({"analysis": "plane_strain",
        "upper": body(json!({"type": "profile", "points": points, "depth": 20,
            "interpolation": "smooth"})),
        "lower": body(json!({"type": "block", "width": 40, "depth": 40})),
        "load": {"force": 500}, "mesh": {"elements_per_half_width": 6}});
    let step = &solve(&job).steps[0];
    assert_eq!(step.contact.patches.len(), 2);
    assert!(answer(step, "mean_pressure").label.ends_with("gaps included"));
    let one = cylinders(&steel(500.0), &json!({"force": 500}), "deformation");
    assert_eq!(answer(&solve(&one).steps[0], "mean_pressure").label, "Mean pressure");
}

/// One curve that begins at any stress has one answer: the size of the mesh does not hang on where
/// it begins.
#[test]
fn curves_that_begin_low_are_solved() {
    let [exponent, strain] = [3.33_f64, 0.002];
    let of_law = |law: Value| {
        let material = json!({"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": law});
        let job = json!({"analysis": "plane_strain", "upper": cylinder(&material),
            "lower": {"shape": {"type": "block", "width": 40, "depth": 40}, "material": material},
            "load": {"force": 1000}, "mesh": {"elements_per_half_width": 6}});
        let step = solve(&job).steps.remove(0);
        assert_eq!(step.status, SolveStatus::Converged, "{job}");
        [value(&step, "half_width"), value(&step, "peak_pressure")]
    };
    let ramberg_osgood = |stress: f64| {
        of_law(json!({"law": "ramberg_osgood", "reference_stress": stress,
            "offset": strain * (stress / 500.0).powf(exponent), "exponent": exponent}))
    };
    let ludwik = |stress: f64| {
        of_law(
            json!({"law": "ludwik", "yield_stress": stress, "coefficient": 3000, "exponent": 0.3}),
        )
    };
    let swift = |offset: f64| {
        of_law(json!({"law": "swift", "yield_stress": 3000.0 * offset.powf(0.3),
            "strain_offset": offset, "exponent": 0.3}))
    };
    for [usual, low] in [
        [ramberg_osgood(500.0), ramberg_osgood(10.0)],
        [ludwik(5.0), ludwik(1e-6)],
        [swift(1e-6), swift(1e-9)],
    ] {
        near(low[0], usual[0], 0.02, "half-width");
        near(low[1], usual[1], 0.02, "peak");
    }
}

/// A peak off the middle of its cell, on two grids that agree: 40 cells have 799.97 MPa.
#[test]
fn two_grids_that_agree_leave_a_bar() {
    let elastic = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    let job = json!({"analysis": "three_dimensional",
        "upper": {"shape": {"type": "roller", "radius": 10, "length": 10, "profile": "iso_16281",
            "tilt": 0.37}, "material": elastic},
        "lower": {"shape": {"type": "curved", "radius_x": 30}, "material": elastic},
        "load": {"force": 500}, "mesh": {"elements_per_half_width": 6}});
    let step = solve(&job).steps.remove(0);
    let bar = step.bar(Name::PeakPressure).unwrap();
    near(799.97, step[Name::PeakPressure], bar, "peak");
    assert!(bar < 0.01, "{bar}");
}

/// A roller in three dimensions and the same cylinder in the plane; a ball and Hertz's mean
/// pressure of a circle.
#[test]
fn figures_of_three_dimensions_are_those_of_the_plane() {
    let roller = json!({"analysis": "three_dimensional",
        "upper": {"shape": {"type": "roller", "radius": 20, "length": 10, "profile": "iso_16281"},
            "material": steel(500.0)},
        "lower": {"shape": {"type": "flat"}, "material": steel(500.0)},
        "load": {"force": 1000}, "mesh": {"elements_per_half_width": 4}});
    let step = &solve(&roller).steps[0];
    near(value(step, "effective_radius"), 20.0, 1e-12, "effective radius");
    assert!(answer(step, "mean_pressure").elastic.is_none());
    let ball = json!({"analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"}, "material": steel(5000.0)},
        "load": {"force": 70}, "mesh": {"elements_per_half_width": 4}});
    let step = &solve(&ball).steps[0];
    near(value(step, "effective_radius"), 10.0, 1e-12, "effective radius");
    let hertz = answer(step, "mean_pressure").elastic.unwrap();
    let [a, b] = ["semi_axis_a", "semi_axis_b"].map(|name| answer(step, name).elastic.unwrap());
    near(hertz * PI * a * b, 70.0, 1e-6, "Hertz's mean pressure");
    // Stress under a ball goes with the third root of the force.
    near(value(step, "utilization").powi(-3), value(step, "margin"), 1e-4, "margin");
}

/// The contact ratio leads, and the peak is that within the rim.
#[test]
fn rough_surfaces_lead_with_their_contact() {
    let heights: Vec<Vec<f64>> = (0..12)
        .map(|i| (0..12).map(|j| if (i + j) % 3 == 0 { 1e-5 } else { 0.0 }).collect())
        .collect();
    let job = json!({"analysis": "three_dimensional",
        "upper": {"shape": {"type": "flat"}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"},
            "surface": {"spacing_x": 0.01, "spacing_y": 0.01, "heights": heights},
            "material": {"young_modulus": 210_000, "poisson_ratio": 0.3}},
        "load": {"force": 0.5}});
    let step = &solve(&job).steps[0];
    assert_eq!(step.answers[0].name, "contact_ratio");
    assert_eq!(step.answers[1].name, "nominal_pressure");
    near(value(step, "nominal_pressure"), 0.5 / 0.0144, 1e-9, "nominal pressure");
    assert!(step.validity.iter().any(|note| note.code == "surface_end"));
    let peak = answer(step, "peak_pressure");
    assert!(peak.text.contains("without the cells of the rim"), "{peak:?}");
    assert!(peak.value.unwrap() < value(step, "largest_cell_pressure"));
    let place = peak.place.unwrap();
    assert!(place.x.abs() < 0.05 && place.y.unwrap().abs() < 0.05, "{place:?}");
}

/// Spots of single cells: nothing that a load leaves has a bar, nor has the approach.
#[test]
fn what_single_cells_leave_has_no_bar() {
    let height = |i: usize, j: usize| if i % 4 == 2 && j % 4 == 2 { 1e-3 } else { 0.0 };
    let heights: Vec<Vec<f64>> =
        (0..12).map(|i| (0..12).map(|j| height(i, j)).collect()).collect();
    let job = json!({"analysis": "three_dimensional",
        "upper": {"shape": {"type": "flat"}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"}, "material": steel(500.0),
            "surface": {"spacing_x": 0.01, "spacing_y": 0.01, "heights": heights}},
        "load": {"history": [{"force": 1.0}, {"force": 0}]}, "solver": {"theory": "flow"}});
    let report = solve(&job);
    assert!(report.steps[1].validity.iter().any(|note| note.message.contains("approach")));
    let left = answer(&report.steps[1], "permanent_approach");
    assert!(left.value.unwrap() > 0.0 && left.error.bound().is_none(), "{left:?}");
}

/// Where the cells of the rim bear the most, a peak without them is none: it would be below the mean.
#[test]
fn a_peak_without_the_rim_is_not_below_the_mean() {
    let height = |i: usize, j: usize| match (i.min(11 - i).min(j.min(11 - j)), (i, j)) {
        (0, _) if (i + j).is_multiple_of(3) => 1e-5,
        (_, (5, 5)) => 0.95e-5,
        _ => 0.0,
    };
    let heights: Vec<Vec<f64>> =
        (0..12).map(|i| (0..12).map(|j| height(i, j)).collect()).collect();
    let job = |force: f64| {
        json!({"analysis": "three_dimensional",
        "upper": {"shape": {"type": "flat"}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"},
            "surface": {"spacing_x": 0.01, "spacing_y": 0.01, "heights": heights},
            "material": {"young_modulus": 210_000, "poisson_ratio": 0.3}},
        "load": {"force": force}})
    };
    let mut withheld = 0;
    for force in [0.06, 0.12, 0.5, 2.0] {
        let step = &solve(&job(force)).steps[0];
        let peak = answer(step, "peak_pressure");
        let mean = value(step, "mean_pressure");
        assert!(peak.value.is_none_or(|peak| peak >= mean), "{peak:?} {mean}");
        withheld += usize::from(why(peak).contains("cells of the rim bear the most"));
    }
    assert!(withheld > 0);
}

#[test]
fn the_onset_is_said_as_the_force_that_was_found() {
    let step = &solve(&cylinders(&steel(500.0), &json!({"onset": true}), "deformation")).steps[0];
    let verdict = &step.verdict;
    assert_eq!(verdict.level, VerdictLevel::Elastic);
    let beginning = "First yield: a body begins to yield under this force, ";
    assert!(verdict.text.starts_with(beginning), "{verdict:?}");
}

/// A roller that is hollow in the middle bears on both ends.
#[test]
fn an_edge_pressure_is_no_multiple_of_nothing() {
    let step = &solve(&json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "roller", "radius": 5, "length": 10, "profile": "points",
            "points": [[-5, 0], [0, -0.05], [5, 0]]}, "material": steel(1800.0)},
        "lower": {"shape": {"type": "flat"}, "material": steel(1800.0)},
        "load": {"force": 100},
        "mesh": {"elements_per_half_width": 4},
    }))
    .steps[0];
    let edge = answer(step, "edge_pressure");
    assert_eq!(edge.text, "the middle of the roller does not touch");
    assert!(edge.value > Some(0.0));
}

/// A straight roller bears on its ends: closed forms of the endless line are too favourable there.
#[test]
fn a_roller_that_touches_its_ends_has_no_margin_of_the_line() {
    for force in [3000.0, 8000.0] {
        let step = &solve(&json!({
            "analysis": "three_dimensional",
            "upper": {"shape": {"type": "roller", "radius": 10, "length": 20},
                "material": {"young_modulus": 210_000, "poisson_ratio": 0.3}},
            "lower": {"shape": {"type": "flat"}, "material": steel(900.0)},
            "load": {"force": force},
            "mesh": {"elements_per_half_width": 6},
        }))
        .steps[0];
        let verdict = &step.verdict;
        assert_ne!(verdict.level, VerdictLevel::Elastic, "{verdict:?}");
        assert!(!verdict.text.contains("first yield"), "{verdict:?}");
        assert_eq!(["margin", "utilization"].map(|name| answer(step, name).value), [None; 2]);
        assert!(!step.answers.iter().any(|answer| answer.name == "shakedown_pressure"));
    }
}

/// Ramberg and Osgood's law has plastic strain under any stress, and another body's margin is none
/// of the contact.
#[test]
fn a_law_without_a_yield_point_is_never_elastic() {
    let mut law = steel(500.0);
    law["plasticity"] = json!({"law": "ramberg_osgood", "reference_stress": 300, "offset": 0.43,
        "exponent": 5});
    let mut job = cylinders(&law, &json!({"history": [{"force": 60}, {"force": 0}]}), "flow");
    job["lower"]["material"] = steel(1500.0);
    let steps = solve(&job).steps;
    let verdict = |k: usize| &steps[k].verdict;
    assert_eq!(verdict(0).level, VerdictLevel::Yields);
    assert!(verdict(0).text.starts_with("Flows, with no yield point: "), "{:?}", verdict(0));
    assert!(value(&steps[0], "max_plastic_strain") > 1e-4);
    assert_eq!(["margin", "utilization"].map(|name| answer(&steps[0], name).value), [None; 2]);
    assert_eq!(verdict(1).level, VerdictLevel::Dented, "{:?}", verdict(1));
}

/// Hertz's pressure is not that of a thin layer on its support.
#[test]
fn a_near_support_has_no_shakedown_limit() {
    let mut job = cylinders(&steel(500.0), &json!({"force": 800}), "deformation");
    job["lower"]["shape"] = json!({"type": "block", "width": 10, "depth": 0.5});
    let step = &solve(&job).steps[0];
    assert_eq!(step.verdict.level, VerdictLevel::Yields);
    assert!(!step.answers.iter().any(|answer| answer.name == "shakedown_pressure"));
}

/// Without a yield point all of a body has some plastic strain: only what has flowed by more than a
/// hundredth of its elastic strain counts.
#[test]
fn the_mean_strain_is_over_what_has_yielded() {
    let aluminium = json!({"young_modulus": 70_000, "poisson_ratio": 0.33, "plasticity":
        {"law": "ramberg_osgood", "reference_stress": 250, "offset": 0.6, "exponent": 12}});
    let rigid = json!({"rigid": true});
    let of = |analysis: &str, lower: &str, force: f64| {
        json!({"analysis": analysis, "load": {"force": force},
            "upper": {"shape": {"type": "sphere", "radius": 20}, "material": rigid},
            "lower": {"shape": {"type": lower}, "material": aluminium}})
    };
    let mut plane = of("plane_strain", "block", 300.0);
    plane["upper"]["shape"]["type"] = json!("cylinder");
    plane["lower"]["shape"] = json!({"type": "block", "width": 60, "depth": 30});
    for job in [plane, of("three_dimensional", "flat", 20.0)] {
        let step = solve(&job).steps.remove(0);
        let [mean, largest] =
            [Name::MeanPlasticStrain, Name::MaxPlasticStrain].map(|name| step[name]);
        assert!(mean > 0.1 * largest && mean < largest, "{mean} of {largest}");
        let bar = step.bar(Name::MeanPlasticStrain);
        assert_eq!(bar.is_none(), job["analysis"] == "three_dimensional");
        assert!(bar.is_none_or(|bar| bar < 0.3), "{bar:?}");
    }
}

/// At the verge of yield a mesh tells no more of the largest strain than its bound.
#[test]
fn an_error_as_large_as_its_figure_is_a_bound() {
    let step = solve(&cylinders(&steel(350.0), &json!({"force": 110}), "deformation"));
    let step = &step.steps[0];
    let strain = answer(step, "max_plastic_strain");
    assert_eq!(strain.error, ErrorBar::Word(ErrorWord::NotBounded));
    assert!(strain.at_most >= Some(2.0 * strain.value.unwrap()), "{strain:?}");
    assert_eq!(strain.text, "of all integration points", "said once");
    assert!(step.verdict.text.contains("largest plastic strain at most"), "{:?}", step.verdict);
}

/// Names that are one figure where their values are equal.
const ONE_FIGURE: [[Name; 2]; 6] = [
    [Name::PeakPressure, Name::MiddlePressure],
    [Name::PeakPressure, Name::LargestCellPressure],
    [Name::ContactStiffness, Name::UnloadingStiffness],
    [Name::DissipatedWork, Name::PlasticWork],
    [Name::Force, Name::FirstYieldForce],
    [Name::Hardness, Name::MeyerHardness],
];

/// What holds of the rows of any step.
fn assert_rows(rows: &[Answer], analysis: &str) {
    for row in rows {
        assert!(row.label.chars().count() <= 30 || row.detail, "{row:?}");
        let is_bare = row.place.is_none() && row.text.is_empty() && row.elastic.is_none();
        assert!(row.value.is_some() || row.reason.is_some() && is_bare, "{row:?}");
        if row.value == Some(0.0) {
            let reason = row.reason.as_deref().unwrap_or("a figure of zero has no relative error");
            assert_eq!(reason, "a figure of zero has no relative error", "{row:?}");
            assert!(row.place.is_none() && matches!(row.error, ErrorBar::Word(_)), "{row:?}");
        }
        let is_flat = analysis != "three_dimensional";
        let is_right = |place: &AnswerPlace| place.depth >= 0.0 && place.y.is_none() == is_flat;
        assert!(row.place.as_ref().is_none_or(is_right), "{row:?}");
        for name in ["at most", "at least", "not known"] {
            assert!(!row.text.contains(name), "said twice: {row:?}");
        }
    }
    let row = |name: Name| rows.iter().find(|row| row.is(name) && row.value.is_some());
    for [one, other] in ONE_FIGURE.map(|pair| pair.map(row)) {
        let Some((one, other)) = one.zip(other) else { continue };
        // A peak without a bar has that of the pressure in the middle.
        let is_known = !one.is(Name::PeakPressure) || one.error.bound().is_some();
        let is_zero = one.value == Some(0.0);
        assert!(one.value != other.value || is_zero || !is_known, "{one:?} {other:?}");
    }
}

/// Of each kind of fault one job: a step without an answer, bodies alike of unlike shapes, a rough
/// corner of a hole, an onset, a specimen that does not yield, one without load.
#[test]
fn rows_say_each_figure_once() {
    let elastic = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    let mut stopped = cylinders(&steel(300.0), &json!({"force": 2000}), "flow");
    stopped["solver"]["max_iterations"] = json!(2);
    let mut pin = cylinders(&elastic, &json!({"force": 3000}), "flow");
    pin["lower"] = json!({"shape": {"type": "hole", "radius": 20.1, "outer_radius": 40},
        "material": steel(900.0)});
    let ball = |force: f64| {
        json!({"lower": {"shape": {"type": "block", "width": 20, "depth": 10},
            "material": steel(650.0)}, "mesh": {"elements_per_half_width": 6},
            "load": {"hardness": {"scale": "sphere", "ball": 10, "force": force}}})
    };
    let ellipse = json!({"analysis": "three_dimensional", "mesh": {"elements_per_half_width": 4},
        "upper": {"shape": {"type": "curved", "radius_x": 10, "radius_y": 20},
            "material": steel(400.0)},
        "lower": {"shape": {"type": "flat"}, "material": steel(400.0)},
        "load": {"history": [{"force": 300}, {"force": 0}]}, "solver": {"theory": "flow"}});
    let onset = cylinders(&steel(500.0), &json!({"onset": true}), "deformation");
    let sweep =
        cylinders(&steel(500.0), &json!({"history": [{"force": 50}, {"force": 0}]}), "flow");
    let reports = [stopped, pin, ball(1.0), ball(3000.0), ellipse, onset, sweep].map(|job| {
        let report = solve(&job);
        let analysis = job["analysis"].as_str().unwrap_or("axisymmetric").to_owned();
        assert_rows(&report.answers, &analysis);
        for step in &report.steps {
            assert_rows(&step.answers, &analysis);
            let verdict = &step.verdict;
            let decides = |row: &Answer| {
                Some(&row.name) == verdict.figure.as_ref() && row.body == verdict.body
            };
            let is_there = step.answers.iter().any(|row| decides(row) && row.value.is_some());
            assert_eq!(is_there, verdict.figure.is_some(), "{verdict:?}");
        }
        report
    });
    let [stopped, _, elastic, dented, ellipse, onset, _] = &reports;
    assert_eq!(stopped.status, SolveStatus::NotConverged);
    assert_eq!(stopped.steps[0].value(Name::PeakPressure), None);
    let hardness = &elastic.answers[..];
    assert!(hardness.len() == 1 && hardness[0].is(Name::MeyerHardness), "{hardness:?}");
    assert!(why(&hardness[0]).contains("has not yielded"), "{hardness:?}");
    assert_eq!(elastic.steps[1].verdict.figure, None);
    let said = &dented.steps[1].verdict.text;
    let digits = said.split_once(": ").unwrap().1.split(' ').next().unwrap();
    let bar = dented.answers[0].error.bound().unwrap();
    let unit = 10f64.powf(f64::floor((bar * dented.answers[0].value.unwrap()).log10()));
    assert_eq!(digits.parse::<f64>().unwrap() % unit, 0.0, "{said}");
    let of_zone = |row: &&Answer| row.is(Name::PlasticDepth) || row.is(Name::PileUp);
    assert_eq!(ellipse.steps[1].answers.iter().filter(of_zone).count(), 2, "one body for both");
    assert_eq!(onset.steps[0].answers[0].label, "First yield");
}
