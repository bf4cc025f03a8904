//! What in a valid job is probably not meant: figures in other units, total strain given as
//! plastic, depths in micrometres. Each finding has its figures, and the report its words.
//!
//! A finding follows from the job alone. It refuses nothing: somebody may mean it.

use super::fields::{Figure, Value};
use super::no_data::NoData;
use super::{
    Analysis, Body, Deformable, Domain, Hardening, HistoryLoad, InitialStress, Job, Load,
    Material, OverDepth, RambergOsgood, Shape, TablePoints, Units,
};
use crate::material::HardeningLaw;
use crate::material::hardening::PolyLine;
use crate::material::tensile::{Measure, TestSettings, YieldRule, hardening_curve};

/// Something in a valid job that is probably not meant.
#[derive(Debug, Clone, PartialEq)]
pub struct Suspicion {
    /// Code of the remark.
    pub code: &'static str,
    /// JSON pointer of the figure.
    pub pointer: String,
    /// The finding with its figures.
    pub finding: Suspected,
}

/// A finding. Figures are in N–mm–MPa.
#[derive(Debug, Clone, PartialEq)]
pub enum Suspected {
    /// A job in SI has a Young's modulus that is one of steel in MPa.
    MillimetresInSi {
        /// Young's modulus.
        young_modulus: f64,
    },
    /// No solid has this yield stress beside this Young's modulus.
    YieldBesideModulus {
        /// Yield stress.
        yield_stress: f64,
        /// Young's modulus.
        young_modulus: f64,
        /// The figure that would fit.
        guess: Option<Guess>,
    },
    /// A radius of less than 0.1 µm.
    TinyRadius {
        /// The radius.
        radius: f64,
    },
    /// By Hertz's theory the contact is wider than a body.
    ContactWiderThanBody {
        /// Half-width by Hertz's theory.
        half_width: f64,
        /// Half the width of the body, or its radius.
        limit: f64,
    },
    /// A table of plastic strain rises from nothing, or its first step is `σ/E`.
    TotalStrain {
        /// First slope of the table.
        slope: f64,
        /// Young's modulus.
        young_modulus: f64,
        /// First stress of the table.
        given: f64,
        /// Yield stress if its strains are total strains; `None` if they make no curve.
        meant: Option<f64>,
    },
    /// A table has plastic strains of more than one.
    StrainInPercent {
        /// Largest plastic strain.
        largest: f64,
        /// Stress at a plastic strain of 1 %.
        given: f64,
        /// The same if the strains are in per cent.
        meant: f64,
    },
    /// `offset` of Ramberg and Osgood's law, a factor, is the strain of a proof stress.
    OffsetIsStrain {
        /// The offset.
        offset: f64,
        /// Plastic strain at the reference stress.
        plastic_strain: f64,
        /// The factor that makes the offset that strain.
        factor: f64,
        /// Stress at a plastic strain of 0.2 %.
        given: f64,
        /// The same with this factor.
        meant: f64,
    },
    /// A table over depth goes on far beyond the body.
    DepthBeyondBody {
        /// Largest depth, or the case depth.
        deepest: f64,
        /// Depth of the body, or its radius.
        size: f64,
    },
    /// Hardness beyond the steels of the regression.
    HardnessOutside {
        /// Number of such figures.
        count: usize,
        /// Number of all figures.
        of: usize,
        /// Smallest and largest hardness \[HV\].
        range: [f64; 2],
    },
    /// All hardnesses are such as the scale HRC has.
    RockwellAsVickers {
        /// Largest hardness.
        largest: f64,
    },
    /// Many heights have exactly one value, and all others differ.
    OneHeight(NoData),
}

/// A figure that would fit, as a factor of the one that is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Guess {
    /// Young's modulus, e.g. 1000 times as large: it was given in GPa.
    Modulus(f64),
    /// Yield stress.
    Stress(f64),
}

/// Codes of findings.
pub const UNITS: &str = "suspicious_units";
/// A hardening curve.
pub const CURVE: &str = "suspicious_curve";
/// A table over depth.
pub const PROFILE: &str = "suspicious_profile";
/// Heights.
pub const HEIGHTS: &str = "suspicious_heights";
/// Hardness beyond the regression.
pub const BY_HARDNESS: &str = "yield_by_hardness";

