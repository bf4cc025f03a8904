//! The verdict on a load step: one level and one sentence.

use serde::{Deserialize, Serialize};
use strum::{IntoStaticStr, VariantArray};

use super::answers::{AnswerBody, Facts};
use super::findings::Finding;
use crate::job::{Load, Named, Quantity};
use crate::solver::SolveStatus;
use crate::units::{about, rounded};

/// The verdict on a load step.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Verdict {
    /// The state of the bodies.
    pub level: VerdictLevel,
    /// One sentence for a person.
    pub text: String,
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

impl Facts<'_> {
    /// Returns the verdict.
    pub(super) fn verdict(&self) -> Verdict {
        let (level, text) = self.judged();
        Verdict { level, text }
    }

    fn judged(&self) -> (VerdictLevel, String) {
        let has = |is: fn(&Finding) -> bool| self.findings.iter().any(is);
        if has(|finding| matches!(finding, Finding::Collapse { .. })) {
            let text = "The bodies do not bear this load with small strains.";
            return (VerdictLevel::Collapse, text.to_owned());
        }
        match self.step.status {
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
        if let Some(rolling) = &self.step.rolling {
            return self.track_verdict(rolling);
        }
        let has_yielded = self.has_yielded();
        if !self.touches() {
            return if has_yielded {
                (VerdictLevel::Dented, self.dented())
            } else {
                (VerdictLevel::NoContact, "The bodies do not touch, and none has yielded.".into())
            };
        }
        if self.is_rough() {
            return self.rough(has_yielded);
        }
        if has_yielded {
            return self.yields();
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
        match self.first_yield().filter(|first| !is_sought && self.step.contact.force > *first) {
            Some(first) => {
                let first = self.with_unit(rounded, self.force_quantity(), first);
                let text = format!(
                    "About at first yield: nothing yields on this mesh, and closed forms give \
                     first yield at {first}."
                );
                (VerdictLevel::NotKnown, text)
            }
            None => (VerdictLevel::Elastic, self.elastic()),
        }
    }

    /// Returns the force of first yield, which laws without a yield point have none of.
    pub fn first_yield(&self) -> Option<f64> {
        let force = self.measured.first_yield.filter(|_| !self.flows_from_the_first());
        force.map(|force| self.write.force(force))
    }

    fn elastic(&self) -> String {
        if let Some(first) = self.first_yield() {
            if self.job.load == Load::Onset {
                let force = self.with_unit(rounded, self.force_quantity(), first);
                return format!("First yield: a body begins to yield under this force, {force}.");
            }
            return format!(
                "Elastic: this force is {} % of that of first yield, {}.",
                about(100.0 * self.step.contact.force / first),
                self.with_unit(rounded, self.force_quantity(), first)
            );
        }
        match &self.measured.utilization {
            Some(used) => format!(
                "Elastic: the largest von Mises stress is {} % of the yield stress.",
                about(100.0 * used.value)
            ),
            None => "Elastic: no body yields.".to_owned(),
        }
    }

    fn yields(&self) -> (VerdictLevel, String) {
        let mut parts: Vec<String> = Vec::new();
        if let Some(first) = self.first_yield().filter(|_| !self.measured.is_dented) {
            let ratio = self.step.contact.force / first;
            let by = if ratio < 1.0 { " of closed forms" } else { "" };
            parts.push(format!(
                "{} times first yield{by} at {}",
                about(ratio),
                self.with_unit(rounded, self.force_quantity(), first)
            ));
        }
        parts.extend(self.strained());
        let above = self.shakedown().filter(|(peak, limit)| peak > limit);
        parts.extend(above.map(|(peak, limit)| {
            format!(
                "above the shakedown limit of a perfectly plastic body (Hertz's peak {} > {})",
                rounded(peak),
                self.with_unit(rounded, Quantity::Stress, limit)
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
    fn strained(&self) -> Option<String> {
        let (body, zone) = self.most_strained()?;
        let body = match body {
            AnswerBody::Upper => " in the upper body",
            AnswerBody::Lower => " in the lower body",
            AnswerBody::Both => "",
        };
        Some(match zone.max_equivalent_plastic_strain {
            Some(strain) => format!(
                "largest plastic strain {} %, {} deep{body}",
                about(100.0 * strain),
                self.with_unit(about, Quantity::Length, zone.depth)
            ),
            None => format!(
                "mean plastic strain {} %{body}",
                about(100.0 * zone.mean_equivalent_plastic_strain)
            ),
        })
    }

    fn dented(&self) -> String {
        let surfaces = self.step.flow.as_ref().map(|flow| &flow.surfaces);
        let depths = surfaces.map(|surfaces| {
            let depth = |surface: &Option<super::SurfaceReport>| {
                surface.as_ref().map_or(0.0, |surface| surface.depth)
            };
            [depth(&surfaces.upper), depth(&surfaces.lower)]
        });
        let [upper, lower] = depths.unwrap_or_default();
        let length = |depth: f64| self.with_unit(about, Quantity::Length, depth);
        let dent = match (upper > 0.0, lower > 0.0) {
            (true, true) if self.is_alike() => {
                format!("The load has left a dent of {} in both bodies", length(lower))
            }
            (true, true) => format!(
                "The load has left dents of {} in the upper and {} in the lower body",
                length(upper),
                length(lower)
            ),
            (true, false) => {
                format!("The load has left a dent of {} in the upper body", length(upper))
            }
            (false, true) => {
                format!("The load has left a dent of {} in the lower body", length(lower))
            }
            (false, false) => "The load has left plastic strain and no dent".to_owned(),
        };
        let tension = self.measured.tension.as_ref().filter(|most| most.value > 0.0);
        let tension = tension.map(|most| {
            let stress = self.write.stress(most.value);
            format!(", with tension up to {}", self.with_unit(about, Quantity::Stress, stress))
        });
        let strain = self.strained().map(|strain| format!("; {strain}"));
        format!("{dent}{}{}.", tension.unwrap_or_default(), strain.unwrap_or_default())
    }

    fn rough(&self, has_yielded: bool) -> (VerdictLevel, String) {
        let whole = self.step.three_dimensional.as_ref();
        let Some(rough) = whole.and_then(|whole| whole.surface.as_ref()) else {
            return self.yields();
        };
        let touches = format!(
            "{} % of the area of the heights touches under a nominal pressure of {}",
            about(100.0 * rough.contact_ratio),
            self.with_unit(about, Quantity::Stress, rough.nominal_pressure)
        );
        if self.measured.inside_rim.is_some_and(|(pressure, _)| pressure <= 0.0) {
            return (
                VerdictLevel::NotKnown,
                format!("{touches}, all of it at the rim: what yields is not known."),
            );
        }
        match rough.plastic_part {
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
