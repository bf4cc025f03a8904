//! Why a track has no answer, or one that its grid cuts off.

use std::ops::Range;

use brinell_material::StreamLaw;
use thiserror::Error;

/// Why a pass has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum TrackFault {
    /// A traction under Hertz's peak pressure that no hardening can bear.
    #[error(
        "friction asks for a shear stress of {traction} MPa at the surface under Hertz's peak \
         pressure, where the material bears {strength} MPa at most, after all hardening"
    )]
    Traction {
        /// `|μ| p` \[MPa\].
        traction: f64,
        /// `k_max(0)` \[MPa\].
        strength: f64,
    },
    /// A pressure far beyond yield.
    #[error(
        "Hertz's peak of {peak} MPa is {} times the yield stress of {yield_stress} MPa: passes are \
         solved up to {} times, a force of {force} N or N/mm", peak / yield_stress, DEEPEST
    )]
    Deep {
        /// Hertz's peak pressure \[MPa\].
        peak: f64,
        /// Yield stress \[MPa\].
        yield_stress: f64,
        /// The largest force that is solved \[N/mm of a line, N\].
        force: f64,
    },
    /// The contact is as wide as the window.
    #[error("the contact reaches the end of the window of {width} mm in which bodies may touch")]
    Window {
        /// Width of the window \[mm\].
        width: f64,
    },
    /// The contact or the plastic zone is as wide as the track.
    #[error("contact or yield reaches the edge of the track, {half_width} mm from its axis")]
    Edge {
        /// Half the width of the track \[mm\].
        half_width: f64,
    },
    /// Flow far from the load, where the ends of the track decide on it.
    #[error(
        "{} % of the plastic flow is at the ends of a track of {length} mm, far from the load; a \
         longer track may have an answer",
        100.0 * part
    )]
    Far {
        /// The part of the flow.
        part: f64,
        /// Length of the track \[mm\].
        length: f64,
    },
    /// A residual stress that the material does not bear.
    #[error(
        "the residual stress exceeds the yield stress by {} %; more columns or fewer passes may \
         have an answer",
        100.0 * excess
    )]
    BeyondYield {
        /// [`Outlet::excess`](super::Outlet::excess).
        excess: f64,
    },
    /// A balance of energy that does not close.
    #[error(
        "work of the load, plastic work and stored energy of the pass differ by {} % of the \
         plastic work; more columns or a smaller load may have an answer",
        100.0 * gap
    )]
    Energy {
        /// What is missing, over the largest plastic work of a pass so far.
        gap: f64,
    },
    /// Flow in the last layer.
    #[error("the material yields down to {depth} mm, where the layers end")]
    Depth {
        /// Depth of the layers \[mm\].
        depth: f64,
    },
}

impl TrackFault {
    /// Checks that the first row of a law bears a traction \[MPa\], after all hardening.
    ///
    /// # Errors
    /// [`Self::Traction`].
    pub fn require_strength<const D: usize, const R: usize>(
        law: &dyn StreamLaw<D, R>,
        traction: f64,
    ) -> Result<(), Self> {
        let strength = law.largest_stress(0) / 3f64.sqrt();
        if traction > strength { Err(Self::Traction { traction, strength }) } else { Ok(()) }
    }
}

/// Hertz's peak over the yield stress up to which passes are solved: what deep rolling asks for. The
/// groove is then about as deep as small strains allow.
pub const DEEPEST: f64 = 8.0;

/// Strain of the last layer over the largest one below which the layers go deep enough (a curve
/// without an elastic limit flows everywhere), and of a pass over the strain at yield below which
/// nothing is left to happen.
pub(super) const NOTHING: f64 = 1e-3;

/// Part of the flow far from the load below which a track is long enough. Sound passes have up to
/// 1.4 %.
const FAR: f64 = 0.03;

/// Plastic flow of a pass.
#[derive(Debug, Clone, Copy)]
pub(super) struct FlowOfPass {
    /// `∫∫dp dx dz` over the width of a column.
    pub whole: f64,
    /// The part in the outer quarters of the columns that may flow, where nothing should.
    pub far: f64,
}

impl FlowOfPass {
    /// The flow of strains in rows of n columns of which some are live, each row as thick as given.
    pub fn of(
        strains: &[f64],
        (n, live): (usize, Range<usize>),
        thickness: impl Fn(usize) -> f64,
    ) -> Self {
        let outer = live.len() / 8;
        let inner = live.start + outer..live.end - outer;
        let rows = strains.chunks_exact(n).enumerate();
        rows.fold(Self { whole: 0.0, far: 0.0 }, |Self { whole, far }, (row, strains)| {
            let all: f64 = strains.iter().sum();
            let near: f64 = strains[inner.clone()].iter().sum();
            let h = thickness(row);
            Self { whole: whole + h * all, far: far + h * (all - near) }
        })
    }

    /// Why a track of this length is too short, if it is, after passes of which one had the most
    /// flow.
    pub fn holds(self, most: f64, length: f64) -> Result<(), TrackFault> {
        let part = self.far / self.whole.max(most);
        if part > FAR { Err(TrackFault::Far { part, length }) } else { Ok(()) }
    }
}

/// By how much the worst of equivalent stresses exceeds its yield stress, over the largest yield
/// stress. A curve without an elastic limit may have none.
pub(super) fn excess(rows: impl Iterator<Item = [f64; 2]>) -> f64 {
    let (worst, strongest) = rows.fold((f64::NEG_INFINITY, 0.0_f64), |(worst, strongest), row| {
        let [equivalent, yield_stress] = row;
        (worst.max(equivalent - yield_stress), strongest.max(yield_stress))
    });
    if strongest > 0.0 { worst / strongest } else { worst.max(0.0) }
}
