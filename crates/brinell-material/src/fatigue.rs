//! High-cycle fatigue: criteria on the path of the stress at one point.
//!
//! A body that has shaken down sees the same closed path of stresses in each pass. A criterion makes
//! one shear stress of this path. The point endures while this stress is at most the fatigue limit in
//! torsion. Over the path, σ_h is a third of the trace, s the deviator, and s* the centre of the
//! smallest ball round all s, in the norm √(s:s):
//!
//! ```text
//! Dang Van          max [ τ(s - s*) + a σ_h ]     a = 3 t/f - 3/2    τ: half the difference of the
//! Crossland         R/√2 + a max σ_h              a = 3 t/f - √3        extreme principal values
//! orthogonal shear  half the range of σ_xz
//! ```
//!
//! R is the radius of that ball; t and f are the limits in torsion and in bending at R = -1. Under
//! torsion of amplitude t and under bending of amplitude f both of the first two criteria give t.
//!
//! **A stress that stands still**, as residual and initial stress do, moves s* by its deviator and
//! leaves s - s*. It adds its σ_h, multiplied by a, to the first two criteria, and nothing to the
//! third.
//!
//! **Life.** Lundberg and Palmgren's number of passes that a share of all bodies survives falls with
//! the shear stress τ, its depth z and the stressed volume V,
//! ```text
//! L^e ~ z^h / (τ^c V)     c = 31/3, h = 7/3, e = 10/9 of balls, 9/8 of lines
//! ```
//! Two contacts under one force differ in τ alone, but for little: `L ~ τ^(-c/e)`, with exponents
//! from 9 to 10.3 in use.
//!
//! # Reference
//! K. Dang Van, *Macro-micro approach in high-cycle multiaxial fatigue*, ASTM STP 1191 (1993)
//! 120–130; B. Crossland, *Effect of large hydrostatic pressures on the torsional fatigue strength of
//! an alloy steel*, Proc. Int. Conf. Fatigue of Metals, IMechE (1956) 138–149; G. Lundberg, A.
//! Palmgren, *Dynamic capacity of rolling bearings*, Acta Polytechnica, Mech. Eng. Ser. 1 no. 3
//! (1947), with e of lines from no. 4 of volume 2 (1952).

use crate::{Ball, StrengthProfile, smallest_ball};

/// A stress `xx yy zz xy xz yz` \[MPa\]; z is the depth and x the travel.
pub type Stress = [f64; 6];

/// A criterion of high-cycle fatigue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Criterion {
    /// Dang Van's.
    DangVan,
    /// Crossland's.
    Crossland,
    /// The amplitude of the shear stress along the surface.
    OrthogonalShear,
}

impl Criterion {
    /// All criteria, in the order of fields that have one value of each.
    pub const ALL: [Self; 3] = [Self::DangVan, Self::Crossland, Self::OrthogonalShear];
}

/// Fatigue limits of a material: amplitudes at a stress ratio of -1 \[MPa\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// In torsion.
    pub torsion: f64,
    /// In bending.
    pub bending: f64,
}

impl Limits {
    /// Weight of the hydrostatic stress in a criterion; `None` where it is negative and the
    /// criterion does not hold: of Dang Van's with a limit in torsion below a half of that in
    /// bending, of Crossland's below 1/√3.
    pub fn weight(&self, criterion: Criterion) -> Option<f64> {
        let ratio = 3.0 * self.torsion / self.bending;
        let weight = match criterion {
            Criterion::DangVan => ratio - 1.5,
            Criterion::Crossland => ratio - 3f64.sqrt(),
            Criterion::OrthogonalShear => 0.0,
        };
        // The ratio of von Mises is 1/√3 but for rounding.
        (weight >= -ROUNDING).then_some(weight.max(0.0))
    }
}

/// A weight that is zero.
const ROUNDING: f64 = 1e-9;

/// Fatigue limits of a body, which may vary over its depth as its hardness does.
#[derive(Debug, Clone, PartialEq)]
pub struct FatigueStrength {
    limits: Limits,
    over_depth: Option<StrengthProfile>,
}

impl FatigueStrength {
    /// Limits that are the same at all depths.
    pub const fn new(limits: Limits) -> Self {
        Self { limits, over_depth: None }
    }

    /// Limits that are multiplied by factors over depth.
    pub const fn over_depth(limits: Limits, factors: StrengthProfile) -> Self {
        Self { limits, over_depth: Some(factors) }
    }

