//! Stresses under an elastic line contact.
//!
//! McEwen's field is that of two half-planes. In a disc of radius R the force that arrives at the
//! other end of the diameter adds a uniform tension `σ_x = P/(πR)`, which is a/2R of the peak
//! pressure (J. H. Michell, Proc. London Math. Soc. 32 (1900) 35–61); the loads here are small
//! enough to leave it at 0.1 %.
//!
//! E. McEwen, *Stresses in elastic cylinders in contact along a generatrix*, Phil. Mag. 40 (1949)
//! 454–459.

use brinell_solver::analytical::HertzLine;
use serde_json::Value;

use crate::problems::{assert_within, report, two_cylinders};

/// a/R is 0.0023 under this force \[N/mm\].
const FORCE: f64 = 20.0;

#[test]
fn stresses_on_the_axis_are_mcewens() {
    let report = report(&two_cylinders("clamped", Value::Null, FORCE));
    let hertz = HertzLine::new(FORCE, 10.0, 210_000.0 / 1.82);
    let (a, p0) = (hertz.half_width(), hertz.peak_pressure());
    let profile = report.steps[0].subsurface.as_ref().unwrap().upper.as_ref().unwrap();
    assert_eq!(profile.depth[0], 0.0);
    let mut compared = 0;
    for (k, &depth) in profile.depth.iter().enumerate().filter(|(_, depth)| **depth <= 2.0 * a) {
        let exact = hertz.stress_on_axis(depth, 0.3);
        for (name, got, expected) in [
            ("sigma_x", profile.sigma_x[k], exact.sigma_x),
            ("sigma_y", profile.sigma_y[k], exact.sigma_y),
            ("sigma_z", profile.sigma_z[k], exact.sigma_z),
            ("tau_max", profile.tau_max[k], exact.tau_max()),
        ] {
            let error = (got - expected).abs() / p0;
            assert!(error < 0.01, "{name} at {:.3} a: {got} instead of {expected}", depth / a);
        }
        compared += 1;
    }
    assert!(compared > 30);

    let (k, most) = profile.tau_max.iter().enumerate().max_by(|x, y| x.1.total_cmp(y.1)).unwrap();
    assert_within(*most, 0.3003 * p0, 5e-3);
    assert!((profile.depth[k] / a - 0.786).abs() < 0.04);
}

/// At a fixed depth the error falls as the square of the element size.
#[test]
fn stresses_converge_at_second_order() {
    let hertz = HertzLine::new(FORCE, 10.0, 210_000.0 / 1.82);
    let tension = FORCE / (std::f64::consts::PI * 20.0);
    let error = |elements: u32| {
        let mut job = two_cylinders("clamped", Value::Null, FORCE);
        job["mesh"] = serde_json::json!({"elements_per_half_width": elements});
        let report = report(&job);
        let profile = report.steps[0].subsurface.clone().unwrap().upper.unwrap();
        let inside = profile
            .depth
            .iter()
            .enumerate()
            .filter(|(_, d)| (0.3..1.2).contains(&(**d / hertz.half_width())));
        let squares: Vec<f64> = inside
            .map(|(k, &d)| {
                (profile.sigma_x[k] - tension - hertz.stress_on_axis(d, 0.3).sigma_x).powi(2)
            })
            .collect();
        (squares.iter().sum::<f64>() / squares.len() as f64).sqrt() / hertz.peak_pressure()
    };
    let (coarse, fine) = (error(10), error(20));
    let order = (coarse / fine).log2();
    assert!(order > 1.5, "order {order:.2} from {coarse:.2e} to {fine:.2e}");
}

/// A crown that is steeper on one side: the middle of the contact and its largest pressure are at
/// places of their own.
#[test]
fn profiles_lie_below_the_middle_and_below_the_peak() {
    let steel = serde_json::json!({"young_modulus": 210_000, "poisson_ratio": 0.3,
        "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 2000}});
    let points =
        [[-5.0, -0.5], [-1.0, -0.02], [0.0, 0.0], [0.3, -0.004], [1.0, -0.08], [5.0, -0.9]];
    let profile = serde_json::json!({"type": "profile", "points": points, "depth": 10,
        "interpolation": "smooth"});
    let job = serde_json::json!({"analysis": "plane_strain",
        "upper": {"shape": profile, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 40, "depth": 20}, "material": steel},
        "load": {"history": [{"force": 500}, {"force": 0}]},
        "mesh": {"elements_per_half_width": 6}, "solver": {"theory": "flow"}});
    let steps = report(&job).steps;
    let parts = &steps[0].contact.patches;
    let middle = 0.5 * (parts[0].left + parts.last().unwrap().right);
    let peak = steps[0].peak_position();
    assert!((peak - middle).abs() > 0.02, "{peak} {middle}");
    for step in &steps {
        let places: Vec<f64> = step.profiles().map(|(_, profile)| profile.position[0]).collect();
        assert_eq!(places.len(), 2);
        assert!(
            (places[0] - middle).abs() < 1e-12 && (places[1] - peak).abs() < 1e-12,
            "{places:?}"
        );
    }

    // The largest pressure of cylinders is in the middle.
    let step = &report(&two_cylinders("clamped", Value::Null, FORCE)).steps[0];
    assert!(step.subsurface_below_peak.is_none());
    assert!(step.profiles().all(|(_, profile)| profile.position == [0.0]));
}
