//! Forces that are told by what they do.

use brinell_solver::job::Job;
use brinell_solver::report::{self, Answer, Name, Report, RunError};
use brinell_solver::solver::{SolveStatus, Unobserved};
use serde_json::{Value, json};

use super::problems::assert_within;

const ELEMENTS: u32 = 12;

fn steel() -> Value {
    json!({"young_modulus": 210_000, "poisson_ratio": 0.3,
        "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10_500}})
}

fn cylinders(analysis: &str, theory: &str, target: &Value) -> Value {
    let body = json!({"shape": {"type": "cylinder", "radius": 20}, "material": steel()});
    json!({"analysis": analysis, "upper": body, "lower": body, "load": {"target": target},
        "mesh": {"elements_per_half_width": ELEMENTS}, "solver": {"theory": theory}})
}

fn run(job: &Value) -> Result<Report, RunError> {
    report::run(&Job::from_value(job).unwrap(), &mut Unobserved)
}

/// The row of the force that is found.
fn found(job: &Value) -> (Answer, Report) {
    let report = run(job).unwrap();
    assert_eq!(report.status, SolveStatus::Converged, "{job}");
    assert!(report.answers[0].is(Name::ForceFound), "{:?}", report.answers);
    (report.answers[0].clone(), report)
}

/// The one fault of a target that no force gives.
fn refusal(job: &Value) -> String {
    match run(job) {
        Err(RunError::Input(faults)) => faults.iter().map(ToString::to_string).collect(),
        other => panic!("{other:?}"),
    }
}

/// The force that is found, given as a force, is the same job to the last bit, and its figure is
/// the wanted one.
#[test]
#[ignore = "full"]
fn a_force_that_is_found_does_what_it_was_sought_for() {
    let targets = [
        ("deformation", json!({"peak_pressure": 1200})),
        ("deformation", json!({"mean_pressure": 900})),
        ("deformation", json!({"half_width": 0.3})),
        ("deformation", json!({"max_plastic_strain": 0.01})),
        ("flow", json!({"peak_pressure": 1100})),
        ("flow", json!({"permanent_approach": 0.002})),
        ("flow", json!({"dent_depth": 0.001})),
    ];
    for analysis in ["plane_strain", "plane_stress", "axisymmetric"] {
        for (theory, target) in &targets {
            if analysis == "plane_stress" && target.get("peak_pressure").is_some() {
                // In plane stress such pressures are deep in the plastic range, and slow.
                continue;
            }
            let job = cylinders(analysis, theory, target);
            let (answer, report) = found(&job);
            let name = format!("{analysis} {theory} {target}");
            let (figure, wanted) = target.as_object().unwrap().iter().next().unwrap();
            let wanted = wanted.as_f64().unwrap();
            let scatters = ["half_width", "mean_pressure"].contains(&figure.as_str());
            let mut given = job.clone();
            let force = json!({"force": match report.steps[0].load { report::LoadReport::Force(force) => force, report::LoadReport::Approach(_) => unreachable!() }});
            let is_permanent = report.steps.len() == 2;
            given["load"] =
                if is_permanent { json!({"history": [force, {"force": 0}]}) } else { force };
            let direct = run(&given).unwrap();
            let (step, last) = (&direct.steps[0], direct.steps.last().unwrap());
            let reached = match figure.as_str() {
                "peak_pressure" => step[Name::PeakPressure],
                "mean_pressure" => step[Name::MeanPressure],
                "half_width" => step[Name::HalfWidth],
                "permanent_approach" => last[Name::PermanentApproach],
                "dent_depth" => last[Name::DentDepth],
                _ => step[Name::MaxPlasticStrain],
            };
            assert_within(reached, wanted, if scatters { 0.02 } else { 5e-3 });
            assert_within(answer.value.unwrap(), step[Name::Force], 1e-9);
            if figure == "permanent_approach" {
                let bar = answer.error.bound();
                assert!(bar.is_some_and(|bar| bar > 0.0 && bar < 0.2), "{name}: {answer:?}");
            }
            let sensitivity = report.answers[1].value.unwrap();
            assert!(sensitivity > 0.05 && sensitivity < 6.0, "{name}: {sensitivity}");
        }
    }
}

/// P = π p0² R/E* of equal cylinders, and 4 a³ E*/3R of spheres; R is half the radius of one.
#[test]
fn an_elastic_contact_meets_hertz() {
    let modulus = 210_000.0 / (2.0 * (1.0 - 0.09));
    let mut line = cylinders("plane_strain", "deformation", &json!({"peak_pressure": 900}));
    let mut point = cylinders("axisymmetric", "deformation", &json!({"half_width": 0.2}));
    for job in [&mut line, &mut point] {
        for side in ["upper", "lower"] {
            job[side]["material"].as_object_mut().unwrap().remove("plasticity");
        }
    }
    let (line, report) = found(&line);
    let force = |row: &Answer| row.value.unwrap();
    assert_within(force(&line), std::f64::consts::PI * 900.0 * 900.0 * 10.0 / modulus, 5e-3);
    assert_within(force(&report.answers[1]), 0.5, 0.02);
    assert!(report.mesh.passes <= 15, "{}", report.mesh.passes);
    let (point, _) = found(&point);
    let expected = 4.0 * 0.2_f64.powi(3) * modulus / (3.0 * 10.0);
    let off = (force(&point) / expected - 1.0).abs();
    assert!(off < point.error.bound().unwrap(), "{point:?} {expected}");
}

#[test]
#[ignore = "full"]
fn units_and_sides_do_not_matter() {
    let job = cylinders("plane_strain", "flow", &json!({"permanent_approach": 0.002}));
    let (mm, in_mm) = found(&job);
    let mut si = job.clone();
    si["units"] = json!("SI");
    for side in ["upper", "lower"] {
        si[side]["shape"]["radius"] = json!(0.02);
        si[side]["material"]["young_modulus"] = json!(210e9);
        si[side]["material"]["plasticity"]["yield_stress"] = json!(500e6);
        si[side]["material"]["plasticity"]["tangent_modulus"] = json!(10.5e9);
    }
    si["load"]["target"]["permanent_approach"] = json!(2e-6);
    let (si, in_si) = found(&si);
    let force = |row: &Answer| row.value.unwrap();
    assert_within(force(&si), 1e3 * force(&mm), 1e-9);
    let left = |report: &Report| report.steps[1][Name::PermanentApproach];
    assert_within(left(&in_si), 1e-3 * left(&in_mm), 1e-9);
    let block =
        json!({"shape": {"type": "block", "width": 40, "depth": 20}, "material": {"rigid": true}});
    let mut over = job.clone();
    over["lower"] = block.clone();
    let mut under = job;
    under["upper"] = block;
    assert_within(force(&found(&over).0), force(&found(&under).0), 1e-6);
}

#[test]
#[ignore = "full"]
fn what_no_force_gives_is_refused_with_what_there_is() {
    let peak =
        |value: f64| cylinders("plane_strain", "deformation", &json!({"peak_pressure": value}));
    let large = refusal(&peak(9000.0));
    assert!(
        large.starts_with(
            "/load/target/peak_pressure: the largest peak pressure that is reached is"
        ),
        "{large}"
    );
    assert!(
        large.ends_with("the contact would spread over more of the surfaces than is solved"),
        "{large}"
    );
    let small = refusal(&peak(1e-6));
    assert!(
        small.contains("the peak pressure is larger than this under any force, down to"),
        "{small}"
    );
    let mut limit = peak(1700.0);
    for side in ["upper", "lower"] {
        limit[side]["material"]["plasticity"]["tangent_modulus"] = json!(0);
    }
    let limit = refusal(&limit);
    assert!(limit.contains("under a larger one"), "{limit}");
    // In plane stress a perfectly plastic body bears about 2/√3 σ_y, and any force by a wider
    // contact.
    let mut level = cylinders("plane_stress", "flow", &json!({"peak_pressure": 1000}));
    level["lower"]["material"]["plasticity"]["tangent_modulus"] = json!(0);
    level["mesh"] = json!({"elements_per_half_width": 6});
    let level = refusal(&level);
    assert!(
        level.contains("that is reached is 577.35 MPa") && level.contains("under a larger one"),
        "{level}"
    );
    let wide =
        Job::from_value(&cylinders("plane_strain", "deformation", &json!({"half_width": 15})))
            .unwrap();
    let wide = report::preflight(&wide).unwrap_err();
    assert_eq!(wide[0].pointer, "/load");
}

/// A sharp punch is as wide under every force, and the mean pressure under an elastic cone is the
/// same.
#[test]
fn a_figure_that_does_not_depend_on_the_force_tells_none() {
    let elastic = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    let block =
        json!({"shape": {"type": "block", "width": 200, "depth": 100}, "material": elastic});
    let job = |analysis: &str, shape: Value, target: Value| {
        json!({"analysis": analysis, "upper": {"shape": shape, "material": {"rigid": true}},
            "lower": block,
            "load": {"target": target}, "mesh": {"elements_per_half_width": ELEMENTS}})
    };
    let punch = json!({"type": "punch", "width": 4, "depth": 10});
    let cone = json!({"type": "cone", "angle": 5, "width": 40, "depth": 20});
    let mean = 0.5 * 210_000.0 / 0.91 * 5_f64.to_radians().tan();
    for job in [
        job("plane_strain", punch, json!({"half_width": 2})),
        job("axisymmetric", cone, json!({"mean_pressure": mean})),
    ] {
        let refusal = refusal(&job);
        assert!(refusal.contains("hardly depends on the force"), "{refusal}");
    }
}
