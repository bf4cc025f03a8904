//! The bias of deformation theory in the answers.

use super::answers::{Answer, AnswerBody, Facts};
use crate::job::{Analysis, Load};
use crate::solver::TheoryBias;
use crate::solver::method::figures::Figure;

impl Facts<'_> {
    /// Gives an answer the bias of its figure. A figure without an error bar has no bias: the mesh
    /// does not tell it. One that is prescribed is the same by either theory. A force that was
    /// sought has none: flow theory was solved under it.
    pub(super) fn biased(&self, answer: Answer) -> Answer {
        let (Some(bias), Some(error)) = (&self.measured.bias, answer.error) else { return answer };
        if answer.name == "force" && matches!(self.job.load, Load::Onset | Load::Target(_)) {
            return answer;
        }
        let side = usize::from(answer.body != Some(AnswerBody::Upper));
        let found = if error == 0.0 {
            Some([0.0; 2])
        } else if answer.name == "mean_pressure" {
            Some(self.mean_pressure_bias(bias))
        } else {
            let figure = Figure::ALL.iter().find(|figure| figure.name() == answer.name);
            figure.map(|figure| [&bias.bias, &bias.error].map(|of| of.get(*figure, side)))
        };
        let [bias, bias_error] = found.map_or([None; 2], |found| found.map(Some));
        Answer { bias, bias_error, ..answer }
    }

    /// Returns the bias of the mean pressure, by those of force and contact size, and its error.
    fn mean_pressure_bias(&self, of: &TheoryBias) -> [f64; 2] {
        let power = if self.job.analysis == Analysis::Axisymmetric { 2 } else { 1 };
        let size = 1.0 - of.bias.half_width;
        let ratio = (1.0 - of.bias.force) / size.powi(power);
        let error = of.error.force + f64::from(power) * of.error.half_width / size.abs();
        [1.0 - ratio, ratio.abs() * error]
    }
}
