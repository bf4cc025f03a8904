//! The error bars hold: six problems on five meshes, each against the same problem on a mesh of 64
//! elements over the half-width, which is itself eight times closer to the truth than the bars
//! at 8.

use std::thread;

use brinell_solver::report::{ErrorBar, ErrorWord, Name, StepReport};
use serde_json::{Value, json};

use crate::problems::{FORCE_3, bilinear, cylinder, report, two_cylinders};

const MESHES: [u32; 5] = [8, 11, 15, 20, 28];
const REFERENCE: u32 = 64;

fn problems() -> Vec<Value> {
    let ramberg_osgood = json!({"law": "ramberg_osgood", "reference_stress": 500.0, "offset": 0.3,
        "exponent": 5.0});
    let mut on_block = two_cylinders("clamped", Value::Null, 400.0);
    on_block["lower"]["shape"] = json!({"type": "block", "width": 200.0, "depth": 200.0});
    let mut spheres = two_cylinders("clamped", Value::Null, 500.0);
    spheres["analysis"] = json!("axisymmetric");
    let mut plastic_spheres = two_cylinders("clamped", bilinear(), 800.0);
    plastic_spheres["analysis"] = json!("axisymmetric");
    let unequal = json!({"analysis": "plane_strain", "upper": cylinder("roller", bilinear()),
        "lower": cylinder("roller", ramberg_osgood), "load": {"force": FORCE_3}});
    vec![
        two_cylinders("clamped", Value::Null, 100.0),
        two_cylinders("clamped", bilinear(), FORCE_3),
        unequal,
        on_block,
        spheres,
        plastic_spheres,
    ]
}

fn at(problem: &Value, elements: u32) -> StepReport {
    let mut job = problem.clone();
    job["mesh"] = json!({"elements_per_half_width": elements});
    job["output"] = json!({"subsurface": false});
    report(&job).steps.remove(0)
}

/// Bar over true error of peak pressure, half-width and approach, on every mesh.
fn ratios(problem: &Value) -> Vec<[f64; 3]> {
    let figures = |step: &StepReport| {
        [step[Name::PeakPressure], step[Name::HalfWidth], step.approach().unwrap()]
    };
    let exact = figures(&at(problem, REFERENCE));
    let ratios = MESHES.map(|elements| {
        let step = at(problem, elements);
        let names = [Name::PeakPressure, Name::HalfWidth, Name::Approach];
        let (bars, found) = (names.map(|name| step.bar(name)), figures(&step));
        std::array::from_fn(|k| {
            bars[k].unwrap() / (found[k] / exact[k] - 1.0).abs().max(f64::MIN_POSITIVE)
        })
    });
    ratios.to_vec()
}

/// A rigid indenter on a steel block by flow theory, pressed in and taken away.
fn unloaded(analysis: &str, shape: &Value, law: &str, force: f64, elements: u32) -> StepReport {
    let plasticity = match law {
        "voce" => {
            json!({"law": "voce", "yield_stress": 400.0, "saturation_stress": 600.0, "rate": 50.0})
        }
        _ => json!({"law": "bilinear", "yield_stress": 500.0, "tangent_modulus": 0.0}),
    };
    let steel =
        json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3, "plasticity": plasticity});
    let job = json!({"analysis": analysis, "load": {"history": [{"force": force}, {"force": 0}]},
        "upper": {"shape": shape, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 60, "depth": 30}, "material": steel},
        "mesh": {"elements_per_half_width": elements}, "output": {"subsurface": false},
        "solver": {"theory": "flow"}});
    report(&job).steps.remove(1)
}

/// What a history leaves of the approach has a bar, which three of four times holds against twice as
/// many elements and is never far off; nothing else is in doubt there.
#[test]
#[ignore = "full"]
fn the_approach_that_is_left_has_a_bar_that_holds() {
    let roller = json!({"type": "cylinder", "radius": 10});
    let punch = json!({"type": "punch", "width": 2, "depth": 5});
    let cases = [
        ("plane_strain", &roller, "voce", 417.0),
        ("plane_strain", &punch, "", 2200.0),
        ("axisymmetric", &roller, "", 52.0),
        ("axisymmetric", &roller, "voce", 52.0),
    ];
    let mut held = 0;
    for (analysis, shape, law, force) in cases {
        let [coarse, fine] =
            [8, 16].map(|elements| unloaded(analysis, shape, law, force, elements));
        let error = (coarse.approach().unwrap() / fine.approach().unwrap() - 1.0).abs();
        let bar = coarse.bar(Name::PermanentApproach).unwrap();
        assert!(
            fine.approach().unwrap() > 0.0 && 1.5 * bar >= error && bar < 0.3,
            "{error} {bar}"
        );
        held += usize::from(bar >= error);
        assert_eq!(coarse.row(Name::Force).unwrap().error, ErrorBar::Word(ErrorWord::Given));
    }
    assert!(held >= 3, "{held} of 4");
}

