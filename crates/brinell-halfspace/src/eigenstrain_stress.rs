//! Stress of plastic strain, the operator G: one wave vector after the other, by a sweep up and a
//! sweep down.
//!
//! Plastic strain `ε_p` acts on the elastic half-space as the polarization `τ = C : ε_p`. For the
//! wave vector `q (c, s)` in the plane, with x' along it,
//! ```text
//! τx = c²τxx + s²τyy + 2cs τxy    τy = s²τxx + c²τyy - 2cs τxy    τxy' = cs(τyy - τxx) + (c² - s²)τxy
//! t  = -i(c τxz + s τyz)          ty = -i(-s τxz + c τyz)         τz = τzz
//! ```
//! After this everything is real arithmetic on complex numbers. Away from its source a field is of
//! Airy form. With `ζ = q · distance`, downwards `(a, b, g)`:
//! ```text
//! σz = -(a + bζ)e^-ζ    σx = (a - 2b + bζ)e^-ζ    s_xz = (a - b + bζ)e^-ζ
//! σy = ν(σx + σz)       σxy' = g e^-ζ             s_yz = g e^-ζ
//! ```
//! and upwards the same with `s_xz` and `s_yz` of opposite sign. Per unit of thickness a source
//! sends, with `κ = 1/(2(1-ν))`,
//! ```text
//! a = q(1-κ)/2 (τx+τz) both ways   b_down = -(qκ/2)(τx - 2t - τz)   b_up = -(qκ/2)(τx + 2t - τz)
//!                                  g_down = (q/2)(τxy' - ty)        g_up = (q/2)(τxy' + ty)
//! ```
//! Source and stress are constant over a layer and averaged over it. With `x = qh`, `e = exp(-x)`
//! and
//! ```text
//! al = ∫ e^-qs ds   be = ∫ qs e^-qs ds   I0 = ∫ (h-s) e^-qs ds   I1 = ∫ (h-s) qs e^-qs ds     over 0..h
//! ```
//! the sweep up from the deepest layer, with `(A, B, Γ)` of the layers below at a layer's lower
//! face, is
//! ```text
//! own:    hσz = -(2a I0 + (b_d+b_u)I1)   hσx = 2(a-b_d-b_u)I0 + (b_d+b_u)I1   hs_xz = (b_d-b_u)(I1-I0)
//!         hσxy' = (g_d+g_u)I0            hs_yz = (g_d-g_u)I0
//! below:  hσz -= A0   hσx += A0 - 2B al   hs_xz -= A0 - B al   hσxy' += Γ al   hs_yz -= Γ al,   A0 = A al + B be
//! next:   A <- (A+Bx)e + a al + b_u be    B <- Be + b_u al     Γ <- Γe + g_u al
//! ```
//! The free surface sends `(A, B, Γ)` back as `(-A, B - 2A, Γ)`, under which its tractions vanish
//! whatever ν. The sweep down begins with these, with `s_xz += A0 - B al`, `s_yz += Γ al` and the
//! sources `b_d`, `g_d`. At the end `σy += ν(σx+σz)`, and the local part `σx += λ'τz - τx`, `σy +=
//! λ'τz - τy`, `σxy' -= τxy'` with `λ' = ν/(1-ν)`.
//!
//! This is a Galerkin projection: trigonometric in the plane, constant in layers, averaged over
//! layers. G is therefore symmetric and negative semidefinite on any layers. At the largest wave
//! number along x of an even grid, which is its own negative, the mean of both directions is
//! taken.
//!
//! # Reference
//! Own derivation. Kernel by quadrature over layers: L. Frérot, M. Bonnet, J.-F. Molinari, G.
//! Anciaux, *A Fourier-accelerated volume integral method for elastoplastic contact*, Comput.
//! Methods Appl. Mech. Eng. 351 (2019) 951–976.

use std::f64::consts::PI;

use crate::tensors::COMPONENTS;
use crate::transform::Transform;
use crate::waves::WIDTH;
use crate::{Elasticity, Layers};

