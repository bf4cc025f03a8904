use serde_json::{Value, json};

use super::*;

fn steel(plasticity: &Value) -> Value {
    json!({"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity": plasticity})
}

fn bilinear() -> Value {
    steel(&json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 1000}))
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

fn suspicions(job: &Value) -> Vec<Suspicion> {
    Job::from_value(job).unwrap().suspicions()
}

/// Codes, pointers and findings of a material.
fn of_material(material: &Value) -> Vec<Suspicion> {
    suspicions(&job(material))
}

fn of_law(law: &Value) -> Option<(String, Suspected)> {
    of_material(&steel(law)).pop().map(|found| (found.pointer, found.finding))
}

fn table(points: &Value) -> Option<(String, Suspected)> {
    of_law(&json!({"law": "table", "points": points}))
}

#[test]
fn common_jobs_are_above_suspicion() {
    let laws = [
        json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 1000}),
        json!({"law": "bilinear", "yield_stress": 12, "tangent_modulus": 0}),
        json!({"law": "ramberg_osgood", "reference_stress": 500, "offset": 0.3, "exponent": 5}),
        json!({"law": "ramberg_osgood", "reference_stress": 355, "offset": 1.183, "exponent": 10}),
        json!({"law": "swift", "yield_stress": 900, "strain_offset": 0.002, "exponent": 0.1}),
        // Annealed copper, a plateau, a straight line by two points, a curve to 200 %.
        json!({"law": "table", "points": [[0, 33], [0.002, 60], [0.05, 180], [0.3, 330]]}),
        json!({"law": "table", "points": [[0, 350], [0.015, 350], [0.05, 450], [0.15, 520]]}),
        json!({"law": "table", "points": [[0, 350], [1, 1350]]}),
        json!({"law": "table", "points": [[0, 350], [0.002, 400], [0.05, 520], [2, 700]]}),
        json!({"law": "table", "points": [[0, 350]]}),
        // A round curve has any slope at the start.
        json!({"law": "table", "points": [[0, 200], [1e-4, 221], [1e-3, 300], [0.1, 500]]}),
    ];
    for law in laws {
        assert_eq!(of_material(&steel(&law)), [], "{law}");
    }
    let polymer = json!({"young_modulus": 2800, "poisson_ratio": 0.38,
        "plasticity": {"law": "bilinear", "yield_stress": 65, "tangent_modulus": 0}});
    let rubber = json!({"young_modulus": 5, "poisson_ratio": 0.49});
    for material in [polymer, rubber] {
        let mut soft = job(&material);
        soft["load"] = json!({"force": 1});
        assert_eq!(suspicions(&soft), [], "{material}");
    }
}

#[test]
fn units_that_no_solid_has_are_told_with_a_guess() {
    let material = |modulus: f64, stress: f64| {
        json!({"young_modulus": modulus, "poisson_ratio": 0.3,
               "plasticity": {"law": "bilinear", "yield_stress": stress, "tangent_modulus": 0}})
    };
    for (modulus, stress, expected) in [
        (210.0, 500.0, Some(Guess::Modulus(1e3))),
        (70.0, 25.0, Some(Guess::Modulus(1e3))),
        (210.0, 20.5, Some(Guess::Modulus(1e3))),
        (210_000.0, 500_000.0, Some(Guess::Stress(1e-3))),
        (210_000.0, 0.5, Some(Guess::Stress(1e3))),
        (210_000.0, 80_000.0, Some(Guess::Stress(1e-3))),
    ] {
        let found = of_material(&material(modulus, stress));
        let [Suspicion { code: UNITS, finding, .. }] = &found[..] else { panic!("{found:?}") };
        let Suspected::YieldBesideModulus { guess, .. } = finding else { panic!("{finding:?}") };
        match (guess, expected) {
            (Some(Guess::Modulus(a)), Some(Guess::Modulus(b)))
            | (Some(Guess::Stress(a)), Some(Guess::Stress(b))) => {
                assert!((a / b - 1.0).abs() < 1e-9);
            }
            (None, None) => {}
            other => panic!("{modulus} {stress}: {other:?}"),
        }
    }
    // SI with a yield stress in MPa.
    let mut si = job(&material(2.1e11, 500.0));
    si["units"] = json!("SI");
    si["upper"]["shape"]["radius"] = json!(0.02);
    si["lower"]["shape"]["radius"] = json!(0.01);
    assert_eq!(suspicions(&si).len(), 1);
    si["lower"]["material"] = material(2.1e5, 500.0);
    assert!(matches!(suspicions(&si)[0].finding, Suspected::MillimetresInSi { .. }));
}

