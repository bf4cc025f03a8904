//! A pin in a hole of nearly its own radius, and a ball in a socket: Persson's contact in an
//! infinite plate, Hertz's where the contact is narrow, and what holds of both.

use std::f64::consts::PI;

use brinell_solver::analytical::{HertzLine, HertzPoint, PinInHole, YieldOnset};
use brinell_solver::report::{Name, Side, StepReport};
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::problems::{assert_peak, assert_width, assert_within, report, solve};

const YOUNG: f64 = 210_000.0;
const RADIUS: f64 = 10.0;
const CLEARANCE: f64 = 0.01;
/// `E₁*` of one body in plane strain.
const MODULUS: f64 = YOUNG / 0.91;

fn steel() -> Value {
    json!({"young_modulus": YOUNG, "poisson_ratio": 0.3})
}

fn pin(hole: &Value, load: &Value) -> Value {
    json!({"analysis": "plane_strain", "load": load,
        "upper": {"shape": {"type": "cylinder", "radius": RADIUS}, "material": steel()},
        "lower": {"shape": hole, "material": steel()}})
}

/// In a plate that is 20 pin radii wide.
fn plate(clearance: f64) -> Value {
    json!({"type": "hole", "radius": RADIUS + clearance, "outer_radius": 10.0 * RADIUS})
}

fn step(job: &Value) -> StepReport {
    let step = report(job).steps.remove(0);
    assert_eq!(step.status, SolveStatus::Converged, "{:?}", step.validity);
    step
}

fn persson(degrees: f64) -> (PinInHole, f64) {
    let pin = PinInHole::of_half_angle(degrees.to_radians());
    (pin, MODULUS * CLEARANCE / pin.clearance_ratio())
}

/// Persson's table at the default mesh: the half-angle and the peak pressure of a force, within 1
/// % in a plate 20 pin radii wide, round or square. The angle of the pressure that is found has
/// Persson's peak as well.
#[test]
fn pins_of_persson() {
    let square = json!({"type": "hole", "radius": RADIUS + CLEARANCE, "width": 20.0 * RADIUS});
    for degrees in [5.0, 20.0, 45.0, 60.0, 75.0] {
        let (expected, force) = persson(degrees);
        for hole in [&plate(CLEARANCE), &square] {
            let step = step(&pin(hole, &json!({"force": force})));
            let angle = step[Name::HalfAngle];
            assert_within(angle, degrees, 1e-2);
            assert_within(
                step[Name::PeakPressure] * RADIUS / force,
                expected.peak_pressure_ratio(),
                1e-2,
            );
            let found = PinInHole::of_half_angle(angle.to_radians());
            assert_within(
                step[Name::PeakPressure] * RADIUS / force,
                found.peak_pressure_ratio(),
                1e-2,
            );
            assert_within(step[Name::HalfWidth], angle.to_radians() * RADIUS, 1e-3);
            let chord = 2.0 * RADIUS * angle.to_radians().sin();
            assert_within(step[Name::MeanPressure], force / chord, 1e-3);
            assert!(
                step.validity.is_empty() && step.elastic(Name::PeakPressure).is_none(),
                "{:?}",
                step.validity
            );
            // From end to end the pressure is Persson's.
            for (s, p) in step.contact.nodes.x.iter().zip(&step.contact.nodes.pressure) {
                let pressure = expected.pressure_ratio(s / RADIUS) * force / RADIUS;
                if s.abs() < 0.9 * step[Name::HalfWidth] {
                    assert!(
                        (p - pressure).abs() < 1.5e-2 * step[Name::PeakPressure],
                        "{s}: {p} {pressure}"
                    );
                }
            }
        }
    }
}

/// A plate that is narrow holds its hole: the contact is narrower, by 3 % where it is 6 radii
/// wide (43.54° with 14 to 80 elements).
#[test]
fn a_narrow_plate_has_a_narrow_contact() {
    let (_, force) = persson(45.0);
    let angle = |outer: f64| {
        let hole = json!({"type": "hole", "radius": RADIUS + CLEARANCE, "outer_radius": outer});
        step(&pin(&hole, &json!({"force": force})))[Name::HalfAngle]
    };
    assert_within(angle(300.0), 45.0, 1.5e-3);
    assert_within(angle(30.0), 43.54, 1e-3);
}

