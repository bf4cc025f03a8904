//! Strength over depth: hardened cases and other layers.
//!
//! The factor s(z) scales the stresses of the hardening curve, `q = s(z) q_0(ε_p)`, at the depth z
//! below the undeformed surface, along its normal. Elastic constants and backstress do not depend
//! on the depth.

use std::f64::consts::SQRT_2;
use std::ops::RangeInclusive;

use serde::{Serialize, Serializer};

use super::fields::{Field, Figure, Known, Member, Record, read_record, record};
use super::reader::{Cursor, Named};
use super::wire::InUnits;
use super::{FaultCode, FieldError, PositiveF64, Quantity, Units};
use crate::material::StrengthProfile;

/// Variation of the strength with the depth below the surface.
#[derive(Debug, Clone, PartialEq)]
pub enum OverDepth {
    /// Points `[depth, s]` with factors of the hardening curve.
    Factors(Vec<[f64; 2]>),
    /// Measured points of hardness, from which [`YIELD_OF_HARDNESS`] gives the yield stress.
    Hardness(HardnessProfile),
    /// Hardness of surface and core and depth of a hardened case, as on a drawing.
    Case(HardenedCase),
}

record! {
    /// Vickers hardness at points.
    pub struct HardnessProfile("", "Hardness over depth") where rules_of_profile {
        /// Points `[depth, HV]`, depths rising, joined by straight lines, constant beyond the
        /// ends.
        pub profile: Vec<[f64; 2]> = Field::points(
            [
                ("Depth below the surface.", Figure::Quantity(Quantity::Depth)),
                ("Vickers hardness.", Figure::Pure(HARDNESS)),
            ],
            1..=OverDepth::MAX_POINTS,
        )
        .label("Hardness over depth", "z, HV")
        .example_points(&[[0.0, 720.0], [0.5, 640.0], [1.0, 500.0], [1.5, 400.0], [2.0, 380.0]]),
    }
}

record! {
    /// Vickers hardness of a hardened case.
    #[derive(Copy)]
    pub struct HardenedCase("", "Hardened case") where rules_of_case {
        /// Vickers hardness HV of the surface.
        pub surface: PositiveF64 = Field::pure(HARDNESS).label("Surface hardness", "HV_s").example(720.0),
        /// Vickers hardness HV of the core.
        pub core: PositiveF64 = Field::pure(HARDNESS).label("Core hardness", "HV_c").example(380.0),
        /// Case depth: where the hardness has fallen to 550 HV.
        pub case_depth: PositiveF64 = Field::quantity(Quantity::Length).label("Case depth", "d").example(1.0),
        /// Profile between surface and core: `error_function` unless given.
        pub curve: Option<CaseCurve> = Field::choice::<CaseCurve>("CaseCurve").label("Profile", ""),
    }
}

/// The hardness profile of a hardened case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CaseCurve {
    /// The profile of carbon that diffuses into a half-space,
    /// `HV = HV_c + (HV_s - HV_c) erfc(u z/d)`. The factor u gives 550 HV at the case depth d.
    #[default]
    ErrorFunction,
    /// Lang's profile, `HV = HV_c + (HV_s - HV_c) 10^(-0.0381 z/d - 0.2662 (z/d)²)`.
    Lang,
}

impl Named for CaseCurve {
    const ALL: &'static [Self] = &[Self::ErrorFunction, Self::Lang];

    fn name(self) -> &'static str {
        match self {
            Self::ErrorFunction => "error_function",
            Self::Lang => "lang",
        }
    }
}

/// The yield stress as a function of the hardness, a regression over steels of 136 to 622 HV.
///
/// # Reference
/// E. J. Pavlina, C. J. Van Tyne, *Correlation of yield strength and tensile strength with
/// hardness for steels*, J. Mater. Eng. Perform. 17 (2008) 888–893.
pub const YIELD_OF_HARDNESS: &str = "σ_y = 2.876 HV − 90.7 MPa (Pavlina and Van Tyne 2008)";

/// Valid range of the hardness \[HV\].
const HARDNESS: RangeInclusive<f64> = 50.0..=2000.0;
/// Hardness at the case depth \[HV\].
const CASE_HARDNESS: f64 = 550.0;
/// Valid range of the factors.
const FACTORS: RangeInclusive<f64> = 0.01..=100.0;
/// Number of intervals of a sampled profile.
const SAMPLES: u32 = 200;

impl OverDepth {
    /// The key of the strength over depth, beside the keys of a hardening law.
    pub const KEY: &'static str = "over_depth";
    /// Most points of a profile.
    pub const MAX_POINTS: usize = 1000;

