//! Rows of the contact: pressure, size, force; heights and rollers.

use super::{Answer, AnswerBody, AnswerPlace, Bar, Facts, Name, ROUNDING};
use crate::contact::ContactLoad;
use crate::job::{Analysis, Load, Shape};
use crate::report::known::{Hertz, RollerFigures, Rough, Whole};
use crate::solver::SolveStatus;
use crate::solver::method::figures::Figure;
use crate::units::about;

impl Facts<'_> {
    fn whole(&self) -> Option<&Whole> {
        self.known.whole.as_ref()
    }

    pub fn rough(&self) -> Option<Rough> {
        self.whole()?.rough
    }

    fn roller(&self) -> Option<RollerFigures> {
        self.whole()?.roller
    }

    fn on_surface(&self, [x, y]: [f64; 2]) -> AnswerPlace {
        self.place(AnswerBody::Both, [x, y, 0.0])
    }

    pub(super) fn of_heights(&self) -> Vec<Answer> {
        let Some(rough) = self.rough() else { return Vec::new() };
        let of_force = self.bar(&[(Figure::Force, 0)], self.bar_of(Figure::Force, 0));
        let is_given = self.given_force().is_some();
        let mut rows = vec![
            self.row(Name::ContactRatio, rough.contact_ratio)
                .text("cells in contact over the area of all heights"),
            self.row(Name::NominalPressure, rough.nominal_pressure)
                .bar(if is_given { Bar::Exact } else { of_force })
                .text("force over the area of all heights"),
        ];
        rows.extend(rough.yielded_part.map(|part| {
            self.row(Name::YieldedPart, part)
                .text("of the area in contact, below which a body has yielded")
        }));
        rows
    }

    pub(super) fn of_roller(&self) -> Vec<Answer> {
        let Some((whole, roller)) = self.whole().zip(self.roller()) else { return Vec::new() };
        let [low, high] = roller.end_pressure;
        let edge = low.max(high);
        let text = if !self.touches() {
            String::new()
        } else if edge <= 0.0 {
            "the contact ends before the roller".to_owned()
        } else if roller.middle_pressure > 0.0 {
            format!("{} times the pressure in the middle", about(edge / roller.middle_pressure))
        } else {
            "the middle of the roller does not touch".to_owned()
        };
        let end = roller.ends[usize::from(high >= low)];
        let place = Some(self.on_surface([0.0, end]));
        let mut rows = vec![self.row(Name::EdgePressure, edge).place(place).text(text)];
        let [_, longer] = whole.semi_axes;
        let part = roller.moment.abs() / (self.known.figures.force * longer);
        let is_even = part.is_nan() || part <= 1e-6;
        let moment = if part > ROUNDING { roller.moment } else { 0.0 };
        // Without one of them a symmetric roller has none of the other.
        let row = |name: Name, core: f64| {
            let row = self.told(name, core);
            if core == 0.0 { row.bar(Bar::Exact) } else { row }
        };
        let (moment, tilt) = (row(Name::Moment, moment), row(Name::Tilt, roller.tilt));
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
        let bodies = self.job.bodies();
        bodies.iter().any(|body| match &body.shape {
            Shape::Roller(roller) => roller.moment.is_some(),
            _ => false,
        })
    }

    /// Returns the force that the job gives.
    pub fn given_force(&self) -> Option<f64> {
        let is_sought = matches!(self.job.load, Load::Target(_) | Load::Onset);
        match self.known.load {
            ContactLoad::Force(force) if !is_sought => Some(force),
            _ => None,
        }
    }

    /// Returns the force. One that is given is known, whatever the mesh tells.
    fn force(&self) -> Answer {
        let given = self.given_force().filter(|_| self.known.status == SolveStatus::Converged);
        let force = given.unwrap_or(self.known.figures.force);
        let row = self.meshed(Name::Force, force, (Figure::Force, 0));
        match self.job.load {
            Load::Target(_) => row.bar(Bar::none("`force_found` has its error")).detail(),
            _ if given.is_some() => row.bar(Bar::Given),
            _ => row,
        }
    }

    pub fn of_contact(&self) -> Vec<Answer> {
        let mut rows = vec![self.peak()];
        rows.extend(self.middle_pressure());
        rows.extend(self.sizes());
        if !self.is_unloaded() && self.known.rolled.is_none() {
            rows.push(self.approach());
        }
        // That of first yield stands before the others.
        rows.extend(self.known.onset.is_none().then(|| self.force()));
        rows.push(self.mean_pressure());
        rows
    }

    /// Returns a note on elastic figures beside those of a dent.
    fn of_dent(&self) -> &'static str {
        let has_elastic = self.measured.is_dented && self.hertz().is_some();
        if has_elastic { "elastic bodies without a dent" } else { "" }
    }

    fn peak(&self) -> Answer {
        let known = self.known;
        let unknown = |why: &str| self.row(Name::PeakPressure, None).not_known(why);
        let meshed = |core: f64| self.meshed(Name::PeakPressure, core, (Figure::PeakPressure, 0));
        match self.measured.inside_rim {
            _ if self.measured.bearable.is_some() => unknown("above what the flow stress carries"),
            Some((pressure, _)) if pressure <= 0.0 => unknown("only cells of the rim touch"),
            Some((pressure, _)) if pressure < known.mean_pressure => {
                unknown("cells of the rim bear the most")
            }
            Some((pressure, place)) => meshed(pressure)
                .bar(Bar::none("remark `surface_end`"))
                .place(Some(self.on_surface(place)))
                .text("largest pressure of a cell, without the cells of the rim"),
            None => {
                let elastic = self.hertz().map(|hertz| self.write.stress(hertz.peak_pressure));
                let least = self.least_peak().map(|least| self.write.stress(least));
                let row = meshed(known.figures.peak_pressure).elastic(elastic);
                let row = row.place(Some(self.on_surface(known.peak_place)));
                Answer { at_least: least, ..row.text(self.of_dent()) }
            }
        }
    }

    /// Returns Hertz's contact, where it is beside this one.
    fn hertz(&self) -> Option<Hertz> {
        self.known.hertz.filter(|_| self.touches() && !self.is_rough())
    }

    /// Returns the half-width, or both semi-axes.
    fn sizes(&self) -> Vec<Answer> {
        let length = |core: f64| self.write.length(core);
        let size = |name: Name, core: f64, figure: Figure, elastic: Option<f64>| {
            let row = self.meshed(name, core, (figure, 0));
            row.elastic(elastic.map(length)).text(self.of_dent())
        };
        let shorter = self.hertz().map(|hertz| hertz.half_width);
        if let Some(whole) = self.whole() {
            let longer = self.hertz().and_then(|hertz| hertz.longer);
            let [a, b] = whole.semi_axes;
            let both = [
                size(Name::SemiAxisA, a, Figure::HalfWidth, shorter),
                size(Name::SemiAxisB, b, Figure::SemiAxisY, longer),
            ];
            return if self.is_rough() { both.map(Answer::detail) } else { both }.to_vec();
        }
        let half_width = self.known.figures.half_width;
        let row = size(Name::HalfWidth, half_width, Figure::HalfWidth, shorter);
        if self.job.analysis == Analysis::Axisymmetric {
            return vec![row.labelled("Contact radius").of_width(self.touches())];
        }
        let Some(angle) = self.known.half_angle else {
            return vec![row.of_width(self.touches())];
        };
        let row = row.text(format!("along the arc, {}° to each side", about(angle)));
        let angle = self.meshed(Name::HalfAngle, angle, (Figure::HalfWidth, 0));
        [row, angle].map(|row| row.of_width(self.touches())).to_vec()
    }

    fn mean_pressure(&self) -> Answer {
        let hertz = self.hertz().map(|hertz| self.write.stress(hertz.peak_pressure));
        // A roller that touches from end to end has Hertz's line contact.
        let over_peak = if self.roller().is_some() {
            None
        } else if self.is_whole() {
            Some(2.0 / 3.0)
        } else {
            Some(std::f64::consts::FRAC_PI_4)
        };
        let has_gaps = self.known.parts > 1 && self.whole().is_none();
        let row = self.row(Name::MeanPressure, self.known.mean_pressure);
        let row = if has_gaps { row.labelled("Mean pressure, gaps included") } else { row };
        let of = [(Figure::HalfWidth, 0), (Figure::ContactArea, 0), (Figure::Force, 0)];
        row.bar(self.bar(&of, self.mean_pressure_bar()))
            .elastic(hertz.zip(over_peak).map(|(peak, part)| part * peak))
            .text(if self.is_rough() { "over the cells in contact" } else { self.of_dent() })
            .of_width(self.touches())
    }

    /// Returns the pressure in the middle where that is not the peak or the peak has no bar; before
    /// the details where it alone has a bar.
    fn middle_pressure(&self) -> Option<Answer> {
        let peak =
            self.bar_of(Figure::PeakPressure, 0).and(Some(self.known.figures.peak_pressure));
        let is_other =
            |middle: &f64| peak.is_none_or(|peak| (middle - peak).abs() > ROUNDING * peak);
        let pressure = self.known.figures.middle_pressure.filter(is_other)?;
        let row = self.meshed(Name::MiddlePressure, pressure, (Figure::MiddlePressure, 0));
        let is_ahead = self.bar_of(Figure::MiddlePressure, 0).is_some()
            && self.bar_of(Figure::PeakPressure, 0).is_none()
            && pressure > 0.0;
        Some(if is_ahead { row } else { row.detail() })
    }

    /// Returns what a peak without a bar is at least: the larger of the pressures in the middle and
    /// in the mean, less their bars.
    fn least_peak(&self) -> Option<f64> {
        if self.bars().is_none() || self.bar_of(Figure::PeakPressure, 0).is_some() {
            return None;
        }
        let less =
            |pressure: f64, bar: Option<f64>| pressure * (1.0 - bar.unwrap_or(1.0)).max(0.0);
        let middle = self.known.figures.middle_pressure.unwrap_or_default();
        let least = less(middle, self.bar_of(Figure::MiddlePressure, 0))
            .max(less(self.known.mean_pressure, self.mean_pressure_bar()));
        (least > 0.0).then_some(least)
    }

    /// Returns the bar of the mean pressure: under a given force that of the contact area.
    fn mean_pressure_bar(&self) -> Option<f64> {
        if self.is_rough() {
            return None;
        }
        let of = |figure: Figure| self.bar_of(figure, 0);
        let of_area = match self.whole() {
            Some(_) => of(Figure::ContactArea)?,
            None if self.is_whole() => 2.0 * of(Figure::HalfWidth)?,
            None => of(Figure::HalfWidth)?,
        };
        Some(of_area + of(Figure::Force)?)
    }

    /// Returns area, orientation and the largest cell of a contact in three dimensions.
    pub(super) fn of_place(&self) -> Vec<Answer> {
        let Some(whole) = self.whole() else { return Vec::new() };
        let area = self.meshed(Name::ContactArea, whole.area, (Figure::ContactArea, 0));
        let largest = self.row(Name::LargestCellPressure, whole.largest_cell_pressure);
        let largest = Some(largest).filter(|row| row.value != self.peak().value);
        let orientation = self.told(Name::Orientation, whole.orientation);
        let rows = [Some(area), largest, Some(orientation)];
        rows.into_iter().flatten().map(Answer::detail).collect()
    }
}
