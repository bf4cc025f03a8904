//! Arrays of the layers of a half-space.

use crate::job::Quantity;
use crate::report::LayersReport;
use crate::solver::half_spaces::HalfSpaceBody;
use crate::units::UnitConverter;

/// Returns the cells of a body.
pub(super) fn layers(body: &HalfSpaceBody, write: UnitConverter) -> LayersReport {
    let (grid, faces) = (&body.grid, body.layers.faces());
    let (n_layers, n_cells) = (body.layers.len(), grid.n_cells());
    let lengths = |values: Vec<f64>| values.into_iter().map(|value| write.length(value)).collect();
    let cells = || (0..n_layers).flat_map(|layer| (0..n_cells).map(move |cell| (layer, cell)));
    let stress = |k: usize| {
        let of_layer = |layer: usize| body.stress.component(layer, k).iter();
        (0..n_layers)
            .flat_map(of_layer)
            .map(|stress| write.figure(Quantity::Stress, *stress))
            .collect()
    };
    let plastic = |rows: &[usize], sign: f64| -> Vec<f64> {
        let Some(strain) = &body.plastic_strain else { return vec![0.0; n_layers * n_cells] };
        let of_cell = |(layer, cell): (usize, usize)| {
            sign * rows.iter().map(|row| strain.component(layer, *row)[cell]).sum::<f64>()
        };
        cells().map(of_cell).collect()
    };
    // Components of a deviator; the component zz is -xx - yy.
    let [xx, yy, xy, xz, yz] = [0, 1, 2, 3, 4];
    let equivalent = &body.equivalent_plastic_strain;
    LayersReport {
        x: lengths((0..grid.nx()).map(|i| grid.x(i)).collect()),
        y: lengths((0..grid.ny()).map(|j| grid.y(j)).collect()),
        z: lengths((0..n_layers).map(|layer| body.layers.middle(layer)).collect()),
        z_faces: lengths(faces.to_vec()),
        sigma_xx: stress(0),
        sigma_yy: stress(1),
        sigma_zz: stress(2),
        sigma_xy: stress(3),
        sigma_xz: stress(4),
        sigma_yz: stress(5),
        von_mises: cells()
            .map(|(layer, cell)| write.stress(body.von_mises(layer, cell)))
            .collect(),
        equivalent_plastic_strain: if equivalent.is_empty() {
            vec![0.0; n_layers * n_cells]
        } else {
            equivalent.clone()
        },
        plastic_strain_xx: plastic(&[xx], 1.0),
        plastic_strain_yy: plastic(&[yy], 1.0),
        plastic_strain_zz: plastic(&[xx, yy], -1.0),
        plastic_strain_xy: plastic(&[xy], 1.0),
        plastic_strain_xz: plastic(&[xz], 1.0),
        plastic_strain_yz: plastic(&[yz], 1.0),
    }
}
