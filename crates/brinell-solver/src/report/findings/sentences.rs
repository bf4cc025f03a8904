//! The sentences of findings, in the units of a job.

use super::kinds::{
    Advice, CasePlace, Deformation, FinerBy, MANY_MESHES, OnsetUnknown, Unconverged, Wide, Work,
};
use crate::job::MeshSettings;
use crate::report::solve_error::track_text;
use crate::units::{UnitConverter, about, percent, rounded};

/// Advice for a round body that nearly fills its groove.
pub(in crate::report) const CONFORMING_ADVICE: &str = "a pin or ball that nearly fills what \
    it lies in is solved as a `cylinder` in a `hole`, up to 80° to each side";

pub(super) const MORE_ELEMENTS: &str = "Ask for more elements (`mesh.elements_per_half_width`).";
const MEANT: &str =
    "contact theory with small displacements and vertical gaps is meant for up to 10 %";

pub(super) fn stopped(why: &str, is_preliminary: bool) -> String {
    if is_preliminary {
        format!(
            "{why} before the mesh that was asked for had come to this load: the figures are \
             those of the mesh of half the density on which increments are chosen, and there are \
             no stresses and no error bars."
        )
    } else {
        format!("{why}; the figures are those of the last iteration.")
    }
}

pub(super) fn collapse(strain: f64, last: Option<[f64; 2]>) -> String {
    let strain = 100.0 * strain;
    match last {
        Some([from, size]) => format!(
            "Plastic strain reaches {strain:.0} %: after {} of the load another increment of {} \
             of it, the smallest that is tried, does not end with small strains. Approach and \
             strains are no answer. The history ends here, with that increment.",
            percent(from),
            percent(size)
        ),
        None => format!(
            "Plastic strain reaches {strain:.0} %: the bodies do not bear this load with small \
             strains. It is at or beyond their limit load, and approach and strains are no \
             answer. Reduce the load."
        ),
    }
}

pub(super) fn few(number: f64, advice: FinerBy) -> String {
    match advice {
        FinerBy::Elements => format!(
            "The half-width has only {number:.1} elements; ask for at least 10 \
             (`mesh.elements_per_half_width`)."
        ),
        FinerBy::Cells => format!(
            "A semi-axis of the contact has only {number:.1} cells; ask for more \
             (`mesh.elements_per_half_width`)."
        ),
        FinerBy::Heights => format!(
            "A semi-axis of the contact has only {number:.1} cells; finer heights tell more."
        ),
    }
}

pub(super) fn rounded_tip(
    arc: Option<String>,
    needed: f64,
    pressure: &str,
    spacing: &str,
) -> String {
    let Some(arc) = arc else {
        return format!(
            "The curvature of the surface is infinite at its tip; elements of {spacing} leave \
             that out, and pressure, yield and strain at the tip are those of the mesh. In closed \
             form elastic bodies have a peak of about {pressure} there. What is away from the tip \
             does not depend on it."
        );
    };
    let advice = if needed > f64::from(MeshSettings::MAX_ELEMENTS_PER_HALF_WIDTH) {
        "No mesh that may be asked for resolves it.".to_owned()
    } else {
        format!("About {needed:.0} elements (`mesh.elements_per_half_width`) resolve it.")
    };
    format!(
        "The tip is rounded off within {arc} to each side of its middle; elements of {spacing} \
         leave that out, and pressure, yield and strain at the tip are those of the mesh. In \
         closed form elastic bodies have a peak of about {pressure} there. {advice} What is away \
         from the tip does not depend on it."
    )
}

pub(super) fn onset_unknown(cause: OnsetUnknown, is_sought: bool, write: UnitConverter) -> String {
    let unknown = if is_sought {
        "The force under which yield begins is not known"
    } else {
        "That no body yields holds for this mesh only"
    };
    match cause {
        OnsetUnknown::AtEdge { width, spacing, force } => format!(
            "{unknown}. The contact ends within {} on the rounded edges, which elements of {} \
             leave out; in closed form elastic bodies yield there under {}.",
            write.length_about(width),
            write.length_about(spacing),
            write.force_text(force),
        ),
        OnsetUnknown::NextToEnd { x, spacing } => format!(
            "{unknown}. The largest pressure is at x = {}, next to an end of the contact, where \
             it rises within elements of {}: finer ones find more of it, and yield under a \
             smaller force.",
            write.length_text(x),
            write.length_about(spacing)
        ),
        OnsetUnknown::AtCorner { x } => format!(
            "{unknown}. A sharp corner carries pressure at x = {}, where elastic stress has no \
             bound: the force falls with the size of the elements.",
            write.length_text(x)
        ),
        OnsetUnknown::AtRollerEnd => format!(
            "{unknown}. The contact runs to an end of a roller, where elastic pressure has no \
             bound: the force falls with the size of the cells. A profile that ends the contact \
             before the roller does has an onset."
        ),
    }
}

