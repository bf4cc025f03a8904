//! Limits of shakedown of a track, from its elastic stresses.
//!
//! Residual stress of a uniform track is `(σxx, σyy)(z)` alone. It cannot touch σxz, so that a
//! perfectly plastic layer shakes down only while `max |σxz| <= k`. A backstress without bound may
//! be any deviator: then a layer shakes down if and only if the path of `dev σ(x)` fits into a ball
//! of radius σ_y, in the norm of von Mises.
//!
//! # Reference
//! K. L. Johnson, *Contact Mechanics* (1985), section 9.2; A. R. S. Ponter, *A general shakedown
//! theorem for elastic/plastic bodies with work hardening*, Proc. 3rd Int. Conf. Struct. Mech.
//! Reactor Technol. (1975), for balls as elastic domains that move.

use super::figures::AtDepth;
use super::operators::{Ground, ISOMETRIC, Operators};
use crate::stop::{Stop, Stopped};
use brinell_material::smallest_ball;

/// Load factors of layers, the least of which is the limit of the track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackLimits {
    /// Factor of the pressure up to which perfect plasticity shakes down on these layers, and the
    /// layer that decides: `min k/max|σxz|`.
    ///
    /// Stresses of layers are means over them. The limit lies above that of a continuum, by 1.1,
    /// 0.3 and 0.08 % at 10, 20 and 40 columns a half-width.
    pub perfect: AtDepth,
    /// Factor of the pressure with kinematic hardening without bound: σ_y over the radius of the
    /// smallest ball.
    pub kinematic: AtDepth,
}

impl TrackLimits {
    /// Limits of a line under a pressure in the window \[MPa\], with a traction μ p, for a yield
    /// stress of each layer \[MPa\]. Operators of a line are those of three components.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn new(
        space: &impl Operators<4, 3>,
        pressure: &[f64],
        friction: f64,
        yield_stress: impl Fn(usize) -> f64,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let Ground { grid, layers, .. } = space.ground();
        let n = grid.n_columns();
        let mut stress = vec![0.0; space.ground().field_len::<3>()];
        space.stress(pressure, friction, &mut space.work(), &mut stress, stop)?;
        let none = AtDepth { value: f64::INFINITY, ..AtDepth::default() };
        let mut limits = Self { perfect: none, kinematic: none };
        for (layer, rows) in stress.chunks_exact(3 * n).enumerate() {
            let strength = yield_stress(layer);
            let (xx, rest) = rows.split_at(n);
            let (zz, xz) = rest.split_at(n);
            let shear = xz.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            let path = xx.iter().zip(zz).zip(xz).map(|((xx, zz), xz)| {
                let values = [xx + zz, xx - zz, *xz];
                std::array::from_fn(|k| 1.5f64.sqrt() * ISOMETRIC[k] * values[k])
            });
            let radius = smallest_ball::<3>(&path.collect::<Vec<_>>()).radius;
            for (limit, value) in [
                (&mut limits.perfect, strength / (3f64.sqrt() * shear)),
                (&mut limits.kinematic, strength / radius),
            ] {
                if value < limit.value {
                    let depth = layers.middle(layer);
                    *limit = AtDepth { value, depth, layer, ..AtDepth::default() };
                }
            }
        }
        Ok(limits)
    }
}
