//! Answers and verdict of a load that rolls.

use super::document::{
    BodyPassReport, PassReport, RollingReport, RuleVerdict, SolvedHardening, TrackVerdict,
};
use crate::job::Load;
use crate::report::answers::{Answer, AnswerBody, AnswerPlace, Facts};
use crate::report::{PerBody, Quantity, Side, VerdictLevel};
use crate::solver::method::figures::Figure;
use crate::units::{about, rounded};

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

    /// Returns the answers of the last pass.
    pub(in crate::report) fn of_track(&self, rolling: &RollingReport) -> Vec<Answer> {
        let Some(last) = rolling.passes.last() else { return Vec::new() };
        let mut answers = vec![self.rate(rolling)];
        let sides = [(Side::Upper, &last.bodies.upper), (Side::Lower, &last.bodies.lower)];
        let is_shared = rolling.body.is_none() && last.bodies.upper == last.bodies.lower;
        let sides = sides.into_iter().filter(|(side, _)| !is_shared || *side == Side::Lower);
        for (side, body) in sides.filter_map(|(side, body)| Some((side, body.as_ref()?))) {
            let of = if is_shared { AnswerBody::Both } else { side.into() };
            answers.extend(self.of_body(last, (side, of), body));
        }
        let work = last.estimated_error.as_ref().and_then(|errors| errors.plastic_work);
        let force = self.force_quantity();
        answers.push(
            self.answer("rolling_force", "Rolling force", force, last.rolling_force)
                .error(work)
                .text("against which the load is pushed in the last pass, without friction"),
        );
        answers.push(
            self.answer("loss", "Rolling resistance", Quantity::Ratio, last.loss)
                .error(work)
                .text("rolling force over the load"),
        );
        answers.extend(self.without_member());
        answers.extend(self.limits(rolling));
        let contact = self.of_contact().into_iter();
        let has_approach = self.step.approach.is_some();
        answers.extend(
            contact.filter(|answer| has_approach || answer.name != Figure::Approach.name()),
        );
        answers
    }

    /// Returns the strain that a steady pass adds or moves.
    fn rate(&self, rolling: &RollingReport) -> Answer {
        let text = match rolling.verdict {
            TrackVerdict::Elastic => "nothing yields",
            TrackVerdict::ShakesDown => "plastic flow dies out",
            TrackVerdict::ClosedCycle => {
                "accumulated in each pass, or pair of passes, and taken back"
            }
            TrackVerdict::Ratchets => "added by each pass, or pair of passes, for good",
            TrackVerdict::Undecided => "not known: more passes are needed",
        };
        let of_rate = |(error, rate): (f64, f64)| if rate > 0.0 { error / rate } else { 0.0 };
        let error = rolling.rate_error.zip(rolling.rate).map(of_rate);
        let rate = self.answer("rate", "Strain of a steady pass", Quantity::Strain, rolling.rate);
        let body = rolling.body.map(AnswerBody::from);
        let place = |depth: f64| AnswerPlace {
            body: body.unwrap_or(AnswerBody::Both),
            x: 0.0,
            y: None,
            depth,
        };
        let rate = rate.place(rolling.rate_depth.map(place));
        Answer { body, ..rate.error(error.filter(|error| error.is_finite())).text(text) }
    }

    fn of_body(
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
        let below = |depth: f64, across: f64| {
            let y = last.half_width_across.map(|_| across);
            Some(AnswerPlace { body: of, x: 0.0, y, depth })
        };
        let stress = Quantity::Stress;
        let mut answers = vec![
            self.answer("groove_depth", "Depth of the track", Quantity::Length, body.groove_depth)
                .error(error(|errors| errors.groove_depth))
                .of(of)
                .text("how far all passes have sunk the surface, on the axis"),
            self.answer("forward", "Forward displacement", Quantity::Length, body.forward)
                .error(error(|errors| errors.forward))
                .of(of)
                .text("of the surface along the travel, by the last pass"),
            self.answer("pass_strain", "Strain, last pass", Quantity::Strain, body.largest_strain)
                .error(error(|errors| errors.largest_strain))
                .of(of)
                .place(
                    below(body.largest_strain_depth, body.largest_strain_across)
                        .filter(|_| body.largest_strain > 0.0),
                )
                .text("accumulated, largest of all layers"),
            self.answer("net_strain", "Net strain, last pass", Quantity::Strain, body.net_strain)
                .error(error(|errors| errors.net_strain))
                .of(of)
                .place(
                    below(body.net_strain_depth, body.net_strain_across)
                        .filter(|_| body.net_strain > 0.0),
                )
                .text(if error(|errors| errors.net_strain).is_some_and(|error| error >= 1.0) {
                    "below its error; what the pass has not taken back, largest of all layers"
                } else {
                    "what the pass has not taken back, largest of all layers"
                }),
            self.figure(Figure::MaxPlasticStrain, body.accumulated_strain)
                .of(of)
                .text("accumulated by all passes, largest of all layers"),
            self.answer("least_sigma_x", "Residual σ_x", stress, body.least_sigma_x)
                .error(of_stress(body.least_sigma_x))
                .of(of)
                .text("along the travel, the least over depth after the last pass"),
            self.answer("least_sigma_z", "Residual σ_z", stress, body.least_sigma_z)
                .error(of_stress(body.least_sigma_z))
                .of(of)
                .text("across the travel, the least over depth after the last pass"),
        ];
        if last.half_width_across.is_some() {
            let pile_up = self.answer("pile_up", "Pile-up", Quantity::Length, body.pile_up);
            let pile_up = pile_up.error(error(|errors| errors.pile_up)).of(of);
            answers.insert(
                1,
                pile_up.text("how far all passes have raised the surface beside the track"),
            );
        }
        answers
    }

    fn limits(&self, rolling: &RollingReport) -> Vec<Answer> {
        let stress = Quantity::Stress;
        let place = |limit: &super::TrackLimitReport| {
            Some(AnswerPlace { body: limit.body.into(), x: 0.0, y: None, depth: limit.depth })
        };
        let perfect = rolling.limits.perfect.as_ref().map(|limit| {
            self.answer("shakedown_pressure", "Shakedown pressure", stress, limit.peak_pressure)
                .place(place(limit))
                .text("Hertz's peak up to which perfectly plastic bodies shake down")
        });
        let kinematic = rolling.limits.kinematic.as_ref().map(|limit| {
            self.answer(
                "kinematic_shakedown_pressure",
                "Kinematic shakedown",
                stress,
                limit.peak_pressure,
            )
            .place(place(limit))
            .text("of bodies whose backstress has no bound, on these layers")
        });
        let peak = self.answer(
            "elastic_peak_pressure",
            "Peak pressure of Hertz",
            stress,
            self.step.hertz.as_ref().map(|hertz| hertz.peak_pressure),
        );
        perfect
            .into_iter()
            .chain(kinematic)
            .chain([peak.text("to be held beside the limits")])
            .collect()
    }
}

/// Returns a strain with its error, both in per cent.
fn strain(rate: Option<f64>, error: Option<f64>) -> String {
    let Some(rate) = rate else { return String::new() };
    let error = error.filter(|error| error.is_finite());
    let error = error.map(|error| format!(" ± {}", about(100.0 * error)));
    format!("{}{} %", about(100.0 * rate), error.unwrap_or_default())
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
