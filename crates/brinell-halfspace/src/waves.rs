//! Spectra of the components of a tensor, in real numbers.
//!
//! Each component is even or odd in x and in y where the whole state is symmetric about both axes,
//! as [`PARITIES`] says, and so is the kernel of each component in any state. With the spectra of
//! components that are odd in one coordinate multiplied by -i, all operators are real. A *row*
//! holds one component at one wave number q_y, in *planes* of `filled` numbers over `q_x >= 0`:
//! ```text
//! any state        real part, imaginary part at +q_x, the same at -q_x     by fast Fourier transforms
//! symmetric        one plane, the whole spectrum                           by sums of cosines and sines over a quarter
//! ```
//! Between the transforms along y and along x a row holds `nx` complex numbers, or `nx/2` real
//! ones. A *stack* holds rows of several fields, wave number q_y outermost: `stack[(iy n_fields +
//! field) row_len ..]`. All fields of one q_y are thus one contiguous *block*, which a recursion
//! over layers finds in the cache.

use std::f64::consts::PI;

use realfft::num_complex::Complex64;

use crate::tensors::COMPONENTS;
use crate::transform::{Scratch, Transform, fast_length};

/// Numbers that are worked on at once; planes are filled up to a multiple of it.
pub(crate) const WIDTH: usize = 8;
/// Numbers of a sum of cosines that are worked on at once where there are enough.
const WIDE: usize = 32;

/// Whether a kernel keeps or changes its sign with an offset along x and along y.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Parity {
    /// In both offsets.
    Even,
    /// In both offsets.
    Odd,
    OddInX,
    OddInY,
}

/// Parity of each component where an offset changes its sign.
pub(crate) const PARITIES: [Parity; COMPONENTS] =
    [Parity::Even, Parity::Even, Parity::Even, Parity::Odd, Parity::OddInX, Parity::OddInY];

impl Parity {
    pub const fn is_odd_in_x(self) -> bool {
        matches!(self, Self::Odd | Self::OddInX)
    }

    pub const fn is_odd_in_y(self) -> bool {
        matches!(self, Self::Odd | Self::OddInY)
    }

    /// Whether a symmetric spectrum is imaginary.
    pub const fn is_imaginary(self) -> bool {
        matches!(self, Self::OddInX | Self::OddInY)
    }

    /// Sign of a kernel in a plane, which is given at `q_x >= 0`.
    #[inline(always)]
    pub const fn sign_in(self, plane: usize) -> f64 {
        if plane >= 2 && self.is_odd_in_x() { -1.0 } else { 1.0 }
    }
}

/// The wave vectors of a padded box.
pub(crate) struct Waves {
    pub transform: Transform,
    /// `mx/2 + 1`, and the same filled up.
    pub half: usize,
    pub filled: usize,
    quarter: Option<Quarter>,
    arch: pulp::Arch,
}

/// Sums of cosines (0) and sines (1) at the cells of a quarter.
struct Quarter {
    /// Cells along x filled up.
    wide_x: usize,
    wide_y: usize,
    /// `2 cos q_y y`: wave number, cell.
    to_y: [Vec<f64>; 2],
    /// `2 cos q_y y` over `my`, and half of it at both ends: wave number, cell filled up.
    from_y: [Vec<f64>; 2],
    /// Cell, wave number filled up.
    to_x: [Vec<f64>; 2],
    /// Wave number, cell filled up.
    from_x: [Vec<f64>; 2],
}

/// Work space of the transforms.
pub(crate) struct WavesScratch {
    complex: Scratch,
    line: Vec<Complex64>,
    vector: Vec<f64>,
    table: Vec<f64>,
    cells: Vec<f64>,
}

/// cos or sin of `π k (n + 1/2) 2/m`.
pub(crate) fn wave(k: usize, n: usize, m: usize, is_odd: bool) -> f64 {
    let phase = PI * (k * (2 * n + 1) % (2 * m)) as f64 / m as f64;
    if is_odd { phase.sin() } else { phase.cos() }
}

