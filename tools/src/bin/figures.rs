//! Figure 4 of the paper, by this program: `cargo run --release -p brinell-tools --bin figures`
//! writes the pressure over the contact and the stresses over depth to `docs/figures/`.

use brinell_solver::job::Job;
use brinell_solver::report::export::{depth_svg, pressure_svg};
use brinell_solver::solver::Unobserved;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let job = Job::from_json(include_bytes!("../../../api/examples/two_cylinders.json"))?;
    let report = brinell_solver::report::run(&job, &mut Unobserved)?;
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/figures");
    std::fs::create_dir_all(folder)?;
    std::fs::write(format!("{folder}/pressure.svg"), pressure_svg(&job, &report, 0)?)?;
    std::fs::write(format!("{folder}/depth.svg"), depth_svg(&job, &report, 0)?)?;
    println!("written to docs/figures/: pressure.svg, depth.svg");
    Ok(())
}
