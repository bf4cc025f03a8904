//! A hardness test: the reader writes its indenter and its history of forces.
//!
//! Pyramids are cones of equal area: at every depth the section of the cone is as large as that of
//! the pyramid, `tan ψ = 2 tan 68° / √π` (W. C. Oliver and G. M. Pharr, J. Mater. Res. 7 (1992)
//! 1564).

use strum::{IntoStaticStr, VariantArray};

use super::fields::{Field, Known, read_record_of, record};
use super::reader::Cursor;
use super::{
    Body, Cone, Deformable, Domain, Elastic, FarSupport, FaultCode, FieldError, Material,
    MeshSettings, Named, PoissonRatio, PositiveF64, Profile, SolverSettings, Units,
};

/// Standard gravity \[N/kgf\].
const NEWTONS: f64 = 9.80665;
/// Angle of the cone of equal area to the surface \[degrees\], of Vickers and Berkovich.
const PYRAMID: f64 = 90.0 - 70.3;
/// Tip radii of pyramids unless given \[mm\].
const VICKERS_TIP: f64 = 5e-4;
const BERKOVICH_TIP: f64 = 1e-4;
/// The sphero-conical indenter of Rockwell C: angle to the surface \[degrees\], radius \[mm\].
const ROCKWELL_CONE: f64 = 30.0;
const ROCKWELL_TIP: f64 = 0.2;
/// The ball of Rockwell B \[mm\].
const ROCKWELL_BALL: f64 = 1.5875;
/// Forces of Rockwell tests \[N\]: the preliminary one, the total of C and of B.
const PRELIMINARY: f64 = 98.07;
const TOTAL_C: f64 = 1471.0;
const TOTAL_B: f64 = 980.7;
/// Balls of ISO 6506-1 \[mm\] and its force over the square of the ball \[kgf/mm²\].
const BALLS: [f64; 4] = [10.0, 5.0, 2.5, 1.0];
const RATIOS: [f64; 6] = [30.0, 15.0, 10.0, 5.0, 2.5, 1.0];
/// Increments of each load unless given, and the least: the diameter follows from those of the last
/// three quarters of the force.
const INCREMENTS: u32 = 32;
pub(super) const LEAST_INCREMENTS: u32 = 8;
/// Why a hold is refused.
const NO_HOLD: &str = "no law here knows of time, so that nothing creeps in a hold: leave it out";

/// Elements over the radius of the contact, which leave some 1 % of error in a number.
const ELEMENTS: u32 = 24;

/// A scale of hardness.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub enum TestScale {
    /// Brinell with a ball of tungsten carbide.
    #[strum(serialize = "HBW")]
    Hbw,
    /// Vickers, by the cone of equal area.
    #[strum(serialize = "HV")]
    Hv,
    /// Berkovich, by the cone of equal area.
    Berkovich,
    /// Rockwell C.
    #[strum(serialize = "HRC")]
    Hrc,
    /// Rockwell B.
    #[strum(serialize = "HRB")]
    Hrb,
    /// A sphere of diamond and what an instrument reads.
    Sphere,
}

impl Named for TestScale {}

impl TestScale {
    /// Whether the depth under the preliminary force is the answer.
    pub const fn is_rockwell(self) -> bool {
        matches!(self, Self::Hrc | Self::Hrb)
    }

    const fn takes_ball(self) -> bool {
        matches!(self, Self::Hbw | Self::Sphere)
    }

    const fn takes_tip(self) -> bool {
        matches!(self, Self::Hv | Self::Berkovich)
    }
}

