//! Contacts that begin at two places or at the edge of a surface: flat punches on hollow blocks,
//! faces with two bumps, and pins that reach nearly all round their holes.

use std::f64::consts::PI;

use brinell_solver::analytical::PinInHole;
use brinell_solver::report::{self, Name, StepReport};
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::problems::{assert_within, parse, report};

const MODULUS: f64 = 210_000.0 / 0.91;

fn steel() -> Value {
    json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3})
}

fn step(job: &Value) -> StepReport {
    let step = report(job).steps.remove(0);
    assert_eq!(step.status, SolveStatus::Converged, "{:?}", step.validity);
    step
}

fn codes(step: &StepReport) -> Vec<&str> {
    step.validity.iter().map(|note| note.code.as_str()).collect()
}

/// A rigid punch, 4 mm wide, that touches a hollow block with both edges.
#[expect(clippy::needless_pass_by_value, reason = "values are written where they are used")]
fn on_groove(analysis: &str, edge_radius: f64, load: Value, elements: u32) -> Value {
    json!({"analysis": analysis, "load": load, "mesh": {"elements_per_half_width": elements},
        "upper": {"shape": {"type": "punch", "width": 4.0, "edge_radius": edge_radius,
            "depth": 5.0}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "groove", "radius": 20.0, "width": 20.0, "depth": 20.0},
            "material": steel()}})
}

/// Sharp edges of a slope s to the surface beside them, each over the width b: `P = π/4 E* s b`,
/// as of a tilted punch that is about to lift off (Johnson, Contact Mechanics, 2.8, with the far
/// end where the pressure ends).
#[test]
#[ignore = "full"]
fn two_edges_of_a_punch() {
    let force = 5000.0;
    let width = 4.0 * 0.5 * force / (PI * MODULUS * 0.1);
    let on =
        |elements: u32| step(&on_groove("plane_strain", 0.0, json!({"force": force}), elements));
    let [coarse, fine] = [on(10), on(20)];
    for (step, spacing) in [(&coarse, 0.032), (&fine, 0.016)] {
        let [left, right] = step.contact.patches.as_slice() else {
            panic!("{:?}", step.contact.patches)
        };
        assert_eq!((left.left, right.right), (-2.0, 2.0));
        assert!((right.right - right.left - width).abs() < spacing, "{right:?} for {width}");
        assert!(codes(step).contains(&"sharp_corner"));
    }
    // The pair of an edge closes where the edge is, so that the approach does not hang on the
    // mesh.
    assert_within(coarse.approach().unwrap(), fine.approach().unwrap(), 1e-2);
}

/// However light the load, what touches first carries it; and force and approach ask for the same
/// state.
#[test]
#[ignore = "full"]
fn edges_touch_under_the_smallest_approach() {
    for analysis in ["plane_strain", "plane_stress", "axisymmetric"] {
        for approach in [1e-6, 1e-4, 1e-2] {
            let found = step(&on_groove(analysis, 0.0, json!({"approach": approach}), 10));
            assert!(
                found[Name::Force] > 0.0 && found[Name::HalfWidth] == 2.0,
                "{analysis} {approach}"
            );
            let again = step(&on_groove(analysis, 0.0, json!({"force": found[Name::Force]}), 10));
            let bar = found.bar(Name::Force).unwrap_or(0.5);
            assert_within(again.approach().unwrap(), approach, bar.max(1e-3));
        }
    }
}

/// Pressed flat, a hollow block gives way to more load as a flat one does.
#[test]
fn a_hollow_that_is_pressed_flat() {
    for analysis in ["plane_strain", "plane_stress"] {
        let approach = |force: f64, is_hollow: bool| {
            let mut job = on_groove(analysis, 0.0, json!({"force": force}), 20);
            if !is_hollow {
                job["lower"]["shape"] = json!({"type": "block", "width": 20.0, "depth": 20.0});
            }
            let step = step(&job);
            assert!(
                step[Name::HalfWidth] == 2.0 && step.contact.patches.len() == 1,
                "{analysis} {force}"
            );
            step.approach().unwrap()
        };
        let [hollow, flat] =
            [true, false].map(|hollow| approach(90_000.0, hollow) - approach(60_000.0, hollow));
        assert_within(hollow, flat, 1e-3);
    }
}

/// Parts of a contact that no element resolves are not answered without a word, neither under a
/// force nor at the onset of yield.
#[test]
#[ignore = "full"]
fn parts_that_are_too_small_for_the_mesh_are_said() {
    let mut job = on_groove("plane_strain", 0.3, json!({"force": 5.0}), 10);
    let under_force = step(&job);
    assert!(codes(&under_force).contains(&"coarse_mesh"));
    // Each edge is a cylinder of 0.3 mm that carries half of the force.
    let exact = brinell_solver::analytical::HertzLine::new(2.5, 0.3, MODULUS).peak_pressure();
    assert_eq!(under_force.bar(Name::PeakPressure), None);
    assert!(under_force[Name::PeakPressure] < exact);
    job["load"] = json!({"onset": true});
    job["lower"]["material"]["plasticity"] =
        json!({"law": "bilinear", "yield_stress": 500.0, "tangent_modulus": 0.0});
    assert!(codes(&step(&job)).contains(&"coarse_mesh"));
}

