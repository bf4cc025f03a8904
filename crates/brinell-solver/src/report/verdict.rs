//! The verdict on a load step: one level and one sentence.

use serde::{Deserialize, Serialize};
use strum::{IntoStaticStr, VariantArray};

use super::answers::{Answer, AnswerBody, ErrorBar, Facts, Name, endures};
use super::findings::Finding;
use crate::job::{Load, Named, Quantity};
use crate::solver::SolveStatus;
use crate::units::{about, rounded, to_digits};

/// The verdict on a load step, made of its rows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Verdict {
    /// The state of the bodies.
    pub level: VerdictLevel,
    /// How the state is marked.
    pub mark: Mark,
    /// One sentence for a person.
    pub text: String,
    /// Name of the row that decides, and at whose `place` pictures open; `null` without an answer.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub figure: Option<String>,
    /// `body` of that row.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub body: Option<AnswerBody>,
}

/// The mark of a verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
pub enum Mark {
    /// Nothing yields, or plastic flow ends.
    Good,
    /// A body yields, is left dented, or does not endure by all criteria of fatigue.
    Attention,
    /// There is no answer, or the bodies do not bear the load.
    Bad,
    /// Nothing tells.
    Unknown,
}

impl Mark {
    /// Returns the mark of bodies that do not endure by all criteria of fatigue.
    const fn beside_fatigue(self) -> Self {
        match self {
            Self::Good | Self::Unknown => Self::Attention,
            Self::Attention | Self::Bad => self,
        }
    }
}

/// The state of the bodies under a load.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, IntoStaticStr, VariantArray,
)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum VerdictLevel {
    /// The step has not converged or was stopped: its figures are no answer.
    NotConverged,
    /// The bodies do not bear the load with small strains.
    Collapse,
    /// A body yields, and Hertz's peak pressure is above the shakedown limit of a perfectly plastic
    /// body.
    AboveShakedownLimit,
    /// The load rolls, and every pass adds a plastic strain.
    Ratchets,
    /// The load rolls, and every pass flows and takes back what it has moved.
    ClosedCycle,
    /// The load rolls, and plastic flow dies out.
    ShakesDown,
    /// A body yields.
    Yields,
    /// The load is taken away and has left plastic strain.
    Dented,
    /// No body yields.
    Elastic,
    /// Nothing tells whether a body yields: no yield stress is given, or the mesh does not resolve
    /// the onset of yield.
    NotKnown,
    /// The bodies do not touch, and none has yielded.
    NoContact,
}

impl Named for VerdictLevel {}

impl VerdictLevel {
    const fn mark(self) -> Mark {
        match self {
            Self::NotConverged | Self::Collapse | Self::Ratchets => Mark::Bad,
            Self::AboveShakedownLimit | Self::ClosedCycle | Self::Yields | Self::Dented => {
                Mark::Attention
            }
            Self::Elastic | Self::ShakesDown => Mark::Good,
            Self::NotKnown | Self::NoContact => Mark::Unknown,
        }
    }
}

