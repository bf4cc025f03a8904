//! The bilinear map from the reference square `[-1, 1]²` to a quadrilateral, and back.
//!
//! `x(ξ, η) = Σ N_i x_i` with `N_i = ¼ (1 + ξ_i ξ)(1 + η_i η)`, corners anticlockwise from `(-1,
//! -1)`.

use nalgebra::{Matrix2, Vector2};

/// Natural coordinates `[ξ_i, η_i]` of the corners.
pub const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Shape functions at `[ξ, η]`.
pub fn shape_functions([xi, eta]: [f64; 2]) -> [f64; 4] {
    CORNERS.map(|[a, b]| 0.25 * (1.0 + a * xi) * (1.0 + b * eta))
}

/// `[ξ, η]` of a point in, or near, a quadrilateral; coordinates beyond ±2 are cut off there.
///
/// Newton's method, which is exact after one step on a parallelogram and takes a few on a convex
/// quadrilateral.
pub fn natural_coordinates(corners: &[[f64; 2]; 4], point: [f64; 2]) -> [f64; 2] {
    // x(ξ, η) = m + p ξ + q η + r ξη.
    let combine = |signs: [f64; 4]| -> Vector2<f64> {
        signs.iter().zip(corners).map(|(sign, corner)| 0.25 * sign * Vector2::from(*corner)).sum()
    };
    let m = combine([1.0, 1.0, 1.0, 1.0]);
    let p = combine([-1.0, 1.0, 1.0, -1.0]);
    let q = combine([-1.0, -1.0, 1.0, 1.0]);
    let r = combine([1.0, -1.0, 1.0, -1.0]);
    let point = Vector2::from(point);
    let [mut xi, mut eta] = [0.0_f64; 2];
    for _ in 0..20 {
        let residual = point - (m + p * xi + q * eta + r * (xi * eta));
        let jacobian = Matrix2::from_columns(&[p + r * eta, q + r * xi]);
        let Some(inverse) = jacobian.try_inverse() else { break };
        let step = inverse * residual;
        xi = (xi + step.x).clamp(-2.0, 2.0);
        eta = (eta + step.y).clamp(-2.0, 2.0);
        if step.lp_norm(1) < 1e-12 {
            break;
        }
    }
    [xi, eta]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_map_is_inverted_within_the_quadrilateral_and_near_it() {
        let corners = [[0.0, 0.0], [2.0, 0.3], [2.4, 1.9], [-0.2, 1.5]];
        for expected in [[0.0, 0.0], [0.3, -0.7], [1.0, 1.0], [-1.0, 0.2], [1.4, -1.2]] {
            let shape = shape_functions(expected);
            let point: [f64; 2] = std::array::from_fn(|k| {
                shape.iter().zip(&corners).map(|(n, corner)| n * corner[k]).sum()
            });
            let found = natural_coordinates(&corners, point);
            assert!(
                (0..2).all(|k| (found[k] - expected[k]).abs() < 1e-12),
                "{found:?} for {expected:?}"
            );
        }
        assert_eq!(
            natural_coordinates(&corners, [1e3, 1e3]).map(f64::abs).map(|t| t <= 2.0),
            [true; 2]
        );
    }
}
