//! Stress states and their invariants.

/// Von Mises equivalent stress of a stress `[σ_xx, σ_yy, σ_zz, τ_xy]`, in its unit.
///
/// `q² = ½[(σ_xx - σ_yy)² + (σ_yy - σ_zz)² + (σ_zz - σ_xx)²] + 3 τ_xy²`
pub fn von_mises(stress: [f64; 4]) -> f64 {
    let [x, y, z, t] = stress;
    (0.5 * ((x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2)) + 3.0 * t * t).sqrt()
}

/// Stress at a point of a plane or axisymmetric contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stress {
    /// Tangential normal stress `σ_x` (radial in axisymmetry).
    pub sigma_x: f64,
    /// Stress `σ_y` normal to the contact.
    pub sigma_y: f64,
    /// Out-of-plane stress `σ_z` (hoop in axisymmetry).
    pub sigma_z: f64,
    /// Shear stress `τ_xy` with y pointing into the body; with y pointing out of it the sign
    /// changes.
    pub tau_xy: f64,
}

impl Stress {
    /// Von Mises equivalent stress.
    pub fn von_mises(&self) -> f64 {
        von_mises([self.sigma_x, self.sigma_y, self.sigma_z, self.tau_xy])
    }

    /// The same stress in axes of which `y` is along a unit vector `normal`, and `x` to the right
    /// of it.
    #[must_use]
    pub fn along(&self, normal: [f64; 2]) -> Self {
        let Self { sigma_x, sigma_y, sigma_z, tau_xy } = *self;
        let ([n_x, n_y], twice) = (normal, 2.0 * normal[0] * normal[1]);
        Self {
            sigma_x: n_y * n_y * sigma_x + n_x * n_x * sigma_y - twice * tau_xy,
            sigma_y: n_x * n_x * sigma_x + n_y * n_y * sigma_y + twice * tau_xy,
            sigma_z,
            tau_xy: 0.5 * twice * (sigma_x - sigma_y) + (n_y * n_y - n_x * n_x) * tau_xy,
        }
    }

    /// Largest shear stress, half the difference of the extreme principal stresses, `σ_z` being
    /// one of the three.
    pub fn tau_max(&self) -> f64 {
        let middle = 0.5 * (self.sigma_x + self.sigma_y);
        let radius = (0.5 * (self.sigma_x - self.sigma_y)).hypot(self.tau_xy);
        let highest = (middle + radius).max(self.sigma_z);
        let lowest = (middle - radius).min(self.sigma_z);
        0.5 * (highest - lowest)
    }
}

/// Stress in a long cylinder under internal pressure; all three are principal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CylinderStress {
    /// Radial stress `σ_r`.
    pub radial: f64,
    /// Hoop stress `σ_θ`.
    pub hoop: f64,
    /// Axial stress `σ_z`, the cylinder held at its length.
    pub axial: f64,
}

impl CylinderStress {
    /// Von Mises equivalent stress.
    pub fn von_mises(&self) -> f64 {
        von_mises([self.radial, self.hoop, self.axial, 0.0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariants_of_simple_states() {
        let zero = Stress { sigma_x: 0.0, sigma_y: 0.0, sigma_z: 0.0, tau_xy: 0.0 };
        let uniaxial = Stress { sigma_y: -7.0, ..zero };
        assert!(
            (uniaxial.von_mises() - 7.0).abs() < 1e-14 && (uniaxial.tau_max() - 3.5).abs() < 1e-14
        );
        let shear = Stress { tau_xy: -2.0, ..zero };
        assert!(
            (shear.von_mises() - 12.0_f64.sqrt()).abs() < 1e-14
                && (shear.tau_max() - 2.0).abs() < 1e-14
        );
        let out_of_plane = Stress { sigma_z: 9.0, ..shear };
        assert!((out_of_plane.tau_max() - 5.5).abs() < 1e-14);
        let pressure = CylinderStress { radial: -3.0, hoop: -3.0, axial: -3.0 };
        assert!(pressure.von_mises() < 1e-14);
    }
}
