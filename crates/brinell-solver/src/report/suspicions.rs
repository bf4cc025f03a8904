//! Sentences on what in a job is probably not meant. Each names its field first.

use crate::job::suspicions::{Guess, Suspected, Suspicion};
use crate::job::{Quantity, Units};
use crate::units::{UnitConverter, rounded};

/// Returns the sentences in the units of the job.
pub(super) fn text(suspicion: &Suspicion, write: UnitConverter) -> String {
    format!("`{}`: {}", suspicion.pointer, finding(&suspicion.finding, write))
}

#[expect(clippy::too_many_lines, reason = "one text for each finding")]
fn finding(finding: &Suspected, write: UnitConverter) -> String {
    let units = write.units();
    let stress = |core| write.stress_text(core);
    let length = |core: f64| write.length_text(core);
    match finding {
        Suspected::MillimetresInSi { .. } => {
            "Units are SI, but the figures look like millimetres, newtons and megapascals: metres, \
             N/m and pascals are expected. If they are meant in mm, leave `units` out."
                .to_owned()
        }
        Suspected::YieldBesideModulus { yield_stress, young_modulus, guess } => {
            let guess = match guess {
                Some(Guess::Modulus(factor)) => format!(
                    " A Young's modulus of {} would fit: is it given in another unit, GPa perhaps?",
                    stress(young_modulus * factor)
                ),
                Some(Guess::Stress(factor)) => format!(
                    " A yield stress of {} would fit: is it given in another unit?",
                    stress(yield_stress * factor)
                ),
                None => String::new(),
            };
            format!(
                "The yield stress, {}, is {} of Young's modulus, {}; no firm solid is like that.\
                 {guess}",
                stress(*yield_stress),
                share(yield_stress / young_modulus),
                stress(*young_modulus),
            )
        }
        Suspected::TinyRadius { radius } => format!(
            "A radius of {} is that of some hundred atoms: is it given in another unit?",
            length(*radius)
        ),
        Suspected::ContactWiderThanBody { half_width, limit } => format!(
            "By Hertz's theory this load makes a contact of {} to each side, and a body ends at \
             {}. Is the load in another unit? In plane analyses a force is that of one {} of \
             thickness.",
            length(*half_width),
            length(*limit),
            units.symbol(Quantity::Length),
        ),
        Suspected::TotalStrain { slope, young_modulus, given, meant } => {
            let meant = meant.map_or_else(String::new, |meant| {
                format!(" As total strain it has a yield stress of {}, not {}.", stress(meant), stress(*given))
            });
            format!(
                "The table starts with a slope of {}, {} of Young's modulus: it looks like total \
                 strain, elastic part included, and plastic strain is expected.{meant} \
                 `POST /v1/hardening-curves` and \"From total strain\" on the page convert it.",
                stress(*slope),
                share(slope / young_modulus),
            )
        }
        Suspected::StrainInPercent { largest, given, meant } => format!(
            "Plastic strain goes up to {}, {:.0} %: is it given in per cent? At a plastic strain \
             of 1 % the stress is {} now, and would be {}.",
            rounded(*largest),
            100.0 * largest,
            stress(*given),
            stress(*meant),
        ),
        Suspected::OffsetIsStrain { offset, plastic_strain, factor, given, meant } => format!(
            "`offset` is the factor a of ε_p = a (σ_0/E) (q/σ_0)^m, and {} looks like the strain \
             of a proof stress: the plastic strain at the reference stress is {} now. For {} \
             there a is {}, and the proof stress R_p0.2 {} in place of {}.",
            rounded(*offset),
            rounded(*plastic_strain),
            rounded(*offset),
            rounded(*factor),
            stress(*meant),
            stress(*given),
        ),
        Suspected::DepthBeyondBody { deepest, size } => {
            let end = if size.is_finite() {
                format!(", and the body ends at {}", length(*size))
            } else {
                String::new()
            };
            let (unit, guess) = match units {
                Units::MmNMpa => ("µm", deepest / 1e3),
                Units::Si => ("mm", deepest / 1e3),
            };
            format!(
                "The depths go on to {}{end}: are they in {unit}? Then the last is {}.",
                length(*deepest),
                length(guess)
            )
        }
        Suspected::HardnessOutside { count, of, range: [least, largest] } => format!(
            "{count} of {of} hardnesses, of {} to {} HV, lie outside of the 136 to 622 HV of the \
             steels behind the yield stress: it is extrapolated there.",
            rounded(*least),
            rounded(*largest),
        ),
        Suspected::RockwellAsVickers { largest } => format!(
            "No hardness is above {}: these look like HRC, and HV is expected. Say \
             `\"hardness_scale\": \"HRC\"` if they are.",
            rounded(*largest)
        ),
        Suspected::OneHeight(found) => {
            let places: Vec<_> =
                found.places.iter().map(|[i, j]| format!("[{i}, {j}]")).collect();
            format!(
                "{} of {} heights are exactly {}, the first at {}, and nearly all others differ: \
                 do they stand for missing data? A plateau that is meant is solved as it is.",
                found.count,
                found.of,
                length(found.height),
                places.join(", "),
            )
        }
    }
}

