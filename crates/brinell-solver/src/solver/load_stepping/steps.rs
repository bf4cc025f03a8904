//! Who takes the steps of a solution.

use crate::solver::Observer;
use crate::solver::solution::StepSolution;

/// Takes the steps of a solution, each as soon as it is finished.
pub trait StepReceiver {
    /// Takes the next step.
    fn step(&mut self, step: StepSolution, observer: &mut dyn Observer);

    /// Gives up the steps so far: a history begins anew, because its contact has grown beyond the mesh. Loads that do not
    /// depend on those before never do.
    fn begin_anew(&mut self);
}

/// Keeps them.
impl StepReceiver for Vec<StepSolution> {
    fn step(&mut self, step: StepSolution, _: &mut dyn Observer) {
        self.push(step);
    }

    fn begin_anew(&mut self) {
        self.clear();
    }
}
