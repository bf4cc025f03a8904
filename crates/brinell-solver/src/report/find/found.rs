//! The input with which a figure is as wanted, how sure it is, and which figure would tell it
//! better.

use super::document::{FoundReport, Looks};
use super::search::{self, Point};
use super::trials::{Trials, elasticity, refused, rows, words};
use crate::job::{Domain, Find, Job, Named as _, Quantity, Wanted};
use crate::report::answers::Bar;
use crate::report::{Answer, Name, Report, RunError};
use crate::units::{percent, rounded};

/// Part of a bar within which a figure is as wanted, and its limits. Figures scatter by 1e-6 to
/// 1e-3 from one input to the next (`docs/notes/find.md`).
const GOOD: (f64, f64, f64) = (0.1, 1e-5, 1e-3);
/// Logarithm in place of that of a figure which is 0 or has the other sign.
const FAR: f64 = 3.0;
/// Difference of the logarithm of the input within which scatter tells an elasticity. A look that
/// is made for one is twice as far.
const SCATTERS: f64 = 0.01;
/// Relative difference of two elasticities whose parabola tells the one between them.
const EVEN: f64 = 0.05;
/// Relative error from which on both ends are told in place of a value.
const POOR: f64 = 0.25;

/// One solved job, and its figure.
struct Look {
    value: f64,
    row: Answer,
    figure: f64,
    rows: Vec<Answer>,
}

/// What a search has come to.
pub struct Sought {
    /// The job with the input found.
    pub job: Job,
    /// Its report without fields, if the search has it still.
    pub report: Option<Report>,
    /// Rows of the input.
    pub answers: Vec<Answer>,
    pub found: FoundReport,
}

/// The search of one job.
struct Seeker<'a, 'b> {
    job: &'a Job,
    find: &'a Find,
    trials: &'a mut Trials<'b>,
    looks: Vec<Look>,
    /// The nearest point, with its report.
    kept: Option<(Point, Report)>,
}

/// Looks for the input that a job asks for.
///
/// # Errors
/// [`RunError::Input`] where no input between the ends is found, and those of a solve.
pub fn seek(job: &Job, find: &Find, trials: &mut Trials<'_>) -> Result<Sought, RunError> {
    let mut seeker = Seeker { job, find, trials, looks: Vec::new(), kept: None };
    let ends = find.between.map(|end| seeker.coordinate(end));
    let Wanted::Value(wanted) = find.wanted else {
        let (found, bend) = search::least(ends, &mut |at| seeker.look(at))?;
        let is_bent = bend > 0.0 && found.off != 0.0;
        let scale = if seeker.is_log() { 1.0 } else { seeker.value(found.at).abs() };
        let error = |bar: f64| is_bent.then(|| (bar * found.off.abs() / bend).sqrt() / scale);
        return seeker.sought(&[found], None, error);
    };
    let (found, slope) = if let Some(target) = job.with_target(find, wanted) {
        let target = target.map_err(|fault| refused("/find/until", words(&fault)))?;
        let (force, slope) = seeker.force(target)?;
        (vec![seeker.look(seeker.coordinate(force))?], slope)
    } else {
        let found = search::crossings(ends, &mut |at| seeker.look(at))?;
        let found = found.ok_or_else(|| seeker.out_of_reach(wanted))?;
        let slope = seeker.slope(seeker.value(found[0].at))?;
        (found, slope)
    };
    let missed = found[0].off.abs();
    let bar = seeker.looked(seeker.value(found[0].at)).and_then(|look| look.row.error.bound());
    if missed > bar.unwrap_or_default().max(GOOD.2) {
        return Err(seeker.jumps(found[0], wanted));
    }
    seeker.sought(&found, slope, |bar| slope.map(|slope| (bar + missed) / slope.abs()))
}

impl Seeker<'_, '_> {
    fn is_log(&self) -> bool {
        self.find.between[0] > 0.0
    }

    fn coordinate(&self, value: f64) -> f64 {
        if self.is_log() { value.ln() } else { value }
    }

