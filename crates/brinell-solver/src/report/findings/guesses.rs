//! Guesses of what in a valid job is not meant: figures in other units, total strain given as
//! plastic, depths in micrometres. A guess follows from the job alone and refuses nothing: somebody
//! may mean it.

use super::Finding;
use crate::job::{Deformable, Hardening, Job, OverDepth, RambergOsgood, Units};
use crate::material::HardeningLaw;
use crate::material::hardening::PolyLine;
use crate::material::tensile::{Measure, TestSettings, YieldRule, hardening_curve};

/// Young's modulus \[MPa\] below which a job in SI probably gives MPa in place of Pa.
const SOFT: f64 = 1.0;
/// Yield strains of solids: whiskers and glasses of metal reach some per cent, single crystals
/// begin to glide near 1e-5.
const YIELD_STRAINS: [f64; 2] = [1e-5, 0.1];
/// Yield strains that a guess has to have.
const COMMON: [f64; 2] = [5e-5, 0.05];
/// Smallest and largest Young's modulus of firm solids \[MPa\].
const FIRM: [f64; 2] = [1e3, 1.5e6];
/// First stress over the largest below which a table rises from nothing.
const NOTHING: f64 = 0.05;
/// Offsets of Ramberg and Osgood's law that are strains of proof stresses.
const PROOF: [f64; 2] = [5e-5, 0.02];
/// Depth beyond which it is in another unit: the deepest cases, of slewing rings, have some 20 mm
/// \[mm\].
const DEEP: f64 = 100.0;
/// Largest hardness on the scale HRC.
const ROCKWELL: f64 = 70.0;

/// Returns what is probably not meant, in the order of the document.
pub(in crate::report) fn guesses(job: &Job) -> Vec<Finding> {
    let mut found = Vec::new();
    for (side, body) in [("upper", &job.upper), ("lower", &job.lower)] {
        if let Some(material) = body.deformable() {
            let at = format!("/{side}/material");
            found.extend(of_units(&at, material, job.units));
            found.extend(of_curve(&at, material));
            found.extend(of_depths(&at, material));
        }
        if let Some(heights) = body.surface.as_ref().and_then(|surface| surface.block()) {
            let pointer = format!("/{side}/surface/heights");
            found.push(Finding::OneHeight { pointer, heights: heights.clone() });
        }
    }
    found
}

fn of_units(at: &str, material: &Deformable, units: Units) -> Option<Finding> {
    let young_modulus = material.elastic.young_modulus.get();
    if units == Units::Si && young_modulus < SOFT {
        return Some(Finding::MillimetresInSi { pointer: format!("{at}/young_modulus") });
    }
    let nominal = material.hardening_law()?.nominal_yield_stress();
    let (weakest, strongest) = material.strength().map_or((1.0, 1.0), |strength| strength.range());
    let [least, most] = YIELD_STRAINS.map(|strain| strain * young_modulus);
    let is_total = || matches!(of_curve(at, material), Some(Finding::TotalStrain { .. }));
    let yield_stress = if strongest * nominal > most {
        strongest * nominal
    } else if weakest * nominal < least && !is_total() {
        weakest * nominal
    } else {
        return None;
    };
    // The power of a thousand that makes a common yield strain.
    let is_in = |[low, high]: [f64; 2], value: f64| (low..=high).contains(&value);
    let fits = |factor: &f64| is_in(COMMON, yield_stress / young_modulus * factor);
    let factor = [1e-3, 1e-6, 1e3, 1e6].into_iter().find(fits);
    let meant_modulus = factor
        .map(|factor| young_modulus / factor)
        .filter(|modulus| !is_in(FIRM, young_modulus) && is_in(FIRM, *modulus));
    let key = if meant_modulus.is_some() { "young_modulus" } else { "plasticity" };
    Some(Finding::YieldBesideModulus {
        pointer: format!("{at}/{key}"),
        yield_stress,
        young_modulus,
        meant: meant_modulus.or_else(|| Some(yield_stress * factor?)),
    })
}

