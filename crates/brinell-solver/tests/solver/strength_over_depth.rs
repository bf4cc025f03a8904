//! Strength that varies with the depth below the surface: closed forms of a graded tube and of the
//! onset of yield below a line contact, and what a hard case and a soft core do to a contact.

use std::sync::Arc;

use brinell_solver::analytical::{DepthLimit, HertzLine};
use brinell_solver::fem::assembly::MaterialModel;
use brinell_solver::fem::element::StressState;
use brinell_solver::fem::mesh::Mesh;
use brinell_solver::inputs::outline_of;
use brinell_solver::job::{
    Bilinear, Groove, Hardening, Job, JobError, NonNegativeF64, OverDepth, Shape,
};
use brinell_solver::material::{
    DeformationPlasticity, DepthStrength, ElasticModuli, FlowPlasticity, Inhomogeneous,
    OutOfPlane, ReturnMapping,
};
use brinell_solver::report::Name;
use brinell_solver::solver::{BodySolution, SolveStatus};
use serde_json::{Value, json};

use crate::bodies::{Specimen, grid, material, positive};
use crate::problems::{
    assert_within, bilinear, bits, cylinder, parse, report, solve, two_cylinders,
};

const INNER: f64 = 100.0;
const OUTER: f64 = 200.0;
const YOUNG: f64 = 210_000.0;
const POISSON: f64 = 0.4999;
/// k at the bore \[MPa\], and by how much it falls over a mm.
const BORE: f64 = 140.0;
const SLOPE: f64 = -0.25;

/// A quarter of a tube whose bore is the surface: the centre lies at `[0, INNER]` in the frame of
/// the body.
fn tube(radial: i32, around: i32) -> Mesh {
    grid(radial, around, |i, j| {
        let r = INNER * (OUTER / INNER).powf(f64::from(i) / f64::from(radial));
        let angle = std::f64::consts::FRAC_PI_2 * f64::from(j) / f64::from(around);
        let (sin, cos) = if j == around { (1.0, 0.0) } else { angle.sin_cos() };
        [r * cos, INNER + r * sin]
    })
}

/// The yield stress falls straight from bore to rim: `k(r) = k_0 + k_1 (r - a)`, with `σ_y = √3
/// k`.
fn graded(flow: bool) -> Arc<dyn MaterialModel> {
    let yield_stress = 3f64.sqrt() * BORE;
    let law = Hardening::Bilinear(Bilinear {
        yield_stress: positive(yield_stress),
        tangent_modulus: NonNegativeF64::new(0.0).unwrap(),
    });
    let material = material(YOUNG, POISSON, Some(law));
    let wall = OUTER - INNER;
    let over_depth = OverDepth::Factors(vec![[0.0, 1.0], [wall, 1.0 + SLOPE * wall / BORE]]);
    let (radius, width) = (positive(INNER), positive(2.0 * INNER));
    let bore = Groove { radius, width, depth: positive(wall) };
    let strength =
        DepthStrength::new(over_depth.profile(yield_stress), outline_of(&Shape::Groove(bore)));
    let elastic = ElasticModuli::from(&material.elastic);
    let (law, plane) = (material.hardening_law(), OutOfPlane::Strained);
    if flow {
        let of = |law: Option<_>| {
            FlowPlasticity::new(
                elastic,
                ReturnMapping::new(law.unwrap(), elastic.shear),
                [],
                plane,
            )
        };
        Arc::new(Inhomogeneous::new(law, Some(strength), of))
    } else {
        let of = |law| DeformationPlasticity::with_law(elastic, law, plane);
        Arc::new(Inhomogeneous::new(law, Some(strength), of))
    }
}