#[expect(clippy::needless_pass_by_value, reason = "values are written where they are used")]
fn bumps(heights: [f64; 2], interpolation: &str, force: f64, material: Value) -> Value {
    json!({"analysis": "plane_strain", "load": {"force": force},
        "mesh": {"elements_per_half_width": 10},
        "upper": {"shape": {"type": "profile", "interpolation": interpolation, "depth": 20.0,
            "points": [[-10.0, -0.3], [-5.0, heights[0]], [0.0, 0.0], [5.0, heights[1]], [10.0, -0.3]]}, "material": material},
        "lower": {"shape": {"type": "block", "width": 80.0, "depth": 40.0}, "material": steel()}})
}

/// A contact that begins on one bump and reaches the other one, far on one side: its zone grows
/// where the surfaces have room, and what it costs is known.
#[test]
#[ignore = "full"]
fn two_unequal_bumps_far_apart() {
    for interpolation in ["smooth", "linear"] {
        for material in [steel(), json!({"rigid": true})] {
            let job = bumps([0.01, 0.0101], interpolation, 1000.0, material.clone());
            let found = report(&job);
            assert_eq!(found.status, SolveStatus::Converged, "{:?}", found.steps[0].validity);
            let [left, right] = found.steps[0].contact.patches.as_slice() else {
                panic!("not two parts")
            };
            assert!(left.left < -5.0 && left.right < 0.0 && right.left > 0.0 && right.right > 5.0);
            let expected = report::preflight(&parse(&job)).unwrap().equations as f64;
            assert_within(found.mesh.equations as f64, expected, 0.5);
            let mirrored = step(&bumps([0.0101, 0.01], interpolation, 1000.0, material));
            assert_within(mirrored.approach().unwrap(), found.steps[0].approach().unwrap(), 1e-4);
            assert_within(mirrored[Name::PeakPressure], found.steps[0][Name::PeakPressure], 1e-2);
        }
    }
}

/// A tip near the end of its face: the contact needs more room on one side than the other one has.
#[test]
fn a_crest_near_the_end_of_its_face() {
    for interpolation in ["smooth", "linear"] {
        let mut job = bumps([0.0; 2], interpolation, 1000.0, steel());
        job["upper"]["shape"]["points"] = json!([[-1.0, -0.2], [0.0, 0.0], [10.0, -0.1]]);
        let found = step(&job);
        let [patch] = found.contact.patches.as_slice() else { panic!("not one part") };
        assert!(patch.left > -0.8 && patch.right > 1.2, "{patch:?}");
    }
}

/// A smooth curve through points has no corner, however few they are.
#[test]
fn a_smooth_face_has_no_sharp_corner() {
    let mut job = bumps([0.0; 2], "smooth", 1000.0, json!({"rigid": true}));
    job["upper"]["shape"]["points"] = json!([[0.0, 0.0], [10.0, -0.5]]);
    assert!(codes(&step(&job)).is_empty());
    job["upper"]["shape"]["interpolation"] = json!("linear");
    assert!(codes(&step(&job)).contains(&"sharp_corner"));
}

/// Points on a flat face beside a sharp punch cost nothing.
#[test]
fn points_of_a_flat_face_are_not_resolved() {
    let punch = json!({"shape": {"type": "punch", "width": 2.0, "depth": 2.0},
        "material": {"rigid": true}});
    let points: Vec<[f64; 2]> = (0..40).map(|k| [0.25 * f64::from(k), 0.0]).collect();
    let face =
        json!({"type": "profile", "interpolation": "linear", "points": points, "depth": 20.0});
    let block = json!({"type": "block", "width": 19.5, "depth": 20.0});
    let [on_face, on_block] = [face, block].map(|shape| {
        let job = json!({"analysis": "plane_strain", "load": {"force": 400.0}, "upper": punch,
            "lower": {"shape": shape, "material": steel()}});
        (report::preflight(&parse(&job)).unwrap().equations as f64, step(&job).approach().unwrap())
    });
    assert_within(on_face.0, on_block.0, 0.1);
    assert_within(on_face.1, on_block.1, 1e-3);
}

