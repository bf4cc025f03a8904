//! Rows and verdict of a load that rolls.

use super::document::{SolvedHardening, TrackVerdict};
use super::known::{PassFigure, Rolled, Ruled};
use crate::job::{Load, Named as _, Side};
use crate::report::answers::{Answer, AnswerAt, AnswerBody, Bar, Facts, Name};
use crate::report::{ErrorBar, VerdictLevel};
use crate::solver::rolling::Limit;
use crate::units::{about, to_digits};

/// Why a figure of a pass has no bar.
const NO_BAR: &str = "the pass on half the columns does not bound it";

impl Facts<'_> {
    /// Returns level and sentence of the verdict on a track.
    pub(in crate::report) fn track_verdict(&self, rolled: &Rolled) -> (VerdictLevel, String) {
        let worst = rolled.worst();
        let verdict = worst.map_or(TrackVerdict::Undecided, Ruled::verdict);
        let rule = worst.map_or("", |worst| by_rule(worst.hardening()));
        let passes = self.passes_of(worst.map_or(0, |worst| worst.passes));
        let body = in_body(worst.and_then(|worst| worst.body));
        let rate = worst.map_or_else(String::new, strain);
        let at = match worst.and_then(|worst| worst.depth) {
            Some(depth) if depth > 0.0 => {
                format!(" at a depth of {}", self.write.length_about(depth))
            }
            Some(_) => " at the surface".to_owned(),
            None => String::new(),
        };
        let each = if self.is_alternating() { "each pass there and back" } else { "each pass" };
        let (level, text) = match verdict {
            TrackVerdict::Elastic if !self.can_yield() => (
                VerdictLevel::NotKnown,
                "No yield stress is given: elastic by assumption".to_owned(),
            ),
            TrackVerdict::Elastic => {
                (VerdictLevel::Elastic, "Elastic: nothing yields as the load rolls".to_owned())
            }
            TrackVerdict::ShakesDown => (
                if self.is_beyond(rolled) {
                    VerdictLevel::AboveShakedownLimit
                } else {
                    VerdictLevel::ShakesDown
                },
                format!("Shakes down{rule}: plastic flow dies out{body} within {passes}"),
            ),
            TrackVerdict::ClosedCycle => (
                VerdictLevel::ClosedCycle,
                format!(
                    "Closes a cycle{rule}: after {passes} {each} flows by a plastic strain of \
                     {rate}{at}{body} and takes it back, which is low-cycle fatigue"
                ),
            ),
            TrackVerdict::Ratchets => (
                VerdictLevel::Ratchets,
                format!(
                    "Ratchets{rule}: after {passes} {each} adds a plastic strain of \
                     {rate}{at}{body}"
                ),
            ),
            TrackVerdict::Undecided => {
                (VerdictLevel::NotKnown, format!("Not decided after {passes}{rule}"))
            }
        };
        let other = rolled.rules.iter().enumerate().find(|(place, _)| *place != rolled.worst);
        let other = other.map_or_else(String::new, |(_, rule)| self.beside(rule));
        let perfect = rolled.limits[0].zip(self.known.hertz);
        let limit = perfect.map_or_else(String::new, |(limit, hertz)| {
            format!(
                "; Hertz's peak is {} times the limit of shakedown of a perfectly plastic body, {}",
                about(hertz.peak_pressure / limit.peak_pressure),
                self.write.stress_text(limit.peak_pressure)
            )
        });
        (level, format!("{text}{other}{limit}."))
    }

    /// Returns what a second rule of hardening says.
    fn beside(&self, rule: &Ruled) -> String {
        let rate = strain(rule);
        let passes = self.passes_of(rule.passes);
        let says = match rule.verdict() {
            TrackVerdict::Elastic => "nothing yields".to_owned(),
            TrackVerdict::ShakesDown => format!("it shakes down within {passes}"),
            TrackVerdict::ClosedCycle => format!("it closes a cycle of {rate}"),
            TrackVerdict::Ratchets => format!("it ratchets by {rate} a pass"),
            TrackVerdict::Undecided => format!("it is not decided after {passes}"),
        };
        format!(";{} {says}", by_rule(rule.hardening()))
    }

    /// Returns a number of passes, of those asked for where fewer were enough.
    fn passes_of(&self, number: usize) -> String {
        let asked = match self.job.load {
            Load::Rolling(rolling) => rolling.passes as usize,
            _ => number,
        };
        match number {
            1 if asked == 1 => "1 pass".to_owned(),
            n if n < asked => format!("{n} of {asked} passes"),
            n => format!("{n} passes"),
        }
    }

    /// Returns whether the pressure is above the limit of bodies whose backstress has no bound,
    /// which no rule but isotropic hardening exceeds.
    fn is_beyond(&self, rolled: &Rolled) -> bool {
        let limit = rolled.limits[1].zip(self.known.hertz);
        limit.is_some_and(|(limit, hertz)| hertz.peak_pressure > limit.peak_pressure)
    }

    /// Returns the rows of the last pass.
    pub(in crate::report) fn of_track(&self, rolled: &Rolled) -> Vec<Answer> {
        let Some(last) = &rolled.last else { return Vec::new() };
        let mut rows = self.rates(rolled);
        for side in self.sides() {
            let of = self.body(*side);
            let figures = &last.bodies[side.member()];
            rows.extend(figures.iter().map(|figure| self.of_pass(figure, Some(of)).of(of)));
        }
        rows.extend(self.fatigue());
        rows.extend(last.works.iter().map(|figure| self.of_pass(figure, None)));
        rows.extend(self.plastic_depths());
        rows.extend(self.limits(rolled));
        rows.extend(self.of_contact());
        let has = |name: Name| last.contact.iter().find(|figure| figure.name == name);
        rows.extend(has(Name::HalfWidthAcross).map(|figure| self.of_pass(figure, None)));
        rows.extend(has(Name::Approach).map(|_| self.approach()));
        let at = AnswerAt { pass: Some(last.number), ..AnswerAt::default() };
        let of_pass = |row: Answer| if row.at.is_none() { row.at(at) } else { row };
        rows.into_iter().map(of_pass).collect()
    }

    /// Returns the row of a figure of a pass.
    fn of_pass(&self, figure: &PassFigure, body: Option<AnswerBody>) -> Answer {
        let bar = figure.bar().map_or_else(|| Bar::none(NO_BAR), Bar::Relative);
        let row = self.told(figure.name, figure.core).bar(bar);
        let place = figure.place.zip(body);
        let place = place.map(|([across, depth], body)| self.place(body, [0.0, across, depth]));
        let row = row.place(place);
        if figure.is_detail { row.detail() } else { row }
    }

    /// Returns the strain that a steady pass adds or moves, by each rule of hardening; that of the
    /// verdict first.
    fn rates(&self, rolled: &Rolled) -> Vec<Answer> {
        let text = |verdict: TrackVerdict| match verdict {
            TrackVerdict::Elastic => "nothing yields",
            TrackVerdict::ShakesDown => "plastic flow dies out",
            TrackVerdict::ClosedCycle => {
                "accumulated in each pass, or pair of passes, and taken back"
            }
            TrackVerdict::Ratchets => "added by each pass, or pair of passes, for good",
            TrackVerdict::Undecided => "",
        };
        let of = |(k, rule): (usize, &Ruled)| {
            let bar = rule.rate.zip(rule.rate_error).map(|(rate, error)| error / rate);
            let bar = bar.filter(|bar| bar.is_finite());
            let bar = bar.map_or_else(|| Bar::none(NO_BAR), Bar::Relative);
            let hardening = (rolled.rules.len() > 1).then_some(rule.hardening());
            let at = AnswerAt { pass: Some(rule.passes), hardening, ..AnswerAt::default() };
            let label = Name::StrainPerPass.label();
            let label = match rule.hardening() {
                SolvedHardening::Given => label.to_owned(),
                hardening => format!("{label}, {}", hardening.name()),
            };
            let row = self.row(Name::StrainPerPass, rule.rate).bar(bar).at(at);
            let row = match rule.verdict() {
                TrackVerdict::Undecided => row.not_known("more passes are needed"),
                verdict => row.text(text(verdict)),
            };
            let row = row.labelled(&label);
            let body = rule.body.map(AnswerBody::from);
            let of = body.unwrap_or(AnswerBody::Both);
            let place = rule.depth.map(|depth| self.place(of, [0.0, 0.0, depth]));
            let row = Answer { body, ..row.place(place) };
            if k == rolled.worst { row } else { row.detail() }
        };
        rolled.rules.iter().enumerate().map(of).collect()
    }

    fn limits(&self, rolled: &Rolled) -> Vec<Answer> {
        let row = |name: Name, limit: Option<Limit>| {
            let limit = limit?;
            let place = self.place(Side::of(limit.side).into(), [0.0, 0.0, limit.depth]);
            Some(self.told(name, limit.peak_pressure).place(Some(place)))
        };
        let [perfect, kinematic] = rolled.limits;
        let limits = [
            row(Name::ShakedownPressure, perfect),
            row(Name::KinematicShakedownPressure, kinematic),
        ];
        let shear = rolled.shear_yield_stress;
        let shear = shear.map(|shear| self.row(Name::ShearYieldStress, shear).detail());
        let friction = self.row(Name::Friction, rolled.friction).bar(Bar::Given).detail();
        limits.into_iter().flatten().chain(shear).chain([friction]).collect()
    }
}

/// Returns the strain of a steady pass in the digits of its error, and the error, both in per cent.
fn strain(rule: &Ruled) -> String {
    let Some(rate) = rule.rate else { return String::new() };
    let Some(error) = rule.rate_error.filter(|error| error.is_finite() && rate > 0.0) else {
        return format!("{} %", about(100.0 * rate));
    };
    let digits = ErrorBar::Relative(error / rate).digits(rate);
    format!("{} ± {} %", to_digits(100.0 * rate, digits), to_digits(100.0 * error, 2))
}

/// Returns the rule that a verdict is said under.
const fn by_rule(rule: SolvedHardening) -> &'static str {
    match rule {
        SolvedHardening::Given => "",
        SolvedHardening::Isotropic => " with isotropic hardening",
        SolvedHardening::Kinematic => " with kinematic hardening",
    }
}

const fn in_body(body: Option<Side>) -> &'static str {
    match body {
        Some(Side::Upper) => " in the upper body",
        Some(Side::Lower) => " in the lower body",
        None => "",
    }
}
