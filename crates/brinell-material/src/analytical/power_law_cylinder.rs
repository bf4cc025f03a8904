//! The thick-walled cylinder of an incompressible power-law material.

use super::CylinderStress;

/// A long thick-walled tube whose strain is a pure power of its stress: Ramberg-Osgood without the
/// elastic part.
///
/// ```text
/// ε_q = β (σ_0/E) (q/σ_0)^m
/// ```
/// Plane strain and incompressibility leave `u = C/r`, so `ε_q = (2/√3) C/r²` and `q ~ r^(-2/m)`;
/// equilibrium then gives every stress in closed form. All stresses stay in proportion as the
/// pressure grows, so deformation theory is exact. `m = 1` is Lamé's tube with ν = 1/2, `m -> ∞`
/// the rigid-plastic limit.
///
/// # Reference
/// R. W. Bailey, Proc. Inst. Mech. Eng. 131 (1935) 131-349 (the same field for power-law creep).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerLawCylinder {
    /// `a = inner_radius [mm]`
    pub inner_radius: f64,
    /// `b = outer_radius [mm]`
    pub outer_radius: f64,
    /// `E = young_modulus [MPa]`
    pub young_modulus: f64,
    /// `σ_0 = reference_stress [MPa]`
    pub reference_stress: f64,
    /// `β = offset`, called a where it cannot be taken for a radius
    pub offset: f64,
    /// `m = exponent`
    pub exponent: f64,
}

impl PowerLawCylinder {
    /// Equivalent strain at the equivalent stress q.
    pub fn strain(&self, equivalent_stress: f64) -> f64 {
        let Self { young_modulus, reference_stress, offset, exponent, .. } = self;
        offset * reference_stress / young_modulus
            * (equivalent_stress / reference_stress).powf(*exponent)
    }

    /// The tube under an internal pressure p `[MPa]`.
    pub const fn under(&self, pressure: f64) -> LoadedPowerLawCylinder {
        LoadedPowerLawCylinder { cylinder: *self, pressure }
    }
}

/// A [`PowerLawCylinder`] under a given pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadedPowerLawCylinder {
    cylinder: PowerLawCylinder,
    pressure: f64,
}

impl LoadedPowerLawCylinder {
    /// Stress at the radius r.
    ///
    /// ```text
    /// σ_r = -p [(b/r)^(2/m) - 1] / D          D = (b/a)^(2/m) - 1
    /// σ_θ = σ_r + (2/m) p (b/r)^(2/m) / D     σ_z = ½ (σ_r + σ_θ)
    /// ```
    pub fn stress(&self, radius: f64) -> CylinderStress {
        let power = 2.0 / self.cylinder.exponent;
        let logarithm = (self.cylinder.outer_radius / radius).ln();
        let denominator = self.denominator();
        let radial = -self.pressure * (power * logarithm).exp_m1() / denominator;
        let hoop = radial + power * self.pressure * (power * logarithm).exp() / denominator;
        CylinderStress { radial, hoop, axial: 0.5 * (radial + hoop) }
    }

    /// Equivalent stress `q = (√3/m) p (b/r)^(2/m) / D` at the radius r.
    pub fn equivalent_stress(&self, radius: f64) -> f64 {
        let m = self.cylinder.exponent;
        let decay = (self.cylinder.outer_radius / radius).powf(2.0 / m);
        3.0_f64.sqrt() / m * self.pressure * decay / self.denominator()
    }

    /// Equivalent strain `ε_q` at the radius r.
    pub fn equivalent_strain(&self, radius: f64) -> f64 {
        self.cylinder.strain(self.equivalent_stress(radius))
    }

    /// Radial displacement `u = (√3/2) r ε_q(r) [mm]` at the radius r; u r is the same everywhere.
    pub fn displacement(&self, radius: f64) -> f64 {
        0.5 * 3.0_f64.sqrt() * radius * self.equivalent_strain(radius)
    }

    /// `(b/a)^(2/m) - 1`
    fn denominator(&self) -> f64 {
        let cylinder = &self.cylinder;
        (2.0 / cylinder.exponent * (cylinder.outer_radius / cylinder.inner_radius).ln()).exp_m1()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytical::ThickCylinder;

    fn tube(exponent: f64) -> PowerLawCylinder {
        PowerLawCylinder {
            inner_radius: 100.0,
            outer_radius: 200.0,
            young_modulus: 210_000.0,
            reference_stress: 240.0,
            offset: 1.0,
            exponent,
        }
    }

    #[test]
    fn fields_are_in_equilibrium_and_compatible() {
        for m in [1.0, 3.0, 5.0, 12.0] {
            let state = tube(m).under(150.0);
            assert!((state.stress(100.0).radial + 150.0).abs() < 1e-10);
            assert!(state.stress(200.0).radial.abs() < 1e-10);
            let constant = state.displacement(100.0) * 100.0;
            for r in [101.0, 130.0, 199.0] {
                let stress = state.stress(r);
                let slope = (state.stress(r + 1e-4).radial - state.stress(r - 1e-4).radial) / 2e-4;
                assert!(
                    (slope - (stress.hoop - stress.radial) / r).abs() < 1e-6,
                    "m = {m}, r = {r}"
                );
                assert!((state.displacement(r) * r / constant - 1.0).abs() < 1e-12);
                assert!((stress.von_mises() / state.equivalent_stress(r) - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn exponent_one_is_lame_without_volume_change() {
        let lame = ThickCylinder {
            inner_radius: 100.0,
            outer_radius: 200.0,
            young_modulus: 210_000.0,
            poisson_ratio: 0.5,
            yield_stress: 1e9,
        };
        let (expected, state) = (lame.under(150.0).unwrap(), tube(1.0).under(150.0));
        for r in [100.0, 140.0, 200.0] {
            assert!((expected.stress(r).hoop - state.stress(r).hoop).abs() < 1e-9);
            assert!((expected.stress(r).axial - state.stress(r).axial).abs() < 1e-9);
            assert!((expected.displacement(r) / state.displacement(r) - 1.0).abs() < 1e-12);
        }
    }

    /// At the limit pressure a very large exponent leaves `q = σ_0` everywhere.
    #[test]
    fn large_exponents_approach_the_limit_state() {
        let limit = 2.0 * 240.0 / 3.0_f64.sqrt() * 2.0_f64.ln();
        for r in [100.0, 150.0, 200.0] {
            assert!((tube(1e5).under(limit).equivalent_stress(r) / 240.0 - 1.0).abs() < 1e-4);
        }
    }
}
