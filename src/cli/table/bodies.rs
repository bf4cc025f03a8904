//! Descriptions of bodies in a few words.

use super::number::{short, significant};
use brinell_solver::job::fields::{Field, FieldKind, FieldValue};
use brinell_solver::job::{
    Analysis, Body, Deformable, FarSupport, Job, Material, Quantity, Units,
};

/// Shape, material and support, in the units of the job.
pub(super) fn describe(body: &Body, job: &Job) -> Vec<String> {
    let (shape, units) = (&body.shape, job.units);
    let mut items = vec![describe_fields(shape.label(job.analysis), shape.values(), units)];
    match &body.material {
        Material::Rigid => items.push("rigid".to_owned()),
        Material::Deformable(material) => {
            items.extend(describe_material(material, job));
            if job.analysis != Analysis::ThreeDimensional {
                items.push(match body.support {
                    FarSupport::Clamped => "clamped".to_owned(),
                    FarSupport::Roller => "on rollers".to_owned(),
                });
            }
        }
    }
    items
}

fn describe_material(material: &Deformable, job: &Job) -> Vec<String> {
    let units = job.units;
    let stress = |value: f64| short(units.to_wire(Quantity::Stress, value));
    let elastic = &material.elastic;
    let mut items = vec![
        format!("E {}", stress(elastic.young_modulus.get())),
        format!("ν {}", short(elastic.poisson_ratio.get())),
    ];
    items.extend(
        material
            .plasticity
            .as_ref()
            .map(|law| describe_fields(law.table().label, law.values(), units)),
    );
    if let Some(strength) = material.strength() {
        let (least, greatest) = strength.range();
        items.push(format!(
            "its stresses × {} to {} over depth",
            significant(least, 3),
            significant(greatest, 3)
        ));
    }
    let initial = material.initial_stress.iter().map(|row| row.sigma_x);
    if let Some((least, greatest)) =
        initial.map(|x| (x, x)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
    {
        let along = if job.analysis == Analysis::Axisymmetric { "σ_r" } else { "σ_x" };
        items.push(format!("{along} {} to {} before the load", stress(least), stress(greatest)));
    }
    items
}

/// An object of the job by its label and its fields, each under its symbol.
fn describe_fields(label: &str, values: Vec<(&Field, FieldValue)>, units: Units) -> String {
    let mut words = vec![label.to_owned()];
    for (field, value) in values {
        match (value, &field.kind) {
            (FieldValue::Figure(core), FieldKind::Figure(figure)) => {
                words.push(format!("{} {}", field.symbol, short(figure.to_wire(units, core))));
            }
            (FieldValue::Points(points), _) => words.push(format!("of {} points", points.len())),
            _ => {}
        }
    }
    words.join(" ")
}
