//! Rigid indenters on an elastic block: wedges, cones, power-law punches and flat punches, against
//! Sneddon, Johnson, Sadowsky and Boussinesq; and the limit load of the flat punch on a perfectly
//! plastic block against Prandtl.

use brinell_solver::analytical::{
    PowerIndenter, circular_punch_pressure, flat_punch_pressure, prandtl_mean_pressure,
    shear_yield_von_mises,
};
use brinell_solver::report::{Name, StepReport, preflight};
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::problems::{assert_peak, assert_within, parse, report};

const MODULUS: f64 = 210_000.0 / 0.91;

#[expect(clippy::needless_pass_by_value, reason = "values are written where they are used")]
fn press(analysis: &str, shape: Value, load: Value, block: f64, plasticity: Value) -> Value {
    let mut material = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3});
    if !plasticity.is_null() {
        material["plasticity"] = plasticity;
    }
    json!({"analysis": analysis, "load": load,
        "upper": {"shape": shape, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 2.0 * block, "depth": block},
            "material": material}})
}

fn step(job: &Value) -> StepReport {
    let step = report(job).steps.remove(0);
    assert_eq!(step.status, SolveStatus::Converged);
    step
}

fn spacing(step: &StepReport) -> f64 {
    let x = &step.contact.nodes.x;
    x.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
}

fn assert_half_width(step: &StepReport, expected: f64) {
    let error = (step[Name::HalfWidth] - expected).abs();
    assert!(
        error < 0.01 * expected || error < spacing(step),
        "{} for {expected}",
        step[Name::HalfWidth]
    );
}

/// Pressure at x, between two nodes.
fn pressure_at(step: &StepReport, x: f64) -> f64 {
    let nodes = &step.contact.nodes;
    let right = nodes.x.partition_point(|node| *node < x);
    let left = right.saturating_sub(1);
    let t =
        if right == left { 0.0 } else { (x - nodes.x[left]) / (nodes.x[right] - nodes.x[left]) };
    (1.0 - t) * nodes.pressure[left] + t * nodes.pressure[right]
}

#[test]
fn cones_of_sneddon() {
    for angle in [2.0_f64, 5.710_593] {
        let indenter = PowerIndenter::wedge(angle.to_radians(), MODULUS);
        let shape = json!({"type": "cone", "angle": angle, "width": 20.0, "depth": 20.0});
        let step = step(&press(
            "axisymmetric",
            shape,
            json!({"force": indenter.force(1.0)}),
            400.0,
            Value::Null,
        ));
        assert_within(step.approach().unwrap(), indenter.approach(1.0), 3e-3);
        assert_half_width(&step, 1.0);
        assert_within(step[Name::MeanPressure], 0.5 * MODULUS * angle.to_radians().tan(), 1e-2);
    }
}

/// A wedge touches in the same way under any force: the pressure is the same down to contacts of
/// 1e-13 mm, and a roller's is Hertz's.
#[test]
fn the_smallest_loads_are_solved() {
    let peak = |shape: Value, force: f64| {
        step(&press("plane_strain", shape, json!({"force": force}), 20.0, Value::Null))
            [Name::PeakPressure]
    };
    let wedge = json!({"type": "wedge", "angle": 0.8, "width": 10.0, "depth": 10.0});
    let reference = peak(wedge.clone(), 1.0);
    for force in [1e-9, 1e-6, 1e-4] {
        assert_within(peak(wedge.clone(), force), reference, 1e-3);
        let hertz = brinell_solver::analytical::HertzLine::new(force, 10.0, MODULUS);
        let roller = json!({"type": "cylinder", "radius": 10.0});
        assert_within(peak(roller, force), hertz.peak_pressure(), 1e-3);
    }
}

#[test]
fn wedges_of_johnson() {
    for angle in [2.0_f64, 5.710_593] {
        let indenter = PowerIndenter::wedge(angle.to_radians(), MODULUS);
        let shape = json!({"type": "wedge", "angle": angle, "width": 20.0, "depth": 20.0});
        let force = indenter.line_force(1.0);
        let step =
            step(&press("plane_strain", shape, json!({"force": force}), 400.0, Value::Null));
        assert_half_width(&step, 1.0);
        assert_within(step[Name::MeanPressure], 0.5 * MODULUS * angle.to_radians().tan(), 1e-2);
        // p = E* tan β / π · arcosh(a/x)
        let exact = MODULUS * angle.to_radians().tan() / std::f64::consts::PI * 2.0_f64.acosh();
        assert_within(pressure_at(&step, 0.5), exact, 1e-2);
    }
}

