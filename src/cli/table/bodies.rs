//! A body in a few words.

use super::number::{short, significant};
use brinell_solver::job::fields::{Field, FieldKind, FieldTable, Value};
use brinell_solver::job::{Body, Deformable, Material, Support, Units};

/// Shape, material and support, in the units of the job.
pub(super) fn describe(body: &Body, units: Units) -> Vec<String> {
    let mut items = vec![describe_fields(body.shape.table(), body.shape.values(), units)];
    match &body.material {
        Material::Rigid => items.push("rigid".to_owned()),
        Material::Deformable(material) => {
            items.extend(describe_material(material, units));
            items.push(match body.support {
                Support::Clamped => "clamped".to_owned(),
                Support::Roller => "on rollers".to_owned(),
            });
        }
    }
    items
}

fn describe_material(material: &Deformable, units: Units) -> Vec<String> {
    let stress = |value: f64| short(value / units.stress());
    let elastic = material.elastic();
    let mut items = vec![
        format!("E {}", stress(elastic.young_modulus.get())),
        format!("ν {}", short(elastic.poisson_ratio.get())),
    ];
    items.extend(material.plasticity().map(|law| describe_fields(law.table(), law.values(), units)));
    if let Some(strength) = material.strength() {
        let (least, greatest) = strength.range();
        items.push(format!(
            "its stresses × {} to {} over depth",
            significant(least, 3),
            significant(greatest, 3)
        ));
    }
    let initial = material.initial_stress().iter().map(|row| row.sigma_x);
    if let Some((least, greatest)) = initial.map(|x| (x, x)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))) {
        items.push(format!("σ_x {} to {} before the load", stress(least), stress(greatest)));
    }
    items
}

/// An object of the job by its label and its fields, each under its symbol.
fn describe_fields(table: &FieldTable, values: Vec<(&Field, Value)>, units: Units) -> String {
    let mut words = vec![table.label.to_owned()];
    for (field, value) in values {
        match (value, &field.kind) {
            (Value::Figure(core), FieldKind::Figure(figure)) => {
                words.push(format!("{} {}", field.symbol, short(figure.to_wire(units, core))));
            }
            (Value::Points(points), _) => words.push(format!("of {} points", points.len())),
            _ => {}
        }
    }
    words.join(" ")
}
