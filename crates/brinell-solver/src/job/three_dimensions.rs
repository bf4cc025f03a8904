//! The limits of jobs with half-spaces in three dimensions.

use super::reader::Node;
use super::reader::text::five_digits;
use super::{
    Analysis, Body, ContactMethod, Coupling, Domain, FieldError, Job, Load, MeshSettings, Shape,
    Surface, TargetFigure,
};

/// Least ratio of the smaller to the larger curvature of the gap. Below it the contact is a line
/// contact.
const LEAST_CURVATURE_RATIO: f64 = 1e-4;
/// Sine of the largest angle between two axes that count as parallel.
const ALIGNED: f64 = 1e-9;

impl Job {
    /// Returns the faults of a job that half-spaces cannot solve, and of half-spaces in a plane
    /// analysis.
    pub(super) fn faults_of_three_dimensions(&self, document: &Node) -> Vec<FieldError> {
        let is_three_dimensional = self.analysis == Analysis::ThreeDimensional;
        let mut faults = self.faults_of_shapes_of(is_three_dimensional);
        faults.extend(self.faults_of_heights(is_three_dimensional));
        if !is_three_dimensional {
            return faults;
        }
        if faults.is_empty() && !self.has_heights() {
            faults.extend(self.faults_of_gap());
            faults.extend(self.faults_of_moments());
            faults.extend(self.faults_of_half_width());
        }
        let most = MeshSettings::MAX_CELLS_PER_SEMI_AXIS;
        if self.mesh.elements_per_half_width > most {
            let least = MeshSettings::MIN_ELEMENTS_PER_HALF_WIDTH;
            let detail = format!(
                "must be between {least} and {most} cells over a semi-axis in three dimensions"
            );
            faults.push(FieldError::new("/mesh/elements_per_half_width", detail));
        }
        let supports = ["/upper/support", "/lower/support"];
        let given = supports
            .into_iter()
            .filter(|at| document.at(at).is_some_and(|node| *node != Node::Null));
        faults.extend(given.map(|pointer| {
            let detail = "a half-space in three dimensions has no far boundary that could be \
                          held; leave `support` out";
            FieldError::new(pointer, detail)
        }));
        if self.solver.coupling == Coupling::SecantStiffness {
            let detail = "half-spaces have no stiffness that could take secant moduli; take \
                          `accelerated`, `strong` or `weak`";
            faults.push(FieldError::new("/solver/coupling", detail));
        }
        if self.solver.contact == ContactMethod::Simplex {
            let detail = "the simplex needs the flexibility as a matrix, which half-spaces do not \
                          have; take `active_set`";
            faults.push(FieldError::new("/solver/contact", detail));
        }
        faults
    }

    /// Refuses sections of bodies in three dimensions, and half-spaces in all other analyses.
    fn faults_of_shapes_of(&self, is_three_dimensional: bool) -> Vec<FieldError> {
        let sides = [("upper", &self.upper), ("lower", &self.lower)];
        let is_ball_of_revolution = |shape: &Shape| {
            self.analysis == Analysis::Axisymmetric && matches!(shape, Shape::Sphere(_))
        };
        let misplaced = sides.into_iter().filter(|(_, body)| {
            body.shape.curvatures().is_some() != is_three_dimensional
                && !is_ball_of_revolution(&body.shape)
        });
        misplaced
            .map(|(side, body)| {
                let word = body.shape.table().word;
                let detail = if is_three_dimensional {
                    format!(
                        "\"{word}\" is a section of a body; in three dimensions take \
                             \"sphere\", \"curved\", \"roller\" or \"flat\""
                    )
                } else if matches!(body.shape, Shape::Sphere(_)) {
                    "\"sphere\" needs the analysis \"axisymmetric\" or \"three_dimensional\"; \
                     the plane body is a \"cylinder\""
                        .to_owned()
                } else {
                    format!("\"{word}\" needs the analysis \"three_dimensional\"")
                };
                FieldError::new(format!("/{side}/shape/type"), detail)
            })
            .collect()
    }

    /// Whether a body has heights on top of its shape.
    pub fn has_heights(&self) -> bool {
        self.upper.surface.is_some() || self.lower.surface.is_some()
    }

