//! The table of findings: each with its data, its code, the bars that it takes, its rows of
//! `docs/validity.md` and its sentence.

use super::kinds::{
    BELOW, CasePlace, Deformation, FinerBy, Missed, OnsetUnknown, PEAK_AND_BELOW, Row, Section,
    Takes, Unconverged, Wide, Work,
};
use super::sentences::{
    MORE_ELEMENTS, coarse_case, collapse, few, onset_unknown, rounded_tip, stopped,
};
use crate::job::{BENDING_OF_HARDNESS, Named as _, NoData, TestScale, YIELD_OVER_HARDNESS};
use crate::material::fatigue::FatigueStrength;
use crate::report::figure_names::name_of;
use crate::report::rolling::TrackVerdict;
use crate::report::surface_stress::UncertainStress;
use crate::solver::MAX_HALF_ANGLE;
use crate::solver::method::figures::{Figure, FigureSet};
use crate::units::{UnitConverter, percent, rounded};

/// Declares [`Finding`]: variants, codes, bars, rows of the document and sentences.
macro_rules! findings {
    ($(
        $(#[doc = $doc:literal])+
        $name:ident $(($part:ident: $of:ty))? $({ $($field:ident: $type:ty),+ $(,)? })?
        => $code:literal, $takes:expr,
        $(row $section:ident $condition:literal $meaning:literal,)*
        |$write:pat_param| $text:expr;
    )+) => {
        /// One limit of the answer to a load step. Lengths in mm, stresses in MPa, forces in N/mm
        /// or N.
        #[derive(Debug, Clone, PartialEq)]
        pub(in crate::report) enum Finding {
            $($(#[doc = $doc])+ $name $(($of))? $({ $($field: $type),+ })?,)+
        }

        /// The rows of the document, in the order of the variants.
        pub(super) const ROWS: &[Row] = &[
            $($(Row {
                code: $code,
                section: Section::$section,
                condition: $condition,
                meaning: $meaning,
                takes: $takes,
            },)*)+
        ];

        impl Finding {
            /// Returns the code of the remark.
            pub const fn code(&self) -> &'static str {
                match self {
                    $(Self::$name { .. } => $code,)+
                }
            }

            /// Returns the bars that a finding of this kind takes.
            pub(super) const fn takes(&self) -> Takes {
                match self {
                    $(Self::$name { .. } => $takes,)+
                }
            }

            /// Returns the finding as sentences in the units of a job.
            #[expect(unused_variables, reason = "some sentences need no data")]
            pub fn text(&self, write: UnitConverter) -> String {
                match self {
                    $(Self::$name $(($part))? $({ $($field),+ })? => {
                        let $write = write;
                        String::from($text)
                    })+
                }
            }
        }
    };
}

/// Figures of a contact that runs to an end of a roller: the surface is deepest there too.
const AT_END: [Figure; 8] = [
    Figure::PeakPressure,
    Figure::Dent,
    Figure::PileUp,
    Figure::MaxPlasticStrain,
    Figure::MeanPlasticStrain,
    Figure::PlasticArea,
    Figure::LeastStress,
    Figure::LargestVonMises,
];

findings! {
    /// The step has not converged.
    NotConverged(cause: Unconverged) => "not_converged", Takes::Estimate,
    row State
        "the iteration limit is reached; or no force meets the figure that is sought; or the \
         final state fails the check of equilibrium (`solver.tolerance`) or of the contact \
         conditions (1e-8 of the largest forces and displacements of the history)"
        "the figures are those of the last iteration, of a diverged one those without plastic \
         load. They are no answer. The message names the failed condition, its size and a remedy",
    |write| cause.text(write);

    /// Somebody stopped the job.
    Cancelled { is_preliminary: bool } => "cancelled", Takes::Estimate,
    row State
        "somebody stopped the job"
        "the figures are those of the last iteration. Later loads of a history have those of the \
         coarser mesh; the message says so. There are no stresses and strains",
    |_| stopped("Stopped on request", *is_preliminary);

    /// The deadline of the job passed.
    TimedOut { is_preliminary: bool } => "timed_out", Takes::Estimate,
    row State
        "its deadline passed"
        "as above",
    |_| stopped("The deadline passed", *is_preliminary);

    /// The load took far more work than usual.
    Work(work: Work) => "slow_coupling", Takes::Nothing,
    row State
        "`strong`, `weak` or `secant_stiffness` took more than 200 evaluations of the plastic law \
         for a load; with `accelerated` a factorization counts as ten; a force was sought on more \
         than 40 meshes; details of the surfaces take more than twice the elements that were \
         asked for, and more than a million equations"
        "`accelerated` rarely takes more than 40 evaluations. The message names the cause: many \
         increments, Newton's method after a standstill, contact and flow that settle slowly, \
         trials of a force that are histories, or a fine mesh. The counts are the same on every \
         machine",
    |write| work.text(write);

    /// The contact is wide beside the radii of the surfaces.
    Wide(wide: Wide) => "wide_contact", Takes::Nothing,
    row Theory
        "a > 0.1 of the smallest of R and both radii of curvature; without a radius, a slope \
         above 0.15 between two nodes in contact; for a pin in a hole, normals that differ by \
         more than 0.1 at the ends of the contact; in three dimensions along an axis along which \
         the bodies conform, normals inclined by more than 0.5"
        "displacements are taken as small and gaps as vertical. At a/R = 0.12 the NAFEMS contact \
         shows 0.2 % in the peak pressure. A pin that nearly fills its groove should be a \
         `cylinder` in a `hole`",
    |write| wide.text(write);

    /// The plastic strain is so large that the bodies do not bear the load. A history has the
    /// start and the size of its last increment, as parts of the load.
    Collapse { strain: f64, last: Option<[f64; 2]> } => "collapse", Takes::Estimate,
    row State
        "plastic strain above 100 % over more than a²/50 of a section"
        "under deformation theory the load is at or beyond the limit load. Under flow theory the \
         smallest increment has no answer with small strains, and the history ends there. The \
         step is `not_converged` and has no error bars",
    |_| collapse(*strain, *last);

    /// The plastic strain is too large for small-strain theory.
    LargeStrain { strain: f64 } => "large_strain", Takes::Nothing,
    row Theory
        "plastic strain above 5 % at a Gauss point (under flow theory the equivalent strain, if \
         that is less)"
        "rotations and the change of shape are left out",
    |_| format!(
                "Strain reaches {:.1} %; small-strain theory is meant for up to 5 %: it \
                 leaves out the change of shape.",
                100.0 * strain
            );

    /// The bodies yield by deformation theory.
    DeformationTheory(deformation: Deformation) => "deformation_theory", Takes::Nothing,
    row Theory
        "plastic strain under deformation theory"
        "the theory is exact only where stresses grow in proportion. Error bars are those of the \
         mesh; that of the theory is not bounded. The message says how far peaks of its shape lie \
         above those of flow theory ([below](#deformation-theory)). Unloading and residual stress \
         need `\"theory\": \"flow\"`",
    |_| deformation.text();

    /// Loads fall under deformation theory.
    FallingLoads => "falling_loads", Takes::Nothing,
    row Theory
        "a history falls under deformation theory"
        "each load is taken from rest",
    |_| "Deformation theory takes each load from rest, whatever went before; for \
                 unloading choose the theory `flow`.";

    /// Bodies with a dent do not touch at the approach that is given.
    NoContact => "no_contact", Takes::Nothing,
    row State
        "under flow theory, the bodies do not touch at an approach above zero"
        "the dent of earlier loads is deeper",
    |_| "At this approach the bodies do not touch: what earlier loads have left of the \
                 dent is deeper.";

    /// A sharp corner carries pressure on elastic bodies.
    ElasticCorner { x: f64 } => "sharp_corner", Takes::Figures(&PEAK_AND_BELOW),
    row Mesh
        "a sharp corner carries pressure and nothing yields, or the curve of what yields rises \
         without bound; or it carries the peak, which half the elements change by more than 2 %"
        "elastic pressure has no bound there, nor has that of a body that hardens. The peak \
         pressure is that of the mesh. The peak, stress and strain have no bars",
    |write| format!(
                "A sharp corner carries pressure at x = {}. Elastic pressure has no bound there: \
                 the peak pressure is that of the mesh. It grows with the density of the mesh, \
                 and the force under which yield begins falls.",
                write.length_text(*x)
            );

    /// A sharp corner of bodies that yield carries pressure that grows with the density of the mesh.
    YieldingCorner { x: f64 } => "sharp_corner", Takes::Figures(&PEAK_AND_BELOW),
    |write| format!(
                "The sharp corner at x = {} carries a pressure that grows with the density of the \
                 mesh, although the bodies yield: where they harden it has no bound. The peak \
                 pressure is that of the mesh.",
                write.length_text(*x)
            );

    /// The points of a roller's profile make kinks.
    Kinks => "sharp_corner", Takes::Figures(&PEAK_AND_BELOW),
    |_| "The profile of a roller is given by points: elastic pressure has no bound at its \
                 kinks, and grows there with finer cells. The peak pressure is that of the cells, \
                 without a bar.";

    /// The contact reaches the edge of what is meshed.
    AtEdge { in_hole: bool } => "contact_at_edge", Takes::Nothing,
    row State
        "the contact reaches the end of the meshed zone after the zone has become as wide as the \
         surfaces allow; for a pin in a hole beyond 80°"
        "pressure beyond the zone is missing. The step is `not_converged`",
    |_| if *in_hole { format!(
                "The contact reaches beyond what is meshed of the hole. It is solved up to \
                 {MAX_HALF_ANGLE}° to each side: reduce the load, or widen the clearance."
            ) } else { {
                "The contact still reaches the edge of the meshed contact zone; pressure beyond \
                 it is missing."
                    .to_owned()
            } };

    /// Few elements or cells over the half-width. `unit` is one of the two.
    FewElements { number: f64, advice: FinerBy } => "coarse_mesh", Takes::Nothing,
    row Mesh
        "fewer than 9 elements over a, or over half the width of a part that carries at least 5 % \
         of the force"
        "the end of a contact is known to half an element, which is more than 5 % of a. A mesh of \
         10 elements may turn out to have 9.5, hence 9. Parts are resolved down to a sixth of a",
    |_| few(*number, *advice);

    /// Few elements over a part of the contact.
    FewElementsOverPart { x: f64, number: f64 } => "coarse_mesh", Takes::Nothing,
    |write| format!(
                "The part of the contact at x = {} has only {number:.1} elements over half of its \
                 width: pressure, yield and the end of the contact there are those of the mesh. \
                 Ask for more elements (`mesh.elements_per_half_width`), or solve that part for \
                 itself.",
                write.length_text(*x)
            );

    /// The contact of bodies of revolution is a ring of few elements.
    RingOnFewElements { radius: f64 } => "coarse_mesh", Takes::Estimate,
    row Mesh
        "a body of revolution touches in a ring of fewer than 9 elements"
        "nothing bounds the errors",
    |write| format!(
                "The contact is a ring of few elements at r = {}: its figures are those of the \
                 mesh, and their errors are not known. {MORE_ELEMENTS}",
                write.length_text(*radius)
            );

    /// The peak pressure is next to an end of the contact.
    PeakNextToEnd { x: f64, spacing: f64 } => "coarse_mesh", Takes::Figures(&PEAK_AND_BELOW),
    row Mesh
        "the largest pressure is within 4 elements of an end of a contact of more than 6 to each \
         side, beside the middle; of a body of revolution within 5 elements of an end of its \
         part, beside the axis"
        "pressure rises within elements there",
    |write| format!(
                "The largest pressure is at {}, next to an end of the contact, where it rises \
                 within elements of {}: it is that of the mesh. {MORE_ELEMENTS}",
                write.length_text(*x),
                write.length_about(*spacing)
            );

    /// The mesh has not resolved the peak pressure of an earlier load.
    EarlierLoads { unknown: FigureSet } => "coarse_mesh", Takes::Figures(&BELOW),
    row Mesh
        "an earlier load of a history has figures of the bodies, or a peak, without a bar"
        "nor have the figures of the bodies that it left; the message names them",
    |_| {
                let figures =
                    Figure::ALL.iter().filter(|figure| (0..2).any(|k| unknown.has(**figure, k)));
                let names: Vec<_> = figures.filter_map(|figure| name_of(*figure)).collect();
                format!(
                    "The mesh does not tell what an earlier load left in the bodies: {} are those \
                     of the mesh.",
                    names.join(", ")
                )
            };

    /// A clamped body is deeper than wide.
    ClampedColumn
    => "coarse_mesh", Takes::Figures(&[Figure::Approach, Figure::Force, Figure::Dent]),
    row Mesh
        "a clamped body of a plane analysis is deeper than wide"
        "its end is kept from widening over few elements: approach, dent and, under a given \
         approach, the force have no bar",
    |_| "A clamped body is deeper than wide: the mesh has few elements over its end, and \
                 the error of the approach, and of the force under a given approach, is not \
                 known. A body on rollers has no such end.";

    /// The stress at the surface of a body changes within elements.
    SurfaceStress { spacing: f64, bodies: [Option<UncertainStress>; 2] }
    => "coarse_mesh", Takes::Nothing,
    row Mesh
        "the plastic strain changes within the first two elements below the surface, by what is a \
         tenth of the largest von Mises stress as half of a stress; or the stress at the surface \
         is above the largest that elements have borne by as much, to which it is limited"
        "the message has the error of the stresses at the depth 0; the bars of residual stress \
         and utilization have as much of it on top as the surface may have more than the depths \
         below",
    |write| format!(
                "Below the surface plastic strain changes within elements of {}: stresses along \
                 the surface, at the depth 0, are known to about {} only. {MORE_ELEMENTS}",
                write.length_about(*spacing),
                write.stress_about(
                    bodies.iter().flatten().map(|stress| stress.error).fold(0.0, f64::max)
                )
            );

    /// The permanent approach is smaller than its error.
    SmallApproach { error: f64 } => "coarse_mesh", Takes::Nothing,
    row Mesh
        "the approach that a history leaves is smaller than its error"
        "it may as well be none, or of the other sign",
    |write| format!(
                "The approach that is left is smaller than its error of {}: it may as well be \
                 none, or of the other sign.",
                write.length_text(*error)
            );

    /// Elements leave out a rounded edge.
    RoundedEdge { width: f64, pressure: f64, spacing: f64, is_onset: bool }
    => "coarse_mesh", Takes::AllButMiddlePressure,
    row Mesh
        "fewer than four elements over a rounded edge in contact"
        "the message has the peak of elastic bodies in closed form. Only the pressure in the \
         middle has a bar, with half an element over the half-width on top",
    row Mesh
        "at the onset of yield the contact ends on a rounded edge that elements leave out"
        "`force` is that of first yield in closed form. Its bar is 1.5 % and what the pressure in \
         the middle is off from that of a flat punch on a half-space. Exact half-planes: within 1 % \
         for flats of 4 mm with edges of 0.02 to 1 mm; meshes that resolve the edge: within 1 to \
         3 % in all three analyses",
    |write| format!(
                "The contact ends within about {} on the rounded edges, where elastic bodies have \
                 a peak of about {} in closed form; elements of {} leave that out. {}What is away \
                 from the edges does not depend on it.",
                write.length_about(*width),
                write.stress_about(*pressure),
                write.length_about(*spacing),
                if *is_onset { "Onset of yield is that of the closed form. " } else { "" }
            );

    /// Elements leave out a tip. `needed` elements over the half-width resolve the arc.
    RoundedTip { arc: Option<f64>, needed: f64, pressure: f64, spacing: f64 }
    => "coarse_mesh", Takes::Figures(&PEAK_AND_BELOW),
    row Mesh
        "fewer than four elements over half of a rounded tip; a power below 2"
        "the message has the peak of elastic bodies in closed form and the elements that would \
         resolve the tip",
    |write| rounded_tip(
                arc.map(|arc| write.length_about(arc)),
                *needed,
                &write.stress_about(*pressure),
                &write.length_about(*spacing),
            );

    /// Elements leave out details of the surfaces.
    Details { needed: f64, spacing: f64 } => "coarse_mesh", Takes::Nothing,
    row Mesh
        "elements larger than the details of a surface given by points within the contact, or \
         than half of the parts in which half-planes of such surfaces touch"
        "pressure, yield and its onset there are those of the mesh",
    |write| format!(
                "Within the contact the surfaces have details that elements of {} resolve; those \
                 of this mesh have {}.",
                write.length_about(*needed),
                write.length_about(*spacing)
            );

    /// The largest plastic strain has no limit on finer meshes.
    UnboundedStrain { bodies: [bool; 2] }
    => "unbounded_strain", Takes::Figures(&[Figure::MaxPlasticStrain]),
    row Mesh
        "a body yields whose curve does not rise any more, or at the ends of the contact alone"
        "the largest plastic strain has no limit on smaller and smaller elements and is `null`. \
         `area` and `mean_equivalent_plastic_strain` do not depend on the mesh",
    |_| "The largest plastic strain of a material that does not harden, and at the ends of a \
                 contact, grows on smaller elements, and is not given. The plastic area and the mean \
                 plastic strain in it have one where a single body flows; two that do not harden \
                 may share the flow otherwise on another mesh.";

    /// The largest plastic strain is that beside the ends of the contact.
    StrainAtEnds { strain: f64 } => "unbounded_strain", Takes::Nothing,
    row Mesh
        "plastic strain is largest within a tenth of the half-width of an end of the contact, or \
         beyond it, and of the surface"
        "it grows there on smaller elements, where no edge is rounded without limit, whether the \
         body hardens or not. The largest plastic strain that is given is that beside these places",
    |_| format!(
                "At the ends of the contact plastic strain reaches {} on this mesh and grows on \
                 smaller elements. The largest plastic strain that is given is that \
                 deeper, or further inside, than a tenth of the half-width.",
                percent(*strain)
            );

    /// A figure misses the accuracy that the job asks for.
    AccuracyMissed { figure: Option<(String, f64)>, why: Missed } => "accuracy_missed", Takes::Nothing,
    row Mesh
        "`mesh.accuracy` is not met by every figure that answers the job and has a bound, or none has one"
        "the message names the figure with the largest error, and what stopped the refinement: four \
         times the elements of the job, a finer mesh without an answer, or the time. It is in \
         `validity` beside `steps`",
    |_| {
                let why = match why {
                    Missed::Elements(most) => {
                        format!("on {most} elements, the most that are tried from this mesh")
                    }
                    Missed::NoAnswer(next) => format!("and {next} elements have no answer"),
                    Missed::Stopped(next) => {
                        format!("and the job was stopped before {next} elements had an answer")
                    }
                };
                match figure {
                    Some((label, error)) => {
                        format!("The {} has ± {}, {why}.", label.to_lowercase(), percent(*error))
                    }
                    None => format!("No figure that answers the job has a bound, {why}."),
                }
            };

    /// A permanent deformation is computed with a bilinear curve.
    BilinearCurve => "bilinear_curve", Takes::Nothing,
    row Theory
        "a permanent deformation or a plastic strain is the target, a body is bilinear, and the \
         largest plastic strain is below 1 %"
        "steels begin to flow below the yield stress of a bilinear fit. The ISO 76 force of one \
         100Cr6 contact is 613 N by a bilinear curve and 1086 N by a published Swift curve",
    |_| "A bilinear curve is elastic up to its yield stress; steels begin to flow below \
                 that, little by little. Forces of a permanent deformation below 1 % strain \
                 differ by up to a factor of two from those of a measured curve: take the law \
                 `swift` or `table` (api/materials.json has 100Cr6).";

    /// The force at the onset of yield is not known. A job that seeks it has no answer.
    OnsetUnknown { cause: OnsetUnknown, is_sought: bool } => "onset_unknown", Takes::Nothing,
    row Mesh
        "no body yields on the mesh, but in closed form elastic bodies yield on a rounded edge \
         that elements leave out; at the onset of yield where that bar is above 15 %, and where a \
         sharp corner carries pressure; or the largest pressure is next to an end of the contact"
        "that no body yields holds for the mesh only, and the message has the force of the closed \
         form. At the onset of yield `force` is not that of first yield, and the step has no bars",
    |write| onset_unknown(*cause, *is_sought, write);

    /// The yield stress follows from the hardness.
    YieldByHardness => "yield_by_hardness", Takes::Nothing,
    row Theory
        "σ_y follows from hardness"
        "σ_y = 2.876 HV − 90.7 MPa is a regression over steels of 136 to 622 HV that scatters by \
         some 100 MPa",
    |write| {
                let [slope, offset] = YIELD_OVER_HARDNESS;
                format!(
                    "The yield stress over depth follows from the hardness by σ_y = {} HV − {} \
                     (Pavlina and Van Tyne 2008), a regression over steels of 136 to 622 HV that \
                     scatters by some {}.",
                    rounded(write.stress(slope)),
                    write.stress_text(offset),
                    write.stress_about(100.0)
                )
            };

    /// A body yields before it is loaded; the stress over the yield stress.
    InitialYield { ratio: f64 } => "initial_yield", Takes::Nothing,
    row Theory
        "the mean stress of an element before the load, after relaxation, is above σ_y"
        "the body yields before it is loaded. That flow is found with the first load",
    |_| format!(
                "The initial stress, after the body has relaxed, is {ratio:.3} times the yield \
                 stress somewhere: the body yields before it is loaded, and that flow is reckoned \
                 to the first load."
            );

    /// The strength changes within an element or a layer.
    CoarseCase { change: f64, place: CasePlace, wanted: f64, bodies: [bool; 2] }
    => "coarse_case", Takes::Figures(&BELOW),
    row Mesh
        "strength over depth changes by more than 10 % within an element whose von Mises stress \
         is above half of its σ_y"
        "which part of the element yields is known to its size only. The message says how many \
         elements would do. Stress and strain of the body have no bars",
    |write| {
                coarse_case(*change, *place, *wanted, write)
            };

    /// A support is close below the contact.
    NearSupport => "near_support", Takes::Nothing,
    row Theory
        "a deformable body is less deep than 5 a"
        "the support shapes the stresses. Hertz's figures beside the answer do not apply",
    |_| "A support is closer than five half-widths below the contact; it shapes the \
                 stresses, and Hertz's figures of half-spaces do not apply.";

    /// The bodies are half-spaces; they must reach this far beyond the contact.
    HalfSpaces { reach: f64, across_roller: bool } => "half_spaces", Takes::Nothing,
    row Theory
        "every contact in three dimensions; a load that rolls"
        "the bodies are half-spaces. They stand for bodies that reach at least three of the \
         longer semi-axes beyond the contact, to all sides and in depth, half-planes five \
         half-widths; the message has the length",
    |write| format!(
                "The bodies are half-spaces. They stand for bodies that reach at least {} beyond \
                 the contact {}and in depth.",
                write.length_about(*reach),
                if *across_roller { "across the roller " } else { "to all sides " },
            );

    /// The contact runs to an end of a roller.
    RollerEnd { pressure: f64, is_sharp: bool, is_all: bool }
    => "roller_end", Takes::Figures(&AT_END),
    row Theory
        "a contact that runs to an end of a roller"
        "a half-space goes on beyond the end and bears a part of the load there; a roller ends, \
         gives way more and is pressed less at the end than is said. The pressure at sharp ends \
         grows without bound with finer cells. Guilbault's factor (2011) would correct for the \
         free end; it is not used. The half-width has no bar either where nothing touches clear \
         of the ends",
    |write| format!(
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
            );

    /// The contact runs to the rim of the heights.
    SurfaceEnd => "surface_end", Takes::Figures(&PEAK_AND_BELOW),
    row Theory
        "heights of a surface that touch at their rim"
        "beyond the heights there is nothing to touch, so that the rim is that of a block that \
         stands out of the body: the pressure there is too high",
    |_| "The contact comes to the end of the heights, beyond which nothing touches: at \
                 the rim the pressure is too high and the surface too soft, as if the patch were \
                 a block that stands out of the body.";

    /// A part of the force is borne by spots of few cells; cells over half of a typical spot.
    SpotsOfFewCells { number: f64, part: f64 } => "coarse_mesh", Takes::Estimate,
    row Mesh
        "heights touch in spots of fewer than 5 cells over half of their width (that of a circle \
         of as many cells) that bear at least 5 % of the force"
        "a ball that yields has an approach 8 % too small on 3 cells and 3 % on 5, which half the \
         cells do not show. Nothing has a bar",
    |_| format!(
        "Spots of fewer than 5 cells over half of their width bear {:.0} % of the force; a typical \
         spot has {number:.1}. Pressure, approach and yield are those of the cells, and their errors \
         are not known: finer heights, or heights whose short waves are filtered out, tell more.",
        100.0 * part
    );

    /// A part of the force is borne by spots beside which the heights have a step.
    StepsOfHeights { part: f64 } => "sharp_corner", Takes::Figures(&PEAK_AND_BELOW),
    row Mesh
        "heights that fall from one cell to the next by more than a spot is pressed in, beside \
         spots that bear at least 5 % of the force"
        "elastic pressure has no bound there",
    |_| format!(
        "Beside spots that bear {:.0} % of the force the heights fall by more than the spots are \
         pressed in: such a step is a sharp corner, at which the pressure grows with finer cells. \
         The peak pressure is that of the cells.",
        100.0 * part
    );

    /// The largest pressure of heights is above what the flow stress carries.
    UnbearablePressure { pressure: f64, bearable: f64 }
    => "coarse_mesh", Takes::Figures(&PEAK_AND_BELOW),
    row Mesh
        "the largest pressure of heights is above four times the flow stress of the softer body, \
         where at most 30 % of the surface touch"
        "a square punch carries 3.3 flow stresses (5.71 k), a ball has a peak of 3.0: more is a \
         rise at single cells. `answers` have no peak pressure",
    |write| format!(
        "The largest pressure, {}, is above {}, four times the flow stress, of which a square punch \
         carries 3.3 times: it is that of single cells, and no answer.",
        write.stress_text(*pressure),
        write.stress_text(*bearable)
    );

    /// On half the columns something else becomes of the track.
    NearLimit { coarse: TrackVerdict } => "near_limit", Takes::Nothing,
    row Theory
        "a load that rolls has another verdict on half the columns"
        "the load lies near a limit of shakedown, which on columns lies up to 1 % higher; the \
         verdict may be wrong",
    |_| format!(
                "On half the columns something else becomes of the track ({}): the load lies near \
                 a limit, and the verdict may be wrong.",
                coarse.name().replace('_', " ")
            );

    /// A body has limits of fatigue.
    Fatigue { rolls: bool, is_meshed: bool } => "fatigue", Takes::Nothing,
    row Theory
        "a body has limits of fatigue"
        "the criteria are those of high-cycle fatigue below the surface. The path is one elastic \
         pass of the pressure over a half-space, of a load that rolls after its last pass; residual \
         stress of the yield of meshed bodies is not in it",
    |_| format!(
                "Fatigue is that of {} over half-spaces{}. Damage that starts at the surface, \
                 lubricant and inclusions are not in it, and residual compression helps less than \
                 Dang Van's criterion says.",
                if *rolls {
                    "one more pass, which is elastic,"
                } else {
                    "one elastic pass of this pressure, along x,"
                },
                if *is_meshed { ", without the residual stress of yield" } else { "" },
            );

    /// Limits of fatigue follow from the hardness.
    FatigueByHardness => "fatigue_by_hardness", Takes::Nothing,
    row Theory
        "limits of fatigue follow from hardness"
        "1.6 HV in bending is a regression over steels of up to 400 HV that scatters by 0.1 HV; \
         harder steels, which inclusions decide on, have the limit of 400 HV",
    |_| format!(
                "The fatigue limits follow from the hardness by {BENDING_OF_HARDNESS}, in MPa; the \
                 regression scatters by 0.1 HV, and harder steels have the limit of {} HV, since \
                 inclusions decide on them.",
                FatigueStrength::HARDEST
            );

    /// The friction of a load that rolls slides over the whole contact.
    FullSliding => "full_sliding", Takes::Nothing,
    row Theory
        "a load that rolls with friction"
        "the traction is μ times the pressure in the whole contact, and both bodies pass under \
         the load. One that slides without turning must not yield",
    |_| "The friction is that of full sliding, in the whole contact the pressure times \
                 its coefficient, and both bodies pass under the load: one that slides without \
                 turning must not yield.";

    /// The pressures act along inclined normals: their sum is larger than the force.
    InclinedPressure { ratio: f64 } => "inclined_pressure", Takes::Nothing,
    row Theory
        "in three dimensions the pressures of conforming bodies sum to more than 1.01 times the \
         force"
        "pressures act along the normals, which are inclined at the ends of the contact; of each \
         a part alone counts for the force. `mean_pressure` is the mean along the normals",
    |_| format!(
        "The pressures sum to {:.1} % more than the force: they act along the normals of the \
         surfaces, which are inclined at the ends of the contact.",
        100.0 * (ratio - 1.0)
    );

    /// A job in SI has a Young's modulus that is one of steel in MPa.
    MillimetresInSi { pointer: String } => "suspicious_units", Takes::Nothing,
    row Theory
        "the job is in SI with a Young's modulus below 1 MPa; a yield stress is above a tenth or \
         below 1e-5 of Young's modulus"
        "no solid has such figures, which are probably in another unit. Then every figure is \
         wrong by powers of ten. The message names the field and, where there is one, the figure \
         that would fit",
    |_| format!(
        "`{pointer}`: Units are SI, but the figures look like millimetres, newtons and \
         megapascals: metres, N/m and pascals are expected. If they are meant in mm, leave \
         `units` out."
    );

    /// No solid has this yield stress beside this Young's modulus; the figure that would fit.
    YieldBesideModulus {
        pointer: String,
        yield_stress: f64,
        young_modulus: f64,
        meant: Option<f64>,
    } => "suspicious_units", Takes::Nothing,
    |write| {
        let meant = meant.map_or_else(String::new, |meant| {
            format!(" {} would fit: is it given in another unit?", write.stress_text(meant))
        });
        format!(
            "`{pointer}`: The yield stress, {}, is {:.3e} times Young's modulus, {}; no firm solid \
             is like that.{meant}",
            write.stress_text(*yield_stress),
            yield_stress / young_modulus,
            write.stress_text(*young_modulus),
        )
    };

    /// A table of plastic strain looks like one of total strain; its yield stress, and that of
    /// total strain.
    TotalStrain { pointer: String, given: f64, meant: Option<f64> }
    => "suspicious_curve", Takes::Nothing,
    row Theory
        "a table of plastic strain rises from a twentieth of its last stress or less, or its \
         second point lies at σ/E; its plastic strains are as large and as coarse as figures in \
         per cent are; `offset` of `ramberg_osgood` lies between 5e-5 and 0.02"
        "total strain was given as plastic, strain is in per cent, the offset is the strain of a \
         proof stress. The message has the figure that changes",
    |write| {
        let meant = meant.map_or_else(String::new, |meant| format!(
            " As total strain it has a yield stress of {}, not {}.",
            write.stress_text(meant),
            write.stress_text(*given)
        ));
        format!(
            "`{pointer}`: The table looks like total strain, elastic part included, and plastic \
             strain is expected.{meant} `POST /v1/hardening-curves` and \"From total strain\" on \
             the page convert it."
        )
    };

    /// Plastic strains look like per cent; stresses at a plastic strain of 1 %.
    StrainInPercent { pointer: String, largest: f64, given: f64, meant: f64 }
    => "suspicious_curve", Takes::Nothing,
    |write| format!(
        "`{pointer}`: Plastic strain goes up to {}, {:.0} %: is it given in per cent? At a plastic \
         strain of 1 % the stress is {} now, and would be {}.",
        rounded(*largest),
        100.0 * largest,
        write.stress_text(*given),
        write.stress_text(*meant),
    );

    /// The offset of Ramberg and Osgood's law, a factor, is the strain of a proof stress; the
    /// plastic strain at the reference stress, and the factor that makes the offset that strain.
    OffsetIsStrain { pointer: String, offset: f64, strain: f64, factor: f64 }
    => "suspicious_curve", Takes::Nothing,
    |_| format!(
        "`{pointer}`: `offset` is the factor a of ε_p = a (σ_0/E) (q/σ_0)^m, and {} looks like the \
         strain of a proof stress: the plastic strain at the reference stress is {} now. For {} \
         there a is {}.",
        rounded(*offset),
        rounded(*strain),
        rounded(*offset),
        rounded(*factor),
    );

    /// A table over depth, a case or an initial stress goes on far beyond any case.
    DeepProfile { pointer: String, deepest: f64 } => "suspicious_profile", Takes::Nothing,
    row Theory
        "a table over depth, a case depth or an initial stress goes on beyond 100 mm; no hardness \
         is above 70 HV"
        "depths in micrometres, HRC taken for HV",
    |write| format!(
        "`{pointer}`: The depths go on to {}: are they in a unit a thousand times smaller? Then the \
         last is {}.",
        write.length_text(*deepest),
        write.length_text(deepest / 1e3)
    );

    /// All hardnesses are such as the scale HRC has.
    RockwellAsVickers { pointer: String, largest: f64 } => "suspicious_profile", Takes::Nothing,
    |_| format!(
        "`{pointer}`: No hardness is above {}: these look like HRC, and HV is expected. Say \
         `\"hardness_scale\": \"HRC\"` if they are.",
        rounded(*largest)
    );

    /// Many heights have exactly one value, and all others differ.
    OneHeight { pointer: String, heights: NoData } => "suspicious_heights", Takes::Nothing,
    row Theory
        "a hundredth of the heights, and 16 at least, have exactly one value, and most others \
         differ"
        "missing data that were filled",
    |write| format!(
        "`{pointer}`: {} of {} heights are exactly {}, the first at {:?}, and nearly all others \
         differ: do they stand for missing data? A plateau that is meant is solved as it is.",
        heights.count,
        heights.of,
        write.length_text(heights.height),
        heights.places,
    );

    /// No published result tells the bias of a hardness test.
    BiasUnknown { why: &'static str } => "bias_unknown", Takes::Nothing,
    row Hardness
        "a hardness test"
        "no published result with large strains tells what small strains leave out of this \
         number: of Rockwell C, of balls that are not fully plastic, of pyramids whose depths \
         differ too little",
    |_| *why;

    /// The number is outside the range of its scale.
    OutsideScale { scale: TestScale, range: [f64; 2] } => "outside_scale", Takes::Nothing,
    row Hardness
        "above 650 HBW, outside 20 to 70 HRC or 10 to 100 HRB"
        "the standards do not use the scale there",
    |_| format!(
        "The scale {} is for {} to {} by its standard.",
        scale.name(), range[0], range[1]
    );

    /// Hardly a dent is left, as a part of the depth under load; none where nothing has yielded.
    NoDent { left: Option<f64> } => "no_dent", Takes::Nothing,
    row Hardness
        "less than a tenth of the depth is left, or nothing has yielded and `number` is `null`"
        "standards measure what is left",
    |_| match left {
        Some(left) => format!(
            "{} of the depth is left. Standards measure what is left; this number is that of the \
             contact under load.",
            percent(*left)
        ),
        None => {
            "The specimen has not yielded: no dent is left that could be measured.".to_owned()
        }
    };

    /// The specimen is thinner than the standard wants.
    ThinSpecimen { thickness: f64, least: f64 } => "thin_specimen", Takes::Nothing,
    row Hardness
        "the specimen is thinner than 8 depths (HBW), 1.5 diagonals (HV), 10 depths (HRC) or 15 \
         (HRB) of the standards"
        "the support bears a part of the force",
    |write| format!(
        "The specimen is {} thick; the standard wants {} for this indentation, so that the support \
         does not bear it.",
        write.length_text(*thickness),
        write.length_text(*least)
    );

    /// The specimen is narrower than the standards want.
    NarrowSpecimen { width: f64, least: f64 } => "narrow_specimen", Takes::Nothing,
    row Hardness
        "the specimen ends nearer than 2.5 diameters to the middle, the standards' distance from \
         an edge"
        "the edge gives way",
    |write| format!(
        "The specimen is {} wide; the standards want {} for this indentation, so that no edge gives \
         way.",
        write.length_text(*width),
        write.length_text(*least)
    );

    /// The tip takes a large part of the contact of a pyramid.
    BluntTip { radius: f64 } => "blunt_tip", Takes::Nothing,
    row Hardness
        "the tip takes more than 0.3 of the radius of a pyramid's contact"
        "its figures are more those of a ball",
    |write| format!(
        "The tip of {} reaches far into this indentation: its figures are more those of a ball.",
        write.length_text(*radius)
    );

    /// A pyramid is solved as a cone.
    EqualCone => "equal_cone", Takes::Nothing,
    row Hardness
        "a pyramid"
        "Vickers' and Berkovich's pyramids are solved as the cone of equal area. In three \
         dimensions Vickers' number by the diagonals is 0.95 to 1.09 of the cone's: the error of \
         `HV` has 9 % for that. Beside HBW of the same curve the cone's number is 6 to 8 % below \
         ISO 18265 for steels",
    |_| "A pyramid is solved as the cone of equal area, of 70.3° half-angle; the ± of HV has 9 % \
         for its edges. Beside HBW of the same curve HV of the cone is 6 to 8 % lower than ISO \
         18265 has it for steels.";
}
