//! The stress that the places of a half-space see while a pressure passes over it along x.
//!
//! In the frame of the load a place moves along a line in x, from far ahead to far behind, where
//! there is no stress. Stresses are sums over cells of constant pressure
//! ([`pressure_stress`](crate::pressure_stress), [`traction_stress`](crate::traction_stress)), of a
//! line over strips.

use std::f64::consts::PI;

use brinell_material::fatigue::Stress;

use crate::line::strip;
use crate::tensors::COMPONENTS;
use crate::{SurfaceGrid, pressure_stress, traction_stress};

/// Part of a pressure below which its two sides are alike, and depth over a cell at which stress is
/// that of the surface.
const ALIKE: f64 = 1e-6;

/// A pressure that passes over a half-space along x: the cells of the smallest rectangle with all
/// of the contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Passing {
    /// Cells along x and y.
    cells: [usize; 2],
    sides: [f64; 2],
    /// y of the first row.
    first: f64,
    /// Row by row, along x.
    pressure: Vec<f64>,
    below: Below,
    slides: bool,
}

/// What lies below the pressure, with the elastic constant of its stress.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Below {
    /// Below a line: stress out of the section over the sum of both in it.
    Section { out_of_plane: f64 },
    /// Below an area.
    Space { poisson: f64 },
}

impl Passing {
    /// A pressure in strips of the width h of a line \[MPa, mm\]. The stress out of the section is
    /// `out_of_plane (σxx + σzz)`: Poisson's ratio in plane strain, 0 in plane stress. `None`
    /// without contact.
    pub fn line(pressure: &[f64], h: f64, out_of_plane: f64) -> Option<Self> {
        let first = pressure.iter().position(|p| *p > 0.0)?;
        let last = pressure.iter().rposition(|p| *p > 0.0)?;
        Some(Self {
            cells: [last - first + 1, 1],
            sides: [h, 1.0],
            first: 0.0,
            pressure: pressure[first..=last].to_vec(),
            below: Below::Section { out_of_plane },
            slides: false,
        })
    }

    /// A pressure in the cells of a surface \[MPa\]; `None` without contact.
    pub fn area(pressure: &[f64], grid: &SurfaceGrid, poisson: f64) -> Option<Self> {
        let touches = |i: usize, j: usize| pressure[i * grid.ny() + j] > 0.0;
        let columns: Vec<usize> =
            (0..grid.nx()).filter(|i| (0..grid.ny()).any(|j| touches(*i, j))).collect();
        let rows: Vec<usize> =
            (0..grid.ny()).filter(|j| (0..grid.nx()).any(|i| touches(i, *j))).collect();
        let ([left, right], [near, far]) = (ends(&columns)?, ends(&rows)?);
        let row = |j: usize| (left..=right).map(move |i| pressure[i * grid.ny() + j].max(0.0));
        Some(Self {
            cells: [right - left + 1, far - near + 1],
            sides: [grid.hx(), grid.hy()],
            first: grid.y(near),
            pressure: (near..=far).flat_map(row).collect(),
            below: Below::Space { poisson },
            slides: false,
        })
    }

    /// Hertz's line of peak pressure 1 and half-width a \[mm\], in so many strips over a.
    pub fn hertz_line(half_width: f64, strips: usize, out_of_plane: f64) -> Option<Self> {
        let pressure = means(strips, 1.0);
        let passing = Self::line(&pressure, half_width / strips as f64, out_of_plane)?;
        Some(passing.carrying(0.5 * PI * half_width))
    }

    /// Hertz's ellipse of peak pressure 1 and semi-axes along and across the travel \[mm\], in so
    /// many cells over each.
    pub fn hertz_ellipse([a, b]: [f64; 2], cells: [usize; 2], poisson: f64) -> Option<Self> {
        let [along, across] = cells;
        let grid = SurfaceGrid::new(2 * along, 2 * across, a / along as f64, b / across as f64);
        let grid = grid.ok()?;
        let row = |j: usize| means(along, 1.0 - (grid.y(j) / b).powi(2));
        let rows: Vec<Vec<f64>> = (0..grid.ny()).map(row).collect();
        let pressure: Vec<f64> =
            (0..grid.nx()).flat_map(|i| rows.iter().map(move |row| row[i])).collect();
        let passing = Self::area(&pressure, &grid, poisson)?;
        Some(passing.carrying(2.0 / 3.0 * PI * a * b))
    }

    /// The pressure, multiplied by a factor.
    #[must_use]
    pub fn times(mut self, factor: f64) -> Self {
        for pressure in &mut self.pressure {
            *pressure *= factor;
        }
        self
    }

    /// The pressure, scaled so that it carries a force \[N, N/mm of a line\].
    #[must_use]
    pub fn carrying(self, force: f64) -> Self {
        let carried = self.sides[0] * self.sides[1] * self.pressure.iter().sum::<f64>();
        self.times(force / carried)
    }

