//! Reports of contacts in three dimensions: units, frames, forces, sound answers over random jobs.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

use std::collections::BTreeMap;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use brinell_solver::job::Job;
use brinell_solver::report::export::Export;
use brinell_solver::report::{self, Name, Report, Side, StepReport};
use brinell_solver::solver::{SolveStatus, Unobserved};
use serde_json::{Value, json};

#[path = "support/random_job.rs"]
mod random_job;

use random_job::{Random, half_spaces};

#[path = "support/theory.rs"]
mod theory;

use theory::by_deformation_theory;

fn solve(job: &Value) -> Report {
    let job = Job::from_value(&by_deformation_theory(job))
        .unwrap_or_else(|error| panic!("{error:?} of {job}"));
    report::run(&job, &mut Unobserved).unwrap()
}

fn steel(yield_stress: Option<f64>) -> Value {
    let mut steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    if let Some(yield_stress) = yield_stress {
        steel["plasticity"] =
            json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 10_500});
    }
    steel
}

/// A rigid ellipsoid on steel.
fn ellipsoid(rotation: f64, yield_stress: Option<f64>, load: &Value) -> Value {
    json!({
        "analysis": "three_dimensional",
        "upper": {
            "shape": {"type": "curved", "radius_x": 10, "radius_y": 50, "rotation": rotation},
            "material": {"rigid": true},
        },
        "lower": {"shape": {"type": "flat"}, "material": steel(yield_stress)},
        "load": load,
        "mesh": {"elements_per_half_width": 5},
    })
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} and not {expected}");
}

fn pressed(step: &StepReport) -> f64 {
    let maps = step.contact.maps.as_ref().unwrap();
    let cell = (maps.x[1] - maps.x[0]) * (maps.y[1] - maps.y[0]);
    cell * maps.pressure.iter().sum::<f64>()
}

#[test]
fn a_turned_body_has_the_same_contact_at_another_angle() {
    let straight = solve(&ellipsoid(0.0, None, &json!({"force": 100})));
    let turned = solve(&ellipsoid(30.0, None, &json!({"force": 100})));
    let [straight, turned] = [&straight.steps[0], &turned.steps[0]];
    let angles = [straight, turned].map(|step| step[Name::Orientation]);
    assert!(angles[0].abs() < 1e-9 && (angles[1] - 30.0).abs() < 1e-9, "{angles:?}");
    assert_near(turned[Name::PeakPressure], straight[Name::PeakPressure], 1e-9);
    assert_near(turned[Name::Approach], straight[Name::Approach], 1e-9);
}

#[test]
fn figures_are_in_the_units_of_the_job() {
    let mut job = ellipsoid(0.0, None, &json!({"force": 100}));
    job["output"] = json!({"fields": true});
    let millimetres = solve(&job);
    let [one, whole] = [&millimetres.steps[0], &millimetres.steps[0]];
    assert_near(pressed(one), 100.0, 1e-9);
    let metres = json!({
        "analysis": "three_dimensional", "units": "SI", "output": {"fields": true},
        "upper": {"shape": {"type": "curved", "radius_x": 0.01, "radius_y": 0.05},
            "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"}, "material": {"young_modulus": 210e9,
            "poisson_ratio": 0.3}},
        "load": {"force": 100}, "mesh": {"elements_per_half_width": 5},
    });
    let report = solve(&metres);
    let other = &report.steps[0];
    assert_near(pressed(other), 100.0, 1e-9);
    assert_near(other[Name::PeakPressure], 1e6 * one[Name::PeakPressure], 1e-9);
    let stiffness = Name::ContactStiffness;
    assert_near(other[stiffness], 1e3 * one[stiffness], 1e-9);
    assert_near(other[Name::ContactArea], 1e-6 * whole[Name::ContactArea], 1e-9);
    assert_near(other[Name::SemiAxisB], 1e-3 * whole[Name::SemiAxisB], 1e-9);
}

