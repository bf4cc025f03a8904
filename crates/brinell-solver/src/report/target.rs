//! The force under which a figure of the contact has the target value of a job.

use serde::{Deserialize, Serialize};

use super::error_bars;
use super::findings::Finding;
use super::solve_error::limit_text;
use crate::fem::element::StressState;
use crate::job::{Job, Load, Named as _, Target, label_of};
use crate::solver::{StepSolution, Unreachable, UnreachableReason, target_figure};
use crate::units::UnitConverter;

/// Largest solved force over the force of the largest figure, above which the message says that
/// the figure no longer rises. At smaller ratios both forces read alike in the message.
const RISING: f64 = 1.001;

/// The force under which a figure of the contact has the value that a job asked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = TargetResult))]
pub struct TargetReport {
    /// Which figure: `permanent_approach`, `dent_depth`, `peak_pressure`, `mean_pressure`,
    /// `half_width` or `max_plastic_strain`.
    pub figure: String,
    /// The value that it was to have \[length, stress or 1\].
    pub wanted: f64,
    /// The value that it has under the force \[length, stress or 1\].
    pub reached: f64,
    /// The force \[force >= 0\].
    pub force: f64,
    /// Relative change of the figure over the relative change of the force \[1\].
    pub sensitivity: f64,
    /// Estimated bound of the relative error of the force: what the figure is off by, and what the
    /// mesh may have done to it. `null` where there is no estimate for the figure \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub relative_error: Option<f64>,
}

/// Findings of the load steps of a job on its target.
#[derive(Debug, Default)]
pub(super) struct TargetSeen {
    force: Option<f64>,
    reached: f64,
    figure_error: Option<f64>,
}

impl TargetSeen {
    /// Records the force of the first load step, and the figure of the last load step with its
    /// error.
    pub fn take(&mut self, force: f64, reached: f64, figure_error: Option<f64>) {
        self.force.get_or_insert(force);
        (self.reached, self.figure_error) = (reached, figure_error);
    }

    /// Returns the report, or `None` for a job without a target or without a solution.
    pub fn finish(
        self,
        job: &Job,
        sensitivity: Option<f64>,
        write: UnitConverter,
    ) -> Option<TargetReport> {
        let Load::Target(target) = &job.load else { return None };
        let Target { figure, value } = *target;
        let (force, sensitivity) = (self.force?, sensitivity?);
        let missed = (self.reached / value.get() - 1.0).abs();
        Some(TargetReport {
            figure: figure.name().to_owned(),
            wanted: write.of_target(figure, value.get()),
            reached: write.of_target(figure, self.reached),
            force: write.force(force),
            sensitivity,
            relative_error: self.figure_error.map(|error| (error + missed) / sensitivity),
        })
    }
}

/// Returns the figure of meshed bodies that a target asks for, and its relative error.
pub(super) fn of_section(
    job: &Job,
    step: &StepSolution,
    findings: &[Finding],
) -> Option<(f64, Option<f64>)> {
    let Load::Target(target) = &job.load else { return None };
    let of_revolution = step.field.stress_state == StressState::Axisymmetric;
    let bars = error_bars::under_its_force(step, findings);
    let error = bars.and_then(|bars| error_bars::of_target(target.figure, &bars, of_revolution));
    Some((target_figure(step, target.figure), error))
}

/// Returns the reason why a target is not reached, in the units of the job.
pub(super) fn unreachable(found: &Unreachable, load: &Load, write: UnitConverter) -> String {
    let Load::Target(target) = load else {
        let (ratio, force) = (found.nearest, write.force_text(found.force));
        return match &found.reason {
            UnreachableReason::Limit(why) => {
                format!("the contact does not yield: {}", limit_text(why, write))
            }
            UnreachableReason::LargestForce => {
                "the contact does not yield under any force that is solved".to_owned()
            }
            UnreachableReason::SmallestForce => format!(
                "the contact yields under the smallest forces already, down to {force}: at a \
                 sharp corner, or where the stress before the load is beyond the yield stress"
            ),
            UnreachableReason::Insensitive => format!(
                "the highest von Mises stress is {ratio:.3} of the yield stress under {force} and \
                 hardly depends on the force, at a sharp corner or because of the stress before \
                 the load, so that no force is the onset of yield"
            ),
        };
    };
    let name = label_of(target.figure);
    let figure = |value: f64| write.target_text(target.figure, value);
    let (nearest, force) =
        (figure(found.nearest * target.value.get()), write.force_text(found.force));
    match &found.reason {
        UnreachableReason::Insensitive => format!(
            "the {name} is {nearest} under {force} and hardly depends on the force, so that it \
             does not tell one"
        ),
        UnreachableReason::SmallestForce => {
            format!("the {name} is larger than this under any force, down to {force}")
        }
        UnreachableReason::LargestForce | UnreachableReason::Limit(_) => {
            let bound = if found.nearest > 0.0 {
                format!(
                    "the largest {name} that is reached is {nearest}, under a force of {force}"
                )
            } else {
                format!("no force that is solved, up to {force}, gives any {name}")
            };
            let bound = if found.largest_force > RISING * found.force {
                format!(
                    "{bound}; up to {} it rises no more",
                    write.force_text(found.largest_force)
                )
            } else {
                bound
            };
            match &found.reason {
                UnreachableReason::Limit(why) => {
                    format!("{bound}; under a larger one {}", limit_text(why, write))
                }
                _ => bound,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Analysis, PositiveF64, TargetFigure, Units};

    /// A figure that falls beyond its largest value, and a limit to the force that can be solved,
    /// get different messages.
    #[test]
    fn a_limit_is_told_of_the_force_at_which_it_is() {
        let value = PositiveF64::new(5000.0).unwrap();
        let load = Load::Target(Target { figure: TargetFigure::PeakPressure, value });
        let found = |largest_force: f64| Unreachable {
            nearest: 0.6,
            force: 90.0,
            largest_force,
            reason: UnreachableReason::Limit("the iteration does not converge".into()),
        };
        let told = |found: &Unreachable| {
            unreachable(found, &load, UnitConverter::new(Units::MmNMpa, Analysis::PlaneStrain))
        };
        assert!(
            told(&found(95.0))
                .contains("up to 95 N/mm it rises no more; under a larger one the iteration")
        );
        assert!(
            told(&found(90.0))
                .contains("under a force of 90 N/mm; under a larger one the iteration")
        );
    }
}
