use super::*;
use crate::hardening::{HardeningLaw, StraightLine, Swift};

const YOUNG: f64 = 206_000.0;

fn settings() -> TestSettings {
    TestSettings {
        measure: Measure::Engineering,
        yield_rule: YieldRule::Offset(1e-4),
        young_modulus: Some(210_000.0),
    }
}

/// Engineering record of a law: `elastic` points up to yield, `plastic` ones up to a plastic
/// strain.
fn record(law: &dyn HardeningLaw, elastic: usize, plastic: usize, end: f64) -> Vec<[f64; 2]> {
    let yield_stress = law.yield_stress();
    let rise = (0..elastic).map(|k| {
        let stress = yield_stress * k as f64 / elastic as f64;
        [stress / YOUNG, stress]
    });
    let flow = (0..=plastic).map(|k| {
        let p = end * k as f64 / plastic as f64;
        [p + law.stress(p) / YOUNG, law.stress(p)]
    });
    rise.chain(flow).map(engineering).collect()
}

fn engineering([strain, stress]: [f64; 2]) -> [f64; 2] {
    [strain.exp_m1(), stress * (-strain).exp()]
}

fn straight() -> StraightLine {
    StraightLine { yield_stress: 500.0, plastic_modulus: 2000.0 }
}

fn swift() -> Swift {
    Swift { yield_stress: 400.0, strain_offset: 2e-3, exponent: 0.15 }
}

/// Normal deviates that are the same in each run.
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

fn noisy(record: &[[f64; 2]], strain: f64, stress: f64, seed: u64) -> Vec<[f64; 2]> {
    let mut noise = Noise(seed);
    record
        .iter()
        .map(|[e, s]| [e + strain * noise.normal(), s + stress * noise.normal()])
        .collect()
}

/// Largest difference of a curve from a law over the law's stress, from a plastic strain on.
fn off(curve: &TestCurve, law: &dyn HardeningLaw, from: f64) -> f64 {
    let end = curve.points[curve.points.len() - 1][0];
    let polygon = crate::hardening::PolyLine { points: curve.points.clone() };
    let samples = (0..200).map(|k| from + (end - from) * f64::from(k) / 199.0);
    samples.map(|p| (polygon.stress(p) / law.stress(p) - 1.0).abs()).fold(0.0, f64::max)
}

fn is_a_table(curve: &TestCurve) -> bool {
    curve.points[0][0] == 0.0
        && curve.points[0][1] > 0.0
        && curve.points.windows(2).all(|pair| pair[1][0] > pair[0][0] && pair[1][1] >= pair[0][1])
}

#[test]
fn a_slope_that_is_not_the_modulus_is_no_yield() {
    let curve = hardening_curve(&record(&straight(), 39, 40, 0.05), settings()).unwrap();
    assert!((curve.line.slope / YOUNG - 1.0).abs() < 1e-3, "{:?}", curve.line);
    assert!((curve.points[0][1] / 500.0 - 1.0).abs() < 2e-3, "{:?}", curve.points);
    assert!(off(&curve, &straight(), 1e-3) < 2e-3);
    assert!(is_a_table(&curve) && curve.counts.beyond_necking == 0, "{:?}", curve.counts);
}

/// Strains of five decimals, as instruments write them: 2 % of yield is a step of them.
#[test]
fn rounded_strains_are_no_yield() {
    let rounded: Vec<[f64; 2]> = record(&straight(), 39, 60, 0.05)
        .iter()
        .map(|[e, s]| [(e * 1e5).round() / 1e5, (s * 1e3).round() / 1e3])
        .collect();
    for yield_rule in [YieldRule::Offset(1e-4), YieldRule::Departure] {
        let curve = hardening_curve(&rounded, TestSettings { yield_rule, ..settings() }).unwrap();
        assert!((curve.points[0][1] / 500.0 - 1.0).abs() < 0.01, "{:?}", curve.points);
        assert!((curve.line.slope / YOUNG - 1.0).abs() < 0.01, "{:?}", curve.line);
    }
}