/// Two cylinders and two balls that are loaded, unloaded and loaded beyond: what a load leaves off
/// stays, where the meshes of a later load happen to agree. Before, the approach of the unloaded
/// cylinders was 1.2 % off at ± 0.29 %, the last peak of the balls 3.6 % at ± 0.84 %.
#[test]
#[ignore = "full"]
fn a_history_keeps_the_errors_of_its_loads() {
    let law = |stress: f64| {
        json!({"law": "bilinear", "yield_stress": stress,
        "tangent_modulus": 10_500.0})
    };
    let cylinders = two_cylinders("clamped", law(750.0), 0.0);
    let balls = {
        let ball = json!({"shape": {"type": "sphere", "radius": 10.0}, "material":
            {"young_modulus": 210_000.0, "poisson_ratio": 0.3, "plasticity": law(500.0)}});
        json!({"analysis": "three_dimensional", "upper": ball, "lower": ball})
    };
    let cases =
        [(cylinders, 2450.44, [0.5, 1.0, 0.3, 1.1], 24), (balls, 262.0, [0.5, 1.0, 0.2, 1.2], 12)];
    for (mut job, force, parts, finer) in cases {
        let loads = parts.map(|part| json!({"force": part * force}));
        job["load"] = json!({"history": loads});
        job["solver"] = json!({"theory": "flow"});
        job["output"] = json!({"subsurface": false});
        let [coarse, fine] = [6, finer].map(|elements| {
            job["mesh"] = json!({"elements_per_half_width": elements});
            report(&job).steps
        });
        for (k, (coarse, fine)) in coarse.iter().zip(&fine).enumerate() {
            for name in ["peak pressure", "half-width", "approach"] {
                let [value, truth] = [coarse, fine].map(|step| figure(step, name));
                let [bar, rest] = [coarse, fine].map(|step| bar_of(step, name).unwrap());
                let off = (truth - value).abs();
                assert!(off <= bar * value + rest * truth, "{name} {k}: {value} {bar} {truth}");
            }
        }
    }
}

#[test]
#[ignore = "full"]
fn the_true_error_lies_within_the_bar() {
    let workers: Vec<_> =
        problems().into_iter().map(|job| thread::spawn(move || ratios(&job))).collect();
    let all: Vec<[f64; 3]> =
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect();
    for (k, name) in ["peak pressure", "half-width", "approach"].into_iter().enumerate() {
        let mut ratio: Vec<f64> = all.iter().map(|ratios| ratios[k]).collect();
        ratio.sort_by(f64::total_cmp);
        let share = |holds: fn(f64) -> bool| {
            ratio.iter().filter(|r| holds(**r)).count() as f64 / ratio.len() as f64
        };
        let (covered, tight, median) =
            (share(|r| r >= 1.0), share(|r| r <= 20.0), ratio[ratio.len() / 2]);
        println!(
            "{name}: within {covered:.3}, not 20 times too wide {tight:.3}, median ratio \
             {median:.1}"
        );
        assert!(covered >= 0.95, "{name}: {covered} of the errors lie within their bars");
        // An error changes its sign between meshes, so some are zero by chance and no bar is near
        // them.
        assert!(tight >= 0.75, "{name}: {tight} of the bars are not 20 times too wide");
        // Two thirds of these jobs are elastic, or hardly yield: the bars are those of all jobs.
        assert!(median <= 15.0, "{name}: the median bar is {median} times too wide");
    }
}

/// A body that rolls on its support.
#[expect(clippy::needless_pass_by_value, reason = "values are written where they are used")]
fn body(shape: Value, young_modulus: f64, poisson_ratio: f64, plasticity: Value) -> Value {
    let mut material = json!({"young_modulus": young_modulus, "poisson_ratio": poisson_ratio});
    if !plasticity.is_null() {
        material["plasticity"] = plasticity;
    }
    json!({"shape": shape, "support": "roller", "material": material})
}

fn rigid(shape: &Value) -> Value {
    json!({"shape": shape, "material": {"rigid": true}})
}

/// The figures of a step, by name.
fn figure(step: &StepReport, name: &str) -> f64 {
    match name {
        "peak pressure" => step[Name::PeakPressure],
        "half-width" => step[width(step)],
        "approach" => step.approach().unwrap(),
        _ => step[Name::Force],
    }
}

fn bar_of(step: &StepReport, name: &str) -> Option<f64> {
    match name {
        "peak pressure" => step.bar(Name::PeakPressure),
        "half-width" => step.bar(width(step)),
        "approach" => step.bar(Name::Approach).or_else(|| step.bar(Name::PermanentApproach)),
        _ => step.bar(Name::Force),
    }
}

