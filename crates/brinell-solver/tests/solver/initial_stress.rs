//! Stress before the load: what depends on the depth below a plane alone moves nothing; what is
//! not in equilibrium relaxes to the closed form of a ring; yield begins where the sum of both
//! stresses says.

use std::sync::Arc;

use brinell_solver::analytical::HertzLine;
use brinell_solver::fem::assembly::PointStresses;
use brinell_solver::fem::element::{Quad, StressState};
use brinell_solver::fem::mesh::Mesh;
use brinell_solver::job::Job;
use brinell_solver::material::{DeformationPlasticity, ElasticModuli, OutOfPlane};
use brinell_solver::report::{Name, Report, StepReport};
use brinell_solver::solver::SolveStatus;
use serde_json::{Value, json};

use crate::bodies::{Specimen, grid, material};
use crate::problems::{assert_within, parse, report};

fn step(report: &Report) -> &StepReport {
    assert_eq!(report.status, SolveStatus::Converged);
    &report.steps[0]
}

/// A cylinder on a block with a layer under compression.
fn pressed(analysis: &str, initial: &Value) -> Value {
    let mut lower = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3});
    if !initial.is_null() {
        lower["initial_stress"] = initial.clone();
    }
    json!({"analysis": analysis, "load": {"force": 400.0},
        "upper": {"shape": {"type": "cylinder", "radius": 10.0},
                  "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3}},
        "lower": {"shape": {"type": "block", "width": 100.0, "depth": 50.0}, "material": lower}})
}

fn peened() -> Value {
    json!([{"depth": 0.0, "sigma_x": -500.0, "sigma_z": -500.0}, {"depth": 0.1, "sigma_x": -650.0,
        "sigma_z": -650.0},
           {"depth": 0.4, "sigma_x": 60.0, "sigma_z": 60.0}, {"depth": 3.0, "sigma_x": 0.0,
               "sigma_z": 0.0}])
}

fn hard() -> Value {
    json!({"law": "bilinear", "yield_stress": 4000.0, "tangent_modulus": 1000.0})
}

/// A stress of depth alone moves nothing in a block, under either theory, with or without a
/// hardening curve; it adds to the stress of the load.
#[test]
fn a_stress_of_depth_alone_moves_nothing() {
    for analysis in ["plane_strain", "axisymmetric"] {
        for theory in ["deformation", "flow"] {
            let mut jobs = [pressed(analysis, &Value::Null), pressed(analysis, &peened())];
            for job in &mut jobs {
                job["lower"]["material"]["plasticity"] = hard();
                job["solver"] = json!({"theory": theory});
            }
            let [plain, stressed] = jobs.each_ref().map(report);
            let (plain, stressed) = (step(&plain), step(&stressed));
            assert_within(stressed.approach().unwrap(), plain.approach().unwrap(), 1e-9);
            assert_within(stressed[Name::HalfWidth], plain[Name::HalfWidth], 1e-9);
            for name in [Name::Work, Name::ElasticEnergy] {
                if let Some(expected) = plain.value(name) {
                    assert_within(stressed[name], expected, 1e-6);
                }
            }
            for (a, b) in stressed.contact.nodes.pressure.iter().zip(&plain.contact.nodes.pressure)
            {
                assert!((a - b).abs() < 1e-9 * plain[Name::PeakPressure]);
            }
            assert!(
                stressed.elastic(Name::PeakPressure).is_some()
                    && stressed.value(Name::FirstYieldForce).is_none()
            );
            let [with, without] = [stressed, plain]
                .map(|step| step.subsurface.as_ref().unwrap().lower.clone().unwrap());
            let initial = with.initial_sigma_x.as_ref().unwrap();
            for (k, depth) in with.depth.iter().enumerate().filter(|(_, depth)| **depth < 2.0) {
                let sum = without.sigma_x[k] + initial[k];
                assert!(
                    (with.sigma_x[k] - sum).abs() < 1e-6 * 650.0,
                    "{depth}: {} {sum}",
                    with.sigma_x[k]
                );
                assert!(with.initial_sigma_y.as_ref().unwrap()[k].abs() < 20.0);
            }
            // The mean over an element misses the kink by what it turns over half of one.
            let at_kink = initial.iter().copied().fold(0.0, f64::min);
            assert!((at_kink + 650.0).abs() < 25.0, "{at_kink}");
        }
    }
}

const INNER: f64 = 100.0;
const OUTER: f64 = 200.0;
const MODULI: (f64, f64) = (210_000.0, 0.3);