    /// The field of factors, for the schema and the form.
    pub(crate) const FACTORS: Field = Field::points(
        [
            ("Depth below the surface.", Figure::Quantity(Quantity::Depth)),
            ("Factor of the stresses of the hardening curve.", Figure::Pure(FACTORS)),
        ],
        1..=Self::MAX_POINTS,
    )
    .label("Strength over depth", "z, factor")
    .example_points(&[[0.0, 1.8], [0.5, 1.6], [1.5, 1.0]])
    .declared(
        Self::KEY,
        "Points `[depth, factor]`, depths rising, joined by straight lines, constant beyond the \
         ends.",
        false,
    );

    /// Returns the kinds of a strength over depth: word, label, pointer of the fields below the
    /// key, and fields.
    pub fn kinds() -> [(&'static str, &'static str, &'static str, &'static [Field]); 3] {
        const FACTORS: &[Field] = &[OverDepth::FACTORS];
        [
            ("factors", "Factors", "", FACTORS),
            ("hardness", HardnessProfile::TABLE.label, "/hardness", HardnessProfile::TABLE.fields),
            ("case", HardenedCase::TABLE.label, "/hardness", HardenedCase::TABLE.fields),
        ]
    }

    /// Returns the factors of a hardening curve with this nominal yield stress \[MPa\].
    pub fn profile(&self, yield_stress: f64) -> StrengthProfile {
        let from_hardness =
            |[z, hardness]: [f64; 2]| [z, yield_of_hardness(hardness) / yield_stress];
        let points = match self {
            Self::Factors(points) => points.clone(),
            Self::Hardness(hardness) => {
                hardness.profile.iter().copied().map(from_hardness).collect()
            }
            Self::Case(case) => case.sampled().map(from_hardness).collect(),
        };
        StrengthProfile::new(points)
    }

    /// Returns the rule for the yield stress if it follows from the hardness.
    pub fn rule(&self) -> Option<&'static str> {
        (!matches!(self, Self::Factors(_))).then_some(YIELD_OF_HARDNESS)
    }

    pub(super) fn read(cursor: Cursor<'_>, units: Option<Units>) -> Option<Self> {
        if cursor.is_array() {
            let points = <Vec<[f64; 2]> as Member>::read(cursor, &Self::FACTORS, units)?;
            let faults = faults_of_points(&points, "");
            return cursor.checked(if faults.is_empty() {
                Ok(Self::Factors(points))
            } else {
                Err(faults)
            });
        }
        let object = cursor.object()?;
        object.only(&["hardness"]);
        object.required("hardness", |c| {
            let object = c.object()?;
            if object.has("profile") {
                return read_record(&object, None, units, None, &[]).map(Self::Hardness);
            }
            read_record(&object, None, units, None, &[]).map(Self::Case)
        })
    }
}

/// Refuses depths that do not rise; `pointer` returns the pointer of each depth.
pub(super) fn faults_of_depths(
    depths: impl Iterator<Item = f64>,
    pointer: impl Fn(usize) -> String,
) -> Vec<FieldError> {
    let (mut faults, mut last) = (Vec::new(), f64::NEG_INFINITY);
    for (k, depth) in depths.enumerate() {
        if depth <= last {
            faults.push(FieldError::new(pointer(k), "must be greater than the depth before"));
        }
        last = depth;
    }
    faults
}

fn faults_of_points(points: &[[f64; 2]], pointer: &str) -> Vec<FieldError> {
    faults_of_depths(points.iter().map(|[depth, _]| *depth), |k| format!("{pointer}/{k}/0"))
}

fn rules_of_profile(known: &Known) -> Vec<FieldError> {
    known.points("profile").map_or_else(Vec::new, |points| faults_of_points(points, "/profile"))
}

fn rules_of_case(known: &Known) -> Vec<FieldError> {
    let (Some(surface), Some(core)) = (known.figure("surface"), known.figure("core")) else {
        return Vec::new();
    };
    let (low, high) = (surface.min(core), surface.max(core));
    if low < CASE_HARDNESS && CASE_HARDNESS < high {
        return Vec::new();
    }
    let detail = "must have 550 HV, which the case depth belongs to, between `surface` and \
                  `core`; for other cases give `profile`";
    vec![FieldError {
        pointer: String::new(),
        code: FaultCode::Inconsistent,
        detail: detail.to_owned(),
    }]
}

