//! A document with computed figures, and what its figures share.

use std::error::Error;

use brinell_solver::job::Job;
use brinell_solver::report::{self, Report, StepReport};
use brinell_solver::solver::Unobserved;
use serde_json::{Value, json};

pub(super) type Computed = Result<String, Box<dyn Error>>;

/// Makes the text of a block from the job that its document shows.
pub(super) type Compute = fn(&Value) -> Computed;

/// A document, and what computes each of its blocks.
pub struct Example {
    pub document: &'static str,
    pub(super) blocks: &'static [(&'static str, Compute)],
}

impl Example {
    /// The document with its figures computed anew.
    pub fn written_anew(&self, text: &str) -> Computed {
        let shown = text.split_once("```json\n").and_then(|(_, after)| after.split_once("```"));
        let job = shown.map_or(Ok(Value::Null), |(job, _)| serde_json::from_str(job))?;
        let mut anew = text.to_owned();
        for (name, compute) in self.blocks {
            let begin = format!("<!-- computed: {name} -->\n");
            let (before, after) = anew.split_once(&begin).ok_or(format!("{begin} is missing"))?;
            let (_, after) = after.split_once("<!-- end -->").ok_or("a block has no end")?;
            anew = [before, &begin, &compute(&job)?, "<!-- end -->", after].concat();
        }
        Ok(anew)
    }
}

/// A job that is shipped.
pub(super) fn shipped(name: &str) -> Result<Value, Box<dyn Error>> {
    let path = format!("{}/../api/examples/{name}.json", env!("CARGO_MANIFEST_DIR"));
    Ok(serde_json::from_str(&std::fs::read_to_string(path)?)?)
}

pub(super) fn solve(job: &Value) -> Result<Report, Box<dyn Error>> {
    Ok(report::run(&Job::from_value(job)?, &mut Unobserved)?)
}

/// The report under each of these forces in turn, and after each is taken away.
pub(super) fn pressed(job: &Value, force: f64) -> Result<[StepReport; 2], Box<dyn Error>> {
    let mut job = job.clone();
    job["load"] = json!({"history": [{"force": force}, {"force": 0}]});
    let steps = <[StepReport; 2]>::try_from(solve(&job)?.steps);
    steps.map_err(|_| "a force and no force are two steps".into())
}

/// A figure of a step by its name.
pub(super) fn answer(step: &StepReport, name: &str) -> Result<f64, Box<dyn Error>> {
    let found = step.answers.iter().find(|answer| answer.name == name);
    found.and_then(|answer| answer.value).ok_or_else(|| format!("no {name}").into())
}

/// Hertz's peak pressure [MPa].
pub(super) fn hertz(step: &StepReport) -> Result<f64, Box<dyn Error>> {
    let found = step.answers.iter().find(|answer| answer.name == "peak_pressure");
    found.and_then(|answer| answer.elastic).ok_or_else(|| "no closed form".into())
}
