//! Selection of the requested parts of a stored result.

use axum::body::Bytes;
use serde_json::{Value, json};

use super::problem::Problem;
use super::problem_type::ProblemType;
use super::query::{Selection, StepPart};

/// Returns the problem for a step that the result does not have.
pub(super) fn no_step(count: usize) -> Problem {
    let steps = if count == 1 { "step" } else { "steps" };
    Problem::new(ProblemType::StepNotFound, format!("the result has {count} {steps}"))
}

/// Keeps none of the large parts of a report.
pub(crate) fn summary(report: &[u8]) -> Result<Vec<u8>, serde_json::Error> {
    let mut report: Value = serde_json::from_slice(report)?;
    for step in report["steps"].as_array_mut().into_iter().flatten() {
        keep(step, &[]);
    }
    serde_json::to_vec(&report)
}

/// Keeps the requested parts of a step.
pub(super) fn edit(step: &[u8], selection: &Selection) -> Result<Bytes, serde_json::Error> {
    let mut step = serde_json::from_slice(step)?;
    edit_step(&mut step, selection);
    Ok(serde_json::to_vec(&step)?.into())
}

/// Members of a step with stresses over depth.
const PROFILES: [&str; 2] = ["subsurface", "subsurface_below_peak"];

/// Members that the schema requires stay, empty.
fn edit_step(step: &mut Value, selection: &Selection) {
    if let Some(parts) = &selection.parts {
        keep(step, parts);
    }
    let Some(depths) = selection.depths else { return };
    for profiles in PROFILES {
        let bodies = step.get_mut(profiles).and_then(Value::as_object_mut);
        for body in bodies.into_iter().flat_map(|bodies| bodies.values_mut()) {
            thin(body, depths);
        }
    }
}

fn remove(object: &mut Value, key: &str) {
    if let Some(members) = object.as_object_mut() {
        members.remove(key);
    }
}

/// Removes all large parts of a step except these.
fn keep(step: &mut Value, parts: &[StepPart]) {
    let drops = |part| !parts.contains(&part);
    if drops(StepPart::Contact) {
        for list in step["contact"]["nodes"]
            .as_object_mut()
            .into_iter()
            .flat_map(|nodes| nodes.values_mut())
        {
            *list = json!([]);
        }
    }
    if drops(StepPart::Plasticity) {
        for zone in
            step["plasticity"].as_object_mut().into_iter().flat_map(|bodies| bodies.values_mut())
        {
            if zone.is_object() {
                zone["outline"] = json!([]);
            }
        }
    }
    if drops(StepPart::History) {
        step["history"] = json!([]);
    }
    if drops(StepPart::Subsurface) {
        for profiles in PROFILES {
            remove(step, profiles);
        }
    }
    if drops(StepPart::Fields) {
        remove(step, "fields");
        remove(step, "layers");
    }
    if drops(StepPart::Maps)
        && let Some(contact) = step.get_mut("contact")
    {
        remove(contact, "maps");
    }
}

/// Thins the depths to `most`: the first, the last, the depths of the largest shear and von Mises
/// stress, and others spread evenly over the depths of the mesh, which are closer together near
/// the surface.
fn thin(body: &mut Value, most: usize) {
    let Some(count) = body["depth"].as_array().map(Vec::len).filter(|count| *count > most) else {
        return;
    };
    let mut kept = vec![0, count - 1];
    for name in ["von_mises", "tau_max"] {
        let values = body[name].as_array().map_or(&[][..], Vec::as_slice);
        let figures = values.iter().map(|value| value.as_f64().unwrap_or_default());
        let largest =
            figures.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index);
        kept.extend(largest.filter(|index| kept.len() < most && !kept.contains(index)));
    }
    let rest = most.saturating_sub(kept.len());
    let even =
        (1..=rest).map(|k| k * (count - 1) / (rest + 1)).filter(|index| !kept.contains(index));
    let even: Vec<_> = even.collect();
    kept.extend(even);
    kept.sort_unstable();
    for list in body.as_object_mut().into_iter().flat_map(|lists| lists.values_mut()) {
        if let Some(values) = list.as_array().filter(|values| values.len() == count) {
            *list = kept.iter().filter_map(|index| values.get(*index).cloned()).collect();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_the_ends_and_the_largest_stresses() {
        let depth: Vec<f64> = (0..100).map(f64::from).collect();
        let peak = |at: f64| depth.iter().map(|d| 100.0 - (d - at).abs()).collect::<Vec<_>>();
        let mut body = json!({"depth": depth, "von_mises": peak(13.0), "tau_max": peak(17.0)});
        thin(&mut body, 10);
        let depths: Vec<_> =
            body["depth"].as_array().unwrap().iter().map(|d| d.as_f64().unwrap()).collect();
        assert!(depths.len() <= 10 && depths.is_sorted());
        for kept in [0.0, 13.0, 17.0, 99.0] {
            assert!(depths.contains(&kept), "{kept} is not among {depths:?}");
        }
        assert_eq!(body["von_mises"].as_array().unwrap().len(), depths.len());
    }
}