/// Young's modulus \[MPa\] below which a job in SI probably gives MPa in place of Pa.
const SOFT: f64 = 1.0;
/// Yield strains of solids: whiskers and glasses of metal reach some per cent, single crystals
/// begin to glide near 1e-5.
const YIELD_STRAINS: [f64; 2] = [1e-5, 0.1];
/// Yield strains that a guess has to have.
const COMMON: [f64; 2] = [5e-5, 0.05];
/// Young's moduli \[MPa\] that are those of metals in GPa, and a yield stress that no such soft
/// solid has.
const SOFT_SOLIDS: [f64; 2] = [50.0, 1000.0];
const FIRM: f64 = 20.0;
/// Smallest and largest Young's modulus of firm solids \[MPa\].
const FIRM_SOLIDS: [f64; 2] = [1e3, 1.5e6];
/// Radius \[mm\] below which a body is no continuum.
const ATOMIC: f64 = 1e-4;
/// Slopes of a table over Young's modulus that are elastic: an extensometer is a tenth off, the
/// way of a crosshead more.
const ELASTIC: [f64; 2] = [0.3, 1.1];
/// First stress over the largest below which a table rises from nothing.
const NOTHING: f64 = 0.1;
/// Offsets of Ramberg and Osgood's law that are strains of proof stresses.
const PROOF: [f64; 2] = [5e-5, 0.02];
/// Depth of a table over that of the body, and depth \[mm\], beyond which it is in another unit:
/// the deepest cases, of slewing rings, have some 20 mm.
const DEEP: (f64, f64) = (5.0, 100.0);
/// Hardness of the steels of the regression \[HV\].
const REGRESSION: [f64; 2] = [136.0, 622.0];
/// Largest hardness on the scale HRC.
const ROCKWELL: f64 = 70.0;

impl Job {
    /// Returns what is probably not meant, in the order of the document.
    pub fn suspicions(&self) -> Vec<Suspicion> {
        let bodies = [("/upper", &self.upper, &self.lower), ("/lower", &self.lower, &self.upper)];
        let mut found: Vec<Suspicion> = Vec::new();
        for (side, body, other) in bodies {
            let mut say = |code, pointer: &str, finding| {
                found.push(Suspicion { code, pointer: format!("{side}{pointer}"), finding });
            };
            of_shape(&body.shape, &mut say);
            if let Material::Deformable(material) = &body.material {
                of_material(material, self.units, &mut say);
                let size = size(&body.shape).or_else(|| self::size(&other.shape));
                of_depths(material, size, &mut say);
            }
            if let Some(heights) = body.surface.as_ref().and_then(|surface| surface.block()) {
                say(HEIGHTS, "/surface/heights", Suspected::OneHeight(heights.clone()));
            }
        }
        if let Some((half_width, limit)) = self.wider_than_body() {
            found.push(Suspicion {
                code: UNITS,
                pointer: "/load".to_owned(),
                finding: Suspected::ContactWiderThanBody { half_width, limit },
            });
        }
        found
    }

