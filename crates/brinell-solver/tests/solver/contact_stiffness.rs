//! `contact_stiffness` against differences of the approach between loads that are jobs of their own.

use brinell_solver::report::StepReport;
use serde_json::{Value, json};

use crate::problems::{assert_within, report};

/// The last step of a job, and dP/dα between last forces that are by so much smaller and larger.
fn step_and_slope(job: &Value, by: f64) -> (StepReport, f64) {
    let at = |factor: f64| {
        let mut job = job.clone();
        job["output"] = json!({"subsurface": false});
        let scaled = |force: &Value| json!({"force": factor * force.as_f64().unwrap()});
        if let Some(last) = job["load"]["history"].as_array_mut().and_then(|loads| loads.last_mut()) {
            *last = scaled(&last["force"]);
        } else {
            job["load"] = scaled(&job["load"]["force"]);
        }
        report(&job).steps.pop().unwrap()
    };
    let (below, here, above) = (at(1.0 - by), at(1.0), at(1.0 + by));
    let slope = (above.contact.force - below.contact.force) / (above.approach - below.approach);
    (here, slope)
}

/// Meshes grow with the contact, and it ends at the same place between two nodes of each, so that load-approach curves of jobs of their
/// own are smooth: differences of loads of ±1 % are the stiffness that each of them says.
#[test]
#[ignore = "full"]
fn jobs_whose_loads_differ_by_a_hundredth_differ_by_the_stiffness() {
    let law = |tangent: f64| json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": tangent});
    let swift = json!({"law": "swift", "yield_stress": 500, "strain_offset": 0.002, "exponent": 0.15});
    for (analysis, plasticity, forces) in [
        ("plane_strain", law(10_000.0), [612.6106, 1089.0855, 1701.696]),
        ("plane_strain", law(0.0), [612.6106, 1089.0855, 1400.0]),
        ("plane_stress", law(10_000.0), [250.0, 400.0, 700.0]),
        ("plane_stress", swift, [250.0, 400.0, 700.0]),
        ("axisymmetric", law(10_000.0), [100.0, 400.0, 1500.0]),
        ("axisymmetric", law(0.0), [100.0, 400.0, 1500.0]),
    ] {
        let body = json!({"shape": {"type": "cylinder", "radius": 20},
            "material": {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": plasticity}});
        for force in forces {
            let job = json!({"analysis": analysis, "upper": body, "lower": body, "load": {"force": force}});
            let (step, slope) = step_and_slope(&job, 0.01);
            let error = step.contact_stiffness / slope - 1.0;
            assert!(error.abs() < 0.005, "{analysis} {plasticity} {force}: {error:+.4}");
        }
    }
}

/// Contacts as wide as a body or as a layer is thick: the mesh moves with all of the contact, however close the sides and the support are.
#[test]
#[ignore = "full"]
fn a_contact_wider_than_its_body_is_thick_is_as_stiff_as_loads_that_differ_tell() {
    let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    let soft = json!({"young_modulus": 70_000, "poisson_ratio": 0.3,
        "plasticity": {"law": "bilinear", "yield_stress": 100, "tangent_modulus": 3000}});
    let column =
        |width: f64| json!({"type": "power", "scale": 2.5, "exponent": 4, "width": width, "depth": 20});
    let layer = |depth: f64| json!({"type": "block", "width": 40, "depth": depth});
    for (analysis, radius, shape, force) in [
        ("plane_strain", 100, column(2.0), 180.0),
        ("plane_strain", 100, column(1.5), 120.0),
        ("plane_strain", 20, layer(0.2), 300.0),
        ("plane_strain", 20, layer(0.5), 300.0),
        ("plane_strain", 20, layer(1.0), 500.0),
        ("plane_stress", 20, layer(0.5), 150.0),
        ("axisymmetric", 20, layer(0.2), 300.0),
        ("axisymmetric", 20, layer(2.0), 3000.0),
    ] {
        let job = json!({"analysis": analysis, "load": {"force": force},
            "upper": {"shape": {"type": "cylinder", "radius": radius}, "material": steel},
            "lower": {"shape": shape, "support": "roller", "material": soft}});
        let (step, slope) = step_and_slope(&job, 0.01);
        let error = step.contact_stiffness / slope - 1.0;
        assert!(error.abs() < 0.01, "{analysis} {shape} {force}: {error:+.4}");
    }
}

/// An end of the contact close behind a corner of the surface, and another one far from it; between these forces the stiffness once had a
/// pole.
#[test]
#[ignore = "full"]
fn ends_on_both_sides_of_a_corner_move_each_by_what_is_beyond_it() {
    let mut job: Value =
        serde_json::from_slice(&std::fs::read("tests/cases/uneven_profile_on_a_layer.json").unwrap())
            .unwrap();
    for force in [537.0, 540.0, 542.8] {
        job["load"] = json!({"force": force});
        let (step, slope) = step_and_slope(&job, 0.03);
        assert_within(step.contact_stiffness, slope, 0.03);
    }
}

/// A rigid punch of 3 mm with rounded edges on a block.
fn rounded_punch(analysis: &str, edge_radius: f64, plasticity: &Value, force: f64) -> Value {
    json!({"analysis": analysis, "load": {"force": force}, "mesh": {"elements_per_half_width": 15},
        "upper": {"shape": {"type": "punch", "width": 3, "edge_radius": edge_radius, "depth": 5},
                  "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 60, "depth": 60},
                  "material": {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": plasticity}}})
}

/// A contact that reaches two elements and more onto a rounded edge grows with the load.
#[test]
fn a_contact_on_two_elements_of_a_rounded_edge_grows() {
    for (elements, tolerance) in [(12, 0.03), (14, 0.03), (20, 0.01)] {
        let job = json!({"analysis": "axisymmetric", "load": {"force": 15_396.7},
            "mesh": {"elements_per_half_width": elements},
            "lower": {"shape": {"type": "punch", "width": 18.464, "edge_radius": 3.6928, "depth": 361.6},
                      "material": {"rigid": true}},
            "upper": {"shape": {"type": "block", "width": 1576, "depth": 637.6},
                      "material": {"young_modulus": 58_962, "poisson_ratio": 0, "plasticity": {"law": "voce",
                          "rate": 6.653, "saturation_stress": 71.978, "yield_stress": 27.293}}}});
        // What 80 elements find.
        assert_within(report(&job).steps[0].contact_stiffness, 21_690.0, tolerance);
    }
}

/// A contact that ends on an edge narrower than an element does not grow with the load, be the edge elastic or about to yield. The
/// bar has what one pair more would change.
#[test]
fn a_contact_that_ends_on_a_narrow_edge_does_not_grow() {
    let perfect = |limit: f64| json!({"law": "bilinear", "yield_stress": limit, "tangent_modulus": 0});
    for (job, yields) in [
        (rounded_punch("plane_stress", 0.103, &perfect(202.6), 200.76), true),
        (rounded_punch("axisymmetric", 0.1, &perfect(15.0), 60.0), true),
        (rounded_punch("axisymmetric", 0.163, &Value::Null, 53.8), false),
        (rounded_punch("plane_stress", 0.101, &Value::Null, 16.8), false),
    ] {
        let (step, slope) = step_and_slope(&job, 0.01);
        assert_eq!(
            step.plasticity
                .lower
                .is_some_and(|body| body.max_equivalent_plastic_strain.is_none_or(|strain| strain > 0.0)),
            yields
        );
        assert_within(step.contact_stiffness, slope, 0.005);
        let bar = step.estimated_error.unwrap().contact_stiffness;
        assert!((0.01..0.1).contains(&bar), "{bar}");
    }
}

/// Two equal cylinders or spheres that a history of loads presses together, with this part of the last one before it.
fn rising_history(analysis: &str, plasticity: &Value, before: &[f64], force: f64) -> Value {
    let body = json!({"shape": {"type": "cylinder", "radius": 20},
        "material": {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": plasticity}});
    let history: Vec<Value> =
        before.iter().chain([&1.0]).map(|part| json!({"force": part * force})).collect();
    json!({"analysis": analysis, "solver": {"theory": "flow"}, "upper": body, "lower": body, "load": {"history": history}})
}

/// Where the contact grows over fresh material, plastic strain stays where it is while the mesh moves.
#[test]
#[ignore = "full"]
fn a_history_at_its_largest_load_is_as_stiff_as_loads_that_differ_tell() {
    let law = |tangent: f64| json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": tangent});
    let ludwik = json!({"law": "ludwik", "yield_stress": 500, "coefficient": 800, "exponent": 0.3});
    let kinematic = json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 0,
        "backstress": [{"modulus": 30_000, "rate": 100}]});
    for (analysis, plasticity, before, force, bound) in [
        ("plane_strain", &law(10_500.0), &[][..], 1089.0, 0.012),
        ("plane_strain", &law(0.0), &[0.5], 1089.0, 0.02),
        ("plane_strain", &kinematic, &[0.5], 1089.0, 0.006),
        ("plane_strain", &ludwik, &[0.6, 0.0], 1089.0, 0.005),
        ("axisymmetric", &law(10_500.0), &[], 3500.0, 0.012),
        ("axisymmetric", &ludwik, &[], 3500.0, 0.01),
    ] {
        let (step, slope) = step_and_slope(&rising_history(analysis, plasticity, before, force), 0.05);
        let error = step.contact_stiffness / slope - 1.0;
        assert!(error.abs() < bound, "{analysis} {plasticity} {before:?}: {error:+.4}");
        let bar = step.estimated_error.unwrap().contact_stiffness;
        let widest = if analysis == "plane_strain" { 0.065 } else { 0.2 };
        assert!(bar > error.abs() && bar < widest, "{analysis} {plasticity}: {bar}");
    }
}

/// The stress that a body has before any load stays with the material too. With the stiffness of the present pairs these were 13 % too
/// low and 15 % too high, the second by 26 % too low where the same approach was prescribed in place of the force.
#[test]
#[ignore = "full"]
fn a_body_with_a_stress_before_the_load_is_as_stiff_as_loads_that_differ_tell() {
    for (name, bound) in
        [("stressed_graded_body_at_its_largest_load", 0.03), ("stressed_layer_pressed_again", 0.055)]
    {
        let text = std::fs::read(format!("tests/cases/{name}.json")).unwrap();
        let mut job: Value = serde_json::from_slice(&text).unwrap();
        let (step, slope) = step_and_slope(&job, 0.1);
        assert_within(step.contact_stiffness, slope, bound);
        *job["load"]["history"].as_array_mut().unwrap().last_mut().unwrap() =
            json!({"approach": step.approach});
        let again = report(&job).steps.pop().unwrap();
        assert_within(again.contact_stiffness, slope, bound);
    }
}

/// Ten elements below a ball that does not harden: the stiffness of the pairs in contact is a quarter of what loads that differ tell,
/// and that of a growing contact below zero.
#[test]
fn a_stiffness_that_the_mesh_does_not_tell_has_a_wide_bar() {
    let law = json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 0});
    let mut job = rising_history("axisymmetric", &law, &[2.0 / 3.0, 0.0], 2205.0);
    job["upper"]["material"] = json!({"rigid": true});
    job["mesh"] = json!({"elements_per_half_width": 10});
    let (step, slope) = step_and_slope(&job, 0.1);
    let bar = step.estimated_error.unwrap().contact_stiffness;
    assert!((step.contact_stiffness / slope - 1.0).abs() < bar && bar >= 1.0, "{bar}");
}

/// Below the largest load of a history the ends of the contact go back, or forth again over what has yielded, and the bodies answer
/// elastically.
#[test]
#[ignore = "full"]
fn a_history_below_its_largest_load_is_as_stiff_as_its_elastic_bodies() {
    let plasticity = json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 4000});
    for (analysis, forces) in [
        ("axisymmetric", &[400.0, 250.0][..]),
        ("plane_strain", &[1500.0, 700.0, 1000.0]),
        ("plane_stress", &[600.0, 400.0]),
    ] {
        let history: Vec<Value> = forces.iter().map(|force| json!({"force": force})).collect();
        let job = json!({"analysis": analysis, "load": {"history": history}, "solver": {"theory": "flow"},
            "mesh": {"elements_per_half_width": 14},
            "upper": {"shape": {"type": "cylinder", "radius": 10}, "material": {"rigid": true}},
            "lower": {"shape": {"type": "block", "width": 60, "depth": 30},
                      "material": {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": plasticity}}});
        // The mesh is that of the largest load, on which the contact has to grow by more than an element to tell its slope.
        let (step, slope) = step_and_slope(&job, 0.1);
        assert_within(step.contact_stiffness, slope, 0.01);
        let bar = step.estimated_error.unwrap().contact_stiffness;
        assert!((0.01..0.06).contains(&bar), "{bar}");
    }
}
