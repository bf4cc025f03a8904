//! Answers on the strength of the bodies: utilization, margin, core, shakedown.

use super::{Answer, AnswerBody, Bar, Facts, Name};
use crate::job::Load;
use crate::report::findings::Finding;
use crate::units::about;

impl Facts<'_> {
    /// Returns utilization and margin, which every loaded job has.
    pub(super) fn strength(&self) -> Vec<Answer> {
        if !self.touches() {
            return Vec::new();
        }
        let none = "no yield stress is given";
        let reason = if self.flows_from_the_first() {
            Some("a body has plastic strain under any stress")
        } else {
            let is_dented = self.measured.is_dented;
            is_dented.then_some("an earlier load has dented the bodies")
        };
        let used = self.measured.utilization.as_ref().filter(|_| reason.is_none());
        let utilization = self.row(Name::Utilization, used.map(|used| used.value));
        let utilization = match used {
            Some(used) => {
                let row = utilization.place(Some(self.place_of(used)));
                let row = row.text(Name::Utilization.meaning());
                if self.measured.is_of_field {
                    row.bar(Bar::none(super::row::NO_ESTIMATE))
                } else {
                    row
                }
            }
            None if !self.can_yield() => utilization.not_known(none),
            None => utilization.not_known(reason.unwrap_or(
                "closed forms do not have these shapes, and the bodies yield or the mesh does not \
                 tell the onset of yield",
            )),
        };
        let first = self.first_yield().filter(|_| reason.is_none());
        let margin = first.map(|first| first / self.known.figures.force);
        let margin = self.row(Name::Margin, margin);
        let margin = match first {
            Some(_) if self.job.load == Load::Onset => margin.bar(Bar::Given),
            Some(_) => margin,
            None if self.is_rough() => margin.not_known("rough surfaces have no closed form"),
            None if !self.can_yield() => margin.not_known(none),
            None => margin
                .not_known(reason.unwrap_or("`load.onset` looks for the force of first yield")),
        };
        [utilization, margin].into_iter().chain(self.core()).collect()
    }

    pub(super) fn core(&self) -> Option<Answer> {
        let core = self.measured.core.as_ref()?;
        let text = format!("below the case, of all {}", self.measured.points);
        let row = self.row(Name::CoreUtilization, core.value);
        Some(row.place(Some(self.place_of(core))).text(text))
    }

    pub(super) fn of_shapes(&self) -> Vec<Answer> {
        let mut rows = Vec::new();
        if let Some([peak, limit, depth]) = self.shakedown() {
            let place = self.place(AnswerBody::Both, [0.0, 0.0, depth]);
            let row = self.row(Name::ShakedownPressure, limit).place(Some(place));
            rows.push(row.text(format!(
                "of a perfectly plastic body that rolls freely; Hertz's peak is {} times that",
                about(peak / limit)
            )));
        }
        let radius = self.measured.effective_radius;
        rows.extend(radius.map(|radius| self.told(Name::EffectiveRadius, radius)));
        rows
    }

    /// Returns Hertz's peak pressure, the shakedown limit and the depth that decides, where they are
    /// those of the contact. Beyond the end of a roller the pressure is larger: a peak below the
    /// limit tells nothing. In a dent the contact is wider.
    pub fn shakedown(&self) -> Option<[f64; 3]> {
        let is_of_contact = self.touches() && !self.measured.is_dented;
        let hertz = self.known.hertz.filter(|_| is_of_contact)?;
        let (peak, [limit, depth]) = (hertz.peak_pressure, hertz.shakedown?);
        let is_known = self.findings.iter().all(|finding| match finding {
            Finding::NearSupport => false,
            Finding::RollerEnd { .. } | Finding::Kinks => peak > limit,
            _ => true,
        });
        (is_known && !self.flows_from_the_first()).then_some([peak, limit, depth])
    }
}