    /// Refuses heights on rollers and on bodies that are not half-spaces, heights of two bodies at
    /// different points, and a sought force or an accuracy between heights.
    fn faults_of_heights(&self, is_three_dimensional: bool) -> Vec<FieldError> {
        let bodies = [("/upper/surface", &self.upper), ("/lower/surface", &self.lower)];
        let given = || bodies.iter().filter(|(_, body)| body.surface.is_some());
        let is_roller = bodies.iter().any(|(_, body)| matches!(body.shape, Shape::Roller(_)));
        let detail = match (is_three_dimensional, is_roller) {
            (false, _) => Some("belongs to the analysis \"three_dimensional\""),
            (true, true) => Some(
                "does not go with a roller, whose length is not that of the heights; take \
                 \"curved\"",
            ),
            (true, false) => None,
        };
        let mut faults: Vec<_> = detail
            .iter()
            .flat_map(|detail| given().map(|(at, _)| FieldError::new(*at, *detail)))
            .collect();
        let most = Surface::MAX_CELLS_OF_YIELD;
        let is_large = |body: &Body| {
            body.surface.as_ref().is_some_and(|surface| surface.cells().iter().any(|n| *n > most))
        };
        let large = given().filter(|(_, body)| self.has_plasticity() && is_large(body));
        faults.extend(large.map(|(at, _)| {
            let detail = format!(
                "must have at most {most} heights along a side where a body yields, and {} of \
                 elastic bodies: thin them, or leave `plasticity` out",
                Surface::MAX_CELLS
            );
            FieldError::new(format!("{at}/heights"), detail)
        }));
        if let (Some(upper), Some(lower)) = (&self.upper.surface, &self.lower.surface)
            && !upper.has_cells_of(lower)
        {
            let detail =
                "must have as many cells, of the same sides, as the surface of the other body";
            faults.extend(given().map(|(at, _)| FieldError::new(*at, detail)));
        }
        if self.has_heights() && matches!(self.load, Load::Onset | Load::Target(_)) {
            let detail =
                "is not sought between surfaces with heights; take a force or an approach";
            faults.push(FieldError::new(format!("/load/{}", self.load.kind()), detail));
        }
        if self.has_heights() && self.mesh.accuracy.is_some() {
            let detail = "needs finer cells, and those of heights are given";
            faults.push(FieldError::new("/mesh/accuracy", detail));
        }
        faults
    }

    /// Refuses moments on two rollers, without given forces, or beyond the limit of the contact.
    fn faults_of_moments(&self) -> Vec<FieldError> {
        let pointers = ["/upper/shape/moment", "/lower/shape/moment"].into_iter();
        let moments = self.bodies().map(|body| match &body.shape {
            Shape::Roller(roller) => roller.moment,
            _ => None,
        });
        let given: Vec<_> = pointers.zip(moments).filter_map(|(at, of)| Some((at, of?))).collect();
        let (Some((_, moment)), Some(half_length)) = (given.first(), self.half_length()) else {
            return Vec::new();
        };
        let detail = match self.load.least_force() {
            _ if given.len() > 1 => {
                "belongs to one of the bodies: the other one holds against it".to_owned()
            }
            None => format!(
                "goes with forces that are given, not with `{}`: give the `tilt`",
                self.load.kind()
            ),
            Some(force) if moment.abs() >= force * half_length => format!(
                "must be smaller than the smallest force times half the length of the roller, {} \
                 {}, beyond which no pressure balances it",
                five_digits(Domain::Moment.to_wire(self.units, force * half_length)),
                Domain::Moment.symbol(self.units)
            ),
            Some(_) => return Vec::new(),
        };
        given.into_iter().map(|(pointer, _)| FieldError::new(pointer, detail.clone())).collect()
    }

    /// Returns half the largest contact length that the rollers allow; `None` without a roller.
    fn half_length(&self) -> Option<f64> {
        let of = |body: &Body| match &body.shape {
            Shape::Roller(roller) => Some(0.5 * roller.length.get()),
            _ => None,
        };
        [of(&self.upper), of(&self.lower)].into_iter().flatten().reduce(f64::min)
    }

    /// Refuses a sought half-width beyond half the length of a roller: the half-width is the
    /// shorter semi-axis.
    fn faults_of_half_width(&self) -> Option<FieldError> {
        let (Load::Target(target), Some(most)) = (&self.load, self.half_length()) else {
            return None;
        };
        if target.figure != TargetFigure::HalfWidth || target.value.get() < most {
            return None;
        }
        let detail = format!(
            "must be below half the length of the roller, {} {}: the half-width is the shorter \
             semi-axis of the contact",
            five_digits(Domain::Length.to_wire(self.units, most)),
            Domain::Length.symbol(self.units)
        );
        Some(FieldError::new("/load/target/half_width", detail))
    }

