//! Stresses and plastic strain in the layers of a half-space, cell by cell.

use serde::{Deserialize, Serialize};

/// Cells of the layers of one body. The cell at `x[i]`, `y[j]`, `z[k]` stands at the place `(k *
/// x.length + i) * y.length + j` of an array, counted from 0. Axes are those of the contact: x
/// along its shorter semi-axis, y along the longer one, z into the body. Of a load that rolls they
/// are the section of the track behind it: x, of one cell, along the travel, y across it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Layers))]
pub struct LayersReport {
    /// Middles of the cells along x \[length\].
    pub x: Vec<f64>,
    /// Middles of the cells along y \[length\].
    pub y: Vec<f64>,
    /// Middles of the layers \[length >= 0\].
    pub z: Vec<f64>,
    /// Faces of the layers, from the surface down; one more than layers \[length >= 0\].
    pub z_faces: Vec<f64>,
    /// Stress along x, initial stress included \[stress\].
    pub sigma_xx: Vec<f64>,
    /// Stress along y, initial stress included \[stress\].
    pub sigma_yy: Vec<f64>,
    /// Normal stress \[stress\].
    pub sigma_zz: Vec<f64>,
    /// Shear stress of x and y \[stress\].
    pub sigma_xy: Vec<f64>,
    /// Shear stress of x and z \[stress\].
    pub sigma_xz: Vec<f64>,
    /// Shear stress of y and z \[stress\].
    pub sigma_yz: Vec<f64>,
    /// Von Mises stress \[stress\].
    pub von_mises: Vec<f64>,
    /// Equivalent plastic strain \[1\].
    pub equivalent_plastic_strain: Vec<f64>,
    /// Plastic strain along x; 0 in a body that does not yield, like the following \[1\].
    pub plastic_strain_xx: Vec<f64>,
    /// Plastic strain along y \[1\].
    pub plastic_strain_yy: Vec<f64>,
    /// Plastic strain along the normal \[1\].
    pub plastic_strain_zz: Vec<f64>,
    /// Plastic shear strain of x and y, half of the change of the angle; so are the following
    /// \[1\].
    pub plastic_strain_xy: Vec<f64>,
    /// Plastic shear strain of x and z \[1\].
    pub plastic_strain_xz: Vec<f64>,
    /// Plastic shear strain of y and z \[1\].
    pub plastic_strain_yz: Vec<f64>,
}

/// The names of the arrays of a body, in their order.
pub const LAYER_NAMES: [&str; 18] = [
    "x",
    "y",
    "z",
    "z_faces",
    "sigma_xx",
    "sigma_yy",
    "sigma_zz",
    "sigma_xy",
    "sigma_xz",
    "sigma_yz",
    "von_mises",
    "equivalent_plastic_strain",
    "plastic_strain_xx",
    "plastic_strain_yy",
    "plastic_strain_zz",
    "plastic_strain_xy",
    "plastic_strain_xz",
    "plastic_strain_yz",
];

impl LayersReport {
    /// The arrays, in the order of [`LAYER_NAMES`].
    pub(super) fn arrays(&self) -> [&[f64]; 18] {
        [
            &self.x,
            &self.y,
            &self.z,
            &self.z_faces,
            &self.sigma_xx,
            &self.sigma_yy,
            &self.sigma_zz,
            &self.sigma_xy,
            &self.sigma_xz,
            &self.sigma_yz,
            &self.von_mises,
            &self.equivalent_plastic_strain,
            &self.plastic_strain_xx,
            &self.plastic_strain_yy,
            &self.plastic_strain_zz,
            &self.plastic_strain_xy,
            &self.plastic_strain_xz,
            &self.plastic_strain_yz,
        ]
    }
}