/// The name of the size of a contact.
fn width(step: &StepReport) -> Name {
    if step.row(Name::SemiAxisA).is_some() { Name::SemiAxisA } else { Name::HalfWidth }
}

/// Errors that the difference to a mesh of half the density does not show, each against four times
/// as many elements: the pressure beside the end of a plateau in plane stress, the force under a
/// prescribed approach of bodies that flow, the clamped end of a column, and a contact that ends
/// on a rounded edge. The bar holds, or there is none.
#[test]
#[ignore = "full"]
fn errors_that_a_coarser_mesh_does_not_show() {
    let roller = json!({"type": "cylinder", "radius": 20.0});
    let block = json!({"type": "block", "width": 200.0, "depth": 200.0});
    let soft = json!({"law": "bilinear", "yield_stress": 300.0, "tangent_modulus": 210.0});
    let plateau = json!({"analysis": "plane_stress", "load": {"approach": 0.02},
        "upper": body(roller.clone(), 210_000.0, 0.3, soft.clone()),
        "lower": body(block, 210_000.0, 0.3, soft)});
    let ramberg_osgood = json!({"law": "ramberg_osgood", "reference_stress": 238.0,
        "offset": 0.579, "exponent": 4.03});
    let parabola = json!({"type": "parabola", "radius": 0.192, "width": 0.214, "depth": 0.373});
    let mut flowing = json!({"analysis": "plane_strain", "load": {"approach": 3.31e-5},
        "upper": body(parabola, 1_220_000.0, 0.499, ramberg_osgood),
        "lower": body(json!({"type": "cylinder",
            "radius": 0.739}), 244_000.0, 0.499, Value::Null)});
    flowing["upper"]["support"] = json!("clamped");
    flowing["lower"]["support"] = json!("clamped");
    let tall = json!({"type": "block", "width": 10.0, "depth": 35.0});
    let mut column = json!({"analysis": "plane_stress", "load": {"approach": 0.004},
        "upper": rigid(&roller),
        "lower": body(tall, 210_000.0, 0.499, Value::Null)});
    column["lower"]["support"] = json!("clamped");
    let punch = json!({"type": "punch", "width": 2.0, "edge_radius": 0.4, "depth": 5.0});
    let wide = json!({"type": "block", "width": 1000.0, "depth": 450.0});
    let edge = json!({"analysis": "plane_strain", "load": {"approach": 0.0091},
        "upper": rigid(&punch),
        "lower": body(wide, 13_000.0, 0.0, Value::Null)});
    let cases: [(Value, u32, &[&str]); 4] = [
        (plateau, 10, &["peak pressure", "half-width", "force"]),
        (flowing, 10, &["peak pressure", "half-width", "force"]),
        (column, 10, &["peak pressure", "half-width", "force"]),
        (edge, 8, &["half-width", "force"]),
    ];
    for (job, elements, figures) in cases {
        let [found, exact] = [1, 4].map(|finer| at(&job, finer * elements));
        for name in figures {
            let error = (figure(&found, name) / figure(&exact, name) - 1.0).abs();
            let bar = bar_of(&found, name);
            assert!(bar.is_none_or(|bar| error <= bar), "{name}: {error} beyond {bar:?} of {job}");
        }
    }
}

/// The pressure at a corner that carries the peak has no limit, of bodies that yield as well: the
/// answer says so, and the peak has no bar.
#[test]
#[ignore = "full"]
fn a_peak_without_a_limit_is_told() {
    let block = json!({"type": "block", "width": 200.0, "depth": 200.0});
    let perfect = json!({"law": "bilinear", "yield_stress": 1300.0, "tangent_modulus": 0.0});
    for (analysis, shape, force, law) in [
        ("axisymmetric", "cone", 100.0, &perfect),
        ("plane_strain", "wedge", 500.0, &perfect),
        ("plane_strain", "wedge", 500.0, &Value::Null),
    ] {
        let tip = json!({"type": shape, "angle": 1.0, "width": 20.0, "depth": 20.0});
        let job = json!({"analysis": analysis, "load": {"force": force}, "upper": rigid(&tip),
            "lower": body(block.clone(), 70_000.0, 0.3, law.clone())});
        let [found, exact] = [12, 48].map(|elements| at(&job, elements));
        let growth = exact[Name::PeakPressure] / found[Name::PeakPressure] - 1.0;
        assert!(growth > 0.05, "{shape}: {growth}");
        for step in [&found, &exact] {
            assert_eq!(step.bar(Name::PeakPressure), None, "{shape}");
            assert!(step.validity.iter().any(|note| note.code == "sharp_corner"), "{shape}");
        }
    }
}
