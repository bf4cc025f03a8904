//! Shape-function gradients of one element at its 2 × 2 Gauss points.

use super::bilinear_map::CORNERS;
use brinell_material::PerPoint;

/// Gauss points of an element.
pub const QUADRATURE_POINTS: usize = 4;

/// The condition of the third direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StressState {
    /// ε_zz = 0, unit thickness.
    PlaneStrain,
    /// σ_zz = 0, unit thickness.
    PlaneStress,
    /// Body of revolution about `x = 0`: x is the radius, ε_zz = u_x / x the hoop strain, the
    /// thickness 2πx.
    Axisymmetric,
}

/// Gradients `∂N_i/∂x`, `∂N_i/∂y` and integration weights of one quadrilateral. Gauss point g lies
/// at `corner g / √3`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quad {
    /// `gradient_x[i][g] = ∂N_i/∂x` at point g \[1/mm\].
    pub gradient_x: [PerPoint; 4],
    /// `gradient_y[i][g] = ∂N_i/∂y` at point g \[1/mm\].
    pub gradient_y: [PerPoint; 4],
    /// `over_radius[i][g] = N_i / x` at point g of a body of revolution \[1/mm\]; zero in plane
    /// analyses.
    pub over_radius: [PerPoint; 4],
    /// Weight times Jacobian determinant times thickness \[mm² in plane analyses, mm³ in
    /// axisymmetry\].
    pub weight: PerPoint,
    /// Third direction.
    pub stress_state: StressState,
}

/// `SHAPE_AT_POINTS[i][g] = N_i` at Gauss point g: `(1 ± 1/√3)²/4` at the same corner and the
/// opposite one, 1/6 beside.
pub const SHAPE_AT_POINTS: [PerPoint; 4] = {
    const SAME: f64 = 0.622_008_467_928_146_2;
    const OPPOSITE: f64 = 0.044_658_198_738_520_45;
    const BESIDE: f64 = 1.0 / 6.0;
    [
        [SAME, BESIDE, OPPOSITE, BESIDE],
        [BESIDE, SAME, BESIDE, OPPOSITE],
        [OPPOSITE, BESIDE, SAME, BESIDE],
        [BESIDE, OPPOSITE, BESIDE, SAME],
    ]
};

/// `[∂N_i/∂ξ, ∂N_i/∂η][i][g]` at Gauss point g.
const NATURAL_GRADIENTS: [[PerPoint; 4]; 2] = {
    const OVER_ROOT_3: f64 = 0.577_350_269_189_625_8;
    let mut gradients = [[[0.0; QUADRATURE_POINTS]; 4]; 2];
    let mut i = 0;
    while i < 4 {
        let [a, b] = CORNERS[i];
        let mut g = 0;
        while g < QUADRATURE_POINTS {
            let [xi, eta] = CORNERS[g];
            gradients[0][i][g] = 0.25 * a * (1.0 + b * eta * OVER_ROOT_3);
            gradients[1][i][g] = 0.25 * b * (1.0 + a * xi * OVER_ROOT_3);
            g += 1;
        }
        i += 1;
    }
    gradients
};

impl Quad {
    /// Evaluates the gradients for corner coordinates `[x, y]` \[mm\], counter-clockwise.
    #[inline(always)]
    pub fn new(corners: &[[f64; 2]; 4], stress_state: StressState) -> Self {
        let zero = [0.0; QUADRATURE_POINTS];
        let [along_xi, along_eta] = &NATURAL_GRADIENTS;
        // Jacobian [[x_ξ, y_ξ], [x_η, y_η]].
        let [mut x_xi, mut y_xi, mut x_eta, mut y_eta] = [zero; 4];
        for (i, [x, y]) in corners.iter().enumerate() {
            for g in 0..QUADRATURE_POINTS {
                x_xi[g] += along_xi[i][g] * x;
                y_xi[g] += along_xi[i][g] * y;
                x_eta[g] += along_eta[i][g] * x;
                y_eta[g] += along_eta[i][g] * y;
            }
        }
        let (mut gradient_x, mut gradient_y, mut over_radius) = ([zero; 4], [zero; 4], [zero; 4]);
        let mut weight: PerPoint =
            std::array::from_fn(|g| x_xi[g] * y_eta[g] - y_xi[g] * x_eta[g]);
        for i in 0..4 {
            for g in 0..QUADRATURE_POINTS {
                gradient_x[i][g] =
                    (y_eta[g] * along_xi[i][g] - y_xi[g] * along_eta[i][g]) / weight[g];
                gradient_y[i][g] =
                    (x_xi[g] * along_eta[i][g] - x_eta[g] * along_xi[i][g]) / weight[g];
            }
        }
        if stress_state == StressState::Axisymmetric {
            for g in 0..QUADRATURE_POINTS {
                let [radius, _] = Self::point(corners, g);
                weight[g] *= 2.0 * std::f64::consts::PI * radius;
                for (over_radius, shape) in over_radius.iter_mut().zip(&SHAPE_AT_POINTS) {
                    over_radius[g] = shape[g] / radius;
                }
            }
        }
        Self { gradient_x, gradient_y, over_radius, weight, stress_state }
    }

