//! Arrays over the contact that only contacts in three dimensions have. x lies along the shorter
//! semi-axis of the contact, y along the longer one, z into the body.

use serde::{Deserialize, Serialize};

/// The contact of heights: parts of the area in contact, and the pressure below which they are.
/// Empty where nothing touches.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct PressureQuantiles {
    /// Parts of the area in contact \[1 >= 0\].
    pub part: Vec<f64>,
    /// Pressure below which they are \[stress >= 0\].
    pub pressure: Vec<f64>,
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