/// Returns a part in per cent, to three digits.
fn share(part: f64) -> String {
    let digits = format!("{:.2e}", 100.0 * part);
    match digits.parse::<f64>() {
        Ok(percent) if (1e-3..1e4).contains(&percent) => format!("{percent} %"),
        _ => format!("{digits} %"),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::job::Job;
    use crate::solver::Unobserved;

    /// Solves a job and returns the remarks with a code.
    fn told(job: &Value, code: &str) -> Vec<String> {
        let report = crate::report::run(&Job::from_value(job).unwrap(), &mut Unobserved).unwrap();
        let notes = report.steps[0].validity.iter().filter(|note| note.code == code);
        notes.map(|note| note.message.clone()).collect()
    }

    fn rollers(material: &Value) -> Value {
        let body = json!({"shape": {"type": "cylinder", "radius": 20}, "material": material});
        json!({"analysis": "plane_strain", "upper": body, "lower": body,
            "load": {"force": 300}, "mesh": {"elements_per_half_width": 5}})
    }

    fn steel(modulus: f64, law: &Value) -> Value {
        json!({"young_modulus": modulus, "poisson_ratio": 0.3, "plasticity": law})
    }

    #[test]
    fn sentences_name_the_field_and_the_figure_that_changes() {
        let law = json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10});
        let found = told(&rollers(&steel(210.0, &law)), "suspicious_units");
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(
            found[0].starts_with("`/upper/material/young_modulus`")
                && found[0].contains("A Young's modulus of 210000 MPa would fit"),
            "{found:?}"
        );
        let law = json!({"law": "table", "points": [[0, 0.001], [0.0017, 350], [0.02, 400]]});
        let found = told(&rollers(&steel(210e3, &law)), "suspicious_curve");
        assert!(found[0].contains("it has a yield stress of 350"), "{found:?}");
        let law = json!({"law": "ramberg_osgood", "reference_stress": 355, "offset": 0.002,
            "exponent": 10});
        let found = told(&rollers(&steel(210e3, &law)), "suspicious_curve");
        assert!(found[0].contains("a is 1.1831") && found[0].contains("355 MPa"), "{found:?}");
    }

    #[test]
    fn depths_in_micrometres_and_hardness_are_told_in_three_dimensions_too() {
        let law = json!({"law": "swift", "yield_stress": 1000, "strain_offset": 0.002,
            "exponent": 0.08, "over_depth": {"hardness":
                {"profile": [[0, 720], [500, 640], [1000, 500], [2000, 380]]}}});
        let ball = json!({"analysis": "three_dimensional",
            "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
            "lower": {"shape": {"type": "flat"}, "material": steel(206e3, &law)},
            "load": {"force": 100}, "mesh": {"elements_per_half_width": 4}});
        let found = told(&ball, "suspicious_profile");
        assert!(
            found[0].contains(
                "2000 mm, and the body ends at 10 mm: are they in µm? Then the last is 2 mm"
            ),
            "{found:?}"
        );
        let found = told(&ball, "yield_by_hardness");
        assert!(found.len() == 2 && found[1].contains("2 of 4 hardnesses"), "{found:?}");
    }
}
