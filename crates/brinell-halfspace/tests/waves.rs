//! Elastic contacts of wavy and rough surfaces: closed forms, and another program.
//!
//! Closed forms are of waves without end, and the grid ends. On it the surface is hollowed by
//! what an even pressure presses the bodies in, `A p̄`: waves then bear alike, and the middle one
//! does not know of the end. What is left of it falls with the square of the number of waves.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

use std::f64::consts::{PI, SQRT_2, TAU};

use brinell_contact::{
    ConjugateGradientSolver, ContactLoad, ContactProblem, ContactSolution, ContactSolver,
    ContactStatus, Flexibility as _, never,
};
use brinell_halfspace::{SurfaceFlexibility, SurfaceGrid};

const MODULUS: f64 = 210_000.0 / 0.91;
/// Of a wave of length 1, from its mean to its crest.
const AMPLITUDE: f64 = 1e-3;

fn solve(
    surface: &SurfaceFlexibility,
    gap: &[f64],
    force: f64,
    tolerance: f64,
) -> ContactSolution {
    let (flexibility, closing) = (surface, vec![1.0; gap.len()]);
    let (initial_gap, load) = (gap, ContactLoad::Force(force));
    let problem = ContactProblem { flexibility, initial_gap, closing: &closing, load };
    let solver = ConjugateGradientSolver::new(tolerance);
    let solution = solver.solve(&problem, None, &mut never).unwrap();
    assert_eq!(solution.status, ContactStatus::Converged);
    solution
}

/// Pressures of waves on a grid under a mean pressure.
fn pressures(grid: SurfaceGrid, mean: f64, height: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let surface = SurfaceFlexibility::new(grid, MODULUS);
    let mut even = vec![0.0; grid.n_cells()];
    surface.apply(&vec![mean * grid.cell_area(); grid.n_cells()], &mut even);
    let gap: Vec<f64> =
        grid.sample(|x, y| -height(x, y)).iter().zip(&even).map(|(gap, u)| gap - u).collect();
    let force = mean * grid.cell_area() * grid.n_cells() as f64;
    let solution = solve(&surface, &gap, force, 1e-8);
    solution.force.iter().map(|force| force / grid.cell_area()).collect()
}

/// `p = E*/2 |q| u` of a wave on a periodic surface, whatever the number of cells along a side.
#[test]
fn the_preconditioner_is_the_inverse_of_a_periodic_surface() {
    for [nx, ny] in [[8, 8], [9, 8], [8, 9], [15, 7]] {
        let grid = SurfaceGrid::new(nx, ny, 0.1, 0.2).unwrap();
        let surface = SurfaceFlexibility::new(grid, MODULUS);
        for (i, j) in (0..=nx / 2).flat_map(|i| (0..=ny / 2).map(move |j| (i, j))).skip(1) {
            let q = [TAU * i as f64 / (nx as f64 * 0.1), TAU * j as f64 / (ny as f64 * 0.2)];
            let displacement = grid.sample(|x, y| (q[0] * x + q[1] * y).cos());
            let mut force = vec![0.0; grid.n_cells()];
            surface.precondition(&displacement, &mut force);
            let stiffness = 0.5 * MODULUS * q[0].hypot(q[1]) * grid.cell_area();
            for (force, u) in force.iter().zip(&displacement) {
                assert!((force / stiffness - u).abs() < 1e-12, "{nx} × {ny}, wave {i}, {j}");
            }
        }
    }
}

/// A flat punch as large as the grid: sides of odd numbers of cells take no more than even ones.
#[test]
fn a_contact_of_all_cells_takes_few_steps() {
    for [nx, ny] in [[16, 16], [17, 16], [16, 17], [9, 33]] {
        let grid = SurfaceGrid::new(nx, ny, 0.1, 0.1).unwrap();
        let surface = SurfaceFlexibility::new(grid, MODULUS);
        let solution = solve(&surface, &vec![0.0; grid.n_cells()], 1e3, 1e-8);
        let ContactSolution { pivots, applications, .. } = solution;
        assert!(pivots <= 3 && applications <= 30, "{nx} × {ny}: {pivots}, {applications}");
    }
}

/// `p = 2p̄ cos(πx)/s² √(s² - sin²(πx))` with `s = sin(πa)`, `p̄ = s² πE*Δ` in wave lengths.
///
/// 15 waves leave 0.1 % of the mean pressure. The slope of the pressure has no bound at the edge,
/// where the outermost cells err with the first power of their size.
///
/// # Reference
/// H. M. Westergaard, *Bearing pressures and cracks*, J. Appl. Mech. 6 (1939) A49–A53; K. L.
/// Johnson, *Contact Mechanics* (1985), section 13.2.
#[test]
fn a_wave_in_one_direction_agrees_with_westergaard() {
    const WAVES: usize = 15;
    let full = PI * MODULUS * AMPLITUDE;
    // Half-widths on faces of cells: a quarter and three eighths of a wave.
    for half_width in [0.25, 0.375] {
        for cells in [32, 64] {
            let bound = (PI * half_width).sin().powi(2);
            let mean = full * bound;
            let side = 1.0 / cells as f64;
            let grid = SurfaceGrid::new(WAVES * cells, 4 * WAVES, side, 0.25).unwrap();
            let found = pressures(grid, mean, |x, _| AMPLITUDE * (TAU * x).cos());
            let of_wave: Vec<(f64, f64)> = (0..grid.nx())
                .map(|i| (grid.x(i), found[i * grid.ny() + 2 * WAVES]))
                .filter(|(x, _)| x.abs() < 0.5)
                .collect();
            let load = side * of_wave.iter().map(|(_, p)| p).sum::<f64>();
            assert!((load / mean - 1.0).abs() < 1.2e-3, "{load} and not {mean}");
            for (x, found) in of_wave {
                let sine = (PI * x).sin().powi(2);
                let expected =
                    2.0 * mean * (PI * x).cos() / bound * (bound - sine).max(0.0).sqrt();
                assert_eq!(found > 0.0, expected > 0.0, "contact at {x}");
                let is_outermost = half_width - x.abs() < side;
                let most = if is_outermost { 1.2 * side } else { 4e-3 };
                assert!((found - expected).abs() < most * full, "{x}: {found} and not {expected}");
            }
        }
    }
}

