//! A tensile or compression test in the wire format, and the hardening curve that it gives. The
//! routine is [`crate::material::tensile`]; this module reads its input, names every fault, and
//! says in words what was done to the record.

use serde::{Deserialize, Serialize};
use strum::{IntoStaticStr, VariantArray};

use super::fields::{Field, NumberKind, Record, read_record_of, record};
use super::reader::{self, Cursor, Faults};
use super::{Domain, FaultCode, FieldError, FieldTable, JobError, Named, PositiveF64, Units};
use crate::material::tensile::{
    LEAST_POINTS, Measure, TestCurve, TestFault, TestSettings, YieldRule, hardening_curve,
};

record! {
    /// Strain and stress of a tensile or compression test, elastic part included.
    pub struct TensileTest("", "Tensile test") where rules {
        /// Points `[strain, stress]` in the order of their recording. Negative strain and stress
        /// are compression.
        pub points: Vec<[f64; 2]> = Field::points(
            [
                ("Strain, elastic part included.", NumberKind::Pure(-1e7..=1e7)),
                ("Stress.", NumberKind::Quantity(Domain::SignedStress)),
            ],
            LEAST_POINTS..=TensileTest::MAX_POINTS,
        )
        .label("Record", "ε, σ")
        .example_points(&[[0.0, 0.0], [0.001, 210.0], [0.0024, 500.0], [0.02, 540.0], [0.05, 580.0]]),
        /// Young's modulus of the job, which the first slope is compared with, and which takes its
        /// place where no part of the record is straight.
        pub young_modulus: Option<PositiveF64> =
            Field::quantity(Domain::Modulus).label("Young’s modulus", "E"),
        /// Unit of the strain: `1` unless given.
        pub strain_unit: Option<StrainUnit> =
            Field::choice::<StrainUnit>("StrainUnit").label("Unit of the strain", ""),
        /// `engineering` (over first length and section), unless given, or `true`.
        pub measure: Option<TestMeasure> =
            Field::choice::<TestMeasure>("TestMeasure").label("Measure", ""),
        /// What counts as yield: `offset`, unless given, or `departure`, where the record leaves
        /// its first line for good.
        pub yield_at: Option<YieldPlace> =
            Field::choice::<YieldPlace>("YieldPlace").label("Yield", ""),
        /// Plastic strain at yield: 0.0001, R_p0.01, unless given; 0.002 is R_p0.2.
        pub offset: Option<PositiveF64> = Field::pure(1e-7..=0.05).label("Offset", "ε_off"),
    }
}

/// Unit of a strain.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, IntoStaticStr, VariantArray)]
pub enum StrainUnit {
    /// A pure number.
    #[default]
    #[strum(serialize = "1")]
    One,
    /// Per cent.
    #[strum(serialize = "percent")]
    Percent,
    /// Parts per million.
    #[strum(serialize = "microstrain")]
    Micro,
}

impl Named for StrainUnit {}

/// What strain and stress are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, IntoStaticStr, VariantArray)]
pub enum TestMeasure {
    /// Over the first length and the first section.
    #[default]
    #[strum(serialize = "engineering")]
    Engineering,
    /// Logarithmic strain, stress over the section of the moment.
    #[strum(serialize = "true")]
    True,
}

impl Named for TestMeasure {}

/// What counts as yield.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, IntoStaticStr, VariantArray)]
pub enum YieldPlace {
    /// A plastic strain, R_p.
    #[default]
    #[strum(serialize = "offset")]
    Offset,
    /// Where the record leaves its first line for good.
    #[strum(serialize = "departure")]
    Departure,
}

impl Named for YieldPlace {}

/// Plastic strain at yield unless a test gives one: R_p0.01, the least that extensometers tell.
const OFFSET: f64 = 1e-4;
/// Difference of slope and modulus that is worth a sentence of its own.
const NEAR: f64 = 0.1;
/// First stress over the largest above which a record without first strain has plastic strain.
const PLASTIC: f64 = 0.3;
/// Megapascals of a kilopound per square inch.
const KSI: f64 = 6.895;
/// Slopes \[MPa\] of metals in GPa, and largest yield strain of these: soft solids have more.
const IN_GPA: ([f64; 2], f64) = ([40.0, 1000.0], 5e-3);
/// Largest strain of a test: no metal stretches to six times its length.
const LONGEST: f64 = 5.0;