/// `p = k(c)(1 - c²/b²) + 2[(k0 - k1 a) ln(c/a) + k1(c - a)]`, while `k(r) > k(c) c²/r²` beyond c;
/// u at the rim follows from the elastic part, `2 (1 - ν²) k(c) c²/(E b)`.
#[test]
fn a_graded_tube_yields_as_its_closed_form_says() {
    let shear_yield = |r: f64| BORE + SLOPE * (r - INNER);
    for (c, flow) in [(120.0, false), (150.0, false), (180.0, false), (150.0, true)] {
        let logarithm = (BORE - SLOPE * INNER) * (c / INNER).ln() + SLOPE * (c - INNER);
        let pressure = shear_yield(c) * (1.0 - (c / OUTER).powi(2)) + 2.0 * logarithm;
        let mesh = tube(40, 24);
        let held = mesh.nodes.iter().map(|[x, y]| [*x == 0.0, *y == INNER]).collect();
        let mut force = vec![[0.0; 2]; mesh.nodes.len()];
        for k in 0..24 {
            let (p, q) = (mesh.nodes[k], mesh.nodes[k + 1]);
            let half = [0.5 * pressure * (q[1] - p[1]), -0.5 * pressure * (q[0] - p[0])];
            for node in [k, k + 1] {
                force[node] = [force[node][0] + half[0], force[node][1] + half[1]];
            }
        }
        let mut specimen = Specimen::new(&mesh, StressState::PlaneStrain, graded(flow), held);
        let loaded = specimen.load(&force, 20_000);
        let rim = mesh.nodes.iter().position(|[x, y]| *y == INNER && *x > OUTER - 1e-9).unwrap();
        let expected = 2.0 * (1.0 - POISSON * POISSON) * shear_yield(c) * c * c / (YOUNG * OUTER);
        assert_within(loaded.displacement[rim][0], expected, 5e-3);
        for point in loaded.field.points.iter().flatten() {
            let (x, y) = (point.position[0], point.position[1] - INNER);
            let r = x.hypot(y);
            assert!(point.yielded == (r < c) || (r - c).abs() < 3.0, "c = {c}, r = {r}");
            let [xx, yy, _, xy] = point.stress;
            let shear = (0.5 * (xx - yy)).hypot(xy);
            let expected = if r < c { shear_yield(r) } else { shear_yield(c) * (c / r).powi(2) };
            assert!(
                (shear / expected - 1.0).abs() < 0.02,
                "c = {c}, r = {r}: {shear} instead of {expected}"
            );
        }
    }
}

fn graded_cylinder(yield_stress: f64, over_depth: &Value) -> Value {
    let law = json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 0.0,
        "over_depth": over_depth});
    let mut body = cylinder("roller", law);
    body["shape"]["radius"] = json!(10.0);
    body
}

/// `p0 = min_z σ_y(z)/F(z/a)`, F by McEwen. Contacts so small that the bodies are half-planes. A
/// step within an element is met where it is.
#[test]
#[ignore = "full"]
fn a_graded_contact_yields_first_where_it_is_weakest_for_its_stress() {
    let modulus = YOUNG / 1.82;
    for (over_depth, elements) in [
        (json!([[0.0, 2.0], [0.008, 1.0]]), 40),
        (json!([[0.0, 1.0], [0.01, 3.0]]), 40),
        (json!([[0.0, 1.6], [0.003, 1.0], [0.012, 2.0]]), 40),
        (json!([[0.0, 3.0], [0.012, 2.8], [0.016, 1.0]]), 40),
        (json!([[0.0, 3.0], [0.0131, 3.0], [0.013_113, 1.0]]), 20),
        (json!([[0.0, 3.0], [0.0157, 3.0], [0.015_716, 1.0]]), 20),
        (json!([[0.0, 4.0], [0.0212, 4.0], [0.021_221, 1.0], [0.03, 4.0]]), 20),
    ] {
        let body = graded_cylinder(35.0, &over_depth);
        let job = json!({"analysis": "plane_strain", "upper": body, "lower": body,
            "load": {"onset": true},
            "mesh": {"elements_per_half_width": elements}});
        let found = report(&job);
        assert_eq!(found.status, SolveStatus::Converged);
        let step = &found.steps[0];
        let hertz = HertzLine::new(step[Name::Force], 5.0, modulus);
        let profile =
            OverDepth::Factors(serde_json::from_value(over_depth).unwrap()).profile(35.0);
        let least = (0..20_000)
            .map(|k| 1e-4 * f64::from(k) * 10.0 * hertz.half_width())
            .map(|z| {
                35.0 * profile.factor(z) * hertz.peak_pressure()
                    / hertz.stress_on_axis(z, 0.3).von_mises()
            })
            .fold(f64::INFINITY, f64::min);
        assert_within(hertz.peak_pressure(), least, 5e-3);
        // And the closed form of the report is that as well.
        let limit = DepthLimit::line_onset(0.3, 10.0 / modulus, |z| 35.0 * profile.factor(z));
        assert_within(hertz.peak_pressure(), limit.peak_pressure, 5e-3);
        let onset = step.row(Name::Force).unwrap();
        let depth = onset.place.unwrap().depth;
        assert!((depth - limit.depth).abs() < 0.15 * hertz.half_width(), "{onset:?} {limit:?}");
    }
}