    /// Returns the value of a coordinate to seven digits, so that it can be put in as it is told.
    fn value(&self, at: f64) -> f64 {
        let value = if self.is_log() { at.exp() } else { at };
        let [low, high] = self.find.between;
        format!("{value:.6e}").parse().unwrap_or(value).clamp(low, high)
    }

    fn inputs(&self) -> String {
        self.find.vary.join(" and ")
    }

    /// Returns the look with a value.
    fn looked(&self, value: f64) -> Option<&Look> {
        self.looks.iter().find(|look| look.value.total_cmp(&value).is_eq())
    }

    /// Solves the job with a value.
    fn look(&mut self, at: f64) -> Result<Point, RunError> {
        let value = self.value(at);
        let inputs = self.inputs();
        let with = |detail: String| refused("/find", format!("with {inputs} = {value}: {detail}"));
        let job = self.job.varied(&self.find.vary, value).map_err(|fault| with(words(&fault)))?;
        let report = match self.trials.solve(job) {
            Err(RunError::Interrupted(why)) => return Err(RunError::Interrupted(why)),
            Err(error) => return Err(with(error.to_string())),
            Ok(report) => report,
        };
        let rows = rows(&report);
        let Find { figure, body, wanted, .. } = *self.find;
        let is_figure = |row: &&Answer| row.is(figure) && body.is_none_or(|side| row.is_of(side));
        let known =
            rows.iter().filter(is_figure).filter_map(|row| Some((row.value?, row.clone())));
        // Of several criteria, rules or bodies the largest figure decides.
        let Some((figure, row)) = known.max_by(|one, other| one.0.total_cmp(&other.0)) else {
            return Err(with(if rows.is_empty() {
                "the job does not converge".to_owned()
            } else {
                format!("{:?} is no figure of this job, or is not known", figure.label())
            }));
        };
        let (part, least, most) = GOOD;
        let good = row.error.bound().map_or(most, |bar| (part * bar).clamp(least, most));
        let (off, good) = match wanted {
            Wanted::Value(wanted) if figure / wanted > 0.0 => ((figure / wanted).ln(), good),
            Wanted::Value(_) => (-FAR, good),
            Wanted::Least => (figure, good * figure.abs()),
            Wanted::Most => (-figure, good * figure.abs()),
        };
        let point = Point { at: self.coordinate(value), off, good };
        let is_nearer = self.kept.as_ref().is_none_or(|(kept, _)| match wanted {
            Wanted::Value(_) => !kept.is_good() && off.abs() < kept.off.abs(),
            Wanted::Least | Wanted::Most => off < kept.off,
        });
        if is_nearer {
            self.kept = Some((point, report));
        }
        self.looks.push(Look { value, row, figure, rows });
        Ok(point)
    }

    /// Finds a force, and the elasticity of the figure there, by the search of `load.target`.
    fn force(&mut self, target: Job) -> Result<(f64, Option<f64>), RunError> {
        let report = self.trials.solve(target).map_err(|error| match error {
            RunError::Input(faults) => {
                let detail = faults.into_iter().next().map(|fault| fault.detail);
                refused("/find/until", detail.unwrap_or_default())
            }
            error => error,
        })?;
        let rows = rows(&report);
        let value = |name| rows.iter().find(|row| row.is(name)).and_then(|row| row.value);
        let [low, high] = self.find.between;
        match value(Name::ForceFound) {
            Some(force) if (low..=high).contains(&force) => {
                Ok((force, value(Name::ForceSensitivity)))
            }
            Some(force) => {
                let detail = format!("do not have the force {} between them", rounded(force));
                Err(refused("/find/between", detail))
            }
            None => Err(refused("/find", "the job does not converge".to_owned())),
        }
    }

