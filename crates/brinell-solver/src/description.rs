//! A job in a line.

use crate::job::fields::{FieldKind, FieldValue};
use crate::job::{Body, Job, Load, Material, Named as _, Shape};
use crate::units::{UnitConverter, rounded};

/// Returns bodies, load and materials of a job in a line: `cylinder R 20 on cylinder R 20, 500 N/mm,
/// S355`. Figures are in the units of the job, to five digits.
pub fn description(job: &Job) -> String {
    if let Some(test) = job.load.hardness() {
        return format!("{} of {}", test.name(), material(&job.lower));
    }
    let [upper, lower] = job.bodies().map(|body| outline(body, job));
    let joint = if matches!(job.lower.shape, Shape::Hole(_)) { "in" } else { "on" };
    let [above, below] = job.bodies().map(material);
    let materials = if above == below { above } else { format!("{above} on {below}") };
    format!("{upper} {joint} {lower}, {}, {materials}", load(job))
}

/// Shape of a body and its first radius, by which people call it.
fn outline(body: &Body, job: &Job) -> String {
    let label = body.shape.label(job.analysis).to_lowercase();
    let radius = body.shape.values().into_iter().find_map(|(field, value)| match value {
        FieldValue::Figure(core) if field.symbol.starts_with('R') => match &field.kind {
            FieldKind::Figure(kind) => Some(kind.to_wire(job.units, core.abs())),
            _ => None,
        },
        _ => None,
    });
    radius.map_or_else(|| label.clone(), |radius| format!("{label} R {}", rounded(radius)))
}

fn load(job: &Job) -> String {
    let units = UnitConverter::new(job.units, job.analysis);
    match &job.load {
        Load::Forces(forces) => match forces[..] {
            [first, .., last] if first != last => {
                format!("{} … {}", rounded(units.force(first.get())), units.force_text(last.get()))
            }
            _ => units.force_text(forces[0].get()),
        },
        Load::Approaches(approaches) => match approaches[..] {
            [first, .., last] if first != last => {
                let first = rounded(units.length(first.get()));
                format!("approach {first} … {}", units.length_text(last.get()))
            }
            _ => format!("approach {}", units.length_text(approaches[0].get())),
        },
        Load::History(loads) => format!("{} loads in turn", loads.len()),
        Load::Onset => "onset of yield".to_owned(),
        Load::Target(target) => {
            let figure = target.figure.name().replace('_', " ");
            format!("force for {figure} {}", units.target_text(target.figure, target.value.get()))
        }
        Load::Rolling(rolling) => format!("{} rolling", units.force_text(rolling.force.get())),
    }
}

/// What people call a material, or else its law.
fn material(body: &Body) -> String {
    match (&body.material_name, &body.material) {
        (Some(name), _) => name.clone(),
        (None, Material::Rigid) => "rigid".to_owned(),
        (None, Material::Deformable(material)) => {
            material.plasticity.as_ref().map_or("elastic", |law| law.table().label).to_lowercase()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_is_described_in_its_own_units() {
        for (text, expected) in [
            (
                include_str!("../../../api/examples/two_cylinders.json"),
                "cylinder R 20 on cylinder R 20, 612.61 N/mm, bilinear",
            ),
            (
                include_str!("../../../api/examples/pin_in_hole.json"),
                "cylinder R 10 in hole R 10.02, 1000 … 6000 N/mm, elastic on bilinear",
            ),
            (
                include_str!("../../../api/examples/ball_runs_in.json"),
                "sphere R 5 on curved surface R 20, 800 N rolling, ball on raceway",
            ),
            (
                include_str!("../../../api/examples/static_rating_ball.json"),
                "sphere R 5 on block, force for permanent approach 0.001 mm, swift",
            ),
            (include_str!("../../../api/examples/brinell_test.json"), "HBW 10/3000 of A514"),
        ] {
            let job = Job::from_json(text.as_bytes()).unwrap();
            assert_eq!(description(&job), expected);
        }
    }
}
