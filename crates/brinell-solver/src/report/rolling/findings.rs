//! Findings on a load that rolls.

use brinell_halfspace::track::TrackFault;

use super::document::TrackVerdict;
use super::verdicts::{word, worst};
use crate::job::Job;
use crate::report::findings::{Advice, Finding, Unconverged, Wide, guesses};
use crate::report::strength::by_hardness;
use crate::report::validity::{NEAR_SUPPORT, WIDE_CONTACT, large_strain, smallest_radius};
use crate::solver::rolling::{RollingProblem, TrackStep};
use crate::solver::{ElasticReference, SolveStatus};

/// Returns the findings on a load that rolls.
pub(super) fn findings(
    job: &Job,
    problem: &RollingProblem,
    reference: Option<&ElasticReference>,
    step: &TrackStep,
) -> Vec<Finding> {
    let mut findings = Vec::new();
    let field = &step.field;
    let last = &field.last;
    match step.status {
        SolveStatus::Converged => {}
        SolveStatus::NotConverged if last.fault.is_some_and(cuts_off) => {
            findings.push(Finding::NotConverged(Unconverged::AtEdge));
            findings.push(Finding::AtEdge { in_hole: false });
        }
        SolveStatus::NotConverged if let Some(fault) = last.fault => {
            findings.push(Finding::NotConverged(Unconverged::Pass(fault)));
        }
        SolveStatus::NotConverged => {
            let has_room = last.iterations < problem.solver.max_iterations;
            findings.push(Finding::NotConverged(Unconverged::Iteration {
                iterations: last.iterations,
                residual: last.residual,
                advice: if has_room { Advice::SmallerLoad } else { Advice::MoreIterations },
            }));
        }
        status => findings.push(Finding::stopped(status, false)),
    }
    let half_width = last.half_width();
    let ratio = half_width / smallest_radius(job, reference).min(problem.smallest_radius());
    if ratio > WIDE_CONTACT {
        findings.push(Finding::Wide(Wide::OverRadius { ratio, in_groove: false }));
    }
    let other = field.kinematic.iter().flat_map(|other| &other.passes);
    let bodies = field.passes.iter().chain(other).flat_map(|pass| pass.bodies.iter().flatten());
    let strain = bodies.map(|body| body.strain.largest.value.max(body.outlet.strain_of_all()));
    findings.extend(large_strain(strain.fold(0.0, f64::max), false, None));
    let [fine, coarse] =
        [&field.verdicts, &field.coarse_verdicts].map(|verdicts| word(worst(verdicts).1));
    if fine != coarse && ![fine, coarse].contains(&TrackVerdict::Undecided) {
        findings.push(Finding::NearLimit { coarse });
    }
    if step.status == SolveStatus::Converged && problem.load.friction != 0.0 {
        findings.push(Finding::FullSliding);
    }
    findings.extend(by_hardness(job));
    findings.extend(guesses(job));
    if half_width > 0.0 {
        let across_roller = problem.is_line();
        let longest = last.half_width_across.map_or(half_width, |across| across.max(half_width));
        findings.push(Finding::HalfSpaces { reach: NEAR_SUPPORT * longest, across_roller });
    }
    findings
}

/// Whether a fault is one of cells that contact or yield outgrow.
const fn cuts_off(fault: TrackFault) -> bool {
    matches!(fault, TrackFault::Window { .. } | TrackFault::Edge { .. } | TrackFault::Depth { .. })
}
