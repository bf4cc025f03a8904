//! The limits of the two theories of plasticity, and the loads that need one of them.

use super::hardness::LEAST_INCREMENTS;
use super::{
    Analysis, Coupling, Deformable, FaultCode, FieldError, HistoryLoad, Job, Load, Material,
    Named, Shape, Target, TargetFigure, Theory,
};

impl Job {
    /// Returns the faults of a job that the chosen theory of plasticity cannot solve.
    pub(super) fn faults_of_theory(&self) -> Vec<FieldError> {
        let mut faults = Vec::new();
        let mut fault = |pointer: String, detail: &str| {
            faults.push(FieldError {
                pointer,
                code: FaultCode::Inconsistent,
                detail: detail.to_owned(),
            });
        };
        match self.solver.theory {
            Theory::Flow => {
                if self.solver.coupling == Coupling::SecantStiffness {
                    let detail = "`secant_stiffness` has the moduli of deformation theory, which \
                                  `flow` does not know; take `accelerated`, `strong` or `weak`, \
                                  or the theory `deformation`";
                    fault("/solver/coupling".to_owned(), detail);
                }
            }
            // The test refuses it, and has increments and a load of zero of its own.
            Theory::Deformation if self.load.hardness().is_some() => {}
            Theory::Deformation => {
                if self.solver.increments.is_some() {
                    let detail =
                        "deformation theory has no increments; they need the theory `flow`";
                    fault("/solver/increments".to_owned(), detail);
                }
                for (side, body) in [("upper", &self.upper), ("lower", &self.lower)] {
                    if body.deformable().is_some_and(|material| !material.backstress.is_empty()) {
                        let detail =
                            "deformation theory knows no backstress; it needs the theory `flow`";
                        fault(format!("/{side}/material/plasticity/backstress"), detail);
                    }
                }
                if let Load::History(loads) = &self.load {
                    let is_zero = |load: &HistoryLoad| load.magnitude() == 0.0;
                    for (k, _) in loads.iter().enumerate().filter(|(_, load)| is_zero(load)) {
                        let detail = "deformation theory takes each load from rest, where a load \
                                      of zero makes no contact that could be solved; unloading \
                                      needs the theory `flow`";
                        fault(format!("/load/history/{k}"), detail);
                    }
                }
                if let Load::Target(Target { figure, .. }) = self.load
                    && figure.is_permanent()
                {
                    let detail = "deformation theory knows no unloading, so nothing is left of a \
                                  contact; it needs the theory `flow`";
                    fault(format!("/load/target/{}", figure.name()), detail);
                }
            }
        }
        if let Load::Target(Target { figure, .. }) = self.load
            && figure.needs_yield()
            && !self.has_plasticity()
        {
            let detail = "neither body has a hardening law, so nothing yields under any force";
            fault(format!("/load/target/{}", figure.name()), detail);
        }
        if let Load::Target(Target { figure: figure @ TargetFigure::MaxPlasticStrain, value }) =
            self.load
            && self.bodies().into_iter().any(|body| does_not_harden(&body.material, value.get()))
        {
            let detail = "the largest plastic strain of a material that does not harden has no \
                          limit on smaller and smaller elements, so that it tells no force; ask \
                          for a dent or a permanent approach, or give a curve that rises";
            fault(format!("/load/target/{}", figure.name()), detail);
        }
        faults
    }

    /// Returns the faults of a load that rolls where nothing rolls, or by which this program does
    /// not roll.
    pub(super) fn faults_of_rolling(&self) -> Vec<FieldError> {
        let Load::Rolling(_) = self.load else { return Vec::new() };
        let mut faults = Vec::new();
        let mut fault = |pointer: &str, detail: &str| {
            faults.push(FieldError {
                pointer: pointer.to_owned(),
                code: FaultCode::Inconsistent,
                detail: detail.to_owned(),
            });
        };
        if !matches!(self.analysis, Analysis::PlaneStrain | Analysis::ThreeDimensional) {
            let detail = "lines roll with the analysis \"plane_strain\", and balls, crowned \
                          rollers and raceways with \"three_dimensional\"";
            fault("/load/rolling", detail);
        }
        if self.solver.theory == Theory::Deformation {
            let detail = "a load that rolls takes the stress off what it has passed, which \
                          deformation theory does not know; it needs the theory `flow`";
            fault("/solver/theory", detail);
        }
        if self.solver.increments.is_some() {
            fault("/solver/increments", "a pass is solved as a whole and has no increments");
        }
        if self.solver.coupling == Coupling::SecantStiffness {
            let detail = "a track has no stiffness that could take secant moduli; take \
                          `accelerated`, `strong` or `weak`";
            fault("/solver/coupling", detail);
        }
        faults
    }

    /// Returns the faults of a hardness test that is no contact of revolution under flow theory
    /// with a block that deforms.
    pub(super) fn faults_of_hardness(&self) -> Vec<FieldError> {
        if self.load.hardness().is_none() {
            return Vec::new();
        }
        let mut faults = Vec::new();
        let mut fault = |pointer: &str, detail: &str| {
            let (pointer, detail) = (pointer.to_owned(), detail.to_owned());
            faults.push(FieldError { pointer, code: FaultCode::Inconsistent, detail });
        };
        if self.analysis != Analysis::Axisymmetric {
            let detail = "a hardness test is a contact of revolution: \"axisymmetric\"";
            fault("/analysis", detail);
        }
        if self.solver.theory == Theory::Deformation {
            let detail = "a hardness test unloads, which deformation theory does not know; it \
                          needs the theory `flow`";
            fault("/solver/theory", detail);
        }
        if self.solver.increments.is_some_and(|increments| increments < LEAST_INCREMENTS) {
            let detail = "a hardness test has at least 8 increments for each load: its diameter \
                          follows from them";
            fault("/solver/increments", detail);
        }
        if self.lower.material == Material::Rigid {
            fault("/lower/material", "a rigid specimen takes no indentation");
        }
        if !matches!(self.lower.shape, Shape::Block(_)) {
            fault("/lower/shape/type", "the specimen of a hardness test is a \"block\"");
        }
        faults
    }
}

/// Whether the hardening curve of a material does not rise at a plastic strain.
fn does_not_harden(material: &Material, strain: f64) -> bool {
    let Material::Deformable(material) = material else { return false };
    Deformable::hardening_law(material).is_some_and(|law| law.slope(strain) <= 0.0)
}
