//! Bodies of revolution alone: the patch test and the thick-walled sphere under internal pressure.
//!
//! ```text
//! elastic         σ_r = p a³/(b³-a³) (1 - b³/r³),  σ_θ = p a³/(b³-a³) (1 + b³/2r³)
//! plastic to c    p(c) = 2σ_y ln(c/a) + (2/3) σ_y (1 - c³/b³);   limit 2σ_y ln(b/a)
//! ```
//! The sphere's stresses stay in proportion (two principal stresses are equal), so deformation
//! theory is exact for every ν.
//!
//! R. Hill, *The Mathematical Theory of Plasticity* (1950), chapter V.

use brinell_solver::fem::element::StressState;
use brinell_solver::fem::mesh::Mesh;
use brinell_solver::job::{Bilinear, Deformable, Hardening, NonNegativeF64};
use std::f64::consts::{FRAC_PI_2, PI};

use crate::bodies::{Loaded, grid, load, material, positive};
use crate::problems::assert_within;

const YOUNG: f64 = 210_000.0;
const POISSON: f64 = 0.3;

fn bilinear(yield_stress: f64, tangent_modulus: f64) -> Hardening {
    Hardening::Bilinear(Bilinear {
        yield_stress: positive(yield_stress),
        tangent_modulus: NonNegativeF64::new(tangent_modulus).unwrap(),
    })
}

/// A solid cylinder of unit radius and height, inner nodes out of place.
fn distorted_cylinder() -> Mesh {
    grid(3, 3, |i, j| {
        let (x, y) = (f64::from(i) / 3.0, f64::from(j) / 3.0);
        let shift = if (1..3).contains(&i) && (1..3).contains(&j) { 0.07 } else { 0.0 };
        [x + shift * f64::from(2 * j - 3), y - shift * f64::from(i - 1)]
    })
}

/// Nodal forces of tractions that do not vary: `along` on the top, `around` on the mantle.
fn tractions(mesh: &Mesh, along: f64, around: f64) -> Vec<[f64; 2]> {
    let mut force = vec![[0.0; 2]; mesh.nodes.len()];
    let edges = mesh.elements.iter().flat_map(|e| (0..4).map(move |k| [e[k], e[(k + 1) % 4]]));
    for [p, q] in edges {
        let ends = [p, q].map(|node| mesh.nodes[node as usize]);
        for (node, own, other) in [(p, ends[0], ends[1]), (q, ends[1], ends[0])] {
            // ∫ N 2πr ds over a straight edge.
            let length = (own[0] - other[0]).hypot(own[1] - other[1]);
            let share = 2.0 * PI * length * (2.0 * own[0] + other[0]) / 6.0;
            let on = |c: usize| ends.iter().all(|end| (end[c] - 1.0).abs() < 1e-12);
            if on(1) {
                force[node as usize][1] += along * share;
            }
            if on(0) {
                force[node as usize][0] += around * share;
            }
        }
    }
    force
}

/// Any mesh must reproduce a homogeneous state, elastic or plastic: a pull along the axis, and one
/// all around it (radial and hoop stress equal).
#[test]
fn patch_test() {
    let mesh = distorted_cylinder();
    let held: Vec<[bool; 2]> = mesh.nodes.iter().map(|[x, y]| [*x == 0.0, *y == 0.0]).collect();
    for (law, yields) in [(None, false), (Some(bilinear(240.0, 21_000.0)), true)] {
        for (along, around) in [(500.0, 0.0), (0.0, 500.0), (150.0, 600.0)] {
            let law = law.clone();
            let force = tractions(&mesh, along, around);
            let state = load(
                &mesh,
                StressState::Axisymmetric,
                &material(YOUNG, POISSON, law),
                held.clone(),
                &force,
                5000,
            );
            for point in state.field.points.iter().flatten() {
                assert_eq!(point.yielded, yields);
                for (got, expected) in point.stress.iter().zip([around, along, around, 0.0]) {
                    assert!(
                        (got - expected).abs() < 1e-6 * 500.0,
                        "{along} {around}: {:?}",
                        point.stress
                    );
                }
            }
            // The uniaxial curve: σ/E + (σ - σ_y)/H for the pull along the axis.
            let q: f64 = (along - around).abs();
            let modulus = 21_000.0 / (1.0 - 21_000.0 / YOUNG);
            let plastic =
                if yields { (q - 240.0) / modulus * (along - around).signum() } else { 0.0 };
            let expected = (along - 2.0 * POISSON * around) / YOUNG + plastic;
            let top = mesh.nodes.iter().position(|[_, y]| *y == 1.0).unwrap();
            assert!((state.displacement[top][1] - expected).abs() < 1e-6 * expected.abs());
        }
    }
}

const INNER: f64 = 100.0;
const OUTER: f64 = 200.0;
const YIELD: f64 = 240.0;