    /// Position `[x, y]` of point g \[mm\] in an element with these corners.
    #[inline(always)]
    pub fn point(corners: &[[f64; 2]; 4], g: usize) -> [f64; 2] {
        let mut position = [0.0; 2];
        for (shape, corner) in SHAPE_AT_POINTS.iter().zip(corners) {
            position[0] += shape[g] * corner[0];
            position[1] += shape[g] * corner[1];
        }
        position
    }

    /// Area of the quadrilateral that point g stands for \[mm²\].
    pub fn area(&self, corners: &[[f64; 2]; 4], g: usize) -> f64 {
        match self.stress_state {
            StressState::PlaneStrain | StressState::PlaneStress => self.weight[g],
            StressState::Axisymmetric => {
                self.weight[g] / (2.0 * std::f64::consts::PI * Self::point(corners, g)[0])
            }
        }
    }

    /// Volume (area times thickness).
    pub fn volume(&self) -> f64 {
        self.weight.iter().sum()
    }

    /// `mean[i] = 1/V ∫ [∂N_i/∂x + N_i/x, ∂N_i/∂y] dV`: the dilatation of the element is `Σ
    /// mean[i] · u_i`.
    pub fn mean_divergence(&self) -> [[f64; 2]; 4] {
        let volume = self.volume();
        std::array::from_fn(|i| {
            let mean = |gradient: &PerPoint| -> f64 {
                gradient.iter().zip(&self.weight).map(|(n, w)| n * w).sum::<f64>() / volume
            };
            [mean(&self.gradient_x[i]) + mean(&self.over_radius[i]), mean(&self.gradient_y[i])]
        })
    }

    /// Displacement gradients at all points, `[ε_xx, ε_yy, ε_zz, γ_xy][g]`, from the nodal
    /// displacements `[u_x, u_y]` of the four nodes; the dilatation is the local one, not the
    /// mean.
    #[inline(always)]
    pub fn strain(&self, u: &[[f64; 2]; 4]) -> [PerPoint; 4] {
        let [mut xx, mut yy, mut zz, mut shear] = [[0.0; QUADRATURE_POINTS]; 4];
        for (i, [ux, uy]) in u.iter().enumerate() {
            let (nx, ny, nr) = (&self.gradient_x[i], &self.gradient_y[i], &self.over_radius[i]);
            for g in 0..QUADRATURE_POINTS {
                xx[g] += nx[g] * ux;
                yy[g] += ny[g] * uy;
                zz[g] += nr[g] * ux;
                shear[g] += ny[g] * ux + nx[g] * uy;
            }
        }
        [xx, yy, zz, shear]
    }

    /// Dilatation of the element, the mean over its volume.
    pub fn mean_dilatation(&self, strain: &[PerPoint; 4]) -> f64 {
        let weighted = (0..QUADRATURE_POINTS)
            .map(|g| (strain[0][g] + strain[1][g] + strain[2][g]) * self.weight[g]);
        weighted.sum::<f64>() / self.volume()
    }

    /// Replaces the dilatation at every point by that of the element (B-bar).
    #[inline(always)]
    pub fn average_dilatation(&self, strain: &mut [PerPoint; 4]) {
        let mean = self.mean_dilatation(strain);
        for g in 0..QUADRATURE_POINTS {
            let shift = (mean - (strain[0][g] + strain[1][g] + strain[2][g])) / 3.0;
            for normal in &mut strain[..3] {
                normal[g] += shift;
            }
        }
    }