#[test]
fn small_radii_and_large_forces_are_told() {
    let mut tiny = job(&bilinear());
    tiny["lower"]["shape"]["radius"] = json!(5e-5);
    tiny["load"] = json!({"force": 1e-4});
    let found = suspicions(&tiny);
    assert_eq!(found[0].pointer, "/lower/shape/radius");
    assert!(matches!(found[0].finding, Suspected::TinyRadius { .. }));
    let mut wide = job(&bilinear());
    wide["load"] = json!({"force": 4e6});
    let found = suspicions(&wide);
    let [
        Suspicion {
            code: UNITS,
            pointer,
            finding: Suspected::ContactWiderThanBody { half_width, limit },
        },
    ] = &found[..]
    else {
        panic!("{found:?}")
    };
    // sqrt(4 F R (1 - ν²)/(π E)), R = 20/3 mm.
    let expected = (4.0 * 4e6 * 20.0 / 3.0 * 0.91 / (std::f64::consts::PI * 210_000.0)).sqrt();
    assert!((half_width / expected - 1.0).abs() < 1e-12, "{half_width} {expected}");
    assert_eq!((pointer.as_str(), *limit), ("/load", 10.0));
    let mut ball = json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 5}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"}, "material": bilinear()},
        "load": {"forces": [100, 1e8]},
    });
    assert_eq!(suspicions(&ball).len(), 1);
    ball["load"] = json!({"forces": [100, 1e4]});
    assert_eq!(suspicions(&ball), []);
}

#[test]
fn total_strain_is_told_with_the_yield_stress_meant() {
    for points in [
        json!([[0, 0.001], [0.0017, 350], [0.02, 400]]),
        // A record of many points, and one that is 8 % too soft.
        json!([[0, 1], [0.0005, 105], [0.001, 210], [0.0015, 315], [0.00167, 350], [0.02, 400]]),
        json!([[0, 0.1], [0.0009, 175], [0.0018, 350], [0.02, 400]]),
    ] {
        let Some((pointer, Suspected::TotalStrain { given, meant, .. })) = table(&points) else {
            panic!("{points}")
        };
        assert_eq!(pointer, "/lower/material/plasticity/points");
        assert!(given <= 1.0 && (meant.unwrap() / 350.0 - 1.0).abs() < 0.01, "{points} {meant:?}");
    }
    let doubled = json!([[0, 350], [0.00167, 350], [0.02, 400], [0.1, 480]]);
    assert!(matches!(table(&doubled), Some((_, Suspected::TotalStrain { .. }))));
    let jump = json!([[0, 0.5], [0.01, 380], [0.1, 480]]);
    assert!(matches!(table(&jump), Some((_, Suspected::TotalStrain { .. }))));
}

#[test]
fn strain_in_per_cent_is_told_where_it_matters() {
    for points in [
        json!([[0, 350], [0.2, 400], [1, 450], [5, 500]]),
        json!([[0, 350], [0.05, 380], [1, 450], [12, 500]]),
        json!([[0, 500], [0.5, 560], [1, 600], [1.5, 610]]),
    ] {
        let Some((_, Suspected::StrainInPercent { given, meant, .. })) = table(&points) else {
            panic!("{points}")
        };
        assert!(meant > 1.02 * given, "{points}");
    }
    assert_eq!(table(&json!([[0, 350], [5, 352]])), None);
}