    /// Limits of steel from its Vickers hardness at points `[depth, HV]` \[mm, HV\] in order of
    /// depth; `None` without points.
    ///
    /// In bending `f = 1.6 HV` up to [`HARDEST`](Self::HARDEST), which 0.1 HV to either side bound,
    /// and no more beyond: there inclusions decide, and the limit of their size is not known. In
    /// torsion `t = f/√3`, as von Mises has it.
    ///
    /// # Reference
    /// Y. Murakami, *Metal Fatigue: Effects of Small Defects and Nonmetallic Inclusions* (2002).
    pub fn of_hardness(points: &[[f64; 2]]) -> Option<Self> {
        let (first, _) = points.split_first()?;
        let bending = |hardness: f64| OF_HARDNESS * hardness.min(Self::HARDEST);
        let surface = bending(first[1]);
        let limits = Limits { torsion: surface / 3f64.sqrt(), bending: surface };
        let factors =
            points.iter().map(|[depth, hardness]| [*depth, bending(*hardness) / surface]);
        let factors = StrengthProfile::new(factors.collect());
        let varies = factors.range() != (1.0, 1.0);
        Some(Self { limits, over_depth: varies.then_some(factors) })
    }

    /// Hardness up to which the limit in bending follows the hardness \[HV\].
    pub const HARDEST: f64 = 400.0;

    /// Limits where the factor is 1.
    pub const fn limits(&self) -> Limits {
        self.limits
    }

    /// Limit in torsion at a depth \[MPa\].
    pub fn torsion(&self, depth: f64) -> f64 {
        let factor = self.over_depth.as_ref().map_or(1.0, |factors| factors.factor(depth));
        factor * self.limits.torsion
    }
}

/// Limit in bending over Vickers hardness \[MPa\].
const OF_HARDNESS: f64 = 1.6;

/// A closed path of the stress at one point.
#[derive(Debug, Clone, Copy)]
pub struct Cycle<'a> {
    path: &'a [Stress],
    ball: Ball<5>,
}

impl<'a> Cycle<'a> {
    /// The cycle of a path, with the smallest ball round its deviators.
    pub fn of(path: &'a [Stress]) -> Self {
        let deviators: Vec<Isometric> = path.iter().map(isometric).collect();
        Self { path, ball: smallest_ball(&deviators) }
    }

    /// The shear stress that a criterion makes of the path, with the weight of the hydrostatic
    /// stress \[MPa\]; 0 without points.
    pub fn shear(&self, criterion: Criterion, weight: f64) -> f64 {
        match criterion {
            Criterion::DangVan => self.dang_van(weight),
            Criterion::Crossland => self.crossland(weight),
            Criterion::OrthogonalShear => self.orthogonal(),
        }
    }

    fn dang_van(&self, weight: f64) -> f64 {
        let of = |stress: &Stress| {
            let mut beside = isometric(stress);
            for (coordinate, middle) in beside.iter_mut().zip(self.ball.centre) {
                *coordinate -= middle;
            }
            tresca(beside) + weight * hydrostatic(stress)
        };
        self.path.iter().map(of).reduce(f64::max).unwrap_or(0.0)
    }

    fn crossland(&self, weight: f64) -> f64 {
        let most = self.path.iter().map(hydrostatic).reduce(f64::max).unwrap_or(0.0);
        self.ball.radius / 2f64.sqrt() + weight * most
    }

    /// Half the range of the shear stress in planes along the surface, in the direction of travel.
    fn orthogonal(&self) -> f64 {
        let shear = || self.path.iter().map(|stress| stress[4]);
        let range = shear().reduce(f64::max).zip(shear().reduce(f64::min));
        range.map_or(0.0, |(most, least)| 0.5 * (most - least))
    }
}

/// Life over that of a contact whose shear stress is `ratio` times smaller, under the same force:
/// its range over the exponents in use, the smaller one first. `None` of a ratio that is not
/// positive.
pub fn relative_life(ratio: f64) -> Option<[f64; 2]> {
    let lives = LIFE_EXPONENTS.map(|exponent| ratio.powf(-exponent));
    (ratio > 0.0).then(|| [lives[0].min(lives[1]), lives[0].max(lives[1])])
}

/// Exponents c/e in use.
const LIFE_EXPONENTS: [f64; 2] = [9.0, 10.3];

/// A third of the trace.
pub fn hydrostatic([xx, yy, zz, ..]: &Stress) -> f64 {
    (xx + yy + zz) / 3.0
}

/// A deviator in coordinates whose sum of squares is `s:s`.
type Isometric = [f64; 5];

fn isometric(stress @ &[xx, yy, zz, xy, xz, yz]: &Stress) -> Isometric {
    let two = 2f64.sqrt();
    [(xx - yy) / two, 1.5f64.sqrt() * (zz - hydrostatic(stress)), two * xy, two * xz, two * yz]
}

