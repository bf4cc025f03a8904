//! Size of an elastic contact of rough surfaces: half-spaces instead of bodies, pairs as close as
//! the elements of the mesh. A trace touches beyond where its mean surface would.

use std::f64::consts::PI;

use crate::element::StressState;
use crate::engine::body_system::contact_patch::LEAST_PART;
use crate::engine::mesh_solve::ENLARGEMENT;
use crate::engine::problem::Problem;
use brinell_contact::{ActiveSetSolver, ContactLoad, ContactProblem, ContactSolver, never};
use dense_cholesky::SymmetricMatrix;

/// Half-width of the candidate zone over that of the contact.
pub(super) const ZONE: f64 = 1.6;
/// Pairs at most to each side of the middle.
const MAX_PAIRS: f64 = 450.0;
/// Part of what is looked at that a contact covers at least for its ends to be known.
const LEAST_PART_OF_REACH: f64 = 0.4;
/// Pairs to each side of the middle that tell the ends of a contact to a few per cent.
const PAIRS_OF_EXTENT: f64 = 45.0;
/// Most steps by which the pairs come closer to the contact.
const MAX_LOOKS: u32 = 40;
/// Factor by which the pairs reach farther, in case the surfaces beside a contact touch as well.
const BESIDE: f64 = 3.0;

/// Contact size of plane half-spaces.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Touching {
    /// Ends, half of the spacing beyond the outermost pairs \[mm\].
    pub left: f64,
    pub right: f64,
    /// Half-width of the smallest connected part that carries more than a small share of the force
    /// \[mm\].
    pub smallest_part: f64,
}

impl Touching {
    /// Returns the distance from a place to the farther end.
    fn reach(&self, x: f64) -> f64 {
        (self.right - x).max(x - self.left)
    }

    pub fn half_width(&self) -> f64 {
        0.5 * (self.right - self.left)
    }
}

/// The contact under a force around a middle, on pairs of this spacing; `None` where that takes
/// too many pairs, or in axisymmetry.
pub(crate) fn contact(
    problem: &Problem,
    force: f64,
    centre: f64,
    expected: f64,
    spacing: f64,
) -> Option<Touching> {
    let mut reach = ZONE * expected;
    loop {
        let to_each_side = (reach / spacing).ceil();
        if to_each_side > MAX_PAIRS {
            return None;
        }
        let pairs = Pairs { centre, spacing, to_each_side };
        match pairs.press(problem, force)? {
            Pressed::Within(touching) => return Some(touching),
            Pressed::Beyond => reach *= ENLARGEMENT,
        }
    }
}

/// Returns the contact under a force around a middle, on a number of pairs that does not depend on
/// its size. The pairs first reach as far as the surfaces are `available`. Step by step they come
/// closer to the contact. They then reach beyond it again, because a summit gives way more than the
/// element that stood for it.
pub(crate) fn extent(
    problem: &Problem,
    force: f64,
    centre: f64,
    available: f64,
) -> Option<Touching> {
    let look = |reach: f64, to_each_side: f64| {
        let pairs = Pairs { centre, spacing: reach / to_each_side, to_each_side };
        match pairs.press(problem, force)? {
            Pressed::Within(touching) => Some(touching),
            Pressed::Beyond => None,
        }
    };
    let (mut reach, mut found) = (available, look(available, PAIRS_OF_EXTENT)?);
    for _ in 0..MAX_LOOKS {
        if found.reach(centre) >= LEAST_PART_OF_REACH * reach {
            break;
        }
        reach = ZONE * found.reach(centre);
        found = look(reach, PAIRS_OF_EXTENT)?;
    }
    while BESIDE * reach < available {
        reach *= BESIDE;
        let wider = look(reach, BESIDE * PAIRS_OF_EXTENT)?;
        let is_all = wider.half_width() < ENLARGEMENT * found.half_width();
        found = wider;
        if is_all {
            break;
        }
    }
    Some(found)
}

enum Pressed {
    Within(Touching),
    /// The contact reaches an end of what is looked at.
    Beyond,
}

/// Even pairs on both sides of a middle.
struct Pairs {
    centre: f64,
    spacing: f64,
    /// A whole number.
    to_each_side: f64,
}

impl Pairs {
    /// The highest summit of an element stands for it, so that none is missed.
    fn gap(&self, problem: &Problem, x: f64) -> f64 {
        let knots = problem.knots_within(x - 0.5 * self.spacing, x + 0.5 * self.spacing);
        knots.iter().map(|&x| problem.initial_gap(x)).fold(problem.initial_gap(x), f64::min)
    }

    fn press(&self, problem: &Problem, force: f64) -> Option<Pressed> {
        if problem.stress_state == StressState::Axisymmetric {
            return None;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "small and positive"
        )]
        let count = 2 * self.to_each_side as usize + 1;
        let x = |k: usize| self.centre + (k as f64 - self.to_each_side) * self.spacing;
        let initial_gap: Vec<f64> = (0..count).map(|k| self.gap(problem, x(k))).collect();
        let flexibility = half_plane(count, problem.effective_modulus());
        let closing = vec![1.0; count];
        let contact = ContactProblem {
            flexibility: &flexibility,
            initial_gap: &initial_gap,
            closing: &closing,
            load: ContactLoad::Force(force),
        };
        let found = ActiveSetSolver.solve(&contact, None, &mut never).ok()?;
        let (first, last) = (found.active_set.first()?, found.active_set.last()?);
        if first <= 1 || last + 2 >= count {
            return Some(Pressed::Beyond);
        }
        let parts = found.force.chunk_by(|a, b| (*a > 0.0) == (*b > 0.0));
        let carrying = parts.filter(|part| part.iter().sum::<f64>() > LEAST_PART * force);
        let smallest = carrying.map(<[f64]>::len).min().unwrap_or(last + 1 - first);
        let half = 0.5 * self.spacing;
        let smallest_part = half * smallest as f64;
        Some(Pressed::Within(Touching {
            left: x(first) - half,
            right: x(last) + half,
            smallest_part,
        }))
    }
}

/// Normal displacements of a half-plane under unit forces, each spread evenly over an element,
/// relative to a point far away: `-2/(π E*) ∫ ln|x - s| ds/h`.
fn half_plane(count: usize, modulus: f64) -> SymmetricMatrix {
    // In elements; beyond all of them, so that every entry is positive.
    let datum = (10.0 * count as f64).ln();
    let integral = |x: f64| if x == 0.0 { 0.0 } else { x * x.abs().ln() - x };
    let by_distance: Vec<f64> = (0..count)
        .map(|k| {
            let distance = k as f64;
            2.0 / (PI * modulus) * (datum - integral(distance + 0.5) + integral(distance - 0.5))
        })
        .collect();
    SymmetricMatrix::from_fn(count, |i, j| by_distance[i.abs_diff(j)])
}
