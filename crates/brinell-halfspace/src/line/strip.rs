//! Stress of a pressure and of a traction on a strip of a half-plane, in plane strain.
//!
//! With the strip `|x| < h/2`, `a = x + h/2`, `b = x - h/2`, `r_a = a² + z²`, `r_b = b² + z²`, `t =
//! atan(a/z) - atan(b/z)` and `f = az/r_a - bz/r_b`,
//! ```text
//! pressure 1          σxx = -(t-f)/π   σzz = -(t+f)/π   σxz = (z²/r_a - z²/r_b)/π
//! traction 1 in +x    σxx = -[ln(r_a/r_b) + z²/r_a - z²/r_b]/π
//!                     σzz = (z²/r_a - z²/r_b)/π        σxz = -(t-f)/π
//! ```
//! and `σyy = ν(σxx+σzz)`.
//!
//! # Reference
//! K. L. Johnson, *Contact Mechanics* (1985), section 2.5.

use std::f64::consts::PI;

/// Quadrature over the thickness of a layer, by two Gauss points, between 0 and 1.
const GAUSS: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// `σxx σzz σxz` of unit pressure and of unit traction in +x, at a place.
pub(crate) fn at(x: f64, z: f64, h: f64) -> [[f64; 3]; 2] {
    let (a, b) = (x + 0.5 * h, x - 0.5 * h);
    let (ra, rb) = (a * a + z * z, b * b + z * z);
    let t = a.atan2(z) - b.atan2(z);
    let f = a * z / ra - b * z / rb;
    let shear = (z * z / ra - z * z / rb) / PI;
    let along = -(t - f) / PI;
    [[along, -(t + f) / PI, shear], [-(ra / rb).ln() / PI - shear, shear, along]]
}

/// Returns `σxx σzz σxz` of unit pressure and of unit traction in +x, averaged over a layer between
/// two depths.
pub(crate) fn average(x: f64, [top, bottom]: [f64; 2], h: f64) -> [[f64; 3]; 2] {
    let [upper, lower] = GAUSS.map(|g| at(x, top + g * (bottom - top), h));
    std::array::from_fn(|n| std::array::from_fn(|k| 0.5 * (upper[n][k] + lower[n][k])))
}