    /// The pressure with a traction in proportion to it.
    #[must_use]
    pub fn sliding(self) -> Self {
        Self { slides: true, ..self }
    }

    /// Width of a column along x \[mm\].
    pub const fn column(&self) -> f64 {
        self.sides[0]
    }

    /// The rows that tell all, with their y \[mm\]: of a pressure that is alike on both sides of y
    /// = 0 those at y >= 0.
    pub fn rows(&self) -> impl Iterator<Item = (usize, f64)> {
        let rows = self.cells[1];
        let least = if self.is_even() { rows / 2 } else { 0 };
        (least..rows).map(|j| (j, self.first + j as f64 * self.sides[1]))
    }

    fn is_even(&self) -> bool {
        let [nx, ny] = self.cells;
        let middle = self.first + 0.5 * (ny - 1) as f64 * self.sides[1];
        let most = self.pressure.iter().copied().fold(0.0, f64::max);
        let row = |j: usize| &self.pressure[j * nx..][..nx];
        let is_like = |j: usize| {
            row(j).iter().zip(row(ny - 1 - j)).all(|(a, b)| (a - b).abs() <= ALIKE * most)
        };
        middle.abs() <= ALIKE * self.sides[1] && (0..ny / 2).all(is_like)
    }

    /// Points of a path: half as many on each side of the contact as in it.
    const fn points(&self) -> usize {
        self.cells[0] + 2 * self.reach()
    }

    const fn reach(&self) -> usize {
        self.cells[0] / 2
    }

    /// Numbers of a point: components under pressure, and those under a traction.
    const fn width(&self) -> usize {
        if self.slides { 2 * COMPONENTS } else { COMPONENTS }
    }

    /// The stress at a depth \[mm\].
    pub fn at(&self, depth: f64) -> Level<'_> {
        let [hx, hy] = self.sides;
        let kernel = match self.below {
            Below::Section { out_of_plane } => self.of_strips(depth.max(ALIKE * hx), out_of_plane),
            Below::Space { poisson } => self.of_cells(depth.max(ALIKE * hx.min(hy)), poisson),
        };
        Level { of: self, kernel }
    }

    /// Offsets along x between points and cells.
    const fn offsets(&self) -> usize {
        self.points() + self.cells[0] - 1
    }

    /// Offset of a place from a cell, or from the corner before it.
    fn offset(&self, along: f64, across: f64) -> [f64; 2] {
        let least = [self.reach() + self.cells[0] - 1, self.cells[1] - 1];
        [(along - least[0] as f64) * self.sides[0], (across - least[1] as f64) * self.sides[1]]
    }

    fn of_strips(&self, depth: f64, out_of_plane: f64) -> Vec<f64> {
        let stress = |[xx, zz, xz]: [f64; 3]| [xx, out_of_plane * (xx + zz), zz, 0.0, xz, 0.0];
        let mut kernel = Vec::with_capacity(self.offsets() * self.width());
        for d in 0..self.offsets() {
            let [x, _] = self.offset(d as f64, 0.0);
            let both = strip::at(x, depth, self.sides[0]).map(stress);
            kernel.extend(both.as_flattened().iter().take(self.width()));
        }
        kernel
    }

    fn of_cells(&self, depth: f64, poisson: f64) -> Vec<f64> {
        let (columns, rows) = (self.offsets(), 2 * self.cells[1] - 1);
        let corner = |d: usize, e: usize| {
            let [x, y] = self.offset(d as f64 - 0.5, e as f64 - 0.5);
            let traction = if self.slides {
                traction_stress::corner(x, y, depth, poisson)
            } else {
                [0.0; COMPONENTS]
            };
            [pressure_stress::corner(x, y, depth, poisson), traction]
        };
        let corners: Vec<[Stress; 2]> = (0..=rows)
            .flat_map(|e| (0..=columns).map(move |d| (d, e)))
            .map(|(d, e)| corner(d, e))
            .collect();
        let at = |d: usize, e: usize| corners[e * (columns + 1) + d].as_flattened();
        let mut kernel = Vec::with_capacity(rows * columns * self.width());
        for e in 0..rows {
            for d in 0..columns {
                let [a, b, c, f] = [at(d, e), at(d + 1, e), at(d, e + 1), at(d + 1, e + 1)];
                let of = |k: usize| (a[k] - b[k] - c[k] + f[k]) / (2.0 * PI);
                kernel.extend((0..self.width()).map(of));
            }
        }
        kernel
    }
}

/// Means of `√(c² - x²)` over strips between x = -1 and 1, so many over 1.
fn means(strips: usize, square: f64) -> Vec<f64> {
    let end = square.max(0.0).sqrt();
    // ∫√(c² - x²) dx
    let up_to = |k: usize| {
        let x = (k as f64 / strips as f64 - 1.0).clamp(-end, end);
        let angle = if end > 0.0 { (x / end).clamp(-1.0, 1.0).asin() } else { 0.0 };
        0.5 * (x * (square - x * x).max(0.0).sqrt() + square * angle)
    };
    (0..2 * strips).map(|k| strips as f64 * (up_to(k + 1) - up_to(k))).collect()
}

