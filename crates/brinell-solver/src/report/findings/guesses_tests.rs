use serde_json::{Value, json};

use super::*;
use crate::units::UnitConverter;

fn steel(plasticity: &Value) -> Value {
    json!({"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": plasticity})
}

fn bilinear(young_modulus: f64, yield_stress: f64) -> Value {
    let law = json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 0});
    json!({"young_modulus": young_modulus, "poisson_ratio": 0.3, "plasticity": law})
}

/// A cylinder of 20 mm on one of 10 mm, of this material.
fn job(material: &Value) -> Value {
    json!({
        "analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": 20}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "cylinder", "radius": 10}, "material": material},
        "load": {"force": 600},
    })
}

/// Codes and sentences of the guesses on a job.
fn told(job: &Value) -> Vec<(&'static str, String)> {
    let job = Job::from_value(job).unwrap();
    let write = UnitConverter::new(job.units, job.analysis);
    guesses(&job).into_iter().map(|guess| (guess.code(), guess.text(write))).collect()
}

/// Asserts that there is one guess, with this code, pointer and part of a sentence.
fn assert_one(job: &Value, code: &str, pointer: &str, part: &str) {
    let found = told(job);
    let [(found_code, text)] = &found[..] else { panic!("{found:?}") };
    assert_eq!(*found_code, code, "{text}");
    assert!(text.starts_with(&format!("`/lower/material/{pointer}`: ")), "{text}");
    assert!(text.contains(part), "{text}");
}

#[test]
fn common_jobs_raise_no_guess() {
    let laws = [
        json!({"law": "bilinear", "yield_stress": 12, "tangent_modulus": 0}),
        json!({"law": "ramberg_osgood", "reference_stress": 500, "offset": 0.3, "exponent": 5}),
        json!({"law": "ramberg_osgood", "reference_stress": 355, "offset": 1.183, "exponent": 10}),
        json!({"law": "swift", "yield_stress": 900, "strain_offset": 0.002, "exponent": 0.1}),
        // Annealed copper, a plateau, a straight line by two points, a curve to 200 %.
        json!({"law": "table", "points": [[0, 33], [0.002, 60], [0.05, 180], [0.3, 330]]}),
        json!({"law": "table", "points": [[0, 350], [0.015, 350], [0.05, 450], [0.15, 520]]}),
        json!({"law": "table", "points": [[0, 350], [1, 1350]]}),
        json!({"law": "table", "points": [[0, 350], [5, 352]]}),
        json!({"law": "table", "points": [[0, 350], [0.002, 400], [0.05, 520], [2, 700]]}),
        json!({"law": "table", "points": [[0, 350]]}),
        // A round curve has any slope at the start.
        json!({"law": "table", "points": [[0, 200], [1e-4, 221], [1e-3, 300], [0.1, 500]]}),
    ];
    for law in laws {
        assert!(told(&job(&steel(&law))).is_empty(), "{law}");
    }
    for material in [bilinear(2800.0, 65.0), json!({"young_modulus": 5, "poisson_ratio": 0.49})] {
        assert!(told(&job(&material)).is_empty(), "{material}");
    }
}

#[test]
fn units_that_no_solid_has_are_told_with_what_would_fit() {
    for (modulus, stress, pointer, meant) in [
        (210.0, 500.0, "young_modulus", "210000 MPa would fit"),
        (70.0, 25.0, "young_modulus", "70000 MPa would fit"),
        (210_000.0, 500_000.0, "plasticity", "500 MPa would fit"),
        (210_000.0, 0.5, "plasticity", "500 MPa would fit"),
    ] {
        assert_one(&job(&bilinear(modulus, stress)), "suspicious_units", pointer, meant);
    }
    let mut si = job(&bilinear(2.1e11, 500.0));
    si["units"] = json!("SI");
    assert_one(&si, "suspicious_units", "plasticity", " Pa would fit");
    si["lower"]["material"] = bilinear(2.1e5, 500.0);
    assert_one(&si, "suspicious_units", "young_modulus", "Units are SI");
}

#[test]
fn total_strain_is_told_with_the_yield_stress_meant() {
    for points in [
        json!([[0, 0.001], [0.0017, 350], [0.02, 400]]),
        // A record of many points, one that is 8 % too soft, σ/E after the yield stress.
        json!([[0, 1], [0.0005, 105], [0.001, 210], [0.0015, 315], [0.00167, 350], [0.02, 400]]),
        json!([[0, 0.1], [0.0009, 175], [0.0018, 350], [0.02, 400]]),
        json!([[0, 350], [0.00167, 350], [0.02, 400], [0.1, 480]]),
    ] {
        let table = job(&steel(&json!({"law": "table", "points": points})));
        let part = "As total strain it has a yield stress of 3";
        assert_one(&table, "suspicious_curve", "plasticity/points", part);
    }
}

