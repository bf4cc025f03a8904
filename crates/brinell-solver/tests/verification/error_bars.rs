//! The error bars hold: six problems on five meshes, each against the same problem on a mesh of 64 elements over the
//! half-width, which is itself eight times closer to the truth than the bars at 8.

use std::thread;

use brinell_solver::report::StepReport;
use serde_json::{Value, json};

use crate::problems::{FORCE_3, bilinear, cylinder, report, two_cylinders};

const MESHES: [u32; 5] = [8, 11, 15, 20, 28];
const REFERENCE: u32 = 64;

fn problems() -> Vec<Value> {
    let ramberg_osgood =
        json!({"law": "ramberg_osgood", "reference_stress": 500.0, "offset": 0.3, "exponent": 5.0});
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
    let figures = |step: &StepReport| [step.contact.peak_pressure, step.contact.half_width, step.approach];
    let exact = figures(&at(problem, REFERENCE));
    let ratios = MESHES.map(|elements| {
        let step = at(problem, elements);
        let bar = step.estimated_error.unwrap();
        let (bars, found) = ([bar.peak_pressure, bar.half_width, bar.approach], figures(&step));
        std::array::from_fn(|k| bars[k] / (found[k] / exact[k] - 1.0).abs().max(f64::MIN_POSITIVE))
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
    let steel = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3, "plasticity": plasticity});
    let job = json!({"analysis": analysis, "load": {"history": [{"force": force}, {"force": 0}]},
        "upper": {"shape": shape, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 60, "depth": 30}, "material": steel},
        "mesh": {"elements_per_half_width": elements}, "output": {"subsurface": false}, "solver": {"theory": "flow"}});
    report(&job).steps.remove(1)
}

/// What a history leaves of the approach has a bar, which holds against twice as many elements; nothing else is in doubt there.
#[test]
fn the_approach_that_is_left_has_a_bar_that_holds() {
    let roller = json!({"type": "cylinder", "radius": 10});
    let punch = json!({"type": "punch", "width": 2, "depth": 5});
    let cases = [
        ("plane_strain", &roller, "voce", 417.0),
        ("plane_strain", &punch, "", 2200.0),
        ("axisymmetric", &roller, "", 52.0),
        ("axisymmetric", &roller, "voce", 52.0),
    ];
    for (analysis, shape, law, force) in cases {
        let [coarse, fine] = [8, 16].map(|elements| unloaded(analysis, shape, law, force, elements));
        let bars = coarse.estimated_error.unwrap();
        let error = (coarse.approach / fine.approach - 1.0).abs();
        assert!(fine.approach > 0.0 && bars.approach >= error && bars.approach < 0.3, "{error} {bars:?}");
        let rest = [bars.peak_pressure, bars.half_width, bars.force, bars.contact_stiffness];
        assert_eq!(rest, [0.0; 4]);
    }
}

#[test]
fn the_true_error_lies_within_the_bar() {
    let workers: Vec<_> = problems().into_iter().map(|job| thread::spawn(move || ratios(&job))).collect();
    let all: Vec<[f64; 3]> = workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect();
    for (k, name) in ["peak pressure", "half-width", "approach"].into_iter().enumerate() {
        let mut ratio: Vec<f64> = all.iter().map(|ratios| ratios[k]).collect();
        ratio.sort_by(f64::total_cmp);
        let share =
            |holds: fn(f64) -> bool| ratio.iter().filter(|r| holds(**r)).count() as f64 / ratio.len() as f64;
        let (covered, tight, median) = (share(|r| r >= 1.0), share(|r| r <= 20.0), ratio[ratio.len() / 2]);
        println!("{name}: within {covered:.3}, not 20 times too wide {tight:.3}, median ratio {median:.1}");
        assert!(covered >= 0.95, "{name}: {covered} of the errors lie within their bars");
        // An error changes its sign between meshes, so some are zero by chance and no bar is near them.
        assert!(tight >= 0.75, "{name}: {tight} of the bars are not 20 times too wide");
        assert!(median <= 10.0, "{name}: the median bar is {median} times too wide");
    }
}
