//! A bar of steel is pulled beyond yield and let go: deformation theory forgets, flow theory does
//! not.
//!
//! `cargo run -p brinell-material --example bar`

use std::sync::Arc;

use brinell_material::hardening::Voce;
use brinell_material::{
    ConstitutiveModel, DeformationPlasticity, ElasticModuli, FlowPlasticity, HardeningLaw,
    OutOfPlane, ReturnMapping,
};

fn main() {
    // [MPa]
    let steel = ElasticModuli { bulk: 175_000.0, shear: 80_769.0 };
    let law: Arc<dyn HardeningLaw> =
        Arc::new(Voce { yield_stress: 500.0, saturation_stress: 750.0, rate: 50.0 });
    let by_strain =
        DeformationPlasticity::with_law(steel, Some(Arc::clone(&law)), OutOfPlane::PlaneStress);
    let by_history = FlowPlasticity::new(
        steel,
        ReturnMapping::new(law, steel.shear),
        [],
        OutOfPlane::PlaneStress,
    );
    let mut state = by_history.at_rest(&brinell_material::PointOrigin::default());
    println!("strain    stress [MPa]: deformation, flow    plastic strain");
    for along in [0.002, 0.004, 0.008, 0.004, 0.002] {
        let strain = [along, -0.4 * along, 0.0, 0.0];
        let (total, ()) = by_strain.update(strain, &());
        let (flow, after) = by_history.update(strain, &state);
        state = after;
        let plastic = flow.equivalent_plastic_strain;
        println!("{along:.4} {:24.1} {:13.1} {plastic:12.5}", total.stress[0], flow.stress[0]);
    }
}