record! {
    /// A hardness test of the lower body. It brings its indenter, so that there is no `upper`.
    #[derive(Copy)]
    pub struct HardnessTest("", "Hardness test") where rules {
        /// Scale: `HBW`, `HV`, `HRC` and `HRB` by ISO 6506, 6507 and 6508; `berkovich` and
        /// `sphere` for instrumented indentation.
        pub scale: TestScale = Field::choice::<TestScale>("TestScale").label("Scale", ""),
        /// Diameter of the ball of `HBW` (10, 5, 2.5 or 1 mm) or `sphere`.
        pub ball: Option<PositiveF64> = Field::quantity(Domain::Length).label("Ball", "D").example(10.0),
        /// Force in kgf of 9.80665 N, as scales name it.
        pub force_kgf: Option<PositiveF64> = Field::pure(1e-9..=3000.0).label("Force", "F").example(3000.0),
        /// Force, in place of `force_kgf`.
        pub force: Option<PositiveF64> = Field::quantity(Domain::Force).label("Force", "F").example(29420.0),
        /// Radius of the tip of `HV`, 0.5 µm unless given, or `berkovich`, 0.1 µm.
        pub tip_radius: Option<PositiveF64> = Field::quantity(Domain::Length).label("Tip radius", "ρ").example(0.0005),
        /// Young's modulus of the indenter: 600 GPa of tungsten carbide for `HBW` and `HRB`, 1141
        /// GPa of diamond for all others, unless given.
        pub indenter_young_modulus: Option<PositiveF64> = Field::quantity(Domain::Modulus).label("Young’s modulus of the indenter", "E_i").example(600_000.0),
        /// Poisson's ratio of the indenter: 0.21 of tungsten carbide, 0.07 of diamond.
        pub indenter_poisson_ratio: Option<PoissonRatio> = Field::pure(PoissonRatio::RANGE).label("Poisson’s ratio of the indenter", "ν_i").example(0.21),
    }
}

/// The conditions of the scales on ball, force and tip.
fn rules(known: &Known) -> Vec<FieldError> {
    let named = TestScale::ALL.iter().find(|scale| known.word("scale") == Some(scale.name()));
    let Some(&scale) = named else { return Vec::new() };
    let mut faults = Vec::new();
    let mut fault = |key: &str, code: FaultCode, detail: String| {
        faults.push(FieldError { pointer: format!("/{key}"), code, detail });
    };
    let name = scale.name();
    for (key, is_taken) in [
        ("ball", scale.takes_ball()),
        ("force_kgf", !scale.is_rockwell()),
        ("force", !scale.is_rockwell()),
        ("tip_radius", scale.takes_tip()),
    ] {
        if known.has(key) && !is_taken {
            let detail = format!("the scale {name} has its own");
            fault(key, FaultCode::Inconsistent, detail);
        }
    }
    if scale.takes_ball() && !known.has("ball") {
        fault("ball", FaultCode::Required, "is required".to_owned());
    }
    if !scale.is_rockwell() {
        match (known.has("force_kgf"), known.has("force")) {
            (false, false) => {
                fault("force_kgf", FaultCode::Required, "is required, or `force`".to_owned());
            }
            (true, true) => {
                fault("force", FaultCode::Inconsistent, "is given by `force_kgf`".to_owned());
            }
            _ => {}
        }
    }
    if known.has("indenter_young_modulus") != known.has("indenter_poisson_ratio") {
        let key = "indenter_poisson_ratio";
        fault(key, FaultCode::Inconsistent, "goes with `indenter_young_modulus`".to_owned());
    }
    if scale == TestScale::Hbw
        && let Some(ball) = known.figure("ball")
    {
        let is_near = |a: f64, b: f64| (a / b - 1.0).abs() < 0.01;
        let force = known.figure("force_kgf");
        let force = force.or_else(|| known.figure("force").map(|force| force / NEWTONS));
        if !BALLS.iter().any(|known| is_near(ball, *known)) {
            let detail = "ISO 6506 knows balls of 10, 5, 2.5 and 1 mm".to_owned();
            fault("ball", FaultCode::OutOfRange, detail);
        } else if let Some(force) = force
            && !RATIOS.iter().any(|known| is_near(force / (ball * ball), *known))
        {
            let key = if known.has("force_kgf") { "force_kgf" } else { "force" };
            let detail = "0.102 F/D² of ISO 6506 is 30, 15, 10, 5, 2.5 or 1: with a ball of 10 \
                          mm forces of 3000, 1500, 1000, 500, 250 and 100 kgf"
                .to_owned();
            fault(key, FaultCode::OutOfRange, detail);
        }
    }
    faults
}

impl HardnessTest {
    /// The key of this load.
    pub const KEY: &'static str = "hardness";
    const HOLD: &'static str = "hold";

