//! Answers and verdict of a load that rolls.

use super::document::{
    BodyPassReport, PassReport, RollingReport, RuleVerdict, SolvedHardening, TrackVerdict,
};
use crate::job::Load;
use crate::report::answers::{Answer, AnswerAt, AnswerBody, AnswerPlace, Bar, Facts, Name};
use crate::report::{ErrorBar, PerBody, Quantity, Side, VerdictLevel};
use crate::units::{about, rounded, to_digits};

/// Why a figure of a pass has no bar.
const NO_BAR: &str = "the pass on half the columns does not bound it";

type ErrorOf = fn(&super::document::BodyPassErrorReport) -> Option<f64>;

impl Facts<'_> {
    /// Returns level and sentence of the verdict on a track.
    pub(in crate::report) fn track_verdict(
        &self,
        rolling: &RollingReport,
    ) -> (VerdictLevel, String) {
        let is_worst =
            |rule: &&RuleVerdict| (rule.verdict, rule.rate) == (rolling.verdict, rolling.rate);
        let worst = rolling.rules.iter().rev().find(is_worst);
        let rule = worst.map_or("", |worst| by_rule(worst.hardening));
        let passes = self.passes_of(worst.map_or(rolling.passes.len(), |worst| worst.passes));
        let body = in_body(rolling.body);
        let rate = strain(rolling.rate, rolling.rate_error);
        let at = match rolling.rate_depth {
            Some(depth) if depth > 0.0 => {
                format!(" at a depth of {}", self.with_unit(about, Quantity::Length, depth))
            }
            Some(_) => " at the surface".to_owned(),
            None => String::new(),
        };
        let each = if self.is_alternating() { "each pass there and back" } else { "each pass" };
        let (level, text) = match rolling.verdict {
            TrackVerdict::Elastic if !self.can_yield() => (
                VerdictLevel::NotKnown,
                "No yield stress is given: elastic by assumption".to_owned(),
            ),
            TrackVerdict::Elastic => {
                (VerdictLevel::Elastic, "Elastic: nothing yields as the load rolls".to_owned())
            }
            TrackVerdict::ShakesDown => (
                if self.is_beyond(rolling) {
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
        let other = rolling.rules.iter().find(|rule| {
            rolling.rules.len() > 1 && worst.is_some_and(|worst| worst.hardening != rule.hardening)
        });
        let other = other.map_or_else(String::new, |rule| self.beside(rule));
        let perfect = rolling.limits.perfect.zip(self.step.hertz.as_ref());
        let limit = perfect.map_or_else(String::new, |(limit, hertz)| {
            format!(
                "; Hertz's peak is {} times the limit of shakedown of a perfectly plastic body, {}",
                about(hertz.peak_pressure / limit.peak_pressure),
                self.with_unit(rounded, Quantity::Stress, limit.peak_pressure)
            )
        });
        (level, format!("{text}{other}{limit}."))
    }

    /// Returns what a second rule of hardening says.
    fn beside(&self, rule: &RuleVerdict) -> String {
        let rate = strain(rule.rate, rule.rate_error);
        let passes = self.passes_of(rule.passes);
        let says = match rule.verdict {
            TrackVerdict::Elastic => "nothing yields".to_owned(),
            TrackVerdict::ShakesDown => format!("it shakes down within {passes}"),
            TrackVerdict::ClosedCycle => format!("it closes a cycle of {rate}"),
            TrackVerdict::Ratchets => format!("it ratchets by {rate} a pass"),
            TrackVerdict::Undecided => format!("it is not decided after {passes}"),
        };
        format!(";{} {says}", by_rule(rule.hardening))
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
    fn is_beyond(&self, rolling: &RollingReport) -> bool {
        let limit = rolling.limits.kinematic.zip(self.step.hertz.as_ref());
        limit.is_some_and(|(limit, hertz)| hertz.peak_pressure > limit.peak_pressure)
    }

    /// Returns the rows of the last pass.
    pub(in crate::report) fn of_track(&self, rolling: &RollingReport) -> Vec<Answer> {
        let Some(last) = rolling.passes.last() else { return Vec::new() };
        let mut rows = self.rates(rolling);
        let sides = [(Side::Upper, &last.bodies.upper), (Side::Lower, &last.bodies.lower)];
        let is_shared = rolling.body.is_none() && last.bodies.upper == last.bodies.lower;
        let sides = sides.into_iter().filter(|(side, _)| !is_shared || *side == Side::Lower);
        for (side, body) in sides.filter_map(|(side, body)| Some((side, body.as_ref()?))) {
            let of = if is_shared { AnswerBody::Both } else { side.into() };
            rows.extend(self.of_pass(last, (side, of), body));
        }
        rows.extend(self.works(last));
        rows.extend(self.plastic_depths());
        rows.extend(self.limits(rolling));
        let contact = self.of_contact().into_iter();
        let across = last.half_width_across.map(|across| self.row(Name::HalfWidthAcross, across));
        let approach = self.step.approach.map(|_| self.approach());
        rows.extend(contact.chain(across).chain(approach));
        let at = AnswerAt { pass: Some(last.number), ..AnswerAt::default() };
        let of_pass = |row: Answer| if row.at.is_none() { row.at(at) } else { row };
        rows.into_iter().map(of_pass).collect()
    }

    /// Returns works and resistance of the last pass.
    fn works(&self, last: &PassReport) -> Vec<Answer> {
        let work = last.estimated_error.as_ref().and_then(|errors| errors.plastic_work);
        let bar = || work.map_or_else(|| Bar::none(NO_BAR), Bar::Relative);
        let force = self.row(Name::RollingForce, last.rolling_force).bar(bar());
        let loss = self.row(Name::RollingResistance, last.loss).bar(bar());
        let details = [
            self.row(Name::PassWork, last.plastic_work).bar(bar()),
            self.row(Name::PassStoredEnergy, last.stored_energy),
            self.row(Name::TractionWork, last.traction_work),
            self.row(Name::EnergyGap, last.energy_gap),
        ];
        let rows = [
            force.text("against which the load is pushed in the last pass, without friction"),
            loss.text("rolling force over the load"),
        ];
        rows.into_iter().chain(details.map(Answer::detail)).collect()
    }

    /// Returns the strain that a steady pass adds or moves, by each rule of hardening; that of the
    /// verdict first.
    fn rates(&self, rolling: &RollingReport) -> Vec<Answer> {
        let text = |verdict: TrackVerdict| match verdict {
            TrackVerdict::Elastic => "nothing yields",
            TrackVerdict::ShakesDown => "plastic flow dies out",
            TrackVerdict::ClosedCycle => {
                "accumulated in each pass, or pair of passes, and taken back"
            }
            TrackVerdict::Ratchets => "added by each pass, or pair of passes, for good",
            TrackVerdict::Undecided => "not known: more passes are needed",
        };
        let bar = |rule: &RuleVerdict| match (rule.verdict, rule.rate, rule.rate_error) {
            (TrackVerdict::ShakesDown | TrackVerdict::Elastic, ..) => {
                Bar::none("a figure of zero has no relative error")
            }
            (_, Some(rate), Some(error)) if rate > 0.0 && error.is_finite() => {
                Bar::Relative(error / rate)
            }
            _ => Bar::none(NO_BAR),
        };
        let body = rolling.body.map(AnswerBody::from);
        let place = |depth: f64| AnswerPlace {
            body: body.unwrap_or(AnswerBody::Both),
            x: 0.0,
            y: None,
            depth,
        };
        let is_worst =
            |rule: &RuleVerdict| (rule.verdict, rule.rate) == (rolling.verdict, rolling.rate);
        let of = |rule: &RuleVerdict| {
            let row = self.row(Name::StrainPerPass, rule.rate).bar(bar(rule));
            let hardening = (rolling.rules.len() > 1).then_some(rule.hardening);
            let at = AnswerAt { pass: Some(rule.passes), hardening, load: None };
            let label = Name::StrainPerPass.label();
            let label = format!("{label}{}", by_rule(rule.hardening));
            let row = row.at(at).labelled(&label).text(text(rule.verdict));
            if is_worst(rule) {
                let place = rolling.rate_depth.map(place);
                Answer { body, ..row.place(place) }
            } else {
                row.detail()
            }
        };
        rolling.rules.iter().rev().map(of).collect()
    }

    fn of_pass(
        &self,
        last: &PassReport,
        (side, of): (Side, AnswerBody),
        body: &BodyPassReport,
    ) -> Vec<Answer> {
        let error = |figure: ErrorOf| {
            let errors = &last.estimated_error.as_ref()?.bodies;
            let PerBody { upper, lower } = errors;
            if side == Side::Upper { upper } else { lower }.as_ref().and_then(figure)
        };
        let of_stress = |stress: f64| {
            error(|errors| errors.residual)
                .map(|error| error * body.largest_residual() / stress.abs())
                .filter(|error| error.is_finite())
        };
        let row = |name: Name, value: f64, error: Option<f64>| {
            let bar = error.map_or_else(|| Bar::none(NO_BAR), Bar::Relative);
            self.row(name, value).bar(bar).of(of)
        };
        let stress = |name: Name, value: f64| row(name, value, of_stress(value));
        let below = |value: f64, depth: f64, across: f64| {
            let y = last.half_width_across.map(|_| across);
            (value > 0.0).then_some(AnswerPlace { body: of, x: 0.0, y, depth })
        };
        let net = error(|errors| errors.net_strain);
        let mut rows = vec![
            row(Name::TrackDepth, body.groove_depth, error(|errors| errors.groove_depth))
                .text("how far all passes have sunk the surface, on the axis"),
            row(Name::ForwardDisplacement, body.forward, error(|errors| errors.forward))
                .text("of the surface along the travel, by the last pass"),
            row(Name::PassStrain, body.largest_strain, error(|errors| errors.largest_strain))
                .place(below(
                    body.largest_strain,
                    body.largest_strain_depth,
                    body.largest_strain_across,
                ))
                .text("accumulated, largest of all layers"),
            row(Name::NetStrain, body.net_strain, net)
                .place(below(body.net_strain, body.net_strain_depth, body.net_strain_across))
                .text(if net.is_some_and(|error| error >= 1.0) {
                    "below its error; what the pass has not taken back, largest of all layers"
                } else {
                    "what the pass has not taken back, largest of all layers"
                }),
            row(Name::MaxPlasticStrain, body.accumulated_strain, None)
                .text("accumulated by all passes, largest of all layers"),
            stress(Name::LeastSigmaX, body.least_sigma_x)
                .text("along the travel, the least over depth after the last pass"),
            stress(Name::LeastSigmaZ, body.least_sigma_z)
                .text("across the travel, the least over depth after the last pass"),
            stress(Name::LargestSigmaX, body.largest_sigma_x).detail(),
            stress(Name::LargestSigmaZ, body.largest_sigma_z).detail(),
        ];
        if last.half_width_across.is_some() {
            let pile_up = row(Name::PileUp, body.pile_up, error(|errors| errors.pile_up));
            let text = "how far all passes have raised the surface beside the track";
            rows.insert(1, pile_up.text(text));
        }
        rows
    }

    fn limits(&self, rolling: &RollingReport) -> Vec<Answer> {
        let place = |limit: &super::TrackLimitReport| {
            Some(AnswerPlace { body: limit.body.into(), x: 0.0, y: None, depth: limit.depth })
        };
        let perfect = rolling.limits.perfect.as_ref().map(|limit| {
            self.row(Name::ShakedownPressure, limit.peak_pressure)
                .place(place(limit))
                .text("Hertz's peak up to which perfectly plastic bodies shake down")
        });
        let kinematic = rolling.limits.kinematic.as_ref().map(|limit| {
            self.row(Name::KinematicShakedownPressure, limit.peak_pressure)
                .place(place(limit))
                .text("of bodies whose backstress has no bound, on these layers")
        });
        let shear = rolling.limits.shear_yield_stress;
        let shear = shear.map(|shear| self.row(Name::ShearYieldStress, shear).detail());
        let friction = self.row(Name::Friction, rolling.friction).bar(Bar::Given).detail();
        perfect.into_iter().chain(kinematic).chain(shear).chain([friction]).collect()
    }
}

/// Returns a strain in the digits of its error, and the error, both in per cent.
fn strain(rate: Option<f64>, error: Option<f64>) -> String {
    let Some(rate) = rate else { return String::new() };
    let Some(error) = error.filter(|error| error.is_finite() && rate > 0.0) else {
        return format!("{} %", about(100.0 * rate));
    };
    let digits = ErrorBar::Relative(error / rate).digits();
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