fn with_factor(theory: &str, over_depth: Option<Value>, law: Value) -> Value {
    let mut law = law;
    if let Some(over_depth) = over_depth {
        law["over_depth"] = over_depth;
    }
    let mut job = two_cylinders("clamped", law, 612.6106);
    job["mesh"] = json!({"elements_per_half_width": 8});
    if theory == "flow" {
        job["solver"] = json!({"theory": theory, "increments": 3});
        job["load"] = json!({"history": [{"force": 612.6106}, {"force": 0.0}]});
    }
    job
}

#[test]
fn a_factor_of_one_is_none_to_the_bit() {
    for theory in ["deformation", "flow"] {
        let plain = solve(&with_factor(theory, None, bilinear()));
        for over_depth in [json!([[0.0, 1.0]]), json!([[0.0, 1.0], [3.0, 1.0]])] {
            let graded = solve(&with_factor(theory, Some(over_depth), bilinear()));
            assert_eq!(bits(&graded), bits(&plain), "{theory}");
        }
    }
}

/// `1.5 q(ε_p)` of a straight line is a straight line.
#[test]
fn a_constant_factor_is_another_curve() {
    let (young, factor): (f64, f64) = (210_000.0, 1.5);
    let plastic = factor * 10_500.0 / (1.0 - 10_500.0 / young);
    let tangent = plastic / (1.0 + plastic / young);
    let stronger =
        json!({"law": "bilinear", "yield_stress": 500.0 * factor, "tangent_modulus": tangent});
    for theory in ["deformation", "flow"] {
        let graded = solve(&with_factor(theory, Some(json!([[0.2, factor]])), bilinear()));
        let plain = solve(&with_factor(theory, None, stronger.clone()));
        for (a, b) in graded.steps.iter().zip(&plain.steps) {
            assert!((a.figures.approach / b.figures.approach - 1.0).abs() < 1e-9, "{theory}");
            assert!(
                (a.figures.peak_pressure - b.figures.peak_pressure).abs()
                    <= 1e-9 * plain.steps[0].figures.peak_pressure
            );
        }
    }
}

/// Depths of the yielded points below the lower surface, lowest and highest.
fn yielded_depths(body: &BodySolution) -> Option<(f64, f64)> {
    let yielded = body.stress.points.iter().flatten().filter(|point| point.yielded);
    yielded.map(|point| -point.position[1]).fold(None, |range, z| {
        let (least, greatest) = range.unwrap_or((z, z));
        Some((f64::min(least, z), f64::max(greatest, z)))
    })
}