#[test]
fn a_toe_is_removed() {
    let mut toed = record(&straight(), 60, 60, 0.05);
    for point in &mut toed {
        point[0] += 6e-4;
    }
    let slack = (0..30).map(|k| [2e-5 * f64::from(k), 60.0 * (f64::from(k) / 30.0).powi(4)]);
    let start = toed.iter().position(|point| point[1] > 62.0).unwrap();
    let toed: Vec<_> = slack.chain(toed[start..].iter().copied()).collect();
    let curve = hardening_curve(&toed, settings()).unwrap();
    assert!((curve.line.slope / YOUNG - 1.0).abs() < 5e-3, "{:?}", curve.line);
    assert!((curve.line.toe - 6e-4).abs() < 2e-5, "{:?}", curve.line);
    assert!((curve.points[0][1] / 500.0 - 1.0).abs() < 5e-3, "{:?}", curve.points);
    assert!(off(&curve, &straight(), 1e-3) < 5e-3);
}

#[test]
fn noise_is_fitted_and_its_size_told() {
    for seed in 1..=8 {
        let law = swift();
        let noisy = noisy(&record(&law, 400, 2000, 0.08), 1e-5, 3.0, seed);
        let curve = hardening_curve(&noisy, settings()).unwrap();
        assert!(is_a_table(&curve), "{:?}", curve.points);
        assert!((curve.line.slope / YOUNG - 1.0).abs() < 0.02, "{:?}", curve.line);
        assert!((curve.line.slope / YOUNG - 1.0).abs() < 5.0 * curve.line.slope_error.max(2e-3));
        assert!((2.0..5.0).contains(&curve.fit_error[0]), "{:?}", curve.fit_error);
        assert!(off(&curve, &law, 2e-3) < 0.01, "{seed}: {}", off(&curve, &law, 2e-3));
        assert!(
            (curve.points[0][1] / law.stress(1e-4) - 1.0).abs() < 0.02,
            "{:?}",
            curve.points[0]
        );
        assert!(curve.points.len() < 60, "{}", curve.points.len());
    }
}

#[test]
fn proof_stresses_are_those_of_their_offset() {
    let law = swift();
    for offset in [1e-4, 5e-4, 2e-3] {
        let settings = TestSettings { yield_rule: YieldRule::Offset(offset), ..settings() };
        let curve = hardening_curve(&record(&law, 100, 4000, 0.05), settings).unwrap();
        assert!(
            (curve.yield_stress / law.stress(offset) - 1.0).abs() < 2e-3,
            "{offset} {} {:?}",
            curve.yield_stress,
            curve.line
        );
        assert!(off(&curve, &law, offset) < 3e-3, "{offset}");
    }
}

#[test]
fn points_beyond_necking_are_left_out() {
    let law = Swift { yield_stress: 300.0, strain_offset: 5e-3, exponent: 0.1 };
    for stress in [0.0, 1.5] {
        let mut pulled = record(&law, 100, 800, 0.25);
        let top = pulled.iter().map(|point| point[1]).fold(0.0, f64::max);
        let at = pulled.iter().position(|point| point[1] >= top).unwrap();
        // Consideré: the force is largest where the slope is the stress, n - ε_0 = 0.095.
        let [strain, _] = pulled[at];
        assert!((strain.ln_1p() - 0.095 - top * strain.exp() / YOUNG).abs() < 3e-3, "{strain}");
        for point in pulled.iter_mut().filter(|point| point[0] > strain) {
            point[1] -= 3000.0 * (point[0] - strain).powi(2);
        }
        let pulled = noisy(&pulled, 0.0, stress, 3);
        let curve = hardening_curve(&pulled, settings()).unwrap();
        let necking = curve.necking.unwrap();
        assert!((necking[0] / strain - 1.0).abs() < 0.25 && (necking[1] / top - 1.0).abs() < 0.01);
        assert!(curve.counts.beyond_necking > 300, "{:?}", curve.counts);
        assert!(off(&curve, &law, 1e-3) < 0.01, "{}", off(&curve, &law, 1e-3));
    }
}

