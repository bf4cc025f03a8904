//! Elastic constants and the complete material.

use std::sync::Arc;

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use super::fields::{Field, InUnits, Known, Record, record, write_record};
use super::reader::{Cursor, Object};
use super::{
    BackstressTerm, Domain, FatigueLimits, FaultCode, FieldError, Hardening, InitialStress,
    OverDepth, PoissonRatio, PositiveF64, Units,
};
use crate::analytical::ElasticConstants;
use crate::material::{ElasticModuli, HardeningLaw, InitialStressProfile, Solid, StrengthProfile};

/// The material of a body.
#[derive(Debug, Clone, PartialEq)]
pub enum Material {
    /// A rigid body.
    Rigid,
    /// An isotropic elastic body, with an optional hardening curve.
    Deformable(Deformable),
}

impl Material {
    pub(super) fn read(cursor: Cursor<'_>, units: Option<Units>) -> Option<Self> {
        let object = cursor.object()?;
        if !object.has("rigid") {
            return Deformable::read(&object, units).map(Self::Deformable);
        }
        let rigid = object.required("rigid", |c| c.boolean())?;
        if !rigid {
            object.fault(
                "rigid",
                FaultCode::OutOfRange,
                format_args!("must be true, or left out for a body that deforms"),
            );
            return None;
        }
        let of_rigid = ["name", "rigid"];
        let is_deformable =
            Deformable::KEYS.iter().any(|key| !of_rigid.contains(key) && object.has(key));
        object.only(if is_deformable { &of_rigid } else { Deformable::KEYS });
        Some(Self::Rigid)
    }
}

/// An isotropic body: elastic constants and, where it can yield, a hardening curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Deformable {
    /// Elastic constants.
    pub elastic: Elastic,
    /// The hardening law; `None` of a body that stays elastic.
    pub plasticity: Option<Hardening>,
    /// Terms of the backstress, for flow theory; none without a hardening law.
    pub backstress: Vec<BackstressTerm>,
    /// How the stresses of the law vary with the depth.
    pub over_depth: Option<OverDepth>,
    /// Stress before the load by depth; empty if there is none.
    pub initial_stress: Vec<InitialStress>,
    /// Limits of fatigue.
    pub fatigue: Option<FatigueLimits>,
}

impl Deformable {
    const KEYS: &[&str] = &[
        "name",
        "young_modulus",
        "poisson_ratio",
        "plasticity",
        InitialStress::KEY,
        FatigueLimits::KEY,
        "rigid",
    ];

    /// Returns a material that is the same at all depths, without stress before the load and
    /// without limits of fatigue.
    pub fn new(elastic: Elastic, plasticity: Option<Hardening>) -> Self {
        Self {
            elastic,
            plasticity,
            backstress: Vec::new(),
            over_depth: None,
            initial_stress: Vec::new(),
            fatigue: None,
        }
    }

