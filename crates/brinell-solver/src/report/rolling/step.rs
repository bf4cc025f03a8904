//! The report of a load that rolls.

use brinell_halfspace::track::Verdict;

use super::document::{
    BodyPassErrorReport, BodyPassReport, PassErrorReport, PassReport, ResidualReport,
    RollingReport, TrackLimitReport, TrackLimitsReport, TrackVerdict,
};
use super::findings::findings;
use crate::job::Job;
use crate::report::answers::Measured;
use crate::report::build::{hertz, in_units, over_friction};
use crate::report::validity;
use crate::report::{
    ContactNodes, ContactReport, ErrorEstimate, LoadReport, Patch, PerBody, Side, StepReport,
};
use crate::solver::rolling::{
    BodyPass, BodyPassErrors, Limit, Pass, PassErrors, RollingProblem, RollingSolution,
};
use crate::solver::{ElasticReference, SolveStatus};
use crate::units::UnitConverter;

/// What an approach would be counted between, had a line contact that rolls one.
const DATUM: &str = "none: how far half-planes approach under a line load depends on where that is \
                     counted from";

/// Writes the report of one job.
pub(super) struct StepWriter<'a> {
    pub job: &'a Job,
    pub write: UnitConverter,
    pub problem: &'a RollingProblem,
    pub solution: &'a RollingSolution,
}

