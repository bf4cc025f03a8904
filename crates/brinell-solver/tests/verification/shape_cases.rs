//! Jobs with spikes, tips, edges and pins that were once missed, smoothed or refused without advice (`tests/shape_cases`): each is
//! answered as a closed form says, or refused with what to do about it.

use std::path::Path;

use brinell_solver::analytical::{PinInHole, PowerIndenter, flat_punch_pressure};
use brinell_solver::job::FieldError;
use brinell_solver::report::{self, StepReport};
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::problems::{assert_within, parse, report};

const MODULUS: f64 = 210_000.0 / 0.91;

fn case(name: &str) -> Value {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/shape_cases");
    let text = std::fs::read_to_string(folder.join(format!("{name}.json"))).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn straight(mut job: Value) -> Value {
    job["upper"]["shape"]["interpolation"] = json!("linear");
    job
}

fn step(job: &Value) -> StepReport {
    let step = report(job).steps.remove(0);
    assert_eq!(step.status, SolveStatus::Converged, "{:?}", step.validity);
    step
}

/// The one error that a job is refused with, before it is solved.
fn refused(job: &Value) -> FieldError {
    let mut faults = report::preflight(&parse(job)).unwrap_err();
    assert_eq!(faults.len(), 1, "{faults:?}");
    faults.remove(0)
}

fn codes(step: &StepReport) -> Vec<&str> {
    step.validity.iter().map(|note| note.code.as_str()).collect()
}

/// Refused for a corner in the contact, with both ways out in words.
fn assert_corner_is_asked_about(job: &Value) {
    let fault = refused(job);
    assert_eq!(fault.pointer, "/upper/shape/interpolation");
    assert!(fault.detail.contains("\"linear\"") && fault.detail.contains("\"smooth\""), "{}", fault.detail);
}

/// By how much a half-width may be off: 1 %, or the distance of two nodes.
fn assert_half_width(step: &StepReport, expected: f64) {
    let x = &step.contact.nodes.x;
    let spacing = x.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    let error = (step.contact.half_width - expected).abs();
    assert!(error < (0.01 * expected).max(spacing), "{} for {expected}", step.contact.half_width);
}

/// Cones and a wedge by points: those of two points are asked about, however blunt; 101 points leave nothing to ask.
#[test]
fn cones_and_wedges_by_points() {
    for blunt in [1.0, 0.2, 0.02] {
        let indenter = PowerIndenter::new(1.0, 0.1 * blunt, MODULUS);
        for name in ["cone_of_two_points", "wedge_of_two_points"] {
            let mut job = case(name);
            job["upper"]["shape"]["points"][1][1] = json!(-blunt);
            let is_cone = name.starts_with("cone");
            let force = if is_cone { indenter.force(1.0) } else { indenter.line_force(1.0) };
            job["load"]["force"] = json!(force);
            assert_corner_is_asked_about(&job);
            let sharp = step(&straight(job));
            assert_half_width(&sharp, 1.0);
            assert_within(sharp.contact.mean_pressure, 0.05 * blunt * MODULUS, 1e-2);
            if is_cone {
                assert_within(sharp.approach, indenter.approach(1.0), 3e-3);
            }
        }
    }
    let indenter = PowerIndenter::new(1.0, 0.1, MODULUS);
    let many = step(&case("cone_of_101_points"));
    assert_within(many.approach, indenter.approach(1.0), 3e-3);
    assert_half_width(&many, 1.0);
    assert_within(many.contact.mean_pressure, 0.05 * MODULUS, 1e-2);
}

/// A flat punch by points, elastic, whose flanks have a slope of 100: at the approach α the block touches them up to
/// `1 + α/100`.
#[test]
fn a_flat_punch_by_points() {
    let job = case("flat_punch_elastic");
    let force = job["load"]["force"].as_f64().unwrap();
    for job in [job.clone(), straight(job)] {
        let step = step(&job);
        let on_flank = 0.01 * step.approach;
        assert_within(step.contact.half_width, 1.0 + on_flank, 1e-4);
        let nodes = &step.contact.nodes;
        let middle = nodes.x.iter().position(|x| x.abs() < 1e-9).unwrap();
        assert_within(nodes.pressure[middle], flat_punch_pressure(force, 1.0, 0.0), 5e-3);
        assert_eq!(codes(&step), ["sharp_corner"]);
    }
}

/// Punches on perfectly plastic blocks: at nine tenths of the limit load, at Prandtl's, and 2 % beyond it.
#[test]
fn punches_near_their_limit() {
    for name in ["circular_punch_near_its_limit", "flat_punch_at_its_limit"] {
        let step = step(&case(name));
        assert_within(step.contact.half_width, 1.0, 1e-3);
        assert_eq!(codes(&step), ["large_strain", "deformation_theory"]);
        // So near its limit a block gives way for small changes of its mesh, and the bar says so.
        assert!(step.estimated_error.unwrap().approach > 0.1);
    }
    let beyond = report(&case("flat_punch_beyond_its_limit"));
    assert_eq!(beyond.status, SolveStatus::NotConverged);
    assert!(codes(&beyond.steps[0]).contains(&"collapse") && beyond.steps[0].estimated_error.is_none());
}

/// A pin in a groove of nearly its own radius is refused or remarked upon, and both times sent to `hole`, where it has the
/// half-angle and the pressure of Persson's contact.
#[test]
fn pins_in_grooves_are_sent_to_holes() {
    for clearance in ["0.02", "0.05", "0.2"] {
        let mut job = case(&format!("pin_in_groove_clearance_{clearance}"));
        let advice = if clearance == "0.02" {
            let fault = refused(&job);
            assert_eq!(fault.pointer, "/load");
            fault.detail
        } else {
            let step = step(&job);
            let notes = step.validity.iter();
            notes.filter(|note| note.code == "wide_contact").map(|note| note.message.clone()).collect()
        };
        assert!(advice.contains("`hole`"), "{advice}");
        let force = job["load"]["force"].as_f64().unwrap();
        let clearance: f64 = clearance.parse().unwrap();
        job["lower"]["shape"] = json!({"type": "hole", "radius": 10.0 + clearance, "outer_radius": 100.0});
        let found = step(&job);
        let persson = PinInHole::of_clearance_ratio(MODULUS * clearance / force);
        assert_within(found.contact.half_angle.unwrap(), persson.half_angle().to_degrees(), 1e-2);
        let peak = persson.peak_pressure_ratio() * force / 10.0;
        assert_within(found.contact.peak_pressure, peak, 1e-2);
    }
}

/// A radius that no mesh resolves is refused at its field, and the sharp punch is solved.
#[test]
fn a_radius_that_no_mesh_resolves_is_refused() {
    let steel = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3});
    let mut job = json!({"analysis": "plane_strain", "load": {"force": 1000.0},
        "upper": {"shape": {"type": "punch", "width": 10.0, "edge_radius": 1e-5, "depth": 10.0},
                  "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 80.0, "depth": 40.0}, "material": steel}});
    let fault = refused(&job);
    assert_eq!(fault.pointer, "/upper/shape/edge_radius");
    assert!(fault.detail.contains("leave out a radius"), "{}", fault.detail);
    job["upper"]["shape"]["edge_radius"] = json!(0.0);
    assert_within(step(&job).contact.half_width, 5.0, 1e-9);
}

/// What no force will find is said by the check before the solve: elastic bodies have no onset of yield, and a pin that fills
/// its groove has no contact that ends.
#[test]
fn searches_without_an_end_are_refused_before_they_begin() {
    let mut job = case("pin_in_groove_clearance_0.2");
    job["load"] = json!({"onset": true});
    assert_eq!(refused(&job).pointer, "/load/onset");
    job["lower"]["material"]["plasticity"] =
        json!({"law": "bilinear", "yield_stress": 300.0, "tangent_modulus": 0.0});
    report::preflight(&parse(&job)).unwrap();
    job["lower"]["shape"]["radius"] = json!(10.0);
    let faults = report::preflight(&parse(&job)).unwrap_err();
    assert!(faults.len() == 2 && faults.iter().all(|fault| fault.detail.contains("`hole`")), "{faults:?}");
}

/// A sphere far beyond full plasticity would sink in by two thirds of its radius.
#[test]
fn a_ball_that_would_sink_in_is_refused() {
    let fault = refused(&case("ball_far_beyond_full_plasticity"));
    assert_eq!(fault.pointer, "/load");
    assert!(fault.detail.contains("reduce the load"), "{}", fault.detail);
}

/// A spike 0.01 mm high on a crest, `half` of its base to each side; even points 0.25 mm apart beside it.
fn spike(at: f64, half: f64, crest: impl Fn(f64) -> f64) -> Value {
    let mut x: Vec<f64> = (-40..=40).map(|k| 0.25 * f64::from(k)).chain([at - half, at, at + half]).collect();
    x.sort_by(f64::total_cmp);
    x.dedup();
    let height = |x: f64| crest(x) + 0.01 * (1.0 - (x - at).abs() / half).max(0.0);
    let points: Vec<[f64; 2]> = x.into_iter().map(|x| [x, height(x)]).collect();
    let steel = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3});
    json!({"analysis": "plane_strain", "load": {"force": 5.0}, "mesh": {"elements_per_half_width": 10},
        "upper": {"shape": {"type": "profile", "points": points, "depth": 20.0}, "material": steel},
        "lower": {"shape": {"type": "block", "width": 60.0, "depth": 30.0}, "material": steel}})
}