/// Numbers kept of a layer between the sweeps.
const KEPT: usize = 10;
/// Numbers that depend on layer and wave number: e, al, be, I0/h, I1/h.
pub(crate) const COEFFICIENTS: usize = 5;

type Lanes = [f64; WIDTH];

/// Work space: what is kept of each layer.
pub(crate) type SweepWork = Vec<[Lanes; KEPT]>;

/// G on the wave numbers of a periodic box.
pub(crate) struct EigenstrainStress {
    /// `mx/2 + 1` filled up.
    filled: usize,
    thickness: Vec<f64>,
    elastic: Elasticity,
    /// Rows of q_y: wave number, cosine and sine of its direction.
    directions: Vec<[Vec<f64>; 3]>,
    /// Wave number q_y, layer, coefficient, wave number q_x.
    coefficients: Vec<f64>,
}

impl EigenstrainStress {
    /// Sides of a cell in mm.
    pub fn new(
        transform: &Transform,
        sides: [f64; 2],
        layers: &Layers,
        elastic: Elasticity,
    ) -> Self {
        let mx = transform.mx;
        let half = mx / 2 + 1;
        let filled = half.next_multiple_of(WIDTH);
        let (dx, dy) =
            (2.0 * PI / (mx as f64 * sides[0]), 2.0 * PI / (transform.my as f64 * sides[1]));
        let thickness: Vec<f64> = (0..layers.len()).map(|layer| layers.thickness(layer)).collect();
        let mut directions = Vec::with_capacity(transform.n_rows());
        let mut coefficients =
            Vec::with_capacity(transform.n_rows() * layers.len() * COEFFICIENTS * filled);
        for iy in 0..transform.n_rows() {
            let mut direction = [vec![0.0; filled], vec![1.0; filled], vec![0.0; filled]];
            for ix in 0..half {
                let (qx, qy) = (ix as f64 * dx, iy as f64 * dy);
                let q = qx.hypot(qy);
                if q > 0.0 {
                    for (row, value) in direction.iter_mut().zip([q, qx / q, qy / q]) {
                        row[ix] = value;
                    }
                }
            }
            for h in &thickness {
                let of_q: Vec<_> = direction[0].iter().map(|q| coefficients_of(*q, *h)).collect();
                for k in 0..COEFFICIENTS {
                    coefficients.extend(of_q.iter().map(|values| values[k]));
                }
            }
            directions.push(direction);
        }
        Self { filled, thickness, elastic, directions, coefficients }
    }

    pub fn work(&self) -> SweepWork {
        vec![[[0.0; WIDTH]; KEPT]; self.thickness.len()]
    }

    /// Turns the strains of one wave number q_y into stresses, in place.
    #[inline(always)]
    pub fn apply(&self, iy: usize, block: &mut [f64], work: &mut SweepWork) {
        self.apply_from(0, iy, block, work);
    }

    /// Turns the strains of one wave number q_y into stresses from a wave number q_x on, a multiple
    /// of [`WIDTH`]; leaves those below it.
    #[inline(always)]
    pub fn apply_from(&self, first: usize, iy: usize, block: &mut [f64], work: &mut SweepWork) {
        let row_len = block.len() / (COMPONENTS * self.thickness.len());
        for start in (first..self.filled).step_by(WIDTH) {
            for plane in 0..row_len / self.filled {
                self.pass(iy, start, plane, row_len, block, work);
            }
        }
    }

