//! Jobs with spikes, tips, edges and pins that were once missed, smoothed or refused without
//! advice (`tests/shape_cases`): each is answered as a closed form says, or refused with what to
//! do about it.

use std::path::Path;

use brinell_solver::analytical::{HertzLine, PinInHole, PowerIndenter, flat_punch_pressure};
use brinell_solver::job::FieldError;
use brinell_solver::report::{self, Name, StepReport};
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::problems::{assert_within, parse, report};
use crate::rough_traces::{self, TRACES};

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
    assert!(
        fault.detail.contains("\"linear\"") && fault.detail.contains("\"smooth\""),
        "{}",
        fault.detail
    );
}

/// By how much a half-width may be off: 1 %, or the distance of two nodes.
fn assert_half_width(step: &StepReport, expected: f64) {
    let x = &step.contact.nodes.x;
    let spacing = x.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    let error = (step[Name::HalfWidth] - expected).abs();
    assert!(error < (0.01 * expected).max(spacing), "{} for {expected}", step[Name::HalfWidth]);
}

/// Cones and a wedge by points: those of two points are asked about, however blunt; 101 points
/// leave nothing to ask.
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
            assert_within(sharp[Name::MeanPressure], 0.05 * blunt * MODULUS, 1e-2);
            if is_cone {
                assert_within(sharp.approach().unwrap(), indenter.approach(1.0), 3e-3);
            }
        }
    }
    let indenter = PowerIndenter::new(1.0, 0.1, MODULUS);
    let many = step(&case("cone_of_101_points"));
    assert_within(many.approach().unwrap(), indenter.approach(1.0), 3e-3);
    assert_half_width(&many, 1.0);
    assert_within(many[Name::MeanPressure], 0.05 * MODULUS, 1e-2);
}

/// A flat punch by points, elastic, whose flanks have a slope of 100: at the approach α the block
/// touches them up to `1 + α/100`. The column in which the contact ends is 0.0037 wide.
#[test]
fn a_flat_punch_by_points() {
    let job = case("flat_punch_elastic");
    let force = job["load"]["force"].as_f64().unwrap();
    for job in [job.clone(), straight(job)] {
        let step = step(&job);
        let on_flank = 0.01 * step.approach().unwrap();
        assert_within(step[Name::HalfWidth], 1.0 + on_flank, 1e-3);
        let nodes = &step.contact.nodes;
        let middle = nodes.x.iter().position(|x| x.abs() < 1e-9).unwrap();
        assert_within(nodes.pressure[middle], flat_punch_pressure(force, 1.0, 0.0), 5e-3);
        assert_eq!(codes(&step), ["sharp_corner"]);
    }
}

/// Punches on perfectly plastic blocks: at nine tenths of the limit load, at Prandtl's, and 2 %
/// beyond it.
#[test]
fn punches_near_their_limit() {
    for name in ["circular_punch_near_its_limit", "flat_punch_at_its_limit"] {
        let step = step(&case(name));
        let on_flank = 0.01 * step.approach().unwrap();
        assert_within(step[Name::HalfWidth], 1.0 + on_flank, 1e-3);
        assert_eq!(codes(&step), ["large_strain", "deformation_theory", "unbounded_strain"]);
        // So near its limit a block gives way for small changes of its mesh, and the bar says so.
        assert!(step.bar(Name::Approach).unwrap() > 0.1);
    }
    let beyond = report(&case("flat_punch_beyond_its_limit"));
    assert_eq!(beyond.status, SolveStatus::NotConverged);
    assert!(
        codes(&beyond.steps[0]).contains(&"collapse")
            && beyond.steps[0].bar(Name::PeakPressure).is_none()
    );
}

