//! Answers: the figures of a load step as rows, in the order in which the job asks for them, and a
//! verdict. Terminal, page, printed report and Python draw them and compute nothing.

mod bodies;
mod contact;
mod names;
mod row;
mod strength;

pub use names::{BarKind, Name, table_of_names};
pub(super) use row::Bar;
pub use row::{Answer, AnswerAt, AnswerBody, AnswerPlace, ErrorBar, ErrorWord};

use super::datum::Datum;
use super::findings::{Finding, Voids};
use super::{ErrorEstimate, FlowReport, LoadReport, PerBody, PlasticityReport, StepReport};
use crate::job::{Analysis, Job, Load, Material, Quantity, Side, Theory};
use crate::solver::SolveStatus;
use crate::solver::method::figures::{Figure, Values};
use crate::units::{UnitConverter, about};

/// Relative difference of forces that are alike.
const ROUNDING: f64 = 1e-9;

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
    /// All figures.
    pub figures: Values,
    /// Between what the approach is measured.
    pub datum: Datum,
    /// Depth at which the plastic zone of each body of cells begins.
    pub plastic_tops: [Option<f64>; 2],
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
    pub step: &'a StepReport,
    pub measured: &'a Measured,
    pub findings: &'a [Finding],
    pub write: UnitConverter,
}

impl StepReport {
    /// Adds answers and verdict to a report that is complete but for them.
    pub(super) fn answered(
        mut self,
        job: &Job,
        measured: &Measured,
        findings: &[Finding],
        write: UnitConverter,
    ) -> Self {
        let facts = Facts { job, step: &self, measured, findings, write };
        let rows = facts.answers().into_iter().map(|row| facts.bounded(row));
        let (details, mut rows): (Vec<_>, Vec<_>) = rows.partition(|row| row.detail);
        rows.extend(details);
        self.verdict = Some(facts.verdict(&rows));
        self.answers = rows;
        self
    }
}

