//! A perfectly plastic ball and a rigid flat beside fits of others to their finite elements.

use std::f64::consts::PI;

use super::*;

/// E/(1 - ν²) \[MPa\].
const EFFECTIVE: f64 = 210_000.0 / 0.91;

/// L. Kogut, I. Etsion, J. Appl. Mech. 69 (2002) 657–662: force \[N\] at an approach \[mm\].
fn kogut_etsion(approach: f64) -> f64 {
    let (factor, hardness) = (0.454 + 0.41 * 0.3, 2.8 * YIELD_STRESS);
    let critical = (PI * factor * hardness / (2.0 * EFFECTIVE)).powi(2) * RADIUS;
    let w = approach / critical;
    let fit = if w <= 6.0 { 1.03 * w.powf(1.425) } else { 1.40 * w.powf(1.263) };
    2.0 / 3.0 * factor * hardness * PI * critical * RADIUS * fit
}

/// The same for the area \[mm²\].
fn kogut_etsion_area(approach: f64) -> f64 {
    let (factor, hardness) = (0.454 + 0.41 * 0.3, 2.8 * YIELD_STRESS);
    let critical = (PI * factor * hardness / (2.0 * EFFECTIVE)).powi(2) * RADIUS;
    let w = approach / critical;
    PI * critical * RADIUS * if w <= 6.0 { 0.93 * w.powf(1.136) } else { 0.94 * w.powf(1.146) }
}

/// R. L. Jackson, I. Green, J. Tribol. 127 (2005) 343–354: force \[N\] at an approach \[mm\],
/// beyond 1.9 of that at which the ball begins to yield.
fn jackson_green(approach: f64) -> f64 {
    let factor = 1.295 * (0.736_f64 * 0.3).exp();
    let strain = YIELD_STRESS / EFFECTIVE;
    let critical = (PI * factor * strain / 2.0).powi(2) * RADIUS;
    let critical_force =
        4.0 / 3.0 * (RADIUS / EFFECTIVE).powi(2) * (factor * PI * YIELD_STRESS / 2.0).powi(3);
    let w = approach / critical;
    assert!(w > 1.9, "{w}");
    let radius =
        PI * factor * strain / 2.0 * w.sqrt() * (w / 1.9).powf(0.07 * (23.0 * strain).exp());
    let hardness = 2.84 * (1.0 - (-0.82 * radius.powf(-0.7)).exp());
    let elastic = (-0.25 * w.powf(5.0 / 12.0)).exp() * w.powf(1.5);
    let plastic = 4.0 * hardness / factor * (1.0 - (-w.powf(5.0 / 9.0) / 25.0).exp()) * w;
    critical_force * (elastic + plastic)
}

#[test]
#[ignore = "full"]
fn a_perfectly_plastic_ball_agrees_with_the_fits_of_others() {
    for ratio in [2.5, 3.0, 4.0, 5.0, 6.0] {
        let [loaded, _] = loaded_and_unloaded(on_flat(RADIUS, steel(Some(0.0)), 15), ratio);
        let approach = loaded.figures.approach;
        near(loaded.figures.force, jackson_green(approach), 5e-2, "force of Jackson and Green");
        near(loaded.figures.force, kogut_etsion(approach), 5e-2, "force of Kogut and Etsion");
        let area = loaded.figures.contact_area.unwrap();
        near(area, kogut_etsion_area(approach), 0.15, "area of theirs");
    }
}
