//! Error of the force under which yield begins.

use super::force_search::ForceSearch;
use super::utilization::{at_narrow_edge, error_at_narrow_edge, highest_at_ends};
use crate::engine::error::MeshedError;
use crate::engine::reference::ElasticReference;
use crate::engine::solution::{SectionField, StepSolution};
use brinell_method::force_search::{Density, ForceFound, Trial, try_force};
use brinell_method::observer::SolveStatus;
use brinell_method::run::Run;
use brinell_method::sought::Sought;

/// Error at least of the force under which yield begins, over h/a; where it begins at an end of
/// the contact, 0.51 on 10 elements and 0.4 on 20 and 40.
const ONSET_FLOOR: f64 = 0.2;
const ONSET_FLOOR_AT_ENDS: f64 = 0.6;
/// Error of the utilization at the ends of the contact over its change to half the density.
const ENDS_MARGIN: f64 = 1.5;
const MOST_HIDDEN: f64 = 0.15;

impl ForceSearch<'_> {
    /// Gives the step of the onset of yield the relative error of its force, where it has an answer.
    pub fn tell_error_of_onset(
        &self,
        found: &mut ForceFound<SectionField>,
        run: &mut Run<'_>,
    ) -> Result<(), MeshedError> {
        let has_answer = |step: &StepSolution| {
            step.status == SolveStatus::Converged || step.search.missed.is_some()
        };
        if found.trial.steps.iter().all(has_answer) {
            let error = self.onset_error(found, run)?;
            found.trial.steps.iter_mut().for_each(|step| step.search.force_error = Some(error));
        }
        Ok(())
    }

    /// Relative error of the force under which yield begins, by how much half the density changes
    /// utilization under it: where it is highest, and at the ends of the contact, where more may
    /// be hidden from the mesh.
    fn onset_error(
        &self,
        ForceFound { trial: found, slope, .. }: &ForceFound<SectionField>,
        run: &mut Run<'_>,
    ) -> Result<f64, MeshedError> {
        let Some(last) = found.steps.last() else { return Ok(0.0) };
        let missed = found.ratio.ln().abs() / slope;
        if at_narrow_edge(last, self.problem).is_some_and(|edge| edge.ratio >= found.ratio) {
            return Ok(missed + error_at_narrow_edge(last).unwrap_or_default());
        }
        let elements = f64::from(self.sequence.asked.elements);
        let force = last.figures.force;
        let half =
            run.preliminarily(|run| try_force(Sought::Onset, self, Density::Half, force, run))?;
        let change = match half {
            Ok(half) if half.is_converged() => {
                let at_ends = |trial: &Trial<SectionField>| {
                    let highest =
                        trial.steps.last().and_then(|step| highest_at_ends(step, self.problem));
                    highest.map_or(f64::MIN_POSITIVE, |highest| highest.ratio).ln()
                };
                let (ends, highest) = (at_ends(found), found.ratio.ln());
                let hidden = (ENDS_MARGIN * (ends - at_ends(&half)).abs()).min(MOST_HIDDEN) + ends
                    - highest;
                let floor = if ends < highest { ONSET_FLOOR } else { ONSET_FLOOR_AT_ENDS };
                ((half.ratio.ln() - highest).abs().max(hidden) / slope).max(floor / elements)
            }
            _ => ONSET_FLOOR / elements,
        };
        Ok(missed + change.max(self.beyond_closed_form(force)))
    }

    /// Returns the relative excess of a force over the one under which yield begins below the
    /// middle in closed form. In bodies whose strength varies over the depth, yield may begin in a
    /// layer thinner than an element. The excess is 0 for other bodies.
    fn beyond_closed_form(&self, force: f64) -> f64 {
        let is_graded = self.problem.bodies.iter().any(|body| {
            let (least, greatest) = body.strength_range();
            least < greatest
        });
        let reference = is_graded.then(|| ElasticReference::of(self.problem, force)).flatten();
        let onset = reference.and_then(|reference| reference.yield_onset_force);
        onset.map_or(0.0, |onset| force / onset - 1.0)
    }
}
