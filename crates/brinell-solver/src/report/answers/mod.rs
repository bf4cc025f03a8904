//! Answers: the figures of a load step in the order in which the job asks for them, and a verdict.
//! Terminal, page, printed report and Python draw them and compute nothing.

mod contact;
mod strength;

use serde::{Deserialize, Serialize};

use super::datum::Datum;
use super::findings::Finding;
use super::{ErrorEstimate, FlowReport, LoadReport, PerBody, PlasticityReport, StepReport};
use crate::job::{Analysis, Job, Load, Material, Quantity, Side, Theory, label_of};
use crate::solver::SolveStatus;
use crate::solver::method::figures::{Figure, Values};
use crate::units::{UnitConverter, about};

/// Relative difference of forces that are alike.
const ROUNDING: f64 = 1e-9;

/// One figure of a load step, made to be shown.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Answer {
    /// Stable identifier, such as `peak_pressure`. An identifier may occur once for each body.
    pub name: String,
    /// Name for a person.
    pub label: String,
    /// Whose figure it is: `upper`, `lower` or, of bodies that are alike, `both`; `null` of the
    /// contact.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub body: Option<AnswerBody>,
    /// The figure in `unit`; `null` where it is not known, and `text` says why.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub value: Option<f64>,
    /// Its physical quantity. A `strain` and a `ratio` are shown in per cent.
    pub quantity: Quantity,
    /// Symbol of its unit in the units of the job; empty of a strain, a ratio and a number.
    pub unit: String,
    /// Estimated bound of its relative error by the mesh, as in `estimated_error`; 0 where it is
    /// prescribed, `null` where it is not known or as large as the figure, whose bound `text`
    /// then says \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub error: Option<f64>,
    /// What a figure without an error is at least. Unit: `unit`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_least: Option<f64>,
    /// What a figure without an error is at most, one below zero by its size. Unit: `unit`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_most: Option<f64>,
    /// The figure by Hertz's elastic theory, where that has one.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub elastic: Option<f64>,
    /// Where it is; `null` of a figure without a place.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub place: Option<AnswerPlace>,
    /// A note for a person: over which points a maximum was taken, or against what the figure
    /// counts.
    pub text: String,
}

/// Whose figure an answer is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
pub enum AnswerBody {
    /// The upper body.
    Upper,
    /// The lower body.
    Lower,
    /// Both bodies, which are alike.
    Both,
}

impl From<Side> for AnswerBody {
    fn from(side: Side) -> Self {
        match side {
            Side::Upper => Self::Upper,
            Side::Lower => Self::Lower,
        }
    }
}

/// The place of an answer, in the coordinates of `contact` and `plasticity`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct AnswerPlace {
    /// In which body.
    pub body: AnswerBody,
    /// x, or the radius \[length\].
    pub x: f64,
    /// y; only in three dimensions \[length\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub y: Option<f64>,
    /// Depth below the surface \[length\].
    pub depth: f64,
}

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
        let answers = facts.answers().into_iter().map(|answer| facts.bounded(answer)).collect();
        (self.answers, self.verdict) = (answers, Some(facts.verdict()));
        self
    }
}

impl Answer {
    pub(super) fn error(self, error: Option<f64>) -> Self {
        Self { error, ..self }
    }

    /// Sets what the figure is at least, or else a note.
    fn at_least(self, at_least: Option<f64>, note: &str) -> Self {
        let said = at_least.map(|least| format!("at least {} {}", about(least), self.unit));
        Self { at_least, ..self.text(said.unwrap_or_else(|| note.to_owned())) }
    }

    fn elastic(self, elastic: Option<f64>) -> Self {
        Self { elastic, ..self }
    }

    pub(super) fn place(self, place: Option<AnswerPlace>) -> Self {
        Self { place, ..self }
    }

    fn named(self, name: &str, label: &str) -> Self {
        Self { name: name.to_owned(), ..self.labelled(label) }
    }

    fn labelled(self, label: &str) -> Self {
        Self { label: label.to_owned(), ..self }
    }

    pub(super) fn of(self, body: AnswerBody) -> Self {
        let label = match body {
            AnswerBody::Upper => format!("{}, upper body", self.label),
            AnswerBody::Lower => format!("{}, lower body", self.label),
            AnswerBody::Both => self.label,
        };
        Self { body: Some(body), label, ..self }
    }

