//! Conforming surfaces: a ball in its groove, a roller in its seat.
//!
//! Where one body is convex and the other concave along an axis, the contact bends round both. A
//! place is then told by its arc lengths, the same on both bodies, and its gap, displacement and
//! force are along the common normal, which is inclined by the angle θ:
//! ```text
//! κ_k² = max(0, -κ_upper κ_lower)      along the axis k of the fields, 1/κ = √(R_1 R_2)
//! θ² = Σ (κ_k s_k)²                    inclination at the arc lengths s
//! δ0 = ½ Σ k_k s_k² (sin θ/2)²/(θ/2)²  gap along the normal; (R_2 - R_1)(1 - cos θ) of two arcs
//! e = cos θ                            closing of the gap per unit of approach
//! ```
//! so that an approach α leaves the gap `(e + α)(1 - cos θ) - α` of two arcs whose radii differ by
//! e: the contact conforms less the deeper the ball lies. Displacements between inclined normals
//! are those of [`SurfaceFlexibility::inclined`]. In narrow contacts all this is Hertz's theory.
//!
//! Only the curvatures along the axes of the fields count; those of bodies that are turned against
//! each other leave a mixed term that is left out. Bodies with heights lie on a plane.
//!
//! [`SurfaceFlexibility::inclined`]: crate::SurfaceFlexibility::inclined

use crate::SurfaceGrid;

/// Largest inclination of the common normal \[rad\]: 80°, beyond which no contact is solved.
const STEEPEST: f64 = 1.396_263_401_595_463_6;

/// The inclination of the common normals of two bodies.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Conformity {
    /// Angle of the common normal for each arc length along x and y of the fields \[1/mm\].
    curvature: [f64; 2],
}

impl Conformity {
    /// The conformity of two bodies with these curvatures along x and y of the fields, positive
    /// where convex \[1/mm\].
    pub fn of(upper: [f64; 2], lower: [f64; 2]) -> Self {
        Self { curvature: [0, 1].map(|k| (-upper[k] * lower[k]).max(0.0).sqrt()) }
    }

    /// Whether the bodies conform along an axis.
    pub fn is_conforming(&self) -> bool {
        self.curvature.iter().any(|curvature| *curvature > 0.0)
    }

    /// Returns the angle of the common normal for each arc length along x and y \[1/mm\].
    pub const fn curvature(&self) -> [f64; 2] {
        self.curvature
    }

    /// Returns the inclination of the common normal at the arc lengths \[rad\].
    pub fn angle(&self, place: [f64; 2]) -> f64 {
        f64::hypot(self.curvature[0] * place[0], self.curvature[1] * place[1])
    }

    /// Returns the gap along the normal over that of parabolas.
    pub(super) fn of_parabola(&self, place: [f64; 2]) -> f64 {
        let half = 0.5 * self.angle(place).min(STEEPEST);
        if half > 0.0 { (half.sin() / half).powi(2) } else { 1.0 }
    }

    /// Returns by how much an approach of 1 closes the gaps of cells.
    pub(super) fn closing(&self, grid: &SurfaceGrid) -> Vec<f64> {
        grid.sample(|x, y| self.angle([x, y]).min(STEEPEST).cos())
    }

    /// Returns the stiffness of a flat punch with the semi-axes `[a, b]` that presses along the
    /// normals, over that of one that presses along the approach: the mean of `cos² θ` along each
    /// axis, over which the pressure of the punch is even.
    pub fn of_stiffness(&self, semi_axes: [f64; 2]) -> f64 {
        let along = |k: usize| {
            let twice = 2.0 * (self.curvature[k] * semi_axes[k]).min(STEEPEST);
            if twice > 0.0 { 0.5 * (1.0 + twice.sin() / twice) } else { 1.0 }
        };
        along(0) * along(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_arcs_have_their_gap_and_closing() {
        let (ball, groove) = (5.0, 5.2);
        let pair = Conformity::of([0.2, 1.0 / ball], [0.05, -1.0 / groove]);
        assert_eq!(pair.curvature()[0].to_bits(), 0.0_f64.to_bits());
        let arc = 2.5;
        let angle = pair.angle([0.4, arc]);
        assert!((angle - arc / (ball * groove).sqrt()).abs() < 1e-15);
        let parabola = 0.5 * (1.0 / ball - 1.0 / groove) * arc * arc;
        let gap = parabola * pair.of_parabola([0.0, arc]);
        assert!((gap - (groove - ball) * (1.0 - angle.cos())).abs() < 1e-12, "{gap}");
        let grid = SurfaceGrid::new(4, 6, 0.1, 1.0).unwrap();
        let closing = pair.closing(&grid);
        assert!((closing[5] - angle.cos()).abs() < 1e-15);
        assert!(closing.iter().all(|closing| (0.8..=1.0).contains(closing)));
    }

    #[test]
    fn convex_bodies_do_not_conform() {
        let pair = Conformity::of([0.2, 0.2], [0.05, 0.0]);
        assert!(!pair.is_conforming());
        assert_eq!(pair.of_parabola([1.0, 3.0]).to_bits(), 1.0_f64.to_bits());
        assert_eq!(pair.of_stiffness([1.0, 3.0]).to_bits(), 1.0_f64.to_bits());
    }

    /// A punch over `±θ` has the mean `½ (1 + sin 2θ/2θ)` of `cos² θ`.
    #[test]
    fn inclined_punches_are_softer() {
        let pair = Conformity::of([0.0, 0.2], [0.0, -0.2]);
        let (count, end) = (1000, 0.6_f64);
        let place = |k: i32| end * (f64::from(k) + 0.5) / f64::from(count);
        let mean = (0..count).map(|k| place(k).cos().powi(2)).sum::<f64>() / f64::from(count);
        assert!((pair.of_stiffness([0.3, 3.0]) - mean).abs() < 1e-6);
    }
}
