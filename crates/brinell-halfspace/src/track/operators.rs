//! What the operators of lines and of ellipses have in common.

use brinell_material::{Deviators, Solid, StreamLaw, TrackFrame};

use super::grid::TrackGrid;
use super::law::law_of_rows;
use crate::stop::{Stop, Stopped};
use crate::tensors::{COMPONENTS, DEVIATOR_COMPONENTS, from_isometric, isometric};
use crate::{Elasticity, Layers};

/// Cells, layers and elastic constants of a body.
#[derive(Debug, Clone)]
pub struct Ground {
    /// Cells of the surface.
    pub grid: TrackGrid,
    /// Layers below it.
    pub layers: Layers,
    /// Elastic constants.
    pub elastic: Elasticity,
}

impl Ground {
    /// Numbers of a field of R components.
    pub const fn field_len<const R: usize>(&self) -> usize {
        self.layers.len() * R * self.grid.n_cells()
    }
}

/// The direction of a surface load or displacement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Into the body.
    Normal,
    /// Along the travel.
    Tangential,
}

/// What a plastic strain leaves that is uniform along the track.
#[derive(Debug, Clone, PartialEq)]
pub struct Settled {
    /// Residual stress `xx yy zz xy xz yz` of the rows, with the stress before any load \[MPa\].
    pub residual: Vec<[f64; COMPONENTS]>,
    /// How deep the rows of the surface of one body have sunk \[mm\].
    pub groove: Vec<f64>,
    /// Elastic energy of the residual stress per length of track, up to a constant \[N\].
    pub stored_energy: f64,
}

/// S and S_t (pressure and traction to stress), Sᵀ and S_tᵀ (plastic strain to displacement) and G
/// (plastic strain to stress) of a body on a ring.
///
/// Deviators have D components, R of which are given and determine the others. A field has them in rows `layer,
/// component, row` of the columns of the grid, of all rows of a layer one after the other. Plastic
/// strains are given as polarization `τ = 2μ ε_p` \[MPa\]. Pressures and displacements are those
/// of the window at y > 0, row by row.
pub trait Operators<const D: usize, const R: usize>: Sized {
    /// Its deviators.
    type Frame: Frame<D, R>;
    /// Work space of an evaluation, with the spectra that it carries from strain to stress.
    type Work;

