//! The rows of a hardness test, and its number in the verdict of its steps.

use super::found::{Found, OliverPharr};
use super::seen::Seen;
use super::{BALL_STRAIN, DAO_STRAIN, HardnessSeen, PYRAMID_STRAIN, dao_curvature};
use crate::job::{Job, TestScale};
use crate::report::answers::{Answer, AnswerAt, Bar, Name};
use crate::report::findings::Finding;
use crate::report::verdict::said;
use crate::report::{ValidityNote, Verdict, validity};
use crate::units::{UnitConverter, percent, to_digits};

/// Why a figure of the indentation has no bar.
const NO_BAR: &str = "too few increments or elements to bound it";

/// The answer to a test.
#[derive(Debug, Default)]
struct Answered {
    rows: Vec<Answer>,
    findings: Vec<Finding>,
}

impl HardnessSeen {
    /// Returns the rows of the test; none of another job and where the largest force has no answer.
    pub fn rows(&self, job: &Job, write: UnitConverter) -> Vec<Answer> {
        self.answered(job, write).unwrap_or_default().rows
    }

    /// Returns what to keep in mind about the test.
    pub fn remarks(&self, job: &Job, write: UnitConverter) -> Vec<ValidityNote> {
        validity::remarks(&self.answered(job, write).unwrap_or_default().findings, write)
    }

    /// Puts the number that the loads so far have found before a verdict.
    pub fn before(&self, verdict: Verdict, job: &Job, write: UnitConverter) -> Verdict {
        let rows = self.rows(job, write);
        let Some((number, value)) = rows.first().and_then(|row| Some((row, row.value?))) else {
            return verdict;
        };
        let points = || number.at_most.map(|most| format!(" ± {}", to_digits(most - value, 2)));
        let bar = number.error.bound().map(|part| format!(" ± {}", percent(part)));
        let bar = bar.or_else(points).unwrap_or_default();
        let (label, figure) = (&number.label, said(number));
        Verdict { text: format!("{label}: {figure}{bar}. {}", verdict.text), ..verdict }
    }

    fn answered(&self, job: &Job, write: UnitConverter) -> Option<Answered> {
        let test = job.load.hardness()?;
        let loaded = self.0.iter().position(|seen| seen.force >= 0.999 * test.force())?;
        let specimen = job.lower.deformable()?;
        let modulus = 1.0
            / (1.0 / specimen.elastic.plane_strain_modulus()
                + 1.0 / test.elastic()?.plane_strain_modulus());
        let found = Found::of(test, job, &self.0, loaded)?;
        let law = specimen.hardening_law();
        let strain = match test.slope() {
            None => BALL_STRAIN * found.radius / test.radius(),
            Some(_) => PYRAMID_STRAIN,
        };
        let curve = law.as_ref().map(|law| [strain, law.stress(strain)]);
        let curvature = law.as_ref().filter(|_| found.is_pyramid());
        let curvature = curvature.and_then(|law| dao_curvature(modulus, law.stress(DAO_STRAIN)));
        let published = found.published(modulus, curve.map(|[_, stress]| stress));
        let findings = found.findings(published.is_some());
        let at = AnswerAt { load: Some(loaded + 1), ..AnswerAt::default() };
        let shown = Shown { job, write, found: &found };
        let rows = shown.rows(modulus, curve, curvature, published);
        Some(Answered { rows: rows.into_iter().map(|row| row.at(at)).collect(), findings })
    }
}

/// A test in the units of its job.
struct Shown<'a> {
    job: &'a Job,
    write: UnitConverter,
    found: &'a Found<'a>,
}

