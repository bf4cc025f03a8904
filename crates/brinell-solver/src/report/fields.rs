//! The mesh fields of a load step, in one frame for both bodies.
//!
//! The solver keeps each body in a frame of its own, with `y` out of the material. The report has
//! the lower body in this frame, and the upper body mirrored in the contact plane:
//!
//! ```text
//! y → -y - g,  u_y → -u_y,  τ_xy → -τ_xy
//! element corners in reverse order (still counter-clockwise)
//! ```
//!
//! where `g` is the smallest gap between the outlines in the coordinates of the job, so that the
//! bodies just touch.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::PerBody;
use crate::analytical::Stress;
use crate::solver::method::observer::ask;
use crate::solver::{BodySolution, Interrupt, Observer, StepSolution, recovered};
use crate::units::UnitConverter;

/// Mesh and nodal fields of one body as it was meshed: one half where `mesh.symmetric` is true.
/// Positions are those before loading, where the bodies just touch; `y` points from the lower body
/// to the upper one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Fields))]
pub struct FieldsReport {
    /// Nodes `[x, y]` \[length\].
    pub nodes: Vec<[f64; 2]>,
    /// Corners of each element, counter-clockwise, counted from 0.
    pub elements: Vec<[u32; 4]>,
    /// Displacements `[u_x, u_y]`, each body relative to its own support \[length\].
    pub displacement: Vec<[f64; 2]>,
    /// Stress along x, or along the radius \[stress\].
    pub sigma_x: Vec<f64>,
    /// Stress along y \[stress\].
    pub sigma_y: Vec<f64>,
    /// Out-of-plane stress, or hoop stress \[stress\].
    pub sigma_z: Vec<f64>,
    /// Shear stress \[stress\].
    pub tau_xy: Vec<f64>,
    /// Von Mises stress \[stress\].
    pub von_mises: Vec<f64>,
    /// Equivalent plastic strain \[1\].
    pub equivalent_plastic_strain: Vec<f64>,
}

/// Returns the fields of both bodies; `None` for a rigid body.
pub(super) fn fields(
    step: &StepSolution,
    write: UnitConverter,
    observer: &mut dyn Observer,
) -> Result<PerBody<Option<FieldsReport>>, Interrupt> {
    let [upper, lower] = &step.field.bodies;
    let mut of = |body: &Option<Arc<BodySolution>>, mirror| {
        let body = body.as_ref();
        body.map(|body| body_fields(body, step, mirror, write, observer)).transpose()
    };
    Ok(PerBody { upper: of(upper, true)?, lower: of(lower, false)? })
}

/// Number of nodes between two calls of the observer, some tens of milliseconds.
const NODES_BETWEEN_CHECKPOINTS: usize = 1 << 15;

fn body_fields(
    body: &BodySolution,
    step: &StepSolution,
    mirror: bool,
    write: UnitConverter,
    observer: &mut dyn Observer,
) -> Result<FieldsReport, Interrupt> {
    ask(observer)?;
    // The addition of zero turns a mirrored -0 into 0.
    let (sign, gap) = if mirror { (-1.0, step.field.smallest_gap) } else { (1.0, 0.0) };
    let global =
        |[x, y]: &[f64; 2], offset| [write.length(*x), write.length(sign * y - offset) + 0.0];
    let mut report = FieldsReport {
        nodes: body.mesh.nodes.iter().map(|node| global(node, gap)).collect(),
        elements: body.mesh.elements.clone(),
        displacement: body.displacement.iter().map(|u| global(u, 0.0)).collect(),
        ..FieldsReport::default()
    };
    if mirror {
        report.elements.iter_mut().for_each(|corners| corners.reverse());
    }
    let mut recovery = recovered(step, body);
    for node in (0u32..).take(body.mesh.nodes.len()) {
        if (node as usize).is_multiple_of(NODES_BETWEEN_CHECKPOINTS) {
            ask(observer)?;
        }
        let [sigma_x, sigma_y, sigma_z, tau_xy, plastic_strain, _] = recovery.node(node);
        let stress = Stress { sigma_x, sigma_y, sigma_z, tau_xy };
        report.sigma_x.push(write.stress(sigma_x));
        report.sigma_y.push(write.stress(sigma_y));
        report.sigma_z.push(write.stress(sigma_z));
        report.tau_xy.push(write.stress(sign * tau_xy) + 0.0);
        report.von_mises.push(write.stress(stress.von_mises()));
        report.equivalent_plastic_strain.push(plastic_strain.max(0.0));
    }
    Ok(report)
}
