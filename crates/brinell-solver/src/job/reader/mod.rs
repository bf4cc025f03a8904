//! The reader of a document. It collects every fault, with its place, before it refuses the
//! document.
//!
//! A [`Cursor`] is a value with its place. Each of its methods records a fault and returns `None`
//! if the value is invalid, so that a reader first reads *all* of its members and only then
//! combines them with `?`:
//! ```text
//! let radius = object.required("radius", |c| c.quantity(Domain::Length, units));
//! let depth = object.required("depth", |c| c.quantity(Domain::Length, units));
//! Some(Shape::… { radius: radius?, depth: depth? })
//! ```

mod cursor;
mod faults;
mod object;
mod syntax;
pub(super) mod text;
mod tree;

pub(super) use self::cursor::Cursor;
pub(super) use self::faults::Faults;
pub(super) use self::object::Object;
pub(super) use self::syntax::{explain, parse};
pub(super) use self::tree::Node;
