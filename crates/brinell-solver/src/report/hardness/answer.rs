//! The number of a hardness test among the answers of its steps.

use super::HardnessSeen;
use crate::job::{Job, Quantity, TestScale};
use crate::report::{Answer, StepReport};
use crate::units::{UnitConverter, about, percent};

impl StepReport {
    /// Adds the hardness that the loads so far have found: the first answer, and the first sentence
    /// of the verdict.
    pub(in crate::report) fn with_hardness(
        mut self,
        job: &Job,
        seen: &HardnessSeen,
        write: UnitConverter,
    ) -> Self {
        let Some(test) = job.load.hardness() else { return self };
        let Some(found) = seen.clone().finish(job, write) else { return self };
        let (value, quantity, unit) = match (found.number, test.scale) {
            (Some(number), _) => (number, Quantity::Number, ""),
            (None, TestScale::Berkovich | TestScale::Sphere) => {
                let unit = job.units.symbol(Quantity::Stress);
                (found.mean_pressure, Quantity::Stress, unit)
            }
            (None, _) => return self,
        };
        if let Some(verdict) = &mut self.verdict {
            let space = if unit.is_empty() { "" } else { " " };
            let points = || found.number_error.map(|points| format!(" ± {}", about(points)));
            let bar = found.relative_error.map(|part| format!(" ± {}", percent(part)));
            let bar = bar.or_else(points);
            let (value, bar) = (about(value), bar.unwrap_or_default());
            verdict.text = format!("{}: {value}{space}{unit}{bar}. {}", found.test, verdict.text);
        }
        let beside = |bias: f64| {
            let side = if bias < 0.0 { "below" } else { "above" };
            format!("its mean pressure is {} {side} that with large strains", percent(bias.abs()))
        };
        let points = found.number_error.filter(|_| found.relative_error.is_none());
        self.answers.insert(
            0,
            Answer {
                name: "hardness".to_owned(),
                label: found.test,
                body: None,
                value: Some(value),
                quantity,
                unit: unit.to_owned(),
                error: found.relative_error,
                at_least: points.map(|points| value - points),
                at_most: points.map(|points| value + points),
                elastic: None,
                place: None,
                text: {
                    let points = points.map(|points| format!("± {} points", about(points)));
                    let clauses = points.into_iter().chain(found.bias.map(beside));
                    clauses.collect::<Vec<_>>().join("; ")
                },
            },
        );
        self
    }
}