    /// Returns the elasticity of the figure at a value: by the parabola through the two nearest
    /// looks where they nearly tell the same, else by a look beside it.
    fn slope(&mut self, value: f64) -> Result<Option<f64>, RunError> {
        if value == 0.0 {
            return Ok(None);
        }
        let figure = |look: &Look| Some(look.figure);
        if let (Some(here), &[one, other, ..]) = (self.looked(value), &self.beside(value)[..])
            && let Some(slope) = between((here, one), figure)
            && let Some(second) = between((here, other), figure)
            && (slope - second).abs() <= EVEN * slope.abs()
        {
            let bend = (second - slope) / (other.value / one.value).ln();
            return Ok(Some(slope + bend * (value / one.value).ln()));
        }
        let [low, high] = self.find.between;
        let beside = [2.0, -2.0].map(|times| value * (times * SCATTERS).exp());
        let Some(beside) = beside.into_iter().find(|one| (low..=high).contains(one)) else {
            return Ok(None);
        };
        self.look(self.coordinate(beside))?;
        Ok(self.looked(value).zip(self.looks.last()).and_then(|pair| between(pair, figure)))
    }

    /// Returns the looks whose distance tells an elasticity, the nearest first.
    fn beside(&self, value: f64) -> Vec<&Look> {
        let far = |look: &&Look| (look.value / value).ln().abs();
        let is_far = |look: &&Look| (SCATTERS..f64::INFINITY).contains(&far(look));
        let mut looks: Vec<_> = self.looks.iter().filter(is_far).collect();
        looks.sort_by(|one, other| far(one).total_cmp(&far(other)));
        looks
    }

