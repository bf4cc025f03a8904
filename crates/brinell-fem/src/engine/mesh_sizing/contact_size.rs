//! Expected contact size, by which meshes are sized.

use std::f64::consts::PI;

use super::rough::{self, Touching, ZONE};
use super::trace::resolving_spacing;
use crate::element::StressState;
use crate::engine::body_system::contact_patch::ContactPatch;
use crate::engine::body_system::contact_patch::LEAST_PART;
use crate::engine::body_system::plastic_search_region::RadialEnvelope;
use crate::engine::conforming::ConformingPair;
use crate::engine::error::MeshedError;
use crate::engine::mesh_solve::MeshSolve;
use crate::engine::problem::Problem;
#[cfg(doc)]
use crate::mesh::MeshError;
use crate::mesh::{ContactZone, ROUNDING, Refinement};
use brinell_contact::ContactLoad;
use brinell_material::analytical::PinInHole;

/// Largest half-width of a contact as a part of the surface beside its middle that is solved at
/// all.
pub(super) const MAX_HALF_WIDTH: f64 = 0.5;
/// Elements over the half-width of the zone at least.
const LEAST_COLUMNS: f64 = 4.0;
/// Step in elements from one size to the next, as it moves the end of the contact, and between
/// places of an off-centre zone.
const STEP: f64 = 0.002;
/// Growth of the rings at 20 elements per half-width, less one. It leaves the approach low by 0.03
/// %.
const RING_GROWTH: f64 = 0.065;
/// Part of an element by which a contact is wider than whole elements. Half an element would put
/// its end in the middle between two nodes if half-widths found on a coarser mesh were not a
/// little low.
pub(super) const BEYOND_LAST: f64 = 0.4;
/// Largest refinement of a mesh over the one that was expected before anything was solved.
const MORE_THAN_EXPECTED: f64 = 1.5;
/// Elements over a half-width at most, a few more than a job may ask for.
const MAX_ELEMENTS: f64 = 350.0;
/// Half-width of a contact of rough surfaces over that in closed form, from which on the larger one
/// sizes the mesh.
const WIDER_THAN_CLOSED_FORM: f64 = 1.25;
/// Part of an approach by which a summit is pushed into the other body as it is before it counts
/// as in contact: away from where they touch bodies hardly give way.
const OVERLAP: f64 = 0.8;
/// Points within a contact from which on its surfaces may touch in parts; an edge, a tip and an
/// arc have fewer.
const TRACE_POINTS: usize = 5;
/// Pairs over a half-width with which parts are looked for.
const PAIRS_OF_PARTS: f64 = 90.0;
/// Elements over the half-width of a part of the contact with which its pressure is known at all.
const LEAST_ELEMENTS_OF_PART: f64 = 2.0;
/// A part of the contact is resolved by its own width down to this part of the whole width.
const MAX_PART_RATIO: f64 = 6.0;

/// Place and size of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactSizeEstimate {
    /// Middle \[mm\].
    pub centre: f64,
    /// Half of the distance from end to end \[mm\].
    pub half_width: f64,
    /// Half-width of the smallest connected part \[mm\].
    pub smallest_part: f64,
    /// Plastic region.
    pub plastic: RadialEnvelope,
    /// Half-width of the elastic contact in closed form, which element sizes are rounded to steps
    /// from \[mm\].
    pub hertz_half_width: f64,
    /// Factor by which elements have to be smaller for the nodes to see surfaces that are given by
    /// points as they are, at least 1.
    pub refinement: f64,
}

