//! The small meshes that tell a contact stiffness, and what they take.

use crate::job::{Analysis, Job};

/// Elements over the half-width of the small meshes, and cells over the semi-axes of small grids.
const ELEMENTS: u32 = 12;
const CELLS: u32 = 8;

/// Returns the elements over the half-width of the small meshes of a job, or cells over the
/// semi-axes.
fn small(job: &Job) -> u32 {
    let most = if job.analysis == Analysis::ThreeDimensional { CELLS } else { ELEMENTS };
    job.mesh.elements_per_half_width.min(most)
}

/// Returns [`small`] where the job asks for a contact stiffness.
pub(super) fn of_slopes(job: &Job) -> Option<u32> {
    job.output.contact_stiffness.then(|| small(job))
}

/// Returns what small meshes take of what a mesh of the job's own takes, of memory; nothing where they are not made.
pub(crate) fn of_small_mesh(job: &Job, own: u64) -> u64 {
    let dimensions = if job.analysis == Analysis::ThreeDimensional { 3 } else { 2 };
    let of = |elements: u32| u64::from(elements).pow(dimensions);
    of_slopes(job).map_or(0, |small| own * of(small) / of(job.mesh.elements_per_half_width))
}
