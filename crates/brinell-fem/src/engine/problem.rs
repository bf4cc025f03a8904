//! The mechanical problem: two outlines with materials and supports.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::assembly::{MaterialModel, Support, out_of_plane};
use crate::element::StressState;
use crate::engine::conforming::ConformingPair;
use crate::engine::mesh_sizing::first_contact::smallest_gap;
use crate::mesh::{ContactZone, Corner, Outline};
use brinell_material::analytical::{effective_modulus, effective_modulus_plane_stress};
use brinell_material::{
    BackstressTerm, ConstitutiveModel, DeformationPlasticity, DepthStrength, FlowPlasticity,
    HardeningLaw, Inhomogeneous, InitialStressProfile, OutOfPlane, ReturnMapping, Solid,
};

/// Two bodies whose surfaces first touch where their gap is smallest.
#[derive(Clone)]
pub struct Problem {
    /// The third direction.
    pub stress_state: StressState,
    /// Upper and lower body.
    pub bodies: [ProblemBody; 2],
    /// Whether an existing symmetry is used.
    pub use_symmetry: bool,
    /// Abscissa of the smallest gap \[mm\].
    pub first_contact_x: f64,
    /// The smallest gap as the outlines are given \[mm\]; gaps are counted from it.
    pub smallest_gap: f64,
    /// Knots, the abscissae where the gap may not be smooth \[mm\], ascending.
    knots: Vec<f64>,
    /// Corners of both surfaces, ascending.
    corners: Vec<Corner>,
    /// A pin and its hole, whose abscissae are arc lengths.
    pub conforming: Option<ConformingPair>,
}

/// A body as it is given.
pub struct GivenBody {
    /// Its section.
    pub outline: Outline,
    /// `None` for a rigid body.
    pub material: Option<Solid>,
    /// Support.
    pub support: Support,
    /// Whether it is a profile of which nothing says how it runs between its points.
    pub interpolation_is_open: bool,
}

/// A body with its constitutive model.
#[derive(Clone)]
pub struct ProblemBody {
    /// Its section.
    pub outline: Outline,
    /// `None` for a rigid body.
    pub material: Option<Solid>,
    /// Its constitutive model.
    pub model: Option<Arc<dyn MaterialModel>>,
    /// Its stress before any load.
    pub initial_stress: Option<Arc<GivenStress>>,
    /// Support.
    pub support: Support,
    /// Whether it is a profile of which nothing says how it runs between its points.
    interpolation_is_open: bool,
}

/// Stress over the depth of a body before any load, as it is given.
#[derive(Debug)]
pub struct GivenStress {
    profile: InitialStressProfile,
    outline: Outline,
}

impl GivenStress {
    fn of(material: &Solid, outline: &Outline) -> Option<Arc<Self>> {
        let profile = material.initial_stress();
        let given = || Self { profile: profile.clone(), outline: outline.clone() };
        (!profile.is_empty()).then(|| Arc::new(given()))
    }

    /// `[σ_xx, σ_yy, σ_zz, τ_xy]` at a place \[MPa\].
    pub fn at(&self, position: [f64; 2]) -> [f64; 4] {
        self.below(self.outline.foot(position))
    }

    /// Returns `[σ_xx, σ_yy, σ_zz, τ_xy]` \[MPa\] at a depth \[mm\] below the place of a surface
    /// where it has this normal.
    pub fn below(&self, (depth, [n_x, n_y]): (f64, [f64; 2])) -> [f64; 4] {
        let [along, across] = self.profile.at(depth);
        [along * n_y * n_y, along * n_x * n_x, across, -along * n_x * n_y]
    }

    /// Depths between which it varies evenly \[mm\].
    pub fn depths(&self) -> impl Iterator<Item = f64> {
        self.profile.depths()
    }

    /// Whether it is in equilibrium as it is.
    pub fn is_in_equilibrium(&self) -> bool {
        self.outline.is_flat()
    }
}

/// Makes the constitutive model of a material in a body of this outline.
pub type ModelOf = fn(&Solid, &Outline, OutOfPlane) -> Arc<dyn MaterialModel>;

