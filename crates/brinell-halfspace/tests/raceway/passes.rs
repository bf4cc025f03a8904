//! Passes by the figures of another program, and by what must hold of any.
//!
//! Reference figures are those of a prototype in Python with its own transforms, contact solver,
//! return map and accelerator, at the same resolution: they say that both solve the same equations.

use super::driver::{Pass, Roller, Setup, TWENTIETH};

fn close(name: &str, found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found / expected - 1.0).abs() <= tolerance,
        "{name}: {found:.4e} instead of {expected:.4e}"
    );
}

/// Missing work over the plastic work of the first pass.
fn energy_gaps(passes: &[Pass]) -> impl Iterator<Item = f64> {
    let first = passes[0].outlet.plastic_work;
    passes.iter().map(move |pass| {
        let done = pass.outlet.plastic_work + pass.outlet.stored_energy;
        (pass.rolling_force + pass.work_of_traction - done).abs() / first
    })
}

fn roll(setup: &Setup, passes: usize) -> Vec<Pass> {
    let passes = Roller::new(setup).passes(passes);
    for pass in &passes {
        println!("{}", pass.line());
        assert!(pass.converged);
    }
    // Force, work of the traction, plastic work and stored energy are found apart.
    for gap in energy_gaps(&passes) {
        println!("gap {gap:.4}");
        assert!(gap < 0.02, "energy {gap}");
    }
    passes
}

/// Groove by the ring and by line loads in µm, dp, net, σx, σy. The prototype let its join flow
/// (0.15 % of all flow): its σx are -350.4, -347.2 and -346.3.
#[test]
fn a_ball_rolls_a_groove() {
    let passes = roll(&Setup::ball(7, 3.5, TWENTIETH), 3);
    let references = [
        (0.4012, 8.48e-3, 5.72e-3, -351.8, -266.6, 0.0830, 1284.2),
        (0.4160, 2.02e-3, 1.94e-3, -348.6, -257.7, 0.0082, f64::NAN),
        (0.4207, 2.13e-4, 2.13e-4, -347.7, -256.0, 0.0016, f64::NAN),
    ];
    for (pass, (groove, dp, net, along, across, work, peak)) in passes.iter().zip(references) {
        close("groove", 1e3 * pass.ring_groove, groove, 2e-3);
        close("dp", pass.strain.largest.value, dp, 1e-2);
        close("net", pass.strain.net.value, net, 1e-2);
        close("σx", pass.least_residual()[0], along, 2e-3);
        close("σy", pass.least_residual()[1], across, 2e-3);
        close("work", pass.outlet.plastic_work, work, 0.03);
        if peak.is_finite() {
            close("peak", pass.peak, peak, 2e-3);
        }
    }
    close("approach", passes[0].approach, 1.528e-3, 1e-3);
    close("groove of an endless track", passes[0].outlet.groove_depth, 3.946e-4, 1e-3);
    close("pile-up", passes[0].outlet.pile_up, 9.961e-5, 2e-3);
    let evaluations: usize = passes.iter().map(|pass| pass.evaluations).sum();
    assert!(evaluations <= 75, "{evaluations}");
}

/// Grooves of the ball that hardens are the prototype's. It let its join flow, which spoils the
/// others: they are this program's, and what holds them is the balance of energy, which closed
/// within 7 % there, and [`super::march`].
#[test]
#[ignore = "full"]
fn finer_tracks_and_other_materials_agree() {
    let groove = |passes: &[Pass], references: &[f64], tolerance: f64| {
        for (pass, reference) in passes.iter().zip(references) {
            close("groove", 1e3 * pass.ring_groove, *reference, tolerance);
        }
    };
    let passes = roll(&Setup::ball(10, 3.5, TWENTIETH), 3);
    groove(&passes, &[0.4069, 0.4194, 0.4239], 3e-3);
    let passes = roll(&Setup::ball(14, 3.5, TWENTIETH), 3);
    groove(&passes, &[0.4068, 0.4206, 0.4250], 3e-3);
    close("σx", passes[2].least_residual()[0], -348.9, 3e-3);
    close("σy", passes[2].least_residual()[1], -254.0, 3e-3);

    let passes = roll(&Setup::ball(10, 3.5, 0.0), 6);
    groove(&passes[1..], &[0.4973, 0.5051, 0.5071, 0.5078, 0.5081], 0.003);

    let armstrong = Setup { terms: vec![[40_000.0, 200.0]], ..Setup::ball(7, 3.5, 0.0) };
    groove(&roll(&armstrong, 6), &[0.3737, 0.3936, 0.4013, 0.4050, 0.4078, 0.4100], 0.003);
    let sliding = Setup { friction: 0.2, ..armstrong };
    groove(&roll(&sliding, 6), &[0.3752, 0.4096, 0.4224, 0.4272, 0.4310, 0.4338], 0.003);

    let ellipse = Setup { radii: [10.0, 50.0], ..Setup::ball(10, 3.5, TWENTIETH) };
    let passes = roll(&ellipse, 3);
    groove(&passes, &[0.5691, 0.5824, 0.5855], 0.003);
    close("σx", passes[2].least_residual()[0], -374.5, 3e-3);
    close("σy", passes[2].least_residual()[1], -270.3, 3e-3);
}

