//! The input of a contact in three dimensions.

use std::f64::consts::PI;

use crate::{EllipticContact, SurfaceGrid};

use super::conformity::Conformity;
use super::error::HalfSpaceError;
use super::gap::{HeightMap, RollerGap};
use super::moment::PrescribedMoment;
use brinell_contact::ContactLoad;
use brinell_material::analytical::ElasticConstants;
use brinell_material::{HardeningLaw, Solid};
use brinell_method::settings::Settings;
use brinell_method::sought::Loads;

/// Cells along a roller over those across it, at most.
pub(super) const MOST_CELLS_ALONG: f64 = 8.0;
/// Relative difference of the curvatures below which the contact is circular and has no principal
/// direction.
const CIRCLE: f64 = 1e-12;
/// Ratio of axial to transverse curvature below which a roller is straight.
const LINE: f64 = 1e-9;
/// Ratio of peak pressure to yield stress at which a ball begins to yield, for Poisson's ratio
/// 0.3. Other contacts begin to yield later.
const ONSET: f64 = 1.6;
/// Bounds of a sought force \[N\], and number of bisections.
const FORCES: [f64; 2] = [1e-12, 1e12];
pub(super) const BISECTIONS: u32 = 60;
/// Mean pressure of a fully plastic contact over the flow stress, and strain of the flow stress
/// over half-width times curvature.
///
/// # Reference
/// D. Tabor, *The Hardness of Metals* (1951).
const CONSTRAINT: f64 = 3.0;
const INDENTATION_STRAIN: f64 = 0.2;
/// Largest overload that is solved. A perfectly plastic ball of steel reaches strains of 13 % at
/// 30.
const MOST_OVERLOAD: f64 = 40.0;

/// Two bodies, the curvature of the gap between them, and the loads.
#[derive(Debug, Clone)]
pub struct HalfSpaceProblem {
    /// Upper and lower body; `None` for a rigid body. At least one body deforms.
    ///
    /// Of an initial stress, `sigma_x` acts along the given x, and `sigma_z` along the given y.
    pub materials: [Option<Solid>; 2],
    /// `[k_xx, k_yy, k_xy]` of the gap `(k_xx x² + k_yy y²)/2 + k_xy x y`, the sum over both
    /// surfaces \[1/mm\]; positive definite, or zero along the axis of a straight roller.
    pub curvature: [f64; 3],
    /// Inclination of the common normals of bodies that conform.
    pub conformity: Conformity,
    /// The ends, relief and tilt of the bodies that are rollers.
    pub rollers: Vec<RollerGap>,
    /// Heights on top of the shapes. With heights, the contact is solved on their grid, in the
    /// axes of the job.
    pub heights: Option<HeightMap>,
    /// Loads \[N, mm\].
    pub loads: Loads,
    /// Cells over each semi-axis of the contact.
    pub cells_per_semi_axis: u32,
    /// Cells of the small grids that tell the contact stiffness, where it is asked for.
    pub cells_of_slopes: Option<u32>,
    /// Force at the onset of yield, where it has a closed form \[N\].
    pub onset: Option<f64>,
    /// Theory, coupling, tolerance, increments and iteration limit.
    pub solver: Settings,
}

impl HalfSpaceProblem {
    /// Returns the largest and smallest curvature of the gap \[1/mm\], along x and y of the
    /// fields.
    pub fn principal_curvatures(&self) -> [f64; 2] {
        let [xx, yy, xy] = self.curvature;
        let (mean, radius) = (0.5 * (xx + yy), f64::hypot(0.5 * (xx - yy), xy));
        // The smaller one from the determinant: the difference would cancel.
        [mean + radius, (xx * yy - xy * xy) / (mean + radius)]
    }

    /// Returns the angle from the job's x to the x of the fields, towards the job's y \[rad\], in
    /// `(-π/2, π/2]`; 0 for a circular contact.
    pub fn orientation(&self) -> f64 {
        let [xx, yy, xy] = self.curvature;
        if self.heights.is_some() || f64::hypot(0.5 * (xx - yy), xy) <= CIRCLE * (xx + yy) {
            return 0.0;
        }
        0.5 * (2.0 * xy).atan2(xx - yy)
    }

    /// Returns the contact modulus E\* \[MPa\], `1/E* = Σ (1 - ν²)/E` over the bodies that deform.
    pub fn effective_modulus(&self) -> f64 {
        1.0 / self.materials.iter().flatten().map(plane_compliance).sum::<f64>()
    }

