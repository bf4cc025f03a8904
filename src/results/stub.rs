//! TEMPORARY STUB, replaced at merge: `run` and `preflight` with plausible figures instead of mechanics.

use std::ops::ControlFlow;

use serde::Serialize;
use thiserror::Error;

#[allow(clippy::wildcard_imports)]
use super::*;
use crate::model::{FieldError, Job};
use crate::solve::{Interrupt, IterationRecord, Observer, SolveStatus};

/// Why a job gave no report.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum RunError {
    /// The job is well formed and physically impossible.
    #[error("{} field(s) at fault", .0.len())]
    Input(Vec<FieldError>),
    /// Anything else.
    #[error("{0}")]
    Failed(String),
}

/// What a job will cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct JobEstimate {
    /// Equations of both bodies.
    pub equations: usize,
    /// Peak memory.
    pub bytes: u64,
}

/// Estimates the cost of a job.
///
/// # Errors
/// Every field that makes the job impossible.
pub fn preflight(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    let n = job.mesh.elements_per_half_width as usize;
    Ok(JobEstimate { equations: 80 * n * n, bytes: 80 * (n as u64).pow(2) * 1200 })
}

/// Runs a job.
///
/// # Errors
/// [`RunError`].
pub fn run(job: &Job, observer: &mut dyn Observer) -> Result<Report, RunError> {
    let mut history = Vec::new();
    let mut status = SolveStatus::Converged;
    for iteration in 1..=14 {
        let change = 0.2_f64.powi(iteration);
        let record = IterationRecord {
            iteration: iteration.unsigned_abs() as usize,
            contact_pivots: if iteration == 1 { 36 } else { 2 },
            initial_stress_updates: 1,
            factorizations: usize::from(iteration == 1),
            displacement_change: change,
            force_change: 0.5 * change,
            equilibrium_residual: 0.7 * change,
            plastic_points: 812,
            contact_pairs: 29,
            approach: 0.017_919 * (1.0 - change),
            peak_pressure: 1182.6 * (1.0 + change),
            elapsed_ms: observer.elapsed().as_secs_f64() * 1e3,
        };
        let flow = observer.on_iteration(&record);
        history.push(record);
        if let ControlFlow::Break(interrupt) = flow {
            status = match interrupt {
                Interrupt::Cancelled => SolveStatus::Cancelled,
                Interrupt::TimedOut => SolveStatus::TimedOut,
            };
            break;
        }
        if iteration.unsigned_abs() >= job.solver.max_iterations {
            status = SolveStatus::NotConverged;
            break;
        }
    }
    Ok(report(job, status, history))
}

fn report(job: &Job, status: SolveStatus, history: Vec<IterationRecord>) -> Report {
    let x: Vec<f64> = (-35..=35).map(|i| f64::from(i) * 0.013).collect();
    let pressure: Vec<f64> =
        x.iter().map(|x| 1182.6 * (1.0 - (x / 0.37).powi(2)).max(0.0).sqrt().powf(0.7)).collect();
    let plastic = PlasticityReport {
        yielded: true,
        max_equivalent_plastic_strain: 0.0063,
        position: 0.0,
        depth: 0.21,
        area: 0.31,
    };
    Report {
        units: job.units.name().into(),
        analysis: "plane_strain".into(),
        status,
        steps: vec![StepReport {
            load: LoadReport::Force(612.6106),
            status,
            approach: 0.017_919,
            approach_datum: "diametral planes".into(),
            contact: ContactReport {
                force: 612.6106,
                half_width: 0.37,
                peak_pressure: 1182.6,
                peak_position: 0.0,
                mean_pressure: 828.0,
                nodes: ContactNodes {
                    force: pressure.iter().map(|p| p * 0.013).collect(),
                    gap: vec![0.0; x.len()],
                    x,
                    pressure,
                },
            },
            subsurface: None,
            plasticity: PerBody { upper: Some(plastic.clone()), lower: Some(plastic) },
            hertz: Some(HertzReport {
                half_width: 0.26,
                peak_pressure: 1500.0,
                yield_onset_force: Some(218.2),
            }),
            validity: vec![ValidityNote {
                code: "deformation_theory".into(),
                message: "deformation theory is stretched: the load path is not proportional".into(),
            }],
            estimated_error: Some(ErrorEstimate { peak_pressure: 0.002, half_width: 0.01, approach: 0.0004 }),
            history,
        }],
        mesh: MeshReport {
            symmetric: true,
            spacing: 0.013,
            contact_pairs: 36,
            nodes: 4000,
            elements: 3900,
            equations: 7900,
            passes: 2,
            enlargements: 0,
            min_jacobian_ratio: 0.4,
            max_aspect_ratio: 4.0,
        },
        timings_ms: Timings { total: 40.0, numeric: 12.0, ordering: 3.0, ..Timings::default() },
        tags: job.tags.clone(),
        version: env!("CARGO_PKG_VERSION").into(),
    }
}