/// A narrow contact is Hertz's whatever the clearance: plane strain, plane stress, a ball in its
/// socket.
#[test]
fn narrow_contacts_are_of_hertz() {
    for clearance in [0.1, 10.0] {
        let radius = RADIUS * (RADIUS + clearance) / clearance;
        for (analysis, modulus) in [("plane_strain", 0.5 * MODULUS), ("plane_stress", 0.5 * YOUNG)]
        {
            let hertz =
                HertzLine::from_peak_pressure(0.02 * modulus * RADIUS / radius, radius, modulus);
            let mut job = pin(&plate(clearance), &json!({"force": hertz.force()}));
            job["lower"]["shape"]["outer_radius"] = json!(40.0 * RADIUS);
            job["analysis"] = json!(analysis);
            let step = step(&job);
            assert_peak(&step, hertz.peak_pressure());
            assert_width(&step, hertz.half_width());
        }
        let hertz = HertzPoint::new(20.0 * 0.1 / clearance, radius, 0.5 * MODULUS);
        let mut job = pin(&plate(clearance), &json!({"force": hertz.force()}));
        job["analysis"] = json!("axisymmetric");
        let step = step(&job);
        assert_peak(&step, hertz.peak_pressure());
        assert_width(&step, hertz.contact_radius());
    }
}

/// Forces along the normals add up to the load, and the slope of the load-approach curve is the
/// stiffness.
#[test]
fn a_pin_is_in_equilibrium() {
    let stiffness_and = |force: f64| {
        let solution = solve(&pin(&plate(CLEARANCE), &json!({"force": force}))).steps.remove(0);
        let vertical: f64 =
            solution.field.pairs.iter().map(|pair| pair.force * (pair.x / 10.005).cos()).sum();
        let on_axis = solution.field.pairs[0].force;
        assert_within(2.0 * vertical - on_axis, force, 1e-5);
        (solution.contact_stiffness.unwrap(), solution.figures.approach)
    };
    let (_, force) = persson(60.0);
    let (stiffness, _) = stiffness_and(force);
    let ((_, below), (_, above)) = (stiffness_and(0.95 * force), stiffness_and(1.05 * force));
    assert_within(stiffness, 0.1 * force / (above - below), 5e-3);
}

/// What is upper and what is lower makes no difference; force and approach ask for the same state;
/// so do both contact methods and all couplings.
#[test]
#[ignore = "full"]
fn the_same_pin_however_it_is_asked_for() {
    let mut job = pin(&plate(0.1), &json!({"force": 6000.0}));
    for side in ["upper", "lower"] {
        job[side]["material"]["plasticity"] =
            json!({"law": "bilinear", "yield_stress": 300.0, "tangent_modulus": 4000.0});
    }
    let reference = step(&job);
    assert!(reference.body(Name::MaxPlasticStrain, Side::Lower) > Some(0.0));
    let mut others = Vec::new();
    for (member, value) in [
        ("coupling", json!("strong")),
        ("coupling", json!("weak")),
        ("coupling", json!("secant_stiffness")),
        ("contact", json!("simplex")),
    ] {
        let mut other = job.clone();
        other["solver"] = json!({member: value, "max_iterations": 500});
        others.push(other);
    }
    let mut swapped = job.clone();
    swapped["upper"] = job["lower"].clone();
    swapped["lower"] = job["upper"].clone();
    others.push(swapped);
    for other in &others {
        let step = step(other);
        assert_within(step[Name::PeakPressure], reference[Name::PeakPressure], 1e-5);
        assert_within(step.approach().unwrap(), reference.approach().unwrap(), 1e-4);
    }
    job["load"] = json!({"approach": reference.approach()});
    assert_within(step(&job)[Name::Force], 6000.0, 5e-3);
}

/// Under a narrow contact yield begins where it does under Hertz's.
#[test]
fn onset_of_a_pin() {
    let clearance = RADIUS;
    let mut job = pin(&plate(clearance), &json!({"onset": true}));
    for side in ["upper", "lower"] {
        job[side]["material"]["plasticity"] =
            json!({"law": "bilinear", "yield_stress": 300.0, "tangent_modulus": 4000.0});
    }
    let step = step(&job);
    let place = step.row(Name::Force).unwrap().place.unwrap();
    let radius = RADIUS * (RADIUS + clearance) / clearance;
    let expected = YieldOnset::line_von_mises(0.3).line_force(300.0, radius, 0.5 * MODULUS);
    // The half-width is 2 % of the pin's radius, and the stress across the pin P/πR beside p0 =
    // 2P/πa.
    assert_within(step[Name::Force], expected, 4e-2);
    let a = (4.0 * expected * radius / (PI * 0.5 * MODULUS)).sqrt();
    assert_within(place.depth, 0.7 * a, 8e-2);
    assert!(place.x < 0.1 * a);
}

