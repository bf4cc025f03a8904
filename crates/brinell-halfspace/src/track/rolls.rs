//! Pass of a body on a track, of a contact along a line or over an ellipse.

use super::body::RollingBody;
use super::fault::TrackFault;
use super::figures::Outlet;
use super::sweep::ROWS;
use crate::stop::{Stop, Stopped};

/// A body whose pass is the fixed point of `increment -> open -> (contact) -> trial -> flow`.
///
/// Increments and trials have the same length; an increment is `2μ Δε` \[MPa\] of each column of
/// each row. Surface fields are those of the cells of the window in which bodies may touch.
pub trait Rolls {
    /// Numbers of a cell in a packed vector.
    const PACKED: usize;

    /// Numbers of an increment.
    fn n_numbers(&self) -> usize;

    /// Returns the number of bodies for which this one stands.
    fn count(&self) -> f64;

    /// Begins a pass from an increment: the cells that may change are those that flow in it.
    fn begin(&mut self, increment: &[f64]);

    /// Adds u_p of all the bodies that this one stands for to `opening` \[mm\], positive where it
    /// opens the gap.
    ///
    /// # Errors
    /// [`Stopped`].
    fn open(
        &mut self,
        increment: &[f64],
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped>;

    /// The trial deviators under pressures \[MPa\], with the increment of the last
    /// [`open`](Self::open), which it uses up.
    ///
    /// # Errors
    /// [`Stopped`].
    fn trial(
        &mut self,
        pressure: &[f64],
        into: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped>;

    /// Answers a trial with `2μ Δε` of the plastic law.
    fn flow(&mut self, trial: &[f64], into: &mut [f64]);

    /// Accepts an increment that the law has just answered its trial with. The state at the back
    /// enters the next pass, and the trial becomes that of the same path behind the residual stress
    /// that this pass leaves.
    fn accept(&mut self, increment: &[f64], trial: &mut [f64]) -> Outlet;

    /// Turns the track round: the next pass goes the other way. x is again the direction of
    /// travel.
    fn turn(&mut self);

    /// Work of the traction on the plastic displacement of the surface of one body, per length of
    /// travel, with the increment of the last [`open`](Self::open).
    ///
    /// # Errors
    /// [`Stopped`].
    fn work_of_traction(&mut self, pressure: &[f64], stop: &mut Stop<'_>) -> Result<f64, Stopped>;

    /// Accumulated plastic strain that the columns of each row have added in the last stream.
    fn strains(&self) -> &[f64];

    /// Columns of a row.
    fn n_columns(&self) -> usize;

    /// Layers of the body.
    fn n_layers(&self) -> usize;

    /// Number of cells that may change.
    fn n_flowed(&self) -> usize;

    /// Appends the cells that have flowed, in the order in which their flow began, to one vector
    /// whose square is `Σ h_l a:a`, over all cells on both sides of an axis \[MPa √mm\]. A vector
    /// packed earlier is the beginning of one packed later.
    fn pack(&self, increment: &[f64], into: &mut Vec<f64>);

    /// Writes the cells back to where [`pack`](Self::pack) took them from.
    fn unpack(&self, packed: &[f64], increment: &mut [f64]);

    /// Why the plastic zone of the last stream is cut off, if it is.
    ///
    /// # Errors
    /// [`TrackFault`].
    fn holds(&self) -> Result<(), TrackFault>;
}

impl Rolls for RollingBody {
    const PACKED: usize = ROWS;

    fn n_numbers(&self) -> usize {
        self.len()
    }

    fn count(&self) -> f64 {
        Self::count(self)
    }

    fn begin(&mut self, increment: &[f64]) {
        Self::begin(self, increment);
    }

    fn open(
        &mut self,
        increment: &[f64],
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        Self::open(self, increment, opening, stop)
    }

    fn trial(
        &mut self,
        pressure: &[f64],
        into: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        Self::trial(self, pressure, into, stop)
    }

    fn flow(&mut self, trial: &[f64], into: &mut [f64]) {
        Self::flow(self, trial, into);
    }

    fn accept(&mut self, increment: &[f64], trial: &mut [f64]) -> Outlet {
        let n = self.space().grid().n_columns();
        let deviators = |body: &Self| -> Vec<[f64; 2]> {
            let of_layer = |layer: usize| {
                let [xx, yy] = body.residual(layer);
                let mean = (xx + yy) / 3.0;
                [xx - mean, -mean]
            };
            (0..body.law().n_rows()).map(of_layer).collect()
        };
        let before = deviators(self);
        let outlet = Self::accept(self, increment);
        let changes = before.iter().zip(deviators(self));
        for (rows, ([xx, zz], after)) in trial.chunks_exact_mut(ROWS * n).zip(changes) {
            let (row, rest) = rows.split_at_mut(n);
            for value in row {
                *value += after[0] - xx;
            }
            for value in &mut rest[..n] {
                *value += after[1] - zz;
            }
        }
        outlet
    }

    fn turn(&mut self) {
        Self::turn(self);
    }

    fn work_of_traction(&mut self, pressure: &[f64], stop: &mut Stop<'_>) -> Result<f64, Stopped> {
        Self::work_of_traction(self, pressure, stop)
    }

    fn strains(&self) -> &[f64] {
        Self::strains(self)
    }

    fn n_columns(&self) -> usize {
        self.space().grid().n_columns()
    }

    fn n_layers(&self) -> usize {
        self.space().layers().len()
    }

    fn n_flowed(&self) -> usize {
        Self::n_flowed(self)
    }

    fn pack(&self, increment: &[f64], into: &mut Vec<f64>) {
        Self::pack(self, increment, into);
    }

    fn unpack(&self, packed: &[f64], increment: &mut [f64]) {
        Self::unpack(self, packed, increment);
    }

    fn holds(&self) -> Result<(), TrackFault> {
        Self::holds(self)
    }
}
