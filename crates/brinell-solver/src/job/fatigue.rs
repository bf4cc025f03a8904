//! Limits of high-cycle fatigue.

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::fields::{Field, InUnits, Known, read_record, record};
use super::over_depth::OverDepth;
use super::reader::Cursor;
use super::{Domain, FaultCode, FieldError, PositiveF64, Units};
use crate::material::fatigue::{FatigueStrength, Limits};

/// Limits of high-cycle fatigue of a material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FatigueLimits {
    /// As tests have them.
    Given(GivenLimits),
    /// By [`BENDING_OF_HARDNESS`] from the hardness over depth: `{"from_hardness": true}`.
    FromHardness,
}

record! {
    /// Limits of high-cycle fatigue, which are the same at all depths: amplitudes of stress at a
    /// stress ratio of -1 that a polished specimen bears without end.
    #[derive(Copy)]
    pub struct GivenLimits("", "Fatigue limits") where rules {
        /// Limit in torsion, of the shear stress.
        pub torsion: PositiveF64 = Field::quantity(Domain::Stress).label("Fatigue limit in torsion", "t_w").example(480.0),
        /// Limit in bending; the limit in torsion lies between a half of it and itself.
        pub bending: PositiveF64 = Field::quantity(Domain::Stress).label("Fatigue limit in bending", "f_w").example(800.0),
    }
}

/// The limit in bending as a function of the hardness, a regression over steels of up to 400 HV,
/// with ± 0.1 HV; beyond it inclusions decide, and the limit rises no more.
///
/// # Reference
/// Y. Murakami, *Metal Fatigue: Effects of Small Defects and Nonmetallic Inclusions* (2002).
pub const BENDING_OF_HARDNESS: &str = "f_w = 1.6 HV up to 400 HV, t_w = f_w/√3 (Murakami 2002)";

impl FatigueLimits {
    /// The key of the limits in a material.
    pub const KEY: &'static str = "fatigue";
    /// The key of limits from the hardness.
    pub(super) const FROM_HARDNESS: &'static str = "from_hardness";

    /// Returns the strength of a material with this hardness; `None` where it follows from a hardness
    /// that the job does not give.
    pub fn strength(&self, over_depth: Option<&OverDepth>) -> Option<FatigueStrength> {
        match self {
            Self::Given(GivenLimits { torsion, bending }) => {
                let limits = Limits { torsion: torsion.get(), bending: bending.get() };
                Some(FatigueStrength::new(limits))
            }
            Self::FromHardness => FatigueStrength::of_hardness(&over_depth?.vickers()?),
        }
    }

    /// Returns the fault of limits from a hardness that the job does not give.
    pub(super) fn fault(&self, over_depth: Option<&OverDepth>) -> Option<FieldError> {
        self.strength(over_depth).is_none().then(|| FieldError {
            pointer: format!("/{}", Self::FROM_HARDNESS),
            code: FaultCode::Inconsistent,
            detail:
                "needs the hardness over depth, `over_depth` of `plasticity` with `hardness`; \
                     or give `torsion` and `bending`"
                    .to_owned(),
        })
    }

    pub(super) fn read(cursor: Cursor<'_>, units: Option<Units>) -> Option<Self> {
        let object = cursor.object()?;
        if !object.has(Self::FROM_HARDNESS) {
            return read_record(&object, None, units, None, &[]).map(Self::Given);
        }
        object.only(&[Self::FROM_HARDNESS]);
        let is_so = object.required(Self::FROM_HARDNESS, |c| c.boolean())?;
        if !is_so {
            object.fault(
                Self::FROM_HARDNESS,
                FaultCode::OutOfRange,
                format_args!("must be true, or left out beside `torsion` and `bending`"),
            );
        }
        is_so.then_some(Self::FromHardness)
    }
}

fn rules(known: &Known) -> Vec<FieldError> {
    let figures = known.figure("torsion").zip(known.figure("bending"));
    let is_wrong = figures.is_some_and(|(t, f)| !(0.5 * f..=f).contains(&t));
    is_wrong
        .then(|| FieldError {
            pointer: "/torsion".to_owned(),
            code: FaultCode::Inconsistent,
            detail:
                "must lie between a half of `bending` and `bending`: Dang Van's criterion holds \
                     for no other metal; steels have about 0.6"
                    .to_owned(),
        })
        .into_iter()
        .collect()
}

