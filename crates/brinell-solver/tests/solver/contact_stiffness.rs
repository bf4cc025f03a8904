//! `contact_stiffness` against differences of the approach between loads that are jobs of their
//! own.

use brinell_solver::report::{Name, StepReport};
use serde_json::{Value, json};

use crate::problems::{assert_within, report};

/// The last step of a job, and dP/dα between last forces that are by so much smaller and larger.
fn step_and_slope(job: &Value, by: f64) -> (StepReport, f64) {
    let at = |factor: f64| {
        let mut job = job.clone();
        job["output"] = json!({"subsurface": false, "contact_stiffness": factor == 1.0});
        let scaled = |force: &Value| json!({"force": factor * force.as_f64().unwrap()});
        if let Some(last) =
            job["load"]["history"].as_array_mut().and_then(|loads| loads.last_mut())
        {
            *last = scaled(&last["force"]);
        } else {
            job["load"] = scaled(&job["load"]["force"]);
        }
        report(&job).steps.pop().unwrap()
    };
    let (below, here, above) = (at(1.0 - by), at(1.0), at(1.0 + by));
    let slope = (above[Name::Force] - below[Name::Force])
        / (above.approach().unwrap() - below.approach().unwrap());
    (here, slope)
}

fn agrees(job: &Value, by: f64, bound: f64) {
    let (step, slope) = step_and_slope(job, by);
    let error = step[Name::ContactStiffness] / slope - 1.0;
    assert!(error.abs() < bound, "{job}: {error:+.4}");
    let bar = step.bar(Name::ContactStiffness).unwrap();
    assert!(bar >= error.abs() && bar <= 0.05, "{job}: {error:+.4}, bar {bar}");
}

fn law(tangent: f64) -> Value {
    json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": tangent})
}