impl Quarter {
    fn new(transform: &Transform, filled: usize) -> Self {
        let Transform { nx, ny, mx, my, .. } = *transform;
        let [wide_x, wide_y] = [nx, ny].map(|n| (n / 2).next_multiple_of(WIDTH));
        let weight = |k: usize, m: usize| if k == 0 || 2 * k == m { 1.0 } else { 2.0 } / m as f64;
        let both = |table: &dyn Fn(bool) -> Vec<f64>| [table(false), table(true)];
        let from = |n: usize, wide: usize, m: usize, is_odd: bool| {
            let mut table = vec![0.0; (m / 2 + 1) * wide];
            for (k, row) in table.chunks_exact_mut(wide).enumerate() {
                for (cell, value) in row[..n / 2].iter_mut().enumerate() {
                    *value = weight(k, m) * wave(k, cell, m, is_odd);
                }
            }
            table
        };
        Self {
            wide_x,
            wide_y,
            to_y: both(&|is_odd| {
                (0..=my / 2)
                    .flat_map(|k| (0..ny / 2).map(move |cell| 2.0 * wave(k, cell, my, is_odd)))
                    .collect()
            }),
            from_y: both(&|is_odd| from(ny, wide_y, my, is_odd)),
            to_x: both(&|is_odd| {
                let mut table = vec![0.0; nx / 2 * filled];
                for (cell, row) in table.chunks_exact_mut(filled).enumerate() {
                    for (k, value) in row[..=mx / 2].iter_mut().enumerate() {
                        *value = 2.0 * wave(k, cell, mx, is_odd);
                    }
                }
                table
            }),
            from_x: both(&|is_odd| from(nx, wide_x, mx, is_odd)),
        }
    }
}

impl Waves {
    /// The wave vectors of a box of `mx × my` around `nx × ny` cells, which are even numbers where
    /// all fields are symmetric.
    pub fn new(
        [nx, ny]: [usize; 2],
        [mx, my]: [usize; 2],
        is_symmetric: bool,
        arch: pulp::Arch,
    ) -> Self {
        let transform = Transform::new(nx, ny, mx, my);
        let half = mx / 2 + 1;
        let filled = half.next_multiple_of(WIDTH);
        let quarter = is_symmetric.then(|| Quarter::new(&transform, filled));
        Self { transform, half, filled, quarter, arch }
    }

    /// Whether all fields are symmetric about both axes.
    pub const fn is_symmetric(&self) -> bool {
        self.quarter.is_some()
    }

    /// Numbers of a row.
    pub fn row_len(&self) -> usize {
        Self::row_len_of(self.transform.mx, self.is_symmetric())
    }

    fn row_len_of(mx: usize, is_symmetric: bool) -> usize {
        let planes = if is_symmetric { 1 } else { 4 };
        planes * (mx / 2 + 1).next_multiple_of(WIDTH)
    }

    /// Numbers of a stack for `n_fields` fields of `nx × ny` with padding.
    pub fn padded_stack_len([nx, ny]: [usize; 2], n_fields: usize, is_symmetric: bool) -> usize {
        let [mx, my] = [nx, ny].map(|n| fast_length(2 * n));
        (my / 2 + 1) * n_fields * Self::row_len_of(mx, is_symmetric)
    }

    /// Numbers of a stack.
    pub fn stack_len(&self, n_fields: usize) -> usize {
        self.transform.n_rows() * n_fields * self.row_len()
    }

    pub fn scratch(&self) -> WavesScratch {
        let Transform { nx, ny, mx, .. } = self.transform;
        let n_rows = self.transform.n_rows();
        let (mut table, mut cells) = (Vec::new(), Vec::new());
        if let Some(quarter) = &self.quarter {
            table.resize((ny / 2).max(n_rows) * quarter.wide_x, 0.0);
            cells.resize(quarter.wide_y, 0.0);
        }
        WavesScratch {
            complex: self.transform.scratch(),
            line: vec![Complex64::ZERO; mx],
            vector: vec![0.0; self.half.max(nx)],
            table,
            cells,
        }
    }

