//! Figures that a mesh does not know are not given, and the answer says why.

use brinell_solver::job::Job;
use brinell_solver::report::{self, RunError, StepReport};
use brinell_solver::solver::{SolveStatus, Unobserved};
use serde_json::{Value, json};

use crate::problems::report;

fn remark<'a>(step: &'a StepReport, code: &str) -> Option<&'a str> {
    step.validity.iter().find(|note| note.code == code).map(|note| note.message.as_str())
}

fn case(text: &str) -> Vec<StepReport> {
    report(&serde_json::from_str(text).unwrap()).steps
}

/// A rigid punch, 4 mm wide, on steel that yields at 500 MPa.
fn punch(analysis: &str, edge_radius: f64, load: &Value) -> StepReport {
    let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3,
        "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10_500}});
    let shape = json!({"type": "punch", "width": 4, "edge_radius": edge_radius, "depth": 5});
    let block = json!({"type": "block", "width": 60, "depth": 40});
    let job = json!({"analysis": analysis, "upper": {"shape": shape, "material": {"rigid": true}},
        "lower": {"shape": block, "material": steel}, "load": load,
        "mesh": {"elements_per_half_width": 10}, "output": {"subsurface": false}});
    report(&job).steps.remove(0)
}

/// Exact forces of first yield by the half-plane's pressure and Flamant's stresses \[N/mm\]; 10 elements find 1065 for 110.
#[test]
fn an_onset_on_a_rounded_edge_is_not_known() {
    for (edge_radius, exact) in [(0.1, 110.3), (0.4, 202.5)] {
        let step = punch("plane_strain", edge_radius, &json!({"onset": true}));
        assert_eq!(step.status, SolveStatus::Converged);
        assert!(step.yield_onset.is_none() && step.estimated_error.is_none());
        let message = remark(&step, "onset_unknown").unwrap();
        let told = message.split("there under ").nth(1).unwrap().split(' ').next().unwrap();
        assert!((told.parse::<f64>().unwrap() / exact - 1.0).abs() < 0.015, "{message} for {exact}");
        // Below and above the force that the closed form tells.
        for (force, is_told) in [(0.9 * exact, false), (1.2 * exact, true)] {
            let step = punch("plane_strain", edge_radius, &json!({"force": force}));
            assert!(!step.plasticity.lower.as_ref().unwrap().yielded);
            assert_eq!(remark(&step, "onset_unknown").is_some(), is_told, "{force}");
        }
    }
    for analysis in ["plane_stress", "axisymmetric"] {
        let step = punch(analysis, 0.4, &json!({"onset": true}));
        assert!(step.yield_onset.is_none() && remark(&step, "onset_unknown").is_some(), "{analysis}");
    }
}

/// 160 elements find 13.88 MPa where 8 find 10.73.
#[test]
fn pressure_next_to_the_end_of_a_flat_by_points_is_told() {
    let steps = case(include_str!("../cases/flat_with_tight_radius_by_points.json"));
    let bar = steps[0].estimated_error.unwrap().peak_pressure;
    assert!((13.88 / steps[0].contact.peak_pressure - 1.0).abs() < bar);
    assert!(remark(&steps[0], "coarse_mesh").is_some_and(|message| message.contains("next to an end")));
}

#[test]
fn a_high_power_of_revolution_on_few_elements_is_told() {
    // 24 elements.
    let exact = [0.12470, 0.048_859, 0.094_330];
    for (step, exact) in
        case(include_str!("../cases/high_power_of_revolution_on_few_elements.json")).iter().zip(exact)
    {
        assert!(
            (exact / step.contact.peak_pressure - 1.0).abs() < step.estimated_error.unwrap().peak_pressure
        );
        assert!(remark(step, "coarse_mesh").is_some_and(|message| message.contains("next to an end")));
    }
}

/// A light load on one ring of nodes: four times the elements find less than half of the approach.
#[test]
fn a_ring_of_few_elements_has_no_bars() {
    let step = &case(include_str!("../cases/ring_of_one_node.json"))[0];
    assert_eq!((step.status, step.estimated_error), (SolveStatus::Converged, None));
    assert!(remark(step, "coarse_mesh").is_some_and(|message| message.contains("a ring of few elements")));
}

/// Cylinders under a load or target.
fn cylinders(tangent_modulus: f64, load: &Value) -> Value {
    let material = json!({"young_modulus": 210_000, "poisson_ratio": 0.3,
        "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": tangent_modulus}});
    let body = json!({"shape": {"type": "cylinder", "radius": 20}, "material": material});
    json!({"analysis": "plane_strain", "upper": body, "lower": body, "load": load,
        "mesh": {"elements_per_half_width": 10}, "output": {"subsurface": false}})
}

#[test]
fn the_largest_strain_of_a_material_that_does_not_harden_is_not_given() {
    let zone = |elements: u32| {
        let mut job = cylinders(0.0, &json!({"force": 1200}));
        job["mesh"]["elements_per_half_width"] = json!(elements);
        let step = report(&job).steps.remove(0);
        let zone = step.plasticity.lower.clone().unwrap();
        assert!(remark(&step, "unbounded_strain").is_some() && step.max_plastic_strain().is_none());
        (zone.max_equivalent_plastic_strain, zone.area, zone.mean_equivalent_plastic_strain)
    };
    let [(largest, area, mean), (_, fine_area, fine_mean)] = [10, 30].map(zone);
    assert!(largest.is_none() && mean > 0.0);
    assert!((area / fine_area - 1.0).abs() < 0.05, "{area} {fine_area}");
    assert!((mean / fine_mean - 1.0).abs() < 0.05, "{mean} {fine_mean}");

    let step = report(&cylinders(2000.0, &json!({"force": 1200}))).steps.remove(0);
    assert!(step.max_plastic_strain().unwrap() > 0.0 && remark(&step, "unbounded_strain").is_none());

    let job = cylinders(0.0, &json!({"target": {"max_plastic_strain": 0.01}}));
    let faults = format!("{:?}", Job::from_value(&job).unwrap_err());
    assert!(faults.contains("/load/target/max_plastic_strain") && faults.contains("no limit"), "{faults}");
}

#[test]
fn a_bilinear_curve_is_said_to_tell_little_of_small_strains() {
    for (strain, is_told) in [(0.002, true), (0.02, false)] {
        let job = cylinders(5000.0, &json!({"target": {"max_plastic_strain": strain}}));
        let report: Result<_, RunError> = report::run(&Job::from_value(&job).unwrap(), &mut Unobserved);
        assert_eq!(remark(&report.unwrap().steps[0], "bilinear_curve").is_some(), is_told, "{strain}");
    }
}
