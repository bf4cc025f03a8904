//! G of a state that does not depend on y: the sweep of
//! [`eigenstrain_stress`](crate::eigenstrain_stress) with q_y = 0.
//!
//! A spectrum is held in two *planes* of real numbers, which G does not mix:
//! ```text
//! plane 0    Re τxx    Re τzz     Im τxz
//! plane 1    Im τxx    Im τzz    -Re τxz
//! ```
//! In both, with `t` the third, the source of a layer is `a = q(1-κ)/2 (τxx+τzz)`, `b_down =
//! -(qκ/2)(τxx-2t-τzz)`, `b_up = -(qκ/2)(τxx+2t-τzz)`. Plastic strain is a deviator, and so is the
//! stress that leaves. At q = 0 the sweep adds nothing, and the local part is left: the residual
//! stress of a state that is uniform along the track.

use std::f64::consts::PI;

use crate::eigenstrain_stress::{COEFFICIENTS, coefficients_of, lanes};
use crate::track::Ground;
use crate::waves::WIDTH;

/// xx, zz, xz.
pub(super) const ROWS: usize = 3;
pub(super) const PLANES: usize = 2;
/// Numbers of a layer that are kept between the sweeps.
const KEPT: usize = 7;

type Lanes = [f64; WIDTH];

pub(super) struct Sweep {
    /// Wave numbers filled up.
    pub filled: usize,
    thickness: Vec<f64>,
    poisson: f64,
    /// q over the wave numbers.
    wave: Vec<f64>,
    /// Layer, coefficient, wave number.
    coefficients: Vec<f64>,
}

pub(super) type SweepWork = Vec<[Lanes; KEPT]>;

impl Sweep {
    pub fn new(Ground { grid, layers, elastic }: &Ground) -> Self {
        let half = grid.n_columns() / 2 + 1;
        let filled = half.next_multiple_of(WIDTH);
        let mut wave: Vec<f64> = (0..half).map(|k| 2.0 * PI * k as f64 / grid.length()).collect();
        wave.resize(filled, 0.0);
        let thickness: Vec<f64> = (0..layers.len()).map(|layer| layers.thickness(layer)).collect();
        let mut coefficients = Vec::with_capacity(layers.len() * COEFFICIENTS * filled);
        for h in &thickness {
            let of_q: Vec<_> = wave.iter().map(|q| coefficients_of(*q, *h)).collect();
            for k in 0..COEFFICIENTS {
                coefficients.extend(of_q.iter().map(|values| values[k]));
            }
        }
        Self { filled, thickness, poisson: elastic.poisson(), wave, coefficients }
    }

    pub fn work(&self) -> SweepWork {
        vec![[[0.0; WIDTH]; KEPT]; self.thickness.len()]
    }

    /// Turns the polarizations `τ = 2μ ε_p` of all layers into stress deviators, in place. The
    /// stack has layers of `PLANES × ROWS` rows.
    #[inline(always)]
    pub fn apply(&self, stack: &mut [f64], work: &mut SweepWork) {
        for start in (0..self.filled).step_by(WIDTH) {
            for plane in 0..PLANES {
                self.pass(start, plane, stack, work);
            }
        }
    }

    #[inline(always)]
    fn pass(&self, start: usize, plane: usize, stack: &mut [f64], work: &mut SweepWork) {
        let kappa = 0.5 / (1.0 - self.poisson);
        let local = self.poisson / (1.0 - self.poisson);
        let of_layer = |layer: usize, k: usize| {
            lanes(&self.coefficients[(layer * COEFFICIENTS + k) * self.filled + start..])
        };
        let place = |layer: usize, row: usize| {
            ((layer * PLANES + plane) * ROWS + row) * self.filled + start
        };
        let q = lanes(&self.wave[start..]);

        let (mut a, mut b) = ([0.0; WIDTH], [0.0; WIDTH]);
        for (layer, kept) in work.iter_mut().enumerate().rev() {
            let h = self.thickness[layer];
            let per_h = 1.0 / h;
            let [xx, zz, t] = std::array::from_fn(|row| lanes(&stack[place(layer, row)..]));
            let [e, al, be, i0, i1] = std::array::from_fn(|k| of_layer(layer, k));
            for n in 0..WIDTH {
                let source = 0.5 * (1.0 - kappa) * q[n] * (xx[n] + zz[n]);
                let down = -0.5 * kappa * q[n] * (xx[n] - zz[n] - 2.0 * t[n]);
                let up = -0.5 * kappa * q[n] * (xx[n] - zz[n] + 2.0 * t[n]);
                let (both, difference) = (down + up, down - up);
                let (al_h, a0) = (al[n] * per_h, (a[n] * al[n] + b[n] * be[n]) * per_h);
                kept[0][n] = 2.0 * (source - both) * i0[n] + both * i1[n] + a0 - 2.0 * b[n] * al_h;
                kept[1][n] = -(2.0 * source * i0[n] + both * i1[n]) - a0;
                kept[2][n] = difference * (i1[n] - i0[n]) - (a0 - b[n] * al_h);
                kept[3][n] = source;
                kept[4][n] = down;
                // The local part: λ'τzz - τxx, λ'τzz - τyy.
                kept[5][n] = local * zz[n] - xx[n];
                kept[6][n] = local * zz[n] + xx[n] + zz[n];
                a[n] = (a[n] + b[n] * q[n] * h) * e[n] + source * al[n] + up * be[n];
                b[n] = b[n] * e[n] + up * al[n];
            }
        }
        for n in 0..WIDTH {
            b[n] -= 2.0 * a[n];
            a[n] = -a[n];
        }
        for (layer, kept) in work.iter().enumerate() {
            let h = self.thickness[layer];
            let per_h = 1.0 / h;
            let [e, al, be] = std::array::from_fn(|k| of_layer(layer, k));
            let mut stress = [[0.0; WIDTH]; ROWS];
            for n in 0..WIDTH {
                let (al_h, a0) = (al[n] * per_h, (a[n] * al[n] + b[n] * be[n]) * per_h);
                let along = kept[0][n] + a0 - 2.0 * b[n] * al_h;
                let normal = kept[1][n] - a0;
                let across = self.poisson * (along + normal) + kept[6][n];
                let along = along + kept[5][n];
                let mean = (along + across + normal) * (1.0 / 3.0);
                stress[0][n] = along - mean;
                stress[1][n] = normal - mean;
                stress[2][n] = kept[2][n] + a0 - b[n] * al_h;
                a[n] = (a[n] + b[n] * q[n] * h) * e[n] + kept[3][n] * al[n] + kept[4][n] * be[n];
                b[n] = b[n] * e[n] + kept[4][n] * al[n];
            }
            for (row, lanes) in stress.iter().enumerate() {
                stack[place(layer, row)..][..WIDTH].copy_from_slice(lanes);
            }
        }
    }
}
