//! Identities that hold to rounding whatever the grid, and closed forms of elasticity.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

use std::f64::consts::PI;

use brinell_halfspace::{
    COMPONENTS, Elasticity, EllipticContact, HalfSpace, Layers, SurfaceGrid, TensorField,
};
use proptest::prelude::*;

/// Work that is not stopped.
fn never() -> bool {
    false
}

const WEIGHTS: [f64; COMPONENTS] = [1.0, 1.0, 1.0, 2.0, 2.0, 2.0];

fn body(grid: SurfaceGrid, faces: &[f64], young: f64, images: bool) -> HalfSpace {
    let layers = Layers::new(faces.to_vec()).unwrap();
    let elastic = Elasticity::new(young, 0.3).unwrap();
    let build = if images { HalfSpace::new } else { HalfSpace::periodic };
    build(grid, layers, elastic, false, &mut never).unwrap()
}

/// Numbers between -1 and 1 that a seed determines.
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

fn random_strain(body: &HalfSpace, seed: u64) -> TensorField {
    let mut strain = TensorField::tensors(body.layers().len(), body.grid().n_cells());
    let mut next = noise(seed);
    strain.values_mut().fill_with(&mut next);
    strain
}

/// `u_p` and `σ` of a strain and a pressure.
fn response(body: &HalfSpace, strain: &TensorField, pressure: &[f64]) -> (Vec<f64>, TensorField) {
    let mut work =
        if strain.n_components() == COMPONENTS { body.work_for_tensors() } else { body.work() };
    let mut opening = vec![0.0; pressure.len()];
    body.opening(strain, &mut work, &mut opening, &mut never).unwrap();
    let mut stress = TensorField::tensors(strain.n_layers(), strain.n_cells());
    body.stress(pressure, &mut work, &mut stress, &mut never).unwrap();
    (opening, stress)
}

/// `∫ a : b dV`.
fn work_of(body: &HalfSpace, a: &TensorField, b: &TensorField) -> f64 {
    let mut sum = 0.0;
    for layer in 0..a.n_layers() {
        for (k, weight) in WEIGHTS.into_iter().enumerate() {
            let product: f64 =
                a.component(layer, k).iter().zip(b.component(layer, k)).map(|(a, b)| a * b).sum();
            sum += body.layers().thickness(layer) * weight * product;
        }
    }
    sum * body.grid().cell_area()
}

fn size(body: &HalfSpace, a: &TensorField) -> f64 {
    work_of(body, a, a).sqrt()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn g_is_symmetric_and_between_nothing_and_the_stiffness(
        nx in 3..9usize, ny in 3..9usize, hx in 0.5..2.0_f64, growth in 1.0..1.5_f64, images: bool, seed in 1..1000u64,
    ) {
        let grid = SurfaceGrid::new(nx, ny, hx, 1.0).unwrap();
        let layers = Layers::graded(0.4, growth, 3.0).unwrap();
        let body = body(grid, layers.faces(), 1.0, images);
        let nothing = vec![0.0; grid.n_cells()];
        let (one, two) = (random_strain(&body, seed), random_strain(&body, seed + 1));
        let (stress_one, stress_two) = (response(&body, &one, &nothing).1, response(&body, &two, &nothing).1);
        let scale = size(&body, &one) * size(&body, &stress_two);
        let difference = work_of(&body, &one, &stress_two) - work_of(&body, &two, &stress_one);
        prop_assert!(difference.abs() < 1e-14 * scale, "{:e}", difference / scale);
        let energy = -work_of(&body, &one, &stress_one);
        prop_assert!(energy > 0.0);
        let (shear, lame) = (body.elastic().shear(), body.elastic().lame());
        let mut rigid = one.clone();
        for layer in 0..one.n_layers() {
            for k in 0..COMPONENTS {
                for cell in 0..one.n_cells() {
                    let trace: f64 = (0..3).map(|k| one.component(layer, k)[cell]).sum();
                    let own = 2.0 * shear * one.component(layer, k)[cell];
                    rigid.component_mut(layer, k)[cell] = own + if k < 3 { lame * trace } else { 0.0 };
                }
            }
        }
        prop_assert!(energy < work_of(&body, &one, &rigid));
    }

    #[test]
    fn displacement_is_the_transpose_of_stress(
        nx in 2..9usize, ny in 2..9usize, hx in 0.5..2.0_f64, seed in 1..1000u64,
    ) {
        let grid = SurfaceGrid::new(nx, ny, hx, 1.0).unwrap();
        let body = body(grid, &[0.0, 0.3, 0.8, 1.7], 1.0, false);
        let strain = random_strain(&body, seed);
        let mut next = noise(seed + 7);
        let pressure: Vec<f64> = (0..grid.n_cells()).map(|_| next()).collect();
        let none = TensorField::tensors(3, grid.n_cells());
        let opening = response(&body, &strain, &vec![0.0; grid.n_cells()]).0;
        let stress = response(&body, &none, &pressure).1;
        let left: f64 = opening.iter().zip(&pressure).map(|(u, p)| u * p).sum::<f64>() * grid.cell_area();
        let right = work_of(&body, &stress, &strain);
        prop_assert!((left - right).abs() < 1e-13 * size(&body, &stress) * size(&body, &strain));
    }
}

