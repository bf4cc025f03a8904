//! Settings and loads of a job.

use brinell_method::couplings::{self, Accelerated, SecantStiffness, Strong, Weak};
use brinell_method::increments::Increments;
use brinell_method::settings::Settings;
use brinell_method::sought::{self, Loads, Sought};

use crate::contact::{ActiveSetSolver, ContactLoad, ContactSolver, SimplexSolver};
use crate::job::{
    ContactMethod, Coupling, HistoryLoad, Job, Load, PositiveF64, SolverSettings, Target, Theory,
};

/// Accuracy up to which the increments that a solve chooses do. Their error falls like their square.
const OF_CHOSEN_INCREMENTS: f64 = 0.005;

/// Most times as many of them, which do for the smallest accuracy.
const MOST_TIMES: u32 = 3;

/// Returns the settings of the solve that a job asks for. Of bodies without a memory each load is
/// solved at once.
pub fn settings(job: &Job) -> Settings {
    let SolverSettings { coupling, contact, tolerance, max_iterations, .. } = job.solver;
    Settings {
        theory: if job.has_memory() { Theory::Flow } else { Theory::Deformation },
        increments: increments(job),
        coupling: coupling_of(coupling),
        contact: contact_solver_of(contact),
        tolerance: tolerance.get(),
        max_iterations: max_iterations as usize,
    }
}

/// Returns the increments that a job gives, or those that its accuracy takes.
pub fn increments(job: &Job) -> Increments {
    let does = |times: &u32| {
        let accuracy = job.mesh.accuracy.map_or(1.0, PositiveF64::get);
        f64::from(times * times) * accuracy >= OF_CHOSEN_INCREMENTS
    };
    let chosen = || Increments::Chosen((1..MOST_TIMES).find(does).unwrap_or(MOST_TIMES));
    job.solver.increments.map_or_else(chosen, Increments::Given)
}

/// Returns the coupling that a job names.
fn coupling_of(coupling: Coupling) -> &'static (dyn couplings::Coupling + Sync) {
    match coupling {
        Coupling::Strong => &Strong,
        Coupling::Accelerated => &Accelerated,
        Coupling::Weak => &Weak,
        Coupling::SecantStiffness => &SecantStiffness,
    }
}

/// Returns the contact solver that a job names.
fn contact_solver_of(method: ContactMethod) -> &'static (dyn ContactSolver + Sync) {
    match method {
        ContactMethod::ActiveSet => &ActiveSetSolver,
        ContactMethod::Simplex => &SimplexSolver,
    }
}

/// Returns the loads of a job; of a load that rolls its force.
pub fn loads(load: &Load) -> Loads {
    match load {
        Load::Forces(forces) => {
            Loads::Each(forces.iter().map(|force| ContactLoad::Force(force.get())).collect())
        }
        Load::Approaches(approaches) => Loads::Each(
            approaches.iter().map(|approach| ContactLoad::Approach(approach.get())).collect(),
        ),
        Load::History(loads) => {
            let load = |load: &HistoryLoad| match load {
                HistoryLoad::Force(force) => ContactLoad::Force(force.get()),
                HistoryLoad::Approach(approach) => ContactLoad::Approach(approach.get()),
            };
            Loads::History(loads.iter().map(load).collect())
        }
        Load::Rolling(rolling) => Loads::Each(vec![ContactLoad::Force(rolling.force.get())]),
        Load::Onset => Loads::Sought(Sought::Onset),
        Load::Target(Target { figure, value }) => {
            let target = sought::Target { figure: *figure, value: value.get() };
            Loads::Sought(Sought::Target(target))
        }
    }
}
