//! Answers: the figures of a load step as rows, in the order in which the job asks for them, and a
//! verdict. Terminal, page, printed report and Python draw them and compute nothing.

mod bodies;
mod contact;
mod fatigue;
mod row;
mod strength;

pub use crate::job::{BarKind, Name, table_of_names};
pub(super) use fatigue::endures;
pub(super) use row::Bar;
pub use row::{Answer, AnswerAt, AnswerBody, AnswerPlace, ErrorBar, ErrorWord};

use super::datum::Datum;
use super::findings::{Finding, Voids};
use super::known::{ErrorEstimate, FlowFigures, Known, Zone};
use crate::contact::ContactLoad;
use crate::job::{Analysis, Body, Job, Load, Quantity, Side, Theory};
use crate::solver::SolveStatus;
use crate::solver::method::figures::{Figure, ROUNDING};
use crate::units::UnitConverter;

/// A largest value of a field, and its place. Lengths in mm, stresses in MPa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Largest {
    pub value: f64,
    /// 0 for the upper body, 1 for the lower body.
    pub side: usize,
    /// `[x, y, depth]`; y only in three dimensions.
    pub place: [f64; 3],
}

/// Figures of a load step that its report does not have, in N–mm–MPa.
#[derive(Debug, Clone, Default)]
pub(super) struct Measured {
    /// Largest elastic von Mises stress over the yield stress, and where.
    pub utilization: Option<Largest>,
    /// Whether that is of the field and not of a closed form.
    pub is_of_field: bool,
    /// The force of first yield.
    pub first_yield: Option<f64>,
    /// Largest von Mises stress over the yield stress below the hardened cases.
    pub core: Option<Largest>,
    /// Largest principal stress that a load has left.
    pub tension: Option<Largest>,
    /// Reciprocal of the sum of the curvatures of both surfaces along the shorter semi-axis.
    pub effective_radius: Option<f64>,
    /// Largest pressure of a cell beside the rim of heights, and its `[x, y]`, where the contact
    /// reaches the rim.
    pub inside_rim: Option<(f64, [f64; 2])>,
    /// The largest pressure that the flow stress carries, where the peak of heights is above it.
    pub bearable: Option<f64>,
    /// Between what the approach is measured.
    pub datum: Datum,
    /// Over which points the fields were searched.
    pub points: &'static str,
    /// Whether an earlier load of the history, at least as large, has dented the bodies.
    pub is_dented: bool,
}

/// Returns whether an earlier load has dented the bodies at least as much as this force.
/// `dented_under` is the largest force that has left plastic strain, 0 without one. Forces that
/// differ by rounding are alike.
pub(super) fn is_dented(dented_under: f64, force: f64) -> bool {
    dented_under > 0.0 && dented_under >= (1.0 - ROUNDING) * force
}

/// What the answers and the verdict of a load step are made of.
pub(super) struct Facts<'a> {
    pub job: &'a Job,
    pub known: &'a Known,
    pub measured: &'a Measured,
    pub findings: &'a [Finding],
    pub write: UnitConverter,
}

