//! Stress and plastic strain in the section of a track, behind the load.

use crate::job::Quantity;
use crate::report::LayersReport;
use crate::solver::half_spaces::von_mises;
use crate::solver::rolling::BodyPass;
use crate::units::UnitConverter;

/// Returns the section that the last of these passes has left in a body, with the cells on both
/// sides of its axis. The passes on a line have no section.
pub(super) fn section(passes: &[&BodyPass], write: UnitConverter) -> Option<LayersReport> {
    let outlet = &passes.last()?.outlet;
    let (rows, n_layers) = (outlet.across.len(), outlet.depths.len());
    if rows < 2 {
        return None;
    }
    // Rows hold y > 0, from the axis outwards; σxy and σyz are odd in y.
    let across = || (0..rows).rev().map(|row| (row, -1.0)).chain((0..rows).map(|row| (row, 1.0)));
    let cells = || {
        (0..n_layers).flat_map(|layer| across().map(move |(row, side)| (layer * rows + row, side)))
    };
    let sign = |side: f64, is_odd: bool| if is_odd { side } else { 1.0 };
    let stress = |k: usize| {
        let odd = [3, 5].contains(&k);
        cells()
            .map(|(cell, side)| {
                write.figure(Quantity::Stress, sign(side, odd) * outlet.residual[cell][k])
            })
            .collect::<Vec<f64>>()
    };
    let plastic = |of: &dyn Fn(&[f64; 5]) -> f64, odd: bool| {
        cells()
            .map(|(cell, side)| sign(side, odd) * of(&outlet.strain[cell]))
            .collect::<Vec<f64>>()
    };
    let lengths = |values: &[f64]| values.iter().map(|value| write.length(*value)).collect();
    let accumulated =
        |cell: usize| passes.iter().map(|pass| pass.outlet.accumulated[cell]).sum::<f64>();
    let y = across().map(|(row, side)| side * outlet.across[row]).collect::<Vec<f64>>();
    Some(LayersReport {
        x: vec![0.0],
        y: lengths(&y),
        z: lengths(&outlet.depths),
        z_faces: lengths(&outlet.faces),
        sigma_xx: stress(0),
        sigma_yy: stress(1),
        sigma_zz: stress(2),
        sigma_xy: stress(3),
        sigma_xz: stress(4),
        sigma_yz: stress(5),
        von_mises: cells()
            .map(|(cell, _)| write.stress(von_mises(outlet.residual[cell])))
            .collect(),
        equivalent_plastic_strain: cells().map(|(cell, _)| accumulated(cell)).collect(),
        plastic_strain_xx: plastic(&|strain| strain[0], false),
        plastic_strain_yy: plastic(&|strain| strain[1], false),
        plastic_strain_zz: plastic(&|strain| -strain[0] - strain[1], false),
        plastic_strain_xy: plastic(&|strain| strain[2], true),
        plastic_strain_xz: plastic(&|strain| strain[3], false),
        plastic_strain_yz: plastic(&|strain| strain[4], true),
    })
}