#[test]
fn power_law_punches() {
    for exponent in [1.2, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0] {
        let scale = 30.0_f64;
        let coefficient = scale.powf(1.0 - exponent);
        let indenter = PowerIndenter::new(exponent, coefficient, MODULUS);
        let shape = json!({"type": "power", "exponent": exponent, "scale": scale, "width": 20.0,
            "depth": 20.0});
        let load = json!({"force": indenter.force(1.0)});
        let round = step(&press("axisymmetric", shape.clone(), load, 400.0, Value::Null));
        assert_within(round.approach().unwrap(), indenter.approach(1.0), 3e-3);
        assert_half_width(&round, 1.0);
        let load = json!({"force": indenter.line_force(1.0)});
        let plane = step(&press("plane_strain", shape, load, 400.0, Value::Null));
        assert_half_width(&plane, 1.0);
    }
}

/// High powers are nearly flat punches, whose pressure is highest next to the ends of the contact.
#[test]
fn the_bar_of_the_half_width_holds_for_high_powers() {
    for exponent in [8.0_f64, 12.0, 18.0, 25.0] {
        let indenter = PowerIndenter::new(exponent, 3f64.powf(1.0 - exponent), MODULUS);
        for (analysis, force) in
            [("axisymmetric", indenter.force(1.0)), ("plane_strain", indenter.line_force(1.0))]
        {
            let shape = json!({"type": "power", "exponent": exponent, "scale": 3.0, "width": 6.0,
                "depth": 20.0});
            let step = step(&press(analysis, shape, json!({"force": force}), 400.0, Value::Null));
            let error = (step[Name::HalfWidth] - 1.0).abs();
            assert!(error <= step.bar(Name::HalfWidth).unwrap(), "{analysis} {exponent}: {error}");
        }
    }
}

/// Powers below 2 are pointed, and a mesh sees a part of the pressure at the tip.
#[test]
fn the_peak_of_a_pointed_power_has_no_bar() {
    for exponent in [1.05_f64, 1.5, 1.95] {
        let indenter = PowerIndenter::new(exponent, 30f64.powf(1.0 - exponent), MODULUS);
        for (analysis, force) in
            [("axisymmetric", indenter.force(1.0)), ("plane_strain", indenter.line_force(1.0))]
        {
            let shape = json!({"type": "power", "exponent": exponent, "scale": 30.0, "width": 20.0,
                "depth": 20.0});
            let step = step(&press(analysis, shape, json!({"force": force}), 200.0, Value::Null));
            assert!(
                (step[Name::HalfWidth] - 1.0).abs() <= step.bar(Name::HalfWidth).unwrap(),
                "{analysis} {exponent}"
            );
            assert_eq!(step.bar(Name::PeakPressure), None);
            assert!(
                step.validity.iter().any(|note| note.code == "coarse_mesh"),
                "{analysis} {exponent}"
            );
        }
    }
}

/// An edge that yields by next to nothing is told like an elastic one.
#[test]
fn a_rounded_edge_that_hardly_yields_is_told_like_an_elastic_one() {
    let law =
        json!({"law": "ramberg_osgood", "reference_stress": 200.0, "offset": 0.3, "exponent": 6});
    let punch = json!({"type": "punch", "width": 2.0, "depth": 4.0, "edge_radius": 0.1356});
    let mut job = press("axisymmetric", punch, json!({"force": 31.3}), 40.0, law);
    job["mesh"] = json!({"elements_per_half_width": 12});
    let step = step(&job);
    for name in [Name::PeakPressure, Name::HalfWidth, Name::Approach] {
        assert_eq!(step.bar(name), None, "{name:?}");
    }
    assert!(step.validity.iter().any(|note| note.code == "coarse_mesh"), "{:?}", step.validity);
}

#[test]
fn a_parabola_has_hertz_pressure_and_an_ellipse_that_of_its_vertex() {
    let plane = |shape: Value| {
        step(&press("plane_strain", shape, json!({"force": 500.0}), 60.0, Value::Null))
    };
    let parabola =
        plane(json!({"type": "parabola", "radius": 20.0, "width": 30.0, "depth": 20.0}));
    let ellipse = plane(json!({"type": "ellipse", "semi_axis_x": 20.0, "semi_axis_y": 20.0}));
    let flat = plane(json!({"type": "ellipse", "semi_axis_x": 20.0, "semi_axis_y": 10.0}));
    let hertz = |radius: f64| {
        brinell_solver::analytical::HertzLine::new(500.0, radius, MODULUS).peak_pressure()
    };
    assert_peak(&parabola, hertz(20.0));
    assert_peak(&ellipse, hertz(20.0));
    assert_peak(&flat, hertz(40.0));
    assert_within(parabola.elastic(Name::PeakPressure).unwrap(), hertz(20.0), 1e-12);
}

