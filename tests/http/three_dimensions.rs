//! Contacts in three dimensions through the service.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::curl::{row, value};
use crate::server::Server;

fn raceway() -> Value {
    serde_json::from_str(include_str!("../../api/examples/ball_in_raceway.json")).unwrap()
}

/// A rigid ball of 10 mm on steel: Hertz's p0 = (6 P E*²/(π³ R²))^(1/3), a = (3 P R/(4 E*))^(1/3).
fn ball() -> Value {
    json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"},
            "material": {"young_modulus": 210_000, "poisson_ratio": 0.3}},
        "load": {"force": 100},
    })
}

fn figure(value: &Value, pointer: &str) -> f64 {
    value
        .pointer(pointer)
        .and_then(Value::as_f64)
        .unwrap_or_else(|| panic!("{pointer} in {value}"))
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} and not {expected}");
}

/// Each increment is reported, of a history in three dimensions as well.
#[test]
fn increments_count_in_the_estimate() {
    let server = Server::start();
    let estimate = |loads: usize, increments: usize| {
        let mut job = ball();
        job["lower"]["material"]["plasticity"] =
            json!({"law": "bilinear", "yield_stress": 1000, "tangent_modulus": 2000});
        let load =
            |number: usize| json!({"force": if number.is_multiple_of(2) { 100 } else { 50 }});
        job["load"] = json!({"history": (0..loads).map(load).collect::<Vec<_>>()});
        job["solver"] = json!({"theory": "flow", "increments": increments});
        server.target.post("/v1/validate", job.to_string())
    };
    let (few, many) = (estimate(10, 10).json(), estimate(10, 1000).json());
    for figure in ["/estimate/bytes", "/estimate/result_bytes"] {
        assert!(few.pointer(figure).unwrap().as_u64() < many.pointer(figure).unwrap().as_u64());
    }
    estimate(1000, 10_000).problem(422, "job-too-large");
}

#[test]
fn a_ball_is_the_contact_of_hertz() {
    let server = Server::start();
    let answer = server.target.post("/v1/solve", ball().to_string());
    assert_eq!(answer.status, 200, "{}", answer.json());
    let step = answer.json()["result"]["steps"][0].clone();
    let elastic = |name: &str| row(&step, name)["elastic"].as_f64().unwrap();
    let modulus = 210_000.0 / 0.91;
    let radius = f64::cbrt(0.75 * 100.0 * 10.0 / modulus);
    assert_near(
        value(&step, "peak_pressure"),
        150.0 / (std::f64::consts::PI * radius * radius),
        3e-3,
    );
    assert_near(value(&step, "semi_axis_a"), radius, 2e-2);
    assert_near(value(&step, "semi_axis_b"), radius, 2e-2);
    assert_near(value(&step, "approach"), radius * radius / 10.0, 1e-3);
    assert_near(elastic("semi_axis_a"), radius, 1e-9);
    assert_near(value(&step, "contact_stiffness"), 2.0 * modulus * radius, 2e-2);
    assert!(row(&step, "peak_pressure")["error"].as_f64().unwrap() < 0.02);
    // In bodies of revolution the largest shear stress is 0.31 p0 at 0.48 a.
    let shears = step["subsurface"]["lower"]["tau_max"].as_array().unwrap();
    let largest = shears.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    assert_near(largest, 0.310 * elastic("peak_pressure"), 1e-2);
    let closed = server.target.post("/v1/hertz", ball().to_string()).json();
    assert_near(figure(&closed, "/steps/0/half_width"), radius, 1e-9);
}