    /// Whether at least one body has a hardening curve.
    pub(super) fn can_yield(&self) -> bool {
        self.materials.iter().flatten().any(Solid::can_yield)
    }

    /// Returns the lowest nominal yield stress over the depth of both bodies \[MPa\].
    pub(super) fn weakest(&self) -> Option<f64> {
        self.least_stress(HardeningLaw::nominal_yield_stress)
    }

    /// Returns the least value of a stress of the hardening curves over the depth of both bodies
    /// \[MPa\].
    fn least_stress(&self, of: impl Fn(&dyn HardeningLaw) -> f64) -> Option<f64> {
        let least = |material: &Solid| {
            let factor = material.strength().map_or(1.0, |strength| strength.range().0);
            material.hardening_law().map(|law| factor * of(&**law))
        };
        self.materials.iter().flatten().filter_map(least).reduce(f64::min)
    }

    /// Returns estimates of semi-axes and overload; `None` if the bodies do not touch.
    ///
    /// The semi-axes are the larger of the elastic ones and `√(P/3πσ)`: a fully plastic contact
    /// has a mean pressure of 3σ. At a given approach, the surface around a fully plastic contact
    /// neither sinks nor rises, and its area is twice the area between elastic bodies.
    pub(super) fn expected(&self, load: ContactLoad) -> Option<Expected> {
        if let Some(map) = &self.heights {
            return Some(Expected::of_heights(map));
        }
        let elastic = self.elastic_contact(load)?;
        let (a, b, peak) = self.tilted(&elastic, load);
        let is_line = self.half_length().is_some_and(|half_length| b >= half_length);
        let most = match load {
            ContactLoad::Force(_) => f64::INFINITY,
            ContactLoad::Approach(_) => 2.0,
        };
        // P = 2/3 p0 π a b; for a line contact, P = π/4 p0 2a 2b.
        let mean = if is_line { 0.25 * PI } else { 2.0 / 3.0 };
        let area_ratio = |stress: f64| mean * peak / (CONSTRAINT * stress);
        let growth = |area: f64| if is_line { area } else { area.sqrt() };
        let strain =
            |area: f64| INDENTATION_STRAIN * a * growth(area) * self.principal_curvatures()[0];
        let mut area: f64 = 1.0;
        for _ in 0..2 {
            let flow =
                self.least_stress(|law| law.stress(strain(area)).max(law.nominal_yield_stress()));
            area = flow.map_or(1.0, area_ratio).clamp(1.0, most);
        }
        let of_yield = self.weakest().map_or(0.0, |weakest| peak / weakest);
        let flow =
            self.least_stress(|law| law.stress(strain(area)).max(law.nominal_yield_stress()));
        let share = self.weakest().map_or(1.0, |weakest| (most / area_ratio(weakest)).min(1.0));
        Some(Expected {
            semi_axes: [growth(area) * a, if is_line { b } else { growth(area) * b }],
            half_length: self.half_length(),
            is_line,
            patch: None,
            overload: share.cbrt() * of_yield,
            over_flow: share.cbrt() * flow.map_or(0.0, |flow| peak / flow),
        })
    }

    /// Returns a force below which no body yields \[N\].
    pub(super) fn yield_force(&self) -> Option<f64> {
        let weakest = self.weakest().filter(|_| self.heights.is_none())?;
        Some(self.force_where(|hertz| hertz.peak_pressure, ONSET * weakest, 3.0))
    }

    /// Returns the number of cells over each semi-axis.
    pub(super) fn cells(&self) -> f64 {
        f64::from(self.cells_per_semi_axis)
    }

    /// Returns the contact of elastic bodies under a force above zero \[N\]: Hertz's ellipse, or,
    /// if the ellipse is longer than a roller, the line contact of the roller's length under an
    /// even line load. Profiles other than arcs are left out.
    pub fn hertz(&self, force: f64) -> EllipticContact {
        let [kx, ky] = self.principal_curvatures();
        let ellipse =
            || EllipticContact::new(kx.recip(), ky.recip(), self.effective_modulus(), force);
        let Some(half_length) = self.half_length() else { return ellipse() };
        let ellipse = (ky > LINE * kx).then(ellipse);
        ellipse.filter(|found| found.semi_axis_y < half_length).unwrap_or_else(|| {
            line_contact(kx.recip(), 2.0 * half_length, self.effective_modulus(), force)
        })
    }