/// The paper's theory of plasticity.
pub(crate) fn deformation_theory(
    material: &Solid,
    outline: &Outline,
    out_of_plane: OutOfPlane,
) -> Arc<dyn MaterialModel> {
    let elastic = material.moduli();
    in_body(material, outline, |law| DeformationPlasticity::with_law(elastic, law, out_of_plane))
}

/// Flow theory, which follows a history of loads.
pub(crate) fn flow_theory(
    material: &Solid,
    outline: &Outline,
    out_of_plane: OutOfPlane,
) -> Arc<dyn MaterialModel> {
    // As many terms as there are, because every point keeps one tensor for each.
    match *material.backstress() {
        [] => flow_theory_with(material, outline, out_of_plane, []),
        [a] => flow_theory_with(material, outline, out_of_plane, [a]),
        [a, b] => flow_theory_with(material, outline, out_of_plane, [a, b]),
        [a, b, c] => flow_theory_with(material, outline, out_of_plane, [a, b, c]),
        [a, b, c, d, ..] => flow_theory_with(material, outline, out_of_plane, [a, b, c, d]),
    }
}

fn flow_theory_with<const N: usize>(
    material: &Solid,
    outline: &Outline,
    out_of_plane: OutOfPlane,
    terms: [BackstressTerm; N],
) -> Arc<dyn MaterialModel> {
    let Some(law) = material.hardening_law().cloned() else {
        return deformation_theory(material, outline, out_of_plane);
    };
    let elastic = material.moduli();
    in_body(material, outline, |scaled| {
        let law = scaled.unwrap_or_else(|| Arc::clone(&law));
        FlowPlasticity::new(elastic, ReturnMapping::new(law, elastic.shear), terms, out_of_plane)
    })
}

/// A model of the hardening law of a material; of its scaled laws where strength varies over
/// depth, and from its stress before any load.
fn in_body<M: ConstitutiveModel>(
    material: &Solid,
    outline: &Outline,
    model: impl Fn(Option<Arc<dyn HardeningLaw>>) -> M,
) -> Arc<dyn MaterialModel> {
    let law = material.hardening_law().cloned();
    let strength = material.strength().cloned();
    let strength = strength.map(|profile| DepthStrength::new(profile, outline.clone()));
    if strength.is_none() && material.initial_stress().is_empty() {
        return Arc::new(model(law));
    }
    Arc::new(Inhomogeneous::new(law, strength, model))
}

/// Part of the half-width in which a corner counts: one near the end of the contact ends it,
/// rounded or not.
const INNER_PART: f64 = 0.95;
/// Rounding of a corner that makes a difference, as a part of the gap at the ends of the contact.
const ROUNDING_SHARE: f64 = 0.05;
/// Places that differ by less, relative to the distance from the origin, are the same.
const SAME_PLACE: f64 = 1e-9;
/// Steps of the integral for the force of an elastic contact.
const FORCE_STEPS: u32 = 48;
/// Steps of the integral for the pressure in the middle of one.
const PRESSURE_STEPS: u32 = 400;

impl Problem {
    /// Two bodies by deformation theory, the upper one first.
    pub fn new(stress_state: StressState, bodies: [GivenBody; 2]) -> Self {
        let conforming = ConformingPair::of(bodies.each_ref().map(|body| &body.outline));
        let out_of_plane = out_of_plane(stress_state);
        let mut problem = Self {
            stress_state,
            bodies: bodies.map(|body| ProblemBody::of(body, out_of_plane)),
            use_symmetry: true,
            first_contact_x: 0.0,
            smallest_gap: 0.0,
            knots: Vec::new(),
            corners: Vec::new(),
            conforming,
        };
        let (left, right) = problem.span();
        let mut knots: Vec<f64> =
            problem.bodies.iter().flat_map(|body| body.outline.knots()).collect();
        knots.retain(|x| (left..=right).contains(x));
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        problem.knots = knots;
        problem.corners = problem.bodies.iter().flat_map(|body| body.outline.corners()).collect();
        problem.corners.sort_by(|a, b| a.x.total_cmp(&b.x));
        problem.find_smallest_gap();
        problem
    }

