//! The force under which a figure of the contact has the target value of a job.

use super::answers::{Answer, Bar, Name};
use super::error_bars;
use super::findings::Finding;
use super::solve_error::limit_text;
use crate::job::{Job, Load, Quantity, Target, label_of};
use crate::solver::{StepSolution, Unreachable, UnreachableReason, target_figure};
use crate::units::UnitConverter;

/// Largest solved force over the force of the largest figure, above which the message says that
/// the figure no longer rises. At smaller ratios both forces read alike in the message.
const RISING: f64 = 1.001;

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

    /// Returns the rows of the force that was found; none of a job without a target or without a
    /// solution. The error of the force is what the figure is off by, and what the mesh may have
    /// done to it.
    pub fn rows(&self, job: &Job, sensitivity: Option<f64>, write: UnitConverter) -> Vec<Answer> {
        let Load::Target(Target { figure, value }) = job.load else { return Vec::new() };
        let Some((force, sensitivity)) = self.force.zip(sensitivity) else { return Vec::new() };
        let missed = (self.reached / value.get() - 1.0).abs();
        let bar = self.figure_error.map(|error| (error + missed) / sensitivity);
        let none = || Bar::none(format!("the {} has no bound", label_of(figure)));
        let text = format!(
            "for a {} of {}; it is {}",
            label_of(figure),
            write.target_text(figure, value.get()),
            write.target_text(figure, self.reached)
        );
        let row = |name: Name, quantity: Quantity, core: f64| {
            let value = Some(write.of(quantity, core));
            Answer::new(name, quantity, job.units.symbol(quantity), value)
        };
        let quantity = job.analysis.force().quantity();
        let found = row(Name::ForceFound, quantity, force);
        let found = found.bar(bar.map_or_else(none, Bar::Relative)).text(text);
        let sensitivity = row(Name::ForceSensitivity, Quantity::Number, sensitivity);
        vec![found, sensitivity.text(Name::ForceSensitivity.meaning()).detail()]
    }
}

/// Returns the figure of meshed bodies that a target asks for, and its relative error.
pub(super) fn of_section(
    job: &Job,
    step: &StepSolution,
    findings: &[Finding],
) -> Option<(f64, Option<f64>)> {
    let Load::Target(target) = &job.load else { return None };
    let bars = error_bars::under_its_force(step, findings);
    let error = bars.and_then(|bars| error_bars::of_target(target.figure, &bars, step));
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
