//! Whether a body endures a contact that passes over it: criteria of high-cycle fatigue over depth.
//!
//! Each place of the body sees the elastic stress of the pressure and of its traction beside a
//! stress that stands still: residual stress of what has yielded, and the stress before any load.
//! The path closes, since far ahead and far behind there is no load. This holds for a body that has
//! shaken down, and for no other.
//!
//! The utilization is the shear stress that a criterion makes of the path over the fatigue limit in
//! torsion at this depth. A stress that stands still adds its hydrostatic part alone
//! ([`brinell_material::fatigue`]).

use brinell_material::fatigue::{Criterion, Cycle, FatigueStrength, Stress, relative_life};

use crate::passing::Passing;
use crate::stop::{Stop, Stopped, ask};

/// Rows of a path at most: the others lie between them.
const MOST_ROWS: usize = 24;

/// Points of a path for each column. Dang Van's stress has a kink where principal stresses change
/// places: of a line with 20 columns a half-width it is 0.1807 p0 on the columns and 0.1815 p0 on
/// points eight times as close.
const POINTS: usize = 8;

/// Utilization of a body by each criterion.
#[derive(Debug, Clone, PartialEq)]
pub struct Fatigue {
    /// Depths of the curves, from the surface down \[mm\].
    pub depths: Vec<f64>,
    /// By criterion, in the order of [`Criterion::ALL`]; `None` of a criterion that does not hold
    /// for the limits.
    pub criteria: [Option<Utilization>; 3],
}

/// Utilization by one criterion: the body endures at 1 and below.
#[derive(Debug, Clone, PartialEq)]
pub struct Utilization {
    /// Largest utilization across the travel at each depth.
    pub over_depth: Vec<f64>,
    /// The largest of all.
    pub largest: Largest,
    /// The largest without residual and initial stress.
    pub without_rest: f64,
    /// Estimated error of the largest; `None` where it is not known.
    pub error: Option<f64>,
    /// The largest under the elastic contact of the same force in a body without residual and
    /// initial stress; `None` where there is no such contact.
    pub elastic: Option<f64>,
}

/// A utilization and its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Largest {
    /// The utilization.
    pub value: f64,
    /// Depth \[mm\].
    pub depth: f64,
    /// y \[mm\]; 0 of a line.
    pub across: f64,
}

impl Utilization {
    /// The part that residual and initial stress have in the largest utilization; negative where
    /// they help.
    pub fn of_rest(&self) -> f64 {
        self.largest.value - self.without_rest
    }

    /// Range of the life over that of the elastic contact, over the exponents in use and a relative
    /// error of the largest utilization.
    pub fn relative_life(&self, error: f64) -> Option<[f64; 2]> {
        let ratio = self.largest.value / self.elastic?;
        let [least, _] = relative_life(ratio * (1.0 + error))?;
        let [_, most] = relative_life(ratio * (1.0 - error))?;
        most.is_finite().then_some([least, most])
    }
}

impl Fatigue {
    /// Relative error of the largest utilization, times the cells over half the contact: Hertz's line
    /// and circle have up to 0.08 and 0.21 on 6 cells, and less on more.
    pub const OF_CELLS: f64 = 0.25;

    /// The utilization of a body at some depths \[mm\], from the surface down, under a pressure
    /// with a traction `friction` times it. `at_rest` is the hydrostatic part of the stress that
    /// stands still, at a depth and a y \[MPa\].
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked at each depth.
    pub fn of(
        passing: &Passing,
        friction: f64,
        strength: &FatigueStrength,
        depths: Vec<f64>,
        at_rest: impl Fn(f64, f64) -> f64,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let limits = strength.limits();
        let weights = Criterion::ALL.map(|criterion| limits.weight(criterion));
        let slides = friction != 0.0;
        let passing = if slides { passing.clone().sliding() } else { passing.clone() };
        let rows: Vec<(usize, f64)> = passing.rows().collect();
        let step = rows.len().div_ceil(MOST_ROWS);
        let mut criteria = weights.map(|weight| weight.map(|_| Utilization::none()));
        for depth in &depths {
            ask(stop)?;
            let (level, limit) = (passing.at(*depth), strength.torsion(*depth));
            for criterion in criteria.iter_mut().flatten() {
                criterion.over_depth.push(f64::NEG_INFINITY);
            }
            for (row, y) in rows.iter().step_by(step) {
                let path = level.path(*row).iter().map(|s| with(s, friction)).collect();
                let path = if *depth > passing.column() { refined(path) } else { path };
                let (cycle, rest) = (Cycle::of(&path), at_rest(*depth, *y));
                let all = criteria.iter_mut().zip(Criterion::ALL).zip(weights);
                for ((criterion, name), weight) in all {
                    let Some((criterion, weight)) = criterion.as_mut().zip(weight) else {
                        continue;
                    };
                    let shear = cycle.shear(name, weight);
                    let value = (shear + weight * rest) / limit;
                    criterion.add(shear / limit, Largest { value, depth: *depth, across: *y });
                }
            }
        }
        Ok(Self { depths, criteria })
    }

