//! Rows of high-cycle fatigue, and its sentence in the verdict.

use brinell_halfspace::{Fatigue, Utilization};
use strum::VariantArray as _;

use super::{Answer, AnswerAt, AnswerBody, Bar, Facts, Name};
use crate::job::{Named as _, Side};
use crate::report::fatigue::{BodyFatigue, curve, remarks};
use crate::report::findings::Finding;
use crate::report::rolling::TrackVerdict;
use crate::report::{FatigueCriterion, FatigueReport, PerBody};
use crate::solver::method::figures::Figure;
use crate::units::to_digits;

impl Facts<'_> {
    /// Returns the utilization of each body by each criterion, its relative life, and the part of
    /// residual stress.
    pub fn fatigue(&self) -> Vec<Answer> {
        self.known.fatigue.iter().flat_map(|body| self.endurance(body)).collect()
    }

    fn endurance(&self, body: &BodyFatigue) -> Vec<Answer> {
        let fatigue = match &body.found {
            Ok(fatigue) => fatigue,
            Err(reason) => {
                let row = self.fatigue_row(body, Name::FatigueUtilization, None, None);
                return vec![row.not_known(reason)];
            }
        };
        let is_elastic = self.is_as_elastic(fatigue);
        let mut rows = Vec::new();
        for (&criterion, used) in FatigueCriterion::VARIANTS.iter().zip(&fatigue.criteria) {
            let row = |name: Name, value: Option<f64>| {
                self.fatigue_row(body, name, Some(criterion), value)
            };
            let Some(used) = used else {
                rows.push(
                    row(Name::FatigueUtilization, None).not_known(
                        "its hydrostatic stress has a weight below zero for these limits",
                    ),
                );
                continue;
            };
            let utilization = row(Name::FatigueUtilization, Some(used.largest.value));
            let utilization = self.used(utilization, used);
            let error = utilization.error.bound();
            rows.push(utilization);
            // Elastic bodies without residual stress are those that a life is counted by.
            let life = error.filter(|_| !is_elastic).and_then(|error| used.relative_life(error));
            rows.extend(life.map(|[least, most]| {
                let row = row(Name::RelativeLife, Some(0.5 * (least + most)));
                let row = row.bar(Bar::none("the exponents in use differ"));
                let row = Answer { at_least: Some(least), at_most: Some(most), ..row };
                let row = row.text("over that of elastic bodies without residual stress");
                if criterion == FatigueCriterion::DangVan { row } else { row.detail() }
            }));
            let part = Some(used.of_rest()).filter(|part| *part != 0.0);
            rows.extend(part.map(|part| {
                let text = "of residual and initial stress, which no longer change";
                row(Name::FatigueOfResidualStress, Some(part)).text(text).detail()
            }));
        }
        if body.is_of_verdict { rows } else { rows.into_iter().map(Answer::detail).collect() }
    }

    /// Returns the curves of the rule of the verdict, of bodies whose rows have values; `None` without
    /// limits.
    pub fn curves_of_fatigue(&self, rows: &[Answer]) -> Option<PerBody<Option<FatigueReport>>> {
        let of = |side: Side| {
            rows.iter().find(|row| is_known(row) && row.is_of(side) && !row.detail)?;
            let is_of = |body: &&BodyFatigue| body.side == side || self.known.is_alike;
            let body = self.known.fatigue.iter().filter(|body| body.is_of_verdict).find(is_of)?;
            Some(curve(body.found.as_ref().ok()?, self.write))
        };
        let curves = || PerBody { upper: of(Side::Upper), lower: of(Side::Lower) };
        (!self.known.fatigue.is_empty()).then(curves)
    }

    /// Returns the remarks on fatigue; none where no row has a value.
    pub fn remarks_on_fatigue(&self, rows: &[Answer]) -> Vec<Finding> {
        if rows.iter().any(is_known) { remarks(self.job) } else { Vec::new() }
    }

    /// Returns whether nothing has yielded and no stress stands still.
    fn is_as_elastic(&self, fatigue: &Fatigue) -> bool {
        let has_yielded = match &self.known.rolled {
            Some(rolled) => {
                rolled.rules.iter().any(|rule| rule.verdict() != TrackVerdict::Elastic)
            }
            None => self.has_yielded(),
        };
        !has_yielded && fatigue.criteria.iter().flatten().all(|used| used.of_rest() == 0.0)
    }

    /// Returns a row of fatigue with its name and all that tells it from others.
    fn fatigue_row(
        &self,
        body: &BodyFatigue,
        name: Name,
        criterion: Option<FatigueCriterion>,
        value: Option<f64>,
    ) -> Answer {
        let by = criterion.map(|by| format!(", {}", by.in_words())).unwrap_or_default();
        let rule = body.rule.map(|rule| format!(", {}", rule.name())).unwrap_or_default();
        let of = self.body(body.side);
        let at = AnswerAt { pass: body.pass, hardening: body.rule, criterion, load: None };
        let row = self.row(name, value).labelled(&format!("{}{by}{rule}", name.label())).of(of);
        if at == AnswerAt::default() { row } else { row.at(at) }
    }

    /// Returns the row of a utilization with its bar and its place.
    fn used(&self, row: Answer, used: &Utilization) -> Answer {
        let of = row.body.unwrap_or(AnswerBody::Both);
        let place = self.place(of, [0.0, used.largest.across, used.largest.depth]);
        let size = used.largest.value.abs();
        let bar = match used.error {
            Some(error) => Bar::Relative(error / size),
            None if self.known.rolled.is_some() => Bar::none("half the columns do not bound it"),
            None => self.of_static(of, used),
        };
        row.bar(bar).place(Some(place)).elastic(used.elastic)
    }

    /// Returns the bar of a static load: that of the peak pressure, of which the stress is a multiple,
    /// that of plastic strain for residual stress, and that of the cells of a path.
    fn of_static(&self, of: AnswerBody, used: &Utilization) -> Bar {
        let side = usize::from(of != AnswerBody::Upper);
        let peak = self.bar_of(Figure::PeakPressure, 0);
        let yielded = self.known.zones[side].as_ref().is_some_and(|zone| zone.yielded);
        let strain = (Figure::MaxPlasticStrain, side);
        let strain_bar = if yielded { self.bar_of(strain.0, side) } else { Some(0.0) };
        let cells = Fatigue::OF_CELLS / f64::from(self.job.mesh.elements_per_half_width);
        let bar = peak.zip(strain_bar).map(|(peak, strain)| {
            let size = used.largest.value.abs();
            peak + cells + strain * (used.of_rest() / size).abs()
        });
        self.bar(&[(Figure::PeakPressure, 0), strain], bar)
    }
}

