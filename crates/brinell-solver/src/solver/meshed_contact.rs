//! What is solved on meshes: two bodies, their loads, and how.

use crate::solver::method::settings::Settings;
use crate::solver::method::sought::Loads;
use crate::solver::problem::Problem;

/// Two bodies, their loads, and how they are solved.
pub(crate) struct MeshedContact {
    pub problem: Problem,
    pub loads: Loads,
    pub asked: Asked,
    /// Elements of the small meshes that tell the contact stiffness, where it is asked for.
    pub elements_of_slopes: Option<u32>,
}

/// The mesh and the solve that are asked for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Asked {
    /// Elements over the half-width of the contact.
    pub elements: u32,
    pub solver: Settings,
}
