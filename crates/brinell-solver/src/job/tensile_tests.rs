use serde_json::{Value, json};

use super::*;

fn solve(test: &Value) -> Result<TestedCurve, Vec<String>> {
    match TensileTest::solve(test.to_string().as_bytes()) {
        Ok(curve) => Ok(curve),
        Err(JobError::Fields(faults)) => Err(faults.iter().map(ToString::to_string).collect()),
        Err(JobError::Syntax { .. }) => panic!("{test}"),
    }
}

/// An engineering record of steel with 206 GPa, 500 MPa and a plastic modulus of 2 GPa; strains
/// of five decimals.
fn record() -> Vec<[f64; 2]> {
    let rise = (1..40).map(|k| 500.0 * f64::from(k) / 40.0).map(|s| [s / 206_000.0, s]);
    let flow = (0..60).map(|k| 8e-4 * f64::from(k)).map(|p| {
        let stress = 500.0 + 2000.0 * p;
        [p + stress / 206_000.0, stress]
    });
    let engineering = |[e, s]: [f64; 2]| [(e.exp_m1() * 1e5).round() / 1e5, s * (-e).exp()];
    rise.chain(flow).map(engineering).collect()
}

#[test]
fn a_test_is_a_table_of_the_job() {
    let test = json!({"points": record(), "young_modulus": 210_000});
    let curve = solve(&test).unwrap();
    assert!((curve.points[0][1] / 500.0 - 1.0).abs() < 0.01, "{:?}", curve.points);
    let said = &curve.remarks[0];
    assert!(
        said.starts_with("The test rises with 20") && said.ends_with("E is 210000 MPa."),
        "{said}"
    );
    let mut in_percent = test.clone();
    in_percent["points"] =
        record().iter().map(|[e, s]| json!([100.0 * e, s])).collect::<Vec<_>>().into();
    let faults = solve(&in_percent).unwrap_err();
    assert!(faults[0].contains("per cent"), "{faults:?}");
    in_percent["strain_unit"] = json!("percent");
    let converted = solve(&in_percent).unwrap();
    assert!((converted.yield_stress / curve.yield_stress - 1.0).abs() < 1e-9);
    let mut si = test.clone();
    si["units"] = json!("SI");
    si["young_modulus"] = json!(2.1e11);
    si["points"] = record().iter().map(|[e, s]| json!([e, s * 1e6])).collect::<Vec<_>>().into();
    let si = solve(&si).unwrap();
    assert!((si.yield_stress / curve.yield_stress / 1e6 - 1.0).abs() < 1e-9);
    assert!(si.remarks[0].contains("Pa; E is 2.100e11 Pa"), "{:?}", si.remarks);
}

#[test]
fn the_curve_is_accepted_by_a_job() {
    let curve = solve(&json!({"points": record(), "young_modulus": 210_000})).unwrap();
    let job = json!({
        "analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": 20}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 40, "depth": 20},
            "material": {"young_modulus": 210_000, "poisson_ratio": 0.3,
                "plasticity": {"law": "table", "points": curve.points}}},
        "load": {"force": 100},
    });
    assert!(crate::job::Job::from_value(&job).is_ok());
}

#[test]
fn every_field_at_fault_is_named() {
    let faults = solve(&json!({"points": [[0, 0], ["x", 1], [1, 2]], "young_modulus": -1,
        "offset": 3, "strain_unit": "inch", "colour": 1, "units": "mm"}))
    .unwrap_err();
    assert_eq!(faults.len(), 6, "{faults:?}");
    let both = json!({"points": record(), "yield_at": "departure", "offset": 0.002});
    assert_eq!(solve(&both).unwrap_err().len(), 1);
    assert!(solve(&json!({"points": [[0, 0], [0.001, 210]]})).is_err());
    let faults = solve(&json!({"points": [[0, 0], [10, 400], [20, 500]]})).unwrap_err();
    assert!(faults[0].contains("/points/1/0") && faults[0].contains("per cent"), "{faults:?}");
}

#[test]
fn a_record_that_is_none_is_refused_or_asked_about() {
    let scaled = |strain: f64, stress: f64| -> Vec<[f64; 2]> {
        record().iter().map(|[e, s]| [strain * e, stress * s]).collect()
    };
    // Force in kN over the way in mm of a specimen of 50 mm and 78.5 mm².
    let refused = [
        (json!({"points": scaled(50.0, 0.0785), "young_modulus": 206_000}), "force over a way"),
        (json!({"points": scaled(1.0, 78.5), "young_modulus": 206_000}), "force over a way"),
        (json!({"points": scaled(0.01, 1.0)}), "no solid"),
        (
            json!({"points": [[0, 350], [0.002, 400], [0.01, 440], [0.03, 500], [0.1, 560]],
                   "young_modulus": 206_000}),
            "is the strain plastic",
        ),
    ];
    for (test, words) in refused {
        let faults = solve(&test).unwrap_err();
        assert!(faults[0].contains(words), "{faults:?}");
    }
    let asked = [
        (json!({"points": scaled(1.0, 1.0 / 6.895), "young_modulus": 206_000}), "in ksi?"),
        (json!({"points": scaled(1.0, 1e-3)}), "in GPa?"),
        (json!({"points": scaled(1.0, 1.3), "young_modulus": 206_000}), "makes a test steeper"),
        (json!({"points": scaled(4.0, 1.0), "young_modulus": 206_000}), "does no harm"),
    ];
    for (test, words) in asked {
        let remarks = solve(&test).unwrap().remarks.join(" ");
        assert!(remarks.contains(words), "{remarks}");
    }
}