impl ContactSizeEstimate {
    /// The extent that closed forms suggest for a load.
    ///
    /// The gap at ±a stands for a parabola of the same opening, of which Hertz's theory knows the
    /// force; a fully plastic contact needs at least the width that bears the force at the
    /// material's hardness. For a prescribed approach the width is where the undeformed surfaces
    /// would overlap, which is too much.
    ///
    /// # Errors
    /// [`MeshedError::Conforming`] where the surfaces do not open, [`MeshedError::TouchesAtEnd`]
    /// where they end, [`MeshedError::TooWide`] or [`MeshedError::TooFarRound`] where the contact
    /// would take up more of the surfaces than is solved.
    pub fn expected(problem: &Problem, load: ContactLoad) -> Result<Self, MeshedError> {
        if let Some(pair) = &problem.conforming {
            return Self::round(problem, pair, load);
        }
        let (left, right) = problem.span();
        // A full model of a symmetric problem is sized as its half would be, so that both have the
        // same mesh.
        let symmetric = problem.is_symmetric() || problem.has_symmetric_outlines();
        let touch =
            if symmetric { problem.first_contact_x.abs() } else { problem.first_contact_x };
        let beside = right - touch;
        let available = if symmetric { beside } else { beside.min(touch - left) };
        let limit = MAX_HALF_WIDTH * available;
        let is_apart = symmetric && touch > 0.0;
        let farthest = if is_apart { limit.min(touch) } else { limit };
        if limit > 0.0 && problem.opening(touch, farthest) <= 0.0 {
            return Err(MeshedError::Conforming { limit: farthest });
        }
        let room = problem.room();
        if touch > room.1 || touch < room.0 {
            return Err(MeshedError::TouchesAtEnd { x: touch, left: room.0, right: room.1 });
        }
        if !is_apart {
            return Self::at(problem, load, touch, limit)?
                .map_err(|half_width| MeshedError::TooWide { half_width, available });
        }
        // Two places that are mirror images of each other, or a ring, until the contact has closed
        // between them.
        let share = match (load, problem.stress_state) {
            (ContactLoad::Force(force), StressState::Axisymmetric) => {
                ContactLoad::Force(force / (2.0 * PI * touch))
            }
            (ContactLoad::Force(force), _) => ContactLoad::Force(0.5 * force),
            (approach, _) => approach,
        };
        if let Ok(apart) = Self::at(problem, share, touch, farthest)? {
            return Ok(apart);
        }
        let limit = MAX_HALF_WIDTH * right;
        let too_wide = |half_width: f64| MeshedError::TooWide { half_width, available: right };
        if touch > limit {
            return Err(too_wide(touch));
        }
        let closed = Self::at(problem, load, 0.0, limit)?.map_err(too_wide)?;
        // Both places are in contact.
        let half_width = closed.half_width.max(touch);
        Ok(Self { half_width, smallest_part: half_width, ..closed })
    }

    /// The extent around one place; the inner error is the half-width that would be needed, above
    /// the limit.
    fn at(
        problem: &Problem,
        load: ContactLoad,
        touch: f64,
        limit: f64,
    ) -> Result<Result<Self, f64>, MeshedError> {
        let bears = |a: f64| match load {
            ContactLoad::Force(force) => problem.elastic_force(touch, a) >= force,
            ContactLoad::Approach(approach) => 0.5 * problem.opening(touch, a) >= approach,
        };
        // From small to large, because a contact on several bumps opens, closes and opens again.
        let ratio = if problem.has_arcs() { SEARCH_RATIO } else { ROUGH_RATIO };
        let elastic = smallest(limit, ratio, bears).map(|a| bisect(a / ratio, a, bears));
        let plastic = match load {
            ContactLoad::Force(force) => plastic_half_width(problem, force, touch),
            ContactLoad::Approach(_) => 0.0,
        };
        match elastic {
            Some(elastic) if elastic.max(plastic) <= limit => {
                let a = elastic.max(plastic);
                if let Some((side, corner)) = problem.ambiguous_corner(touch, a) {
                    return Err(MeshedError::AmbiguousCorner {
                        side,
                        x: corner.x,
                        opening: corner.opening(),
                    });
                }
                let symmetric = problem.is_symmetric() || problem.has_symmetric_outlines();
                Ok(Ok(Self::around(touch, a, elastic, symmetric)))
            }
            elastic => {
                // On the power of the half-width that the load follows there: 2 of a cylinder, 3
                // of a ball under a force.
                let borne = |a: f64| match load {
                    ContactLoad::Force(_) => problem.elastic_force(touch, a),
                    ContactLoad::Approach(_) => 0.5 * problem.opening(touch, a),
                };
                let exponent = (borne(limit) / borne(0.5 * limit)).log2();
                let ratio = load.magnitude() / borne(limit);
                // Where the surfaces close again, no ratio tells.
                let beyond =
                    if ratio > 1.0 && exponent > 0.0 { ratio.powf(exponent.recip()) } else { 1.0 };
                Ok(Err(elastic.unwrap_or(beyond * limit).max(plastic)))
            }
        }
    }