/// Half the difference of the extreme principal stresses.
pub fn largest_shear(stress: &Stress) -> f64 {
    tresca(isometric(stress))
}

/// The largest principal stress.
pub fn largest_principal(stress: &Stress) -> f64 {
    let (size, angle) = lode(isometric(stress));
    hydrostatic(stress) + 2.0 / 3f64.sqrt() * size * angle.cos()
}

fn tresca(deviator: Isometric) -> f64 {
    let (size, angle) = lode(deviator);
    size * (angle + std::f64::consts::FRAC_PI_3).sin()
}

/// `√J2` of a deviator with `J2 = s:s/2`, and Lode's angle θ with `cos 3θ = (√27/2) J3/J2^(3/2)`: its
/// principal values are `2 √(J2/3) cos θ` and `2 √(J2/3) cos(θ ± 120°)`.
fn lode(deviator: Isometric) -> (f64, f64) {
    let [difference, normal, xy, xz, yz] = deviator.map(|coordinate| coordinate / 2f64.sqrt());
    let second: f64 = deviator.iter().map(|coordinate| 0.5 * coordinate * coordinate).sum();
    if second <= 0.0 {
        return (0.0, 0.0);
    }
    let zz = 2.0 / 3f64.sqrt() * normal;
    let (xx, yy) = (difference - 0.5 * zz, -difference - 0.5 * zz);
    let third = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    let cosine = 0.5 * 27f64.sqrt() * third / second.powf(1.5);
    (second.sqrt(), cosine.clamp(-1.0, 1.0).acos() / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytical::{HertzEllipse, HertzLine};

    fn dang_van(path: &[Stress], weight: f64) -> f64 {
        Cycle::of(path).shear(Criterion::DangVan, weight)
    }

    fn crossland(path: &[Stress], weight: f64) -> f64 {
        Cycle::of(path).shear(Criterion::Crossland, weight)
    }

    fn orthogonal_shear(path: &[Stress]) -> f64 {
        Cycle::of(path).shear(Criterion::OrthogonalShear, 0.0)
    }

    #[track_caller]
    fn near(found: f64, expected: f64, tolerance: f64) {
        assert!((found - expected).abs() <= tolerance, "{found} for {expected}");
    }

    /// A path from -1 to 1 times a stress, the middle included.
    fn reversed(stress: Stress) -> [Stress; 3] {
        [-1.0, 0.0, 1.0].map(|factor| stress.map(|value| factor * value))
    }

    #[test]
    fn both_tests_of_a_material_are_at_its_limit() {
        let limits = Limits { torsion: 480.0, bending: 800.0 };
        let weight = |criterion| limits.weight(criterion).unwrap();
        let (a, c) = (weight(Criterion::DangVan), weight(Criterion::Crossland));
        for component in 3..6 {
            let mut torsion = [0.0; 6];
            torsion[component] = limits.torsion;
            near(dang_van(&reversed(torsion), a), limits.torsion, 1e-9);
            near(crossland(&reversed(torsion), c), limits.torsion, 1e-9);
        }
        for component in 0..3 {
            let mut bending = [0.0; 6];
            bending[component] = limits.bending;
            near(dang_van(&reversed(bending), a), limits.torsion, 1e-9);
            near(crossland(&reversed(bending), c), limits.torsion, 1e-9);
        }
        near(orthogonal_shear(&reversed([0.0, 0.0, 0.0, 9.0, 5.0, 7.0])), 5.0, 1e-12);
    }

    #[test]
    fn a_path_that_stands_still_has_no_amplitude() {
        let rest = [[-300.0, 40.0, 5.0, 7.0, -80.0, 20.0]; 4];
        let mean = (-300.0 + 40.0 + 5.0) / 3.0;
        near(dang_van(&rest, 0.3), 0.3 * mean, 1e-9);
        near(crossland(&rest, 0.2), 0.2 * mean, 1e-9);
        near(orthogonal_shear(&rest), 0.0, 1e-12);
        assert!(dang_van(&[], 0.3) == 0.0 && crossland(&[], 0.3) == 0.0);
    }

    /// Half the difference of principal stresses does not change when axes turn.
    #[test]
    fn the_largest_shear_is_that_of_the_principal_stresses() {
        // Principal 5, -1, -4: turned about z by 30°, then about x by 50°.
        let turned = |a: f64, b: f64| {
            let (s, c, v, u) = (a.sin(), a.cos(), b.sin(), b.cos());
            let axes = [[c, s * u, s * v], [-s, c * u, c * v], [0.0, -v, u]];
            let of = |i: usize, j: usize| -> f64 {
                [5.0, -1.0, -4.0]
                    .iter()
                    .zip(axes)
                    .map(|(value, axis)| value * axis[i] * axis[j])
                    .sum()
            };
            [of(0, 0), of(1, 1), of(2, 2), of(0, 1), of(0, 2), of(1, 2)]
        };
        for (a, b) in [(0.0, 0.0), (0.5, 0.0), (0.52, 0.87), (2.0, -1.1)] {
            near(largest_shear(&turned(a, b)), 4.5, 1e-12);
            near(largest_principal(&turned(a, b)), 5.0, 1e-12);
        }
        near(largest_shear(&[100.0, 40.0, 40.0, 0.0, 0.0, 0.0]), 30.0, 1e-6);
        near(largest_shear(&[0.0; 6]), 0.0, 0.0);
        near(largest_principal(&[-5.0, -5.0, -5.0, 0.0, 0.0, 0.0]), -5.0, 1e-12);
    }

    /// Stress in the plane of travel below the middle of a contact of half-width and peak pressure 1,
    /// ν = 0.3: `xx yy zz xz` at x and depth.
    type Field = fn(f64, f64) -> [f64; 4];

    fn line(x: f64, depth: f64) -> [f64; 4] {
        let s = HertzLine::from_peak_pressure(1.0, 1.0, 2.0).stress(x, depth, 0.3);
        [s.sigma_x, s.sigma_z, s.sigma_y, s.tau_xy]
    }

    /// Below a circle. M. T. Huber, Ann. Phys. 14 (1904) 153; K. L. Johnson, *Contact Mechanics*
    /// (1985), section 3.4.
    fn circle(x: f64, z: f64) -> [f64; 4] {
        let (nu, r) = (0.3, x.abs().max(1e-6));
        let b = r * r + z * z - 1.0;
        let u = 0.5 * (b + b.hypot(2.0 * z));
        let (root, ratio) = (u.sqrt(), z / u.sqrt());
        let angle = (1.0 + nu) * root * root.recip().atan();
        let side = (1.0 - 2.0 * nu) / 3.0 / (r * r) * (1.0 - ratio.powi(3));
        let common = ratio.powi(3) * u / (u * u + z * z);
        let radial = side + common + ratio * ((1.0 - nu) * u / (1.0 + u) + angle - 2.0);
        let hoop = -side - ratio * (2.0 * nu + u * (1.0 - nu) / (1.0 + u) - angle);
        let shear = -r * z * z / (u * u + z * z) * root / (1.0 + u);
        [radial, hoop, -common, shear.copysign(-x)]
    }

    /// The largest of a criterion over depth.
    fn largest(of: Field, initial: f64, criterion: impl Fn(&[Stress]) -> f64) -> f64 {
        let far = [30.0, 14.0, 8.0, 5.0, 3.5].into_iter().flat_map(|x| [-x, x]);
        let places: Vec<f64> = far.chain((-250..=250).map(|k| f64::from(k) / 100.0)).collect();
        let at = |depth: f64| -> Vec<Stress> {
            let stress = |x: &f64| {
                let [xx, yy, zz, xz] = of(*x, depth);
                [xx + initial, yy + initial, zz, 0.0, xz, 0.0]
            };
            places.iter().map(stress).collect()
        };
        (1..50).map(|k| criterion(&at(0.02 * f64::from(k)))).fold(0.0, f64::max)
    }

    /// Lundberg and Palmgren's shear, and the radius of the ball where it is largest.
    #[test]
    fn orthogonal_shear_is_that_of_hertz() {
        near(largest(line, 0.0, orthogonal_shear), 0.25, 3e-4);
        near(largest(line, 0.0, |path| crossland(path, 0.0)), 0.25, 3e-4);
        let of_circle = HertzEllipse { axis_ratio: 1.0 }.largest_orthogonal_shear().0;
        near(largest(circle, 0.0, orthogonal_shear), of_circle, 3e-4);
        near(largest(circle, 0.0, |path| crossland(path, 0.0)), of_circle, 3e-4);
    }

    /// Figures of a program of its own, which finds the ball by another iteration, to ±0.0003.
    #[test]
    fn dang_van_of_rolling_contacts() {
        let of = |field, weight| largest(field, 0.0, |path: &[Stress]| dang_van(path, weight));
        for (weight, of_line, of_circle) in
            [(0.15, 0.2066, 0.1824), (0.25, 0.1818, 0.1660), (0.33, 0.1641, 0.1573)]
        {
            near(of(line, weight), of_line, 4e-4);
            near(of(circle, weight), of_circle, 4e-4);
        }
    }

    /// An equal stress along the surface leaves amplitudes and takes a·2/3 of itself.
    #[test]
    fn a_stress_along_the_surface_shifts_dang_van() {
        let of = |initial| largest(line, initial, |path: &[Stress]| dang_van(path, 0.25));
        near(of(-0.1) - of(0.0), -0.25 * 2.0 / 3.0 * 0.1, 1e-9);
        near(of(0.1) - of(0.0), 0.25 * 2.0 / 3.0 * 0.1, 1e-9);
    }

    #[test]
    fn closed_paths_scale_with_the_pressure() {
        let path: Vec<Stress> = (0..40)
            .map(|k| {
                let [xx, yy, zz, xz] = line(0.1 * f64::from(k) - 2.0, 0.6);
                [xx, yy, zz, 0.0, xz, 0.0]
            })
            .collect();
        let twice: Vec<Stress> = path.iter().map(|s| s.map(|value| 2.0 * value)).collect();
        near(dang_van(&twice, 0.25), 2.0 * dang_van(&path, 0.25), 1e-12);
        near(crossland(&twice, 0.25), 2.0 * crossland(&path, 0.25), 1e-12);
    }

    /// A stress that stands still adds its hydrostatic part alone, whatever its deviator.
    #[test]
    fn a_stress_at_rest_adds_its_hydrostatic_part() {
        let path: Vec<Stress> = (0..60)
            .map(|k| {
                let [xx, yy, zz, xz] = line(0.1 * f64::from(k) - 3.0, 0.4);
                [xx, yy, zz, 0.0, xz, 0.0]
            })
            .collect();
        let rest = [-0.3, 0.1, 0.02, 0.05, -0.07, 0.11];
        let moved: Vec<Stress> =
            path.iter().map(|stress| std::array::from_fn(|k| stress[k] + rest[k])).collect();
        for (criterion, weight) in [
            (Criterion::DangVan, 0.25),
            (Criterion::Crossland, 0.2),
            (Criterion::OrthogonalShear, 0.0),
        ] {
            let [before, after] =
                [&path, &moved].map(|path| Cycle::of(path).shear(criterion, weight));
            near(after - before, weight * hydrostatic(&rest), 1e-9);
        }
    }

    #[test]
    fn criteria_hold_for_limits_of_metals() {
        let of = |torsion| Limits { torsion, bending: 100.0 };
        assert!(of(49.0).weight(Criterion::DangVan).is_none());
        assert!(of(57.0).weight(Criterion::Crossland).is_none());
        near(of(50.0).weight(Criterion::DangVan).unwrap(), 0.0, 1e-12);
        near(of(100.0 / 3f64.sqrt()).weight(Criterion::Crossland).unwrap(), 0.0, 1e-12);
        near(of(60.0).weight(Criterion::DangVan).unwrap(), 0.3, 1e-12);
    }

    /// The limits of a case of 720 over a core of 300 HV, and of a steel of one hardness.
    #[test]
    fn limits_follow_the_hardness_up_to_where_inclusions_decide() {
        let case =
            FatigueStrength::of_hardness(&[[0.0, 720.0], [1.0, 400.0], [2.0, 300.0]]).unwrap();
        near(case.limits().bending, 640.0, 1e-9);
        let over_core = [0.0, 0.5, 1.0, 1.5, 2.0, 9.0].map(|z| 3f64.sqrt() * case.torsion(z));
        for (found, expected) in
            over_core.into_iter().zip([640.0, 640.0, 640.0, 560.0, 480.0, 480.0])
        {
            near(found, expected, 1e-9);
        }
        let even = FatigueStrength::of_hardness(&[[0.0, 250.0]]).unwrap();
        assert_eq!(even, FatigueStrength::new(even.limits()));
        near(even.torsion(3.0), 400.0 / 3f64.sqrt(), 1e-9);
        assert!(FatigueStrength::of_hardness(&[]).is_none());
        // Bearing steel: the limit of ISO 281, Hertz's 1500 MPa, is √J2a = 375 MPa of a line.
        near(case.torsion(0.0), 375.0, 6.0);
    }

    #[test]
    fn life_is_a_power_of_the_shear_stress() {
        let [short, long] = relative_life(0.9).unwrap();
        near(short, 2.581, 1e-3);
        near(long, 2.960, 1e-3);
        assert!(relative_life(0.0).is_none() && relative_life(f64::NAN).is_none());
        assert!(relative_life(1.1).unwrap()[0] < relative_life(1.1).unwrap()[1]);
    }
}