#[test]
fn a_raceway_is_kept_and_read_back_in_every_form() {
    let server = Server::start();
    let mut asked = raceway();
    asked["output"] = json!({"fields": true});
    let estimate = server.target.post("/v1/validate", asked.to_string()).json();
    let job = server.target.submit(&asked);
    server.target.wait_for(&job, &["succeeded"]);
    let answer = server.target.get(&format!("{job}/result"));
    let report = answer.json();
    assert_eq!(report["analysis"], "three_dimensional");
    let step = &report["steps"][0];
    let maps = &step["contact"]["maps"];
    let elastic = |name: &str| row(step, name)["elastic"].as_f64().unwrap();
    // The groove fits the ball: the contact is long across it, along y.
    assert!(value(step, "semi_axis_b") > 4.0 * value(step, "semi_axis_a"));
    assert_near(value(step, "semi_axis_b"), elastic("semi_axis_b"), 2e-2);
    // Arcs open less than parabolas, and forces are inclined.
    let conforming = 1.005 * elastic("peak_pressure");
    assert_near(value(step, "peak_pressure"), conforming, 3e-3);
    let [columns, rows] = ["x", "y"].map(|axis| maps[axis].as_array().unwrap().len());
    assert_eq!(maps["pressure"].as_array().unwrap().len(), columns * rows);
    let layers = &step["layers"]["lower"];
    let count = layers["z"].as_array().unwrap().len();
    assert_eq!(layers["sigma_xz"].as_array().unwrap().len(), columns * rows * count);
    assert!(step["fields"].is_null() && step["layers"]["upper"].is_object());
    let arrays = server.target.get(&format!("{job}/fields/1"));
    assert!(arrays.body.len() > 2 * 14 * 4 * columns * rows * count, "in single precision");
    let summary = server.target.get(&format!("{job}/result?fields=summary")).json();
    assert!(summary["steps"][0]["contact"]["maps"].is_null());
    assert!(summary["steps"][0]["layers"].is_null());
    let alone = server.target.get(&format!("{job}/result?fields=maps")).json()["steps"][0].clone();
    assert_eq!(&alone["contact"]["maps"], maps);
    assert!(alone["layers"].is_null(), "a map is drawn without them");
    let parts = "contact,subsurface,plasticity,history";
    let without = server.target.get(&format!("{job}/result?fields={parts}")).json();
    assert!(without["steps"][0]["contact"]["maps"].is_null(), "maps are fields");
    assert!(without["steps"][0]["layers"].is_null());
    assert!(estimate["estimate"]["result_bytes"].as_u64().unwrap() > 1000, "{estimate}");
    for (file, beginning, lines) in [
        ("summary.csv", "step,status,peak_pressure [MPa],", 2),
        ("pressure.csv", "step,x [mm],y [mm],pressure [MPa],gap [mm]\n", 1 + columns * rows),
        ("subsurface.csv", "step,body,depth [mm],sigma_xx [MPa],sigma_zz [MPa],sigma_yy [MPa]", 3),
        ("pressure.svg", "<svg ", 3),
        ("depth.svg", "<svg ", 3),
        ("field.vtu", "<?xml version", 3),
        ("field.vtr", "<?xml version", 3),
    ] {
        let answer = server.target.get(&format!("{job}/{file}"));
        let text = String::from_utf8(answer.body.clone()).unwrap();
        assert_eq!(answer.status, 200, "{file}: {text}");
        assert!(
            text.starts_with(beginning) && text.lines().count() >= lines,
            "{file}: {text:.200}"
        );
    }
}

#[test]
fn a_sweep_has_a_curve_and_a_fault_has_its_place() {
    let server = Server::start();
    let mut sweep = ball();
    sweep["load"] = json!({"forces": [50, 100, 200]});
    sweep["mesh"] = json!({"elements_per_half_width": 6});
    sweep["output"] = json!({"fields": true});
    let solved = server.target.post("/v1/solve", sweep.to_string()).json();
    let report = solved["result"].clone();
    let vtu = server
        .target
        .get(&format!("{}?step=2", solved["links"]["field_vtu"].as_str().unwrap()))
        .body;
    assert!(String::from_utf8(vtu).unwrap().contains("step 2 of 3"));
    let curve: Vec<f64> =
        serde_json::from_value(report["load_approach"]["approach"].clone()).unwrap();
    assert_near(curve[2] / curve[0], 4f64.powf(2.0 / 3.0), 2e-3);
    let mut wrong = ball();
    wrong["lower"]["support"] = json!("clamped");
    wrong["solver"] = json!({"contact": "simplex"});
    let problem = server.target.post("/v1/validate", wrong.to_string()).json();
    let faults = problem["errors"].as_array().unwrap();
    let pointers: Vec<_> = faults.iter().map(|fault| fault["pointer"].as_str().unwrap()).collect();
    assert_eq!(pointers, ["#/lower/support", "#/solver/contact"]);
}

