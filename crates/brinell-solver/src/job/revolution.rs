//! The conditions of a shape on the analysis and on the material.

use super::{
    Analysis, Coupling, FieldError, Hole, InitialStress, Job, Material, Profile, Shape, Sphere,
};

impl Job {
    /// Refuses shapes that the analysis does not offer, and deformable punches.
    pub(super) fn faults_of_shapes(&self) -> Vec<FieldError> {
        if self.analysis == Analysis::ThreeDimensional {
            return self.faults_of_initial_stress();
        }
        let is_revolved = self.analysis == Analysis::Axisymmetric;
        let mut faults = Vec::new();
        for (side, body) in [("upper", &self.upper), ("lower", &self.lower)] {
            let misplaced = match body.shape {
                Shape::Cone(_) if !is_revolved => {
                    Some("\"cone\" is a body of revolution; the plane one is \"wedge\"")
                }
                Shape::Wedge(_) if is_revolved => {
                    Some("\"wedge\" is a plane body; the one of revolution is \"cone\"")
                }
                Shape::Hole(Hole { width: Some(_), .. }) if is_revolved => {
                    let detail =
                        "a square plate is no body of revolution; give `outer_radius` instead";
                    faults.push(FieldError::new(format!("/{side}/shape/width"), detail));
                    None
                }
                Shape::Sphere(Sphere { rotation: Some(_), .. }) => {
                    let detail = "belongs to the analysis \"three_dimensional\"";
                    faults.push(FieldError::new(format!("/{side}/shape/rotation"), detail));
                    None
                }
                _ => None,
            };
            faults.extend(
                misplaced.map(|detail| FieldError::new(format!("/{side}/shape/type"), detail)),
            );
            if matches!(body.shape, Shape::Punch(_)) && body.material != Material::Rigid {
                let detail = "a punch is rigid (`{\"rigid\": true}`), because its contact reaches \
                              to the edge of its face; give a face that deforms as a `profile`";
                faults.push(FieldError::new(format!("/{side}/material"), detail));
            }
        }
        faults.extend(self.faults_of_holes());
        faults.extend(self.faults_of_initial_stress());
        faults
    }

    /// Refuses an initial stress that the analysis or the coupling does not support.
    fn faults_of_initial_stress(&self) -> Vec<FieldError> {
        let mut faults = Vec::new();
        for (side, body) in [("upper", &self.upper), ("lower", &self.lower)] {
            let Some(material) = body.deformable() else { continue };
            let key = format!("/{side}/material/{}", InitialStress::KEY);
            for mut fault in InitialStress::faults_in(&material.initial_stress, self.analysis) {
                fault.pointer.insert_str(0, &key);
                faults.push(fault);
            }
            if !material.initial_stress.is_empty()
                && self.solver.coupling == Coupling::SecantStiffness
            {
                let detail = "the secant stiffness has no place for a stress before the load; \
                              take `accelerated`, `strong` or `weak`";
                faults.push(FieldError::new("/solver/coupling", detail));
                break;
            }
        }
        faults
    }

    /// Refuses a hole without a smaller cylinder in it.
    fn faults_of_holes(&self) -> Vec<FieldError> {
        let sides = [("upper", &self.upper.shape), ("lower", &self.lower.shape)];
        let mut faults = Vec::new();
        for (k, (side, shape)) in sides.into_iter().enumerate() {
            let ((other, opposite), Shape::Hole(hole)) = (sides[1 - k], shape) else { continue };
            match opposite.round_radius() {
                Some(radius) if radius < hole.radius.get() => {}
                Some(_) => {
                    let detail = "must be greater than the radius of the cylinder in the hole: \
                                  contact without clearance is not solved";
                    faults.push(FieldError::new(format!("/{side}/shape/radius"), detail));
                }
                None => {
                    let detail =
                        "the body in a \"hole\" is a \"cylinder\", in axisymmetry a \"sphere\"";
                    faults.push(FieldError::new(format!("/{other}/shape/type"), detail));
                }
            }
        }
        faults
    }

    /// Refuses an asymmetric profile in axisymmetry, where it turns about x = 0: it must start
    /// or end there, or have two equal sides.
    pub(super) fn faults_of_revolution(&self) -> Vec<FieldError> {
        if self.analysis != Analysis::Axisymmetric {
            return Vec::new();
        }
        let profiles = [("upper", &self.upper), ("lower", &self.lower)].into_iter().filter_map(
            |(side, body)| {
                let Shape::Profile(profile) = &body.shape else { return None };
                (!is_meridian(profile)).then(|| {
                FieldError::new(
                    format!("/{side}/shape/points"),
                    "must start at x = 0 or be symmetric about it, because an axisymmetric body \
                     is the profile turned about x = 0",
                )
            })
            },
        );
        profiles.collect()
    }
}

#[expect(clippy::float_cmp, reason = "a face is symmetric if its points are, to the last bit")]
fn is_meridian(profile: &Profile) -> bool {
    let points = &profile.points;
    let starts_on_axis = points.first().is_some_and(|[x, _]| *x == 0.0);
    let ends_on_axis = points.last().is_some_and(|[x, _]| *x == 0.0);
    let mirrored =
        points.iter().zip(points.iter().rev()).all(|(p, q)| p[0] == -q[0] && p[1] == q[1]);
    starts_on_axis || ends_on_axis || mirrored
}
