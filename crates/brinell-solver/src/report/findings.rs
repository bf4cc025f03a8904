//! Findings: the limits of an answer, as data. Each engine makes the findings of a load step once.
//! Remarks, error bars, onset and target read them: [`Finding::voids`] says which figures lose
//! their bar, [`Finding::text`] says a finding in the units of a job.

use brinell_halfspace::track::TrackFault;

use super::rolling::TrackVerdict;
use super::surface_stress::UncertainStress;
use crate::job::{Job, Load, Suspicion};
use crate::solver::SolveStatus;
use crate::solver::half_spaces::figure_of;
use crate::solver::method::figures::{Figure, FigureSet};

/// Number of meshes above which a search for a force is called long.
pub(super) const MANY_MESHES: usize = 40;

/// One limit of the answer to a load step. Lengths in mm, stresses in MPa, forces in N/mm or N.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Finding {
    /// The step has not converged.
    NotConverged(Unconverged),
    /// Somebody stopped the job, or its deadline passed.
    Stopped { status: SolveStatus, is_preliminary: bool },
    /// The load took far more work than usual.
    Work(Work),
    /// The contact is wide beside the radii of the surfaces.
    Wide(Wide),
    /// The plastic strain is so large that the bodies do not bear the load. A history has the
    /// start and the size of its last increment, as parts of the load.
    Collapse { strain: f64, last: Option<[f64; 2]> },
    /// The plastic strain is too large for small-strain theory.
    LargeStrain { strain: f64 },
    /// The bodies yield by deformation theory.
    DeformationTheory(Deformation),
    /// Loads fall under deformation theory.
    FallingLoads,
    /// Bodies with a dent do not touch at the approach that is given.
    NoContact,
    /// A sharp corner carries pressure on elastic bodies.
    ElasticCorner { x: f64 },
    /// A sharp corner of bodies that yield carries pressure that grows with the density of the mesh.
    YieldingCorner { x: f64 },
    /// The points of a roller's profile make kinks.
    Kinks,
    /// The contact reaches the edge of what is meshed.
    AtEdge { in_hole: bool },
    /// Few elements or cells over the half-width. `unit` is one of the two.
    FewElements { number: f64, advice: Density },
    /// Few elements over a part of the contact.
    FewElementsOverPart { x: f64, number: f64 },
    /// The contact of bodies of revolution is a ring of few elements.
    RingOnFewElements { radius: f64 },
    /// The peak pressure is next to an end of the contact.
    PeakNextToEnd { x: f64, spacing: f64 },
    /// The mesh has not resolved the peak pressure of an earlier load.
    EarlierLoads { unknown: FigureSet },
    /// A clamped body is deeper than wide.
    ClampedColumn,
    /// The stress at the surface of a body changes within elements.
    SurfaceStress { spacing: f64, bodies: [Option<UncertainStress>; 2] },
    /// The permanent approach is smaller than its error.
    SmallApproach { error: f64 },
    /// Elements leave out a rounded edge.
    RoundedEdge { width: f64, pressure: f64, spacing: f64, is_onset: bool },
    /// Elements leave out a tip. `needed` elements over the half-width resolve the arc.
    RoundedTip { arc: Option<f64>, needed: f64, pressure: f64, spacing: f64 },
    /// Elements leave out details of the surfaces.
    Details { needed: f64, spacing: f64 },
    /// The largest plastic strain has no limit on finer meshes.
    UnboundedStrain { bodies: [bool; 2] },
    /// A permanent deformation is computed with a bilinear curve.
    BilinearCurve,
    /// The force at the onset of yield is not known. A job that seeks it has no answer.
    OnsetUnknown { cause: OnsetUnknown, is_sought: bool },
    /// The yield stress follows from the hardness.
    YieldByHardness,
    /// A body yields before it is loaded; the stress over the yield stress.
    InitialYield { ratio: f64 },
    /// The strength changes within an element or a layer.
    CoarseCase { change: f64, place: CasePlace, wanted: f64, bodies: [bool; 2] },
    /// A support is close below the contact.
    NearSupport,
    /// Something in the job is probably not meant.
    Suspicious(Suspicion),
    /// The bodies are half-spaces; they must reach this far beyond the contact.
    HalfSpaces { reach: f64, across_roller: bool },
    /// The contact runs to an end of a roller.
    RollerEnd { pressure: f64, is_sharp: bool, is_all: bool },
    /// The contact runs to the rim of the heights.
    SurfaceEnd,
    /// The spots in which heights touch are no smooth summits.
    Heights(HeightsFinding),
    /// On half the columns something else becomes of the track.
    NearLimit { coarse: TrackVerdict },
    /// The friction of a load that rolls slides over the whole contact.
    FullSliding,
}