    /// Returns the expected contact size of a pin in a hole, by arc lengths. Under a large
    /// prescribed approach it is the largest arc, until a mesh has found the size.
    fn round(
        problem: &Problem,
        pair: &ConformingPair,
        load: ContactLoad,
    ) -> Result<Self, MeshedError> {
        let limit = pair.largest_arc();
        let bears = |a: f64| match load {
            ContactLoad::Force(force) => problem.elastic_force(0.0, a) >= force,
            ContactLoad::Approach(approach) => pair.initial_gap(a) >= approach * pair.closing(a),
        };
        let elastic = smallest(limit, SEARCH_RATIO, bears);
        let (elastic, plastic) = match load {
            ContactLoad::Force(force) => {
                let Some(elastic) = elastic else {
                    let ratio = 2.0 * problem.effective_modulus() * pair.clearance / force;
                    let half_angle =
                        PinInHole::of_clearance_ratio(ratio).half_angle().to_degrees();
                    return Err(MeshedError::TooFarRound { half_angle });
                };
                (elastic, pair.arc_of_chord(plastic_half_width(problem, force, 0.0)))
            }
            ContactLoad::Approach(_) => (elastic.unwrap_or(limit), 0.0),
        };
        if plastic > limit {
            return Err(MeshedError::TooFarRound { half_angle: pair.angle(plastic).to_degrees() });
        }
        Ok(Self::around(0.0, elastic.max(plastic), elastic, true))
    }

    fn around(touch: f64, a: f64, hertz_half_width: f64, symmetric: bool) -> Self {
        let (centre, half_width) = if symmetric { (0.0, touch + a) } else { (touch, a) };
        Self {
            centre,
            half_width,
            smallest_part: a,
            plastic: RadialEnvelope::NONE,
            hertz_half_width,
            refinement: 1.0,
        }
    }

    /// This extent, with elements as small as the surfaces need them; `elements` are asked for
    /// over a half-width.
    ///
    /// # Errors
    /// [`MeshedError::TraceTooFine`] where that is smaller than what is solved,
    /// [`MeshError::TooSteep`] where a face that deforms is too steep within the contact.
    pub fn resolved(
        self,
        problem: &Problem,
        load: ContactLoad,
        elements: usize,
    ) -> Result<Self, MeshedError> {
        let (left, right) = (self.centre - self.half_width, self.centre + self.half_width);
        for outline in problem.deformable_outlines() {
            outline.require_contact_slope(left, right)?;
        }
        let extent = self.of_several_parts(problem, load);
        let (wanted, spacing) = extent.spacings(problem, elements);
        let finest = extent.half_width / MAX_ELEMENTS;
        if spacing < wanted && spacing < finest {
            return Err(MeshedError::TraceTooFine {
                half_width: extent.half_width,
                spacing,
                finest,
            });
        }
        let radius = problem.edge_radius();
        if radius < finest && extent.half_width >= problem.walls()[1] - radius {
            return Err(MeshedError::TraceTooFine {
                half_width: extent.half_width,
                spacing: radius,
                finest,
            });
        }
        Ok(Self { refinement: wanted / spacing, ..extent })
    }