    /// Returns the half-width by Hertz's theory under the largest load and the size of the
    /// smallest body, if the contact is wider.
    fn wider_than_body(&self) -> Option<(f64, f64)> {
        let bodies = [&self.upper, &self.lower];
        if bodies.iter().any(|body| body.surface.is_some()) {
            return None;
        }
        let curvature: f64 = match self.gap_curvatures() {
            Some([least, most]) => 0.5 * (least + most),
            None => bodies.iter().map(|body| curvature(&body.shape)).sum::<Option<f64>>()?,
        };
        let radius = 1.0 / curvature;
        let compliance: f64 = bodies.iter().map(|body| compliance(body)).sum();
        let is_line = matches!(self.analysis, Analysis::PlaneStrain | Analysis::PlaneStress);
        let by_force = |force: f64| {
            if is_line {
                (4.0 * force * radius * compliance / std::f64::consts::PI).sqrt()
            } else {
                (0.75 * force * radius * compliance).cbrt()
            }
        };
        let by_approach = |approach: f64| (radius * approach.max(0.0)).sqrt();
        let sizes: Vec<f64> = match &self.load {
            Load::Forces(forces) => forces.iter().map(|force| by_force(force.get())).collect(),
            Load::Approaches(ways) => ways.iter().map(|way| by_approach(way.get())).collect(),
            Load::History(loads) => loads
                .iter()
                .map(|load| match *load {
                    HistoryLoad::Force(force) => by_force(f64::from(force)),
                    HistoryLoad::Approach(way) => by_approach(f64::from(way)),
                })
                .collect(),
            Load::Rolling(rolling) => vec![by_force(rolling.force.get())],
            Load::Onset | Load::Target(_) => return None,
        };
        let half_width = sizes.into_iter().fold(0.0, f64::max);
        let limit = bodies.iter().filter_map(|body| half_size(&body.shape)).reduce(f64::min)?;
        (half_width > limit).then_some((half_width, limit))
    }
}

/// Adds a finding: code, pointer within the body, figures.
type Say<'a> = dyn FnMut(&'static str, &str, Suspected) + 'a;

fn of_shape(shape: &Shape, say: &mut Say<'_>) {
    for (key, radius) in lengths(shape).filter(|(key, _)| key.starts_with("radius")) {
        if radius.abs() < ATOMIC {
            say(UNITS, &format!("/shape/{key}"), Suspected::TinyRadius { radius });
        }
    }
}

fn of_material(material: &Deformable, units: Units, say: &mut Say<'_>) {
    let young_modulus = material.elastic().young_modulus.get();
    if units == Units::Si && young_modulus < SOFT {
        let finding = Suspected::MillimetresInSi { young_modulus };
        say(UNITS, "/material/young_modulus", finding);
        return;
    }
    let Some(law) = material.hardening_law() else { return };
    let curve = material.plasticity().and_then(|given| of_curve(given, &*law, young_modulus));
    let is_total = matches!(curve, Some((_, Suspected::TotalStrain { .. })));
    let factors = material.strength().map_or((1.0, 1.0), |strength| strength.range());
    let nominal = law.nominal_yield_stress();
    let (weakest, strongest) = (factors.0 * nominal, factors.1 * nominal);
    let is_soft = (SOFT_SOLIDS[0]..=SOFT_SOLIDS[1]).contains(&young_modulus) && strongest > FIRM;
    let yield_stress = if strongest > YIELD_STRAINS[1] * young_modulus || is_soft {
        Some(strongest)
    } else {
        (weakest < YIELD_STRAINS[0] * young_modulus && !is_total).then_some(weakest)
    };
    if let Some(yield_stress) = yield_stress {
        let guess = guess(yield_stress, young_modulus);
        let at = if matches!(guess, Some(Guess::Modulus(_))) {
            "/material/young_modulus"
        } else {
            "/material/plasticity"
        };
        say(UNITS, at, Suspected::YieldBesideModulus { yield_stress, young_modulus, guess });
    }
    if let Some((key, finding)) = curve {
        say(CURVE, &format!("/material/plasticity/{key}"), finding);
    }
}

/// Returns the power of a thousand that makes a common yield strain.
fn guess(yield_stress: f64, young_modulus: f64) -> Option<Guess> {
    let fits = |strain: f64| (COMMON[0]..=COMMON[1]).contains(&strain);
    let strain = yield_stress / young_modulus;
    let factor = [1e-3, 1e-6, 1e3, 1e6].into_iter().find(|factor| fits(strain * factor))?;
    let is_firm = |modulus: f64| (FIRM_SOLIDS[0]..=FIRM_SOLIDS[1]).contains(&modulus);
    let is_modulus = !is_firm(young_modulus) && is_firm(young_modulus / factor);
    Some(if is_modulus { Guess::Modulus(1.0 / factor) } else { Guess::Stress(factor) })
}

