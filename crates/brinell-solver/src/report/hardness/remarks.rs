//! Findings on a hardness test.

use super::found::Found;
use super::seen::is_pyramid;
use crate::job::TestScale;
use crate::report::findings::Finding;

/// Part of the depth that has to be left.
const SHALLOW: f64 = 0.1;

impl Found<'_> {
    /// Returns what to keep in mind.
    pub fn findings(&self, is_bias_known: bool) -> Vec<Finding> {
        let mut findings = Vec::new();
        if !is_bias_known {
            findings.push(Finding::BiasUnknown { why: self.why_unknown() });
        }
        let scale = self.test.scale;
        if let (Some(number), Some(range)) = (self.number(), range(scale))
            && !(range[0]..=range[1]).contains(&number)
        {
            findings.push(Finding::OutsideScale { scale, range });
        }
        if let Some(left) = self.left().filter(|left| *left < SHALLOW) {
            let left = Some(left).filter(|_| self.load().has_yielded);
            findings.push(Finding::NoDent { left });
        }
        if let Some(least) = self.least_thickness().filter(|_| self.is_thin()) {
            let thickness = self.specimen.depth.get();
            findings.push(Finding::ThinSpecimen { thickness, least });
        }
        if self.is_narrow() {
            let (width, least) = (self.specimen.width.get(), self.least_width());
            findings.push(Finding::NarrowSpecimen { width, least });
        }
        if self.is_blunt() {
            findings.push(Finding::BluntTip { radius: self.test.radius() });
        }
        if is_pyramid(self.test) {
            findings.push(Finding::EqualCone);
        }
        findings
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