/// A hardening curve from a test, in the units of the test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct TestedCurve {
    /// Points `[plastic_strain, stress]` of the law `table`, true stress. Unit: MPa (SI: Pa).
    pub points: Vec<[f64; 2]>,
    /// Stress at the place that counts as yield. Unit: MPa (SI: Pa).
    pub yield_stress: f64,
    /// First slope of the record; Young's modulus where no part is straight. Unit: MPa (SI: Pa).
    pub slope: f64,
    /// Standard error of the slope over the slope. Without unit.
    pub slope_error: f64,
    /// Stresses between which the record is straight; `null` if no part is. Unit: MPa (SI: Pa).
    #[cfg_attr(feature = "openapi", schema(required))]
    pub straight: Option<[f64; 2]>,
    /// Strain at which the first line meets the axis; it is removed. Without unit.
    pub toe: f64,
    /// Engineering strain and stress at which the specimen necks; `null` if it does not.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub necking: Option<[f64; 2]>,
    /// Root mean square of the distance of the points from the curve. Unit: MPa (SI: Pa).
    pub fit_rms: f64,
    /// Largest distance of a point from the curve. Unit: MPa (SI: Pa).
    pub fit_largest: f64,
    /// Number of points beyond yield that the curve is fitted to.
    pub fitted: usize,
    /// Number of points up to yield.
    pub elastic: usize,
    /// Number of points of unloading and reloading, left out.
    pub unloading: usize,
    /// Number of points beyond necking, left out.
    pub beyond_necking: usize,
    /// What was done to the record, in sentences.
    pub remarks: Vec<String>,
}

impl TensileTest {
    /// Most points of a record.
    pub const MAX_POINTS: usize = 100_000;

    /// The table of its fields.
    pub const FIELDS: FieldTable = <Self as Record>::TABLE;

    /// Reads a test from JSON and computes its hardening curve.
    ///
    /// # Errors
    /// [`JobError`]: not JSON, every field at fault, or a record that gives no curve.
    pub fn solve(text: &[u8]) -> Result<TestedCurve, JobError> {
        let document = reader::parse(text)?;
        let faults = Faults::default();
        let read = Self::read(Cursor::root(&document, &faults));
        let faults = faults.into_sorted(&document);
        match read {
            Some((test, units)) if faults.is_empty() => {
                test.curve(units).map_err(|fault| JobError::Fields(vec![fault]))
            }
            _ => Err(JobError::Fields(faults)),
        }
    }

    fn read(cursor: Cursor<'_>) -> Option<(Self, Units)> {
        let object = cursor.object()?;
        let units = object.or("units", Units::default(), |c| c.named());
        let test = read_record_of(&object, None, &["units"], units, None, &[]);
        Some((test?, units?))
    }

    /// Computes the hardening curve, in the units of the wire.
    ///
    /// # Errors
    /// The reason why the record gives no curve.
    pub fn curve(&self, units: Units) -> Result<TestedCurve, FieldError> {
        let scale = match self.strain_unit.unwrap_or_default() {
            StrainUnit::One => 1.0,
            StrainUnit::Percent => 1e-2,
            StrainUnit::Micro => 1e-6,
        };
        let record: Vec<[f64; 2]> = self.points.iter().map(|[e, s]| [scale * e, *s]).collect();
        let offset = self.offset.map_or(OFFSET, PositiveF64::get);
        let settings = TestSettings {
            measure: match self.measure.unwrap_or_default() {
                TestMeasure::Engineering => Measure::Engineering,
                TestMeasure::True => Measure::True,
            },
            yield_rule: match self.yield_at.unwrap_or_default() {
                YieldPlace::Offset => YieldRule::Offset(offset),
                YieldPlace::Departure => YieldRule::Departure,
            },
            young_modulus: self.young_modulus.map(PositiveF64::get),
        };
        let words = Words(units);
        if let Some(k) = record.iter().position(|[strain, _]| strain.abs() > LONGEST) {
            let detail = format!(
                "is a strain of {} %: is it in per cent (`strain_unit`)?",
                figure(100.0 * record[k][0])
            );
            return Err(out_of_range(format!("/points/{k}/0"), detail));
        }
        let curve = hardening_curve(&record, settings)
            .map_err(|fault| words.fault(fault, settings.young_modulus))?;
        let most = record.iter().fold(0.0, |most: f64, point| most.max(point[1].abs()));
        let [strain, stress] = record[0];
        if curve.line.straight.is_none() && strain.abs() < 1e-6 && stress.abs() > PLASTIC * most {
            let detail = format!(
                "has {} without strain: is the strain plastic? Then the points are those of a \
                 `table` as they are, with true stress",
                words.stress(stress.abs())
            );
            return Err(FieldError::new("/points/0", detail));
        }
        Ok(words.answer(curve, settings))
    }
}