impl Facts<'_> {
    /// Returns the verdict on a step with these rows.
    pub(super) fn verdict(&self, rows: &[Answer]) -> Verdict {
        let (level, text) = self.judged(rows);
        let is_answer = !matches!(level, VerdictLevel::NotConverged | VerdictLevel::Collapse);
        let endurance = endures(rows, self.may_flow(level)).filter(|_| is_answer);
        let text = match &endurance {
            Some(endurance) => format!("{text} {}", endurance.sentence),
            None => text,
        };
        let fails = endurance.filter(|endurance| !endurance.is_endured);
        let mark = if fails.is_some() { level.mark().beside_fatigue() } else { level.mark() };
        let by_fatigue = fails.filter(|_| mark != level.mark()).map(|fails| fails.worst);
        let is_shown = |row: &Answer| !row.detail || row.is(Name::FirstYieldForce);
        let of = |name: &Name| {
            let known = |row: &&Answer| row.is(*name) && row.value.is_some() && is_shown(row);
            rows.iter().find(known)
        };
        let figure = by_fatigue.or_else(|| self.deciding(level).iter().find_map(of));
        Verdict {
            level,
            mark,
            text,
            figure: figure.map(|row| row.name.clone()),
            body: figure.and_then(|row| row.body),
        }
    }

    /// Returns whether passes of the load may flow without end: those of a force under which a body
    /// has yielded, unless Hertz's peak is within a known limit.
    fn may_flow(&self, level: VerdictLevel) -> bool {
        let hertz =
            self.known.hertz.and_then(|hertz| Some((hertz.peak_pressure, hertz.shakedown?)));
        let is_within = hertz.is_some_and(|(peak, [limit, _])| peak <= limit);
        let has_flowed = self.known.rolled.is_none() && self.has_yielded();
        level == VerdictLevel::AboveShakedownLimit || has_flowed && !is_within
    }

    /// Returns the rows that decide on a level, the first of which a step has.
    fn deciding(&self, level: VerdictLevel) -> &'static [Name] {
        match level {
            VerdictLevel::NotConverged | VerdictLevel::NoContact => &[],
            VerdictLevel::Elastic if self.job.load == Load::Onset => &[Name::Force],
            VerdictLevel::Elastic => {
                &[Name::FirstYieldForce, Name::Utilization, Name::PeakPressure]
            }
            VerdictLevel::NotKnown => {
                &[Name::PassStrain, Name::FirstYieldForce, Name::PeakPressure]
            }
            _ if self.known.rolled.is_some() => &[Name::StrainPerPass],
            _ => &[Name::MaxPlasticStrain, Name::MeanPlasticStrain],
        }
    }

    fn judged(&self, rows: &[Answer]) -> (VerdictLevel, String) {
        let has = |is: fn(&Finding) -> bool| self.findings.iter().any(is);
        if has(|finding| matches!(finding, Finding::Collapse { .. })) {
            let text = "The bodies do not bear this load with small strains.";
            return (VerdictLevel::Collapse, text.to_owned());
        }
        match self.known.status {
            SolveStatus::Converged => {}
            SolveStatus::NotConverged => {
                let text = "No answer: this load has not converged.";
                return (VerdictLevel::NotConverged, text.to_owned());
            }
            SolveStatus::Cancelled | SolveStatus::TimedOut => {
                let text = "No answer: the job was stopped before this load had converged.";
                return (VerdictLevel::NotConverged, text.to_owned());
            }
        }
        if let Some(rolled) = &self.known.rolled {
            return self.track_verdict(rolled);
        }
        let has_yielded = self.has_yielded();
        if !self.touches() {
            return if has_yielded {
                (VerdictLevel::Dented, self.dented(rows))
            } else {
                (VerdictLevel::NoContact, "The bodies do not touch, and none has yielded.".into())
            };
        }
        if self.is_rough() {
            return self.rough_verdict(has_yielded, rows);
        }
        if has_yielded {
            return self.yields(rows);
        }
        if !self.can_yield() {
            let text = "No yield stress is given: elastic by assumption.";
            return (VerdictLevel::NotKnown, text.to_owned());
        }
        let is_unknown = |finding: &Finding| {
            matches!(
                finding,
                Finding::OnsetUnknown { .. }
                    | Finding::ElasticCorner { .. }
                    | Finding::RollerEnd { .. }
                    | Finding::Kinks
            )
        };
        if self.findings.iter().any(is_unknown) {
            let text = "Nothing yields on this mesh; whether the bodies yield is not known.";
            return (VerdictLevel::NotKnown, text.to_owned());
        }
        let is_sought = self.job.load == Load::Onset;
        match self.first_yield().filter(|first| !is_sought && self.known.figures.force > *first) {
            Some(first) => {
                let first = self.write.force_text(first);
                let text = format!(
                    "About at first yield: nothing yields on this mesh, and closed forms give \
                     first yield at {first}."
                );
                (VerdictLevel::NotKnown, text)
            }
            None => (VerdictLevel::Elastic, self.elastic(rows)),
        }
    }

    /// Returns the force of first yield, which laws without a yield point have none of.
    pub fn first_yield(&self) -> Option<f64> {
        self.measured.first_yield.filter(|_| !self.flows_from_the_first())
    }

    fn elastic(&self, rows: &[Answer]) -> String {
        let row = |name: Name| rows.iter().find(|row| row.is(name) && row.value.is_some());
        if self.job.load == Load::Onset
            && let Some(first) = row(Name::Force)
        {
            let force = said(first);
            return format!("First yield: a body begins to yield under this force, {force}.");
        }
        if let Some(first) = row(Name::FirstYieldForce) {
            let force = said(first);
            let force_now = self.write.force(self.known.figures.force);
            let part = first.value.map_or(0.0, |first| force_now / first);
            let part = to_digits(100.0 * part, first.error.digits(part).min(3));
            return format!("Elastic: this force is {part} % of that of first yield, {force}.");
        }
        match row(Name::Utilization) {
            Some(used) => format!(
                "Elastic: the largest von Mises stress is {} of the yield stress.",
                said(used)
            ),
            None => "Elastic: no body yields.".to_owned(),
        }
    }

    fn yields(&self, rows: &[Answer]) -> (VerdictLevel, String) {
        let mut parts: Vec<String> = Vec::new();
        if let Some(first) = self.first_yield().filter(|_| !self.measured.is_dented) {
            let ratio = self.known.figures.force / first;
            let by = if ratio < 1.0 { " of closed forms" } else { "" };
            parts.push(format!(
                "{} times first yield{by} at {}",
                about(ratio),
                self.write.force_text(first)
            ));
        }
        parts.extend(self.strained(rows));
        let above = self.shakedown().filter(|[peak, limit, _]| peak > limit);
        parts.extend(above.map(|[peak, limit, _]| {
            format!(
                "above the shakedown limit of a perfectly plastic body (Hertz's peak {} > {})",
                rounded(self.write.stress(peak)),
                self.write.stress_text(limit)
            )
        }));
        let level =
            if above.is_some() { VerdictLevel::AboveShakedownLimit } else { VerdictLevel::Yields };
        let yields = match (self.measured.is_dented, self.yields_by_limit()) {
            (true, _) => "Has yielded under an earlier load",
            (false, true) => "Yields",
            (false, false) => "Flows, with no yield point",
        };
        let text = if parts.is_empty() {
            format!("{yields}.")
        } else {
            format!("{yields}: {}.", parts.join("; "))
        };
        (level, text)
    }

    /// Returns the largest plastic strain and its depth, or the mean of a strain without limit.
    fn strained(&self, rows: &[Answer]) -> Option<String> {
        let row = |name: Name| rows.iter().find(|row| row.is(name) && !row.detail);
        let body = |row: &Answer| row.body.map_or("", AnswerBody::in_words);
        if let Some(most) = row(Name::MaxPlasticStrain) {
            let depth = most.place.map_or(0.0, |place| place.depth);
            return Some(format!(
                "largest plastic strain {}, {} deep{}",
                said(most),
                self.with_unit(about, Quantity::Length, depth),
                body(most)
            ));
        }
        let mean = row(Name::MeanPlasticStrain)?;
        Some(format!("mean plastic strain {}{}", said(mean), body(mean)))
    }

    fn dented(&self, rows: &[Answer]) -> String {
        let dents: Vec<_> = rows
            .iter()
            .filter(|row| row.is(Name::DentDepth) && row.value > Some(0.0))
            .map(|row| (said(row), row.body))
            .collect();
        let dent = match &dents[..] {
            [] => "The load has left plastic strain and no dent".to_owned(),
            [(depth, Some(AnswerBody::Both))] => {
                format!("The load has left a dent of {depth} in both bodies")
            }
            [(depth, body)] => {
                let body = body.map_or("", AnswerBody::in_words);
                format!("The load has left a dent of {depth}{body}")
            }
            [(upper, _), (lower, _), ..] => format!(
                "The load has left dents of {upper} in the upper and {lower} in the lower body"
            ),
        };
        let tension = rows.iter().find(|row| row.is(Name::ResidualTension));
        let tension = tension.map(|most| format!(", with tension up to {}", said(most)));
        let strain = self.strained(rows).map(|strain| format!("; {strain}"));
        format!("{dent}{}{}.", tension.unwrap_or_default(), strain.unwrap_or_default())
    }

    fn rough_verdict(&self, has_yielded: bool, rows: &[Answer]) -> (VerdictLevel, String) {
        let Some(rough) = self.rough() else { return self.yields(rows) };
        let touches = format!(
            "{} % of the area of the heights touches under a nominal pressure of {}",
            about(100.0 * rough.contact_ratio),
            self.write.stress_about(rough.nominal_pressure)
        );
        if self.measured.inside_rim.is_some_and(|(pressure, _)| pressure <= 0.0) {
            return (
                VerdictLevel::NotKnown,
                format!("{touches}, all of it at the rim: what yields is not known."),
            );
        }
        match rough.yielded_part {
            Some(part) if has_yielded => (
                VerdictLevel::Yields,
                format!("{touches}; below {} % of that area a body yields.", about(100.0 * part)),
            ),
            Some(_) => (VerdictLevel::Elastic, format!("{touches}; no body yields.")),
            None => (
                VerdictLevel::NotKnown,
                format!("{touches}; no yield stress is given: elastic by assumption."),
            ),
        }
    }
}