/// On few cells the stiffness of bodies that yield is the difference of jobs of their own. Below
/// the largest load of a history they are elastic.
#[test]
#[ignore = "full"]
fn the_stiffness_of_bodies_that_yield_is_there_on_request() {
    let at = |force: f64| {
        let mut job = ellipsoid(0.0, Some(500.0), &json!({"force": force}));
        job["output"] = json!({"contact_stiffness": (force - 300.0).abs() < 1.0});
        solve(&job).steps.remove(0)
    };
    let [less, here, more] = [285.0, 300.0, 315.0].map(at);
    let slope =
        (more[Name::Force] - less[Name::Force]) / (more[Name::Approach] - less[Name::Approach]);
    let stiffness = |step: &StepReport| step.value(Name::ContactStiffness);
    assert_eq!(stiffness(&less), None);
    assert_near(stiffness(&here).unwrap(), slope, 1e-9);
    let mut job =
        ellipsoid(0.0, Some(500.0), &json!({"history": [{"force": 300}, {"force": 200}]}));
    job["solver"] = json!({"theory": "flow"});
    let steps = solve(&job).steps;
    // One slope of bodies that are elastic again is said once.
    assert_eq!((stiffness(&steps[0]), steps[1].row(Name::UnloadingStiffness)), (None, None));
    assert!(stiffness(&steps[1]) > Some(0.0));
}

/// Of Hertz's contact the work is 2/5 P α, all of it elastic.
#[test]
fn a_history_of_elastic_bodies_keeps_its_work() {
    let mut job =
        ellipsoid(0.0, Some(5000.0), &json!({"history": [{"force": 100}, {"force": 0}]}));
    job["solver"] = json!({"theory": "flow"});
    let report = solve(&job);
    let [loaded, unloaded] = [0, 1].map(|k| &report.steps[k]);
    let expected = 0.4 * 100.0 * loaded[Name::Approach];
    assert_near(loaded[Name::Work], expected, 5e-3);
    assert_near(loaded[Name::ElasticEnergy], expected, 5e-3);
    assert!(unloaded[Name::Work].abs() < 5e-3 * expected, "{}", unloaded[Name::Work]);
    assert!(unloaded.body(Name::DentDepth, Side::Lower) < Some(1e-6 * loaded[Name::Approach]));
    assert!(report.load_approach.is_some());
}

/// HALF-SPACE prototype: dent 1.008 µm, residual stress along the short axis -230 MPa, within the
/// error that is told.
#[test]
fn an_ellipsoid_leaves_a_dent() {
    let mut job =
        ellipsoid(0.0, Some(500.0), &json!({"history": [{"force": 317.1424}, {"force": 0}]}));
    job["solver"] = json!({"theory": "flow"});
    let report = solve(&job);
    assert_eq!(report.status, SolveStatus::Converged);
    let [loaded, unloaded] = [&report.steps[0], &report.steps[1]];
    let bar = |step: &StepReport, name: Name| step.bar(name).unwrap();
    let peak = bar(loaded, Name::PeakPressure).min(0.04);
    assert_near(loaded[Name::PeakPressure], 1174.5, peak);
    assert_near(loaded[Name::Approach], 3.805e-3, bar(loaded, Name::Approach).min(0.01));
    let dent = bar(unloaded, Name::DentDepth).min(0.08);
    assert_near(unloaded[Name::DentDepth], 1.008e-3, dent);
    assert!(unloaded[Name::PileUp] > 0.05e-3, "{}", unloaded[Name::PileUp]);
    assert!(unloaded.row(Name::ReversePlasticStrain).is_none());
    let profile = unloaded.subsurface.as_ref().unwrap().lower.as_ref().unwrap();
    let least = profile.sigma_xx.as_ref().unwrap().iter().skip(1).copied().fold(0.0, f64::min);
    assert_near(least, -230.5, 0.1);
    let [lost, elastic, work] =
        [Name::DissipatedWork, Name::ElasticEnergy, Name::Work].map(|name| unloaded[name]);
    assert!(lost > 0.0 && elastic > 0.0 && elastic < work, "{lost} {elastic} {work}");
    assert!(unloaded[Name::PlasticVolume] > 0.0 && unloaded[Name::PlasticArea] > 0.0);
    assert!(unloaded[Name::Force].abs() < 1e-12);
}

/// Numbers of an array of a VTK file.
fn array(text: &str, name: &str) -> Vec<f64> {
    let (_, behind) = text.split_once(&format!("Name=\"{name}\"")).unwrap();
    let (_, values) = behind.split_once('>').unwrap();
    let bytes = STANDARD.decode(values.split_once('<').unwrap().0).unwrap();
    let (count, values) = bytes.split_first_chunk::<8>().unwrap();
    assert_eq!(u64::from_le_bytes(*count), values.len() as u64);
    values.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect()
}