    /// Some wave numbers of a plane.
    #[inline(always)]
    fn pass(
        &self,
        iy: usize,
        start: usize,
        plane: usize,
        row_len: usize,
        block: &mut [f64],
        work: &mut SweepWork,
    ) {
        let (shear, lame, poisson) =
            (self.elastic.shear(), self.elastic.lame(), self.elastic.poisson());
        let kappa = 0.5 / (1.0 - poisson);
        let local = poisson / (1.0 - poisson);
        let n_layers = self.thickness.len();
        let coefficients = &self.coefficients[iy * n_layers * COEFFICIENTS * self.filled..];
        let of_layer = |layer: usize, k: usize| {
            lanes(&coefficients[(layer * COEFFICIENTS + k) * self.filled + start..])
        };
        let [q, c, s] = &self.directions[iy];
        let (q, mut c, s) = (lanes(&q[start..]), lanes(&c[start..]), lanes(&s[start..]));
        if plane >= 2 {
            for cosine in &mut c {
                *cosine = -*cosine;
            }
        }
        let place = plane * self.filled + start;

        let (mut a, mut b, mut g) = ([0.0; WIDTH], [0.0; WIDTH], [0.0; WIDTH]);
        for (layer, kept) in work.iter_mut().enumerate().rev() {
            let h = self.thickness[layer];
            let rows = &block[layer * COMPONENTS * row_len..][..COMPONENTS * row_len];
            let row = |k: usize| lanes(&rows[k * row_len + place..]);
            let strain = [row(0), row(1), row(2), row(3), row(4), row(5)];
            let [e, al, be] = [of_layer(layer, 0), of_layer(layer, 1), of_layer(layer, 2)];
            let [i0, i1] = [of_layer(layer, 3), of_layer(layer, 4)];
            let per_h = 1.0 / h;
            for n in 0..WIDTH {
                let trace = lame * (strain[0][n] + strain[1][n] + strain[2][n]);
                let xx = 2.0 * shear * strain[0][n] + trace;
                let yy = 2.0 * shear * strain[1][n] + trace;
                let zz = 2.0 * shear * strain[2][n] + trace;
                let (xy, xz, yz) = (
                    2.0 * shear * strain[3][n],
                    2.0 * shear * strain[4][n],
                    2.0 * shear * strain[5][n],
                );
                let (cc, ss, cs) = (c[n] * c[n], s[n] * s[n], c[n] * s[n]);
                let tx = cc * xx + ss * yy + 2.0 * cs * xy;
                let ty = ss * xx + cc * yy - 2.0 * cs * xy;
                let txy = cs * (yy - xx) + (cc - ss) * xy;
                let (t, t_y) = (c[n] * xz + s[n] * yz, c[n] * yz - s[n] * xz);

                let source_a = 0.5 * (1.0 - kappa) * q[n] * (tx + zz);
                let b_down = -0.5 * kappa * q[n] * (tx - zz - 2.0 * t);
                let b_up = -0.5 * kappa * q[n] * (tx - zz + 2.0 * t);
                let (g_down, g_up) = (0.5 * q[n] * (txy - t_y), 0.5 * q[n] * (txy + t_y));
                let (both, difference) = (b_down + b_up, b_down - b_up);
                let (al_h, a0) = (al[n] * per_h, (a[n] * al[n] + b[n] * be[n]) * per_h);
                kept[0][n] =
                    2.0 * (source_a - both) * i0[n] + both * i1[n] + a0 - 2.0 * b[n] * al_h;
                kept[1][n] = -(2.0 * source_a * i0[n] + both * i1[n]) - a0;
                kept[2][n] = difference * (i1[n] - i0[n]) - (a0 - b[n] * al_h);
                kept[3][n] = (g_down + g_up) * i0[n] + g[n] * al_h - txy;
                kept[4][n] = (g_down - g_up) * i0[n] - g[n] * al_h;
                kept[5][n] = local * zz - tx;
                kept[6][n] = local * zz - ty;
                kept[7][n] = source_a;
                kept[8][n] = b_down;
                kept[9][n] = g_down;
                a[n] = (a[n] + b[n] * q[n] * h) * e[n] + source_a * al[n] + b_up * be[n];
                b[n] = b[n] * e[n] + b_up * al[n];
                g[n] = g[n] * e[n] + g_up * al[n];
            }
        }
        for n in 0..WIDTH {
            b[n] -= 2.0 * a[n];
            a[n] = -a[n];
        }
        for (layer, kept) in work.iter().enumerate() {
            let h = self.thickness[layer];
            let [e, al, be] = [of_layer(layer, 0), of_layer(layer, 1), of_layer(layer, 2)];
            let per_h = 1.0 / h;
            let mut stress = [[0.0; WIDTH]; COMPONENTS];
            for n in 0..WIDTH {
                let (al_h, a0) = (al[n] * per_h, (a[n] * al[n] + b[n] * be[n]) * per_h);
                let along = kept[0][n] + a0 - 2.0 * b[n] * al_h;
                let normal = kept[1][n] - a0;
                let shear_xz = kept[2][n] + a0 - b[n] * al_h;
                let shear_xy = kept[3][n] + g[n] * al_h;
                let shear_yz = kept[4][n] + g[n] * al_h;
                a[n] = (a[n] + b[n] * q[n] * h) * e[n] + kept[7][n] * al[n] + kept[8][n] * be[n];
                b[n] = b[n] * e[n] + kept[8][n] * al[n];
                g[n] = g[n] * e[n] + kept[9][n] * al[n];
                let across = poisson * (along + normal) + kept[6][n];
                let along = along + kept[5][n];
                let (cc, ss, cs) = (c[n] * c[n], s[n] * s[n], c[n] * s[n]);
                stress[0][n] = cc * along + ss * across - 2.0 * cs * shear_xy;
                stress[1][n] = ss * along + cc * across + 2.0 * cs * shear_xy;
                stress[2][n] = normal;
                stress[3][n] = cs * (along - across) + (cc - ss) * shear_xy;
                stress[4][n] = c[n] * shear_xz - s[n] * shear_yz;
                stress[5][n] = s[n] * shear_xz + c[n] * shear_yz;
            }
            let rows = &mut block[layer * COMPONENTS * row_len..][..COMPONENTS * row_len];
            for (k, lanes) in stress.iter().enumerate() {
                rows[k * row_len + place..][..WIDTH].copy_from_slice(lanes);
            }
        }
    }
}