    /// Returns the same bodies with other constitutive models of their materials.
    #[must_use]
    pub fn with_models(&self, model: ModelOf) -> Self {
        let out_of_plane = out_of_plane(self.stress_state);
        let with_model = |body: &ProblemBody| ProblemBody {
            model: model_of(model, body.material.as_ref(), &body.outline, out_of_plane),
            ..body.clone()
        };
        Self { bodies: self.bodies.each_ref().map(with_model), ..self.clone() }
    }

    /// Returns the same bodies, of which a symmetry is not used.
    #[must_use]
    pub fn as_whole(&self) -> Self {
        Self { use_symmetry: false, ..self.clone() }
    }

    /// Returns the same bodies without their hardening curves.
    #[must_use]
    pub fn without_plasticity(&self) -> Self {
        let elastic = |body: &ProblemBody| ProblemBody {
            material: body.material.as_ref().map(Solid::without_plasticity),
            ..body.clone()
        };
        Self { bodies: self.bodies.each_ref().map(elastic), ..self.clone() }
            .with_models(deformation_theory)
    }

    /// Force over the area of a contact of this half-width \[MPa\].
    pub fn mean_pressure(&self, force: f64, half_width: f64) -> f64 {
        let half_width = self.conforming.map_or(half_width, |pair| pair.half_chord(half_width));
        match self.stress_state {
            StressState::PlaneStrain | StressState::PlaneStress => force / (2.0 * half_width),
            StressState::Axisymmetric => force / (PI * half_width * half_width),
        }
    }

    /// Looks for the smallest gap.
    fn find_smallest_gap(&mut self) {
        if self.has_arcs() {
            return;
        }
        let (left, right) = self.span();
        let left = if self.stress_state == StressState::Axisymmetric { 0.0 } else { left };
        (self.first_contact_x, self.smallest_gap) =
            smallest_gap(|x| self.initial_gap(x), left, right, &self.knots);
    }

    /// The knots within `[left, right]`.
    pub fn knots_within(&self, left: f64, right: f64) -> &[f64] {
        let first = self.knots.partition_point(|x| *x < left);
        let end = self.knots.partition_point(|x| *x <= right);
        self.knots.get(first..end).unwrap_or(&[])
    }

    /// The nearest edges beside a place, beyond which no contact around it reaches \[mm\];
    /// infinite where there is none.
    pub fn edges_around(&self, centre: f64) -> [f64; 2] {
        let [mut left, mut right] = self.walls();
        for corner in &self.corners {
            if corner.edge() < 0.0 && corner.x < centre {
                left = left.max(corner.x);
            } else if corner.edge() > 0.0 && corner.x > centre {
                right = right.min(corner.x);
            }
        }
        [left, right]
    }

    /// The side walls of a punch, beyond which there is no contact \[mm\]; infinite without one.
    pub fn walls(&self) -> [f64; 2] {
        let walls = self.bodies.iter().filter_map(|body| body.outline.wall());
        let nearest = walls.fold(f64::INFINITY, f64::min);
        [-nearest, nearest]
    }

    /// The smallest radius of the edges of a punch \[mm\]; infinite where none is rounded.
    pub fn edge_radius(&self) -> f64 {
        let radii = self.bodies.iter().filter_map(|body| body.outline.edge_radius());
        radii.fold(f64::INFINITY, f64::min)
    }

    /// Half of the width of the narrowest arc that rounds off a tip \[mm\]; infinite where there
    /// is none.
    pub fn tip_arc(&self) -> f64 {
        self.bodies.iter().filter_map(|body| body.outline.tip_arc()).fold(f64::INFINITY, f64::min)
    }

    /// The least exponent below 2 of a power, whose curvature is infinite at the tip.
    pub fn pointed_exponent(&self) -> Option<f64> {
        self.bodies.iter().filter_map(|body| body.outline.pointed_exponent()).reduce(f64::min)
    }

    /// Whether a knot lies on a rounded edge of a punch, or is one of the arc of a tip.
    pub fn is_rounded_off(&self, x: f64) -> bool {
        let is_on = |outline: &Outline| {
            let edge = outline.edge_radius().zip(outline.wall());
            edge.is_some_and(|(radius, wall)| (wall - radius..=wall).contains(&x.abs()))
                || outline.tip_arc().is_some() && outline.knots().contains(&x)
        };
        self.bodies.iter().any(|body| is_on(&body.outline))
    }

