//! The input with which a figure is as wanted, how sure it is, and which figure would tell it
//! better.

use super::document::{FoundReport, Looks};
use super::search::{self, Point};
use super::trials::{Trials, rows, words};
use crate::job::{Domain, FieldError, Find, Job, JobError, Named as _, Quantity, Wanted};
use crate::report::answers::Bar;
use crate::report::{Answer, Name, Report, RunError};
use crate::units::{percent, rounded};

/// Part of a bar within which a figure is as wanted, and its limits. Figures scatter by 1e-6 to
/// 1e-3 from one input to the next (`docs/notes/find.md`).
const GOOD: (f64, f64, f64) = (0.1, 1e-5, 1e-3);
/// A bar in place of one that is not bounded.
const NO_BAR: f64 = 0.01;
/// Largest logarithm of a figure over its wanted value that a secant takes at its word.
const FAR: f64 = 3.0;
/// Differences of the logarithm of the input by which an elasticity is told: at least, so that
/// scatter does not tell it, and at most; and the step of a look that is made for it.
const NEIGHBOUR: (f64, f64, f64) = (0.01, 0.1, 0.02);
/// Relative error from which on both ends are told in place of a value.
const POOR: f64 = 0.25;
/// Least elasticity of a figure that tells an input.
const LEAST_ELASTICITY: f64 = 0.01;

