//! Uniaxial hardening curves.

use std::ops::RangeInclusive;

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::reader::{Cursor, Object};
use super::wire::InUnits;
use super::{FieldError, NonNegativeF64, PositiveF64, Quantity, TablePoints, Units};

/// Uniaxial curve of stress against plastic strain. Its numerics live in `plasticity`.
#[derive(Debug, Clone, PartialEq)]
pub enum Hardening {
    /// Straight line of slope `E_t` (total strain) beyond the yield stress; `E_t = 0` is perfectly plastic.
    Bilinear {
        /// `σ_y` \[MPa\].
        yield_stress: PositiveF64,
        /// `E_t` \[MPa\], below Young's modulus.
        tangent_modulus: NonNegativeF64,
    },
    /// `ε_p = a (σ_0 / E) (q / σ_0)^m`.
    RambergOsgood {
        /// `σ_0` \[MPa\].
        reference_stress: PositiveF64,
        /// Offset a.
        offset: PositiveF64,
        /// Exponent m, 1 to 200.
        exponent: PositiveF64,
    },
    /// Piecewise linear through `[plastic_strain, stress]`; constant beyond the last.
    Table {
        /// The curve.
        points: TablePoints,
    },
    /// `q = σ_y (1 + ε_p / ε_0)^n`.
    Swift {
        /// `σ_y` \[MPa\].
        yield_stress: PositiveF64,
        /// `ε_0`.
        strain_offset: PositiveF64,
        /// n, above 0 and at most 1.
        exponent: PositiveF64,
    },
    /// `q = σ_y + k ε_p^n`.
    Ludwik {
        /// `σ_y` \[MPa\].
        yield_stress: PositiveF64,
        /// k \[MPa\].
        coefficient: PositiveF64,
        /// n, above 0 and at most 1.
        exponent: PositiveF64,
    },
    /// `q = σ_y + (σ_s - σ_y) (1 - exp(-b ε_p))`.
    Voce {
        /// `σ_y` \[MPa\].
        yield_stress: PositiveF64,
        /// Saturation stress `σ_s` \[MPa\], at least `σ_y`.
        saturation_stress: PositiveF64,
        /// b.
        rate: PositiveF64,
    },
}

/// Range of the Ramberg–Osgood exponent m: from linear to, for every purpose, perfectly plastic.
pub const STRESS_EXPONENT: RangeInclusive<f64> = 1.0..=200.0;
/// Range of the exponent n of the Swift and Ludwik laws.
pub const STRAIN_EXPONENT: RangeInclusive<f64> = 1e-3..=1.0;
/// Range of the Ramberg–Osgood offset a.
pub const OFFSET: RangeInclusive<f64> = 1e-9..=1e6;
/// Range of the Swift strain `ε_0`.
pub const STRAIN_OFFSET: RangeInclusive<f64> = 1e-9..=1e3;
/// Range of the Voce rate b.
pub const RATE: RangeInclusive<f64> = 1e-6..=1e6;
/// Range of plastic strains in a table.
pub const PLASTIC_STRAIN: RangeInclusive<f64> = 0.0..=100.0;