/// `z = Δ cos(2πx) cos(2πy)`: full contact has `p = p̄ + p* cos cos` with `p* = √2 πE*Δ`; little
/// contact is Hertz's of each crest, and just below full contact `1 - A = 3/(2π) (1 - p̄/p*)`.
///
/// # Reference
/// K. L. Johnson, J. A. Greenwood, J. G. Higginson, *The contact of elastic regular wavy
/// surfaces*, Int. J. Mech. Sci. 27 (1985) 383–396.
#[test]
fn waves_in_two_directions_agree_with_their_limits() {
    const WAVES: usize = 5;
    const CELLS: usize = 48;
    let side = 1.0 / CELLS as f64;
    let grid = SurfaceGrid::new(WAVES * CELLS, WAVES * CELLS, side, side).unwrap();
    let wave = |x: f64, y: f64| (TAU * x).cos() * (TAU * y).cos();
    let full = SQRT_2 * PI * MODULUS * AMPLITUDE;
    let middle = |mean: f64| {
        let found = pressures(grid, mean, |x, y| AMPLITUDE * wave(x, y));
        let is_there = |i: &usize| grid.x(*i).abs() < 0.5;
        let cells: Vec<_> = (0..grid.nx())
            .filter(is_there)
            .flat_map(|i| (0..grid.ny()).map(move |j| (i, j)))
            .filter(|(_, j)| grid.y(*j).abs() < 0.5)
            .map(|(i, j)| (wave(grid.x(i), grid.y(j)), found[i * grid.ny() + j]))
            .collect();
        assert_eq!(cells.len(), CELLS * CELLS);
        cells
    };
    let touching = middle(1.5 * full);
    for (wave, found) in touching {
        assert!((found - full * (1.5 + wave)).abs() < 3e-3 * full, "{wave}: {found}");
    }
    let apart = middle(0.95 * full).iter().filter(|(_, p)| *p == 0.0).count() as f64;
    let expected = 1.5 / PI * 0.05;
    let found = apart / (CELLS * CELLS) as f64;
    // Two spots of some 30 cells each.
    assert!((found - expected).abs() < 0.2 * expected, "{found} and not {expected}");
    // Of each crest: P = p̄/2, R = 1/(4π²Δ).
    let mean = 0.01 * full;
    let radius = 1.0 / (4.0 * PI * PI * AMPLITUDE);
    let hertz = (6.0 * 0.5 * mean * MODULUS * MODULUS / (PI.powi(3) * radius * radius)).cbrt();
    let peak = middle(mean).iter().map(|(_, p)| *p).fold(0.0, f64::max);
    // 3.6 cells over the radius.
    assert!((peak / hertz - 1.0).abs() < 0.05, "{peak} and not {hertz}");
}

/// Waves of 1 to 8 over a side of 1, E* = 1, 128 × 128 cells. Cells in contact, largest pressure
/// and approach from the highest point are those of ContactMechanics 1.8.3 (PyPI, L. Pastewka and
/// others), `FreeFFTElasticHalfSpace`: `tools/rough_patch.py waves`.
#[test]
fn a_rough_patch_agrees_with_contact_mechanics() {
    let mut state = 7_u64;
    let mut waves = Vec::new();
    for kx in -8..=8_i32 {
        for ky in 0..=8_i32 {
            let size = f64::from(kx * kx + ky * ky).sqrt();
            if (1.0..=8.0).contains(&size) && (ky > 0 || kx > 0) {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                let phase = TAU * (state >> 33) as f64 / f64::from(1_u32 << 31);
                waves.push([f64::from(kx), f64::from(ky), 1e-3 * size.powf(-1.8), phase]);
            }
        }
    }
    let height = |x: f64, y: f64| {
        let of_wave =
            |[kx, ky, size, phase]: &[f64; 4]| size * (TAU * (kx * x + ky * y) + phase).cos();
        waves.iter().map(of_wave).sum::<f64>()
    };
    let grid = SurfaceGrid::new(128, 128, 1.0 / 128.0, 1.0 / 128.0).unwrap();
    let heights = grid.sample(height);
    let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let gap: Vec<f64> = heights.iter().map(|height| highest - height).collect();
    let surface = SurfaceFlexibility::new(grid, 1.0);
    for (force, cells, peak, approach) in
        [(2e-4, 411, 0.016_193_25, 1.772_828_48e-3), (1e-3, 2_027, 0.034_370_24, 3.689_427_76e-3)]
    {
        let found = solve(&surface, &gap, force, 1e-8);
        let largest = found.force.iter().copied().fold(0.0, f64::max) / grid.cell_area();
        assert_eq!(found.active_set.len(), cells);
        assert!((largest / peak - 1.0).abs() < 1e-6, "{largest} and not {peak}");
        assert!((found.approach / approach - 1.0).abs() < 1e-7, "{} ", found.approach);
    }
}