/// Returns the key and the finding of a hardening curve.
fn of_curve(
    law: &Hardening,
    curve: &dyn HardeningLaw,
    young_modulus: f64,
) -> Option<(&'static str, Suspected)> {
    match law {
        Hardening::Table(table) => {
            let found = total_strain(&table.points, young_modulus);
            Some(("points", found.or_else(|| in_percent(&table.points))?))
        }
        Hardening::RambergOsgood(law) => {
            Some(("offset", offset_is_strain(law, curve, young_modulus)?))
        }
        _ => None,
    }
}

fn total_strain(points: &TablePoints, young_modulus: f64) -> Option<Suspected> {
    let points = points.as_slice();
    let (first, last) = (points[0], points[points.len() - 1]);
    let rising = points.iter().rposition(|point| point[1] <= 0.5 * last[1]).unwrap_or(0).max(1);
    let &[strain, stress] = points.get(rising)?;
    let is_elastic = |slope: f64| (ELASTIC[0]..=ELASTIC[1]).contains(&(slope / young_modulus));
    let rise = (stress - first[1]) / strain;
    let from_nothing = first[1] <= NOTHING * last[1]
        && (is_elastic(rise)
            || (first[1] <= 0.5 * NOTHING * last[1] && points[1][1] > 0.5 * last[1]));
    // Yield stress, yield stress at its elastic strain, …
    let [next_strain, next] = points[1];
    let own = next / next_strain;
    let doubled = points.len() > 2
        && next - first[1] <= 0.01 * next
        && (own / young_modulus - 1.0).abs() <= 0.1;
    if !(from_nothing || doubled) {
        return None;
    }
    let settings = TestSettings {
        measure: Measure::True,
        yield_rule: YieldRule::Offset(1e-4),
        young_modulus: Some(young_modulus),
    };
    let total: Vec<[f64; 2]> = if doubled {
        std::iter::once([0.0, 0.0]).chain(points[1..].iter().copied()).collect()
    } else {
        points.to_vec()
    };
    let meant = hardening_curve(&total, settings).ok().map(|curve| curve.points[0][1]);
    let slope = if doubled { own } else { rise };
    Some(Suspected::TotalStrain { slope, young_modulus, given: first[1], meant })
}

fn in_percent(points: &TablePoints) -> Option<Suspected> {
    let points = points.as_slice();
    let largest = points[points.len() - 1][0];
    let step = points.get(1)?[0];
    let is_coarse = points.len() > 2 && step >= 0.1 && largest > 0.5;
    let is_long = largest > 5.0 || (largest >= 2.0 && step >= 0.05);
    let curve = PolyLine { points: points.to_vec() };
    let (given, meant) = (curve.stress(0.01), curve.stress(1.0));
    // Where it makes no difference nothing is to be said.
    let end = if largest > 5.0 { curve.stress(largest) } else { meant };
    let matters = end > 1.02 * given;
    ((is_coarse || is_long) && matters).then_some(Suspected::StrainInPercent {
        largest,
        given,
        meant,
    })
}

fn offset_is_strain(
    law: &RambergOsgood,
    curve: &dyn HardeningLaw,
    young_modulus: f64,
) -> Option<Suspected> {
    let (stress, offset) = (law.reference_stress.get(), law.offset.get());
    let plastic_strain = offset * stress / young_modulus;
    let factor = offset * young_modulus / stress;
    let is_strain = (PROOF[0]..=PROOF[1]).contains(&offset);
    let meant = stress * (2e-3 / offset).powf(1.0 / law.exponent.get());
    is_strain.then(|| Suspected::OffsetIsStrain {
        offset,
        plastic_strain,
        factor,
        given: curve.stress(2e-3),
        meant,
    })
}