/// Limits of a contact of heights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum HeightsFinding {
    /// A part of the force is borne by spots of few cells; cells over half of a typical spot.
    FewCells { number: f64, part: f64 },
    /// A part of the force is borne by spots beside which the heights have a step.
    Steps { part: f64 },
    /// The largest pressure is above what the flow stress carries.
    Unbearable { pressure: f64, bearable: f64 },
}

/// Why a load step has not converged.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Unconverged {
    /// No force gives the figure that is sought; its ratio to the wanted value.
    Missed { ratio: f64 },
    /// The state violates the contact conditions by a part of their scale.
    Contact { violation: f64, is_slow: bool },
    /// No answer with small strains.
    Collapse,
    /// The contact is wider than the mesh.
    AtEdge,
    /// An earlier increment has not converged.
    Inherited { is_slow: bool },
    /// Forces are off balance over the whole bodies.
    Unbalanced { residual: f64 },
    /// The iteration has ended without an answer.
    Iteration { iterations: usize, residual: f64, advice: Advice },
    /// No tilt of the roller has its moment.
    Moment { missing: f64 },
    /// A check of a pass of a load that rolls fails.
    Pass(TrackFault),
}

/// A remedy for an iteration without an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Advice {
    LargerLoad,
    AcceleratedCoupling,
    MoreIterations,
    SmallerLoad,
}

/// Work that a load took.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Work {
    /// A slow coupling.
    Coupling { updates: usize, iterations: usize },
    /// Many evaluations of the plastic law.
    Load {
        updates: usize,
        iterations: usize,
        /// Number of increments, where they are the cause.
        increments: Option<usize>,
        /// Number of factorizations, where they are the cause.
        factorizations: Option<usize>,
    },
    /// A search over many meshes, in three dimensions grids.
    Search { meshes: usize, of_cells: bool, of_histories: bool, force: f64 },
    /// A mesh that details of the surfaces make much finer than requested.
    FineMesh { elements: f64, asked: f64, equations: usize },
}

/// Contacts that are too wide for the theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Wide {
    /// Angle between the normals of pin and hole at the ends of the contact \[rad\].
    InHole { angle: f64 },
    /// Half-width over the smallest radius.
    OverRadius { ratio: f64, in_groove: bool },
    /// Slope of a surface within the contact.
    Slope { slope: f64 },
    /// Semi-axis over a radius of curvature, in three dimensions.
    OverCurvature { ratio: f64, radius: f64 },
    /// Inclination of the common normal at the end of a contact of half-spaces that conform \[rad\].
    Inclined { angle: f64 },
    /// Tilt of a roller under its moment, and the largest tilt that may be given \[mrad\].
    Tilt { tilt: f64, most: f64 },
}

/// A remedy for a coarse mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Density {
    Elements,
    Cells,
    Heights,
}

/// A contact that yields by deformation theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Deformation {
    /// A line, and the elastic peak pressure over the least yield stress.
    Line(f64),
    /// A ball or an ellipse, and the elastic peak pressure over the least yield stress.
    Ball(f64),
    /// A cone or a wedge.
    Tip,
    /// A contact without published figures.
    Other,
}

/// Why the force at the onset of yield is not known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum OnsetUnknown {
    /// Elements leave out a rounded edge, where closed forms yield under `force`.
    AtEdge { width: f64, spacing: f64, force: f64 },
    /// The peak pressure is next to an end of the contact.
    NextToEnd { x: f64, spacing: f64 },
    /// A sharp corner carries pressure.
    AtCorner { x: f64 },
    /// The contact runs to an end of a roller.
    AtRollerEnd,
}

/// A place where strength changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CasePlace {
    /// An element, by its middle.
    Element([f64; 2]),
    /// A layer of cells, by the depth of its middle.
    Layer(f64),
}

/// Error bars that a finding takes away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Voids {
    /// The bars of a set of figures.
    Figures(FigureSet),
    /// The error estimate as a whole: the figures are no answer, or nothing bounds their errors.
    Estimate,
}

/// Figures below the surface and along it, which depend on the peak pressure.
const BELOW: [Figure; 5] = [
    Figure::MaxPlasticStrain,
    Figure::MeanPlasticStrain,
    Figure::PlasticArea,
    Figure::LeastStress,
    Figure::LargestVonMises,
];