fn ring() -> Mesh {
    let (radial, around) = (60, 40);
    grid(radial, around, |i, j| {
        let r = INNER * (OUTER / INNER).powf(f64::from(i) / f64::from(radial));
        let angle = std::f64::consts::FRAC_PI_2 * f64::from(j) / f64::from(around);
        let (sin, cos) = if j == around { (1.0, 0.0) } else { angle.sin_cos() };
        [r * cos, r * sin]
    })
}

fn moduli() -> ElasticModuli {
    ElasticModuli::from(&material(MODULI.0, MODULI.1, None).elastic)
}

/// What is left of `[σ_r, σ_θ](r)` in a ring with free surfaces, as `[r, σ_r, σ_θ]` of each
/// element.
fn relaxed(given: impl Fn(f64) -> [f64; 2]) -> Vec<[f64; 3]> {
    let mesh = ring();
    let held = mesh.nodes.iter().map(|[x, y]| [*x == 0.0, *y == 0.0]).collect();
    let model = Arc::new(DeformationPlasticity::with_law(moduli(), None, OutOfPlane::Strained));
    let specimen = Specimen::new(&mesh, StressState::PlaneStrain, model, held);
    let stress: PointStresses = specimen.relaxed(|[x, y]| {
        let r = x.hypot(y);
        let ([radial, hoop], [c, s]) = (given(r), [x / r, y / r]);
        [
            radial * c * c + hoop * s * s,
            radial * s * s + hoop * c * c,
            MODULI.1 * (radial + hoop),
            (radial - hoop) * s * c,
        ]
    });
    let means = stress.iter().enumerate().map(|(element, points)| {
        let corners = mesh.corners(element);
        let place: [f64; 2] =
            std::array::from_fn(|k| (0..4).map(|g| 0.25 * Quad::point(&corners, g)[k]).sum());
        let [xx, yy, _, xy]: [f64; 4] =
            std::array::from_fn(|k| points.iter().map(|p| 0.25 * p[k]).sum());
        let r = place[0].hypot(place[1]);
        let [c, s] = place.map(|x| x / r);
        let (along, across) = (xx * c * c + yy * s * s, xx * s * s + yy * c * c);
        [r, along + 2.0 * xy * s * c, across - 2.0 * xy * s * c]
    });
    means.collect()
}

/// A ring in which the stress of a pressure in its bore is left without the pressure has no
/// stress.
#[test]
fn the_stress_of_a_pressure_that_is_gone_relaxes_to_nothing() {
    let pressure = 100.0;
    let lame = |r: f64| {
        let factor = pressure / ((OUTER / INNER).powi(2) - 1.0);
        [factor * (1.0 - (OUTER / r).powi(2)), factor * (1.0 + (OUTER / r).powi(2))]
    };
    for [r, radial, hoop] in relaxed(lame) {
        assert!(radial.abs().max(hoop.abs()) < 2e-3 * pressure, "{r}: {radial} {hoop}");
    }
}

/// A hoop stress g alone, the same everywhere, relaxes to `u = g/M (r/2 ln r - r/4) + A r + B/r`
/// with `M = K + 4G/3`, both surfaces free.
#[test]
fn a_hoop_stress_relaxes_to_its_closed_form() {
    let (g, ElasticModuli { bulk, shear }) = (-400.0, moduli());
    let (m, lame) = (bulk + 4.0 / 3.0 * shear, bulk - 2.0 / 3.0 * shear);
    let strain = |r: f64, [a, b]: [f64; 2]| {
        let half = 0.5 * r.ln();
        [g / m * (half + 0.25) + a - b / (r * r), g / m * (half - 0.25) + a + b / (r * r)]
    };
    let radial = |r: f64, constants: [f64; 2]| {
        let [along, around] = strain(r, constants);
        m * along + lame * around
    };
    // Radial stress is linear in the two constants.
    let rest = |r: f64| radial(r, [0.0; 2]);
    let of = |r: f64| [radial(r, [1.0, 0.0]) - rest(r), radial(r, [0.0, 1.0]) - rest(r)];
    let ([p, q], [s, t]) = (of(INNER), of(OUTER));
    let determinant = p * t - q * s;
    let constants = [
        (-rest(INNER) * t + rest(OUTER) * q) / determinant,
        (-rest(OUTER) * p + rest(INNER) * s) / determinant,
    ];
    assert!(radial(INNER, constants).abs() + radial(OUTER, constants).abs() < 1e-9);
    let mut largest: f64 = 0.0;
    for [r, found_radial, found_hoop] in relaxed(|_| [0.0, g]) {
        let [along, around] = strain(r, constants);
        let hoop = m * around + lame * along + g;
        largest = largest.max(hoop.abs());
        assert!(
            (found_radial - radial(r, constants)).abs() < 2e-3 * g.abs(),
            "{r}: {found_radial}"
        );
        assert!((found_hoop - hoop).abs() < 2e-3 * g.abs(), "{r}: {found_hoop} {hoop}");
    }
    assert!(largest > 0.1 * g.abs());
}