fn rules(known: &super::fields::Known) -> Vec<FieldError> {
    let departs = known.word("yield_at") == Some(YieldPlace::Departure.name());
    if departs && known.has("offset") {
        return vec![FieldError::new("/offset", "belongs to a yield by `offset`")];
    }
    Vec::new()
}

fn out_of_range(pointer: String, detail: String) -> FieldError {
    FieldError { pointer, code: FaultCode::OutOfRange, detail }
}

/// Sentences in a system of units.
#[derive(Clone, Copy)]
struct Words(Units);

impl Words {
    fn wire(self, stress: f64) -> f64 {
        Domain::SignedStress.to_wire(self.0, stress)
    }

    fn stress(self, stress: f64) -> String {
        format!("{} {}", figure(self.wire(stress)), Domain::Stress.symbol(self.0))
    }

    fn fault(self, fault: TestFault, young_modulus: Option<f64>) -> FieldError {
        let points = |detail: String| FieldError::new("/points", detail);
        match fault {
            TestFault::TooFewPoints => {
                points(format!("must have at least {LEAST_POINTS} points"))
            }
            TestFault::NotFinite(k) => {
                out_of_range(format!("/points/{k}"), "must be finite".to_owned())
            }
            TestFault::NoLengthLeft(k) => out_of_range(
                format!("/points/{k}/0"),
                "is an engineering strain of -1 or less: nothing is left of the specimen".into(),
            ),
            TestFault::OppositeSigns(k) => FieldError::new(
                format!("/points/{k}"),
                "has strain and stress of opposite signs; in compression both are negative",
            ),
            TestFault::Stray(k) => out_of_range(
                format!("/points/{k}/1"),
                "is far from the stress before and after it: it stands for no data".to_owned(),
            ),
            TestFault::NoRise => points("must rise: strain and stress of a test grow".to_owned()),
            TestFault::NoStraightPart => points(
                "has no straight part that could be the elastic one; give `young_modulus` to take \
                 its place"
                    .to_owned(),
            ),
            TestFault::Units { slope, power } => points(format!(
                "rises with {}, which is Young's modulus, {}, over 10^{power}: {}",
                self.stress(slope),
                self.stress(young_modulus.unwrap_or(0.0)),
                match power {
                    2 => "the strain is in per cent; say `\"strain_unit\": \"percent\"`",
                    6 => {
                        "the strain is in parts per million (say `\"strain_unit\": \
                         \"microstrain\"`), or the stress in another unit"
                    }
                    _ => "strain or stress are in another unit",
                }
            )),
            TestFault::Slope(slope) => points(match young_modulus {
                Some(modulus) => format!(
                    "rises with {}, {} times Young's modulus, {}: is it force over a way, is strain \
                     or stress in another unit, or is the test one of another material?",
                    self.stress(slope),
                    figure(slope / modulus),
                    self.stress(modulus),
                ),
                None => format!(
                    "rises with {}, which no solid does: strain or stress are in another unit",
                    self.stress(slope)
                ),
            }),
            TestFault::NoYield { slope, largest } => points(format!(
                "ends before yield: it rises with {} up to {}; points go from the first to the last",
                self.stress(slope),
                self.stress(largest)
            )),
        }
    }

    fn answer(self, curve: TestCurve, settings: TestSettings) -> TestedCurve {
        let remarks = self.remarks(&curve, settings);
        let TestCurve { points, line, yield_stress, fit_error, necking, counts, .. } = curve;
        TestedCurve {
            points: points
                .into_iter()
                .map(|[p, stress]| [rounded(p), rounded(self.wire(stress))])
                .collect(),
            yield_stress: self.wire(yield_stress),
            slope: self.wire(line.slope),
            slope_error: line.slope_error,
            straight: line.straight.map(|ends| ends.map(|stress| self.wire(stress))),
            toe: line.toe,
            necking: necking.map(|[strain, stress]| [strain, self.wire(stress)]),
            fit_rms: self.wire(fit_error[0]),
            fit_largest: self.wire(fit_error[1]),
            fitted: counts.plastic,
            elastic: counts.elastic,
            unloading: counts.set_back,
            beyond_necking: counts.beyond_necking,
            remarks,
        }
    }