#[test]
fn an_upper_yield_point_is_no_necking() {
    let mut steel: Vec<[f64; 2]> =
        (0..50).map(|k| [1.7e-3 * f64::from(k) / 50.0, 7.14 * f64::from(k)]).collect();
    steel.extend((0..60).map(|k| [1.75e-3 + 3e-4 * f64::from(k), 310.0 + f64::from(k % 3)]));
    let with = |end: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
        let more = (1..200).map(|k| 0.02 + 5e-4 * f64::from(k)).map(|e| [e, end(e)]);
        steel.iter().copied().chain(more).collect()
    };
    for (record, least) in [
        (with(&|e| 310.0 + 150.0 * (1.0 - (-(e - 0.02) / 0.03).exp())), 440.0),
        (with(&|_| 310.0), 310.0),
        // The largest force is at yield, and the specimen necks later.
        (with(&|e| 310.0 + 600.0 * (e - 0.02) * (0.12 - e)), 315.0),
    ] {
        let curve = hardening_curve(&record, settings()).unwrap();
        assert!(curve.necking.is_none_or(|at| at[0] > 0.06) && is_a_table(&curve));
        assert!((curve.points[0][1] - 311.0).abs() < 3.0, "{:?}", curve.points);
        assert!(curve.yield_stress > 330.0, "{}", curve.yield_stress);
        assert!(curve.points[curve.points.len() - 1][1] > least);
    }
}

#[test]
fn unloading_is_left_out() {
    let law = swift();
    let plain = record(&law, 60, 400, 0.05);
    let mut loops = Vec::new();
    for (k, point) in plain.iter().enumerate() {
        loops.push(*point);
        if k == 200 || k == 300 {
            let back = (0..40).map(|i| 1.0 - (f64::from(i) - 20.0).abs() / 20.0);
            loops.extend(
                back.map(|t| [point[0] - 0.9 * t * point[1] / YOUNG, point[1] * (1.0 - 0.9 * t)]),
            );
        }
    }
    let curve = hardening_curve(&loops, settings()).unwrap();
    assert!((70..=80).contains(&curve.counts.set_back), "{:?}", curve.counts);
    assert!(off(&curve, &law, 1e-3) < 3e-3);
}

#[test]
fn compression_counts_positive() {
    let law = swift();
    let pressed: Vec<[f64; 2]> = (0..60)
        .map(|k| 400.0 * f64::from(k) / 60.0)
        .map(|stress| [stress / YOUNG, stress])
        .chain(
            (0..300)
                .map(|k| 3e-4 * f64::from(k))
                .map(|p| [p + law.stress(p) / YOUNG, law.stress(p)]),
        )
        .map(|[strain, stress]| [(-strain).exp_m1(), -stress * strain.exp()])
        .collect();
    let curve = hardening_curve(&pressed, settings()).unwrap();
    assert!(curve.is_compression && curve.necking.is_none());
    assert!(off(&curve, &law, 1e-3) < 3e-3, "{}", off(&curve, &law, 1e-3));
}

#[test]
fn true_figures_are_taken_as_they_are() {
    let law = straight();
    let truth: Vec<[f64; 2]> =
        record(&law, 40, 60, 0.2).iter().map(|[e, s]| [e.ln_1p(), s * (1.0 + e)]).collect();
    let settings = TestSettings { measure: Measure::True, ..settings() };
    let curve = hardening_curve(&truth, settings).unwrap();
    assert!(curve.necking.is_none() && off(&curve, &law, 1e-3) < 2e-3);
}

/// Tables of few points, as handbooks print them.
#[test]
fn few_points_are_a_curve() {
    let printed = [[0.0, 0.0], [0.00165, 340.0], [0.01, 380.0], [0.05, 450.0], [0.1, 480.0]];
    let curve = hardening_curve(&printed, settings()).unwrap();
    assert!((curve.points[0][1] - 340.0).abs() < 3.0, "{:?}", curve.points);
    // The second point is beyond yield: the line is that of the modulus.
    let printed = [[0.0, 0.0], [0.01, 380.0], [0.05, 450.0], [0.1, 480.0]];
    let curve = hardening_curve(&printed, settings()).unwrap();
    assert!(
        curve.line.straight.is_none() && (curve.line.slope - 210_000.0).abs() < 1e-9,
        "{:?}",
        curve.line
    );
    assert!(is_a_table(&curve) && curve.points[0][1] < 384.0, "{:?}", curve.points);
}

