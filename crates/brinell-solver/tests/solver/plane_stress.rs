//! Plane stress: a patch against the uniaxial and the biaxial curve, Lamé's annulus, Hertz with
//! E* = E/2.

use std::f64::consts::FRAC_PI_2;

use brinell_solver::analytical::HertzLine;
use brinell_solver::fem::element::StressState;
use brinell_solver::fem::mesh::Mesh;
use brinell_solver::job::{Bilinear, Hardening, NonNegativeF64};
use brinell_solver::report::Name;
use brinell_solver::solver::SolveStatus;
use serde_json::Value;

use crate::bodies::{grid, load, material, positive};
use crate::problems::{assert_peak, assert_within, report, two_cylinders};

const YOUNG: f64 = 210_000.0;
const POISSON: f64 = 0.3;
const YIELD: f64 = 240.0;
const TANGENT: f64 = 21_000.0;

/// A unit square, inner nodes out of place, pulled in both directions.
fn pull(along: f64, across: f64, law: Option<Hardening>) -> (Mesh, crate::bodies::Loaded) {
    let mesh = grid(3, 3, |i, j| {
        let (x, y) = (f64::from(i) / 3.0, f64::from(j) / 3.0);
        let shift = if (1..3).contains(&i) && (1..3).contains(&j) { 0.09 } else { 0.0 };
        [x + shift * f64::from(2 * j - 3), y - shift * f64::from(i - 1)]
    });
    let held = mesh.nodes.iter().map(|[x, y]| [*x == 0.0, *y == 0.0]).collect();
    let share = |s: f64| if (1e-12..1.0 - 1e-12).contains(&s) { 1.0 / 3.0 } else { 1.0 / 6.0 };
    let on = |s: f64| if s > 1.0 - 1e-12 { 1.0 } else { 0.0 };
    let force: Vec<[f64; 2]> = mesh
        .nodes
        .iter()
        .map(|&[x, y]| [along * on(x) * share(y), across * on(y) * share(x)])
        .collect();
    let loaded = load(
        &mesh,
        StressState::PlaneStress,
        &material(YOUNG, POISSON, law),
        held,
        &force,
        20_000,
    );
    (mesh, loaded)
}

/// ε_i = σ_i/E - ν σ_j/E + (3/2) ε_p s_i/q with ε_p = (q - σ_y)/H.
#[test]
fn a_patch_follows_the_curve() {
    let law = Hardening::Bilinear(Bilinear {
        yield_stress: positive(YIELD),
        tangent_modulus: NonNegativeF64::new(TANGENT).unwrap(),
    });
    for (along, across) in
        [(500.0, 0.0), (0.0, 400.0), (500.0, 500.0), (500.0, 250.0), (300.0, -300.0)]
    {
        let (mesh, loaded) = pull(along, across, Some(law.clone()));
        let q = f64::sqrt(along * along - along * across + across * across);
        let plastic = (q - YIELD) * (1.0 - TANGENT / YOUNG) / TANGENT;
        let strain = |own: f64, other: f64| {
            (own - POISSON * other) / YOUNG + plastic * (own - 0.5 * other) / q
        };
        for point in loaded.field.points.iter().flatten() {
            assert!(point.yielded);
            assert_within(point.equivalent_plastic_strain, plastic, 1e-6);
            for (got, expected) in point.stress.iter().zip([along, across, 0.0, 0.0]) {
                assert!((got - expected).abs() < 1e-6 * YIELD, "{:?}", point.stress);
            }
        }
        let corner = mesh.nodes.iter().position(|&[x, y]| x == 1.0 && y == 1.0).unwrap();
        let size = plastic + q / YOUNG;
        for (got, expected) in
            loaded.displacement[corner].iter().zip([strain(along, across), strain(across, along)])
        {
            assert!(
                (got - expected).abs() < 1e-6 * size,
                "{along} {across}: {got} instead of {expected}"
            );
        }
    }
}

/// A thin annulus under internal pressure: `u(r) = p a²/(E (b²-a²)) [(1-ν) r + (1+ν) b²/r]`.
#[test]
fn a_thin_annulus_follows_lame() {
    let (inner, outer, pressure, n) = (100.0, 200.0, 100.0, 32);
    let mesh = grid(n, n, |i, j| {
        let r = inner * f64::powf(outer / inner, f64::from(i) / f64::from(n));
        let angle = FRAC_PI_2 * f64::from(j) / f64::from(n);
        let (sin, cos) = if j == n { (1.0, 0.0) } else { angle.sin_cos() };
        [r * cos, r * sin]
    });
    let held = mesh.nodes.iter().map(|[x, y]| [*x == 0.0, *y == 0.0]).collect();
    let mut force = vec![[0.0; 2]; mesh.nodes.len()];
    for k in 0..32 {
        let (p, q) = (mesh.nodes[k], mesh.nodes[k + 1]);
        for node in [k, k + 1] {
            force[node][0] += 0.5 * pressure * (q[1] - p[1]);
            force[node][1] -= 0.5 * pressure * (q[0] - p[0]);
        }
    }
    let loaded =
        load(&mesh, StressState::PlaneStress, &material(YOUNG, POISSON, None), held, &force, 10);
    let factor = pressure / (f64::powi(outer / inner, 2) - 1.0);
    for (node, u) in mesh.nodes.iter().zip(&loaded.displacement) {
        let r = node[0].hypot(node[1]);
        let expected =
            factor / YOUNG * ((1.0 - POISSON) * r + (1.0 + POISSON) * outer * outer / r);
        assert_within(u[0].hypot(u[1]), expected, 1e-3);
    }
    for points in &loaded.field.points {
        // σ_r + σ_θ = 2 p a²/(b²-a²) everywhere; an element has it in the mean.
        let sum = points.iter().map(|point| point.stress[0] + point.stress[1]).sum::<f64>() / 4.0;
        assert!((sum - 2.0 * factor).abs() < 0.01 * pressure, "{sum} instead of {}", 2.0 * factor);
        assert!(points.iter().all(|point| point.stress[2] == 0.0));
    }
}

/// Discs instead of cylinders: `E* = E/2`.
#[test]
fn equal_discs_have_hertz_pressure() {
    for force in [50.0, 200.0, 612.6106] {
        let mut job = two_cylinders("clamped", Value::Null, force);
        job["analysis"] = "plane_stress".into();
        let report = report(&job);
        let step = &report.steps[0];
        assert_eq!(step.status, SolveStatus::Converged);
        let hertz = HertzLine::new(force, 10.0, 0.5 * YOUNG);
        assert_peak(step, hertz.peak_pressure());
        assert!((step[Name::HalfWidth] - hertz.half_width()).abs() < report.mesh.spacing);
    }
}