impl Shown<'_> {
    fn row(&self, name: Name, core: impl Into<Option<f64>>) -> Answer {
        let quantity = name.quantity();
        let value = core.into().map(|core| self.write.of(quantity, core));
        Answer::new(name, quantity, self.job.units.symbol(quantity), value).text(name.meaning())
    }

    /// Returns a row with an error of the mesh.
    fn meshed(&self, name: Name, core: f64, error: Option<f64>) -> Answer {
        self.row(name, core).bar(error.map_or_else(|| Bar::none(NO_BAR), Bar::Relative))
    }

    /// `curve` is Tabor's strain and its stress, `curvature` Dao's, `published` the mean pressure of
    /// a published result and its source.
    fn rows(
        &self,
        modulus: f64,
        curve: Option<[f64; 2]>,
        curvature: Option<f64>,
        published: Option<(f64, &'static str)>,
    ) -> Vec<Answer> {
        let (found, load) = (self.found, self.found.load());
        let of_area = found.area_error();
        // Twice that of the radius.
        let of_radius = of_area.map(|error| 0.5 * error);
        let pressure = found.pressure();
        let bias = published.map(|(published, source)| (pressure / published - 1.0, source));
        let mut rows = self.number(bias.map(|(bias, _)| bias));
        if found.without_answer().is_some() {
            return rows;
        }
        let (depth, depth_error) = found.depth();
        rows.extend([
            self.meshed(Name::Diameter, found.diameter(), of_radius),
            self.meshed(Name::IndentationDepth, depth, depth_error),
        ]);
        let unloaded = found.unloaded();
        let recovery = |seen: &Seen| load.dent - seen.dent;
        rows.extend(unloaded.map(|seen| self.row(Name::PermanentDepth, depth - recovery(seen))));
        let rim = unloaded.filter(|seen| seen.highest[1] > 0.0);
        rows.extend(rim.map(|seen| self.row(Name::RimDiameter, 2.0 * seen.highest[0].abs())));
        rows.push(self.row(Name::EdgeHeight, found.edge_height()));
        if let Some([strain, stress]) = curve {
            let is_given = found.test.slope().is_some();
            rows.extend([(Name::RepresentativeStrain, strain), (Name::FlowStress, stress)].map(
                |(name, core)| {
                    let row = self.meshed(name, core, of_radius);
                    if is_given { row.bar(Bar::Exact) } else { row }
                },
            ));
            rows.push(self.meshed(Name::ConstraintFactor, pressure / stress, of_area));
        }
        rows.extend(found.exponent.map(|exponent| self.row(Name::MeyerExponent, exponent)));
        rows.extend(bias.map(|(bias, source)| self.row(Name::LargeStrainBias, bias).text(source)));
        rows.extend(curvature.map(|curvature| {
            let bias = load.force / found.approach().0.powi(2) / curvature - 1.0;
            self.row(Name::CurvatureBias, bias)
        }));
        rows.extend(found.least_thickness().map(|least| self.row(Name::LeastThickness, least)));
        rows.extend(found.oliver_pharr().into_iter().flat_map(|pharr| self.pharr(&pharr)));
        rows.push(self.row(Name::ReducedModulus, modulus).detail());
        rows
    }

    /// Returns the number and the mean pressure; of a scale without number the pressure alone. Both
    /// are those of an indentation.
    fn number(&self, bias: Option<f64>) -> Vec<Answer> {
        let found = self.found;
        let pressure = self.meshed(Name::MeyerHardness, found.pressure(), found.area_error());
        let has_number = !matches!(found.test.scale, TestScale::Berkovich | TestScale::Sphere);
        let first = match found.number() {
            _ if !has_number => pressure.clone(),
            number => self.row(Name::Hardness, number).labelled(&found.test.name()),
        };
        if let Some(reason) = found.without_answer() {
            return vec![first.not_known(reason)];
        }
        let beside = |bias: f64| {
            let side = if bias < 0.0 { "below" } else { "above" };
            format!("its mean pressure is {} {side} that with large strains", percent(bias.abs()))
        };
        let relative = found.relative_error();
        let points = found.number_error().filter(|_| relative.is_none());
        let bar = match (relative, points) {
            (Some(error), _) => Bar::Relative(error + found.error_of_edges()),
            (None, Some(_)) => Bar::none("its zero is a convention"),
            (None, None) => Bar::none(NO_BAR),
        };
        let at = |sign: f64| Some(first.value? + sign * points?);
        let (at_least, at_most) = (at(-1.0), at(1.0));
        let text = bias.map_or_else(String::new, beside);
        let first = Answer { at_least, at_most, ..first }.bar(bar).text(text);
        if has_number { vec![first, pressure] } else { vec![first] }
    }

    /// Returns what an instrument would find, beside the true contact.
    fn pharr(&self, pharr: &OliverPharr) -> [Answer; 6] {
        let OliverPharr { modulus, hardness, stiffness, depth, area, errors } = *pharr;
        [
            self.meshed(Name::OliverPharrModulus, modulus, errors[0]),
            self.meshed(Name::OliverPharrHardness, hardness, errors[1]),
            self.row(Name::OliverPharrStiffness, stiffness).detail(),
            self.row(Name::OliverPharrDepth, depth).detail(),
            self.row(Name::OliverPharrArea, area).detail(),
            self.meshed(Name::IndentationArea, self.found.area(), self.found.area_error())
                .detail(),
        ]
    }
}
