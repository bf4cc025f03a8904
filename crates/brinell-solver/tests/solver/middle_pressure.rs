//! The pressure in the middle of a contact has a bar where the peak has none: at sharp and at rounded
//! edges, of balls that are pressed most in a ring; not at a tip.

use brinell_solver::analytical::flat_punch_pressure;
use brinell_solver::report::{Answer, Name, StepReport};
use serde_json::{Value, json};

use crate::problems::{assert_within, report};

const ELEMENTS: [u32; 2] = [16, 64];

/// A rigid indenter on a steel block, on meshes of so many elements.
fn pressed(analysis: &str, shape: &Value, law: &Value, force: f64) -> [StepReport; 2] {
    ELEMENTS.map(|elements| {
        let material =
            json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3, "plasticity": law});
        let job = json!({"analysis": analysis, "load": {"force": force},
            "upper": {"shape": shape, "material": {"rigid": true}},
            "lower": {"shape": {"type": "block", "width": 80.0, "depth": 40.0},
                "material": material},
            "mesh": {"elements_per_half_width": elements}, "output": {"subsurface": false}});
        report(&job).steps.remove(0)
    })
}

fn answer<'a>(step: &'a StepReport, name: &str) -> Option<&'a Answer> {
    step.answers.iter().find(|answer| answer.name == name)
}

/// Asserts that the bar on the coarse mesh holds against the fine one.
#[track_caller]
fn assert_holds([coarse, fine]: &[StepReport; 2]) -> f64 {
    let bar = coarse.bar(Name::MiddlePressure).unwrap();
    assert_within(fine[Name::MiddlePressure], coarse[Name::MiddlePressure], bar);
    bar
}

#[test]
fn a_sharp_punch_is_pressed_in_the_middle_as_sadowsky_found() {
    let punch = json!({"type": "punch", "width": 2.0, "depth": 5.0});
    let steps = pressed("plane_strain", &punch, &Value::Null, 100.0);
    let bar = assert_holds(&steps);
    let [step, _] = &steps;
    assert_within(step[Name::MiddlePressure], flat_punch_pressure(100.0, 1.0, 0.0), bar);
    assert!(bar < 0.03 && step.bar(Name::PeakPressure).is_none(), "{bar}");
    assert_eq!(answer(step, "middle_pressure").unwrap().error.bound(), Some(bar));
    let peak = answer(step, "peak_pressure").unwrap();
    assert!(peak.error.bound().is_none() && peak.at_least > Some(0.0), "{peak:?}");
}

#[test]
fn a_rounded_edge_leaves_the_middle_known() {
    let law = json!({"law": "bilinear", "yield_stress": 500.0, "tangent_modulus": 2000.0});
    for radius in [0.1, 0.5] {
        let punch = json!({"type": "punch", "width": 4.0, "edge_radius": radius, "depth": 5.0});
        let steps = pressed("plane_strain", &punch, &law, 1500.0);
        let bar = assert_holds(&steps);
        assert!(bar < 0.12, "{bar}");
        assert_eq!(steps[0].bar(Name::HalfWidth), None);
    }
}

#[test]
fn the_middle_of_a_ball_is_known() {
    let ball = json!({"type": "cylinder", "radius": 10.0});
    let law = json!({"law": "bilinear", "yield_stress": 300.0, "tangent_modulus": 1000.0});
    for law in [Value::Null, law] {
        let steps = pressed("axisymmetric", &ball, &law, 400.0);
        assert!(assert_holds(&steps) < 0.05);
        // An ordinary contact has one answer for its peak.
        let middle = answer(&steps[0], "middle_pressure").unwrap();
        assert_eq!(middle.detail, steps[0].bar(Name::PeakPressure).is_some());
    }
}

#[test]
fn the_middle_of_a_tip_is_not_known() {
    let cone = json!({"type": "cone", "angle": 19.7, "width": 20.0, "depth": 20.0});
    let law = json!({"law": "bilinear", "yield_stress": 300.0, "tangent_modulus": 2000.0});
    let [step, _] = pressed("axisymmetric", &cone, &law, 400.0);
    for name in [Name::PeakPressure, Name::MiddlePressure] {
        assert_eq!(step.bar(name), None, "{name:?}");
    }
    assert!(answer(&step, "middle_pressure").unwrap().detail);
}