    /// Transforms a field along y into its rows of a stack.
    pub fn rows_forward(
        &self,
        field: &[f64],
        parity: Parity,
        stack: &mut [f64],
        (n_fields, index): (usize, usize),
        scratch: &mut WavesScratch,
    ) {
        let row_len = self.row_len();
        let mut rows = stack
            .chunks_exact_mut(n_fields * row_len)
            .map(|block| &mut block[index * row_len..][..row_len]);
        let Transform { nx, ny, .. } = self.transform;
        let Some(quarter) = &self.quarter else {
            let spectra = self.transform.rows_forward(field, &mut scratch.complex);
            let n_rows = self.transform.n_rows();
            for (iy, row) in rows.enumerate() {
                for (to, from) in row.chunks_exact_mut(2).zip(spectra.chunks_exact(n_rows)) {
                    to.copy_from_slice(&[from[iy].re, from[iy].im]);
                }
            }
            return;
        };
        let wide = quarter.wide_x;
        for (i, values) in field.chunks_exact(ny).skip(nx / 2).enumerate() {
            for (j, value) in values[ny / 2..].iter().enumerate() {
                scratch.table[j * wide + i] = *value;
            }
        }
        let table = &scratch.table[..ny / 2 * wide];
        let mut waves = quarter.to_y[usize::from(parity.is_odd_in_y())].chunks_exact(ny / 2);
        self.arch.dispatch(Wide(
            #[inline(always)]
            || {
                for (row, waves) in rows.by_ref().zip(waves.by_ref()) {
                    combine(waves, table, &mut row[..wide]);
                }
            },
        ));
    }

    /// Transforms a row along x, in place.
    pub fn columns_forward(&self, row: &mut [f64], parity: Parity, scratch: &mut WavesScratch) {
        let nx = self.transform.nx;
        if let Some(quarter) = &self.quarter {
            let vector = &mut scratch.vector[..nx / 2];
            signed(&row[..nx / 2], parity, vector);
            let table = &quarter.to_x[usize::from(parity.is_odd_in_x())];
            self.arch.dispatch(Wide(
                #[inline(always)]
                || combine(vector, table, row),
            ));
            return;
        }
        for (to, from) in scratch.line.iter_mut().zip(row[..2 * nx].chunks_exact(2)) {
            *to = Complex64::new(from[0], from[1]);
        }
        scratch.line[nx..].fill(Complex64::ZERO);
        self.transform.columns_forward(&mut scratch.line, &mut scratch.complex);
        let (plus, minus) = row.split_at_mut(2 * self.filled);
        let (positive, negative) = (&scratch.line[..self.half], &scratch.line[self.half - 1..]);
        to_planes(positive.iter(), parity, plus, self.filled);
        to_planes(positive[..1].iter().chain(negative.iter().rev()), parity, minus, self.filled);
    }

    /// Transforms a row back along x, in place.
    pub fn columns_inverse(&self, row: &mut [f64], parity: Parity, scratch: &mut WavesScratch) {
        let Transform { nx, mx, .. } = self.transform;
        if let Some(quarter) = &self.quarter {
            let vector = &mut scratch.vector[..self.half];
            signed(&row[..self.half], parity, vector);
            let table = &quarter.from_x[usize::from(parity.is_odd_in_x())];
            self.arch.dispatch(Wide(
                #[inline(always)]
                || combine(vector, table, &mut row[..quarter.wide_x]),
            ));
            return;
        }
        let (plus, minus) = row.split_at(2 * self.filled);
        let (positive, negative) = scratch.line.split_at_mut(self.half);
        from_planes(plus, self.filled, parity, 0, positive.iter_mut());
        from_planes(minus, self.filled, parity, 1, negative.iter_mut().rev());
        // The largest wave number along x is its own negative: the mean of both.
        let mut other = [Complex64::ZERO];
        from_planes(minus, self.filled, parity, mx / 2, other.iter_mut());
        positive[mx / 2] = 0.5 * (positive[mx / 2] + other[0]);
        self.transform.columns_inverse(&mut scratch.line, &mut scratch.complex);
        for (to, from) in row[..2 * nx].chunks_exact_mut(2).zip(&scratch.line) {
            to.copy_from_slice(&[from.re, from.im]);
        }
    }