/// Returns whether a row is a utilization that is known.
fn is_known(row: &Answer) -> bool {
    row.is(Name::FatigueUtilization) && row.value.is_some()
}

/// What the rows of fatigue say together.
pub(in crate::report) struct Endurance<'a> {
    /// Whether the bodies endure by all criteria.
    pub is_endured: bool,
    pub sentence: String,
    /// The row of the largest utilization.
    pub worst: &'a Answer,
}

/// Returns what the rows say: of both bodies, and of both rules of hardening, the larger utilization
/// counts. `None` without limits and where the rule of the verdict knows none. Passes of a load that
/// `may_flow` need not shake down.
pub(in crate::report) fn endures(rows: &[Answer], may_flow: bool) -> Option<Endurance<'_>> {
    let used = || rows.iter().filter(|row| row.is(Name::FatigueUtilization));
    rows.iter().find(|row| is_known(row) && !row.detail)?;
    let by_value = |a: &&Answer, b: &&Answer| value(a).total_cmp(&value(b));
    let decides = |criterion: &FatigueCriterion| {
        let is_by = |row: &&Answer| row.at.and_then(|at| at.criterion) == Some(*criterion);
        rows.iter().filter(|row| is_known(row)).filter(is_by).max_by(by_value)
    };
    let deciding: Vec<&Answer> = FatigueCriterion::VARIANTS.iter().filter_map(decides).collect();
    let [least, worst] =
        [deciding.iter().copied().min_by(by_value)?, deciding.iter().copied().max_by(by_value)?];
    let endured = deciding.iter().filter(|row| value(row) <= 1.0).count();
    // Dang Van's criterion and orthogonal shear hold for all limits that a job may have.
    let [of_all, all] = if deciding.len() == 2 { ["two", "both"] } else { ["three", "all three"] };
    let by = match endured {
        0 => format!("Does not endure by any of {of_all} criteria"),
        every if every == deciding.len() => format!("Endures by {all} criteria"),
        1 => format!("Endures by one of {of_all} criteria"),
        _ => format!("Endures by two of {of_all} criteria"),
    };
    // A body of which nothing is known has a row without a criterion.
    let is_unknown = |row: &Answer| row.at.is_none_or(|at| at.criterion.is_none());
    let other = if used().any(is_unknown) { "; of the other it is not known" } else { "" };
    let condition = if may_flow { ", if its passes shake down" } else { "" };
    let [low, high] = [least, worst].map(in_percent);
    let span = if low == high { high } else { format!("{low} to {high}") };
    let body = worst.body.map_or("", AnswerBody::in_words);
    let is_close = |row: &&Answer| {
        (value(row) - 1.0).abs() <= row.error.bound().unwrap_or(0.0) * value(row).abs()
    };
    let close =
        if deciding.iter().any(is_close) { "; the limit lies within the error" } else { "" };
    Some(Endurance {
        is_endured: endured == deciding.len(),
        sentence: format!(
            "{by} of fatigue{condition} (utilization {span} %{body}{other}{close})."
        ),
        worst,
    })
}

fn value(row: &Answer) -> f64 {
    row.value.unwrap_or(f64::NEG_INFINITY)
}

/// Returns a utilization in the digits that its error leaves.
fn in_percent(row: &Answer) -> String {
    to_digits(100.0 * value(row), row.error.digits(value(row)).clamp(2, 3))
}