/// On 30 cells over a semi-axis.
#[test]
fn a_large_job_is_cancelled_at_once() {
    let server = Server::start();
    let mut large = ball();
    large["mesh"] = json!({"elements_per_half_width": 30});
    large["lower"]["material"]["plasticity"] =
        json!({"law": "bilinear", "yield_stress": 300, "tangent_modulus": 0});
    large["load"] = json!({"force": 200});
    let job = server.target.submit(&large);
    server.target.wait_for(&job, &["running"]);
    let asked = Instant::now();
    assert_eq!(server.target.post(&format!("{job}/cancel"), "").status, 200);
    server.target.wait_for(&job, &["cancelled"]);
    let waited = asked.elapsed();
    assert!(waited < Duration::from_millis(1500), "{waited:?} in a debug build");
}

/// The generator splitmix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn one_of<T: Clone>(&mut self, all: &[T]) -> T {
        let part = self.next();
        let last =
            all.iter().enumerate().rev().find(|(k, _)| *k as f64 <= part * all.len() as f64);
        last.map_or(&all[0], |(_, one)| one).clone()
    }
}

/// Bodies that may be anything, sound or not.
fn any_job(random: &mut Random) -> Value {
    let radius = |random: &mut Random| {
        random.one_of(&[json!(null), json!(-6), json!(4), json!(12), json!(300)])
    };
    let mut body = |is_upper: bool| {
        let shape = match random.one_of(&[0, 1, 2]) {
            0 => json!({"type": "sphere", "radius": random.one_of(&[0.01, 5.0, 2000.0])}),
            1 => json!({"type": "flat"}),
            _ => json!({"type": "curved", "radius_x": radius(random), "radius_y": radius(random),
                "rotation": 180.0 * random.next() - 90.0}),
        };
        if is_upper && random.next() < 0.3 {
            return json!({"shape": shape, "material": {"rigid": true}});
        }
        let mut material = json!({"young_modulus": random.one_of(&[2000, 210_000]),
            "poisson_ratio": 0.49 * random.next()});
        if random.next() < 0.7 {
            material["plasticity"] = random.one_of(&[
                json!({"law": "bilinear", "yield_stress": 600, "tangent_modulus": 0}),
                json!({"law": "bilinear", "yield_stress": 600, "tangent_modulus": 5000,
                    "over_depth": [[0, 1.5], [0.1, 1]],
                    "backstress": [{"modulus": 30_000, "rate": 60}]}),
                json!({"law": "voce", "yield_stress": 400, "saturation_stress": 700, "rate": 50}),
                json!({"law": "ramberg_osgood", "reference_stress": 500, "offset": 0.4,
                    "exponent": 6}),
            ]);
        }
        if random.next() < 0.3 {
            material["initial_stress"] = json!([{"depth": 0, "sigma_x": -300, "sigma_z": -200},
                {"depth": 0.2, "sigma_x": 0, "sigma_z": 0}]);
        }
        json!({"shape": shape, "material": material})
    };
    let (upper, lower) = (body(true), body(false));
    let (force, approach) = (10f64.powf(6.0 * random.next() - 1.0), 0.1 * random.next());
    let load = random.one_of(&[
        json!({"force": force}),
        json!({"approach": approach}),
        json!({"forces": [0.2 * force, force]}),
        json!({"history": [{"force": force}, {"force": 0}]}),
        json!({"onset": true}),
        json!({"target": {"peak_pressure": 1500}}),
        json!({"target": {"dent_depth": 1e-3}}),
    ]);
    let theory = random.one_of(&["deformation", "flow"]);
    json!({"analysis": "three_dimensional", "upper": upper, "lower": lower, "load": load,
        "mesh": {"elements_per_half_width": 4}, "solver": {"theory": theory},
        "output": {"fields": random.next() < 0.3}})
}

/// An answer, or a fault that is named: nothing of it is the service's own.
#[test]
#[ignore = "full"]
fn any_bodies_are_solved_or_refused() {
    let server = Server::start();
    let count =
        std::env::var("BRINELL_RANDOM_JOBS").ok().and_then(|text| text.parse().ok()).unwrap_or(60);
    let mut solved = 0;
    for seed in 0..count {
        let job = any_job(&mut Random(seed));
        let begin = Instant::now();
        let answer = server.target.post("/v1/solve", job.to_string());
        println!("{seed}: {} in {:?}", answer.status, begin.elapsed());
        assert!(matches!(answer.status, 200 | 202 | 422), "{seed}: {} {job}", answer.json());
        if answer.status == 200 {
            let status = answer.json()["status"].clone();
            assert!(
                status == "succeeded" || status == "not_converged",
                "{seed}: {} {job}",
                answer.json()
            );
            solved += 1;
        }
    }
    assert!(3 * solved >= count, "{solved} of {count}");
}