/// Both bodies in one grid, which goes down from the deepest layer of the upper one.
#[test]
#[expect(clippy::float_cmp, reason = "numbers are copied")]
fn layers_are_a_grid_of_both_bodies() {
    let mut job = ellipsoid(0.0, None, &json!({"force": 100}));
    job["upper"]["material"] = json!({"young_modulus": 70_000, "poisson_ratio": 0.2});
    job["output"] = json!({"fields": true});
    let report = solve(&job);
    let layers = report.steps[0].layers.as_ref().unwrap();
    let [upper, lower] = [&layers.upper, &layers.lower].map(|body| body.as_ref().unwrap());
    let [nx, ny, nz] = [&lower.x, &lower.y, &lower.z].map(Vec::len);
    let parsed = Job::from_value(&job).unwrap();
    let text = Export::FieldVtr.write(&parsed, &report, None).unwrap();
    assert!(text.contains(&format!("WholeExtent=\"0 {nx} 0 {ny} 0 {}\"", 2 * nz)));
    let z = array(&text, "z");
    assert!(z.is_sorted() && z[nz] == 0.0 && z[2 * nz] == *lower.z_faces.last().unwrap());
    assert_near(z[0], -lower.z_faces[nz], 1e-15);
    let (stress, von_mises) = (array(&text, "stress"), array(&text, "von_mises"));
    assert_eq!(stress.len(), 6 * 2 * nx * ny * nz);
    for (i, j, k) in [(2, 1, 0), (nx / 2, ny / 2, 3), (nx - 1, 0, nz - 1)] {
        let here = (k * nx + i) * ny + j;
        let below = ((nz + k) * ny + j) * nx + i;
        let above = ((nz - 1 - k) * ny + j) * nx + i;
        assert_eq!(
            [von_mises[above], von_mises[below]],
            [upper.von_mises[here], lower.von_mises[here]]
        );
        let components =
            |cell: usize| -> [f64; 6] { stress[6 * cell..6 * cell + 6].try_into().unwrap() };
        let [xx, _, zz, xy, yz, xz] = components(below);
        assert_eq!(
            [xx, zz, xy],
            [lower.sigma_xx[here], lower.sigma_zz[here], lower.sigma_xy[here]]
        );
        assert_eq!([yz, xz], [lower.sigma_yz[here], lower.sigma_xz[here]]);
        let [_, yy, _, _, yz, xz] = components(above);
        assert_eq!(
            [yy, yz, xz],
            [upper.sigma_yy[here], -upper.sigma_yz[here], -upper.sigma_xz[here]]
        );
    }
}

/// What must hold of any answer.
fn assert_sound(job: &Value, report: &Report) {
    let text = serde_json::to_string(report).unwrap();
    assert!(!text.contains("NaN"), "{job}");
    for step in report.steps.iter().filter(|step| step.status == SolveStatus::Converged) {
        let [a, b] = [step[Name::SemiAxisA], step[Name::SemiAxisB]];
        assert!(
            b >= 0.9 * a && step.value(Name::LargestCellPressure) != Some(0.0),
            "{job}: {a} {b}"
        );
        if step[Name::Force] > 0.0 {
            let hertz = |name: Name| step.elastic(name).unwrap();
            assert!(step[Name::PeakPressure] < 1.08 * hertz(Name::PeakPressure), "{job}");
            assert!(a > 0.8 * hertz(Name::SemiAxisA), "{job}");
        }
    }
}

/// Balls, rollers and raceways in any direction, elastic and yielding, single loads, sweeps and
/// histories.
#[test]
#[ignore = "full"]
fn random_contacts_in_three_dimensions_are_sound() {
    let count =
        std::env::var("BRINELL_RANDOM_JOBS").ok().and_then(|text| text.parse().ok()).unwrap_or(30);
    let mut converged = 0;
    for seed in 0..count {
        let job = half_spaces(&mut Random(seed));
        let report = solve(&job);
        assert_sound(&job, &report);
        converged += usize::from(report.status == SolveStatus::Converged);
        if report.status != SolveStatus::Converged {
            println!("{seed} {:?}: {job}", report.status);
        }
    }
    assert!(converged as u64 * 20 >= count * 19, "only {converged} of {count} converge");
}