impl Hardening {
    /// The words of the wire format's `law`.
    pub const LAWS: &'static [&'static str] =
        &["bilinear", "ramberg_osgood", "table", "swift", "ludwik", "voce"];

    /// The word of this law in the wire format.
    pub const fn law_name(&self) -> &'static str {
        match self {
            Self::Bilinear { .. } => "bilinear",
            Self::RambergOsgood { .. } => "ramberg_osgood",
            Self::Table { .. } => "table",
            Self::Swift { .. } => "swift",
            Self::Ludwik { .. } => "ludwik",
            Self::Voce { .. } => "voce",
        }
    }

    /// Everything unphysical about this curve beside an elastic modulus, with pointers relative to the curve.
    pub(super) fn faults(&self, young_modulus: PositiveF64) -> Vec<FieldError> {
        match self {
            Self::Bilinear { tangent_modulus, .. } => {
                too_steep(*tangent_modulus, young_modulus).into_iter().collect()
            }
            Self::RambergOsgood { exponent, .. } => outside(*exponent, &STRESS_EXPONENT),
            Self::Swift { exponent, .. } | Self::Ludwik { exponent, .. } => {
                outside(*exponent, &STRAIN_EXPONENT)
            }
            Self::Voce { yield_stress, saturation_stress, .. } => {
                softening(*yield_stress, *saturation_stress).into_iter().collect()
            }
            Self::Table { .. } => Vec::new(),
        }
    }

    /// Reads a curve. Young's modulus is only needed for comparison and may itself be at fault.
    pub(super) fn read(
        cursor: Cursor<'_>,
        units: Option<Units>,
        young_modulus: Option<PositiveF64>,
    ) -> Option<Self> {
        let object = cursor.object()?;
        match object.required("law", |c| c.word(Self::LAWS))? {
            "bilinear" => read_bilinear(&object, units, young_modulus),
            "ramberg_osgood" => read_ramberg_osgood(&object, units),
            "table" => read_table(&object, units),
            "swift" => read_swift(&object, units),
            "ludwik" => read_ludwik(&object, units),
            _ => read_voce(&object, units),
        }
    }
}

fn stress(object: &Object<'_>, key: &str, units: Option<Units>) -> Option<PositiveF64> {
    object.required(key, |c| c.quantity(Quantity::Stress, units))
}

fn read_bilinear(
    object: &Object<'_>,
    units: Option<Units>,
    young_modulus: Option<PositiveF64>,
) -> Option<Hardening> {
    object.only(&["law", "yield_stress", "tangent_modulus"]);
    let yield_stress = stress(object, "yield_stress", units);
    let tangent_modulus = object.required("tangent_modulus", |c| c.quantity(Quantity::TangentModulus, units));
    object.report(tangent_modulus.zip(young_modulus).and_then(|(slope, limit)| too_steep(slope, limit)));
    Some(Hardening::Bilinear { yield_stress: yield_stress?, tangent_modulus: tangent_modulus? })
}

fn read_ramberg_osgood(object: &Object<'_>, units: Option<Units>) -> Option<Hardening> {
    object.only(&["law", "reference_stress", "offset", "exponent"]);
    let reference_stress = stress(object, "reference_stress", units);
    let offset = object.required("offset", |c| c.number_in(&OFFSET));
    let exponent = object.required("exponent", |c| c.number_in(&STRESS_EXPONENT));
    Some(Hardening::RambergOsgood {
        reference_stress: reference_stress?,
        offset: offset?,
        exponent: exponent?,
    })
}

fn read_table(object: &Object<'_>, units: Option<Units>) -> Option<Hardening> {
    object.only(&["law", "points"]);
    let strain = |c: Cursor<'_>| c.number_in(&PLASTIC_STRAIN);
    let stress = |c: Cursor<'_>| c.quantity(Quantity::Stress, units);
    let points = object.required("points", |c| {
        let points = c.array(1..=TablePoints::MAX_POINTS, |item| item.pair(strain, stress))?;
        c.checked(TablePoints::new(points))
    });
    Some(Hardening::Table { points: points? })
}

fn read_swift(object: &Object<'_>, units: Option<Units>) -> Option<Hardening> {
    object.only(&["law", "yield_stress", "strain_offset", "exponent"]);
    let yield_stress = stress(object, "yield_stress", units);
    let strain_offset = object.required("strain_offset", |c| c.number_in(&STRAIN_OFFSET));
    let exponent = object.required("exponent", |c| c.number_in(&STRAIN_EXPONENT));
    Some(Hardening::Swift { yield_stress: yield_stress?, strain_offset: strain_offset?, exponent: exponent? })
}

