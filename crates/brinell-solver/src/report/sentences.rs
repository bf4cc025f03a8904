//! The sentences of findings, in the units of a job.

use super::error_bars::name_of;
use super::findings::{
    Advice, CasePlace, Deformation, Density, Finding, HeightsFinding, MANY_MESHES, OnsetUnknown,
    Unconverged, Wide, Work,
};
use super::solve_error::track_text;
use super::suspicions;
use crate::job::{MeshSettings, Named as _, YIELD_OVER_HARDNESS};
use crate::solver::method::figures::Figure;
use crate::solver::{MAX_HALF_ANGLE, SolveStatus};
use crate::units::{UnitConverter, about, percent, rounded};

/// Advice for a round body that nearly fills its groove.
pub(super) const CONFORMING_ADVICE: &str = "a pin or ball that nearly fills what it lies in is \
                                            solved as a `cylinder` in a `hole`, up to 80° to each \
                                            side";

const MORE_ELEMENTS: &str = "Ask for more elements (`mesh.elements_per_half_width`).";
const MEANT: &str =
    "contact theory with small displacements and vertical gaps is meant for up to 10 %";

impl Finding {
    /// Returns the finding as sentences in the units of a job.
    #[expect(clippy::too_many_lines, reason = "one text for each finding")]
    pub fn text(&self, write: UnitConverter) -> String {
        let length = |core: f64| write.length_text(core);
        let small = |core: f64| write.length_about(core);
        match self {
            Self::NotConverged(cause) => cause.text(write),
            Self::Stopped { status, is_preliminary } => stopped(*status, *is_preliminary),
            Self::Work(work) => work.text(write),
            Self::Wide(wide) => wide.text(write),
            Self::Collapse { strain, last } => collapse(*strain, *last),
            Self::LargeStrain { strain } => format!(
                "Strain reaches {:.1} %; small-strain theory is meant for up to 5 %: it \
                 leaves out the change of shape.",
                100.0 * strain
            ),
            Self::DeformationTheory(deformation) => deformation.text(),
            Self::FallingLoads => {
                "Deformation theory takes each load from rest, whatever went before; for \
                 unloading choose the theory `flow`."
                    .to_owned()
            }
            Self::NoContact => {
                "At this approach the bodies do not touch: what earlier loads have left of the \
                 dent is deeper."
                    .to_owned()
            }
            Self::ElasticCorner { x } => format!(
                "A sharp corner carries pressure at x = {}. Elastic pressure has no bound there: \
                 the peak pressure is that of the mesh. It grows with the density of the mesh, \
                 and the force under which yield begins falls.",
                length(*x)
            ),
            Self::YieldingCorner { x } => format!(
                "The sharp corner at x = {} carries a pressure that grows with the density of the \
                 mesh, although the bodies yield: where they harden it has no bound. The peak \
                 pressure is that of the mesh.",
                length(*x)
            ),
            Self::Kinks => {
                "The profile of a roller is given by points: elastic pressure has no bound at its \
                 kinks, and grows there with finer cells. The peak pressure is that of the cells, \
                 without a bar."
                    .to_owned()
            }
            Self::AtEdge { in_hole: true } => format!(
                "The contact reaches beyond what is meshed of the hole. It is solved up to \
                 {MAX_HALF_ANGLE}° to each side: reduce the load, or widen the clearance."
            ),
            Self::AtEdge { in_hole: false } => {
                "The contact still reaches the edge of the meshed contact zone; pressure beyond \
                 it is missing."
                    .to_owned()
            }
            Self::Heights(finding) => finding.text(write),
            Self::FewElements { number, advice } => few(*number, *advice),
            Self::FewElementsOverPart { x, number } => format!(
                "The part of the contact at x = {} has only {number:.1} elements over half of its \
                 width: pressure, yield and the end of the contact there are those of the mesh. \
                 Ask for more elements (`mesh.elements_per_half_width`), or solve that part for \
                 itself.",
                length(*x)
            ),
            Self::RingOnFewElements { radius } => format!(
                "The contact is a ring of few elements at r = {}: its figures are those of the \
                 mesh, and their errors are not known. {MORE_ELEMENTS}",
                length(*radius)
            ),
            Self::PeakNextToEnd { x, spacing } => format!(
                "The largest pressure is at {}, next to an end of the contact, where it rises \
                 within elements of {}: it is that of the mesh. {MORE_ELEMENTS}",
                length(*x),
                small(*spacing)
            ),
            Self::EarlierLoads { unknown } => {
                let figures =
                    Figure::ALL.iter().filter(|figure| (0..2).any(|k| unknown.has(**figure, k)));
                let names: Vec<_> = figures.filter_map(|figure| name_of(*figure)).collect();
                format!(
                    "The mesh does not tell what an earlier load left in the bodies: {} are those \
                     of the mesh.",
                    names.join(", ")
                )
            }
            Self::ClampedColumn => {
                "A clamped body is deeper than wide: the mesh has few elements over its end, and \
                 the error of the approach, and of the force under a given approach, is not \
                 known. A body on rollers has no such end."
                    .to_owned()
            }
            Self::SurfaceStress { spacing, bodies } => format!(
                "Below the surface plastic strain changes within elements of {}: stresses along \
                 the surface, at the depth 0, are known to about {} only. {MORE_ELEMENTS}",
                small(*spacing),
                write.stress_text(
                    bodies.iter().flatten().map(|stress| stress.error).fold(0.0, f64::max)
                )
            ),
            Self::SmallApproach { error } => format!(
                "The approach that is left is smaller than its error of {}: it may as well be \
                 none, or of the other sign.",
                length(*error)
            ),
            Self::RoundedEdge { width, pressure, spacing, is_onset } => format!(
                "The contact ends within about {} on the rounded edges, where elastic bodies have \
                 a peak of about {} in closed form; elements of {} leave that out. {}What is away \
                 from the edges does not depend on it.",
                small(*width),
                write.stress_about(*pressure),
                small(*spacing),
                if *is_onset { "Onset of yield is that of the closed form. " } else { "" }
            ),
            Self::RoundedTip { arc, needed, pressure, spacing } => rounded_tip(
                arc.map(small),
                *needed,
                &write.stress_about(*pressure),
                &small(*spacing),
            ),
            Self::Details { needed, spacing } => format!(
                "Within the contact the surfaces have details that elements of {} resolve; those \
                 of this mesh have {}.",
                small(*needed),
                small(*spacing)
            ),
            Self::UnboundedStrain { .. } => {
                "The largest plastic strain of a material that does not harden has no limit on \
                 smaller and smaller elements, and is not given. The plastic area and the mean \
                 plastic strain in it have one where a single body flows; two that do not harden \
                 may share the flow otherwise on another mesh."
                    .to_owned()
            }
            Self::BilinearCurve => {
                "A bilinear curve is elastic up to its yield stress; steels begin to flow below \
                 that, little by little. Forces of a permanent deformation below 1 % strain \
                 differ by up to a factor of two from those of a measured curve: take the law \
                 `swift` or `table` (api/materials.json has 100Cr6)."
                    .to_owned()
            }
            Self::OnsetUnknown { cause, is_sought } => onset_unknown(*cause, *is_sought, write),
            Self::YieldByHardness => {
                let [slope, offset] = YIELD_OVER_HARDNESS;
                format!(
                    "The yield stress over depth follows from the hardness by σ_y = {} HV − {} \
                     (Pavlina and Van Tyne 2008), a regression over steels of 136 to 622 HV that \
                     scatters by some {}.",
                    rounded(write.stress(slope)),
                    write.stress_text(offset),
                    write.stress_about(100.0)
                )
            }
            Self::InitialYield { ratio } => format!(
                "The initial stress, after the body has relaxed, is {ratio:.3} times the yield \
                 stress somewhere: the body yields before it is loaded, and that flow is reckoned \
                 to the first load."
            ),
            Self::CoarseCase { change, place, wanted, .. } => {
                coarse_case(*change, *place, *wanted, write)
            }
            Self::NearSupport => {
                "A support is closer than five half-widths below the contact; it shapes the \
                 stresses, and Hertz's figures of half-spaces do not apply."
                    .to_owned()
            }
            Self::Suspicious(suspicion) => suspicions::text(suspicion, write),
            Self::HalfSpaces { reach, across_roller } => format!(
                "The bodies are half-spaces. They stand for bodies that reach at least {} beyond \
                 the contact {}and in depth.",
                small(*reach),
                if *across_roller { "across the roller " } else { "to all sides " },
            ),
            Self::NearLimit { coarse } => format!(
                "On half the columns something else becomes of the track ({}): the load lies near \
                 a limit, and the verdict may be wrong.",
                coarse.name().replace('_', " ")
            ),
            Self::FullSliding => {
                "The friction is that of full sliding, in the whole contact the pressure times \
                 its coefficient, and both bodies pass under the load: one that slides without \
                 turning must not yield."
                    .to_owned()
            }
            Self::RollerEnd { pressure, is_sharp, .. } => format!(
                "The contact runs to an end of the roller, with a pressure of {} in the outermost \
                 cells.{} A half-space goes on beyond the end and bears a part of the load there; \
                 a roller ends, gives way more and is pressed less at the end than is said here. \
                 Guilbault's factor (2011) would correct for it.",
                write.stress_text(*pressure),
                if *is_sharp {
                    " It grows without bound with finer cells, because the roller is straight up \
                     to its ends: a profile tells what it is."
                } else {
                    ""
                }
            ),
            Self::SurfaceEnd => {
                "The contact comes to the end of the heights, beyond which nothing touches: at \
                 the rim the pressure is too high and the surface too soft, as if the patch were \
                 a block that stands out of the body."
                    .to_owned()
            }
        }
    }
}