impl Facts<'_> {
    /// Returns the rows, those with details last.
    pub fn rows(&self) -> Vec<Answer> {
        let rows = self.answers().into_iter().map(|row| self.settled(row));
        let (details, mut rows): (Vec<_>, Vec<_>) = rows.partition(|row| row.detail);
        rows.extend(details);
        rows
    }

    pub fn is_three_dimensional(&self) -> bool {
        self.job.analysis == Analysis::ThreeDimensional
    }

    /// Returns whether a force is that of the whole contact and not of a unit of thickness.
    pub fn is_whole(&self) -> bool {
        self.is_three_dimensional() || self.job.analysis == Analysis::Axisymmetric
    }

    pub fn is_rough(&self) -> bool {
        self.rough().is_some()
    }

    /// Returns whether every second pass goes back.
    pub fn is_alternating(&self) -> bool {
        matches!(self.job.load, Load::Rolling(rolling) if rolling.alternating)
    }

    pub fn touches(&self) -> bool {
        self.known.figures.force > 0.0
    }

    /// Returns whether the load of a history is taken away.
    pub fn is_unloaded(&self) -> bool {
        !self.touches() && self.job.solver.theory == Theory::Flow
    }

    pub fn has_yielded(&self) -> bool {
        self.strained_zones().next().is_some()
    }

    /// Returns whether a body with a yield point has yielded.
    pub fn yields_by_limit(&self) -> bool {
        self.zones().any(|(side, zone)| zone.yielded && self.yield_point(side) != Some(0.0))
    }

    /// Returns whether a body has a law without a yield point.
    pub fn flows_from_the_first(&self) -> bool {
        Side::BOTH.into_iter().any(|side| self.yield_point(side) == Some(0.0))
    }

    /// Returns the stress from which a body has plastic strain, 0 without a yield point.
    fn yield_point(&self, side: Side) -> Option<f64> {
        let material = self.job.bodies()[side.member()].deformable()?;
        Some(material.hardening_law()?.yield_stress())
    }

    /// Returns the zones that have yielded; under a law without a yield point those with plastic
    /// strain.
    fn strained_zones(&self) -> impl Iterator<Item = (Side, &Zone)> {
        self.zones().filter(|(side, zone)| {
            zone.yielded || zone.largest > Some(0.0) && self.yield_point(*side) == Some(0.0)
        })
    }

    /// Returns whether a body can yield.
    pub fn can_yield(&self) -> bool {
        let bodies = self.job.bodies().into_iter();
        bodies.filter_map(Body::deformable).any(|material| material.plasticity.is_some())
    }

    fn zones(&self) -> impl Iterator<Item = (Side, &Zone)> {
        let zones = Side::BOTH.into_iter().zip(&self.known.zones);
        zones.filter_map(|(side, zone)| Some((side, zone.as_ref()?)))
    }

    /// Returns the body with the largest plastic strain, or with the largest mean of strains
    /// without limit.
    fn most_strained(&self) -> Option<AnswerBody> {
        let strain = |zone: &Zone| zone.largest.unwrap_or(zone.mean);
        let zones = self.strained_zones();
        let (side, _) = zones.max_by(|a, b| strain(a.1).total_cmp(&strain(b.1)))?;
        Some(self.body(side))
    }

    pub fn body(&self, side: Side) -> AnswerBody {
        if self.known.is_alike { AnswerBody::Both } else { side.into() }
    }

    /// Returns a place `[x, y, depth]` in the units of the job; y only in three dimensions.
    pub fn place(&self, body: AnswerBody, place: [f64; 3]) -> AnswerPlace {
        let [x, y, depth] = place.map(|length| self.write.length(length));
        // Points of straight elements stand above a concave surface.
        let depth = depth.max(0.0);
        AnswerPlace { body, x, y: self.is_three_dimensional().then_some(y), depth }
    }

    pub fn place_of(&self, largest: &Largest) -> AnswerPlace {
        self.place(self.body(Side::of(largest.side)), largest.place)
    }

    /// Returns the row of a figure in N–mm–MPa.
    pub fn row(&self, name: Name, core: impl Into<Option<f64>>) -> Answer {
        let quantity = self.quantity(name);
        let value = core.into().map(|core| self.write.of(quantity, core));
        let row = Answer::new(name, quantity, self.unit(quantity), value);
        match name.bar() {
            BarKind::Mesh | BarKind::MeshOrExact => row.bar(Bar::none(self.why(&[]))),
            BarKind::Exact | BarKind::None => row,
        }
    }

    /// Returns the row of a figure with what it is.
    pub fn told(&self, name: Name, core: impl Into<Option<f64>>) -> Answer {
        self.row(name, core).text(name.meaning())
    }

    /// Returns the row of a figure with the bar of two meshes, of a body that of one side.
    pub fn meshed(
        &self,
        name: Name,
        core: impl Into<Option<f64>>,
        (figure, side): (Figure, usize),
    ) -> Answer {
        let bar = self.bar_of(figure, side);
        self.row(name, core).bar(self.bar(&[(figure, side)], bar))
    }

    /// Returns the bar of a figure, of a body that of one side.
    pub fn bar_of(&self, figure: Figure, side: usize) -> Option<f64> {
        self.bars()?.of_figure(figure, side)
    }

    /// Returns a bar, or why one of the figures on which it depends has none.
    pub fn bar(&self, of: &[(Figure, usize)], bar: Option<f64>) -> Bar {
        bar.map_or_else(|| Bar::none(self.why(of)), Bar::Relative)
    }

    /// Returns why figures have no bar.
    fn why(&self, of: &[(Figure, usize)]) -> String {
        if self.known.status != SolveStatus::Converged {
            return "the load has not converged".to_owned();
        }
        let takes = |finding: &&Finding| match finding.voids() {
            Voids::Estimate => true,
            Voids::Figures(set) => of.iter().any(|(figure, side)| set.has(*figure, *side)),
        };
        match self.findings.iter().find(takes) {
            Some(finding) => format!("remark `{}`", finding.code()),
            None if self.bars().is_none() => "no coarser mesh to compare with".to_owned(),
            None => "two meshes do not bound it".to_owned(),
        }
    }

    /// Returns the quantity of a row: forces, slopes and energies of a plane are those of unit
    /// thickness.
    fn quantity(&self, name: Name) -> Quantity {
        match name.quantity() {
            Quantity::Force if !self.is_whole() => Quantity::LineForce,
            Quantity::Stiffness if !self.is_whole() => Quantity::LineStiffness,
            Quantity::Energy if !self.is_whole() => Quantity::LineEnergy,
            quantity => quantity,
        }
    }

    pub fn unit(&self, quantity: Quantity) -> &'static str {
        self.job.units.symbol(quantity)
    }

    /// Returns a value of the report with its unit, to `digits` of
    /// [`rounded`](crate::units::rounded) or [`about`](crate::units::about).
    pub fn with_unit(&self, digits: fn(f64) -> String, quantity: Quantity, value: f64) -> String {
        format!("{} {}", digits(value), self.unit(quantity))
    }

    /// Returns a row as it is answered: without a value where the step has no answer, without a
    /// relative error of zero, and with the bound of its size in place of an error as large as
    /// itself. Bodies that do not touch have exactly no contact.
    fn settled(&self, row: Answer) -> Answer {
        let is_known = matches!(row.error, ErrorBar::Word(ErrorWord::Given | ErrorWord::Exact));
        if self.known.status != SolveStatus::Converged && !is_known {
            return row.not_known("the load has not converged");
        }
        match (row.value, row.error) {
            (Some(0.0), _) => {
                let is_exact = row.body.is_none() && !self.touches();
                let row = row.place(None);
                match (is_known, is_exact) {
                    (true, _) => row,
                    (false, true) => row.bar(Bar::Exact),
                    (false, false) => row.bar(Bar::none("a figure of zero has no relative error")),
                }
            }
            (Some(value), ErrorBar::Relative(error)) if error >= 1.0 => {
                let at_most = Some(value.abs() * (1.0 + error));
                Answer { at_most, ..row.bar(Bar::none("the error is as large as the figure")) }
            }
            _ => row,
        }
    }

    /// Returns the error estimate of a step that has converged.
    fn bars(&self) -> Option<&ErrorEstimate> {
        let bars = self.known.bars.as_ref();
        bars.filter(|_| self.known.status == SolveStatus::Converged)
    }

    /// Returns the rows in their order, but for details, which may be anywhere.
    fn answers(&self) -> Vec<Answer> {
        if self.known.status.is_stopped() {
            return Vec::new();
        }
        if let Some(rolled) = &self.known.rolled {
            return self.of_track(rolled);
        }
        let mut rows: Vec<Answer> = self.first_yield_force().into_iter().collect();
        rows.extend(self.first_yield_peak());
        let is_graded = self.known.is_graded;
        if self.is_unloaded() {
            rows.extend(self.surfaces(Name::DentDepth));
            rows.push(self.approach());
            rows.extend(self.tension());
            rows.extend(self.core());
            rows.extend(self.strains());
            rows.extend(self.plastic_depths());
            rows.extend(self.work());
            let behind = [self.of_contact(), self.of_heights(), self.of_roller()];
            rows.extend(behind.into_iter().flatten().map(Answer::detail));
        } else {
            rows.extend(self.of_heights());
            rows.extend(self.of_roller());
            if is_graded {
                rows.extend(self.strength());
            }
            rows.extend(self.of_contact());
            rows.extend(self.strains());
            if !is_graded {
                rows.extend(self.strength());
            }
            rows.extend(self.plastic_depths());
            rows.extend(self.of_shapes());
            rows.extend(self.stiffness());
            rows.extend(self.surfaces(Name::SurfaceDepth));
            rows.extend(self.work());
        }
        rows.extend(self.fatigue());
        rows.extend(self.of_bodies());
        rows.extend(self.of_place());
        rows
    }

    /// Returns the force of first yield: the one that was sought, or the closed form.
    fn first_yield_force(&self) -> Option<Answer> {
        let closed = self.known.hertz.and_then(|hertz| hertz.first_yield);
        if let Some(onset) = &self.known.onset {
            let body = self.body(Side::of(onset.side));
            let place = self.place(body, [onset.position, 0.0, onset.depth]);
            let first = self.meshed(Name::Force, onset.force, (Figure::Force, 0));
            let elastic = closed.map(|[force, _]| self.write.force(force));
            let label = Name::FirstYieldForce.label();
            return Some(first.labelled(label).elastic(elastic).place(Some(place)));
        }
        // A closed form that is not of these bodies is no figure of theirs.
        let is_of_bodies = self.touches() && self.job.load != Load::Onset;
        let (force, [_, depth]) = self.first_yield().filter(|_| is_of_bodies).zip(closed)?;
        let used = self.measured.utilization.as_ref();
        let body = used.map_or(AnswerBody::Both, |used| self.body(Side::of(used.side)));
        let row = self.row(Name::FirstYieldForce, force);
        Some(row.place(Some(self.place(body, [0.0, 0.0, depth]))).detail())
    }

    /// Returns the peak of the closed form by which an onset of yield was sought.
    fn first_yield_peak(&self) -> Option<Answer> {
        let peak = self.known.onset.as_ref()?.closed_peak?;
        Some(self.row(Name::FirstYieldPeakPressure, peak).detail())
    }

    /// Returns the approach; without force, and unless it is given, the permanent one.
    pub fn approach(&self) -> Answer {
        let hertz = self.known.hertz.filter(|_| self.touches());
        let hertz = hertz.and_then(|hertz| hertz.approach);
        let given = match self.known.load {
            ContactLoad::Approach(approach) => Some(approach),
            ContactLoad::Force(_) => None,
        };
        // Apart, a given approach tells nothing of what is left.
        let is_left = self.is_unloaded() && given.is_none();
        let name = if is_left { Name::PermanentApproach } else { Name::Approach };
        let approach = given.unwrap_or(self.known.figures.approach);
        let row = self.meshed(name, approach, (Figure::Approach, 0));
        let row = if given.is_some() { row.bar(Bar::Given) } else { row };
        row.elastic(hertz.map(|approach| self.write.length(approach)))
            .text(format!("between {}", self.measured.datum.between()))
    }

    fn tension(&self) -> Option<Answer> {
        let largest = self.measured.tension.as_ref().filter(|most| most.value > 0.0)?;
        let place = self.place_of(largest);
        let row = self.row(Name::ResidualTension, largest.value);
        let text = format!("of all {}", self.measured.points);
        Some(row.place(Some(place)).text(text))
    }

    /// Returns the works of flow theory; of bodies without plastic strain all are details. Without
    /// a backstress the plastic work is dissipated.
    fn work(&self) -> Vec<Answer> {
        let Some(FlowFigures { energy, .. }) = &self.known.flow else { return Vec::new() };
        let lost = self.row(Name::DissipatedWork, energy.dissipated());
        let is_lost = energy.dissipated() > 0.0;
        let mut rows = vec![if is_lost { lost } else { lost.detail() }];
        let mut details = vec![(Name::Work, energy.work()), (Name::ElasticEnergy, energy.elastic)];
        if energy.backstress != 0.0 {
            details.push((Name::PlasticWork, energy.plastic_work));
            details.push((Name::StoredEnergy, energy.backstress));
        }
        rows.extend(details.into_iter().map(|(name, value)| self.row(name, value).detail()));
        rows
    }

    fn stiffness(&self) -> Vec<Answer> {
        let contact = self.known.stiffness.filter(|_| self.touches());
        let contact = contact.map(|slope| {
            let bar = self.bars().and_then(|bars| bars.contact_stiffness);
            self.row(Name::ContactStiffness, slope)
                .bar(self.bar(&[(Figure::HalfWidth, 0)], bar))
                .text(Name::ContactStiffness.meaning())
        });
        // Elastic bodies have one slope.
        let unloading = self.known.flow.as_ref().map(|flow| flow.unloading_stiffness);
        let is_other = |slope: &f64| *slope > 0.0 && Some(*slope) != self.known.stiffness;
        let unloading = unloading.filter(is_other);
        let unloading = unloading.map(|slope| self.told(Name::UnloadingStiffness, slope));
        contact.into_iter().chain(unloading).collect()
    }
}
