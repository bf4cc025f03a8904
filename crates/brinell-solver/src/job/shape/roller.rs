//! The roller: a cylinder of finite length on a half-space. Only in three dimensions.

use std::ops::RangeInclusive;

use strum::{IntoStaticStr, VariantArray};

use super::profile::{Profile, outline_faults};
use crate::job::fields::{Field, Known, NumberKind, record, unless};
use crate::job::{Domain, FieldError, Named, PositiveF64};

record! {
    /// A cylinder of finite length, whose axis is its y: a roller, a rib; only in three
    /// dimensions.
    pub struct Roller("roller", "Roller") where rules {
        /// Radius.
        pub radius: PositiveF64 = Field::quantity(Domain::Length).label("Radius", "R").example(5.0),
        /// Length that can touch, without the rounded ends.
        pub length: PositiveF64 = Field::quantity(Domain::Length).label("Length", "L").example(10.0),
        /// How the surface falls towards the ends: `crowned` in an arc of `crown_radius`,
        /// `logarithmic` by Lundberg for `design_force`, `iso_16281` with the factor of that
        /// standard, `points` as given. If it is left out, the roller is straight.
        pub profile: Option<RollerProfile> = Field::choice::<RollerProfile>("RollerProfile").label("Profile", ""),
        /// Radius of the arc along the axis, for `crowned`.
        pub crown_radius: Option<f64> = Field::quantity(Domain::Length).label("Crown radius", "R_c"),
        /// Force under which a `logarithmic` profile makes the pressure along the roller even.
        pub design_force: Option<f64> = Field::quantity(Domain::Force).label("Design force", "Q"),
        /// Points `[y, height]` for `points`, y rising and passing 0, straight between them.
        /// Points that start or end at y = 0 are completed by their mirror image. Beyond the
        /// outermost ones the height stays.
        pub points: Option<Vec<[f64; 2]>> = Field::points(
            [
                ("y, along the axis from the middle.", NumberKind::Quantity(Domain::Position)),
                ("Height over the cylinder, negative where the surface \
                  falls.", NumberKind::Quantity(Domain::Position)),
            ],
            2..=Profile::MAX_POINTS,
        )
        .label("Points", "y, height"),
        /// Angle of its x from that of the contact plane, in degrees, towards y; 0 if it is left
        /// out.
        pub rotation: Option<f64> = Field::pure(-360.0..=360.0).label("Rotation", "φ"),
        /// Misalignment in the plane of axis and normal, in mrad: positive brings the end at
        /// positive y closer to the other body; 0 if it is left out. The approach is that of the
        /// middle.
        pub tilt: Option<f64> = Field::pure(Roller::tilts()).label("Tilt", "ϑ"),
        /// Moment about its x axis through the middle, in place of `tilt`, which is found then:
        /// positive presses the end at positive y. It is whole from the smallest force of the job
        /// on and in proportion to the force below. Only with forces.
        pub moment: Option<f64> = Field::quantity(Domain::Moment).label("Moment", "M"),
    }
}

/// The profile of a roller towards its ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub enum RollerProfile {
    /// An arc over the whole length.
    Crowned,
    /// Lundberg's logarithmic profile for a design force.
    Logarithmic,
    /// The logarithmic profile of ISO 16281.
    #[strum(serialize = "iso_16281")]
    Iso16281,
    /// Given points.
    Points,
}

impl Named for RollerProfile {}

impl RollerProfile {
    /// Returns the key of the field with the size of this profile.
    const fn measure(self) -> Option<&'static str> {
        match self {
            Self::Crowned => Some("crown_radius"),
            Self::Logarithmic => Some("design_force"),
            Self::Iso16281 => None,
            Self::Points => Some("points"),
        }
    }
}

impl Roller {
    /// Tilts that may be given \[mrad\].
    pub const fn tilts() -> RangeInclusive<f64> {
        -50.0..=50.0
    }

    /// Returns the curvatures along the roller's x and y, positive where convex \[1/mm\].
    pub(super) fn curvatures(&self) -> [f64; 2] {
        let crown = self.crown_radius.filter(|_| self.profile == Some(RollerProfile::Crowned));
        [self.radius.get().recip(), crown.map_or(0.0, f64::recip)]
    }
}