/// Two equal cylinders, discs or balls.
fn pair(analysis: &str, plasticity: &Value, load: &Value) -> Value {
    let body = json!({"shape": {"type": "cylinder", "radius": 20},
        "material": {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": plasticity}});
    json!({"analysis": analysis, "upper": body, "lower": body, "load": load})
}

/// Each job has meshes that end alike at the ends of its contact, so that load-approach curves of
/// jobs of their own are smooth.
#[test]
#[ignore = "full"]
fn jobs_whose_loads_differ_by_a_hundredth_differ_by_the_stiffness() {
    let swift =
        json!({"law": "swift", "yield_stress": 500, "strain_offset": 0.002, "exponent": 0.15});
    for (analysis, plasticity, forces) in [
        ("plane_strain", law(10_000.0), [612.6106, 1089.0855, 1701.696]),
        ("plane_strain", law(0.0), [612.6106, 1089.0855, 1400.0]),
        ("plane_stress", law(10_000.0), [250.0, 400.0, 700.0]),
        ("plane_stress", swift, [250.0, 400.0, 700.0]),
        ("axisymmetric", law(10_000.0), [100.0, 400.0, 1500.0]),
        ("axisymmetric", law(0.0), [100.0, 400.0, 1500.0]),
    ] {
        let bound = if analysis == "plane_stress" { 0.05 } else { 0.02 };
        for force in forces {
            agrees(&pair(analysis, &plasticity, &json!({"force": force})), 0.01, bound);
        }
    }
}

/// Under flow theory the loads of a history before are applied again. Meshes of histories do not
/// end alike, so that it takes loads farther apart to tell.
#[test]
#[ignore = "full"]
fn a_history_at_its_largest_load_is_as_stiff_as_loads_that_differ_tell() {
    let ludwik =
        json!({"law": "ludwik", "yield_stress": 500, "coefficient": 800, "exponent": 0.3});
    for (analysis, plasticity, before, force) in [
        ("plane_strain", law(10_500.0), &[][..], 1089.0),
        ("plane_strain", ludwik.clone(), &[653.0, 0.0], 1089.0),
        ("plane_stress", law(10_500.0), &[], 600.0),
        ("axisymmetric", law(10_500.0), &[], 3500.0),
        ("axisymmetric", ludwik, &[2000.0, 0.0], 3500.0),
    ] {
        let loads: Vec<Value> =
            before.iter().chain([&force]).map(|force| json!({"force": force})).collect();
        let mut job = pair(analysis, &plasticity, &json!({"history": loads}));
        job["solver"] = json!({"theory": "flow"});
        agrees(&job, 0.1, if analysis == "plane_stress" { 0.05 } else { 0.02 });
    }
}

/// On meshes of few elements it is the difference of jobs of their own, in the units of the job;
/// nothing else changes.
#[test]
fn the_stiffness_of_bodies_that_yield_is_there_on_request() {
    for (analysis, force) in
        [("plane_strain", 800.0), ("plane_stress", 500.0), ("axisymmetric", 600.0)]
    {
        let mut job = pair(analysis, &law(10_000.0), &json!({"force": force}));
        job["mesh"] = json!({"elements_per_half_width": 5});
        let (step, slope) = step_and_slope(&job, 0.05);
        assert_within(step[Name::ContactStiffness], slope, 1e-9);
        let silent = report(&job).steps.remove(0);
        assert!(silent.row(Name::ContactStiffness).is_none());
        assert_eq!(silent.approach(), step.approach());
        job["upper"]["material"]["plasticity"]["tangent_modulus"] = json!(0);
        job["output"] = json!({"contact_stiffness": true});
        let perfect = report(&job).steps.remove(0).value(Name::ContactStiffness);
        assert_eq!(perfect.is_none(), analysis == "plane_stress", "{analysis} {perfect:?}");
    }
}

/// The smaller load of a difference is not below what a history has reached before.
#[test]
fn a_history_is_as_stiff_as_histories_that_differ_in_their_last_load() {
    let mut job = pair(
        "plane_strain",
        &law(10_000.0),
        &json!({"history": [{"force": 500}, {"force": 0}, {"force": 510}]}),
    );
    job["mesh"] = json!({"elements_per_half_width": 4});
    job["solver"] = json!({"theory": "flow", "increments": 2});
    job["output"] = json!({"contact_stiffness": true});
    let steps = report(&job).steps;
    let after = |force: f64| {
        let mut job = job.clone();
        job["load"]["history"][2]["force"] = json!(force);
        report(&job).steps.pop().unwrap()
    };
    let (less, more) = (after(500.0), after(1.05 * 510.0));
    let slope = (more[Name::Force] - less[Name::Force])
        / (more.approach().unwrap() - less.approach().unwrap());
    assert_within(steps[2][Name::ContactStiffness], slope, 1e-9);
    assert!(steps[1].row(Name::ContactStiffness).is_none());
    assert!(steps[0][Name::ContactStiffness] > 0.0);
}

/// Elastic cylinders, against loads on meshes that grow with the contact.
#[test]
fn elastic_bodies_always_have_their_stiffness() {
    let (step, slope) =
        step_and_slope(&pair("plane_strain", &Value::Null, &json!({"force": 100})), 0.05);
    assert_within(step[Name::ContactStiffness], slope, 1.5e-3);
}

/// A rigid punch of 3 mm with rounded edges on a block.
fn rounded_punch(analysis: &str, edge_radius: f64, plasticity: &Value, force: f64) -> Value {
    json!({"analysis": analysis, "load": {"force": force}, "mesh": {"elements_per_half_width": 15},
        "upper": {"shape": {"type": "punch", "width": 3, "edge_radius": edge_radius, "depth": 5},
                  "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 60, "depth": 60},
                  "material": {"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": plasticity}}})
}

/// An elastic contact that ends on an edge narrower than an element does not grow with the load.
#[test]
fn a_contact_that_ends_on_a_narrow_edge_does_not_grow() {
    for job in [
        rounded_punch("axisymmetric", 0.163, &Value::Null, 53.8),
        rounded_punch("plane_stress", 0.101, &Value::Null, 16.8),
    ] {
        let (step, slope) = step_and_slope(&job, 0.01);
        assert_within(step[Name::ContactStiffness], slope, 0.005);
    }
}

/// Below the largest load of a history the ends of the contact go back, or forth again over what
/// has yielded, and the bodies answer elastically.
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
        // The mesh is that of the largest load, on which the contact has to grow by more than an
        // element to tell its slope.
        let (step, slope) = step_and_slope(&job, 0.1);
        assert_within(step[Name::ContactStiffness], slope, 0.01);
        let bar = step.bar(Name::ContactStiffness).unwrap();
        assert!((0.005..0.02).contains(&bar), "{bar}");
    }
}
