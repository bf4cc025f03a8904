//! The result of a hardness test.

use serde::{Deserialize, Serialize};

use crate::report::ValidityNote;

/// The hardness that a test finds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = HardnessResult))]
pub struct HardnessReport {
    /// Name of the test, e.g. `HBW 10/3000`.
    pub test: String,
    /// Hardness number; `null` of `berkovich` and `sphere`, whose hardness is `mean_pressure`, and
    /// where a load did not converge \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub number: Option<f64>,
    /// Estimated bound of the relative error of the number, or of the mean pressure, by the mesh;
    /// `null` of Rockwell numbers, whose zero is a convention \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub relative_error: Option<f64>,
    /// The same in points of the scale \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub number_error: Option<f64>,
    /// Mean pressure over that of a published result with large strains, less 1; `null` where none
    /// is known, as a remark says \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub bias: Option<f64>,
    /// The published result.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub bias_source: Option<String>,
    /// Largest force \[force\].
    pub force: f64,
    /// Diameter of the contact under it; of pyramids the diagonal of a square of equal area
    /// \[length\].
    pub diameter: f64,
    /// Depth of the indentation under it \[length\].
    pub depth: f64,
    /// Estimated bound of the relative error of the depth by the mesh \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub depth_error: Option<f64>,
    /// Depth that is left \[length\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub permanent_depth: Option<f64>,
    /// Diameter of the highest points around the indentation that is left; `null` where nothing is
    /// piled up \[length\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub rim_diameter: Option<f64>,
    /// Height of the edge of the contact under load over the plane surface: above 0 piled up,
    /// below 0 sunk in \[length\].
    pub pile_up: f64,
    /// Force over the area of the contact, Meyer's hardness \[stress\].
    pub mean_pressure: f64,
    /// Exponent of Meyer's law, force over diameter \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub meyer_exponent: Option<f64>,
    /// Tabor's representative plastic strain: 0.2 a/R of a ball, 0.08 of a pyramid \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub representative_strain: Option<f64>,
    /// Stress of the curve at this strain \[stress\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub flow_stress: Option<f64>,
    /// Mean pressure over this stress; Tabor's is 2.8 \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub constraint: Option<f64>,
    /// What an instrument would find by Oliver and Pharr's method.
    #[cfg_attr(feature = "openapi", schema(required))]
    pub oliver_pharr: Option<OliverPharrReport>,
    /// Loading curvature F/h² of a pyramid over that of Dao et al., less 1 \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub curvature_bias: Option<f64>,
    /// Least thickness of the specimen by the standard \[length\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub least_thickness: Option<f64>,
    /// What to keep in mind.
    pub remarks: Vec<ValidityNote>,
}

/// Oliver and Pharr's figures (J. Mater. Res. 7 (1992) 1564) of the unloading curve, beside the
/// true contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = OliverPharr))]
pub struct OliverPharrReport {
    /// Slope S of the unloading curve at its beginning \[stiffness\].
    pub stiffness: f64,
    /// Contact depth `h_c = h − 0.75 F/S` \[length\].
    pub contact_depth: f64,
    /// Area of the indenter at this depth \[area\].
    pub area: f64,
    /// Area of the true contact \[area\].
    pub true_area: f64,
    /// `√π S / (2 √A)` \[stress\].
    pub reduced_modulus: f64,
    /// Estimated bound of its relative error by the mesh \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub modulus_error: Option<f64>,
    /// E* of the two materials \[stress\].
    pub true_reduced_modulus: f64,
    /// Force over the area, H \[stress\].
    pub indentation_hardness: f64,
    /// Estimated bound of its relative error by the mesh \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub hardness_error: Option<f64>,
}
