//! Operators of a track, by closed forms and by what they owe each other.

use brinell_halfspace::Layers;
use brinell_halfspace::line::LineSpace;
use brinell_halfspace::track::{Direction, Operators as _, TrackGrid, TrackLimits};
use brinell_material::analytical::{DepthLimit, HertzLine};

use super::driver::{POISSON, YIELD, hertz, limits, shear_strength, space};

fn track(resolution: usize, first: f64, growth: f64) -> LineSpace {
    let grid = TrackGrid::of_line(1.0, resolution, 32.0).unwrap();
    space(grid, Layers::graded(first * grid.column(), growth, 3.0).unwrap())
}

/// Numbers between -1 and 1, other ones for each seed.
fn noise(seed: u64, n: usize) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    (0..n).map(|_| next()).collect()
}

/// `∫a:b` of deviators xx, zz, xz, over the layers.
fn product(space: &LineSpace, a: &[f64], b: &[f64]) -> f64 {
    let n = space.ground().grid.n_columns();
    let layers = a.chunks_exact(3 * n).zip(b.chunks_exact(3 * n)).enumerate();
    layers
        .map(|(layer, (a, b))| {
            let cell = |i: usize| {
                let ([ax, az, at], [bx, bz, bt]) =
                    ([a[i], a[n + i], a[2 * n + i]], [b[i], b[n + i], b[2 * n + i]]);
                2.0 * (ax * bx + az * bz + at * bt) + ax * bz + az * bx
            };
            space.ground().layers.thickness(layer) * (0..n).map(cell).sum::<f64>()
        })
        .sum()
}

/// G of a polarization, with the displacement of the window.
fn of_strain(space: &LineSpace, polarization: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (mut work, strained) = (space.work(), vec![1; space.ground().layers.len()]);
    let mut opening = vec![0.0; space.ground().grid.window().len()];
    let mut stress = vec![0.0; space.ground().field_len::<3>()];
    let none = vec![0.0; opening.len()];
    space
        .opening(Direction::Normal, polarization, &strained, &mut work, &mut opening, &mut || {
            false
        })
        .unwrap();
    space.stress(&none, 0.0, &mut work, &mut stress, &mut || false).unwrap();
    (stress, opening)
}

fn of_pressure(space: &LineSpace, pressure: &[f64], friction: f64) -> Vec<f64> {
    let mut stress = vec![0.0; space.ground().field_len::<3>()];
    space.stress(pressure, friction, &mut space.work(), &mut stress, &mut || false).unwrap();
    stress
}

#[test]
fn stress_below_hertz_is_that_of_mcewen() {
    for (resolution, tolerance) in [(10, 11e-4), (20, 3e-4), (40, 1.7e-4)] {
        let space = track(resolution, 0.75, 1.06);
        let stress = of_pressure(&space, &hertz(&space.ground().grid, 1.0), 0.0);
        let (n, exact) =
            (space.ground().grid.n_columns(), HertzLine::from_peak_pressure(1.0, 1.0, 2.0));
        let mut worst: f64 = 0.0;
        for layer in 0..space.ground().layers.len() {
            let (top, h) =
                (space.ground().layers.faces()[layer], space.ground().layers.thickness(layer));
            let mean = |row: usize| {
                let at = |k: u32| {
                    let stress =
                        exact.stress_on_axis(top + h * (f64::from(k) + 0.5) / 40.0, POISSON);
                    let third = (stress.sigma_x + stress.sigma_y + stress.sigma_z) / 3.0;
                    [stress.sigma_x, stress.sigma_y][row] - third
                };
                (0..40).map(at).sum::<f64>() / 40.0
            };
            for row in 0..2 {
                let found = stress[(layer * 3 + row) * n + n / 2];
                worst = worst.max((found - mean(row)).abs());
            }
        }
        assert!(worst < tolerance, "{resolution}: {worst:.2e}");
    }
}

/// A shear stress at depth by pressure, and by a traction of the same shape.
#[test]
fn stress_beside_the_axis_is_that_of_mcewen_with_friction() {
    let space = track(20, 0.75, 1.06);
    let (n, friction) = (space.ground().grid.n_columns(), 0.3);
    let stress = of_pressure(&space, &hertz(&space.ground().grid, 1.0), friction);
    let exact = HertzLine::from_peak_pressure(1.0, 1.0, 2.0);
    for layer in 2..space.ground().layers.len() {
        for i in (n / 2 - 60..n / 2 + 60).step_by(7) {
            let (x, z) = (space.ground().grid.x(i), space.ground().layers.middle(layer));
            let expected = exact.stress(x, z, POISSON);
            // A traction in +x makes σxz of the sign of σxx under pressure.
            let expected = expected.tau_xy + friction * expected.sigma_x;
            let found = stress[(layer * 3 + 2) * n + i];
            assert!((found - expected).abs() < 4e-3, "{x} {z}: {found} instead of {expected}");
        }
    }
}

