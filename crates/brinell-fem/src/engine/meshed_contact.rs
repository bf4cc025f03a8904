//! Contact that is solved on meshes: two bodies, their loads, and the settings.

use crate::engine::problem::Problem;
use brinell_method::settings::Settings;
use brinell_method::sought::Loads;

/// Two bodies, their loads, and the settings of the solution.
pub struct MeshedContact {
    /// The bodies.
    pub problem: Problem,
    /// The loads.
    pub loads: Loads,
    /// The mesh and the solve.
    pub asked: Asked,
    /// Elements of the small meshes that tell the contact stiffness, where it is asked for.
    pub elements_of_slopes: Option<u32>,
}

/// The mesh and the solve that are asked for.
#[derive(Debug, Clone, Copy)]
pub struct Asked {
    /// Elements over the half-width of the contact.
    pub elements: u32,
    /// Theory, coupling, contact solver and limits of the iteration.
    pub solver: Settings,
}
