//! Closed-form contact (Hertz), without a mesh.

use serde::Serialize;
use utoipa::ToSchema;

use brinell_solver::inputs::{elastic_reference, elliptic_reference};
use brinell_solver::job::{FieldError, Job, Load, Named as _, Quantity, Sweep, Units};
use brinell_solver::solver::half_spaces::EllipticReference;

/// Hertz's contact of the bodies of a job, in the units of the job.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct ClosedForm {
    /// Units of all figures: `mm_N_MPa` or `SI`.
    #[schema(example = "mm_N_MPa")]
    pub units: &'static str,
    /// Effective radius of the two surfaces, along the shorter side of their contact.
    /// Unit: mm (SI: m).
    #[schema(exclusive_minimum = 0, example = 10.0)]
    pub effective_radius: f64,
    /// Force at which the first body begins to yield; `null` if none can. Unit: N/mm (SI: N/m); N
    /// in axisymmetry and three dimensions.
    #[schema(required, minimum = 0, example = 218.99)]
    pub yield_onset_force: Option<f64>,
    /// One for each force of the load.
    pub steps: Vec<ClosedFormStep>,
}

/// Hertz's contact under one force.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct ClosedFormStep {
    /// The force. Unit: N/mm (SI: N/m); N in axisymmetry and three dimensions.
    #[schema(minimum = 0, example = 612.6106)]
    pub force: f64,
    /// Half-width of the strip, radius of the circle or shorter semi-axis of the ellipse. Unit: mm
    /// (SI: m).
    #[schema(minimum = 0, example = 0.26)]
    pub half_width: f64,
    /// Peak pressure. Unit: MPa (SI: Pa).
    #[schema(minimum = 0, example = 1500.0)]
    pub peak_pressure: f64,
    /// Whether a body yields under this force: then Hertz's figures no longer hold.
    pub yields: bool,
}

impl ClosedForm {
    /// Evaluates the closed form for a job.
    ///
    /// # Errors
    /// The fields to which Hertz's theory does not apply.
    pub fn of(job: &Job) -> Result<Self, Vec<FieldError>> {
        let Load::Forces(forces) = &job.load else {
            let detail =
                "the closed form takes a force or forces; the approach of two cylinders has none";
            return Err(vec![FieldError::not_solvable("/load", detail)]);
        };
        let (units, force_unit) = (job.units, job.analysis.force());
        if let Some(reference) = elliptic_reference(job) {
            return Ok(Self::of_ellipse(job.units, &reference, forces));
        }
        let mut whole = None;
        let mut steps = Vec::with_capacity(forces.len());
        for force in forces.iter().map(|force| force.get()) {
            let reference = elastic_reference(job, force).ok_or_else(not_hertzian)?;
            steps.push(ClosedFormStep {
                force: force_unit.to_wire(units, force),
                half_width: units.to_wire(Quantity::Length, reference.half_width),
                peak_pressure: units.to_wire(Quantity::Stress, reference.peak_pressure),
                yields: reference.yield_onset_force.is_some_and(|onset| force > onset),
            });
            whole = Some(reference);
        }
        let whole = whole.ok_or_else(not_hertzian)?;
        Ok(Self {
            units: units.name(),
            effective_radius: units.to_wire(Quantity::Length, whole.effective_radius),
            yield_onset_force: whole
                .yield_onset_force
                .map(|force| force_unit.to_wire(units, force)),
            steps,
        })
    }

    /// Evaluates Hertz's contact of half-spaces in three dimensions.
    fn of_ellipse(units: Units, reference: &EllipticReference, forces: &Sweep) -> Self {
        let step = |force: f64| {
            let hertz = reference.under(force);
            ClosedFormStep {
                force: units.to_wire(Quantity::Force, force),
                half_width: units
                    .to_wire(Quantity::Length, hertz.semi_axis_x.min(hertz.semi_axis_y)),
                peak_pressure: units.to_wire(Quantity::Stress, hertz.peak_pressure),
                yields: reference.onset_force().is_some_and(|onset| force > onset),
            }
        };
        Self {
            units: units.name(),
            effective_radius: units.to_wire(Quantity::Length, reference.effective_radius()),
            yield_onset_force: reference.onset_force(),
            steps: forces.iter().map(|force| step(force.get())).collect(),
        }
    }
}

fn not_hertzian() -> Vec<FieldError> {
    let detail =
        "Hertz's theory needs arcs that open away from the contact, and a body that deforms";
    ["/upper/shape", "/lower/shape"]
        .map(|pointer| FieldError::not_solvable(pointer, detail))
        .to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_problem() {
        let job = Job::from_json(include_bytes!("../../api/examples/two_cylinders.json")).unwrap();
        let hertz = ClosedForm::of(&job).unwrap();
        assert_eq!((hertz.effective_radius, hertz.steps.len()), (10.0, 1));
        // a = √(4 F R / (π E*)), E* = E / (2 (1 - ν²))
        let modulus = 210_000.0 / (2.0 * 0.91);
        let a = (4.0 * hertz.steps[0].force * 10.0 / (std::f64::consts::PI * modulus)).sqrt();
        assert!((hertz.steps[0].half_width / a - 1.0).abs() < 1e-12);
        assert!(hertz.steps[0].yields);
    }
}