pub(super) fn coarse_case(
    change: f64,
    place: CasePlace,
    wanted: f64,
    write: UnitConverter,
) -> String {
    let change = 100.0 * change;
    match place {
        CasePlace::Element([x, y]) => format!(
            "The strength changes by {change:.0} % within one element at x = {}, y = {}, where \
             the stress is more than half of it: what yields there is known to its place within \
             that element only. About {wanted:.0} elements over the half-width \
             (`mesh.elements_per_half_width`) would do.",
            write.length_text(x),
            write.length_text(y),
        ),
        CasePlace::Layer(depth) => format!(
            "The strength changes by {change:.0} % within one layer of cells at a depth of {}, \
             where the stress is more than half of it: a layer has the strength of its middle, \
             and what is thinner is left out. About {wanted:.0} cells over a semi-axis \
             (`mesh.elements_per_half_width`) would do.",
            write.length_about(depth),
        ),
    }
}

impl Unconverged {
    pub(super) fn text(&self, write: UnitConverter) -> String {
        let slow = |is_slow: bool| {
            if is_slow { " Use the accelerated coupling (`solver.coupling`)." } else { "" }
        };
        match *self {
            Self::Missed { ratio } => format!(
                "What is sought is not found: under this force it is {ratio:.4} times what it is \
                 to be (of an onset, the highest von Mises stress over the yield stress), and \
                 jumps from one mesh to the next. More elements (`mesh.elements_per_half_width`) \
                 follow it more closely."
            ),
            Self::Contact { violation, is_slow } => format!(
                "The final state violates the contact conditions by {} of their scale \
                 (penetration, tension or load); do not use it.{}",
                percent(violation),
                slow(is_slow)
            ),
            Self::Collapse => "There is no answer with small strains; see `collapse`.".to_owned(),
            Self::AtEdge => {
                "The contact is wider than what could be meshed; see `contact_at_edge`.".to_owned()
            }
            Self::Inherited { is_slow } => format!(
                "An increment before it in this history has not converged, and this step inherits \
                 its error.{}",
                slow(is_slow)
            ),
            Self::Unbalanced { residual } => format!(
                "The iteration has converged, but over the whole bodies forces are off balance by \
                 {} of the contact force: do not use the figures.",
                percent(residual)
            ),
            Self::Iteration { iterations, residual, advice } => format!(
                "Not converged after {iterations} iterations: forces are off balance by {} of the \
                 contact force. {}",
                percent(residual),
                match advice {
                    Advice::LargerLoad =>
                        "Nothing yields: what is off is rounding, under a load that is tiny \
                         beside the stress before it or beside the stiffness of the bodies. \
                         Choose a larger load.",
                    Advice::AcceleratedCoupling => {
                        "Use the accelerated coupling (`solver.coupling`)."
                    }
                    Advice::MoreIterations => "Raise `solver.max_iterations`.",
                    Advice::SmallerLoad =>
                        "The iteration stands still: do not use the figures. A smaller load or a \
                         little hardening may have an answer.",
                }
            ),
            Self::Moment { missing } => format!(
                "The moment is missed by {} of the force times half the length of the roller: no \
                 tilt that was tried has it. The cells next to the end bear at most the force \
                 times the distance of their middles. Give a smaller moment, or more elements \
                 (`mesh.elements_per_half_width`).",
                percent(missing)
            ),
            Self::Pass(ref fault) => {
                format!("The next pass has no answer: {}.", track_text(fault, write))
            }
        }
    }
}

impl Work {
    pub(super) fn text(&self, write: UnitConverter) -> String {
        match *self {
            Self::Coupling { updates, iterations } => format!(
                "The coupling took {updates} evaluations of the plastic law in {iterations} \
                 iterations; the accelerated one (`solver.coupling`) rarely takes more than 40."
            ),
            Self::Load { updates, iterations, increments, factorizations } => {
                let increments = increments.map(|increments| {
                    format!(
                        "the load is divided into {increments} increments \
                         (`solver.increments` sets their number)"
                    )
                });
                let factorizations = factorizations.map(|factorizations| {
                    format!(
                        "the iteration came to a standstill and went on by Newton's method, with \
                         {factorizations} factorizations of the stiffness"
                    )
                });
                let causes: Vec<String> = increments.into_iter().chain(factorizations).collect();
                let cause = if causes.is_empty() {
                    "what yields hardly hardens, or is near the limit load, so that contact and \
                     plastic flow settle slowly"
                        .to_owned()
                } else {
                    causes.join("; ")
                };
                format!(
                    "This load took {updates} evaluations of the plastic law in {iterations} \
                     iterations, of which others rarely take more than 40 for each increment of a \
                     history: {cause}."
                )
            }
            Self::Search { meshes, of_cells, of_histories, force } => {
                let [one, many] = if of_cells { ["grid", "grids"] } else { ["mesh", "meshes"] };
                let cause = if of_histories {
                    format!(
                        "each trial of a force is a history in increments on {many} of its own"
                    )
                } else {
                    format!("near the value the contact changes from {one} to {one}")
                };
                format!(
                    "The force was sought on {meshes} {many}, of which searches rarely take more \
                     than {MANY_MESHES}: {cause}. A force near {} (`load.force` or \
                     `load.history`) is solved at once.",
                    write.force_text(force)
                )
            }
            Self::FineMesh { elements, asked, equations } => format!(
                "Details of the surfaces take {elements:.0} elements over the half-width in place \
                 of {asked:.0}, and {:.1} million equations: the job takes some {:.0} times as \
                 long as one of smooth surfaces. A profile with points further apart, or a \
                 smoothed one, is faster.",
                equations as f64 / 1e6,
                (elements / asked).powi(2)
            ),
        }
    }
}

