//! The bias of deformation theory in the answers, against flow theory on the same mesh.

use brinell_solver::inputs;
use brinell_solver::job::Job;
use brinell_solver::report::{Answer, Report, scales_of_floors};
use brinell_solver::solver::floors::floors;
use brinell_solver::solver::{Figure, Unobserved};
use serde_json::{Value, json};

use crate::problems::report;

/// A rigid ball on a perfectly plastic block of steel.
fn ball(load: &Value, theory: &str) -> Report {
    report(&json!({
        "analysis": "axisymmetric", "load": load,
        "upper": {"shape": {"type": "cylinder", "radius": 20}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 200, "depth": 100}, "material":
            {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity":
                {"law": "bilinear", "yield_stress": 300, "tangent_modulus": 0}}},
        "mesh": {"elements_per_half_width": 12}, "solver": {"theory": theory},
        "output": {"subsurface": false},
    }))
}

/// The force under which Hertz's peak is `ratio` times 300 MPa.
fn force(ratio: f64) -> Value {
    let modulus = 210_000.0 / 0.91;
    let peak = 300.0 * ratio;
    json!({"force": std::f64::consts::PI.powi(3) * peak.powi(3) * 400.0 / (6.0 * modulus * modulus)})
}

fn answer<'a>(report: &'a Report, name: &str) -> &'a Answer {
    report.steps[0].answers.iter().find(|answer| answer.name == name).unwrap()
}

/// Flow theory lies within bias, error of the bias and bars of both meshes.
fn assert_inside(deformation: &Report, flow: &Report, name: &str) {
    let (of, other) = (answer(deformation, name), answer(flow, name));
    let (x, y) = (of.value.unwrap(), other.value.unwrap());
    let whole = of.bias_error.unwrap() + of.error.unwrap();
    let off = (y - x * (1.0 - of.bias.unwrap())).abs();
    assert!(off <= whole * x + other.error.unwrap() * y, "{name}: {of:?} {other:?}");
}

#[test]
fn a_fully_plastic_ball_has_the_bias_of_its_theory() {
    let (deformation, flow) = (ball(&force(10.0), "deformation"), ball(&force(10.0), "flow"));
    for name in ["half_width", "approach", "mean_pressure"] {
        assert_inside(&deformation, &flow, name);
    }
    // Without its bias the approach is outside of its bar.
    let approach = answer(&deformation, "approach");
    let off = approach.value.unwrap() / answer(&flow, "approach").value.unwrap() - 1.0;
    assert!(off > 0.04 && approach.error.unwrap() < 0.02, "{off} {approach:?}");
    assert!(approach.bias.unwrap() > 0.02, "{approach:?}");
    // The force is given.
    assert_eq!(answer(&deformation, "force").bias, Some(0.0));
    let remark =
        deformation.steps[0].validity.iter().find(|note| note.code == "deformation_theory");
    assert!(remark.unwrap().message.contains("the peak pressure is"), "{remark:?}");
    assert!(flow.steps[0].answers.iter().all(|answer| answer.bias.is_none()));
}

#[test]
fn the_force_under_an_approach_has_a_bias() {
    let load = json!({"approach": 0.08});
    let (deformation, flow) = (ball(&load, "deformation"), ball(&load, "flow"));
    assert_inside(&deformation, &flow, "force");
    let bias = answer(&deformation, "force").bias.unwrap();
    assert!(bias < -0.02, "{bias}");
}

/// Below twice the yield stress both theories agree, and nothing is computed.
#[test]
fn little_flow_has_no_bias() {
    let deformation = ball(&force(1.9), "deformation");
    assert!(deformation.steps[0].answers.iter().all(|answer| answer.bias.is_none()));
    let remark =
        deformation.steps[0].validity.iter().find(|note| note.code == "deformation_theory");
    assert!(remark.unwrap().message.contains("Below twice the yield stress"), "{remark:?}");
}