fn read_ludwik(object: &Object<'_>, units: Option<Units>) -> Option<Hardening> {
    object.only(&["law", "yield_stress", "coefficient", "exponent"]);
    let yield_stress = stress(object, "yield_stress", units);
    let coefficient = stress(object, "coefficient", units);
    let exponent = object.required("exponent", |c| c.number_in(&STRAIN_EXPONENT));
    Some(Hardening::Ludwik { yield_stress: yield_stress?, coefficient: coefficient?, exponent: exponent? })
}

fn read_voce(object: &Object<'_>, units: Option<Units>) -> Option<Hardening> {
    object.only(&["law", "yield_stress", "saturation_stress", "rate"]);
    let yield_stress = stress(object, "yield_stress", units);
    let saturation_stress = stress(object, "saturation_stress", units);
    let rate = object.required("rate", |c| c.number_in(&RATE));
    object.report(yield_stress.zip(saturation_stress).and_then(|(first, last)| softening(first, last)));
    Some(Hardening::Voce { yield_stress: yield_stress?, saturation_stress: saturation_stress?, rate: rate? })
}

fn too_steep(tangent_modulus: NonNegativeF64, young_modulus: PositiveF64) -> Option<FieldError> {
    (tangent_modulus.get() >= young_modulus.get())
        .then(|| FieldError::new("/tangent_modulus", "must be less than `young_modulus`"))
}

fn softening(yield_stress: PositiveF64, saturation_stress: PositiveF64) -> Option<FieldError> {
    (saturation_stress < yield_stress)
        .then(|| FieldError::new("/saturation_stress", "must be at least `yield_stress`"))
}

fn outside(exponent: PositiveF64, range: &RangeInclusive<f64>) -> Vec<FieldError> {
    if range.contains(&exponent.get()) {
        return Vec::new();
    }
    let detail = format!("must be between {} and {}", range.start(), range.end());
    vec![FieldError::new("/exponent", detail)]
}

impl Serialize for InUnits<'_, Hardening> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("law", self.0.law_name())?;
        match self.0 {
            Hardening::Bilinear { yield_stress, tangent_modulus } => {
                self.entry(&mut map, "yield_stress", Quantity::Stress, *yield_stress)?;
                self.entry(&mut map, "tangent_modulus", Quantity::TangentModulus, *tangent_modulus)?;
            }
            Hardening::RambergOsgood { reference_stress, offset, exponent } => {
                self.entry(&mut map, "reference_stress", Quantity::Stress, *reference_stress)?;
                map.serialize_entry("offset", offset)?;
                map.serialize_entry("exponent", exponent)?;
            }
            Hardening::Table { points } => {
                let in_units = |stress| Quantity::Stress.to_wire(self.1, stress);
                let points = points.as_slice().iter().map(|[strain, stress]| [*strain, in_units(*stress)]);
                map.serialize_entry("points", &points.collect::<Vec<_>>())?;
            }
            Hardening::Swift { yield_stress, strain_offset, exponent } => {
                self.entry(&mut map, "yield_stress", Quantity::Stress, *yield_stress)?;
                map.serialize_entry("strain_offset", strain_offset)?;
                map.serialize_entry("exponent", exponent)?;
            }
            Hardening::Ludwik { yield_stress, coefficient, exponent } => {
                self.entry(&mut map, "yield_stress", Quantity::Stress, *yield_stress)?;
                self.entry(&mut map, "coefficient", Quantity::Stress, *coefficient)?;
                map.serialize_entry("exponent", exponent)?;
            }
            Hardening::Voce { yield_stress, saturation_stress, rate } => {
                self.entry(&mut map, "yield_stress", Quantity::Stress, *yield_stress)?;
                self.entry(&mut map, "saturation_stress", Quantity::Stress, *saturation_stress)?;
                map.serialize_entry("rate", rate)?;
            }
        }
        map.end()
    }
}