    /// Whether the shapes have a Hertzian contact, apart from any heights on top of them.
    pub fn has_hertz(&self) -> bool {
        let [kx, ky] = self.principal_curvatures();
        kx > 0.0 && (ky > LINE * kx || self.half_length().is_some())
    }

    /// Whether the contact reaches both ends of a roller.
    pub fn is_line(&self, contact: &EllipticContact) -> bool {
        self.half_length().is_some_and(|half_length| contact.semi_axis_y >= half_length)
    }

    /// Returns the semi-axes along x and y and the peak pressure of a contact whose rollers tilt.
    /// Each length of a roller acts as a spring, so that the line load is linear along the axis
    /// and largest at an end; under a moment beyond P L/6 it falls to zero before the other end.
    /// The ellipse of an arc moves along the axis.
    fn tilted(&self, even: &EllipticContact, load: ContactLoad) -> (f64, f64, f64) {
        let EllipticContact { semi_axis_x: a, semi_axis_y: b, peak_pressure, approach } = *even;
        let Some(half_length) = self.half_length() else {
            return (a, b, peak_pressure);
        };
        // Position of the force over half the length.
        let beside = self.moment().map(|moment| moment.missing(0.0, load.magnitude()).abs());
        let tilt = self.tilt().abs();
        if !self.is_line(even) {
            let off = beside.map_or_else(
                || tilt / self.principal_curvatures()[1],
                |beside| beside * half_length,
            );
            return (a, (b + off).min(half_length), peak_pressure);
        }
        // Line load at the end over the mean line load.
        let most = match beside {
            Some(beside) if beside < 1.0 / 3.0 => 1.0 + 3.0 * beside,
            Some(beside) => 4.0 / (3.0 * (1.0 - beside)),
            None => {
                let uneven = tilt * half_length / approach;
                if uneven < 1.0 { 1.0 + uneven } else { 2.0 * uneven.sqrt() }
            }
        };
        (most.sqrt() * a, b, most.sqrt() * peak_pressure)
    }

    /// Returns the force under which a figure of [`Self::hertz`] has a value. Without rollers, the
    /// figure is proportional to the force to the power of 1/`exponent`.
    pub fn force_where(
        &self,
        figure: impl Fn(&EllipticContact) -> f64,
        value: f64,
        exponent: f64,
    ) -> f64 {
        let by_ellipse = (value / figure(&self.hertz(1.0))).max(0.0).powf(exponent);
        if self.half_length().is_none() || value <= 0.0 {
            return by_ellipse;
        }
        let (mut low, mut high) = (FORCES[0].ln(), FORCES[1].ln());
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if figure(&self.hertz(middle.exp())) < value { low = middle } else { high = middle }
        }
        high.exp()
    }

    /// Returns the contact of elastic bodies under a load; `None` if they do not touch.
    pub fn elastic_contact(&self, load: ContactLoad) -> Option<EllipticContact> {
        let force = match load {
            ContactLoad::Force(force) => force,
            ContactLoad::Approach(approach) => {
                self.force_where(|hertz| hertz.approach, approach, 1.5)
            }
        };
        (force > 0.0).then(|| self.hertz(force))
    }

    /// Returns the gap along the common normals at the middles of cells, x and y in the axes of
    /// the fields \[mm\].
    pub fn gap(&self, grid: &SurfaceGrid) -> Vec<f64> {
        if let Some(map) = &self.heights {
            return self.rough_gap(map, grid);
        }
        let [kx, ky] = self.principal_curvatures();
        let (sine, cosine) = self.orientation().sin_cos();
        grid.sample(|x, y| {
            let place = [cosine * x - sine * y, sine * x + cosine * y];
            let falls = self.rollers.iter().map(|roller| roller.fall(place)).sum::<f64>();
            0.5 * (kx * x * x + ky * y * y) * self.conformity.of_parabola([x, y]) + falls
        })
    }

    /// Returns the gap with heights on top of the shapes, less its minimum.
    fn rough_gap(&self, map: &HeightMap, grid: &SurfaceGrid) -> Vec<f64> {
        let [xx, yy, xy] = self.curvature;
        let mut gap = grid.sample(|x, y| 0.5 * (xx * x * x + yy * y * y) + xy * x * y);
        for (gap, height) in gap.iter_mut().zip(map.over(grid)) {
            *gap -= height;
        }
        let least = gap.iter().copied().fold(f64::INFINITY, f64::min);
        gap.iter().map(|gap| gap - least).collect()
    }

    /// Returns half the largest contact length along y of the fields that the rollers allow
    /// \[mm\]; `None` without a roller.
    pub fn half_length(&self) -> Option<f64> {
        self.rollers.iter().map(|roller| 0.5 * roller.length).reduce(f64::min)
    }

    /// Returns the slope by which the gap falls along y of the fields, from the given tilts.
    pub(super) fn tilt(&self) -> f64 {
        let orientation = self.orientation();
        self.rollers.iter().map(|roller| roller.tilt * (roller.rotation - orientation).cos()).sum()
    }

    /// The moment under which a roller tilts; `None` where tilts are given.
    pub(super) fn moment(&self) -> Option<PrescribedMoment> {
        let orientation = self.orientation();
        let along = self.rollers.iter().find_map(|roller| {
            Some(roller.moment? * (roller.rotation - orientation).cos().signum())
        });
        Some(PrescribedMoment {
            moment: along?,
            whole_from: self.loads.least_force()?,
            half_length: self.half_length()?,
        })
    }
}