    /// The extent of a contact that closed forms of contacts in one part do not see: of a surface
    /// whose highest summits lie so far above the others that they seem to bear the force alone.
    fn of_several_parts(self, problem: &Problem, load: ContactLoad) -> Self {
        let ContactLoad::Force(force) = load else { return self };
        if problem.has_arcs() {
            return self;
        }
        let symmetric = problem.has_symmetric_outlines();
        let middle = if symmetric { 0.0 } else { problem.first_contact_x };
        let (left, right) = problem.span();
        let available = (right - middle).min(middle - left);
        let near = rough::extent(problem, force, middle, available);
        // Contact that reaches farther to one side than the surfaces reach to the other.
        let far = rough::extent(problem, force, 0.5 * (left + right), 0.5 * (right - left))
            .filter(|far| far.right > middle + available || far.left < middle - available);
        let Some(found) = far.or(near) else {
            return self;
        };
        let (centre, half_width) = if symmetric {
            (0.0, found.right.max(-found.left))
        } else {
            (0.5 * (found.left + found.right), found.half_width())
        };
        if half_width < WIDER_THAN_CLOSED_FORM * self.half_width {
            return self;
        }
        let smallest_part = found.smallest_part.min(half_width);
        Self { centre, half_width, smallest_part, hertz_half_width: half_width, ..self }
    }

    /// The extent that a mesh is expected to find of surfaces given by points: a trace touches
    /// beyond where its mean surface would, and in parts that meshes resolve.
    pub fn of_trace(self, problem: &Problem, load: ContactLoad, elements: usize) -> Self {
        let force = match load {
            ContactLoad::Force(force) => force,
            ContactLoad::Approach(approach) => return self.of_all_summits(problem, approach),
        };
        if self.refinement > 1.0 {
            let spacing = self.spacing(elements);
            let found = rough::contact(problem, force, self.centre, self.half_width, spacing);
            let Some(found) = found else { return self };
            let half_width = found.half_width();
            return Self { half_width, smallest_part: half_width, ..self }
                .refined(problem, elements);
        }
        // Two places that are expected to touch, or all between them.
        let found = if self.smallest_part < 0.5 * self.half_width {
            rough::contact(
                problem,
                force,
                self.centre,
                self.half_width,
                self.half_width / PAIRS_OF_PARTS,
            )
        } else {
            self.half_planes(problem, force)
        };
        match found {
            Some(found) => {
                Self { half_width: found.half_width(), smallest_part: found.smallest_part, ..self }
            }
            None => self,
        }
    }

    /// The extent with all points that an approach is to bring well into the other body.
    fn of_all_summits(self, problem: &Problem, approach: f64) -> Self {
        if problem.has_arcs() {
            return self;
        }
        let (left, right) = problem.room();
        let is_inside = |x: &&f64| problem.initial_gap(**x) < OVERLAP * approach;
        let (from, to) = problem.knots_within(left, right).iter().filter(is_inside).fold(
            (self.centre - self.half_width, self.centre + self.half_width),
            |(from, to), &x| (from.min(x), to.max(x)),
        );
        let half_width =
            if problem.has_symmetric_outlines() { to.max(-from) } else { 0.5 * (to - from) };
        if half_width < WIDER_THAN_CLOSED_FORM * self.half_width {
            return self;
        }
        Self { centre: 0.5 * (from + to), half_width, hertz_half_width: half_width, ..self }
    }

    /// The extent of a contact that a mesh has found under a force, with parts that it may have
    /// been too coarse to tell apart.
    pub fn with_parts(self, problem: &Problem, force: f64) -> Self {
        if self.refinement > 1.0 {
            return self;
        }
        let parts =
            self.half_planes(problem, force).map_or(f64::INFINITY, |found| found.smallest_part);
        Self { smallest_part: self.smallest_part.min(parts), ..self }
    }

    /// Returns the contact of half-planes with the surfaces of a trace, if it is in several parts.
    fn half_planes(&self, problem: &Problem, force: f64) -> Option<Touching> {
        let (left, right) = (self.centre - self.half_width, self.centre + self.half_width);
        if problem.has_arcs() || problem.knots_within(left, right).len() < TRACE_POINTS {
            return None;
        }
        let spacing = self.half_width / PAIRS_OF_PARTS;
        rough::contact(problem, force, self.centre, self.half_width, spacing)
            .filter(|found| found.smallest_part < 0.5 * found.half_width())
    }

