//! Stress below tractions along x, the operator S_t.
//!
//! With the potentials of [`pressure_stress`](crate::pressure_stress), a traction of 1 in +x on a
//! cell makes
//! ```text
//! σxx = (1/2π) [2(1+ν) V_x + 2ν Ω_xxx - z F_xxx]    σxy = (1/2π) [V_y + 2ν Ω_xxy - z F_xxy]
//! σyy = (1/2π) [2ν V_x + 2ν Ω_xyy - z F_xyy]        σxz = (1/2π) [V_z - z V_xx]
//! σzz = -(z/2π) V_xz                                σyz = -(z/2π) V_xy
//! ```
//! The derivatives are sums over the corners of the cell with the sign of their product:
//! ```text
//! V_x   = ln(Y+ρ)        F_xyy = Y/(ρ(ρ+z))         Ω_xyy = -Y/(ρ+z)
//! V_y   = ln(X+ρ)        F_xxy = X/(ρ(ρ+z))         Ω_xxy = -X/(ρ+z)
//! V_xz  = z/(ρ(Y+ρ))     F_xxx = -F_xyy - V_xz      Ω_xxx = -Ω_xyy - V_x
//! ```
//! Each component has the other parity in x than under pressure. Its spectrum, multiplied by i,
//! is therefore real in the planes in which those of pressure are ([`waves`](crate::waves)): a
//! traction is a pressure whose spectrum has been multiplied by -i.
//!
//! # Reference
//! K. L. Johnson, *Contact Mechanics* (1985), section 3.6, for Cerruti's potentials; the sums are
//! an own derivation.

use crate::pressure_stress::{PressureStress, sum_with};
use crate::stop::{Stop, Stopped};
use crate::tensors::COMPONENTS;
use crate::transform::Transform;
use crate::waves::Parity;
use crate::{Layers, SurfaceGrid};

const PARITIES: [Parity; COMPONENTS] =
    [Parity::OddInX, Parity::OddInX, Parity::OddInX, Parity::OddInY, Parity::Even, Parity::Odd];
/// i times the spectrum, which is i times what is kept of the first four, in the planes.
const SIGNS: [f64; COMPONENTS] = [-1.0, -1.0, -1.0, -1.0, 1.0, 1.0];

/// Spectra of the stresses of a cell under unit traction in +x, multiplied by i.
pub(crate) fn traction_stress(
    transform: &Transform,
    of: (&SurfaceGrid, &Layers),
    poisson: f64,
    stop: &mut Stop<'_>,
) -> Result<PressureStress, Stopped> {
    let of_corner = |x: f64, y: f64, z: f64| corner(x, y, z, poisson);
    let mut stress = PressureStress::of_kernels(transform, of, PARITIES, of_corner, stop)?;
    stress.scale(SIGNS);
    Ok(stress)
}

/// 2π times the stresses of one corner of a cell under unit traction in +x.
pub(crate) fn corner(x: f64, y: f64, z: f64, poisson: f64) -> [f64; COMPONENTS] {
    let rho = (x * x + y * y + z * z).sqrt();
    let (rho_y, rho_x) = (sum_with(rho, y, x * x + z * z), sum_with(rho, x, y * y + z * z));
    let (v_x, v_y, v_z) = (rho_y.ln(), rho_x.ln(), -(x * y).atan2(z * rho));
    let (v_xx, v_xz) = (x / (rho * rho_y), z / (rho * rho_y));
    let (f_xyy, f_xxy) = (y / (rho * (rho + z)), x / (rho * (rho + z)));
    let (o_xyy, o_xxy) = (-y / (rho + z), -x / (rho + z));
    let (f_xxx, o_xxx) = (-f_xyy - v_xz, -o_xyy - v_x);
    let twice = 2.0 * poisson;
    [
        (2.0 + twice) * v_x + twice * o_xxx - z * f_xxx,
        twice * v_x + twice * o_xyy - z * f_xyy,
        -z * v_xz,
        v_y + twice * o_xxy - z * f_xxy,
        v_z - z * v_xx,
        -z / rho,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Stresses of one cell at a point.
    fn of_cell(x: f64, y: f64, z: f64) -> [f64; COMPONENTS] {
        let (hx, hy, nu) = (1.0, 0.7, 0.3);
        let mut sum = [0.0; COMPONENTS];
        for (sx, sy) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let values = corner(x + 0.5 * sx * hx, y + 0.5 * sy * hy, z, nu);
            for (sum, value) in sum.iter_mut().zip(values) {
                *sum += sx * sy * value / (2.0 * std::f64::consts::PI);
            }
        }
        sum
    }

    #[test]
    fn the_stress_of_a_cell_is_in_equilibrium() {
        let ([x, y, z], d) = ([0.37, -0.21, 0.45], 1e-4);
        let along = |of: &dyn Fn(f64) -> [f64; COMPONENTS]| {
            let (after, before) = (of(d), of(-d));
            std::array::from_fn::<f64, COMPONENTS, _>(|k| (after[k] - before[k]) / (2.0 * d))
        };
        let dx = along(&|d| of_cell(x + d, y, z));
        let dy = along(&|d| of_cell(x, y + d, z));
        let dz = along(&|d| of_cell(x, y, z + d));
        for divergence in [dx[0] + dy[3] + dz[4], dx[3] + dy[1] + dz[5], dx[4] + dy[5] + dz[2]] {
            assert!(divergence.abs() < 1e-7, "{divergence}");
        }
        // At the surface, σxz = -1 below the traction and 0 beside it.
        assert!((of_cell(0.2, 0.1, 1e-9)[4] + 1.0).abs() < 1e-6);
        assert!(of_cell(0.8, 0.1, 1e-9)[4].abs() < 1e-6);
    }
}