/// Spikes of 1 µm to 1 mm, on and off the samples of any search: asked about; straight, they touch with their tips as wedges do
/// and nowhere else, or are refused as too steep.
#[test]
fn spikes_are_found_wherever_they_stand() {
    for half in [0.5, 0.1, 0.01, 0.002, 0.0005] {
        for at in [0.0, 3.001_23] {
            let job = spike(at, half, |x| -1e-5 * x * x);
            assert_corner_is_asked_about(&job);
            if half < 0.01 {
                let fault = refused(&straight(job));
                assert_eq!(fault.pointer, "/upper/shape/points");
                assert!(fault.detail.contains("slope"), "{}", fault.detail);
                continue;
            }
            let step = step(&straight(job));
            let slope: f64 = 0.01 / half;
            // Both bodies give way; a spike is no half-plane, but on its slopes of 2 and 10 % nearly.
            let expected = 5.0 / (0.5 * MODULUS * slope);
            assert_within(step.contact.half_width, expected, if slope > 0.5 { 0.1 } else { 1e-2 });
            assert!((step.contact.peak_position - at).abs() < expected);
            let ends = [step.contact.nodes.x[0], *step.contact.nodes.x.last().unwrap()];
            assert!(ends.iter().all(|x| (x - at).abs() < 10.0 * expected), "{ends:?}");
            assert_eq!(codes(&step).contains(&"wide_contact"), slope > 0.15);
        }
    }
}

/// The same contact, shifted by micrometres beside the samples, has the same approach: to 1e-4, at both densities.
#[test]
fn a_shift_does_not_change_the_approach() {
    for elements in [10, 40] {
        let at = |x: f64| {
            let mut job = straight(spike(x, 0.1, |s| -1e-6 * (s - x) * (s - x)));
            job["mesh"]["elements_per_half_width"] = json!(elements);
            step(&job).approach
        };
        let reference = at(3.0);
        for x in [3.001_23, 3.0025, 3.004] {
            assert_within(at(x), reference, 1e-4);
        }
        if elements == 10 {
            continue;
        }
        // In the middle of its body it stands a little stiffer.
        assert_within(at(0.0), reference, 1e-2);
    }
}
