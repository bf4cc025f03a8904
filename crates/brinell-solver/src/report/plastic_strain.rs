//! The largest plastic strain: whether it is independent of the mesh, and whether the hardening
//! curve of the material is accurate enough for it.

use crate::job::{Deformable, Hardening, Job, Load, Material, TargetFigure};
use crate::material::HardeningLaw;
use crate::solver::{BodySolution, StepSolution};

/// Plastic strain below which a bilinear curve represents a real material badly.
const SMALL_STRAIN: f64 = 0.01;

/// Remark on the strain of a material that does not harden.
pub(super) const UNBOUNDED: &str = "The largest plastic strain of a material that does not harden \
                                    has no limit on smaller and smaller elements, and is not \
                                    given. The plastic area and the mean plastic strain in it do \
                                    not depend on the mesh.";

/// Returns the largest equivalent plastic strain of a body, or `None` if its material no longer
/// hardens at this strain. Plastic flow then gathers in bands of the width of one element, and the
/// strain grows with the density of the mesh.
pub(super) fn largest(body: &BodySolution) -> Option<f64> {
    let strain = body.max_plastic_strain();
    bounded(strain, body.model.hardening())
}

/// Returns the largest plastic strain, or `None` if the hardening curve no longer rises there.
pub(super) fn bounded(strain: f64, law: Option<&dyn HardeningLaw>) -> Option<f64> {
    (strain == 0.0 || law.is_none_or(|law| law.slope(strain) > 0.0)).then_some(strain)
}

/// Returns codes and texts of the remarks on plastic strain.
pub(super) fn remarks(job: &Job, step: &StepSolution) -> Vec<(&'static str, String)> {
    let mut remarks = Vec::new();
    if step.bodies.iter().flatten().any(|body| largest(body).is_none()) {
        remarks.push(("unbounded_strain", UNBOUNDED.to_owned()));
    }
    let strain =
        step.bodies.iter().flatten().map(|body| body.max_plastic_strain()).fold(0.0, f64::max);
    remarks.extend(bilinear_curve(job, strain));
    remarks
}

/// Returns the remark on a small permanent deformation that is computed with a bilinear curve.
pub(super) fn bilinear_curve(job: &Job, strain: f64) -> Option<(&'static str, String)> {
    let is_permanent = match &job.load {
        Load::Target(target) => {
            target.figure.is_permanent() || target.figure == TargetFigure::MaxPlasticStrain
        }
        _ => false,
    };
    let is_bilinear = |material: &Material| match material {
        Material::Deformable(material) => {
            matches!(Deformable::plasticity(material), Some(Hardening::Bilinear(_)))
        }
        Material::Rigid => false,
    };
    let has_bilinear =
        [&job.upper, &job.lower].into_iter().any(|body| is_bilinear(&body.material));
    if is_permanent && has_bilinear && strain < SMALL_STRAIN {
        let message = "A bilinear curve is elastic up to its yield stress; steels begin to flow \
                       below that, little by little. Forces of a permanent deformation below 1 % \
                       strain differ by up to a factor of two from those of a measured curve: \
                       take the law `swift` or `table` (api/materials.json has 100Cr6).";
        return Some(("bilinear_curve", message.to_owned()));
    }
    None
}