/// Name, value and estimated error of the figures of a step that have one.
fn figures_with_errors(step: &StepReport) -> Vec<(&'static str, f64, f64)> {
    let named = [
        ("peak pressure", Name::PeakPressure),
        ("a", Name::SemiAxisA),
        ("b", Name::SemiAxisB),
        ("area", Name::ContactArea),
        ("approach", Name::Approach),
        ("approach", Name::PermanentApproach),
        ("plastic strain", Name::MaxPlasticStrain),
        ("dent", Name::DentDepth),
        ("pile-up", Name::PileUp),
        ("residual stress", Name::LeastStress),
    ];
    let row =
        |(word, name): (&'static str, Name)| Some((word, step.value(name)?, step.bar(name)?));
    named.into_iter().filter_map(row).collect()
}

/// Estimated errors of random jobs beside what twice the cells change.
#[test]
#[ignore = "full"]
fn estimated_errors_cover_what_finer_grids_change() {
    let count =
        std::env::var("BRINELL_RANDOM_JOBS").ok().and_then(|text| text.parse().ok()).unwrap_or(30);
    let mut all: BTreeMap<&str, Vec<[f64; 2]>> = BTreeMap::new();
    for seed in 0..count {
        let mut job = half_spaces(&mut Random(1000 + seed));
        let force = job["load"]["force"].clone();
        if force.is_f64() {
            // Dents are what random jobs seldom leave.
            job["load"] = json!({"history": [{"force": force}, {"force": 0}]});
            job["solver"]["theory"] = json!("flow");
        }
        let cells = 4 + seed % 3;
        let [coarse, fine] = [cells, 2 * cells].map(|cells| {
            job["mesh"]["elements_per_half_width"] = json!(cells);
            solve(&job)
        });
        for (coarse, fine) in coarse.steps.iter().zip(&fine.steps) {
            let truth: BTreeMap<_, _> = figures_with_errors(fine)
                .into_iter()
                .map(|(name, value, _)| (name, value))
                .collect();
            for (name, value, error) in figures_with_errors(coarse) {
                let Some(truth) = truth.get(name).filter(|_| value != 0.0) else { continue };
                let change = (truth / value - 1.0).abs();
                if change > error {
                    let place = coarse.peak_position() / coarse[Name::SemiAxisA];
                    println!(
                        "{seed}, {cells} cells, {:?}, {} increments, peak at {place:.2}: {name} \
                         {value} changes by {change:.4}, bar {error:.4}",
                        coarse.load,
                        coarse.increments.as_ref().map_or(0, |ends| ends.force.len()),
                    );
                }
                all.entry(name).or_default().push([change, error]);
            }
        }
    }
    let median = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let (mut covered, mut total) = (0, 0);
    for (name, pairs) in &all {
        let within = pairs.iter().filter(|[change, error]| *change <= *error + 1e-12).count();
        let [change, error] =
            [0, 1].map(|k: usize| 100.0 * median(pairs.iter().map(|pair| pair[k]).collect()));
        println!("| {name} | {} | {within} | {error:.2} | {change:.2} |", pairs.len());
        (covered, total) = (covered + within, total + pairs.len());
    }
    // Thirty jobs tell 95 % to within 3 %.
    assert!(total as u64 > 8 * count && 100 * covered >= 92 * total, "{covered} of {total}");
}

/// Pressures between cells and means over cells meet where a body begins to yield.
#[test]
fn the_peak_goes_on_where_yield_begins() {
    let job = |load: &Value| ellipsoid(0.0, Some(1000.0), load);
    let onset = solve(&job(&json!({"onset": true}))).steps[0][Name::Force];
    let loads: Vec<f64> = [0.97, 1.0, 1.03, 1.06, 1.1, 1.2].map(|part| part * onset).to_vec();
    let report = solve(&job(&json!({"forces": loads})));
    let mut before = 0.0;
    for step in &report.steps {
        let peak = step[Name::PeakPressure];
        assert!(peak > 0.99 * before, "{peak} after {before}");
        before = peak;
        let middle = step.value(Name::MiddlePressure);
        assert!(middle.is_none_or(|middle| middle <= peak), "{middle:?} of {peak}");
    }
    let ends = [0, 5].map(|k: usize| report.steps[k][Name::PeakPressure]);
    assert!(ends[1] > 1.03 * ends[0], "{ends:?}");
}