impl Finding {
    /// Returns the code of the remark.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NotConverged(_) => "not_converged",
            Self::Stopped { status: SolveStatus::Cancelled, .. } => "cancelled",
            Self::Stopped { .. } => "timed_out",
            Self::Work(_) => "slow_coupling",
            Self::Wide(_) => "wide_contact",
            Self::Collapse { .. } => "collapse",
            Self::LargeStrain { .. } => "large_strain",
            Self::DeformationTheory(_) => "deformation_theory",
            Self::FallingLoads => "falling_loads",
            Self::NoContact => "no_contact",
            Self::ElasticCorner { .. }
            | Self::YieldingCorner { .. }
            | Self::Kinks
            | Self::Heights(HeightsFinding::Steps { .. }) => "sharp_corner",
            Self::AtEdge { .. } => "contact_at_edge",
            Self::FewElements { .. }
            | Self::FewElementsOverPart { .. }
            | Self::RingOnFewElements { .. }
            | Self::PeakNextToEnd { .. }
            | Self::EarlierLoads { .. }
            | Self::ClampedColumn
            | Self::SurfaceStress { .. }
            | Self::SmallApproach { .. }
            | Self::RoundedEdge { .. }
            | Self::RoundedTip { .. }
            | Self::Details { .. }
            | Self::Heights(_) => "coarse_mesh",
            Self::UnboundedStrain { .. } => "unbounded_strain",
            Self::BilinearCurve => "bilinear_curve",
            Self::OnsetUnknown { .. } => "onset_unknown",
            Self::YieldByHardness => "yield_by_hardness",
            Self::InitialYield { .. } => "initial_yield",
            Self::CoarseCase { .. } => "coarse_case",
            Self::NearSupport => "near_support",
            Self::Suspicious(suspicion) => suspicion.code,
            Self::HalfSpaces { .. } => "half_spaces",
            Self::RollerEnd { .. } => "roller_end",
            Self::SurfaceEnd => "surface_end",
            Self::NearLimit { .. } => "near_limit",
            Self::FullSliding => "full_sliding",
        }
    }

    /// Returns the error bars that the finding takes away.
    pub fn voids(&self) -> Voids {
        let of = |figures: &[Figure]| Voids::Figures(FigureSet::of(figures));
        match self {
            Self::NotConverged(_)
            | Self::Stopped { .. }
            | Self::Collapse { .. }
            | Self::RingOnFewElements { .. }
            | Self::OnsetUnknown { is_sought: true, .. }
            | Self::Heights(HeightsFinding::FewCells { .. }) => Voids::Estimate,
            Self::RoundedEdge { .. } => Voids::Figures(FigureSet::all_but(Figure::MiddlePressure)),
            Self::ElasticCorner { .. }
            | Self::YieldingCorner { .. }
            | Self::Kinks
            | Self::PeakNextToEnd { .. }
            | Self::RoundedTip { .. }
            | Self::SurfaceEnd
            | Self::Heights(_) => {
                let peak = FigureSet::of(&[Figure::PeakPressure]);
                Voids::Figures(peak.with(FigureSet::of(&BELOW)))
            }
            // The surface is deepest at the end too.
            Self::RollerEnd { is_all, .. } => {
                let peak = [Figure::PeakPressure, Figure::Dent, Figure::PileUp];
                let width: &[Figure] = if *is_all { &[Figure::HalfWidth] } else { &[] };
                let taken = FigureSet::of(&peak).with(FigureSet::of(width));
                Voids::Figures(taken.with(FigureSet::of(&BELOW)))
            }
            Self::EarlierLoads { unknown } => Voids::Figures(*unknown),
            Self::ClampedColumn => of(&[Figure::Approach, Figure::Force, Figure::Dent]),
            Self::CoarseCase { bodies, place: CasePlace::Element(_), .. } => {
                Voids::Figures(FigureSet::of_bodies(&BELOW, *bodies))
            }
            Self::UnboundedStrain { bodies } => {
                Voids::Figures(FigureSet::of_bodies(&[Figure::MaxPlasticStrain], *bodies))
            }
            _ => of(&[]),
        }
    }
}

/// Returns the figures that a history leaves unknown: those that earlier loads left
/// unknown, those that the findings of this load take, and what depends on a peak that they take.
pub(super) fn left_unknown(before: FigureSet, findings: &[Finding]) -> FigureSet {
    const KEPT: [Figure; 3] = [Figure::Approach, Figure::Dent, Figure::PileUp];
    let known = Known::by(findings);
    let below = FigureSet::of(&BELOW);
    let kept = below.with(FigureSet::of(&KEPT));
    if !known.has_estimate() {
        return kept;
    }
    let taken = known.void.within(kept);
    let is_peak_known = known.has(Figure::PeakPressure, 0);
    before.with(taken).with(if is_peak_known { FigureSet::default() } else { below })
}

/// The error bars that all findings of a load step take away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Known {
    has_estimate: bool,
    void: FigureSet,
}

impl Known {
    pub fn by(findings: &[Finding]) -> Self {
        let none = Self { has_estimate: true, void: FigureSet::default() };
        findings.iter().fold(none, |known, finding| match finding.voids() {
            Voids::Estimate => Self { has_estimate: false, void: FigureSet::ALL },
            Voids::Figures(figures) => Self { void: known.void.with(figures), ..known },
        })
    }