    /// Reads a test, or its name: `"HBW 10/3000"`, `"HV 10"`, `"HRC"`.
    pub(super) fn read(cursor: Cursor<'_>, units: Option<Units>) -> Option<Self> {
        if !cursor.is_object() {
            let text = cursor.text_or("a hardness test, by its name or as an object")?;
            let Some(test) = Self::named(text) else {
                let is_held = text.rsplit_once('/').is_some_and(|(name, hold)| {
                    hold.parse::<f64>().is_ok() && Self::named(name).is_some()
                });
                if is_held {
                    cursor.fault(FaultCode::Inconsistent, format_args!("{NO_HOLD}"));
                } else {
                    let detail = "must name a test: HBW 10/3000, HV 10, HRC or HRB";
                    cursor.fault(FaultCode::UnknownWord, format_args!("{detail}"));
                }
                return None;
            };
            let faults = super::fields::faults_of(&test, &[]);
            let detail = faults.first().map(|fault| fault.detail.clone());
            return match detail {
                None => Some(test),
                Some(detail) => {
                    cursor.fault(FaultCode::OutOfRange, format_args!("{detail}"));
                    None
                }
            };
        }
        let object = cursor.object()?;
        let hold: &[&'static str] = if object.has(Self::HOLD) { &[Self::HOLD] } else { &[] };
        if !hold.is_empty() {
            object.fault(Self::HOLD, FaultCode::Inconsistent, format_args!("{NO_HOLD}"));
        }
        read_record_of(&object, None, hold, units, None, &[])
    }

    fn named(text: &str) -> Option<Self> {
        let (scale, rest) = text.split_once(' ').unwrap_or((text, ""));
        let scale = TestScale::ALL.iter().copied().find(|known| known.name() == scale)?;
        let number = |text: &str| text.parse().ok().and_then(|value| PositiveF64::new(value).ok());
        let (ball, force_kgf) = match scale {
            TestScale::Hbw => {
                let (ball, force) = rest.split_once('/')?;
                (Some(number(ball)?), Some(number(force)?))
            }
            TestScale::Hv => (None, Some(number(rest)?)),
            TestScale::Hrc | TestScale::Hrb if rest.is_empty() => (None, None),
            _ => return None,
        };
        Some(Self {
            scale,
            ball,
            force_kgf,
            force: None,
            tip_radius: None,
            indenter_young_modulus: None,
            indenter_poisson_ratio: None,
        })
    }

    /// Returns the name of the test, `HBW 10/3000`.
    pub fn name(&self) -> String {
        let scale = self.scale.name();
        let force = rounded(self.force() / NEWTONS);
        match self.scale {
            TestScale::Hbw => format!("{scale} {}/{force}", rounded(2.0 * self.radius())),
            TestScale::Hv => format!("{scale} {force}"),
            _ => scale.to_owned(),
        }
    }

    /// Returns the largest force \[N\].
    pub fn force(&self) -> f64 {
        match self.scale {
            TestScale::Hrc => TOTAL_C,
            TestScale::Hrb => TOTAL_B,
            _ => {
                let by_kgf = self.force_kgf.map(|force| force.get() * NEWTONS);
                by_kgf.or(self.force.map(f64::from)).unwrap_or_default()
            }
        }
    }

    /// Returns the radius of the ball, or of the tip \[mm\].
    pub fn radius(&self) -> f64 {
        let of = |given: Option<PositiveF64>, default: f64| given.map_or(default, f64::from);
        match self.scale {
            TestScale::Hbw | TestScale::Sphere => 0.5 * of(self.ball, 0.0),
            TestScale::Hrb => 0.5 * ROCKWELL_BALL,
            TestScale::Hv => of(self.tip_radius, VICKERS_TIP),
            TestScale::Berkovich => of(self.tip_radius, BERKOVICH_TIP),
            TestScale::Hrc => ROCKWELL_TIP,
        }
    }

    /// Returns the slope of a cone to the surface; `None` for a ball.
    pub fn slope(&self) -> Option<f64> {
        Some(self.angle()?.to_radians().tan())
    }

    fn angle(&self) -> Option<f64> {
        match self.scale {
            TestScale::Hv | TestScale::Berkovich => Some(PYRAMID),
            TestScale::Hrc => Some(ROCKWELL_CONE),
            TestScale::Hbw | TestScale::Hrb | TestScale::Sphere => None,
        }
    }

    /// Returns the elastic constants of the indenter.
    pub fn elastic(&self) -> Option<Elastic> {
        let (modulus, ratio) = match self.scale {
            TestScale::Hbw | TestScale::Hrb => (600_000.0, 0.21),
            _ => (1_141_000.0, 0.07),
        };
        let young_modulus = self.indenter_young_modulus.or(PositiveF64::new(modulus).ok())?;
        let poisson_ratio = self.indenter_poisson_ratio.or(PoissonRatio::new(ratio).ok())?;
        Some(Elastic { young_modulus, poisson_ratio })
    }

    /// Returns the forces of the test, one after the other.
    pub(super) fn forces(&self) -> Vec<f64> {
        if self.scale.is_rockwell() {
            vec![PRELIMINARY, self.force(), PRELIMINARY, 0.0]
        } else {
            vec![self.force(), 0.0]
        }
    }

    /// Returns the indenter for a specimen of this material.
    pub(super) fn indenter(&self, specimen: &Material) -> Option<Body> {
        let material = Deformable::new(self.elastic()?, None);
        let length = |value: f64| PositiveF64::new(value).ok();
        let shape = match self.angle() {
            None => ball(self.radius())?.into(),
            Some(angle) => {
                let half = match self.scale {
                    TestScale::Hrc => 10.0 * ROCKWELL_TIP,
                    _ => 20.0 * self.expected_radius(specimen).max(self.radius()),
                };
                let (angle, tip_radius) = (length(angle)?, Some(length(self.radius())?));
                let width = length(2.0 * half)?;
                Cone { angle, tip_radius, width, depth: width }.into()
            }
        };
        Some(Body {
            shape,
            material: Material::Deformable(material),
            material_name: None,
            support: FarSupport::default(),
            surface: None,
        })
    }

    /// Radius of the contact of a cone, for the size of the indenter \[mm\]: Tabor's pressure at
    /// his 8 % of strain, at most that of an elastic body.
    fn expected_radius(&self, specimen: &Material) -> f64 {
        let (Material::Deformable(specimen), Some(indenter)) = (specimen, self.elastic()) else {
            return 0.0;
        };
        let compliance =
            1.0 / specimen.elastic.plane_strain_modulus() + 1.0 / indenter.plane_strain_modulus();
        let elastic = 0.5 * self.slope().unwrap_or_default() / compliance;
        let plastic = specimen.hardening_law().map(|law| 2.8 * law.stress(0.08));
        let pressure = plastic.map_or(elastic, |plastic| plastic.min(elastic));
        (self.force() / (std::f64::consts::PI * pressure)).sqrt()
    }
}

/// Returns a number as scales write it.
fn rounded(value: f64) -> String {
    format!("{}", (1e4 * value).round() / 1e4)
}

/// Largest sine of the slope of a ball: the face goes on straight, which no test reaches, so that
/// the meshed face is wide enough for the contact.
const STEEPEST: f64 = 0.8;
const POINTS: u32 = 33;

/// A ball as a profile, to `STEEPEST` of its radius and then straight to twice the radius.
fn ball(radius: f64) -> Option<Profile> {
    let arc = |k: u32| {
        let x = radius * (STEEPEST.asin() * f64::from(k) / f64::from(POINTS - 1)).sin();
        [x, (radius * radius - x * x).sqrt() - radius]
    };
    let mut points: Vec<_> = (0..POINTS).map(arc).collect();
    let slope = STEEPEST / (1.0 - STEEPEST * STEEPEST).sqrt();
    let [mut x, mut height] = *points.last()?;
    let mut step = 0.03 * radius;
    while x < 2.0 * radius {
        (x, height) = (x + step, height - slope * step);
        step *= 1.3;
        points.push([x, height]);
    }
    let depth = PositiveF64::new(4.0 * radius).ok()?;
    Some(Profile { points, depth, interpolation: None })
}

/// Settings of the solver for a test that gives none.
pub(super) fn settings() -> SolverSettings {
    SolverSettings { increments: Some(INCREMENTS), ..SolverSettings::default() }
}

/// Mesh of a test that gives none.
pub(super) fn mesh() -> MeshSettings {
    MeshSettings::default().with_elements(ELEMENTS)
}
