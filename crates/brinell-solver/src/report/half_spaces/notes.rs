//! Remarks on the validity of an answer in three dimensions.

use crate::job::{Job, Theory};
use crate::report::ValidityNote;
use crate::report::units::{UnitConverter, rounded};
use crate::solver::SolveStatus;
use crate::solver::half_spaces::HalfSpaceStep;

/// Semi-axis over the smallest radius beyond which the surfaces are no longer close to their tangent.
const WIDE_CONTACT: f64 = 0.1;
/// Plastic strain beyond which small-strain theory is stretched.
const LARGE_STRAIN: f64 = 0.05;
/// Cells over the shorter semi-axis below which the grid is called coarse.
const COARSE_GRID: f64 = 5.0;
/// Semi-axes from each other from which on the bodies near the contact are no half-spaces: depth over which its stress dies away.
const REACH: f64 = 3.0;

/// The remarks of a step.
pub(super) fn notes(job: &Job, step: &HalfSpaceStep, write: UnitConverter) -> Vec<ValidityNote> {
    let mut notes = Vec::new();
    let mut note = |code: &str, message: String| notes.push(ValidityNote { code: code.to_owned(), message });
    match step.status {
        SolveStatus::Converged => {}
        SolveStatus::NotConverged => note(
            "not_converged",
            "The iteration did not converge, or the answer does not pass the check of contact and plasticity; figures are those of \
             the last iteration."
                .to_owned(),
        ),
        SolveStatus::Cancelled => note("cancelled", "The solve was cancelled; figures are those of the last iteration.".to_owned()),
        SolveStatus::TimedOut => note("timed_out", "The solve ran out of time; figures are those of the last iteration.".to_owned()),
    }
    let [a, b] = step.figures.semi_axes;
    if let Some((size, radius)) = widest(job, [a, b]) {
        note(
            "wide_contact",
            format!(
                "The contact reaches {} of a radius of curvature ({}): half-spaces take surfaces for parabolas and bodies for large \
                 beside the contact.",
                rounded(size / radius),
                write.length_text(radius)
            ),
        );
    }
    if a > 0.0 && a < COARSE_GRID * step.surface.grid.hx() {
        note(
            "coarse_mesh",
            format!(
                "The shorter semi-axis has only {:.1} cells; ask for at least 8 (`mesh.elements_per_half_width`).",
                a / step.surface.grid.hx()
            ),
        );
    }
    let strain = step.figures.max_plastic_strain.into_iter().fold(0.0, f64::max);
    if strain > LARGE_STRAIN {
        note(
            "large_strain",
            format!(
                "The plastic strain reaches {:.1} %; the theory is that of small strains, and the surface is where it was before \
                 loading.",
                100.0 * strain
            ),
        );
    }
    let yields = strain > 0.0;
    if yields && job.solver.theory == Theory::Deformation {
        note(
            "deformation_theory",
            "Deformation theory takes each point for loaded in proportion. Under a growing contact it gives peaks that are some per \
             cent to a tenth too high; the theory `flow` does not."
                .to_owned(),
        );
    }
    if step.figures.force <= 0.0 && step.status == SolveStatus::Converged {
        note("no_contact", "The bodies do not touch.".to_owned());
    }
    if a > 0.0 {
        note(
            "half_spaces",
            format!(
                "The bodies are half-spaces. They stand for bodies that reach at least {} beyond the contact to all sides and in depth.",
                write.length_text(digits(REACH * b))
            ),
        );
    }
    notes
}

/// The largest semi-axis over a radius of curvature of the bodies, if it is beyond what parabolas stand for: both.
fn widest(job: &Job, semi_axes: [f64; 2]) -> Option<(f64, f64)> {
    let radii = [&job.upper, &job.lower].into_iter().filter_map(|body| body.shape.curvatures());
    // Along its own axes, the largest curvature of each body meets the shorter semi-axis at most.
    let ratios = radii.flat_map(|[xx, yy, xy]| {
        let (mean, spread) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
        let [strong, weak] = if (mean + spread).abs() > (mean - spread).abs() {
            [mean + spread, mean - spread]
        } else {
            [mean - spread, mean + spread]
        };
        [(semi_axes[0], strong.abs().recip()), (semi_axes[1], weak.abs().recip())]
    });
    let widest = ratios.max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)));
    widest.filter(|(size, radius)| size / radius > WIDE_CONTACT)
}

/// To two digits.
fn digits(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}