    /// Returns this contact with the refinement that its surfaces need. The mesh does not become
    /// much finer than was expected and estimated.
    pub fn refined(self, problem: &Problem, elements: usize) -> Self {
        let (wanted, spacing) = self.spacings(problem, elements);
        let finest = (self.half_width / MAX_ELEMENTS).min(wanted);
        let refinement = wanted / spacing.max(finest);
        Self { refinement: refinement.min(MORE_THAN_EXPECTED * self.refinement), ..self }
    }

    /// Element size that the surfaces within the contact need, where it is smaller than a given
    /// one \[mm\]; `force` is that of an elastic contact, whose parts have a size.
    pub fn unresolved(&self, problem: &Problem, spacing: f64, force: Option<f64>) -> Option<f64> {
        let details = resolving_spacing(problem, self.centre, self.half_width, spacing);
        let parts = force.and_then(|force| self.half_planes(problem, force));
        let needed = parts
            .map_or(details, |parts| details.min(parts.smallest_part / LEAST_ELEMENTS_OF_PART));
        (!problem.has_arcs() && needed < spacing).then_some(needed)
    }

    /// Element size that is asked for, and the one up to it that the surfaces need \[mm\].
    fn spacings(&self, problem: &Problem, elements: usize) -> (f64, f64) {
        let wanted = self.half_width / (elements as f64 + BEYOND_LAST);
        if problem.has_arcs() {
            return (wanted, wanted);
        }
        (wanted, resolving_spacing(problem, self.centre, self.half_width, wanted))
    }

    /// The extent that a pass found; `self` where nothing touched.
    pub fn found_by(self, pass: &MeshSolve) -> Self {
        let Some(patch) = pass.sizing_patch else { return self };
        let zone = &pass.system.zone;
        let own_width = |left: f64, right: f64| {
            if zone.is_symmetric() && left == 0.0 { right } else { 0.5 * (right - left) }
        };
        let (x, pressures) =
            pass.system.pressure_over_x(&pass.outcome.state.response.contact.force);
        let carried = |part: &ContactPatch| -> f64 {
            let inside =
                x.iter().zip(&pressures).filter(|(x, _)| (part.left..=part.right).contains(*x));
            inside.map(|(_, p)| p).sum()
        };
        let mut parts = pass.parts();
        let least = LEAST_PART * pressures.iter().sum::<f64>();
        if parts.len() > 1 {
            parts.retain(|part| carried(part) >= least);
        }
        let smallest = match parts.as_slice() {
            [only] if !zone.is_symmetric() || only.left == 0.0 => patch.half_width(),
            many => many
                .iter()
                .map(|part| own_width(part.left, part.right))
                .fold(patch.half_width(), f64::min),
        };
        Self {
            centre: 0.5 * (patch.left + patch.right),
            // A single node says no more than that.
            half_width: patch.half_width().max(0.5 * zone.spacing()),
            smallest_part: smallest.max(0.5 * zone.spacing()),
            plastic: pass.yielded_envelope(),
            hertz_half_width: self.hertz_half_width,
            refinement: self.refinement,
        }
    }

    /// This extent with elements of this size, so many over a half-width \[mm\].
    pub fn with_spacing(self, spacing: f64, elements: usize) -> Self {
        let half_width = spacing * (elements as f64 + BEYOND_LAST);
        Self { half_width, smallest_part: half_width, ..self }
    }