    /// Whether one of the surfaces has a corner at this knot.
    pub fn is_corner(&self, x: f64) -> bool {
        self.corners.binary_search_by(|corner| corner.x.total_cmp(&x)).is_ok()
    }

    /// A zone of about so many even columns, with a node at each corner and at each edge whose
    /// radius is smaller than a column.
    pub fn zone(&self, x_min: f64, x_max: f64, columns: usize, symmetric: bool) -> ContactZone {
        let spacing = (x_max - x_min) / columns as f64;
        let rounded =
            self.bodies.iter().flat_map(|body| body.outline.edges_rounded_below(spacing));
        let mut corners: Vec<Corner> = self.corners.iter().copied().chain(rounded).collect();
        corners.retain(|corner| (x_min..x_max).contains(&corner.x));
        corners.sort_by(|a, b| a.x.total_cmp(&b.x));
        ContactZone::with_corners(x_min, x_max, columns, symmetric, &corners)
    }

    /// The sharpest corner of a profile within the middle part of a contact, where nothing says
    /// whether it is one and a smooth curve through it would make a difference; and the body that
    /// has it, 0 for the upper one.
    pub fn ambiguous_corner(&self, centre: f64, half_width: f64) -> Option<(usize, Corner)> {
        let (left, right) = (centre - INNER_PART * half_width, centre + INNER_PART * half_width);
        let opening = 0.5 * (self.initial_gap(left) + self.initial_gap(right));
        let bodies = self.bodies.iter().enumerate().filter(|(_, body)| {
            body.interpolation_is_open
                && body.outline.rounding(left, right) > ROUNDING_SHARE * opening
        });
        let corners = bodies.flat_map(|(side, body)| {
            body.outline.possible_corners().into_iter().map(move |corner| (side, corner))
        });
        let inside = corners.filter(|(_, corner)| (left..=right).contains(&corner.x));
        inside.max_by(|a, b| a.1.opening().abs().total_cmp(&b.1.opening().abs()))
    }

    /// Whether both bodies are deformable and mirror images of each other.
    pub fn bodies_are_equal(&self) -> bool {
        let [upper, lower] = &self.bodies;
        upper.material.is_some()
            && upper.outline == lower.outline
            && upper.material == lower.material
            && upper.support == lower.support
    }

    /// Initial gap `δ0 = f_u + f_l` at an abscissa \[mm\], zero where the surfaces first touch.
    pub fn initial_gap(&self, x: f64) -> f64 {
        if let Some(pair) = &self.conforming {
            return pair.initial_gap(x);
        }
        -self.bodies.iter().map(|body| body.outline.height(x)).sum::<f64>() - self.smallest_gap
    }

    /// Returns the closing of the gap per unit of approach at an abscissa: nearly 1 where a contact
    /// is narrow beside the radii.
    pub fn closing(&self, x: f64) -> f64 {
        self.conforming.map_or(1.0, |pair| pair.closing(x))
    }

    /// Whether both surfaces are circular arcs or planes.
    pub fn has_arcs(&self) -> bool {
        self.bodies.iter().all(|body| body.outline.is_arc())
    }

    /// Opening of the surfaces, both sides together, at the distance a from where they touch
    /// \[mm\]. At an edge a contact grows to one side only, which stands for both.
    pub fn opening(&self, touch: f64, a: f64) -> f64 {
        let at_touch = |corner: &&Corner| {
            (corner.x - touch).abs() <= SAME_PLACE * corner.x.abs() && corner.edge() != 0.0
        };
        match self.corners.iter().find(at_touch) {
            Some(edge) => 2.0 * self.initial_gap(touch - a * edge.edge()),
            None => self.initial_gap(touch + a) + self.initial_gap(touch - a),
        }
    }