/// A case that bears the contact by itself over a core that does not: all of the zone lies below
/// the case, three half-widths away from the contact.
#[test]
fn a_zone_at_the_core_is_found() {
    for theory in ["deformation", "flow"] {
        let over_depth = json!([[0.0, 6.0], [1.3, 6.0], [1.31, 1.0]]);
        let law = json!({"law": "bilinear", "yield_stress": 240.0, "tangent_modulus": 2000.0,
            "over_depth": over_depth});
        let mut job = two_cylinders("clamped", law, 612.6106);
        job["solver"] = json!({"theory": theory});
        let solution = solve(&job);
        let step = &solution.steps[0];
        assert_eq!(step.status, SolveStatus::Converged, "{theory}");
        let half_width = step.field.patch.unwrap().half_width();
        let (least, greatest) = yielded_depths(step.field.bodies[1].as_ref().unwrap()).unwrap();
        assert!(least > 1.28 && least > 3.0 * half_width, "{theory}: {least} {half_width}");
        assert!(greatest > least + 0.1, "{theory}: {least} to {greatest}");
        // Forces balance over both whole bodies, the core included.
        assert!(step.checks.residual < 2e-6 && step.checks.contact.is_sound());
    }
}

/// A soft surface over a hard core and a hard case over a soft core lie on the two sides of a
/// uniform body.
#[test]
fn a_harder_case_makes_a_higher_peak() {
    let peak = |over_depth: Value| {
        let step =
            solve(&with_factor("deformation", Some(over_depth), bilinear())).steps.remove(0);
        assert_eq!(step.status, SolveStatus::Converged);
        step.figures.peak_pressure
    };
    let case = peak(json!([[0.0, 1.6], [0.4, 1.5], [0.8, 1.0]]));
    let uniform = peak(json!([[0.0, 1.0]]));
    let soft = peak(json!([[0.0, 0.7], [0.4, 0.8], [0.8, 1.0]]));
    assert!(case > 1.02 * uniform && uniform > 1.02 * soft, "{case} {uniform} {soft}");
}

/// The same body by factors, by hardness, and in SI.
#[test]
fn hardness_and_units_are_only_other_words() {
    let strength = |hardness: f64| (2.876 * hardness - 90.7) / 500.0;
    let factors = json!([[0.1, strength(600.0)], [0.5, strength(350.0)]]);
    let hardness = json!({"hardness": {"profile": [[0.1, 600.0], [0.5, 350.0]]}});
    let by_factors = solve(&with_factor("deformation", Some(factors), bilinear()));
    let job = with_factor("deformation", Some(hardness), bilinear());
    let by_hardness = solve(&job);
    assert_within(
        by_hardness.steps[0].figures.peak_pressure,
        by_factors.steps[0].figures.peak_pressure,
        1e-12,
    );
    let mut other = parse(&job);
    other.units = brinell_solver::job::Units::Si;
    let written = serde_json::to_value(&other).unwrap();
    assert_eq!(
        written["lower"]["material"]["plasticity"]["over_depth"]["hardness"]["profile"][0][0],
        1e-4
    );
    let in_si = solve(&written);
    assert_within(
        in_si.steps[0].figures.peak_pressure,
        by_factors.steps[0].figures.peak_pressure,
        1e-12,
    );
}

