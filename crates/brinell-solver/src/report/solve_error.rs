//! Errors of a solve as sentences in the units of a job.

use brinell_halfspace::track::{DEEPEST, TrackFault};

use crate::fem::mesh::{MESHED_SLOPE, MeshError};
use crate::inputs::SolveError;
use crate::solver::half_spaces::HalfSpaceError;
use crate::solver::method::Limit;
use crate::solver::rolling::TrackError;
use crate::solver::{MAX_HALF_ANGLE, MeshedError};
use crate::units::{UnitConverter, about};

/// Returns an error as a sentence in the units of a job.
pub(super) fn text(error: &SolveError, write: UnitConverter) -> String {
    match error {
        SolveError::Meshed(error) => meshed_text(error, write),
        SolveError::HalfSpaces(HalfSpaceError::ShortRoller { length: whole, least }) => format!(
            "the roller is {} long, but under this load no grid holds its contact below a \
             length of {}: reduce the load or its moment, or give the length that touches",
            write.length_about(*whole),
            write.length_about(*least)
        ),
        SolveError::Track(TrackError::Track(fault)) => track_text(fault, write),
        other => other.to_string(),
    }
}

/// Returns an error of meshed bodies as a sentence in the units of a job.
fn meshed_text(error: &MeshedError, write: UnitConverter) -> String {
    let length = |core: f64| write.length_text(core);
    match error {
        MeshedError::Mesh(error) => mesh_text(error, write),
        MeshedError::TooWide { half_width, available } => format!(
            "the contact would reach about {} to each side on a surface that spans {}; \
             small-displacement contact theory does not carry that far: reduce the load",
            length(*half_width),
            length(*available)
        ),
        MeshedError::TooFarRound { half_angle } => format!(
            "the contact would reach about {half_angle:.0}° to each side; a contact in a hole \
             is solved up to {MAX_HALF_ANGLE}°: reduce the load, or widen the clearance"
        ),
        MeshedError::Conforming { limit } => format!(
            "the surfaces do not open within {} of where they first touch, half of the way to \
             their ends, so that no load makes a contact that ends there: make the surfaces \
             wider if they open beyond",
            length(*limit)
        ),
        MeshedError::TouchesAtEnd { x, left, right } => format!(
            "the surfaces first touch at x = {}, but contacts are solved from {} to {}, a \
             fifth short of the ends of the surfaces: make them wider, or move what touches \
             towards the middle",
            length(*x),
            length(*left),
            length(*right)
        ),
        MeshedError::TraceTooFine { half_width, spacing, finest } => format!(
            "within the contact, of half-width {}, the surfaces have details that only \
             elements of {} resolve, but {} is the finest that is solved: give the surface \
             with fewer points, smooth its trace, or leave out a radius that is so much \
             smaller than the contact",
            length(*half_width),
            write.length_about(*spacing),
            write.length_about(*finest)
        ),
        MeshedError::AmbiguousCorner { x, opening, .. } => format!(
            "the face turns by {} at the point x = {} of a profile, within the contact: set \
             its `interpolation` to \"linear\" if this is a corner, to \"smooth\" if it is to \
             be rounded off",
            about(*opening),
            length(*x)
        ),
        other => other.to_string(),
    }
}

/// Returns why a track has no answer as a sentence in the units of a job.
pub(super) fn track_text(fault: &TrackFault, write: UnitConverter) -> String {
    match *fault {
        TrackFault::Traction { traction, strength } => format!(
            "friction asks for a shear stress of {} at the surface under Hertz's peak pressure, where \
             the material bears {} at most, after all hardening: give a smaller friction or force",
            write.stress_about(traction),
            write.stress_about(strength)
        ),
        TrackFault::Deep { peak, yield_stress, force } => format!(
            "Hertz's peak of {} is {} times the yield stress of {}: passes are solved up to \
             {DEEPEST} times, which is a force of {}",
            write.stress_about(peak),
            about(peak / yield_stress),
            write.stress_about(yield_stress),
            write.force_text(force)
        ),
        TrackFault::Window { width } => format!(
            "the contact reaches the end of the {} in which the bodies may touch",
            write.length_about(width)
        ),
        TrackFault::Edge { half_width } => format!(
            "contact or yield reaches the edge of the track, {} from its axis",
            write.length_about(half_width)
        ),
        TrackFault::Far { part, length } => format!(
            "{} % of the plastic flow is at the ends of a track of {}, far from the load: give a \
             longer `load.rolling.track`",
            about(100.0 * part),
            write.length_about(length)
        ),
        TrackFault::BeyondYield { excess } => format!(
            "its residual stress exceeds the yield stress by {} %: more columns \
             (`mesh.elements_per_half_width`) or fewer passes may have an answer",
            about(100.0 * excess)
        ),
        TrackFault::Energy { gap } => format!(
            "{} % of the plastic work is missing in its balance of energy: more columns \
             (`mesh.elements_per_half_width`) or a smaller load may have an answer",
            about(100.0 * gap)
        ),
        TrackFault::Depth { depth } => format!(
            "the material yields down to a depth of {}, where the layers end",
            write.length_about(depth)
        ),
    }
}

/// Returns an error of the mesh as a sentence in the units of a job.
fn mesh_text(error: &MeshError, write: UnitConverter) -> String {
    match *error {
        MeshError::ZoneBeyondBody { half_width, available } => {
            limit_text(&Limit::NoRoom { half_width, available }, write)
        }
        MeshError::TooSteep { x, slope } => limit_text(&Limit::TooSteep { x, slope }, write),
        MeshError::Inverted { .. } => error.to_string(),
    }
}

/// Returns why larger forces are not solved in the units of a job.
pub(super) fn limit_text(limit: &Limit, write: UnitConverter) -> String {
    match limit {
        Limit::NoRoom { half_width, available } => format!(
            "a contact zone of half-width {} does not fit on a surface that spans {}",
            write.length_text(*half_width),
            write.length_text(*available)
        ),
        Limit::TooSteep { x, slope } => format!(
            "the face has a slope of {slope:.2} at x = {}; a body that deforms is meshed up to \
             slopes of about {MESHED_SLOPE}, and contact theory with small displacements is not \
             meant for steeper ones",
            write.length_text(*x)
        ),
        Limit::Other(reason) => reason.clone(),
    }
}