    /// Refuses a contact without end: the gap must open in every direction, unless a roller has an
    /// end there.
    fn faults_of_gap(&self) -> Vec<FieldError> {
        let Some([least, greatest]) = self.gap_curvatures() else { return Vec::new() };
        let ends = self.bodies().iter().any(|body| matches!(body.shape, Shape::Roller(_)));
        let needed = if ends { -LEAST_CURVATURE_RATIO } else { LEAST_CURVATURE_RATIO };
        if greatest > 0.0 && least >= needed * greatest {
            return self.faults_of_rollers();
        }
        let detail = if greatest <= 0.0 || least < -LEAST_CURVATURE_RATIO * greatest {
            "the surfaces do not open away from where they touch: in each direction the concave \
             body needs the larger radius"
        } else {
            "the contact would have no end, or nearly none, in the direction in which both \
             surfaces are straight or fit each other: solve it as \"plane_strain\", give a body a \
             radius there, or make it a \"roller\""
        };
        ["/upper/shape", "/lower/shape"].map(|pointer| FieldError::new(pointer, detail)).to_vec()
    }

    /// Refuses rollers that do not lie along the contact, because only their ends limit it.
    fn faults_of_rollers(&self) -> Vec<FieldError> {
        let orientation = self.gap_orientation().unwrap_or(0.0);
        let lies_across = |body: &Body| match &body.shape {
            Shape::Roller(roller) => {
                let angle = roller.rotation.unwrap_or(0.0) - orientation;
                angle.to_radians().sin().abs() > ALIGNED
            }
            _ => false,
        };
        let bodies = [("/upper/shape", &self.upper), ("/lower/shape", &self.lower)];
        let across = bodies.into_iter().filter(|(_, body)| lies_across(body));
        let detail = "the roller does not lie along the longer axis of the contact: turn it by \
                      `rotation` until it does, or take \"curved\" where the contact stays away \
                      from its ends";
        across.map(|(pointer, _)| FieldError::new(pointer, detail)).collect()
    }

    /// Returns the principal curvatures of the gap between two half-spaces, the smaller one first
    /// \[1/mm\]; `None` for other shapes.
    pub fn gap_curvatures(&self) -> Option<[f64; 2]> {
        let [xx, yy, xy] = self.gap_curvature()?;
        let (mean, spread) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
        Some([mean - spread, mean + spread])
    }

    /// Returns the direction in which the gap grows fastest and the contact is shortest, as the
    /// angle from x towards y in degrees, above -90 and at most 90; 0 for a round gap, `None` for
    /// other shapes.
    pub fn gap_orientation(&self) -> Option<f64> {
        let [xx, yy, xy] = self.gap_curvature()?;
        let is_round = (0.5 * (xx - yy)).hypot(xy) <= 1e-12 * (xx + yy).abs();
        Some(if is_round { 0.0 } else { 0.5 * (2.0 * xy).atan2(xx - yy).to_degrees() })
    }

