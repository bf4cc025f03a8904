//! The material of a body: elastic constants, and how it yields.

use std::sync::Arc;

use crate::analytical::ElasticConstants;
use crate::fatigue::FatigueStrength;
use crate::{BackstressTerm, ElasticModuli, HardeningLaw, InitialStressProfile, StrengthProfile};

/// An isotropic material, elastic or with a hardening law.
#[derive(Debug, Clone)]
pub struct Solid {
    elastic: ElasticConstants,
    hardening_law: Option<Arc<dyn HardeningLaw>>,
    backstress: Vec<BackstressTerm>,
    strength: Option<StrengthProfile>,
    initial_stress: InitialStressProfile,
    fatigue: Option<FatigueStrength>,
}

impl Solid {
    /// Returns an elastic material without stress before the load.
    pub fn new(elastic: ElasticConstants) -> Self {
        Self {
            elastic,
            hardening_law: None,
            backstress: Vec::new(),
            strength: None,
            initial_stress: InitialStressProfile::default(),
            fatigue: None,
        }
    }

    /// Returns the material with a hardening law.
    #[must_use]
    pub fn with_hardening(self, law: Arc<dyn HardeningLaw>) -> Self {
        Self { hardening_law: Some(law), ..self }
    }

    /// Returns the material with terms of the backstress, for flow theory.
    #[must_use]
    pub fn with_backstress(self, backstress: Vec<BackstressTerm>) -> Self {
        Self { backstress, ..self }
    }

    /// Returns the material with factors of its hardening law over depth; a profile that is 1 at
    /// all depths is none.
    #[must_use]
    pub fn with_strength(self, strength: StrengthProfile) -> Self {
        Self { strength: Some(strength).filter(|profile| profile.range() != (1.0, 1.0)), ..self }
    }

    /// Returns the material with a stress over depth before any load.
    #[must_use]
    pub fn with_initial_stress(self, initial_stress: InitialStressProfile) -> Self {
        Self { initial_stress, ..self }
    }

    /// Returns the material with limits of its fatigue.
    #[must_use]
    pub fn with_fatigue(self, fatigue: FatigueStrength) -> Self {
        Self { fatigue: Some(fatigue), ..self }
    }

    /// Returns a pressure over the least nominal yield stress of solids; `None` without one, or
    /// without a pressure.
    pub fn over_yield_stress(solids: [Option<&Self>; 2], pressure: f64) -> Option<f64> {
        let yield_stress =
            |solid: &Self| Some(solid.hardening_law.as_ref()?.nominal_yield_stress());
        let least = solids.into_iter().flatten().filter_map(yield_stress).reduce(f64::min)?;
        (least > 0.0 && pressure > 0.0).then(|| pressure / least)
    }

    /// Returns the elastic constants.
    pub const fn elastic(&self) -> ElasticConstants {
        self.elastic
    }

    /// Returns bulk and shear modulus.
    pub fn moduli(&self) -> ElasticModuli {
        self.elastic.into()
    }

    /// Returns the hardening law; `None` for a purely elastic material.
    pub const fn hardening_law(&self) -> Option<&Arc<dyn HardeningLaw>> {
        self.hardening_law.as_ref()
    }

    /// Whether the material has a hardening law.
    pub const fn can_yield(&self) -> bool {
        self.hardening_law.is_some()
    }

    /// Returns the stress at which the hardening law begins \[MPa\]; `None` for a material that
    /// cannot yield, or does from the first load on.
    pub fn yield_stress(&self) -> Option<f64> {
        Some(self.hardening_law.as_ref()?.yield_stress()).filter(|stress| *stress > 0.0)
    }

    /// Returns the terms of the backstress.
    pub fn backstress(&self) -> &[BackstressTerm] {
        &self.backstress
    }

    /// Returns the factors of the hardening law over depth; `None` where they do not vary.
    pub const fn strength(&self) -> Option<&StrengthProfile> {
        self.strength.as_ref()
    }

    /// Returns the stress before any load; empty where there is none.
    pub const fn initial_stress(&self) -> &InitialStressProfile {
        &self.initial_stress
    }

    /// Returns the limits of its fatigue; `None` where they are not known.
    pub const fn fatigue(&self) -> Option<&FatigueStrength> {
        self.fatigue.as_ref()
    }

    /// Returns the material without its hardening law, with elastic constants and initial stress.
    #[must_use]
    pub fn without_plasticity(&self) -> Self {
        Self::new(self.elastic).with_initial_stress(self.initial_stress.clone())
    }
}

/// Materials are equal if neither stress nor life tells them apart.
impl PartialEq for Solid {
    fn eq(&self, other: &Self) -> bool {
        let Self { elastic, hardening_law, backstress, strength, initial_stress, fatigue } = self;
        let laws_are_alike = match (hardening_law, &other.hardening_law) {
            (Some(one), Some(two)) => one.is_like(&**two),
            (one, two) => one.is_none() && two.is_none(),
        };
        laws_are_alike
            && *elastic == other.elastic
            && *backstress == other.backstress
            && *strength == other.strength
            && *initial_stress == other.initial_stress
            && *fatigue == other.fatigue
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hardening::{StraightLine, Swift};

    fn steel() -> Solid {
        Solid::new(ElasticConstants { young_modulus: 210_000.0, poisson_ratio: 0.3 })
    }

    fn swift(yield_stress: f64) -> Arc<dyn HardeningLaw> {
        Arc::new(Swift { yield_stress, strain_offset: 0.01, exponent: 0.2 })
    }

    #[test]
    fn materials_of_the_same_law_are_equal() {
        let hard = steel().with_hardening(swift(500.0));
        assert_eq!(hard, steel().with_hardening(swift(500.0)));
        assert_ne!(hard, steel().with_hardening(swift(501.0)));
        assert_ne!(hard, steel());
        let straight = Arc::new(StraightLine { yield_stress: 500.0, plastic_modulus: 0.0 });
        assert_ne!(hard, steel().with_hardening(straight));
        assert_eq!(hard.without_plasticity(), steel());
    }

    #[test]
    fn a_strength_of_one_is_none() {
        let even = StrengthProfile::new(vec![[0.0, 1.0], [1.0, 1.0]]);
        assert!(steel().with_strength(even).strength().is_none());
        let uneven = StrengthProfile::new(vec![[0.0, 2.0], [1.0, 1.0]]);
        assert!(steel().with_strength(uneven).strength().is_some());
    }
}