#[test]
fn stress_of_strain_is_symmetric_and_takes_away_no_more_than_there_is() {
    let space = track(10, 0.75, 1.06);
    for seed in 0..3 {
        let (a, b) = (
            noise(2 * seed + 1, space.ground().field_len::<3>()),
            noise(2 * seed + 2, space.ground().field_len::<3>()),
        );
        let (of_a, of_b) = (of_strain(&space, &a).0, of_strain(&space, &b).0);
        let (ab, ba) = (product(&space, &a, &of_b), product(&space, &b, &of_a));
        let (aa, size) = (product(&space, &a, &of_a), product(&space, &a, &a));
        assert!((ab - ba).abs() < 1e-14 * size, "{ab} {ba}");
        assert!(aa < 0.0 && -aa < size, "{aa} {size}");
    }
}

/// The work of pressure and traction on a plastic strain is that of the displacement on them.
#[test]
fn displacements_are_reciprocal() {
    let space = track(10, 0.75, 1.06);
    let (strain, friction) = (noise(5, space.ground().field_len::<3>()), 0.37);
    let pressure: Vec<f64> =
        noise(6, space.ground().grid.window().len()).iter().map(|p| p.abs()).collect();
    let work = |friction: f64| {
        let elastic = space.ground().elastic;
        let stress = of_pressure(&space, &pressure, friction);
        product(&space, &stress, &strain) / (2.0 * elastic.shear())
    };
    let on = |u: &[f64]| u.iter().zip(&pressure).map(|(u, p)| u * p).sum::<f64>();
    let normal = on(&of_strain(&space, &strain).1);
    assert!((normal / work(0.0) - 1.0).abs() < 1e-11, "{normal} {}", work(0.0));
    let mut along = vec![0.0; pressure.len()];
    let strained = vec![1; space.ground().layers.len()];
    space
        .opening(
            Direction::Tangential,
            &strain,
            &strained,
            &mut space.work(),
            &mut along,
            &mut || false,
        )
        .unwrap();
    let both = normal + friction * on(&along);
    assert!((both / work(friction) - 1.0).abs() < 1e-10, "{both} {}", work(friction));
}

/// A strain that is uniform along the track leaves the stress of its local part.
#[test]
fn a_uniform_strain_has_its_residual_stress_and_an_even_surface() {
    let space = track(10, 0.75, 1.06);
    let (n, local) = (space.ground().grid.n_columns(), POISSON / (1.0 - POISSON));
    let (xx, zz) = (3.0, -5.0);
    let mut strain = vec![0.0; space.ground().field_len::<3>()];
    let layer = 4;
    strain[layer * 3 * n..][..n].fill(xx);
    strain[(layer * 3 + 1) * n..][..n].fill(zz);
    strain[(layer * 3 + 2) * n..][..n].fill(7.0);
    let (stress, opening) = of_strain(&space, &strain);
    let full = [local * zz - xx, local * zz + xx + zz];
    let mean = (full[0] + full[1]) / 3.0;
    for (k, value) in stress.iter().enumerate() {
        let expected = match (k / n / 3, k / n % 3) {
            (l, 0) if l == layer => full[0] - mean,
            (l, 1) if l == layer => -mean,
            _ => 0.0,
        };
        assert!((value - expected).abs() < 1e-12, "{k}: {value}");
    }
    // How deep the surface of a half-plane sinks has no meaning.
    assert!(opening.iter().all(|u| (u / opening[0] - 1.0).abs() < 1e-11), "{opening:?}");
}

/// What the discrete problem really shakes down at.
#[test]
fn limits_of_layers_are_a_little_above_the_exact_ones() {
    let space = track(20, 0.75, 1.06);
    for (friction, expected) in [(0.0, 4.012), (0.1, 3.573), (0.2, 3.210), (0.3, 2.906)] {
        let found = limits(&space, friction).perfect;
        let ratio = found.value / shear_strength();
        assert!((ratio / expected - 1.0).abs() < 1e-3, "{friction}: {found:?} {ratio}");
        let exact = DepthLimit::sliding(friction, 1e-3, |_| YIELD).peak_pressure;
        assert!(found.value > exact && found.value < 1.004 * exact, "{friction}");
        let driven = limits(&space, -friction).perfect.value;
        assert!((driven / found.value - 1.0).abs() < 1e-12, "{friction}");
    }
}

/// Backstress without a bound loses 1.5 % to a friction of 0.2, where perfect plasticity loses 20.
#[test]
fn kinematic_hardening_hardly_minds_friction() {
    let space = track(20, 0.25, 1.08);
    for (friction, expected) in
        [(0.0, 4.005), (0.1, 3.986), (0.2, 3.946), (0.3, 3.579), (0.4, 2.702)]
    {
        let found = limits(&space, friction).kinematic;
        let ratio = found.value / shear_strength();
        assert!((ratio / expected - 1.0).abs() < 4e-3, "{friction}: {found:?} {ratio}");
        assert_eq!(found.layer == 0, friction >= 0.3, "{friction}: {found:?}");
    }
}

/// A soft layer decides where it lies.
#[test]
fn limits_follow_strength_over_depth() {
    let space = track(20, 0.75, 1.06);
    let pressure = hertz(&space.ground().grid, 1.0);
    let strength = |layer: usize| if layer == 20 { 0.5 * YIELD } else { YIELD };
    let limits = TrackLimits::new(&space, &pressure, 0.0, strength, &mut || false).unwrap();
    assert_eq!((limits.perfect.layer, limits.kinematic.layer), (20, 20));
}
