//! Report of the contact: pressure, resultants and connected parts.

use serde::{Deserialize, Serialize};

use super::{MapsReport, PressureQuantiles, RollerReport, SectionReport};
use crate::solver::{ContactPatch, StepSolution};
use crate::units::UnitConverter;

/// The contact over the surface.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Contact))]
pub struct ContactReport {
    /// The connected parts of the contact, from left to right.
    pub patches: Vec<Patch>,
    /// The candidate pairs in order of x; in three dimensions the cells of the section y = 0.
    pub nodes: ContactNodes,
    /// The cells of the section x = 0, in three dimensions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub section: Option<SectionReport>,
    /// The rows of cells along a roller.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub along: Option<RollerReport>,
    /// How the pressure of heights is spread.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quantiles: Option<PressureQuantiles>,
    /// Pressure, gap and dent of all cells, in three dimensions; absent unless `output.fields`
    /// asks for them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub maps: Option<MapsReport>,
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
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
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
        patches: patches(step)
            .map(|part| Patch { left: write.length(part.left), right: write.length(part.right) })
            .collect(),
        nodes: ContactNodes {
            x: pairs().map(|(pair, sign)| write.length(sign * pair.x)).collect(),
            pressure: pairs().map(|(pair, _)| write.stress(pair.pressure)).collect(),
            force: pairs().map(|(pair, _)| write.force(pair.force)).collect(),
            gap: pairs().map(|(pair, _)| write.length(pair.gap)).collect(),
        },
        ..ContactReport::default()
    }
}

/// Returns the parts of the contact with their interpolated ends. A plane half model has each part
/// and its mirror image.
pub(super) fn patches(step: &StepSolution) -> impl Iterator<Item = ContactPatch> {
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
