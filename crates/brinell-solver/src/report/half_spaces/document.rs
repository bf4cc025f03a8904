//! What a result has of a contact in three dimensions alone.

use serde::{Deserialize, Serialize};

use crate::report::PerBody;

/// What only a contact in three dimensions has. x lies along the shorter semi-axis of the contact, y along the longer one, z into
/// the body; every place, map and stress of this step is in these axes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = ThreeDimensional))]
pub struct ThreeDimensionalReport {
    /// Angle from the x of the job to this x, towards the y of the job; 0 of a circle \[degrees\].
    pub orientation: f64,
    /// Shorter semi-axis; 0 where nothing touches \[length >= 0\].
    pub a: f64,
    /// Longer semi-axis \[length >= 0\].
    pub b: f64,
    /// Area of the ellipse of these semi-axes \[area >= 0\].
    pub area: f64,
    /// Largest pressure of one cell. `contact.peak_pressure` is a mean over neighbours, weights 1-2-1 each way, where bodies yield,
    /// because the pressure of single cells is jagged near the edge \[stress >= 0\].
    pub largest_cell_pressure: f64,
    /// y of the largest pressure; its x is `contact.peak_position` \[length\].
    pub peak_position_y: f64,
    /// The elastic contact of the same bodies under the same force; absent where nothing touches.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hertz: Option<EllipticHertzReport>,
    /// The cells of the section x = 0; those of the section y = 0 are `contact.nodes`.
    pub section: SectionReport,
    /// Pressure and gap of all cells; absent unless `output.fields` asks for them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub maps: Option<MapsReport>,
    /// Estimated relative errors of further figures; absent where `estimated_error` is `null`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub estimated_error: Option<EllipseErrors>,
}

/// Hertz's ellipse.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = EllipticHertz))]
pub struct EllipticHertzReport {
    /// Shorter semi-axis \[length >= 0\].
    pub a: f64,
    /// Longer semi-axis \[length >= 0\].
    pub b: f64,
    /// Approach of points far from the contact \[length >= 0\].
    pub approach: f64,
}

/// Cells along y, the mean of the two rows beside x = 0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = ContactSection))]
pub struct SectionReport {
    /// Middle of the cell \[length\].
    pub y: Vec<f64>,
    /// Contact pressure \[stress\].
    pub pressure: Vec<f64>,
    /// Gap after loading \[length\].
    pub gap: Vec<f64>,
}

/// Cells of the surface. The cell at `x[i]`, `y[j]` stands at the place `i * y.length + j` of a map, counted from 0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = ContactMaps))]
pub struct MapsReport {
    /// Middles of the cells along x \[length\].
    pub x: Vec<f64>,
    /// Middles of the cells along y \[length\].
    pub y: Vec<f64>,
    /// Contact pressure \[stress\].
    pub pressure: Vec<f64>,
    /// Gap after loading \[length\].
    pub gap: Vec<f64>,
}

/// Estimated relative errors of figures of the contact and of each body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct EllipseErrors {
    /// Of the longer semi-axis \[1 >= 0\].
    pub b: f64,
    /// Of the area \[1 >= 0\].
    pub area: f64,
    /// Of each body; `null` of a rigid one.
    pub bodies: PerBody<Option<BodyErrors>>,
}

/// Estimated relative errors of figures of one body; 0 of a figure that is 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct BodyErrors {
    /// Of the largest plastic strain \[1 >= 0\].
    pub max_equivalent_plastic_strain: f64,
    /// Of the depth by which plastic strain lowers the surface \[1 >= 0\].
    pub depth: f64,
    /// Of the height by which it raises it \[1 >= 0\].
    pub pile_up: f64,
    /// Of the least residual stress along the surface below the largest pressure; `null` under load, where the least stress is at
    /// the surface and not one of the layers' \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub least_stress: Option<f64>,
}