/// A wedge whose tip is rounded: pressed lightly it is a cylinder, pressed hard a wedge.
#[test]
fn a_rounded_wedge_goes_from_cylinder_to_wedge() {
    let (angle, radius) = (2.0_f64, 5.0);
    let shape = json!({"type": "wedge", "angle": angle, "tip_radius": radius, "width": 20.0,
        "depth": 20.0});
    let with = |force: f64| {
        step(&press("plane_strain", shape.clone(), json!({"force": force}), 400.0, Value::Null))
    };
    let hertz = brinell_solver::analytical::HertzLine::new(50.0, radius, MODULUS);
    let light = with(50.0);
    assert!(hertz.half_width() < radius * angle.to_radians().sin());
    assert_peak(&light, hertz.peak_pressure());
    let indenter = PowerIndenter::wedge(angle.to_radians(), MODULUS);
    let hard = with(indenter.line_force(4.0));
    assert_half_width(&hard, 4.0);
}

#[test]
fn a_sharp_flat_punch_ends_at_its_edge() {
    let force = 4_615.384_615;
    let punch = json!({"type": "punch", "width": 2.0, "depth": 5.0});
    let plane =
        step(&press("plane_strain", punch.clone(), json!({"force": force}), 200.0, Value::Null));
    assert_eq!(plane[Name::HalfWidth], 1.0);
    assert_within(pressure_at(&plane, 0.0), flat_punch_pressure(force, 1.0, 0.0), 5e-3);
    assert_within(pressure_at(&plane, 0.5), flat_punch_pressure(force, 1.0, 0.5), 5e-3);
    let round = step(&press("axisymmetric", punch, json!({"force": force}), 800.0, Value::Null));
    assert_eq!(round[Name::HalfWidth], 1.0);
    assert_within(pressure_at(&round, 0.5), circular_punch_pressure(force, 1.0, 0.5), 1e-2);
    assert_within(round.approach().unwrap(), force / (2.0 * MODULUS), 3e-3);
}

/// Rounded edges: Ciavarella, Hills & Monno's punch is the sharp one in the limit, and its contact
/// ends on the arcs.
#[test]
fn a_rounded_punch_ends_on_its_arcs() {
    let at = |radius: f64, force: f64| {
        let shape = json!({"type": "punch", "width": 2.0, "edge_radius": radius, "depth": 5.0});
        step(&press("plane_strain", shape, json!({"force": force}), 100.0, Value::Null))
    };
    let light = at(0.5, 100.0);
    assert!(light[Name::HalfWidth] > 0.5 && light[Name::HalfWidth] < 0.6);
    let hard = at(0.5, 5000.0);
    assert!(hard[Name::HalfWidth] > light[Name::HalfWidth] && hard[Name::HalfWidth] < 1.0);
}

/// Edges whose radius is smaller than an element, in every analysis: the check before knows what
/// they cost, the contact ends on the arcs, the approach is near those of sharp punches as wide as
/// the flat and as the whole, and no figure has a bar. Radii that no mesh resolves are refused in
/// all.
#[test]
fn small_edge_radii_are_solved_or_refused_in_every_analysis() {
    for analysis in ["plane_strain", "plane_stress", "axisymmetric"] {
        let job = |half_width: f64, radius: f64| {
            let shape = json!({"type": "punch", "width": 2.0 * half_width, "edge_radius": radius,
                "depth": 5.0});
            let mut job = press(analysis, shape, json!({"force": 2000.0}), 40.0, Value::Null);
            job["mesh"] = json!({"elements_per_half_width": 12});
            job
        };
        let rounded = job(1.0, 0.02);
        let estimate = preflight(&parse(&rounded)).unwrap().equations as f64;
        let found = report(&rounded);
        assert_within(found.mesh.equations as f64, estimate, 0.1);
        let step = &found.steps[0];
        assert_eq!(step.status, SolveStatus::Converged);
        assert!(step[Name::HalfWidth] <= 1.0 && step[Name::HalfWidth] >= 0.95);
        let sharp =
            |half_width: f64| report(&job(half_width, 0.0)).steps.remove(0).approach().unwrap();
        assert!(step.approach().unwrap() <= 1.05 * sharp(0.98));
        assert!(step.approach().unwrap() >= 0.95 * sharp(1.0));
        // The smaller the radius, the nearer to the flat is the last node in contact.
        for radius in [0.02, 0.008, 0.004] {
            let step = report(&job(1.0, radius)).steps.remove(0);
            assert_eq!(step.bar(Name::PeakPressure), None, "{radius}");
            assert!(step.validity.iter().any(|note| note.code == "coarse_mesh"), "{radius}");
        }
        for radius in [1e-5, 1e-3, 2e-3] {
            let faults = preflight(&parse(&job(1.0, radius))).unwrap_err();
            assert_eq!(faults[0].pointer, "/upper/shape/edge_radius", "{radius}");
        }
    }
}

