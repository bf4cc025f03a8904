//! Findings: the limits of an answer, as data. Each engine makes the findings of a load step once.
//! Remarks, error bars, onset and target read them: [`Finding::voids`] says which figures lose
//! their bar, [`Finding::text`] says a finding in the units of a job. `table` has all of them.

mod guesses;
mod kinds;
mod sentences;
mod table;

use std::fmt::Write as _;

use strum::VariantArray as _;

use super::figure_names::name_of;
use crate::job::{Job, Load};
use crate::solver::SolveStatus;
use crate::solver::half_spaces::figure_of;
use crate::solver::method::figures::{Figure, FigureSet};

pub(super) use guesses::guesses;
pub(super) use kinds::Voids;
pub(super) use kinds::{
    Advice, CasePlace, Deformation, FinerBy, MANY_MESHES, Missed, OnsetUnknown, Unconverged, Wide,
    Work,
};
use kinds::{BELOW, Row, Section, Takes};
pub(super) use sentences::CONFORMING_ADVICE;
pub(super) use table::Finding;
use table::ROWS;

/// Returns every code that a remark can have.
pub fn validity_codes() -> Vec<&'static str> {
    let mut codes = Vec::new();
    for row in ROWS {
        if !codes.contains(&row.code) {
            codes.push(row.code);
        }
    }
    codes
}

/// Returns the tables of remarks in `docs/validity.md`, by the names of their sections.
pub fn validity_tables() -> Vec<(&'static str, String)> {
    let of = |section: &Section| {
        let mut table = "| code | condition | meaning | takes the bars of |\n".to_owned();
        table.push_str("|---|---|---|---|\n");
        for code in validity_codes() {
            let of_code = ROWS.iter().filter(|row| row.section == *section && row.code == code);
            for (k, Row { condition, meaning, takes, .. }) in of_code.enumerate() {
                let code = if k == 0 { format!("`{code}`") } else { String::new() };
                let _ =
                    writeln!(table, "| {code} | {condition} | {meaning} | {} |", takes.words());
            }
        }
        (section.into(), table)
    };
    Section::VARIANTS.iter().map(of).collect()
}

impl Takes {
    fn words(self) -> String {
        match self {
            Self::Nothing => String::new(),
            Self::Estimate => "the whole estimate".to_owned(),
            Self::AllButMiddlePressure => "all figures but the middle pressure".to_owned(),
            Self::Figures(figures) => {
                let names: Vec<_> = figures.iter().filter_map(|figure| name_of(*figure)).collect();
                names.join(", ")
            }
        }
    }
}

impl Finding {
    /// Returns the finding on a job that was stopped.
    pub fn stopped(status: SolveStatus, is_preliminary: bool) -> Self {
        match status {
            SolveStatus::Cancelled => Self::Cancelled { is_preliminary },
            _ => Self::TimedOut { is_preliminary },
        }
    }

    /// Returns the error bars that the finding takes away.
    pub fn voids(&self) -> Voids {
        let of = |figures: &[Figure], bodies: [bool; 2]| {
            Voids::Figures(FigureSet::of_bodies(figures, bodies))
        };
        match (self, self.takes()) {
            (Self::EarlierLoads { unknown }, _) => Voids::Figures(*unknown),
            (Self::OnsetUnknown { is_sought: true, .. }, _) => Voids::Estimate,
            (Self::CoarseCase { place: CasePlace::Layer(_), .. }, _) | (_, Takes::Nothing) => {
                of(&[], [true; 2])
            }
            (
                Self::CoarseCase { bodies, .. } | Self::UnboundedStrain { bodies },
                Takes::Figures(figures),
            ) => of(figures, *bodies),
            (Self::RollerEnd { is_all: true, .. }, Takes::Figures(figures)) => {
                let width = FigureSet::of(&[Figure::HalfWidth]);
                Voids::Figures(FigureSet::of(figures).with(width))
            }
            (_, Takes::Figures(figures)) => of(figures, [true; 2]),
            (_, Takes::AllButMiddlePressure) => {
                Voids::Figures(FigureSet::all_but(Figure::MiddlePressure))
            }
            (_, Takes::Estimate) => Voids::Estimate,
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
