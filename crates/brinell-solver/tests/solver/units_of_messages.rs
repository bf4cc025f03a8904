//! Sentences with figures are in the units of the job: the same job in both systems of units says
//! the same.

use brinell_solver::job::Job;
use brinell_solver::report;
use brinell_solver::solver::Unobserved;
use serde_json::{Value, json};

use crate::random_jobs::random_job::{self, Random};

/// Relative difference of figures that are written to two or three digits.
const DIGITS: f64 = 0.06;

/// All sentences of an answer or a refusal, and whether their figures are those of an answer. An
/// iteration that ends without an answer depends on rounding.
fn told(job: &Value) -> (Vec<String>, bool) {
    let Ok(parsed) = Job::from_value(&crate::theory::by_deformation_theory(job)) else {
        return (vec!["refused by the reader".to_owned()], true);
    };
    let report = match report::run(&parsed, &mut Unobserved) {
        Ok(report) => serde_json::to_value(report).unwrap(),
        Err(error) => return (vec![error.to_string()], true),
    };
    let (mut found, is_answer) = (Vec::new(), report["status"] == "converged");
    for step in report["steps"].as_array().unwrap() {
        // What a body that collapses has come to is not the same twice: it has its verdict.
        let is_collapse = step["verdict"]["level"] == "collapse";
        collect(if is_collapse { &step["verdict"]["text"] } else { step }, &mut found);
    }
    (found, is_answer)
}

fn sentences(job: &Value) -> Vec<String> {
    told(job).0
}

fn collect(value: &Value, found: &mut Vec<String>) {
    match value {
        Value::String(text) => found.push(text.clone()),
        Value::Array(items) => items.iter().for_each(|item| collect(item, found)),
        Value::Object(members) => {
            let texts = members.iter().filter(|(name, _)| *name != "unit");
            texts.for_each(|(_, item)| collect(item, found));
        }
        _ => {}
    }
}

/// Factor of a unit to SI.
fn factor(unit: &str) -> Option<f64> {
    Some(match unit {
        "mm" => 1e-3,
        "mm²" => 1e-6,
        "mm³" => 1e-9,
        "MPa" => 1e6,
        "N/mm" => 1e3,
        "m" | "m²" | "m³" | "Pa" | "N/m" => 1.0,
        _ => return None,
    })
}

/// The words of a sentence, with numbers in SI.
fn words(text: &str) -> Vec<Result<f64, String>> {
    let trimmed = |word: &str| {
        word.trim_matches(|c: char| "().,;:".contains(c)).trim_end_matches("'s").to_owned()
    };
    let all: Vec<String> = text.split_whitespace().map(trimmed).collect();
    let word = |k: usize| match all[k].parse::<f64>() {
        // The unit may stand behind the last of several numbers.
        Ok(number) => {
            let mut behind = all[k + 1..].iter();
            let is_between =
                |next: &str| next.parse::<f64>().is_ok() || matches!(next, ">" | "to");
            let unit = behind.find(|next| !is_between(next.as_str()));
            Ok(number * unit.and_then(|unit| factor(unit)).unwrap_or(1.0))
        }
        Err(_) => Err(if factor(&all[k]).is_some() { "unit".to_owned() } else { all[k].clone() }),
    };
    (0..all.len()).map(word).collect()
}

fn assert_alike(in_mm: &str, in_si: &str, is_answer: bool) {
    let (a, b) = (words(in_mm), words(in_si));
    let is_alike = |(a, b): (&Result<f64, String>, &Result<f64, String>)| match (a, b) {
        (Ok(_), Ok(_)) if !is_answer => true,
        (Ok(a), Ok(b)) => (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + 1e-12,
        (a, b) => a == b,
    };
    assert!(
        a.len() == b.len() && a.iter().zip(&b).all(is_alike),
        "\n{in_mm}\n{in_si}\n{a:?}\n{b:?}"
    );
}

/// Solves a job in both systems of units; returns the number of its sentences.
fn says_alike(job: &Value) -> usize {
    let mut in_si = job.clone();
    random_job::in_si(&mut in_si);
    let ((a, is_answer), (b, _)) = (told(job), told(&in_si));
    assert_eq!(a.len(), b.len(), "{job}\n{a:#?}\n{b:#?}");
    for (a, b) in a.iter().zip(&b) {
        assert_alike(a, b, is_answer);
    }
    a.len()
}

fn random_jobs_say_alike(seeds: std::ops::Range<u64>) {
    for seed in seeds {
        let mut job = random_job::in_millimetres(&mut Random(seed), &[4]);
        says_alike(&job);
        // Far too large, so that most are refused.
        scale(&mut job["load"], 1e4);
        says_alike(&job);
    }
}

fn scale(load: &mut Value, factor: f64) {
    match load {
        Value::Number(number) => *load = json!(number.as_f64().unwrap() * factor),
        Value::Array(items) => items.iter_mut().for_each(|item| scale(item, factor)),
        Value::Object(members) => members.values_mut().for_each(|item| scale(item, factor)),
        _ => {}
    }
}

#[test]
fn a_few_random_jobs_say_the_same_in_both_systems_of_units() {
    random_jobs_say_alike(0..3);
}

#[test]
#[ignore = "full"]
fn thirty_random_jobs_say_the_same_in_both_systems_of_units() {
    random_jobs_say_alike(100..130);
}

#[test]
#[ignore = "full"]
fn random_jobs_in_three_dimensions_say_the_same_in_both_systems_of_units() {
    for seed in 0..8 {
        says_alike(&random_job::half_spaces(&mut Random(seed)));
    }
}

/// A corner, a tip, an edge, a clamped column, a block that is too narrow, surfaces that do not
/// open.
#[test]
fn limits_of_an_answer_are_told_in_the_units_of_the_job() {
    let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3, "plasticity":
        {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10_000}});
    let elastic = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    let rigid = |shape: Value| json!({"shape": shape, "material": {"rigid": true}});
    let block = |material: &Value, width: f64, depth: f64| json!({"shape": {"type": "block", "width": width, "depth": depth}, "material": material});
    let punch = |edge: f64| {
        let mut shape = json!({"type": "punch", "width": 4, "depth": 10});
        if edge > 0.0 {
            shape["edge_radius"] = json!(edge);
        }
        rigid(shape)
    };
    let wedge = |tip: f64| {
        rigid(json!({"type": "wedge", "angle": 2, "width": 40, "depth": 40, "tip_radius": tip}))
    };
    let cylinder = rigid(json!({"type": "cylinder", "radius": 20}));
    let groove = json!({"shape": {"type": "groove", "radius": 20.001, "width": 30, "depth": 40},
        "material": elastic});
    let cases = [
        (punch(0.0), block(&elastic, 60.0, 60.0), json!({"force": 500}), "sharp corner"),
        (punch(0.0), block(&steel, 60.0, 60.0), json!({"onset": true}), "sharp corner"),
        (punch(0.02), block(&steel, 60.0, 60.0), json!({"force": 500}), "rounded edges"),
        (wedge(0.05), block(&steel, 60.0, 60.0), json!({"force": 100}), "rounded off"),
        (cylinder.clone(), block(&elastic, 40.0, 40.0), json!({"force": 1e7}), "would reach"),
        (cylinder, groove, json!({"force": 100}), ""),
    ];
    for (upper, lower, load, told) in cases {
        let job = json!({"analysis": "plane_strain", "upper": upper, "lower": lower,
            "load": load, "mesh": {"elements_per_half_width": 4}});
        assert!(sentences(&job).iter().any(|text| text.contains(told)), "{told} {job}");
        says_alike(&job);
    }
}