/// One solved job.
struct Look {
    value: f64,
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

/// Searches of one job.
struct Seeker<'a, 'b> {
    job: &'a Job,
    find: &'a Find,
    trials: &'a mut Trials<'b>,
    looks: Vec<Look>,
    kept: Option<(f64, Report)>,
}

/// Looks for the input that a job asks for.
///
/// # Errors
/// [`RunError::Input`] where no input between the ends is found, and those of a solve.
pub fn seek(job: &Job, find: &Find, trials: &mut Trials<'_>) -> Result<Sought, RunError> {
    let mut seeker = Seeker { job, find, trials, looks: Vec::new(), kept: None };
    let is_force = matches!(&find.vary[..], [one] if one == "/load/force");
    if let Wanted::Value(value) = find.wanted
        && is_force
        && find.body.is_none()
        && let Some(target) = job.with_target(find.figure, value)
    {
        return seeker.force(target.map_err(|fault| refused("/find/until", words(&fault)))?);
    }
    let ends = find.between.map(|end| seeker.coordinate(end));
    if let Wanted::Value(value) = find.wanted {
        let found = search::crossings(ends, &mut |at| seeker.look(at))?;
        let found = found.ok_or_else(|| seeker.out_of_reach(value))?;
        let values: Vec<f64> = found.iter().map(|point| seeker.value(point.at)).collect();
        let missed = found.first().map_or(0.0, |point| point.off.abs());
        let elasticity = seeker.elasticity(values[0])?;
        let error = |bar: f64| elasticity.map(|slope| (bar + missed) / slope.abs());
        seeker.sought(&values, elasticity, error)
    } else {
        let (found, bend) = search::least(ends, &mut |at| seeker.look(at))?;
        let value = seeker.value(found.at);
        let bent = (bend > 0.0).then_some(bend);
        let error = |bar: f64| bent.map(|bend| (bar * found.off.abs() / bend).sqrt());
        seeker.sought(&[value], None, error)
    }
}

fn refused(pointer: &str, detail: String) -> RunError {
    RunError::Input(vec![FieldError::not_solvable(pointer, detail)])
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

    fn row<'r>(&self, rows: &'r [Answer]) -> Option<&'r Answer> {
        let Find { figure, body, .. } = *self.find;
        rows.iter().find(|row| row.is(figure) && body.is_none_or(|side| row.is_of(side)))
    }

    fn figure(&self, look: &Look) -> f64 {
        self.row(&look.rows).and_then(|row| row.value).unwrap_or_default()
    }

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
        let look = Look { value, rows: rows(&report) };
        let label = self.find.figure.label();
        let Some((figure, row)) = self.row(&look.rows).and_then(|row| Some((row.value?, row)))
        else {
            return Err(with(if look.rows.is_empty() {
                "the job does not converge".to_owned()
            } else {
                format!("{label:?} is no figure of this job, or is not known")
            }));
        };
        let (part, least, most) = GOOD;
        let good = (part * row.error.bound().unwrap_or(NO_BAR)).clamp(least, most);
        let off = match self.find.wanted {
            Wanted::Value(wanted) if figure / wanted > 0.0 => {
                (figure / wanted).ln().clamp(-FAR, FAR)
            }
            Wanted::Value(_) => -FAR,
            wanted => {
                let scale = self.looks.first().map_or(figure, |first| self.figure(first)).abs();
                if wanted == Wanted::Least { figure / scale } else { -figure / scale }
            }
        };
        let point = Point { at: self.coordinate(value), off, good };
        let is_wanted = off.abs() <= good;
        let is_best = || {
            let best = |kept: &f64| self.looked(*kept);
            let before = self.kept.as_ref().and_then(|(kept, _)| best(kept));
            let sign = if self.find.wanted == Wanted::Most { -1.0 } else { 1.0 };
            before.is_none_or(|before| sign * figure < sign * self.figure(before))
        };
        if is_wanted || !matches!(self.find.wanted, Wanted::Value(_)) && is_best() {
            self.kept = Some((value, report));
        }
        self.looks.push(look);
        Ok(point)
    }

    /// Returns the elasticity of the figure at a value, by the nearest look that is far enough.
    fn elasticity(&mut self, value: f64) -> Result<Option<f64>, RunError> {
        let (_, far, step) = NEIGHBOUR;
        if value == 0.0 {
            return Ok(None);
        }
        if self.neighbour(value).is_none_or(|at| distance(self.looks[at].value, value) > far) {
            let [low, high] = self.find.between;
            let beside = [1.0 + step, 1.0 - step].map(|part| part * value);
            if let Some(beside) = beside.into_iter().find(|one| (low..=high).contains(one)) {
                let kept = self.kept.take();
                self.look(self.coordinate(beside))?;
                self.kept = kept;
            }
        }
        Ok(self.pair(value).and_then(|[here, there]| {
            let of = |look: &Look| Some(self.figure(look));
            elasticity([here, there], of)
        }))
    }

    fn neighbour(&self, value: f64) -> Option<usize> {
        let far = |at: &usize| distance(self.looks[*at].value, value);
        let all = 0..self.looks.len();
        let beside = all.filter(|at| far(at) >= NEIGHBOUR.0 && far(at).is_finite());
        beside.min_by(|one, other| far(one).total_cmp(&far(other)))
    }

    /// Returns the look at a value and its neighbour.
    fn pair(&self, value: f64) -> Option<[&Look; 2]> {
        let here = self.looked(value)?;
        Some([here, &self.looks[self.neighbour(value)?]])
    }

    /// Returns the refusal of a figure that neither the ends nor the places between them reach.
    fn out_of_reach(&self, wanted: f64) -> RunError {
        let label = self.find.figure.label();
        let of = |look: &Look| format!("{} with {}", rounded(self.figure(look)), look.value);
        let figures = self.looks.iter().map(|look| self.figure(look));
        let range = figures.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], one| {
            [low.min(one), high.max(one)]
        });
        let detail = format!(
            "{label} is {} and {}, and between {} and {} at three values between them: nowhere {}",
            of(&self.looks[0]),
            of(&self.looks[1]),
            rounded(range[0]),
            rounded(range[1]),
            rounded(wanted)
        );
        refused(&format!("/find/until/{}", self.find.figure.name()), detail)
    }

    /// Finds a force by the search along the loads of bodies.
    fn force(mut self, target: Job) -> Result<Sought, RunError> {
        let report = self.trials.solve(target)?;
        let of_target = rows(&report);
        let found = of_target.iter().find(|row| row.is(Name::ForceFound));
        let Some((found, value)) = found.and_then(|row| Some((row, row.value?))) else {
            return Err(refused("/find", "the job does not converge".to_owned()));
        };
        let [low, high] = self.find.between;
        if !(low..=high).contains(&value) {
            let detail =
                format!("the force is {}, which is not between these ends", rounded(value));
            return Err(refused("/find/between", detail));
        }
        let slope = of_target.iter().find(|row| row.is(Name::ForceSensitivity));
        let (slope, bar) = (slope.and_then(|row| row.value), found.error.bound());
        self.looks.push(Look { value, rows: of_target });
        self.kept = Some((value, report));
        self.sought(&[value], slope, |_| bar)
    }

    /// Returns the answer of a search whose first value is found.
    fn sought(
        mut self,
        values: &[f64],
        elasticity: Option<f64>,
        error: impl Fn(f64) -> Option<f64>,
    ) -> Result<Sought, RunError> {
        let value = values[0];
        let fault = |fault: JobError| refused("/find", words(&fault));
        let job = self.job.varied(&self.find.vary, value).map_err(fault)?;
        let here = self.looked(value);
        let row = here.and_then(|look| self.row(&look.rows)).cloned();
        let bar = row.as_ref().and_then(|row| row.error.bound());
        let error = bar.and_then(&error).filter(|error| error.is_finite());
        let domain = self.job.domain_at(&self.find.vary[0]);
        let quantity = domain.map_or(Quantity::Number, Domain::quantity);
        let unit = self.job.units.symbol(quantity);
        let told = format!("{} {unit}", rounded(value)).trim_end().to_owned();
        let found = Answer::new(Name::InputFound, quantity, unit, Some(value));
        let input = self.inputs();
        let reached = row.as_ref().map_or_else(String::new, |row| {
            format!("{} is {} {}", row.label, rounded(row.value.unwrap_or_default()), row.unit)
        });
        let reached = reached.trim_end();
        let (found, text) = match error {
            Some(error) if error <= POOR => {
                let text = format!("With {input} = {told} ± {}, {reached}.", percent(error));
                (found.bar(Bar::Relative(error)), text)
            }
            Some(error) => {
                let [low, high] = [-error, error].map(|by| value * by.exp());
                let better = self.better(value);
                let text = format!(
                    "{reached} with {input} = {told}, but tells it poorly: from {} to {} {unit}{}.",
                    rounded(low),
                    rounded(high),
                    better.map(|better| format!("; {better}")).unwrap_or_default()
                );
                let reason = "the figure hardly depends on the input";
                let found = found.not_known(reason);
                (Answer { at_least: Some(low), at_most: Some(high), ..found }, text)
            }
            None => {
                let reason = match (&row, bar) {
                    (_, Some(_)) => "the figure does not bend or rise here".to_owned(),
                    (Some(row), None) => row.reason.clone().unwrap_or_default(),
                    (None, None) => String::new(),
                };
                let text = format!("With {input} = {told}, {reached}; no ± of it: {reason}.");
                (found.bar(Bar::none(reason)), text)
            }
        };
        let also: Vec<_> = values.iter().skip(1).map(|value| rounded(*value)).collect();
        let also = if also.is_empty() {
            String::new()
        } else {
            format!(" Also with {}.", also.join(", "))
        };
        let text = format!("{text}{also}");
        let slope = elasticity.map(|slope| {
            Answer::new(Name::InputElasticity, Quantity::Number, "", Some(slope)).detail()
        });
        let answers = [found.text(text.clone())].into_iter().chain(slope).collect();
        let report = self.kept.take().filter(|(kept, _)| kept.total_cmp(&value).is_eq());
        let (vary, figure) = (self.find.vary.clone(), self.find.figure.name().to_owned());
        let found =
            FoundReport { vary, figure, values: values.to_vec(), looks: self.looks(), text };
        Ok(Sought { job, report: report.map(|(_, report)| report), answers, found })
    }

    fn looks(mut self) -> Looks {
        self.looks.sort_by(|one, other| one.value.total_cmp(&other.value));
        let error = |look: &Look| self.row(&look.rows).and_then(|row| row.error.bound());
        Looks {
            value: self.looks.iter().map(|look| look.value).collect(),
            figure: self.looks.iter().map(|look| self.figure(look)).collect(),
            error: self.looks.iter().map(error).collect(),
        }
    }

    /// Returns which other figure would tell the input best, in words.
    fn better(&self, value: f64) -> Option<String> {
        let [here, there] = self.pair(value)?;
        let others = here.rows.iter().filter(|row| !row.is(self.find.figure));
        let told = others.filter_map(|row| {
            let bar = row.error.bound().filter(|bar| *bar > 0.0)?;
            let of = |look: &Look| look.rows.iter().find(|other| other.is_alike(row))?.value;
            let slope = elasticity([here, there], of)?.abs();
            (slope >= LEAST_ELASTICITY).then_some((bar / slope, row))
        });
        let (error, row) = told.min_by(|one, other| one.0.total_cmp(&other.0))?;
        let label = &row.label;
        (error < POOR).then(|| format!("{label} would tell it to ± {}", percent(error)))
    }
}

/// Returns the distance of two values of one sign as a logarithm.
fn distance(one: f64, other: f64) -> f64 {
    (one / other).ln().abs()
}

/// Returns the relative change of a figure over that of the input.
fn elasticity([here, there]: [&Look; 2], of: impl Fn(&Look) -> Option<f64>) -> Option<f64> {
    let slope = (of(there)? / of(here)?).ln() / (there.value / here.value).ln();
    slope.is_finite().then_some(slope)
}
