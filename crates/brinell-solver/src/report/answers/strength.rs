//! Answers on the strength of the bodies: utilization, margin, core, shakedown.

use super::{Answer, Facts};
use crate::job::Quantity;
use crate::report::findings::Finding;
use crate::units::{about, rounded};

impl Facts<'_> {
    /// Returns utilization and margin, which every loaded job has.
    pub(super) fn strength(&self) -> Vec<Answer> {
        if !self.touches() {
            return Vec::new();
        }
        let none = "no yield stress is given";
        let reason = if self.flows_from_the_first() {
            Some("not known: a body has plastic strain under any stress")
        } else {
            let is_dented = self.measured.is_dented;
            is_dented.then_some("not known: an earlier load has dented the bodies")
        };
        let used = self.measured.utilization.as_ref().filter(|_| reason.is_none());
        let place = used.map(|used| self.place_of(used));
        let utilization = self
            .answer("utilization", "Utilization", Quantity::Ratio, used.map(|used| used.value))
            .place(place)
            .text(if used.is_some() {
                "largest von Mises stress of elastic bodies over the yield stress there"
            } else if let Some(reason) = reason {
                reason
            } else if self.can_yield() {
                "not known: closed forms do not have these shapes, and the bodies yield or the \
                 mesh does not tell the onset of yield"
            } else {
                none
            });
        let utilization = Answer { body: place.map(|place| place.body), ..utilization };
        let first = self.first_yield().filter(|_| reason.is_none());
        let margin = self
            .answer(
                "margin",
                "Margin to first yield",
                Quantity::Number,
                first.map(|first| first / self.step.contact.force),
            )
            .text(match (first, reason) {
                (Some(first), _) => format!(
                    "force of first yield, {}, over this force",
                    self.with_unit(rounded, self.force_quantity(), first)
                ),
                (None, Some(reason)) => reason.to_owned(),
                (None, None) if self.is_rough() => "not known of rough surfaces".to_owned(),
                (None, None) if self.can_yield() => {
                    "not known: `load.onset` looks for the force of first yield".to_owned()
                }
                (None, None) => none.to_owned(),
            });
        [utilization, margin].into_iter().chain(self.core()).collect()
    }

    pub(super) fn core(&self) -> Option<Answer> {
        let core = self.measured.core.as_ref()?;
        let place = self.place_of(core);
        Some(
            self.answer("core_utilization", "Core utilization", Quantity::Ratio, core.value)
                .of(place.body)
                .place(Some(place))
                .text(format!(
                    "von Mises stress over the yield stress below the case, largest of all {}",
                    self.measured.points
                )),
        )
    }

    pub(super) fn of_shapes(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        if let Some((peak, limit)) = self.shakedown() {
            answers.push(
                self.answer(
                    "shakedown_pressure",
                    "Shakedown pressure",
                    Quantity::Stress,
                    limit,
                )
                .text(format!(
                    "of a perfectly plastic body that rolls freely; Hertz's peak is {} times that",
                    about(peak / limit)
                )),
            );
        }
        answers.extend(self.measured.effective_radius.map(|radius| {
            self.answer(
                "effective_radius",
                "Effective radius",
                Quantity::Length,
                self.write.length(radius),
            )
            .text(
                "reciprocal of the sum of both curvatures across the shorter side of the contact",
            )
        }));
        answers
    }

    /// Returns Hertz's peak pressure and the shakedown limit, where both are those of the contact.
    /// Beyond the end of a roller the pressure is larger: a peak below the limit tells nothing. In
    /// a dent the contact is wider.
    pub fn shakedown(&self) -> Option<(f64, f64)> {
        let is_of_contact = self.touches() && !self.measured.is_dented;
        let hertz = self.step.hertz.as_ref().filter(|_| is_of_contact)?;
        let (peak, limit) = (hertz.peak_pressure, hertz.shakedown_pressure?);
        let is_known = self.findings.iter().all(|finding| match finding {
            Finding::NearSupport => false,
            Finding::RollerEnd { .. } | Finding::Kinks => peak > limit,
            _ => true,
        });
        (is_known && !self.flows_from_the_first()).then_some((peak, limit))
    }
}
