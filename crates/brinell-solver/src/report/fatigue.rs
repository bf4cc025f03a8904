//! Fatigue in a report: who computes it, curves over depth, remarks. Its rows are in
//! `answers/fatigue.rs`.

use brinell_halfspace::{Fatigue, Stop, Stopped, Utilization};
use serde::{Deserialize, Serialize};
use strum::{IntoStaticStr, VariantArray};

use super::findings::Finding;
use super::rolling::SolvedHardening;
use crate::job::{Analysis, FatigueLimits, Job, Load, Named, Side};
use crate::solver::method::observer::ask;
use crate::solver::{Interrupt, Observer};
use crate::units::UnitConverter;

/// A criterion of high-cycle fatigue.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, IntoStaticStr, VariantArray,
)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum FatigueCriterion {
    /// Dang Van's.
    DangVan,
    /// Crossland's.
    Crossland,
    /// The amplitude of the shear stress along the surface.
    OrthogonalShear,
}

impl Named for FatigueCriterion {}

impl FatigueCriterion {
    /// Returns the criterion in words.
    pub(super) const fn in_words(self) -> &'static str {
        match self {
            Self::DangVan => "Dang Van",
            Self::Crossland => "Crossland",
            Self::OrthogonalShear => "orthogonal shear",
        }
    }
}

/// Utilization over depth by criteria of high-cycle fatigue: the largest across the travel.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Fatigue))]
pub struct FatigueReport {
    /// Depth below the surface, from 0 \[length\].
    pub depth: Vec<f64>,
    /// By Dang Van's criterion; `null` where it does not hold for the limits \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub dang_van: Option<Vec<f64>>,
    /// By Crossland's criterion; `null` where it does not hold for the limits \[1\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub crossland: Option<Vec<f64>>,
    /// By the amplitude of the shear stress along the surface \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub orthogonal_shear: Option<Vec<f64>>,
}

/// The fatigue of a body with limits, or of both that are alike, or why it is not known.
#[derive(Debug, Clone)]
pub(super) struct BodyFatigue {
    pub side: Side,
    pub found: Result<Fatigue, &'static str>,
    /// The rule of hardening, where two were solved, and whether it is that of the verdict.
    pub rule: Option<SolvedHardening>,
    pub is_of_verdict: bool,
    /// Number of the pass.
    pub pass: Option<usize>,
}

/// Returns the fatigue of the bodies with limits under a static load. `of` is that of one body, unless
/// it is `refused`. Of bodies that are alike the lower one stands for both.
///
/// # Errors
/// The observer's [`Interrupt`].
pub(super) fn of_pressed(
    job: &Job,
    is_alike: bool,
    refused: Option<&'static str>,
    observer: &mut dyn Observer,
    mut of: impl FnMut(usize, &mut Stop<'_>) -> Result<Option<Fatigue>, Stopped>,
) -> Result<Vec<BodyFatigue>, Interrupt> {
    let is_indented = job.load.hardness().is_some();
    let refused = is_indented.then_some("an indentation passes over no body").or(refused);
    let sides: &[Side] = if is_alike { &[Side::Lower] } else { &Side::BOTH };
    let mut bodies = Vec::new();
    for side in sides.iter().filter(|side| job.fatigue(**side).is_some()) {
        let mut interrupt = None;
        let mut stop = || {
            interrupt = ask(observer).err();
            interrupt.is_some()
        };
        let found = match refused {
            Some(reason) => Ok(Err(reason)),
            None => {
                of(side.member(), &mut stop).map(|found| found.ok_or("the contact has no width"))
            }
        };
        let found = found.map_err(|Stopped| interrupt.unwrap_or(Interrupt::Cancelled))?;
        bodies.push(BodyFatigue {
            side: *side,
            found,
            rule: None,
            is_of_verdict: true,
            pass: None,
        });
    }
    Ok(bodies)
}

/// Returns the curves over depth.
pub(super) fn curve(fatigue: &Fatigue, write: UnitConverter) -> FatigueReport {
    let of = |criterion: &Option<Utilization>| Some(criterion.as_ref()?.over_depth.clone());
    let [dang_van, crossland, orthogonal_shear] = fatigue.criteria.each_ref().map(of);
    FatigueReport {
        depth: fatigue.depths.iter().map(|depth| write.length(*depth)).collect(),
        dang_van,
        crossland,
        orthogonal_shear,
    }
}

/// Returns the remarks on fatigue.
pub(super) fn remarks(job: &Job) -> Vec<Finding> {
    let limits = Side::BOTH.map(|side| job.fatigue(side));
    let rolls = matches!(job.load, Load::Rolling(_));
    let is_meshed = !rolls && job.analysis != Analysis::ThreeDimensional;
    let by_hardness = limits.contains(&Some(FatigueLimits::FromHardness));
    let of_hardness = by_hardness.then_some(Finding::FatigueByHardness);
    [Finding::Fatigue { rolls, is_meshed }].into_iter().chain(of_hardness).collect()
}