    /// Returns the faults of initial stress and fatigue limits beside the other figures, with
    /// pointers relative to the material.
    fn faults(&self) -> Vec<FieldError> {
        let (law, strength) = (self.hardening_law(), self.strength());
        let of_stress =
            InitialStress::faults(&self.initial_stress, law.as_deref(), strength.as_ref());
        let of_fatigue = self.fatigue.and_then(|limits| limits.fault(self.over_depth.as_ref()));
        let at = |key: &'static str| {
            move |fault: FieldError| FieldError {
                pointer: format!("/{key}{}", fault.pointer),
                ..fault
            }
        };
        let of_stress = of_stress.into_iter().map(at(InitialStress::KEY));
        of_stress.chain(of_fatigue.map(at(FatigueLimits::KEY))).collect()
    }

    /// Returns the hardening curve; `None` for a purely elastic material.
    pub fn hardening_law(&self) -> Option<Arc<dyn HardeningLaw>> {
        let young_modulus = self.elastic.young_modulus.get();
        self.plasticity.as_ref().map(|law| law.curve(young_modulus))
    }

    /// Returns the factors of the hardening curve over depth; `None` if the curve is the same
    /// at all depths.
    pub fn strength(&self) -> Option<StrengthProfile> {
        let profile =
            self.over_depth.as_ref()?.profile(self.hardening_law()?.nominal_yield_stress());
        (profile.range() != (1.0, 1.0)).then_some(profile)
    }

    /// Returns the initial stress over depth.
    pub fn initial_stress_profile(&self) -> InitialStressProfile {
        InitialStress::profile(&self.initial_stress)
    }

    fn read(object: &Object<'_>, units: Option<Units>) -> Option<Self> {
        object.only(Self::KEYS);
        let mut known = Known::default();
        let elastic = Elastic::read_fields(object, units, None, &mut known);
        let beside: Vec<_> = known
            .figure("young_modulus")
            .map(|modulus| ("young_modulus", modulus))
            .into_iter()
            .collect();
        let plasticity = object.or("plasticity", (None, Vec::new(), None), |c| {
            let law = Hardening::read(c, units, &beside);
            let terms =
                c.object()?.or("backstress", Vec::new(), |c| BackstressTerm::read_all(c, units));
            let over_depth =
                c.object()?.or(OverDepth::KEY, None, |c| OverDepth::read(c, units).map(Some));
            Some((Some(law?), terms?, over_depth?))
        });
        let initial_stress =
            object.or(InitialStress::KEY, Vec::new(), |c| InitialStress::read_all(c, units));
        let fatigue =
            object.or(FatigueLimits::KEY, None, |c| FatigueLimits::read(c, units).map(Some));
        let (law, terms, over_depth) = plasticity?;
        let material = Self {
            elastic: elastic?,
            plasticity: law,
            backstress: terms,
            over_depth,
            initial_stress: initial_stress?,
            fatigue: fatigue?,
        };
        let faults = material.faults();
        object.checked(if faults.is_empty() { Ok(material) } else { Err(faults) })
    }
}

record! {
    /// Isotropic linear elasticity.
    #[derive(Copy)]
    pub struct Elastic("", "Elastic") {
        /// Young's modulus E.
        pub young_modulus: PositiveF64 =
            Field::quantity(Domain::Modulus).label("Young’s modulus", "E").example(210_000.0),
        /// Poisson's ratio ν. What is incompressible has 0.499999.
        pub poisson_ratio: PoissonRatio = Field::pure(PoissonRatio::RANGE).label("Poisson’s ratio", "ν").example(0.3),
    }
}

impl From<&Deformable> for Solid {
    fn from(material: &Deformable) -> Self {
        let elastic = Self::new(material.elastic.into())
            .with_initial_stress(material.initial_stress_profile());
        let fatigue =
            material.fatigue.and_then(|limits| limits.strength(material.over_depth.as_ref()));
        let elastic = match fatigue {
            Some(fatigue) => elastic.with_fatigue(fatigue),
            None => elastic,
        };
        let Some(law) = material.hardening_law() else { return elastic };
        let backstress = material.backstress.iter().map(Into::into).collect();
        let solid = elastic.with_hardening(law).with_backstress(backstress);
        match material.strength() {
            Some(strength) => solid.with_strength(strength),
            None => solid,
        }
    }
}

impl From<Elastic> for ElasticConstants {
    fn from(elastic: Elastic) -> Self {
        Self {
            young_modulus: elastic.young_modulus.get(),
            poisson_ratio: elastic.poisson_ratio.get(),
        }
    }
}

impl From<&Elastic> for ElasticModuli {
    fn from(elastic: &Elastic) -> Self {
        ElasticConstants::from(*elastic).into()
    }
}

impl Elastic {
    /// Returns the shear modulus `G = E / (2 (1 + ν))` \[MPa\].
    pub fn shear_modulus(&self) -> f64 {
        ElasticConstants::from(*self).shear_modulus()
    }

    /// Returns the bulk modulus `K = E / (3 (1 - 2ν))` \[MPa\].
    pub fn bulk_modulus(&self) -> f64 {
        ElasticConstants::from(*self).bulk_modulus()
    }

    /// Returns the plane-strain modulus `E / (1 - ν²)` \[MPa\].
    pub fn plane_strain_modulus(&self) -> f64 {
        ElasticConstants::from(*self).plane_strain_modulus()
    }
}

/// A hardening law, its backstress terms and its strength over depth.
struct Plasticity<'a>(&'a Hardening, &'a [BackstressTerm], Option<&'a OverDepth>);