    pub(super) fn text(self, text: impl Into<String>) -> Self {
        Self { text: text.into(), ..self }
    }

    /// A width of 0 of bodies that touch is not known, nor is the mean pressure over it.
    fn of_width(self, touches: bool) -> Self {
        if touches && self.value == Some(0.0) {
            let unknown = Self { value: None, error: None, ..self };
            unknown.text("not known: narrower than an element")
        } else {
            self
        }
    }
}

/// Returns the name of a figure for a person: its identifier where nothing else is usual.
pub(super) fn label(figure: Figure) -> String {
    match figure {
        Figure::HalfWidth => "Half-width".to_owned(),
        Figure::MaxPlasticStrain => "Largest plastic strain".to_owned(),
        Figure::PileUp => "Pile-up".to_owned(),
        other => {
            let words = other.name().replace('_', " ");
            words[..1].to_uppercase() + &words[1..]
        }
    }
}

impl Facts<'_> {
    fn is_three_dimensional(&self) -> bool {
        self.job.analysis == Analysis::ThreeDimensional
    }

    /// Returns whether a force is that of the whole contact and not of a unit of thickness.
    fn is_whole(&self) -> bool {
        self.is_three_dimensional() || self.job.analysis == Analysis::Axisymmetric
    }

    pub fn is_rough(&self) -> bool {
        self.step.three_dimensional.as_ref().is_some_and(|whole| whole.surface.is_some())
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

    pub fn answer(
        &self,
        name: &str,
        label: &str,
        quantity: Quantity,
        value: impl Into<Option<f64>>,
    ) -> Answer {
        Answer {
            name: name.to_owned(),
            label: label.to_owned(),
            body: None,
            value: value.into().filter(|value| value.is_finite()),
            quantity,
            unit: self.unit(quantity).to_owned(),
            error: None,
            at_least: None,
            at_most: None,
            elastic: None,
            place: None,
            text: String::new(),
        }
    }

    /// Returns the answer of a figure, whose name, label and quantity are those of its row.
    pub fn figure(&self, figure: Figure, value: impl Into<Option<f64>>) -> Answer {
        let quantity = match figure.quantity() {
            Quantity::Force => self.force_quantity(),
            quantity => quantity,
        };
        self.answer(figure.name(), &label(figure), quantity, value)
    }

    pub fn force_quantity(&self) -> Quantity {
        if self.is_whole() { Quantity::Force } else { Quantity::LineForce }
    }

    pub fn unit(&self, quantity: Quantity) -> &'static str {
        self.job.units.symbol(quantity)
    }

    /// Returns a value of the report with its unit, to `digits` of
    /// [`rounded`](crate::units::rounded) or [`about`].
    pub fn with_unit(&self, digits: fn(f64) -> String, quantity: Quantity, value: f64) -> String {
        format!("{} {}", digits(value), self.unit(quantity))
    }

    /// Returns an answer with the bound of its size in place of an error as large as itself.
    fn bounded(&self, answer: Answer) -> Answer {
        let (Some(value), Some(error)) = (answer.value, answer.error) else { return answer };
        if error < 1.0 || value == 0.0 {
            return answer;
        }
        let size = value.abs() * (1.0 + error);
        let most = match answer.quantity {
            Quantity::Strain | Quantity::Ratio => format!("{} %", about(100.0 * size)),
            quantity => self.with_unit(about, quantity, size),
        };
        let note =
            if answer.text.is_empty() { String::new() } else { format!("; {}", answer.text) };
        let sign = if value < 0.0 { " either way" } else { "" };
        Answer { at_most: Some(size), ..answer.error(None) }
            .text(format!("at most {most}{sign}{note}"))
    }

    /// Returns the error estimate of a step that has converged.
    fn bars(&self) -> Option<&ErrorEstimate> {
        let bars = self.step.estimated_error.as_ref();
        bars.filter(|_| self.step.status == SolveStatus::Converged)
    }

    fn body_bar(&self, side: Side, bar: fn(&super::BodyErrors) -> Option<f64>) -> Option<f64> {
        let of_ellipse = self
            .step
            .three_dimensional
            .as_ref()
            .and_then(|whole| whole.estimated_error.as_ref())
            .map(|errors| errors.bodies);
        let PerBody { upper, lower } = of_ellipse.or(self.bars()?.bodies)?;
        let errors = if side == Side::Upper { upper } else { lower };
        errors.as_ref().and_then(bar)
    }

    /// Returns the answers in their order.
    fn answers(&self) -> Vec<Answer> {
        if self.step.status.is_stopped() {
            return Vec::new();
        }
        if let Some(rolling) = &self.step.rolling {
            return self.of_track(rolling);
        }
        let mut answers = self.asked();
        let is_graded = self.step.profiles().any(|(_, profile)| profile.yield_stress.is_some());
        if self.is_unloaded() {
            answers.extend(self.surfaces("dent_depth", &label(Figure::Dent)));
            // Apart, a given approach tells nothing of what is left.
            let is_given = matches!(self.step.load, LoadReport::Approach(_));
            let approach = self.approach();
            answers.push(if is_given {
                approach
            } else {
                approach.named("permanent_approach", "Permanent approach")
            });
            answers.extend(self.tension());
            answers.extend(self.core());
            answers.extend(self.strain());
            answers.extend(self.without_member());
            answers.extend(self.work());
            return answers;
        }
        answers.extend(self.of_heights());
        answers.extend(self.of_roller());
        if is_graded {
            answers.extend(self.strength());
        }
        answers.extend(self.of_contact());
        answers.extend(self.strain());
        if !is_graded {
            answers.extend(self.strength());
        }
        answers.extend(self.without_member());
        answers.extend(self.of_shapes());
        answers.extend(self.stiffness());
        if self.step.flow.is_some() {
            answers.extend(self.surfaces("surface_depth", "Surface depth"));
            answers.extend(self.work());
        }
        answers
    }

    /// Returns what the load of the job asks for: a force, or the onset of yield.
    fn asked(&self) -> Vec<Answer> {
        let step = self.step;
        let mut answers = Vec::new();
        if let (Load::Target(target), true) = (&self.job.load, self.touches()) {
            let figure = self.write.target_text(target.figure, target.value.get());
            answers.push(
                self.answer(
                    "force_found",
                    "Force found",
                    self.force_quantity(),
                    step.contact.force,
                )
                .error(self.bars().and_then(|bars| bars.force))
                .text(format!("for a {} of {figure}", label_of(target.figure))),
            );
        }
        if let Some(onset) = &step.yield_onset {
            let body = self.body(onset.body);
            let error = self.bars().and_then(|bars| bars.force);
            answers.push(
                self.answer(
                    "first_yield_force",
                    "First yield",
                    self.force_quantity(),
                    onset.force,
                )
                .error(error)
                .elastic(step.hertz.as_ref().and_then(|hertz| hertz.yield_onset_force))
                .place(Some(AnswerPlace { body, x: onset.position, y: None, depth: onset.depth }))
                .text("the force under which a body begins to yield, on this mesh"),
            );
        }
        answers
    }

    /// Returns depth and pile-up of each surface.
    fn surfaces(&self, name: &str, label: &str) -> Vec<Answer> {
        let Some(FlowReport { surfaces, .. }) = &self.step.flow else { return Vec::new() };
        let both = [(Side::Upper, &surfaces.upper), (Side::Lower, &surfaces.lower)];
        let both = both.into_iter().filter(|(side, _)| !self.is_alike() || *side == Side::Lower);
        let both: Vec<_> =
            both.filter_map(|(side, surface)| Some((side, surface.as_ref()?))).collect();
        let mut answers = Vec::new();
        // Under load the surfaces of half-spaces have an elastic deflection, which has no bar.
        let has_bar = self.is_unloaded() || !self.is_three_dimensional();
        for (side, surface) in &both {
            let bar = self.body_bar(*side, |errors| errors.depth).filter(|_| has_bar);
            let reversed = if surface.yielded_in_reverse { "; yielded in reverse" } else { "" };
            answers.push(
                self.figure(Figure::Dent, surface.depth)
                    .named(name, label)
                    .of(self.body(*side))
                    .error(bar)
                    .text(format!("deepest point below the undeformed surface{reversed}")),
            );
        }
        for (side, surface) in &both {
            let bar = self.body_bar(*side, |errors| errors.pile_up).filter(|_| has_bar);
            let body = self.body(*side);
            answers.push(self.figure(Figure::PileUp, surface.pile_up).of(body).error(bar).text(
                if surface.pile_up > 0.0 {
                    format!(
                        "highest point above the undeformed surface, {} from the middle",
                        self.with_unit(about, Quantity::Length, surface.pile_up_position)
                    )
                } else {
                    String::new()
                },
            ));
        }
        answers
    }

    fn approach(&self) -> Answer {
        let step = self.step;
        let hertz = step.three_dimensional.as_ref().and_then(|whole| whole.hertz);
        self.figure(Figure::Approach, step.approach)
            .error(self.bars().and_then(|bars| bars.approach))
            .elastic(hertz.filter(|_| self.touches()).map(|hertz| hertz.approach))
            .text(format!("between {}", self.measured.datum.between()))
    }

    fn tension(&self) -> Option<Answer> {
        let largest = self.measured.tension.as_ref().filter(|most| most.value > 0.0)?;
        let place = self.place_of(largest);
        Some(
            self.answer(
                "residual_tension",
                "Residual tension",
                Quantity::Stress,
                self.write.stress(largest.value),
            )
            .of(place.body)
            .place(Some(place))
            .text(format!("largest principal stress of all {}", self.measured.points)),
        )
    }

    fn work(&self) -> Option<Answer> {
        let energy = &self.step.flow.as_ref()?.energy;
        let quantity = if self.is_whole() { Quantity::Energy } else { Quantity::LineEnergy };
        (energy.dissipated > 0.0).then(|| {
            self.answer("dissipated_work", "Dissipated work", quantity, energy.dissipated)
                .text("since the bodies were at rest")
        })
    }

    fn strain(&self) -> Option<Answer> {
        let (body, zone) = self.most_strained()?;
        let side = if body == AnswerBody::Upper { Side::Upper } else { Side::Lower };
        let is_limited =
            self.zones().all(|(_, zone)| zone.max_equivalent_plastic_strain.is_some());
        let answer = if is_limited {
            let place =
                AnswerPlace { body, x: zone.position, y: zone.position_y, depth: zone.depth };
            self.figure(Figure::MaxPlasticStrain, zone.max_equivalent_plastic_strain)
                .error(self.body_bar(side, |errors| errors.max_equivalent_plastic_strain))
                .elastic(Some(0.0).filter(|_| self.touches()))
                .place(Some(place))
                .text(format!("of all {}", self.measured.points))
        } else {
            self.figure(Figure::MeanPlasticStrain, zone.mean_equivalent_plastic_strain)
                .error(self.body_bar(side, |errors| errors.mean_equivalent_plastic_strain))
                .text("over the area that has yielded; the largest has no limit on finer meshes")
        };
        Some(Answer { body: Some(body), ..answer })
    }

    /// Returns the figures that have no member of their own.
    pub(super) fn without_member(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        for figure in Figure::ALL.iter().filter(|figure| !figure.has_member()) {
            let sides: &[Side] =
                if figure.is_of_body() && !self.is_alike() { &Side::BOTH } else { &[Side::Lower] };
            for side in sides {
                let Some(core) = self.measured.figures.get(*figure, side.member()) else {
                    continue;
                };
                let answer = self.figure(*figure, self.write.of(figure.quantity(), core));
                answers.push(if figure.is_of_body() {
                    answer.of(self.body(*side))
                } else {
                    answer
                });
            }
        }
        answers
    }

    fn stiffness(&self) -> Vec<Answer> {
        let quantity = if self.is_whole() { Quantity::Stiffness } else { Quantity::LineStiffness };
        let contact = self.step.contact_stiffness.filter(|_| self.touches());
        let contact = contact.map(|slope| {
            self.answer("contact_stiffness", "Contact stiffness", quantity, slope)
                .error(self.bars().and_then(|bars| bars.contact_stiffness))
                .text("slope of the force over the approach")
        });
        let unloading = self.step.flow.as_ref().map(|flow| flow.unloading_stiffness);
        let unloading = unloading.filter(|slope| *slope > 0.0).map(|slope| {
            self.answer("unloading_stiffness", "Unloading stiffness", quantity, slope)
                .text("slope where the load begins to fall")
        });
        contact.into_iter().chain(unloading).collect()
    }
}