    /// Transforms the rows of a field back along y.
    pub fn rows_inverse(
        &self,
        stack: &[f64],
        (n_fields, index): (usize, usize),
        parity: Parity,
        field: &mut [f64],
        scratch: &mut WavesScratch,
    ) {
        let row_len = self.row_len();
        let rows = stack
            .chunks_exact(n_fields * row_len)
            .map(|block| &block[index * row_len..][..row_len]);
        let Transform { nx, ny, .. } = self.transform;
        let n_rows = self.transform.n_rows();
        let Some(quarter) = &self.quarter else {
            let spectra = scratch.complex.rows_mut();
            for (iy, row) in rows.enumerate() {
                for (to, from) in spectra.chunks_exact_mut(n_rows).zip(row.chunks_exact(2)) {
                    to[iy] = Complex64::new(from[0], from[1]);
                }
            }
            self.transform.rows_inverse(field, &mut scratch.complex);
            return;
        };
        for (iy, row) in rows.enumerate() {
            for (i, value) in row[..nx / 2].iter().enumerate() {
                scratch.table[i * n_rows + iy] = *value;
            }
        }
        let waves = &quarter.from_y[usize::from(parity.is_odd_in_y())];
        let sign_x = if parity.is_odd_in_x() { -1.0 } else { 1.0 };
        let sign_y = if parity.is_odd_in_y() { -1.0 } else { 1.0 };
        let (before, after) = field.split_at_mut(nx / 2 * ny);
        let mut mirrored = after.chunks_exact_mut(ny).zip(before.chunks_exact_mut(ny).rev());
        let (cells, mut table) = (&mut scratch.cells, scratch.table.chunks_exact(n_rows));
        self.arch.dispatch(Wide(
            #[inline(always)]
            || {
                for (spectrum, (row, mirror)) in table.by_ref().zip(mirrored.by_ref()) {
                    combine(spectrum, waves, cells);
                    let (left, right) = row.split_at_mut(ny / 2);
                    right.copy_from_slice(&cells[..ny / 2]);
                    for (to, from) in left.iter_mut().rev().zip(&*right) {
                        *to = sign_y * from;
                    }
                    for (to, from) in mirror.iter_mut().zip(&*row) {
                        *to = sign_x * from;
                    }
                }
            },
        ));
    }

    /// Transforms a field whose stack holds nothing else.
    pub fn forward(&self, field: &[f64], stack: &mut [f64], scratch: &mut WavesScratch) {
        self.rows_forward(field, Parity::Even, stack, (1, 0), scratch);
        for row in stack.chunks_exact_mut(self.row_len()) {
            self.columns_forward(row, Parity::Even, scratch);
        }
    }

    /// The reverse.
    pub fn inverse(&self, stack: &mut [f64], field: &mut [f64], scratch: &mut WavesScratch) {
        for row in stack.chunks_exact_mut(self.row_len()) {
            self.columns_inverse(row, Parity::Even, scratch);
        }
        self.rows_inverse(stack, (1, 0), Parity::Even, field, scratch);
    }

