//! Thick-walled cylinder under internal pressure, and the patch test: the plasticity part alone.
//!
//! With ν → 1/2 all stresses grow in proportion, so that deformation theory is exact and Hill's
//! solution with it; and a mesh that locks would show it here at once.
//!
//! R. Hill, *The Mathematical Theory of Plasticity* (1950), chapter V.

use brinell_solver::analytical::{PowerLawCylinder, ThickCylinder};
use brinell_solver::fem::element::StressState;
use brinell_solver::fem::mesh::Mesh;
use brinell_solver::job::{Bilinear, Deformable, Hardening, NonNegativeF64, RambergOsgood};

use crate::bodies::{Loaded, grid, load, material, positive};
use crate::problems::assert_within;

const INNER: f64 = 100.0;
const OUTER: f64 = 200.0;
const HILL: ThickCylinder = ThickCylinder {
    inner_radius: INNER,
    outer_radius: OUTER,
    young_modulus: 210_000.0,
    poisson_ratio: 0.4999,
    yield_stress: 240.0,
};

/// A quarter of the ring.
fn ring(radial: i32, around: i32) -> Mesh {
    grid(radial, around, |i, j| {
        let r = INNER * (OUTER / INNER).powf(f64::from(i) / f64::from(radial));
        let angle = std::f64::consts::FRAC_PI_2 * f64::from(j) / f64::from(around);
        // The planes of symmetry exactly at zero.
        let (sin, cos) = if j == around { (1.0, 0.0) } else { angle.sin_cos() };
        [r * cos, r * sin]
    })
}

/// The quarter ring under internal pressure, symmetry on both ends.
fn pressurise(radial: i32, around: i32, material: &Deformable, pressure: f64) -> (Mesh, Loaded) {
    let mesh = ring(radial, around);
    let held = mesh.nodes.iter().map(|[x, y]| [*x == 0.0, *y == 0.0]).collect();
    let mut force = vec![[0.0; 2]; mesh.nodes.len()];
    let bore: Vec<usize> = (0..=usize::try_from(around).unwrap()).collect();
    for pair in bore.windows(2) {
        let (p, q) = (mesh.nodes[pair[0]], mesh.nodes[pair[1]]);
        // Pressure on a straight edge, normal to it, half to each end.
        let half = [0.5 * pressure * (q[1] - p[1]), -0.5 * pressure * (q[0] - p[0])];
        for &node in pair {
            force[node][0] += half[0];
            force[node][1] += half[1];
        }
    }
    let loaded = load(&mesh, StressState::PlaneStrain, material, held, &force, 20_000);
    (mesh, loaded)
}

fn perfectly_plastic(poisson: f64) -> Deformable {
    let law = Hardening::Bilinear(Bilinear {
        yield_stress: positive(240.0),
        tangent_modulus: NonNegativeF64::new(0.0).unwrap(),
    });
    material(210_000.0, poisson, Some(law))
}

/// Radial displacement at the outer surface.
fn outer_displacement(mesh: &Mesh, loaded: &Loaded) -> f64 {
    let outermost = mesh
        .nodes
        .iter()
        .zip(&loaded.displacement)
        .filter(|([x, y], _)| *y == 0.0 && *x > OUTER - 1e-9);
    outermost.map(|(_, u)| u[0]).next().unwrap()
}

#[test]
fn below_first_yield_the_ring_is_elastic() {
    let pressure = 0.999 * HILL.first_yield_pressure();
    assert_within(HILL.first_yield_pressure(), 103.92, 1e-4);
    let (mesh, loaded) = pressurise(24, 24, &perfectly_plastic(0.4999), pressure);
    assert_eq!(loaded.field.plastic_points(), 0);
    assert_eq!(loaded.iterations, 2);
    let exact = HILL.under(pressure).unwrap();
    assert_within(outer_displacement(&mesh, &loaded), exact.displacement(OUTER), 2e-3);
}

#[test]
fn the_plastic_zone_spreads_as_hill_says() {
    for (pressure, radius) in [(139.21, 120.0), (163.91, 140.0), (180.13, 160.0)] {
        let (mesh, loaded) = pressurise(32, 20, &perfectly_plastic(0.4999), pressure);
        let exact = HILL.under(pressure).unwrap();
        assert_within(exact.plastic_radius(), radius, 1e-3);
        assert_within(outer_displacement(&mesh, &loaded), exact.displacement(OUTER), 1e-2);

        // The yielded area is that of a ring up to c.
        let area: f64 = loaded
            .field
            .points
            .iter()
            .flatten()
            .filter(|point| point.yielded)
            .map(|point| point.weight)
            .sum();
        let found = (INNER.powi(2) + area / std::f64::consts::FRAC_PI_4).sqrt();
        assert!((found - radius).abs() < 2.5, "c = {found:.2} instead of {radius}");

        // Radial and hoop stress at every point: in-plane principal stresses.
        for point in loaded.field.points.iter().flatten() {
            let r = point.position[0].hypot(point.position[1]);
            let (cos, sin) = (point.position[0] / r, point.position[1] / r);
            let [x, y, _, t] = point.stress;
            let radial = x * cos * cos + y * sin * sin + 2.0 * t * sin * cos;
            let hoop = x * sin * sin + y * cos * cos - 2.0 * t * sin * cos;
            let expected = exact.stress(r);
            assert!(
                (radial - expected.radial).abs() < 6.0,
                "σ_r {radial} instead of {}",
                expected.radial
            );
            assert!((hoop - expected.hoop).abs() < 6.0, "σ_θ {hoop} instead of {}", expected.hoop);
        }
    }
}

