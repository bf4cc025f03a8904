//! Strength over depth: hardened cases and other layers.
//!
//! The factor s(z) scales the stresses of the hardening curve, `q = s(z) q_0(ε_p)`, at the depth z
//! below the undeformed surface, along its normal. Elastic constants and backstress do not depend
//! on the depth.

use std::f64::consts::SQRT_2;
use std::ops::RangeInclusive;

use serde::{Serialize, Serializer};
use strum::{IntoStaticStr, VariantArray};

use super::fields::{Field, InUnits, Known, Member, NumberKind, Record, read_record, record};
use super::reader::Cursor;
use super::{Domain, FaultCode, FieldError, Named, PositiveF64, Units};
use crate::material::{StrengthProfile, hardness};

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
    /// Hardness at points.
    pub struct HardnessProfile("", "Hardness over depth") where rules_of_profile {
        /// Points `[depth, hardness]`, depths rising, joined by straight lines, constant beyond the
        /// ends.
        pub profile: Vec<[f64; 2]> = Field::points(
            [
                ("Depth below the surface.", NumberKind::Quantity(Domain::Depth)),
                ("Hardness, HV unless `hardness_scale` says HRC.", NumberKind::Pure(HARDNESS)),
            ],
            1..=OverDepth::MAX_POINTS,
        )
        .label("Hardness over depth", "z, HV")
        .example_points(&[[0.0, 720.0], [0.5, 640.0], [1.0, 500.0], [1.5, 400.0], [2.0, 380.0]]),
        /// Scale of the hardness: `HV` unless given. `HRC` becomes HV by ISO 18265, table A.1.
        pub hardness_scale: Option<HardnessScale> =
            Field::choice::<HardnessScale>("HardnessScale").label("Scale", ""),
    }
}

record! {
    /// Hardness of a hardened case.
    #[derive(Copy)]
    pub struct HardenedCase("", "Hardened case") where rules_of_case {
        /// Hardness of the surface, HV unless `hardness_scale` says HRC.
        pub surface: PositiveF64 = Field::pure(HARDNESS).label("Surface hardness", "HV_s").example(720.0),
        /// Hardness of the core.
        pub core: PositiveF64 = Field::pure(HARDNESS).label("Core hardness", "HV_c").example(380.0),
        /// Case depth: where the hardness has fallen to `limit`.
        pub case_depth: PositiveF64 = Field::quantity(Domain::Length).label("Case depth", "d").example(1.0),
        /// Hardness at the case depth: 550 HV unless given, as ISO 18203 has it for carburized
        /// cases. Nitrided cases have that of the core + 50 HV, induction-hardened ones 80 % of
        /// that of the surface.
        pub limit: Option<PositiveF64> = Field::pure(HARDNESS).label("Hardness at the case depth", "HV_d"),
        /// Profile between surface and core: `error_function` unless given.
        pub curve: Option<CaseCurve> = Field::choice::<CaseCurve>("CaseCurve").label("Profile", ""),
        /// Scale of the hardness: `HV` unless given. `HRC` becomes HV by ISO 18265, table A.1.
        pub hardness_scale: Option<HardnessScale> =
            Field::choice::<HardnessScale>("HardnessScale").label("Scale", ""),
    }
}

/// A scale of hardness.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, IntoStaticStr, VariantArray)]
pub enum HardnessScale {
    /// Vickers hardness.
    #[default]
    #[serde(rename = "HV")]
    #[strum(serialize = "HV")]
    Vickers,
    /// Rockwell hardness, scale C.
    #[serde(rename = "HRC")]
    #[strum(serialize = "HRC")]
    RockwellC,
}

impl Named for HardnessScale {}

impl HardnessScale {
    /// Returns the Vickers hardness; `None` beyond the table of the scale.
    pub fn vickers(self, hardness: f64) -> Option<f64> {
        match self {
            Self::Vickers => Some(hardness),
            Self::RockwellC => hardness::vickers_of_rockwell_c(hardness),
        }
    }

    /// Returns the range of valid figures.
    const fn range(self) -> (f64, f64) {
        match self {
            Self::Vickers => VICKERS,
            Self::RockwellC => hardness::ROCKWELL_C_RANGE,
        }
    }

    /// Returns the fault of a figure that lies outside of the range.
    fn fault(self, pointer: &str, hardness: f64) -> Option<FieldError> {
        let (low, high) = self.range();
        (!(low..=high).contains(&hardness)).then(|| FieldError {
            pointer: pointer.to_owned(),
            code: FaultCode::OutOfRange,
            detail: format!("must be between {low} and {high} {}", self.name()),
        })
    }
}