#[test]
fn strain_in_per_cent_is_told_where_it_matters() {
    for (points, part) in [
        (json!([[0, 350], [0.2, 400], [1, 450], [5, 500]]), "up to 5, 500 %"),
        (json!([[0, 350], [0.05, 380], [1, 450], [12, 500]]), "would be 450 MPa"),
        (json!([[0, 500], [0.5, 560], [1, 600], [1.5, 610]]), "is 501.2 MPa now"),
    ] {
        let table = job(&steel(&json!({"law": "table", "points": points})));
        assert_one(&table, "suspicious_curve", "plasticity/points", part);
    }
}

#[test]
fn an_offset_that_is_a_strain_is_told() {
    let law =
        json!({"law": "ramberg_osgood", "reference_stress": 355, "offset": 0.002, "exponent": 10});
    assert_one(&job(&steel(&law)), "suspicious_curve", "plasticity/offset", "a is 1.1831");
}

#[test]
fn depths_in_micrometres_and_rockwell_hardness_are_told() {
    let at = "plasticity/over_depth/hardness";
    let hard = |figures: &Value| {
        job(&steel(&json!({"law": "swift", "yield_stress": 1000, "strain_offset": 0.002,
            "exponent": 0.08, "over_depth": {"hardness": figures}})))
    };
    let deep = json!({"profile": [[0, 600], [500, 580], [1000, 500], [2000, 380]]});
    assert_one(&hard(&deep), "suspicious_profile", &format!("{at}/profile"), "to 2000 mm");
    let case = json!({"surface": 600, "core": 380, "case_depth": 800});
    assert_one(&hard(&case), "suspicious_profile", &format!("{at}/case_depth"), "last is 0.8 mm");
    let mut peened = bilinear(210e3, 500.0);
    peened["initial_stress"] = json!([{"depth": 0, "sigma_x": -200, "sigma_z": -200},
        {"depth": 300, "sigma_x": 0, "sigma_z": 0}]);
    assert_one(&job(&peened), "suspicious_profile", "initial_stress", "to 300 mm");
    let rockwell = json!({"profile": [[0, 61], [0.5, 58], [1, 52]]});
    assert_one(&hard(&rockwell), "suspicious_profile", at, "above 61");
    for plain in [
        json!({"profile": [[0, 720], [0.5, 580], [2, 380], [12, 380]]}),
        json!({"profile": [[0, 55], [0.5, 52], [1, 40]], "hardness_scale": "HRC"}),
    ] {
        assert!(told(&hard(&plain)).is_empty(), "{plain}");
    }
}

#[test]
fn a_block_of_one_height_is_told() {
    let mut rows: Vec<Vec<f64>> = (0..16)
        .map(|i| (0..16).map(|j| 1e-3 * f64::from(i * 7 + j * j * 3).sin()).collect())
        .collect();
    let map = |rows: &[Vec<f64>]| {
        json!({
            "analysis": "three_dimensional",
            "upper": {"shape": {"type": "flat"}, "material": {"rigid": true},
                "surface": {"heights": rows, "spacing_x": 0.01, "spacing_y": 0.01}},
            "lower": {"shape": {"type": "flat"}, "material": bilinear(210e3, 500.0)},
            "load": {"force": 1},
        })
    };
    assert!(told(&map(&rows)).is_empty());
    for row in &mut rows[2..7] {
        row[3..8].fill(0.0);
    }
    let found = told(&map(&rows));
    assert_eq!(found[0].0, "suspicious_heights");
    assert!(found[0].1.starts_with("`/upper/surface/heights`: 26 of 256 heights"), "{found:?}");
    rows[9][4] = -9999.0;
    let Err(crate::job::JobError::Fields(faults)) = Job::from_value(&map(&rows)) else { panic!() };
    assert_eq!((faults.len(), faults[0].pointer.as_str()), (1, "/upper/surface/heights"));
    assert!(
        faults[0].detail.starts_with("1 of 256 heights stand for no data: -9999 mm at [9, 4]"),
        "{}",
        faults[0].detail
    );
}