fn stopped(status: SolveStatus, is_preliminary: bool) -> String {
    let why = if status == SolveStatus::Cancelled {
        "Stopped on request"
    } else {
        "The deadline passed"
    };
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

fn collapse(strain: f64, last: Option<[f64; 2]>) -> String {
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

fn few(number: f64, advice: Density) -> String {
    match advice {
        Density::Elements => format!(
            "The half-width has only {number:.1} elements; ask for at least 10 \
             (`mesh.elements_per_half_width`)."
        ),
        Density::Cells => format!(
            "A semi-axis of the contact has only {number:.1} cells; ask for more \
             (`mesh.elements_per_half_width`)."
        ),
        Density::Heights => format!(
            "A semi-axis of the contact has only {number:.1} cells; finer heights tell more."
        ),
    }
}

fn rounded_tip(arc: Option<String>, needed: f64, pressure: &str, spacing: &str) -> String {
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

fn onset_unknown(cause: OnsetUnknown, is_sought: bool, write: UnitConverter) -> String {
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

fn coarse_case(change: f64, place: CasePlace, wanted: f64, write: UnitConverter) -> String {
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
    fn text(&self, write: UnitConverter) -> String {
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
                        "Newton's method, to which the accelerated coupling turns last, came to \
                         no end either: do not use the figures. A smaller load or a little \
                         hardening may have an answer.",
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
    fn text(&self, write: UnitConverter) -> String {
        match *self {
            Self::Coupling { updates, iterations } => format!(
                "The coupling took {updates} evaluations of the plastic law in {iterations} \
                 iterations; the accelerated one (`solver.coupling`) rarely takes more than 40."
            ),
            Self::Load { updates, iterations, increments, factorizations } => {
                let increments = increments.map(|increments| {
                    format!(
                        "the load is divided into {increments} increments, until half as many \
                         change little (`solver.increments` sets their number)"
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

impl HeightsFinding {
    fn text(self, write: UnitConverter) -> String {
        match self {
            Self::FewCells { number, part } => format!(
                "Spots of fewer than 5 cells over half of their width bear {:.0} % of the force; \
                 a typical spot has {number:.1}. Pressure, approach and yield are those of the \
                 cells, and their errors are not known: finer heights, or heights whose short \
                 waves are filtered out, tell more.",
                100.0 * part
            ),
            Self::Steps { part } => format!(
                "Beside spots that bear {:.0} % of the force the heights fall by more than the \
                 spots are pressed in: such a step is a sharp corner, at which the pressure grows \
                 with finer cells. The peak pressure is that of the cells.",
                100.0 * part
            ),
            Self::Unbearable { pressure, bearable } => format!(
                "The largest pressure, {}, is above {}, four times the flow stress, of which a \
                 square punch carries 3.3 times: it is that of single cells, and no answer.",
                write.stress_text(pressure),
                write.stress_text(bearable)
            ),
        }
    }
}

impl Wide {
    fn text(self, write: UnitConverter) -> String {
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
/// has most).
const PEAKS_BEYOND_YIELD: [[f64; 3]; 4] =
    [[2.0, 4.0, 4.0], [3.0, 4.2, 5.8], [4.0, 7.5, 9.9], [5.0, 11.6, 12.8]];

impl Deformation {
    fn text(self) -> String {
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