    /// As [`by`](Self::by), of half-spaces. All bars are taken where the figure by which a force was
    /// sought has none: the error of the force is in all of them.
    pub fn of_job(job: &Job, findings: &[Finding]) -> Self {
        let known = Self::by(findings);
        match &job.load {
            Load::Target(target)
                if ![0, 1].iter().any(|side| known.has(figure_of(target.figure), *side)) =>
            {
                Self { has_estimate: false, void: FigureSet::ALL }
            }
            _ => known,
        }
    }

    /// Returns whether the step has an error estimate.
    pub const fn has_estimate(self) -> bool {
        self.has_estimate
    }

    /// Returns the figures whose bars are taken.
    pub const fn void(self) -> FigureSet {
        self.void
    }

    /// Returns whether the mesh resolves a figure, of a body that of one side.
    pub fn has(self, figure: Figure, side: usize) -> bool {
        !self.void.has(figure, side)
    }

    /// Returns the bar of a figure if the mesh resolves the figure.
    pub fn bar(self, figure: Figure, side: usize, bar: Option<f64>) -> Option<f64> {
        bar.filter(|_| self.has(figure, side))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::error_bars::name_of;

    /// The table of `docs/validity.md`: what each finding takes.
    #[test]
    fn the_document_says_which_bars_a_finding_takes() {
        let document = include_str!("../../../../docs/validity.md");
        let at_edge = OnsetUnknown::AtCorner { x: 0.0 };
        let findings = [
            (Finding::NotConverged(Unconverged::Collapse), "no answer"),
            (
                Finding::Stopped { status: SolveStatus::Cancelled, is_preliminary: false },
                "stopped",
            ),
            (Finding::Collapse { strain: 1.0, last: None }, "limit load"),
            (Finding::OnsetUnknown { cause: at_edge, is_sought: true }, "at the onset of yield"),
            (Finding::RingOnFewElements { radius: 1.0 }, "a ring on few elements"),
            (
                Finding::RoundedEdge { width: 0.0, pressure: 0.0, spacing: 0.0, is_onset: false },
                "a rounded edge that elements leave out",
            ),
            (
                Finding::RoundedTip { arc: None, needed: 0.0, pressure: 0.0, spacing: 0.0 },
                "a tip that elements leave out",
            ),
            (Finding::PeakNextToEnd { x: 0.0, spacing: 0.0 }, "the peak next to an end"),
            (
                Finding::EarlierLoads { unknown: FigureSet::of(&BELOW) },
                "an earlier load whose peak has no bar",
            ),
            (Finding::ClampedColumn, "a clamped column"),
            (Finding::ElasticCorner { x: 0.0 }, "pressure without bound"),
            (Finding::YieldingCorner { x: 0.0 }, "pressure without bound"),
            (Finding::Kinks, "pressure without bound"),
            (
                Finding::RollerEnd { pressure: 0.0, is_sharp: false, is_all: false },
                "the end of a roller",
            ),
            (
                Finding::RollerEnd { pressure: 0.0, is_sharp: false, is_all: true },
                "the end of a roller alone",
            ),
            (Finding::SurfaceEnd, "the rim of heights"),
            (
                Finding::Heights(HeightsFinding::FewCells { number: 0.0, part: 0.0 }),
                "spots of few cells",
            ),
            (Finding::Heights(HeightsFinding::Steps { part: 0.0 }), "steps of heights"),
            (
                Finding::Heights(HeightsFinding::Unbearable { pressure: 0.0, bearable: 0.0 }),
                "more than the flow stress carries",
            ),
            (
                Finding::CoarseCase {
                    change: 0.0,
                    place: CasePlace::Element([0.0; 2]),
                    wanted: 0.0,
                    bodies: [true, false],
                },
                "strength within an element, of that body",
            ),
            (
                Finding::UnboundedStrain { bodies: [true, false] },
                "strain without limit, of that body",
            ),
        ];
        for (finding, words) in findings {
            let taken = match finding.voids() {
                Voids::Estimate => "the whole estimate".to_owned(),
                Voids::Figures(set) if set == FigureSet::all_but(Figure::MiddlePressure) => {
                    "all figures but the middle pressure".to_owned()
                }
                Voids::Figures(set) => {
                    let figures = Figure::ALL.iter().filter(|figure| set.has(**figure, 0));
                    let names: Vec<&str> = figures.filter_map(|figure| name_of(*figure)).collect();
                    names.join(", ")
                }
            };
            let row = format!("| `{}`: {words} | {taken} |", finding.code());
            assert!(document.contains(&row), "{row}");
        }
    }
}