impl Serialize for InUnits<'_, FatigueLimits> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            FatigueLimits::Given(limits) => InUnits(limits, self.1).serialize(serializer),
            FatigueLimits::FromHardness => {
                let mut map = serializer.serialize_map(Some(1))?;
                map.serialize_entry(FatigueLimits::FROM_HARDNESS, &true)?;
                map.end()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::super::{Job, Material};
    use super::*;
    use crate::material::Solid;

    fn job(fatigue: &Value, over_depth: &Value) -> Value {
        json!({
            "analysis": "plane_strain", "load": {"force": 100},
            "upper": {"shape": {"type": "cylinder", "radius": 10}, "material": {"rigid": true}},
            "lower": {
                "shape": {"type": "block", "width": 20, "depth": 20},
                "material": {
                    "young_modulus": 210_000, "poisson_ratio": 0.3, "fatigue": fatigue,
                    "plasticity": {
                        "law": "bilinear", "yield_stress": 900, "tangent_modulus": 2100,
                        "over_depth": over_depth,
                    },
                },
            },
        })
    }

    fn case() -> Value {
        json!({"hardness": {"profile": [[0, 700], [1, 400], [2, 300]]}})
    }

    fn refused(fatigue: &Value, over_depth: &Value) -> String {
        format!("{:?}", Job::from_value(&job(fatigue, over_depth)).unwrap_err())
    }

    fn strength(job: &Value) -> FatigueStrength {
        let job = Job::from_value(job).unwrap();
        let Material::Deformable(material) = &job.lower.material else { panic!("it deforms") };
        Solid::from(material).fatigue().unwrap().clone()
    }

    #[test]
    fn limits_are_given_or_follow_from_hardness() {
        let given = strength(&job(&json!({"torsion": 480, "bending": 800}), &case()));
        assert_eq!(given.limits(), Limits { torsion: 480.0, bending: 800.0 });
        assert!((given.torsion(5.0) - 480.0).abs() < 1e-12);
        let of_case = strength(&job(&json!({"from_hardness": true}), &case()));
        assert!((of_case.limits().bending - 640.0).abs() < 1e-9);
        assert!((of_case.torsion(1.5) - 1.6 * 350.0 / 3f64.sqrt()).abs() < 1e-9);
        let hardened = json!({"hardness": {
            "surface": 60, "core": 30, "case_depth": 1, "hardness_scale": "HRC",
        }});
        let of_drawing = strength(&job(&json!({"from_hardness": true}), &hardened));
        assert!(of_drawing.torsion(9.0) < of_drawing.torsion(0.0));
        let mut in_si = job(&json!({"torsion": 480e6, "bending": 800e6}), &Value::Null);
        in_si["units"] = json!("SI");
        in_si["lower"]["material"]["young_modulus"] = json!(210e9);
        in_si["lower"]["material"]["plasticity"] = Value::Null;
        for (pointer, meters) in [
            ("/upper/shape/radius", 0.01),
            ("/lower/shape/width", 0.02),
            ("/lower/shape/depth", 0.02),
        ] {
            *in_si.pointer_mut(pointer).unwrap() = json!(meters);
        }
        let Limits { torsion, bending } = strength(&in_si).limits();
        assert!((torsion - 480.0).abs() < 1e-9 && (bending - 800.0).abs() < 1e-9);
    }

    #[test]
    fn a_job_with_limits_is_written_as_it_was_read() {
        for fatigue in
            [json!({"torsion": 480.0, "bending": 800.0}), json!({"from_hardness": true})]
        {
            let read = Job::from_value(&job(&fatigue, &case())).unwrap();
            let written = serde_json::to_value(&read).unwrap();
            assert_eq!(written["lower"]["material"]["fatigue"], fatigue);
            assert_eq!(Job::from_value(&written).unwrap(), read);
        }
        let none = serde_json::to_value(Job::from_value(&job(&Value::Null, &case())).unwrap());
        assert!(none.unwrap()["lower"]["material"].get("fatigue").is_none());
    }

    #[test]
    fn limits_that_no_criterion_takes_are_refused() {
        let at = "/lower/material/fatigue";
        for (fatigue, pointer) in [
            (json!({"torsion": 390, "bending": 800}), "/torsion"),
            (json!({"torsion": 810, "bending": 800}), "/torsion"),
            (json!({"torsion": 480}), "/bending"),
            (json!({"from_hardness": false}), "/from_hardness"),
            (json!({"from_hardness": true, "torsion": 480}), "/torsion"),
        ] {
            let message = refused(&fatigue, &case());
            assert!(message.contains(&format!("{at}{pointer}")), "{message}");
        }
        for over_depth in [Value::Null, json!([[0, 1.2], [1, 1.0]])] {
            let message = refused(&json!({"from_hardness": true}), &over_depth);
            assert!(message.contains(&format!("{at}/from_hardness")), "{message}");
            assert!(message.contains("needs the hardness over depth"), "{message}");
        }
        let mut rigid = job(&Value::Null, &Value::Null);
        rigid["upper"]["material"]["fatigue"] = json!({"torsion": 480, "bending": 800});
        let message = format!("{:?}", Job::from_value(&rigid).unwrap_err());
        assert!(message.contains("/upper/material/fatigue"), "{message}");
    }
}