fn of_depths(material: &Deformable, size: Option<f64>, say: &mut Say<'_>) {
    let size = size.unwrap_or(f64::INFINITY);
    let is_deep = |depth: f64| depth > (DEEP.0 * size).min(DEEP.1);
    let last = |points: &[[f64; 2]]| points.last().map_or(0.0, |point| point[0]);
    let over_depth = material.over_depth();
    if let Some(profile) = over_depth {
        let (key, deepest) = match profile {
            OverDepth::Factors(points) => ("", last(points)),
            OverDepth::Hardness(hardness) => ("/hardness/profile", last(&hardness.profile)),
            OverDepth::Case(case) => ("/hardness/case_depth", case.case_depth.get()),
        };
        if is_deep(deepest) {
            let pointer = format!("/material/plasticity/over_depth{key}");
            say(PROFILE, &pointer, Suspected::DepthBeyondBody { deepest, size });
        }
    }
    let deepest =
        material.initial_stress().last().map_or(0.0, |row: &InitialStress| row.depth.get());
    if is_deep(deepest) {
        let finding = Suspected::DepthBeyondBody { deepest, size };
        say(PROFILE, "/material/initial_stress", finding);
    }
    let Some(hardness) = over_depth.map(OverDepth::hardnesses).filter(|all| !all.is_empty())
    else {
        return;
    };
    let pointer = "/material/plasticity/over_depth/hardness";
    let ends = |(low, high): (f64, f64), value: &f64| (value.min(low), value.max(high));
    let (low, high) = hardness.iter().fold((f64::INFINITY, 0.0), ends);
    if high <= ROCKWELL {
        say(PROFILE, pointer, Suspected::RockwellAsVickers { largest: high });
        return;
    }
    let is_outside = |value: &&f64| !(REGRESSION[0]..=REGRESSION[1]).contains(*value);
    let count = hardness.iter().filter(is_outside).count();
    if count > 0 {
        let finding = Suspected::HardnessOutside { count, of: hardness.len(), range: [low, high] };
        say(BY_HARDNESS, pointer, finding);
    }
}

/// Returns the lengths of a shape by their keys \[mm\].
fn lengths(shape: &Shape) -> impl Iterator<Item = (&'static str, f64)> {
    shape.values().into_iter().filter_map(|(field, value)| {
        let is_length = matches!(
            field.kind,
            super::fields::FieldKind::Figure(Figure::Quantity(
                Domain::Length | Domain::Position | Domain::Depth
            ))
        );
        match value {
            Value::Figure(figure) if is_length => Some((field.key, figure)),
            _ => None,
        }
    })
}

/// Returns the least of the lengths with these keys that a shape has first.
fn length(shape: &Shape, keys: &[&[&str]]) -> Option<f64> {
    keys.iter().find_map(|keys| {
        let found = lengths(shape).filter(|(key, _)| keys.contains(key));
        found.map(|(_, length)| length.abs()).reduce(f64::min)
    })
}

/// Returns the depth of a body, or else its radius; `None` of a half-space that is flat.
fn size(shape: &Shape) -> Option<f64> {
    length(
        shape,
        &[&["depth"], &["semi_axis_y"], &["radius"], &["radius_x", "radius_y"], &["width"]],
    )
}

/// Returns half the width of a body, or else its radius.
fn half_size(shape: &Shape) -> Option<f64> {
    match shape {
        Shape::Cylinder(_) | Shape::Sphere(_) | Shape::Roller(_) | Shape::Curved(_) => {
            length(shape, &[&["radius"], &["radius_x", "radius_y"]])
        }
        Shape::Block(_) | Shape::Parabola(_) => {
            length(shape, &[&["width"]]).map(|width| 0.5 * width)
        }
        _ => None,
    }
}

/// Returns the curvature of a plane or axisymmetric body at the middle \[1/mm\]; `None` if it has
/// none there.
fn curvature(shape: &Shape) -> Option<f64> {
    match shape {
        Shape::Cylinder(_) | Shape::Parabola(_) => Some(length(shape, &[&["radius"]])?.recip()),
        Shape::Block(_) => Some(0.0),
        _ => None,
    }
}

/// Returns `(1 - ν²)/E` of a body \[1/MPa\]; 0 of a rigid one.
fn compliance(body: &Body) -> f64 {
    match &body.material {
        Material::Rigid => 0.0,
        Material::Deformable(material) => material.elastic().plane_strain_modulus().recip(),
    }
}

#[cfg(test)]
#[path = "suspicions_tests.rs"]
mod tests;