fn ends(places: &[usize]) -> Option<[usize; 2]> {
    Some([*places.first()?, *places.last()?])
}

/// A depth below a pressure that passes.
pub struct Level<'a> {
    of: &'a Passing,
    /// Offset across, offset along, component.
    kernel: Vec<f64>,
}

impl Level<'_> {
    /// The path of a row: stress under the pressure, and under a traction in +x that equals it,
    /// which is zero unless the pressure [slides](Passing::sliding) \[MPa\]. The last point is far
    /// from the load.
    pub fn path(&self, row: usize) -> Vec<[Stress; 2]> {
        let ([nx, ny], width) = (self.of.cells, self.of.width());
        let (points, offsets) = (self.of.points() * width, self.of.offsets() * width);
        let mut sum = vec![0.0; points];
        for (j, pressure) in self.of.pressure.chunks_exact(nx).enumerate() {
            let kernel = &self.kernel[(row + ny - 1 - j) * offsets..][..offsets];
            for (i, p) in pressure.iter().enumerate().filter(|(_, p)| **p != 0.0) {
                for (sum, k) in sum.iter_mut().zip(&kernel[(nx - 1 - i) * width..]) {
                    *sum += p * k;
                }
            }
        }
        let component = |point: &[f64], k: usize| point.get(k).copied().unwrap_or(0.0);
        let stresses = |point: &[f64]| {
            [0, COMPONENTS].map(|from| std::array::from_fn(|k| component(point, from + k)))
        };
        sum.chunks_exact(width).map(stresses).chain([[[0.0; COMPONENTS]; 2]]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stress in the middle of Hertz's contacts of peak pressure 1, by their closed forms.
    #[test]
    fn the_middle_of_a_path_has_the_stress_of_hertz() {
        let middle = |passing: &Passing, depth: f64, row: usize| {
            let path = passing.at(depth).path(row);
            let [k, l] = [(path.len() - 1) / 2 - 1, (path.len() - 1) / 2];
            std::array::from_fn::<f64, 6, _>(|n| 0.5 * (path[k][0][n] + path[l][0][n]))
        };
        let line = Passing::hertz_line(2.0, 40, 0.3).unwrap();
        let hertz = brinell_material::analytical::HertzLine::from_peak_pressure(1.0, 4.0, 4.0);
        for depth in [0.4, 1.6, 5.0] {
            let [xx, yy, zz, ..] = middle(&line, depth, 0);
            let stress = hertz.stress_on_axis(depth, 0.3);
            for (found, expected) in
                [(xx, stress.sigma_x), (yy, stress.sigma_z), (zz, stress.sigma_y)]
            {
                assert!((found - expected).abs() < 1e-3, "{depth}: {found} {expected}");
            }
        }
        let circle = Passing::hertz_ellipse([2.0, 2.0], [16, 16], 0.3).unwrap();
        let (row, y) = circle.rows().next().unwrap();
        assert!((y - 0.0625).abs() < 1e-12 && circle.rows().count() == 16);
        // Half a cell off the axis along both sides.
        let off = 0.5 / 16.0 * 2f64.sqrt();
        for depth in [1.0, 2.0, 4.0] {
            let zz = middle(&circle, depth, row)[2];
            let expected = below_circle(off, 0.5 * depth);
            assert!((zz - expected).abs() < 1.2e-3, "{depth}: {zz} {expected}");
        }
    }

    /// σzz below a circle of radius and peak pressure 1. M. T. Huber, Ann. Phys. 14 (1904) 153.
    fn below_circle(r: f64, z: f64) -> f64 {
        let b = r * r + z * z - 1.0;
        let u = 0.5 * (b + b.hypot(2.0 * z));
        -(z / u.sqrt()).powi(3) * u / (u * u + z * z)
    }

    /// Rows of a pressure that is heavier on one side are all looked at.
    #[test]
    fn uneven_pressures_have_all_their_rows() {
        let grid = SurfaceGrid::new(6, 8, 0.1, 0.2).unwrap();
        let pressure =
            grid.sample(|x, y| if x.abs() < 0.2 && y.abs() < 0.6 { 1.0 + y } else { 0.0 });
        let passing = Passing::area(&pressure, &grid, 0.3).unwrap();
        let rows: Vec<f64> = passing.rows().map(|(_, y)| y).collect();
        assert_eq!(rows.len(), 6, "{rows:?}");
        assert!((rows[0] + 0.5).abs() < 1e-12 && passing.cells == [4, 6]);
        assert!(Passing::area(&vec![0.0; 48], &grid, 0.3).is_none());
        assert!(Passing::line(&[0.0, 0.0], 0.1, 0.3).is_none());
    }
}
