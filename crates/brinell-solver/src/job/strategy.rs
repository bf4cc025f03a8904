//! Any job that the format can say, as a strategy for property tests.

#![expect(clippy::unwrap_used, reason = "the values drawn are in range")]

use std::collections::BTreeMap;

use proptest::collection::{btree_map, vec};
use proptest::prelude::*;

use super::reader::Named;
use super::*;

/// A positive number within two decades of a typical one, so that it is in range in either unit system.
fn near(typical: f64) -> impl Strategy<Value = PositiveF64> {
    (-2.0..2.0_f64).prop_map(move |decades| PositiveF64::new(typical * 10_f64.powf(decades)).unwrap())
}

fn between(low: f64, high: f64) -> impl Strategy<Value = PositiveF64> {
    (low..=high).prop_map(|value| PositiveF64::new(value).unwrap())
}

fn shape() -> impl Strategy<Value = Shape> {
    let profile = (vec((0.01..1.0, -1.0..1.0_f64), 2..20), near(300.0)).prop_map(|(steps, depth)| {
        let mut x = -0.005;
        let points = steps.into_iter().map(|(step, height)| {
            let point = [x, height];
            x += step;
            point
        });
        Shape::Profile(Profile::new(points.collect(), depth).unwrap())
    });
    prop_oneof![
        near(20.0).prop_map(|radius| Shape::Cylinder { radius }),
        (near(200.0), near(200.0)).prop_map(|(width, depth)| Shape::Block { width, depth }),
        // Below the exact limit: a conversion may move width and radius apart in the last digit.
        (near(20.0), 0.01..1.99, near(50.0)).prop_map(|(radius, ratio, depth)| {
            let width = PositiveF64::new(radius.get() * ratio).unwrap();
            Shape::Groove(Groove::new(radius, width, depth).unwrap())
        }),
        profile,
    ]
}

fn curve() -> impl Strategy<Value = Hardening> {
    let table = vec((1e-4..1.0, 0.01..10.0_f64), 1..20).prop_map(|steps| {
        let (mut strain, mut stress) = (0.0, 200.0);
        let points = steps.into_iter().map(|(strain_step, stress_step)| {
            let point = [strain, stress];
            strain += strain_step;
            stress += stress_step;
            point
        });
        Hardening::Table { points: TablePoints::new(points.collect()).unwrap() }
    });
    prop_oneof![
        (near(500.0), 0.0..90.0).prop_map(|(yield_stress, slope)| Hardening::Bilinear {
            yield_stress,
            tangent_modulus: NonNegativeF64::new(slope).unwrap(),
        }),
        (near(500.0), near(0.3), between(1.0, 200.0)).prop_map(|(reference_stress, offset, exponent)| {
            Hardening::RambergOsgood { reference_stress, offset, exponent }
        }),
        table,
        (near(300.0), near(0.01), between(0.001, 1.0)).prop_map(|(yield_stress, strain_offset, exponent)| {
            Hardening::Swift { yield_stress, strain_offset, exponent }
        }),
        (near(300.0), near(400.0), between(0.001, 1.0)).prop_map(|(yield_stress, coefficient, exponent)| {
            Hardening::Ludwik { yield_stress, coefficient, exponent }
        }),
        (near(300.0), 1.01..2.0, near(10.0)).prop_map(|(yield_stress, ratio, rate)| {
            let saturation_stress = PositiveF64::new(yield_stress.get() * ratio).unwrap();
            Hardening::Voce { yield_stress, saturation_stress, rate }
        }),
    ]
}

fn deformable() -> impl Strategy<Value = Material> {
    let constants = (near(10_000.0), (0.0..0.5).prop_map(|ratio| PoissonRatio::new(ratio).unwrap()));
    (constants, proptest::option::of(curve())).prop_map(|((young_modulus, poisson_ratio), curve)| {
        Material::Deformable(Deformable::new(Elastic { young_modulus, poisson_ratio }, curve).unwrap())
    })
}

fn body(material: impl Strategy<Value = Material>) -> impl Strategy<Value = Body> {
    (shape(), material, any_of(Support::ALL)).prop_map(|(shape, material, support)| Body {
        shape,
        material,
        support,
    })
}

fn any_of<T: Named + std::fmt::Debug>(all: &'static [T]) -> impl Strategy<Value = T> {
    proptest::sample::select(all)
}

fn load() -> impl Strategy<Value = Load> {
    let sweep = |typical| vec(near(typical), 1..20).prop_map(|values| Sweep::new(values).unwrap());
    prop_oneof![
        sweep(600.0).prop_map(Load::Forces),
        sweep(0.02).prop_map(Load::Approaches),
        Just(Load::Onset)
    ]
}

fn settings() -> impl Strategy<Value = (MeshSettings, SolverSettings, OutputSettings)> {
    let solver = (any_of(Coupling::ALL), any_of(ContactMethod::ALL), between(1e-12, 1e-1), 1..=100_000_u32);
    let solver = solver.prop_map(|(coupling, contact, tolerance, max_iterations)| SolverSettings {
        coupling,
        contact,
        tolerance,
        max_iterations,
    });
    let mesh = (4..=320_u32).prop_map(|elements_per_half_width| MeshSettings { elements_per_half_width });
    let output =
        (any::<bool>(), any::<bool>()).prop_map(|(subsurface, fields)| OutputSettings { subsurface, fields });
    (mesh, solver, output)
}

fn tags() -> impl Strategy<Value = BTreeMap<String, String>> {
    btree_map("[a-zé/~ ]{1,64}", "[^\\p{Cc}]{0,256}", 0..5)
}

/// Any job that the format can say, solvable or not.
pub fn job() -> impl Strategy<Value = Job> {
    let lower = prop_oneof![4 => deformable(), 1 => Just(Material::Rigid)];
    let bodies = (body(deformable()), body(lower), any::<bool>());
    let kinds = (any_of(Analysis::ALL), any_of(Units::ALL));
    (kinds, bodies, load(), settings(), tags()).prop_map(
        |((analysis, units), (one, other, swap), load, (mesh, solver, output), tags)| {
            let (upper, lower) = if swap { (other, one) } else { (one, other) };
            Job { analysis, units, upper, lower, load, mesh, solver, output, tags }
        },
    )
}