#[test]
fn a_round_curve_has_the_slope_of_its_start() {
    let law = crate::hardening::RambergOsgood::of_offset(300.0, 0.4, 6.0, YOUNG);
    let round: Vec<[f64; 2]> = (0..400)
        .map(|k| 1.4 * f64::from(k))
        .filter_map(|q| Some(engineering([q / YOUNG + law.inverse(q)?.plastic_strain, q])))
        .collect();
    let curve = hardening_curve(&round, settings()).unwrap();
    assert!((curve.line.slope / YOUNG - 1.0).abs() < 0.02, "{:?}", curve.line);
    assert!(
        (curve.yield_stress / law.stress(1e-4) - 1.0).abs() < 0.03,
        "{:?}",
        curve.yield_stress
    );
    assert!(off(&curve, &law, 1e-3) < 0.01, "{}", off(&curve, &law, 1e-3));
}

/// Annealed copper with six elastic points among two thousand noisy ones: hardening is no first
/// slope.
#[test]
fn a_rise_that_noise_hides_is_that_of_the_modulus() {
    let law = crate::hardening::Ludwik { yield_stress: 33.0, coefficient: 400.0, exponent: 0.5 };
    for seed in 1..=4 {
        let noisy = noisy(&record(&law, 6, 2000, 0.3), 1e-5, 0.5, seed);
        let curve = hardening_curve(&noisy, settings()).unwrap();
        assert!(curve.line.straight.is_none(), "{:?}", curve.line);
        assert!(
            (curve.yield_stress / law.stress(1e-4) - 1.0).abs() < 0.1,
            "{}",
            curve.yield_stress
        );
        assert!(off(&curve, &law, 2e-3) < 0.02, "{}", off(&curve, &law, 2e-3));
    }
}

#[test]
fn what_is_no_test_is_refused() {
    let plain = record(&straight(), 40, 40, 0.05);
    let scaled =
        |x: f64, y: f64| -> Vec<[f64; 2]> { plain.iter().map(|[e, s]| [x * e, y * s]).collect() };
    let truth = TestSettings { measure: Measure::True, ..settings() };
    let fault = |record: &[[f64; 2]]| hardening_curve(record, truth).unwrap_err();
    for (record, power) in [(scaled(100.0, 1.0), 2), (scaled(1e6, 1.0), 6), (scaled(1.0, 1e-3), 3)]
    {
        assert!(matches!(fault(&record), TestFault::Units { power: found, .. } if found == power));
    }
    let mut spiked = plain.clone();
    spiked[60][1] = 99_999.0;
    assert_eq!(fault(&spiked), TestFault::Stray(60));
    let mut dropped = plain.clone();
    dropped[60][1] = 0.0;
    assert_eq!(fault(&dropped), TestFault::Stray(60));
    for factor in [3.0, 1.0 / 70.0] {
        assert!(matches!(fault(&scaled(1.0, factor)), TestFault::Slope(_)), "{factor}");
    }
    assert_eq!(fault(&plain[..2]), TestFault::TooFewPoints);
    assert_eq!(fault(&[[0.0, 0.0], [f64::NAN, 1.0], [1.0, 1.0]]), TestFault::NotFinite(1));
    assert_eq!(fault(&[[0.0; 2]; 9]), TestFault::NoRise);
    assert_eq!(fault(&scaled(1.0, -1.0)), TestFault::OppositeSigns(80));
    assert!(
        matches!(fault(&plain[..40]), TestFault::NoYield { .. }),
        "{:?}",
        hardening_curve(&plain[..40], truth)
    );
    let falling: Vec<[f64; 2]> = plain.iter().map(|[e, s]| [*e, 600.0 - s]).collect();
    assert!(hardening_curve(&falling, TestSettings { young_modulus: None, ..truth }).is_err());
}