impl StepWriter<'_> {
    /// Returns the report of the step.
    pub fn report(&self) -> StepReport {
        let (job, write, solution) = (self.job, self.write, self.solution);
        let reference = ElasticReference::of(job, self.problem.load.force.get());
        let findings = findings(job, self.problem, solution);
        let report = StepReport {
            verdict: None,
            answers: Vec::new(),
            load: LoadReport::Force(write.force(self.problem.load.force.get())),
            status: solution.status,
            approach: None,
            approach_datum: DATUM.to_owned(),
            contact: self.contact(),
            contact_stiffness: None,
            flow: None,
            subsurface: None,
            subsurface_below_peak: None,
            plasticity: PerBody { upper: None, lower: None },
            hertz: reference
                .as_ref()
                .map(|reference| hertz(reference, &over_friction(job, reference, write), write)),
            yield_onset: None,
            validity: validity::remarks(&findings, write),
            estimated_error: self.estimated_error(),
            fields: None,
            layers: None,
            three_dimensional: None,
            rolling: Some(self.rolling()),
            history: solution.history.iter().map(|record| in_units(record, write)).collect(),
        };
        let first_yield = reference.and_then(|reference| reference.yield_onset_force);
        let measured = Measured { first_yield, ..Measured::default() };
        report.answered(job, &measured, &findings, write)
    }

    fn contact(&self) -> ContactReport {
        let (write, solution, last) = (self.write, self.solution, &self.solution.last);
        let force: f64 = solution.pressure.iter().map(|p| p * solution.column).sum();
        let [left, right] = last.ends.map(|x| write.length(x));
        let touches = last.half_width() > 0.0;
        let mean = if touches { force / (2.0 * last.half_width()) } else { 0.0 };
        let forces = solution.pressure.iter().map(|p| write.force(p * solution.column));
        ContactReport {
            force: write.force(force),
            half_width: write.length(last.half_width()),
            half_angle: None,
            peak_pressure: write.stress(last.peak_pressure),
            peak_position: write.length(last.peak_position),
            mean_pressure: write.stress(mean),
            patches: touches.then_some(Patch { left, right }).into_iter().collect(),
            nodes: ContactNodes {
                x: solution.x.iter().map(|x| write.length(*x)).collect(),
                force: forces.collect(),
                pressure: solution.pressure.iter().map(|p| write.stress(*p)).collect(),
                gap: solution.gap.iter().map(|gap| write.length(*gap)).collect(),
            },
        }
    }

    /// Returns the errors of the contact in the last pass.
    fn estimated_error(&self) -> Option<ErrorEstimate> {
        if self.solution.status != SolveStatus::Converged {
            return None;
        }
        let errors = self.solution.errors.last()?.as_ref()?;
        let last = &self.solution.last;
        Some(ErrorEstimate {
            peak_pressure: relative(errors.peak_pressure, last.peak_pressure),
            half_width: relative(errors.half_width, last.half_width()),
            force: Some(0.0),
            ..ErrorEstimate::default()
        })
    }

    fn rolling(&self) -> RollingReport {
        let (write, solution) = (self.write, self.solution);
        let (side, verdict) = self.verdict();
        let (rate, change) = match verdict {
            Verdict::Elastic | Verdict::ShakesDown { .. } => (Some(0.0), Some(0.0)),
            Verdict::ClosedCycle { strain, bar } => (Some(strain), Some(bar)),
            Verdict::Ratchets { rate, bar } => (Some(rate), Some(bar)),
            Verdict::Undecided { .. } => (None, None),
        };
        let errors = solution.errors.last().and_then(Option::as_ref);
        let errors = errors.and_then(|errors| errors.bodies[side?]);
        let of_columns = match verdict {
            Verdict::ClosedCycle { .. } => errors.map(|errors| errors.largest_strain),
            Verdict::Ratchets { .. } => errors.map(|errors| errors.net_strain),
            _ => Some(0.0),
        };
        let limit = |limit: &Limit| TrackLimitReport {
            peak_pressure: write.stress(limit.peak_pressure),
            depth: write.length(limit.depth),
            body: Side::of(limit.side),
        };
        let [perfect, kinematic] = &solution.limits;
        RollingReport {
            verdict: word(verdict),
            body: side.filter(|_| !self.problem.is_shared()).map(Side::of),
            rate,
            rate_error: change.zip(of_columns).map(|(change, columns)| change + columns),
            reason: self.reason(verdict),
            passes: self.passes(),
            limits: TrackLimitsReport {
                perfect: perfect.as_ref().filter(|limit| limit.peak_pressure > 0.0).map(limit),
                kinematic: kinematic.as_ref().filter(|limit| limit.peak_pressure > 0.0).map(limit),
            },
            residual: PerBody { upper: self.residual(0), lower: self.residual(1) },
            columns: solution.grid[0],
            layers: solution.grid[1],
        }
    }

    /// Returns the worse of both verdicts and the body that has it.
    fn verdict(&self) -> (Option<usize>, Verdict) {
        worst(&self.solution.verdicts)
    }

    /// Returns why the verdict is open, or why the passes end.
    fn reason(&self, verdict: Verdict) -> Option<String> {
        let solution = self.solution;
        let number = solution.passes.len();
        match (solution.status, &solution.fault) {
            (SolveStatus::Converged, _) => {}
            (SolveStatus::NotConverged, Some(fault)) => {
                let fault = crate::solver::track_text(fault, self.write);
                return Some(format!("pass {} has no answer: {fault}", number + 1));
            }
            (SolveStatus::NotConverged, None) => {
                return Some(format!(
                    "pass {} has not converged in {} iterations",
                    number + 1,
                    solution.last.iterations
                ));
            }
            _ => return Some(format!("the job was stopped in pass {}", number + 1)),
        }
        matches!(verdict, Verdict::Undecided { .. }).then(|| {
            let unit = if self.problem.load.alternating { "pairs of passes" } else { "passes" };
            format!(
                "no word has come three times running within {number} passes: a verdict takes at \
                 least ten {unit}, and more near a limit"
            )
        })
    }

    fn passes(&self) -> Vec<PassReport> {
        let passes = self.solution.passes.iter().zip(&self.solution.errors).enumerate();
        passes.map(|(k, (pass, errors))| self.pass(k + 1, pass, errors.as_ref())).collect()
    }

    fn pass(&self, number: usize, pass: &Pass, errors: Option<&PassErrors>) -> PassReport {
        let write = self.write;
        let of_side = |side: usize| {
            let body = pass.bodies[side].as_ref()?;
            Some(body_report(body, write))
        };
        PassReport {
            number,
            iterations: pass.iterations,
            peak_pressure: write.stress(pass.peak_pressure),
            half_width: write.length(pass.half_width()),
            rolling_force: write.force(pass.rolling_force),
            loss: pass.rolling_force / self.problem.load.force.get(),
            plastic_work: write.force(pass.plastic_work()),
            stored_energy: write.force(pass.stored_energy()),
            traction_work: write.force(pass.work_of_traction),
            energy_gap: pass.energy_gap(),
            bodies: PerBody { upper: of_side(0), lower: of_side(1) },
            estimated_error: errors.map(|errors| PassErrorReport {
                peak_pressure: relative(errors.peak_pressure, pass.peak_pressure),
                half_width: relative(errors.half_width, pass.half_width()),
                plastic_work: relative(errors.work, pass.plastic_work()),
                bodies: PerBody {
                    upper: errors_report(pass, errors.bodies, 0),
                    lower: errors_report(pass, errors.bodies, 1),
                },
            }),
        }
    }

    fn residual(&self, side: usize) -> Option<ResidualReport> {
        let write = self.write;
        let passes = || self.solution.passes.iter().filter_map(|pass| pass.bodies[side].as_ref());
        let outlet = &passes().next_back()?.outlet;
        let stress = |k: usize| outlet.residual.iter().map(|s| write.stress(s[k])).collect();
        let accumulated = |layer: usize| passes().map(|body| body.outlet.accumulated[layer]).sum();
        Some(ResidualReport {
            depth: outlet.depths.iter().map(|depth| write.length(*depth)).collect(),
            sigma_x: stress(0),
            sigma_z: stress(1),
            equivalent_plastic_strain: (0..outlet.depths.len()).map(accumulated).collect(),
        })
    }
}