/// The coarse mesh of a load serves for the next one as it does without a comparison.
#[test]
fn a_sweep_has_the_figures_of_its_loads() {
    let at = |force: &Value| force["force"].as_f64().unwrap();
    let loads = [at(&force(6.0)), 1.01 * at(&force(6.0))];
    let sweep = ball(&json!({"forces": loads}), "deformation");
    let last = ball(&json!({"force": loads[1]}), "deformation");
    let (one, other) = (&sweep.steps[1].contact, &last.steps[0].contact);
    assert!((one.peak_pressure / other.peak_pressure - 1.0).abs() < 0.01);
    let bias = |step: usize| {
        let answers = &sweep.steps[step].answers;
        answers.iter().find(|answer| answer.name == "approach").unwrap().bias.unwrap()
    };
    assert!((bias(0) - bias(1)).abs() < 0.01, "{} {}", bias(0), bias(1));
}

/// A ball pressed 20 mm into a soft block by flow theory: the approach times the unloading stiffness
/// is a hundred times the force, whose floor is that of the contact area.
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
    let step =
        inputs::run(&Job::from_value(&job).unwrap(), &mut Unobserved).unwrap().steps.remove(0);
    let force = step.figures.force;
    assert!(step.field.unloading_stiffness * 20.0 > 60.0 * force);
    let size = step.field.spacing / step.figures.half_width;
    let [width, floor] =
        [Figure::HalfWidth, Figure::Force].map(|figure| floors(figure)[2].unwrap());
    let scale = scales_of_floors(&step).unwrap().force;
    assert!(floor * scale <= 2.001 * width * size * force, "{scale} {force}");
}

/// Flow theory is solved under the force that was found, which has no bias then; nor has a figure
/// whose bar says no more than its bound.
#[test]
fn a_force_that_was_sought_has_no_bias() {
    let report = ball(&json!({"target": {"half_width": 1.2}}), "deformation");
    assert_eq!(answer(&report, "force").bias, None);
    assert!(answer(&report, "approach").bias.is_some());
    for answer in &report.steps[0].answers {
        assert!(answer.bias.is_none() || answer.error.is_some(), "{answer:?}");
    }
}

/// Of a figure without a bar the remark has no bias either.
#[test]
fn a_sharp_tip_has_no_bias_of_its_peak() {
    let report = report(&json!({
        "analysis": "axisymmetric", "load": {"approach": 0.02},
        "upper": {"shape": {"type": "cone", "angle": 19.7, "width": 4, "depth": 4},
            "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 8, "depth": 4}, "material":
            {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity":
                {"law": "bilinear", "yield_stress": 400, "tangent_modulus": 4000}}},
        "mesh": {"elements_per_half_width": 8},
    }));
    assert_eq!(answer(&report, "peak_pressure").bias, None);
    let remark = report.steps[0].validity.iter().find(|note| note.code == "deformation_theory");
    assert!(!remark.unwrap().message.contains("the peak pressure is"), "{remark:?}");
}

/// Flow theory that outgrows the coarse mesh begins again on a wider one, from rest.
#[test]
fn flow_theory_may_outgrow_the_mesh_of_the_deformation_theory() {
    let report = report(&json!({
        "analysis": "axisymmetric",
        "load": {"approaches": [0.000_064_952_684_05, 0.000_129_905_368_1, 0.000_103_924_294_48]},
        "upper": {"shape": {"type": "groove", "radius": 4.256_505_147_6, "width": 1.064_736_349_8,
                "depth": 3.247_110_739_4}, "support": "roller",
            "material": {"young_modulus": 177_492.594_517, "poisson_ratio": 0.3, "plasticity":
                {"law": "bilinear", "yield_stress": 24.504_722_29, "tangent_modulus": 120.760_406_8}}},
        "lower": {"shape": {"type": "cylinder", "radius": 1.064_736_349_8},
            "material": {"rigid": true}},
        "mesh": {"elements_per_half_width": 10},
    }));
    assert_eq!(report.steps.len(), 3);
    for step in &report.steps {
        assert!(step.answers.iter().any(|answer| answer.bias.is_some()), "{:?}", step.answers);
    }
}