/// Flow theory goes through the same contact conditions: a dent is left, and an elastic pin comes
/// back.
#[test]
fn pins_are_unloaded() {
    let mut job = pin(&plate(0.1), &json!({"history": [{"force": 6000.0}, {"force": 0.0}]}));
    job["solver"] = json!({"theory": "flow"});
    job["mesh"] = json!({"elements_per_half_width": 10});
    let elastic = report(&job);
    assert!(
        elastic.steps[1].approach().unwrap().abs() < 1e-9 * elastic.steps[0].approach().unwrap()
    );
    for side in ["upper", "lower"] {
        job[side]["material"]["plasticity"] =
            json!({"law": "bilinear", "yield_stress": 300.0, "tangent_modulus": 4000.0});
    }
    let plastic = report(&job);
    let (loaded, unloaded) = (&plastic.steps[0], &plastic.steps[1]);
    assert_eq!(unloaded.status, SolveStatus::Converged);
    let dents = Side::BOTH.map(|side| unloaded.body(Name::DentDepth, side).unwrap());
    let dent: f64 = dents.iter().sum();
    assert!(
        unloaded.approach().unwrap() > 0.05 * loaded.approach().unwrap()
            && dent > 0.5 * unloaded.approach().unwrap(),
        "{dent}"
    );
    // The work of the closed cycle is what was dissipated and what residual stresses store.
    assert!(unloaded[Name::DissipatedWork] > 0.0);
    assert!(unloaded[Name::ElasticEnergy] < 0.2 * unloaded[Name::Work]);
}

/// Figures in metres and pascals are the same pin.
#[test]
fn a_pin_in_si() {
    let job = pin(&plate(CLEARANCE), &json!({"force": 800.0}));
    let mut si = job.clone();
    si["units"] = json!("SI");
    si["load"]["force"] = json!(800_000.0);
    si["upper"]["shape"]["radius"] = json!(0.01);
    si["lower"]["shape"] = json!({"type": "hole", "radius": 0.010_01, "outer_radius": 0.1});
    for side in ["upper", "lower"] {
        si[side]["material"]["young_modulus"] = json!(210e9);
    }
    let (mm, si) = (step(&job), step(&si));
    assert_within(1e-6 * si[Name::PeakPressure], mm[Name::PeakPressure], 1e-9);
    assert_within(si[Name::HalfAngle], mm[Name::HalfAngle], 1e-9);
    assert!(si.validity.is_empty(), "{:?}", si.validity);
}

/// The numbers of rows and columns, and with them the answer, are the same in other units, where
/// lengths differ by rounding.
#[test]
fn other_units_have_the_same_mesh() {
    for clearance in [1.922_904_155_5e-6, 1e-4, 3e-2] {
        let job = |length: f64, stress: f64| {
            let body = |shape: Value| {
                json!({"shape": shape,
                "material": {"young_modulus": stress * YOUNG, "poisson_ratio": 0.45}})
            };
            json!({"analysis": "axisymmetric",
                "units": if stress > 1.0 { "SI" } else { "mm_N_MPa" },
                "upper": body(json!({"type": "cylinder", "radius": length})),
                "lower": body(json!({"type": "hole", "radius": length * (1.0 + clearance),
                    "outer_radius": 1.2 * length * (1.0 + clearance)})),
                "load": {"force": 63.682 * clearance}, "mesh": {"elements_per_half_width": 10}})
        };
        let [mm, si] = [report(&job(1.0, 1.0)), report(&job(1e-3, 1e6))];
        assert_eq!(mm.mesh.equations, si.mesh.equations);
        assert_within(
            1e3 * si.steps[0].approach().unwrap(),
            mm.steps[0].approach().unwrap(),
            1e-9,
        );
    }
}

/// Elastic bodies that are unloaded keep nothing, and the bars say so.
#[test]
fn an_elastic_pin_keeps_no_stress() {
    for analysis in ["plane_strain", "plane_stress"] {
        let mut job = pin(
            &json!({"type": "hole", "radius": 10.05, "outer_radius": 60}),
            &json!({"history": [{"force": 500}, {"force": 0}]}),
        );
        job["analysis"] = json!(analysis);
        let law = json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10_500});
        for side in ["upper", "lower"] {
            job[side]["material"]["plasticity"] = law.clone();
        }
        job["mesh"] = json!({"elements_per_half_width": 6});
        job["solver"] = json!({"theory": "flow"});
        let report = report(&job);
        for (name, side) in [Name::LeastStress, Name::LargestVonMises]
            .into_iter()
            .flat_map(|name| Side::BOTH.map(|side| (name, side)))
        {
            assert_eq!(report.steps[1].body(name, side), None, "{analysis} {name:?}");
        }
        let tension =
            report.steps[1].answers.iter().find(|answer| answer.name == "residual_tension");
        assert!(tension.is_none(), "{analysis}: {tension:?}");
    }
}
