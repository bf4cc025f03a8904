//! Hill's thick-walled cylinder: elastic, perfectly plastic, internal pressure, plane strain.

use super::{CylinderStress, shear_yield_von_mises};

/// A long thick-walled tube of elastic, perfectly plastic material, its length held.
///
/// With `k = σ_y/√3`, inner radius a and outer radius b, yield begins at the bore and spreads to
/// the radius c:
/// ```text
/// first yield  k (1 - a²/b²)      p(c) = k [2 ln(c/a) + 1 - c²/b²]      limit  2 k ln(b/a)
/// ```
/// Stresses follow from equilibrium and `σ_θ - σ_r = 2k` alone while the axial stress is the
/// middle one. For `ν -> 1/2` von Mises' criterion takes exactly this form and loading is
/// proportional, so deformation theory and flow theory agree with it; for smaller ν it is Tresca's
/// with the same k.
///
/// # Reference
/// R. Hill, *The Mathematical Theory of Plasticity* (1950), ch. V.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThickCylinder {
    /// `a = inner_radius [mm]`
    pub inner_radius: f64,
    /// `b = outer_radius [mm]`
    pub outer_radius: f64,
    /// `E = young_modulus [MPa]`
    pub young_modulus: f64,
    /// `ν = poisson_ratio`
    pub poisson_ratio: f64,
    /// `σ_y = yield_stress [MPa]`
    pub yield_stress: f64,
}

impl ThickCylinder {
    /// Yield stress in shear `k = σ_y/√3 [MPa]`.
    pub fn shear_yield_stress(&self) -> f64 {
        shear_yield_von_mises(self.yield_stress)
    }

    /// Pressure at which the bore yields, `k (1 - a²/b²) [MPa]`.
    pub fn first_yield_pressure(&self) -> f64 {
        self.pressure_at(self.inner_radius)
    }

    /// Pressure under which the whole wall flows, `2 k ln(b/a) [MPa]`.
    pub fn limit_pressure(&self) -> f64 {
        self.pressure_at(self.outer_radius)
    }

    /// Pressure at which the plastic zone reaches the radius c, `k [2 ln(c/a) + 1 - c²/b²] [MPa]`.
    pub fn pressure_at(&self, plastic_radius: f64) -> f64 {
        let outer = plastic_radius / self.outer_radius;
        self.shear_yield_stress()
            * (2.0 * (plastic_radius / self.inner_radius).ln() + 1.0 - outer * outer)
    }

    /// The tube under an internal pressure `[MPa]`; `None` above the limit pressure.
    ///
    /// The plastic radius is found by bisection, to rounding.
    pub fn under(&self, pressure: f64) -> Option<LoadedCylinder> {
        if pressure > self.limit_pressure() || pressure.is_nan() {
            return None;
        }
        let (a, b) = (self.inner_radius, self.outer_radius);
        if pressure <= self.first_yield_pressure() {
            let shear = pressure / (1.0 - (a / b).powi(2));
            return Some(LoadedCylinder {
                cylinder: *self,
                plastic_radius: a,
                elastic_shear: shear * a * a,
            });
        }
        let (mut low, mut high) = (a, b);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if self.pressure_at(middle) < pressure { low = middle } else { high = middle }
        }
        let c = 0.5 * (low + high);
        let elastic_shear = self.shear_yield_stress() * c * c;
        Some(LoadedCylinder { cylinder: *self, plastic_radius: c, elastic_shear })
    }
}

/// A [`ThickCylinder`] under a given pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadedCylinder {
    cylinder: ThickCylinder,
    plastic_radius: f64,
    /// `B [N]` of the elastic part, where `σ_r, σ_θ = B (1/b² ∓ 1/r²)`.
    elastic_shear: f64,
}

impl LoadedCylinder {
    /// Radius `c [mm]` of the plastic zone; the inner radius while everything is elastic.
    pub const fn plastic_radius(&self) -> f64 {
        self.plastic_radius
    }

    /// Stress at the radius r.
    ///
    /// ```text
    /// r >= c:  σ_r, σ_θ = B (1/b² ∓ 1/r²)        B = k c²,  or p a² b²/(b² - a²) before yield
    /// r <  c:  σ_r = -k [2 ln(c/r) + 1 - c²/b²]      σ_θ = σ_r + 2k
    ///          σ_z = ν (σ_r + σ_θ)
    /// ```
    pub fn stress(&self, radius: f64) -> CylinderStress {
        let (b, c) = (self.cylinder.outer_radius, self.plastic_radius);
        let (radial, hoop) = if radius < c {
            let k = self.cylinder.shear_yield_stress();
            let radial = -k * (2.0 * (c / radius).ln() + 1.0 - (c / b).powi(2));
            (radial, radial + 2.0 * k)
        } else {
            let (mean, deviator) =
                (self.elastic_shear / (b * b), self.elastic_shear / (radius * radius));
            (mean - deviator, mean + deviator)
        };
        CylinderStress { radial, hoop, axial: self.cylinder.poisson_ratio * (radial + hoop) }
    }

