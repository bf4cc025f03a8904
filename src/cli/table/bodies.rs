//! A body in a few words.

use super::number::short;
use brinell_solver::job::{Body, Deformable, Hardening, Material, Shape, Support, Units};

/// Shape, material and support, in the units of the job.
pub(super) fn describe(body: &Body, units: Units) -> Vec<String> {
    let length = |value: f64| short(value / units.length());
    let mut items = vec![match &body.shape {
        Shape::Cylinder { radius } => format!("cylinder R {}", length(radius.get())),
        Shape::Block { width, depth } => {
            format!("block {} wide {} deep", length(width.get()), length(depth.get()))
        }
        Shape::Groove(groove) => format!(
            "groove R {} in a block {} wide {} deep",
            length(groove.radius().get()),
            length(groove.width().get()),
            length(groove.depth().get())
        ),
        Shape::Profile(profile) => {
            format!("profile of {} points, {} deep", profile.points().len(), length(profile.depth().get()))
        }
    }];
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
    items.extend(material.plasticity().map(|law| match law {
        Hardening::Bilinear { yield_stress, tangent_modulus } => {
            format!("bilinear σ_y {} E_t {}", stress(yield_stress.get()), stress(tangent_modulus.get()))
        }
        Hardening::RambergOsgood { reference_stress, offset, exponent } => format!(
            "Ramberg-Osgood σ_0 {} a {} m {}",
            stress(reference_stress.get()),
            short(offset.get()),
            short(exponent.get())
        ),
        Hardening::Table { points } => format!("hardening table of {} points", points.as_slice().len()),
        Hardening::Swift { yield_stress, .. } => format!("Swift σ_y {}", stress(yield_stress.get())),
        Hardening::Ludwik { yield_stress, .. } => format!("Ludwik σ_y {}", stress(yield_stress.get())),
        Hardening::Voce { yield_stress, .. } => format!("Voce σ_y {}", stress(yield_stress.get())),
    }));
    items
}