/// Onset of yield under the sum of both stresses, within 0.5 %, of a layer under compression and
/// one under tension.
#[test]
fn onset_of_yield_in_a_stressed_block() {
    let (yield_stress, poisson): (f64, f64) = (800.0, 0.3);
    for stress in [-300.0, 250.0] {
        let rows = json!([{"depth": 0.0, "sigma_x": stress, "sigma_z": 0.5 * stress}]);
        let mut job = pressed("plane_strain", &rows);
        job["lower"]["material"]["plasticity"] =
            json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 1000.0});
        job["load"] = json!({"onset": true});
        job["mesh"] = json!({"elements_per_half_width": 30});
        let found = report(&job);
        let peak = step(&found)[Name::PeakPressure];
        let highest = |peak: f64| {
            let hertz = HertzLine::from_peak_pressure(peak, 10.0, 0.5 * 210_000.0 / 0.91);
            let step = hertz.half_width() / 60.0;
            let at = |k: u32| {
                let (x, depth) = (step * f64::from(k % 100), step * f64::from(k / 100));
                let mut sum = hertz.stress(x, depth, poisson);
                (sum.sigma_x, sum.sigma_z) = (sum.sigma_x + stress, sum.sigma_z + 0.5 * stress);
                sum.von_mises()
            };
            (0..100 * 150).map(at).fold(0.0, f64::max)
        };
        let (mut low, mut high) = (0.0, 4.0 * yield_stress);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            *(if highest(middle) > yield_stress { &mut high } else { &mut low }) = middle;
        }
        assert_within(peak, low, 5e-3);
    }
}

/// A roller with a stressed layer relaxes: what is left is in equilibrium round its circle,
/// `dσ_r/dr = (σ_θ - σ_r)/r`, and the contact is that of an elastic roller. Both theories agree
/// where hardly anything yields.
#[test]
fn a_stressed_roller() {
    let plasticity = json!({"law": "bilinear", "yield_stress": 900.0, "tangent_modulus": 5000.0});
    let job = |theory: &str, initial: bool| {
        let mut body = json!({"shape": {"type": "cylinder", "radius": 10.0}, "support": "roller",
            "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3,
                "plasticity": plasticity}});
        if initial {
            body["material"]["initial_stress"] = json!([{"depth": 0.0, "sigma_x": -300.0,
                "sigma_z": -300.0},
                {"depth": 0.3, "sigma_x": -300.0, "sigma_z": -300.0}, {"depth": 0.6,
                    "sigma_x": 0.0, "sigma_z": 0.0}]);
        }
        json!({"analysis": "plane_strain", "upper": body, "lower": body, "load": {"force": 420.0},
            "solver": {"theory": theory}})
    };
    let [plain, stressed, flow] = [("deformation", false), ("deformation", true), ("flow", true)]
        .map(|(theory, initial)| report(&job(theory, initial)));
    let (plain, stressed, flow) = (step(&plain), step(&stressed), step(&flow));
    // What yields is not quite the same.
    assert_within(stressed[Name::HalfWidth], plain[Name::HalfWidth], 1.5e-2);
    assert_within(flow[Name::PeakPressure], stressed[Name::PeakPressure], 5e-3);
    assert_within(flow.approach().unwrap(), stressed.approach().unwrap(), 2e-3);
    let body = stressed.subsurface.as_ref().unwrap().upper.as_ref().unwrap();
    let (hoop, radial) =
        (body.initial_sigma_x.as_ref().unwrap(), body.initial_sigma_y.as_ref().unwrap());
    // The layer pulls on what is below it: its stress over the radius, added up from the free
    // surface.
    let mut sum = 0.0;
    for k in 1..body.depth.len() {
        let (depth, step) = (body.depth[k], body.depth[k] - body.depth[k - 1]);
        let middle = 10.0 - 0.5 * (depth + body.depth[k - 1]);
        let difference = 0.5 * (hoop[k] + hoop[k - 1] - radial[k] - radial[k - 1]);
        sum -= step * difference / middle;
        if depth < 1.5 {
            assert!((radial[k] - sum).abs() < 0.6, "{depth}: {} {sum}", radial[k]);
        }
    }
    assert!(hoop[1] < -250.0 && sum.abs() > 1.0);
    // What is stored before the load is no work of it: the area under the curve of force over
    // approach.
    let ends = flow.increments.as_ref().unwrap();
    let (force, approach) = (&ends.force, &ends.approach);
    let power = (force[0].ln() - force[1].ln()) / (approach[0].ln() - approach[1].ln());
    let mut area = force[0] * approach[0] / (1.0 + power);
    for k in 1..force.len() {
        area += 0.5 * (force[k] + force[k - 1]) * (approach[k] - approach[k - 1]);
    }
    assert_within(flow[Name::Work], area, 1e-2);
}