impl HardenedCase {
    /// Samples the profile as points `[depth, HV]`.
    fn sampled(&self) -> impl Iterator<Item = [f64; 2]> + use<> {
        let (surface, core, depth) = (self.surface.get(), self.core.get(), self.case_depth.get());
        let curve = self.curve.unwrap_or_default();
        let share = (CASE_HARDNESS - core) / (surface - core);
        let unit = inverse_erfc(share);
        let part = move |t: f64| match curve {
            CaseCurve::ErrorFunction => erfc(unit * t),
            CaseCurve::Lang => 10f64.powf(-0.0381 * t - 0.2662 * t * t),
        };
        // The profile ends where a thousandth or less of the difference to the core remains.
        let reach = match curve {
            CaseCurve::ErrorFunction => 2.5 / unit,
            CaseCurve::Lang => 3.5,
        };
        (0..=SAMPLES).map(move |k| {
            let t = reach * f64::from(k) / f64::from(SAMPLES);
            [t * depth, core + (surface - core) * part(t)]
        })
    }
}

/// Returns the yield stress by [`YIELD_OF_HARDNESS`] \[MPa\].
fn yield_of_hardness(hardness: f64) -> f64 {
    2.876 * hardness - 90.7
}

/// Returns the complementary error function for `x >= 0`, to 1.5e-7.
///
/// # Reference
/// M. Abramowitz, I. A. Stegun, *Handbook of Mathematical Functions* (1964), 7.1.26.
fn erfc(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.327_591_1 * x);
    let series = [0.254_829_592, -0.284_496_736, 1.421_413_741, -1.453_152_027, 1.061_405_429];
    let polynomial = series.iter().rev().fold(0.0, |sum, c| t * (c + sum));
    polynomial * (-x * x).exp()
}

/// Returns the x at which [`erfc`] has a value between 0 and 1, by bisection.
fn inverse_erfc(value: f64) -> f64 {
    let (mut low, mut high) = (0.0, 4.0 * SQRT_2);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if erfc(middle) > value { low = middle } else { high = middle }
    }
    low
}

impl Serialize for InUnits<'_, OverDepth> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Hardness<T> {
            hardness: T,
        }
        match self.0 {
            OverDepth::Factors(points) => {
                let rows = points.iter().map(|[z, s]| [Quantity::Depth.to_wire(self.1, *z), *s]);
                serializer.collect_seq(rows)
            }
            OverDepth::Hardness(hardness) => {
                Hardness { hardness: InUnits(hardness, self.1) }.serialize(serializer)
            }
            OverDepth::Case(case) => {
                Hardness { hardness: InUnits(case, self.1) }.serialize(serializer)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(surface: f64, core: f64, curve: Option<CaseCurve>) -> OverDepth {
        let value = |value: f64| PositiveF64::new(value).unwrap();
        OverDepth::Case(HardenedCase {
            surface: value(surface),
            core: value(core),
            case_depth: value(0.8),
            curve,
        })
    }

    #[test]
    fn factors_are_straight_between_points_and_constant_beyond() {
        let profile = OverDepth::Factors(vec![[0.1, 2.0], [0.3, 1.0]]).profile(500.0);
        for (depth, factor) in [(0.0, 2.0), (0.1, 2.0), (0.2, 1.5), (0.3, 1.0), (9.0, 1.0)] {
            assert!((profile.factor(depth) - factor).abs() < 1e-15);
        }
        assert_eq!(profile.range(), (1.0, 2.0));
    }

    #[test]
    fn the_error_function() {
        for (x, expected) in
            [(0.0, 1.0), (0.5, 0.479_500_12), (1.0, 0.157_299_2), (2.0, 0.004_677_73)]
        {
            assert!((erfc(x) - expected).abs() < 2e-7, "{x}");
            assert!(x == 0.0 || (inverse_erfc(expected) - x).abs() < 1e-5, "{x}");
        }
    }

    #[test]
    fn a_case_has_its_hardness_at_surface_depth_and_core() {
        let yield_stress = 1000.0;
        for (surface, core) in [(720.0, 380.0), (380.0, 720.0)] {
            let profile = case(surface, core, None).profile(yield_stress);
            let at = |depth: f64| yield_stress * profile.factor(depth);
            for (depth, hardness) in [(0.0, surface), (0.8, 550.0), (9.0, core)] {
                assert!(
                    (at(depth) / yield_of_hardness(hardness) - 1.0).abs() < 2e-3,
                    "{}",
                    at(depth)
                );
            }
        }
        // Here Lang's profile has fallen by half, for any hardness.
        let lang = case(720.0, 380.0, Some(CaseCurve::Lang)).profile(yield_stress);
        assert!((yield_stress * lang.factor(0.8) / yield_of_hardness(548.7) - 1.0).abs() < 1e-3);
    }
}