    fn remarks(self, curve: &TestCurve, settings: TestSettings) -> Vec<String> {
        let line = &curve.line;
        let mut remarks = Vec::new();
        let slope = self.stress(line.slope);
        remarks.push(match (settings.young_modulus, line.straight) {
            (Some(_), None) => format!(
                "No part of the record is straight: Young's modulus, {slope}, takes the place of \
                 the first slope."
            ),
            (Some(modulus), Some(_)) if (line.slope / modulus - 1.0).abs() > NEAR => format!(
                "The test rises with {slope}; E is {}, {} times that. {}",
                self.stress(modulus),
                figure(modulus / line.slope),
                if line.slope > modulus {
                    "No give of a machine makes a test steeper: are strain and stress those of \
                     this material?"
                } else if (modulus / line.slope / KSI - 1.0).abs() < 0.03 {
                    "That is the factor of ksi: is the stress in ksi?"
                } else {
                    "Plastic strain is what the slope of the test leaves: the give of a machine \
                     that stays the same does no harm."
                },
            ),
            (Some(modulus), Some(_)) => {
                format!("The test rises with {slope}; E is {}.", self.stress(modulus))
            }
            (None, _) => format!("The test rises with {slope}."),
        });
        if settings.young_modulus.is_none() && (400.0..5000.0).contains(&line.slope) {
            remarks.push(
                "That is a hundredth of the modulus of metals: is the strain in per cent?"
                    .to_owned(),
            );
        }
        let is_in_gpa = (IN_GPA.0[0]..IN_GPA.0[1]).contains(&line.slope)
            && curve.yield_stress < IN_GPA.1 * line.slope;
        if settings.young_modulus.is_none() && is_in_gpa {
            remarks.push(
                "That is a thousandth of the modulus of metals: is the stress in GPa?".to_owned(),
            );
        }
        if line.straight.is_some() && line.points < 5 {
            remarks.push(format!("The first slope is that of {} points.", line.points));
        }
        if line.toe.abs() > 1e-5 {
            remarks.push(format!("A toe of {} of strain is removed.", figure(line.toe)));
        }
        if curve.is_compression {
            remarks.push("The test is taken for one in compression.".to_owned());
        }
        let first = curve.points[0][1];
        remarks.push(match settings.yield_rule {
            YieldRule::Offset(offset) => {
                format!("R_p{} is {}.", figure(100.0 * offset), self.stress(curve.yield_stress))
            }
            YieldRule::Departure => {
                format!(
                    "The record leaves its line for good at {}.",
                    self.stress(curve.yield_stress)
                )
            }
        });
        if curve.yield_stress > 1.02 * first {
            remarks.push(format!(
                "The stress drops at yield; the curve, which never falls, starts at {}.",
                self.stress(first)
            ));
        }
        if let Some([strain, stress]) = curve.necking {
            remarks.push(format!(
                "The specimen necks at a strain of {} under {}: {} points beyond are left out.",
                figure(strain),
                self.stress(stress),
                curve.counts.beyond_necking
            ));
        }
        if curve.counts.set_back > 0 {
            remarks.push(format!("{} points of unloading are left out.", curve.counts.set_back));
        }
        remarks.push(format!(
            "{} points beyond yield are fitted by {}, to {} (root mean square) and {} at most.",
            curve.counts.plastic,
            curve.points.len(),
            self.stress(curve.fit_error[0]),
            self.stress(curve.fit_error[1]),
        ));
        remarks
    }
}

/// Returns a figure to seven digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

/// Returns a figure to four digits.
fn figure(value: f64) -> String {
    let digits = format!("{value:.3e}");
    match digits.parse::<f64>() {
        Ok(plain) if plain == 0.0 || (1e-3..1e7).contains(&plain.abs()) => plain.to_string(),
        _ => digits,
    }
}

#[cfg(test)]
#[path = "tensile_tests.rs"]
mod tests;