    /// The same beside the elastic contact of the same force, where there is one.
    ///
    /// # Errors
    /// [`Stopped`], as of [`Self::of`].
    pub fn beside(
        mut self,
        elastic: Option<&Passing>,
        friction: f64,
        strength: &FatigueStrength,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let Some(elastic) = elastic else { return Ok(self) };
        let depths = self.depths.clone();
        let elastic = Self::of(elastic, friction, strength, depths, |_, _| 0.0, stop)?;
        for (criterion, elastic) in self.criteria.iter_mut().zip(elastic.criteria) {
            if let Some(criterion) = criterion {
                criterion.elastic = elastic.map(|elastic| elastic.without_rest);
            }
        }
        Ok(self)
    }

    /// The largest utilization by each criterion.
    pub fn largest(&self) -> [Option<f64>; 3] {
        self.criteria.each_ref().map(|of| of.as_ref().map(|of| of.largest.value))
    }
}

impl Utilization {
    fn none() -> Self {
        let value = f64::NEG_INFINITY;
        Self {
            over_depth: Vec::new(),
            largest: Largest { value, depth: 0.0, across: 0.0 },
            without_rest: value,
            error: None,
            elastic: None,
        }
    }

    fn add(&mut self, without_rest: f64, with_rest: Largest) {
        self.without_rest = self.without_rest.max(without_rest);
        if let Some(here) = self.over_depth.last_mut() {
            *here = here.max(with_rest.value);
        }
        if with_rest.value > self.largest.value {
            self.largest = with_rest;
        }
    }
}

/// The stress under a pressure and under a traction μ times it.
fn with([pressure, traction]: &[Stress; 2], friction: f64) -> Stress {
    std::array::from_fn(|k| pressure[k] + friction * traction[k])
}

/// A path with points between its own, by the cubics through four neighbours. The last point is far
/// from the load and not their neighbour.
fn refined(path: Vec<Stress>) -> Vec<Stress> {
    let Some((far, points)) = path.split_last() else { return path };
    let mut fine = points[..points.len().min(1)].to_vec();
    for near in points.windows(4) {
        fine.extend((0..POINTS).map(|part| between(near, part as f64 / POINTS as f64)));
    }
    fine.extend(&points[points.len().saturating_sub(2)..]);
    fine.push(*far);
    fine
}

/// The value at a part of the way from the second to the third of four neighbours.
fn between(near: &[Stress], t: f64) -> Stress {
    let weights = [
        -t * (t - 1.0) * (t - 2.0) / 6.0,
        (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
        -(t + 1.0) * t * (t - 2.0) / 2.0,
        (t + 1.0) * t * (t - 1.0) / 6.0,
    ];
    std::array::from_fn(|k| {
        weights.iter().zip(near).map(|(weight, stress)| weight * stress[k]).sum()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cubics are met, own points stay, and the last point is no neighbour.
    #[test]
    fn a_refined_path_goes_through_its_points() {
        let of = |x: f64| -> Stress { [x, 1.0 - x, x * x, x.powi(3), 2.0, x.powi(3) - x] };
        let path: Vec<Stress> = (0..9).map(|k| of(f64::from(k))).chain([[0.0; 6]]).collect();
        let fine = refined(path.clone());
        assert_eq!(fine.len(), 1 + 6 * POINTS + 2 + 1);
        let is_near = |a: &Stress, b: &Stress| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(is_near(&fine[0], &path[0]));
        for (k, found) in fine[1..=6 * POINTS].iter().enumerate() {
            assert!(is_near(found, &of(1.0 + k as f64 / POINTS as f64)), "{k}");
        }
        for (found, expected) in fine[6 * POINTS + 1..].iter().zip(&path[7..]) {
            assert!(is_near(found, expected));
        }
        for short in [vec![], path[..1].to_vec(), path[6..].to_vec()] {
            assert!(refined(short.clone()).ends_with(&short[short.len().min(1)..]));
        }
    }
}
