//! What the format can say and this version cannot solve yet.

use super::reader::Named;
use super::{Analysis, FieldError, Hardening, Job, Load, Material, Shape};

/// Features that are read and checked but refused. Deleting a line offers the feature.
const NOT_YET: &[(Feature, &str)] = &[
    (Feature::Analysis, "plane_stress"),
    (Feature::Analysis, "axisymmetric"),
    (Feature::Shape, "groove"),
    (Feature::Shape, "profile"),
    (Feature::Law, "table"),
    (Feature::Law, "swift"),
    (Feature::Law, "ludwik"),
    (Feature::Law, "voce"),
    (Feature::Load, "forces"),
    (Feature::Load, "approach"),
    (Feature::Load, "approaches"),
];

/// A place of the format that offers a choice of words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Feature {
    Analysis,
    Shape,
    Law,
    Load,
}

impl Feature {
    const fn name(self) -> &'static str {
        match self {
            Self::Analysis => "analysis",
            Self::Shape => "shape",
            Self::Law => "plasticity law",
            Self::Load => "load",
        }
    }

    fn words(self) -> Vec<&'static str> {
        match self {
            Self::Analysis => Analysis::ALL.iter().map(|analysis| analysis.name()).collect(),
            Self::Shape => Shape::TYPES.to_vec(),
            Self::Law => Hardening::LAWS.to_vec(),
            Self::Load => Load::KINDS.to_vec(),
        }
    }

    /// The refusal of a word, unless it is offered.
    fn refuse(self, word: &'static str, pointer: String) -> Option<FieldError> {
        if !NOT_YET.contains(&(self, word)) {
            return None;
        }
        let name = self.name();
        let offered: Vec<_> =
            self.words().into_iter().filter(|other| !NOT_YET.contains(&(self, other))).collect();
        let offered = offered.join(", ");
        let detail = format!(
            "{name} `{word}` is part of the format but this version does not solve it yet; it solves: {offered}"
        );
        Some(FieldError { pointer, detail })
    }
}

impl Job {
    /// What this version cannot solve yet of a job that is otherwise in order; empty if it can solve it.
    pub fn unsupported(&self) -> Vec<FieldError> {
        let mut used = vec![(Feature::Analysis, self.analysis.name(), "/analysis".to_owned())];
        for (side, body) in [("upper", &self.upper), ("lower", &self.lower)] {
            used.push((Feature::Shape, body.shape.type_name(), format!("/{side}/shape/type")));
            if let Material::Deformable(material) = &body.material
                && let Some(curve) = material.plasticity()
            {
                used.push((Feature::Law, curve.law_name(), format!("/{side}/material/plasticity/law")));
            }
        }
        used.push((Feature::Load, self.load.kind(), "/load".to_owned()));
        used.into_iter().filter_map(|(feature, word, pointer)| feature.refuse(word, pointer)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_refused_word_is_a_word_of_the_format() {
        for (feature, word) in NOT_YET {
            assert!(feature.words().contains(word), "{word}");
        }
    }

    #[test]
    fn a_refusal_names_what_is_offered() {
        let fault = Feature::Analysis.refuse("axisymmetric", "/analysis".to_owned()).unwrap();
        insta::assert_snapshot!(fault, @"/analysis: analysis `axisymmetric` is part of the format but this version does not solve it yet; it solves: plane_strain");
        assert_eq!(Feature::Shape.refuse("block", String::new()), None);
    }
}
