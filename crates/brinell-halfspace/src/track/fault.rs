//! Why a track has no answer, or one that its grid cuts off.

use thiserror::Error;

use super::body::RollingBody;
use super::grid::TrackGrid;

/// Why a pass has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum TrackFault {
    /// A traction that no hardening can bear: there is no equilibrium.
    #[error(
        "friction asks for a shear stress of {traction} MPa at the surface, where the material \
         bears {strength} MPa at most, after all hardening"
    )]
    Traction {
        /// `|μ| p` \[MPa\].
        traction: f64,
        /// `k_max(0)` \[MPa\].
        strength: f64,
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
    /// Flow in the last layer.
    #[error("the material yields down to {depth} mm, where the layers end")]
    Depth {
        /// Depth of the layers \[mm\].
        depth: f64,
    },
}

/// Strain of the last layer over the largest one below which the layers go deep enough. A curve
/// without an elastic limit flows everywhere.
pub(crate) const NOTHING: f64 = 1e-3;

impl TrackGrid {
    /// Why the pressures of the window are cut off, if they are.
    ///
    /// # Errors
    /// [`TrackFault::Window`].
    pub fn holds(&self, pressure: &[f64]) -> Result<(), TrackFault> {
        let ends = [pressure.first(), pressure.last()];
        if ends.into_iter().flatten().any(|p| *p > 0.0) {
            return Err(TrackFault::Window { width: pressure.len() as f64 * self.h() });
        }
        Ok(())
    }
}

impl RollingBody {
    /// Why the body cannot bear the traction of a peak pressure \[MPa\], if it cannot. A pressure
    /// is known before the first pass as that of Hertz.
    ///
    /// # Errors
    /// [`TrackFault::Traction`].
    pub fn bears(&self, peak_pressure: f64) -> Result<(), TrackFault> {
        let traction = self.friction().abs() * peak_pressure;
        let strength = self.law().largest_stress(0) / 3f64.sqrt();
        if traction > strength {
            return Err(TrackFault::Traction { traction, strength });
        }
        Ok(())
    }

    /// Why the plastic zone of the last stream is cut off, if it is.
    ///
    /// # Errors
    /// [`TrackFault::Depth`].
    pub fn holds(&self) -> Result<(), TrackFault> {
        let of_layer = |row: &[f64]| row.iter().sum::<f64>();
        let rows = self.strains().chunks_exact(self.space().grid().n_columns());
        let largest = rows.clone().map(of_layer).fold(0.0, f64::max);
        if rows.last().map_or(0.0, of_layer) > NOTHING * largest {
            let depth = self.space().layers().faces().last().copied().unwrap_or(0.0);
            return Err(TrackFault::Depth { depth });
        }
        Ok(())
    }
}