#[test]
fn an_offset_that_is_a_strain_is_told() {
    let law =
        json!({"law": "ramberg_osgood", "reference_stress": 355, "offset": 0.002, "exponent": 10});
    let Some((pointer, Suspected::OffsetIsStrain { plastic_strain, factor, given, meant, .. })) =
        of_law(&law)
    else {
        panic!()
    };
    assert_eq!(pointer, "/lower/material/plasticity/offset");
    assert!((plastic_strain - 3.38e-6).abs() < 1e-8 && (factor - 1.183).abs() < 1e-3);
    assert!((meant - 355.0).abs() < 1e-9 && (given - 672.0).abs() < 1.0, "{given}");
}

fn hardness(figures: &Value) -> Value {
    steel(&json!({"law": "swift", "yield_stress": 1000, "strain_offset": 0.002, "exponent": 0.08,
        "over_depth": {"hardness": figures}}))
}

#[test]
fn depths_beyond_the_body_are_told() {
    let deep = json!({"profile": [[0, 600], [500, 580], [1000, 500], [2000, 380]]});
    let found = of_material(&hardness(&deep));
    let [Suspicion { code: PROFILE, pointer, finding }] = &found[..] else { panic!("{found:?}") };
    assert_eq!(pointer, "/lower/material/plasticity/over_depth/hardness/profile");
    assert_eq!(*finding, Suspected::DepthBeyondBody { deepest: 2000.0, size: 10.0 });
    let case = json!({"surface": 600, "core": 380, "case_depth": 800});
    assert_eq!(of_material(&hardness(&case)).len(), 1);
    let mut peened = bilinear();
    peened["initial_stress"] = json!([{"depth": 0, "sigma_x": -200, "sigma_z": -200},
        {"depth": 300, "sigma_x": 0, "sigma_z": 0}]);
    assert_eq!(of_material(&peened)[0].pointer, "/lower/material/initial_stress");
    let plain = json!({"profile": [[0, 600], [0.5, 580], [2, 380], [12, 380]]});
    assert_eq!(of_material(&hardness(&plain)), []);
    // A half-space that is flat is as large as the other body.
    let mut flat = json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"}, "material": hardness(&deep)},
        "load": {"force": 100},
    });
    assert_eq!(suspicions(&flat).len(), 1);
    flat["lower"]["material"] = hardness(&plain);
    assert_eq!(suspicions(&flat), []);
}

#[test]
fn hardness_outside_of_its_regression_is_counted() {
    let hard = json!({"profile": [[0, 720], [0.5, 640], [1, 500], [2, 380]]});
    let found = of_material(&hardness(&hard));
    let expected = Suspected::HardnessOutside { count: 2, of: 4, range: [380.0, 720.0] };
    assert_eq!((found[0].code, &found[0].finding), (BY_HARDNESS, &expected));
    let rockwell = json!({"profile": [[0, 61], [0.5, 58], [1, 52]]});
    let found = of_material(&hardness(&rockwell));
    assert_eq!(found[0].finding, Suspected::RockwellAsVickers { largest: 61.0 });
    let said = json!({"profile": [[0, 55], [0.5, 52], [1, 40]], "hardness_scale": "HRC"});
    assert_eq!(of_material(&hardness(&said)), []);
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
            "lower": {"shape": {"type": "flat"}, "material": bilinear()},
            "load": {"force": 1},
        })
    };
    assert_eq!(suspicions(&map(&rows)), []);
    for row in &mut rows[2..7] {
        row[3..8].fill(0.0);
    }
    let found = suspicions(&map(&rows));
    assert_eq!((found[0].code, found[0].pointer.as_str()), (HEIGHTS, "/upper/surface/heights"));
    rows[9][4] = -9999.0;
    let Err(crate::job::JobError::Fields(faults)) = Job::from_value(&map(&rows)) else { panic!() };
    assert_eq!((faults.len(), faults[0].pointer.as_str()), (1, "/upper/surface/heights"));
    assert!(
        faults[0].detail.starts_with("1 of 256 heights stand for no data: -9999 mm at [9, 4]"),
        "{}",
        faults[0].detail
    );
}