/// Up to 80° to each side, on meshes of few elements as well; the force of a half-width is found
/// there, and one beyond is refused.
#[test]
fn pins_reach_80_degrees_on_coarse_meshes() {
    let pin = |load: Value, elements: u32| {
        json!({"analysis": "plane_strain", "load": load,
            "mesh": {"elements_per_half_width": elements},
            "upper": {"shape": {"type": "cylinder", "radius": 10.0}, "material": steel()},
            "lower": {"shape": {"type": "hole", "radius": 10.05, "outer_radius": 201.0},
                "material": steel()}})
    };
    for degrees in [70.0_f64, 76.0, 79.0] {
        let persson = PinInHole::of_half_angle(degrees.to_radians());
        let force = MODULUS * 0.05 / persson.clearance_ratio();
        for elements in [5, 8, 10, 20] {
            let found = step(&pin(json!({"force": force}), elements));
            let spacing = degrees / f64::from(elements);
            assert!(
                (found[Name::HalfAngle] - degrees).abs() < 0.5 * spacing,
                "{degrees} {elements}"
            );
            assert_within(
                found[Name::PeakPressure],
                persson.peak_pressure_ratio() * force / 10.0,
                2e-2,
            );
        }
    }
    let arc = |degrees: f64| degrees.to_radians() * (10.0_f64 * 10.05).sqrt();
    let sought = report(&pin(json!({"target": {"half_width": arc(70.0)}}), 20));
    let persson = PinInHole::of_half_angle(70.0_f64.to_radians());
    assert_within(
        sought.answers[0].value.unwrap(),
        MODULUS * 0.05 / persson.clearance_ratio(),
        0.05,
    );
    let beyond = report::preflight(&parse(&pin(json!({"target": {"half_width": arc(81.0)}}), 20)))
        .unwrap_err();
    assert!(beyond[0].pointer == "/load" && beyond[0].detail.contains("80°"), "{beyond:?}");
    // An approach leads farther, never to the 84.8° of a pin without clearance.
    let wide = step(&pin(json!({"approach": 1.5}), 20));
    let persson = PinInHole::of_clearance_ratio(MODULUS * 0.05 / wide[Name::Force]);
    let angle = persson.half_angle().to_degrees();
    assert!(angle > 81.0 && (wide[Name::HalfAngle] - angle).abs() < 2.0, "{angle}");
    assert_within(
        wide[Name::PeakPressure],
        persson.peak_pressure_ratio() * wide[Name::Force] / 10.0,
        1e-2,
    );
}

/// Where no force is the onset of yield, it is said why: a sharp corner, the stress before the load,
/// or a curve that begins at next to nothing.
#[test]
fn onsets_that_no_force_is() {
    let yielding = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3,
        "plasticity": {"law": "bilinear", "yield_stress": 500.0, "tangent_modulus": 0.0}});
    let mut job = bumps([0.0; 2], "linear", 1.0, json!({"rigid": true}));
    job["load"] = json!({"onset": true});
    job["lower"]["material"] = yielding.clone();
    job["upper"]["shape"] = json!({"type": "wedge", "angle": 10.0, "width": 10.0, "depth": 10.0});
    let fault =
        |job: &Value| match report::run(&parse(job), &mut brinell_solver::solver::Unobserved) {
            Err(report::RunError::Input(mut faults)) => faults.remove(0).detail,
            other => panic!("{other:?}"),
        };
    assert!(fault(&job).contains("sharp corner"), "{}", fault(&job));
    job["upper"]["shape"] = json!({"type": "cylinder", "radius": 10.0});
    let mut stressed = yielding;
    stressed["initial_stress"] = json!([{"depth": 0.0, "sigma_x": -499.0, "sigma_z": -499.0},
        {"depth": 0.5, "sigma_x": 0.0, "sigma_z": 0.0}]);
    job["lower"]["material"] = stressed;
    assert!(fault(&job).contains("stress before the load"), "{}", fault(&job));
    job["analysis"] = json!("axisymmetric");
    job["lower"]["material"] = json!({"young_modulus": 70_000.0, "poisson_ratio": 0.33,
        "plasticity": {"law": "table",
            "points": [[0, 0.01], [0.004, 280], [0.02, 310], [0.1, 350]]}});
    let named = "`/lower/material/plasticity/points`: The table looks like total strain";
    assert!(fault(&job).contains(named), "{}", fault(&job));
    // In three dimensions there is such a force.
    job["analysis"] = json!("three_dimensional");
    job["upper"]["shape"] = json!({"type": "sphere", "radius": 10.0});
    job["lower"]["shape"] = json!({"type": "flat"});
    job["mesh"] = json!({"elements_per_half_width": 5});
    assert!(codes(&step(&job)).contains(&"suspicious_curve"));
}

/// What touches only where a surface is about to end is refused before it is solved, with what to
/// do about it.
#[test]
fn contacts_at_the_end_of_a_surface_are_refused() {
    for analysis in ["plane_strain", "axisymmetric"] {
        for load in [
            json!({"force": 10.0}),
            json!({"approach": 0.01}),
            json!({"target": {"peak_pressure": 100.0}}),
        ] {
            let mut job = bumps([0.0; 2], "smooth", 10.0, steel());
            job["analysis"] = json!(analysis);
            job["load"] = load;
            for at in [8.5, 9.5, 9.99] {
                job["upper"]["shape"]["points"] = json!([[0.0, 0.0], [at, 0.5], [10.0, 0.4]]);
                let faults = report::preflight(&parse(&job)).unwrap_err();
                assert!(
                    faults.len() == 2
                        && faults.iter().all(|fault| fault.pointer.ends_with("/shape"))
                );
                assert!(faults[0].detail.contains("towards the middle"), "{}", faults[0].detail);
            }
        }
    }
}