fn of_curve(at: &str, material: &Deformable) -> Option<Finding> {
    let young_modulus = material.elastic.young_modulus.get();
    let pointer = |key: &str| format!("{at}/plasticity/{key}");
    match material.plasticity.as_ref()? {
        Hardening::Table(table) => {
            let points = table.points.as_slice();
            total_strain(pointer("points"), points, young_modulus)
                .or_else(|| in_percent(pointer("points"), points))
        }
        Hardening::RambergOsgood(law) => offset_is_strain(pointer("offset"), law, young_modulus),
        _ => None,
    }
}

/// A table that rises from nothing, or whose second point is the yield stress at its elastic strain.
fn total_strain(pointer: String, points: &[[f64; 2]], young_modulus: f64) -> Option<Finding> {
    let (&[_, given], &[strain, next]) = (points.first()?, points.get(1)?);
    let from_nothing = given <= NOTHING * points.last()?[1];
    let is_elastic = (next / strain / young_modulus - 1.0).abs() <= 0.1;
    let is_doubled = points.len() > 2 && next - given <= 0.01 * next && is_elastic;
    if !(from_nothing || is_doubled) {
        return None;
    }
    let settings = TestSettings {
        measure: Measure::True,
        yield_rule: YieldRule::Offset(1e-4),
        young_modulus: Some(young_modulus),
    };
    let mut total = points.to_vec();
    if is_doubled {
        total[0] = [0.0, 0.0];
    }
    let meant = hardening_curve(&total, settings).ok().map(|curve| curve.points[0][1]);
    Some(Finding::TotalStrain { pointer, given, meant })
}

fn in_percent(pointer: String, points: &[[f64; 2]]) -> Option<Finding> {
    let (step, largest) = (points.get(1)?[0], points.last()?[0]);
    let curve = PolyLine { points: points.to_vec() };
    let (given, meant) = (curve.stress(0.01), curve.stress(1.0));
    let is_coarse = points.len() > 2 && step >= 0.1 && largest > 0.5;
    // Where it makes no difference nothing is to be said.
    let is_percent = (is_coarse || largest > 5.0) && meant > 1.02 * given;
    is_percent.then_some(Finding::StrainInPercent { pointer, largest, given, meant })
}

fn offset_is_strain(pointer: String, law: &RambergOsgood, modulus: f64) -> Option<Finding> {
    let (stress, offset) = (law.reference_stress.get(), law.offset.get());
    let is_strain = (PROOF[0]..=PROOF[1]).contains(&offset);
    let (strain, factor) = (offset * stress / modulus, offset * modulus / stress);
    is_strain.then_some(Finding::OffsetIsStrain { pointer, offset, strain, factor })
}

fn of_depths(at: &str, material: &Deformable) -> Vec<Finding> {
    let over_depth = material.over_depth.as_ref();
    let pointer = format!("{at}/plasticity/over_depth");
    let last = |points: &[[f64; 2]]| points.last().map_or(0.0, |point| point[0]);
    let deepest = over_depth.map(|profile| match profile {
        OverDepth::Factors(points) => (pointer.clone(), last(points)),
        OverDepth::Hardness(hardness) => {
            (format!("{pointer}/hardness/profile"), last(&hardness.profile))
        }
        OverDepth::Case(case) => (format!("{pointer}/hardness/case_depth"), case.case_depth.get()),
    });
    let stressed = material.initial_stress.last();
    let stressed = stressed.map(|row| (format!("{at}/initial_stress"), row.depth.get()));
    let all = deepest.into_iter().chain(stressed).filter(|(_, deepest)| *deepest > DEEP);
    let mut found: Vec<_> =
        all.map(|(pointer, deepest)| Finding::DeepProfile { pointer, deepest }).collect();
    let largest = over_depth.and_then(|all| all.hardnesses().into_iter().reduce(f64::max));
    if let Some(largest) = largest.filter(|largest| *largest <= ROCKWELL) {
        let pointer = format!("{pointer}/hardness");
        found.push(Finding::RockwellAsVickers { pointer, largest });
    }
    found
}

#[cfg(test)]
#[path = "guesses_tests.rs"]
mod tests;