/// The hardness profile of a hardened case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, IntoStaticStr, VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum CaseCurve {
    /// The profile of carbon that diffuses into a half-space,
    /// `HV = HV_c + (HV_s - HV_c) erfc(u z/d)`. The factor u gives 550 HV at the case depth d.
    #[default]
    ErrorFunction,
    /// Lang's profile, `HV = HV_c + (HV_s - HV_c) 10^(-0.0381 z/d - 0.2662 (z/d)²)`.
    Lang,
}

impl Named for CaseCurve {}

/// The yield stress as a function of the hardness, a regression over steels of 136 to 622 HV.
///
/// # Reference
/// E. J. Pavlina, C. J. Van Tyne, *Correlation of yield strength and tensile strength with
/// hardness for steels*, J. Mater. Eng. Perform. 17 (2008) 888–893.
pub const YIELD_OF_HARDNESS: &str = "σ_y = 2.876 HV − 90.7 MPa (Pavlina and Van Tyne 2008)";
/// Slope and offset of [`YIELD_OF_HARDNESS`] \[MPa\].
pub(crate) const YIELD_OVER_HARDNESS: [f64; 2] = [2.876, 90.7];

/// Valid range of the hardness \[HV\].
const VICKERS: (f64, f64) = (50.0, 2000.0);
/// Range of the hardness on any scale.
const HARDNESS: RangeInclusive<f64> = hardness::ROCKWELL_C_RANGE.0..=VICKERS.1;
/// Hardness at the case depth unless the job gives one \[HV\].
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
            ("Depth below the surface.", NumberKind::Quantity(Domain::Depth)),
            ("Factor of the stresses of the hardening curve.", NumberKind::Pure(FACTORS)),
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
        StrengthProfile::new(match (self, self.vickers()) {
            (Self::Factors(points), _) => points.clone(),
            (_, hardness) => hardness.into_iter().flatten().map(from_hardness).collect(),
        })
    }

    /// Returns the hardnesses that the job gives \[HV\]; none if it gives factors.
    pub fn hardnesses(&self) -> Vec<f64> {
        match self {
            Self::Factors(_) => Vec::new(),
            Self::Hardness(hardness) => hardness.in_vickers().map(|[_, value]| value).collect(),
            Self::Case(case) => case.in_vickers()[..2].to_vec(),
        }
    }

    /// Returns points `[depth, HV]` \[mm, HV\]; `None` if the job gives factors.
    pub fn vickers(&self) -> Option<Vec<[f64; 2]>> {
        match self {
            Self::Factors(_) => None,
            Self::Hardness(hardness) => Some(hardness.in_vickers().collect()),
            Self::Case(case) => Some(case.sampled().collect()),
        }
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
            if c.pairs_at("/profile").is_some_and(|points| is_swapped(&points)) {
                object.fault(
                    "profile",
                    FaultCode::Inconsistent,
                    format_args!(
                        "looks like points [hardness, depth]: swap the columns, a point is \
                         [depth, hardness]"
                    ),
                );
                return None;
            }
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

/// Whether points are `[hardness, depth]`: the second column rises, the first does not, and the
/// other way round they are a profile.
fn is_swapped(points: &[[f64; 2]]) -> bool {
    points.len() > 1
        && points.windows(2).all(|pair| pair[1][1] > pair[0][1])
        && points.windows(2).any(|pair| pair[1][0] <= pair[0][0])
        && points.iter().all(|[hardness, depth]| HARDNESS.contains(hardness) && *depth >= 0.0)
}

fn rules_of_profile(known: &Known) -> Vec<FieldError> {
    let Some(points) = known.points("profile") else { return Vec::new() };
    let scale = scale_of(known);
    let mut faults = faults_of_points(points, "/profile");
    faults.extend(
        points
            .iter()
            .enumerate()
            .filter_map(|(k, point)| scale.fault(&format!("/profile/{k}/1"), point[1])),
    );
    faults
}

fn scale_of(known: &Known) -> HardnessScale {
    let word = known.word("hardness_scale");
    let named = HardnessScale::ALL.iter().find(|scale| Some(scale.name()) == word);
    named.copied().unwrap_or_default()
}

fn rules_of_case(known: &Known) -> Vec<FieldError> {
    let scale = scale_of(known);
    let figures = ["surface", "core", "limit"].map(|key| known.figure(key).map(|f| (key, f)));
    let faults: Vec<_> = figures
        .iter()
        .flatten()
        .filter_map(|(key, figure)| scale.fault(&format!("/{key}"), *figure))
        .collect();
    let [Some((_, surface)), Some((_, core)), limit] = figures else { return faults };
    if !faults.is_empty() {
        return faults;
    }
    let vickers = |hardness: f64| scale.vickers(hardness).unwrap_or(hardness);
    let (surface, core) = (vickers(surface), vickers(core));
    let at_depth = limit.map_or(CASE_HARDNESS, |(_, limit)| vickers(limit));
    let (low, high) = (surface.min(core), surface.max(core));
    if low < at_depth && at_depth < high {
        return Vec::new();
    }
    let detail = if limit.is_some() {
        "must lie between the hardness of `surface` and `core`".to_owned()
    } else {
        "must have 550 HV, which the case depth belongs to, between `surface` and `core`; for \
         another hardness at the case depth give `limit`, for other cases `profile`"
            .to_owned()
    };
    let pointer = if limit.is_some() { "/limit" } else { "" };
    vec![FieldError { pointer: pointer.to_owned(), code: FaultCode::Inconsistent, detail }]
}

impl HardnessProfile {
    /// Returns the points in Vickers hardness.
    fn in_vickers(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let scale = self.hardness_scale.unwrap_or_default();
        self.profile.iter().map(move |[z, value]| [*z, scale.vickers(*value).unwrap_or(*value)])
    }
}

impl HardenedCase {
    /// Samples the profile as points `[depth, HV]`.
    fn sampled(&self) -> impl Iterator<Item = [f64; 2]> + use<> {
        let [surface, core, limit] = self.in_vickers();
        let depth = self.case_depth.get();
        let curve = self.curve.unwrap_or_default();
        let share = (limit - core) / (surface - core);
        let unit = inverse_erfc(share);
        // Lang's own profile has fallen by half at the case depth. One that has a hardness of its
        // own there is stretched.
        let stretch = if self.limit.is_some() { inverse_of_lang(share) } else { 1.0 };
        let part = move |t: f64| match curve {
            CaseCurve::ErrorFunction => erfc(unit * t),
            CaseCurve::Lang => 10f64.powf(-LANG[0] * t - LANG[1] * t * t),
        };
        // The profile ends where a thousandth or less of the difference to the core remains.
        let reach = match curve {
            CaseCurve::ErrorFunction => 2.5 / unit,
            CaseCurve::Lang => 3.5,
        };
        let depth = if curve == CaseCurve::Lang { depth / stretch } else { depth };
        (0..=SAMPLES).map(move |k| {
            let t = reach * f64::from(k) / f64::from(SAMPLES);
            [t * depth, core + (surface - core) * part(t)]
        })
    }

    /// Returns the hardness of surface, of core and at the case depth \[HV\].
    fn in_vickers(&self) -> [f64; 3] {
        let scale = self.hardness_scale.unwrap_or_default();
        let vickers = |value: f64| scale.vickers(value).unwrap_or(value);
        let limit = self.limit.map_or(CASE_HARDNESS, |limit| vickers(limit.get()));
        [vickers(self.surface.get()), vickers(self.core.get()), limit]
    }
}

/// Coefficients of Lang's profile, `10^(-a t - b t²)`.
const LANG: [f64; 2] = [0.0381, 0.2662];

/// Returns the t at which Lang's profile has a value between 0 and 1.
fn inverse_of_lang(value: f64) -> f64 {
    let [a, b] = LANG;
    ((a * a - 4.0 * b * value.log10()).sqrt() - a) / (2.0 * b)
}

/// Returns the yield stress by [`YIELD_OF_HARDNESS`] \[MPa\].
fn yield_of_hardness(hardness: f64) -> f64 {
    let [slope, offset] = YIELD_OVER_HARDNESS;
    slope * hardness - offset
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
                let rows = points.iter().map(|[z, s]| [Domain::Depth.to_wire(self.1, *z), *s]);
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
            limit: None,
            curve,
            hardness_scale: None,
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
        // Other limits, of nitrided and induction-hardened cases.
        for limit in [430.0, 576.0, 610.0] {
            for curve in [None, Some(CaseCurve::Lang)] {
                let OverDepth::Case(mut given) = case(720.0, 380.0, curve) else { return };
                given.limit = Some(PositiveF64::new(limit).unwrap());
                let profile = OverDepth::Case(given).profile(yield_stress);
                let found = yield_stress * profile.factor(0.8) / yield_of_hardness(limit);
                assert!((found - 1.0).abs() < 1e-3, "{limit} {curve:?} {found}");
            }
        }
        // Here Lang's profile has fallen by half, for any hardness.
        let lang = case(720.0, 380.0, Some(CaseCurve::Lang)).profile(yield_stress);
        assert!((yield_stress * lang.factor(0.8) / yield_of_hardness(548.7) - 1.0).abs() < 1e-3);
    }
}
