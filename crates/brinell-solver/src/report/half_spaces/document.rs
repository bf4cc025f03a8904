//! Parts of a report that only contacts in three dimensions have.

use serde::{Deserialize, Serialize};

use crate::report::{BodyErrors, PerBody};

/// What only a contact in three dimensions has. x lies along the shorter semi-axis of the contact,
/// y along the longer one, z into the body; every place, map and stress of this step is in these
/// axes.
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
    /// Largest pressure of one cell. `contact.peak_pressure` is a mean over neighbours, weights
    /// 1-2-1 each way, where bodies yield, because the pressure of single cells is jagged near the
    /// edge \[stress >= 0\].
    pub largest_cell_pressure: f64,
    /// y of the largest pressure; its x is `contact.peak_position` \[length\].
    pub peak_position_y: f64,
    /// The elastic contact of the same bodies under the same force; absent where nothing touches.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hertz: Option<EllipticHertzReport>,
    /// What is said along a roller; absent without one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub roller: Option<RollerReport>,
    /// What is said of a contact of heights; absent without them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface: Option<RoughContactReport>,
    /// The cells of the section x = 0; those of the section y = 0 are `contact.nodes`.
    pub section: SectionReport,
    /// Pressure, gap and dent of all cells; absent unless `output.fields` asks for them.
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

/// The contact of surfaces with heights on top of their shapes. `area` is that of the cells in
/// contact, a and b are half of what lies between the outermost of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = RoughContact))]
pub struct RoughContactReport {
    /// Area of the cells in contact over that of all heights \[1 >= 0\].
    pub contact_ratio: f64,
    /// Force over the area of all heights \[stress >= 0\].
    pub nominal_pressure: f64,
    /// Parts of the area in contact \[1 >= 0\].
    pub parts: Vec<f64>,
    /// Pressure below which these parts of the area in contact are; empty where nothing touches
    /// \[stress >= 0\].
    pub pressure_quantiles: Vec<f64>,
    /// Part of the area in contact below which a body has yielded at some depth; `null` where none
    /// has a hardening curve \[1 >= 0\].
    pub plastic_part: Option<f64>,
}

/// The contact along a roller, in rows of cells across it. y is that of the fields, 0 in the
/// middle of the roller.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = RollerContact))]
pub struct RollerReport {
    /// Middles of the rows along the roller \[length\].
    pub y: Vec<f64>,
    /// Force on unit length of each row \[stiffness >= 0\].
    pub line_load: Vec<f64>,
    /// Half the width of the contact in each row \[length >= 0\].
    pub half_width: Vec<f64>,
    /// Largest pressure of a cell of each row \[stress >= 0\].
    pub pressure: Vec<f64>,
    /// Largest pressure of a cell in the rows beside the middle of the roller \[stress >= 0\].
    pub middle_pressure: f64,
    /// Largest pressure of a cell in the outermost rows, at negative and at positive y; 0 where
    /// the contact ends before. Where the roller has sharp ends it grows without bound with finer
    /// cells \[stress >= 0\].
    pub end_pressure: [f64; 2],
    /// Moment of the pressure about the x axis through the middle, the sum of force times y:
    /// positive where the half at positive y bears more. The body whose end at positive y is
    /// pressed is held in its tilt by this moment \[energy\].
    pub moment: f64,
    /// Tilt of one body against the other, that is given or under a moment that is given found:
    /// positive where the surfaces are brought closer at positive y. Without force it is that of
    /// the last contact \[mrad\].
    pub tilt: f64,
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

/// Cells of the surface. The cell at `x[i]`, `y[j]` stands at the place `i * y.length + j` of a
/// map, counted from 0.
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
    /// How far plastic strain lowers both surfaces together, without force the dents of both;
    /// absent where no body has a hardening curve \[length\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dent: Option<Vec<f64>>,
}

/// Estimated relative errors of figures of the contact and of each body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct EllipseErrors {
    /// Of the longer semi-axis; `null` of heights, whose outermost cells in contact tell it
    /// \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub b: Option<f64>,
    /// Of the area \[1 >= 0\].
    pub area: f64,
    /// Of each body; `null` of a rigid one.
    pub bodies: PerBody<Option<BodyErrors>>,
}