    /// Force under which elastic half-spaces with these surfaces touch over the half-width a
    /// around one place, which is the only one \[N/mm, or N in axisymmetry\]; in axisymmetry away
    /// from the axis, of a ring, that for each length of it \[N/mm\].
    ///
    /// Exact, with `g(x)` half of the opening, for contacts in one part:
    /// ```text
    /// P(a) = E* ∫₀ᵃ g'(x) x/√(a² - x²) dx         plane
    /// P(a) = 2 E* ∫₀ᵃ g'(r) r²/√(a² - r²) dr      axisymmetric
    /// ```
    ///
    /// # Reference
    /// I. N. Sneddon, *The relation between load and penetration in the axisymmetric Boussinesq
    /// problem for a punch of arbitrary profile*, Int. J. Engng Sci. 3 (1965) 47–57; K. L.
    /// Johnson, *Contact Mechanics* (1985), section 2.7.
    pub fn elastic_force(&self, touch: f64, a: f64) -> f64 {
        let modulus = self.effective_modulus();
        if let Some(pair) = &self.conforming {
            return pair.elastic_force(self.stress_state, modulus, a);
        }
        let is_round = self.stress_state == StressState::Axisymmetric && touch == 0.0;
        if self.has_arcs() {
            let opening = modulus * self.opening(touch, a);
            return if is_round { 4.0 / 3.0 * a * opening } else { 0.25 * PI * opening };
        }
        // With x = a sin φ, between even steps of φ: dg tan φ, or 2 dg a sin φ tan φ.
        let angle = |k: f64| 0.5 * PI * k / f64::from(FORCE_STEPS);
        let mut last = 0.0;
        let parts = (0..FORCE_STEPS).map(|k| {
            let opening = 0.5 * self.opening(touch, a * angle(f64::from(k + 1)).sin());
            let growth = opening - std::mem::replace(&mut last, opening);
            let (sin, cos) = angle(f64::from(k) + 0.5).sin_cos();
            if is_round { 2.0 * growth * a * sin * sin / cos } else { growth * sin / cos }
        });
        modulus * parts.sum::<f64>()
    }

    /// Pressure in the middle of an elastic contact of half-width a around x = 0 \[MPa\], where it
    /// is the largest on a tip that is rounded off.
    ///
    /// With `g(x)` half of the opening, for contacts in one part:
    /// ```text
    /// p(0) = E*/π ∫₀ᵃ g'(x)/x a/√(a² - x²) dx                            plane
    /// p(0) = E*/π ∫₀ᵃ g'(r) [1/√(a² - r²) + arccos(r/a)/r] dr            axisymmetric
    /// ```
    /// The second is Sneddon's pressure `E*/π ∫ dα/ds /s ds` with his approach `α(s) = s ∫₀ˢ
    /// g'(r)/√(s² - r²) dr`, integrated by parts.
    ///
    /// # Reference
    /// As for [`Self::elastic_force`].
    pub fn elastic_pressure_in_middle(&self, a: f64) -> f64 {
        // With x = a sin φ. Steps of φ shrink towards the middle, where slopes change within an
        // arc that may be very narrow.
        let narrowest = (1e-3 * self.tip_arc() / a).min(1e-3);
        let ratio = (narrowest / (0.5 * PI)).powf(f64::from(PRESSURE_STEPS).recip());
        let mut outer = 0.5 * PI;
        let mut gap_at_outer = 0.5 * self.opening(0.0, a);
        let parts = (0..PRESSURE_STEPS).map(|_| {
            let inner = ratio * outer;
            let middle = 0.5 * (inner + std::mem::replace(&mut outer, inner));
            let gap = 0.5 * self.opening(0.0, a * inner.sin());
            let growth = std::mem::replace(&mut gap_at_outer, gap) - gap;
            let (sin, cos) = middle.sin_cos();
            let weight = match self.stress_state {
                StressState::Axisymmetric => cos.recip() + (0.5 * PI - middle) / sin,
                StressState::PlaneStrain | StressState::PlaneStress => (sin * cos).recip(),
            };
            growth * weight / a
        });
        self.effective_modulus() / PI * parts.sum::<f64>()
    }

    /// Whether one half of the bodies stands for the whole.
    pub fn is_symmetric(&self) -> bool {
        // A pin and its hole are meshed from the contact round to the far side, which is on the
        // axis.
        let is_half = self.stress_state == StressState::Axisymmetric || self.conforming.is_some();
        is_half || (self.use_symmetry && self.has_symmetric_outlines())
    }

