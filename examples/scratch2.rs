use brinell::model::*;
use brinell::solve::{self, Unobserved};
fn main() {
    let text = std::fs::read(std::env::args().nth(1).unwrap()).unwrap();
    let job = Job::from_json(&text).unwrap();
    let s = solve::run(&job, &mut Unobserved).unwrap();
    for step in &s.steps {
        println!(
            "{:?} {:?} its {} residual {:.2e} sound {} a {:?} passes {}",
            step.load,
            step.status,
            step.history.len(),
            step.equilibrium_residual,
            step.contact_is_sound,
            step.patch.map(|p| p.half_width()),
            s.passes
        );
        for r in step.history.iter().filter(|r| r.iteration <= 40 || r.iteration % 50 == 0) {
            print!(" {:.0e}{}", r.equilibrium_residual, if r.factorizations > 0 { "*" } else { "" });
        }
        println!();
    }
}