/// A little above the limit pressure nothing can hold the ring; a little below it still settles.
/// Elements that lock carry more than the limit.
#[test]
fn the_limit_pressure_is_not_exceeded() {
    let limit = HILL.limit_pressure();
    assert_within(limit, 192.09, 1e-4);
    let outer = |pressure: f64| {
        let (mesh, loaded) = pressurise(16, 10, &perfectly_plastic(0.4999), pressure);
        (outer_displacement(&mesh, &loaded), loaded.iterations)
    };
    let (held, iterations) = outer(0.985 * limit);
    assert!(iterations < 20_000, "settles below the limit");
    let (lost, iterations) = outer(1.01 * limit);
    assert_eq!(iterations, 20_000, "does not settle above it");
    assert!(lost > 5.0 * held);
}

/// The other side of the 1 %: 0.99 of the limit settles, and on Hill's displacement; 1.01 does
/// not, see above.
#[test]
fn the_limit_pressure_is_met_within_one_percent() {
    let pressure = 0.99 * HILL.limit_pressure();
    let (mesh, loaded) = pressurise(16, 10, &perfectly_plastic(0.4999), pressure);
    assert!(loaded.iterations < 20_000, "settles below the limit");
    let exact = HILL.under(pressure).unwrap();
    assert_within(outer_displacement(&mesh, &loaded), exact.displacement(OUTER), 0.05);
}

/// A pure power law, incompressible: `q ~ r^(-2/m)`. The elastic part is made small by a large
/// offset.
#[test]
fn a_power_law_ring_follows_its_closed_form() {
    let (offset, exponent, reference) = (50.0, 3.0, 100.0);
    let law = Hardening::RambergOsgood(RambergOsgood {
        reference_stress: positive(reference),
        offset: positive(offset),
        exponent: positive(exponent),
    });
    let exact = PowerLawCylinder {
        inner_radius: INNER,
        outer_radius: OUTER,
        young_modulus: 210_000.0,
        reference_stress: reference,
        offset,
        exponent,
    };
    let pressure = 150.0;
    let (mesh, loaded) = pressurise(24, 16, &material(210_000.0, 0.4999, Some(law)), pressure);
    let exact = exact.under(pressure);
    // 3 % of the strain at the outer rim is elastic, and on top of the power law.
    assert_within(outer_displacement(&mesh, &loaded), exact.displacement(OUTER), 0.05);
    for point in loaded.field.points.iter().flatten() {
        let r = point.position[0].hypot(point.position[1]);
        let q = brinell_solver::material::von_mises(point.stress);
        assert_within(q, exact.equivalent_stress(r), 0.03);
    }
}

/// Any mesh must reproduce a homogeneous state exactly, elastic or plastic.
#[test]
fn patch_test() {
    let mesh = grid(3, 3, |i, j| {
        let (x, y) = (f64::from(i) / 3.0, f64::from(j) / 3.0);
        // Inner nodes out of place.
        let shift = if (1..3).contains(&i) && (1..3).contains(&j) { 0.09 } else { 0.0 };
        [x + shift * f64::from(2 * j - 3), y - shift * f64::from(i - 1)]
    });
    let held = mesh.nodes.iter().map(|[x, y]| [*x == 0.0, *y == 0.0]).collect::<Vec<_>>();
    let hardening = Hardening::Bilinear(Bilinear {
        yield_stress: positive(240.0),
        tangent_modulus: NonNegativeF64::new(21_000.0).unwrap(),
    });
    for (law, traction, yields) in [(None, 500.0, false), (Some(hardening), 500.0, true)] {
        let mut force = vec![[0.0; 2]; mesh.nodes.len()];
        for (node, [x, y]) in
            mesh.nodes.iter().enumerate().filter(|(_, [x, _])| (*x - 1.0).abs() < 1e-12)
        {
            let share = if *y < 1e-12 || *y > 1.0 - 1e-12 { 0.5 } else { 1.0 };
            force[node][0] = traction * share / 3.0 * x;
        }
        let loaded = load(
            &mesh,
            StressState::PlaneStrain,
            &material(210_000.0, 0.3, law),
            held.clone(),
            &force,
            5000,
        );
        let first = loaded.field.points[0][0];
        assert_eq!(first.yielded, yields);
        for point in loaded.field.points.iter().flatten() {
            assert!((point.stress[0] - traction).abs() < 1e-6 * traction, "{:?}", point.stress);
            for (a, b) in point.stress.iter().zip(&first.stress) {
                assert!((a - b).abs() < 1e-6 * traction);
            }
            assert!(
                point.stress[1].abs() < 1e-6 * traction && point.stress[3].abs() < 1e-6 * traction
            );
        }
    }
}