/// Whatever cannot be answered is refused, with the field at fault; what can is written back as it
/// was read.
#[test]
fn rows_are_checked() {
    let refused = |job: &Value| {
        Job::from_value(job)
            .map_or_else(|error| format!("{error:?}"), |_| String::from("accepted"))
    };
    let mut falling = pressed("plane_strain", &peened());
    falling["lower"]["material"]["initial_stress"][1]["depth"] = json!(0.0);
    assert!(refused(&falling).contains("/lower/material/initial_stress/1/depth"));
    let mut weak = pressed("plane_strain", &peened());
    weak["lower"]["material"]["plasticity"] =
        json!({"law": "bilinear", "yield_stress": 600.0, "tangent_modulus": 0.0});
    let message = refused(&weak);
    assert!(
        message.contains("/lower/material/initial_stress") && message.contains("yields by itself"),
        "{message}"
    );
    weak["lower"]["material"]["plasticity"]["over_depth"] = json!([[0.0, 1.2], [0.4, 1.0]]);
    assert_eq!(refused(&weak), "accepted");
    let mut everywhere = pressed("plane_strain", &peened());
    everywhere["lower"]["material"]["plasticity"] = json!({"law": "ramberg_osgood",
        "reference_stress": 900.0, "offset": 0.3, "exponent": 5.0});
    assert!(refused(&everywhere).contains("yield point"));
    assert!(refused(&pressed("plane_stress", &peened())).contains("/0/sigma_z"));
    let mut uneven = pressed("axisymmetric", &peened());
    uneven["lower"]["material"]["initial_stress"][0]["sigma_z"] = json!(0.0);
    assert!(refused(&uneven).contains("/0/sigma_z"));
    let mut secant = pressed("plane_strain", &peened());
    secant["solver"] = json!({"coupling": "secant_stiffness"});
    assert!(refused(&secant).contains("/solver/coupling"));
    assert!(refused(&pressed("plane_strain", &json!([]))).contains("initial_stress"));
    let mut rigid = pressed("plane_strain", &peened());
    rigid["lower"]["material"] = json!({"rigid": true, "initial_stress": peened()});
    assert!(refused(&rigid).contains("/lower/material/initial_stress"));
    let job = parse(&pressed("plane_strain", &peened()));
    assert_eq!(Job::from_value(&serde_json::to_value(&job).unwrap()).unwrap(), job);
}

/// Layers of ten cells find the onset under a stress that changes within them.
#[test]
fn the_onset_under_an_initial_stress_does_not_hang_on_the_layers() {
    let force = |elements: u32| {
        let material = json!({"young_modulus": 207_000, "poisson_ratio": 0.3,
            "plasticity": {"law": "bilinear", "yield_stress": 1000, "tangent_modulus": 0},
            "initial_stress": [{"depth": 0.0, "sigma_x": -300, "sigma_z": -200},
                {"depth": 0.05, "sigma_x": 60, "sigma_z": 20},
                {"depth": 0.12, "sigma_x": 0, "sigma_z": 0}]});
        let job = json!({"analysis": "three_dimensional", "load": {"onset": true},
            "upper": {"shape": {"type": "curved", "radius_x": 8, "radius_y": 20},
                "material": {"rigid": true}},
            "lower": {"shape": {"type": "flat"}, "material": material},
            "mesh": {"elements_per_half_width": elements}});
        let step = report(&job).steps.remove(0);
        (step[Name::Force], step.bar(Name::Force).unwrap())
    };
    let ((coarse, bar), (fine, _)) = (force(10), force(20));
    assert!((coarse / fine - 1.0).abs() < bar.min(0.01), "{coarse} {fine} {bar}");
}