    /// Transforms the six rows of a layer along x; those of a deviator lack zz.
    pub fn layer_forward(&self, rows: &mut [f64], is_deviator: bool, scratch: &mut WavesScratch) {
        let row_len = self.row_len();
        for (component, row) in rows.chunks_exact_mut(row_len).enumerate() {
            if !(is_deviator && component == 2) {
                self.columns_forward(row, PARITIES[component], scratch);
            }
        }
        if is_deviator {
            let (in_plane, normal) = rows.split_at_mut(2 * row_len);
            let (xx, yy) = in_plane.split_at(row_len);
            for ((zz, xx), yy) in normal.iter_mut().zip(xx).zip(yy) {
                *zz = -xx - yy;
            }
        }
    }

    /// Transforms the six rows of a layer back along x, or those of a deviator.
    pub fn layer_inverse(&self, rows: &mut [f64], is_deviator: bool, scratch: &mut WavesScratch) {
        for (component, row) in rows.chunks_exact_mut(self.row_len()).enumerate() {
            if !(is_deviator && component == 2) {
                self.columns_inverse(row, PARITIES[component], scratch);
            }
        }
    }
}

/// A loop that `pulp` compiles for the widest vectors of the machine.
///
/// A closure that does not consume what it captures is a function of its own behind `FnOnce`, and
/// as such it is compiled for the narrowest.
pub(crate) struct Wide<F>(pub F);

impl<F: FnMut()> pulp::NullaryFnOnce for Wide<F> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        (self.0)();
    }
}

/// Fourier's signs of sums of cosines and sines, with -i where a spectrum is imaginary.
fn signed(from: &[f64], parity: Parity, to: &mut [f64]) {
    let sign = if parity == Parity::Even { 1.0 } else { -1.0 };
    for (to, from) in to.iter_mut().zip(from) {
        *to = sign * from;
    }
}

/// Two planes of a spectrum.
fn to_planes<'a>(
    spectrum: impl Iterator<Item = &'a Complex64>,
    parity: Parity,
    planes: &mut [f64],
    filled: usize,
) {
    let (first, second) = planes.split_at_mut(filled);
    let mut len = 0;
    let numbers = first.iter_mut().zip(second.iter_mut()).zip(spectrum);
    if parity.is_imaginary() {
        for ((first, second), value) in numbers {
            (*first, *second) = (value.im, -value.re);
            len += 1;
        }
    } else {
        for ((first, second), value) in numbers {
            (*first, *second) = (value.re, value.im);
            len += 1;
        }
    }
    first[len..].fill(0.0);
    second[len..].fill(0.0);
}

/// The spectrum of two planes from a number on.
fn from_planes<'a>(
    planes: &[f64],
    filled: usize,
    parity: Parity,
    start: usize,
    spectrum: impl Iterator<Item = &'a mut Complex64>,
) {
    let (first, second) = planes.split_at(filled);
    let numbers = spectrum.zip(first[start..].iter().zip(&second[start..]));
    if parity.is_imaginary() {
        for (value, (first, second)) in numbers {
            *value = Complex64::new(-second, *first);
        }
    } else {
        for (value, (first, second)) in numbers {
            *value = Complex64::new(*first, *second);
        }
    }
}

/// `out = Σ factor row` over the rows of a table.
#[inline(always)]
pub(crate) fn combine(factors: &[f64], table: &[f64], out: &mut [f64]) {
    let width = out.len();
    let mut start = 0;
    while start + WIDE <= width {
        combine_some::<WIDE>(factors, table, width, start, out);
        start += WIDE;
    }
    while start < width {
        combine_some::<WIDTH>(factors, table, width, start, out);
        start += WIDTH;
    }
}

#[inline(always)]
fn combine_some<const L: usize>(
    factors: &[f64],
    table: &[f64],
    width: usize,
    start: usize,
    out: &mut [f64],
) {
    let mut sum = [0.0; L];
    for (factor, row) in factors.iter().zip(table.chunks_exact(width)) {
        let row = &row[start..start + L];
        for n in 0..L {
            sum[n] += factor * row[n];
        }
    }
    out[start..start + L].copy_from_slice(&sum);
}