    /// Nodal forces `∫ Bᵀ σ dV` of stresses `[σ_xx, σ_yy, σ_zz, τ_xy][g]`.
    ///
    /// `B` is the plain strain matrix. B-bar would give the same forces for a deviatoric stress,
    /// because the two differ only in the dilatation, and for a pressure that is constant over the
    /// element.
    #[inline(always)]
    pub fn nodal_forces(&self, stress: &[PerPoint; 4]) -> [[f64; 2]; 4] {
        let mut weighted = *stress;
        for component in &mut weighted {
            for (s, w) in component.iter_mut().zip(&self.weight) {
                *s *= w;
            }
        }
        let [sx, sy, sz, shear] = &weighted;
        let mut forces = [[0.0; 2]; 4];
        // A loop and not a map over the nodes: that would not be inlined, and so not be compiled
        // for wide vectors.
        for (i, force) in forces.iter_mut().enumerate() {
            let (nx, ny, nr) = (&self.gradient_x[i], &self.gradient_y[i], &self.over_radius[i]);
            for g in 0..QUADRATURE_POINTS {
                force[0] += nx[g] * sx[g] + ny[g] * shear[g] + nr[g] * sz[g];
                force[1] += ny[g] * sy[g] + nx[g] * shear[g];
            }
        }
        forces
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SKEWED: [[f64; 2]; 4] = [[0.0, 0.0], [2.0, 0.3], [2.4, 1.9], [-0.2, 1.5]];

    #[test]
    fn tabulated_shape_functions_are_those_of_the_points() {
        for (g, corner) in CORNERS.iter().enumerate() {
            let [xi, eta] = corner.map(|c| c / 3f64.sqrt());
            for (tabulated, [a, b]) in SHAPE_AT_POINTS.iter().zip(CORNERS) {
                assert!((tabulated[g] - 0.25 * (1.0 + a * xi) * (1.0 + b * eta)).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn linear_displacement_has_constant_strain() {
        let quad = Quad::new(&SKEWED, StressState::PlaneStrain);
        let u = SKEWED.map(|[x, y]| [0.1 * x + 0.2 * y, -0.3 * x + 0.4 * y]);
        let strain = quad.strain(&u);
        for (component, expected) in strain.iter().zip([0.1, 0.4, 0.0, -0.1]) {
            assert!(component.iter().all(|value| (value - expected).abs() < 1e-14));
        }
        assert!((quad.mean_dilatation(&strain) - 0.5).abs() < 1e-14);
    }

    #[test]
    fn a_body_of_revolution_has_hoop_strain_and_pappus_volume() {
        let corners = SKEWED.map(|[x, y]| [x + 3.0, y]);
        let quad = Quad::new(&corners, StressState::Axisymmetric);
        let strain = quad.strain(&corners.map(|[x, _]| [0.1 * x, 0.0]));
        for component in [strain[0], strain[2]] {
            assert!(component.iter().all(|value| (value - 0.1).abs() < 1e-14));
        }
        // ∫ 2πx dA, exact for the quadrature of a bilinear map.
        let polygon = |f: fn([f64; 2], [f64; 2]) -> f64| -> f64 {
            (0..4).map(|k| f(corners[k], corners[(k + 1) % 4])).sum()
        };
        let first_moment = polygon(|p, q| (p[0] + q[0]) * (p[0] * q[1] - p[1] * q[0]) / 6.0);
        assert!((quad.volume() - 2.0 * std::f64::consts::PI * first_moment).abs() < 1e-11);
    }

    #[test]
    fn volume_is_the_area_of_the_polygon() {
        let area: f64 = (0..4)
            .map(|k| {
                let (p, q) = (SKEWED[k], SKEWED[(k + 1) % 4]);
                0.5 * (p[0] * q[1] - p[1] * q[0])
            })
            .sum();
        assert!((Quad::new(&SKEWED, StressState::PlaneStrain).volume() - area).abs() < 1e-14);
    }

    #[test]
    fn nodal_forces_do_the_work_of_the_stresses() {
        let quad = Quad::new(&SKEWED.map(|[x, y]| [x + 1.0, y]), StressState::Axisymmetric);
        let u = [[0.3, -0.1], [0.2, 0.5], [-0.4, 0.1], [0.6, 0.7]];
        let stress: [[f64; 4]; 4] =
            std::array::from_fn(|c| std::array::from_fn(|g| (1.0 + c as f64) * (g as f64 - 1.2)));
        let strain = quad.strain(&u);
        let internal: f64 = (0..4)
            .map(|g| quad.weight[g] * (0..4).map(|c| strain[c][g] * stress[c][g]).sum::<f64>())
            .sum();
        let external: f64 = quad
            .nodal_forces(&stress)
            .iter()
            .zip(&u)
            .map(|(f, v)| f[0] * v[0] + f[1] * v[1])
            .sum();
        assert!((internal - external).abs() < 1e-13);
    }
}