/// A pin in a groove of nearly its own radius is refused or remarked upon, and both times sent to
/// `hole`, where it has the half-angle and the pressure of Persson's contact.
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
            notes
                .filter(|note| note.code == "wide_contact")
                .map(|note| note.message.clone())
                .collect()
        };
        assert!(advice.contains("`hole`"), "{advice}");
        let force = job["load"]["force"].as_f64().unwrap();
        let clearance: f64 = clearance.parse().unwrap();
        job["lower"]["shape"] =
            json!({"type": "hole", "radius": 10.0 + clearance, "outer_radius": 100.0});
        let found = step(&job);
        let persson = PinInHole::of_clearance_ratio(MODULUS * clearance / force);
        assert_within(found[Name::HalfAngle], persson.half_angle().to_degrees(), 1e-2);
        let peak = persson.peak_pressure_ratio() * force / 10.0;
        assert_within(found[Name::PeakPressure], peak, 1e-2);
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
    assert_within(step(&job)[Name::HalfWidth], 5.0, 1e-9);
}

/// What no force will find is said by the check before the solve: elastic bodies have no onset of
/// yield, and a pin that fills its groove has no contact that ends.
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
    assert!(
        faults.len() == 2 && faults.iter().all(|fault| fault.detail.contains("`hole`")),
        "{faults:?}"
    );
}

/// A blunt wedge meets a narrower groove at its own ends.
#[test]
fn surfaces_that_meet_at_their_ends_are_refused_for_their_ends() {
    let steel = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3});
    let job = json!({"analysis": "plane_strain", "load": {"force": 100.0},
        "upper": {"shape": {"type": "groove", "radius": 36.0, "width": 14.0, "depth": 56.0},
                  "material": steel},
        "lower": {"shape": {"type": "wedge", "angle": 0.16, "width": 8.7, "depth": 42.0},
                  "material": steel}});
    let faults = report::preflight(&parse(&job)).unwrap_err();
    assert!(faults.iter().all(|fault| fault.detail.contains("first touch at x = 4.35 mm")));
}

/// What a search costs is estimated by the force from which it begins.
#[test]
fn searches_cost_what_was_estimated() {
    let steel = |yield_stress: f64| {
        json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3,
            "plasticity": {"law": "bilinear", "yield_stress": yield_stress,
                "tangent_modulus": 2100.0}})
    };
    let roller = json!({"shape": {"type": "cylinder", "radius": 10.0}, "material": steel(500.0)});
    let hole = json!({"shape": {"type": "hole", "radius": 10.05, "outer_radius": 50.0},
        "material": steel(700.0)});
    let block = json!({"shape": {"type": "block", "width": 80.0, "depth": 40.0},
        "material": steel(700.0)});
    for lower in [hole, block] {
        for load in [
            json!({"onset": true}),
            json!({"target": {"peak_pressure": 800.0}}),
            json!({"target": {"max_plastic_strain": 1e-3}}),
        ] {
            let job = json!({"analysis": "plane_strain", "load": load, "upper": roller,
                "lower": lower,
                "mesh": {"elements_per_half_width": 10}});
            let estimate = report::preflight(&parse(&job)).unwrap().equations as f64;
            let found = report(&job).mesh.equations as f64;
            assert!(
                found < 2.0 * estimate && estimate < 2.0 * found,
                "{estimate} for {found}: {job}"
            );
        }
    }
}