/// Returns the value of a row with its unit, in the digits that its bar or its bounds carry.
pub(super) fn said(row: &Answer) -> String {
    let value = row.value.unwrap_or_default();
    let spread = row.at_least.zip(row.at_most).map(|(least, most)| 0.5 * (most - least));
    let bar = spread.map_or(row.error, |spread| ErrorBar::Relative(spread / value.abs()));
    let (factor, unit) = match row.quantity {
        Quantity::Strain | Quantity::Ratio => (100.0, "%"),
        _ => (1.0, row.unit.as_str()),
    };
    let (value, digits, at_most) = match row.at_most.filter(|_| row.at_least.is_none()) {
        Some(most) => (most, UNBOUNDED_DIGITS, "at most "),
        None => (value, bar.digits(value), ""),
    };
    let value = to_digits(factor * value, digits);
    format!("{at_most}{value} {unit}").trim_end().to_owned()
}

/// Digits of a figure that nothing bounds, and the most of any.
const UNBOUNDED_DIGITS: usize = 2;
const MOST_DIGITS: usize = 5;

impl ErrorBar {
    /// Returns the number of digits of a value that are known: the last is the first of its error.
    pub(super) fn digits(self, value: f64) -> usize {
        let Some(error) = self.bound() else { return UNBOUNDED_DIGITS };
        let mut digits = 1;
        let mut unit = 10f64.powf(value.abs().log10().floor());
        while digits < MOST_DIGITS && error * value.abs() < unit {
            (digits, unit) = (digits + 1, 0.1 * unit);
        }
        digits
    }
}

#[cfg(test)]
mod tests {
    use super::super::answers::ErrorWord;
    use super::*;

    #[test]
    fn the_last_digit_is_that_of_the_error() {
        for (value, error, digits) in
            [(0.278, 0.37, 1), (1.45, 0.11, 2), (9.5, 0.02, 2), (1150.4, 0.0086, 4), (3.0, 0.0, 5)]
        {
            assert_eq!(ErrorBar::Relative(error).digits(value), digits, "{value} {error}");
        }
        assert_eq!(ErrorBar::Word(ErrorWord::NotBounded).digits(3.0), 2);
    }
}