    /// This extent with all lengths scaled.
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            centre: self.centre,
            half_width: factor * self.half_width,
            smallest_part: factor * self.smallest_part,
            plastic: self.plastic.scaled(factor),
            hertz_half_width: self.hertz_half_width,
            refinement: self.refinement,
        }
    }

    /// Element size for so many elements over a half-width \[mm\], and a part of one more, so that
    /// the end of the contact falls between two nodes.
    ///
    /// It is a member of a geometric series about the elastic contact, so that jobs whose contacts
    /// differ by rounding alone get the same mesh, and with it all that is known of it
    /// ([`crate::engine::FactorCache`]).
    pub fn spacing(&self, elements: usize) -> f64 {
        let elements = elements as f64 + BEYOND_LAST;
        if self.refinement > 1.0 {
            // Fine enough for the points of a trace, between which nothing is known: parts that it
            // has are no reason more.
            return self.half_width / elements / self.refinement;
        }
        let resolved =
            self.smallest_part.max(self.half_width / MAX_PART_RATIO).min(self.half_width);
        let step = (STEP / elements).ln_1p();
        let steps = (resolved / self.hertz_half_width).ln() / step;
        self.hertz_half_width / elements * (step * steps.round()).exp()
    }

    /// A zone that covers the contact and more, with elements of a given size or, where these
    /// would be too few, smaller ones.
    pub fn zone(&self, problem: &Problem, spacing: f64) -> ContactZone {
        let symmetric = problem.is_symmetric();
        let spacing = spacing.min(ZONE * self.half_width / LEAST_COLUMNS);
        let mut columns = nearest(ZONE * self.half_width / spacing).max(LEAST_COLUMNS);
        if problem.conforming.is_some() {
            // As much as there is of whole elements, for a contact that reaches far round.
            columns = columns.min((problem.span().1 / spacing + ROUNDING).floor());
        }
        let half = columns * spacing;
        // Bounded by the limits of `elements_per_half_width` and of the ratios above.
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "small and positive"
        )]
        let columns = columns as usize;
        if symmetric {
            problem.zone(0.0, half, columns, symmetric)
        } else {
            let step = STEP * spacing;
            let centre = nearest(self.centre / step) * step;
            problem.zone(centre - half, centre + half, 2 * columns, symmetric)
        }
    }
}

/// The nearest whole number; of halves the one away from zero, whatever rounding has made of them.
fn nearest(number: f64) -> f64 {
    (number * (1.0 + ROUNDING)).round()
}

/// Rings become thinner together with the block's elements, so that both errors fall at the same
/// rate.
pub(crate) fn refinement(zone: &ContactZone) -> Refinement {
    // Not of the graded columns: they leave the rest as it is.
    let columns = zone.half_width() / zone.spacing();
    Refinement { growth: 1.0 + RING_GROWTH * 20.0 * ZONE / columns }
}

/// The smallest half-width that bears a load, by steps of a ratio down from the largest to a
/// millionth of it; by as many again where the last still bears it.
fn smallest(largest: f64, ratio: f64, bears: impl Fn(f64) -> bool) -> Option<f64> {
    let at = |k: i32| largest * ratio.powi(-k);
    #[expect(clippy::cast_possible_truncation, reason = "some hundred")]
    let steps = (1e6_f64.ln() / ratio.ln()).ceil() as i32;
    let steps = if bears(at(steps)) { 2 * steps } else { steps };
    (0..=steps).rev().map(at).find(|&a| bears(a))
}

/// Ratio of the trial half-widths.
const SEARCH_RATIO: f64 = 1.02;
/// Ratio of the trial half-widths where a force is an integral.
const ROUGH_RATIO: f64 = 1.1;

/// The least value between `low`, which does not bear, and `high`, which does.
fn bisect(mut low: f64, mut high: f64, bears: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if bears(middle) { high = middle } else { low = middle }
    }
    high
}

/// Half-width that bears a force where all of the contact is plastic; of a ring, the force on a
/// length of it.
fn plastic_half_width(problem: &Problem, force: f64, touch: f64) -> f64 {
    if problem.stress_state == StressState::Axisymmetric && touch == 0.0 {
        (force / (PI * problem.hardness())).sqrt()
    } else {
        force / (2.0 * problem.hardness())
    }
}
