//! Contacts in three dimensions through the service.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::server::Server;

fn raceway() -> Value {
    serde_json::from_str(include_str!("../../api/examples/ball_in_raceway.json")).unwrap()
}

/// A rigid ball of 10 mm on steel: Hertz's p0 = (6 P E*²/(π³ R²))^(1/3), a = (3 P R/(4 E*))^(1/3).
fn ball() -> Value {
    json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"}, "material": {"young_modulus": 210_000, "poisson_ratio": 0.3}},
        "load": {"force": 100},
    })
}

fn figure(value: &Value, pointer: &str) -> f64 {
    value.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer} in {value}"))
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} and not {expected}");
}

#[test]
fn a_ball_is_the_contact_of_hertz() {
    let server = Server::start();
    let answer = server.target.post("/v1/solve", ball().to_string());
    assert_eq!(answer.status, 200, "{}", answer.json());
    let step = answer.json()["result"]["steps"][0].clone();
    let modulus = 210_000.0 / 0.91;
    let radius = f64::cbrt(0.75 * 100.0 * 10.0 / modulus);
    assert_near(
        figure(&step, "/contact/peak_pressure"),
        150.0 / (std::f64::consts::PI * radius * radius),
        3e-3,
    );
    assert_near(figure(&step, "/contact/half_width"), radius, 2e-2);
    assert_near(figure(&step, "/three_dimensional/b"), radius, 2e-2);
    assert_near(figure(&step, "/approach"), radius * radius / 10.0, 1e-3);
    assert_near(figure(&step, "/hertz/half_width"), radius, 1e-9);
    assert_near(figure(&step, "/contact_stiffness"), 2.0 * modulus * radius, 2e-2);
    assert!(figure(&step, "/estimated_error/peak_pressure") < 0.02);
    // In bodies of revolution the largest shear stress is 0.31 p0 at 0.48 a.
    let shears = step["subsurface"]["lower"]["tau_max"].as_array().unwrap();
    let largest = shears.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    assert_near(largest, 0.310 * figure(&step, "/hertz/peak_pressure"), 1e-2);
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
    let whole = &step["three_dimensional"];
    // The groove fits the ball: the contact is long across it, along y.
    assert!(figure(whole, "/b") > 4.0 * figure(whole, "/a"));
    assert_near(figure(whole, "/b"), figure(whole, "/hertz/b"), 2e-2);
    assert_near(figure(step, "/contact/peak_pressure"), figure(step, "/hertz/peak_pressure"), 3e-3);
    let [columns, rows] = ["x", "y"].map(|axis| whole["maps"][axis].as_array().unwrap().len());
    assert_eq!(whole["maps"]["pressure"].as_array().unwrap().len(), columns * rows);
    let layers = &step["layers"]["lower"];
    let count = layers["z"].as_array().unwrap().len();
    assert_eq!(layers["sigma_xz"].as_array().unwrap().len(), columns * rows * count);
    assert!(step["fields"].is_null() && step["layers"]["upper"].is_object());
    let arrays = server.target.get(&format!("{job}/fields/1"));
    assert!(arrays.body.len() > 2 * 14 * 4 * columns * rows * count, "in single precision");
    let summary = server.target.get(&format!("{job}/result?fields=summary")).json();
    assert!(summary["steps"][0]["three_dimensional"]["maps"].is_null());
    assert!(summary["steps"][0]["layers"].is_null());
    let parts = "contact,subsurface,plasticity,history";
    let without = server.target.get(&format!("{job}/result?fields={parts}")).json();
    assert!(without["steps"][0]["three_dimensional"]["maps"].is_null(), "maps are fields");
    assert!(without["steps"][0]["layers"].is_null());
    assert!(estimate["estimate"]["result_bytes"].as_u64().unwrap() > 1000, "{estimate}");
    for (file, beginning, lines) in [
        ("summary.csv", "step,status,force [N],", 2),
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
        assert!(text.starts_with(beginning) && text.lines().count() >= lines, "{file}: {text:.200}");
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
    let vtu = server.target.get(&format!("{}?step=2", solved["links"]["field_vtu"].as_str().unwrap())).body;
    assert!(String::from_utf8(vtu).unwrap().contains("step 2 of 3"));
    let curve: Vec<f64> = serde_json::from_value(report["load_approach"]["approach"].clone()).unwrap();
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