/// Refuses a profile without the field of its size or with the field of another profile, points
/// that do not form an outline, and a tilt beside a moment.
fn rules(known: &Known) -> Vec<FieldError> {
    let profile = known
        .word("profile")
        .and_then(|word| RollerProfile::ALL.iter().find(|one| one.name() == word));
    let wanted = profile.and_then(|profile| profile.measure());
    let mut faults = Vec::new();
    for key in ["crown_radius", "design_force", "points"] {
        let pointer = format!("/{key}");
        if wanted == Some(key) {
            let detail = format!(
                "is needed for the profile `{}`",
                known.word("profile").unwrap_or_default()
            );
            faults.extend(unless(known.has(key), &pointer, &detail));
        } else {
            let owner = RollerProfile::ALL.iter().find(|one| one.measure() == Some(key));
            let detail =
                format!("belongs to the profile `{}`", owner.map_or("", |one| one.name()));
            faults.extend(unless(!known.has(key), &pointer, &detail));
        }
    }
    let is_tilted = known.has("tilt") && known.has("moment");
    faults.extend(unless(!is_tilted, "/moment", "stands in place of `tilt`; give one of them"));
    if wanted == Some("points") {
        let middle = "the middle of the roller";
        let points = known.points("points");
        faults.extend(points.map(|of| outline_faults(of, "y", middle)).unwrap_or_default());
    }
    faults
}

#[cfg(test)]
mod tests {
    use crate::job::{Job, JobError};
    use serde_json::{Value, json};

    fn faults(changes: &Value) -> Vec<String> {
        let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
        let mut job = json!({
            "analysis": "three_dimensional",
            "upper": {"shape": {"type": "roller", "radius": 10, "length": 8}, "material": steel},
            "lower": {"shape": {"type": "flat"}, "material": steel},
            "load": {"force": 100},
        });
        for (key, value) in changes.as_object().unwrap() {
            job["upper"]["shape"][key] = value.clone();
        }
        match Job::from_value(&job) {
            Ok(read) => {
                assert!(read.validate().is_ok());
                Vec::new()
            }
            Err(JobError::Fields(faults)) => faults
                .iter()
                .map(|fault| fault.pointer.trim_start_matches("/upper/shape").to_owned())
                .collect(),
            Err(other) => panic!("{other:?}"),
        }
    }

    #[test]
    fn every_profile_is_a_job() {
        for changes in [
            json!({}),
            json!({"profile": "crowned", "crown_radius": 500}),
            json!({"profile": "logarithmic", "design_force": 4000}),
            json!({"profile": "iso_16281", "rotation": 30, "tilt": -1}),
            json!({"profile": "points", "points": [[0, 0], [3, 0], [4, -0.01]]}),
        ] {
            assert_eq!(faults(&changes), Vec::<String>::new(), "{changes}");
        }
    }

    #[test]
    fn a_profile_has_its_own_figure_and_no_other() {
        assert_eq!(faults(&json!({"profile": "crowned"})), ["/crown_radius"]);
        assert_eq!(
            faults(&json!({"profile": "logarithmic", "crown_radius": 5})),
            ["/crown_radius", "/design_force"]
        );
        assert_eq!(
            faults(&json!({"design_force": 5, "points": [[0, 0], [1, 0]]})),
            ["/design_force", "/points"]
        );
        assert_eq!(faults(&json!({"profile": "crowned", "crown_radius": 0})), ["/crown_radius"]);
        assert_eq!(
            faults(&json!({"profile": "round", "radius": 0, "tilt": 51})),
            ["/profile", "/radius", "/tilt"]
        );
    }

    #[test]
    fn points_rise_and_pass_the_middle() {
        let points = |points: Value| faults(&json!({"profile": "points", "points": points}));
        assert_eq!(points(json!([[1, 0], [1, 0]])), ["/points", "/points/1/0"]);
        assert_eq!(points(json!([[0, 0]])), ["/points"]);
    }
}
