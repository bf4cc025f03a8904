//! First yield of a line contact: p0/σ_y = 1.794 at a depth of 0.704 a (ν = 0.3, von Mises, plane strain).

use serde_json::{Value, json};

use crate::problems::{assert_within, cylinder, report};

fn small_cylinders(force: f64, plasticity: Value) -> Value {
    let mut body = cylinder("clamped", plasticity);
    body["shape"]["radius"] = json!(10.0);
    json!({"analysis": "plane_strain", "upper": body, "lower": body, "load": {"force": force}})
}

/// Two steel cylinders, R 10 mm, σ_y 350 MPa: P_Y = 53.65 N/mm, a = 0.05441 mm, at z = 0.0383 mm.
#[test]
fn closed_form_and_mesh_agree_on_the_onset() {
    let elastic = report(&small_cylinders(53.65, Value::Null));
    let step = &elastic.steps[0];
    let profile = step.subsurface.as_ref().unwrap().lower.as_ref().unwrap();
    let (k, most) = profile.von_mises.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).unwrap();
    assert_within(step.contact.peak_pressure / most, 1.794, 5e-3);
    assert!((profile.depth[k] - 0.0383).abs() < 0.002, "{}", profile.depth[k]);
    assert_within(step.contact.half_width, 0.05441, 0.02);
}

#[test]
fn the_reported_onset_force_is_the_closed_form() {
    let law = json!({"law": "bilinear", "yield_stress": 350.0, "tangent_modulus": 2100.0});
    let step = &report(&small_cylinders(60.0, law.clone())).steps[0];
    assert_within(step.hertz.as_ref().unwrap().yield_onset_force.unwrap(), 53.65, 1e-4);
    assert!(step.plasticity.upper.as_ref().unwrap().yielded);

    // 2 % below the onset nothing yields, although the solver was ready for it.
    let step = &report(&small_cylinders(0.98 * 53.65, law)).steps[0];
    let plasticity = step.plasticity.upper.as_ref().unwrap();
    assert!(!plasticity.yielded);
    assert_eq!(plasticity.max_equivalent_plastic_strain, 0.0);
    assert_eq!(plasticity.area, 0.0);
    assert_eq!(step.history.len(), 1);
}