impl Wide {
    pub(super) fn text(self, write: UnitConverter) -> String {
        match self {
            Self::InHole { angle } => format!(
                "At the ends of the contact the normals of pin and hole differ by {:.0}° before \
                 loading; the theory takes them for one, and is meant for a clearance that is \
                 small beside the radii.",
                angle.to_degrees()
            ),
            Self::OverRadius { ratio, in_groove } => format!(
                "The half-width is {:.0} % of the smallest radius; {MEANT}{}.",
                100.0 * ratio,
                if in_groove { format!("; {CONFORMING_ADVICE}") } else { String::new() }
            ),
            Self::Slope { slope } => format!(
                "Within the contact a surface has a slope of {:.0} %; {MEANT}.",
                100.0 * slope
            ),
            Self::OverCurvature { ratio, radius } => format!(
                "The contact reaches {} of a radius of curvature ({}): half-spaces take surfaces \
                 for parabolas and bodies for large beside the contact.",
                rounded(ratio),
                write.exact_length(radius)
            ),
            Self::Inclined { angle } => format!(
                "At the ends of the contact the common normal is inclined by {:.0}°. Arcs and \
                 inclined forces are part of the solution, but the displacements are those of \
                 half-spaces.",
                angle.to_degrees()
            ),
            Self::Tilt { tilt, most } => format!(
                "The moment tilts the roller by {} mrad. Beyond {most} mrad, up to which a tilt \
                 may be given, rollers and half-spaces are no model of the contact: give a \
                 smaller moment.",
                rounded(tilt)
            ),
        }
    }
}

/// Elastic peak over yield stress, and by how much the peak pressure of lines and of balls lies above
/// that of flow theory up to there \[%\]: the most of seven hardening laws, 40 elements over the
/// half-width (`docs/theory.md`, section 4a; below twice the yield stress Ramberg and Osgood's law
/// has most; a perfectly plastic ball on a block at 4 σ_y, `docs/notes/flow_theory.md`).
const PEAKS_BEYOND_YIELD: [[f64; 3]; 4] =
    [[2.0, 4.0, 4.0], [3.0, 4.2, 5.8], [4.0, 7.5, 10.3], [5.0, 11.6, 12.8]];

impl Deformation {
    pub(super) fn text(self) -> String {
        let found = match self {
            Self::Line(ratio) => peak_beyond_yield(ratio, "lines", 1),
            Self::Ball(ratio) => peak_beyond_yield(ratio, "balls", 2),
            Self::Tip => {
                " The force of cones of 70.3° under an approach is 16 to 22 % below that \
                          of finite elements with flow theory (Dao et al. 2001)."
                    .to_owned()
            }
            Self::Other => String::new(),
        };
        format!(
            "Plasticity by deformation theory: exact where stresses grow in proportion, which they \
             do not below a growing contact.{found} Error bars are those of the mesh; the error of \
             the theory is not bounded. The theory `flow` (`solver.theory`) has none of it, and \
             tells unloading and residual stress."
        )
    }
}

/// Returns what is known of the peak pressure of contacts of one shape, whose figures are in this
/// column of the table.
fn peak_beyond_yield(ratio: f64, shape: &str, column: usize) -> String {
    let beyond = about(ratio);
    let [.., last] = PEAKS_BEYOND_YIELD;
    // To the digits that are shown.
    let known = PEAKS_BEYOND_YIELD.into_iter().find(|row| ratio < row[0] + 0.01).unwrap_or(last);
    format!(
        " The elastic peak is {beyond} times the yield stress; up to {} times, peak pressures of \
         {shape} are at most {} % above those of flow theory.",
        known[0], known[column]
    )
}