/// The half-width that a refusal names is that of the closed form: of a power law the force grows
/// with a high power of it. Pressure in the middle of an elastic contact of half-width 1 on a tip
/// that is a parabola up to ±q, over `E* tan β`.
fn tip_pressure(analysis: &str, q: f64) -> f64 {
    let steps = 20_000;
    // ∫ dx of a function of x from q to 1, in even steps of ln x.
    let outside = |of: &dyn Fn(f64) -> f64| {
        let step = q.recip().ln() / f64::from(steps);
        (0..steps)
            .map(|k| q * (step * (f64::from(k) + 0.5)).exp())
            .map(|x| step * x * of(x))
            .sum::<f64>()
    };
    if analysis == "axisymmetric" {
        // p = E*/π ∫ α'(s)/s ds, by parts, with Sneddon's approach α(s).
        let approach = |s: f64| (s - (s * s - q * q).sqrt()) * s / q + s * (q / s).acos();
        (approach(1.0) + 1.0 + outside(&|s| approach(s) / (s * s))) / std::f64::consts::PI
    } else {
        (q.recip().acosh() + q.asin() / q) / std::f64::consts::PI
    }
}

#[test]
fn the_bar_of_a_rounded_tip_holds_its_pressure() {
    for (analysis, shape) in [("axisymmetric", "cone"), ("plane_strain", "wedge")] {
        for angle in [0.05_f64, 1.0, 4.0] {
            let (slope, indenter) =
                (angle.to_radians().tan(), PowerIndenter::wedge(angle.to_radians(), MODULUS));
            let force =
                if shape == "cone" { indenter.force(1.0) } else { indenter.line_force(1.0) };
            for q in [1e-4, 3e-3, 0.01, 0.03, 0.1, 0.15, 0.25, 0.4] {
                let radius = q / angle.to_radians().sin();
                let indenter = json!({"type": shape, "angle": angle, "tip_radius": radius,
                    "width": 20.0, "depth": 20.0});
                let step =
                    step(&press(analysis, indenter, json!({"force": force}), 80.0, Value::Null));
                let a = step[Name::HalfWidth];
                let exact = MODULUS * slope * tip_pressure(analysis, q / a);
                let error = (exact / step[Name::PeakPressure] - 1.0).abs();
                let bar = step.bar(Name::PeakPressure);
                assert_eq!(bar.is_none(), q < 4.0 * spacing(&step), "{shape} {angle} {q}");
                assert!(
                    bar.is_none_or(|bar| error <= bar),
                    "{shape} {angle} {q}: {error} in {bar:?}"
                );
                let note = step.validity.iter().find(|note| note.code == "coarse_mesh");
                assert_eq!(note.is_some(), q < 4.0 * spacing(&step), "{shape} {angle} {q}");
                let elements = (4.0 * a / q).ceil();
                let advice = if elements > 320.0 {
                    "No mesh".to_owned()
                } else {
                    format!("About {elements:.0} elements")
                };
                assert!(note.is_none_or(|note| note.message.contains(&advice)), "{note:?}");
            }
        }
    }
}

#[test]
fn a_refusal_names_the_half_width_that_there_would_be() {
    for exponent in [3.0, 10.0] {
        let scale = 30.0_f64;
        let indenter = PowerIndenter::new(exponent, scale.powf(1.0 - exponent), MODULUS);
        let shape = json!({"type": "power", "exponent": exponent, "scale": scale, "width": 12.0,
            "depth": 20.0});
        let job = press(
            "axisymmetric",
            shape,
            json!({"force": indenter.force(4.0)}),
            400.0,
            Value::Null,
        );
        let faults = preflight(&parse(&job)).unwrap_err();
        let named: Vec<&str> = faults[0].detail.split_whitespace().collect();
        let reach: f64 =
            named[named.iter().position(|word| *word == "about").unwrap() + 1].parse().unwrap();
        assert_within(reach, 4.0, 5e-3);
    }
}

/// The force of a punch that is driven into a perfectly plastic block approaches Prandtl's from
/// below.
#[test]
fn the_limit_load_of_a_flat_punch_is_prandtls() {
    let yield_stress = 210.0;
    let law = json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 0.0});
    let punch = json!({"type": "punch", "width": 2.0, "depth": 5.0});
    let job =
        press("plane_strain", punch, json!({"approaches": [0.01, 0.02, 0.04, 0.08]}), 20.0, law);
    let report = report(&job);
    let limit = 2.0 * prandtl_mean_pressure(shear_yield_von_mises(yield_stress));
    let forces: Vec<f64> = report.steps.iter().map(|step| step[Name::Force] / limit).collect();
    assert!(report.steps.iter().all(|step| step.status == SolveStatus::Converged), "{forces:?}");
    assert!(
        forces.windows(2).all(|pair| pair[1] > pair[0]) && forces[3] > 0.98 && forces[3] < 1.0,
        "{forces:?}"
    );
}