/// A strain that is symmetric about both axes, from the numbers of its quarter.
fn symmetric_strain(body: &HalfSpace, seed: u64) -> TensorField {
    let mut strain = random_strain(body, seed);
    let (nx, ny) = (body.grid().nx(), body.grid().ny());
    for layer in 0..strain.n_layers() {
        for k in 0..COMPONENTS {
            let (in_x, in_y) = (
                if [3, 4].contains(&k) { -1.0 } else { 1.0 },
                if [3, 5].contains(&k) { -1.0 } else { 1.0 },
            );
            let field = strain.component_mut(layer, k);
            for i in 0..nx {
                for j in 0..ny {
                    let sign =
                        if 2 * i < nx { in_x } else { 1.0 } * if 2 * j < ny { in_y } else { 1.0 };
                    field[i * ny + j] = sign * field[i.max(nx - 1 - i) * ny + j.max(ny - 1 - j)];
                }
            }
        }
    }
    strain
}

/// On even and on odd numbers of wave vectors of a quarter, and with padding beyond twice the
/// grid.
#[test]
fn a_quarter_of_the_wave_vectors_is_enough_for_a_symmetric_state() {
    for (nx, ny, images) in [(6, 8, true), (10, 18, false), (14, 22, true), (34, 40, true)] {
        let grid = SurfaceGrid::new(nx, ny, 0.7, 0.4).unwrap();
        let layers = Layers::new(vec![0.0, 0.3, 0.8, 1.1]).unwrap();
        let elastic = Elasticity::new(2.0, 0.3).unwrap();
        let build = if images { HalfSpace::new } else { HalfSpace::periodic };
        let [whole, quarter] = [false, true].map(|is_symmetric| {
            build(grid, layers.clone(), elastic, is_symmetric, &mut never).unwrap()
        });
        let strain = symmetric_strain(&whole, 3);
        let pressure = strain.component(0, 0).to_vec();
        let (opening, stress) = response(&whole, &strain, &pressure);
        let (opening_of_quarter, stress_of_quarter) = response(&quarter, &strain, &pressure);
        for (a, b) in opening.iter().zip(&opening_of_quarter) {
            assert!((a - b).abs() < 1e-13, "{nx} × {ny}: {a} {b}");
        }
        for (a, b) in stress.values().iter().zip(stress_of_quarter.values()) {
            assert!((a - b).abs() < 1e-13, "{nx} × {ny}: {a} {b}");
        }
    }
}

/// Permutations of the cells and components when x and y are swapped, or the body is turned by
/// 90°.
fn moved(strain: &TensorField, n: usize, turn: bool) -> TensorField {
    let mut out = strain.clone();
    // (x, y) -> (y, x), or (x, y) -> (-y, x): xx <-> yy, xy -> ±xy, (xz, yz) -> (±yz, xz).
    let sign = if turn { -1.0 } else { 1.0 };
    let to = [(1, 1.0), (0, 1.0), (2, 1.0), (3, sign), (5, 1.0), (4, sign)];
    for layer in 0..strain.n_layers() {
        for (k, (target, factor)) in to.into_iter().enumerate() {
            let from = strain.component(layer, k).to_vec();
            for i in 0..n {
                for j in 0..n {
                    let x = if turn { n - 1 - j } else { j };
                    out.component_mut(layer, target)[x * n + i] = factor * from[i * n + j];
                }
            }
        }
    }
    out
}

