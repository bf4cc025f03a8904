//! Remarks on a hardness test.

use super::found::Found;
use super::seen::is_pyramid;
use crate::job::{Named, TestScale};
use crate::report::ValidityNote;
use crate::units::{UnitConverter, percent};

/// Part of the depth that has to be left.
const SHALLOW: f64 = 0.1;

impl Found<'_> {
    /// Returns what to keep in mind.
    pub fn remarks(&self, is_bias_known: bool, write: UnitConverter) -> Vec<ValidityNote> {
        let length = |value: f64| write.length_text(value);
        let mut remarks = Vec::new();
        let mut remark = |code: &str, message: String| {
            remarks.push(ValidityNote { code: code.to_owned(), message });
        };
        if !is_bias_known {
            remark("bias_unknown", self.why_unknown().to_owned());
        }
        if let (Some(number), Some([least, most])) = (self.number(), range(self.test.scale))
            && !(least..=most).contains(&number)
        {
            let name = self.test.scale.name();
            let message = format!("The scale {name} is for {least} to {most} by its standard.");
            remark("outside_scale", message);
        }
        if let Some(left) = self.left().filter(|left| *left < SHALLOW) {
            let message = if self.load().has_yielded {
                format!(
                    "{} of the depth is left. Standards measure what is left; this number is that \
                     of the contact under load.",
                    percent(left)
                )
            } else {
                "The specimen has not yielded: no dent is left that could be measured.".to_owned()
            };
            remark("no_dent", message);
        }
        if let Some(least) = self.least_thickness().filter(|_| self.is_thin()) {
            let message = format!(
                "The specimen is {} thick; the standard wants {} for this indentation, so that \
                 the support does not bear it.",
                length(self.specimen.depth.get()),
                length(least)
            );
            remark("thin_specimen", message);
        }
        if self.is_narrow() {
            let message = format!(
                "The specimen is {} wide; the standards want {} for this indentation, so that no \
                 edge gives way.",
                length(self.specimen.width.get()),
                length(self.least_width())
            );
            remark("narrow_specimen", message);
        }
        if self.is_blunt() {
            let message = format!(
                "The tip of {} reaches far into this indentation: its figures are more those of a \
                 ball.",
                length(self.test.radius())
            );
            remark("blunt_tip", message);
        }
        if is_pyramid(self.test) {
            let message = "A pyramid is solved as the cone of equal area, of 70.3° half-angle: \
                           its edges are left out.";
            remark("equal_cone", message.to_owned());
        }
        remarks
    }

    /// Returns why no published result tells the bias.
    fn why_unknown(&self) -> &'static str {
        if self.is_thin() || self.is_narrow() || self.is_blunt() {
            return "Published results with large strains are of sharp tips on large specimens: \
                    what small strains leave out is not known.";
        }
        match self.test.scale {
            TestScale::Hrc => {
                "No published result with large strains is known of the sphero-conical indenter: \
                 what small strains leave out is not known."
            }
            TestScale::Hv | TestScale::Berkovich => {
                "The depth that is left tells the published pressure with large strains where it \
                 is half to 90 % of that under load: what small strains leave out of \
                 it is not known."
            }
            TestScale::Hbw | TestScale::Hrb | TestScale::Sphere => {
                "The ball is not fully plastic, where Tabor's rule begins: what small strains \
                 leave out is not known."
            }
        }
    }
}

/// Numbers for which a scale is meant: ISO 6506-1 and ISO 6508-1.
const fn range(scale: TestScale) -> Option<[f64; 2]> {
    match scale {
        TestScale::Hbw => Some([0.0, 650.0]),
        TestScale::Hrc => Some([20.0, 70.0]),
        TestScale::Hrb => Some([10.0, 100.0]),
        TestScale::Hv | TestScale::Berkovich | TestScale::Sphere => None,
    }
}
