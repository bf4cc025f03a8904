//! Bodies that yield, against figures of axisymmetric finite elements and of finer grids: errors and iteration counts.
#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a place on the grid is a small positive number"
)]

mod common;

use brinell_contact::{ContactLoad, never};
use common::{Built, Case, Figures, figures, force_of, solve};

fn near(found: f64, expected: f64, tolerance: f64, name: &str) {
    let error = found / expected - 1.0;
    println!("{name}: {found:.6e} for {expected:.6e}, {error:.2e}");
    assert!(error.abs() < tolerance, "{name}: {found} for {expected}");
}

/// Deformation theory in one increment.
fn deformation(case: &Case) -> (Built, Figures, usize) {
    let mut built = case.build();
    let load = ContactLoad::Force(built.force);
    let (_, evaluations, applications) = solve(&mut built.system, load, 1e-6);
    println!("{evaluations} evaluations, {applications} applications");
    let figures = figures(&built.system);
    (built, figures, evaluations)
}

/// Flow theory: loading in ten increments, unloading in one. Figures loaded, figures unloaded, evaluations of loading and unloading.
fn flow(case: &Case) -> (Built, Figures, Figures, [usize; 2]) {
    let mut built = case.build();
    let mut loading = 0;
    for k in 1..=10 {
        let load = ContactLoad::Force(force_of(case, &built, k, 10));
        let tolerance = if k < 10 { 1e-4 } else { 1e-5 };
        let (increment, evaluations, _) = solve(&mut built.system, load, tolerance);
        built.system.commit(&increment);
        loading += evaluations;
    }
    let loaded = figures(&built.system);
    let (increment, unloading, _) = solve(&mut built.system, ContactLoad::Force(0.0), 1e-5);
    built.system.commit(&increment);
    let unloaded = figures(&built.system);
    println!("{loading} + {unloading} evaluations\n{loaded:?}\n{unloaded:?}");
    (built, loaded, unloaded, [loading, unloading])
}

#[test]
fn a_ball_under_deformation_theory() {
    let (built, figures, evaluations) = deformation(&Case::ball(16, 4.0, 0.05, 1.17));
    near(figures.peak, 1259.5, 1e-2, "peak");
    near(figures.approach, 2.0555e-3, 1e-2, "approach");
    near(figures.approach - built.hertz.approach, 2.023e-4, 0.1, "plastic part of the approach");
    near(figures.strain, 5.12e-3, 0.1, "plastic strain");
    assert!((15..=22).contains(&evaluations), "{evaluations}");
}

#[test]
#[ignore = "full"]
fn a_ball_under_deformation_theory_on_a_finer_grid() {
    let (_, figures, evaluations) = deformation(&Case::ball(32, 4.0, 0.05, 1.17));
    near(figures.peak, 1259.5, 3e-3, "peak");
    near(figures.approach, 2.0555e-3, 2e-3, "approach");
    near(figures.strain, 5.12e-3, 2e-2, "plastic strain");
    assert!((15..=22).contains(&evaluations), "{evaluations}");
}

#[test]
#[ignore = "full"]
fn a_ball_under_flow_theory_and_unloaded() {
    let (mut built, loaded, unloaded, [loading, unloading]) = flow(&Case::ball(48, 4.0, 0.05, 1.17));
    near(loaded.smoothed_peak, 1140.5, 5e-3, "peak");
    near(loaded.approach, 2.0355e-3, 2e-3, "approach");
    near(loaded.strain, 4.79e-3, 1e-2, "plastic strain");
    near(unloaded.dent, 5.92e-4, 1.5e-2, "dent");
    near(unloaded.pile_up, 3.37e-5, 3e-2, "pile-up");
    assert!((90..=140).contains(&loading), "{loading}");
    assert_eq!(unloading, 1);

    // Residual stress at r = 0.0755 mm, where the pressure was largest.
    let none = built.system.zeros();
    let stress = built.system.stresses(0, &none);
    let grid = *built.system.grid();
    let layers = built.system.bodies()[0].space().layers().clone();
    let column = |i: usize, layer: usize| {
        let row = &stress.component(layer, 0)[i * grid.ny()..];
        0.5 * (row[grid.ny() / 2] + row[grid.ny() / 2 - 1])
    };
    let place = 0.0755 / grid.hx() + 0.5 * (grid.nx() - 1) as f64;
    let (i, weight) = (place.floor() as usize, place.fract());
    let (depth, least) = (0..layers.len())
        .map(|layer| {
            (layers.middle(layer), (1.0 - weight) * column(i, layer) + weight * column(i + 1, layer))
        })
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap();
    near(least, -215.0, 3e-2, "residual stress");
    near(depth, 0.097, 0.1, "its depth");
}

#[test]
#[ignore = "full"]
fn a_perfectly_plastic_ball() {
    let (_, loaded, unloaded, _) = flow(&Case::ball(48, 4.0, 0.0, 1.17));
    near(loaded.smoothed_peak, 1089.5, 5e-3, "peak");
    near(loaded.approach, 2.0549e-3, 2e-3, "approach");
    near(loaded.strain, 5.18e-3, 1e-2, "plastic strain");
    near(unloaded.dent, 6.47e-4, 1.5e-2, "dent");
}

