//! Why a job has no report.

use thiserror::Error;

use super::findings::{CONFORMING_ADVICE, guesses};
use super::solve_error;
use super::target;
use super::validity::lies_in_groove;
use crate::contact::ContactError;
use crate::fem::mesh::MeshError;
use crate::inputs::SolveError::{self, HalfSpaces, Meshed, Track};
use crate::job::{FieldError, Job, Load, Material, Named as _, Shape};
use crate::solver::half_spaces::HalfSpaceError;
use crate::solver::method;
use crate::solver::rolling::TrackError;
use crate::solver::{Interrupt, MeshedError};
use crate::units::UnitConverter;
use brinell_halfspace::track::TrackFault;

/// Reasons for a job without a report.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RunError {
    /// The job is well formed but describes a contact that the theory does not cover.
    #[error("{}", summary(.0))]
    Input(Vec<FieldError>),
    /// The observer stopped the job before the first report.
    #[error("stopped before the first iteration")]
    Interrupted(Interrupt),
    /// The solver failed.
    #[error("{0}")]
    Failed(String),
}

fn summary(errors: &[FieldError]) -> String {
    errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

impl RunError {
    /// Returns the error of a job, names the fields that cause it, and says what in the job is
    /// probably not meant.
    pub(super) fn of(job: &Job, error: &SolveError) -> Self {
        let sides = [("upper", &job.upper), ("lower", &job.lower)];
        // Surfaces given by points: of deformable bodies or of all bodies.
        let faces = |deformable: bool| -> Vec<String> {
            let faces = sides.iter().filter(|(_, body)| {
                let is_rigid = matches!(body.material, Material::Rigid);
                matches!(body.shape, Shape::Profile(_)) && !(deformable && is_rigid)
            });
            faces.map(|(side, _)| format!("/{side}/shape/points")).collect()
        };
        let sought = || match &job.load {
            Load::Target(target) => format!("/load/target/{}", target.figure.name()),
            _ => "/load/onset".to_owned(),
        };
        let pointers = match error {
            error if error.method().is_some() => match error.method() {
                Some(method::Error::Interrupted(interrupt)) => {
                    return Self::Interrupted(*interrupt);
                }
                Some(method::Error::NoLoad) => vec![format!("/load/{}", job.load.kind())],
                Some(method::Error::Unreachable(_)) => vec![sought()],
                _ => Vec::new(),
            },
            Meshed(
                MeshedError::TooWide { .. }
                | MeshedError::TooFarRound { .. }
                | MeshedError::Mesh(MeshError::ZoneBeyondBody { .. }),
            ) => vec!["/load".to_owned()],
            HalfSpaces(HalfSpaceError::Overloaded { .. }) => {
                vec![format!("/load/{}", job.load.kind())]
            }
            HalfSpaces(HalfSpaceError::ShortRoller { .. }) => {
                let rollers =
                    sides.iter().filter(|(_, body)| matches!(body.shape, Shape::Roller(_)));
                rollers.map(|(side, _)| format!("/{side}/shape/length")).collect()
            }
            Meshed(MeshedError::NoYieldPoint) | HalfSpaces(HalfSpaceError::NoYieldPoint) => {
                vec![sought()]
            }
            Track(TrackError::Track(TrackFault::Traction { .. })) => {
                vec!["/load/rolling/friction".to_owned()]
            }
            Track(TrackError::NoTrack | TrackError::NoRaceway(_))
            | Meshed(MeshedError::Conforming { .. } | MeshedError::TouchesAtEnd { .. }) => {
                sides.map(|(side, _)| format!("/{side}/shape")).to_vec()
            }
            Meshed(MeshedError::AmbiguousCorner { side, .. }) => {
                let side = if *side == 0 { "upper" } else { "lower" };
                vec![format!("/{side}/shape/interpolation")]
            }
            Meshed(MeshedError::TraceTooFine { .. }) => {
                let radii = sides.iter().filter_map(|(side, body)| match body.shape {
                    Shape::Punch(_) => Some(format!("/{side}/shape/edge_radius")),
                    Shape::Wedge(_) | Shape::Cone(_) => Some(format!("/{side}/shape/tip_radius")),
                    _ => None,
                });
                faces(false).into_iter().chain(radii).collect()
            }
            Meshed(MeshedError::Mesh(MeshError::TooSteep { .. })) => faces(true),
            _ => Vec::new(),
        };
        let write = UnitConverter::new(job.units, job.analysis);
        let detail = match error {
            Meshed(MeshedError::TooWide { .. } | MeshedError::Conforming { .. })
                if lies_in_groove(job) =>
            {
                format!("{}; {CONFORMING_ADVICE}", solve_error::text(error, write))
            }
            error => match error.method() {
                Some(method::Error::Unreachable(found)) => {
                    target::unreachable(found, &job.load, write)
                }
                // The author of the job cannot act on errors from inside the contact solver.
                Some(method::Error::Contact(
                    ContactError::NotPositiveDefinite { .. }
                    | ContactError::NoEnergy { .. }
                    | ContactError::Ray { .. }
                    | ContactError::IllConditioned { .. },
                )) => {
                    "rounding leaves the contact without an answer: lengths, stiffness and load \
                       of the job differ by too many orders of magnitude for numbers of double \
                       precision"
                        .to_owned()
                }
                _ => solve_error::text(error, write),
            },
        };
        let guesses = guesses(job).into_iter().map(|guess| guess.text(write));
        let detail = guesses.fold(detail, |detail, guess| format!("{detail}. {guess}"));
        if pointers.is_empty() {
            return Self::Failed(detail);
        }
        Self::Input(
            pointers
                .into_iter()
                .map(|pointer| FieldError::not_solvable(pointer, detail.clone()))
                .collect(),
        )
    }
}