    /// The operators of a body; of one that slides with those of a traction.
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked for each layer.
    fn new(ground: Ground, slides: bool, stop: &mut Stop<'_>) -> Result<Self, Stopped>;

    /// Cells, layers and elastic constants.
    fn ground(&self) -> &Ground;

    /// Work space.
    fn work(&self) -> Self::Work;

    /// `u_p = Sᵀ ε_p`, positive into the body, or `u_px = S_tᵀ ε_p`, positive in +x \[mm\]. Of each
    /// layer only the first `reach` rows are read. A normal one keeps the spectra of `G ε_p` for
    /// [`stress`](Self::stress).
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked for each layer.
    fn opening(
        &self,
        direction: Direction,
        polarization: &[f64],
        reach: &[usize],
        work: &mut Self::Work,
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped>;

    /// The deviators `S p + μ S_t p + G ε_p` \[MPa\] of a pressure with a traction μ p in +x and
    /// the strain of the last normal [`opening`](Self::opening), which it uses up.
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked for each layer.
    fn stress(
        &self,
        pressure: &[f64],
        friction: f64,
        work: &mut Self::Work,
        stress: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped>;

    /// What polarizations of the rows leave that do not depend on x, with the stress σxx, σyy of
    /// each layer before any load.
    fn settle(&self, inlet: &[[f64; R]], initial: &[[f64; 2]], work: &mut Self::Work) -> Settled;

    /// The deviators of the rows far behind the load: those of the inlet, of the uniform state of
    /// polarizations c, and c.
    fn leave(&self, inlet: &[[f64; R]], c: &[[f64; R]], work: &mut Self::Work) -> Vec<[f64; R]>;

    /// Displacement of the surface in +x, against the depth, by strains `xx yy xy xz yz` of the
    /// rows; on the axis \[mm\].
    fn forward(&self, strain: &[[f64; DEVIATOR_COMPONENTS]]) -> f64;
}

/// Deviators of D components by R of them, as fields of a track hold them.
pub trait Frame<const D: usize, const R: usize>: Deviators<D, R> {
    /// Coordinates in which `a:a` is the sum of squares, times a weight.
    fn packed(values: [f64; R], weight: f64) -> [f64; R];

    /// The reverse of [`packed`](Self::packed).
    fn unpacked(values: [f64; R], weight: f64) -> [f64; R];

    /// The components that are given, of `xx yy zz xy xz yz`.
    fn of_all(all: [f64; COMPONENTS]) -> [f64; R];

    /// The deviator with which a row enters, of `xx yy zz xy xz yz`.
    fn at_front(all: [f64; COMPONENTS]) -> [f64; D];

    /// `xx yy xy xz yz`.
    fn all_of(values: [f64; R]) -> [f64; DEVIATOR_COMPONENTS];

    /// The plastic law of so many rows in each of the layers at these depths \[mm\], if the
    /// material can yield. Each layer has the strength at its depth.
    fn law(material: &Solid, depths: &[f64], rows: usize) -> Option<Box<dyn StreamLaw<D, R>>>;
}

/// √(3/2), √(1/2), √2: `a:a = 3/2 (xx+zz)² + 1/2 (xx-zz)² + 2 xz²` of the deviator of a line.
pub(crate) const ISOMETRIC: [f64; 3] =
    [1.224_744_871_391_589, std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::SQRT_2];

impl Frame<4, 3> for TrackFrame {
    fn packed(values: [f64; 3], weight: f64) -> [f64; 3] {
        let [xx, zz, xz] = values.map(|value| weight * value);
        [ISOMETRIC[0] * (xx + zz), ISOMETRIC[1] * (xx - zz), ISOMETRIC[2] * xz]
    }

    fn unpacked(values: [f64; 3], weight: f64) -> [f64; 3] {
        let weight = weight.recip();
        let sum = weight * values[0] / ISOMETRIC[0];
        let difference = weight * values[1] / ISOMETRIC[1];
        [0.5 * (sum + difference), 0.5 * (sum - difference), weight * values[2] / ISOMETRIC[2]]
    }

    fn of_all([xx, _, zz, _, xz, _]: [f64; COMPONENTS]) -> [f64; 3] {
        [xx, zz, xz]
    }

    fn at_front([xx, yy, zz, _, xz, _]: [f64; COMPONENTS]) -> [f64; 4] {
        [xx, yy, zz, xz]
    }

    fn all_of([xx, zz, xz]: [f64; 3]) -> [f64; DEVIATOR_COMPONENTS] {
        [xx, -xx - zz, 0.0, xz, 0.0]
    }

    fn law(material: &Solid, depths: &[f64], rows: usize) -> Option<Box<dyn StreamLaw<4, 3>>> {
        law_of_rows(material, depths, rows)
    }
}

impl Frame<COMPONENTS, DEVIATOR_COMPONENTS> for TrackFrame {
    fn packed(values: [f64; 5], weight: f64) -> [f64; 5] {
        isometric(values).map(|value| weight * value)
    }

    fn unpacked(values: [f64; 5], weight: f64) -> [f64; 5] {
        let weight = weight.recip();
        from_isometric(values.map(|value| weight * value))
    }

    fn of_all([xx, yy, _, xy, xz, yz]: [f64; COMPONENTS]) -> [f64; 5] {
        [xx, yy, xy, xz, yz]
    }

    fn at_front([xx, yy, _, xy, xz, yz]: [f64; COMPONENTS]) -> [f64; 6] {
        [xx, yy, -xx - yy, xy, xz, yz]
    }

    fn all_of(values: [f64; 5]) -> [f64; DEVIATOR_COMPONENTS] {
        values
    }

    fn law(material: &Solid, depths: &[f64], rows: usize) -> Option<Box<dyn StreamLaw<6, 5>>> {
        law_of_rows(material, depths, rows)
    }
}