#[test]
#[ignore = "full"]
fn balls_far_beyond_first_yield() {
    let (_, loaded, unloaded, _) = flow(&Case::ball(48, 6.0, 0.05, 1.33));
    near(loaded.smoothed_peak, 1318.0, 3e-2, "peak");
    near(loaded.approach, 5.055e-3, 3e-3, "approach");
    near(unloaded.dent, 2.266e-3, 1.5e-2, "dent");
    let (_, loaded, unloaded, _) = flow(&Case::ball(48, 6.0, 0.0, 1.33));
    near(loaded.smoothed_peak, 1212.0, 5e-2, "peak");
    near(loaded.approach, 5.191e-3, 3e-3, "approach");
    near(unloaded.dent, 2.522e-3, 1.5e-2, "dent");
    near(loaded.strain, 1.014e-2, 3e-2, "plastic strain");
}

#[test]
#[ignore = "full"]
fn ellipses_under_flow_theory() {
    let case =
        |radius_y| Case { n: 48, radius_y, ratio: 4.0, tangent: 0.05, widening: [1.2, 1.12], count: 1 };
    let (_, loaded, unloaded, _) = flow(&case(50.0));
    near(loaded.smoothed_peak, 1174.5, 5e-3, "peak");
    near(loaded.approach, 3.805e-3, 2e-3, "approach");
    near(unloaded.dent, 1.008e-3, 1.5e-2, "dent");
    let (_, loaded, unloaded, _) = flow(&case(200.0));
    near(loaded.smoothed_peak, 1218.4, 1e-2, "peak");
    near(loaded.approach, 5.264e-3, 1e-2, "approach");
    near(unloaded.dent, 1.177e-3, 1e-2, "dent");
}

#[test]
#[ignore = "full"]
fn an_ellipse_under_deformation_theory() {
    let case = Case { n: 32, radius_y: 50.0, ratio: 4.0, tangent: 0.05, widening: [1.2, 1.12], count: 1 };
    let (_, figures, evaluations) = deformation(&case);
    near(figures.peak, 1279.5, 3e-3, "peak");
    near(figures.approach, 3.8355e-3, 1e-3, "approach");
    near(figures.strain, 5.05e-3, 1e-2, "plastic strain");
    assert!((18..=28).contains(&evaluations), "{evaluations}");
}

#[test]
fn deformation_theory_is_one_increment_of_flow_theory() {
    // In deformation theory the strain lies along the stress it ends with: Δε = 3/2 p s/|s|.
    let case = Case::ball(16, 3.0, 0.05, 1.08);
    let mut built = case.build();
    let load = ContactLoad::Force(built.force);
    let (increment, _, _) = solve(&mut built.system, load, 1e-11);
    let once = figures(&built.system);
    let stress = built.system.stresses(0, &increment);
    let strains = built.system.bodies()[0].equivalent_plastic_strain();
    let (layers, cells) = (stress.n_layers(), stress.n_cells());
    let mut flowing = 0;
    for layer in 0..layers {
        for cell in 0..cells {
            let p = strains[layer * cells + cell];
            let at = |k: usize| stress.component(layer, k)[cell];
            let mean = (at(0) + at(1) + at(2)) / 3.0;
            let s = [at(0) - mean, at(1) - mean, at(3), at(4), at(5)];
            let zz = -s[0] - s[1];
            let square =
                s[0] * s[0] + s[1] * s[1] + zz * zz + 2.0 * (s[2] * s[2] + s[3] * s[3] + s[4] * s[4]);
            let size = (1.5 * square).sqrt();
            for (k, s) in s.into_iter().enumerate() {
                let expected = 1.5 * p * s / size;
                let found = increment[0].component(layer, k)[cell];
                assert!((found - expected).abs() < 1e-9 * once.strain, "{found} {expected}");
            }
            flowing += usize::from(p > 0.0);
        }
    }
    assert!(flowing > 50);

    // The load again: nothing flows but what the tolerance left, and nothing changes.
    built.system.commit(&increment);
    let none = built.system.zeros();
    let mut next = built.system.zeros();
    built.system.equilibrium(&none, load, &mut never).unwrap();
    built.system.initial_stress(&none, &mut next);
    assert!(built.system.norm(&next) < 1e-9 * built.system.norm(&increment));
    assert!((built.system.contact().approach / once.approach - 1.0).abs() < 1e-9);
}

#[test]
fn two_equal_bodies_are_one_that_counts_twice() {
    let one = Case { count: 2, ..Case::ball(16, 3.0, 0.05, 1.08) };
    let mut built = one.build();
    let load = ContactLoad::Force(built.force);
    let (increment, _, _) = solve(&mut built.system, load, 1e-8);
    let figures_two = figures(&built.system);
    assert!(built.system.norm(&increment) > 0.0);
    // Beside a rigid ball all lengths are half as large, at the same pressures.
    let single = Case::ball(16, 3.0, 0.05, 1.08);
    let mut rigid = single.build();
    let load = ContactLoad::Force(rigid.force);
    solve(&mut rigid.system, load, 1e-8);
    let figures_one = figures(&rigid.system);
    near(figures_two.peak, figures_one.peak, 1e-6, "peak");
    near(figures_two.strain, figures_one.strain, 1e-6, "plastic strain");
}
