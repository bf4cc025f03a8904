//! Rows of high-cycle fatigue, and its sentence in the verdict.

use brinell_halfspace::{Fatigue, Utilization};
use strum::VariantArray as _;

use super::{Answer, AnswerAt, AnswerBody, Bar, Facts, Name};
use crate::job::Named as _;
use crate::material::fatigue::Criterion;
use crate::report::FatigueCriterion;
use crate::report::fatigue::BodyFatigue;
use crate::solver::method::figures::Figure;
use crate::units::about;

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
        let span = span(fatigue);
        let mut rows = Vec::new();
        for (criterion, used) in Criterion::ALL.into_iter().zip(&fatigue.criteria) {
            let of = Some(criterion.into());
            let row = |name: Name, value: Option<f64>| self.fatigue_row(body, name, of, value);
            let Some(used) = used else {
                rows.push(
                    row(Name::FatigueUtilization, None).not_known(
                        "its hydrostatic stress has a weight below zero for these limits",
                    ),
                );
                continue;
            };
            let utilization = row(Name::FatigueUtilization, Some(used.largest.value));
            rows.push(self.used(utilization, used, &span));
            rows.extend(used.relative_life().map(|[least, most]| {
                let row = row(Name::RelativeLife, Some(least));
                let row = row.bar(Bar::none("the exponents in use differ"));
                let row = Answer { at_least: Some(least), at_most: Some(most), ..row };
                let row = row.text("over that of elastic bodies without residual stress");
                if criterion == Criterion::DangVan { row } else { row.detail() }
            }));
            let part = Some(used.of_rest()).filter(|part| *part != 0.0);
            rows.extend(part.map(|part| {
                let text = "of residual and initial stress, which no longer change";
                row(Name::FatigueOfResidualStress, Some(part)).text(text).detail()
            }));
        }
        if body.is_of_verdict { rows } else { rows.into_iter().map(Answer::detail).collect() }
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
        let of = if body.is_of_both { AnswerBody::Both } else { body.side.into() };
        let at = AnswerAt { pass: body.pass, hardening: body.rule, criterion, load: None };
        let row = self.row(name, value).labelled(&format!("{}{by}{rule}", name.label())).of(of);
        if at == AnswerAt::default() { row } else { row.at(at) }
    }

    /// Returns the row of a utilization with its bar, its place and the span of all criteria.
    fn used(&self, row: Answer, used: &Utilization, span: &str) -> Answer {
        let of = row.body.unwrap_or(AnswerBody::Both);
        let place = self.place(of, [0.0, used.largest.across, used.largest.depth]);
        let size = used.largest.value.abs();
        let bar = match used.error {
            Some(error) => Bar::Relative(error / size),
            None if self.known.rolled.is_some() => Bar::none("half the columns do not bound it"),
            None => self.of_static(of, used),
        };
        row.bar(bar).place(Some(place)).elastic(used.elastic).text(span)
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

/// Returns whether the bodies endure by all criteria, and the sentence; `None` without limits and
/// where fatigue is not known. Of both bodies the larger utilization counts. Passes of a load that
/// `may_flow` need not shake down.
pub(in crate::report) fn endures(rows: &[Answer], may_flow: bool) -> Option<(bool, String)> {
    let used: Vec<_> =
        rows.iter().filter(|row| row.is(Name::FatigueUtilization) && !row.detail).collect();
    let largest = |criterion: &FatigueCriterion| {
        let of = |row: &&&Answer| row.at.and_then(|at| at.criterion) == Some(*criterion);
        let values = used.iter().filter(of).filter_map(|row| row.value);
        values.reduce(f64::max)
    };
    let largest: Vec<f64> = FatigueCriterion::VARIANTS.iter().filter_map(largest).collect();
    let endured = largest.iter().filter(|value| **value <= 1.0).count();
    let is_close = |row: &&Answer| {
        let (value, bar) = (row.value.unwrap_or(0.0), row.error.bound().unwrap_or(0.0));
        (value - 1.0).abs() <= bar * value.abs()
    };
    let close = if used.iter().any(is_close) { ", within the error of 100 %" } else { "" };
    let span = percent_of(&largest)?;
    // Dang Van's criterion and orthogonal shear hold for all limits that a job may have.
    let [of_all, all] = if largest.len() == 2 { ["two", "both"] } else { ["three", "all three"] };
    let by = match endured {
        0 => format!("Does not endure by any of {of_all} criteria"),
        every if every == largest.len() => format!("Endures by {all} criteria"),
        1 => format!("Endures by one of {of_all} criteria"),
        _ => format!("Endures by two of {of_all} criteria"),
    };
    // A body of which nothing is known has a row without a criterion.
    let is_unknown = |row: &&Answer| row.at.is_none_or(|at| at.criterion.is_none());
    let bodies = if used.iter().any(is_unknown) { ", as far as it is known" } else { "" };
    let condition = if may_flow { ", if its passes shake down" } else { "" };
    let text = format!("{by} of fatigue{bodies}{condition} (utilization {span}{close}).");
    Some((endured == largest.len(), text))
}

/// Returns the utilization by all criteria in words: their difference is the bias of the theory.
fn span(fatigue: &Fatigue) -> String {
    let values: Vec<f64> = fatigue.largest().into_iter().flatten().collect();
    percent_of(&values).map(|span| format!("{span} by all criteria")).unwrap_or_default()
}

/// Returns the range of values in per cent.
fn percent_of(values: &[f64]) -> Option<String> {
    let least = values.iter().copied().reduce(f64::min)?;
    let most = values.iter().copied().reduce(f64::max)?;
    let [least, most] = [least, most].map(|value| about(100.0 * value));
    Some(if least == most { format!("{most} %") } else { format!("{least} to {most} %") })
}