impl Serialize for InUnits<'_, Plasticity<'_>> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Wire<'a> {
            #[serde(flatten)]
            law: InUnits<'a, Hardening>,
            #[serde(skip_serializing_if = "Vec::is_empty")]
            backstress: Vec<InUnits<'a, BackstressTerm>>,
            #[serde(skip_serializing_if = "Option::is_none")]
            over_depth: Option<InUnits<'a, OverDepth>>,
        }
        let Plasticity(law, backstress, over_depth) = *self.0;
        let backstress = backstress.iter().map(|term| InUnits(term, self.1)).collect();
        let over_depth = over_depth.map(|over_depth| InUnits(over_depth, self.1));
        Wire { law: InUnits(law, self.1), backstress, over_depth }.serialize(serializer)
    }
}

impl Serialize for InUnits<'_, Material> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        match self.0 {
            Material::Rigid => map.serialize_entry("rigid", &true)?,
            Material::Deformable(deformable) => {
                write_record(&deformable.elastic, &mut map, self.1)?;
                if let Some(curve) = &deformable.plasticity {
                    let plasticity =
                        Plasticity(curve, &deformable.backstress, deformable.over_depth.as_ref());
                    map.serialize_entry("plasticity", &InUnits(&plasticity, self.1))?;
                }
                if !deformable.initial_stress.is_empty() {
                    let rows: Vec<_> =
                        deformable.initial_stress.iter().map(|row| InUnits(row, self.1)).collect();
                    map.serialize_entry(InitialStress::KEY, &rows)?;
                }
                if let Some(fatigue) = &deformable.fatigue {
                    map.serialize_entry(FatigueLimits::KEY, &InUnits(fatigue, self.1))?;
                }
            }
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Bilinear, RambergOsgood, Swift, Voce};

    fn positive(value: f64) -> PositiveF64 {
        PositiveF64::new(value).unwrap()
    }

    fn faults_of(curve: &Hardening) -> Vec<String> {
        let faults = curve.faults(&[("young_modulus", 210_000.0)]);
        faults.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn moduli() {
        let poisson_ratio = PoissonRatio::new(0.25).unwrap();
        let elastic = Elastic { young_modulus: positive(100.0), poisson_ratio };
        assert!((elastic.shear_modulus() - 40.0).abs() < 1e-12);
        assert!((elastic.bulk_modulus() - 200.0 / 3.0).abs() < 1e-12);
        assert!((elastic.plane_strain_modulus() - 1600.0 / 15.0).abs() < 1e-12);
    }

    #[test]
    fn the_tangent_lies_below_the_elastic_slope() {
        let bilinear = |slope| {
            Hardening::Bilinear(Bilinear {
                yield_stress: positive(500.0),
                tangent_modulus: super::super::NonNegativeF64::new(slope).unwrap(),
            })
        };
        assert!(faults_of(&bilinear(0.0)).is_empty());
        assert!(faults_of(&bilinear(209_999.0)).is_empty());
        let expected = ["/tangent_modulus: must be less than `young_modulus`"];
        assert_eq!(faults_of(&bilinear(210_000.0)), expected);
    }

    #[test]
    fn exponents_and_saturation_are_checked() {
        let (reference_stress, offset) = (positive(500.0), positive(0.3));
        let exponent = positive(0.9);
        let faults = faults_of(&Hardening::RambergOsgood(RambergOsgood {
            reference_stress,
            offset,
            exponent,
        }));
        assert_eq!(faults, ["/exponent: must be between 1 and 200"]);
        let (yield_stress, rate) = (positive(300.0), positive(10.0));
        let saturation_stress = positive(299.0);
        let faults = faults_of(&Hardening::Voce(Voce { yield_stress, saturation_stress, rate }));
        assert_eq!(faults, ["/saturation_stress: must be at least `yield_stress`"]);
        let (strain_offset, exponent) = (positive(0.01), positive(1.1));
        let faults = faults_of(&Hardening::Swift(Swift { yield_stress, strain_offset, exponent }));
        assert_eq!(faults, ["/exponent: must be between 0.001 and 1"]);
    }
}
