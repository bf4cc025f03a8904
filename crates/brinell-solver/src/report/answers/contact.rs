//! Answers on the contact: pressure, size, force; heights and rollers.

use super::{Answer, AnswerBody, AnswerPlace, Facts};
use crate::job::{Analysis, Load, Quantity};
use crate::report::LoadReport;
use crate::solver::SolveStatus;
use crate::solver::method::figures::Figure;
use crate::units::about;

impl Facts<'_> {
    pub(super) fn of_heights(&self) -> Vec<Answer> {
        let whole = self.step.three_dimensional.as_ref();
        let Some(rough) = whole.and_then(|whole| whole.surface.as_ref()) else {
            return Vec::new();
        };
        let mut answers = vec![
            self.answer(
                "contact_ratio",
                "Real contact area",
                Quantity::Ratio,
                rough.contact_ratio,
            )
            .text("cells in contact over the area of all heights"),
            self.answer(
                "nominal_pressure",
                "Nominal pressure",
                Quantity::Stress,
                rough.nominal_pressure,
            )
            .text("force over the area of all heights"),
        ];
        answers.extend(rough.plastic_part.map(|part| {
            self.answer("yielded_part", "Area that yields", Quantity::Ratio, part)
                .text("of the area in contact, below which a body has yielded")
        }));
        answers
    }

    pub(super) fn of_roller(&self) -> Vec<Answer> {
        let whole = self.step.three_dimensional.as_ref();
        let roller = whole.and_then(|whole| Some((whole, whole.roller.as_ref()?)));
        let Some((whole, roller)) = roller.filter(|_| self.touches()) else {
            return Vec::new();
        };
        let [low, high] = roller.end_pressure;
        let edge = low.max(high);
        let text = if edge <= 0.0 {
            "the contact ends before the roller".to_owned()
        } else if roller.middle_pressure > 0.0 {
            format!("{} times the pressure in the middle", about(edge / roller.middle_pressure))
        } else {
            "the middle of the roller does not touch".to_owned()
        };
        let mut answers =
            vec![self.answer("edge_pressure", "Edge pressure", Quantity::Stress, edge).text(text)];
        if roller.moment.abs() > 1e-6 * self.step.contact.force * whole.b {
            answers.push(
                self.answer("moment", "Moment", Quantity::Energy, roller.moment)
                    .text("of the pressure about the middle, positive towards y"),
            );
            answers.push(
                self.answer("tilt", "Tilt", Quantity::Angle, roller.tilt)
                    .text("positive where the surfaces are closer at positive y"),
            );
        }
        answers
    }

    pub fn of_contact(&self) -> Vec<Answer> {
        let (step, bars) = (self.step, self.bars());
        let contact = &step.contact;
        let hertz = step.hertz.as_ref().filter(|_| self.touches() && !self.is_rough());
        let whole = step.three_dimensional.as_ref();
        let beside = if self.measured.is_dented { "elastic bodies without a dent" } else { "" };
        let of_surface = |x: f64, y: Option<f64>| {
            Some(AnswerPlace { body: AnswerBody::Both, x, y, depth: 0.0 })
        };
        let mut answers = Vec::new();
        let peak = |value: f64| self.figure(Figure::PeakPressure, value);
        let middle = self.middle_pressure();
        let unknown = || self.answer("peak_pressure", "Peak pressure", Quantity::Stress, None);
        answers.push(match self.measured.inside_rim {
            _ if self.measured.bearable.is_some() => {
                unknown().text("not known: above what the flow stress carries")
            }
            Some((pressure, _)) if pressure <= 0.0 => {
                unknown().text("not known: only cells of the rim touch")
            }
            Some((pressure, _)) if self.write.stress(pressure) < contact.mean_pressure => {
                unknown().text("not known: cells of the rim bear the most")
            }
            Some((pressure, [x, y])) => peak(self.write.stress(pressure))
                .place(of_surface(self.write.length(x), Some(self.write.length(y))))
                .text("largest pressure of a cell, without the cells of the rim"),
            None => peak(contact.peak_pressure)
                .error(bars.and_then(|bars| bars.peak_pressure))
                .elastic(hertz.map(|hertz| hertz.peak_pressure))
                .place(of_surface(contact.peak_position, whole.map(|whole| whole.peak_position_y)))
                .at_least(self.least_peak(), beside),
        });
        answers.extend(middle);
        let half_width = self
            .figure(Figure::HalfWidth, contact.half_width)
            .error(bars.and_then(|bars| bars.half_width))
            .elastic(hertz.map(|hertz| hertz.half_width))
            .text(beside);
        match whole {
            Some(_) if self.is_rough() => {}
            Some(whole) => {
                answers.push(half_width.named("semi_axis_a", "Shorter semi-axis"));
                answers.push(
                    self.figure(Figure::SemiAxisY, whole.b)
                        .named("semi_axis_b", "Longer semi-axis")
                        .error(
                            whole
                                .estimated_error
                                .as_ref()
                                .filter(|_| bars.is_some())
                                .and_then(|errors| errors.b),
                        )
                        .elastic(whole.hertz.filter(|_| self.touches()).map(|hertz| hertz.b))
                        .text(beside),
                );
            }
            None if self.job.analysis == Analysis::Axisymmetric => {
                answers.push(half_width.labelled("Contact radius").of_width(self.touches()));
            }
            None => {
                let text = contact.half_angle.map_or_else(
                    || beside.to_owned(),
                    |angle| format!("along the arc, {}° to each side", about(angle)),
                );
                answers.push(half_width.text(text).of_width(self.touches()));
            }
        }
        answers.push(self.approach());
        let force = self.figure(Figure::Force, contact.force);
        // A force that is asked for is known, whatever the mesh tells.
        let is_asked = step.status == SolveStatus::Converged
            && matches!(step.load, LoadReport::Force(_))
            && !matches!(self.job.load, Load::Target(_) | Load::Onset);
        let bar = if is_asked { Some(0.0) } else { bars.and_then(|bars| bars.force) };
        answers.push(force.error(bar));
        // A roller that touches from end to end has Hertz's line contact.
        let is_roller = whole.is_some_and(|whole| whole.roller.is_some());
        let over_peak = if is_roller {
            None
        } else if self.is_whole() {
            Some(2.0 / 3.0)
        } else {
            Some(std::f64::consts::FRAC_PI_4)
        };
        answers.push(
            self.answer("mean_pressure", "Mean pressure", Quantity::Stress, contact.mean_pressure)
                .error(self.mean_pressure_bar())
                .elastic(hertz.zip(over_peak).map(|(hertz, part)| part * hertz.peak_pressure))
                .labelled(if whole.is_none() && contact.patches.len() > 1 {
                    "Mean pressure, gaps included"
                } else {
                    "Mean pressure"
                })
                .text(if self.is_rough() { "over the cells in contact" } else { beside })
                .of_width(self.touches()),
        );
        answers
    }

    /// Returns the pressure in the middle where it has a bar and the peak has none.
    fn middle_pressure(&self) -> Option<Answer> {
        let bars = self.bars().filter(|bars| bars.peak_pressure.is_none())?;
        let pressure = self.step.contact.middle_pressure.filter(|pressure| *pressure > 0.0)?;
        let bar = bars.middle_pressure?;
        Some(self.figure(Figure::MiddlePressure, pressure).error(Some(bar)))
    }

    /// Returns what a peak without a bar is at least: the larger of the pressures in the middle and
    /// in the mean, less their bars.
    fn least_peak(&self) -> Option<f64> {
        let bars = self.bars().filter(|bars| bars.peak_pressure.is_none())?;
        let contact = &self.step.contact;
        let less =
            |pressure: f64, bar: Option<f64>| pressure * (1.0 - bar.unwrap_or(1.0)).max(0.0);
        let least = less(contact.middle_pressure.unwrap_or_default(), bars.middle_pressure)
            .max(less(contact.mean_pressure, self.mean_pressure_bar()));
        (least > 0.0).then_some(least)
    }

    /// Returns the bar of the mean pressure: under a given force that of the contact area.
    fn mean_pressure_bar(&self) -> Option<f64> {
        let bars = self.bars().filter(|_| !self.is_rough())?;
        let of_area = match &self.step.three_dimensional {
            Some(whole) => whole.estimated_error.as_ref()?.area,
            None if self.is_whole() => 2.0 * bars.half_width?,
            None => bars.half_width?,
        };
        Some(of_area + bars.force?)
    }
}