#[test]
fn swapping_and_turning_the_body_swaps_and_turns_the_answer() {
    let n = 8;
    let grid = SurfaceGrid::new(n, n, 0.7, 0.7).unwrap();
    for images in [false, true] {
        let body = body(grid, &[0.0, 0.3, 0.8, 1.7, 2.0], 1.0, images);
        let strain = random_strain(&body, 5);
        let mut next = noise(11);
        let pressure: Vec<f64> = (0..n * n).map(|_| next()).collect();
        let (opening, stress) = response(&body, &strain, &pressure);
        for turn in [false, true] {
            let carried = |field: &[f64]| {
                let mut out = vec![0.0; n * n];
                for i in 0..n {
                    for j in 0..n {
                        out[if turn { n - 1 - j } else { j } * n + i] = field[i * n + j];
                    }
                }
                out
            };
            let (opening_moved, stress_moved) =
                response(&body, &moved(&strain, n, turn), &carried(&pressure));
            let expected = moved(&stress, n, turn);
            let scale = stress.values().iter().fold(0.0, |most: f64, s| most.max(s.abs()));
            for (a, b) in stress_moved.values().iter().zip(expected.values()) {
                assert!(
                    (a - b).abs() < 1e-13 * scale,
                    "{a} {b}, turned: {turn}, images: {images}"
                );
            }
            let scale = opening.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
            for (a, b) in opening_moved.iter().zip(carried(&opening)) {
                assert!((a - b).abs() < 1e-13 * scale);
            }
        }
    }
}

#[test]
fn a_body_scaled_in_size_and_stiffness_has_the_same_answer() {
    let small = body(SurfaceGrid::new(6, 5, 0.7, 0.4).unwrap(), &[0.0, 0.3, 0.8], 2.0, true);
    let large = body(SurfaceGrid::new(6, 5, 2.8, 1.6).unwrap(), &[0.0, 1.2, 3.2], 10.0, true);
    let strain = random_strain(&small, 3);
    let (u_small, s_small) = response(&small, &strain, &[0.2; 30]);
    let (u_large, s_large) = response(&large, &strain, &[1.0; 30]);
    for (a, b) in u_small.iter().zip(&u_large) {
        assert!((4.0 * a - b).abs() < 1e-13 * b.abs().max(1.0));
    }
    for (a, b) in s_small.values().iter().zip(s_large.values()) {
        assert!((5.0 * a - b).abs() < 1e-12 * b.abs().max(1.0));
    }
}

#[test]
fn deviators_take_the_short_way_to_the_same_answer() {
    let grid = SurfaceGrid::new(6, 8, 0.7, 0.4).unwrap();
    let body = body(grid, &[0.0, 0.3, 0.8, 1.1], 2.0, true);
    let (mut whole, mut short) = (TensorField::tensors(3, 48), TensorField::deviators(3, 48));
    let mut next = noise(9);
    short.values_mut().fill_with(&mut next);
    for layer in 0..3 {
        for (k, row) in [0, 1, 3, 4, 5].into_iter().enumerate() {
            let values = short.component(layer, k).to_vec();
            whole.component_mut(layer, row).copy_from_slice(&values);
            for (zz, value) in whole.component_mut(layer, 2).iter_mut().zip(&values) {
                *zz -= if row < 2 { *value } else { 0.0 };
            }
        }
    }
    let (opening, stress) = response(&body, &whole, &[1.0; 48]);
    let (mut work, mut found) = (body.work(), vec![0.0; 48]);
    body.opening(&short, &mut work, &mut found, &mut never).unwrap();
    let mut deviator = TensorField::deviators(3, 48);
    body.stress(&[1.0; 48], &mut work, &mut deviator, &mut never).unwrap();
    for (a, b) in opening.iter().zip(&found) {
        assert!((a - b).abs() < 1e-13);
    }
    for layer in 0..3 {
        for cell in 0..48 {
            let mean = (0..3).map(|k| stress.component(layer, k)[cell]).sum::<f64>() / 3.0;
            for (k, row) in [0, 1, 3, 4, 5].into_iter().enumerate() {
                let expected =
                    stress.component(layer, row)[cell] - if row < 2 { mean } else { 0.0 };
                assert!((deviator.component(layer, k)[cell] - expected).abs() < 1e-12);
            }
        }
    }
}

