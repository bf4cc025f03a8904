//! Answers and verdict of a load that rolls.

use super::document::{BodyPassReport, PassReport, RollingReport, TrackVerdict};
use crate::report::answers::{Answer, AnswerBody, AnswerPlace, AnswerQuantity, Facts};
use crate::report::{PerBody, Side, VerdictLevel};
use crate::solver::method::figures::Figure;
use crate::units::{about, rounded};

type ErrorOf = fn(&super::document::BodyPassErrorReport) -> Option<f64>;

impl Facts<'_> {
    /// Returns level and sentence of the verdict on a track.
    pub(in crate::report) fn track_verdict(
        &self,
        rolling: &RollingReport,
    ) -> (VerdictLevel, String) {
        let passes = match rolling.passes.len() {
            1 => "1 pass".to_owned(),
            n => format!("{n} passes"),
        };
        let body = in_body(rolling.body);
        let rate = rolling.rate.map_or_else(String::new, |rate| {
            let bar = rolling.rate_error.unwrap_or(0.0) / rate;
            let bar = if bar.is_finite() {
                format!(" (± {} %)", about(100.0 * bar))
            } else {
                String::new()
            };
            format!("{} %{bar}", about(100.0 * rate))
        });
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
                VerdictLevel::ShakesDown,
                format!("Shakes down: plastic flow dies out{body} within {passes}"),
            ),
            TrackVerdict::ClosedCycle => (
                VerdictLevel::ClosedCycle,
                format!(
                    "Closes a cycle: {each} flows by a plastic strain of {rate}{body} and takes \
                     it back, which is low-cycle fatigue"
                ),
            ),
            TrackVerdict::Ratchets => (
                VerdictLevel::Ratchets,
                format!("Ratchets: {each} adds a plastic strain of {rate}{body}"),
            ),
            TrackVerdict::Undecided => (
                VerdictLevel::NotKnown,
                format!("Not decided after {passes}: the track still changes"),
            ),
        };
        let limit = rolling.limits.perfect.zip(self.step.hertz.as_ref()).map(|(limit, hertz)| {
            format!(
                "; Hertz's peak is {} times the limit of shakedown of a perfectly plastic body, {}",
                about(hertz.peak_pressure / limit.peak_pressure),
                self.with_unit(rounded, AnswerQuantity::Stress, limit.peak_pressure)
            )
        });
        (level, format!("{text}{}.", limit.unwrap_or_default()))
    }

    /// Returns the answers of the last pass.
    pub(in crate::report) fn of_track(&self, rolling: &RollingReport) -> Vec<Answer> {
        let Some(last) = rolling.passes.last() else { return Vec::new() };
        let mut answers = vec![self.rate(rolling)];
        let sides = [(Side::Upper, &last.bodies.upper), (Side::Lower, &last.bodies.lower)];
        let is_shared = rolling.body.is_none() && last.bodies.upper == last.bodies.lower;
        let sides = sides.into_iter().filter(|(side, _)| !is_shared || *side == Side::Lower);
        for (side, body) in sides.filter_map(|(side, body)| Some((side, body.as_ref()?))) {
            let of = if is_shared { AnswerBody::Both } else { of_side(side) };
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
            self.answer("loss", "Rolling resistance", AnswerQuantity::Ratio, last.loss)
                .error(work)
                .text("rolling force over the load"),
        );
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
        let rate =
            self.answer("rate", "Strain of a steady pass", AnswerQuantity::Strain, rolling.rate);
        let body = rolling.body.map(of_side);
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
        let below = |depth: f64, across: f64| {
            let y = last.half_width_across.map(|_| across);
            Some(AnswerPlace { body: of, x: 0.0, y, depth })
        };
        let stress = AnswerQuantity::Stress;
        vec![
            self.answer(
                "groove_depth",
                "Depth of the track",
                AnswerQuantity::Length,
                body.groove_depth,
            )
            .error(error(|errors| errors.groove_depth))
            .of(of)
            .text("how far all passes have sunk the surface, on the axis"),
            self.answer("forward", "Forward displacement", AnswerQuantity::Length, body.forward)
                .error(error(|errors| errors.forward))
                .of(of)
                .text("of the surface along the travel, by the last pass"),
            self.answer(
                "pass_strain",
                "Strain, last pass",
                AnswerQuantity::Strain,
                body.largest_strain,
            )
            .error(error(|errors| errors.largest_strain))
            .of(of)
            .place(
                below(body.largest_strain_depth, body.largest_strain_across)
                    .filter(|_| body.largest_strain > 0.0),
            )
            .text("accumulated, largest of all layers"),
            self.answer(
                "net_strain",
                "Net strain, last pass",
                AnswerQuantity::Strain,
                body.net_strain,
            )
            .error(error(|errors| errors.net_strain))
            .of(of)
            .place(
                below(body.net_strain_depth, body.net_strain_across)
                    .filter(|_| body.net_strain > 0.0),
            )
            .text("what the pass has not taken back, largest of all layers"),
            self.figure(Figure::MaxPlasticStrain, body.accumulated_strain)
                .of(of)
                .text("accumulated by all passes, largest of all layers"),
            self.answer("least_sigma_x", "Residual σ_x", stress, body.least_sigma_x)
                .error(error(|errors| errors.residual))
                .of(of)
                .text("along the travel, the least over depth after the last pass"),
            self.answer("least_sigma_z", "Residual σ_z", stress, body.least_sigma_z)
                .error(error(|errors| errors.residual))
                .of(of)
                .text("across the travel, the least over depth after the last pass"),
        ]
    }

    fn limits(&self, rolling: &RollingReport) -> Vec<Answer> {
        let stress = AnswerQuantity::Stress;
        let place = |limit: &super::TrackLimitReport| {
            Some(AnswerPlace { body: of_side(limit.body), x: 0.0, y: None, depth: limit.depth })
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

const fn of_side(side: Side) -> AnswerBody {
    match side {
        Side::Upper => AnswerBody::Upper,
        Side::Lower => AnswerBody::Lower,
    }
}

const fn in_body(body: Option<Side>) -> &'static str {
    match body {
        Some(Side::Upper) => " in the upper body",
        Some(Side::Lower) => " in the lower body",
        None => "",
    }
}