    /// Returns the curvatures `[k_xx, k_yy, k_xy]` of the gap between two half-spaces.
    fn gap_curvature(&self) -> Option<[f64; 3]> {
        let (upper, lower) = (self.upper.shape.curvatures()?, self.lower.shape.curvatures()?);
        Some([upper[0] + lower[0], upper[1] + lower[1], upper[2] + lower[2]])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{JobError, Units};
    use serde_json::{Value, json};

    fn job(upper: &Value, lower: &Value) -> Value {
        let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
        json!({
            "analysis": "three_dimensional",
            "upper": {"shape": upper, "material": steel},
            "lower": {"shape": lower, "material": steel},
            "load": {"force": 100},
        })
    }

    fn ball_on_flat() -> Value {
        job(&json!({"type": "sphere", "radius": 10}), &json!({"type": "flat"}))
    }

    fn faults(value: &Value) -> Vec<String> {
        let Err(JobError::Fields(faults)) = Job::from_value(value) else { return Vec::new() };
        faults.iter().map(|fault| format!("{fault}")).collect()
    }

    fn pointers(value: &Value) -> Vec<String> {
        faults(value)
            .iter()
            .map(|fault| fault.split(": ").next().unwrap_or_default().to_owned())
            .collect()
    }

    #[test]
    fn a_ball_on_a_plane_is_a_job() {
        let read = Job::from_value(&ball_on_flat()).unwrap();
        assert_eq!(
            (read.analysis, read.mesh.elements_per_half_width),
            (Analysis::ThreeDimensional, 10)
        );
        assert_eq!(read.analysis.force().symbol(Units::MmNMpa), "N");
        assert!(read.validate().is_ok());
        assert!(serde_json::to_value(&read).unwrap()["upper"].get("support").is_none());
    }

    #[test]
    fn elastic_bodies_take_more_heights() {
        let heights: Vec<Vec<f64>> =
            (0..513).map(|i| (0..8).map(|j| 1e-3 * f64::from(i * j).sin()).collect()).collect();
        let mut rough = ball_on_flat();
        rough["upper"]["surface"] =
            json!({"heights": heights, "spacing_x": 0.001, "spacing_y": 0.001});
        assert!(faults(&rough).is_empty(), "{:?}", faults(&rough));
        rough["lower"]["material"]["plasticity"] =
            json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 0});
        let found = faults(&rough);
        assert!(
            found.len() == 1
                && found[0].starts_with("/upper/surface/heights")
                && found[0].contains("512")
                && found[0].contains("1024"),
            "{found:?}"
        );
    }

    #[test]
    fn a_ball_is_a_sphere_in_revolution_too() {
        let ball = json!({"type": "sphere", "radius": 10});
        let mut on_block = job(&ball, &json!({"type": "block", "width": 50, "depth": 50}));
        on_block["analysis"] = json!("axisymmetric");
        assert!(faults(&on_block).is_empty(), "{:?}", faults(&on_block));
        let read = Job::from_value(&on_block).unwrap();
        assert_eq!(serde_json::to_value(&read).unwrap()["upper"]["shape"]["type"], "sphere");
        on_block["upper"]["shape"]["rotation"] = json!(30);
        assert_eq!(pointers(&on_block), ["/upper/shape/rotation"]);
        on_block["upper"]["shape"] = ball;
        on_block["analysis"] = json!("plane_strain");
        assert_eq!(pointers(&on_block), ["/upper/shape/type"]);
    }

    #[test]
    fn a_roller_lies_along_its_contact() {
        let roller = |rotation: i32| json!({"type": "roller", "radius": 10, "length": 20, "rotation": rotation});
        for rotation in [0, 1, 10, 37, 90, 179, 180, 270, 360] {
            assert!(
                faults(&job(&roller(rotation), &json!({"type": "flat"}))).is_empty(),
                "{rotation}"
            );
            let same = json!({"type": "curved", "radius_x": 25, "rotation": rotation});
            assert!(faults(&job(&roller(rotation), &same)).is_empty(), "{rotation}");
        }
        let across = json!({"type": "curved", "radius_y": 5});
        assert_eq!(
            pointers(&job(&json!({"type": "roller", "radius": 50, "length": 20}), &across)),
            ["/upper/shape"]
        );
        assert_eq!(
            pointers(&job(&roller(10), &json!({"type": "curved", "radius_x": 25}))),
            ["/upper/shape"]
        );
    }

    #[test]
    fn curved_bodies_meet_in_principal_directions() {
        let roller = json!({"type": "curved", "radius_x": 10, "rotation": 30});
        let crossed = json!({"type": "curved", "radius_x": 10, "rotation": -60});
        let read = Job::from_value(&job(&roller, &crossed)).unwrap();
        let [least, greatest] = read.gap_curvatures().unwrap();
        assert!((least - 0.1).abs() < 1e-15 && (greatest - 0.1).abs() < 1e-15);
        assert!(read.gap_orientation().unwrap().abs() < 1e-12);
        let barrel = json!({"type": "curved", "radius_x": 20, "radius_y": 400, "rotation": 30});
        let read = Job::from_value(&job(&roller, &barrel)).unwrap();
        let [least, greatest] = read.gap_curvatures().unwrap();
        assert!((least - 0.0025).abs() < 1e-15 && (greatest - 0.15).abs() < 1e-15);
        assert!((read.gap_orientation().unwrap() - 30.0).abs() < 1e-12);
    }

    #[test]
    fn a_ball_in_a_raceway_has_the_smaller_radius() {
        let ball = json!({"type": "sphere", "radius": 10});
        let raceway = |radius: f64| json!({"type": "curved", "radius_x": 30, "radius_y": -radius});
        assert!(faults(&job(&ball, &raceway(10.4))).is_empty());
        let faults = faults(&job(&ball, &raceway(9.9)));
        assert_eq!(faults.len(), 2);
        assert!(
            faults.iter().all(|fault| fault.contains("the surfaces do not open")),
            "{faults:?}"
        );
    }

    #[test]
    fn stress_before_the_load_may_differ_along_x_and_y() {
        let mut ground = ball_on_flat();
        ground["lower"]["material"]["plasticity"] =
            json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 0});
        ground["lower"]["material"]["initial_stress"] =
            json!([{"depth": 0, "sigma_x": -300, "sigma_z": -200}]);
        assert!(faults(&ground).is_empty(), "{:?}", faults(&ground));
    }

    #[test]
    fn a_line_contact_is_of_plane_strain() {
        let roller = json!({"type": "curved", "radius_x": 10});
        for (upper, lower) in [
            (roller, json!({"type": "flat"})),
            (json!({"type": "flat"}), json!({"type": "curved"})),
        ] {
            let faults = faults(&job(&upper, &lower));
            assert_eq!(faults.len(), 2, "{faults:?}");
        }
    }

    #[test]
    fn every_field_at_fault_is_named() {
        let mut wrong = ball_on_flat();
        wrong["lower"]["shape"] = json!({"type": "block", "width": 20, "depth": 20});
        wrong["lower"]["support"] = json!("clamped");
        wrong["mesh"] = json!({"elements_per_half_width": 61});
        wrong["solver"] =
            json!({"theory": "deformation", "coupling": "secant_stiffness", "contact": "simplex"});
        let expected = [
            "/lower/shape/type",
            "/lower/support",
            "/mesh/elements_per_half_width",
            "/solver/contact",
            "/solver/coupling",
        ];
        assert_eq!(pointers(&wrong), expected);
    }

    #[test]
    fn half_spaces_are_of_three_dimensions_only() {
        let mut plane = ball_on_flat();
        plane["analysis"] = json!("axisymmetric");
        // A sphere is of revolution too.
        assert_eq!(pointers(&plane), ["/lower/shape/type"]);
    }

    #[test]
    fn a_radius_is_not_zero() {
        let wrong = job(
            &json!({"type": "curved", "radius_x": 0, "radius_y": 10}),
            &json!({"type": "flat"}),
        );
        assert_eq!(pointers(&wrong), ["/upper/shape/radius_x"]);
    }

    #[test]
    fn a_moment_is_one_that_a_contact_under_forces_bears() {
        let with = |changes: Value, load: Value| {
            let mut shape = json!({"type": "roller", "radius": 10, "length": 8});
            for (key, value) in changes.as_object().unwrap() {
                shape[key] = value.clone();
            }
            let mut job = job(&shape, &json!({"type": "flat"}));
            job["load"] = load;
            job["solver"] = json!({"theory": "flow"});
            job
        };
        let moment = |moment: f64| json!({"moment": moment});
        for load in [
            json!({"force": 100}),
            json!({"forces": [100, 300]}),
            json!({"history": [{"force": 100}, {"force": 0}]}),
        ] {
            assert!(faults(&with(moment(-399.0), load.clone())).is_empty(), "{load}");
            let found = faults(&with(moment(400.0), load));
            assert!(found.len() == 1 && found[0].contains("400 N mm"), "{found:?}");
        }
        for load in [
            json!({"approach": 0.01}),
            json!({"history": [{"force": 100}, {"approach": 0}]}),
            json!({"onset": true}),
            json!({"target": {"peak_pressure": 1000}}),
        ] {
            assert_eq!(pointers(&with(moment(1.0), load)), ["/upper/shape/moment"]);
        }
        let both = with(json!({"moment": 1, "tilt": 0}), json!({"force": 100}));
        assert_eq!(pointers(&both), ["/upper/shape/moment"]);
        let mut si =
            with(json!({"moment": 0.5, "radius": 0.01, "length": 0.008}), json!({"force": 100}));
        si["units"] = json!("SI");
        si["upper"]["material"] = json!({"rigid": true});
        si["lower"]["material"]["young_modulus"] = json!(2.1e11);
        assert!(faults(&si)[0].contains("0.4 N m"), "{:?}", faults(&si));
        let mut two = with(moment(1.0), json!({"force": 100}));
        two["lower"]["shape"] = two["upper"]["shape"].clone();
        assert_eq!(pointers(&two), ["/lower/shape/moment", "/upper/shape/moment"]);
    }

    #[test]
    fn a_half_width_that_is_sought_ends_with_a_roller() {
        let mut wide =
            job(&json!({"type": "roller", "radius": 10, "length": 0.5}), &json!({"type": "flat"}));
        wide["load"] = json!({"target": {"half_width": 0.25}});
        let found = faults(&wide);
        assert!(found.len() == 1 && found[0].contains("0.25 mm"), "{found:?}");
        wide["load"] = json!({"target": {"half_width": 0.24}});
        assert!(faults(&wide).is_empty());
    }
}
