//! Places along and below the surface of a body.

/// Coordinates of the contact on a body: position along the surface and depth below it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SurfaceFrame {
    /// Along x, depth along y: surfaces close to their tangent.
    Tangent,
    /// Arc length from the origin along a circle, depth along its radius. The circle has its
    /// centre at `[0, -radius]`: below a pin, above the bottom of a hole, whose radius is negative
    /// \[mm\].
    Circle {
        /// Radius, negative for a hole \[mm\].
        radius: f64,
    },
}

impl SurfaceFrame {
    /// Position along the surface and depth of a point `[x, y]` \[mm\].
    pub fn place(self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Tangent => [x, 0.0 - y],
            Self::Circle { radius } => {
                let dy = y + radius;
                [
                    radius.abs() * x.atan2(dy * radius.signum()),
                    radius - x.hypot(dy).copysign(radius),
                ]
            }
        }
    }

    /// Whether a point lies in the inner fifth of a pin, whose rigid core disturbs the stresses
    /// there.
    pub fn is_near_core(self, position: [f64; 2]) -> bool {
        let depth = self.place(position)[1];
        matches!(self, Self::Circle { radius } if radius > 0.0 && depth > 0.8 * radius)
    }

    /// Unit vector along the outward normal through a point `[x, y]` \[mm\].
    pub fn normal(self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Tangent => [0.0, 1.0],
            Self::Circle { radius } => {
                let distance = x.hypot(y + radius).copysign(radius);
                if distance == 0.0 { [0.0, 1.0] } else { [x / distance, (y + radius) / distance] }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_on_a_pin_and_in_a_hole() {
        for radius in [10.0_f64, -10.0] {
            let frame = SurfaceFrame::Circle { radius };
            for (angle, depth) in [(0.0_f64, 0.0), (0.3, 2.0), (1.4, 0.5), (2.9, 1.0)] {
                let distance = 10.0 - depth * radius.signum();
                let point =
                    [distance * angle.sin(), distance * angle.cos() * radius.signum() - radius];
                let [along, below] = frame.place(point);
                assert!((along - 10.0 * angle).abs() < 1e-12 && (below - depth).abs() < 1e-12);
                let [x, y] = frame.normal(point);
                assert!(
                    (x - angle.sin() * radius.signum()).abs() < 1e-12
                        && (y - angle.cos()).abs() < 1e-12
                );
            }
        }
        let [along, below] = SurfaceFrame::Tangent.place([2.0, -3.0]);
        assert!((along - 2.0).abs() + (below - 3.0).abs() < 1e-15);
    }
}