impl Facts<'_> {
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

    pub fn is_alike(&self) -> bool {
        self.job.upper.is_alike(&self.job.lower)
    }

    pub fn touches(&self) -> bool {
        self.step.contact.force > 0.0
    }

    /// Returns whether the load of a history is taken away.
    pub fn is_unloaded(&self) -> bool {
        !self.touches() && self.job.solver.theory == Theory::Flow
    }

    /// Returns whether the force was sought by what it does.
    pub fn is_sought(&self) -> bool {
        matches!(self.job.load, Load::Target(_)) && self.touches()
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
        let body = if side == Side::Upper { &self.job.upper } else { &self.job.lower };
        match &body.material {
            Material::Deformable(material) => Some(material.hardening_law()?.yield_stress()),
            Material::Rigid => None,
        }
    }

    /// Returns the zones that have yielded; under a law without a yield point those with plastic
    /// strain.
    fn strained_zones(&self) -> impl Iterator<Item = (Side, &PlasticityReport)> {
        self.zones().filter(|(side, zone)| {
            let strain = zone.max_equivalent_plastic_strain;
            zone.yielded || strain > Some(0.0) && self.yield_point(*side) == Some(0.0)
        })
    }

    /// Returns whether a body can yield.
    pub fn can_yield(&self) -> bool {
        [&self.job.upper, &self.job.lower].iter().any(|body| match &body.material {
            Material::Deformable(material) => material.hardening_law().is_some(),
            Material::Rigid => false,
        })
    }

    fn zones(&self) -> impl Iterator<Item = (Side, &PlasticityReport)> {
        let PerBody { upper, lower } = &self.step.plasticity;
        [(Side::Upper, upper), (Side::Lower, lower)]
            .into_iter()
            .filter_map(|(side, zone)| Some((side, zone.as_ref()?)))
    }

    /// Returns the zone with the largest plastic strain, or with the largest mean of strains
    /// without limit.
    pub fn most_strained(&self) -> Option<(AnswerBody, &PlasticityReport)> {
        let strain = |zone: &PlasticityReport| {
            zone.max_equivalent_plastic_strain.unwrap_or(zone.mean_equivalent_plastic_strain)
        };
        let (side, zone) =
            self.strained_zones().max_by(|a, b| strain(a.1).total_cmp(&strain(b.1)))?;
        Some((self.body(side), zone))
    }

    pub fn body(&self, side: Side) -> AnswerBody {
        if self.is_alike() { AnswerBody::Both } else { side.into() }
    }

    pub fn place_of(&self, largest: &Largest) -> AnswerPlace {
        let [x, y, depth] = largest.place.map(|length| self.write.length(length));
        AnswerPlace {
            body: self.body(Side::of(largest.side)),
            x,
            y: self.is_three_dimensional().then_some(y),
            depth,
        }
    }

    /// Returns the row of a figure of the report.
    pub fn row(&self, name: Name, value: impl Into<Option<f64>>) -> Answer {
        let quantity = self.quantity(name);
        let row = Answer::new(name, quantity, self.unit(quantity), value.into());
        match name.bar() {
            BarKind::Mesh => row.bar(Bar::none(self.why(&[]))),
            BarKind::Exact | BarKind::None => row,
        }
    }

    /// Returns the row of a figure with the bar of two meshes, of a body that of one side.
    pub fn meshed(
        &self,
        name: Name,
        value: impl Into<Option<f64>>,
        (figure, side): (Figure, usize),
        bar: Option<f64>,
    ) -> Answer {
        self.row(name, value).bar(self.bar(&[(figure, side)], bar))
    }

    /// Returns a bar, or why one of the figures on which it depends has none.
    pub fn bar(&self, of: &[(Figure, usize)], bar: Option<f64>) -> Bar {
        bar.map_or_else(|| Bar::none(self.why(of)), Bar::Relative)
    }

    /// Returns why figures have no bar.
    fn why(&self, of: &[(Figure, usize)]) -> String {
        if self.step.status != SolveStatus::Converged {
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

    pub fn force_quantity(&self) -> Quantity {
        self.quantity(Name::Force)
    }

    pub fn unit(&self, quantity: Quantity) -> &'static str {
        self.job.units.symbol(quantity)
    }

    /// Returns a value of the report with its unit, to `digits` of
    /// [`rounded`](crate::units::rounded) or [`about`].
    pub fn with_unit(&self, digits: fn(f64) -> String, quantity: Quantity, value: f64) -> String {
        format!("{} {}", digits(value), self.unit(quantity))
    }

    /// Returns a row with the bound of its size in place of an error as large as itself, and
    /// without a relative error of zero.
    fn bounded(&self, row: Answer) -> Answer {
        let (Some(value), ErrorBar::Relative(error)) = (row.value, row.error) else { return row };
        if value == 0.0 {
            return row.bar(Bar::none("a figure of zero has no relative error"));
        }
        if error < 1.0 {
            return row;
        }
        let size = value.abs() * (1.0 + error);
        let most = match row.quantity {
            Quantity::Strain | Quantity::Ratio => format!("{} %", about(100.0 * size)),
            quantity => self.with_unit(about, quantity, size),
        };
        let note = if row.text.is_empty() { String::new() } else { format!("; {}", row.text) };
        let sign = if value < 0.0 { " either way" } else { "" };
        Answer { at_most: Some(size), ..row.bar(Bar::none("the error is as large as the figure")) }
            .text(format!("at most {most}{sign}{note}"))
    }

    /// Returns the error estimate of a step that has converged.
    fn bars(&self) -> Option<&ErrorEstimate> {
        let bars = self.step.estimated_error.as_ref();
        bars.filter(|_| self.step.status == SolveStatus::Converged)
    }

    /// Returns the rows in their order, but for details, which may be anywhere.
    fn answers(&self) -> Vec<Answer> {
        if self.step.status.is_stopped() {
            return Vec::new();
        }
        if let Some(rolling) = &self.step.rolling {
            return self.of_track(rolling);
        }
        let mut rows = self.asked();
        if self.is_sought() {
            rows.push(self.force().labelled("Force found"));
        }
        let is_graded = self.step.profiles().any(|(_, profile)| profile.yield_stress.is_some());
        if self.is_unloaded() {
            rows.extend(self.surfaces(Name::DentDepth));
            rows.push(self.approach());
            rows.extend(self.tension());
            rows.extend(self.core());
            rows.extend(self.strains());
            rows.extend(self.plastic_depths());
            rows.extend(self.work());
            rows.extend(self.of_contact().into_iter().map(Answer::detail));
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
        rows.extend(self.of_bodies());
        rows.extend(self.of_place());
        rows
    }

    /// Returns the onset of yield: sought, or in closed form.
    fn asked(&self) -> Vec<Answer> {
        let step = self.step;
        let hertz = step.hertz.as_ref();
        let closed = hertz.and_then(|hertz| hertz.yield_onset_force);
        if let Some(onset) = &step.yield_onset {
            let body = self.body(onset.body);
            let place = AnswerPlace { body, x: onset.position, y: None, depth: onset.depth };
            let bar = self.bars().and_then(|bars| bars.force);
            let first = self.meshed(Name::FirstYieldForce, onset.force, (Figure::Force, 0), bar);
            let first = first.elastic(closed).place(Some(place));
            let first = first.text("the force under which a body begins to yield, on this mesh");
            let bar = self.bars().and_then(|bars| bars.peak_pressure);
            let peak = Name::FirstYieldPeakPressure;
            let peak = self.meshed(peak, onset.peak_pressure, (Figure::PeakPressure, 0), bar);
            return vec![first, peak.detail()];
        }
        // A closed form that is not of these bodies is no figure of theirs.
        let first = self.first_yield().filter(|_| self.touches());
        let Some((force, hertz)) = first.zip(hertz) else { return Vec::new() };
        let used = self.measured.utilization.as_ref();
        let body = used.map_or(AnswerBody::Both, |used| self.body(Side::of(used.side)));
        let depth = hertz.yield_onset_depth;
        let place = depth.map(|depth| AnswerPlace { body, x: 0.0, y: None, depth });
        let row = self.row(Name::FirstYieldForce, force).place(place);
        vec![row.text("closed form of half-spaces").detail()]
    }

    /// Returns the approach; without force, and unless it is given, the permanent one.
    pub fn approach(&self) -> Answer {
        let step = self.step;
        let whole = step.three_dimensional.as_ref();
        let hertz = whole.and_then(|whole| whole.hertz).filter(|_| self.touches());
        let given = match step.load {
            LoadReport::Approach(approach) => Some(approach),
            LoadReport::Force(_) => None,
        };
        // Apart, a given approach tells nothing of what is left.
        let is_left = self.is_unloaded() && given.is_none();
        let name = if is_left { Name::PermanentApproach } else { Name::Approach };
        let bar = self.bars().and_then(|bars| bars.approach);
        let row = self.meshed(name, given.or(step.approach), (Figure::Approach, 0), bar);
        let row = if given.is_some() { row.bar(Bar::Given) } else { row };
        row.elastic(hertz.map(|hertz| hertz.approach))
            .text(format!("between {}", self.measured.datum.between()))
    }

    fn tension(&self) -> Option<Answer> {
        let largest = self.measured.tension.as_ref().filter(|most| most.value > 0.0)?;
        let place = self.place_of(largest);
        let row = self.row(Name::ResidualTension, self.write.stress(largest.value));
        let text = format!("largest principal stress of all {}", self.measured.points);
        Some(row.of(place.body).place(Some(place)).text(text))
    }

    /// Returns the works of flow theory; of bodies without plastic strain all are details.
    fn work(&self) -> Vec<Answer> {
        let Some(FlowReport { energy, .. }) = &self.step.flow else { return Vec::new() };
        let since = "since the bodies were at rest";
        let lost = self.row(Name::DissipatedWork, energy.dissipated).text(since);
        let mut rows = vec![if energy.dissipated > 0.0 { lost } else { lost.detail() }];
        let details = [
            (Name::Work, energy.work),
            (Name::ElasticEnergy, energy.elastic),
            (Name::PlasticWork, energy.plastic),
            (Name::StoredEnergy, energy.stored),
        ];
        rows.extend(details.map(|(name, value)| self.row(name, value).detail()));
        rows
    }

    fn stiffness(&self) -> Vec<Answer> {
        let contact = self.step.contact_stiffness.filter(|_| self.touches());
        let contact = contact.map(|slope| {
            let bar = self.bars().and_then(|bars| bars.contact_stiffness);
            let row = self.meshed(Name::ContactStiffness, slope, (Figure::HalfWidth, 0), bar);
            row.text("slope of the force over the approach")
        });
        let unloading = self.step.flow.as_ref().map(|flow| flow.unloading_stiffness);
        let unloading = unloading.filter(|slope| *slope > 0.0).map(|slope| {
            let row = self.row(Name::UnloadingStiffness, slope);
            row.text("slope where the load begins to fall")
        });
        contact.into_iter().chain(unloading).collect()
    }
}
