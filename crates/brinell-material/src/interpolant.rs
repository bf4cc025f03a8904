//! A smooth function of a positive argument as a table of polynomials.
//!
//! An octave is the range from a power of two to the next. It has sixteen equal cells; a cell has
//! 1, 2, 4, … equal pieces. On each piece a polynomial of degree seven interpolates the function
//! at the Chebyshev points. The error is about the last coefficient of the Chebyshev series over
//! the ratio of successive coefficients; the number of pieces makes this error rounding. The
//! binary digits of an argument give its cell, its piece and its position on the piece.
//!
//! # Reference
//! L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM 2013), theorem 8.2.

use std::sync::{LazyLock, OnceLock};

use nalgebra::{SMatrix, SVector};

const DEGREE: usize = 7;
const POINTS: usize = DEGREE + 1;

/// Binary exponent of the smallest argument; the largest are below 2⁴.
const SMALLEST: i32 = -32;
const OCTAVES: usize = 36;

/// Cells of an octave and pieces of a cell at most, as powers of two.
const CELLS_LOG2: u32 = 4;
const MOST_PIECES_LOG2: u32 = 6;

/// Last Chebyshev coefficient over the function below which a piece is small enough.
const LAST_COEFFICIENT: f64 = 1e-14;

/// Digits of an argument behind those that tell its cell.
const REST_BITS: u32 = f64::MANTISSA_DIGITS - 1 - CELLS_LOG2;
const REST: u64 = (1 << REST_BITS) - 1;

/// The Chebyshev points from -1 to 1, and what makes coefficients of powers of the values there.
static CHEBYSHEV: LazyLock<(SVector<f64, POINTS>, SMatrix<f64, POINTS, POINTS>)> =
    LazyLock::new(|| {
        let points = SVector::<f64, POINTS>::from_fn(|i, _| {
            -((2 * i + 1) as f64 * std::f64::consts::PI / (2 * POINTS) as f64).cos()
        });
        let mut powers = SMatrix::<f64, POINTS, POINTS>::repeat(1.0);
        for k in 1..POINTS {
            powers.set_column(k, &powers.column(k - 1).component_mul(&points));
        }
        (points, powers.try_inverse().unwrap_or_default())
    });

/// `f(x) = Σ c_k s^k` with s from -1 to 1 over the piece.
#[derive(Debug, Clone)]
struct Polynomial([f64; POINTS]);

impl Polynomial {
    #[inline]
    fn at(&self, s: f64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, c| c + s * sum)
    }

    fn is_fine_enough(&self) -> bool {
        // T_7 = 64 s^7 - …
        self.0[DEGREE].abs() / 64.0 <= LAST_COEFFICIENT * self.0[0].abs()
    }
}

/// The pieces of a cell, 2^pieces_log2 of them.
#[derive(Debug, Clone)]
struct Cell {
    pieces_log2: u32,
    pieces: Vec<Polynomial>,
}

impl Cell {
    fn new(begin: f64, end: f64, f: &mut impl FnMut(f64) -> f64) -> Self {
        let (points, coefficients) = &*CHEBYSHEV;
        let mut polynomial = |start: f64, width: f64| {
            let values = points.map(|s| f(start + width * 0.5 * (1.0 + s)));
            // The differences lose no digits.
            let middle = 0.5 * (values[DEGREE / 2] + values[DEGREE / 2 + 1]);
            let mut polynomial = Polynomial((coefficients * values.add_scalar(-middle)).into());
            polynomial.0[0] += middle;
            polynomial
        };
        let mut divided = |pieces_log2: u32| {
            let width = (end - begin) / f64::from(1 << pieces_log2);
            let piece = |k: u32| polynomial(begin + f64::from(k) * width, width);
            Self { pieces_log2, pieces: (0..1 << pieces_log2).map(piece).collect() }
        };
        let mut cell = divided(0);
        while cell.pieces_log2 < MOST_PIECES_LOG2
            && !cell.pieces.iter().all(Polynomial::is_fine_enough)
        {
            cell = divided(cell.pieces_log2 + 1);
        }
        cell
    }
}

/// The table. Cells are computed at their first use and stored by octaves, because a body whose
/// strength varies has thousands of tables.
#[derive(Debug, Clone)]
pub(super) struct Interpolant {
    octaves: Vec<OnceLock<Box<[OnceLock<Cell>]>>>,
}

impl Interpolant {
    pub fn new() -> Self {
        Self { octaves: vec![OnceLock::new(); OCTAVES] }
    }

    /// Returns the value of the function; `None` where the argument is too small or too large.
    /// `function()` returns the same function in every call. It is evaluated at mostly rising
    /// arguments when a cell is computed.
    #[inline]
    pub fn at<F: FnMut(f64) -> f64>(&self, x: f64, function: impl FnOnce() -> F) -> Option<f64> {
        let bits = x.to_bits();
        let cell = (bits >> REST_BITS).checked_sub(2f64.powi(SMALLEST).to_bits() >> REST_BITS)?;
        let cell = usize::try_from(cell).ok()?;
        let octave = self.octaves.get(cell >> CELLS_LOG2)?;
        let cells = octave.get_or_init(|| vec![OnceLock::new(); 1 << CELLS_LOG2].into());
        let cell = cells.get(cell % (1 << CELLS_LOG2))?.get_or_init(|| {
            let (begin, end) = (bits & !REST, (bits & !REST) + REST + 1);
            Cell::new(f64::from_bits(begin), f64::from_bits(end), &mut function())
        });
        let rest = bits & REST;
        let piece = usize::try_from(rest >> (REST_BITS - cell.pieces_log2)).ok()?;
        // The digits behind those of the piece, as a number from 1 to 2.
        let place = ((rest << cell.pieces_log2) & REST) << CELLS_LOG2;
        Some(cell.pieces.get(piece)?.at(2.0 * f64::from_bits(place | 1f64.to_bits()) - 3.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_function_to_rounding() {
        let smooth = |x: f64| x / (1.0 + x.powf(0.3));
        // A bend over a hundredth of the argument.
        let bent = |x: f64| 1.0 + x.min(0.01) - 1e-4 * ((0.01 - x).abs() / -1e-4).exp().ln_1p();
        for (f, at_most) in [(&smooth as &dyn Fn(f64) -> f64, 600), (&bent, 4000)] {
            let interpolant = Interpolant::new();
            for k in 0..30_000 {
                let x = 3e-10 * 1.0008f64.powi(k);
                let found = interpolant.at(x, || f).unwrap();
                assert!((found - f(x)).abs() < 3e-15 * f(x), "{found} for {} at {x}", f(x));
            }
            let cells = interpolant.octaves.iter().filter_map(OnceLock::get).flatten();
            let pieces: usize = cells.filter_map(|cell| Some(cell.get()?.pieces.len())).sum();
            assert!(pieces < at_most, "{pieces} pieces");
        }
    }

    #[test]
    fn beyond_its_range_it_has_no_value() {
        let interpolant = Interpolant::new();
        let at = |x: f64| interpolant.at(x, || |x| x);
        for x in [0.0, -1.0, 1e-10, 16.0, f64::MAX, f64::INFINITY, f64::NAN, f64::MIN_POSITIVE] {
            assert_eq!(at(x), None, "{x}");
        }
        for x in [2f64.powi(SMALLEST), 1.0, 16f64.next_down()] {
            assert!((at(x).unwrap() / x - 1.0).abs() < 1e-15, "{x}");
        }
    }
}
