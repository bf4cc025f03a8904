//! The rows of a hardness test, and its number in the verdict of its steps.

use super::{HardnessReport, HardnessSeen, OliverPharrReport};
use crate::job::{Job, TestScale};
use crate::report::answers::{Answer, AnswerAt, Bar, Name};
use crate::report::{Report, StepReport};
use crate::units::{UnitConverter, about, percent};

/// Why a figure of the indentation has no bar.
const NO_BAR: &str = "too few increments, or no coarser mesh, to bound it";

impl StepReport {
    /// Puts the hardness that the loads so far have found before the verdict.
    pub(in crate::report) fn with_hardness(
        mut self,
        job: &Job,
        seen: &HardnessSeen,
        write: UnitConverter,
    ) -> Self {
        let found = seen.clone().finish(job, write);
        let Some(number) = found.as_ref().and_then(|found| number(job, found)) else {
            return self;
        };
        if let Some(verdict) = &mut self.verdict {
            let unit =
                if number.unit.is_empty() { String::new() } else { format!(" {}", number.unit) };
            let points = || {
                let points = found.as_ref()?.number_error?;
                Some(format!(" ± {}", about(points)))
            };
            let bar = number.error.bound().map(|part| format!(" ± {}", percent(part)));
            let bar = bar.or_else(points).unwrap_or_default();
            let value = about(number.value.unwrap_or_default());
            verdict.text = format!("{}: {value}{unit}{bar}. {}", number.label, verdict.text);
        }
        self
    }
}

impl Report {
    /// Returns the rows of a hardness test.
    pub(in crate::report) fn of_hardness(
        job: &Job,
        seen: &HardnessSeen,
        write: UnitConverter,
    ) -> Vec<Answer> {
        let Some((found, load)) = seen.clone().finish(job, write).zip(seen.loaded(job)) else {
            return Vec::new();
        };
        let at = AnswerAt { load: Some(load + 1), ..AnswerAt::default() };
        let relative = |error: Option<f64>| error.map_or_else(|| Bar::none(NO_BAR), Bar::Relative);
        let of_area = relative(found.relative_error);
        // The radius is the half of the area.
        let of_radius = relative(found.relative_error.map(|error| 0.5 * error));
        let row =
            |name: Name, value: Option<f64>, bar: Bar| Some(plain(job, name, value?).bar(bar));
        let none = || Bar::none("no estimate is made of it");
        let rows = [
            row(Name::MeyerHardness, Some(found.mean_pressure), of_area.clone()),
            row(Name::Diameter, Some(found.diameter), of_radius.clone()),
            row(Name::IndentationDepth, Some(found.depth), relative(found.depth_error)),
            row(Name::PermanentDepth, found.permanent_depth, none()),
            row(Name::RimDiameter, found.rim_diameter, none()),
            row(Name::EdgeHeight, Some(found.pile_up), none()),
            row(Name::RepresentativeStrain, found.representative_strain, of_radius.clone()),
            row(Name::FlowStress, found.flow_stress, of_radius),
            row(Name::ConstraintFactor, found.constraint, of_area),
            row(Name::MeyerExponent, found.meyer_exponent, none()),
            row(Name::LargeStrainBias, found.bias, none())
                .map(|row| row.text(found.bias_source.clone().unwrap_or_default())),
            row(Name::CurvatureBias, found.curvature_bias, none()).map(|row| {
                row.text("F/h² beside that of M. Dao et al., Acta Mater. 49 (2001) 3899")
            }),
            row(Name::LeastThickness, found.least_thickness, none()),
        ];
        let rows = number(job, &found).into_iter().chain(rows.into_iter().flatten());
        let oliver = found.oliver_pharr.iter().flat_map(|found| oliver_pharr(job, found));
        rows.chain(oliver).map(|row| row.at(at)).collect()
    }
}

fn plain(job: &Job, name: Name, value: f64) -> Answer {
    let quantity = name.quantity();
    Answer::new(name, quantity, job.units.symbol(quantity), Some(value))
}

/// Returns the row of the number, or of the pressure that stands for it.
fn number(job: &Job, found: &HardnessReport) -> Option<Answer> {
    let scale = job.load.hardness()?.scale;
    let row = match (found.number, scale) {
        (Some(number), _) => plain(job, Name::Hardness, number),
        (None, TestScale::Berkovich | TestScale::Sphere) => {
            let pressure = plain(job, Name::MeyerHardness, found.mean_pressure);
            Answer { name: plain(job, Name::Hardness, 0.0).name, ..pressure }
        }
        (None, _) => return None,
    };
    let row = row.labelled(&found.test);
    let beside = |bias: f64| {
        let side = if bias < 0.0 { "below" } else { "above" };
        format!("its mean pressure is {} {side} that with large strains", percent(bias.abs()))
    };
    let points = found.number_error.filter(|_| found.relative_error.is_none());
    let said = points.map(|points| format!("± {} points", about(points)));
    let clauses: Vec<_> = said.into_iter().chain(found.bias.map(beside)).collect();
    let bar = match (found.relative_error, points) {
        (Some(error), _) => Bar::Relative(error),
        (None, Some(_)) => Bar::none("its zero is a convention"),
        (None, None) => Bar::none(NO_BAR),
    };
    let row = row.bar(bar).text(clauses.join("; "));
    let at = |sign: f64| Some(row.value? + sign * points?);
    Some(Answer { at_least: at(-1.0), at_most: at(1.0), ..row })
}

/// Returns what an instrument would find, beside the true contact.
fn oliver_pharr(job: &Job, found: &OliverPharrReport) -> Vec<Answer> {
    let bar = |error: Option<f64>| error.map_or_else(|| Bar::none(NO_BAR), Bar::Relative);
    let row = |name: Name, value: f64| plain(job, name, value);
    let rows = [
        row(Name::OliverPharrModulus, found.reduced_modulus).bar(bar(found.modulus_error)),
        row(Name::OliverPharrHardness, found.indentation_hardness).bar(bar(found.hardness_error)),
        row(Name::OliverPharrStiffness, found.stiffness),
        row(Name::OliverPharrDepth, found.contact_depth),
        row(Name::OliverPharrArea, found.area),
        row(Name::IndentationArea, found.true_area),
        row(Name::ReducedModulus, found.true_reduced_modulus),
    ];
    rows.to_vec()
}