/// Returns the worst verdict and the body that has it; elastic where none can yield.
pub(super) fn worst(verdicts: &[Option<Verdict>; 2]) -> (Option<usize>, Verdict) {
    let bodies = verdicts.iter().enumerate().filter_map(|(side, v)| Some((Some(side), (*v)?)));
    bodies.rev().max_by_key(|(_, verdict)| word(*verdict)).unwrap_or((None, Verdict::Elastic))
}

/// Returns the word of a verdict.
pub(super) const fn word(verdict: Verdict) -> TrackVerdict {
    match verdict {
        Verdict::Elastic => TrackVerdict::Elastic,
        Verdict::ShakesDown { .. } => TrackVerdict::ShakesDown,
        Verdict::ClosedCycle { .. } => TrackVerdict::ClosedCycle,
        Verdict::Undecided { .. } => TrackVerdict::Undecided,
        Verdict::Ratchets { .. } => TrackVerdict::Ratchets,
    }
}

fn body_report(body: &BodyPass, write: UnitConverter) -> BodyPassReport {
    let stresses = |k: usize| body.outlet.residual.iter().map(move |stress| stress[k]);
    let least = |k: usize| write.stress(stresses(k).fold(f64::INFINITY, f64::min));
    let most = |k: usize| write.stress(stresses(k).fold(f64::NEG_INFINITY, f64::max));
    BodyPassReport {
        groove_depth: write.length(body.outlet.groove_depth),
        forward: write.length(body.outlet.forward),
        largest_strain: body.strain.largest.value,
        largest_strain_depth: write.length(body.strain.largest.depth),
        net_strain: body.strain.net.value,
        net_strain_depth: write.length(body.strain.net.depth),
        least_sigma_x: least(0),
        largest_sigma_x: most(0),
        least_sigma_z: least(1),
        largest_sigma_z: most(1),
    }
}

fn errors_report(
    pass: &Pass,
    errors: [Option<BodyPassErrors>; 2],
    side: usize,
) -> Option<BodyPassErrorReport> {
    let (body, errors) = (pass.bodies[side].as_ref()?, errors[side]?);
    let stresses = body.outlet.residual.iter().flatten();
    let largest = stresses.fold(0.0, |most: f64, stress| most.max(stress.abs()));
    Some(BodyPassErrorReport {
        groove_depth: relative(errors.groove_depth, body.outlet.groove_depth),
        forward: relative(errors.forward, body.outlet.forward),
        largest_strain: relative(errors.largest_strain, body.strain.largest.value),
        net_strain: relative(errors.net_strain, body.strain.net.value),
        residual: relative(errors.residual, largest),
    })
}

/// Returns an error relative to its figure; `None` of a figure that is 0.
fn relative(error: f64, figure: f64) -> Option<f64> {
    Some(error / figure.abs()).filter(|error| error.is_finite())
}
