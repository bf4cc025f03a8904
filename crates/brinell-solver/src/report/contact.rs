//! Report of the contact: pressure, resultants and connected parts.

use serde::{Deserialize, Serialize};

use crate::solver::{ContactPatch, StepSolution};
use crate::units::UnitConverter;

/// Contact pressure and its resultants, both sides of the axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Contact))]
pub struct ContactReport {
    /// Sum of the nodal forces along the approach \[force >= 0\].
    pub force: f64,
    /// Half of the distance between the ends of the pressure, along the arc for a pin in a hole
    /// \[length >= 0\].
    pub half_width: f64,
    /// Angle over which a pin touches its hole to each side of the middle; only of these
    /// \[degrees >= 0\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub half_angle: Option<f64>,
    /// Largest pressure \[stress >= 0\].
    pub peak_pressure: f64,
    /// x of the largest pressure; where nothing touches, of the largest that the history had
    /// \[length\].
    pub peak_position: f64,
    /// Pressure in the middle of the contact; of a roller the largest across its middle, `null` of
    /// heights \[stress >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub middle_pressure: Option<f64>,
    /// Force over width, or over the area of the contact circle; of a pin in a hole over those
    /// across the approach \[stress >= 0\].
    pub mean_pressure: f64,
    /// The connected parts of the contact, from left to right.
    pub patches: Vec<Patch>,
    /// The candidate pairs in order of x.
    pub nodes: ContactNodes,
}

/// One connected part of the contact. The outer ends of all are interpolated to where the pressure
/// vanishes, those between two parts are loaded nodes. Of a body of revolution they are radii.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Patch {
    /// Left end \[length\].
    pub left: f64,
    /// Right end \[length\].
    pub right: f64,
}

/// Values at the candidate pairs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ContactNodes {
    /// Tangential position, along the arc for a pin in a hole \[length\].
    pub x: Vec<f64>,
    /// Contact pressure \[stress\].
    pub pressure: Vec<f64>,
    /// Nodal force along the normal \[force\].
    pub force: Vec<f64>,
    /// Gap after loading \[length\].
    pub gap: Vec<f64>,
}

pub(super) fn report(step: &StepSolution, write: UnitConverter) -> ContactReport {
    // A half model is mirrored: -x_n … -x_1, x_0 = 0, x_1 … x_n. For a body of revolution x is the
    // radius.
    let mirrored =
        if step.field.is_mirrored() { step.field.pairs.get(1..).unwrap_or(&[]) } else { &[] };
    let pairs = || {
        mirrored
            .iter()
            .rev()
            .map(|pair| (pair, -1.0))
            .chain(step.field.pairs.iter().map(|pair| (pair, 1.0)))
    };
    ContactReport {
        force: write.force(step.figures.force),
        half_width: write.length(step.figures.half_width),
        half_angle: step
            .field
            .conforming
            .map(|pair| pair.angle(step.figures.half_width).to_degrees()),
        peak_pressure: write.stress(step.figures.peak_pressure),
        peak_position: write.length(step.field.peak_position),
        middle_pressure: step.figures.middle_pressure.map(|pressure| write.stress(pressure)),
        mean_pressure: write.stress(step.field.mean_pressure(&step.figures)),
        patches: patches(step)
            .map(|part| Patch { left: write.length(part.left), right: write.length(part.right) })
            .collect(),
        nodes: ContactNodes {
            x: pairs().map(|(pair, sign)| write.length(sign * pair.x)).collect(),
            pressure: pairs().map(|(pair, _)| write.stress(pair.pressure)).collect(),
            force: pairs().map(|(pair, _)| write.force(pair.force)).collect(),
            gap: pairs().map(|(pair, _)| write.length(pair.gap)).collect(),
        },
    }
}

/// Returns the parts of the contact with their interpolated ends. A plane half model has each part
/// and its mirror image.
fn patches(step: &StepSolution) -> impl Iterator<Item = ContactPatch> {
    let mut parts = step.field.parts.clone();
    if let (Some(part), Some(whole)) = (parts.last_mut(), step.field.patch) {
        part.right = whole.right;
    }
    let mut images = Vec::new();
    if step.field.is_mirrored() {
        images = parts
            .iter()
            .rev()
            .map(|part| ContactPatch { left: -part.right, right: -part.left })
            .collect();
        // The part on the axis and its mirror image form one part.
        if let (Some(first), Some(image)) = (parts.first_mut(), images.last())
            && first.left == 0.0
        {
            first.left = image.left;
            images.pop();
        }
    } else if let (Some(part), Some(whole), false) =
        (parts.first_mut(), step.field.patch, step.field.symmetric)
    {
        part.left = whole.left;
    }
    images.into_iter().chain(parts)
}