    /// Radial displacement `u [mm]` at the radius r, elastic and plastic zone alike.
    ///
    /// ```text
    /// u = (1 + ν)(1 - 2ν)/E r σ_r(r) + 2 (1 - ν²) B/(E r)
    /// ```
    /// from elastic volume change and equilibrium. It assumes no plastic strain along the axis,
    /// which is exact for `ν = 1/2`.
    pub fn displacement(&self, radius: f64) -> f64 {
        let ThickCylinder { young_modulus, poisson_ratio: nu, .. } = self.cylinder;
        let volumetric = (1.0 + nu) * (1.0 - 2.0 * nu) * radius * self.stress(radius).radial;
        (volumetric + 2.0 * (1.0 - nu * nu) * self.elastic_shear / radius) / young_modulus
    }

    /// Equivalent plastic strain at the radius r, for `ν = 1/2`: `σ_y (c²/r² - 1)/E`; zero outside
    /// c.
    pub fn equivalent_plastic_strain(&self, radius: f64) -> f64 {
        let ratio = self.plastic_radius / radius;
        (self.cylinder.yield_stress * (ratio * ratio - 1.0) / self.cylinder.young_modulus).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tube(poisson_ratio: f64) -> ThickCylinder {
        ThickCylinder {
            inner_radius: 100.0,
            outer_radius: 200.0,
            young_modulus: 210_000.0,
            poisson_ratio,
            yield_stress: 240.0,
        }
    }

    #[test]
    fn pressures_of_the_benchmark() {
        let tube = tube(0.3);
        assert!((tube.first_yield_pressure() - 103.92).abs() < 5e-3);
        assert!((tube.limit_pressure() - 192.09).abs() < 5e-3);
        for (c, pressure) in [(120.0, 139.21), (140.0, 163.91), (160.0, 180.13), (180.0, 189.22)] {
            assert!((tube.pressure_at(c) - pressure).abs() < 5e-3, "c = {c}");
            let state = tube.under(tube.pressure_at(c)).unwrap();
            assert!((state.plastic_radius() - c).abs() < 1e-9);
        }
        assert!(tube.under(193.0).is_none() && tube.under(f64::NAN).is_none());
    }

    #[test]
    fn fields_are_in_equilibrium_and_meet_their_boundaries() {
        let tube = tube(0.3);
        for pressure in [60.0, 139.21, 180.13, tube.limit_pressure()] {
            let state = tube.under(pressure).unwrap();
            assert!((state.stress(100.0).radial + pressure).abs() < 1e-9);
            assert!(state.stress(200.0).radial.abs() < 1e-9);
            for r in [101.0, 115.0, 139.0, 161.0, 199.0] {
                let slope = (state.stress(r + 1e-4).radial - state.stress(r - 1e-4).radial) / 2e-4;
                let stress = state.stress(r);
                assert!((slope - (stress.hoop - stress.radial) / r).abs() < 1e-6, "r = {r}");
            }
        }
    }

    #[test]
    fn elastic_displacement_is_lames_and_continues_through_the_front() {
        let state = tube(0.3).under(60.0).unwrap();
        for r in [100.0_f64, 150.0, 200.0] {
            let lame = 1.3 / 210_000.0 * 60.0 * 1e4 / 3e4 * (0.4 * r + 4e4 / r);
            assert!((state.displacement(r) / lame - 1.0).abs() < 1e-12);
        }
        for nu in [0.3, 0.5] {
            let state = tube(nu).under(163.91).unwrap();
            let c = state.plastic_radius();
            let jump = state.displacement(c * (1.0 + 1e-9)) - state.displacement(c * (1.0 - 1e-9));
            assert!(jump.abs() < 1e-8 * state.displacement(c));
        }
    }

    /// Without volume change u = C/r, and total strain less elastic strain is the plastic strain.
    #[test]
    fn incompressible_strains_add_up() {
        let state = tube(0.5).under(163.91).unwrap();
        let c = state.displacement(100.0) * 100.0;
        for r in [100.0, 110.0, 130.0, 170.0] {
            assert!((state.displacement(r) * r / c - 1.0).abs() < 1e-12);
            let total = 2.0 / 3.0_f64.sqrt() * state.displacement(r) / r;
            let elastic = state.stress(r).von_mises() / 210_000.0;
            assert!(
                (total - elastic - state.equivalent_plastic_strain(r)).abs() < 1e-14,
                "r = {r}"
            );
        }
    }
}
