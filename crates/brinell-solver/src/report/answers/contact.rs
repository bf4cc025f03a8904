//! Rows of the contact: pressure, size, force; heights and rollers.

use super::{Answer, AnswerBody, AnswerPlace, Bar, Facts, Name};
use crate::job::{Analysis, Load, Shape, label_of};
use crate::report::{
    HertzReport, LoadReport, RollerReport, RoughContactReport, ThreeDimensionalReport,
};
use crate::solver::SolveStatus;
use crate::solver::method::figures::Figure;
use crate::units::about;

impl Facts<'_> {
    fn whole(&self) -> Option<&ThreeDimensionalReport> {
        self.step.three_dimensional.as_ref()
    }

    pub fn rough(&self) -> Option<&RoughContactReport> {
        self.whole()?.surface.as_ref()
    }

    fn roller(&self) -> Option<&RollerReport> {
        self.whole()?.roller.as_ref()
    }

    fn on_surface(&self, x: f64, y: Option<f64>) -> Option<AnswerPlace> {
        Some(AnswerPlace { body: AnswerBody::Both, x, y, depth: 0.0 })
    }

    pub(super) fn of_heights(&self) -> Vec<Answer> {
        let Some(rough) = self.rough() else { return Vec::new() };
        let bar = self.bars().and_then(|bars| bars.force);
        let of_force = self.bar(&[(Figure::Force, 0)], bar);
        let is_given = self.given_force().is_some();
        let mut rows = vec![
            self.row(Name::ContactRatio, rough.contact_ratio)
                .text("cells in contact over the area of all heights"),
            self.row(Name::NominalPressure, rough.nominal_pressure)
                .bar(if is_given { Bar::Exact } else { of_force })
                .text("force over the area of all heights"),
        ];
        rows.extend(rough.plastic_part.map(|part| {
            self.row(Name::YieldedPart, part)
                .text("of the area in contact, below which a body has yielded")
        }));
        rows
    }

    pub(super) fn of_roller(&self) -> Vec<Answer> {
        let whole = self.whole().filter(|_| self.touches());
        let Some((whole, roller)) = whole.zip(self.roller()) else { return Vec::new() };
        let [low, high] = roller.end_pressure;
        let edge = low.max(high);
        let text = if edge <= 0.0 {
            "the contact ends before the roller".to_owned()
        } else if roller.middle_pressure > 0.0 {
            format!("{} times the pressure in the middle", about(edge / roller.middle_pressure))
        } else {
            "the middle of the roller does not touch".to_owned()
        };
        let end = if high >= low { roller.y.last() } else { roller.y.first() };
        let place = end.filter(|_| edge > 0.0).and_then(|y| self.on_surface(0.0, Some(*y)));
        let mut rows = vec![self.row(Name::EdgePressure, edge).place(place).text(text)];
        let is_even = roller.moment.abs() <= 1e-6 * self.step.contact.force * whole.b;
        let moment = self
            .row(Name::Moment, roller.moment)
            .text("of the pressure about the middle, positive towards y");
        let tilt = self
            .row(Name::Tilt, roller.tilt)
            .text("positive where the surfaces are closer at positive y");
        let (moment, tilt) = if self.is_moment_given() {
            (moment.bar(Bar::Given), tilt)
        } else {
            (moment, tilt.bar(Bar::Given))
        };
        let both = [moment, tilt];
        rows.extend(if is_even { both.map(Answer::detail) } else { both });
        rows
    }

    /// Returns whether the job gives the moment of a roller; it gives the tilt otherwise.
    fn is_moment_given(&self) -> bool {
        let bodies = [&self.job.upper, &self.job.lower];
        bodies.iter().any(|body| match &body.shape {
            Shape::Roller(roller) => roller.moment.is_some(),
            _ => false,
        })
    }

    /// Returns the force that the job gives.
    pub fn given_force(&self) -> Option<f64> {
        let is_sought = matches!(self.job.load, Load::Target(_) | Load::Onset);
        match self.step.load {
            LoadReport::Force(force) if !is_sought => Some(force),
            _ => None,
        }
    }

    /// Returns the force. One that is given is known, whatever the mesh tells.
    pub(super) fn force(&self) -> Answer {
        let given = self.given_force().filter(|_| self.step.status == SolveStatus::Converged);
        let bar = self.bars().and_then(|bars| bars.force);
        let force = given.unwrap_or(self.step.contact.force);
        let row = self.meshed(Name::Force, force, (Figure::Force, 0), bar);
        let row = if given.is_some() { row.bar(Bar::Given) } else { row };
        match &self.job.load {
            Load::Target(target) if self.touches() => {
                let figure = self.write.target_text(target.figure, target.value.get());
                row.text(format!("for a {} of {figure}", label_of(target.figure)))
            }
            _ => row,
        }
    }

    pub fn of_contact(&self) -> Vec<Answer> {
        let mut rows = vec![self.peak()];
        rows.extend(self.middle_pressure());
        rows.extend(self.sizes());
        if !self.is_unloaded() && self.step.rolling.is_none() {
            rows.push(self.approach());
        }
        if !self.is_sought() {
            rows.push(self.force());
        }
        rows.push(self.mean_pressure());
        rows
    }

    /// Returns a note on elastic figures beside those of a dent.
    const fn of_dent(&self) -> &'static str {
        if self.measured.is_dented { "elastic bodies without a dent" } else { "" }
    }

    fn peak(&self) -> Answer {
        let step = self.step;
        let (contact, whole) = (&step.contact, self.whole());
        let unknown = |why: &str| self.row(Name::PeakPressure, None).not_known(why);
        let bar = self.bars().and_then(|bars| bars.peak_pressure);
        let meshed =
            |value: f64| self.meshed(Name::PeakPressure, value, (Figure::PeakPressure, 0), bar);
        match self.measured.inside_rim {
            _ if self.measured.bearable.is_some() => unknown("above what the flow stress carries"),
            Some((pressure, _)) if pressure <= 0.0 => unknown("only cells of the rim touch"),
            Some((pressure, _)) if self.write.stress(pressure) < contact.mean_pressure => {
                unknown("cells of the rim bear the most")
            }
            Some((pressure, [x, y])) => meshed(self.write.stress(pressure))
                .bar(Bar::none("remark `surface_end`"))
                .place(self.on_surface(self.write.length(x), Some(self.write.length(y))))
                .text("largest pressure of a cell, without the cells of the rim"),
            None => {
                meshed(contact.peak_pressure)
                    .elastic(self.hertz().map(|hertz| hertz.peak_pressure))
                    .place(self.on_surface(
                        contact.peak_position,
                        whole.map(|whole| whole.peak_position_y),
                    ))
                    .at_least(self.least_peak(), self.of_dent())
            }
        }
    }

    /// Returns Hertz's contact, where it is beside this one.
    fn hertz(&self) -> Option<&HertzReport> {
        self.step.hertz.as_ref().filter(|_| self.touches() && !self.is_rough())
    }

    /// Returns the half-width, or both semi-axes.
    fn sizes(&self) -> Vec<Answer> {
        let (contact, bars, whole) = (&self.step.contact, self.bars(), self.whole());
        let bar = bars.and_then(|bars| bars.half_width);
        let elastic = self.hertz().map(|hertz| hertz.half_width);
        let half_width = |name: Name| {
            let row = self.meshed(name, contact.half_width, (Figure::HalfWidth, 0), bar);
            row.elastic(elastic).text(self.of_dent())
        };
        if let Some(whole) = whole {
            let errors = whole.estimated_error.as_ref().filter(|_| bars.is_some());
            let bar = errors.and_then(|errors| errors.b);
            let hertz = whole.hertz.filter(|_| self.touches());
            let longer = self.meshed(Name::SemiAxisB, whole.b, (Figure::SemiAxisY, 0), bar);
            let longer = longer.elastic(hertz.map(|hertz| hertz.b)).text(self.of_dent());
            let both = [half_width(Name::SemiAxisA), longer];
            return if self.is_rough() { both.map(Answer::detail) } else { both }.to_vec();
        }
        let row = half_width(Name::HalfWidth);
        if self.job.analysis == Analysis::Axisymmetric {
            return vec![row.labelled("Contact radius").of_width(self.touches())];
        }
        let Some(angle) = contact.half_angle else {
            return vec![row.of_width(self.touches())];
        };
        let row = row.text(format!("along the arc, {}° to each side", about(angle)));
        let angle = self.meshed(Name::HalfAngle, angle, (Figure::HalfWidth, 0), bar);
        vec![row.of_width(self.touches()), angle.detail()]
    }

    fn mean_pressure(&self) -> Answer {
        let (contact, hertz) = (&self.step.contact, self.hertz());
        // A roller that touches from end to end has Hertz's line contact.
        let over_peak = if self.roller().is_some() {
            None
        } else if self.is_whole() {
            Some(2.0 / 3.0)
        } else {
            Some(std::f64::consts::FRAC_PI_4)
        };
        let parts = contact.patches.len() > 1 && self.whole().is_none();
        let row = self.row(Name::MeanPressure, contact.mean_pressure);
        let row = if parts { row.labelled("Mean pressure, gaps included") } else { row };
        let of = [(Figure::HalfWidth, 0), (Figure::ContactArea, 0), (Figure::Force, 0)];
        row.bar(self.bar(&of, self.mean_pressure_bar()))
            .elastic(hertz.zip(over_peak).map(|(hertz, part)| part * hertz.peak_pressure))
            .text(if self.is_rough() { "over the cells in contact" } else { self.of_dent() })
            .of_width(self.touches())
    }

    /// Returns the pressure in the middle, before the details where it has a bar and the peak has
    /// none.
    fn middle_pressure(&self) -> Option<Answer> {
        let pressure = self.step.contact.middle_pressure?;
        let (bars, figure) = (self.bars(), Figure::MiddlePressure);
        let bar = bars.and_then(|bars| bars.middle_pressure);
        let row = self.meshed(Name::MiddlePressure, pressure, (figure, 0), bar);
        let is_peak_known = bars.is_none_or(|bars| bars.peak_pressure.is_some());
        let is_behind = is_peak_known || bar.is_none() || pressure <= 0.0;
        Some(if is_behind { row.detail() } else { row })
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
        let of_area = match self.whole() {
            Some(whole) => whole.estimated_error.as_ref()?.area,
            None if self.is_whole() => 2.0 * bars.half_width?,
            None => bars.half_width?,
        };
        Some(of_area + bars.force?)
    }

    /// Returns area, orientation and the largest cell of a contact in three dimensions.
    pub(super) fn of_place(&self) -> Vec<Answer> {
        let Some(whole) = self.whole() else { return Vec::new() };
        let area = whole.estimated_error.as_ref().filter(|_| self.bars().is_some());
        let area = area.map(|errors| errors.area);
        let area = self.meshed(Name::ContactArea, whole.area, (Figure::ContactArea, 0), area);
        let rows = [
            area,
            self.row(Name::LargestCellPressure, whole.largest_cell_pressure),
            self.row(Name::Orientation, whole.orientation)
                .text("from the x of the job to this x, towards the y of the job"),
        ];
        rows.map(Answer::detail).to_vec()
    }
}