    /// Returns the refusal of a figure that neither the ends nor the places between them reach.
    fn out_of_reach(&self, wanted: f64) -> RunError {
        let figures = self.looks.iter().map(|look| look.figure);
        let range = figures.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], one| {
            [low.min(one), high.max(one)]
        });
        let of = |look: &Look| format!("{} with {}", rounded(look.figure), look.value);
        self.unreached(&format!(
            "{} and {}, and between {} and {} at three values between them: nowhere {}",
            of(&self.looks[0]),
            of(&self.looks[1]),
            rounded(range[0]),
            rounded(range[1]),
            rounded(wanted)
        ))
    }

    /// Returns the refusal of a figure that jumps over the wanted value.
    fn jumps(&self, found: Point, wanted: f64) -> RunError {
        let value = self.value(found.at);
        let here = self.looked(value).map_or(wanted, |look| look.figure);
        let far = |look: &&Look| (look.value - value).abs();
        let others = self.looks.iter().filter(|look| (look.figure > wanted) != (here > wanted));
        let other = others.min_by(|one, other| far(one).total_cmp(&far(other)));
        let other = other.map_or_else(String::new, |look| {
            format!(" and {} with {}", rounded(look.figure), look.value)
        });
        let (here, wanted) = (rounded(here), rounded(wanted));
        self.unreached(&format!("{here} with {value}{other}: it jumps over {wanted}"))
    }

    fn unreached(&self, detail: &str) -> RunError {
        let Find { figure, .. } = self.find;
        refused(
            &format!("/find/until/{}", figure.name()),
            format!("{} is {detail}", figure.label()),
        )
    }

    /// Returns the answer of a search whose first point is found; `error` is that of the input
    /// under the bar of the figure.
    fn sought(
        mut self,
        points: &[Point],
        slope: Option<f64>,
        error: impl Fn(f64) -> Option<f64>,
    ) -> Result<Sought, RunError> {
        let values: Vec<f64> = points.iter().map(|point| self.value(point.at)).collect();
        let job = self.job.varied(&self.find.vary, values[0]);
        let job = job.map_err(|fault| refused("/find", words(&fault)))?;
        let Some(here) = self.looked(values[0]) else {
            return Err(RunError::Failed("a search has not solved what it found".to_owned()));
        };
        let error = here.row.error.bound().and_then(error).filter(|error| error.is_finite());
        let (input, mut text) = self.told(here, error);
        if let [_, also @ ..] = &values[..]
            && !also.is_empty()
        {
            let also: Vec<_> = also.iter().map(|value| rounded(*value)).collect();
            text = format!("{text} Also with {}.", also.join(", "));
        }
        let slope = slope.map(|slope| {
            Answer::new(Name::InputElasticity, Quantity::Number, "", Some(slope)).detail()
        });
        let answers = [input.text(text.clone())].into_iter().chain(slope).collect();
        let report = self.kept.take().filter(|(kept, _)| *kept == points[0]);
        let (vary, figure) = (self.find.vary.clone(), self.find.figure.name().to_owned());
        let found = FoundReport { vary, figure, values, looks: self.looks(), text };
        Ok(Sought { job, report: report.map(|(_, report)| report), answers, found })
    }

    /// Returns the row of the input, and the answer in a sentence.
    fn told(&self, here: &Look, error: Option<f64>) -> (Answer, String) {
        let domain = self.job.domain_at(&self.find.vary[0]);
        let quantity = domain.map_or(Quantity::Number, Domain::quantity);
        let unit = self.job.units.symbol(quantity);
        let with_unit = |words: String| format!("{words} {unit}").trim_end().to_owned();
        let row = Answer::new(Name::InputFound, quantity, unit, Some(here.value));
        let given = format!("{} = {}", self.inputs(), with_unit(rounded(here.value)));
        let figure = format!("{} is {} {}", here.row.label, rounded(here.figure), here.row.unit);
        let figure = figure.trim_end();
        match error {
            Some(error) if error <= POOR => {
                let bar = format!(" ± {}", percent(error));
                let bar = if error < GOOD.1 { "" } else { &bar };
                let text = format!("With {given}{bar}, {figure}.");
                (row.bar(Bar::Relative(error)), text)
            }
            Some(error) => {
                let [least, most] = self.find.between;
                let ends = [-error, error]
                    .map(|by| here.value * by.exp())
                    .map(|end| end.clamp(least, most));
                let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
                let range = with_unit(format!("{} to {}", rounded(low), rounded(high)));
                let better = self.better(here).unwrap_or_default();
                let text =
                    format!("{figure} with {given}, but tells it poorly: from {range}{better}.");
                let row = row.not_known("the figure hardly depends on the input");
                (Answer { at_least: Some(low), at_most: Some(high), ..row }, text)
            }
            None => {
                let reason = here.row.reason.clone();
                let reason =
                    reason.unwrap_or_else(|| "the figure does not bend or rise here".to_owned());
                let text = format!("With {given}, {figure}; no ± of it: {reason}.");
                (row.bar(Bar::none(reason)), text)
            }
        }
    }

    /// Returns which other figure would tell the input best, in words.
    fn better(&self, here: &Look) -> Option<String> {
        let there = *self.beside(here.value).first()?;
        let others = here.rows.iter().filter(|row| !row.is(self.find.figure));
        let told = others.filter_map(|row| {
            let bar = row.error.bound().filter(|bar| *bar > 0.0)?;
            let of = |look: &Look| look.rows.iter().find(|other| other.is_alike(row))?.value;
            // No figure tells it better than it scatters.
            Some((bar.max(GOOD.2) / between((here, there), of)?.abs(), row))
        });
        let (error, row) = told.min_by(|one, other| one.0.total_cmp(&other.0))?;
        let label = &row.label;
        (error < POOR).then(|| format!("; {label} would tell it to ± {}", percent(error)))
    }

    fn looks(mut self) -> Looks {
        self.looks.sort_by(|one, other| one.value.total_cmp(&other.value));
        Looks {
            value: self.looks.iter().map(|look| look.value).collect(),
            figure: self.looks.iter().map(|look| look.figure).collect(),
            error: self.looks.iter().map(|look| look.row.error.bound()).collect(),
        }
    }
}

/// Returns the elasticity of a figure between two looks.
fn between((here, there): (&Look, &Look), of: impl Fn(&Look) -> Option<f64>) -> Option<f64> {
    elasticity([here.value, there.value], [of(here)?, of(there)?])
}