/// Both edges of a punch touch a groove first, and all between them at the end.
#[test]
fn a_punch_in_a_groove_costs_what_was_estimated() {
    for (analysis, force) in
        [("plane_strain", 20.0), ("plane_strain", 150.0), ("plane_stress", 150.0)]
    {
        let job = json!({"analysis": analysis, "load": {"force": force},
            "mesh": {"elements_per_half_width": 12},
            "upper": {"shape": {"type": "punch", "width": 0.177, "depth": 10.0,
                "edge_radius": 0.0014}, "material": {"rigid": true}},
            "lower": {"shape": {"type": "groove", "radius": 15.0, "width": 20.0, "depth": 30.0},
                "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3}}});
        let estimate = report::preflight(&parse(&job)).unwrap().equations as f64;
        let found = report(&job).mesh.equations as f64;
        assert!(
            found < 3.0 * estimate && estimate < 3.0 * found,
            "{estimate} for {found}: {analysis} {force}"
        );
    }
}

/// A sphere far beyond full plasticity would sink in by two thirds of its radius.
#[test]
fn a_ball_that_would_sink_in_is_refused() {
    let fault = refused(&case("ball_far_beyond_full_plasticity"));
    assert_eq!(fault.pointer, "/load");
    assert!(fault.detail.contains("reduce the load"), "{}", fault.detail);
}

/// Spikes 0.01 mm high, half a micrometre to a tenth of a millimetre to each side of their tips,
/// on and off the samples of any search: asked about; straight, they touch with their tips as
/// wedges do and nowhere else, or are refused as too steep.
#[test]
fn spikes_are_found_wherever_they_stand() {
    for half in [0.5, 0.1, 0.01, 0.002, 0.0005] {
        for at in [0.0, 3.001_23] {
            let shift = if half > 0.1 { "_shift" } else { "" };
            let elements = if half > 0.1 { "_n10" } else { "" };
            let job = case(&format!("asperity{shift}_w{half}_x{at}{elements}"));
            assert_corner_is_asked_about(&job);
            if half < 0.01 {
                let fault = refused(&straight(job));
                assert_eq!(fault.pointer, "/upper/shape/points");
                assert!(fault.detail.contains("slope"), "{}", fault.detail);
                continue;
            }
            let step = step(&straight(job));
            let slope: f64 = 0.01 / half;
            // Both bodies give way; a spike is no half-plane, but on its slopes of 2 and 10 %
            // nearly.
            let expected = 5.0 / (0.5 * MODULUS * slope);
            assert_within(step[Name::HalfWidth], expected, if slope > 0.5 { 0.1 } else { 1e-2 });
            assert!((step.peak_position() - at).abs() < expected);
            let ends = [step.contact.nodes.x[0], *step.contact.nodes.x.last().unwrap()];
            assert!(ends.iter().all(|x| (x - at).abs() < 10.0 * expected), "{ends:?}");
            assert_eq!(codes(&step).contains(&"wide_contact"), slope > 0.15);
        }
    }
}

/// The same contact, shifted by micrometres beside the samples, has the same approach at both
/// densities: of a tip to 1e-4, of one that is rounded off between its points, so that these shape
/// it, to 2e-3.
#[test]
#[ignore = "full"]
fn a_shift_does_not_change_the_approach() {
    for elements in [10, 40] {
        for (interpolation, tolerance) in [("linear", 1e-4), ("smooth", 2e-3)] {
            let at = |half: f64, x: f64| {
                let mut job = case(&format!("asperity_shift_w{half}_x{x}_n{elements}"));
                assert_corner_is_asked_about(&job);
                job["upper"]["shape"]["interpolation"] = json!(interpolation);
                step(&job)
            };
            let reference = at(0.1, 3.0);
            for x in [3.001_23, 3.0025, 3.004] {
                let shifted = at(0.1, x);
                assert_within(
                    shifted.approach().unwrap(),
                    reference.approach().unwrap(),
                    tolerance,
                );
                assert_within(shifted[Name::HalfWidth], reference[Name::HalfWidth], 2e-3);
                assert!((shifted.peak_position() - x).abs() < 0.01);
            }
            let at = |half: f64, x: f64| at(half, x).approach().unwrap();
            let reference = reference.approach().unwrap();
            // In the middle of its body it stands a little stiffer, whatever the spike.
            let [sharp, blunt] = [0.1, 0.5].map(|half| at(half, 3.001_23) - at(half, 0.0));
            assert!(sharp > 0.0 && sharp < 1e-2 * reference);
            assert_within(blunt, sharp, 0.1);
        }
    }
}

/// A rigid face with two summits, one lower by 1e-6 mm, under an approach that brings both into
/// contact: found together, instead of by ever wider zones of elements for one of them.
#[test]
fn summits_of_nearly_one_height_are_found_together() {
    let job = case("two_summits_of_nearly_one_height");
    let found = report(&job);
    let estimate = report::preflight(&parse(&job)).unwrap().equations as f64;
    assert_within(found.mesh.equations as f64, estimate, 0.3);
    assert!(found.mesh.passes <= 5 && found.mesh.equations < 150_000, "{:?}", found.mesh);
    let step = &found.steps[0];
    assert_eq!(step.status, SolveStatus::Converged);
    let patches = &step.contact.patches;
    assert_eq!(patches.len(), 2);
    assert!(patches[0].right < -0.4 && patches[1].left > 0.4);
    assert!(codes(step).contains(&"coarse_mesh"));
}

/// A spike with flanks of 280 % on a body that deforms is refused before it is solved, whatever
/// the material and the theory.
#[test]
fn a_steep_spike_is_refused_of_every_material() {
    let plastic = case("spike_of_slope_3");
    let mut elastic = plastic.clone();
    elastic["upper"]["material"].as_object_mut().unwrap().remove("plasticity");
    let mut flow = plastic.clone();
    flow["solver"] = json!({"theory": "flow"});
    for job in [plastic, elastic, flow] {
        let fault = refused(&job);
        assert_eq!(fault.pointer, "/upper/shape/points");
        assert!(fault.detail.contains("slope of 2.8"), "{}", fault.detail);
    }
}

fn rough(trace: (usize, f64, usize)) -> Value {
    let steel = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3});
    json!({"analysis": "plane_strain", "load": {"force": 300.0},
        "mesh": {"elements_per_half_width": 20},
        "upper": {"shape": {"type": "profile", "points": rough_traces::trace(trace),
            "depth": 20.0}, "material": steel},
        "lower": {"shape": {"type": "block", "width": 60.0, "depth": 30.0}, "material": steel}})
}

/// The traces are those that were reported, number for number.
#[test]
fn rough_traces_are_those_that_were_reported() {
    let reported = [
        (-1.000_117_884_175_123, -1.000_021_418_083_851_4, -668_337.286_471_021_1),
        (-1.000_022_881_043_371_3, -0.999_860_977_734_771_7, -10_673_355.335_271_487),
        (-1.000_507_421_640_317_8, -1.000_797_282_579_779_7, -10_673_562.225_617_686),
    ];
    for (trace, (first, last, sum)) in TRACES.into_iter().zip(reported) {
        let heights: Vec<f64> =
            rough_traces::trace(trace).into_iter().map(|[_, height]| height).collect();
        assert_within(heights[0], first, 1e-15);
        assert_within(heights[heights.len() - 1], last, 1e-15);
        let weighted: f64 =
            heights.iter().enumerate().map(|(k, height)| (k + 1) as f64 * height).sum();
        assert_within(weighted, sum, 1e-14);
    }
}

/// What a rough trace costs is known before it is solved, and by how much the mesh is too coarse
/// for its summits afterwards.
#[test]
#[ignore = "full"]
fn rough_traces_cost_what_was_estimated() {
    let [first, second, third] = TRACES.map(rough);
    let expected = report::preflight(&parse(&first)).unwrap().equations as f64;
    let found = report(&first);
    assert_within(found.mesh.equations as f64, expected, 0.1);
    let step = &found.steps[0];
    assert_eq!(step.status, SolveStatus::Converged);
    // Half-planes under Hertz's parabola are 0.408 mm wide to each side, and the summits reach
    // farther.
    let hertz = HertzLine::new(300.0, 50.0, 0.5 * MODULUS);
    assert!(
        step[Name::HalfWidth] > hertz.half_width()
            && step[Name::HalfWidth] < 1.2 * hertz.half_width()
    );
    assert!(
        step[Name::PeakPressure] > 2.0 * hertz.peak_pressure() && step.contact.patches.len() > 10
    );
    assert_eq!(codes(step), ["coarse_mesh"]);
    // Of points a quarter as far apart.
    assert_corner_is_asked_about(&third);
    for job in [second, straight(third)] {
        let equations = report::preflight(&parse(&job)).unwrap().equations;
        assert!((3_000_000..5_000_000).contains(&equations), "{equations}");
    }
}