/// Fills the cells whose centre lies in a sphere, by the part of `fine³` points of a cell inside
/// it.
fn sphere(body: &HalfSpace, radius: f64, depth: f64, strain: [f64; COMPONENTS]) -> TensorField {
    let (grid, layers) = (body.grid(), body.layers());
    let mut field = TensorField::tensors(layers.len(), grid.n_cells());
    let fine = 6_u32;
    let place = |n: usize| (n as f64 + 0.5) / f64::from(fine) - 0.5;
    for layer in 0..layers.len() {
        for i in 0..grid.nx() {
            for j in 0..grid.ny() {
                let mut inside = 0.0;
                for n in 0..fine.pow(3) as usize {
                    let x = grid.x(i) + place(n % 6) * grid.hx();
                    let y = grid.y(j) + place(n / 6 % 6) * grid.hy();
                    let z = layers.middle(layer) + place(n / 36) * layers.thickness(layer) - depth;
                    inside += f64::from(u8::from(x * x + y * y + z * z < radius * radius));
                }
                let part = inside / f64::from(fine.pow(3));
                for (k, value) in strain.into_iter().enumerate() {
                    field.component_mut(layer, k)[i * grid.ny() + j] = part * value;
                }
            }
        }
    }
    field
}

#[test]
fn a_dilating_sphere_lifts_the_surface() {
    // u_z = -(1+ν)/π ε V d/(r² + d²)^{3/2}, ε the linear strain.
    let n = 24;
    let grid = SurfaceGrid::new(n, n, 1.0 / 6.0, 1.0 / 6.0).unwrap();
    let layers = Layers::graded(1.0 / 6.0, 1.0, 4.0).unwrap();
    let body = body(grid, layers.faces(), 1.0, false);
    let strain = sphere(&body, 1.0, 1.6, [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    let (opening, _) = response(&body, &strain, &vec![0.0; n * n]);
    let volume: f64 = strain.values().iter().sum::<f64>() / 3.0 / 6.0_f64.powi(3);
    assert!((volume / (4.0 / 3.0 * PI) - 1.0).abs() < 3e-3);
    for (cell, u) in opening.iter().enumerate() {
        let (x, y) = (grid.x(cell / n), grid.y(cell % n));
        let expected = -1.3 / PI * volume * 1.6 / (x * x + y * y + 1.6 * 1.6).powf(1.5);
        assert!((u / expected - 1.0).abs() < 2e-3, "{u} {expected}");
    }
}

#[test]
fn a_sphere_deep_below_is_eshelbys() {
    // Interior stress of a sphere in an infinite body: -2μ(1-β) ε for a deviator, β =
    // 2(4-5ν)/(15(1-ν)); -3K(1-α) ε for a dilatation, α = (1+ν)/(3(1-ν)).
    let n = 18;
    let grid = SurfaceGrid::new(n, n, 0.2, 0.2).unwrap();
    let faces: Vec<f64> =
        std::iter::once(0.0).chain((0..=14).map(|k| 2.2 + 0.2 * f64::from(k))).collect();
    let body = body(grid, &faces, 1.0, true);
    let nothing = vec![0.0; n * n];
    let centre = |stress: &TensorField, k: usize| {
        let layer = (0..stress.n_layers()).min_by(|a, b| {
            let off = |layer: &usize| (body.layers().middle(*layer) - 3.4).abs();
            off(a).total_cmp(&off(b))
        });
        let at = |i: usize, j: usize| stress.component(layer.unwrap(), k)[i * n + j];
        let m = n / 2;
        0.25 * (at(m, m) + at(m - 1, m) + at(m, m - 1) + at(m - 1, m - 1))
    };
    let deviator = sphere(&body, 1.0, 3.4, [1.0, -1.0, 0.0, 0.0, 0.0, 0.0]);
    let found = centre(&response(&body, &deviator, &nothing).1, 0);
    let beta = 2.0 * (4.0 - 1.5) / (15.0 * 0.7);
    let expected = -(1.0 - beta) / 1.3;
    assert!((found / expected - 1.0).abs() < 1e-2, "{found} {expected}");
    let dilatation = sphere(&body, 1.0, 3.4, [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    let found = centre(&response(&body, &dilatation, &nothing).1, 0);
    let expected = -(1.0 - 1.3 / 2.1) / 0.4;
    assert!((found / expected - 1.0).abs() < 1e-2, "{found} {expected}");
}

#[test]
fn stresses_on_the_axis_are_hertz() {
    // σzz = -p0/(1 + z²/a²), and σxx = -p0[(1+ν)(1 - z/a atan(a/z)) - 1/(2(1 + z²/a²))], averaged
    // over layers.
    let n = 49;
    let grid = SurfaceGrid::new(n, n, 2.6 / n as f64, 2.6 / n as f64).unwrap();
    let layers = Layers::graded(0.06, 1.06, 2.6).unwrap();
    let body = body(grid, layers.faces(), 1.0, false);
    let mut pressure = grid.sample(|x, y| (1.0 - x * x - y * y).max(0.0).sqrt());
    let scale = 2.0 / 3.0 * PI / (pressure.iter().sum::<f64>() * grid.cell_area());
    for p in &mut pressure {
        *p *= scale;
    }
    let none = TensorField::tensors(layers.len(), n * n);
    let stress = response(&body, &none, &pressure).1;
    let (mut largest, mut depth) = (0.0, 0.0);
    for layer in 0..layers.len() {
        let (z, h) = (layers.middle(layer), layers.thickness(layer));
        let mean = |f: &dyn Fn(f64) -> f64| {
            (0..64).map(|k| f(z + ((f64::from(k) + 0.5) / 64.0 - 0.5) * h)).sum::<f64>() / 64.0
        };
        let normal = mean(&|z| -1.0 / (1.0 + z * z));
        let radial = mean(&|z| -(1.3 * (1.0 - z * (1.0 / z).atan()) - 0.5 / (1.0 + z * z)));
        let at = |k: usize| stress.component(layer, k)[n / 2 * n + n / 2];
        assert!((at(2) - normal).abs() < 5e-4, "{z}: {} {normal}", at(2));
        assert!((at(0) - radial).abs() < 5e-4, "{z}: {} {radial}", at(0));
        assert!((at(0) - at(1)).abs() < 1e-14);
        let shear = 0.5 * (at(0) - at(2));
        if shear > largest {
            (largest, depth) = (shear, z);
        }
    }
    assert!((largest - 0.310).abs() < 1e-3 && (depth - 0.48).abs() < 0.06, "{largest} at {depth}");
}

/// `σzz = -p0/√((1 + z²/a²)(1 + z²/b²))` on the axis; the largest shear stress and its depth; the
/// orthogonal shear stress of G. Lundberg and A. Palmgren (1947), `√(2t - 1)/(2t(t + 1)) p0` with
/// `(t² - 1)(2t - 1) = (a/b)²`.
#[test]
fn stresses_below_ellipses_are_hertz() {
    let n = 49;
    for (radius_ratio, shear, at) in [(5.0, 0.325, 0.689), (20.0, 0.3181, 0.761)] {
        let hertz = EllipticContact::new(1.0, radius_ratio, 1.0, 1.0);
        let b = hertz.semi_axis_y / hertz.semi_axis_x;
        let grid = SurfaceGrid::new(n, n, 2.6 / n as f64, 2.6 * b / n as f64).unwrap();
        let layers = Layers::graded(0.04, 1.05, 2.6).unwrap();
        let body = body(grid, layers.faces(), 1.0, false);
        let mut pressure = grid.sample(|x, y| (1.0 - x * x - y * y / (b * b)).max(0.0).sqrt());
        let scale = 2.0 / 3.0 * PI * b / (pressure.iter().sum::<f64>() * grid.cell_area());
        for p in &mut pressure {
            *p *= scale;
        }
        let stress = response(&body, &TensorField::tensors(layers.len(), n * n), &pressure).1;
        let (mut largest, mut orthogonal) = ((0.0, 0.0), 0.0_f64);
        for layer in 0..layers.len() {
            let (z, h) = (layers.middle(layer), layers.thickness(layer));
            let normal = |z: f64| -1.0 / ((1.0 + z * z) * (1.0 + z * z / (b * b))).sqrt();
            let normal =
                (0..64).map(|k| normal(z + ((f64::from(k) + 0.5) / 64.0 - 0.5) * h)).sum::<f64>()
                    / 64.0;
            let on_axis = |k: usize| stress.component(layer, k)[n / 2 * n + n / 2];
            assert!((on_axis(2) - normal).abs() < 5e-4, "{z}: {} {normal}", on_axis(2));
            let shear = 0.5 * (on_axis(0) - on_axis(2)).abs().max((on_axis(1) - on_axis(2)).abs());
            if shear > largest.0 {
                largest = (shear, z);
            }
            let section = (0..n).map(|i| stress.component(layer, 4)[i * n + n / 2].abs());
            orthogonal = section.fold(orthogonal, f64::max);
        }
        assert!((largest.0 - shear).abs() < 1e-3 && (largest.1 - at).abs() < 0.05, "{largest:?}");
        let is_below = |t: &f64| (t * t - 1.0) * (2.0 * t - 1.0) < (b * b).recip();
        let t = (0..4000).map(|k| 1.0 + 1e-4 * f64::from(k)).take_while(is_below).last().unwrap();
        let expected = (2.0 * t - 1.0).sqrt() / (2.0 * t * (t + 1.0));
        assert!((orthogonal / expected - 1.0).abs() < 1e-2, "{orthogonal} {expected}");
    }
}

#[test]
fn plastic_strain_leaves_the_surface_free_of_traction() {
    // Layers thin enough to look at the surface: tractions fall to zero with the depth, stresses
    // in the plane do not.
    let n = 16;
    let grid = SurfaceGrid::new(n, n, 0.25, 0.25).unwrap();
    let faces: Vec<f64> =
        [0.0, 1e-4, 2e-4].into_iter().chain((0..9).map(|k| 0.2 + 0.25 * f64::from(k))).collect();
    let body = body(grid, &faces, 1.0, true);
    let strain = sphere(&body, 0.9, 1.2, [1.0, 0.5, -1.5, 0.3, 0.2, -0.4]);
    let stress = response(&body, &strain, &vec![0.0; n * n]).1;
    let largest =
        |k: usize| stress.component(0, k).iter().fold(0.0, |most: f64, s| most.max(s.abs()));
    let in_plane = largest(0);
    assert!(in_plane > 1e-2);
    for k in [2, 4, 5] {
        assert!(largest(k) < 1e-3 * in_plane, "component {k}: {} of {in_plane}", largest(k));
    }
}

#[test]
fn a_dilating_sphere_stretches_the_surface_above_it() {
    // Mindlin and Cheng: the surface moves outwards by u_r = (1+ν)/π ε V r/(r² + d²)^{3/2}, and is
    // free of traction: σxx = E/(1-ν) du_r/dr at r = 0.
    let n = 24;
    let grid = SurfaceGrid::new(n, n, 0.15, 0.15).unwrap();
    let faces: Vec<f64> =
        [0.0, 1e-3].into_iter().chain((0..22).map(|k| 0.15 + 0.15 * f64::from(k))).collect();
    let body = body(grid, &faces, 1.0, true);
    let strain = sphere(&body, 1.0, 1.5, [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    let stress = response(&body, &strain, &vec![0.0; n * n]).1;
    let m = n / 2;
    let surface = stress.component(0, 0);
    let found = 0.25
        * [m * n + m, (m - 1) * n + m, m * n + m - 1, (m - 1) * n + m - 1]
            .map(|k| surface[k])
            .iter()
            .sum::<f64>();
    // Half a cell off the axis, like the cells around it.
    let r2 = 2.0 * 0.075 * 0.075;
    let volume: f64 = (0..23)
        .map(|layer| {
            body.layers().thickness(layer)
                * strain.component(layer, 0).iter().sum::<f64>()
                * 0.15
                * 0.15
        })
        .sum();
    let (d2, c) = (1.5 * 1.5 + r2, 1.3 / PI * volume);
    let (radial, hoop) = (c * (d2 - 3.0 * r2) / d2.powf(2.5), c / d2.powf(1.5));
    let expected = 0.5 * (radial + hoop) / 0.7;
    assert!((found / expected - 1.0).abs() < 1e-2, "{found} {expected}");
}

#[test]
fn work_ends_when_it_is_asked_to() {
    let grid = SurfaceGrid::new(6, 8, 0.7, 0.4).unwrap();
    let faces = [0.0, 0.3, 0.8, 1.1];
    let layers = Layers::new(faces.to_vec()).unwrap();
    let elastic = Elasticity::new(2.0, 0.3).unwrap();
    assert!(HalfSpace::new(grid, layers, elastic, false, &mut || true).is_err());
    let body = body(grid, &faces, 2.0, true);
    let strain = random_strain(&body, 4);
    let (mut work, mut opening) = (body.work_for_tensors(), vec![0.0; 48]);
    // Each layer is asked about, and each of the nine wave numbers along y of 16 padded cells.
    let mut asked = 0;
    body.opening(&strain, &mut work, &mut opening, &mut || {
        asked += 1;
        false
    })
    .unwrap();
    assert_eq!(asked, 3 + 9);
    let mut stress = TensorField::tensors(3, 48);
    assert!(body.stress(&[1.0; 48], &mut work, &mut stress, &mut || true).is_err());
}
