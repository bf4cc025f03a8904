//! Half a steel cylinder under a uniform pressure on its top: mesh, stiffness, factor,
//! displacement, on finer and finer elements.

use std::error::Error;

use brinell_fem::assembly::{Equations, Restraint, StiffnessAssembler, Support};
use brinell_fem::element::{QUADRATURE_POINTS, StressState, element_stiffness};
use brinell_fem::mesh::{ContactZone, Mesh, Outline, Quality, Refinement};
use sparse_cholesky::{Cholesky, EliminationOrder, Graph, SymbolicCholesky};

/// Bulk and shear modulus of steel \[MPa\].
const BULK: f64 = 175_000.0;
const SHEAR: f64 = 80_769.2;
/// Radius and half-width of the pressure \[mm\].
const RADIUS: f64 = 20.0;
const HALF_WIDTH: f64 = 0.5;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "{:>8} {:>9} {:>10} {:>14} {:>14}",
        "columns", "elements", "equations", "least Jacobian", "displacement"
    );
    for columns in [10, 20, 40] {
        let outline = Outline::arc(RADIUS.recip(), RADIUS, RADIUS);
        let zone = ContactZone::uniform(0.0, HALF_WIDTH, columns, true);
        let mesh = Mesh::generate(&outline, &zone, Refinement { growth: 1.2 })?;

        let graph = Graph::from_cells(mesh.nodes.len(), &mesh.elements);
        let order = EliminationOrder::new(&graph, &mesh.lattice, &[]);
        let equations = Equations::new(&order, &Restraint::new(&mesh, Support::Clamped), 0);
        let symbolic = SymbolicCholesky::new(equations.pattern(&graph))?;
        let stress_state = StressState::PlaneStrain;
        let assembler = StiffnessAssembler {
            mesh: &mesh,
            stress_state,
            equations: &equations,
            pattern: symbolic.pattern(),
        };
        let values = assembler
            .assemble(|_, quad| element_stiffness(quad, BULK, &[SHEAR; QUADRATURE_POINTS]));
        let factor = Cholesky::factor(&symbolic, &values)?;

        // 1000 MPa: half an element of it at both ends.
        let mut load = vec![0.0; equations.len()];
        for (k, &node) in mesh.contact_nodes.iter().enumerate() {
            let share = if k == 0 || k == columns { 0.5 } else { 1.0 };
            load[equations.of_node(node)[1] as usize] =
                -1000.0 * share * HALF_WIDTH / columns as f64;
        }
        factor.solve(&mut load);
        println!(
            "{columns:>8} {:>9} {:>10} {:>14.3} {:>11.6} mm",
            mesh.elements.len(),
            equations.len(),
            Quality::of(&mesh).min_jacobian_ratio,
            load[equations.of_node(mesh.contact_nodes[0])[1] as usize],
        );
    }
    Ok(())
}