#[test]
fn friction_shears_the_track() {
    let passes = roll(&Setup { friction: 0.2, ..Setup::ball(7, 3.0, TWENTIETH) }, 4);
    let references = [(0.2111, 6.49e-3), (0.2321, 3.2e-3), (0.2397, 6.0e-4), (0.2424, f64::NAN)];
    for (pass, (groove, dp)) in passes.iter().zip(references) {
        close("groove", 1e3 * pass.ring_groove, groove, 3e-3);
        if dp.is_finite() {
            close("dp", pass.strain.largest.value, dp, 0.02);
        }
    }
    close("σx", passes[0].least_residual()[0], -204.0, 0.01);
    close("σy", passes[0].least_residual()[1], -177.0, 0.01);
    assert!(passes[0].outlet.forward > 0.0);
}

/// Below 4.68 k a perfectly plastic ball shakes down, and the groove makes the contact conformal.
#[test]
#[ignore = "full"]
fn a_ball_shakes_down() {
    let k = super::driver::YIELD / 3f64.sqrt();
    for (factor, groove, peak, work) in [
        (0.92, 0.0978, 3.63, 8.64e-3),
        (0.97, 0.1328, 3.72, 1.327e-2),
        (1.05, 0.2035, 3.91, 2.452e-2),
    ] {
        let ratio = factor * 4.68 / 3f64.sqrt();
        let passes = roll(&Setup::ball(10, ratio, 0.0), 10);
        let last = passes.last().unwrap();
        println!("{factor}: {}", last.peak / k);
        close("groove", 1e3 * last.ring_groove, groove, 0.02);
        close("peak", last.peak / k, peak, 0.02);
        close("work", passes[0].outlet.plastic_work, work, 0.03);
        assert!(last.strain.largest.value < 1e-5, "{}", last.strain.largest.value);
    }
}

/// Plastic strain of an evaluation does not stay in rows that flow no more in the next one.
#[test]
fn rows_that_flow_no_more_carry_nothing() {
    let [mut fresh, mut used] = [(); 2].map(|()| Roller::new(&Setup::ball(6, 2.5, TWENTIETH)));
    // A strain xx of the first layer, on the axis, and in the row beside it as well.
    let (row, column) = (fresh.grid.n_columns(), fresh.grid.window().start);
    let mut near = vec![0.0; fresh.body.n_numbers()];
    near[column] = 50.0;
    let mut wide = near.clone();
    wide[row + column] = 50.0;
    let trial = |roller: &mut Roller, increment: &[f64]| {
        let (mut gap, mut trial) = (roller.gap.clone(), vec![0.0; increment.len()]);
        roller.body.open(increment, &mut gap, &mut || false).unwrap();
        roller.body.trial(&roller.pressure, &mut trial, &mut || false).unwrap();
        trial
    };
    assert_ne!(trial(&mut used, &wide), trial(&mut fresh, &near));
    assert_eq!(trial(&mut used, &near), trial(&mut fresh, &near));
}

/// A virgin track does not know its direction, a mirrored one does.
#[test]
fn a_track_may_be_turned_round() {
    let setup = Setup { friction: 0.2, tolerance: 1e-4, ..Setup::ball(5, 3.0, TWENTIETH) };
    let mut there = Roller::new(&setup);
    let first = there.pass();
    let mut back = Roller::new(&setup);
    back.turn();
    let mirrored = back.pass();
    assert_eq!(first.outlet, mirrored.outlet);
    // What the traction has moved forward, a pass back takes back in part.
    there.turn();
    let second = there.pass();
    back.turn();
    back.turn();
    let same = back.pass();
    assert!(second.strain.largest.value > 1.1 * same.strain.largest.value);
    close("groove of both", second.outlet.groove_depth, same.outlet.groove_depth, 0.1);
}

/// All lengths twice as large: strains and stresses stay, lengths double, works are four times as
/// large.
#[test]
fn figures_scale_with_the_size() {
    let setup = Setup { tolerance: 1e-6, ..Setup::ball(5, 3.5, TWENTIETH) };
    let [one, two] = [1.0, 2.0].map(|scale| Roller::new(&Setup { scale, ..setup.clone() }).pass());
    close("strain", two.strain.largest.value, one.strain.largest.value, 1e-4);
    close("groove", two.outlet.groove_depth, 2.0 * one.outlet.groove_depth, 1e-4);
    close("stress", two.least_residual()[0], one.least_residual()[0], 1e-4);
    close("work", two.outlet.plastic_work, 4.0 * one.outlet.plastic_work, 1e-4);
    close("stored", two.outlet.stored_energy, 4.0 * one.outlet.stored_energy, 1e-3);
}

/// Two equal balls meet in a plane: each has the groove of one under a rigid body of half the
/// curvature.
#[test]
fn two_equal_bodies_share_one() {
    let one = Setup { radii: [20.0, 20.0], tolerance: 1e-6, ..Setup::ball(5, 3.5, TWENTIETH) };
    let both = Setup { radii: [10.0, 10.0], count: 2, ..one.clone() };
    close("force", both.force(), one.force(), 1e-12);
    let (one, both) = (Roller::new(&one).pass(), Roller::new(&both).pass());
    close("groove", both.outlet.groove_depth, one.outlet.groove_depth, 1e-4);
    close("approach", both.approach, 2.0 * one.approach, 1e-4);
    close("peak", both.peak, one.peak, 1e-4);
}

/// A longer ring moves the groove by less than a per cent, and no cell flows beyond the track.
#[test]
fn a_longer_ring_changes_little() {
    let setup = Setup::ball(5, 3.5, TWENTIETH);
    let one = Roller::new(&setup).pass();
    let mut roller = Roller::new(&Setup { length: 24.0, ..setup });
    let two = roller.pass();
    close("groove", two.outlet.groove_depth, one.outlet.groove_depth, 0.01);
    close("σx", two.least_residual()[0], one.least_residual()[0], 0.02);
    assert!(roller.body.holds().is_ok());
}