/// A quarter of the hollow sphere's meridian under internal pressure.
fn pressurise(
    radial: i32,
    around: i32,
    material: &Deformable,
    pressure: f64,
    limit: usize,
) -> (Mesh, Loaded) {
    let mesh = grid(radial, around, |i, j| {
        let r = INNER * (OUTER / INNER).powf(f64::from(i) / f64::from(radial));
        let angle = FRAC_PI_2 * f64::from(j) / f64::from(around);
        let (sin, cos) = if j == around { (1.0, 0.0) } else { angle.sin_cos() };
        [r * cos, r * sin]
    });
    let held = mesh.nodes.iter().map(|[x, y]| [*x == 0.0, *y == 0.0]).collect();
    let mut force = vec![[0.0; 2]; mesh.nodes.len()];
    let bore: Vec<usize> = (0..=usize::try_from(around).unwrap()).collect();
    for pair in bore.windows(2) {
        let ends = [mesh.nodes[pair[0]], mesh.nodes[pair[1]]];
        let normal = [ends[1][1] - ends[0][1], ends[0][0] - ends[1][0]];
        for (node, own, other) in [(pair[0], ends[0], ends[1]), (pair[1], ends[1], ends[0])] {
            let share = 2.0 * PI * pressure * (2.0 * own[0] + other[0]) / 6.0;
            force[node][0] += share * normal[0];
            force[node][1] += share * normal[1];
        }
    }
    let loaded = load(&mesh, StressState::Axisymmetric, material, held, &force, limit);
    (mesh, loaded)
}

/// Pressure at which the plastic zone reaches c.
fn pressure_at(c: f64) -> f64 {
    2.0 * YIELD * (c / INNER).ln() + 2.0 / 3.0 * YIELD * (1.0 - (c / OUTER).powi(3))
}

/// Elastic displacement at the outer surface of a shell from `c` to the outside under `pressure`
/// at `c`.
fn outer_displacement(c: f64, pressure: f64) -> f64 {
    let factor = pressure * c.powi(3) / (OUTER.powi(3) - c.powi(3));
    let hoop = factor * 1.5;
    (1.0 - POISSON) / YOUNG * hoop * OUTER
}

fn assert_displacement(mesh: &Mesh, loaded: &Loaded, expected: f64, tolerance: f64) {
    for (node, u) in mesh.nodes.iter().zip(&loaded.displacement) {
        if (node[0].hypot(node[1]) - OUTER).abs() < 1e-9 {
            assert_within(u[0].hypot(u[1]), expected, tolerance);
        }
    }
}

fn assert_stresses(loaded: &Loaded, exact: impl Fn(f64) -> [f64; 2], tolerance: f64) {
    for point in loaded.field.points.iter().flatten() {
        let [x, y] = point.position;
        let r = x.hypot(y);
        let (cos, sin) = (x / r, y / r);
        let [sx, sy, hoop, t] = point.stress;
        let radial = sx * cos * cos + sy * sin * sin + 2.0 * t * sin * cos;
        let expected = exact(r);
        assert!(
            (radial - expected[0]).abs() < tolerance,
            "σ_r {radial} instead of {} at {r}",
            expected[0]
        );
        assert!(
            (hoop - expected[1]).abs() < tolerance,
            "σ_θ {hoop} instead of {} at {r}",
            expected[1]
        );
    }
}

#[test]
fn an_elastic_sphere_follows_lame() {
    let pressure = 100.0;
    let (mesh, loaded) = pressurise(24, 24, &material(YOUNG, POISSON, None), pressure, 10);
    let factor = pressure / ((OUTER / INNER).powi(3) - 1.0);
    assert_displacement(&mesh, &loaded, outer_displacement(INNER, pressure), 4e-3);
    let lame = |r: f64| {
        [factor * (1.0 - (OUTER / r).powi(3)), factor * (1.0 + 0.5 * (OUTER / r).powi(3))]
    };
    assert_stresses(&loaded, lame, 0.03 * pressure);
}

#[test]
fn the_plastic_zone_spreads_as_hill_says() {
    let steel = material(YOUNG, POISSON, Some(bilinear(YIELD, 0.0)));
    for c in [120.0, 150.0, 180.0] {
        let pressure = pressure_at(c);
        let (mesh, loaded) = pressurise(32, 16, &steel, pressure, 20_000);
        let at_boundary = 2.0 / 3.0 * YIELD * (1.0 - (c / OUTER).powi(3));
        assert_displacement(&mesh, &loaded, outer_displacement(c, at_boundary), 1e-2);
        let exact = |r: f64| {
            if r < c {
                let radial = -pressure + 2.0 * YIELD * (r / INNER).ln();
                [radial, radial + YIELD]
            } else {
                let factor = at_boundary / ((OUTER / c).powi(3) - 1.0);
                [factor * (1.0 - (OUTER / r).powi(3)), factor * (1.0 + 0.5 * (OUTER / r).powi(3))]
            }
        };
        assert_stresses(&loaded, exact, 0.04 * YIELD);
        // The yielded volume of the quarter is that of half a shell up to c.
        let points = loaded.field.points.iter().flatten().filter(|point| point.yielded);
        let volume: f64 = points.map(|point| point.weight).sum();
        let found = (INNER.powi(3) + 1.5 * volume / PI).cbrt();
        assert!((found - c).abs() < 3.0, "c = {found:.2} instead of {c}");
    }
}

/// The limit pressure is met from both sides: 1 % below it the sphere settles, 1 % above nothing
/// holds it.
#[test]
fn the_limit_pressure_is_met_within_one_percent() {
    let limit = 2.0 * YIELD * (OUTER / INNER).ln();
    assert_within(pressure_at(OUTER), limit, 1e-12);
    let steel = material(YOUNG, POISSON, Some(bilinear(YIELD, 0.0)));
    let iterations = |pressure: f64| pressurise(16, 8, &steel, pressure, 6000).1.iterations;
    assert!(iterations(0.99 * limit) < 6000, "settles below the limit");
    assert_eq!(iterations(1.01 * limit), 6000, "does not settle above it");
}