/// Pointers and details of what is wrong with a job.
fn faults(over_depth: &Value) -> Vec<String> {
    let job = with_factor("deformation", Some(over_depth.clone()), bilinear());
    match Job::from_value(&job) {
        Ok(_) => Vec::new(),
        Err(JobError::Fields(faults)) => faults.into_iter().map(|fault| fault.pointer).collect(),
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn profiles_that_are_none_are_refused_field_by_field() {
    let at = |rest: &str| {
        ["lower", "upper"]
            .map(|side| format!("/{side}/material/plasticity/over_depth{rest}"))
            .to_vec()
    };
    let case = |surface: f64, core: f64| {
        json!({"hardness": {"surface": surface, "core": core,
        "case_depth": 1.0}})
    };
    for (over_depth, place) in [
        (json!([]), ""),
        (json!({}), "/hardness"),
        (json!(2.0), ""),
        (json!([[0.0, 2.0], [0.0, 1.0]]), "/1/0"),
        (json!([[0.5, 2.0], [0.1, 1.0]]), "/1/0"),
        (json!([[-0.1, 2.0]]), "/0/0"),
        (json!([[1e9, 2.0]]), "/0/0"),
        (json!([[0.0, 0.0]]), "/0/1"),
        (json!([[0.0, -1.0]]), "/0/1"),
        (json!([[0.0, 1e6]]), "/0/1"),
        (json!([[0.0, 1.0, 2.0]]), "/0"),
        (json!({"hardness": {"profile": [[0.2, 700.0], [0.2, 400.0]]}}), "/hardness/profile/1/0"),
        (json!({"hardness": {"profile": [[0.0, 20.0]]}}), "/hardness/profile/0/1"),
        (json!({"hardness": {"profile": [[0.0, 700.0]], "core": 300.0}}), "/hardness/core"),
        (case(500.0, 300.0), "/hardness"),
        (case(700.0, 600.0), "/hardness"),
        (case(700.0, 700.0), "/hardness"),
    ] {
        assert_eq!(faults(&over_depth), at(place), "{over_depth}");
    }
    assert!(faults(&json!([[0.0, 0.01], [1e6, 100.0]])).is_empty());
}

/// With hardness the law gives the shape of the curve alone, whatever its own yield stress is.
#[test]
fn hardness_scales_any_curve_of_the_same_shape() {
    let peak = |yield_stress: f64| {
        let law = json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 0.0});
        let hardness = json!({"hardness": {"profile": [[0.0, 300.0], [2.0, 200.0]]}});
        let mut job = with_factor("deformation", Some(hardness), law);
        job["mesh"] = json!({"elements_per_half_width": 6});
        report(&job).steps[0][Name::PeakPressure]
    };
    let usual = peak(700.0);
    for yield_stress in [2.0, 1e5] {
        assert!((peak(yield_stress) / usual - 1.0).abs() < 1e-9);
    }
}

/// Extremes of what is accepted, by every law and theory: an answer, or a status that says that
/// there is none.
#[test]
#[ignore = "full"]
fn the_strangest_profiles_end_in_an_answer_or_say_so() {
    let profiles = [
        json!([[0.0, 100.0], [1e-6, 0.2]]),
        json!([[0.0, 0.2], [0.3, 100.0]]),
        json!([[1e6, 3.0]]),
        json!([[0.0, 1.0], [0.05, 3.0], [0.1, 0.5], [0.15, 3.0], [0.2, 0.5], [0.25, 2.0]]),
    ];
    let laws = [
        bilinear(),
        json!({"law": "ramberg_osgood", "reference_stress": 500.0, "offset": 0.3,
            "exponent": 5.0}),
        json!({"law": "table", "points": [[0.0, 500.0], [0.01, 600.0]]}),
        json!({"law": "swift", "yield_stress": 500.0, "strain_offset": 0.002, "exponent": 0.1}),
        json!({"law": "ludwik", "yield_stress": 500.0, "coefficient": 700.0, "exponent": 0.4}),
        json!({"law": "voce", "yield_stress": 500.0, "saturation_stress": 800.0, "rate": 30.0}),
    ];
    for (k, law) in laws.iter().enumerate() {
        for (n, profile) in profiles.iter().enumerate() {
            let theory = if (k + n) % 3 == 0 { "flow" } else { "deformation" };
            let report = report(&with_factor(theory, Some(profile.clone()), law.clone()));
            for step in &report.steps {
                assert!(
                    step.approach().unwrap().is_finite() && step[Name::PeakPressure].is_finite()
                );
                let is_told = step.status == SolveStatus::Converged
                    || step.validity.iter().any(|note| note.code == "not_converged");
                assert!(is_told, "{law} {profile} {theory}");
            }
        }
    }
}
