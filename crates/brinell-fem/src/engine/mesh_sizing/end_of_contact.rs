//! End of a contact between two nodes, and the element size that fixes its place.
//!
//! The approach depends a little on where between two nodes the contact ends: of bodies that
//! yield, whose pressure hardly falls towards its end, by a few parts in a thousand. Were it to
//! end elsewhere at each load, load-approach curves would scatter by as much, and differences of
//! neighbouring loads by a tenth. So the elements of the first, small mesh are made larger or
//! smaller until the contact ends at the same place at every load; what is found on it sizes the
//! next mesh, and so on.

use super::contact_size::BEYOND_LAST;
use crate::engine::body_system::contact_patch::outermost_share;
use crate::engine::mesh_solve::MeshSolve;

/// Part of an element by which the end of the contact may be elsewhere.
const TOLERANCE: f64 = 0.01;
/// Part of an element within which it moves in proportion to the elements.
const NEAR: f64 = 0.5;
/// Decrease of the excess of the contact size as elements grow within that part, over the number of
/// elements and the logarithm of their growth: 0.6 to 1.3 in eight jobs.
const SLOPE: f64 = 0.8;
const SLOPES: [f64; 2] = [0.4, 1.6];

/// Returns the excess of the contact size over `elements` and a part of one, in elements. Each
/// further node that carries force adds one element. In between, the excess grows with the pressure
/// of the outermost node over that of the node before it. It also grows as elements become
/// smaller.
///
/// `None` where the contact is in several parts, ends at an edge, or has so few nodes that it has
/// no inside.
fn excess(pass: &MeshSolve, elements: usize) -> Option<f64> {
    let zone = &pass.system.zone;
    let force = &pass.outcome.state.response.contact.force;
    let active = &pass.outcome.state.response.contact.active_set;
    let (first, last) = (active.first()?, active.last()?);
    if pass.parts().len() != 1
        || last < first + 3
        || zone.edge(first).is_some()
        || zone.edge(last).is_some()
    {
        return None;
    }
    let pressure = pass.system.pressures(force);
    let share = |outermost: usize, inner: usize| (pressure[outermost] / pressure[inner]).min(1.0);
    let right = share(last, last - 1);
    let reached = if zone.is_symmetric() {
        // A ring, or two places that are mirror images of each other, has elements over its own
        // width.
        if first > 0 {
            return None;
        }
        last as f64 + right
    } else {
        0.5 * ((last - first) as f64 + share(first, first + 1) + right)
    };
    Some(reached - elements as f64 - outermost_share(1.0 + BEYOND_LAST))
}

/// Looks for the element size with which a contact ends where it is to.
#[derive(Debug, Default)]
pub(crate) struct EndSearch {
    /// Logarithm of the last element size, and the excess of the contact size.
    last: Option<[f64; 2]>,
}

impl EndSearch {
    /// The next element size \[mm\], `found` being the half-width that a mesh found. `None` where
    /// its contact ends where it is to, or that cannot be told.
    pub fn next(&mut self, pass: &MeshSolve, found: f64, elements: usize) -> Option<f64> {
        let excess = excess(pass, elements)?;
        if excess.abs() <= TOLERANCE {
            return None;
        }
        if excess.abs() > NEAR {
            return Some(found / (elements as f64 + BEYOND_LAST));
        }
        let elements = elements as f64;
        let size = pass.system.zone.spacing().ln();
        let slope = match self.last.replace([size, excess]) {
            // No other size is to be had.
            Some([last, _]) if (size - last).abs() < f64::EPSILON => return None,
            Some([last, before]) => {
                ((before - excess) / (size - last) / elements).clamp(SLOPES[0], SLOPES[1])
            }
            None => SLOPE,
        };
        Some((size + excess / (slope * elements)).exp())
    }
}