/// Returns the contact of a cylinder of radius `radius` \[mm\] along `length` with a half-space,
/// under an even line load w = P/L:
/// ```text
/// a² = 4wR/(πE*),   p0 = 2w/(πa),   α = 2w/(πE*) (ln(2L/a) + 1/2)
/// ```
/// α is the displacement in the middle under the pressure of Hertz's line contact over this
/// length, to order a²/L².
///
/// # Reference
/// K. L. Johnson, *Contact Mechanics* (1985), section 4.2(c); α by integration of Boussinesq's
/// displacement.
fn line_contact(radius: f64, length: f64, modulus: f64, force: f64) -> EllipticContact {
    let line_load = force / length;
    let half_width = (4.0 * line_load * radius / (PI * modulus)).sqrt();
    EllipticContact {
        peak_pressure: 2.0 * line_load / (PI * half_width),
        semi_axis_x: half_width,
        semi_axis_y: 0.5 * length,
        approach: 2.0 * line_load / (PI * modulus)
            * ((2.0 * length / half_width).ln().max(0.0) + 0.5),
    }
}

/// Estimated size and overload of a contact before the solve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Expected {
    /// Semi-axes along x and y \[mm\].
    pub semi_axes: [f64; 2],
    /// Half the length of a roller along y \[mm\], and whether the contact is expected to reach
    /// both ends.
    pub half_length: Option<f64>,
    pub is_line: bool,
    /// Numbers of cells of the heights on top of the shapes.
    pub patch: Option<[usize; 2]>,
    /// Peak pressure of elastic bodies under the same force over the lowest yield stress; 0 for
    /// elastic bodies.
    pub overload: f64,
    /// Peak pressure of elastic bodies under the same force over the flow stress of the material.
    pub over_flow: f64,
}

impl Expected {
    /// The contact of a patch of heights, estimated as the whole patch.
    fn of_heights(map: &HeightMap) -> Self {
        let (semi_axes, patch) = (map.half_sides(), Some(map.cells));
        Self { semi_axes, patch, half_length: None, is_line: false, overload: 0.0, over_flow: 0.0 }
    }

    /// Refuses loads beyond small strains, and rollers too short for a grid.
    ///
    /// # Errors
    /// [`HalfSpaceError::Overloaded`], [`HalfSpaceError::ShortRoller`].
    pub fn bearable(self) -> Result<Self, HalfSpaceError> {
        let half_width = self.semi_axes[0];
        if let Some(half_length) = self.half_length
            && MOST_CELLS_ALONG * half_length < half_width
        {
            let (length, least) = (2.0 * half_length, 2.0 * half_width / MOST_CELLS_ALONG);
            return Err(HalfSpaceError::ShortRoller { length, least });
        }
        let (overload, most) = (self.over_flow, MOST_OVERLOAD);
        if overload > most { Err(HalfSpaceError::Overloaded { overload, most }) } else { Ok(self) }
    }
}

/// Returns `(1 - ν²)/E` \[1/MPa\].
pub(super) fn plane_compliance(material: &Solid) -> f64 {
    let ElasticConstants { young_modulus, poisson_ratio } = material.elastic();
    (1.0 - poisson_ratio * poisson_ratio) / young_modulus
}