/// The first numbers of a row.
#[inline(always)]
pub(crate) fn lanes(row: &[f64]) -> Lanes {
    let mut lanes = [0.0; WIDTH];
    lanes.copy_from_slice(&row[..WIDTH]);
    lanes
}

/// Below this x the series are taken, because the closed forms cancel. Both meet to 1e-13.
const SERIES_BELOW: f64 = 0.5;
/// Terms of the series; the first left out is below 1e-17 of the first.
const TERMS: u32 = 16;

/// e, al, be, I0/h, I1/h.
pub(crate) fn coefficients_of(q: f64, h: f64) -> [f64; COEFFICIENTS] {
    let x = q * h;
    let e = (-x).exp();
    if x > SERIES_BELOW {
        let al = (1.0 - e) / q;
        let be = (1.0 - e * (1.0 + x)) / q;
        let second = (1.0 - e * (1.0 + x + 0.5 * x * x)) / (q * x);
        return [e, al, be, (h - al) / x, be - 2.0 * second];
    }
    let (mut al, mut be, mut i0, mut i1, mut power) = (0.0, 0.0, 0.0, 0.0, 1.0);
    for k in 0..TERMS {
        let n = f64::from(k);
        al += power / (n + 1.0);
        be += power / (n + 2.0);
        i0 += power / ((n + 1.0) * (n + 2.0));
        i1 += power / ((n + 2.0) * (n + 3.0));
        power *= -x / (n + 1.0);
    }
    [e, h * al, h * x * be, h * i0, h * x * i1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_forms_meet() {
        let h = 0.3;
        let q = SERIES_BELOW / h;
        let (below, above) = (coefficients_of(q, h), coefficients_of(q * (1.0 + 1e-15), h));
        for (a, b) in below.into_iter().zip(above) {
            assert!((a / b - 1.0).abs() < 1e-13, "{below:?} {above:?}");
        }
    }
}