    /// Whether the answer is symmetric, even if the whole is meshed.
    pub fn has_symmetric_outlines(&self) -> bool {
        self.bodies.iter().all(|body| body.outline.is_symmetric())
    }

    /// Whether the surfaces may touch away from the zone around the smallest gap.
    pub fn may_touch_elsewhere(&self) -> bool {
        !self.has_arcs()
    }

    /// Sum of the curvatures at the origin \[1/mm\]; `None` where a surface is no arc.
    pub fn curvature(&self) -> Option<f64> {
        let [upper, lower] = &self.bodies;
        Some(upper.outline.curvature()? + lower.outline.curvature()?)
    }

    /// Effective modulus E* \[MPa\]; infinite for two rigid bodies.
    pub fn effective_modulus(&self) -> f64 {
        let constants =
            self.bodies.each_ref().map(|body| body.material.as_ref().map(Solid::elastic));
        match self.stress_state {
            StressState::PlaneStrain | StressState::Axisymmetric => effective_modulus(constants),
            StressState::PlaneStress => effective_modulus_plane_stress(constants),
        }
    }

    /// Outlines of the bodies that deform.
    pub fn deformable_outlines(&self) -> impl Iterator<Item = &Outline> {
        self.bodies.iter().filter(|body| body.material.is_some()).map(|body| &body.outline)
    }

    /// The part of the tangential axis where both bodies have a surface \[mm\].
    pub fn span(&self) -> (f64, f64) {
        let spans = self.bodies.each_ref().map(|body| body.outline.span());
        (spans[0].0.max(spans[1].0), spans[0].1.min(spans[1].1))
    }

    /// Returns the ends of the room that a contact zone has on both bodies, from left to right
    /// \[mm\].
    pub fn room(&self) -> (f64, f64) {
        let room = self.bodies.each_ref().map(|body| ContactZone::room(&body.outline));
        (room[0].0.max(room[1].0), room[0].1.min(room[1].1))
    }

    /// Returns the pressure of a fully plastic contact of the softer body \[MPa\]; infinite for
    /// elastic bodies.
    pub fn hardness(&self) -> f64 {
        // Of the strongest depth: a contact that is too narrow for it is widened, one too wide is
        // refused.
        let hardness = |body: &ProblemBody| {
            let (_, strongest) = body.strength_range();
            Some(2.6 * strongest * body.hardening()?.flow_stress())
        };
        self.bodies.iter().filter_map(hardness).fold(f64::INFINITY, f64::min)
    }
}

/// The constitutive model of a material in a body.
fn model_of(
    model: ModelOf,
    material: Option<&Solid>,
    outline: &Outline,
    out_of_plane: OutOfPlane,
) -> Option<Arc<dyn MaterialModel>> {
    material.map(|material| model(material, outline, out_of_plane))
}

impl ProblemBody {
    /// A body by deformation theory.
    fn of(given: GivenBody, out_of_plane: OutOfPlane) -> Self {
        let GivenBody { outline, material, support, interpolation_is_open } = given;
        Self {
            model: model_of(deformation_theory, material.as_ref(), &outline, out_of_plane),
            initial_stress: material
                .as_ref()
                .and_then(|material| GivenStress::of(material, &outline)),
            outline,
            material,
            support,
            interpolation_is_open,
        }
    }

    /// The hardening law of a body that can yield.
    pub fn hardening(&self) -> Option<&dyn HardeningLaw> {
        self.model.as_ref()?.hardening()
    }

    /// Stress at which its hardening curve begins \[MPa\]; `None` if it cannot yield, or does from
    /// the first load on.
    pub fn yield_stress(&self) -> Option<f64> {
        Some(self.hardening()?.yield_stress()).filter(|stress| *stress > 0.0)
    }

    /// Stress at which it begins to yield at a place `[x, y]` \[MPa\].
    pub fn yield_stress_at(&self, position: [f64; 2]) -> Option<f64> {
        Some(self.yield_stress()? * self.model.as_ref()?.strength(position))
    }

    /// Smallest and largest factor of the hardening curve.
    pub fn strength_range(&self) -> (f64, f64) {
        let strength = self.material.as_ref().and_then(Solid::strength);
        strength.map_or((1.0, 1.0), brinell_material::StrengthProfile::range)
    }
}
